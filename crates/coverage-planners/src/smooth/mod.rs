//! Driving a line of corners smoothly: which corners are rounded, and how far.
//!
//! Rounding a corner saves a stop, but the tool leaves out some floor on its outer side. [`smooth`] decides for every corner, or
//! U-turn of two, among curves of several sizes and the stop. A curve must keep the body off everything, by exact distances;
//! all curves together may leave out only a given share of the floor that the line with its corners sweeps. Those that leave out
//! least for the time that they save come first.

mod choice;
mod swept;
mod units;

use crate::lanes::swept_share;
use choice::choose;
use robovac_core::{
    coverage::ReachableFloor,
    geometry::Point,
    robot::RobotModel,
    trajectory::{DriveLimits, RoundedLine, Rounding, Trajectory},
};
use swept::SweptCounts;
use units::units;

/// Samples that each curve counts as leaving out in addition, from try to try: what falls between samples isn't counted, and the
/// exact measure can find that it was too much.
const UNSEEN: [i64; 4] = [0, 1, 3, 8];
/// Accuracy of the exact measure, as a share.
const ACCURACY: f64 = 1e-4;

/// What rounding may do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SmoothSetup {
    /// The farthest that a curve passes from its corner, m.
    pub cut: f64,
    /// Share of the reachable floor that rounding may leave out, 0 to 1.
    pub loss: f64,
    /// Share that has to be swept, 0 to 1: what the line with its corners sweeps beyond that may be left out, too.
    pub least: f64,
    /// Room between body and obstacles in curves, m, at least.
    pub clearance: f64,
}

impl Default for SmoothSetup {
    fn default() -> Self {
        Self { cut: 0.08, loss: 0.001, least: 1.0, clearance: 0.003 }
    }
}

/// A line as it is driven smoothly.
#[derive(Debug, Clone, PartialEq)]
pub struct SmoothPath {
    /// Poses and speeds.
    pub trajectory: Trajectory,
    /// The share of the floor that it sweeps, 0 to 1, by [`swept_share`].
    pub coverage: f64,
    /// The same with stops at all corners.
    pub stopped_coverage: f64,
    /// Corners at which the robot turns, and how many of them are rounded.
    pub corners: usize,
    /// Rounded corners.
    pub rounded: usize,
}

/// Errors of smooth driving.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum SmoothError {
    /// A robot that moves in every direction doesn't turn at corners.
    #[error(
        "{0} can't round corners: it moves in every direction without turning. Choose a robot with two driven wheels"
    )]
    NotDifferential(&'static str),
}

/// Rounds `line` (corners in metres, from the start of `floor`) for `robot`, which drives no faster than `limits`.
///
/// The result takes no longer than stopping at every corner within the same limits, its body touches nothing where the
/// line's doesn't, and it sweeps at most `setup.loss` less, or `setup.least`.
pub fn smooth(floor: &ReachableFloor, line: &[Point], limits: &DriveLimits, setup: &SmoothSetup) -> SmoothPath {
    let heading = floor.start.heading;
    let line = &distinct(line);
    let turns = RoundedLine::turns(line);
    let corners = turns.iter().filter(|turn| **turn != 0.0).count();
    let stopped_coverage = swept_share(floor, line);
    let units = units(floor, line, limits, setup);
    let loss = setup.loss.max(stopped_coverage - setup.least).max(0.0);
    let budget = loss * floor.area();
    let mut best = None;
    for unseen in UNSEEN {
        let roundings = choose(line, &units, &mut SweptCounts::new(floor), budget, unseen);
        let rounded = RoundedLine::new(line, heading, &roundings);
        let coverage = swept_share(floor, &rounded.points());
        if coverage >= stopped_coverage - loss - ACCURACY {
            best = Some((rounded, coverage, roundings));
            break;
        }
    }
    let (rounded, coverage, roundings) =
        best.unwrap_or_else(|| (RoundedLine::new(line, heading, &[]), stopped_coverage, Vec::new()));
    let is_rounded = |rounding: &&Rounding| **rounding != Rounding::Stop;
    SmoothPath {
        trajectory: Trajectory::new(&rounded, limits),
        coverage,
        stopped_coverage,
        corners,
        rounded: roundings.iter().filter(is_rounded).count(),
    }
}

/// The limits of a robot that can drive smoothly.
pub fn limits_of(robot: &RobotModel) -> Result<DriveLimits, SmoothError> {
    DriveLimits::of(robot).ok_or(SmoothError::NotDifferential(robot.title))
}

/// The line without points that repeat the one before.
fn distinct(line: &[Point]) -> Vec<Point> {
    let mut points: Vec<Point> = Vec::with_capacity(line.len());
    for &point in line {
        if points.last().is_none_or(|last| (point - last).norm() > 1e-9) {
            points.push(point);
        }
    }
    points
}
