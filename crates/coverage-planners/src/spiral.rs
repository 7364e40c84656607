//! Growing spirals: outwards from the middle of free space, then on to the next free area.
//!
//! Emu & Obaida 2020 (thesis, East West University), section 4.1: the robot "checks if there is enough place to start
//! moving spirally"; if so it turns to the left again and again, its distance from the centre growing, until it senses an
//! obstacle, and there the algorithm ends. On a grid that is one step ahead, turn, one step, turn, two steps, turn, two,
//! turn, three, and so on. One such spiral leaves most of a room as it was; the thesis' own example (Table 2: 51 cells
//! of about 226 revisited, 100 turns) must have gone on, but doesn't say how. What is said below is ours.
//!
//! - *Enough place* is a square of cells that are left, *enough room* wide on every side of a cell.
//! - *Clean floor* isn't an obstacle. A spiral that was stopped by it would end at the way that the robot came by. It does end
//!   where one side of it, longer than a step, has nothing left to be cleaned.
//! - *The next place* is searched for among the [`REACH`] cells nearest to the robot: the one with most space around it
//!   (which makes the largest spirals), the nearest among equals; or simply the nearest with enough. The robot takes a
//!   shortest way there.
//! - *Corners and strips* without such a place are cleaned by turning to the same side where the cell there is left, else
//!   going straight on, else to the other side: along the wall, and inwards along what has been cleaned. Where this ends the
//!   robot looks for room again, and if there is none, takes a shortest way to the nearest cell left. So every walk
//!   covers all.
//!
//! The room around each cell is computed once by a distance transform and updated only where it matters, as it can only
//! shrink. O(n) steps; each search costs up to [`REACH`] cells and the squares around them.
//!
//! ```
//! use robovac_core::grid::*;
//! use coverage_planners::*;
//! let free = Grid::filled(5, 5, true);
//! let job = CoverageJob::new(&free, Cell::new(2, 2), Direction::Right).unwrap();
//! let info = find("spiral").unwrap();
//! let params = Params::checked(info.params, [("room", ParamValue::Number(2.0))]).unwrap();
//! let path = info.build(&params).plan(&job, &mut PlanContext::new(0)).unwrap();
//! assert_eq!(path.arrows(&job), "v<<<<\nvv<<^\nvv>^^\nv>>>^\n>>>>o\n");
//! ```

use super::{
    BuildPlanner, CoverageJob, CoveragePath, PlanContext, PlanError, Planner, PlannerClaims, PlannerInfo, Search,
    stage::{CoverageProgress, Flood, Straight},
};
use robovac_core::{
    grid::{Cell, Direction, Grid},
    registry::{Example, Explainer, ParamKind, ParamSpec},
};
use std::ops::ControlFlow;

/// Entry in the registry.
pub const INFO: PlannerInfo = PlannerInfo {
    id: "spiral",
    title: "Growing spirals",
    summary: "Spirals outwards in free space until it reaches an obstacle, then goes to the next free area.",
    claims: PlannerClaims { complete: true, deterministic: true, fast: true, in_metres: None, search: Search::None },
    params: &[
        ParamSpec {
            id: "room",
            label: "Free space",
            help: "Uncleaned cells required on every side to start a spiral.",
            kind: ParamKind::Number { min: 1.0, max: 20.0, step: 1.0, default: 3.0, unit: "cells" },
        },
        ParamSpec {
            id: "next",
            label: "Next start",
            help: "Where the next spiral starts: at the most free space nearby, or at the nearest cell with enough.",
            kind: ParamKind::Choice { options: &[("roomiest", "most space"), ("nearest", "nearest")] },
        },
        ParamSpec {
            id: "turn",
            label: "Turn direction",
            help: "Direction in which spirals turn; left in the thesis.",
            kind: ParamKind::Choice { options: &[("left", "left"), ("right", "right")] },
        },
    ],
};

/// Its explanation.
pub const EXPLAINER: Explainer = Explainer {
    idea: "In the middle of free floor the robot spirals outwards until it reaches an obstacle. It then goes to \
           the nearby cell with the most free space and spirals there. Corners and narrow strips are cleaned along \
           their edges.",
    complexity: "O(n) steps and memory for n cells; each search for free space visits up to 400 cells.",
    use_when: "For a dirty spot in the middle of open floor, which is cleaned first. Spirals don't fill rectangles, so \
               the robot must return for the strips between them.",
    shines: Example {
        room: "maze",
        why: "Too narrow to spiral: it follows the walls, which suits a maze better than lanes.",
    },
    fails: Example {
        room: "slanted",
        why: "Spirals are square here: slanted walls stop them early and leave patches to return to.",
    },
    source: "Emu & Obaida 2020, thesis, East West University: section 4.1",
    link: "",
};

/// Makes the planner.
pub(super) const BUILD: BuildPlanner = |params| {
    Box::new(SpiralPlanner {
        turns_right: params.choice("turn") == "right",
        takes_nearest: params.choice("next") == "nearest",
        least_room: params.number("room") as i32,
    })
};

/// The planner.
struct SpiralPlanner {
    turns_right: bool,
    /// Whether the nearest place with enough room is taken rather than the one with most.
    takes_nearest: bool,
    /// Cells on every side of a place where a spiral may start.
    least_room: i32,
}

/// Cells around the robot that are searched for room.
const REACH: usize = 400;

impl Planner for SpiralPlanner {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        let mut progress = CoverageProgress::new(job);
        let mut flood = Flood::new(&job.free);
        // An upper limit: the free room only shrinks.
        let mut room = room_in(&job.free);
        let has_room = room[job.start] >= self.least_room;
        let mut place = if has_room { Some(job.start) } else { self.next_place(&progress, &mut flood, &mut room) };
        while !progress.is_done() {
            progress.report(ctx)?;
            if let Some(place) = place {
                progress.go_to(place);
                self.circle(&job.free, &mut progress, ctx)?;
            } else {
                progress.go_to_nearest_left();
                while let Some(towards) = self.along(progress.facing).into_iter().find(|&d| progress.is_left(d)) {
                    progress.step(towards);
                    progress.report(ctx)?;
                }
            }
            place = self.next_place(&progress, &mut flood, &mut room);
        }
        progress.tell(ctx, &mut Straight { on: "The circle goes on", turn: "The circle turns" });
        Ok(progress.into_path())
    }
}

impl SpiralPlanner {
    /// The direction after a turn.
    fn turned(&self, facing: Direction) -> Direction {
        if self.turns_right { facing.right() } else { facing.left() }
    }

    /// Directions to continue in where there is no room, best first.
    fn along(&self, facing: Direction) -> [Direction; 3] {
        let inwards = self.turned(facing);
        [inwards, facing, inwards.opposite()]
    }

    /// Circles outwards until an obstacle is in the way or a side cleans nothing new.
    fn circle(
        &self,
        free: &Grid<bool>,
        progress: &mut CoverageProgress<'_>,
        ctx: &mut PlanContext<'_>,
    ) -> Result<(), PlanError> {
        let mut facing = progress.facing;
        for side in 2.. {
            let length = side / 2;
            let mut is_new = length == 1;
            for _ in 0..length {
                if !free.is_set(progress.at.step(facing)) {
                    return Ok(());
                }
                is_new |= progress.is_left(facing);
                progress.step(facing);
            }
            if !is_new {
                return Ok(());
            }
            progress.report(ctx)?;
            facing = self.turned(facing);
        }
        Ok(())
    }

    /// Where the next spiral starts; `None` if there is no place with enough room nearby. Updates `room` where it looks.
    fn next_place(&self, progress: &CoverageProgress<'_>, flood: &mut Flood, room: &mut Grid<i32>) -> Option<Cell> {
        let frame = flood.frame();
        let left = progress.left();
        let (mut best, mut wanted, mut looked_at) = (None, self.least_room, 0);
        flood.search(progress.at, |index, _| {
            looked_at += 1;
            let cell = frame.cell(index);
            if left[cell] && room[cell] >= wanted {
                room[cell] = room_around(left, cell, wanted, room[cell]);
                if room[cell] >= wanted {
                    (best, wanted) = (Some(cell), room[cell] + 1);
                }
            }
            let is_enough = looked_at == REACH || (self.takes_nearest && best.is_some());
            if is_enough { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        best
    }
}

/// Cells on every side of `centre` that are left, at most `most`. If fewer than `wanted`, the result lies between the
/// true value and `wanted`, which is found sooner.
fn room_around(left: &Grid<bool>, centre: Cell, wanted: i32, most: i32) -> i32 {
    let is_broken = |radius: &i32| !ring(centre, *radius).all(|cell| left.is_set(cell));
    // Large squares are broken most often.
    let broken = (1..=wanted).rev().find(is_broken).or_else(|| (wanted + 1..=most).find(is_broken));
    broken.map_or(most, |radius| radius - 1)
}

/// The cells on the edge of the square around `centre`.
fn ring(centre: Cell, radius: i32) -> impl Iterator<Item = Cell> {
    (-radius..radius).flat_map(move |i| {
        [(i, -radius), (radius, i), (-i, radius), (-radius, -i)].map(|(x, y)| Cell::new(centre.x + x, centre.y + y))
    })
}

/// Free cells on every side of each free cell: a distance transform by two passes (Rosenfeld & Pfaltz 1966).
fn room_in(free: &Grid<bool>) -> Grid<i32> {
    let mut room = Grid::filled(free.width(), free.height(), i32::MAX);
    for back in [-1, 1] {
        for i in 0..room.len() {
            let cell = room.cell(if back < 0 { i } else { room.len() - 1 - i });
            let near = [(back, 0), (-1, back), (0, back), (1, back)];
            let near = near
                .map(|(x, y)| room.get(Cell::new(cell.x + x, cell.y + y)).map_or(0, |&room| room.saturating_add(1)));
            let least = near.into_iter().fold(room[cell], i32::min);
            room[cell] = if free[cell] { least } else { -1 };
        }
    }
    room
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::{from_picture, picture};

    #[test]
    fn room_is_that_of_the_square_around_a_cell() {
        let free = from_picture("......\n......\n......\n.....#\n......", |c| c == '.').unwrap();
        let room = room_in(&free);
        let drawn = picture(&room, |&r| if r < 0 { '#' } else { char::from(b'0' + r as u8) });
        assert_eq!(drawn, "000000\n011110\n012100\n01110#\n000000\n");
        for (cell, &room) in room.iter().filter(|&(_, &room)| room >= 0) {
            assert_eq!(room_around(&free, cell, 1, room), room, "{cell}");
        }
    }
}
