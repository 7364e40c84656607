//! Followers of planned paths avoid edges, even if the wheels slip and the estimated pose is wrong.

use super::{stairs::rooms, support::conditions};
use robovac_core::{
    registry::Params,
    robot::{MODELS, OdometryModel},
};
use robovac_sim::{
    NoiseLevel,
    experiment::planning::{PlanRequest, Planned, RoomSetup},
};

fn nobody_falls(seeds: u64) {
    let planner = coverage_planners::find("boustrophedon").unwrap();
    let (mut runs, mut edges) = (0, 0);
    for plan in rooms() {
        for robot in MODELS.iter().filter(|robot| robot.sensors.cliffs.iter().any(Option::is_some)) {
            let Ok(prepared) = RoomSetup::new(&plan, robot, robot.default_cell, None) else { continue };
            let (params, job) = (Params::defaults(planner.params), prepared.job.clone());
            let answer = PlanRequest { id: 0, planner, params, seed: 0, job }.serve(|| 0.0, None).unwrap();
            let planned = Planned::new(&prepared, &answer).unwrap();
            for seed in 0..seeds {
                // The worst wheels: no room stays where the robot believes it to be.
                let mut run = planned.run(&prepared, conditions(NoiseLevel::Harsh), OdometryModel::Arc, seed);
                let mut saw = false;
                while !run.is_finished() {
                    run.step();
                    edges += u64::from(run.sensors().sees_cliff() && !saw);
                    saw = run.sensors().sees_cliff();
                    assert!(!run.has_fallen(), "{} {} seed {seed} at {:.1} s", plan.name, robot.id, run.time_s());
                }
                runs += 1;
            }
        }
    }
    assert!(runs > 2 * seeds && edges > 2 * seeds, "{runs} runs with {edges} edges");
}

// slow: whole plans with the worst wheels, in every room with stairs
#[test]
fn nobody_falls_off_a_planned_path() {
    nobody_falls(3);
}

#[test]
#[ignore = "soak: many seeds"]
fn nobody_falls_off_a_planned_path_with_many_seeds() {
    nobody_falls(100);
}
