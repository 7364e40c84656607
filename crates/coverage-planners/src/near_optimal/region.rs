//! A region where the walk is rebuilt, while the rest stays.

use super::{
    profile_dp::MOST_OPEN,
    tour::Tour,
    ways::{CellSide, CellWay, MOST_USES, turns},
};
use crate::bounds::{DualPrices, Graph};
use rand::RngExt;
use robovac_core::{
    grid::{Cell, Grid},
    rng::Rng,
};

/// No site.
const OUTSIDE: u32 = u32::MAX;

/// The other side of a site's side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Beyond {
    /// A wall, or floor outside that the walk doesn't enter from here.
    Nothing,
    /// Another site of the region.
    Site,
    /// Floor outside: the side is used as often as its plug says.
    Plug(usize),
}

/// A cell of the region, in the orientation in which columns are scanned one row after the other.
#[derive(Debug, Clone)]
pub(super) struct RegionSite {
    pub cell: u32,
    /// Column of the scan.
    pub column: usize,
    /// Counter-clockwise from the right of the scan.
    pub beyond: [Beyond; 4],
    /// Prices of the sides.
    pub prices: [i32; 4],
    pub is_start: bool,
    /// Current use by the walk.
    now: Now,
    /// Random costs of using a side, and of turning.
    noise: [i32; 4],
    turn_noise: i32,
}

/// Use of a site by a walk.
#[derive(Debug, Clone, Copy, Default)]
struct Now {
    used: [u8; 4],
    turns: u8,
}

/// A side of a site through which the walk leaves the region.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plug {
    /// How often the walk uses it.
    pub uses: u8,
    /// Plugs with the same number are connected outside.
    pub label: u8,
}

/// A rectangle of the grid.
#[derive(Debug, Clone, Copy)]
pub(super) struct Window {
    pub corner: Cell,
    pub width: usize,
    pub height: usize,
}

/// Cells where the walk is rebuilt, the ends of its parts outside, and its current use of the cells.
pub(super) struct WalkRegion {
    /// In the order of the scan.
    pub sites: Vec<RegionSite>,
    pub columns: usize,
    pub plugs: Vec<Plug>,
    /// Whether the walk ends in the region.
    pub has_end: bool,
    /// The side of the robot's heading at the start, and the cost of a quarter turn to the first step.
    pub heading: (CellSide, i32),
    /// Cost of the walk in the region, in price units.
    pub cost: i64,
    /// Noise added to that.
    disturbed: i64,
    /// Positions of the walk's parts outside, and the plugs at both ends.
    pub arcs: Vec<OutsideStretch>,
    is_swapped: bool,
}

/// A part of the walk outside, from one position to another, both included; the second can be smaller in a closed tour.
#[derive(Debug, Clone, Copy)]
pub(super) struct OutsideStretch {
    pub first: usize,
    pub last: usize,
    pub plugs: [Option<usize>; 2],
}

/// The walk's surroundings: cells, prices and heading.
#[derive(Clone, Copy)]
pub(super) struct Ground<'a> {
    pub graph: &'a Graph,
    pub prices: &'a DualPrices,
    /// Numbers of the free cells.
    pub numbers: &'a Grid<u32>,
    /// Side of the heading, and whether the turn from it counts.
    pub heading: CellSide,
    pub counts_first_turn: bool,
}

impl Ground<'_> {
    /// Costs of a step and of a quarter turn, in price units.
    pub fn costs(&self) -> (i32, i32) {
        (self.prices.step, self.prices.turn)
    }
}

fn swapped(side: CellSide) -> CellSide {
    side ^ 1
}

impl WalkRegion {
    /// The region of a window and the walk's parts outside it; `None` if the walk isn't in the window.
    pub fn new(ground: &Ground<'_>, tour: &Tour, window: Window, site_of: &mut [u32]) -> Option<Self> {
        let Ground { graph, prices, numbers, .. } = ground;
        let is_swapped = window.width > window.height;
        let (columns, rows) = if is_swapped { (window.height, window.width) } else { (window.width, window.height) };
        let turned = |side: CellSide| if is_swapped { swapped(side) } else { side };
        let mut sites: Vec<RegionSite> = Vec::new();
        for row in 0..rows {
            for column in 0..columns {
                let (dx, dy) = if is_swapped { (row, column) } else { (column, row) };
                let cell = Cell::new(window.corner.x + dx as i32, window.corner.y + dy as i32);
                let Some(&number) = numbers.get(cell).filter(|&&number| number != OUTSIDE) else { continue };
                site_of[number as usize] = sites.len() as u32;
                let sides = prices.sides[number as usize];
                sites.push(RegionSite {
                    cell: number,
                    column,
                    beyond: [Beyond::Nothing; 4],
                    prices: std::array::from_fn(|side| sides[turned(side)]),
                    is_start: number as usize == graph.start && !tour.is_closed,
                    now: Now::default(),
                    noise: [0; 4],
                    turn_noise: 0,
                });
            }
        }
        for site in &mut sites {
            for (side, beyond) in site.beyond.iter_mut().enumerate() {
                let next = graph.neighbours[site.cell as usize][turned(side)];
                if next != OUTSIDE && site_of[next as usize] != OUTSIDE {
                    *beyond = Beyond::Site;
                }
            }
        }
        let turn = if ground.counts_first_turn { prices.turn } else { 0 };
        let mut region = Self {
            sites,
            columns,
            plugs: Vec::new(),
            has_end: false,
            heading: (turned(ground.heading), turn),
            cost: 0,
            disturbed: 0,
            arcs: Vec::new(),
            is_swapped,
        };
        let is_found = region.cut_out(ground, tour, site_of);
        for site in &region.sites {
            site_of[site.cell as usize] = OUTSIDE;
        }
        is_found.then_some(region)
    }

    /// Finds the walk's parts outside and its cost inside.
    fn cut_out(&mut self, ground: &Ground<'_>, tour: &Tour, site_of: &[u32]) -> bool {
        let mut positions: Vec<usize> = self.sites.iter().flat_map(|site| tour.visits(site.cell)).collect();
        positions.sort_unstable();
        let cell = |position: usize| tour.cells[position];
        let is_inside = |position: usize| site_of[cell(position) as usize] != OUTSIDE;
        // In the order of the walk: where it leaves the region and where it comes back, each inside and outside.
        let (mut leaves, mut comes) = (Vec::new(), Vec::new());
        for &position in &positions {
            let site = site_of[cell(position) as usize] as usize;
            let sides = [false, true].map(|is_after| {
                let other = tour.beside(position, is_after)?;
                Some((self.side(ground.graph, cell(position), cell(other)), other))
            });
            for (is_after, side) in [false, true].into_iter().zip(sides) {
                let Some((side, other)) = side.filter(|&(_, other)| !is_inside(other)) else { continue };
                let plug = self.plug(site, side);
                if is_after { leaves.push((position, other, plug)) } else { comes.push((position, other, plug)) }
            }
            let sides = sides.map(|side| side.map(|(side, _)| side));
            let now = &mut self.sites[site].now;
            for side in sides.into_iter().flatten() {
                now.used[side] = now.used[side].saturating_add(1);
            }
            if let [Some(a), Some(b)] = sides {
                now.turns = now.turns.saturating_add(turns(a, b) as u8);
            }
            self.cost += i64::from(self.passage_cost(ground.prices, site, sides));
        }
        let (Some(&first), Some(&last)) = (positions.first(), positions.last()) else { return false };
        if tour.is_closed {
            // If the walk's seam lies outside, the first return belongs to the last exit.
            if comes.first().zip(leaves.first()).is_some_and(|(comes, leaves)| comes.0 <= leaves.0) {
                comes.rotate_left(1);
            }
        } else {
            self.has_end = last + 1 == tour.cells.len();
            if first > 0 {
                let (_, other, plug) = comes.remove(0);
                self.arcs.push(OutsideStretch { first: 0, last: other, plugs: [None, Some(plug)] });
            }
            if !self.has_end
                && let Some((_, other, plug)) = leaves.pop()
            {
                self.arcs.push(OutsideStretch { first: other, last: tour.cells.len() - 1, plugs: [Some(plug), None] });
            }
        }
        let between = leaves.into_iter().zip(comes);
        self.arcs.extend(between.map(|(from, to)| OutsideStretch {
            first: from.1,
            last: to.1,
            plugs: [Some(from.2), Some(to.2)],
        }));
        let is_too_much = |plug: &Plug| usize::from(plug.uses) > MOST_USES;
        if self.plugs.len() + self.columns > MOST_OPEN || self.plugs.iter().any(is_too_much) {
            return false;
        }
        for (i, plug) in self.plugs.iter_mut().enumerate() {
            plug.label = 1 + i as u8;
        }
        for arc in &self.arcs {
            if let [Some(a), Some(b)] = arc.plugs {
                let (from, to) = (self.plugs[a].label, self.plugs[b].label);
                self.plugs.iter_mut().filter(|plug| plug.label == from).for_each(|plug| plug.label = to);
            }
        }
        true
    }

    fn side(&self, graph: &Graph, from: u32, to: u32) -> CellSide {
        let side = graph.neighbours[from as usize].iter().position(|&next| next == to).unwrap_or(0);
        if self.is_swapped { swapped(side) } else { side }
    }

    /// Uses a plug once more.
    fn plug(&mut self, site: usize, side: CellSide) -> usize {
        if let Beyond::Plug(plug) = self.sites[site].beyond[side] {
            self.plugs[plug].uses = self.plugs[plug].uses.saturating_add(1);
            return plug;
        }
        self.sites[site].beyond[side] = Beyond::Plug(self.plugs.len());
        self.plugs.push(Plug { uses: 1, label: 0 });
        self.plugs.len() - 1
    }

    /// Cost of a visit by the sides it uses; `None` before the walk's first and after its last.
    fn passage_cost(&self, prices: &DualPrices, site: usize, sides: [Option<CellSide>; 2]) -> i32 {
        let site = &self.sites[site];
        match sides {
            [Some(a), Some(b)] => prices.step + prices.turn * turns(a, b) as i32 + site.prices[a] + site.prices[b],
            [None, Some(first)] => prices.step / 2 + site.prices[first] + self.first_turn(first),
            [Some(last), None] => prices.step / 2 + site.prices[last],
            [None, None] => 0,
        }
    }

    /// Cost of a way in a site, in price units.
    pub fn cost_of(&self, (step, turn): (i32, i32), site: &RegionSite, way: &CellWay) -> i32 {
        let sides: i32 = (0..4).map(|side| i32::from(way.used[side]) * site.prices[side]).sum();
        let first = if site.is_start { way.halves.first().map_or(0, |&side| self.first_turn(side)) } else { 0 };
        let half_steps = (2 * way.passages.len() + way.halves.len()) as i32;
        half_steps * step / 2 + i32::from(way.turns) * turn + sides + first
    }

    /// Cost of a way in a site, noise included.
    pub fn seeming_cost_of(&self, costs: (i32, i32), site: &RegionSite, way: &CellWay) -> i32 {
        let noise: i32 = (0..4).map(|side| i32::from(way.used[side]) * site.noise[side]).sum();
        self.cost_of(costs, site, way) + noise + i32::from(way.turns) * site.turn_noise
    }

    /// Cost of the turn from the heading to the first step.
    pub fn first_turn(&self, side: CellSide) -> i32 {
        let (heading, turn) = self.heading;
        turn * turns(heading ^ 2, side) as i32
    }

    /// Changes the cost of every side and every turn at random, by up to `most` price units each, so that another walk
    /// can seem cheaper than the current one. Sites store the change for the current walk.
    pub fn disturb(&mut self, most: i32, rng: &mut Rng) {
        for site in &mut self.sites {
            for side in 0..2 {
                if site.beyond[side] == Beyond::Site {
                    site.noise[side] = rng.random_range(-most..=most);
                }
            }
            site.turn_noise = rng.random_range(-most..=most);
            let sides: i32 = (0..4).map(|side| i32::from(site.now.used[side]) * site.noise[side]).sum();
            self.disturbed += i64::from(sides + i32::from(site.now.turns) * site.turn_noise);
        }
    }

    /// Cost of the current walk in the region, noise included.
    pub fn seeming_cost(&self) -> i64 {
        self.cost + self.disturbed
    }
}
