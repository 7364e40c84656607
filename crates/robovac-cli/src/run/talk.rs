//! What is said with a program: the greeting, then readings and commands, or a grid and a walk.

use super::{
    child::{ProgramProcess, Task},
    protocol::{PROTOCOL, Reply, Words},
};
use robovac_core::grid::Cell;
use robovac_sim::{
    STEP_S,
    program::{Lockstep, LogEnd, ProgramRoom, RobotFacts},
};
use serde_json::json;

/// Most lines that a program prints in a run.
const MOST_PRINTS: usize = 10_000;
/// Most cells of a plan.
const MOST_CELLS: usize = 2_000_000;

/// What a program has printed: time, s, and text.
pub type Prints = Vec<(f64, String)>;

/// The host's first line. `holds`: whether the robot can keep a command for many steps, see [`Reply::hold`].
pub fn hello(robot: &RobotFacts, seed: u64, holds: bool) -> String {
    let mut line = json!({ "robovac": PROTOCOL, "kind": "hello", "robot": robot, "dt": STEP_S, "seed": seed });
    if holds {
        line["holds"] = true.into();
    }
    line.to_string()
}

/// Greets; whether the program drives. Else it plans.
pub fn greet(process: &mut ProgramProcess, robot: &RobotFacts, seed: u64) -> Result<bool, String> {
    let reply = process.ask(&hello(robot, seed, true), Task::Start)?;
    match reply.ready.as_deref() {
        Some("behaviour") => Ok(true),
        Some("planner") => Ok(false),
        _ => Err("the program must answer the greeting with {\"ready\": \"behaviour\"} or {\"ready\": \"planner\"}"
            .to_owned()),
    }
}

/// Lets a program drive for `most_steps`. Returns why it ended: `done`, `time`, `battery`.
pub fn drive(
    process: &mut ProgramProcess,
    lockstep: &mut Lockstep,
    most_steps: u64,
    prints: &mut Prints,
) -> Result<&'static str, String> {
    let (mut scan, mut speeds) = (0, [0.0; 2]);
    while lockstep.run().steps() < most_steps {
        let time_s = lockstep.run().time_s();
        let line = lockstep.readings_json(lockstep.scan() != scan);
        scan = lockstep.scan();
        let told = |fault: String| format!("at {time_s:.2} s: {fault}");
        let reply = process.ask(&line, Task::Step).map_err(told)?;
        take_prints(prints, time_s, &reply).map_err(told)?;
        speeds = [reply.left.unwrap_or(speeds[0]), reply.right.unwrap_or(speeds[1])];
        if reply.done {
            lockstep.finish(LogEnd::Done);
            return Ok("done");
        }
        let most = u64::from(reply.hold).saturating_add(1).min(most_steps - lockstep.run().steps());
        if lockstep.hold(speeds, most as u32) == 0 {
            return Ok("battery");
        }
    }
    Ok("time")
}

/// The walk that a program plans in a room.
pub fn plan(process: &mut ProgramProcess, room: &ProgramRoom, prints: &mut Prints) -> Result<Vec<Cell>, String> {
    let mut cells = Vec::new();
    let mut reply = process.ask(&json!({ "room": room }).to_string(), Task::Plan)?;
    loop {
        take_prints(prints, 0.0, &reply)?;
        // A number that is no cell's stays one that is none.
        let index = |value: i64| i32::try_from(value).unwrap_or(i32::MAX);
        cells.extend(reply.cells.iter().map(|&[x, y]| Cell::new(index(x), index(y))));
        if cells.len() > MOST_CELLS {
            return Err(format!("the plan has more than {MOST_CELLS} cells; does it go in circles?"));
        }
        if reply.done {
            return Ok(cells);
        }
        reply = process.next(Task::Plan)?;
    }
}

fn take_prints(prints: &mut Prints, time_s: f64, reply: &Reply) -> Result<(), String> {
    prints.extend(reply.print.iter().map(|text| (time_s, Words::of(text.as_bytes()))));
    if prints.len() > MOST_PRINTS {
        return Err(format!("the program printed more than {MOST_PRINTS} lines; print less"));
    }
    Ok(())
}
