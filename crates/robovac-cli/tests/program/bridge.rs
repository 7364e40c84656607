//! `robovac bridge` refuses what cannot work, at once. What it does is tested through the page (tests/e2e/connection-bridge).
#![cfg(unix)]

use super::virtual_roomba::Program;
use std::process::{Command, Stdio};

fn refused(arguments: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_robovac"));
    command.arg("bridge").args(arguments).stdin(Stdio::null()).env_remove("ROBOVAC_TOKEN");
    let output = command.output().unwrap();
    (output.status.code(), String::from_utf8(output.stderr).unwrap())
}

#[test]
fn options_that_cannot_work_are_refused_with_the_mend() {
    let here = ["--listen", "127.0.0.1:0"];
    for (arguments, words) in [
        (&["--token", "short"][..], "at least 8"),
        (&["--token", "has space in it"], "letters or digits"),
        (&["--origin", "example.org"], "a scheme and a host"),
        (&["--origin", "https://example.org/page"], "without a path"),
        (&["--baud", "12345"], "115200"),
        (&["--token", "abcd1234", "--no-token"], "cannot be used with"),
        (&["--port", "/nowhere"], "monitor list"),
    ] {
        let (code, message) = refused(&[&here, arguments].concat());
        assert!(code == Some(2) && message.contains(words), "{arguments:?}: {code:?} {message}");
    }
    let (code, message) = refused(&["--listen", "nowhere"]);
    assert!(code == Some(1) && message.contains("nowhere"), "{code:?} {message}");
}

#[test]
fn address_in_use_is_refused_before_the_robot_is_touched() {
    let mut robot = Program::start("bridge-address", &[]);
    let port = robot.ready();
    let listener = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let address = listener.local_addr().unwrap().to_string();
    let (code, message) = refused(&["--port", &port, "--listen", &address]);
    assert!(code == Some(1) && message.contains(&address), "{code:?} {message}");
    assert_eq!(robot.state()["commands"], 0);
}
