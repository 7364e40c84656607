//! A stronger bound by the same dual prices: whole strips of the room instead of single cells.
//!
//! The room is cut into strips of some rows (or columns). Within a strip, neighbours agree on how often their edge is used:
//! what all its passages cost at least, each of its cells visited, is found exactly by dynamic programming over the edges
//! that lead from the cells seen to those not seen yet, except that only no use, odd and even numbers of uses of an edge are
//! told apart ([`super::crossings`]). Between strips the prices pay for agreement as before. Since single cells are the strips that
//! know least, the sum over all strips is at least the cells' bound; on single cells fractions of walks may be mixed, here
//! an odd number of lanes can't end in a wall.
//!
//! An open walk has its beginning in the strip of the start, and its end in the strip where that adds least. Where
//! connection demands v > 1 visits to a cell, each of them costs at least f, the least that a passage costs there, and
//! v f is added (less f if the walk ends below the cell): a passage still costs at least nothing then, and v visits at
//! least v f.

use super::{
    crossings::{Crossings, LABELLINGS, LABELS, Use},
    cut_vertices::CutVertices,
    dual_prices::DualPrices,
    graph::{Graph, NONE},
    profile_dp::DpTrace,
};

/// More than any walk through a strip.
pub(super) const NEVER: i32 = 1 << 29;
/// Higher costs are treated as impossible or clamped to this.
pub(super) const DEAREST: i32 = 1 << 28;
/// Most that a walk's end can save.
const MOST_SAVED: i64 = 1 << 27;

/// Per labelling of a cell's sides in the strip's orientation, the cost of the best use.
type LabelTable = [i32; LABELLINGS];

/// A room in strips.
pub(super) struct RoomStrips {
    /// Their cells, column by column of the strip, [`NONE`] for walls.
    cells: Vec<Vec<u32>>,
    /// Cells across a strip.
    pub height: usize,
    /// The sides of a cell as a strip sees them: along it and across it, forwards and then backwards.
    sides: [usize; 4],
}

/// Costs of a cell's labellings beyond the cell's share of the bound, and the uses they belong to; each without and
/// with the walk's end.
pub(super) struct SiteCosts {
    pub tables: [LabelTable; 2],
    uses: [[[u8; 4]; LABELLINGS]; 2],
}

impl SiteCosts {
    /// The use of a labelling.
    pub fn crossings(&self, kind: usize, labelling: usize) -> [u8; 4] {
        self.uses[kind][labelling]
    }
}

/// The cost of all strips together, and the uses that reach it.
pub(super) struct StripSolution {
    /// In price units.
    pub bound: i64,
    /// Per cell how often each side is used.
    pub crossings: Vec<[u8; 4]>,
}

/// Data of the whole room.
pub(super) struct WholeRoom<'a> {
    pub graph: &'a Graph,
    pub cuts: &'a CutVertices,
    pub prices: &'a DualPrices,
    pub crossings: &'a Crossings,
}

impl RoomStrips {
    /// Strips of at most `most` rows or, if `upright`, columns.
    pub fn new(graph: &Graph, upright: bool, most: usize) -> Self {
        let (width, rows) = (graph.numbers.width(), graph.numbers.height());
        let (length, across) = if upright { (rows, width) } else { (width, rows) };
        let at = |along: usize, across: usize| {
            let (x, y) = if upright { (across, along) } else { (along, across) };
            graph.numbers.values()[y * width + x]
        };
        // As equal as possible.
        let height = across.div_ceil(across.div_ceil(most).max(1)).max(1);
        let inside = |along: usize, j: usize| if j < across { at(along, j) } else { NONE };
        let strip =
            |low: usize| (0..length).flat_map(|along| (low..low + height).map(move |j| inside(along, j))).collect();
        let cells = (0..across).step_by(height).map(strip).collect();
        Self { cells, height, sides: if upright { [1, 0, 3, 2] } else { [0, 1, 2, 3] } }
    }

    /// Number of strips.
    pub fn len(&self) -> usize {
        self.cells.len()
    }

    /// Numbers stored while the largest strip is solved.
    pub fn memory(&self, is_open: bool) -> usize {
        let cells = |strip: &Vec<u32>| strip.iter().filter(|&&cell| cell != NONE).count();
        let most = self.cells.iter().map(cells).max().unwrap_or(0);
        most.saturating_mul(LABELS.saturating_pow(self.height as u32 + 1)).saturating_mul(if is_open { 2 } else { 1 })
    }

    /// The bound of all strips together, at valid prices; `None` if the walk's end can save too much to be represented.
    pub fn solve(&self, room: &WholeRoom<'_>) -> Option<StripSolution> {
        let WholeRoom { graph, cuts, prices, .. } = room;
        let mut below = vec![0; if prices.is_open() { graph.len() } else { 0 }];
        if prices.is_open() {
            for (cell, sum) in cuts.sums_below(|cell| i64::from(prices.visits(cell).0)) {
                below[cell] = sum;
            }
        }
        if below.iter().any(|&saved| saved > MOST_SAVED) {
            return None;
        }
        let visits = |cell: usize| i64::from(prices.visits(cell).0) * (1 + i64::from(cuts.excess[cell]));
        let mut bound: i64 = (0..graph.len()).map(visits).sum();
        let mut crossings = vec![[0; 4]; graph.len()];
        // The strip where the walk's end adds least: the addition, and the strip's uses with the end in it.
        let mut end: Option<(i64, DpTrace)> = None;
        for strip in &self.cells {
            let sites: Vec<SiteCosts> = strip
                .iter()
                .filter(|&&cell| cell != NONE)
                .map(|&cell| self.site(room, cell as usize, below.get(cell as usize).copied().unwrap_or(0)))
                .collect();
            let run = self.run(strip, &sites, prices.is_open());
            let least = run.least.map(|least| i64::from(least.min(DEAREST)));
            bound += least[0];
            for (cell, uses) in run.trace(strip, &sites, false) {
                crossings[cell as usize] = uses;
            }
            let more = least[1] - least[0];
            if prices.is_open() && end.as_ref().is_none_or(|&(least, _)| more < least) {
                end = Some((more, run.trace(strip, &sites, true)));
            }
        }
        if let Some((more, uses)) = end {
            bound += more;
            for (cell, uses) in uses {
                crossings[cell as usize] = uses;
            }
        }
        Some(StripSolution { bound, crossings })
    }

    /// Costs of a cell's labellings.
    fn site(&self, room: &WholeRoom<'_>, cell: usize, below: i64) -> SiteCosts {
        let WholeRoom { graph, cuts, prices, crossings } = room;
        let is_begun = prices.is_open() && cell == graph.start;
        let sides = prices.sides[cell];
        let (passage, _) = prices.visits(cell);
        let is_granted = cuts.excess[cell] > 0;
        let cost = |one: &Use, has_end: bool| {
            let counts = one.crossings.map(i32::from);
            let total: i32 = counts.iter().sum();
            let priced: i32 =
                counts.iter().zip(sides).map(|(&count, price)| if count > 0 { count * price } else { 0 }).sum();
            let visits = (total + i32::from(is_begun) + i32::from(has_end)) / 2;
            let share = if is_granted { visits * passage } else { passage };
            let saved = if has_end { below as i32 } else { 0 };
            priced + prices.step / 2 * total + prices.turn * i32::from(one.turns) - share - saved
        };
        let kinds = if is_begun { &crossings.begun } else { &crossings.plain };
        let mut site = SiteCosts { tables: [[NEVER; LABELLINGS]; 2], uses: [[[0; 4]; LABELLINGS]; 2] };
        for (kind, uses) in kinds.iter().enumerate().take(1 + usize::from(prices.is_open())) {
            for (labelling, uses) in uses.iter().enumerate() {
                let label = |side: usize| labelling / LABELS.pow(side as u32) % LABELS;
                if (0..4).any(|side| graph.neighbours[cell][side] == NONE && label(side) > 0) {
                    continue;
                }
                let seen = (0..4).rev().fold(0, |index, side| index * LABELS + label(self.sides[side]));
                for one in uses {
                    let cost = cost(one, kind == 1);
                    if cost < site.tables[kind][seen] {
                        site.tables[kind][seen] = cost;
                        site.uses[kind][seen] = one.crossings;
                    }
                }
            }
        }
        site
    }
}
