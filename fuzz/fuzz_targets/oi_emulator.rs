//! Whatever a robot is told, at whatever rate: no panic, and in Off it stands still unless it cleans by itself.
#![no_main]

use libfuzzer_sys::fuzz_target;
use robovac_core::{coverage::ReachableFloor, floor_plan::Sketch, robot::{RobotPort, model}};
use roomba_oi::Mode;
use robovac_link::emulator::{Emulator, PERSONALITIES};
use robovac_sim::{Conditions, RunSetup, World};
use std::sync::{Arc, OnceLock};

fn setup() -> Option<RunSetup> {
    let plan = Sketch::open(2.0, 2.0, 0.05).start(1.0, 1.0, 0.0).finish("", "");
    let robot = model("roomba600")?.clone();
    let floor = Arc::new(ReachableFloor::new(&plan, &robot, None).ok()?);
    Some(RunSetup { floor, world: Arc::new(World::new(&plan)), robot, conditions: Conditions::default(), seed: 1 })
}

fuzz_target!(|input: (u8, u8, &[u8])| {
    static SETUP: OnceLock<Option<RunSetup>> = OnceLock::new();
    let Some(setup) = SETUP.get_or_init(setup) else { return };
    let (who, cut, bytes) = input;
    let mut robot = Emulator::new(setup, &PERSONALITIES[usize::from(who) % PERSONALITIES.len()]);
    let mut sent = Vec::new();
    for piece in bytes.chunks(usize::from(cut) + 1) {
        robot.receive(piece, 115_200);
        robot.advance(0.05);
        robot.transmit(115_200, &mut sent);
        let pose = robot.pose();
        assert!(pose.x.is_finite() && (0.0..2.0).contains(&pose.x) && (0.0..2.0).contains(&pose.y), "{pose}");
    }
    // Fills up whatever was cut, then stops; a second for the brakes.
    robot.receive(&[0; 600], 115_200);
    robot.advance(0.1);
    robot.receive(&[128, 173], 115_200);
    robot.advance(1.0);
    // Ending the interface doesn't end what it does by itself.
    if robot.mode() == Mode::Off && !robot.runs_builtin_program() {
        let pose = robot.pose();
        robot.advance(0.5);
        assert_eq!(robot.pose(), pose);
    }
    let _ = robot.sensors();
    let _ = robot.robot().sensors();
});
