//! Rooms, robots and runs.

use robovac_core::{
    coverage::ReachableFloor, floor_plan::FloorPlan, geometry::Pose, registry::Params, robot::RobotModel,
};
use robovac_sim::{
    Conditions, Noise, NoiseLevel, Run, RunSetup, SlipLevel, World,
    controller::{BehaviourInfo, Setup},
};
use std::sync::Arc;

/// Wheels and sensors at one level.
pub fn conditions(noise: NoiseLevel) -> Conditions {
    let slip = match noise {
        NoiseLevel::Off => SlipLevel::None,
        NoiseLevel::Typical => SlipLevel::Typical,
        NoiseLevel::Harsh => SlipLevel::Harsh,
    };
    Conditions { slip, noise: Noise::all(noise), ..Conditions::default() }
}

/// A room laid out for a robot; `None` where it doesn't fit.
pub fn lay_out(plan: &FloorPlan, robot: &RobotModel, conditions: Conditions) -> Option<RunSetup> {
    let floor = Arc::new(ReachableFloor::new(plan, robot, None).ok()?);
    Some(RunSetup { floor, world: Arc::new(World::new(plan)), robot: robot.clone(), conditions, seed: 0 })
}

/// A room laid out for a robot that starts near `start`.
pub fn lay_out_from(plan: &FloorPlan, robot: &RobotModel, conditions: Conditions, start: Pose) -> Option<RunSetup> {
    Some(starting_from(&lay_out(plan, robot, conditions)?, start))
}

/// The same room and robot, which starts near `start`.
pub fn starting_from(setup: &RunSetup, start: Pose) -> RunSetup {
    let mut floor = (*setup.floor).clone();
    floor.start = floor.place_for(start, |_| true);
    RunSetup { floor: Arc::new(floor), ..setup.clone() }
}

/// A run of `info` with `params` on a floor that is laid out.
pub fn run_with(setup: &RunSetup, info: &BehaviourInfo, params: &Params, seed: u64) -> Run {
    let controller = info.build(&Setup { robot: &setup.robot, params, seed }).expect("it is in the registry");
    Run::new(&RunSetup { seed, ..setup.clone() }, controller)
}

/// A run of `info` as it comes.
pub fn run(setup: &RunSetup, info: &BehaviourInfo, seed: u64) -> Run {
    run_with(setup, info, &Params::defaults(info.params), seed)
}

/// Lets minutes of simulated time pass.
pub fn drive(run: &mut Run, minutes: f64) {
    let end = run.time_s() + 60.0 * minutes;
    while run.time_s() < end && !run.is_finished() {
        run.step();
    }
}
