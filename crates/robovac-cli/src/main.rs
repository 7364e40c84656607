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
    command: CliCommand,
}

#[derive(Subcommand)]
enum CliCommand {
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
        CliCommand::Planners => Ok(list::planners()),
        CliCommand::Behaviours => Ok(list::behaviours()),
        CliCommand::Rooms => Ok(list::rooms()),
        CliCommand::Robots => Ok(list::robots()),
        CliCommand::Personalities => Ok(list::personalities()),
        CliCommand::Metrics => Ok(list::metrics()),
        CliCommand::Plan(arguments) => plan::run(&arguments),
        CliCommand::Sweep(arguments) => sweep::run(&arguments),
        CliCommand::Lanes(arguments) => lanes::run(&arguments),
        CliCommand::Simulate(arguments) => simulate::run(&arguments),
        CliCommand::Montecarlo(arguments) => montecarlo::run(&arguments),
        CliCommand::Clean(arguments) => clean::run(&arguments),
        CliCommand::Compare(arguments) => compare::run(&arguments),
        CliCommand::Grade(arguments) => grade::run(&arguments),
        CliCommand::Locate(arguments) => locate::run(&arguments),
        CliCommand::Convert(arguments) => convert::run(&arguments),
        CliCommand::Generate(arguments) => generate::run(&arguments),
        CliCommand::Drive(arguments) => drive::run(&arguments),
        CliCommand::Bench(arguments) => bench::run(&arguments),
        CliCommand::Benchmark(arguments) => study::benchmark::run(&arguments),
        CliCommand::Bridge(arguments) => bridge::run(&arguments),
        CliCommand::Map(arguments) => map::run(&arguments),
        CliCommand::Monitor(arguments) => monitor::run(&arguments),
        CliCommand::Recording(arguments) => recording::run(&arguments),
        CliCommand::Study(arguments) => study::run(&arguments),
        #[cfg(feature = "ros2")]
        CliCommand::Ros2(arguments) => ros2::run(&arguments),
        #[cfg(not(feature = "ros2"))]
        CliCommand::Ros2 { .. } => Err(failure::Failure::without_ros2()),
        CliCommand::Run(arguments) => run::run(&arguments),
        CliCommand::Twin(arguments) => twin::run(&arguments),
        CliCommand::VirtualRoomba(arguments) => virtual_roomba::run(&arguments),
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
