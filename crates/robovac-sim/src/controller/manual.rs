//! Manual mode: the user drives, and the interlock blocks unsafe commands (002, section IV.B).
//!
//! Hasan, Al-Nahid & Reza 2014: "as the user operates the robot by him in manual mode, some extra logics have to be developed.
//! Without such programming the robot may bump an obstacle badly or fall from stairs." Their Tables I and II say which of
//! four commands are allowed for what the bumper and the cliff sensors report: see [`interlock`].
//!
//! # Beyond the paper
//!
//! - *Brakes take a way.* The tables assume that the robot stops where a sensor detects an edge; in reality it stops
//!   nearer to it, where turning could bring a wheel over the edge. So it rolls back by that way and a little more, and
//!   doesn't drive ahead again until the stick has been let go.
//! - *No rear sensors.* Backward is always allowed by the tables, even down stairs. With the parameter for caution, the
//!   robot reverses only over known ground.
//!
//! ```
//! use robovac_sim::controller::*;
//! use robovac_core::{registry::Params, robot::*};
//! let info = find("manual").unwrap();
//! let (robot, params) = (model("dvr1").unwrap(), Params::defaults(info.params));
//! let mut manual = info.build(&Setup { robot, params: &params, seed: 1 }).unwrap();
//! manual.command(Joystick { forward: 1.0, left: 0.0 });
//! assert!(manual.step(&SensorReadings::default(), 0.015).left > 0.0);
//! let bump = SensorReadings { bump_left: true, ..SensorReadings::default() };
//! assert!(manual.step(&bump, 0.015).is_stop());
//! assert_eq!(manual.blocked().unwrap().left, Some("bumper pressed on the left"));
//! ```

use super::{
    BehaviourClaims, BehaviourInfo, BuildBehaviour, Joystick,
    interlock::{self, Blocked},
    parts::{Behaviour, By, Obstruction, ObstructionKind, Pilot, Reactive},
};
use robovac_core::{
    registry::{Example, Explainer, ParamKind, ParamSpec},
    robot::{Drive, SensorReadings},
};

pub(super) const INFO: BehaviourInfo = BehaviourInfo {
    id: "manual",
    title: "Manual",
    summary: "You drive; commands that would make the robot bump or fall are blocked.",
    claims: BehaviourClaims { manual: true, ..BehaviourClaims::NONE },
    params: &[ParamSpec {
        id: "careful",
        label: "Reverse only over known ground",
        help: "No sensor faces backwards: with this off, the robot may reverse anywhere, even down stairs.",
        kind: ParamKind::Flag { default: false },
    }],
};

/// Its explanation.
pub(super) const EXPLAINER: Explainer = Explainer {
    idea: "You drive with keys, a gamepad or the on-screen joystick. For every combination of bumper and cliff \
           sensors, two tables define which of forward, backward, left and right are allowed. Everything else is \
           blocked, with the reason shown.",
    complexity: "O(1) time and memory per step.",
    use_when: "To clean one spot, to get to know a robot and its sensors, or to see how hard complete coverage is.",
    shines: Example { room: "empty", why: "Lanes are long: there is little to steer." },
    fails: Example { room: "maze", why: "Narrow passages turn every few steps: you steer all the time." },
    source: "Hasan, Al-Nahid & Reza 2014, Path planning algorithm development for autonomous vacuum cleaner robots, ICIEV: \
             section IV.B, Tables I and II",
    link: "https://ieeexplore.ieee.org/document/6850799",
};

pub(super) const BUILD: BuildBehaviour = |setup| {
    let is_careful = setup.params.flag("careful");
    Reactive::boxed(
        setup,
        Manual {
            is_careful,
            command: Joystick::default(),
            blocked: Blocked::default(),
            held: None,
            has_recoiled: false,
            obeyed: Drive::STOP,
        },
    )
};

#[derive(Debug, Clone)]
struct Manual {
    is_careful: bool,
    command: Joystick,
    blocked: Blocked,
    /// Why it doesn't drive ahead until the stick is released.
    held: Option<&'static str>,
    /// Whether it has rolled back from the detected edge.
    has_recoiled: bool,
    obeyed: Drive,
}

impl Behaviour for Manual {
    fn begin(&mut self, pilot: &mut Pilot) {
        pilot.turn_speed = pilot.robot.turn_wheel_speed;
        pilot.by = By::Counts;
        self.held = None;
    }

    fn watch(&mut self, sensed: &SensorReadings, _: f64) {
        self.blocked = interlock::blocked(sensed);
        if self.command.forward <= 0.0 {
            self.held = None;
        }
        self.has_recoiled &= sensed.sees_cliff();
        self.blocked.forward = self.blocked.forward.or(self.held);
    }

    fn command(&mut self, command: Joystick) {
        self.command = command;
    }

    fn blocked(&self) -> Option<Blocked> {
        Some(self.blocked)
    }

    fn roam(&mut self, pilot: &mut Pilot, _: &SensorReadings, _: f64) -> Drive {
        if self.is_careful && !pilot.knows_way_back() && self.blocked.backward.is_none() {
            self.blocked.backward = Some("no rear sensor, and the ground behind is unknown");
        }
        let Joystick { forward, left } = self.blocked.allowed().cut(self.command);
        self.obeyed = if self.is_careful && forward < 0.0 {
            pilot.retreat(-forward)
        } else {
            pilot.twist(forward * pilot.speed, left * pilot.robot.turn_rate())
        };
        self.obeyed
    }

    fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction) {
        if obstruction.kind == ObstructionKind::Cliff && !self.has_recoiled {
            self.has_recoiled = true;
            self.held = self.blocked.forward.or(Some("no floor in front"));
            pilot.answer(obstruction, 0.0, &[]);
        }
    }

    fn activity(&self) -> &'static str {
        let Drive { left, right, .. } = self.obeyed;
        match left + right {
            sum if sum > 1e-9 => "driving forward on command",
            sum if sum < -1e-9 => "reversing on command",
            _ if right > left => "turning left on command",
            _ if right < left => "turning right on command",
            _ => "waiting for your command",
        }
    }

    fn boxed_clone(&self) -> Box<dyn Behaviour> {
        Box::new(self.clone())
    }
}
