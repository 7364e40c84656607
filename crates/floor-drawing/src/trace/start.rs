//! Where a robot starts if there is floor outside of the building, too.

use super::{EnclosedFloor, RoomTracer, frame::RasterFrame, raster::RasterCanvas};
use crate::{DrawingFlaw, Traced};
use robovac_core::{
    coverage::with_objects,
    geometry::{Point, Pose},
    grid::{Cell, Grid, Occupancy, chessboard, largest_part, reachable},
    math::{ceil, floor},
};

/// Width of the robot that could go out, m: a Roomba, the most usual one.
const ROBOT: f64 = 0.35;
/// Least floor outside that is told about, m² (ours): less is a doorstep.
const LEAST: f64 = 1.0;

impl RoomTracer<'_> {
    /// All of it, with a start indoors if there is floor outside, too, and openings up to `outer` metres closed by which a robot
    /// would get there.
    pub(super) fn whole_from_indoors(&self, outer: f64) -> Result<Traced, DrawingFlaw> {
        let mut traced = self.whole()?;
        let free = traced.plan.occupancy.values().iter().filter(|cell| cell.is_free()).count();
        let Some(found) = self.enclosed()? else {
            traced.leak = self.outside_leak(None)?;
            traced.is_open = traced.leak.is_some();
            return Ok(traced);
        };
        let may_be = found.in_doubt.as_ref().map(|building| &building.floor);
        // A building that is taken for a house is all that is inside.
        let block = found.small.as_ref().filter(|(_, is_taken)| !is_taken).map(|(floor, _)| floor).or(may_be);
        let home = block.unwrap_or(&found.inside);
        if home.count() >= free {
            return Ok(traced);
        }
        traced.goes_out = self.start_at(&mut traced, &found.frame, home) == Some(true);
        // Where all may be one building, its doors are to be passed.
        if traced.goes_out && outer > 0.0 && block.is_none() {
            traced.leak = self.outside_leak(Some(&found))?;
            traced.is_open = traced.leak.is_some();
            // The openings may be doors of one room; the others are open to the outside.
            if traced.is_open {
                return Ok(traced);
            }
            self.shut(&mut traced, &found)?;
            traced.goes_out = self.start_at(&mut traced, &found.frame, home) == Some(true);
        }
        Ok(traced)
    }

    /// Makes walls of the openings of a building.
    fn shut(&self, traced: &mut Traced, found: &EnclosedFloor) -> Result<(), DrawingFlaw> {
        let occupancy = &mut traced.plan.occupancy;
        let mut canvas = RasterCanvas::new([occupancy.width() as i32, occupancy.height() as i32]);
        let in_room = |end: Point| Point::from((found.frame.point(end).coords - traced.corner) / self.side);
        for &[a, b] in &found.openings {
            canvas.segment(in_room(a), in_room(b))?;
        }
        for (cell, &is_shut) in occupancy.values_mut().iter_mut().zip(canvas.cells.values()) {
            if is_shut {
                *cell = Occupancy::Occupied;
            }
        }
        self.add_gaps(traced, &found.frame, &found.openings);
        Ok(())
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
