//! `monitor`: listens to a robot on a serial port, with the same driver as the page.

use super::{bridge::cannot_open, failure::Failure, output::say, signals::end_requested, simulate::parse_seconds};
use robovac_link::{
    connection::{Connection, ConnectionView, Request, Traffic, TrafficKind},
    driver::LineRequest,
};
use roomba_oi::Packet;
use serialport::{ClearBuffer, SerialPort};
use std::{
    fs::File,
    io::{self, ErrorKind, IsTerminal, Write, stderr},
    path::{Path, PathBuf},
    sync::atomic::{AtomicBool, Ordering},
    time::{Duration, Instant},
};

/// Baud rate that every connection begins with.
const BAUD: u32 = 115_200;
/// Time that a read waits for bytes, and interval of the driver's ticks.
const LOOK: Duration = Duration::from_millis(5);
/// Time between two lines of sensors.
const REPORT: Duration = Duration::from_secs(1);
/// Largest lump of bytes that is read at once.
const LUMP: usize = 4096;

/// Listen to a robot on a serial port: identify it, show its sensors, record. Never drives the robot
#[derive(clap::Args)]
pub struct Arguments {
    /// Serial port, such as /dev/ttyUSB0 or COM3; "list" lists the ports
    port: String,
    /// Seconds to listen [default: until Ctrl-C]
    #[arg(long, value_name = "S", value_parser = parse_seconds, allow_hyphen_values = true)]
    seconds: Option<f64>,
    /// Record all traffic to this file, which the page can replay. It is written once a second, and completed on Ctrl-C
    #[arg(long, value_name = "FILE")]
    record: Option<PathBuf>,
    /// Show every command and frame instead of one line per second
    #[arg(long)]
    traffic: bool,
    #[cfg(feature = "ros2")]
    #[command(flatten)]
    ros2: super::ros2::WatchedArguments,
}

pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    if arguments.port == "list" {
        return list();
    }
    // First of all: an hour that can't be recorded is lost.
    let mut record = arguments.record.as_deref().map(RecordingFile::create).transpose()?;
    let is_over = end_requested()?;
    let mut port =
        serialport::new(&arguments.port, BAUD).timeout(LOOK).open().map_err(|e| cannot_open(&arguments.port, &e))?;
    // Opening can have pulled the wake-up wire low: release it.
    let _ = (port.write_request_to_send(false), port.write_data_terminal_ready(false), port.clear(ClearBuffer::Input));
    let mut link = Connection::new();
    let watched = watch(arguments, port.as_mut(), &mut link, &mut record, &is_over);
    keep(&mut link, &mut record)?;
    watched.map(|()| String::new())
}

/// The file of a recording.
struct RecordingFile<'a> {
    path: &'a Path,
    file: File,
}

impl<'a> RecordingFile<'a> {
    fn create(path: &'a Path) -> Result<Self, Failure> {
        let file = File::create(path).map_err(|e| Failure::io(path.display(), &e))?;
        Ok(Self { path, file })
    }
}

/// Writes what was recorded since the last call, or forgets it.
fn keep(link: &mut Connection, record: &mut Option<RecordingFile<'_>>) -> Result<(), Failure> {
    let lines = link.take_recording();
    let Some(RecordingFile { path, file }) = record else { return Ok(()) };
    file.write_all(lines.as_bytes()).map_err(|e| Failure::io(path.display(), &e))
}

fn watch(
    arguments: &Arguments,
    port: &mut dyn SerialPort,
    link: &mut Connection,
    record: &mut Option<RecordingFile<'_>>,
    is_over: &AtomicBool,
) -> Result<(), Failure> {
    let lost = |error: &io::Error| Failure::io(&arguments.port, error);
    let began = Instant::now();
    let (mut reported, mut kept) = (began, began);
    let (mut told, mut connected) = (0, false);
    let mut buffer = [0; LUMP];
    #[cfg(feature = "ros2")]
    let mut node = super::ros2::WatchedNode::new(&arguments.ros2, link)?;
    link.opened(0.0);
    loop {
        let now = began.elapsed().as_secs_f64();
        match port.read(&mut buffer) {
            Ok(count) => link.feed(now, buffer.get(..count).unwrap_or_default()),
            Err(error) if matches!(error.kind(), ErrorKind::TimedOut | ErrorKind::Interrupted) => {}
            Err(error) => {
                link.lost(now, "The port was unplugged or closed.", true);
                return Err(lost(&error));
            }
        }
        link.beat(now);
        link.tick(now);
        #[cfg(feature = "ros2")]
        if let Some(node) = &mut node {
            node.publish(link)?;
        }
        let is_over = is_over.load(Ordering::Relaxed) || arguments.seconds.is_some_and(|seconds| now >= seconds);
        if is_over {
            // Nothing to be refused: it is always allowed.
            let _ = link.request(now, Request::Disconnect);
        }
        send(port, link).map_err(|e| lost(&e))?;
        let view = link.view(now);
        for line in view.diagnosis.log.iter().skip(told) {
            say(&format!("{now:7.3}  {line}"));
        }
        told = told.max(view.diagnosis.log.len());
        for line in link.take_traffic().iter().filter(|line| arguments.traffic || line.kind == TrafficKind::Text) {
            say(&told_of(line));
        }
        if view.phase == "waiting" && reported.elapsed() >= 5 * REPORT {
            reported = Instant::now();
            say(&format!("{} {}", view.diagnosis.text, view.diagnosis.remedy));
        }
        if view.phase == "connected" && (!connected || reported.elapsed() >= REPORT) {
            (connected, reported) = (true, Instant::now());
            say(&summary(now, &view, link));
        }
        if kept.elapsed() >= REPORT {
            kept = Instant::now();
            keep(link, record)?;
        }
        if is_over {
            return Ok(());
        }
    }
}

/// Executes the driver's requests at once.
fn send(port: &mut dyn SerialPort, link: &mut Connection) -> io::Result<()> {
    while let Some(request) = link.take_line() {
        match request {
            LineRequest::Baud(baud) => port.set_baud_rate(baud)?,
            // A terminal without that wire is no reason to stop: the next thing is tried.
            LineRequest::Brc(is_low) => drop(port.write_request_to_send(is_low)),
            // For bridges only.
            LineRequest::Stop => {}
        }
    }
    port.write_all(&link.take_tx())
}

/// The readings in a line; of what the robot doesn't send at this baud rate, nothing.
fn summary(now: f64, view: &ConnectionView, link: &Connection) -> String {
    let readings = view.readings.clone().unwrap_or_default();
    let (sensors, statistics) = (&readings.sensors, &view.statistics);
    let flags = |flags: &[bool]| flags.iter().map(|&flag| if flag { '1' } else { '0' }).collect::<String>();
    let [left, right, _] = sensors.counts;
    let mut line = format!("{now:7.3}  {:7}", view.mode);
    let mut add = |packet: Packet, text: String| {
        if link.receives(packet) {
            line += &text;
        }
    };
    add(Packet::Voltage, format!("  battery {:5.2} V", readings.voltage_v));
    add(Packet::Current, format!(" {:5} mA", sensors.battery.current_ma));
    add(Packet::BatteryCharge, format!(" {}/{} mAh", readings.charge_mah, readings.capacity_mah));
    add(Packet::LeftEncoder, format!("  encoders {left} {right}"));
    add(
        Packet::BumpsAndDrops,
        format!("  bumps {}  wheel drops {}", flags(&sensors.bumper), flags(&sensors.wheel_drops)),
    );
    add(Packet::CliffLeft, format!("  cliffs {}", flags(&sensors.cliffs)));
    let bad = statistics.bad_checksums + statistics.implausible;
    format!("{line}  {:.0} frames/s, {bad} bad", statistics.rate_hz)
}

fn told_of(line: &Traffic) -> String {
    let sign = match line.kind {
        TrafficKind::Sent => '>',
        TrafficKind::Frame | TrafficKind::Text | TrafficKind::Bytes => '<',
        TrafficKind::Refused => 'x',
        TrafficKind::Held => '?',
        TrafficKind::Line => '!',
    };
    format!("{:7.3} {sign} {}", line.time_s, line.text)
}

fn list() -> Result<String, Failure> {
    let ports = serialport::available_ports().map_err(|e| Failure::usage(format!("can't list serial ports: {e}")))?;
    if ports.is_empty() && stderr().is_terminal() {
        say("No serial port found. Check that the cable is plugged in.");
    }
    Ok(ports.into_iter().map(|port| port.port_name + "\n").collect())
}
