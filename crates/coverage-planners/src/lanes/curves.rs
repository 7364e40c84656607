//! Time of the curves round corners, without finding the whole trajectory: what a corner takes depends on its angle and on how
//! much of the pieces beside it the curve may use.

use super::free_space::FreeSpace;
use robovac_core::{
    geometry::{Point, Vector},
    math,
    robot::RobotModel,
    trajectory::{CornerShape, DriveLimits, RoundedLine, Rounding},
};

/// Steps of the table from no turn to a reversal, and of tangents up to the longest, m.
const ANGLES: usize = 60;
const TANGENTS: (usize, f64) = (20, 0.2);
/// Farthest that the search takes a curve to pass from its corner, m. It counts the floor as swept up to the corner; a wider bend
/// has several corners.
const CUT: f64 = 0.03;
/// Straight way before and behind a corner along which times are compared, m.
const LEAD: f64 = 0.75;
/// Sizes of curves that are tried where the largest doesn't fit, as shares of it.
const SIZES: [f64; 4] = [1.0, 0.6, 0.35, 0.2];
/// Times that aren't worth a look at obstacles, s.
const LITTLE: f64 = 0.02;

/// A row of the table: corners of one angle.
#[derive(Debug, Clone, Copy)]
struct CornersByAngle {
    /// Seconds with tangents up to each length.
    seconds: [f64; TANGENTS.0 + 1],
    /// Longest tangent, m, at which the curve is near enough to its corner.
    longest: f64,
    /// How far the curve passes from the corner, as a share of its tangent.
    cut: f64,
}

/// Seconds that a robot takes longer for corners than for straight pieces.
#[derive(Debug, Clone)]
pub(super) struct CurveTimes {
    rows: Vec<CornersByAngle>,
}

impl CurveTimes {
    /// `None` for a robot that doesn't drive curves.
    pub fn of(robot: &RobotModel) -> Option<Self> {
        let limits = DriveLimits::of(robot)?;
        let row = |i: usize| {
            let angle = math::PI * i.max(1) as f64 / ANGLES as f64;
            let (sin, cos) = math::sin_cos(angle);
            let line = [Point::new(-LEAD, 0.0), Point::origin(), Point::new(LEAD * cos, LEAD * sin)];
            let seconds = |rounding: Rounding| {
                let rounded = RoundedLine::new(&line, 0.0, &[Rounding::Stop, rounding, Rounding::Stop]);
                rounded.passing_time(&limits) - 2.0 * LEAD / limits.speed
            };
            let shape = CornerShape::alone(angle, 1.0);
            let longest = shape.map_or(0.0, |shape| (CUT / shape.cut).min(TANGENTS.1));
            let mut least = seconds(Rounding::Stop);
            let row = std::array::from_fn(|j| {
                let tangent = (TANGENTS.1 * j as f64 / TANGENTS.0 as f64).min(longest);
                if tangent > 0.0 {
                    least = least.min(seconds(Rounding::Alone(tangent)));
                }
                least
            });
            CornersByAngle { seconds: row, longest, cut: shape.map_or(0.0, |shape| shape.cut) }
        };
        Some(Self { rows: (0..=ANGLES).map(row).collect() })
    }

    /// Seconds for a corner that turns by `angle`, with the pieces `ways` away from it. The curve must fit into `space`.
    pub fn seconds(&self, angle: f64, at: Point, ways: [Vector; 2], space: Option<&FreeSpace>) -> f64 {
        let place = (angle * (ANGLES as f64 / math::PI)).min(ANGLES as f64 - 1e-9);
        let (i, part) = (place as usize, place.fract());
        let rows = [&self.rows[i], &self.rows[i + 1]];
        let with = |tangent: f64| {
            let place = (tangent * (TANGENTS.0 as f64 / TANGENTS.1)).min(TANGENTS.0 as f64 - 1e-9);
            let (j, along) = (place as usize, place.fract());
            let [low, high] = rows.map(|row| row.seconds[j] + along * (row.seconds[j + 1] - row.seconds[j]));
            low + part * (high - low)
        };
        let lengths = ways.map(|way| way.norm());
        let longest = (0.5 * lengths[0].min(lengths[1])).min(rows[0].longest.max(rows[1].longest));
        let Some(space) = space else { return with(longest) };
        let stop = with(0.0);
        if stop - with(longest) < LITTLE {
            return stop;
        }
        let [before, behind] = [ways[0] / lengths[0], ways[1] / lengths[1]];
        let inwards = before + behind;
        let cut = rows[0].cut.min(rows[1].cut);
        let aside = inwards * (cut / inwards.norm().max(1e-9));
        let fits = |tangent: &f64| {
            let middle = at + aside * *tangent;
            space.is_free(at + before * *tangent, middle) && space.is_free(middle, at + behind * *tangent)
        };
        SIZES.iter().map(|size| size * longest).find(fits).map_or(stop, with)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use math::FRAC_PI_2;
    use robovac_core::{coverage::ReachableFloor, floor_plan::Sketch, robot::model};

    /// Radius of a body, with some room, m.
    const REACH: f64 = 0.18;
    const CORNER: Point = Point::new(1.5, 1.0);

    /// Ways of `length` metres from [`CORNER`], of which the second turns by `angle` to the left of the first.
    fn ways(angle: f64, length: f64) -> [Vector; 2] {
        let (sin, cos) = math::sin_cos(angle);
        [Vector::new(-length, 0.0), Vector::new(cos, sin) * length]
    }

    #[test]
    fn corners_take_as_long_as_their_trajectory() {
        let robot = model("roomba600").unwrap();
        let (times, limits) = (CurveTimes::of(robot).unwrap(), DriveLimits::of(robot).unwrap());
        for angle in [0.13, 0.7, 1.57, 2.3, 2.9] {
            for length in [0.1, 0.23, 1.0] {
                let room = ways(angle, LEAD).map(|way| CORNER + way);
                let shape = CornerShape::alone(angle, 1.0).unwrap();
                let tangent = (CUT / shape.cut).min(0.5 * length).min(TANGENTS.1);
                let seconds = |rounding: Rounding| {
                    let rounded =
                        RoundedLine::new(&[room[0], CORNER, room[1]], 0.0, &[Rounding::Stop, rounding, Rounding::Stop]);
                    rounded.passing_time(&limits) - 2.0 * LEAD / limits.speed
                };
                let expected = seconds(Rounding::Alone(tangent)).min(seconds(Rounding::Stop));
                let found = times.seconds(angle, CORNER, ways(angle, length), None);
                assert!((found - expected).abs() < 0.05, "{angle} rad, {length} m: {found} s, not {expected}");
            }
        }
        assert!(CurveTimes::of(model("octagon").unwrap()).is_none(), "it has no need of curves");
    }

    #[test]
    fn a_corner_with_something_on_its_inner_side_is_a_stop() {
        let robot = model("roomba600").unwrap();
        let times = CurveTimes::of(robot).unwrap();
        // As far from the corner as the body needs.
        let inner = CORNER + Vector::new(-math::sin(0.5 * FRAC_PI_2), math::cos(0.5 * FRAC_PI_2)) * (REACH + 0.021);
        let open = Sketch::open(3.0, 2.0, 0.05);
        let [open, blocked] = [open.clone(), open.disc(inner.x, inner.y, 0.02)].map(|sketch| {
            let floor = ReachableFloor::new(&sketch.finish("", ""), robot, None).unwrap();
            let space = FreeSpace::new(floor.limits(), REACH);
            times.seconds(FRAC_PI_2, CORNER, ways(FRAC_PI_2, 0.5), Some(&space))
        });
        let stop = times.seconds(FRAC_PI_2, CORNER, ways(FRAC_PI_2, 0.0), None);
        assert!(open < 0.6 * stop && blocked > 0.8 * stop, "{open} s, {blocked} s, {stop} s");
    }
}
