//! The native companion as people and scripts run it: its lists, its failures, its help.
#![cfg(not(target_arch = "wasm32"))]

mod convert;
mod plan;
mod simulate;

use coverage_planners::{PLANNERS, metrics::METRICS};
use robovac_core::{floor_plan::ROOMS, robot::MODELS};
use robovac_sim::controller::BEHAVIOURS;
use serde_json::Value;
use std::{
    fs,
    path::PathBuf,
    process::{Command, Output},
};

fn robovac(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_robovac")).args(arguments).output().unwrap()
}

/// Standard output of a run that works.
fn text(arguments: &[&str]) -> String {
    let output = robovac(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    assert!(output.stderr.is_empty(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// Exit code and message of a run that doesn't.
fn failure(arguments: &[&str]) -> (i32, String) {
    let output = robovac(arguments);
    assert!(output.stdout.is_empty(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stdout));
    (output.status.code().unwrap(), String::from_utf8(output.stderr).unwrap())
}

/// A file of its own for one test, with this content.
fn file(name: &str, content: &[u8]) -> String {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(&path, content).unwrap();
    path.to_string_lossy().into_owned()
}

#[test]
fn lists_begin_with_the_id() {
    let ids = |command| -> Vec<String> {
        text(&[command]).lines().map(|line| line.split_once("  ").unwrap().0.trim_end().to_owned()).collect()
    };
    assert_eq!(ids("planners"), PLANNERS.iter().map(|p| p.id).collect::<Vec<_>>());
    assert_eq!(ids("behaviours"), BEHAVIOURS.iter().map(|b| b.id).collect::<Vec<_>>());
    assert_eq!(ids("rooms"), ROOMS.iter().map(|r| r.id).collect::<Vec<_>>());
    assert_eq!(ids("robots"), MODELS.iter().map(|r| r.id).collect::<Vec<_>>());
    assert_eq!(ids("metrics"), METRICS.iter().map(|m| m.id).collect::<Vec<_>>());
}

#[test]
fn bench_names_its_cases_and_their_times() {
    let table = text(&["bench", "--once"]);
    let simulates =
        |name: &str| ["simulate ", "map ", "hear ", "repeat ", "drive "].iter().any(|word| name.starts_with(word));
    for row in table.lines().skip(1) {
        // Names are padded, and followed by milliseconds and perhaps times real time.
        let (name, numbers) = row.split_at(44);
        let numbers: Vec<f64> = numbers.split_whitespace().map(|number| number.parse().unwrap()).collect();
        assert!(numbers.iter().all(|&number| number > 0.0), "{row}");
        assert_eq!(numbers.len(), 1 + usize::from(simulates(name)), "{row}");
    }
    for planner in PLANNERS.iter().filter(|planner| !planner.is_in_metres()) {
        assert!(table.contains(&format!("\nplan {} 12 x 12  ", planner.id)), "{} isn't in {table}", planner.id);
    }
    let some: Value = serde_json::from_str(&text(&["bench", "--once", "--json", "--only", "simulate"])).unwrap();
    let some = some.as_array().unwrap();
    assert!(!some.is_empty());
    for result in some {
        let name = result["name"].as_str().unwrap();
        assert!(name.contains("simulate") && table.contains(&format!("\n{name}  ")), "{name}");
        assert!(result["ms"].as_f64().unwrap() > 0.0, "{result}");
        assert!(result["times_real_time"].as_f64().is_some_and(|times| times > 1.0), "{result}");
    }
    let (code, message) = failure(&["bench", "--only", "flying"]);
    assert!(code == 2 && message.contains("no case name contains this"), "{code} {message}");
    let (code, message) = failure(&["bench", "--runs", "3"]);
    assert!(code == 2 && message.contains("unexpected argument '--runs'"), "{code} {message}");
}

#[test]
fn failures_have_a_code_and_say_what_to_do() {
    let map = file("bad.txt", b"..\n...\n");
    let out = file("out.txt", b"");
    let cases: &[(&[&str], i32, &str)] = &[
        (&["convert", "--map", "/no/such.txt", "--out", &out], 1, "/no/such.txt: entity not found; check the path"),
        (&["convert", "--room", "flat", "--out", "/no/such/folder/a.txt"], 1, "/no/such/folder/a.txt: "),
        (
            &["convert", "--room", "flat", "--out", "flat.pdf"],
            2,
            "flat.pdf: unknown file extension; use one of .txt, .json, .pgm, .png, .dxf, .svg",
        ),
        (&["convert", "--room", "attic", "--out", &out], 2, "there is no room \"attic\"; \"robovac rooms\" lists them"),
        (&["convert", "--out", &out], 2, "--map <FILE>|--room <ID>"),
        (&["convert", "--map", &map, "--room", "flat", "--out", &out], 2, "cannot be used with"),
        (
            &["plan", "--room", "flat", "--planner", "telepathy"],
            2,
            "there is no planner \"telepathy\"; \"robovac planners\"",
        ),
        (&["plan", "--room", "flat", "--planner", "x", "--start", "3"], 2, "two whole numbers, e.g. 3,4"),
        (&["plan", "--room", "flat", "--planner", "x", "--param", "speed"], 2, "give it as key=value"),
        (&["convert", "--map", &map, "--out", &out], 3, "\"bad.txt\", line 2: this row has 3 cells"),
    ];
    for (arguments, code, expected) in cases {
        let (found, message) = failure(arguments);
        assert!(found == *code && message.contains(expected), "{arguments:?}: {found} {message}");
    }
    let planner = PLANNERS.first().expect("there are planners");
    let base = ["simulate", "--room", "thesis8", "--planner", planner.id];
    let cases: &[(&[&str], i32, &str)] = &[
        (&["--slip", "icy"], 2, "[possible values: none, typical, harsh]"),
        (&["--odometry", "gps"], 2, "[possible values: arc, straight, packet_arc, packet_straight]"),
        (&["--sample", "0"], 2, "'--sample <SECONDS>': give a number of seconds greater than 0"),
        (&["--sample", "-1"], 2, "'--sample <SECONDS>': give a number of seconds greater than 0"),
        (&["--max-time", "nan"], 2, "'--max-time <SECONDS>': give a number of seconds greater than 0"),
        (&["--max-time", "soon"], 2, "'--max-time <SECONDS>': give a number of seconds greater than 0"),
        (&["--robot", "tank"], 2, "there is no robot \"tank\"; \"robovac robots\" lists them"),
        (&["--start", "99,9"], 4, "the start cell (99, 9) lies outside the planning grid"),
    ];
    for (more, code, expected) in cases {
        let (found, message) = failure(&[&base, *more].concat());
        assert!(found == *code && message.contains(expected), "{more:?}: {found} {message}");
    }
    let base = ["plan", "--room", "thesis8", "--planner", planner.id];
    let cases: &[(&[&str], i32, &str)] = &[
        (&["--robot", "tank"], 2, "there is no robot \"tank\"; \"robovac robots\" lists them"),
        (&["--param", "warp=9"], 2, "there is no parameter \"warp\""),
        (&["--cell", "-1"], 2, "planning cells of -1 m don't suit this map"),
        (&["--heading", "nan"], 2, "the heading can't be NaN"),
        (&["--start", "9,9"], 4, "the start cell (9, 9) lies outside the planning grid of 8 x 8 cells"),
        (&["--start", "-1,0"], 4, "the start cell (-1, 0) lies outside"),
        (&["--start", "0,0"], 4, "the start cell (0, 0) is inside a wall; the nearest cell where the robot fits is"),
    ];
    for (more, code, expected) in cases {
        let (found, message) = failure(&[&base, *more].concat());
        assert!(found == *code && message.starts_with(&format!("robovac: {expected}")), "{more:?}: {found} {message}");
    }
}

#[test]
fn help_documents_exit_codes_and_units() {
    let help = text(&["--help"]);
    assert!(help.contains("Exit codes:") && help.contains("3  the map can't be used"), "{help}");
    let help = text(&["simulate", "--help"]);
    assert!(help.contains("--sample <SECONDS>") && help.contains("[default: 10]"), "{help}");
    let help = text(&["plan", "--help"]);
    assert!(
        help.contains("counted from 0 at the lower left") && help.contains("counter-clockwise from 0 = right"),
        "{help}"
    );
}
