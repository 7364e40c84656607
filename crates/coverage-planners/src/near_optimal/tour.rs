//! A walk that is rebuilt piece by piece, with an index of its visits to each cell.

const NONE: u32 = u32::MAX;

/// A walk by the cells' numbers. Numbers above those of the cells are markers without a place.
#[derive(Debug, Clone)]
pub(super) struct Tour {
    /// The cells in order; a closed tour without the return to its first cell.
    pub cells: Vec<u32>,
    pub is_closed: bool,
    /// Per cell the position of a visit.
    first: Vec<u32>,
    /// Per position that of another visit of the same cell.
    next: Vec<u32>,
}

impl Tour {
    /// A walk in a room of `count` cells.
    pub fn new(count: usize, cells: Vec<u32>, is_closed: bool) -> Self {
        let mut tour = Self { cells: Vec::new(), is_closed, first: vec![NONE; count], next: Vec::new() };
        tour.replace(cells);
        tour
    }

    /// Takes another walk over the same cells; returns the old one.
    pub fn replace(&mut self, cells: Vec<u32>) -> Vec<u32> {
        for &cell in &self.cells {
            if let Some(first) = self.first.get_mut(cell as usize) {
                *first = NONE;
            }
        }
        self.next.clear();
        for (i, &cell) in cells.iter().enumerate() {
            let before = self.first.get_mut(cell as usize).map_or(NONE, |first| std::mem::replace(first, i as u32));
            self.next.push(before);
        }
        std::mem::replace(&mut self.cells, cells)
    }

    /// Positions at which the walk visits a cell.
    pub fn visits(&self, cell: u32) -> impl Iterator<Item = usize> {
        let mut at = self.first[cell as usize];
        std::iter::from_fn(move || {
            let here = (at != NONE).then_some(at as usize)?;
            at = self.next[here];
            Some(here)
        })
    }

    /// The position before or after another.
    pub fn beside(&self, position: usize, is_after: bool) -> Option<usize> {
        let last = self.cells.len() - 1;
        match (is_after, self.is_closed) {
            (true, _) if position < last => Some(position + 1),
            (false, _) if position > 0 => Some(position - 1),
            (true, true) => Some(0),
            (false, true) => Some(last),
            _ => None,
        }
    }
}
