//! `robovac run`: programs of users, in the shell's language where no other is needed.
#![cfg(unix)]

use super::virtual_roomba::Program;
use robovac_core::{floor_plan::room, robot::model};
use robovac_sim::{
    Conditions,
    experiment::RoomSetup,
    program::{Lockstep, LogEnd},
};
use serde_json::Value;
use std::{
    fs,
    path::PathBuf,
    process::{Command, Output},
};

/// A file of its own for one test, with this content.
fn file(name: &str, content: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("run").join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(&path, content).unwrap();
    path
}

fn run(program: &PathBuf, command: &str, more: &[&str]) -> Output {
    let mut robovac = Command::new(env!("CARGO_BIN_EXE_robovac"));
    let room = if more.contains(&"--room") { &[][..] } else { &["--room", "bedroom"] };
    // Without a command it is run as its language is.
    let command = if command.is_empty() { &[][..] } else { &["--command", command] };
    robovac.arg("run").arg(program).args(command).args(room).args(more).output().unwrap()
}

/// A program in the shell's language: it greets, then answers each line as `step` says.
fn script(name: &str, step: &str) -> PathBuf {
    let greeting = r#"read hello; echo '{"ready":"behaviour"}'; n=0"#;
    file(name, &format!("{greeting}\nwhile read -r line; do n=$((n+1))\n{step}\ndone\n"))
}

fn report(output: &Output) -> Value {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// Exit code and message of a run that fails.
fn failure(program: &PathBuf, more: &[&str]) -> (i32, String) {
    let output = run(program, "sh", more);
    assert!(output.stdout.is_empty(), "{}", String::from_utf8_lossy(&output.stdout));
    (output.status.code().unwrap(), String::from_utf8(output.stderr).unwrap())
}

/// What the page's simulation would give for the same commands.
fn lockstep(seed: u64) -> Lockstep {
    let (plan, robot) = ((room("bedroom").unwrap().build)(), model("roomba600").unwrap());
    let setup = RoomSetup::new(&plan, robot, robot.default_cell, None).unwrap();
    Lockstep::new(&setup, Conditions::default(), seed, Vec::new())
}

#[test]
fn a_run_is_the_simulators_to_the_last_bit() {
    let drive = "if [ $n -gt 200 ]; then echo '{\"done\":true,\"print\":[\"enough\"]}'; else \
                 echo '{\"left\":280,\"right\":300.4}'; fi";
    let program = script("straight.sh", drive);
    let report = report(&run(&program, "sh", &["--json", "--seed", "7", "--seeds", "2"]));
    for (index, seed) in [7, 8].into_iter().enumerate() {
        let mut expected = lockstep(seed);
        assert_eq!(expected.steps([280.0, 300.4], 200), 200);
        expected.finish(LogEnd::Done);
        let run = &report["runs"][index];
        assert_eq!((&run["seed"], &run["end"], &run["kind"]), (&seed.into(), &"done".into(), &"behaviour".into()));
        assert_eq!(run["digest"], format!("{:016x}", expected.digest()));
        assert_eq!(run["prints"], serde_json::json!([[3.0, "enough"]]));
    }
}

#[test]
fn time_limit_and_text() {
    let program = script("wait.sh", "echo '{\"left\":0,\"right\":0}'");
    let output = run(&program, "sh", &["--minutes", "0.1"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("Run       stopped by --minutes, seed 1, digest "), "{text}");
    let output = run(&program, "sh", &["--minutes", "0.1", "--seeds", "3"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.lines().any(|line| line.trim_start().starts_with("median")), "{text}");
}

#[test]
fn faults_of_a_program_are_told() {
    for (name, step, expected) in [
        ("words.sh", "echo hello", "at 0.00 s: the program wrote \"hello\", which isn't a line of the protocol"),
        ("fault.sh", "echo '{\"error\":\"division by zero\",\"line\":7}'", "at 0.00 s: line 7: division by zero"),
        ("gone.sh", "echo 'out of ideas' >&2; exit 3", "the program ended before the run was over:\nout of ideas"),
        ("long.sh", "head -c 2000000 /dev/zero | tr '\\0' x", "a line of more than 1024 KB"),
        (
            "loud.sh",
            "p='\"x\"'; for i in 1 2 3 4 5 6 7; do p=\"$p,$p\"; done; echo \"{\\\"print\\\":[$p]}\"",
            "printed more than 10000 lines",
        ),
    ] {
        let (code, message) = failure(&script(name, step), &[]);
        assert_eq!(code, 5, "{name}: {message}");
        assert!(message.contains(expected) && message.contains("seed 1: "), "{name}: {message}");
    }
    let (code, message) = failure(&file("mute.sh", "read hello; echo '{}'"), &[]);
    assert!(code == 5 && message.contains("must answer the greeting"), "{message}");
    let (code, message) = failure(&PathBuf::from("nowhere.py"), &[]);
    assert!(code == 1 && message.contains("nowhere.py"), "{message}");
    let output = run(&file("a.py", ""), "no-such-interpreter", &[]);
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(message.contains("\"no-such-interpreter\" isn't installed"), "{message}");
}

// slow: a program that sleeps has four seconds for a step
#[test]
fn an_endless_step_is_ended_with_all_that_it_started() {
    let pid = file("pid", "");
    let program = script("endless.sh", &format!("sleep 1000 & echo $! > {}; wait", pid.display()));
    let (code, message) = failure(&program, &[]);
    assert!(code == 5 && message.contains("at 0.00 s: a step took more than 1 s"), "{message}");
    let sleeper = fs::read_to_string(&pid).unwrap();
    // One that nobody has waited for yet is a zombie.
    let state = Command::new("ps").args(["-o", "stat=", "-p", sleeper.trim()]).output().unwrap();
    let state = String::from_utf8(state.stdout).unwrap();
    assert!(state.trim().is_empty() || state.starts_with('Z'), "the sleeper is still there: {state}");
}

#[test]
fn a_planner_is_asked_for_cells_and_checked() {
    let planner = |name: &str, answer: &str| {
        file(name, &format!("read hello; echo '{{\"ready\":\"planner\"}}'; read room; {answer}\n"))
    };
    let jump = planner("jump.sh", "echo '{\"cells\":[[0,0]]}'; echo '{\"cells\":[[5,5]],\"done\":true}'");
    let output = run(&jump, "sh", &["--room", "empty", "--robot", "cell", "--cell", "0.5", "--start", "0,0"]);
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(message.contains("step 1 jumps from (0, 0) to (5, 5)"), "{message}");
    let short = planner("short.sh", "echo '{\"cells\":[[0,0],[1,0]],\"done\":true}'");
    let output =
        run(&short, "sh", &["--room", "empty", "--robot", "cell", "--cell", "0.5", "--start", "0,0", "--json"]);
    let run = &report(&output)["runs"][0];
    assert_eq!((&run["end"], &run["walk"]["steps"]), (&"done".into(), &1.into()));
    assert!(run["misses"]["cells"].as_u64().unwrap() > 10, "{run}");
}

#[test]
fn the_example_in_c_cleans() {
    let source = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/program-in-c/bounce.c");
    let binary = file("bounce", "");
    let compiled = Command::new("cc").args(["-O1", "-Wall", "-Werror", "-o"]).arg(&binary).arg(source).output();
    let compiled = compiled.expect("cc is there, as ./dev tools installs it");
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    let command = binary.to_string_lossy().into_owned();
    let report = report(&run(&PathBuf::from(source), &command, &["--json", "--minutes", "2"]));
    let run = &report["runs"][0];
    assert!(run["coverage"].as_f64().unwrap() > 0.1 && run["bumps"].as_u64().unwrap() > 3, "{run}");
    assert!(run["prints"][0][1].as_str().unwrap().starts_with("bump, "), "{run}");
}

/// The examples in both languages, by the runtimes that the program carries: the same commands, so the same state.
#[test]
fn python_and_javascript_give_the_same_digest() {
    let examples = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../programs/examples"));
    for interpreter in ["python3", "node"] {
        let version = Command::new(interpreter).arg("--version").output();
        assert!(version.is_ok(), "{interpreter} is missing; ./dev tools installs it");
    }
    let digest = |name: &str| {
        let mut robovac = Command::new(env!("CARGO_BIN_EXE_robovac"));
        let output = robovac.arg("run").arg(examples.join(name)).args(["--json", "--minutes", "0.5"]).output().unwrap();
        report(&output)["runs"][0]["digest"].as_str().unwrap().to_owned()
    };
    for example in ["turn_when_you_bump", "plan_in_rows"] {
        assert_eq!(digest(&format!("{example}.py")), digest(&format!("{example}.js")), "{example}");
    }
}

/// In real time, as the robot answers in real time.
#[test]
fn a_program_drives_a_virtual_roomba_in_safe_mode() {
    let mut robot = Program::start("driven", &["--room", "empty"]);
    let port = robot.ready();
    let before = robot.state();
    let steps = "if [ $n -gt 40 ]; then echo '{\"done\":true}'; else echo '{\"left\":500,\"right\":500}'; fi";
    let program = script("drive.sh", steps);
    let mut robovac = Command::new(env!("CARGO_BIN_EXE_robovac"));
    robovac.arg("drive").arg(&program).args(["--command", "sh", "--port", &port, "--speed", "0.2"]);
    let output = robovac.output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(text.contains("in Safe mode, at most 0.2 m/s") && text.contains("done"), "{text}");
    let after = robot.wait_for("it is released", |state| state["mode"] == "Off");
    let [x, y] = ["x", "y"].map(|key| after["pose"][key].as_f64().unwrap() - before["pose"][key].as_f64().unwrap());
    let moved = x.hypot(y);
    assert!((0.03..0.4).contains(&moved), "{moved} m: {after}");
}

/// In real time, as above.
#[test]
fn a_behaviour_drives_a_virtual_roomba_no_faster_than_it_may() {
    let log = std::env::temp_dir().join(format!("robovac-{}-behaving.log", std::process::id()));
    let mut robot = Program::start("behaving", &["--room", "empty", "--log", log.to_str().unwrap()]);
    let port = robot.ready();
    let before = robot.state();
    let drive = |options: &[&str]| {
        Command::new(env!("CARGO_BIN_EXE_robovac")).args(["drive", "--port", &port]).args(options).output().unwrap()
    };
    let wrong = drive(&["--behaviour", "learnt"]);
    let message = String::from_utf8_lossy(&wrong.stderr);
    assert!(wrong.status.code() == Some(2) && message.contains("learnt"), "{message}");
    let by_hand = drive(&["--behaviour", "manual"]);
    assert!(String::from_utf8_lossy(&by_hand.stderr).contains("driven by hand"));
    assert_eq!(drive(&[]).status.code(), Some(2), "nobody drives");
    assert_eq!(robot.state()["pose"], before["pose"], "nothing of that reached the robot");
    let output = drive(&["--behaviour", "learned", "--speed", "0.1", "--seconds", "1.5"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(text.contains("at most 0.1 m/s, brushes and vacuum on;") && text.contains("stopped"), "{text}");
    let after = robot.wait_for("it is released", |state| state["mode"] == "Off");
    let [x, y] = ["x", "y"].map(|key| after["pose"][key].as_f64().unwrap() - before["pose"][key].as_f64().unwrap());
    let heading = |state: &Value| state["pose"]["heading_deg"].as_f64().unwrap();
    let (moved, turned) = (x.hypot(y), heading(&after) - heading(&before));
    assert!(moved < 0.17 && (moved > 0.01 || turned.abs() > 3.0), "{moved} m, {turned}: {after}");
    // Main brush, side brush and vacuum run in between, and only there.
    let motors = || -> Vec<String> {
        let text = fs::read_to_string(&log).unwrap();
        let bytes = text.lines().filter_map(|line| line.split_once("command 138 "));
        bytes.map(|(_, bits)| bits.to_owned()).collect()
    };
    let cleaned = motors();
    assert!(cleaned[0] == "7" && cleaned[1..].iter().all(|bits| bits == "0") && cleaned.len() > 1, "{cleaned:?}");
    for off in [&["--behaviour", "learned", "--brushes", "off"][..], &["--behaviour", "explore_look_around"]] {
        assert!(drive(&[off, &["--seconds", "0.1"]].concat()).status.success());
        assert!(motors()[1..].iter().all(|bits| bits == "0"), "{off:?}: {:?}", motors());
    }
    fs::remove_file(&log).unwrap();
}

// slow: a second is the limit of a step
#[test]
fn a_program_that_hangs_is_ended_and_its_robot_stopped_before() {
    let mut robot = Program::start("hanging", &["--room", "empty"]);
    let port = robot.ready();
    let steps = "if [ $n -gt 5 ]; then sleep 1000; else echo '{\"left\":200,\"right\":200}'; fi";
    let program = script("hang.sh", steps);
    let mut robovac = Command::new(env!("CARGO_BIN_EXE_robovac"));
    let output = robovac.arg("drive").arg(&program).args(["--command", "sh", "--port", &port]).output().unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.code() == Some(5) && message.contains("a step took more than 1 s"), "{message}");
    let state = robot.wait_for("it is released", |state| state["mode"] == "Off");
    // The wheels were stopped 200 ms after the last answer, 800 ms before the program was ended.
    let since = state["time_s"].as_f64().unwrap() - state["last_motion_s"].as_f64().unwrap();
    assert!(since > 0.6, "{since} s: {state}");
}

#[test]
fn kept_commands_and_frames_save_questions_and_change_no_bit() {
    let package = concat!(env!("CARGO_MANIFEST_DIR"), "/../../programs/python");
    // The client of `robovac run`, by lines; with `offer` as the host's word for what it offers.
    let client = |name: &str, offer: &str| {
        let text = format!(
            "import sys\nsys.path.insert(0, {package:?})\nfrom robovac_program import native\nasked = 0\n\
             def read():\n    global asked\n    asked += 1\n    return sys.__stdin__.readline().replace('\"frames\"', '\"no\"').replace('\"holds\"', '\"{offer}\"')\n\
             def write(text):\n    sys.__stdout__.write(text)\n    sys.__stdout__.flush()\n\
             try:\n    native.serve(sys.argv[1], read, write)\nfinally:\n    open(sys.argv[0] + '.asked', 'w').write(str(asked))\n"
        );
        file(name, &text)
    };
    let moves = "def run(robot):\n    while True:\n        yield robot.forward(0.7, 0.4)\n        yield robot.turn(robot.choice([1, -1]) * robot.randint(20, 180))\n        yield robot.arc(0.3, -200)\n        yield robot.wait(0.5)\n        yield robot.forward(-0.2)\n";
    let program = file("moves.py", moves);
    for slip in ["none", "harsh"] {
        let [kept, each] = [("keeps.py", "holds"), ("asks.py", "no")].map(|(name, offer)| {
            let client = client(name, offer);
            let more = ["--json", "--minutes", "3", "--slip", slip, "--noise", "harsh"];
            let report = report(&run(&program, &format!("python3 -B {}", client.display()), &more));
            let asked: u32 = fs::read_to_string(format!("{}.asked", client.display())).unwrap().parse().unwrap();
            (report["runs"][0]["digest"].clone(), asked)
        });
        assert_eq!(kept.0, each.0, "slip: {slip}");
        let framed = report(&run(&program, "", &["--json", "--minutes", "3", "--slip", slip, "--noise", "harsh"]));
        assert_eq!(framed["runs"][0]["digest"], each.0, "by frames, slip: {slip}");
        assert!(each.1 > 12_000 && kept.1 < each.1 / 2, "{} of {} questions", kept.1, each.1);
    }
}
