//! A part of the room that is walked anew, while the rest of the walk stays.

use super::{
    tour::Tour,
    frontier::MOST_OPEN,
    ways::{MOST_USES, Side, Way, turns},
};
use crate::{
    grid::{Cell, Grid},
    planner::bounds::{Graph, Prices},
};

/// No site.
const OUTSIDE: u32 = u32::MAX;

/// What lies beyond a side of a site.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Beyond {
    /// A wall, or floor outside that the walk doesn't go to from here.
    Nothing,
    /// Another site of the region.
    Site,
    /// Floor outside: the walk uses the side as often as its plug says.
    Plug(usize),
}

/// A cell of the region, as it's seen when columns are scanned one row after the other.
#[derive(Debug, Clone)]
pub(super) struct Site {
    pub cell: u32,
    /// Column of the scan.
    pub column: usize,
    /// Counter-clockwise from the right of the scan.
    pub beyond: [Beyond; 4],
    /// Prices of the sides.
    pub prices: [i32; 4],
    pub is_start: bool,
}

/// A side of a site through which the walk leaves the region.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plug {
    pub site: usize,
    pub side: Side,
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

/// Cells to be walked anew, the ends of the walk's parts outside, and what it does inside now.
pub(super) struct Region {
    /// In the order of the scan.
    pub sites: Vec<Site>,
    pub columns: usize,
    pub plugs: Vec<Plug>,
    /// Whether the walk ends in the region.
    pub has_end: bool,
    /// Side that the robot looks to at the start, and what a quarter turn to the first step costs.
    pub heading: (Side, i32),
    /// What the walk costs in the region, in price units.
    pub cost: i64,
    /// Positions of the walk's parts outside, and the plugs at both ends.
    arcs: Vec<Arc>,
    is_swapped: bool,
}

/// A part of the walk outside, from one position to another, both included; the second may be smaller in a closed tour.
#[derive(Debug, Clone, Copy)]
struct Arc {
    first: usize,
    last: usize,
    plugs: [Option<usize>; 2],
}

/// Where things are looked up.
pub(super) struct Ground<'a> {
    pub graph: &'a Graph,
    pub prices: &'a Prices,
    /// Numbers of the free cells.
    pub numbers: &'a Grid<u32>,
    /// Sides of the heading, and whether the turn from it counts.
    pub heading: Side,
    pub counts_first_turn: bool,
}

fn swapped(side: Side) -> Side {
    side ^ 1
}

impl Region {
    /// The region of a window and the walk's parts outside it; `None` if the walk isn't there at all.
    pub fn new(ground: &Ground<'_>, tour: &Tour, window: Window, site_of: &mut [u32]) -> Option<Self> {
        let Ground { graph, prices, numbers, .. } = ground;
        let is_swapped = window.width > window.height;
        let (columns, rows) =
            if is_swapped { (window.height, window.width) } else { (window.width, window.height) };
        let turned = |side: Side| if is_swapped { swapped(side) } else { side };
        let mut sites = Vec::new();
        for row in 0..rows {
            for column in 0..columns {
                let (dx, dy) = if is_swapped { (row, column) } else { (column, row) };
                let cell = Cell::new(window.corner.x + dx as i32, window.corner.y + dy as i32);
                let Some(&number) = numbers.get(cell).filter(|&&number| number != OUTSIDE) else { continue };
                site_of[number as usize] = sites.len() as u32;
                let sides = prices.sides[number as usize];
                sites.push(Site {
                    cell: number,
                    column,
                    beyond: [Beyond::Nothing; 4],
                    prices: std::array::from_fn(|side| sides[turned(side)]),
                    is_start: number as usize == graph.start && !tour.is_closed,
                });
            }
        }
        for site in 0..sites.len() {
            for side in 0..4 {
                let next = graph.neighbours[sites[site].cell as usize][turned(side)];
                if next != OUTSIDE && site_of[next as usize] != OUTSIDE {
                    sites[site].beyond[side] = Beyond::Site;
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
            arcs: Vec::new(),
            is_swapped,
        };
        let is_found = region.cut_out(ground, tour, site_of);
        region.sites.iter().for_each(|site| site_of[site.cell as usize] = OUTSIDE);
        is_found.then_some(region)
    }

    /// Finds the walk's parts outside and what it costs inside.
    fn cut_out(&mut self, ground: &Ground<'_>, tour: &Tour, site_of: &[u32]) -> bool {
        let mut positions: Vec<usize> = self.sites.iter().flat_map(|site| tour.visits(site.cell)).collect();
        positions.sort_unstable();
        let cell = |position: usize| tour.cells[position];
        let is_inside = |position: usize| site_of[cell(position) as usize] != OUTSIDE;
        // In the order of the walk: where it leaves the region, where it comes back; there and outside.
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
            self.cost += i64::from(self.passage_cost(ground.prices, site, sides.map(|side| side.map(|(side, _)| side))));
        }
        let (Some(&first), Some(&last)) = (positions.first(), positions.last()) else { return false };
        if tour.is_closed {
            // If the walk's seam lies outside, it comes back first by the part that leaves last.
            if comes.first().zip(leaves.first()).is_some_and(|(comes, leaves)| comes.0 <= leaves.0) {
                comes.rotate_left(1);
            }
        } else {
            self.has_end = last + 1 == tour.cells.len();
            if first > 0 {
                let (_, other, plug) = comes.remove(0);
                self.arcs.push(Arc { first: 0, last: other, plugs: [None, Some(plug)] });
            }
            if !self.has_end && let Some((_, other, plug)) = leaves.pop() {
                self.arcs.push(Arc { first: other, last: tour.cells.len() - 1, plugs: [Some(plug), None] });
            }
        }
        let between = leaves.into_iter().zip(comes);
        self.arcs.extend(between.map(|(from, to)| Arc { first: from.1, last: to.1, plugs: [Some(from.2), Some(to.2)] }));
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

    fn side(&self, graph: &Graph, from: u32, to: u32) -> Side {
        let side = graph.neighbours[from as usize].iter().position(|&next| next == to).unwrap_or(0);
        if self.is_swapped { swapped(side) } else { side }
    }

    /// Uses a plug once more.
    fn plug(&mut self, site: usize, side: Side) -> usize {
        if let Beyond::Plug(plug) = self.sites[site].beyond[side] {
            self.plugs[plug].uses += 1;
            return plug;
        }
        self.sites[site].beyond[side] = Beyond::Plug(self.plugs.len());
        self.plugs.push(Plug { site, side, uses: 1, label: 0 });
        self.plugs.len() - 1
    }

    /// Cost of a visit by the sides it uses; the first of the walk has no side before it, the last none after it.
    fn passage_cost(&self, prices: &Prices, site: usize, sides: [Option<Side>; 2]) -> i32 {
        let site = &self.sites[site];
        match sides {
            [Some(a), Some(b)] => prices.step + prices.turn * turns(a, b) as i32 + site.prices[a] + site.prices[b],
            [None, Some(first)] => prices.step / 2 + site.prices[first] + self.first_turn(first),
            [Some(last), None] => prices.step / 2 + site.prices[last],
            [None, None] => 0,
        }
    }

    /// Cost of a way in a site, in price units.
    pub fn cost_of(&self, (step, turn): (i32, i32), site: &Site, way: &Way) -> i32 {
        let sides: i32 = (0..4).map(|side| i32::from(way.used[side]) * site.prices[side]).sum();
        let first = if site.is_start { way.halves.first().map_or(0, |&side| self.first_turn(side)) } else { 0 };
        let half_steps = (2 * way.passages.len() + way.halves.len()) as i32;
        half_steps * step / 2 + i32::from(way.turns) * turn + sides + first
    }

    /// Cost of the turn from the heading to the first step.
    pub fn first_turn(&self, side: Side) -> i32 {
        let (heading, turn) = self.heading;
        turn * turns(heading ^ 2, side) as i32
    }

    /// The walk that does in each site what `ways` say, its parts outside put in; `None` if they don't fit together.
    pub fn walk(&self, tour: &Tour, ways: &[&Way]) -> Option<Vec<u32>> {
        Linker::new(self, tour, ways)?.walk(tour)
    }
}

/// Ends of pieces at the two halves of an edge.
type Ends = [Vec<(usize, usize)>; 2];

/// Pieces of a walk that are linked where they use the same edges.
struct Linker<'a> {
    region: &'a Region,
    /// Cells of the region that are passed, and parts outside.
    pieces: Vec<Piece>,
    /// Per piece and end the piece that it's linked with, and that one's end.
    mates: Vec<[Option<(usize, usize)>; 2]>,
    begin: usize,
}

#[derive(Clone, Copy)]
enum Piece {
    Cell(u32),
    Arc(usize),
}

impl<'a> Linker<'a> {
    fn new(region: &'a Region, tour: &Tour, ways: &[&Way]) -> Option<Self> {
        let sites = region.sites.len();
        let mut edges: Vec<Ends> = vec![Default::default(); 2 * sites + region.plugs.len()];
        let mut pieces = Vec::new();
        let mut begin = None;
        // The site to the left, and the one below in every column.
        let (mut left, mut below) = (0, vec![0; region.columns]);
        for (i, (site, way)) in region.sites.iter().zip(ways).enumerate() {
            let edge_at = |side: Side| match (site.beyond[side], side) {
                (Beyond::Plug(plug), _) => Some((2 * sites + plug, 0)),
                (Beyond::Nothing, _) => None,
                (Beyond::Site, 0 | 1) => Some((2 * i + side, 0)),
                (Beyond::Site, 2) => Some((2 * left, 1)),
                (Beyond::Site, _) => Some((2 * below[site.column] + 1, 1)),
            };
            for &passage in &way.passages {
                for (end, side) in passage.into_iter().enumerate() {
                    let (edge, half) = edge_at(side)?;
                    edges[edge][half].push((pieces.len(), end));
                }
                pieces.push(Piece::Cell(site.cell));
            }
            for (h, &side) in way.halves.iter().enumerate() {
                // The first half of the start's cell is the walk's first step.
                let is_first = site.is_start && h == 0;
                if is_first {
                    begin = Some(pieces.len());
                }
                let (edge, half) = edge_at(side)?;
                edges[edge][half].push((pieces.len(), usize::from(is_first)));
                pieces.push(Piece::Cell(site.cell));
            }
            left = i;
            below[site.column] = i;
        }
        for (i, arc) in region.arcs.iter().enumerate() {
            if arc.plugs[0].is_none() {
                begin = Some(pieces.len());
            }
            for (end, plug) in arc.plugs.into_iter().enumerate().filter_map(|(end, plug)| Some((end, plug?))) {
                edges[2 * sites + plug][1].push((pieces.len(), end));
            }
            pieces.push(Piece::Arc(i));
        }
        let begin = if tour.is_closed { 0 } else { begin? };
        let mut linker = Self { region, mates: vec![[None; 2]; pieces.len()], pieces, begin };
        linker.link(&edges)?;
        Some(linker)
    }

    /// Links pieces at all edges, such that all are one.
    fn link(&mut self, edges: &[Ends]) -> Option<()> {
        let mut parents: Vec<usize> = (0..self.pieces.len()).collect();
        for [ends, others] in edges {
            if ends.len() != others.len() {
                return None;
            }
            for (&a, &b) in ends.iter().zip(others) {
                self.join(a, b);
                unite(&mut parents, a.0, b.0);
            }
        }
        // What uses the same edge can be exchanged there: two loops become one.
        for [ends, others] in edges {
            for i in 1..ends.len() {
                if unite(&mut parents, ends[0].0, ends[i].0) {
                    let (a, b) = (self.mates[ends[0].0][ends[0].1]?, self.mates[ends[i].0][ends[i].1]?);
                    self.join(ends[0], b);
                    self.join(ends[i], a);
                }
            }
            debug_assert_eq!(ends.len(), others.len());
        }
        Some(())
    }

    fn join(&mut self, a: (usize, usize), b: (usize, usize)) {
        self.mates[a.0][a.1] = Some(b);
        self.mates[b.0][b.1] = Some(a);
    }

    /// All pieces in a row.
    fn walk(&self, tour: &Tour) -> Option<Vec<u32>> {
        let mut cells = Vec::with_capacity(tour.cells.len() + 64);
        let mut count = 0;
        let (mut piece, mut entry) = (self.begin, 0);
        loop {
            count += 1;
            match self.pieces[piece] {
                Piece::Cell(cell) => cells.push(cell),
                Piece::Arc(arc) => self.region.arcs[arc].append(tour, entry == 1, &mut cells),
            }
            let Some((next, end)) = self.mates[piece][1 - entry] else { break };
            (piece, entry) = (next, end);
            if piece == self.begin || count > self.pieces.len() {
                break;
            }
        }
        (count == self.pieces.len()).then_some(cells)
    }
}

impl Arc {
    /// Appends its cells.
    fn append(&self, tour: &Tour, is_reversed: bool, cells: &mut Vec<u32>) {
        let begin = cells.len();
        if self.first <= self.last {
            cells.extend_from_slice(&tour.cells[self.first..=self.last]);
        } else {
            cells.extend_from_slice(&tour.cells[self.first..]);
            cells.extend_from_slice(&tour.cells[..=self.last]);
        }
        if is_reversed {
            cells[begin..].reverse();
        }
    }
}

fn root(parents: &mut [usize], mut at: usize) -> usize {
    while parents[at] != at {
        parents[at] = parents[parents[at]];
        at = parents[at];
    }
    at
}

/// Whether the two were apart.
fn unite(parents: &mut [usize], a: usize, b: usize) -> bool {
    let (a, b) = (root(parents, a), root(parents, b));
    parents[a] = b;
    a != b
}
