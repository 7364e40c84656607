//! The serial port of the robot.

use crate::failure::Failure;
use serialport::{ClearBuffer, SerialPort, SerialPortType};
use std::{
    collections::VecDeque,
    io::{self, ErrorKind},
    thread,
    time::{Duration, Instant},
};

/// Bits on the line for a byte.
const BITS: u32 = 10;
/// Time that a read waits for bytes: the interval at which everything else is looked at.
const LOOK: Duration = Duration::from_millis(5);
/// Time that the line needs for what the system holds, ms: a stop has to wait behind it.
const MOST_LEAVING_MS: u32 = 10;
/// The same for the queue of commands, which a stop clears.
const MOST_WAITING_MS: u32 = 100;
/// Time limit for the last bytes to leave before the rate changes or the program ends, and time for those that the adapter
/// itself still holds then.
const LAST_BYTES: Duration = Duration::from_millis(500);
const ADAPTER: Duration = Duration::from_millis(20);
/// Time limit for a write while the line is busy.
const BUSY: Duration = Duration::from_millis(100);
/// For how long the wake-up pin is pulled low. Shorter ones count for a change of the baud rate.
const WAKE: Duration = Duration::from_millis(600);

pub struct RobotSerialPort {
    name: String,
    port: Box<dyn SerialPort>,
    baud: u32,
    pace: UnsentBytes,
    /// Whole commands that wait for the line.
    waiting: VecDeque<Box<[u8]>>,
    /// A write that failed; the next read reports it.
    broken: Option<io::Error>,
}

impl RobotSerialPort {
    /// Opens `name`, or the only USB serial port.
    pub fn open(name: Option<&str>, baud: u32) -> Result<Self, Failure> {
        let name = name.map_or_else(only_usb_port, |name| Ok(name.to_owned()))?;
        let mut port = serialport::new(&name, baud).timeout(LOOK).open().map_err(|e| cannot_open(&name, &e))?;
        // Opening can have pulled the wake-up pin low. Terminals without that wire work, too.
        let _ =
            (port.write_request_to_send(false), port.write_data_terminal_ready(false), port.clear(ClearBuffer::Input));
        Ok(Self { name, port, baud, pace: UnsentBytes::new(Instant::now()), waiting: VecDeque::new(), broken: None })
    }

    pub fn name(&self) -> &str {
        &self.name
    }

    /// Waits a little for bytes; gives how many there are.
    pub fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if let Some(error) = self.broken.take() {
            return Err(error);
        }
        match self.port.read(buffer) {
            Err(error) if matches!(error.kind(), ErrorKind::TimedOut | ErrorKind::Interrupted) => Ok(0),
            // Plugged out: such a port is always readable, and empty.
            Ok(0) => Err(ErrorKind::UnexpectedEof.into()),
            other => other,
        }
    }

    /// Queues a command; false if there is no room.
    pub fn queue(&mut self, command: &[u8]) -> bool {
        let waiting: usize = self.waiting.iter().map(|command| command.len()).sum();
        let has_room = self.waiting.is_empty() || waiting + command.len() <= self.bytes_in(MOST_WAITING_MS);
        if has_room {
            self.waiting.push_back(command.into());
            self.pump();
        }
        has_room
    }

    /// Sends commands of the queue as far as the line has room.
    pub fn pump(&mut self) {
        while self.has_room()
            && let Some(command) = self.waiting.pop_front()
        {
            self.write(&command);
        }
    }

    /// Sends a stop at once. What waits in the queue is dropped; what the system holds leaves first, so that no command is cut
    /// and swallows the stop.
    pub fn stop(&mut self, bytes: &[u8]) {
        self.waiting.clear();
        self.write(bytes);
    }

    fn write(&mut self, bytes: &[u8]) {
        let (began, mut rest) = (Instant::now(), bytes);
        self.pace.sent(began, self.baud, bytes.len());
        while !rest.is_empty() {
            match self.port.write(rest) {
                Ok(count) => rest = rest.get(count..).unwrap_or_default(),
                // The line is busy.
                Err(error)
                    if matches!(error.kind(), ErrorKind::TimedOut | ErrorKind::Interrupted | ErrorKind::WouldBlock)
                        && began.elapsed() < BUSY => {}
                Err(error) => return self.note(Err(error)),
            }
        }
    }

    /// After all bytes so far have left.
    pub fn set_baud(&mut self, baud: u32) {
        while let Some(command) = self.waiting.pop_front() {
            self.write(&command);
        }
        self.finish();
        let set = self.port.set_baud_rate(baud).map_err(io::Error::from);
        self.note(set);
        self.baud = baud;
    }

    pub fn set_brc(&mut self, is_low: bool) {
        // A terminal without that wire is no reason to stop.
        let _ = self.port.write_request_to_send(is_low);
    }

    /// Wakes a sleeping robot, if its wake-up pin is wired to RTS.
    pub fn wake(&mut self) {
        if self.port.write_request_to_send(true).is_ok() {
            thread::sleep(WAKE);
            self.set_brc(false);
        }
    }

    fn has_room(&self) -> bool {
        self.leaving() <= self.bytes_in(MOST_LEAVING_MS)
    }

    /// Bytes that are on their way, by the system and by the time since they were written.
    fn leaving(&self) -> usize {
        let waiting = self.port.bytes_to_write().map_or(0, |waiting| waiting as usize);
        waiting.max(self.pace.leaving(Instant::now(), self.baud))
    }

    /// What the line carries in a time.
    fn bytes_in(&self, time_ms: u32) -> usize {
        (self.baud / BITS * time_ms / 1000).max(16) as usize
    }

    /// Waits until the last bytes have left; not for ever, as waiting by the system's own means would.
    pub fn finish(&mut self) {
        let began = Instant::now();
        while self.leaving() > 0 && began.elapsed() < LAST_BYTES {
            thread::sleep(Duration::from_millis(1));
        }
        thread::sleep(ADAPTER);
    }

    fn note(&mut self, result: io::Result<()>) {
        self.broken = result.err().or(self.broken.take());
    }
}

/// How many bytes can't have left yet. Some adapters say that nothing waits, as their own buffers are large.
#[derive(Debug, Clone, Copy)]
struct UnsentBytes {
    leaving: f64,
    at: Instant,
}

impl UnsentBytes {
    fn new(now: Instant) -> Self {
        Self { leaving: 0.0, at: now }
    }

    fn leaving(&self, now: Instant, baud: u32) -> usize {
        let left = now.saturating_duration_since(self.at).as_secs_f64() * f64::from(baud / BITS);
        (self.leaving - left).max(0.0).ceil() as usize
    }

    fn sent(&mut self, now: Instant, baud: u32, count: usize) {
        *self = Self { leaving: (self.leaving(now, baud) + count) as f64, at: now };
    }
}

fn only_usb_port() -> Result<String, Failure> {
    let ports = serialport::available_ports().map_err(|e| Failure::usage(format!("can't list serial ports: {e}")))?;
    let usb: Vec<_> = ports.iter().filter(|port| matches!(port.port_type, SerialPortType::UsbPort(_))).collect();
    match usb.as_slice() {
        [only] => Ok(only.port_name.clone()),
        [] => {
            Err(Failure::usage("there is no USB serial port: plug the cable in, or name a port with --port".to_owned()))
        }
        several => {
            let names: Vec<_> = several.iter().map(|port| port.port_name.as_str()).collect();
            Err(Failure::usage(format!(
                "there are several USB serial ports: choose one with --port ({})",
                names.join(", ")
            )))
        }
    }
}

/// The failure to open a serial port, with what helps.
pub fn cannot_open(name: &str, error: &serialport::Error) -> Failure {
    let hint = match error.kind() {
        // By this kind the library reports that the port is locked.
        serialport::ErrorKind::NoDevice if cfg!(unix) => {
            return Failure::usage(format!(
                "can't open {name}: another program uses it; end that one first, such as another \"robovac bridge\" or \"robovac monitor\""
            ));
        }
        serialport::ErrorKind::NoDevice | serialport::ErrorKind::Io(ErrorKind::NotFound) => {
            "\"robovac monitor list\" lists the ports"
        }
        serialport::ErrorKind::Io(ErrorKind::PermissionDenied) => {
            "permission denied: on Linux, add your user to the group dialout"
        }
        _ => "another program may be using it",
    };
    Failure::usage(format!("can't open {name}: {error}; {hint}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_carries_so_many_bytes_in_a_time() {
        let began = Instant::now();
        let mut pace = UnsentBytes::new(began);
        let after = |ms| began + Duration::from_millis(ms);
        pace.sent(began, 115_200, 1152);
        assert_eq!([0, 50, 100, 5000].map(|ms| pace.leaving(after(ms), 115_200)), [1152, 576, 0, 0]);
        pace.sent(after(50), 115_200, 100);
        assert_eq!(pace.leaving(after(50), 115_200), 676);
        assert_eq!(pace.leaving(after(60), 19_200), 657);
    }
}
