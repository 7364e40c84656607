//! Simulates a Roomba with wheel slip in a room, by a plan and by a behaviour, and measures both over several seeds:
//! `cargo run --release -p robovac-sim --example simulate_and_measure -- [MINUTES [RUNS]]`

use coverage_planners::{PlanContext, find};
use robovac_core::{
    floor_plan::room,
    registry::Params,
    robot::{OdometryModel, model},
};
use robovac_sim::{Conditions, Run, SlipLevel, controller, experiment::RoomSetup, montecarlo::quantile};
use std::{env, error::Error, fmt::Write};

fn main() -> Result<(), Box<dyn Error>> {
    let mut numbers = env::args().skip(1).map(|number| number.parse());
    let minutes = numbers.next().transpose()?.unwrap_or(15);
    let runs = numbers.next().transpose()?.unwrap_or(5);
    print!("{}", report(minutes, runs)?);
    Ok(())
}

/// A line for each run, and the median coverage of each algorithm.
pub fn report(minutes: u64, runs: u64) -> Result<String, Box<dyn Error>> {
    let plan = (room("bedroom").ok_or("no such room")?.build)();
    let robot = model("roomba600").ok_or("no such robot")?;
    let setup = RoomSetup::new(&plan, robot, robot.default_cell, None)?;
    let conditions = Conditions { slip: SlipLevel::Typical, ..Conditions::default() };

    let planner = find("boustrophedon").ok_or("no such planner")?;
    let path = planner.build(&Params::defaults(planner.params)).plan(&setup.job, &mut PlanContext::new(1))?;
    let line = setup.planning_grid.polyline(&setup.floor, &path.cells).into();
    let behaviour = controller::find("random_walk").ok_or("no such behaviour")?;
    let params = Params::defaults(behaviour.params);

    let mut text = format!("{:<14} {:>4} {:>8} {:>8} {:>6} {:>6}\n", "", "seed", "min", "covered", "m", "bumps");
    for algorithm in [planner.id, behaviour.id] {
        let mut covered = Vec::new();
        for seed in 1..=runs {
            let run = if algorithm == planner.id {
                Some(setup.run_along(&line, conditions, OdometryModel::Arc, seed))
            } else {
                setup.run_behaviour(behaviour, &params, conditions, seed)
            };
            let run = drive(run.ok_or("the behaviour isn't in the registry")?, 60.0 * minutes as f64);
            let (time, coverage) = (run.time_s() / 60.0, 100.0 * run.coverage());
            let (metres, bumps) = (run.distance_m(), run.bumps());
            writeln!(text, "{algorithm:<14} {seed:>4} {time:>8.1} {coverage:>6.1} % {metres:>6.0} {bumps:>6}")?;
            covered.push(coverage);
        }
        covered.sort_by(f64::total_cmp);
        writeln!(text, "{algorithm:<14} median coverage: {:.1} %", quantile(&covered, 0.5).unwrap_or_default())?;
    }
    Ok(text)
}

/// Continues a run to its end, or for `seconds` of simulated time.
fn drive(mut run: Run, seconds: f64) -> Run {
    while !run.is_finished() && run.time_s() < seconds {
        run.step();
    }
    run
}
