//! Words in a picture: small marks of similar height in a row.

use super::marks::{PixelMark, erase, marks};
use robovac_core::grid::{Cell, Grid};
use std::collections::BTreeMap;

/// Height of letters, as a share of the picture's longer side, at most (ours): chairs of a flat that fills the picture
/// are larger. And in pixels, at least: less is noise.
const HIGHEST: f64 = 0.025;
const LOWEST: i32 = 4;
/// Widest mark of letters that run together, in heights.
const WIDEST: f64 = 8.0;
/// Largest gap between letters, and difference of their heights, as a share of the larger height.
const GAP: f64 = 0.75;
const SMALLER: f64 = 0.45;
/// Most width of half of a word's letters, in heights: the pieces of a faint wall are longer than thick.
const USUAL_WIDTH: f64 = 1.4;
/// Fewest letters of a word. Of two letters only if there are longer words.
const LETTERS: usize = 3;
/// Least difference of the letters' widths or heights, as a share of the largest: chairs in a row, dashes and pillars are
/// alike.
const VARIETY: f64 = 0.2;

/// Removes words, along the rows of the picture and along its columns, with the dots and the pieces of letters in them.
pub(super) fn remove(walls: &mut Grid<bool>) {
    let highest = (HIGHEST * walls.width().max(walls.height()) as f64).max(8.0);
    for along in [0, 1] {
        let height = |mark: &PixelMark| mark.size()[1 - along];
        let is_small =
            |mark: &PixelMark| f64::from(height(mark)) <= highest && f64::from(mark.size()[along]) <= WIDEST * highest;
        let small = marks(walls, is_small);
        let is_letter = |mark: &&PixelMark| {
            height(mark) >= LOWEST && f64::from(mark.size()[along]) <= WIDEST * f64::from(height(mark))
        };
        let letters: Vec<&PixelMark> = small.iter().filter(is_letter).collect();
        let rows = rows(&letters, along);
        let words: Vec<&Vec<&PixelMark>> =
            rows.iter().filter(|row| row.len() >= LETTERS && is_varied(row) && !is_line(row, along)).collect();
        let heights = || words.iter().flat_map(|row| row.iter().map(|mark| height(mark)));
        let Some((least, most)) = heights().min().zip(heights().max()) else { continue };
        let is_like =
            |row: &&Vec<&PixelMark>| row.len() == 2 && row.iter().all(|mark| (least..=most).contains(&height(mark)));
        let pairs = rows.iter().filter(is_like);
        let boxes: Vec<[Cell; 2]> = words.iter().copied().chain(pairs).map(|row| around(row, along)).collect();
        let is_in = |mark: &&PixelMark, [low, high]: &[Cell; 2]| {
            low.x <= mark.low.x && low.y <= mark.low.y && mark.high.x <= high.x && mark.high.y <= high.y
        };
        erase(walls, small.iter().filter(|mark| boxes.iter().any(|word| is_in(mark, word))));
    }
}

/// The box around a word, and where its next letters can be.
fn around(row: &[&PixelMark], along: usize) -> [Cell; 2] {
    let (mut low, mut high) = (row[0].low, row[0].high);
    for mark in row {
        low = Cell::new(low.x.min(mark.low.x), low.y.min(mark.low.y));
        high = Cell::new(high.x.max(mark.high.x), high.y.max(mark.high.y));
    }
    let height = if along == 0 { high.y - low.y + 1 } else { high.x - low.x + 1 };
    let by = (GAP * f64::from(height)) as i32;
    // Less above and below, where other things stand.
    let [x, y] = if along == 0 { [by, by / 3] } else { [by / 3, by] };
    [Cell::new(low.x - x, low.y - y), Cell::new(high.x + x, high.y + y)]
}

/// Whether the marks of a row aren't all alike.
fn is_varied(row: &[&PixelMark]) -> bool {
    (0..2).any(|axis| {
        let sides = || row.iter().map(|mark| f64::from(mark.size()[axis]));
        let (least, most) = (sides().fold(f64::INFINITY, f64::min), sides().fold(0.0, f64::max));
        most - least > (VARIETY * most).max(1.0)
    })
}

/// Whether the marks of a row are the pieces of a line.
fn is_line(row: &[&PixelMark], along: usize) -> bool {
    let is_long = |mark: &&&PixelMark| f64::from(mark.size()[along]) > USUAL_WIDTH * f64::from(mark.size()[1 - along]);
    2 * row.iter().filter(is_long).count() > row.len()
}

/// The marks in rows: those that are beside each other, and of similar height.
fn rows<'a>(letters: &[&'a PixelMark], along: usize) -> Vec<Vec<&'a PixelMark>> {
    let coordinate = |cell: Cell, axis: usize| if axis == 0 { cell.x } else { cell.y };
    let across = 1 - along;
    let mut order: Vec<usize> = (0..letters.len()).collect();
    order.sort_by_key(|&index| coordinate(letters[index].low, along));
    let mut row_of: Vec<usize> = (0..letters.len()).collect();
    let mut open: Vec<usize> = Vec::new();
    for &index in &order {
        let letter = letters[index];
        let height = f64::from(letter.size()[across]);
        let gap = |other: &PixelMark| f64::from(coordinate(letter.low, along) - coordinate(other.high, along) - 1);
        // What these are too far from is no letter of the same row; nor is what follows.
        open.retain(|&other| gap(letters[other]) <= GAP / SMALLER * f64::from(letters[other].size()[across]));
        for &other in &open {
            let beside = letters[other];
            let other_height = f64::from(beside.size()[across]);
            let (smaller, larger) = (height.min(other_height), height.max(other_height));
            let top = coordinate(letter.high, across).min(coordinate(beside.high, across));
            let bottom = coordinate(letter.low, across).max(coordinate(beside.low, across));
            let shared = f64::from(top - bottom + 1);
            if gap(beside) <= GAP * larger && smaller >= SMALLER * larger && shared >= 0.5 * smaller {
                let (from, to) = (root(&row_of, index), root(&row_of, other));
                row_of[from] = to;
            }
        }
        open.push(index);
    }
    let mut rows: BTreeMap<usize, Vec<&PixelMark>> = BTreeMap::new();
    for (index, letter) in letters.iter().enumerate() {
        rows.entry(root(&row_of, index)).or_default().push(letter);
    }
    rows.into_values().collect()
}

fn root(row_of: &[usize], mut index: usize) -> usize {
    while row_of[index] != index {
        index = row_of[index];
    }
    index
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::{from_picture, picture};

    /// The picture on a sheet so large that what is drawn can be letters.
    fn sheet(drawn: &str) -> Grid<bool> {
        let drawn = from_picture(drawn, |c| c == '#').unwrap();
        let mut walls = Grid::filled(400, 300, false);
        for (cell, &is_dark) in drawn.iter() {
            walls[Cell::new(cell.x + 30, cell.y + 30)] = is_dark;
        }
        walls
    }

    fn left(drawn: &str) -> String {
        let mut walls = sheet(drawn);
        remove(&mut walls);
        let found = from_picture(drawn, |_| false).unwrap();
        let cells = Grid::from_rows(
            found.width(),
            (0..found.len())
                .map(|index| walls[Cell::new(found.cell(index).x + 30, found.cell(index).y + 30)])
                .collect(),
        );
        picture(&cells.unwrap(), |&is_dark| if is_dark { '#' } else { '.' }).trim().to_owned()
    }

    const BATH: &str = "\
        #.#.............................\n\
        #.#.............................\n\
        #.#.............................\n\
        #.#.............................\n\
        #.#.............................\n\
        #.#.............................\n\
        #.#............###..............\n\
        #.#...##...##...#...#...#.......\n\
        #.#...#.#.#..#..#...#...#.......\n\
        #.#...##..####..#...#####.......\n\
        #.#...#.#.#..#..#...#...#.......\n\
        #.#...##..#..#..#...#...#.#.....\n\
        #.#.............................\n\
        ################################\n";

    #[test]
    fn a_word_goes_and_the_wall_beside_it_stays() {
        let walls = left(BATH);
        assert_eq!(walls.lines().last().unwrap(), "#".repeat(32));
        assert_eq!(walls.lines().next().unwrap(), format!("#.#{}", ".".repeat(29)));
        assert!(walls.lines().take(13).all(|line| line[3..] == ".".repeat(29)), "{walls}");
    }

    #[test]
    fn the_pieces_of_a_faint_wall_stay() {
        let wall = "\
            ###########..######..#########...####..##########\n\
            ###########..######..#########...####..##########\n\
            ###########..#######.########....####..##########\n\
            ###########..######..#########...####..##########\n";
        assert_eq!(left(wall), wall.trim());
    }

    #[test]
    fn chairs_in_a_row_and_lone_pillars_stay() {
        let chairs = "\
            ####..####..####..####\n\
            #..#..#..#..#..#..#..#\n\
            #..#..#..#..#..#..#..#\n\
            ####..####..####..####\n\
            ......................\n\
            .......######.........\n\
            .......######.........\n\
            .......######.........\n\
            .......######.........\n\
            .......######.........\n";
        assert_eq!(left(chairs), chairs.trim());
    }
}
