//! Joins passages in a region and the walk's parts outside into one walk.

use super::{
    region::{Beyond, OutsideStretch, WalkRegion},
    tour::Tour,
    ways::{CellSide, CellWay},
};

impl WalkRegion {
    /// The walk that uses `ways` in the sites, with its parts outside inserted; `None` if they don't fit together.
    pub fn walk(&self, tour: &Tour, ways: &[&CellWay]) -> Option<Vec<u32>> {
        PieceLinker::new(self, tour, ways)?.walk(tour)
    }
}

/// Ends of pieces at the two halves of an edge.
type PieceEnds = [Vec<(usize, usize)>; 2];

/// Pieces of a walk that are linked where they use the same edges.
struct PieceLinker<'a> {
    region: &'a WalkRegion,
    /// Cells of the region that are passed, and parts outside.
    pieces: Vec<WalkPiece>,
    /// Per piece and end, the piece and end linked with it.
    mates: Vec<[Option<(usize, usize)>; 2]>,
    begin: usize,
}

#[derive(Clone, Copy)]
enum WalkPiece {
    Cell(u32),
    Arc(usize),
}

impl<'a> PieceLinker<'a> {
    fn new(region: &'a WalkRegion, tour: &Tour, ways: &[&CellWay]) -> Option<Self> {
        let sites = region.sites.len();
        let mut edges: Vec<PieceEnds> = vec![Default::default(); 2 * sites + region.plugs.len()];
        let mut pieces = Vec::new();
        let mut begin = None;
        // The site to the left, and the one below in every column.
        let (mut left, mut below) = (0, vec![0; region.columns]);
        for (i, (site, way)) in region.sites.iter().zip(ways).enumerate() {
            let edge_at = |side: CellSide| match (site.beyond[side], side) {
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
                pieces.push(WalkPiece::Cell(site.cell));
            }
            for (h, &side) in way.halves.iter().enumerate() {
                // The first half of the start's cell is the walk's first step.
                let is_first = site.is_start && h == 0;
                if is_first {
                    begin = Some(pieces.len());
                }
                let (edge, half) = edge_at(side)?;
                edges[edge][half].push((pieces.len(), usize::from(is_first)));
                pieces.push(WalkPiece::Cell(site.cell));
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
            pieces.push(WalkPiece::Arc(i));
        }
        let begin = if tour.is_closed { 0 } else { begin? };
        let mut linker = Self { region, mates: vec![[None; 2]; pieces.len()], pieces, begin };
        linker.link(&edges)?;
        Some(linker)
    }

    /// Links pieces at all edges, such that all are one.
    fn link(&mut self, edges: &[PieceEnds]) -> Option<()> {
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
        // Pieces that use the same edge can be exchanged there, which joins two loops.
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

    /// All pieces as one walk.
    fn walk(&self, tour: &Tour) -> Option<Vec<u32>> {
        let mut cells = Vec::with_capacity(tour.cells.len() + 64);
        let mut count = 0;
        let (mut piece, mut entry) = (self.begin, 0);
        loop {
            count += 1;
            match self.pieces[piece] {
                WalkPiece::Cell(cell) => cells.push(cell),
                WalkPiece::Arc(arc) => self.region.arcs[arc].append(tour, entry == 1, &mut cells),
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

impl OutsideStretch {
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

/// Unites two sets; returns whether they were separate.
fn unite(parents: &mut [usize], a: usize, b: usize) -> bool {
    let (a, b) = (root(parents, a), root(parents, b));
    parents[a] = b;
    a != b
}
