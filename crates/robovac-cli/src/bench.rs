//! `bench`: speed of planning and simulation, to compare with the browser.

use super::{failure::Failure, output};
use robovac_app::bench::{self, Bench, BenchResult};
use std::time::Instant;

/// Time the planners and the simulator, on the same work as bench.html in the browser
#[derive(clap::Args)]
pub struct Arguments {
    /// Write one JSON array instead of a table
    #[arg(long)]
    json: bool,
    /// Measure only cases whose names contain TEXT, e.g. "simulate"
    #[arg(long, value_name = "TEXT", default_value = "", hide_default_value = true)]
    only: String,
    /// Run each case once, to check that it works rather than how fast it is
    #[arg(long)]
    once: bool,
}

/// Runs the benchmark. Rows of the table are printed immediately, as it takes a while; the rest of the output is
/// returned.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let begin = Instant::now();
    let clock = || begin.elapsed().as_secs_f64();
    if arguments.json {
        return Ok(output::json(&all(arguments, &clock, &mut |_| {})?));
    }
    let mut head = line("", "ms, median", "times real time");
    let mut written = Ok(());
    all(arguments, &clock, &mut |result| {
        if written.is_ok() {
            written = output::print(&(std::mem::take(&mut head) + &row(result)));
        }
    })?;
    written.map(|()| String::new())
}

fn all(
    arguments: &Arguments,
    clock: &dyn Fn() -> f64,
    report: &mut dyn FnMut(&BenchResult),
) -> Result<Vec<BenchResult>, Failure> {
    let only = arguments.only.as_str();
    let mut bench = Bench::new(clock, &|| None, report).only(only).once_each(arguments.once);
    for cases in [bench::planning, bench::programs, bench::mapping, bench::streaming, bench::floor_plan] {
        cases(&mut bench);
    }
    let results = bench.into_results();
    if results.is_empty() {
        return Err(Failure::usage(format!(
            "--only {only}: no case name contains this; \"robovac bench\" lists all cases"
        )));
    }
    Ok(results)
}

fn row(result: &BenchResult) -> String {
    let times = result.times_real_time.map(|times| format!("{times:.0}")).unwrap_or_default();
    line(&result.name, &format!("{:.2}", result.ms), &times)
}

fn line(name: &str, ms: &str, times_real_time: &str) -> String {
    format!("{name:44}{ms:>12}{times_real_time:>18}").trim_end().to_owned() + "\n"
}
