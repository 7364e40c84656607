//! A simulated robot: body and wheels.

use super::{
    Conditions, Life, STEP_S, Slip, Touch, World,
    contact::{CollisionObstacles, Footprint},
    senses::{Around, Carrier, Senses, Supply},
};
use robovac_core::{
    coverage::Walls,
    geometry::{Point, Pose},
    robot::{Drive, RobotModel, RobotPort, SensorReadings, WheelLayout, advance_sideways},
};

/// Emergency braking, m/s²: a Roomba that reaches an edge at its full 0.5 m/s stops within 52 mm, of the 154 mm between its
/// cliff sensors and wheels (ours).
const BRAKING: f64 = 2.4;

/// Body, wheels and sensors of one robot. It takes wheel speeds and reports the readings of the Open Interface.
#[expect(clippy::struct_excessive_bools)]
#[derive(Debug, Clone)]
pub struct SimRobot {
    model: RobotModel,
    footprint: Footprint,
    pose: Pose,
    slip: Slip,
    is_quantised: bool,
    /// Whether it brakes as hard as it can, and whether brushes or vacuum run.
    is_braking: bool,
    is_sweeping: bool,
    /// Commanded wheel speeds, m/s.
    wanted: Drive,
    /// Present wheel speeds, m/s.
    speed: Drive,
    /// Distances rolled by the wheels since the start: left, right, sideways, m.
    rolled: [f64; 3],
    is_lifted: bool,
    /// Dropped wheels: left, right.
    dropped: [bool; 2],
    has_fallen: bool,
    senses: Senses,
}

impl SimRobot {
    /// A robot at rest.
    pub fn new(model: &RobotModel, pose: Pose, conditions: Conditions, seed: u64) -> Self {
        Self {
            model: model.clone(),
            footprint: Footprint::new(model),
            pose,
            slip: Slip::new(conditions.slip, seed),
            is_quantised: conditions.quantised,
            is_braking: false,
            is_sweeping: true,
            wanted: Drive::STOP,
            speed: Drive::STOP,
            rolled: [0.0; 3],
            is_lifted: false,
            dropped: [false; 2],
            has_fallen: false,
            senses: Senses::new(model, conditions, seed),
        }
    }

    /// For paths that may touch: its contact is exact, also where it is wedged.
    pub fn with_exact_contact(mut self) -> Self {
        self.footprint.make_exact();
        self
    }

    /// Without light bumper and laser: for commands that are known, which nothing that it sees can change.
    pub fn without_sight(mut self) -> Self {
        self.senses.see_nothing();
        self
    }

    /// The true pose, which no controller gets.
    #[inline]
    pub fn pose(&self) -> Pose {
        self.pose
    }

    /// Commanded wheel speeds.
    pub fn commanded(&self) -> Drive {
        self.wanted
    }

    /// Present wheel speeds.
    #[inline]
    pub fn speed(&self) -> Drive {
        self.speed
    }

    /// Whether its battery is empty, so that it no longer moves.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.senses.is_empty()
    }

    /// Whether it was picked up.
    pub fn is_lifted(&self) -> bool {
        self.is_lifted
    }

    /// Whether it has fallen down a drop-off. It lies there until it is put elsewhere.
    pub fn has_fallen(&self) -> bool {
        self.has_fallen
    }

    /// Picks it up.
    pub fn lift(&mut self) {
        self.is_lifted = true;
        self.speed = Drive::STOP;
    }

    /// Puts it down at `pose`, where it must fit.
    pub fn put_down(&mut self, pose: Pose) {
        self.is_lifted = false;
        self.has_fallen = false;
        self.dropped = [false; 2];
        self.pose = pose;
    }

    /// Brakes as hard as the motors can, until the next drive command.
    pub fn brake(&mut self) {
        self.wanted = Drive::STOP;
        self.is_braking = true;
    }

    /// Switches its brushes and vacuum, which run from the start. At rest they pick up nothing.
    pub fn set_sweeping(&mut self, is_sweeping: bool) {
        self.is_sweeping = is_sweeping;
    }

    /// Sets the battery's power and charging current from outside.
    pub fn supply(&mut self, supply: Supply) {
        self.senses.supply(supply);
    }

    /// Whether its body is nearer than `gap` metres to a disc, or overlaps it. False for a lifted robot.
    pub fn is_near_disc(&mut self, centre: Point, radius: f64, gap: f64) -> bool {
        !self.is_lifted && self.footprint.is_near_disc(self.pose, centre, radius, gap)
    }

    /// One step of [`STEP_S`] at the last wheel speeds of [`RobotPort::drive`], after one of what moves in the room.
    pub fn step(&mut self, walls: &Walls, world: &World, life: &mut Life) {
        life.step(world, |centre, radius| self.is_near_disc(centre, radius, 0.0));
        let before = self.pose;
        let drive = if self.senses.is_empty() { Drive::STOP } else { self.wanted };
        let touch = self.roll(CollisionObstacles { walls, movers: life.movers() }, world, drive);
        let is_cleaning = self.is_sweeping && !self.is_lifted && !self.has_fallen;
        let dirt = if is_cleaning { 1e3 * life.sweep(&self.model, self.pose) } else { 0.0 };
        let carrier = Carrier {
            pose: self.pose,
            touch,
            wanted: drive,
            speed: self.speed,
            rolled: self.rolled,
            moved: (self.pose.position() - before.position()).norm(),
            is_lifted: self.is_lifted,
            dropped: self.dropped,
            dirt,
        };
        self.senses.read(Around { walls, world, life }, &carrier);
    }

    /// Turns the wheels and moves the body as far as the obstacles allow; returns its contacts.
    fn roll(&mut self, obstacles: CollisionObstacles<'_>, world: &World, drive: Drive) -> Touch {
        let lateral = if self.model.wheels == WheelLayout::Omnidirectional { drive.lateral } else { 0.0 };
        let speed = Drive {
            left: self.approach(self.speed.left, drive.left),
            right: self.approach(self.speed.right, drive.right),
            lateral: self.approach(self.speed.lateral, lateral),
        };
        // Mean speed of the step: exact for constant acceleration.
        let mean = |before: f64, now: f64| 0.5 * (before + now) * STEP_S;
        let rolled = [
            mean(self.speed.left, speed.left),
            mean(self.speed.right, speed.right),
            mean(self.speed.lateral, speed.lateral),
        ];
        self.speed = speed;
        for (sum, travel) in self.rolled.iter_mut().zip(rolled) {
            *sum += travel;
        }
        if self.is_lifted || self.has_fallen {
            return Touch::NONE;
        }
        let [left, right, lateral] = self.slip.apply(rolled, || world.is_on_carpet(self.pose.position()));
        // A wheel in the air drives nothing.
        let on_floor = |travel: f64, has_dropped: bool| if has_dropped { 0.0 } else { travel };
        let travel = [on_floor(left, self.dropped[0]), on_floor(right, self.dropped[1]), lateral];
        let moved = advance_sideways(self.pose, travel, self.slip.wheel_base(self.model.wheel_base));
        let contact = self.footprint.slide(obstacles, self.pose, moved);
        self.pose = contact.pose;
        if !world.drop_offs.is_empty() {
            self.look_down(world);
        }
        contact.touch
    }

    /// Finds the dropped wheels. The robot falls when both wheels have no floor, or its middle has none.
    fn look_down(&mut self, world: &World) {
        let half = 0.5 * self.model.wheel_base;
        let is_void = |y: f64| world.is_drop_off(self.pose.to_world(Point::new(0.0, y)));
        self.dropped = [is_void(half), is_void(-half)];
        if self.dropped == [true; 2] || world.is_drop_off(self.pose.position()) {
            self.dropped = [true; 2];
            self.has_fallen = true;
            self.speed = Drive::STOP;
        }
    }

    /// The wheel speed one step later: towards `wanted`, within the motors' speed and acceleration.
    fn approach(&self, speed: f64, wanted: f64) -> f64 {
        let least = if self.is_braking { BRAKING } else { 0.0 };
        let most = self.model.acceleration.max(least) * STEP_S;
        let wanted = if self.is_quantised { kept_speed(wanted, self.model.speed_steps) } else { wanted };
        let wanted = wanted.clamp(-self.model.max_wheel_speed, self.model.max_wheel_speed);
        speed + (wanted - speed).clamp(-most, most)
    }
}

impl RobotPort for SimRobot {
    #[inline]
    fn sensors(&self) -> &SensorReadings {
        self.senses.reading()
    }

    #[inline]
    fn drive(&mut self, wanted: Drive) {
        // A pose that isn't a number would be nowhere in the room.
        let is_speed = [wanted.left, wanted.right, wanted.lateral].iter().all(|speed| speed.is_finite());
        self.wanted = if is_speed { wanted } else { Drive::STOP };
        self.is_braking = false;
    }
}

/// The actual speed of a wheel commanded to `wanted` m/s, for a motor controller that keeps only some speeds.
///
/// Below the smallest speed it doesn't turn. Above, it takes the next of the speeds that lie a step apart: commanded 11
/// to 39 mm/s, a Create 2 drives at 39 mm/s, and so on in steps of 28.5 mm/s (K. Tibow, Roombas, motors, and noise,
/// ktibow.github.io/blog/roombamotors; the step is also in the Create 2 Open Interface specification).
pub fn kept_speed(wanted: f64, [smallest, step]: [f64; 2]) -> f64 {
    let speed = wanted.abs();
    if step <= 0.0 {
        return wanted;
    }
    if speed < smallest {
        return 0.0;
    }
    // A little less, so that speeds that the controller can keep don't change.
    let steps = ((speed - smallest) / step - 1e-9).ceil().max(1.0);
    (smallest + steps * step).copysign(wanted)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roomba_drives_at_the_speeds_that_owners_measured() {
        let steps = [0.011, 0.0285];
        for (wanted, expected) in [
            (0.0, 0.0),
            (0.0109, 0.0),
            (0.011, 0.0395),
            (0.039, 0.0395),
            (0.041, 0.068),
            (-0.3, -0.3245),
            (0.3245, 0.3245),
        ] {
            assert!((kept_speed(wanted, steps) - expected).abs() < 1e-9, "{wanted}: {}", kept_speed(wanted, steps));
        }
        assert_eq!(kept_speed(0.0123, [0.0, 0.0]), 0.0123);
    }
}
