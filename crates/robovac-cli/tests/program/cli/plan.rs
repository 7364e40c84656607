//! What plans: `plan`, `compare`, `sweep` and `lanes`.

use super::{failure, file, text};
use coverage_planners::{PLANNERS, metrics::METRICS};
use floor_drawing::{Stroke, read};
use robovac_core::floor_plan::SourceFile;
use serde_json::Value;
use std::{collections::HashSet, fs, path::PathBuf};

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
fn every_planner_plans_the_thesis_preset() {
    for planner in PLANNERS {
        let output = text(&["plan", "--room", "thesis8", "--planner", planner.id, "--json"]);
        assert_eq!(output.lines().count(), 1);
        let report: Value = serde_json::from_str(&output).unwrap();
        if planner.is_in_metres() {
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
fn lanes_print_their_numbers_drive_and_write_files() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("lanes");
    fs::create_dir_all(&folder).unwrap();
    let [csv, dxf, bag] = ["csv", "dxf", "mcap"].map(|ending| folder.join("lanes").with_extension(ending));
    let out = [&csv, &dxf, &bag].map(|file| ["--out", file.to_str().unwrap()]).concat();
    let common = ["lanes", "--room", "bedroom", "--coverage", "95", "--effort", "5"];
    let json = text(&[&common[..], &["--drive", "--json"], &out].concat());
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
    // The drawing has the path on a layer of its own, in metres, as long as was told.
    let drawing = read(&SourceFile { name: "lanes.dxf".into(), bytes: fs::read(&dxf).unwrap() }).unwrap();
    let is_path = |stroke: &&Stroke| drawing.layers[stroke.layer as usize].name == "PATH";
    let drawn: Vec<_> = drawing.strokes.iter().filter(is_path).collect();
    assert!(drawing.metre == Some(1.0) && drawn.len() == 1 && drawing.layers.len() > 1, "{:?}", drawing.layers);
    let corners = drawing.corners(drawn[0]);
    assert_eq!(corners.len() as f64, number("corners"));
    let length: f64 = corners.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum();
    assert!((length - number("length_m")).abs() < 0.01, "{length} {report}");
    assert!(fs::read(&bag).unwrap().starts_with(b"\x89MCAP"));
    let text = text(&common);
    assert!(text.contains("Bound     at least") && text.contains("Excess"), "{text}");
}

/// What `--smooth` saves is the trajectory: every file takes its time and ends where it does.
#[test]
fn lanes_with_rounded_corners_are_so_in_every_file() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("lanes_smooth");
    fs::create_dir_all(&folder).unwrap();
    let files = ["csv", "yaml", "mcap", "oi.txt", "txt", "dxf"].map(|ending| folder.join(format!("s.{ending}")));
    let out = files.each_ref().map(|file| ["--out", file.to_str().unwrap()]).concat();
    let common = ["lanes", "--room", "bedroom", "--coverage", "95", "--effort", "5", "--smooth"];
    let report: Value = serde_json::from_str(&text(&[&common[..], &["--json"], &out].concat())).unwrap();
    let smooth = |key: &str| report["smooth"][key].as_f64().unwrap();
    let (seconds, metres) = (smooth("duration_s"), smooth("length_m"));
    assert!(seconds < 0.9 * report["duration_s"].as_f64().unwrap(), "{report}");
    assert!(smooth("bound_duration_s") < seconds && smooth("bound_length_m") < metres, "{report}");
    assert!((smooth("excess_duration") - (seconds / smooth("bound_duration_s") - 1.0)).abs() < 1e-9, "{report}");
    let [csv, yaml, _, bytes, program, _] = files.each_ref().map(|file| fs::read_to_string(file).unwrap_or_default());
    let rows: Vec<Vec<f64>> =
        csv.lines().skip(1).map(|row| row.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
    let end = rows.last().unwrap();
    assert!((end[4] - seconds).abs() < 1e-3 && (end[3] - metres).abs() < 1e-3, "{end:?} {report}");
    // As far as the rows tell it: chords are shorter than curves.
    let way: f64 = rows.windows(2).map(|pair| (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1])).sum();
    assert!((0.99..1.0).contains(&(way / metres)), "{way} {metres}");
    assert_eq!(yaml.matches("  pose:").count(), rows.len());
    assert!(yaml.contains(&format!("sec: {}, ", seconds.floor())), "{seconds}");
    // The program's times, and those of the bytes.
    let times = program.lines().filter_map(|line| line.strip_suffix(" s")?.rsplit_once(" in ")?.1.parse::<f64>().ok());
    assert!((times.sum::<f64>() - seconds).abs() < 2e-3, "{seconds}");
    let last = bytes.lines().last().unwrap();
    let takes = last.split(' ').next().unwrap().parse::<f64>().unwrap() / seconds;
    assert!((1.0..1.03).contains(&takes) && last.contains("  AD "), "{takes} {last}");
    assert!(bytes.lines().nth_back(1).unwrap().contains("stand still"), "{bytes}");
    // Its head said that the Roomba wasn't the robot that the path was planned for.
    assert!(bytes.contains("# planned   for the Roomba 600") && !bytes.contains("not the robot"), "{bytes}");
    // Times of the bag's messages are as far as those of the path.
    assert!(fs::read(&files[2]).unwrap().starts_with(b"\x89MCAP"));
    let drawing = read(&SourceFile { name: "s.dxf".into(), bytes: fs::read(&files[5]).unwrap() }).unwrap();
    let drawn = drawing.strokes.iter().find(|stroke| drawing.layers[stroke.layer as usize].name == "PATH").unwrap();
    let corners = drawing.corners(drawn);
    let length: f64 = corners.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum();
    assert!((length - metres).abs() < 0.01, "{length} {metres}");
    let told = text(&common);
    assert!(told.contains("in minutes: without stops at least"), "{told}");
}

#[test]
fn a_coverage_out_of_reach_is_told_with_the_most_that_can_be() {
    let base = ["plan", "--room", "bedroom", "--robot", "roomba600", "--planner", "boustrophedon", "--coverage"];
    let (missed, reached) = (text(&[&base[..], &["100"]].concat()), text(&[&base[..], &["90"]].concat()));
    assert!(
        missed.contains("\nMissed    none of the planning cells tried reach 100.00 %: those of 0.")
            && !reached.contains("Missed")
    );
    let json: Value = serde_json::from_str(&text(&[&base[..], &["100", "--json"]].concat())).unwrap();
    let most = json["missed"]["most"].as_f64().unwrap();
    assert!(missed.contains(&format!("sweep most, {:.2} %\n", 100.0 * most)), "{missed}");
    assert!((json["excess"]["swept"].as_f64().unwrap() - most).abs() < 1e-3, "it is the plan that was made: {json}");
    let simulated = text(&["simulate", "--room", "bedroom", "--planner", "boustrophedon", "--coverage", "100"]);
    assert!(simulated.contains("\nMissed    none of the planning cells tried reach 100.00 %"), "{simulated}");
}

#[test]
fn lanes_say_what_is_wrong() {
    let with = |more: &[&str]| failure(&[&["lanes", "--room", "bedroom"], more].concat());
    assert!(with(&["--coverage", "990"]).1.contains("coverage can't be 9.9"));
    assert_eq!(with(&["--coverage", "990"]).0, 2);
    assert!(with(&["--out", "lanes.dwg"]).1.contains("unknown file extension"));
    assert!(with(&["--robot", "nothing"]).1.contains("robovac robots"));
}
