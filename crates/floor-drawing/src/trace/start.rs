//! Where a robot starts if there is floor outside of the building, too.

use super::{EnclosedFloor, RoomTracer, frame::RasterFrame};
use crate::{DrawingFlaw, Traced};
use robovac_core::{
    coverage::with_objects,
    geometry::{Point, Pose},
    grid::{Cell, Grid, chessboard, largest_part, reachable},
    math::{ceil, floor},
};

/// Width of the robot that could go out, m: a Roomba, the most usual one.
const ROBOT: f64 = 0.35;
/// Least floor outside that is told about, m² (ours): less is a doorstep.
const LEAST: f64 = 1.0;

impl RoomTracer<'_> {
    /// All of it, with a start indoors if there is floor outside, too.
    pub(super) fn whole_from_indoors(&self) -> Result<Traced, DrawingFlaw> {
        let mut traced = self.whole()?;
        let free = traced.plan.occupancy.values().iter().filter(|cell| cell.is_free()).count();
        let Some(EnclosedFloor { frame, inside, small, in_doubt, .. }) = self.enclosed()? else { return Ok(traced) };
        let may_be = in_doubt.map(|building| building.floor);
        let home = small.map(|(floor, _)| floor).or(may_be).unwrap_or(inside);
        if home.count() < free {
            traced.goes_out = self.start_at(&mut traced, &frame, &home) == Some(true);
        }
        Ok(traced)
    }

    /// Starts in the middle of the widest place of `home`, whose cells are those of `frame`, and tells whether a robot can
    /// leave it from there; `None` if the room has none of it.
    pub(super) fn start_at(&self, traced: &mut Traced, frame: &RasterFrame, home: &Grid<bool>) -> Option<bool> {
        let free = with_objects(&traced.plan).occupancy.map(|cell| cell.is_free());
        let mut homely = free.clone();
        for index in 0..homely.len() {
            let cell = homely.cell(index);
            let place = Point::from(traced.corner + cell.centre(1.0).coords * self.side);
            let at = frame.cells(place);
            homely[cell] &= home.is_set(Cell::new(floor(at.x), floor(at.y)));
        }
        let room = reachable(&homely, largest_part(&homely)?);
        let width = chessboard(&room.map(|is_room| !is_room));
        let (start, _) = width.iter().max_by_key(|&(_, &moves)| moves)?;
        let at = start.centre(self.how.resolution);
        traced.plan.start = Some(Pose::new(at.x, at.y, 0.0));
        Some(self.leads_out(&free, &homely, start))
    }

    /// Whether a robot gets from a cell to floor that isn't `home`.
    fn leads_out(&self, free: &Grid<bool>, home: &Grid<bool>, start: Cell) -> bool {
        let moves = chessboard(&free.map(|is_free| !is_free));
        // A square of 2 n - 1 cells lies around a cell that is n moves from the next wall.
        let least = ceil(f64::midpoint(ROBOT / self.how.resolution, 1.0) - 1e-9).clamp(1, 250);
        let wide = moves.map(|&moves| i32::from(moves) >= least);
        if !wide.is_set(start) {
            return false;
        }
        let reached = reachable(&wide, start);
        let out = reached.iter().filter(|&(cell, &is_reached)| is_reached && !home[cell]).count();
        out as f64 * self.how.resolution * self.how.resolution >= LEAST
    }
}
