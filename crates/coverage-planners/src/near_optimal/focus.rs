//! A walk with everything outside one block contracted, so that a change costs time in the size of the block, not of
//! the room.

use super::tour::Tour;

/// A block, with the walk outside it contracted.
pub(super) struct Focus {
    /// The walk: cells near the block by their numbers, and two markers for every contracted part.
    pub tour: Tour,
    /// The parts, in the order of their markers.
    parts: Vec<Vec<u32>>,
    /// The first marker: above all cells.
    markers: u32,
}

impl Focus {
    /// Contracts the cells outside `is_inside`, except for the neighbours of cells inside.
    pub fn new(tour: &Tour, cells: usize, is_inside: impl Fn(u32) -> bool) -> Self {
        let (mut list, mut parts) = (Vec::new(), Vec::new());
        let markers = cells as u32;
        let all = &tour.cells;
        let mut at = 0;
        while at < all.len() {
            let end = at + all[at..].iter().take_while(|&&cell| !is_inside(cell)).count();
            // The first and last cells of a closed tour stay, as its seam can't be moved.
            if end - at > 4 {
                list.push(all[at]);
                list.extend([markers + 2 * parts.len() as u32, markers + 2 * parts.len() as u32 + 1]);
                list.push(all[end - 1]);
                parts.push(all[at + 1..end - 1].to_vec());
            } else {
                list.extend_from_slice(&all[at..end]);
            }
            if let Some(&cell) = all.get(end) {
                list.push(cell);
            }
            at = end + 1;
        }
        Self { tour: Tour::new(cells, list, tour.is_closed), parts, markers }
    }

    /// The walk with all parts expanded.
    pub fn unfold(self) -> Vec<u32> {
        let Self { tour, parts, markers } = self;
        let mut list = Vec::with_capacity(parts.iter().map(Vec::len).sum::<usize>() + tour.cells.len());
        let mut skips = false;
        for &cell in &tour.cells {
            if cell < markers {
                list.push(cell);
                continue;
            }
            // The first of two markers gives the direction of the part.
            skips = !skips;
            if skips {
                let marker = cell - markers;
                let part = &parts[marker as usize / 2];
                if marker.is_multiple_of(2) {
                    list.extend_from_slice(part);
                } else {
                    list.extend(part.iter().rev());
                }
            }
        }
        list
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_folded_up_comes_back_either_way_round() {
        let cells: Vec<u32> = (0..30).collect();
        let tour = Tour::new(30, cells.clone(), false);
        let mut focus = Focus::new(&tour, 30, |cell| (10..13).contains(&cell));
        assert_eq!(focus.tour.cells, [0, 30, 31, 9, 10, 11, 12, 13, 32, 33, 29]);
        let reversed: Vec<u32> = focus.tour.cells.iter().rev().copied().collect();
        focus.tour.replace(reversed);
        assert_eq!(focus.unfold(), cells.into_iter().rev().collect::<Vec<_>>());
    }
}
