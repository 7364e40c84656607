//! What is said with a program: the greeting, then readings and commands, or a grid and a walk.

use super::{
    child::{ProgramProcess, WaitFor},
    protocol::{PROTOCOL, Words},
};
use robovac_core::grid::Cell;
use robovac_sim::{
    STEP_S,
    montecarlo::ProgramRun,
    program::{LogEnd, ProgramRoom, RobotFacts, layout_json},
};
use serde_json::{Value, json};

/// Most lines that a program prints in a run.
const MOST_PRINTS: usize = 10_000;
/// Most cells of a plan.
const MOST_CELLS: usize = 2_000_000;

/// What a program has printed: time, s, and text.
pub type Prints = Vec<(f64, String)>;

/// The host's first line. `holds`: whether the robot can keep a command for many steps, see [`Reply::hold`](super::protocol::Reply::hold).
pub fn hello(robot: &RobotFacts, seed: u64, holds: bool) -> String {
    greeting(robot, seed, holds).to_string()
}

fn greeting(robot: &RobotFacts, seed: u64, holds: bool) -> Value {
    let mut line = json!({ "robovac": PROTOCOL, "kind": "hello", "robot": robot, "dt": STEP_S, "seed": seed });
    if holds {
        line["holds"] = true.into();
    }
    line
}

/// What a program is, and how it wants its readings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ready {
    /// It plans.
    Plans,
    /// It drives the run of the first seed, by lines.
    Drives,
    /// It drives the runs of all seeds, by frames; see [`drive_framed`](super::drive_framed).
    DrivesFramed,
}

/// Greets, and offers to drive the runs of all these `seeds` by frames.
pub fn greet(
    process: &mut ProgramProcess,
    robot: &RobotFacts,
    seeds: &[u64],
    prints: &mut Prints,
) -> Result<Ready, String> {
    let mut line = greeting(robot, seeds.first().copied().unwrap_or_default(), true);
    let layout: Value = serde_json::from_str(&layout_json()).unwrap_or_default();
    line["frames"] = json!({ "seeds": seeds, "layout": layout });
    let reply = process.ask(&line.to_string(), WaitFor::Start)?;
    add_prints(prints, 0.0, &reply.print)?;
    match reply.ready.as_deref() {
        Some("behaviour") if reply.frames => Ok(Ready::DrivesFramed),
        Some("behaviour") => Ok(Ready::Drives),
        Some("planner") => Ok(Ready::Plans),
        _ => Err("the program must answer the greeting with {\"ready\": \"behaviour\"} or {\"ready\": \"planner\"}"
            .to_owned()),
    }
}

/// Lets a program drive until the run's time is over. Returns why it ended: `done`, `time`, `battery`.
pub fn drive(process: &mut ProgramProcess, run: &mut ProgramRun, prints: &mut Prints) -> Result<&'static str, String> {
    let (mut scan, mut speeds) = (0, [0.0; 2]);
    while !run.is_over() {
        let lockstep = run.lockstep();
        let time_s = lockstep.run().time_s();
        let line = lockstep.readings_json(lockstep.scan() != scan);
        scan = lockstep.scan();
        let told = |fault: String| format!("at {time_s:.2} s: {fault}");
        let reply = process.ask(&line, WaitFor::Step).map_err(told)?;
        add_prints(prints, time_s, &reply.print).map_err(told)?;
        speeds = [reply.left.unwrap_or(speeds[0]), reply.right.unwrap_or(speeds[1])];
        if reply.done {
            run.finish(LogEnd::Done);
            return Ok("done");
        }
        if run.hold(speeds, reply.hold.saturating_add(1)) == 0 {
            return Ok("battery");
        }
    }
    Ok("time")
}

/// The walk that a program plans in a room.
pub fn plan(process: &mut ProgramProcess, room: &ProgramRoom, prints: &mut Prints) -> Result<Vec<Cell>, String> {
    let mut cells = Vec::new();
    let mut reply = process.ask(&json!({ "room": room }).to_string(), WaitFor::Plan)?;
    loop {
        add_prints(prints, 0.0, &reply.print)?;
        // A number that is no cell's stays one that is none.
        let index = |value: i64| i32::try_from(value).unwrap_or(i32::MAX);
        cells.extend(reply.cells.iter().map(|&[x, y]| Cell::new(index(x), index(y))));
        if cells.len() > MOST_CELLS {
            return Err(format!("the plan has more than {MOST_CELLS} cells; does it go in circles?"));
        }
        if reply.done {
            return Ok(cells);
        }
        reply = process.next(WaitFor::Plan)?;
    }
}

/// Adds lines that a program has printed, if they aren't too many.
pub fn add_prints(prints: &mut Prints, time_s: f64, lines: &[String]) -> Result<(), String> {
    prints.extend(lines.iter().map(|line| (time_s, Words::of(line.as_bytes()))));
    if prints.len() > MOST_PRINTS {
        return Err(format!("the program printed more than {MOST_PRINTS} lines; print less"));
    }
    Ok(())
}
