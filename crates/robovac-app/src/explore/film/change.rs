//! The change of a walk by one improvement.

use robovac_core::grid::{Cell, Direction};
use std::collections::{BTreeMap, BTreeSet};

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
        let ways = before.keys().chain(after.keys());
        let changed = ways.filter(|way| before.get(way) != after.get(way));
        let mut cells = BTreeSet::new();
        cells.extend(changed.map(|(cell, _)| (cell.y, cell.x)));
        let cells = cells.into_iter().map(|(y, x)| Cell::new(x, y)).collect();
        Self {
            cells,
            parts: pieces(former, &mut after_steps, &mut after).0,
            links: pieces(latter, &mut before_steps, &mut before).1,
            steps: steps(former) - steps(latter),
            turns: turns(former) - turns(latter),
        }
    }
}

/// A step, from the lesser cell to the greater.
type WalkEdge = (Cell, Cell);
/// How a cell is passed: the sides that the walk comes from and leaves by, in either order, or just one at its ends.
type Passage = (Cell, [Option<Direction>; 2]);
/// A multiset.
type Bag<T> = BTreeMap<T, usize>;

fn edge(a: Cell, b: Cell) -> WalkEdge {
    (a.min(b), a.max(b))
}

fn passage(walk: &[Cell], index: usize) -> Passage {
    let side = |other: Option<&Cell>| walk[index].direction_to(*other?);
    let before = side(index.checked_sub(1).and_then(|before| walk.get(before)));
    let after = side(walk.get(index + 1));
    (walk[index], [before.min(after), before.max(after)])
}

fn bag<T: Ord>(things: impl Iterator<Item = T>) -> Bag<T> {
    let mut bag = Bag::new();
    for thing in things {
        *bag.entry(thing).or_default() += 1;
    }
    bag
}

fn edges(walk: &[Cell]) -> Bag<WalkEdge> {
    bag(walk.windows(2).map(|pair| edge(pair[0], pair[1])))
}

fn passages(walk: &[Cell]) -> Bag<Passage> {
    bag((0..walk.len()).map(|index| passage(walk, index)))
}

/// Removes one element from the bag; returns whether there was one.
fn take<T: Ord>(bag: &mut Bag<T>, thing: &T) -> bool {
    bag.get_mut(thing).filter(|count| **count > 0).map(|count| *count -= 1).is_some()
}

/// Cuts a walk into pieces that another walk shares, and the others.
fn pieces(walk: &[Cell], steps: &mut Bag<WalkEdge>, ways: &mut Bag<Passage>) -> (Vec<Vec<Cell>>, Vec<Vec<Cell>>) {
    let (mut kept, mut torn): (Vec<Vec<Cell>>, Vec<Vec<Cell>>) = (Vec::new(), Vec::new());
    let mut was_kept = None;
    for (index, pair) in walk.windows(2).enumerate() {
        let is_kept = take(steps, &edge(pair[0], pair[1]));
        let goes_on = was_kept == Some(is_kept) && (!is_kept || take(ways, &passage(walk, index)));
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
