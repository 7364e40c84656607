//! Table 2 of the thesis on the improved snake algorithm (Emu & Obaida 2020, section 5) beside the results of the
//! planners here in a room of as many cells. The room itself is lost, so only the order of the rows can be compared.
//!
//! `cargo run --release --example thesis_table`

use coverage_planners::{PLANNERS, find};
use robovac_app::compare::{PrintedRow, TABLE_2, TABLE_2_ROOM};
use robovac_core::{floor_plan::room, registry::Params};
use robovac_sim::experiment::planning::{CELL_ROBOT, Placement, PlanningTask, choose_robot};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    println!("| algorithm, as printed | turns | revisits | length, m | planner here | turns | revisits | length, m |");
    println!("|---|---|---|---|---|---|---|---|");
    for row in TABLE_2 {
        let PrintedRow { algorithm, turns, revisits, length_m, planner } = row;
        println!("| {algorithm} | {turns} | {revisits} | {length_m:.1} | {}", measured(planner)?);
    }
    for info in PLANNERS.iter().filter(|info| !info.is_in_metres() && TABLE_2.iter().all(|row| row.planner != info.id))
    {
        println!("| - | | | | {}", measured(info.id)?);
    }
    Ok(())
}

/// The rest of a row: the planner's result in the room, empty if there is none of that id.
fn measured(id: &str) -> Result<String, Box<dyn Error>> {
    let Some(planner) = find(id) else { return Ok("- | | | |".to_owned()) };
    let plan = room(TABLE_2_ROOM).map(|info| (info.build)()).ok_or("the room is gone")?;
    let (robot, cell_size) = choose_robot(CELL_ROBOT, &plan, None).ok_or("the robot is gone")?;
    let params = Params::defaults(planner.params);
    let placement = Placement { plan, robot, cells: cell_size.into(), start: None, heading_deg: None };
    let task = PlanningTask { placement, planner, params, seed: 1, is_rounded: false };
    let planned = task.solve(|| 0.0, None)?.planned;
    // The thesis counts a reversal as one turn.
    let walk = planned.walk.ok_or("it isn't a walk")?;
    let (turns, revisits) = (walk.direction_changes, walk.revisits);
    Ok(format!("{id} | {turns} | {revisits} | {:.1} |", planned.drive.length_m))
}
