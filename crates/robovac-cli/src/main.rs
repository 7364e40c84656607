//! Native companion of the page: the same planners and behaviours on the command line.
//!
//! One file a sub-command; each turns its arguments into text or a [`failure::Failure`].

mod bag_file;
mod bench;
mod bridge;
mod clean;
mod compare;
mod conditions;
mod convert;
mod drawing;
mod drive;
mod failure;
mod generate;
mod grade;
mod lanes;
mod list;
mod locate;
mod map;
mod monitor;
mod montecarlo;
mod output;
mod parallel;
mod plan;
mod recording;
#[cfg(feature = "ros2")]
mod ros2;
mod run;
mod signals;
mod simulate;
mod source;
mod study;
mod sweep;
mod task;
mod twin;
mod virtual_roomba;

use clap::{Parser, Subcommand};
use failure::OK;
use output::print;
use std::{io::Write, process::ExitCode};

const EXIT_CODES: &str = "\
Exit codes:
  0  done
  1  a file can't be read or written
  2  wrong usage: unknown option, planner, behaviour, room, robot or parameter
  3  the map can't be used
  4  the robot or its start doesn't fit into the room
  5  the planner or your program failed";

/// Plan and simulate floor coverage by robot vacuum cleaners. Lengths are in metres, angles in degrees
/// counter-clockwise from 0 = right; cells are counted from the lower left.
#[derive(Parser)]
#[command(name = "robovac", version, after_help = EXIT_CODES)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// List the planners: id, then title
    Planners,
    /// List the behaviours (reactive controllers): id, then title
    Behaviours,
    /// List the built-in rooms: id, then title
    Rooms,
    /// List the robots: id, then title
    Robots,
    /// List the personalities of the virtual Roomba: id, then title
    Personalities,
    /// List the metrics of plans: id, then definition
    Metrics,
    Plan(plan::Arguments),
    Sweep(sweep::Arguments),
    Lanes(lanes::Arguments),
    Simulate(simulate::Arguments),
    Montecarlo(montecarlo::Arguments),
    Clean(clean::Arguments),
    Compare(compare::Arguments),
    Grade(grade::Arguments),
    Locate(locate::Arguments),
    Convert(convert::Arguments),
    Generate(generate::Arguments),
    Bench(bench::Arguments),
    Benchmark(study::benchmark::Arguments),
    Drive(drive::Arguments),
    Bridge(bridge::Arguments),
    Map(map::Arguments),
    Monitor(monitor::Arguments),
    Recording(recording::Arguments),
    Study(study::Arguments),
    #[cfg(feature = "ros2")]
    Ros2(ros2::Arguments),
    /// A node of ROS 2. This program was built without it: see docs/ros2.md
    #[cfg(not(feature = "ros2"))]
    #[command(disable_help_flag = true)]
    Ros2 {
        #[arg(trailing_var_arg = true, allow_hyphen_values = true, hide = true)]
        rest: Vec<String>,
    },
    Run(run::Arguments),
    Twin(twin::Arguments),
    VirtualRoomba(virtual_roomba::Arguments),
}

fn main() -> ExitCode {
    let result = match Arguments::parse().command {
        Command::Planners => Ok(list::planners()),
        Command::Behaviours => Ok(list::behaviours()),
        Command::Rooms => Ok(list::rooms()),
        Command::Robots => Ok(list::robots()),
        Command::Personalities => Ok(list::personalities()),
        Command::Metrics => Ok(list::metrics()),
        Command::Plan(arguments) => plan::run(&arguments),
        Command::Sweep(arguments) => sweep::run(&arguments),
        Command::Lanes(arguments) => lanes::run(&arguments),
        Command::Simulate(arguments) => simulate::run(&arguments),
        Command::Montecarlo(arguments) => montecarlo::run(&arguments),
        Command::Clean(arguments) => clean::run(&arguments),
        Command::Compare(arguments) => compare::run(&arguments),
        Command::Grade(arguments) => grade::run(&arguments),
        Command::Locate(arguments) => locate::run(&arguments),
        Command::Convert(arguments) => convert::run(&arguments),
        Command::Generate(arguments) => generate::run(&arguments),
        Command::Drive(arguments) => drive::run(&arguments),
        Command::Bench(arguments) => bench::run(&arguments),
        Command::Benchmark(arguments) => study::benchmark::run(&arguments),
        Command::Bridge(arguments) => bridge::run(&arguments),
        Command::Map(arguments) => map::run(&arguments),
        Command::Monitor(arguments) => monitor::run(&arguments),
        Command::Recording(arguments) => recording::run(&arguments),
        Command::Study(arguments) => study::run(&arguments),
        #[cfg(feature = "ros2")]
        Command::Ros2(arguments) => ros2::run(&arguments),
        #[cfg(not(feature = "ros2"))]
        Command::Ros2 { .. } => Err(failure::Failure::without_ros2()),
        Command::Run(arguments) => run::run(&arguments),
        Command::Twin(arguments) => twin::run(&arguments),
        Command::VirtualRoomba(arguments) => virtual_roomba::run(&arguments),
    };
    match result.and_then(|text| print(&text)) {
        Ok(()) => OK.into(),
        Err(failure) => {
            // If this fails, too, the error can't be reported.
            let _ = writeln!(std::io::stderr(), "robovac: {failure}");
            failure.code.into()
        }
    }
}
