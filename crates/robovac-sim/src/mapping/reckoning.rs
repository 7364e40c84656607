//! Dead reckoning over a stretch of the path, with its uncertainty.
//!
//! The two systematic errors of a robot are wheels of unequal size and a wheel base that differs from the nominal one
//! (Borenstein & Feng 1996, Measurement and correction of systematic odometry errors in mobile robots, IEEE
//! Transactions on Robotics and Automation 12(6)). Both act on the heading, and both act linearly as long as they are
//! small; so a stretch keeps, beside its pose and covariance, the derivatives of the pose by them, and the filter can
//! estimate them while it drives. Random slip grows with the distance (Thrun, Burgard & Fox 2005, Probabilistic
//! Robotics, section 5.4).

use super::PoseCovariance;
use nalgebra::{Matrix2, Matrix3, Matrix3x2};
use robovac_core::{
    geometry::{Point, Pose},
    math,
    robot::{Body, OdometryModel, RobotModel, RollingScale, SensorReadings, advance, advance_sideways},
};

/// Standard deviation of each wheel's slip after one metre, m: a little more than at the simulator's typical level.
const SLIP: f64 = 0.0012;
/// Relative uncertainty of the distance along a contact, its share in the variance of the heading, and the distance over which
/// that error is constant, m (ours).
const SLIDE: ([f64; 2], f64) = ([0.3, 2.0], 0.05);
/// The same for a robot with nothing but a bumper, whose contacts are taken to be with walls.
const SLIDE_ON_WALLS: [f64; 2] = [0.2, 0.1];
/// Distance and turn between two updates of the covariances, m and rad.
const STRIDE: (f64, f64) = (0.02, 0.06);
/// Errors that a laser corrects, as shares of the way and of the turn; and what there is at least, m and rad (ours: a short pile
/// takes 4 % of the way).
const DOUBT: [f64; 2] = [0.03, 0.03];
const DOUBT_LEAST: [f64; 2] = [0.0004, 0.0004];
/// Errors of a motion in contact: of a round body, which is reckoned to slide along the obstacle already, as shares of the way and of
/// the turn; and of another one across what it touches and along it, as shares of the motion (measured in the simulator).
const ROUND: [f64; 2] = [0.5, 0.3];
const HELD: [f64; 2] = [0.5, 0.05];
/// Errors of a motion that was other than the wheels tell, as shares of the way, of what the body's rim turns, and of the turn.
const WRONG: [f64; 3] = [0.5, 1.0, 0.5];
/// Largest plausible distance of a reading, m; larger ones mean a lost connection, or another robot.
const MOST_AT_ONCE: f64 = 0.5;

/// Errors of the wheels, both estimated by the filter.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct WheelErrors {
    /// Right wheel's size less the left one's, as a share of both.
    pub unequal: f64,
    /// Wheel base less the nominal one, as a share of it.
    pub base: f64,
}

/// Conversion of counts to distances rolled.
#[derive(Debug, Clone)]
pub(super) struct Rolling {
    scale: RollingScale,
    model: OdometryModel,
    last: Option<[u16; 3]>,
}

impl Rolling {
    pub fn new(robot: &RobotModel, model: OdometryModel) -> Self {
        Self { scale: RollingScale::of(robot), model, last: None }
    }

    /// Distances rolled since the last reading: left, right, sideways, m.
    pub fn take(&mut self, sensed: &SensorReadings) -> [f64; 3] {
        let counts = [sensed.left_counts, sensed.right_counts, sensed.lateral_counts];
        let Some(last) = self.last.replace(counts) else { return [0.0; 3] };
        let since = [0, 1, 2].map(|i| counts[i].wrapping_sub(last[i]) as i16);
        let rolled = self.model.rolled(sensed, since, self.scale);
        if rolled.iter().any(|way| way.abs() > MOST_AT_ONCE) { [0.0; 3] } else { rolled }
    }
}

/// Motion since a pose.
#[derive(Debug, Clone)]
pub(super) struct Reckoning {
    /// Present pose in the frame of the start of the stretch.
    pub at: Pose,
    /// Turn since the start, not normalised, rad.
    pub turn: f64,
    /// Covariance of `at` (x, y, heading) by random slip.
    pub noise: Matrix3<f64>,
    /// Derivatives of `at` by [`WheelErrors::unequal`] and [`WheelErrors::base`].
    pub by_wheels: Matrix3x2<f64>,
    /// Assumed errors of the wheels.
    pub wheels: WheelErrors,
    /// Distance, m, and sum of all turning, rad.
    pub way: f64,
    pub turned: f64,
    /// Way ahead and turn while something was touched, m and rad, if anything was.
    touched: Option<[f64; 2]>,
    wheel_base: f64,
    /// Distance from the middle at which a turn pushes the body off a wall, m: 0 for a round one.
    lever: f64,
    slide: [f64; 2],
    model: OdometryModel,
    /// Pose at the last update of the covariances, and distances rolled since, m.
    since: Pose,
    rolled: [f64; 2],
    rolled_either_way: f64,
    slid: f64,
}

impl Reckoning {
    pub fn new(robot: &RobotModel, model: OdometryModel, wheels: WheelErrors) -> Self {
        let slide = if robot.sensors.light_bumper.is_some() { SLIDE.0 } else { SLIDE_ON_WALLS };
        let lever = if robot.body == Body::Round { 0.0 } else { robot.radius };
        Self::new_with((robot.wheel_base, lever), slide, model, wheels)
    }

    fn new_with((wheel_base, lever): (f64, f64), slide: [f64; 2], model: OdometryModel, wheels: WheelErrors) -> Self {
        let here = Pose::new(0.0, 0.0, 0.0);
        Self {
            at: here,
            turn: 0.0,
            noise: Matrix3::zeros(),
            by_wheels: Matrix3x2::zeros(),
            wheels,
            way: 0.0,
            turned: 0.0,
            touched: None,
            wheel_base,
            lever,
            slide,
            model,
            since: here,
            rolled: [0.0; 2],
            rolled_either_way: 0.0,
            slid: 0.0,
        }
    }

    /// Advances; `contact` is the direction of a contact, if the bumper is pressed: then the wheels spin where they
    /// push against the obstacle, and the body slides along it. Returns whether a stride is complete.
    pub fn roll(&mut self, [left, right, lateral]: [f64; 3], contact: Option<f64>) -> bool {
        let half = 0.5 * self.wheels.unequal;
        let (left, right) = ((1.0 - half) * left, (1.0 + half) * right);
        let base = self.wheel_base * (1.0 + self.wheels.base);
        let turn = (right - left) / base;
        let ahead = 0.5 * (left + right);
        self.at = match contact {
            Some(direction) if ahead > 0.0 => {
                let (sin, cos) = math::sin_cos(direction);
                let along = self.at.to_world(Point::new(ahead * sin * sin, -ahead * sin * cos));
                self.slid += ahead;
                Pose::new(along.x, along.y, self.at.heading + turn)
            }
            _ if lateral == 0.0 => advance(self.at, left, right, base, self.model),
            _ => advance_sideways(self.at, [left, right, lateral], base),
        };
        self.turn += turn;
        self.way += ahead.abs().max(lateral.abs());
        self.turned += turn.abs();
        self.rolled = [self.rolled[0] + left, self.rolled[1] + right];
        self.rolled_either_way += left.abs() + right.abs() + lateral.abs();
        let is_complete = self.rolled_either_way > 2.0 * STRIDE.0
            || (self.rolled[1] - self.rolled[0]).abs() > STRIDE.1 * self.wheel_base;
        if is_complete {
            self.settle();
        }
        is_complete
    }

    /// Updates the covariances.
    pub fn settle(&mut self) {
        let (dx, dy) = (self.at.x - self.since.x, self.at.y - self.since.y);
        let shift = Matrix3::new(1.0, 0.0, -dy, 0.0, 1.0, dx, 0.0, 0.0, 1.0);
        let [left, right] = self.rolled;
        let (ahead, turn) = (0.5 * (left + right), (right - left) / self.wheel_base);
        self.by_wheels = shift * self.by_wheels;
        // What turns the stride by half as much moves its end sideways.
        let turns = [ahead / self.wheel_base, -turn];
        for (column, by) in turns.into_iter().enumerate() {
            self.by_wheels[(0, column)] -= 0.5 * dy * by;
            self.by_wheels[(1, column)] += 0.5 * dx * by;
            self.by_wheels[(2, column)] += by;
        }
        let slip = SLIP * SLIP * self.rolled_either_way;
        let [share, turning] = self.slide;
        let slide = share * share * self.slid * SLIDE.1;
        let position = 0.25 * slip + slide;
        let heading = slip / (self.wheel_base * self.wheel_base) + turning * slide;
        self.noise = shift * self.noise * shift.transpose();
        for (i, variance) in [position, position, heading].into_iter().enumerate() {
            self.noise[(i, i)] += variance;
        }
        (self.since, self.rolled, self.rolled_either_way, self.slid) = (self.at, [0.0; 2], 0.0, 0.0);
    }

    /// Notes that the body touched something during the last motion of the wheels: left, right, m.
    pub fn touch(&mut self, [left, right]: [f64; 2]) {
        let [way, turn] = self.touched.unwrap_or_default();
        // Where it backs off, nothing holds it.
        let ahead = (0.5 * (left + right)).max(0.0);
        self.touched = Some([way + ahead, turn + ((right - left) / self.wheel_base).abs()]);
    }

    /// Increases the covariance by errors proportional to the motion, which a robot with a laser allows for: carpets, and
    /// obstacles that it pushes against or slides along. `holds` is how firmly these hold it in each direction, seen from the start.
    pub fn doubt(&mut self, holds: &Matrix2<f64>) {
        let is_round = self.lever == 0.0;
        let [position, heading] = if is_round && self.touched.is_some() { ROUND } else { DOUBT };
        let position = DOUBT_LEAST[0] + position * self.way;
        let heading = DOUBT_LEAST[1] + heading * self.turned;
        for (i, deviation) in [position, position, heading].into_iter().enumerate() {
            self.noise[(i, i)] += deviation * deviation;
        }
        let Some([way, turn]) = self.touched.filter(|_| !is_round) else { return };
        let [across, along] = [HELD[0] * (way + self.lever * turn), HELD[1] * way];
        let mut position = self.noise.fixed_view_mut::<2, 2>(0, 0);
        position += holds * (across * across) + Matrix2::identity() * (along * along);
    }

    /// Further errors of a stretch in which the body was held or pushed without being noticed.
    pub fn wrong(&self) -> PoseCovariance {
        let deviation = WRONG[0] * self.way + WRONG[1] * self.lever * self.turned;
        let square = deviation * deviation;
        PoseCovariance { position: [square, 0.0, square], heading: WRONG[2] * self.turned }
    }

    /// Motion of the body if nothing holds it: ahead, and on the edge of the body by turning, m.
    pub fn motion(&self) -> [f64; 2] {
        [self.at.x, 0.5 * self.wheel_base * self.turn]
    }

    /// The same stretch of a robot whose wheels turned while its body was held.
    pub fn held(&self) -> Self {
        let mut held = Self::new_with((self.wheel_base, self.lever), self.slide, self.model, self.wheels);
        (held.way, held.turned, held.touched) = (self.way, self.turned, self.touched);
        for (i, deviation) in [self.way, self.way, self.turned].into_iter().enumerate() {
            held.noise[(i, i)] = deviation * deviation;
        }
        held
    }

    /// A point in the frame of the start of the stretch, transformed to the present pose.
    pub fn seen_from_here(&self, point: Point) -> Point {
        let (offset, ahead) = (point - self.at.position(), self.at.direction());
        Point::new(ahead.dot(&offset), ahead.perp(&offset))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::model;

    /// A stretch with a bend, driven by a robot that takes its wheels for these.
    fn bend(wheels: WheelErrors) -> Reckoning {
        let mut way = Reckoning::new(model("roomba600").unwrap(), OdometryModel::Arc, wheels);
        for step in 0..300 {
            let (left, right) = if step < 150 { (0.004, 0.004) } else { (0.002, 0.004) };
            way.roll([left, right, 0.0], None);
        }
        way.settle();
        way
    }

    #[test]
    fn derivatives_tell_what_other_wheels_would_have_done() {
        let nominal = bend(WheelErrors::default());
        for (column, wheels) in
            [(0, WheelErrors { unequal: 1e-4, base: 0.0 }), (1, WheelErrors { unequal: 0.0, base: 1e-4 })]
        {
            let other = bend(wheels);
            let change = [other.at.x - nominal.at.x, other.at.y - nominal.at.y, other.turn - nominal.turn];
            for (row, change) in change.into_iter().enumerate() {
                let predicted = 1e-4 * nominal.by_wheels[(row, column)];
                assert!((change - predicted).abs() < 8e-6, "{row}, {column}: {change}, predicted {predicted}");
            }
        }
    }

    #[test]
    fn contact_with_a_wall_leaves_the_way_along_it_known() {
        let mut way = Reckoning::new(model("cbot").unwrap(), OdometryModel::Arc, WheelErrors::default());
        way.roll([0.01, 0.01, 0.0], None);
        let (mut free, mut held) = (way.clone(), way);
        free.doubt(&Matrix2::identity());
        held.touch([0.01, 0.01]);
        held.doubt(&Matrix2::new(0.0, 0.0, 0.0, 1.0));
        let [along, across, before] = [held.noise[(0, 0)], held.noise[(1, 1)], free.noise[(0, 0)]].map(f64::sqrt);
        assert!(along < 1.5 * before && across > 6.0 * before, "{before} m free, {along} m and {across} m in contact");
        // It backs off.
        free.touch([-0.01, -0.01]);
        assert_eq!(free.touched, Some([0.0; 2]));
    }

    #[test]
    fn wheels_that_push_against_a_wall_ahead_move_nothing() {
        let mut way = Reckoning::new(model("roomba600").unwrap(), OdometryModel::Arc, WheelErrors::default());
        for _ in 0..20 {
            way.roll([0.004, 0.004, 0.0], Some(0.0));
        }
        way.settle();
        assert!(way.at.position().coords.norm() < 1e-9 && way.noise[(0, 0)].sqrt() > 0.01);
        // At 45 degrees, it slides.
        for _ in 0..20 {
            way.roll([0.004, 0.004, 0.0], Some(core::f64::consts::FRAC_PI_4));
        }
        assert!((way.at.x - 0.04).abs() < 1e-9 && (way.at.y + 0.04).abs() < 1e-9, "{}", way.at);
    }
}
