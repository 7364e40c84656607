//! Serial traffic described in words.

use super::{Traffic, TrafficKind};
use crate::driver::{FrameRefusal, Happening};
use roomba_oi::{Command, CommandDecoder, Packet, ParseError, StreamFrame, Time};
use std::fmt::Write;

/// Most lines kept until they are fetched.
const MOST: usize = 1000;
/// Days in the order of their numbers.
const DAYS: [&str; 7] = ["Sunday", "Monday", "Tuesday", "Wednesday", "Thursday", "Friday", "Saturday"];
/// Most values named in a line.
const MOST_VALUES: usize = 6;

/// Converts events to lines; repeated ones become one line.
#[derive(Debug, Default)]
pub(super) struct Console {
    lines: Vec<Traffic>,
    /// Values of the last frame described.
    last: Vec<(Packet, u16)>,
}

impl Console {
    /// Takes an event.
    pub fn take(&mut self, time_s: f64, happening: &Happening) {
        match happening {
            Happening::Sent(bytes) => {
                let mut decoder = CommandDecoder::default();
                for &byte in bytes {
                    if let Some(received) = decoder.push(byte) {
                        let text = described(received.command);
                        self.push(time_s, TrafficKind::Sent, received.bytes, text);
                    }
                }
                if let Some((opcode, count)) = decoder.waiting() {
                    let rest = bytes.get(bytes.len().saturating_sub(count)..).unwrap_or_default();
                    let text = format!("{opcode}, incomplete: the robot waits for the rest");
                    self.push(time_s, TrafficKind::Sent, rest, text);
                }
            }
            Happening::Frame(bytes) => {
                let text = self.changes(bytes);
                self.push(time_s, TrafficKind::Frame, bytes, text);
            }
            // It isn't lost yet.
            Happening::Refused(bytes, why @ FrameRefusal::Unconfirmed) => {
                self.push(time_s, TrafficKind::Held, bytes, why.to_string());
            }
            Happening::Refused(bytes, why) => self.push(time_s, TrafficKind::Refused, bytes, format!("refused: {why}")),
            Happening::Text(line) => self.push(time_s, TrafficKind::Text, line.as_bytes(), line.clone()),
            Happening::Answer(bytes, words) => self.push(time_s, TrafficKind::Bytes, bytes, words.clone()),
            Happening::Line(text) => self.push(time_s, TrafficKind::Line, &[], text.clone()),
        }
    }

    /// Lines since the last call, oldest first.
    pub fn lines(&mut self) -> Vec<Traffic> {
        std::mem::take(&mut self.lines)
    }

    fn push(&mut self, time_s: f64, kind: TrafficKind, bytes: &[u8], text: String) {
        let hex = hex(bytes);
        if let Some(last) = self.lines.last_mut()
            && last.kind == kind
            && (kind == TrafficKind::Frame || (last.text == text && last.hex == hex))
        {
            (last.time_s, last.times) = (time_s, last.times + 1);
            if kind == TrafficKind::Frame {
                (last.hex, last.text) = (hex, text);
            }
            return;
        }
        if self.lines.len() < MOST {
            self.lines.push(Traffic { time_s, kind, hex, text, times: 1 });
        }
    }

    /// Values of a frame that differ from the last one.
    fn changes(&mut self, bytes: &[u8]) -> String {
        let Ok(frame) = StreamFrame::parse(bytes) else { return String::new() };
        let values: Vec<_> = frame.values().collect();
        let mut text = String::new();
        let mut count = 0;
        for &(packet, raw) in values.iter().filter(|value| !self.last.contains(value)) {
            count += 1;
            if count <= MOST_VALUES {
                let comma = if text.is_empty() { "" } else { ", " };
                // Writing to a string doesn't fail.
                let _ = write!(text, "{comma}{packet} {} {}", packet.value(raw), packet.unit());
                text.truncate(text.trim_end().len());
            }
        }
        if count > MOST_VALUES {
            let _ = write!(text, " and {} more", count - MOST_VALUES);
        }
        self.last = values;
        if text.is_empty() { "nothing new".to_owned() } else { text }
    }
}

/// Bytes in hexadecimal.
pub(super) fn hex(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(3 * bytes.len());
    for (index, byte) in bytes.iter().enumerate() {
        let gap = if index == 0 { "" } else { " " };
        let _ = write!(text, "{gap}{byte:02X}");
    }
    text
}

fn time_of_day([hour, minute]: Time) -> String {
    format!("{hour}:{minute:02}")
}

fn described(command: Result<Command<'_>, ParseError>) -> String {
    let command = match command {
        Ok(command) => command,
        Err(error) => return error.to_string(),
    };
    let name = command.opcode();
    let data = match command {
        Command::Drive { velocity, radius } => format!("{velocity} mm/s, radius {radius} mm"),
        Command::DriveDirect { right, left } => format!("right {right} mm/s, left {left} mm/s"),
        Command::DrivePwm { right, left } => format!("right {right}/255, left {left}/255"),
        Command::Motors(motors) => format!("{:05b}", motors.byte()),
        Command::PwmMotors { main_brush, side_brush, vacuum } => {
            format!("main brush {main_brush}/127, side brush {side_brush}/127, vacuum {vacuum}/127")
        }
        Command::Leds { lamps, colour, intensity } => {
            format!("lamps {:04b}, colour {colour}, brightness {intensity}", lamps.byte())
        }
        Command::Song { number, notes } => format!("number {number}, notes: {}", notes.len()),
        Command::Play { number } => format!("number {number}"),
        Command::SensorReadings { packet } => format!("packet {packet}"),
        Command::Stream { packets } | Command::QueryList { packets } => {
            let ids: Vec<String> = packets.iter().map(u8::to_string).collect();
            format!("packets {}", ids.join(" "))
        }
        Command::PauseResume { state } => (if state == 0 { "pause" } else { "resume" }).to_owned(),
        Command::Baud { code } => format!("code {code}"),
        Command::DigitsAscii { text } => format!("\"{}\"", text.map(char::from).iter().collect::<String>()),
        Command::Buttons(buttons) => format!("{:08b}", buttons.byte()),
        Command::SchedulingLeds { weekdays, lamps } => {
            format!("weekdays {:07b}, lamps {:05b}", weekdays.byte(), lamps.byte())
        }
        Command::Schedule { days, times } => {
            let set = DAYS.iter().zip(times).enumerate().filter(|(day, _)| days.byte() >> day & 1 == 1);
            let set: Vec<_> = set.map(|(_, (name, time))| format!("{name} {}", time_of_day(time))).collect();
            if set.is_empty() { "off".to_owned() } else { set.join(", ") }
        }
        Command::DayTime { day, time } => {
            format!("{} {}", DAYS.get(usize::from(day)).unwrap_or(&"day ?"), time_of_day(time))
        }
        _ => String::new(),
    };
    if data.is_empty() { name.to_string() } else { format!("{name}: {data}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reading_that_waits_for_the_next_is_not_shown_as_rejected() {
        let mut console = Console::default();
        console.take(0.0, &Happening::Refused(vec![1], FrameRefusal::Unconfirmed));
        console.take(0.1, &Happening::Refused(vec![1], FrameRefusal::Impossible));
        let kinds: Vec<_> = console.lines().iter().map(|line| line.kind).collect();
        assert_eq!(kinds, [TrafficKind::Held, TrafficKind::Refused]);
    }
}
