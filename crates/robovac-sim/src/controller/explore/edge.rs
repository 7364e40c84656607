//! Phase 6: edge following (004, chapter 7 and section 7.1).
//!
//! Krapinec 2025 prints this phase as code: a timer calls `move_to_empty_space` every 0.1 s, which looks at the bumper and
//! the six bits of the light bumper and rotates at 0.5 rad/s or moves forward at 0.1 m/s. When the bumper meets something,
//! the robot rotates until only the outer light sensor on that side sees it, and goes along it. Where the edge ends, it goes
//! around the end in three steps: 10 movements forward, 15 rotations, and a zig-zag. Where it can't get out of a rotation,
//! it gives the obstacle up after a random number of rotations, between 100 and 200, and goes straight on.
//!
//! The rules, and where the print errs, are in [`edge_machine`](super::edge_machine).
//!
//! # Where the thesis is silent
//!
//! - *Edges of the floor and virtual walls*: the robot backs off as all behaviours here do, turns away by a random
//!   angle, and starts again.
//! - *Robots that are held*, between the legs of a chair for one, would push for ever. With the rules as intended, one whose bumper
//!   has been pressed for 5 s backs off, turns by a random angle and starts again.
//! - *Robots without a light bumper* report no light. They find out what they follow by the bumper alone and lose it at once:
//!   all that is left is the random rotation.
//!
//! ```
//! use robovac_sim::controller::*;
//! use robovac_core::{registry::Params, robot::*};
//! let info = find("explore_edge").unwrap();
//! let (robot, params) = (model("roomba600").unwrap(), Params::defaults(info.params));
//! let mut explorer = info.build(&Setup { robot, params: &params, seed: 1 }).unwrap();
//! let ahead = (0..7).map(|_| explorer.step(&SensorReadings::default(), 0.015)).last().unwrap();
//! assert_eq!(ahead, Drive::wheels(0.1, 0.1));
//! // A bump on the right: it rotates to the left until only the right light sensor sees the wall.
//! let bump = SensorReadings { bump_right: true, ..SensorReadings::default() };
//! let turning = (0..20).map(|_| explorer.step(&bump, 0.015)).last().unwrap();
//! assert!(turning.left < 0.0 && turning.right > 0.0);
//! let beside = SensorReadings { light_bumper: [false, false, false, false, false, true], ..SensorReadings::default() };
//! let along = (0..20).map(|_| explorer.step(&beside, 0.015)).last().unwrap();
//! assert_eq!((along, explorer.activity()), (Drive::wheels(0.1, 0.1), "following the edge on its right"));
//! ```

use super::{
    THESIS,
    edge_machine::{EdgeMachine, STUCK, ThesisText, Twist},
    position::Position,
    turn_back,
};
use crate::controller::{
    BehaviourClaims, BehaviourInfo, BuildBehaviour,
    parts::{Behaviour, By, Move, Obstruction, ObstructionKind, Pilot, Reactive},
};
use rand::RngExt;
use robovac_core::{
    registry::{Example, Explainer, ParamKind, ParamSpec},
    robot::{Drive, SensorReadings},
};

/// `timer_period`, s.
const PERIOD_S: f64 = 0.1;
/// How long the driver holds a command, s.
const LATCH_S: f64 = 0.2;
/// How long the bumper is pressed until the robot counts as held, s; its way back then, m, and the turn away, rad (ours).
const HELD_S: f64 = 5.0;
const BACK: f64 = 0.1;
const LEAVE: (f64, f64) = (1.2, 2.6);

pub(in crate::controller) const INFO: BehaviourInfo = BehaviourInfo {
    id: "explore_edge",
    title: "Edge following",
    summary: "Finds an obstacle, turns alongside it and follows it round its ends, by the thesis' printed rules.",
    claims: BehaviourClaims { explores: true, ..BehaviourClaims::NONE },
    params: &[
        ParamSpec {
            id: "text",
            label: "Rules",
            help: "The thesis' code and text differ: the zig-zag turns right as in the code, or towards the edge.",
            kind: ParamKind::Choice { options: &[("mended", "as intended"), ("printed", "as printed")] },
        },
        ParamSpec {
            id: "speed",
            label: "Speed",
            help: "Forward speed; 10 cm/s in the thesis.",
            kind: ParamKind::Number { min: 5.0, max: 25.0, step: 1.0, default: 10.0, unit: "cm/s" },
        },
        ParamSpec {
            id: "turn",
            label: "Turn rate",
            help: "Turn rate of rotations; 0.5 rad/s in the thesis.",
            kind: ParamKind::Number { min: 0.2, max: 1.5, step: 0.1, default: 0.5, unit: "rad/s" },
        },
    ],
};

/// Its explanation.
pub(in crate::controller) const EXPLAINER: Explainer = Explainer {
    idea: "The robot drives forward until its bumper is pressed, and rotates until only the outer light sensor on that \
           side detects the obstacle. Then it follows the edge; where that ends, it continues for a fixed distance, \
           rotates towards the edge, and searches in a zig-zag. If a rotation doesn't end, it abandons the edge after \
           a random time and drives straight on.",
    complexity: "O(1) time and memory per call, ten calls a second; it stores two sides, two counters, a step and \
        a random number.",
    use_when: "To map the border of a room with a light bumper. Slow, and circles free-standing furniture for \
        ever.",
    shines: Example { room: "maze", why: "A maze is one long wall, which it follows into every branch." },
    fails: Example { room: "flat", why: "It circles the piece of furniture that it meets first." },
    source: "Krapinec 2025, Enhancing Robotic Vacuum Cleaner Performance through Improved Map Building, master's thesis, \
             FER Zagreb: chapter 7, phase 6, and section 7.1, move_to_empty_space",
    link: THESIS,
};

pub(in crate::controller) const BUILD: BuildBehaviour = |setup| {
    let text = if setup.params.choice("text") == "printed" { ThesisText::Printed } else { ThesisText::Mended };
    let speeds = (setup.params.number("speed") / 100.0, setup.params.number("turn"));
    Reactive::boxed(
        setup,
        EdgeBehaviour { machine: EdgeMachine::new(text), speeds, since_call: 0.0, latched: None, pressed_s: 0.0 },
    )
};

/// The behaviour.
#[derive(Debug, Clone)]
struct EdgeBehaviour {
    machine: EdgeMachine,
    /// m/s and rad/s.
    speeds: (f64, f64),
    /// Since the timer last called, s.
    since_call: f64,
    /// The last command, and how long ago it was given, s.
    latched: Option<(Twist, f64)>,
    /// For how long the bumper has been pressed, s.
    pressed_s: f64,
}

impl EdgeBehaviour {
    /// Resets the state.
    fn restart(&mut self) {
        self.machine = EdgeMachine::new(self.machine.text);
        (self.since_call, self.pressed_s) = (0.0, 0.0);
        self.latched = None;
    }
}

impl Behaviour for EdgeBehaviour {
    fn begin(&mut self, pilot: &mut Pilot) {
        pilot.turn_speed = pilot.robot.turn_wheel_speed;
        pilot.by = By::Counts;
        self.restart();
    }

    fn roam(&mut self, pilot: &mut Pilot, sensed: &SensorReadings, dt_s: f64) -> Drive {
        self.pressed_s = if sensed.bumped() { self.pressed_s + dt_s } else { 0.0 };
        if self.pressed_s > HELD_S && self.machine.text == ThesisText::Mended {
            let way = if pilot.rng.random_bool(0.5) { 1.0 } else { -1.0 };
            let turn = way * pilot.rng.random_range(LEAVE.0..LEAVE.1);
            pilot.go(&[Move::Back(BACK), Move::Turn(turn)]);
            self.restart();
            return Drive::STOP;
        }
        self.since_call += dt_s;
        self.latched = self.latched.map(|(twist, age)| (twist, age + dt_s)).filter(|(_, age)| *age < LATCH_S);
        // The sum of many short times is a little off.
        if self.since_call > PERIOD_S - 1e-9 {
            self.since_call = (self.since_call - PERIOD_S).clamp(0.0, PERIOD_S);
            let told = self.machine.call(sensed, || pilot.rng.random_range(STUCK.0..=STUCK.1));
            self.latched = told.map(|twist| (twist, 0.0)).or(self.latched);
        }
        let (speed, turn) = (self.speeds.0.min(pilot.speed), self.speeds.1);
        match self.latched {
            None => Drive::STOP,
            Some((Twist::Left, _)) => pilot.twist(0.0, turn),
            Some((Twist::Right, _)) => pilot.twist(0.0, -turn),
            Some((Twist::Forward, _)) => pilot.twist(speed, 0.0),
        }
    }

    fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction) {
        // The rules handle bumps.
        if obstruction.kind != ObstructionKind::Bump {
            turn_back(pilot, obstruction);
            self.restart();
        }
    }

    fn activity(&self) -> &'static str {
        match (self.machine.edge_detected, self.machine.rotation.position, self.machine.obstacle) {
            (1..=3, ..) => "going around the end of an edge",
            (_, Position::Left, _) => "turning left along an edge",
            (_, Position::Right, _) => "turning right along an edge",
            (.., Position::Left) => "following the edge on its left",
            (.., Position::Right) => "following the edge on its right",
            (.., Position::None) => "searching for an obstacle",
        }
    }

    fn boxed_clone(&self) -> Box<dyn Behaviour> {
        Box::new(self.clone())
    }
}
