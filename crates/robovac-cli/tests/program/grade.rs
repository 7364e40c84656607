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
    let parts = ["digest", "coverage_percent", "time_s", "distance_m"];
    assert_eq!(marks[2]["goals"][0]["misfits"], json!([{ "seed": 2, "parts": parts }]));
    // Numbers as the page wrote them fit; one that was changed afterwards is named, although the digest is left alone.
    let mut tampered = answer("Mallory", good);
    let mut runs = marks[0]["goals"][0]["verdict"]["runs"].clone();
    runs[1]["coverage_percent"] = json!(99.5);
    tampered["goals"]["more"]["runs"] = runs;
    let (_, text, _) = grade(&[&lesson, &file("mallory.json", &tampered.to_string())]);
    assert!(text.contains("| Mallory (mallory) | no, but not as claimed: coverage_percent of 1 run |"), "{text}");
    assert!(marks[1]["remarks"][0].as_str().unwrap().contains("\"room\" may not be changed"));
    assert!(marks[3]["remarks"][0].as_str().unwrap().contains("isn't an answer file"));

    let (_, csv, _) = grade(&[&all[..], &["--csv"]].concat());
    assert!(csv.contains("\n'=Eve,more,median coverage >= 40 %,"), "{csv}");
    let (_, page, _) = grade(&[&all[..], &["--html"]].concat());
    assert!(
        page.contains("<th>=Eve (eve)</th><td>no, but not as claimed: coverage_percent of 1 run, digest of 1 run,"),
        "{page}"
    );

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
    let told = grade(&[&unknown]).2;
    assert!(told.contains("unknown.md: line 4: the link \"planner=snail\": there is no algorithm \"snail\""), "{told}");
    let rooms = "# T\n```do\nlabel: x\nlink: room=livng\n```\n```do\nlabel: x\nlink: room=own&flat=seven\n```\n";
    let told = grade(&[&file("rooms.md", rooms)]).2;
    assert!(
        told.contains("line 4: the link \"room=livng\": there is no room \"livng\"; did you mean \"living\"?"),
        "{told}"
    );
    assert!(told.contains("line 8: the link \"room=own&flat=seven\": \"seven\" names no flat"), "{told}");
    let (code, text, notes) = grade(&[&file("noted.md", &LESSON.replace("change: algorithm, params\n", ""))]);
    assert!(
        code == 0
            && text.contains("in order")
            && notes.contains("note: line 7: the goal doesn't say what may be changed"),
        "{notes}"
    );
    let lesson = file("fine.md", LESSON);
    let seeds = file("bad-seeds.txt", "1\nx\n");
    let ada = file("one.json", &answer("Ada", "room=thesis8&behaviour=bounce&robot=roomba600").to_string());
    let (code, _, error) = grade(&[&lesson, &ada, "--seeds-file", &seeds]);
    assert!(code == 2 && error.contains("line 2: \"x\" isn't a seed"), "{error}");
}

const HOSTILE: &str = "# Hostile\n\n```lesson\nid: hostile\n```\n\n```goal\nid: drive\nin: room=thesis8&robot=roomba600&behaviour=bounce\nchange: program\nruns: 2\nminutes: 1\nneed: median coverage >= 5 %\n```\n";

/// An answer by a program in Python.
fn by_program(lesson: &str, goal: &str, link: &str, name: &str, source: &str) -> Value {
    let program = json!({ "name": "p", "language": "python", "kind": "behaviour", "source": source });
    json!({ "robovac_answer": 1, "lesson": lesson, "name": name, "goals": { goal: { "link": link, "program": program } } })
}

/// Whether programs of strangers can be kept in here: they must be where bubblewrap works. Elsewhere, such as in containers
/// that allow no namespaces, what `robovac grade` says must name it, and the mend.
fn has_walls(errors: &str, code: i32) -> bool {
    let refused = errors.contains("can't be kept from your files and the network");
    assert!(
        !refused || code == 1 && errors.contains("apt install bubblewrap") && errors.contains("--unconfined"),
        "{errors}"
    );
    let bubblewrap = Command::new("bwrap").args(["--unshare-all", "--ro-bind", "/", "/", "true"]).output();
    assert!(!refused || !bubblewrap.is_ok_and(|output| output.status.success()), "bubblewrap works here, but {errors}");
    !refused
}

// slow: a step and a start without end have a second and 15 s of their own time; memory and processes are refused at once
#[test]
fn hostile_programs_fail_with_their_cause_and_the_others_are_graded_all_the_same() {
    let secret = file("secret.txt", "nobody reads this");
    let listener = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    listener.set_nonblocking(true).unwrap();
    let port = listener.local_addr().unwrap().port();
    let good = "def run(robot):\n    while True:\n        yield robot.forward(9)\n        yield robot.turn(130)\n";
    let js = "function* run(robot) { for (;;) { yield robot.forward(9); yield robot.turn(130); } }";
    let answers = [
        ("loop", "def step(robot):\n    while True: pass\n".to_owned(), "a step took more than 1 s"),
        ("memory", "def step(robot):\n    kept = bytearray(4 << 30)\n".to_owned(), "line 2: MemoryError"),
        ("file", format!("def step(robot):\n    open({secret:?}).read()\n"), "line 2: FileNotFoundError"),
        ("write", "def step(robot):\n    open('/tmp/x', 'w')\n".to_owned(), "line 2: FileNotFoundError"),
        (
            "socket",
            format!("import socket\ndef step(robot):\n    socket.create_connection(('127.0.0.1', {port}))\n"),
            "line 3: PermissionError",
        ),
        ("fork", "import os\ndef step(robot):\n    while True: os.fork()\n".to_owned(), "line 3: PermissionError"),
        (
            "shell",
            "import subprocess\ndef step(robot):\n    subprocess.run(['/bin/ls'])\n".to_owned(),
            "line 3: PermissionError",
        ),
        (
            "secrets",
            "import os\ndef step(robot):\n    raise KeyError(str(len(os.environ.get('HOME', ''))))\n".to_owned(),
            "KeyError: '0'",
        ),
        ("good", good.to_owned(), ""),
    ];
    let lesson = file("hostile.md", HOSTILE);
    let link = "room=thesis8&robot=roomba600&behaviour=program";
    let mut files: Vec<String> = answers
        .iter()
        .map(|(name, source, _)| {
            file(&format!("hostile-{name}.json"), &by_program("hostile", "drive", link, name, source).to_string())
        })
        .collect();
    let mut other = by_program("hostile", "drive", link, "node", js);
    other["goals"]["drive"]["program"]["language"] = json!("javascript");
    files.push(file("hostile-node.json", &other.to_string()));
    let none =
        json!({ "robovac_answer": 1, "lesson": "hostile", "name": "none", "goals": { "drive": { "link": link } } });
    files.push(file("hostile-none.json", &none.to_string()));
    let all: Vec<&str> = std::iter::once(&lesson).chain(&files).map(String::as_str).collect();
    let (code, text, errors) = grade(&[&all[..], &["--json"]].concat());
    if !has_walls(&errors, code) {
        return;
    }
    assert_eq!((code, errors.as_str()), (0, "programs run without files, network and other processes (bubblewrap)\n"));
    let marks: Vec<Value> = serde_json::from_str(&text).unwrap();
    assert_eq!(marks.len(), files.len());
    for ((name, _, cause), mark) in answers.iter().zip(&marks) {
        let fault = mark["goals"][0]["fault"].as_str().unwrap();
        assert_eq!((mark["passed"].as_bool(), mark["name"].as_str()), (Some(cause.is_empty()), Some(*name)), "{mark}");
        assert!(
            fault.contains(cause) && (cause.is_empty() || fault.starts_with("seed 1: at 0.00 s: ")),
            "{name}: {fault}"
        );
    }
    assert_eq!(marks[9]["passed"], json!(true), "in JavaScript: {}", marks[9]);
    assert!(marks[10]["goals"][0]["fault"].as_str().unwrap().contains("contains none"), "{}", marks[10]);
    assert!(listener.accept().is_err(), "somebody has reached the network");
}

/// Places where a run of a program could leave something for the next one, and the lines that count there: in Python and in
/// JavaScript.
const PLACES: [(&str, &str); 9] = [
    ("python", "global count\n    count += 1\n    n = count"),
    ("python", "import math\n    n = math.count = getattr(math, 'count', 0) + 1"),
    (
        "python",
        "import os.path, collections.abc\n    n = collections.abc.count = getattr(collections.abc, 'count', 0) + 1",
    ),
    ("python", "import random\n    n = random.count = getattr(random, 'count', 0) + 1"),
    ("python", "kind = type(robot)\n    n = kind.count = getattr(kind, 'count', 0) + 1"),
    ("javascript", "const n = (globalThis.count = (globalThis.count ?? 0) + 1);"),
    ("javascript", "const n = (Math.count = (Math.count ?? 0) + 1);"),
    ("javascript", "const n = ([].constructor.prototype.count = ([].count ?? 0) + 1);"),
    (
        "javascript",
        "const kind = Object.getPrototypeOf(robot); let n = (Object.hasOwn(kind, 'count') ? kind.count : 0) + 1; kind.count = n;",
    ),
];

// slow: nine programs with three seeds, four times
#[test]
fn runs_know_nothing_of_each_other_however_many_are_made_at_a_time() {
    let lesson = file("apart.md", &HOSTILE.replace("id: hostile", "id: apart").replace("runs: 2", "runs: 3"));
    let link = "room=thesis8&robot=roomba600&behaviour=program";
    let files: Vec<String> = PLACES
        .iter()
        .enumerate()
        .map(|(number, (language, count))| {
            let source = if *language == "python" {
                format!("count = 0\ndef run(robot):\n    {count}\n    yield robot.forward(0.1 * n)\n")
            } else {
                format!("function* run(robot) {{\n  {count}\n  yield robot.forward(0.1 * n);\n}}\n")
            };
            let mut answer = by_program("apart", "drive", link, &format!("{number}"), &source);
            answer["goals"]["drive"]["program"]["language"] = json!(language);
            file(&format!("apart-{number}.json"), &answer.to_string())
        })
        .collect();
    let digests = |more: &[&str]| -> Vec<Vec<Value>> {
        let mut all = vec![lesson.as_str()];
        all.extend(files.iter().map(String::as_str));
        all.extend(["--json", "--unconfined"].iter().chain(more));
        let (code, text, errors) = grade(&all);
        assert_eq!(code, 0, "{errors}");
        let marks: Vec<Value> = serde_json::from_str(&text).unwrap();
        let runs = |mark: &Value| {
            let runs = mark["goals"][0]["verdict"]["runs"].as_array().unwrap_or_else(|| panic!("{mark:#}")).clone();
            runs.into_iter().map(|run| run["digest"].clone()).collect()
        };
        marks.iter().map(runs).collect()
    };
    let together = digests(&["--jobs", "1"]);
    assert_eq!(together, digests(&["--jobs", "2"]), "it depends on the number of jobs");
    for (index, seed) in ["1", "3"].iter().enumerate() {
        let seeds = file(&format!("apart-{seed}.txt"), seed);
        for (place, alone) in PLACES.iter().zip(digests(&["--seeds-file", &seeds]).iter().zip(&together)) {
            assert_eq!(alone.0[0], alone.1[2 * index], "seed {seed} knows of the runs before it: {place:?}");
        }
    }
}

/// The first program of a lesson: what learners start from.
fn starter(text: &str) -> String {
    text.split("```code python\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap().to_owned()
}

/// Programs of the answer files pass, and those that learners start from miss, with `runs` of the lesson's seeds.
fn programs_pass_and_starters_miss(runs: u64) {
    let lessons = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../lessons"));
    let mut seen = 0;
    for entry in fs::read_dir(lessons.join("answers")).unwrap() {
        let path = entry.unwrap().path();
        let mut answer: Value = serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
        if answer["goals"].as_object().unwrap().values().all(|goal| goal["program"].is_null()) {
            continue;
        }
        seen += 1;
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        let lesson = lessons.join(format!("{name}.md"));
        let seeds =
            file(&format!("{name}-seeds.txt"), &(1..=runs).map(|seed| seed.to_string()).collect::<Vec<_>>().join("\n"));
        let start = starter(&fs::read_to_string(&lesson).unwrap());
        let good = file(&format!("{name}-good.json"), &answer.to_string());
        for goal in answer["goals"].as_object_mut().unwrap().values_mut() {
            goal["program"]["source"] = json!(start);
        }
        let begun = file(&format!("{name}-start.json"), &answer.to_string());
        let (code, text, errors) =
            grade(&[&lesson.to_string_lossy(), &good, &begun, "--json", "--unconfined", "--seeds-file", &seeds]);
        assert_eq!(code, 0, "{errors}");
        let marks: Vec<Value> = serde_json::from_str(&text).unwrap();
        assert_eq!(marks[0]["passed"], json!(true), "{name}: {:#}", marks[0]["goals"]);
        let verdict = &marks[1]["goals"][0]["verdict"];
        assert_eq!(verdict["passed"], json!(false), "{name}: what learners start from: {verdict:#}");
    }
    assert_eq!(seen, 2, "lessons whose goals are reached by programs");
}

// slow: two runs of ten minutes of two programs in each of two lessons
#[test]
fn programs_of_the_lessons_answers_pass_and_those_that_they_start_from_miss() {
    programs_pass_and_starters_miss(2);
}

#[test]
#[ignore = "soak: all runs"]
fn programs_pass_and_starters_miss_with_all_seeds() {
    programs_pass_and_starters_miss(10);
}
