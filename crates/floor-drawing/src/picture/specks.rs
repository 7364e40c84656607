//! Marks too small to be walls: noise, dots, letters.

use robovac_core::grid::{Cell, Grid};

/// Removes marks, in any of 8 directions connected, whose longer side is less than `side` pixels.
pub(super) fn remove(walls: &mut Grid<bool>, side: f64) {
    if side <= 1.0 {
        return;
    }
    let mut seen = walls.map(|_| false);
    let mut mark = Vec::new();
    for index in 0..walls.len() {
        let start = walls.cell(index);
        if !walls[start] || seen[start] {
            continue;
        }
        mark.clear();
        mark.push(start);
        seen[start] = true;
        let mut next = 0;
        let (mut low, mut high) = (start, start);
        while let Some(&cell) = mark.get(next) {
            next += 1;
            low = Cell::new(low.x.min(cell.x), low.y.min(cell.y));
            high = Cell::new(high.x.max(cell.x), high.y.max(cell.y));
            for beside in cell.block() {
                if walls.is_set(beside) && !seen[beside] {
                    seen[beside] = true;
                    mark.push(beside);
                }
            }
        }
        if f64::from((high.x - low.x).max(high.y - low.y) + 1) < side {
            for cell in &mark {
                walls[*cell] = false;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::{from_picture, picture};

    #[test]
    fn small_marks_go_and_thin_lines_stay() {
        let mut walls = from_picture("#.......\n...##...\n...#....\n.#....##\n..######\n", |c| c == '#').unwrap();
        remove(&mut walls, 3.0);
        let found = picture(&walls, |&is_wall| if is_wall { '#' } else { '.' });
        assert_eq!(found.trim(), "........\n........\n........\n.#....##\n..######");
    }
}
