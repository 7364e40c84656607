//! Phases 1 to 4: one of a few motions, chosen at random, again and again.

use super::{
    BACK_FROM_EDGE, leave,
    obstacles::{LastContact, SensedObstacles},
    turn_back,
};
use crate::controller::{
    Setup,
    parts::{Behaviour, By, Move, Obstruction, ObstructionKind, ObstructionSide, Pilot},
};
use rand::RngExt;
use robovac_core::{
    math,
    registry::{ParamKind, ParamSpec},
    robot::{Drive, SensorReadings},
};

/// Way back after a contact, m.
const BACK: f64 = 0.02;

/// Length of a motion ahead. Fixed in the thesis, without a figure.
pub(super) const DISTANCE: ParamSpec = ParamSpec {
    id: "distance",
    label: "Forward",
    help: "Length of a forward motion.",
    kind: ParamKind::Number { min: 5.0, max: 100.0, step: 1.0, default: 20.0, unit: "cm" },
};

/// Angle of a rotation. Fixed in the thesis, without a figure.
pub(super) const ANGLE: ParamSpec = ParamSpec {
    id: "angle",
    label: "Rotation",
    help: "Angle of a rotation.",
    kind: ParamKind::Number { min: 5.0, max: 180.0, step: 5.0, default: 30.0, unit: "°" },
};

/// Effect of an unexpected contact on a motion ahead.
pub(super) const PUSHES: ParamSpec = ParamSpec {
    id: "bump",
    label: "At a wall",
    help: "Keep the wheels rolling at a wall until the distance is done, as in the thesis, which corrupts odometry; or \
        stop and back up.",
    kind: ParamKind::Choice { options: &[("push", "rolls on, as printed"), ("stop", "stops and backs up")] },
};

/// Additions of a phase to the one before.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Rules {
    /// Phase 2: turns to the right as well.
    pub turns_right: bool,
    /// Phase 3: doesn't drive forward if there is an obstacle directly ahead.
    pub looks_ahead: bool,
    /// Phase 4: doesn't turn to a side if there is an obstacle on that side alone.
    pub looks_aside: bool,
}

/// One of the motions to choose from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum MotionChoice {
    Forward,
    Left,
    Right,
}

/// The behaviour.
#[derive(Debug, Clone)]
pub(super) struct Options {
    rules: Rules,
    /// m.
    distance: f64,
    /// rad.
    angle: f64,
    pushes: bool,
    contact: Option<LastContact>,
    came: Option<Came>,
    /// Start of the present motion ahead, m ahead.
    since: Option<f64>,
    /// How far to back off after turning back to where it came from, m.
    retreat: Option<f64>,
}

/// The way by which the robot came to its present place: all that it knows of the floor there.
#[derive(Debug, Clone, Copy)]
struct Came {
    /// Way straight ahead, m.
    way: f64,
    /// Total turn at that time, rad.
    turned: f64,
}

impl Rules {
    /// Whether a drawn motion is allowed.
    fn allow(self, choice: MotionChoice, seen: SensedObstacles) -> bool {
        match choice {
            MotionChoice::Forward => !(self.looks_ahead && seen.ahead),
            MotionChoice::Left => !(self.looks_aside && seen.left && !seen.right),
            MotionChoice::Right => !(self.looks_aside && seen.right && !seen.left),
        }
    }
}

impl Options {
    /// With the parameters of `setup`.
    pub(super) fn new(setup: &Setup<'_>, rules: Rules) -> Self {
        Self {
            rules,
            distance: setup.params.number(DISTANCE.id) / 100.0,
            angle: setup.params.number(ANGLE.id).to_radians(),
            // Robots that look ahead don't push obstacles.
            pushes: !rules.looks_ahead && setup.params.choice(PUSHES.id) == "push",
            contact: None,
            came: None,
            since: None,
            retreat: None,
        }
    }

    /// Backs off from an edge. After a turn no ground behind is known, so it first turns back the way it came.
    fn leave_edge(&mut self, pilot: &mut Pilot, obstruction: Obstruction) {
        self.since = None;
        let came = self.came.take().filter(|_| pilot.way_back() < BACK_FROM_EDGE);
        let back = came.map(|came| (came.way, pilot.turned() - came.turned));
        match back.filter(|(_, turned)| turned.abs() < math::TAU) {
            None => turn_back(pilot, obstruction),
            Some((way, turned)) => {
                self.retreat = Some(way);
                pilot.answer(obstruction, BACK_FROM_EDGE, &[Move::Turn(-turned)]);
            }
        }
    }
}

impl Behaviour for Options {
    fn begin(&mut self, pilot: &mut Pilot) {
        pilot.turn_speed = pilot.robot.turn_wheel_speed;
        pilot.by = By::Counts;
        self.contact = None;
        (self.came, self.since, self.retreat) = (None, None, None);
    }

    fn roam(&mut self, pilot: &mut Pilot, sensed: &SensorReadings, _: f64) -> Drive {
        let turned = pilot.turned();
        if let Some(since) = self.since.take() {
            self.came = Some(Came { way: pilot.ahead() - since, turned });
        }
        if let Some(way) = self.retreat.take() {
            pilot.assume_way_back(way);
            let turn = leave(pilot, 1.0);
            pilot.go(&[Move::Back(way.min(BACK_FROM_EDGE)), turn]);
            return Drive::STOP;
        }
        self.contact = self.contact.filter(|contact| !contact.is_past(turned));
        let all = [MotionChoice::Forward, MotionChoice::Left, MotionChoice::Right];
        let choice = all[pilot.rng.random_range(0..if self.rules.turns_right { 3 } else { 2 })];
        // A motion that isn't allowed is drawn again at the next reading.
        if self.rules.allow(choice, SensedObstacles::of(sensed, self.contact)) {
            let step = match choice {
                MotionChoice::Forward => Move::Ahead(self.distance),
                MotionChoice::Left => Move::Turn(self.angle),
                MotionChoice::Right => Move::Turn(-self.angle),
            };
            self.since = (choice == MotionChoice::Forward).then(|| pilot.ahead());
            pilot.go(&[step]);
        }
        Drive::STOP
    }

    fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction) {
        // After an edge no obstacle is pushed: with slip the way back isn't known.
        self.pushes &= obstruction.kind != ObstructionKind::Cliff;
        if self.pushes && obstruction.kind == ObstructionKind::Bump && obstruction.side == ObstructionSide::Front {
            // The wheels slip, so their rolling isn't a distance.
            (self.came, self.since) = (None, None);
            return;
        }
        if obstruction.kind == ObstructionKind::Bump {
            (self.came, self.since) = (None, None);
            self.contact = Some(LastContact::of(obstruction, pilot.turned()));
            pilot.answer(obstruction, BACK, &[]);
        } else {
            self.leave_edge(pilot, obstruction);
        }
    }

    fn activity(&self) -> &'static str {
        "choosing a motion"
    }

    fn boxed_clone(&self) -> Box<dyn Behaviour> {
        Box::new(self.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 004, chapter 7: motions excluded by phases 3 and 4, by the positions of obstacles.
    #[test]
    fn each_phase_leaves_out_what_it_says() {
        let seen = |text: &str| SensedObstacles {
            ahead: text.contains('A'),
            in_path: text.contains('A'),
            left: text.contains('L'),
            right: text.contains('R'),
        };
        let phase_2 = Rules { turns_right: true, looks_ahead: false, looks_aside: false };
        let phase_3 = Rules { looks_ahead: true, ..phase_2 };
        let phase_4 = Rules { looks_aside: true, ..phase_3 };
        // Obstacles, and the allowed motions: forward, left, right.
        let table = [
            (phase_2, "ALR", "FLR"),
            (phase_3, "", "FLR"),
            (phase_3, "LR", "FLR"),
            (phase_3, "A", "LR"),
            (phase_3, "AL", "LR"),
            (phase_4, "", "FLR"),
            (phase_4, "A", "LR"),
            // "Detected solely in the direction of rotation".
            (phase_4, "L", "FR"),
            (phase_4, "AR", "L"),
            // "Obstacles are detected on both sides, the robot will continue to rotate".
            (phase_4, "LR", "FLR"),
            (phase_4, "ALR", "LR"),
        ];
        for (rules, obstacles, expected) in table {
            let all = [(MotionChoice::Forward, 'F'), (MotionChoice::Left, 'L'), (MotionChoice::Right, 'R')];
            let left = all.iter().filter(|(choice, _)| rules.allow(*choice, seen(obstacles)));
            assert_eq!(left.map(|(_, letter)| letter).collect::<String>(), expected, "{rules:?} {obstacles}");
        }
    }
}
