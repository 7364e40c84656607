//! Ways round obstacles: shortest ways on a lattice of free places, pulled tight.

use super::free_space::FreeSpace;
use robovac_core::{coverage::ReachableFloor, geometry::Point};
use std::{cmp::Reverse, collections::BinaryHeap};

/// Side of a lattice cell, m, and most cells.
const SIDE: f64 = 0.06;
const MOST_CELLS: f64 = 4e6;
/// Places tried in a cell, in each direction.
const TRIES: i32 = 5;
/// No cell.
const NONE: u32 = u32::MAX;

/// A free place in every lattice cell that has one, and the straight links between neighbours.
pub(super) struct Lattice {
    side: f64,
    columns: i32,
    rows: i32,
    places: Vec<Option<Point>>,
    /// Which of the eight neighbours can be reached straight.
    links: Vec<u8>,
    reached: Vec<Reached>,
    search: u32,
}

/// How a cell was reached last.
#[derive(Clone, Copy)]
struct Reached {
    distance: f32,
    /// The cell before.
    before: u32,
    /// Number of the search.
    search: u32,
}

const NEIGHBOURS: [(i32, i32); 8] = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)];

impl Lattice {
    pub fn new(floor: &ReachableFloor, space: &FreeSpace) -> Self {
        let size = space.size();
        let side = (size.x * size.y / MOST_CELLS).sqrt().max(SIDE);
        let (columns, rows) = ((size.x / side).ceil() as i32, (size.y / side).ceil() as i32);
        let mut places = Vec::with_capacity((columns * rows) as usize);
        for row in 0..rows {
            for column in 0..columns {
                places.push(place(floor, space, side, (column, row)));
            }
        }
        let mut lattice = Self {
            side,
            columns,
            rows,
            links: vec![0; places.len()],
            reached: vec![Reached { distance: 0.0, before: NONE, search: 0 }; places.len()],
            search: 0,
            places,
        };
        for cell in 0..lattice.places.len() {
            // Links hold both ways: half of the neighbours are enough.
            for way in 0..4 {
                let Some(other) = lattice.neighbour(cell, way) else { continue };
                if let (Some(a), Some(b)) = (lattice.places[cell], lattice.places[other])
                    && space.is_free(a, b)
                {
                    lattice.links[cell] |= 1 << way;
                    lattice.links[other] |= 1 << (way + 4);
                }
            }
        }
        lattice
    }

    fn neighbour(&self, cell: usize, way: usize) -> Option<usize> {
        let (dx, dy) = NEIGHBOURS[way];
        let (x, y) = (cell as i32 % self.columns + dx, cell as i32 / self.columns + dy);
        ((0..self.columns).contains(&x) && (0..self.rows).contains(&y)).then_some((y * self.columns + x) as usize)
    }

    /// The cell of a point.
    pub fn cell_of(&self, p: Point) -> usize {
        let x = ((p.x / self.side) as i32).clamp(0, self.columns - 1);
        let y = ((p.y / self.side) as i32).clamp(0, self.rows - 1);
        (y * self.columns + x) as usize
    }

    /// Number of cells.
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// The nearest cells whose place can be reached straight from a point: at most nine.
    pub fn ports(&self, space: &FreeSpace, p: Point) -> Vec<usize> {
        let cell = self.cell_of(p);
        let around = std::iter::once(cell).chain((0..8).filter_map(|way| self.neighbour(cell, way)));
        around.filter(|&cell| self.places[cell].is_some_and(|place| space.is_free(p, place))).collect()
    }

    /// Searches from `from` in order of distance until `is_goal` returns something for a cell; it's given the distance.
    pub fn search<T>(
        &mut self,
        space: &FreeSpace,
        from: Point,
        mut is_goal: impl FnMut(usize, f32) -> Option<T>,
    ) -> Option<T> {
        self.search += 1;
        let search = self.search;
        // Where there is a link, there is a neighbour.
        let steps = NEIGHBOURS.map(|(dx, dy)| (dy * self.columns + dx) as isize);
        let mut heap = BinaryHeap::new();
        for port in self.ports(space, from) {
            let Some(place) = self.places[port] else { continue };
            let distance = (place - from).norm() as f32;
            self.reached[port] = Reached { distance, before: NONE, search };
            heap.push((Reverse(distance.to_bits()), port as u32));
        }
        while let Some((Reverse(bits), cell)) = heap.pop() {
            let (cell, distance) = (cell as usize, f32::from_bits(bits));
            if distance > self.reached[cell].distance {
                continue;
            }
            if let Some(found) = is_goal(cell, distance) {
                return Some(found);
            }
            let Some(a) = self.places[cell] else { continue };
            let links = self.links[cell];
            for (way, step) in steps.into_iter().enumerate() {
                if links & (1 << way) == 0 {
                    continue;
                }
                let next = cell.wrapping_add_signed(step);
                let Some(b) = self.places[next] else { continue };
                let farther = distance + (b - a).norm() as f32;
                let known = &mut self.reached[next];
                if known.search != search || farther < known.distance {
                    *known = Reached { distance: farther, before: cell as u32, search };
                    heap.push((Reverse(farther.to_bits()), next as u32));
                }
            }
        }
        None
    }

    /// The way that the last search found to a cell: places, from the start's side on.
    pub fn way_to(&self, cell: usize) -> Vec<Point> {
        let mut way = Vec::new();
        let mut at = cell as u32;
        while at != NONE {
            way.extend(self.places[at as usize]);
            at = self.reached[at as usize].before;
        }
        way.reverse();
        way
    }
}

/// A free place in a cell, near its middle.
fn place(floor: &ReachableFloor, space: &FreeSpace, side: f64, (column, row): (i32, i32)) -> Option<Point> {
    let at = |i: i32, j: i32| {
        let part = |index: i32, k: i32| (f64::from(index) + 0.5 + f64::from(k) / f64::from(TRIES)) * side;
        Point::new(part(column, i), part(row, j))
    };
    let is_good = |p: &Point| floor.floor.is_set(floor.cell_at(*p)) && space.has_room(*p);
    if is_good(&at(0, 0)) {
        return Some(at(0, 0));
    }
    let most = TRIES / 2;
    let all = (-most..=most).flat_map(|i| (-most..=most).map(move |j| (i, j)));
    let good = all.filter(|&(i, j)| is_good(&at(i, j)));
    good.min_by_key(|&(i, j)| i * i + j * j).map(|(i, j)| at(i, j))
}

/// Leaves out corners that needn't be: from each point on, the farthest of the next that can be reached straight.
pub(super) fn pull_tight(space: &FreeSpace, way: &[Point]) -> Vec<Point> {
    let mut tight: Vec<Point> = way.first().copied().into_iter().collect();
    let mut at = 0;
    while at + 1 < way.len() {
        let mut next = at + 1;
        // Doubling, then as far as it goes.
        let mut stride = 1;
        while next + stride < way.len() && space.is_free(way[at], way[next + stride]) {
            next += stride;
            stride *= 2;
        }
        while next + 1 < way.len() && space.is_free(way[at], way[next + 1]) {
            next += 1;
        }
        tight.push(way[next]);
        at = next;
    }
    tight
}
