//! Builds the timeline of a recording.

use super::{
    LineEvent, RecordedReading, Timeline, Watch,
    episode::{Cluster, LastingCondition, Over},
    words::{EntryKind, TimelineEntry, counted, lasting, named},
};
use crate::{
    connection::LineRecording,
    driver::{FRAME_S, Happening, ModeLoss},
};
use roomba_oi::{Command, CommandDecoder, Mode, Opcode, Packet};
use std::sync::Arc;

/// Time without a reading that is a gap, s: a driver then stops its robot.
const GAP_S: f64 = 0.25;
/// Time by which lost frames can be apart and are told together, s; the same for commands and lines of text.
const APART_S: f64 = 2.0;
/// Time in which remains of a frame belong together, s: a garbled frame can look like several that are none.
const SAME_FRAME_S: f64 = 0.8 * FRAME_S;
/// Time after a command in which a change of mode is its effect, s.
const EFFECT_S: f64 = 2.0;
/// Charges at which the battery is mentioned, percent.
const LOW: [f64; 3] = [20.0, 10.0, 5.0];
/// Way below which a robot counts as turned only, m.
const HARDLY_M: f64 = 0.05;
/// Most entries.
const MOST: usize = 2000;

const WHEELS: [(u8, &str); 2] = [(8, "left"), (4, "right")];
const CLIFFS: [(u8, &str); 4] = [(1, "left"), (2, "front left"), (4, "front right"), (8, "right")];
const MOTORS: [(u8, &str); 4] = [(16, "left wheel"), (8, "right wheel"), (4, "main brush"), (1, "side brush")];
const BUTTONS: [(u8, &str); 8] = [
    (1, "CLEAN"),
    (2, "SPOT"),
    (4, "DOCK"),
    (8, "minute"),
    (16, "hour"),
    (32, "day"),
    (64, "schedule"),
    (128, "clock"),
];
const CHARGERS: [(u8, &str); 2] = [(1, "its charger"), (2, "its dock")];

/// Goes through a recording and writes its timeline.
pub struct Examination {
    watch: Watch,
    notes: Notes,
    is_done: bool,
}

impl Examination {
    /// At the start of a recording.
    pub fn new(recording: impl Into<Arc<LineRecording>>) -> Self {
        Self { watch: Watch::new(recording), notes: Notes::default(), is_done: false }
    }

    /// Goes through the next `seconds` of the recording; whether there is more.
    pub fn go_on(&mut self, seconds: f64) -> bool {
        if self.is_done {
            return false;
        }
        let Self { watch, notes, .. } = self;
        let has_more = watch.go_on(seconds, |at, event| notes.take(at, event));
        if !has_more {
            self.is_done = true;
            let (end, diagnosis) = (self.watch.duration_s(), self.watch.diagnosis());
            self.notes.finish(end, &diagnosis);
        }
        has_more
    }

    /// The timeline, as far as it went.
    pub fn timeline(&self) -> Timeline {
        let mut timeline = Timeline { duration_s: self.watch.duration_s(), ..self.notes.timeline.clone() };
        // Episodes are told when they are over.
        timeline.entries.sort_by(|a, b| a.time_s.total_cmp(&b.time_s));
        timeline
    }
}

/// Wheels that were told to turn.
#[derive(Debug, Clone, Copy)]
struct DriveEpisode {
    from: f64,
    /// When they were stopped.
    until: Option<f64>,
    /// Path driven before, m.
    before_m: f64,
}

#[derive(Debug, Default)]
struct Notes {
    timeline: Timeline,
    mode: Option<Mode>,
    loss: Option<ModeLoss>,
    /// The last command that changes the mode: itself, the mode after it, its time.
    cause: Option<(Opcode, Mode, f64)>,
    /// Since when a reading is due; `None` if none is.
    due_since: Option<f64>,
    wheels: LastingCondition,
    cliffs: LastingCondition,
    motors: LastingCondition,
    virtual_wall: LastingCondition,
    buttons: LastingCondition,
    chargers: LastingCondition,
    charging_fault: LastingCondition,
    brushes: LastingCondition,
    brushes_on: bool,
    bumped: bool,
    /// Number of low charges mentioned.
    low: usize,
    driven: Option<DriveEpisode>,
    commands: Cluster<Opcode>,
    frames: Cluster<()>,
    last_loss: f64,
    texts: Cluster<()>,
    first_text: String,
}

impl Notes {
    fn add(&mut self, time_s: f64, kind: EntryKind, is_fault: bool, text: impl Into<String>) {
        self.add_lasting(time_s, 0.0, kind, is_fault, text);
    }

    fn add_lasting(&mut self, time_s: f64, duration_s: f64, kind: EntryKind, is_fault: bool, text: impl Into<String>) {
        if self.timeline.entries.len() < MOST {
            self.timeline.entries.push(TimelineEntry { time_s, duration_s, kind, is_fault, text: text.into() });
        } else {
            self.timeline.left_out += 1;
        }
    }

    fn take(&mut self, now: f64, event: LineEvent) {
        match event {
            LineEvent::Line(words) => self.line(now, &words),
            LineEvent::Asked(json) => self.asked(now, &json),
            LineEvent::Reading(reading) => self.reading(now, &reading),
            LineEvent::Happening(Happening::Sent(bytes)) => {
                let mut decoder = CommandDecoder::default();
                for &byte in &bytes {
                    if let Some(Ok(command)) = decoder.push(byte).map(|received| received.command) {
                        self.command(now, command);
                    }
                }
            }
            LineEvent::Happening(Happening::Refused(_, why)) if why.is_loss() => self.lost_frame(now),
            LineEvent::Happening(Happening::Text(line)) => {
                let over = self.texts.take(now, (), APART_S);
                self.tell_text(over);
                if self.first_text.is_empty() {
                    self.first_text = line;
                }
            }
            LineEvent::Happening(_) => {}
        }
    }

    fn line(&mut self, now: f64, words: &str) {
        let why = words.strip_prefix("lost ");
        if words == "open" || why.is_some() {
            self.due_since = None;
        }
        match (words, why, words.strip_prefix("baud ")) {
            ("open", ..) => self.add(now, EntryKind::Line, false, "The line was opened."),
            ("brc low", ..) => self.add(now, EntryKind::Line, false, "The wake-up wire (BRC) was pulled low."),
            ("brc high", ..) => {}
            (_, Some(why), _) => self.add(now, EntryKind::Line, true, format!("The line was lost: {why}")),
            (_, _, Some(baud)) => self.add(now, EntryKind::Line, false, format!("The line was set to {baud} baud.")),
            _ => self.add(now, EntryKind::Line, false, words),
        }
    }

    fn asked(&mut self, now: f64, json: &str) {
        #[derive(serde::Deserialize)]
        struct ProgramStart {
            title: String,
            #[serde(rename = "start")]
            _start: [f64; 3],
        }
        if let Ok(ProgramStart { title, .. }) = serde_json::from_str(json) {
            self.add(now, EntryKind::Command, false, format!("\"{title}\" was started."));
        }
    }

    fn command(&mut self, now: f64, command: Command<'_>) {
        let opcode = command.opcode();
        if let Some(mode) = self.mode.and_then(|mode| mode.after_command(opcode))
            && Some(mode) != self.mode
        {
            self.cause = Some((opcode, mode, now));
        }
        match command {
            Command::DriveDirect { right, left } | Command::DrivePwm { right, left } => {
                self.drive(now, (right, left) != (0, 0));
            }
            Command::Drive { velocity, .. } => self.drive(now, velocity != 0),
            Command::Motors(motors) => {
                self.brushes_on = motors.main_brush || motors.side_brush || motors.vacuum;
            }
            Command::PwmMotors { main_brush, side_brush, vacuum } => {
                self.brushes_on = (main_brush, side_brush, vacuum) != (0, 0, 0);
            }
            Command::PauseResume { state: 0 } => self.due_since = None,
            Command::PauseResume { .. } | Command::Stream { .. } => {
                if self.mode.is_some() {
                    self.due_since.get_or_insert(now);
                }
            }
            Command::Start
            | Command::Safe
            | Command::Full
            | Command::Control
            | Command::SensorReadings { .. }
            | Command::QueryList { .. } => {}
            _ => {
                if matches!(opcode, Opcode::Stop | Opcode::Power | Opcode::Reset) {
                    self.due_since = None;
                    self.drive(now, false);
                }
                let over = self.commands.take(now, opcode, APART_S);
                self.tell_commands(over);
            }
        }
    }

    fn drive(&mut self, now: f64, moves: bool) {
        // Off and Passive ignore it.
        let moves = moves && self.mode >= Some(Mode::Safe);
        match &mut self.driven {
            Some(driven) if moves => driven.until = None,
            Some(driven) => {
                driven.until.get_or_insert(now);
            }
            None if moves => {
                self.driven = Some(DriveEpisode { from: now, until: None, before_m: self.timeline.distance_m });
            }
            None => {}
        }
    }

    fn lost_frame(&mut self, now: f64) {
        if self.timeline.lost_frames > 0 && now - self.last_loss < SAME_FRAME_S {
            return;
        }
        self.last_loss = now;
        self.timeline.lost_frames += 1;
        let over = self.frames.take(now, (), APART_S);
        self.tell_frames(over);
    }

    fn reading(&mut self, now: f64, reading: &RecordedReading) {
        if self.timeline.readings == 0 {
            self.add(now, EntryKind::Line, false, "Connected: sensor readings arrive.");
        }
        self.timeline.readings += 1;
        if let Some(since) = self.due_since.filter(|since| now - since > GAP_S) {
            let text = format!("No sensor readings{}.", lasting(now - since));
            self.add_lasting(since, now - since, EntryKind::Frames, true, text);
        }
        self.due_since = Some(now);
        self.timeline.distance_m = reading.distance_m;
        self.watch_mode(now, reading);
        self.watch_contacts(now, reading);
        self.watch_battery(now, reading);
        if let Some(driven) = self.driven.filter(|driven| driven.until.is_some_and(|until| now - until > APART_S)) {
            self.tell_driven(driven, now);
        }
    }

    fn watch_mode(&mut self, now: f64, reading: &RecordedReading) {
        let before = self.mode;
        self.mode = reading.mode.or(before);
        let loss = reading.loss.as_ref().filter(|loss| self.loss.as_ref() != Some(loss));
        if let Some(loss) = loss {
            self.add(now, EntryKind::Mode, true, loss.to_string());
        } else if let Some(mode) = reading.mode.filter(|mode| Some(*mode) != before) {
            let cause = self.cause.filter(|(_, then, at)| *then == mode && now - at <= EFFECT_S);
            match (before, cause) {
                (None, _) => self.add(now, EntryKind::Mode, false, format!("The mode is {mode}.")),
                (Some(before), Some((opcode, ..))) => {
                    let text = format!("The mode changed from {before} to {mode}: command {opcode}.");
                    self.add(now, EntryKind::Mode, false, text);
                }
                (Some(before), None) => {
                    let text = format!("The mode changed from {before} to {mode} without a command.");
                    self.add(now, EntryKind::Mode, true, text);
                }
            }
        }
        if reading.mode.is_some_and(|mode| mode < Mode::Safe) {
            self.brushes_on = false;
            self.drive(now, false);
        }
        self.loss.clone_from(&reading.loss);
    }

    fn watch_contacts(&mut self, now: f64, reading: &RecordedReading) {
        let readings = &reading.readings;
        let bumped = readings.bumps.bump_left || readings.bumps.bump_right;
        self.timeline.bumps += u64::from(bumped && !self.bumped);
        self.bumped = bumped;
        // A dock's ramp is black.
        let cliffs = if readings.chargers.home_base { [false; 4] } else { readings.cliff };
        let cliffs = cliffs.iter().enumerate().map(|(at, &is_set)| u8::from(is_set) << at).sum();
        let over = [
            self.wheels.see(now, readings.bumps.byte() & 0b1100),
            self.cliffs.see(now, cliffs),
            self.motors.see(now, readings.overcurrents.byte()),
            self.virtual_wall.see(now, readings.virtual_wall.into()),
            self.buttons.see(now, readings.buttons.byte()),
            self.chargers.see(now, readings.chargers.byte()),
            self.charging_fault.see(now, (readings.charging == roomba_oi::ChargingState::Fault).into()),
            self.brushes.see(now, self.brushes_on.into()),
        ];
        self.tell_episodes(over);
    }

    fn tell_episodes(&mut self, over: [Option<Over>; 8]) {
        use EntryKind::{Battery, Command, Hazard, Robot};
        for (at, over) in over.into_iter().enumerate() {
            let Some((bits, from, duration)) = over else { continue };
            let lasts = lasting(duration);
            let (kind, is_fault, text) = match at {
                0 if bits == 0b1100 => (Hazard, true, format!("Both wheels dropped{lasts}.")),
                0 => (Hazard, true, format!("The {} wheel dropped{lasts}.", named(bits, &WHEELS))),
                1 if bits == 0b1111 => (Hazard, true, format!("No cliff sensor detected floor{lasts}.")),
                1 => (Hazard, true, format!("No floor under the cliff sensor {}{lasts}.", named(bits, &CLIFFS))),
                2 => (Hazard, true, format!("Overcurrent, {}{lasts}.", named(bits, &MOTORS))),
                3 => (Hazard, false, format!("A virtual wall was detected{lasts}.")),
                4 => (Robot, false, format!("Button {} was pressed{lasts}.", named(bits, &BUTTONS))),
                5 => (Battery, false, format!("Connected to {}{lasts}.", named(bits, &CHARGERS))),
                6 => (Battery, true, format!("Charging fault{lasts}.")),
                _ => (Command, false, format!("Brushes or vacuum were on{lasts}.")),
            };
            self.add_lasting(from, duration, kind, is_fault, text);
        }
    }

    fn watch_battery(&mut self, now: f64, reading: &RecordedReading) {
        let readings = &reading.readings;
        if readings.capacity_mah == 0 || !reading.contained.contains(Packet::BatteryCharge) {
            return;
        }
        let percent = 100.0 * f64::from(readings.charge_left_mah()) / f64::from(readings.capacity_mah);
        let [first, _] = self.timeline.charge_percent.unwrap_or([percent; 2]);
        self.timeline.charge_percent = Some([first, percent]);
        let low = LOW.iter().filter(|&&mark| percent <= mark).count();
        if low > self.low {
            self.low = low;
            self.add(now, EntryKind::Battery, true, format!("The battery is at {percent:.0} %."));
        }
    }

    fn tell_driven(&mut self, driven: DriveEpisode, now: f64) {
        self.driven = None;
        let duration = driven.until.unwrap_or(now) - driven.from;
        let metres = self.timeline.distance_m - driven.before_m;
        let text = if metres < HARDLY_M {
            format!("Turned, or hardly moved{}.", lasting(duration))
        } else {
            format!("Driven {metres:.1} m{}.", lasting(duration).replacen(" for", " in", 1))
        };
        self.add_lasting(driven.from, duration, EntryKind::Command, false, text);
    }

    fn tell_commands(&mut self, over: Option<(Opcode, u64, f64, f64)>) {
        let Some((opcode, count, from, duration)) = over else { return };
        let times = if count == 1 { String::new() } else { format!(", {count} times") };
        self.add_lasting(from, duration, EntryKind::Command, false, format!("Command {opcode}{times}."));
    }

    fn tell_frames(&mut self, over: Option<((), u64, f64, f64)>) {
        let Some(((), count, from, duration)) = over else { return };
        let frames = counted(count, "frame");
        self.add_lasting(
            from,
            duration,
            EntryKind::Frames,
            true,
            format!("{frames} lost{}.", lasting(duration).replacen(" for", " in", 1)),
        );
    }

    fn tell_text(&mut self, over: Option<((), u64, f64, f64)>) {
        let Some(((), count, from, duration)) = over else { return };
        let first = std::mem::take(&mut self.first_text);
        let more = if count == 1 { String::new() } else { format!(" and {}", counted(count - 1, "more line")) };
        self.add_lasting(
            from,
            duration,
            EntryKind::Robot,
            false,
            format!("The robot wrote \"{}\"{more}.", first.trim()),
        );
    }

    fn finish(&mut self, end: f64, diagnosis: &str) {
        let over = [
            self.wheels.end(),
            self.cliffs.end(),
            self.motors.end(),
            self.virtual_wall.end(),
            self.buttons.end(),
            self.chargers.end(),
            self.charging_fault.end(),
            self.brushes.end(),
        ];
        self.tell_episodes(over);
        let (commands, frames, texts) = (self.commands.end(), self.frames.end(), self.texts.end());
        self.tell_commands(commands);
        self.tell_frames(frames);
        self.tell_text(texts);
        if let Some(driven) = self.driven {
            self.tell_driven(driven, end);
        }
        if self.timeline.readings == 0 {
            self.add(end, EntryKind::Frames, true, format!("There are no sensor readings. {diagnosis}"));
        } else if let Some(since) = self.due_since.filter(|since| end - since > GAP_S) {
            self.add_lasting(since, end - since, EntryKind::Frames, true, "No more sensor readings.");
        }
    }
}
