//! The native companion as people and scripts run it.
#![cfg(not(target_arch = "wasm32"))]

use coverage_planners::{PLANNERS, metrics::METRICS};
use robovac_app::explore::Session;
use robovac_core::{
    floor_plan::ROOMS,
    geometry::{MetricPath, Point},
    robot::MODELS,
};
use robovac_sim::controller::BEHAVIOURS;
use serde_json::Value;
use std::{
    collections::HashSet,
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

/// Asserts what every plan promises, and returns the walk.
fn checked_walk(report: &Value) -> Vec<(i64, i64)> {
    let number = |cell: &Value, i: usize| cell[i].as_i64().unwrap();
    let walk: Vec<_> = report["cells"].as_array().unwrap().iter().map(|c| (number(c, 0), number(c, 1))).collect();
    assert!(walk.windows(2).all(|w| (w[0].0 - w[1].0).abs() + (w[0].1 - w[1].1).abs() == 1), "a jump");
    let visited: HashSet<_> = walk.iter().collect();
    let whole = |key: &str| report[key].as_u64().unwrap() as usize;
    assert_eq!(whole("steps"), walk.len() - 1);
    assert_eq!(whole("revisits"), walk.len() - visited.len());
    assert!(whole("reachable_cells") >= visited.len());
    if report["robot"] == "cell" {
        let share = visited.len() as f64 / whole("reachable_cells") as f64;
        assert_eq!(report["coverage"].as_f64().unwrap(), share);
    }
    let numbers =
        ["turns", "initial_turns", "direction_changes", "revisited_cells", "overlap", "overlap_m2", "length_m"];
    let others = ["duration_s", "energy_wh", "planning_s", "seed", "heading_deg"];
    for key in numbers.into_iter().chain(others) {
        assert!(report[key].is_number(), "{key} in {report}");
    }
    if whole("visited_cells") == whole("reachable_cells") {
        let (steps, turns) = (whole("steps") as u64, whole("turns") as u64);
        for (key, value) in [("steps", steps), ("turns", turns), ("cost", steps + 2 * turns)] {
            assert!(report["bounds"][key].as_u64().unwrap() <= value, "{key} of {}", report["bounds"]);
        }
        assert!(report["above_bound_percent"].as_f64().unwrap() >= 0.0);
    } else {
        assert!(report["above_bound_percent"].is_null());
    }
    walk
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
fn every_planner_plans_the_thesis_preset() {
    for planner in PLANNERS {
        let output = text(&["plan", "--room", "thesis8", "--planner", planner.id, "--json"]);
        assert_eq!(output.lines().count(), 1);
        let report: Value = serde_json::from_str(&output).unwrap();
        if planner.claims.in_metres {
            assert!(report["corners_m"].as_array().is_some_and(|corners| corners.len() > 10), "{report}");
            assert!(report["coverage"].as_f64().is_some_and(|share| share > 0.9) && report["steps"].is_null());
        } else {
            assert_eq!(checked_walk(&report)[0], (0, 7));
        }
        assert_eq!((&report["room"]["width"], &report["room"]["height"]), (&Value::from(8), &Value::from(8)));
        assert_eq!(
            (&report["room"]["resolution_m"], &report["planner"]),
            (&Value::from(0.2), &Value::from(planner.id))
        );
        if planner.claims.complete {
            assert_eq!((report["coverage"].as_f64(), report["reachable_cells"].as_u64()), (Some(1.0), Some(54)));
        }
    }
}

#[test]
fn start_heading_seed_robot_and_cell_are_taken_over() {
    let planner = PLANNERS.first().expect("there are planners");
    let map = file("start.txt", b"; resolution 0.2\n; name Den\n...\n.#.\n...\n");
    let base = ["plan", "--map", &map, "--planner", planner.id, "--json"];
    let with = |more: &[&str]| -> Value { serde_json::from_str(&text(&[&base, more].concat())).unwrap() };
    let report = with(&["--start", "2,1", "--heading", "-90", "--seed", "7"]);
    assert_eq!(checked_walk(&report)[0], (2, 1));
    assert_eq!((&report["start"], &report["seed"]), (&Value::from(vec![2, 1]), &Value::from(7)));
    assert!((report["heading_deg"].as_f64().unwrap() + 90.0).abs() < 1e-9);
    assert_eq!(report["room"]["name"], "Den");

    let large = ["plan", "--room", "empty", "--planner", planner.id, "--json", "--robot", "roomba600", "--cell", "0.2"];
    let report: Value = serde_json::from_str(&text(&large)).unwrap();
    checked_walk(&report);
    assert_eq!((&report["robot"], &report["room"]["width"]), (&Value::from("roomba600"), &Value::from(25)));
    let summary = text(&["plan", "--room", "empty", "--planner", planner.id]);
    assert!(
        summary.contains("Coverage  ") && summary.contains(" m in ") && summary.contains(" quarter turns"),
        "{summary}"
    );
}

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
    for planner in PLANNERS.iter().filter(|planner| !planner.claims.in_metres) {
        assert!(table.contains(&format!("\nplan {} 30 x 30  ", planner.id)), "{} isn't in {table}", planner.id);
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
fn convert_makes_a_room_of_a_drawing() {
    let corners: String = [(0, 0), (300, 0), (300, 200), (0, 200)].map(|(x, y)| format!("10\n{x}\n20\n{y}\n")).concat();
    let drawing = format!("0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nA\n70\n1\n{corners}0\nENDSEC\n0\nEOF\n");
    let drawing = file("convert/house.dxf", drawing.as_bytes());
    let out = file("convert/house.txt", b"");
    let options = ["--units", "cm", "--layer", "A=wall", "--resolution", "0.5", "--region", "room:150,100"];
    text(&[&["convert", "--map", &drawing, "--out", &out], &options[..]].concat());
    assert!(fs::read_to_string(&out).unwrap().ends_with("#######\n#.....#\n#.....#\n#.....#\n#######\n"));
    for (options, message) in [
        (&["--layer", "A=wall"][..], "add --units, e.g. --units mm"),
        (&["--units", "parsec"], "--units parsec: use mm, cm, m, in, ft"),
        (&["--units", "m", "--layer", "B=wall"], "the drawing has no such layer, it has A"),
        (&["--units", "m", "--region", "room:1"], "use whole, room:X,Y"),
        (&["--units", "cm", "--region", "room:-900,0"], "there is nothing drawn at (-900.00, 0.00)"),
    ] {
        let (_, said) = failure(&[&["convert", "--map", &drawing, "--out", &out], options].concat());
        assert!(said.contains(message), "{said}");
    }
    let (code, said) = failure(&["plan", "--planner", "boustrophedon", "--map", &drawing]);
    assert!(code == 3 && said.contains("is a DXF drawing, from which a room must be traced first"), "{said}");
}

#[test]
fn convert_writes_what_can_be_read_again() {
    let json = file("convert/flat.json", b"");
    let back = file("convert/flat.txt", b"");
    let direct = file("convert/direct.txt", b"");
    assert_eq!(text(&["convert", "--room", "flat", "--out", &json]), "");
    text(&["convert", "--map", &json, "--out", &back]);
    text(&["convert", "--room", "flat", "--out", &direct]);
    assert_eq!(fs::read_to_string(&back).unwrap(), fs::read_to_string(&direct).unwrap());
    assert!(fs::read_to_string(&back).unwrap().starts_with("; resolution 0.05\n; name Furnished flat\n"));
}

#[test]
fn ros_maps_of_any_mode_are_the_same_room() {
    let read_back = |image: &str, options: &[&str]| {
        let out = file(&format!("convert/{image}"), b"");
        text(&[&["convert", "--room", "flat", "--out", &out], options].concat());
        let yaml = out.replace(".pgm", ".yaml").replace(".png", ".yaml");
        let back = file("convert/ros.txt", b"");
        text(&["convert", "--map", &yaml, "--out", &back]);
        let map = fs::read_to_string(&back).unwrap();
        map.lines().filter(|line| !line.starts_with("; name")).collect::<Vec<_>>().join("\n")
    };
    let trinary = read_back("trinary.pgm", &[]);
    assert!(trinary.contains("; resolution 0.05") && trinary.contains("##"));
    assert_eq!(read_back("scale.png", &["--mode", "scale", "--negate"]), trinary);
    assert_eq!(read_back("raw.png", &["--mode", "raw"]), trinary);
}

#[test]
fn image_of_a_ros_map_is_found_beside_its_yaml() {
    let yaml = file("ros/map.yaml", b"image: map.pgm\nresolution: 0.2\norigin: [0, 0, 0]\n");
    let out = file("ros/map.txt", b"");
    file("ros/map.pgm", b"P5 3 1 255\n\xfe\xfe\x00");
    text(&["convert", "--map", &yaml, "--out", &out]);
    assert_eq!(fs::read_to_string(&out).unwrap(), "; resolution 0.2\n; name map\n..#\n");
    let lonely = file("ros_alone/map.yaml", b"image: gone.pgm\nresolution: 0.2\norigin: [0, 0, 0]\n");
    let (code, message) = failure(&["convert", "--map", &lonely, "--out", &out]);
    assert!(code == 3 && message.contains("\"gone.pgm\"; choose both files together"), "{code} {message}");
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

#[test]
fn compare_makes_every_trial_once_in_every_form() {
    let map = file("compare/map.txt", b"; resolution 0.2\n; name Two, cells\nS.\n..\n");
    let rooms = format!("thesis8,{map}");
    let arguments = ["compare", "--rooms", &rooms, "--planners", "snake~patience:0,genetic", "--seeds", "3", "--json"];
    let records: Value = serde_json::from_str(&text(&arguments)).unwrap();
    let records = records.as_array().unwrap();
    let of = |planner: &str| records.iter().filter(|r| r["planner"] == planner).collect::<Vec<_>>();
    assert_eq!((of("snake").len(), of("genetic").len()), (2, 6), "only what uses chance needs more seeds");
    assert_eq!(of("snake")[0]["params"]["patience"], 0.0);
    assert_eq!(of("genetic").iter().map(|r| r["seed"].as_u64().unwrap()).collect::<Vec<_>>(), [1, 2, 3, 1, 2, 3]);
    for record in records {
        assert_eq!(record["numbers"]["coverage"], 100.0, "{record}");
        let names: HashSet<&str> = record["numbers"].as_object().unwrap().keys().map(String::as_str).collect();
        assert_eq!(names, METRICS.iter().map(|m| m.id).collect(), "the ids are those of \"robovac metrics\"");
    }
    let csv = text(&["compare", "--rooms", &rooms, "--planners", "all", "--csv", "--jobs", "1"]);
    assert_eq!(csv.lines().count(), 1 + 2 * PLANNERS.len());
    assert!(csv.lines().last().unwrap().starts_with("\"Two, cells\",cell,0.2,"), "{csv}");
    let table = text(&["compare", "--rooms", "thesis8", "--planners", "boustrophedon,snake"]);
    assert!(table.starts_with("### Thesis preset 8 x 8, ") && table.contains("\n| snake | "), "{table}");
    assert!(table.lines().find(|l| l.starts_with("| boustrophedon |")).unwrap().contains("| **14** |"), "{table}");
}

#[test]
fn compare_says_what_it_does_not_know() {
    for (arguments, expected) in [
        (["--rooms", "nowhere"], "neither a room"),
        (["--planners", "snail"], "there is no planner \"snail\""),
        (["--planners", "snake~patience:lots"], "use a whole number from 0 to 20"),
        (["--robot", "tank"], "there is no robot \"tank\""),
        (["--seeds", "0"], "0 is not in 1..=1000"),
    ] {
        let (code, message) = failure(&[&["compare"], &arguments[..]].concat());
        assert!(code == 2 && message.contains(expected), "{arguments:?}: {code} {message}");
    }
    // A room where the robot doesn't fit is a result too.
    let narrow = file("compare/narrow.txt", b"; resolution 0.1\n..\n");
    let csv = text(&["compare", "--rooms", &narrow, "--planners", "snake", "--robot", "roomba600", "--csv"]);
    assert!(csv.contains("fits nowhere in this room"), "{csv}");
}

#[test]
fn sweep_prints_its_numbers_and_writes_every_format() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("sweep");
    fs::create_dir_all(&folder).unwrap();
    let out = |name: &str| folder.join(name).to_string_lossy().into_owned();
    let files = ["a.csv", "a.yaml", "a.txt", "a.oi.txt", "a.json"].map(out);
    let mut arguments = vec!["sweep", "--room", "room12ft", "--outline", "rectangle:0.4x0.3", "--scan-width", "0.2"];
    for file in &files {
        arguments.extend(["--out", file]);
    }
    let report: Value = serde_json::from_str(&text(&arguments)).unwrap();
    assert!(report["subgoals"].as_u64().unwrap() > 10 && report["coverage"].as_f64().unwrap() > 0.97, "{report}");
    assert_eq!((report["collisions"].clone(), report["width_m"].as_f64()), (report["resolved"].clone(), Some(0.3)));
    let [csv, yaml, program, bytes, json] = files.each_ref().map(|file| fs::read_to_string(file).unwrap());
    assert!(csv.starts_with("x_m,y_m,heading_rad,distance_m,time_s\n"));
    assert!(yaml.contains("  frame_id: map\nposes:\n- header:\n"));
    assert!(program.contains("MOVE ") && program.ends_with("STOP\n"));
    assert!(bytes.contains("\n0.000  80 ") && bytes.lines().last().unwrap().contains("  AD "));
    let stages: Value = serde_json::from_str(&json).unwrap();
    let links = stages["links"].as_array().unwrap().len();
    assert_eq!(links + 1, stages["points"].as_array().unwrap().len());
    assert_eq!(stages["points"][0]["status"], "left_wall");
}

#[test]
fn sweep_says_what_is_wrong() {
    let with = |more: &[&str]| failure(&[&["sweep", "--room", "room12ft"], more].concat());
    assert_eq!(with(&["--outline", "star:3"]).0, 2);
    assert_eq!(with(&["--outline", "circle:99"]).0, 2);
    assert_eq!(with(&["--cell", "-1"]).0, 2);
    assert_eq!(with(&["--scan-width", "nan"]).0, 2);
    assert_eq!(with(&["--out", "path.dwg"]).0, 2);
    assert_eq!(with(&["--robot", "nobody"]).0, 2);
    let (code, message) = with(&["--outline", "octagon:9"]);
    assert!(code == 4 && message.contains("9.00 m wide, fits nowhere"), "{message}");
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

#[test]
fn lanes_print_their_numbers_drive_and_write_files() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("lanes");
    fs::create_dir_all(&folder).unwrap();
    let csv = folder.join("lanes.csv");
    let out = csv.to_str().unwrap();
    let common = ["lanes", "--room", "bedroom", "--coverage", "95", "--effort", "5"];
    let json = text(&[&common[..], &["--drive", "--json", "--out", out]].concat());
    let report: Value = serde_json::from_str(&json).unwrap();
    let number = |key: &str| report[key].as_f64().unwrap();
    assert!(number("coverage") >= 0.95 && number("clearance_m") == 0.003);
    assert!(number("length_m") > number("bound_length_m") && number("duration_s") > number("bound_duration_s"));
    assert!(number("excess_length") > 0.0 && number("excess_duration") > 0.0);
    // The simulated robot waits at corners until its wheels stand still.
    let driven = report["driven"]["duration_s"].as_f64().unwrap();
    assert!((1.0..1.6).contains(&(driven / number("duration_s"))), "{report}");
    assert!(report["driven"]["coverage"].as_f64().unwrap() > 0.94, "{report}");
    assert!(fs::read_to_string(&csv).unwrap().lines().count() > 10);
    let text = text(&common);
    assert!(text.contains("Bound     at least") && text.contains("Excess"), "{text}");
}

#[test]
fn lanes_say_what_is_wrong() {
    let with = |more: &[&str]| failure(&[&["lanes", "--room", "bedroom"], more].concat());
    assert!(with(&["--coverage", "990"]).1.contains("coverage can't be 9.9"));
    assert_eq!(with(&["--coverage", "990"]).0, 2);
    assert!(with(&["--out", "lanes.dxf"]).1.contains("unknown file extension"));
    assert!(with(&["--robot", "nothing"]).1.contains("robovac robots"));
}
