//! What drives: `simulate`, `montecarlo` and `map`.

use super::{failure, file, text};
use robovac_app::explore::Session;
use robovac_core::geometry::{MetricPath, Point};
use serde_json::Value;
use std::collections::HashSet;

/// Output of `simulate --json`.
fn simulated(more: &[&str]) -> Value {
    let output = text(&[&["simulate", "--json"], more].concat());
    assert_eq!(output.lines().count(), 1);
    serde_json::from_str(&output).unwrap()
}

#[test]
fn roomba_drives_a_small_room_clean() {
    let base = ["--room", "empty", "--planner", "boustrophedon", "--seed", "5"];
    let report = simulated(&base);
    assert_eq!(report["finished"], true);
    let number = |key: &str| report[key].as_f64().unwrap_or_else(|| panic!("{key} in {report}"));
    assert!(number("coverage") > 0.97, "{}", number("coverage"));
    assert!(number("pose_error_m") < 0.05 && number("bumps") < 5.0 && number("overlap") < 1.0);
    assert_eq!((&report["slip"], &report["odometry"]), (&Value::from("none"), &Value::from("arc")));
    assert_eq!(report["digest"].as_str().unwrap().len(), 16);

    // The head is that of the plan that was driven.
    let plan: Value =
        serde_json::from_str(&text(&[&["plan", "--json", "--robot", "roomba600"], &base[..]].concat())).unwrap();
    for key in ["planner", "params", "seed", "room", "robot", "start", "heading_deg"] {
        assert!(!plan[key].is_null() && report[key] == plan[key], "{key}: {} but {}", report[key], plan[key]);
    }
    assert!((number("distance_m") / plan["length_m"].as_f64().unwrap() - 1.0).abs() < 0.1);
    assert!((number("turning_deg") / plan["turning_deg"].as_f64().unwrap() - 1.0).abs() < 0.1);

    // Every ten seconds, from the start to the end.
    let samples = report["samples"].as_array().unwrap();
    let times: Vec<f64> = samples.iter().map(|s| s["time_s"].as_f64().unwrap()).collect();
    let (last, inner) = times.split_last().unwrap();
    assert!(inner.iter().enumerate().all(|(i, t)| (t - 10.0 * i as f64).abs() < 0.0151), "{times:?}");
    assert_eq!(*last, number("time_s"));
    assert_eq!(samples.last().unwrap()["coverage"], report["coverage"]);
    for sample in samples {
        let far = |key: &str| sample["pose"][key].as_f64().unwrap() - sample["estimate"][key].as_f64().unwrap();
        assert!(far("x").abs() < 0.05 && far("y").abs() < 0.05, "{sample}");
        assert!(sample["pose"]["heading_deg"].is_number());
    }
}

#[test]
fn same_seed_gives_the_same_run() {
    let base = ["--room", "room12ft", "--planner", "snake", "--slip", "harsh", "--odometry", "straight"];
    let with = |seed: &str| simulated(&[&base[..], &["--max-time", "120", "--seed", seed]].concat());
    let (first, again, other) = (with("7"), with("7"), with("8"));
    assert_eq!(first, again);
    assert_ne!(first["digest"], other["digest"]);
    assert_eq!(first["finished"], false);
    assert!((first["time_s"].as_f64().unwrap() - 120.0).abs() < 0.0151, "{}", first["time_s"]);
}

#[test]
fn run_is_the_one_that_the_page_shows() {
    let mut session = Session::new();
    session.restore("room=room12ft&planner=boustrophedon&slip=typical&seed=3").unwrap();
    session.plan_now(|| 0.0);
    session.run_ahead(90.0);
    let digest = format!("{:016x}", session.recording().unwrap().run().digest());
    let base = ["--room", "room12ft", "--planner", "boustrophedon", "--slip", "typical", "--seed", "3"];
    assert_eq!(simulated(&[&base[..], &["--max-time", "90"]].concat())["digest"], digest);
}

#[test]
fn a_scenario_of_the_page_runs_with_its_own_robot_and_path() {
    let corners = [[1.0, 1.0], [2.0, 1.0], [2.0, 1.5], [1.0, 1.5]].map(|[x, y]| Point::new(x, y));
    let path = MetricPath::new(&corners).unwrap();
    let mut name = String::new();
    for (link, corners) in [
        (
            format!("room=empty&robot=roomba600&own=radius:0.15,tool:0.2,speed:0.25&slip=typical&seed=3&path={path}"),
            Some(4),
        ),
        ("room=empty&behaviour=bounce&p.least=60&noise.bumper=typical&seed=5".to_owned(), None),
    ] {
        let mut session = Session::new();
        session.restore(&link).unwrap();
        session.run_ahead(20.0);
        let digest = format!("{:016x}", session.recording().unwrap().run().digest());
        name = file("scenario/run.json", session.scenario_json().as_bytes());
        let report = simulated(&["--map", &name, "--max-time", "20"]);
        assert_eq!(report["digest"], digest, "{link}");
        assert_eq!(report["path_corners"].as_u64(), corners, "{link}");
    }
    let (code, message) = failure(&["simulate", "--map", &name, "--robot", "dvr1"]);
    assert!(code == 2 && message.contains("the scenario has these"), "{message}");
    let (code, message) = failure(&["simulate", "--room", "empty"]);
    assert!(code == 2 && message.contains("--planner or --behaviour"), "{message}");
}

#[test]
fn run_is_told_as_a_table_and_a_summary() {
    let base = ["simulate", "--room", "thesis8", "--planner", "snake", "--robot", "cell"];
    let table = text(&[&base[..], &["--sample", "20"]].concat());
    assert!(table.contains("\n    0.00 s ") && table.contains("\n   20.01 s "), "{table}");
    assert!(table.contains("reached the end of the walk, digest "), "{table}");
    let stopped = text(&[&base[..], &["--max-time", "5"]].concat());
    assert!(stopped.contains("\n    5.0") && stopped.contains("stopped by --max-time"), "{stopped}");
}

#[test]
fn behaviour_is_run_for_as_long_as_one_says() {
    let base = ["--room", "room12ft", "--behaviour", "bounce", "--noise", "typical", "--noise", "cliff=harsh"];
    let report = simulated(&[&base[..], &["--max-time", "60", "--seed", "4", "--quantised"]].concat());
    assert_eq!((&report["behaviour"], report.get("planner")), (&Value::from("bounce"), None));
    assert_eq!((&report["finished"], &report["quantised"]), (&Value::from(false), &Value::from(true)));
    let noise = report["noise"].as_str().unwrap();
    assert!(noise.contains("cliff=harsh") && noise.contains("bumper=typical"), "{noise}");
    assert!((report["time_s"].as_f64().unwrap() - 60.0).abs() < 0.0151);

    let mut session = Session::new();
    session.restore("room=room12ft&behaviour=bounce&noise=typical&noise.cliff=harsh&quantised=true&seed=4").unwrap();
    session.run_ahead(60.0);
    let run = session.recording().unwrap().run();
    assert_eq!(report["digest"], format!("{:016x}", run.digest()), "it is the run that the page shows");
    // By counting wheel turns, which wheels that hold their speed in steps and bumps put off.
    assert!(report["pose_error_m"].as_f64() == run.pose_error_m() && run.pose_error_m() > Some(0.0));

    let told = text(&["simulate", "--room", "empty", "--behaviour", "bounce", "--sample", "600"]);
    assert!(told.starts_with("Behaviour Bounce, seed 0\n") && told.contains("stopped by --max-time"), "{told}");
    assert!(told.contains("\n 1800.0"), "half an hour for those that never end: {told}");
    let base = ["simulate", "--room", "empty", "--behaviour", "bounce", "--sample", "1e5"];
    let told = text(&[&base[..], &["--max-time", "1e5"]].concat());
    assert!(told.contains("stopped by an empty battery"), "it never ends by itself: {told}");
}

#[test]
fn montecarlo_tells_the_same_in_every_form_and_on_any_number_of_cores() {
    let base = ["montecarlo", "--room", "empty", "--behaviour", "bounce", "--planner", "boustrophedon"];
    let base = [&base[..], &["--seeds", "4", "--seed", "7", "--minutes", "10", "--slip", "typical"]].concat();
    let with = |more: &[&str]| text(&[&base[..], more].concat());
    let csv = with(&["--csv", "--jobs", "1"]);
    assert_eq!(csv, with(&["--csv", "--jobs", "3"]));
    let rows: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    let of = |name: &str| rows[0].iter().position(|column| *column == name).unwrap();
    let seeds: Vec<&str> = rows[1..].iter().map(|row| row[of("seed")]).collect();
    assert_eq!(seeds, ["7", "8", "9", "10", "7", "8", "9", "10"]);
    let digests: HashSet<&str> = rows[1..].iter().map(|row| row[of("digest")]).collect();
    assert_eq!(digests.len(), 8, "every seed has a run of its own, planned paths too");

    let json: Value = serde_json::from_str(&with(&["--json"])).unwrap();
    for (algorithm, rows) in json["algorithms"].as_array().unwrap().iter().zip(rows[1..].chunks(4)) {
        assert_eq!(
            (algorithm["runs"].as_u64(), &algorithm["algorithm"]),
            (Some(4), &Value::from(rows[0][of("algorithm")]))
        );
        let ends = algorithm["each"].as_array().unwrap().iter().map(|run| 100.0 * run["coverage"].as_f64().unwrap());
        let told: Vec<f64> = rows.iter().map(|row| row[of("coverage [%]")].parse().unwrap()).collect();
        assert_eq!(ends.collect::<Vec<_>>(), told);
    }
    let table = with(&[]);
    assert!(
        table.starts_with("### Empty room, Roomba 600 / Create 2: 4 runs of 10 min, slip typical, noise off\n"),
        "{table}"
    );
    assert!(
        table.contains("\n| bounce | ") && table.contains("\n| boustrophedon | ") && table.contains("| – | 0 % |"),
        "{table}"
    );
}

#[test]
fn montecarlo_rounds_the_corners_of_plans() {
    let base = ["montecarlo", "--room", "bedroom", "--planner", "boustrophedon", "--seeds", "2", "--minutes", "15"];
    let of = |more: &[&str]| text(&[&base[..], more].concat());
    let first = |more: &[&str], key: &str| {
        let json: Value = serde_json::from_str(&of(&[more, &["--json"]].concat())).unwrap();
        assert_eq!(json["smooth"], more == ["--smooth"]);
        let each = &json["algorithms"][0]["each"][0];
        (each["time_s"].as_f64().unwrap(), each[key][1].as_f64().unwrap())
    };
    let (stopping, smooth) = (first(&[], "excess"), first(&["--smooth"], "excess"));
    assert!(smooth.0 < 0.9 * stopping.0 && smooth.1 < stopping.1, "{smooth:?} {stopping:?}");
    let table = of(&["--smooth"]);
    assert!(table.contains("noise off, rounded corners\n") && table.contains("| in minutes, % |"), "{table}");
    let excess = format!("| {:.0} (", 100.0 * smooth.1);
    assert!(table.contains(&excess), "{excess} in {table}");
    // That a robot without wheels to turn has no plan is a result.
    let octagon = text(&["montecarlo", "--room", "empty", "--robot", "octagon", "--planner", "snake", "--smooth"]);
    assert!(octagon.contains("can't round corners"), "{octagon}");
}

#[test]
fn montecarlo_says_what_it_does_not_know() {
    let base = ["montecarlo", "--room", "empty"];
    for (arguments, expected) in [
        (&["--seeds", "3"][..], "--behaviour <LIST>|--planner <LIST>"),
        (&["--behaviour", "snail"], "there is no behaviour \"snail\"; \"robovac behaviours\" lists them"),
        (&["--behaviour", "snake"], "there is no behaviour \"snake\""),
        (&["--planner", "bounce"], "there is no planner \"bounce\""),
        (&["--planner", "snake~patience:lots"], "use a whole number from 0 to 20"),
        (&["--behaviour", "bounce", "--minutes", "0"], "give a number of minutes from 0.1 to 6000"),
        (&["--behaviour", "bounce", "--seeds", "0"], "0 is not in 1..=100000"),
        (&["--behaviour", "bounce", "--noise", "loud"], "there is no level \"loud\"; there are: off, typical, harsh"),
        (&["--behaviour", "bounce", "--noise", "nose=off"], "there is no kind of sensor \"nose\"; there are: bumper, "),
        (&["--behaviour", "bounce", "--robot", "tank"], "there is no robot \"tank\""),
    ] {
        let (code, message) = failure(&[&base[..], arguments].concat());
        assert!(code == 2 && message.contains(expected), "{arguments:?}: {code} {message}");
    }
    let (code, message) = failure(&["simulate", "--room", "empty", "--behaviour", "bounce", "--planner", "snake"]);
    assert!(code == 2 && message.contains("cannot be used with"), "{code} {message}");
}

#[test]
fn maps_are_measured_with_and_without_correction() {
    let arguments = ["map", "--room", "bedroom", "--behaviour", "bounce", "--minutes", "2", "--seeds", "2"];
    let noisy = ["--slip", "typical", "--noise", "typical"];
    let json = [&arguments[..], &noisy[..], &["--json"]].concat();
    let outcomes: Value = serde_json::from_str(&text(&json)).unwrap();
    let outcomes = outcomes.as_array().unwrap();
    assert_eq!(outcomes.len(), 4);
    for outcome in outcomes {
        for share in ["right", "known", "boundary"] {
            assert!((0.0..=1.0).contains(&outcome[share].as_f64().unwrap()), "{outcome}");
        }
        assert!(outcome["error_m"][2].as_f64().unwrap() >= outcome["error_m"][1].as_f64().unwrap(), "{outcome}");
    }
    let table = text(&[&arguments[..], &["--tracking", "corrected"]].concat());
    assert!(table.starts_with("corrected\n") && !table.contains("odometry") && table.contains("median"), "{table}");
    let (code, message) = failure(&["map", "--room", "bedroom", "--behaviour", "sleep"]);
    assert!(code == 2 && message.contains("sleep"), "{message}");
}
