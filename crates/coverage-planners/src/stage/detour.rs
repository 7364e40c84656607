//! Stage: a detour around obstacles on a straight link (001, section 5).
//!
//! The paper refers to the procedure of Hyun & Suh (A heuristic collision-free path planning algorithm for robots, IROS
//! 1995) without printing it. Figure 6 shows its purpose: a short way with few corners, round the obstacle and on to
//! the intended point. Here A* (Hart, Nilsson & Raphael 1968) over the eight neighbours of a cell, no corner cut, finds
//! a shortest way on the grid and is complete; then the way is pulled taut, corner by corner, as far as the straight
//! line stays in FREE cells. The result is within a few percent of the shortest.

use super::{frame::FramedGrid, is_straight_free};
use robovac_core::grid::{Cell, Direction, Grid};

/// Costs of a step straight and diagonally: 99/70 is the square root of 2 to within 0.00007.
const STRAIGHT: u32 = 70;
const SLANTED: u32 = 99;
/// Buckets of the queue: more than the estimate for a whole way can grow by in one step, a power of two.
const BUCKETS: usize = 256;
/// Corners considered ahead while a way is pulled taut.
const LOOK_AHEAD: usize = 64;
/// Bits of a cell: there is no step to the right, none up, none diagonally within the square above and to the right.
const SHUT_RIGHT: u8 = 1;
const SHUT_UP: u8 = 2;
const SHUT_SQUARE: u8 = 4;

/// What a body can do between free cells.
pub trait Steps {
    /// Whether it can step from a free cell to a free neighbour.
    fn is_open(&self, cell: Cell, to: Direction) -> bool;
    /// Whether it can step diagonally between the four free cells of which `cell` is the lower left one.
    fn is_square_free(&self, cell: Cell) -> bool;
}

impl Steps for robovac_core::cspace::FreeSteps {
    fn is_open(&self, cell: Cell, to: Direction) -> bool {
        Self::is_open(self, cell, to)
    }

    fn is_square_free(&self, cell: Cell) -> bool {
        Self::is_square_free(self, cell)
    }
}

/// Searches for detours. It reuses its memory, so that a search takes time in proportion to the cells it visits.
#[derive(Debug)]
pub struct Detours<'a> {
    free: &'a Grid<bool>,
    frame: FramedGrid,
    /// `base` + cost of the way to a cell; lower values are left from searches before, and [`WALL`] is above all.
    reached: Vec<u32>,
    /// Steps that aren't possible.
    shut: Vec<u8>,
    base: u32,
    /// The cost of the last search's dearest way.
    dearest: u32,
    queue: Queue,
}

const WALL: u32 = u32::MAX;

impl<'a> Detours<'a> {
    /// Searches through `free` cells, with steps between all neighbours.
    pub fn new(free: &'a Grid<bool>) -> Self {
        let frame = FramedGrid::around(free);
        let (reached, shut) = (frame.drawn(free, 0, WALL), frame.filled(0));
        Self { free, frame, reached, shut, base: 1, dearest: 0, queue: Queue::default() }
    }

    /// Searches through `free` cells, by these steps only.
    pub fn along(free: &'a Grid<bool>, steps: &impl Steps) -> Self {
        let mut detours = Self::new(free);
        for (cell, _) in free.iter().filter(|&(_, &is_free)| is_free) {
            let shut = |is_open: bool, bit: u8| if is_open { 0 } else { bit };
            detours.shut[detours.frame.index(cell)] = shut(steps.is_open(cell, Direction::Right), SHUT_RIGHT)
                | shut(steps.is_open(cell, Direction::Up), SHUT_UP)
                | shut(steps.is_square_free(cell), SHUT_SQUARE);
        }
        detours
    }

    /// Corners of a short way, ends included, whose straight pieces stay in free cells; `None` if there is no way.
    pub fn find(&mut self, from: Cell, to: Cell) -> Option<Vec<Cell>> {
        let free = self.free;
        self.find_taut(from, to, |from, to| is_straight_free(free, from, to))
    }

    /// Corners of a short way, ends included, of single steps and of straight pieces that `is_clear` says are free;
    /// `None` if there is no way.
    pub fn find_taut(&mut self, from: Cell, to: Cell, is_clear: impl FnMut(Cell, Cell) -> bool) -> Option<Vec<Cell>> {
        if !self.free.is_set(from) || !self.free.is_set(to) {
            return None;
        }
        self.make_old();
        let goal = self.frame.index(to);
        self.reach(self.frame.index(from), from, 0, to);
        while let Some((index, cost)) = self.queue.pop() {
            if index == goal {
                let way = self.trace_back(index);
                return Some(pulled(&way, is_clear));
            }
            if self.reached[index] < self.base + cost {
                continue;
            }
            self.reach_neighbours(index, cost, to);
        }
        None
    }

    /// The order is that of [`Self::steps`].
    #[inline]
    fn reach_neighbours(&mut self, index: usize, cost: u32, to: Cell) {
        let [right, up, left, down] = self.frame.neighbours(index);
        let Cell { x, y } = self.frame.cell(index);
        let (straight, slanted) = (cost + STRAIGHT, cost + SLANTED);
        let [open_right, open_up, open_left, open_down] = self.open(index);
        let is_right = open_right && self.reach(right, Cell::new(x + 1, y), straight, to);
        let is_up = open_up && self.reach(up, Cell::new(x, y + 1), straight, to);
        let is_left = open_left && self.reach(left, Cell::new(x - 1, y), straight, to);
        let is_down = open_down && self.reach(down, Cell::new(x, y - 1), straight, to);
        if is_right && is_up && self.is_square(index) {
            self.reach(up + 1, Cell::new(x + 1, y + 1), slanted, to);
        }
        if is_up && is_left && self.is_square(left) {
            self.reach(up - 1, Cell::new(x - 1, y + 1), slanted, to);
        }
        if is_left && is_down && self.is_square(down - 1) {
            self.reach(down - 1, Cell::new(x - 1, y - 1), slanted, to);
        }
        if is_down && is_right && self.is_square(down) {
            self.reach(down + 1, Cell::new(x + 1, y - 1), slanted, to);
        }
    }

    /// Free neighbours with the cost of a step there, and their number; diagonally only past two free cells.
    #[inline]
    fn steps(&self, index: usize) -> ([(usize, u32); 8], usize) {
        let [right, up, left, down] = self.frame.neighbours(index);
        let (mut steps, mut count) = ([(0, 0); 8], 0);
        let mut look = |next: usize, is_open: bool, step: u32| {
            let is_open = is_open && self.reached[next] != WALL;
            if is_open {
                steps[count] = (next, step);
                count += 1;
            }
            is_open
        };
        let [open_right, open_up, open_left, open_down] = self.open(index);
        let (is_right, is_up) = (look(right, open_right, STRAIGHT), look(up, open_up, STRAIGHT));
        let (is_left, is_down) = (look(left, open_left, STRAIGHT), look(down, open_down, STRAIGHT));
        look(up + 1, is_right && is_up && self.is_square(index), SLANTED);
        look(up - 1, is_up && is_left && self.is_square(left), SLANTED);
        look(down - 1, is_left && is_down && self.is_square(down - 1), SLANTED);
        look(down + 1, is_down && is_right && self.is_square(down), SLANTED);
        (steps, count)
    }

    /// Which steps from a cell aren't shut, in the order of [`Direction::ALL`].
    #[inline]
    fn open(&self, index: usize) -> [bool; 4] {
        let [_, _, left, down] = self.frame.neighbours(index);
        let here = self.shut[index];
        [here & SHUT_RIGHT == 0, here & SHUT_UP == 0, self.shut[left] & SHUT_RIGHT == 0, self.shut[down] & SHUT_UP == 0]
    }

    /// Whether one can step diagonally within the square above and to the right of a cell.
    #[inline]
    fn is_square(&self, index: usize) -> bool {
        self.shut[index] & SHUT_SQUARE == 0
    }

    /// Records a way of that cost to a cell; returns whether the cell is free.
    #[inline]
    fn reach(&mut self, index: usize, cell: Cell, cost: u32, to: Cell) -> bool {
        let mark = self.reached[index];
        if mark >= self.base && mark <= self.base + cost {
            return true;
        }
        if mark == WALL {
            return false;
        }
        self.reached[index] = self.base + cost;
        self.dearest = self.dearest.max(cost);
        let (dx, dy) = (cell.x.abs_diff(to.x), cell.y.abs_diff(to.y));
        let remaining = STRAIGHT * dx.abs_diff(dy) + SLANTED * dx.min(dy);
        self.queue.push(cost + remaining, index, cost);
        true
    }

    /// Marks all cells as those of an earlier search.
    fn make_old(&mut self) {
        self.queue.clear();
        self.base += self.dearest + 1;
        self.dearest = 0;
        if self.base > WALL / 2 {
            self.reached.iter_mut().filter(|mark| **mark < WALL).for_each(|mark| *mark = 0);
            self.base = 1;
        }
    }

    /// The cells of the way, from its start.
    fn trace_back(&self, goal: usize) -> Vec<Cell> {
        let mut way = vec![self.frame.cell(goal)];
        let mut index = goal;
        while self.reached[index] > self.base {
            let here = self.reached[index];
            let (steps, count) = self.steps(index);
            let is_before =
                |&&(next, step): &&(usize, u32)| self.reached[next] >= self.base && self.reached[next] + step == here;
            let Some(&(next, _)) = steps[..count].iter().find(is_before) else { break };
            index = next;
            way.push(self.frame.cell(index));
        }
        way.reverse();
        way
    }
}

/// Queue of cells, those with the lowest estimate for the whole way first, of these the latest, as it is nearer to the
/// goal. Estimates never fall, nor grow by more than the number of buckets, so there is a bucket for each (Dial 1969).
#[derive(Debug)]
struct Queue {
    /// Numbers of cells and the costs of the ways there.
    buckets: Vec<Vec<(u32, u32)>>,
    /// The lowest estimate.
    lowest: u32,
    count: usize,
}

impl Default for Queue {
    fn default() -> Self {
        Self { buckets: vec![Vec::new(); BUCKETS], lowest: u32::MAX, count: 0 }
    }
}

impl Queue {
    fn clear(&mut self) {
        self.buckets.iter_mut().for_each(Vec::clear);
        (self.lowest, self.count) = (u32::MAX, 0);
    }

    #[inline]
    fn push(&mut self, estimate: u32, index: usize, cost: u32) {
        // The first is the lowest of all.
        self.lowest = self.lowest.min(estimate);
        self.buckets[estimate as usize % BUCKETS].push((index as u32, cost));
        self.count += 1;
    }

    #[inline]
    fn pop(&mut self) -> Option<(usize, u32)> {
        if self.count == 0 {
            return None;
        }
        loop {
            if let Some((index, cost)) = self.buckets[self.lowest as usize % BUCKETS].pop() {
                self.count -= 1;
                return Some((index as usize, cost));
            }
            self.lowest += 1;
        }
    }
}

/// The corners that a way keeps when it is pulled taut, from its start and then from its end.
fn pulled(way: &[Cell], mut is_clear: impl FnMut(Cell, Cell) -> bool) -> Vec<Cell> {
    let turn = |w: &[Cell]| (w[1].x - w[0].x, w[1].y - w[0].y) != (w[2].x - w[1].x, w[2].y - w[1].y);
    let (Some(&first), Some(&last)) = (way.first(), way.last()) else { return Vec::new() };
    let mut corners = vec![first];
    corners.extend(way.windows(3).filter(|w| turn(w)).map(|w| w[1]));
    corners.push(last);
    for _ in 0..2 {
        let mut kept = vec![corners[0]];
        let mut at = 0;
        while at + 1 < corners.len() {
            let farthest = (at + LOOK_AHEAD).min(corners.len() - 1);
            let seen = (at + 2..=farthest).rev().find(|&next| is_clear(corners[at], corners[next]));
            at = seen.unwrap_or(at + 1);
            kept.push(corners[at]);
        }
        kept.reverse();
        corners = kept;
    }
    corners
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{
        floor_plan::generate::random_clutter,
        grid::{from_picture, reachable},
    };

    fn length(way: &[Cell]) -> f64 {
        way.windows(2).map(|w| f64::from((w[1].x - w[0].x).pow(2) + (w[1].y - w[0].y).pow(2)).sqrt()).sum()
    }

    /// 001, Fig. 6: round the obstacle with few corners.
    #[test]
    fn detour_goes_round_with_few_corners() {
        let free = from_picture(
            "
            ............
            .....##.....
            .....##.....
            .....##.....
            ............
            ............",
            |c| c == '.',
        )
        .unwrap();
        let way = Detours::new(&free).find(Cell::new(1, 3), Cell::new(10, 3)).unwrap();
        assert!(way.windows(2).all(|w| is_straight_free(&free, w[0], w[1])), "{way:?}");
        assert!(way.len() <= 4 && length(&way) < 10.5, "{way:?}");
    }

    /// Two cells are connected by a detour if they are by steps, also after many searches.
    #[test]
    fn detours_are_found_where_there_are_ways() {
        let free = random_clutter(40, 30, 0.35, 5);
        let mut detours = Detours::new(&free);
        let cells: Vec<Cell> = free.iter().map(|(cell, _)| cell).collect();
        for (i, &from) in cells.iter().enumerate().step_by(37) {
            let to = cells[(i * 7 + 400) % cells.len()];
            let expected = free.is_set(from) && reachable(&free, from).is_set(to);
            let way = detours.find(from, to);
            assert_eq!(way.is_some(), expected, "{from} {to}");
            let Some(way) = way else { continue };
            assert_eq!((way[0], way[way.len() - 1]), (from, to));
            assert!(way.windows(2).all(|w| is_straight_free(&free, w[0], w[1])));
        }
    }

    #[test]
    fn straight_where_nothing_is_in_the_way() {
        let free = Grid::filled(30, 20, true);
        let way = Detours::new(&free).find(Cell::new(2, 3), Cell::new(27, 11)).unwrap();
        assert_eq!(way, [Cell::new(2, 3), Cell::new(27, 11)]);
        let way = Detours::new(&free).find(Cell::new(2, 3), Cell::new(2, 3)).unwrap();
        assert_eq!(length(&way), 0.0);
    }
}
