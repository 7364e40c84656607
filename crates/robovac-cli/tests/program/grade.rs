//! `robovac grade`: answers are run again, and what is odd is told.

use serde_json::{Value, json};
use std::{fs, path::PathBuf, process::Command};

const LESSON: &str = "# Small\n\n```lesson\nid: small\n```\n\n```goal\nid: more\nin: room=thesis8&robot=roomba600&behaviour=bounce&p.least=180&p.most=180\nchange: algorithm, params\nruns: 3\nminutes: 2\nneed: median coverage >= 40 %\n```\n\n```quiz median\nrounds: 1\n```\n";

fn file(name: &str, content: &str) -> String {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("grade");
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join(name), content).unwrap();
    folder.join(name).to_string_lossy().into_owned()
}

/// Exit code, output and errors.
fn grade(arguments: &[&str]) -> (i32, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_robovac")).arg("grade").args(arguments).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

fn answer(name: &str, link: &str) -> Value {
    json!({ "robovac_answer": 1, "lesson": "small", "name": name, "goals": { "more": { "link": link } }, "quizzes": { "quiz-1": { "answers": [[1, "nothing"]] } } })
}

#[test]
fn answers_are_run_again_and_odd_ones_are_told() {
    let lesson = file("small.md", LESSON);
    let good = "room=thesis8&planner=boustrophedon&robot=roomba600";
    let mut cheat = answer("=Eve", good);
    cheat["goals"]["more"]["runs"] =
        json!([{ "seed": 2, "coverage_percent": 100.0, "time_s": 1.0, "distance_m": 1.0, "digest": "00" }]);
    let files = [
        file("ada.json", &answer("Ada", good).to_string()),
        file(
            "start.json",
            &answer("", "room=flat&behaviour=bounce&p.least=180&p.most=180&robot=roomba600").to_string(),
        ),
        file("eve.json", &cheat.to_string()),
        file("broken.json", "{"),
    ];
    let all: Vec<&str> = std::iter::once(&lesson).chain(&files).map(String::as_str).collect();
    let (code, text, errors) = grade(&[&all[..], &["--json"]].concat());
    assert_eq!((code, errors.as_str()), (0, ""));
    let marks: Vec<Value> = serde_json::from_str(&text).unwrap();
    let names: Vec<&str> = marks.iter().map(|mark| mark["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["Ada", "start", "=Eve", "broken"]);
    let reached = |mark: &Value| mark["goals"][0]["verdict"]["passed"].as_bool();
    assert_eq!((reached(&marks[0]), reached(&marks[1]), reached(&marks[2])), (Some(true), Some(false), Some(true)));
    // The quiz isn't answered.
    assert_eq!((&marks[0]["passed"], &marks[0]["quizzes"][0]["right"]), (&json!(false), &json!(0)));
    assert_eq!(marks[2]["goals"][0]["misfits"], json!([2]));
    assert!(marks[1]["remarks"][0].as_str().unwrap().contains("\"room\" may not be changed"));
    assert!(marks[3]["remarks"][0].as_str().unwrap().contains("isn't an answer file"));

    let (_, csv, _) = grade(&[&all[..], &["--csv"]].concat());
    assert!(csv.contains("\n'=Eve,more,median coverage >= 40 %,"), "{csv}");
    let (_, page, _) = grade(&[&all[..], &["--html"]].concat());
    assert!(page.contains("digests that don&#39;t fit: 1") || page.contains("digests that don't fit: 1"), "{page}");

    let seeds = file("seeds.txt", "# secret\n7\n8 # and this\n");
    let (_, text, _) = grade(&[&lesson, &files[0], "--json", "--seeds-file", &seeds]);
    let marks: Vec<Value> = serde_json::from_str(&text).unwrap();
    let used: Vec<u64> = marks[0]["goals"][0]["verdict"]["runs"]
        .as_array()
        .unwrap()
        .iter()
        .map(|run| run["seed"].as_u64().unwrap())
        .collect();
    assert_eq!(used, [7, 8]);
}

#[test]
fn faults_of_lessons_and_seeds_name_place_and_mend() {
    let broken = file("broken.md", "# T\n```do\nlable: x\n```\n");
    let (code, _, error) = grade(&[&broken]);
    assert_eq!(code, 2);
    assert!(error.contains("broken.md: line 2: the block \"do\" has no line \"label\"; add e.g."), "{error}");
    let unknown = file("unknown.md", "# T\n```do\nlabel: x\nlink: planner=snail\n```\n");
    assert!(
        grade(&[&unknown]).2.contains("the link \"planner=snail\": there is no algorithm \"snail\""),
        "{}",
        grade(&[&unknown]).2
    );
    let lesson = file("fine.md", LESSON);
    let seeds = file("bad-seeds.txt", "1\nx\n");
    let ada = file("one.json", &answer("Ada", "room=thesis8&behaviour=bounce&robot=roomba600").to_string());
    let (code, _, error) = grade(&[&lesson, &ada, "--seeds-file", &seeds]);
    assert!(code == 2 && error.contains("line 2: \"x\" isn't a seed"), "{error}");
}
