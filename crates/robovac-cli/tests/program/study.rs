//! Studies: resumed after a kill, in parts, merged, and each row made again by its command.
#![cfg(unix)]

use serde_json::Value;
use std::{
    fs,
    path::{Path, PathBuf},
    process::{Command, Output, Stdio},
    thread,
    time::Duration,
};

fn robovac(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_robovac")).args(arguments).output().unwrap()
}

/// An empty folder for one test, with a study of `seeds` runs of a minute for each of two behaviours in a flat.
fn folder(name: &str, seeds: u32) -> (PathBuf, String) {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let study = format!(
        r#"{{
          "format": "robovac-study", "version": 1,
          "rooms": [{{ "flats": {{ "first": 1, "count": 1, "area_m2": [25, 30] }} }}],
          "robots": [{{ "robot": "roomba600" }}],
          "algorithms": [{{ "behaviour": "bounce" }}, {{ "behaviour": "random_walk" }}],
          "conditions": [{{ "name": "typical", "slip": "typical", "noise": "typical" }}],
          "seeds": {{ "first": 1, "count": {seeds} }}, "minutes": 1
        }}"#
    );
    let file = folder.join("study.json");
    fs::write(&file, study).unwrap();
    (folder, file.to_string_lossy().into_owned())
}

fn shards(folder: &Path) -> usize {
    let is_shard = |path: PathBuf| path.extension().is_some_and(|ending| ending == "jsonl");
    fs::read_dir(folder).map_or(0, |entries| entries.flatten().filter(|entry| is_shard(entry.path())).count())
}

fn out(folder: &Path, name: &str) -> String {
    folder.join(name).to_string_lossy().into_owned()
}

// slow: hundreds of runs, so that the kill comes in the middle
#[test]
fn a_killed_study_goes_on_and_gives_the_same_bytes() {
    let (folder, study) = folder("study-killed", 200);
    let whole = out(&folder, "whole.parquet");
    let done = robovac(&["study", &study, "--out", &whole]);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    assert!(!folder.join("whole.parquet.shards").exists());

    let killed = out(&folder, "killed.parquet");
    let mut child = Command::new(env!("CARGO_BIN_EXE_robovac"))
        .args(["study", &study, "--out", &killed, "--jobs", "1"])
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let parts = folder.join("killed.parquet.shards");
    while shards(&parts) < 2 {
        assert!(child.try_wait().unwrap().is_none(), "it wasn't stopped in the middle");
        thread::sleep(Duration::from_millis(2));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let left = shards(&parts);
    assert!((2..8).contains(&left) && !Path::new(&killed).exists(), "{left}");
    let again = robovac(&["study", &study, "--out", &killed]);
    let said = String::from_utf8_lossy(&again.stderr);
    assert!(again.status.success() && said.contains(&format!("{left} of 8 shards are there already")), "{said}");
    assert!(fs::read(&killed).unwrap() == fs::read(&whole).unwrap(), "other bytes");
}

#[test]
fn parts_of_several_machines_give_the_same_bytes() {
    let (folder, study) = folder("study-parts", 60);
    let (whole, parts) = (out(&folder, "whole.parquet"), out(&folder, "parts.parquet"));
    assert!(robovac(&["study", &study, "--out", &whole]).status.success());
    for part in ["1/2", "2/2"] {
        let early = robovac(&["study", "merge", &study, "--out", &parts]);
        assert!(String::from_utf8_lossy(&early.stderr).contains("shards are missing"));
        assert!(robovac(&["study", &study, "--out", &parts, "--shard", part]).status.success());
    }
    let merged = robovac(&["study", "merge", &study, "--out", &parts]);
    assert!(String::from_utf8_lossy(&merged.stdout).ends_with(": 120 runs\n"));
    assert!(fs::read(&parts).unwrap() == fs::read(&whole).unwrap(), "other bytes");
    let twice = robovac(&["study", &study, "--out", &whole]);
    assert_eq!(twice.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&twice.stderr).contains("the file exists"));
}

#[test]
fn shards_of_another_study_are_refused() {
    let (folder, study) = folder("study-other", 60);
    let path = out(&folder, "a.parquet");
    assert!(robovac(&["study", &study, "--out", &path, "--shard", "1/3"]).status.success());
    let text = fs::read_to_string(&study).unwrap().replace("\"minutes\": 1", "\"minutes\": 2");
    fs::write(&study, text).unwrap();
    let refused = robovac(&["study", &study, "--out", &path]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("of another study"));
    let checked = robovac(&["study", "check", &study]);
    assert!(String::from_utf8_lossy(&checked.stdout).starts_with("120 runs in 1 rooms, 3 shards"));
}

#[test]
fn a_row_is_made_again_by_its_command() {
    let (folder, study) = folder("study-row", 60);
    assert!(robovac(&["study", &study, "--out", &out(&folder, "a.parquet"), "--shard", "3/3"]).status.success());
    let shard = fs::read_to_string(folder.join("a.parquet.shards/00000002.jsonl")).unwrap();
    let row: Value = serde_json::from_str(shard.lines().next().unwrap()).unwrap();
    assert_eq!(row["run"], 100);
    let read = robovac_sim::study::Study::read("study.json", &fs::read(&study).unwrap()).unwrap();
    let command = read.command(&read.run(100).unwrap());
    let arguments: Vec<&str> = command.split(' ').skip(1).collect();
    let made: Value = serde_json::from_slice(&robovac(&arguments).stdout).unwrap();
    assert_eq!(made["algorithms"][0]["each"][0]["digest"], row["outcome"]["digest"], "{command}");
}

#[test]
fn a_flat_is_generated_by_its_seed() {
    let text = |arguments: &[&str]| String::from_utf8(robovac(arguments).stdout).unwrap();
    let picture = text(&["generate", "--seed", "7"]);
    assert!(picture.starts_with("; resolution 0.05\n; name Flat 7\n") && picture.contains('S'), "{picture}");
    assert_eq!(text(&["generate", "--seed", "7"]), picture);
    assert_ne!(text(&["generate", "--seed", "8"]), picture);
    // The file holds the same flat as the option of other commands.
    let file = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("flat-7.json");
    let file = file.to_string_lossy();
    assert!(robovac(&["generate", "--seed", "7", "--area", "25..30", "--no-rugs", "--out", &file]).status.success());
    let drive = |source: [&str; 2]| {
        let report = text(&["simulate", source[0], source[1], "--behaviour", "bounce", "--max-time", "20", "--json"]);
        serde_json::from_str::<Value>(&report).unwrap()["digest"].clone()
    };
    assert_eq!(drive(["--map", &file]), drive(["--flat", "7~area:25..30~rugs:no"]));
    for wrong in [&["generate", "--area", "10"][..], &["generate", "--furniture", "2"], &["generate", "--area", "x"]] {
        assert_eq!(robovac(wrong).status.code(), Some(2), "{wrong:?}");
    }
}

#[test]
fn the_benchmark_makes_a_table_of_a_study_of_ones_own() {
    let (folder, study) = folder("benchmark", 3);
    let own = out(&folder, "own");
    let done = robovac(&["benchmark", "--study", &study, "--out", &own]);
    let text = String::from_utf8_lossy(&done.stdout).into_owned();
    assert!(text.starts_with("| algorithm | flats, typical | runs without results |\n"), "{text}");
    assert!(text.contains("| 0 of 3 |") && text.contains("digest of all runs"), "{text}");
    let refused = robovac(&["benchmark", "--study", &study, "--out", &own]);
    assert!(String::from_utf8_lossy(&refused.stderr).contains("runs.parquet: the file exists"));
}

#[test]
#[ignore = "soak: every algorithm plans and drives"]
fn the_benchmark_has_a_line_for_every_algorithm() {
    let (folder, _) = folder("benchmark-quick", 1);
    let quick = out(&folder, "quick");
    let done = robovac(&["benchmark", "--quick", "--out", &quick]);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let read = |name: &str| fs::read_to_string(Path::new(&quick).join(name)).unwrap();
    let (table, listed) = (read("table.md"), robovac(&["planners"]).stdout);
    assert_eq!(table, String::from_utf8_lossy(&done.stdout));
    for line in String::from_utf8_lossy(&listed).lines().chain(["bounce", "cleaning_cycle"]) {
        let id = line.split_whitespace().next().unwrap();
        assert!(table.contains(&format!("| `{id}` | ")), "{id} isn't in\n{table}");
    }
    // Four groups for each algorithm, and a head; its study makes the same runs.
    let algorithms = table.lines().filter(|line| line.starts_with("| `")).count();
    assert_eq!(read("table.csv").lines().count(), 1 + 4 * algorithms);
    let again = robovac(&["study", "check", &format!("{quick}/study.json")]);
    assert!(String::from_utf8_lossy(&again.stdout).starts_with(&format!("{} runs", 6 * algorithms)));
}
