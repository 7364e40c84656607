//! Plans how a Roomba covers a room, and prints the walk and its numbers:
//! `cargo run -p coverage-planners --example plan_a_room -- [ROOM [PLANNER]]`

use coverage_planners::{
    Bounds, CoverageJob, Params, PlanContext, find,
    metrics::{DriveMetrics, WalkMetrics},
};
use robovac_core::{
    coverage::{PlanningGrid, ReachableFloor},
    floor_plan::room,
    robot::model,
};
use std::{env, error::Error};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = env::args().skip(1);
    let room = arguments.next().unwrap_or_else(|| "bedroom".to_owned());
    let planner = arguments.next().unwrap_or_else(|| "boustrophedon".to_owned());
    print!("{}", report(&room, &planner)?);
    Ok(())
}

/// The walk as a picture, with an arrow in every planning cell, and what it costs.
pub fn report(room_id: &str, planner_id: &str) -> Result<String, Box<dyn Error>> {
    let room = room(room_id).ok_or("no such room; see floor_plan::ROOMS")?;
    let robot = model("roomba600").ok_or("no such robot; see robot::MODELS")?;
    let planner = find(planner_id).ok_or("no such planner; see coverage_planners::PLANNERS")?;

    // The floor that the robot reaches, cut into planning cells.
    let floor = ReachableFloor::new(&(room.build)(), robot, None)?;
    let grid = PlanningGrid::new(&floor, robot.default_cell);
    let job = CoverageJob::on_planning_grid(&grid, &floor, robot);

    let path = planner.build(&Params::defaults(planner.params)).plan(&job, &mut PlanContext::new(1))?;
    path.check(&job)?;

    let walk = WalkMetrics::of(&job, &path);
    let drive = DriveMetrics::of(&floor, robot, &grid.polyline(&floor, &path.cells));
    let bound = Bounds::of(&job).cost;
    Ok(format!(
        "{} in {}, with a {}\n\n{}\n\
         cells     {} of {} visited, {} revisits\n\
         cost      {} (steps + 2 x quarter turns); no walk costs less than {bound}\n\
         driving   {:.1} m in {:.0} s; {:.1} % of the reachable floor swept\n",
        planner.title,
        room.title,
        robot.title,
        path.arrows(&job),
        walk.visited_cells,
        walk.reachable_cells,
        walk.revisits,
        walk.cost(),
        drive.length_m,
        drive.duration_s,
        100.0 * drive.coverage,
    ))
}
