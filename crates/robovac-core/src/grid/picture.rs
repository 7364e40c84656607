//! Grids as `#.` pictures, for doc tests, failures and map files.

use super::Grid;
use std::fmt::Write;

/// A picture of the grid, top row first, one character a cell.
///
/// ```
/// use robovac_core::grid::{from_picture, picture};
/// let free = from_picture("..#\n.#.", |c| c == '.').unwrap();
/// assert_eq!(picture(&free, |&f| if f { '.' } else { '#' }), "..#\n.#.\n");
/// ```
pub fn picture<T>(grid: &Grid<T>, mut glyph: impl FnMut(&T) -> char) -> String {
    let mut text = String::with_capacity((grid.width() + 1) * grid.height());
    for row in grid.values().chunks(grid.width()).rev() {
        for value in row {
            let _ = text.write_char(glyph(value));
        }
        text.push('\n');
    }
    text
}

/// The grid drawn in `text`, top row first; surrounding blank lines and indentation are ignored.
///
/// `None` if there is no row or the rows differ in length. Map files are read by `floor_plan`, which has detailed
/// errors.
pub fn from_picture<T>(text: &str, mut value: impl FnMut(char) -> T) -> Option<Grid<T>> {
    let rows: Vec<&str> = text.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    let width = rows.first()?.chars().count();
    if rows.iter().any(|row| row.chars().count() != width) {
        return None;
    }
    Grid::from_rows(width, rows.iter().rev().flat_map(|row| row.chars()).map(&mut value).collect())
}
