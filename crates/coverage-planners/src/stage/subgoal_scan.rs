//! Stage: the order in which subgoal points are linked (001, section 4).
//!
//! From a LEFT point to a RIGHT one (case 1) and from a RIGHT one to a LEFT one (case 2): first on its line (steps 1
//! and 2), then, if asked for, on the lines beside it (steps 3 to 5), else to the nearest of all that are left (step
//! 6). Every point is linked once, so the path never closes (step 7).
//!
//! # Where the paper is sloppy
//!
//! - *Step 2* asks whether the nearest point across is TRACKED and goes to step 6 if so and if the way there is
//!   clear: as printed the robot would never take a point across that is UNTRACKED. Read as: if it is UNTRACKED and
//!   the way is clear, link it. Of the points across on a line only the other end of the robot's own run has a clear
//!   way, as between runs there is something.
//! - *Case 2* prints "`LEFT_WALL` and `RIGHT_OBSTACLE`" in place of `RIGHT_WALL` and `RIGHT_OBSTACLE`: `LEFT_OBSTACLE`
//!   is meant.
//! - *Steps 3 to 5* look for a point across one line above, and then on the robot's own line, as step 5 adds what step 3
//!   took off. Read as: one line above, then one line below. Once a line is swept, the robot then crosses the room
//!   slantwise to the far end of the next line, and sweeps everything twice ([`Beside::First`]). By step 2 as printed
//!   (TRACKED) it would go to step 6 once the line is swept, which leads to the near end of the next line as figure 4's
//!   lines ask for ([`Beside::Never`], the default).
//! - *Ties* aren't in the paper: here the lower line comes first, and on a line the left point.

use super::subgoals::Subgoal;
use robovac_core::grid::Cell;

/// Whether steps 3 to 5 come before step 6.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Beside {
    /// As they are meant: the line above, then the one below.
    First,
    /// The nearest point left is taken.
    Never,
}

/// The step of the paper that found a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FoundBy {
    /// Steps 1 and 2: across on its line.
    Across,
    /// Steps 3 to 5: across on the line above or below.
    Beside,
    /// Step 6: the nearest one left.
    Nearest,
}

/// Subgoal points with their tracked flags, indexed by position.
#[derive(Debug)]
pub struct SubgoalScan<'a> {
    subgoals: &'a [Subgoal],
    beside: Beside,
    /// Row of every line.
    rows: Vec<i32>,
    /// Where every line begins in `sorted`.
    starts: Vec<u32>,
    /// Numbers of the points, by line and x.
    sorted: Vec<u32>,
    /// Where every point is in `sorted`.
    places: Vec<u32>,
    /// Places that are left.
    left: Alive,
    /// Lines that have such places.
    lines: Alive,
}

impl<'a> SubgoalScan<'a> {
    /// `subgoals` in the order of [`super::subgoals`], none of them tracked.
    pub fn new(subgoals: &'a [Subgoal], beside: Beside) -> Self {
        let mut sorted: Vec<u32> = (0..subgoals.len() as u32).collect();
        let key = |&number: &u32| {
            let s = &subgoals[number as usize];
            (s.line, s.at.x, !s.contact.is_left())
        };
        sorted.sort_unstable_by_key(key);
        let mut places = vec![0; sorted.len()];
        let (mut rows, mut starts) = (Vec::new(), Vec::new());
        for (&number, place) in sorted.iter().zip(0..) {
            places[number as usize] = place;
            let subgoal = &subgoals[number as usize];
            // A line without points gets a row that keeps the order, and is done from the start.
            while rows.len() <= subgoal.line as usize {
                rows.push(subgoal.at.y);
                starts.push(place);
            }
        }
        starts.push(sorted.len() as u32);
        let (left, lines) = (Alive::new(sorted.len()), Alive::new(rows.len()));
        let mut scan = Self { subgoals, beside, rows, starts, sorted, places, left, lines };
        (0..scan.rows.len()).for_each(|line| scan.close_if_done(line));
        scan
    }

    /// The point to go to from `from` or, at the start, from a cell; `None` once all are tracked. `is_clear` says whether
    /// the straight way from a point to another is free.
    pub fn next(
        &mut self,
        is_clear: &mut impl FnMut(usize, usize) -> bool,
        from: Result<usize, Cell>,
    ) -> Option<(usize, FoundBy)> {
        let at = from.map_or_else(|cell| cell, |number| self.subgoals[number].at);
        if let Ok(number) = from {
            if let Some(across) = self.across(number) {
                return Some((across, FoundBy::Across));
            }
            if self.beside == Beside::First
                && let Some(beside) = self.beside(is_clear, number)
            {
                return Some((beside, FoundBy::Beside));
            }
        }
        self.nearest(at).map(|number| (number, FoundBy::Nearest))
    }

    /// Links all points that are left. `go` receives the starting point, as [`SubgoalScan::next`] takes it, the next
    /// point, and the step that found it. Returns the last point.
    pub fn link_all<E>(
        &mut self,
        mut is_clear: impl FnMut(usize, usize) -> bool,
        mut from: Result<usize, Cell>,
        mut go: impl FnMut(Result<usize, Cell>, usize, FoundBy) -> Result<(), E>,
    ) -> Result<Option<usize>, E> {
        while let Some((to, found)) = self.next(&mut is_clear, from) {
            self.track(to);
            go(from, to, found)?;
            from = Ok(to);
        }
        Ok(from.ok())
    }

    /// Sets a point's tracked flag.
    pub fn track(&mut self, number: usize) {
        self.left.remove(self.places[number] as usize);
        self.close_if_done(self.subgoals[number].line as usize);
    }

    fn close_if_done(&mut self, line: usize) {
        let (begin, end) = (self.starts[line] as usize, self.starts[line + 1] as usize);
        if self.left.at_or_after(begin).is_none_or(|place| place >= end) {
            self.lines.remove(line);
        }
    }

    /// Steps 1 and 2: the other end of the run, if it isn't tracked.
    fn across(&mut self, number: usize) -> Option<usize> {
        let place = self.places[number] as usize;
        let other = if self.subgoals[number].contact.is_left() { place + 1 } else { place.checked_sub(1)? };
        self.left.has(other).then(|| self.sorted[other] as usize)
    }

    /// Steps 3 to 5: the nearest point of the other side on the line above, or else below, with a clear way.
    fn beside(&mut self, is_clear: &mut impl FnMut(usize, usize) -> bool, number: usize) -> Option<usize> {
        let Subgoal { at: cell, contact, line, .. } = self.subgoals[number];
        let lines = [line.checked_sub(1), Some(line + 1).filter(|&next| (next as usize) < self.rows.len())];
        lines.into_iter().flatten().find_map(|line| {
            let (begin, end) = (self.starts[line as usize] as usize, self.starts[line as usize + 1] as usize);
            let points = self.sorted[begin..end].iter().zip(begin..).map(|(&number, place)| (number as usize, place));
            let across = points.filter(|&(number, place)| {
                self.left.has(place) && self.subgoals[number].contact.is_left() != contact.is_left()
            });
            let nearest = across.min_by_key(|&(number, _)| self.subgoals[number].at.x.abs_diff(cell.x))?.0;
            is_clear(number, nearest).then_some(nearest)
        })
    }

    /// Step 6: the nearest point left, as the crow flies.
    fn nearest(&mut self, at: Cell) -> Option<usize> {
        // Rows fall from line to line.
        let middle = self.rows.partition_point(|&row| row > at.y);
        let mut below = self.lines.at_or_after(middle);
        let mut above = middle.checked_sub(1).and_then(|line| self.lines.at_or_before(line));
        let mut best: (i64, Option<usize>) = (i64::MAX, None);
        let off = |row: i32| i64::from(row) - i64::from(at.y);
        loop {
            let distance = |line: Option<usize>| line.map_or(i64::MAX, |line| off(self.rows[line]).pow(2));
            let is_below = distance(below) <= distance(above);
            let Some(line) = (if is_below { below } else { above }) else { break };
            let away = off(self.rows[line]).pow(2);
            if away >= best.0 {
                break;
            }
            let (begin, end) = (self.starts[line] as usize, self.starts[line + 1] as usize);
            let cell_of = |place: usize| self.subgoals[self.sorted[place] as usize].at;
            let split = begin + self.sorted[begin..end].partition_point(|&n| self.subgoals[n as usize].at.x < at.x);
            let before = split.checked_sub(1).and_then(|place| self.left.at_or_before(place)).filter(|&p| p >= begin);
            let after = self.left.at_or_after(split).filter(|&place| place < end);
            for place in [before, after].into_iter().flatten() {
                let distance = away + (i64::from(cell_of(place).x) - i64::from(at.x)).pow(2);
                if distance < best.0 {
                    best = (distance, Some(self.sorted[place] as usize));
                }
            }
            if is_below {
                below = self.lines.at_or_after(line + 1);
            } else {
                above = line.checked_sub(1).and_then(|line| self.lines.at_or_before(line));
            }
        }
        best.1
    }
}

/// Numbers from 0 on, of which some are removed, with fast access to the next remaining one: disjoint sets in both
/// directions.
#[derive(Debug)]
struct Alive {
    /// A number at or after each, the number itself if it remains; the count for none.
    after: Vec<u32>,
    /// 1 + a number at or before each number less 1; 0 for none.
    before: Vec<u32>,
}

impl Alive {
    fn new(count: usize) -> Self {
        let all: Vec<u32> = (0..=count as u32).collect();
        Self { after: all.clone(), before: all }
    }

    fn has(&self, number: usize) -> bool {
        number + 1 < self.after.len() && self.after[number] as usize == number
    }

    fn remove(&mut self, number: usize) {
        self.after[number] = number as u32 + 1;
        self.before[number + 1] = number as u32;
    }

    fn at_or_after(&mut self, number: usize) -> Option<usize> {
        let found = follow(&mut self.after, number);
        (found + 1 < self.after.len()).then_some(found)
    }

    fn at_or_before(&mut self, number: usize) -> Option<usize> {
        follow(&mut self.before, number + 1).checked_sub(1)
    }
}

/// The end of a chain, shortened on the way (path halving).
fn follow(next: &mut [u32], mut number: usize) -> usize {
    while next[number] as usize != number {
        next[number] = next[next[number] as usize];
        number = next[number] as usize;
    }
    number
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stage::{LineEndContact, is_straight_free, scan_rows, subgoals};
    use robovac_core::{
        cspace::ObstacleRuns,
        grid::{Grid, from_picture},
    };

    fn order(picture: &str, beside: Beside) -> (Vec<Subgoal>, Vec<(usize, FoundBy)>) {
        let free = from_picture(picture, |c| c == '.').unwrap();
        let found = subgoals(&free, &scan_rows(&free, 1.0), &ObstacleRuns::of(&free), |_| true);
        let mut scan = SubgoalScan::new(&found, beside);
        scan.track(0);
        let mut links = vec![(0, FoundBy::Nearest)];
        let link = |_, next, by| {
            links.push((next, by));
            Ok::<(), ()>(())
        };
        let is_clear = |from: usize, to: usize| is_straight_free(&free, found[from].at, found[to].at);
        scan.link_all(is_clear, Ok(0), link).unwrap().unwrap();
        (found, links)
    }

    const ISLAND: &str = "
        .......
        ..###..
        ..###..
        .......";

    /// 001, section 4: from LEFT to RIGHT and from RIGHT to LEFT in turn along a line, to the nearest at its end;
    /// begins with the first entry.
    #[test]
    fn lines_are_swept_to_and_fro() {
        use FoundBy::{Across, Nearest};
        let (points, links) = order("....\n....\n....", Beside::Never);
        let cells: Vec<_> = links.iter().map(|&(n, _)| (points[n].at.x, points[n].at.y)).collect();
        assert_eq!(cells, [(0, 2), (3, 2), (3, 1), (0, 1), (0, 0), (3, 0)]);
        assert_eq!(points[0].contact, LineEndContact::LeftWall);
        assert!(links.iter().map(|l| l.1).eq([Nearest, Across, Nearest, Across, Nearest, Across]));
    }

    /// Steps 3 to 5 as meant: to the far end of the next line.
    #[test]
    fn printed_steps_cross_the_room_slantwise() {
        let (points, links) = order("....\n....\n....", Beside::First);
        let cells: Vec<_> = links.iter().map(|&(n, _)| (points[n].at.x, points[n].at.y)).collect();
        assert_eq!(cells, [(0, 2), (3, 2), (0, 1), (3, 1), (0, 0), (3, 0)]);
        assert_eq!(links[2].1, FoundBy::Beside);
    }

    /// Section 4: "a Subgoal point should not be linked more than once and the linked path is never closed".
    #[test]
    fn every_point_is_linked_once_and_every_run_is_swept() {
        for beside in [Beside::Never, Beside::First] {
            let (points, links) = order(ISLAND, beside);
            let mut numbers: Vec<usize> = links.iter().map(|l| l.0).collect();
            let swept = links.windows(2).filter(|l| l[1].1 == FoundBy::Across).count();
            assert_eq!(swept, points.len() / 2);
            numbers.sort_unstable();
            assert!(numbers.into_iter().eq(0..points.len()));
        }
    }

    #[test]
    fn nearest_is_that_of_all() {
        use rand::RngExt;
        let mut rng = robovac_core::rng::seeded(6, 99);
        for _ in 0..30 {
            let mut free = Grid::filled(40, 25, true);
            free.values_mut().iter_mut().for_each(|f| *f = rng.random_bool(0.8));
            let found = subgoals(&free, &scan_rows(&free, 2.0), &ObstacleRuns::of(&free), |_| true);
            let mut scan = SubgoalScan::new(&found, Beside::Never);
            let mut is_left = vec![true; found.len()];
            for _ in 0..found.len() {
                let at = Cell::new(rng.random_range(-3..43), rng.random_range(-3..28));
                let square = |s: &Subgoal| (s.at.x - at.x).pow(2) + (s.at.y - at.y).pow(2);
                let (got, _) = scan.next(&mut |_, _| true, Err(at)).unwrap();
                let left = found.iter().zip(&is_left).filter(|(_, left)| **left);
                assert_eq!(left.map(|(s, _)| square(s)).min(), Some(square(&found[got])));
                assert!(is_left[got]);
                let gone = loop {
                    let number = rng.random_range(0..found.len());
                    if is_left[number] {
                        break number;
                    }
                };
                is_left[gone] = false;
                scan.track(gone);
            }
            assert_eq!(scan.next(&mut |_, _| true, Err(Cell::new(0, 0))), None);
        }
    }
}
