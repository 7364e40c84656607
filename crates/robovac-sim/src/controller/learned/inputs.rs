//! What the network gets to know of each direction.

use super::{
    swept_map::{Fixed, SweptMap, block_of, fixed},
    way::Way,
};
use robovac_core::{
    geometry::{Point, Pose, difference},
    math,
    robot::{LightBumper, SensorReadings},
};

/// Directions among which it chooses, degrees to the left of straight ahead.
const DEGREES: [f64; 16] =
    [0.0, 9.0, -9.0, 20.0, -20.0, 35.0, -35.0, 55.0, -55.0, 80.0, -80.0, 110.0, -110.0, 145.0, -145.0, 180.0];
/// Number of directions.
pub(super) const DIRECTIONS: usize = DEGREES.len();
/// Values for each direction.
pub(super) const INPUTS: usize = 16;

/// Distance between two looks along a direction, m, and number of looks: up to 2.4 m.
const STEP_M: f64 = 0.1;
const LOOKS: usize = 24;
/// Looks that are near, and those that are not yet far.
const NEAR: usize = 4;
const MIDDLE: usize = 10;
/// Distance of the two looks beside each, m: the tool sweeps 17 cm.
const BESIDE_M: f64 = 0.06;
/// Distance of the lanes to the left and right that are compared with it, m, and number of looks along them.
const LANE_M: f64 = 0.17;
const LANE: usize = 8;
/// Light signal that counts half.
const SIGNAL: f64 = 300.0;
/// Angle from a light sensor beyond which it says nothing, rad.
const ASIDE: f64 = 0.6;
/// Visits that count half.
const VISITS: f64 = 8.0;
/// Distance of the place whose visits count, m.
const VISITED_M: f64 = 0.35;

/// Where the robot is, and what is around it.
pub(super) struct Vicinity<'a> {
    pub map: &'a SweptMap,
    pub way: &'a Way,
    pub pose: Pose,
    pub light: Option<LightBumper>,
    pub sensed: &'a SensorReadings,
    /// Time since the last obstruction, s.
    pub untouched_s: f64,
}

/// A direction, rad to the left of straight ahead.
pub(super) fn angle(direction: usize) -> f64 {
    DEGREES.get(direction).copied().unwrap_or(0.0).to_radians()
}

impl Vicinity<'_> {
    /// The values of all directions, mostly from -1 to 1.
    pub(super) fn inputs(&self) -> [[f32; INPUTS]; DIRECTIONS] {
        let here = self.pose.position();
        let to = self.way.next(self.map, here).map(|to| math::atan2(to.y - here.y, to.x - here.x));
        let visits = self.visits(here.x, here.y);
        std::array::from_fn(|direction| {
            let angle = angle(direction);
            let heading = self.pose.heading + angle;
            let (sin, cos) = math::sin_cos(heading);
            let Looked { new, open, known } = self.look((cos, sin));
            let towards = to.map_or(0.0, |to| math::cos(difference(heading, to)));
            let far = self.way.length_m();
            let is_far = if far > 1.0 { 1.0 } else { 0.0 };
            let visited = self.visits(here.x + VISITED_M * cos, here.y + VISITED_M * sin);
            [
                new[0],
                new[1],
                new[2],
                open,
                if open < 0.15 { 1.0 } else { 0.0 },
                known[0],
                known[1],
                angle.abs() / math::PI,
                angle / math::PI,
                towards * (1.0 - is_far),
                towards * is_far,
                far / (2.0 + far),
                visited - visits,
                visited,
                self.light(angle),
                self.untouched_s / (1.0 + self.untouched_s),
            ]
            .map(|value| value as f32)
        })
    }

    /// Looks along a direction.
    fn look(&self, (cos, sin): (f64, f64)) -> Looked {
        let (x, y) = fixed(self.pose.position());
        let along = |metres: f64| fixed(Point::new(metres * cos, metres * sin));
        let step = along(STEP_M);
        // Turned to the left.
        let [beside, lane] = [BESIDE_M, LANE_M].map(|metres| {
            let (x, y) = along(metres);
            (-y, x)
        });
        let mut at = (x, y);
        let mut new = [0_u32; 3];
        let mut known = [0_u32; 2];
        let mut open = LOOKS;
        for look in 1..=LOOKS {
            at = sum(at, step);
            if self.map.is_blocked(at) {
                open = look - 1;
                break;
            }
            let band = usize::from(look > NEAR) + usize::from(look > MIDDLE);
            for place in [at, sum(at, beside), less(at, beside)] {
                new[band] += u32::from(self.map.is_new(place));
            }
            if look <= LANE {
                for (known, place) in known.iter_mut().zip([sum(at, lane), less(at, lane)]) {
                    *known += u32::from(!self.map.is_new(place));
                }
            }
        }
        let looks = [NEAR, MIDDLE - NEAR, LOOKS - MIDDLE];
        let share = |count: u32, of: usize| f64::from(count) / of as f64;
        Looked {
            new: [0, 1, 2].map(|band| share(new[band], 3 * looks[band])),
            open: open as f64 / LOOKS as f64,
            known: known.map(|known| share(known, open.clamp(1, LANE))),
        }
    }

    /// How often the robot was at a point, from 0 for never to 1.
    fn visits(&self, x: f64, y: f64) -> f64 {
        let visits = f64::from(self.map.visits(block_of([x, y].into())));
        visits / (VISITS + visits)
    }

    /// How near something is by the light bumper, 0 to 1.
    fn light(&self, angle: f64) -> f64 {
        let Some(bumper) = self.light else { return 0.0 };
        let near = bumper.angles.into_iter().zip(self.sensed.light_signal).map(|(at, signal)| {
            let signal = f64::from(signal);
            (1.0 - (angle - at).abs() / ASIDE).max(0.0) * signal / (SIGNAL + signal)
        });
        near.fold(0.0, f64::max)
    }
}

fn sum(a: Fixed, b: Fixed) -> Fixed {
    (a.0.wrapping_add(b.0), a.1.wrapping_add(b.1))
}

fn less(a: Fixed, b: Fixed) -> Fixed {
    (a.0.wrapping_sub(b.0), a.1.wrapping_sub(b.1))
}

/// What lies in a direction.
struct Looked {
    /// Share that is new of what is near, farther, and far.
    new: [f64; 3],
    /// Way until something is known to be there, as a share of the farthest look.
    open: f64,
    /// Share that is known of the lanes to the left and to the right.
    known: [f64; 2],
}
