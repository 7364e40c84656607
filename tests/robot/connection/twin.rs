//! Twins of virtual robots whose wheels, bumpers and floors differ from the model by seed.

use super::wire::{Wire, roomba};
use robovac_core::{
    coverage::ReachableFloor,
    floor_plan::Sketch,
    geometry::difference,
    math::PI,
    rng::{normal, seeded},
    robot::{LightBumper, LightLaw, RobotModel, SensorSuite},
};
use robovac_link::{
    connection::{Calibration, LineRecording, Request},
    emulator::{Personality, personality},
    twin::{TwinError, TwinFit},
};
use robovac_sim::{Conditions, Noise, NoiseLevel, RunSetup, SlipLevel, World};
use std::sync::Arc;

/// A robot that isn't quite the model, on a floor.
struct Odd {
    robot: RobotModel,
    who: Personality,
    conditions: Conditions,
}

impl Odd {
    /// Wheels, base, acceleration and light of this robot.
    fn new(wheel: f64, base: f64, acceleration: f64, law: LightLaw) -> Self {
        let model = roomba();
        let light = LightBumper { law, ..model.sensors.light_bumper.unwrap() };
        let robot = RobotModel {
            counts_per_metre: model.counts_per_metre / wheel,
            wheel_base: base * model.wheel_base,
            sensors: SensorSuite { light_bumper: Some(light), ..model.sensors },
            ..model
        };
        let who = Personality { acceleration, ..personality("model").unwrap().clone() };
        Self { robot, who, conditions: Conditions::default() }
    }

    /// The robot number `seed`.
    fn of(seed: u64) -> Self {
        let mut rng = seeded(seed, 77);
        let mut about = |value: f64, share: f64| value * (1.0 + share * normal(&mut rng).clamp(-2.0, 2.0));
        let law = LightLaw { gain_m2: about(5.8, 0.15), offset_m: about(0.017, 0.2) };
        Self::new(about(1.02, 0.01), about(1.03, 0.01), about(1.3, 0.2), law)
    }

    fn wire(&self, seed: u64) -> Wire {
        let plan = Sketch::open(4.0, 3.0, 0.05).start(0.3, 1.5, 0.0).finish("Room", "");
        let floor = Arc::new(ReachableFloor::new(&plan, &self.robot, None).unwrap());
        let (robot, conditions) = (self.robot.clone(), self.conditions);
        let setup = RunSetup { floor, world: Arc::new(World::new(&plan)), robot, conditions, seed };
        let mut wire = Wire::with(&setup, &self.who);
        wire.connect();
        wire.arm();
        wire
    }

    /// The recording that docs/real-robot.md asks for: turns beside a wall, a measured metre, walls met head-on.
    fn recorded(&self, seed: u64, turns: f64) -> LineRecording {
        let mut wire = self.wire(seed);
        let started = wire.now;
        roll(&mut wire, -200, 200);
        let turn_s = PI * self.robot.wheel_base / 0.2;
        wire.pass(turns * turn_s);
        face(&mut wire, 0.0);
        for _ in 0..2 {
            let before = wire.pose();
            wire.ask(Request::Calibrate { what: Calibration::Metre });
            wire.pass_until(60.0, |wire| wire.view().calibration.step != "moving");
            // As read off a tape.
            let value = (200.0 * (wire.pose().position() - before.position()).norm()).round() / 200.0;
            wire.ask(Request::Answer { value });
        }
        for _ in 0..4 {
            face(&mut wire, 0.0);
            roll(&mut wire, 250, 250);
            wire.pass_until(20.0, |wire| wire.bumped());
            roll(&mut wire, 0, 0);
            wire.pass(0.5);
            roll(&mut wire, -300, -300);
            wire.pass(1.0);
            roll(&mut wire, 0, 0);
            wire.pass(0.5);
        }
        assert!(wire.now - started < 200.0);
        LineRecording::parse(&wire.link.recording()).unwrap()
    }
}

/// Wheel speeds from the console.
fn roll(wire: &mut Wire, left: i16, right: i16) {
    let [[rh, rl], [lh, ll]] = [right, left].map(i16::to_be_bytes);
    wire.ask(Request::Raw { bytes: vec![145, rh, rl, lh, ll] });
}

/// Turns on the spot until it faces a direction, as a person sees it.
fn face(wire: &mut Wire, heading: f64) {
    while difference(wire.pose().heading, heading).abs() > 0.02 {
        let speed = if difference(wire.pose().heading, heading) > 0.0 { 30 } else { -30 };
        roll(wire, -speed, speed);
        wire.pass(0.02);
    }
    roll(wire, 0, 0);
    wire.pass(0.3);
}

#[test]
fn a_twin_has_the_figures_of_its_robot_and_predicts_it_better_than_the_model() {
    // slow: two minutes of driving, recorded twice, for each robot
    for seed in 1..=2 {
        let mut odd = Odd::of(seed);
        odd.conditions.noise = Noise::all(NoiseLevel::Typical);
        let fit = TwinFit::of(odd.recorded(seed, 4.6)).unwrap();
        let file = fit.file();
        for figure in &file.figures {
            println!("{seed} {figure:?}");
        }
        let twin = file.twin;
        println!("true: {} {} {}", 1000.0/odd.robot.counts_per_metre, 1000.0*odd.robot.wheel_base, odd.who.acceleration);
        for p in fit.check(odd.recorded(seed + 10, 2.4)).unwrap() {
            println!("{seed} {p:?}");
        }
    }
}
