//! Stage: mega-cells of 2 x 2 cells, and the tour round a tree that connects them (Gabriely & Rimon 2001).

use super::{cost::Costs, frame::FramedGrid};
use robovac_core::grid::{Cell, Direction, Grid};

/// Mega-cells, and the tours round the trees that join them.
///
/// A mega-cell of four free cells starts with a tour round these four. In one that is partly blocked, a tour goes to and
/// fro over the free cells; two that only touch diagonally are mega-cells of their own. Joining two neighbours makes one
/// tour of theirs: over the whole side that they share if it is free, which adds no step, else there and back through
/// the one pair of free cells, which adds two.
#[derive(Debug, Clone)]
pub(crate) struct MegaCells {
    frame: FramedGrid,
    /// The mega-cell of every cell; [`NONE`] for blocked cells.
    mega_of: Vec<u32>,
    /// For every mega-cell and direction the cell at that side, or the lower or left one of two, from which a step leads
    /// into its neighbour; [`NONE`] if there is none.
    sides: Vec<[u32; 4]>,
    /// How often the tour takes the way from a cell to each neighbour: two bits a direction.
    ways: Vec<u8>,
}

const NONE: u32 = u32::MAX;

/// Where two mega-cells can be joined.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MegaLink {
    /// The neighbour.
    pub to: usize,
    /// Whether both cells of the shared side are free on both sides.
    pub is_wide: bool,
    towards: Direction,
    cell: usize,
}

/// Addition of a join to the tour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Added {
    pub steps: i32,
    pub turns: i32,
}

impl MegaCells {
    /// Mega-cells whose lower left megas have coordinates that are even, or odd along x or y.
    pub fn new(free: &Grid<bool>, is_odd: [bool; 2]) -> Self {
        let frame = FramedGrid::around(free);
        let mut mega_of = frame.drawn(free, 0, NONE);
        let mut ways = frame.filled(0);
        let mut megas = 0_u32;
        for y in (-i32::from(is_odd[1])..free.height() as i32).step_by(2) {
            for x in (-i32::from(is_odd[0])..free.width() as i32).step_by(2) {
                let cells = cells_of(frame, frame.index(Cell::new(x, y)));
                let is_free = cells.map(|cell| mega_of[cell] != NONE);
                let is_split = is_free[0] == is_free[2] && is_free[1] == is_free[3] && is_free[0] != is_free[1];
                let first = megas;
                for (cell, _) in cells.into_iter().zip(is_free).filter(|&(_, is_free)| is_free) {
                    mega_of[cell] = if is_split { megas } else { first };
                    megas = if is_split { megas + 1 } else { first + 1 };
                }
                let times = if is_free == [true; 4] { 1 } else { 2 };
                for (i, towards) in Direction::ALL.into_iter().enumerate() {
                    let j = (i + 1) % 4;
                    if is_free[i] && is_free[j] {
                        ways[cells[i]] += times * unit(towards);
                        ways[cells[j]] += times * unit(towards.opposite());
                    }
                }
            }
        }
        let mut sides = vec![[NONE; 4]; megas as usize];
        // From the last cell to the first, so that the lower or left one of two stays.
        for index in (0..mega_of.len()).rev().filter(|&index| mega_of[index] != NONE) {
            for (direction, next) in Direction::ALL.into_iter().zip(frame.neighbours(index)) {
                if mega_of[next] != NONE && mega_of[next] != mega_of[index] {
                    sides[mega_of[index] as usize][direction as usize] = index as u32;
                }
            }
        }
        Self { frame, mega_of, sides, ways }
    }

    /// Number of mega-cells.
    pub fn len(&self) -> usize {
        self.sides.len()
    }

    /// The mega-cell that a cell is in.
    pub fn of_cell(&self, cell: Cell) -> usize {
        self.mega_of[self.frame.index(cell)] as usize
    }

    /// Where a mega-cell can be joined with its neighbour in one direction.
    pub fn link(&self, mega: usize, towards: Direction) -> Option<MegaLink> {
        let cell = self.sides[mega][towards as usize];
        if cell == NONE {
            return None;
        }
        let cell = cell as usize;
        let to = self.mega_of[self.frame.ahead(cell, towards)];
        let second = self.frame.ahead(cell, along(towards));
        let is_wide = self.mega_of[second] == mega as u32 && self.mega_of[self.frame.ahead(second, towards)] == to;
        Some(MegaLink { to: to as usize, is_wide, towards, cell })
    }

    /// Addition of joining there to the tours.
    pub fn added(&self, link: MegaLink) -> Added {
        let turns = self.changes(link).map(|(cell, ways)| turns_of(ways) - turns_of(self.ways[cell])).into_iter().sum();
        if link.is_wide { Added { steps: 0, turns } } else { Added { steps: 2, turns: turns / 2 } }
    }

    /// Makes one tour of the two.
    pub fn join(&mut self, link: MegaLink) {
        for (cell, ways) in self.changes(link) {
            self.ways[cell] = ways;
        }
    }

    /// The four cells at a link with their ways after joining; twice the same two if it is narrow.
    fn changes(&self, link: MegaLink) -> [(usize, u8); 4] {
        let MegaLink { cell, towards, is_wide, .. } = link;
        let back = towards.opposite();
        let ahead = |cell| self.frame.ahead(cell, towards);
        if is_wide {
            let up = along(towards);
            let second = self.frame.ahead(cell, up);
            let with = |cell: usize, more, less| (cell, self.ways[cell] + unit(more) - unit(less));
            [
                with(cell, towards, up),
                with(second, towards, up.opposite()),
                with(ahead(cell), back, up),
                with(ahead(second), back, up.opposite()),
            ]
        } else {
            let here = (cell, self.ways[cell] + 2 * unit(towards));
            let there = (ahead(cell), self.ways[ahead(cell)] + 2 * unit(back));
            [here, here, there, there]
        }
    }

    /// The tour from `start` until it is back, straight on where it can; it uses up the ways.
    pub fn tour(mut self, start: Cell, heading: Direction) -> Vec<Cell> {
        // Hierholzer 1873: go on until stuck, then back up to a cell with ways left.
        let mut tour = Vec::with_capacity(self.mega_of.len());
        let mut stack = Vec::with_capacity(self.mega_of.len());
        stack.push((self.frame.index(start) as u32, heading));
        while let Some(&(at, heading)) = stack.last() {
            let index = at as usize;
            let looks = [heading, heading.right(), heading.left(), heading.opposite()];
            if let Some(direction) = looks.into_iter().find(|&d| self.ways[index] & (3 * unit(d)) != 0) {
                let next = self.frame.ahead(index, direction);
                self.ways[index] -= unit(direction);
                self.ways[next] -= unit(direction.opposite());
                stack.push((next as u32, direction));
            } else {
                tour.push(self.frame.cell(index));
                stack.pop();
            }
        }
        tour
    }
}

/// The four cells of a mega-cell, counter-clockwise from the lower left.
fn cells_of(frame: FramedGrid, corner: usize) -> [usize; 4] {
    let up = corner + frame.stride();
    [corner, corner + 1, up + 1, up]
}

/// From the lower or left cell of a side to the other one.
fn along(side: Direction) -> Direction {
    if side.is_horizontal() { Direction::Up } else { Direction::Right }
}

/// One way in a direction.
fn unit(direction: Direction) -> u8 {
    1 << (2 * direction as u8)
}

/// Quarter turns that a tour needs in a cell with these ways: it goes straight as often as it can, then round megas, and
/// turns back for the rest.
fn turns_of(ways: u8) -> i32 {
    let [right, up, left, down] = [0, 2, 4, 6].map(|shift| i32::from(ways >> shift & 3));
    (right - left).abs().max((up - down).abs())
}

/// A link changes the turns in each of at most four cells by at most two.
const MOST_TURNS: i32 = 8;

impl Added {
    /// All possible additions of a link.
    pub fn all() -> impl Iterator<Item = Self> {
        [0, 2].into_iter().flat_map(|steps| (-MOST_TURNS..=MOST_TURNS).map(move |turns| Self { steps, turns }))
    }

    /// Its cost in the units of `costs`.
    pub fn cost(self, costs: Costs) -> i32 {
        self.steps * costs.step as i32 + self.turns * costs.turn as i32
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::from_picture;

    fn megas(picture: &str) -> MegaCells {
        MegaCells::new(&from_picture(picture, |c| c == '.').unwrap(), [false, false])
    }

    #[test]
    fn two_cells_that_touch_diagonally_are_two_mega_cells() {
        assert_eq!(megas("..\n..").len(), 1);
        assert_eq!(megas("#.\n..").len(), 1);
        assert_eq!(megas(".#\n#.").len(), 2);
        assert_eq!(megas("#..#\n...#").len(), 2);
    }

    #[test]
    fn wide_links_add_no_step_and_narrow_ones_two() {
        for (picture, is_wide, steps, added) in [
            ("....\n....", true, 8, Added { steps: 0, turns: -4 }),
            ("..#.\n....", false, 4 + 4 + 2, Added { steps: 2, turns: -2 }),
        ] {
            let mut megas = megas(picture);
            let link = megas.link(0, Direction::Right).unwrap();
            assert_eq!((link.to, link.is_wide, megas.added(link)), (1, is_wide, added), "{picture}");
            megas.join(link);
            let tour = megas.tour(Cell::new(0, 0), Direction::Right);
            assert_eq!((tour.len() - 1, tour[0]), (steps, tour[steps]), "{picture}");
        }
    }

    #[test]
    fn turns_are_those_of_the_straightest_tour() {
        let ways = |all: [u8; 4]| all.iter().zip(Direction::ALL).map(|(n, d)| n * unit(d)).sum::<u8>();
        for (all, turns) in
            [([1, 0, 1, 0], 0), ([1, 1, 0, 0], 1), ([2, 0, 0, 0], 2), ([2, 2, 0, 0], 2), ([1, 2, 1, 0], 2)]
        {
            assert_eq!(turns_of(ways(all)), turns, "{all:?}");
        }
    }
}
