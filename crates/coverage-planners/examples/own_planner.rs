//! A planner defined outside the crate, tested like those of the registry and compared with two of them.
//! `cargo run -p coverage-planners --example own_planner`

use coverage_planners::{
    CoverageJob, CoveragePath, Params, PlanContext, PlanError, Planner, find, metrics::WalkMetrics,
};
use robovac_core::{
    coverage::{PlanningGrid, ReachableFloor},
    floor_plan::room,
    robot::model,
};
use std::{error::Error, fmt::Write, ops::ControlFlow};

/// Depth-first search: to a new neighbour, straight ahead if possible; at a dead end, back the way it came.
struct DepthFirst;

impl Planner for DepthFirst {
    fn plan(&self, job: &CoverageJob, ctx: &mut PlanContext<'_>) -> Result<CoveragePath, PlanError> {
        let (cells, mut found) = (job.cells(), 1);
        let (mut at, mut heading) = (job.start, job.heading);
        let (mut walk, mut way_back) = (vec![at], Vec::new());
        let mut is_new = job.free.clone();
        is_new[at] = false;
        while found < cells {
            // Progress, and the chance to cancel.
            ctx.checkpoint(found as f64 / cells as f64, &walk)?;
            let turns = [heading, heading.left(), heading.right(), heading.opposite()];
            if let Some(next) = turns.into_iter().find(|&turn| is_new.is_set(at.step(turn))) {
                way_back.push(at);
                (at, heading) = (at.step(next), next);
                is_new[at] = false;
                found += 1;
            } else {
                let Some(before) = way_back.pop() else { break };
                heading = at.direction_to(before).unwrap_or(heading);
                at = before;
            }
            walk.push(at);
        }
        Ok(CoveragePath::walk(walk))
    }
}

/// The checks that the contract tests make of a complete, deterministic planner.
fn check(planner: &dyn Planner, job: &CoverageJob) -> Result<WalkMetrics, Box<dyn Error>> {
    let path = planner.plan(job, &mut PlanContext::new(1))?;
    path.check(job)?;
    let walk = WalkMetrics::of(job, &path);
    if walk.visited_cells < walk.reachable_cells {
        return Err(format!("{} cells are not covered", walk.reachable_cells - walk.visited_cells).into());
    }
    if planner.plan(job, &mut PlanContext::new(2))? != path {
        return Err("the walk depends on the seed".into());
    }
    let cancelled = planner.plan(job, &mut PlanContext::observed(1, &mut |_| ControlFlow::Break(())));
    if job.cells() > 1 && cancelled != Err(PlanError::Cancelled) {
        return Err("planning can't be cancelled".into());
    }
    Ok(walk)
}

fn main() -> Result<(), Box<dyn Error>> {
    print!("{}", report()?);
    Ok(())
}

/// Costs in some rooms: steps + 2 × quarter turns.
pub fn report() -> Result<String, Box<dyn Error>> {
    let robot = model("roomba600").ok_or("no such robot")?;
    let peers = ["boustrophedon", "snake"].map(find).into_iter().flatten().collect::<Vec<_>>();
    let mut table = format!("{:<24} {:>15} {:>15} {:>15}\n", "Cost", "depth_first", "boustrophedon", "snake");
    for room in ["bedroom", "kitchen", "living", "maze"].into_iter().filter_map(room) {
        let floor = ReachableFloor::new(&(room.build)(), robot, None)?;
        let grid = PlanningGrid::new(&floor, robot.default_cell);
        let job = CoverageJob::on_planning_grid(&grid, &floor, robot);
        let own = check(&DepthFirst, &job).map_err(|error| format!("in {}: {error}", room.title))?;
        write!(table, "{:<24} {:>15}", room.title, own.cost())?;
        for peer in &peers {
            let path = peer.build(&Params::defaults(peer.params)).plan(&job, &mut PlanContext::new(1))?;
            write!(table, " {:>15}", WalkMetrics::of(&job, &path).cost())?;
        }
        table.push('\n');
    }
    Ok(table)
}
