//! The change of a walk by one improvement.

use robovac_core::grid::{Cell, Direction};

/// The difference of two walks, regardless of their direction.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WalkDiff {
    /// Cells that they pass in different ways, row by row.
    pub cells: Vec<Cell>,
    /// The parts of the former walk that stay, in its order.
    pub parts: Vec<Vec<Cell>>,
    /// The new parts of the latter walk, in its order.
    pub links: Vec<Vec<Cell>>,
    /// Steps saved; negative if the latter walk has more.
    pub steps: i64,
    /// Quarter turns saved.
    pub turns: i64,
}

impl WalkDiff {
    /// From one walk to another.
    pub fn between(former: &[Cell], latter: &[Cell]) -> Self {
        let (mut before, mut after) = (passages(former), passages(latter));
        let (mut before_steps, mut after_steps) = (edges(former), edges(latter));
        let changed = Multiset::of(before.unlike(&after).chain(after.unlike(&before)).map(|passage| passage >> 8));
        Self {
            cells: changed.0.iter().map(|&(cell, _)| cell_of(cell)).collect(),
            parts: pieces(former, &mut after_steps, &mut after).0,
            links: pieces(latter, &mut before_steps, &mut before).1,
            steps: steps(former) - steps(latter),
            turns: turns(former) - turns(latter),
        }
    }
}

/// A multiset, sorted.
struct Multiset(Vec<(u64, usize)>);

impl Multiset {
    fn of(things: impl Iterator<Item = u64>) -> Self {
        let mut bag = Self(Vec::new());
        for thing in things {
            match bag.find(thing) {
                Ok(at) => bag.0[at].1 += 1,
                Err(at) => bag.0.insert(at, (thing, 1)),
            }
        }
        bag
    }

    fn find(&self, thing: u64) -> Result<usize, usize> {
        self.0.binary_search_by_key(&thing, |&(other, _)| other)
    }

    /// Removes one of a thing; returns whether there was one.
    fn take(&mut self, thing: u64) -> bool {
        let left = self.find(thing).ok().map(|at| &mut self.0[at].1).filter(|count| **count > 0);
        left.map(|count| *count -= 1).is_some()
    }

    /// What another bag has more or less often.
    fn unlike<'b>(&'b self, other: &'b Self) -> impl Iterator<Item = u64> + 'b {
        let has = move |thing, count| other.find(thing).is_ok_and(|at| other.0[at].1 == count);
        self.0.iter().filter(move |&&(thing, count)| !has(thing, count)).map(|&(thing, _)| thing)
    }
}

/// A cell of a room that is filmed, as a number of 32 bits.
fn number(cell: Cell) -> u64 {
    u64::from(cell.y as u16) << 16 | u64::from(cell.x as u16)
}

/// The cell of a number.
fn cell_of(number: u64) -> Cell {
    Cell::new(i32::from(number as u16), i32::from((number >> 16) as u16))
}

/// A step in either direction.
fn edge(a: Cell, b: Cell) -> u64 {
    let (a, b) = (number(a), number(b));
    a.min(b) << 32 | a.max(b)
}

/// How a cell is passed: the sides that the walk comes from and leaves by, in either order, or just one at its ends.
fn passage(walk: &[Cell], index: usize) -> u64 {
    let side = |other: Option<&Cell>| {
        other.and_then(|&other| walk[index].direction_to(other)).map_or(0, |direction| 1 + direction as u64)
    };
    let before = side(index.checked_sub(1).and_then(|before| walk.get(before)));
    let after = side(walk.get(index + 1));
    number(walk[index]) << 8 | before.min(after) << 4 | before.max(after)
}

fn edges(walk: &[Cell]) -> Multiset {
    Multiset::of(walk.windows(2).map(|pair| edge(pair[0], pair[1])))
}

fn passages(walk: &[Cell]) -> Multiset {
    Multiset::of((0..walk.len()).map(|index| passage(walk, index)))
}

/// Cuts a walk into pieces that another walk shares, and the others.
fn pieces(walk: &[Cell], steps: &mut Multiset, ways: &mut Multiset) -> (Vec<Vec<Cell>>, Vec<Vec<Cell>>) {
    let (mut kept, mut torn): (Vec<Vec<Cell>>, Vec<Vec<Cell>>) = (Vec::new(), Vec::new());
    let mut was_kept = None;
    for (index, pair) in walk.windows(2).enumerate() {
        let is_kept = steps.take(edge(pair[0], pair[1]));
        let goes_on = was_kept == Some(is_kept) && (!is_kept || ways.take(passage(walk, index)));
        let pieces = if is_kept { &mut kept } else { &mut torn };
        match pieces.last_mut().filter(|_| goes_on) {
            Some(piece) => piece.push(pair[1]),
            None => pieces.push(pair.to_vec()),
        }
        was_kept = Some(is_kept);
    }
    (kept, torn)
}

/// Steps of a walk.
pub(super) fn steps(walk: &[Cell]) -> i64 {
    walk.len().saturating_sub(1) as i64
}

/// Quarter turns between its steps.
pub(super) fn turns(walk: &[Cell]) -> i64 {
    let directions: Vec<Direction> = walk.windows(2).filter_map(|pair| pair[0].direction_to(pair[1])).collect();
    directions.windows(2).map(|pair| i64::from(pair[0].quarter_turns(pair[1]))).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn walk(cells: &[(i32, i32)]) -> Vec<Cell> {
        cells.iter().map(|&(x, y)| Cell::new(x, y)).collect()
    }

    /// Up and down the columns of a room of 4 x 2 cells.
    fn lanes() -> Vec<Cell> {
        walk(&[(0, 0), (0, 1), (1, 1), (1, 0), (2, 0), (2, 1), (3, 1), (3, 0)])
    }

    #[test]
    fn parts_that_stay_are_told_from_what_is_new() {
        // The right half in the other direction: one step goes, one comes, and the last corner is passed as before.
        let better = walk(&[(0, 0), (0, 1), (1, 1), (1, 0), (2, 0), (3, 0), (3, 1), (2, 1)]);
        let change = WalkDiff::between(&lanes(), &better);
        assert_eq!(change.cells, walk(&[(2, 0), (3, 0), (2, 1)]));
        assert_eq!(change.parts, [lanes()[..5].to_vec(), lanes()[5..].to_vec()]);
        assert_eq!(change.links, [walk(&[(2, 0), (3, 0)])]);
        assert_eq!((change.steps, change.turns), (0, 1));
    }

    #[test]
    fn the_same_walk_backwards_is_no_change() {
        let backwards: Vec<Cell> = lanes().into_iter().rev().collect();
        let change = WalkDiff::between(&lanes(), &backwards);
        assert_eq!((change.cells.len(), change.links.len()), (0, 0));
        assert_eq!(change.parts, [lanes()]);
    }

    #[test]
    fn a_crossing_that_is_only_turned_otherwise_cuts_the_walk() {
        // A cross of five cells with two loops through its middle, which may cross or only touch there.
        let straight = walk(&[(1, 1), (2, 1), (1, 1), (0, 1), (1, 1), (1, 2), (1, 1), (1, 0)]);
        let turned = walk(&[(1, 1), (0, 1), (1, 1), (2, 1), (1, 1), (1, 2), (1, 1), (1, 0)]);
        let change = WalkDiff::between(&straight, &turned);
        assert_eq!(change.cells, walk(&[(1, 1)]));
        assert!(change.links.is_empty() && change.parts.len() > 1, "{change:?}");
    }

    #[test]
    fn steps_that_are_saved_are_counted() {
        let detour = walk(&[(0, 0), (1, 0), (0, 0), (0, 1), (1, 1)]);
        let change = WalkDiff::between(&detour, &walk(&[(0, 0), (1, 0), (1, 1), (0, 1)]));
        assert_eq!((change.steps, change.turns), (1, 2));
        assert_eq!(WalkDiff::between(&[], &[]).parts, Vec::<Vec<Cell>>::new());
    }
}
