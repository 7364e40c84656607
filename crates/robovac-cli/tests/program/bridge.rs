//! `robovac bridge` between clients and an emulated robot. The page's part is tested in tests/e2e/connection-bridge.
#![cfg(unix)]

use super::virtual_roomba::Program;
use std::{
    io::{BufRead, BufReader, ErrorKind},
    net::{TcpListener, TcpStream},
    os::unix::net::UnixDatagram,
    process::{Child, Command, Stdio},
    thread,
    time::{Duration, Instant},
};
use tungstenite::{Error, Message, WebSocket};

const PATIENCE: Duration = Duration::from_secs(20);
/// To Safe, and on the spot: it never meets a wall.
const TURN: [u8; 6] = [131, 145, 0, 100, 255, 156];
/// The robot stands by the bridge's order.
const STOPS: [&str; 2] = ["/asked/left", "/asked/right"];

/// A running bridge, which is killed at the end of the test.
struct Bridge {
    child: Child,
    url: String,
}

impl Bridge {
    fn start(port: &str, variables: &[(&str, &str)]) -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_robovac"));
        command.args(["bridge", "--port", port, "--listen", "127.0.0.1:0"]).envs(variables.iter().copied());
        let mut child = command.stdin(Stdio::null()).stdout(Stdio::piped()).spawn().unwrap();
        let mut told = BufReader::new(child.stdout.take().unwrap()).lines();
        let ready = told.next().unwrap().unwrap();
        // What it prints is read to the end, so that it isn't held up.
        thread::spawn(move || told.for_each(drop));
        Self { child, url: ready.strip_prefix("ready ").expect("ready").to_owned() }
    }
}

impl Drop for Bridge {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

struct Client(WebSocket<TcpStream>);

impl Client {
    fn connect(bridge: &Bridge) -> Self {
        let stream = TcpStream::connect(bridge.url.trim_start_matches("ws://").trim_end_matches('/')).unwrap();
        let (socket, _) = tungstenite::client(&bridge.url, stream).unwrap();
        socket.get_ref().set_read_timeout(Some(Duration::from_millis(5))).unwrap();
        Self(socket)
    }

    /// One that drives.
    fn driver(bridge: &Bridge) -> Self {
        let mut client = Self::connect(bridge);
        client.until("hello roomba-bridge 2");
        client.take();
        client
    }

    fn say(&mut self, word: &str) {
        self.0.send(Message::text(word)).unwrap();
    }

    fn send(&mut self, bytes: &[u8]) {
        self.0.send(Message::binary(bytes.to_vec())).unwrap();
    }

    fn take(&mut self) {
        let drive = self.until("drive ");
        self.say(&drive.replace("drive", "take"));
    }

    /// The next word that isn't a beat; beats are answered. None if nothing comes for a moment.
    fn hear(&mut self) -> Option<String> {
        loop {
            match self.0.read() {
                Ok(Message::Text(text)) => match text.strip_prefix("beat ") {
                    Some(number) => self.say(&format!("alive {number}")),
                    None => return Some(text.to_string()),
                },
                Ok(Message::Close(frame)) => return frame.map(|frame| frame.reason.to_string()),
                Ok(_) => {}
                Err(Error::Io(error)) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut) => {
                    return None;
                }
                Err(error) => panic!("{error}"),
            }
        }
    }

    /// Waits for a word that begins so.
    fn until(&mut self, begin: &str) -> String {
        let began = Instant::now();
        loop {
            match self.hear() {
                Some(word) if word.starts_with(begin) => return word,
                _ => assert!(began.elapsed() < PATIENCE, "waited in vain for {begin:?}"),
            }
        }
    }

    /// Answers beats until the robot turns, or stands.
    fn until_robot(&mut self, robot: &mut Program, stands: bool) {
        let began = Instant::now();
        while is_stopped(robot) != stands {
            self.hear();
            assert!(began.elapsed() < PATIENCE, "{}", robot.state());
        }
    }
}

fn is_stopped(robot: &mut Program) -> bool {
    let state = robot.state();
    STOPS.iter().all(|wheel| state.pointer(wheel).unwrap().as_f64() == Some(0.0))
}

/// When the last command arrived that moved it, s; null for never.
fn last_motion(robot: &mut Program) -> serde_json::Value {
    robot.state()["last_motion_s"].clone()
}

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
fn an_address_or_a_port_in_use_is_refused_with_the_mend_before_the_robot_is_touched() {
    let mut robot = Program::start("bridge-address", &[]);
    let port = robot.ready();
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = listener.local_addr().unwrap().to_string();
    let (code, message) = refused(&["--port", &port, "--listen", &address]);
    let begin = format!("can't listen on {address}: another program does");
    assert!(code == Some(1) && message.contains(&begin) && message.contains("use --listen"), "{code:?} {message}");
    let (code, message) = refused(&["--port", &port, "--listen", "192.0.2.1:7626"]);
    assert!(code == Some(1) && message.contains("doesn't have that address"), "{code:?} {message}");
    assert_eq!(robot.state()["commands"], 0);
    let _bridge = Bridge::start(&port, &[]);
    let (code, message) = refused(&["--port", &port, "--listen", "127.0.0.1:0"]);
    assert!(code == Some(2) && message.contains("another program uses it; end that one"), "{code:?} {message}");
}

#[test]
fn whoever_watches_can_stop_the_robot_and_what_the_driver_sends_then_is_dropped() {
    let mut robot = Program::start("bridge-stop", &[]);
    let bridge = Bridge::start(&robot.ready(), &[]);
    let mut driver = Client::driver(&bridge);
    let mut watcher = Client::connect(&bridge);
    watcher.until("watch");
    driver.send(&TURN);
    driver.until_robot(&mut robot, false);
    let moved = last_motion(&mut robot);
    // Bytes don't count, the word does.
    watcher.send(&[145, 0, 0, 0, 0]);
    watcher.say("what?");
    watcher.until("unknown");
    assert!(!is_stopped(&mut robot));
    watcher.say("stop");
    watcher.until("halted stopped");
    driver.send(&TURN);
    driver.say("what?");
    driver.until("unknown");
    driver.until_robot(&mut robot, true);
    assert_eq!(last_motion(&mut robot), moved);
    // It also ends what the robot does by itself, such as cleaning.
    let mut driver = Client(driver.0);
    driver.say("take 2");
    driver.send(&[128, 131, 135]);
    let began = Instant::now();
    while robot.state()["runs_builtin_program"] != true {
        driver.hear();
        assert!(began.elapsed() < PATIENCE, "{}", robot.state());
    }
    watcher.say("stop");
    while robot.state()["runs_builtin_program"] != false {
        driver.hear();
        assert!(began.elapsed() < PATIENCE, "{}", robot.state());
    }
}

#[test]
fn commands_that_a_network_delivers_late_move_nothing() {
    let mut robot = Program::start("bridge-late", &[]);
    let bridge = Bridge::start(&robot.ready(), &[]);
    let mut client = Client::connect(&bridge);
    client.until("drive 1");
    // slow: the delay itself.
    thread::sleep(Duration::from_millis(250));
    client.say("take 1");
    client.send(&TURN);
    client.until("halted late");
    client.send(&TURN);
    // On time now: it drives.
    client.say("take 2");
    client.send(&TURN);
    client.until_robot(&mut robot, false);
    // And again, while it drives: it answers nothing any more.
    let began = Instant::now();
    while !is_stopped(&mut robot) {
        assert!(began.elapsed() < PATIENCE, "{}", robot.state());
    }
}

#[test]
fn a_driver_that_sends_more_than_the_line_carries_is_stopped_at_once() {
    let mut robot = Program::start("bridge-flood", &[]);
    let bridge = Bridge::start(&robot.ready(), &[]);
    let mut driver = Client::driver(&bridge);
    driver.send(&TURN);
    driver.until_robot(&mut robot, false);
    // Five seconds of the line.
    for _ in 0..60 {
        driver.send(&TURN[1..].repeat(200));
    }
    let began = Instant::now();
    driver.until("halted flooded");
    driver.until_robot(&mut robot, true);
    let moved = last_motion(&mut robot);
    assert!(began.elapsed() < Duration::from_secs(2), "{:?}", began.elapsed());
    // Nothing of the rest arrives, not even later.
    driver.say("what?");
    driver.until("unknown");
    driver.until_robot(&mut robot, true);
    assert_eq!(last_motion(&mut robot), moved);
}

#[test]
fn a_robot_at_another_rate_is_stopped_when_its_driver_or_the_bridge_dies() {
    let mut robot = Program::start("bridge-rate", &["--personality", "slow"]);
    let port = robot.ready();
    for kills_bridge in [false, true] {
        let mut bridge = Bridge::start(&port, &[]);
        let mut driver = Client::driver(&bridge);
        driver.say("baud 19200");
        driver.send(&[&[128], &TURN[..]].concat());
        driver.until_robot(&mut robot, false);
        if kills_bridge {
            bridge.child.kill().unwrap();
            bridge.child.wait().unwrap();
            assert!(!is_stopped(&mut robot));
            bridge = Bridge::start(&port, &[]);
        }
        drop(driver);
        let began = Instant::now();
        while !is_stopped(&mut robot) {
            assert!(began.elapsed() < PATIENCE, "{}", robot.state());
        }
        drop(bridge);
    }
}

#[test]
fn clients_without_a_place_hear_why_and_silent_ones_make_room() {
    let mut robot = Program::start("bridge-many", &[]);
    let bridge = Bridge::start(&robot.ready(), &[]);
    let mut clients: Vec<_> = (0..8).map(|_| Client::connect(&bridge)).collect();
    for client in &mut clients {
        client.until("hello");
    }
    let why = Client::connect(&bridge).until("all");
    assert!(why.contains("8 connections") && why.contains("close a page"), "{why}");
    clients.pop();
    // Its place is free as soon as the bridge has noticed.
    let began = Instant::now();
    while !Client::connect(&bridge).until("").starts_with("hello") {
        assert!(began.elapsed() < PATIENCE);
    }
}

#[test]
fn the_service_manager_hears_that_it_is_ready_and_alive() {
    let mut robot = Program::start("bridge-service", &[]);
    let path = std::env::temp_dir().join(format!("robovac-{}-notify", std::process::id()));
    let manager = UnixDatagram::bind(&path).unwrap();
    manager.set_read_timeout(Some(PATIENCE)).unwrap();
    let _bridge = Bridge::start(&robot.ready(), &[("NOTIFY_SOCKET", path.to_str().unwrap())]);
    for expected in ["READY=1", "WATCHDOG=1", "WATCHDOG=1"] {
        let mut buffer = [0; 64];
        let count = manager.recv(&mut buffer).unwrap();
        assert_eq!(str::from_utf8(&buffer[..count]), Ok(expected));
    }
    std::fs::remove_file(path).unwrap();
}
