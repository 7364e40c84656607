//! Marks too small to be walls: noise, dots.

use super::marks::{erase, marks};
use robovac_core::grid::Grid;

/// Removes marks whose longer side is less than `side` pixels.
pub(super) fn remove(walls: &mut Grid<bool>, side: f64) {
    if side > 1.0 {
        let specks = marks(walls, |mark| f64::from(mark.size()[0].max(mark.size()[1])) < side);
        erase(walls, &specks);
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
