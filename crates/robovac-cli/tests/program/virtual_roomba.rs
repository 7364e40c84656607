//! `robovac virtual-roomba` as a program on the other end of its line sees it: in real time, so times are generous.
#![cfg(unix)]

use roomba_oi::{Packet, StreamFrame};
use rustix::{
    fs::{Mode, OFlags, open},
    io::{Errno, ioctl_fionbio, read, write},
    termios::{LocalModes, OptionalActions, OutputModes, tcgetattr, tcsetattr},
};
use serde_json::Value;
use std::{
    fs,
    io::{BufRead, BufReader, Read, Write},
    net::{Shutdown, TcpStream},
    os::fd::OwnedFd,
    path::PathBuf,
    process::{Child, ChildStdin, ChildStdout, Command, Stdio},
    time::{Duration, Instant},
};

const PATIENCE: Duration = Duration::from_secs(20);

/// A running program, which ends with the test.
pub(super) struct Program {
    child: Child,
    orders: Option<ChildStdin>,
    told: BufReader<ChildStdout>,
    link: PathBuf,
}

impl Program {
    pub(super) fn start(name: &str, arguments: &[&str]) -> Self {
        let link = std::env::temp_dir().join(format!("robovac-{}-{name}", std::process::id()));
        let mut command = Command::new(env!("CARGO_BIN_EXE_robovac"));
        command.arg("virtual-roomba").args(arguments);
        if !arguments.contains(&"--tcp") {
            command.arg("--pty").arg(&link);
        }
        let mut child = command.arg("--control").stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
        let (orders, told) = (child.stdin.take(), BufReader::new(child.stdout.take().unwrap()));
        Self { child, orders, told, link }
    }

    /// The next line that it prints.
    fn line(&mut self) -> String {
        let mut line = String::new();
        self.told.read_line(&mut line).unwrap();
        line.trim_end().to_owned()
    }

    pub(super) fn ready(&mut self) -> String {
        self.line().strip_prefix("ready ").expect("ready").to_owned()
    }

    fn order(&mut self, order: &str) {
        writeln!(self.orders.as_mut().unwrap(), "{order}").unwrap();
    }

    pub(super) fn state(&mut self) -> Value {
        self.order("state");
        serde_json::from_str(&self.line()).unwrap()
    }

    /// Waits until its state satisfies `holds`.
    pub(super) fn wait_for(&mut self, what: &str, holds: impl Fn(&Value) -> bool) -> Value {
        let begin = Instant::now();
        loop {
            let state = self.state();
            if holds(&state) {
                return state;
            }
            assert!(begin.elapsed() < PATIENCE, "{what}: {state}");
            std::thread::sleep(Duration::from_millis(10));
        }
    }

    fn quit(mut self) {
        self.order("quit");
        assert!(self.child.wait().unwrap().success());
        assert!(fs::symlink_metadata(&self.link).is_err(), "the link is gone");
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
        let _ = fs::remove_file(&self.link);
    }
}

/// A host's end of the terminal.
struct Terminal(OwnedFd);

impl Terminal {
    fn open(program: &Program) -> Self {
        let flags = OFlags::RDWR | OFlags::NOCTTY | OFlags::CLOEXEC;
        let fd = open(&program.link, flags, Mode::empty()).unwrap();
        ioctl_fionbio(&fd, true).unwrap();
        Self(fd)
    }

    fn send(&self, bytes: &[u8]) {
        assert_eq!(write(&self.0, bytes), Ok(bytes.len()));
    }

    /// Waits for so many bytes.
    fn hear(&self, count: usize) -> Vec<u8> {
        let (mut heard, begin) = (Vec::new(), Instant::now());
        while heard.len() < count {
            let mut buffer = [0; 256];
            match read(&self.0, &mut buffer) {
                Ok(got) => heard.extend(&buffer[..got]),
                Err(Errno::AGAIN) => std::thread::sleep(Duration::from_millis(2)),
                Err(error) => panic!("{error}"),
            }
            assert!(begin.elapsed() < PATIENCE, "{heard:?}");
        }
        heard
    }

    /// All that waits.
    fn rest(&self) -> Vec<u8> {
        std::thread::sleep(Duration::from_millis(100));
        let mut heard = Vec::new();
        let mut buffer = [0; 4096];
        while let Ok(count @ 1..) = read(&self.0, &mut buffer) {
            heard.extend(&buffer[..count]);
        }
        heard
    }
}

#[test]
fn a_terminal_answers_drives_and_streams() {
    let mut program = Program::start("drive", &[]);
    assert_eq!(program.ready(), program.link.display().to_string());
    let terminal = Terminal::open(&program);
    // Raw: nothing is echoed, and no byte has a meaning of its own.
    let settings = tcgetattr(&terminal.0).unwrap();
    assert!(!settings.local_modes.intersects(LocalModes::ECHO | LocalModes::ICANON | LocalModes::ISIG));
    assert!(!settings.output_modes.contains(OutputModes::OPOST) && settings.output_speed() == 115_200);
    terminal.send(&[128, 131, 142, 35]);
    assert_eq!(terminal.hear(1), [2]);
    terminal.send(&[145, 0, 200, 0, 200]);
    let moving = program.wait_for("it drives", |state| state["pose"]["x"].as_f64().unwrap() > 1.2);
    assert_eq!((&moving["mode"], moving["asked"]["left"].as_f64()), (&"Safe".into(), Some(200.0)));
    assert!(moving["last_motion_s"].as_f64().unwrap() < moving["time_s"].as_f64().unwrap());
    terminal.send(&[145, 0, 0, 0, 0]);
    program.wait_for("it stops", |state| state["speed"]["right"] == 0.0);
    terminal.send(&[148, 2, 35, 21]);
    let stream = terminal.hear(70);
    let frame = StreamFrame::parse(&stream).unwrap();
    assert!(frame.values().eq([(Packet::OiMode, 2), (Packet::ChargingState, 0)]));
    program.quit();
}

#[test]
fn a_program_that_does_not_read_blocks_nothing() {
    let mut program = Program::start("absent", &[]);
    program.ready();
    let terminal = Terminal::open(&program);
    terminal.send(&[128, 148, 1, 100]);
    // 5.6 kB a second aren't read for a while; the robot keeps running.
    let before = program.state()["time_s"].as_f64().unwrap();
    program.wait_for("time passes", |state| state["time_s"].as_f64().unwrap() > before + 3.0);
    terminal.send(&[150, 0]);
    let old = terminal.rest();
    assert!(old.len() < 1 << 17, "{}", old.len());
    terminal.send(&[142, 35]);
    assert_eq!(terminal.hear(1), [1]);
    program.quit();
}

#[test]
fn stale_bytes_waited_for_the_next_program() {
    let mut program = Program::start("stale", &[]);
    program.ready();
    let terminal = Terminal::open(&program);
    terminal.send(&[128, 148, 1, 7]);
    terminal.hear(6);
    drop(terminal);
    let closed = program.wait_for("closed", |state| state["connected"] == false);
    // Frames of a robot on the floor, which nobody reads.
    let then = closed["time_s"].as_f64().unwrap() + 0.5;
    program.wait_for("time passes", |state| state["time_s"].as_f64().unwrap() > then);
    program.order("lift");
    program.wait_for("lifted", |state| state["lifted"] == true);
    let terminal = Terminal::open(&program);
    let heard = terminal.hear(12);
    let frame = (0..heard.len()).find_map(|at| StreamFrame::parse(heard.get(at..at + 6)?).ok()).unwrap();
    assert!(frame.values().eq([(Packet::BumpsAndDrops, 0b1100)]), "{heard:?}");
    program.quit();
}

#[test]
fn slow_bytes_blocked_the_line_after_the_rate_had_changed() {
    let mut program = Program::start("blocked", &[]);
    program.ready();
    let terminal = Terminal::open(&program);
    let mut settings = tcgetattr(&terminal.0).unwrap();
    let mut set = |rate| {
        settings.set_speed(rate).unwrap();
        tcsetattr(&terminal.0, OptionalActions::Now, &settings).unwrap();
    };
    set(50);
    // 140 s at this rate.
    terminal.send(&[0; 700]);
    program.wait_for("the first has arrived", |state| state["commands"].as_u64() > Some(0));
    set(115_200);
    terminal.send(&[128, 142, 35]);
    assert_eq!(terminal.hear(1), [1]);
    program.quit();
}

#[test]
fn second_emulator_took_over_a_link_in_use() {
    let mut program = Program::start("taken", &[]);
    program.ready();
    let terminal = Terminal::open(&program);
    let link = program.link.to_str().unwrap();
    let second = Command::new(env!("CARGO_BIN_EXE_robovac"))
        .args(["virtual-roomba", "--pty", link, "--control"])
        .output()
        .unwrap();
    let message = String::from_utf8(second.stderr).unwrap();
    assert!(second.status.code() == Some(1) && message.contains("another virtual Roomba"), "{message}");
    Terminal::open(&program).send(&[128, 142, 35]);
    assert_eq!(terminal.hear(1), [1]);
    // The link of one that was killed is free.
    drop(terminal);
    program.child.kill().unwrap();
    program.child.wait().unwrap();
    assert!(fs::symlink_metadata(&program.link).is_ok());
    let mut next = Program::start("taken", &[]);
    next.ready();
    Terminal::open(&next).send(&[128]);
    next.wait_for("it listens", |state| state["mode"] == "Passive");
    next.quit();
}

#[test]
fn the_rate_is_the_one_that_a_program_sets() {
    let mut program = Program::start("slow", &["--personality", "slow"]);
    program.ready();
    let terminal = Terminal::open(&program);
    terminal.send(&[142, 35]);
    assert_eq!(terminal.rest(), [0_u8; 0]);
    let mut settings = tcgetattr(&terminal.0).unwrap();
    settings.set_speed(19_200).unwrap();
    tcsetattr(&terminal.0, OptionalActions::Now, &settings).unwrap();
    std::thread::sleep(Duration::from_millis(50));
    terminal.send(&[128; 6]);
    terminal.send(&[142, 35]);
    assert_eq!(terminal.hear(1), [1]);
    program.quit();
}

#[test]
fn hands_chargers_and_cables_obey_orders() {
    let mut program = Program::start("orders", &[]);
    program.ready();
    let terminal = Terminal::open(&program);
    terminal.send(&[128, 131]);
    program.wait_for("Safe", |state| state["mode"] == "Safe");
    program.order("lift");
    program.wait_for("the wheels drop", |state| state["mode"] == "Passive" && state["lifted"] == true);
    program.order("drop");
    // The line and the orders are two ways in: neither waits for the other.
    program.wait_for("it stands", |state| state["lifted"] == false);
    terminal.send(&[131]);
    program.wait_for("Safe again", |state| state["mode"] == "Safe");
    program.order("plug");
    program.wait_for("bounced", |state| state["mode"] == "Passive");
    terminal.send(&[142, 34]);
    assert_eq!(terminal.hear(1), [1]);
    program.order("unplug");
    program.order("press clean");
    program.wait_for("it cleans", |state| state["runs_builtin_program"] == true);
    terminal.send(&[133]);
    program.wait_for("asleep", |state| state["awake"] == false);
    program.order("brc low");
    program.wait_for("still asleep", |state| state["awake"] == false);
    program.order("brc high");
    program.wait_for("awake", |state| state["awake"] == true);
    // The cable: the terminal hangs up, and comes back as another one.
    program.order("unplug-line");
    program.state();
    assert!(fs::symlink_metadata(&program.link).is_err());
    let hung_up = |result: Result<usize, Errno>| matches!(result, Ok(0) | Err(Errno::IO));
    assert!(hung_up(read(&terminal.0, &mut [0; 64])));
    program.order("replug-line");
    program.state();
    let terminal = Terminal::open(&program);
    terminal.send(&[142, 35]);
    assert_eq!(terminal.hear(1), [1]);
    program.order("dance");
    assert!(program.line().contains("no command \"dance\""));
    program.quit();
}

#[test]
fn walls_and_drop_offs_are_where_they_were_put_and_the_log_tells_when() {
    let log = std::env::temp_dir().join(format!("robovac-{}-cliff.log", std::process::id()));
    let mut program = Program::start("cliff", &["--cliff-at", "0.6", "--log", log.to_str().unwrap()]);
    program.ready();
    let terminal = Terminal::open(&program);
    terminal.send(&[128, 131, 137, 1, 44, 128, 0]);
    let stopped = program.wait_for("it stops", |state| {
        state["mode"] == "Passive" && state["commands"] == 3 && state["speed"]["left"] == 0.0
    });
    let ahead = stopped["pose"]["x"].as_f64().unwrap() - 1.0;
    assert!((0.44..0.5).contains(&ahead) && stopped["fallen"] == false, "{stopped}");
    program.quit();
    let text = fs::read_to_string(&log).unwrap();
    fs::remove_file(&log).unwrap();
    let lines: Vec<Vec<&str>> = text.lines().map(|line| line.splitn(3, ' ').collect()).collect();
    let time = |what: &str| -> [f64; 2] {
        let line = lines.iter().find(|line| line[2].starts_with(what)).unwrap_or_else(|| panic!("{what}: {text}"));
        [line[0].parse().unwrap(), line[1].parse().unwrap()]
    };
    let (told, turning) = (time("command 137 1 44 128 0"), time("wheels commanded left 300 right 300 mm/s, turning"));
    assert!(told[0] <= turning[0] && turning[0] - told[0] < 0.5, "{text}");
    assert!((turning[1] - told[1] - 1000.0 * (turning[0] - told[0])).abs() < 0.2, "{text}");
    assert!(lines.last().unwrap()[2].ends_with("commanded left 0 right 0 mm/s, at rest"), "{text}");

    let mut program = Program::start("wall", &["--wall-at", "0.5"]);
    program.ready();
    let terminal = Terminal::open(&program);
    terminal.send(&[128, 132, 145, 0, 200, 0, 200]);
    let bumped = program.wait_for("it bumps", |state| state["bumped"] == true);
    let ahead = bumped["pose"]["x"].as_f64().unwrap() - 1.0;
    assert!((ahead - (0.5 - 0.174_25)).abs() < 0.01, "{bumped}");
    program.quit();
}

#[test]
fn tcp_clients_come_one_after_the_other() {
    let mut program = Program::start("tcp", &["--tcp", "127.0.0.1:0"]);
    let address = program.ready();
    for round in 0..2 {
        let mut client = TcpStream::connect(&address).unwrap();
        client.set_read_timeout(Some(PATIENCE)).unwrap();
        client.write_all(&[128, 142, 35]).unwrap();
        let mut answer = [0];
        client.read_exact(&mut answer).unwrap();
        assert_eq!(answer, [1], "{round}");
    }
    program.order("unplug-line");
    assert!(program.line().contains("can be unplugged"));
    program.quit();
}

#[test]
fn half_closed_client_lost_its_answers() {
    let mut program = Program::start("half", &["--tcp", "127.0.0.1:0"]);
    let mut client = TcpStream::connect(program.ready()).unwrap();
    client.set_read_timeout(Some(PATIENCE)).unwrap();
    client.write_all(&[&[128][..], &[142, 35].repeat(20)].concat()).unwrap();
    client.shutdown(Shutdown::Write).unwrap();
    let mut answers = Vec::new();
    client.read_to_end(&mut answers).unwrap();
    assert_eq!(answers, [1; 20]);
    program.quit();
}

#[test]
fn standard_streams_carry_the_bytes_and_nothing_else() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_robovac"))
        .args(["virtual-roomba", "--stdio", "--personality", "mode_plus_one"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(&[128, 131, 142, 35, 142, 9]).unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(
        (output.status.success(), &output.stdout[..], &output.stderr[..]),
        (true, &[3, 0][..], &b"ready stdio\n"[..])
    );
}

#[test]
fn what_cant_be_done_is_said() {
    let run = |arguments: &[&str]| {
        let output =
            Command::new(env!("CARGO_BIN_EXE_robovac")).arg("virtual-roomba").args(arguments).output().unwrap();
        (output.status.code(), String::from_utf8(output.stderr).unwrap())
    };
    let file = std::env::temp_dir().join(format!("robovac-{}-file", std::process::id()));
    fs::write(&file, "precious").unwrap();
    let (code, message) = run(&["--pty", file.to_str().unwrap()]);
    assert!(code == Some(1) && message.contains("isn't a symbolic link"), "{message}");
    assert_eq!(fs::read_to_string(&file).unwrap(), "precious");
    fs::remove_file(&file).unwrap();
    let (code, message) = run(&["--stdio", "--personality", "nobody"]);
    assert!(code == Some(2) && message.contains("mode_plus_one"), "{message}");
    let (code, message) = run(&["--stdio", "--wall-at", "0.1"]);
    assert!(code == Some(2) && message.contains("0.17 m"), "{message}");
    assert_eq!(run(&[]).0, Some(2));
}

#[test]
fn a_signal_takes_the_link_away() {
    let mut program = Program::start("signal", &[]);
    program.ready();
    let pid = program.child.id().to_string();
    assert!(Command::new("kill").args(["-TERM", &pid]).status().unwrap().success());
    assert!(program.child.wait().unwrap().success());
    assert!(fs::symlink_metadata(&program.link).is_err());
}
