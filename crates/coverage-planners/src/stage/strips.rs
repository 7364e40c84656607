//! Stage: which floor to sweep along x and which along y, with the fewest lane ends.
//!
//! Every lane has two ends, and a mower makes a quarter turn at each. Fewest lanes that cover all cells are a smallest
//! strip cover, which Arkin, Bender, Demaine, Fekete, Mitchell & Sethia 2005 ("Optimal covering tours with turn costs", SIAM
//! J. Comput. 35(3)) find as a smallest vertex cover in the bipartite graph of rows and columns, by König's theorem. That
//! theorem is the unweighted case of minimum cut = maximum flow; the cut used here weighs turns against steps, as lanes
//! that cross clean floor twice. Its nodes aren't cells but *pieces*, rectangles between the lines on which walls begin or
//! end: moving the border between floor mown along x and along y inside a piece changes the cost linearly, so that an
//! end of the piece is as good.

use super::{
    axis::swap_grid,
    cost::Costs,
    decompose::{Block, decompose},
    min_cut::FlowNetwork,
    part::MownBlock,
};
use crate::PlanError;
use robovac_core::grid::{Cell, Direction, Grid};

/// Floor to be mown along x, and along y; some cells both ways if crossing them is cheaper than ending lanes there.
#[derive(Debug)]
pub struct Strips {
    /// Along x.
    pub along_x: Grid<bool>,
    /// Along y.
    pub along_y: Grid<bool>,
}

impl Strips {
    /// The same with x and y swapped.
    pub fn swapped(self) -> Self {
        Self { along_x: swap_grid(&self.along_y), along_y: swap_grid(&self.along_x) }
    }

    /// Connected floor of one direction, cut at critical points and wherever a wall beside it jumps by more than
    /// `max_jump` cells.
    pub fn parts(&self, max_jump: i32) -> Vec<MownBlock> {
        let along_y = swap_grid(&self.along_y);
        let parts = |floor, is_swapped| {
            decompose(floor, max_jump).into_iter().map(move |block| MownBlock { block, is_swapped })
        };
        parts(&self.along_x, false).chain(parts(&along_y, true)).collect()
    }
}

/// Cost of a lane's end at floor mown the other way.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Borders {
    /// The same as at a wall.
    Apart,
    /// A little less, as one turn can lead from one lane into the other and so serve the ends of both. For lanes that
    /// are driven part by part; the reduction was found by trial.
    Shared,
}

impl Borders {
    /// In the units of [`SCALE`].
    fn weight(self) -> u32 {
        if self == Self::Apart { SCALE } else { SCALE - 1 }
    }
}

/// Most pieces in the minimum cut.
const MAX_PIECES: usize = 60_000;
/// Weight of a lane's end at a wall.
const SCALE: u32 = 8;
/// More than all ends of a piece weigh.
const NEVER: u32 = 1 << 30;
/// Not in a piece.
const NONE: u32 = u32::MAX;

/// The strips whose ends and crossings cost least; all floor along x if there are too many pieces.
///
/// ```
/// use robovac_core::grid::*;
/// use coverage_planners::stage::*;
/// let free = from_picture(
///     "
///     ..####
///     ..####
///     ..####
///     ......
///     ......", |c| c == '.').unwrap();
/// let strips = strips(&free, Costs { step: 16, turn: 32 }, Borders::Shared, || Ok(())).unwrap();
/// assert_eq!(picture(&strips.along_x, |&x| if x { '-' } else { ' ' }), "      \n      \n      \n  ----\n  ----\n");
/// assert_eq!(picture(&strips.along_y, |&y| if y { '|' } else { ' ' }), "||    \n||    \n||    \n||    \n||    \n");
/// ```
pub fn strips(
    free: &Grid<bool>,
    costs: Costs,
    borders: Borders,
    mut report: impl FnMut() -> Result<(), PlanError>,
) -> Result<Strips, PlanError> {
    let (mut pieces, mut count) = pieces_of(free, 0);
    if count > MAX_PIECES {
        report()?;
        (pieces, count) = pieces_of(free, i32::MAX);
    }
    if count > MAX_PIECES {
        return Ok(Strips { along_x: free.clone(), along_y: free.map(|_| false) });
    }
    // Node 2 p is on the side of the source if piece p is mown along x, node 2 p + 1 if it isn't mown along y.
    let mut network = FlowNetwork::new(2 * count);
    let mut contacts = Vec::new();
    let mut areas = vec![0_u32; count];
    for (cell, &piece) in pieces.iter().filter(|&(_, &piece)| piece != NONE) {
        areas[piece as usize] += 1;
        for direction in Direction::ALL {
            let other = pieces.get(cell.step(direction)).copied().unwrap_or(NONE);
            let node = 2 * piece + u32::from(!direction.is_horizontal());
            if other == NONE && direction.is_horizontal() {
                network.tie_to_sink(node as usize, SCALE * costs.turn);
            } else if other == NONE {
                network.tie_to_source(node as usize, SCALE * costs.turn);
            } else if other > piece {
                contacts.push((node, node + 2 * (other - piece)));
            }
        }
    }
    contacts.sort_unstable();
    for same in contacts.chunk_by(|a, b| a == b) {
        let cost = (same.len() as u32).saturating_mul(borders.weight() * costs.turn).min(NEVER);
        network.add_edge(same[0].0 as usize, same[0].1 as usize, cost, cost);
    }
    for (piece, &area) in areas.iter().enumerate() {
        network.add_edge(2 * piece, 2 * piece + 1, area.saturating_mul(SCALE * costs.step).min(NEVER), NEVER);
    }
    let sides = network.cut(report)?;
    let is_mown =
        |shift: usize| pieces.map(|&piece| piece != NONE && sides[2 * piece as usize + shift] == (shift == 0));
    Ok(Strips { along_x: is_mown(0), along_y: is_mown(1) })
}

/// Numbers the pieces, [`NONE`] for cells that aren't free; returns their count as well.
fn pieces_of(free: &Grid<bool>, max_jump: i32) -> (Grid<u32>, usize) {
    let mut blocks = free.map(|_| (NONE, NONE));
    let paint = |all: Vec<Block>, mut set: Box<dyn FnMut(i32, i32, u32) + '_>| {
        for (number, block) in (0..).zip(all) {
            for run in block {
                for x in run.left..=run.right {
                    set(x, run.y, number);
                }
            }
        }
    };
    paint(decompose(free, max_jump), Box::new(|x, y, number| blocks[Cell::new(x, y)].0 = number));
    paint(decompose(&swap_grid(free), max_jump), Box::new(|y, x, number| blocks[Cell::new(x, y)].1 = number));
    let mut pieces = free.map(|_| NONE);
    let mut count = 0;
    for (cell, &block) in blocks.iter().filter(|&(_, &block)| block.0 != NONE) {
        let before = [Direction::Left, Direction::Down].map(|d| cell.step(d));
        let same = before.into_iter().find(|&next| blocks.get(next) == Some(&block));
        pieces[cell] = same.map_or(count, |next| pieces[next]);
        count += u32::from(same.is_none());
    }
    (pieces, count as usize)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const COSTS: Costs = Costs { step: 16, turn: 32 };

    /// Ends of the lanes of a grid.
    fn ends(grid: &Grid<bool>) -> usize {
        decompose(grid, i32::MAX).iter().map(|block| 2 * block.len()).sum()
    }

    /// Arkin et al. 2005: as many strips are needed as rooks fit in without attacking each other. In a plus with arms of
    /// one cell these are two.
    #[test]
    fn plus_takes_two_strips() {
        let free = robovac_core::grid::from_picture("##.##\n##.##\n.....\n##.##\n##.##", |c| c == '.').unwrap();
        let found = strips(&free, COSTS, Borders::Shared, || Ok(())).unwrap();
        assert_eq!((ends(&found.along_x), ends(&swap_grid(&found.along_y))), (2, 2));
    }

    /// Steps through all cells of lanes, and turns at their ends.
    fn cost(strips: &Strips) -> usize {
        let lanes = [strips.along_x.clone(), swap_grid(&strips.along_y)];
        let cost = |lanes: &Grid<bool>| lanes.count() * COSTS.step as usize + ends(lanes) * COSTS.turn as usize;
        lanes.iter().map(cost).sum()
    }

    #[test]
    fn no_other_strips_cost_less() {
        for seed in 0..8 {
            let free = robovac_core::floor_plan::generate::random_clutter(3, 3, 0.3, seed);
            let cells: Vec<Cell> = free.iter().filter(|&(_, &f)| f).map(|(cell, _)| cell).collect();
            // Along x, along y or both in every cell.
            let least = (0..3_usize.pow(cells.len() as u32)).map(|choice| {
                let none = free.map(|_| false);
                let mut strips = Strips { along_x: none.clone(), along_y: none };
                for (i, &cell) in cells.iter().enumerate() {
                    let way = choice / 3_usize.pow(i as u32) % 3;
                    (strips.along_x[cell], strips.along_y[cell]) = (way != 1, way != 0);
                }
                cost(&strips)
            });
            let found = strips(&free, COSTS, Borders::Apart, || Ok(())).unwrap();
            let turned = strips(&swap_grid(&free), COSTS, Borders::Apart, || Ok(())).unwrap().swapped();
            assert_eq!((cost(&found), cost(&turned)), (cost(&turned), least.min().unwrap()), "{seed}");
        }
    }

    proptest! {
        #[test]
        fn all_is_mown_and_nothing_else(bits in proptest::collection::vec(proptest::bool::weighted(0.7), 12 * 9)) {
            let free = Grid::from_rows(12, bits).unwrap();
            let found = strips(&free, COSTS, Borders::Shared, || Ok(())).unwrap();
            for (cell, &is_free) in free.iter() {
                prop_assert_eq!(found.along_x[cell] || found.along_y[cell], is_free);
            }
        }
    }
}
