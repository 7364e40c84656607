//! `robovac monitor` with the virtual Roomba at the other end of its line.
#![cfg(unix)]

use super::virtual_roomba::Program;
use robovac_link::connection::{LineRecording, RecordedEvent};
use std::{
    fs,
    io::{BufRead, BufReader},
    process::{Command, Stdio},
};

fn monitor(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_robovac"));
    command.arg("monitor").args(arguments).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

#[test]
fn recording_is_whole_after_ctrl_c_and_sigterm() {
    for signal in ["INT", "TERM"] {
        let mut robot = Program::start(&format!("monitored-{signal}"), &[]);
        let port = robot.ready();
        let file = std::env::temp_dir().join(format!("robovac-{}-{signal}.txt", std::process::id()));
        let mut child = monitor(&[&port, "--record", file.to_str().unwrap()]).spawn().unwrap();
        let mut lines = BufReader::new(child.stdout.take().unwrap()).lines().map(Result::unwrap);
        let line = lines.find(|line| line.contains("frames/s")).expect("it reports what it hears");
        assert!(line.contains(" V ") && line.contains("encoders"), "{line}");
        assert!(Command::new("kill").args(["-s", signal, &child.id().to_string()]).status().unwrap().success());
        assert!(child.wait().unwrap().success(), "{signal}");
        let recording = LineRecording::parse(&fs::read_to_string(&file).unwrap()).unwrap();
        let has = |fits: fn(&RecordedEvent) -> bool| recording.entries.iter().any(|(_, event)| fits(event));
        assert!(has(|event| matches!(event, RecordedEvent::Received(bytes) if bytes.len() > 20)), "{signal}");
        let last = recording.entries.iter().rev().find_map(|(_, event)| match event {
            RecordedEvent::Sent(bytes) => Some(bytes),
            _ => None,
        });
        // It ends the interface, as when it ends by itself: Start, then Stop.
        assert!(last.is_some_and(|bytes| bytes.ends_with(&[173])), "{signal}: {last:?}");
        assert_eq!(robot.state()["commands"].as_u64().map(|count| count > 0), Some(true));
        fs::remove_file(file).unwrap();
    }
}

#[test]
fn slow_line_reports_only_what_is_received() {
    let mut robot = Program::start("slow", &["--personality", "slow"]);
    let port = robot.ready();
    let mut child = monitor(&[&port, "--seconds", "15"]).spawn().unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines().map(Result::unwrap);
    let line = lines.find(|line| line.contains("frames/s")).expect("it reports what it hears");
    assert!(!line.contains(" V ") && line.contains("encoders"), "{line}");
    child.kill().unwrap();
    child.wait().unwrap();
}

#[test]
fn what_cannot_work_is_refused_at_once() {
    let refused = |arguments: &[&str]| {
        let output = monitor(arguments).output().unwrap();
        (output.status.code(), String::from_utf8(output.stderr).unwrap())
    };
    for seconds in ["nan", "inf", "-1", "0"] {
        let (code, message) = refused(&["/dev/null", "--seconds", seconds]);
        assert!(code == Some(2) && message.contains("greater than 0"), "{seconds}: {code:?} {message}");
    }
    let (code, message) = refused(&["/dev/null", "--record", "/nowhere/recording.txt"]);
    assert!(code == Some(1) && message.contains("/nowhere/recording.txt"), "{code:?} {message}");
}
