//! The serial port of the robot.

use crate::failure::Failure;
use serialport::{ClearBuffer, SerialPort, SerialPortType};
use std::{
    io::{self, ErrorKind},
    thread,
    time::{Duration, Instant},
};

/// Time that a read waits for bytes: the interval at which everything else is looked at.
const LOOK: Duration = Duration::from_millis(5);
/// Time for which bytes may wait to leave, ms: a stop has to wait behind them.
const MOST_WAITING_MS: u32 = 50;
/// Time for the last bytes to leave before the rate changes or the program ends.
const LAST_BYTES: Duration = Duration::from_millis(100);
/// For how long the wake-up pin is pulled low. Shorter ones count for a change of the baud rate.
const WAKE: Duration = Duration::from_millis(600);

pub struct RobotPort {
    name: String,
    port: Box<dyn SerialPort>,
    baud: u32,
    /// A write that failed; the next read reports it.
    broken: Option<io::Error>,
}

impl RobotPort {
    /// Opens `name`, or the only USB serial port.
    pub fn open(name: Option<&str>, baud: u32) -> Result<Self, Failure> {
        let name = name.map_or_else(only_usb_port, |name| Ok(name.to_owned()))?;
        let mut port = serialport::new(&name, baud).timeout(LOOK).open().map_err(|e| cannot_open(&name, &e))?;
        // Opening can have pulled the wake-up pin low. Terminals without that wire work, too.
        let _ =
            (port.write_request_to_send(false), port.write_data_terminal_ready(false), port.clear(ClearBuffer::Input));
        Ok(Self { name, port, baud, broken: None })
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

    pub fn write(&mut self, bytes: &[u8]) {
        let (began, mut rest) = (Instant::now(), bytes);
        while !rest.is_empty() {
            match self.port.write(rest) {
                Ok(count) => rest = rest.get(count..).unwrap_or_default(),
                // The line is busy.
                Err(error)
                    if matches!(error.kind(), ErrorKind::TimedOut | ErrorKind::Interrupted | ErrorKind::WouldBlock)
                        && began.elapsed() < LAST_BYTES => {}
                Err(error) => return self.note(Err(error)),
            }
        }
    }

    /// Drops what hasn't left yet: a stop comes next.
    pub fn discard(&mut self) {
        let _ = self.port.clear(ClearBuffer::Output);
    }

    /// After all bytes so far have left.
    pub fn set_baud(&mut self, baud: u32) {
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

    /// Whether more bytes for the robot may be read from clients.
    pub fn has_room(&mut self) -> bool {
        // Ten bits a byte.
        let most = self.baud / 10 * MOST_WAITING_MS / 1000;
        self.port.bytes_to_write().is_ok_and(|waiting| waiting <= most.max(16))
    }

    /// Waits until the last bytes have left; not for ever, as waiting by the system's own means would.
    pub fn finish(&mut self) {
        let began = Instant::now();
        while self.port.bytes_to_write().is_ok_and(|waiting| waiting > 0) && began.elapsed() < LAST_BYTES {
            thread::sleep(Duration::from_millis(1));
        }
        // The adapter itself holds a few.
        thread::sleep(LOOK);
    }

    fn note(&mut self, result: io::Result<()>) {
        self.broken = result.err().or(self.broken.take());
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
