//! A recording's timeline, as it is shown.

use serde::Serialize;
use std::fmt;

/// What an entry of a timeline is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum EntryKind {
    /// The line itself.
    Line,
    /// The robot's mode.
    Mode,
    /// Wheel drops, cliffs, blocked motors, virtual walls.
    Hazard,
    /// Lost frames, and times without any.
    Frames,
    /// Battery and chargers.
    Battery,
    /// Commands to the robot, and what was asked for.
    Command,
    /// Buttons pressed on the robot, and what it wrote.
    Robot,
}

/// Something that happened in a recording.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct TimelineEntry {
    /// When it began, s since the start of the recording.
    pub time_s: f64,
    /// How long it lasted, s; 0 for a moment.
    pub duration_s: f64,
    /// What it is about.
    pub kind: EntryKind,
    /// Whether something was wrong.
    pub is_fault: bool,
    /// A sentence.
    pub text: String,
}

/// What happened in a recording, in order.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Timeline {
    /// Duration of the recording, s.
    pub duration_s: f64,
    /// Readings of the sensors.
    pub readings: u64,
    /// Frames that were lost on the line, as far as their remains arrived.
    pub lost_frames: u64,
    /// Path driven by odometry, m.
    pub distance_m: f64,
    /// Times that the bumper was pressed.
    pub bumps: u64,
    /// Charge of the battery at the first and at the last reading, percent; `None` if it wasn't reported.
    pub charge_percent: Option<[f64; 2]>,
    /// What happened.
    pub entries: Vec<TimelineEntry>,
    /// Entries that were left out, as there were too many.
    pub left_out: u64,
}

impl Timeline {
    /// The figures in one line.
    pub fn summary(&self) -> String {
        let faults = self.entries.iter().filter(|entry| entry.is_fault).count();
        let mut parts = vec![
            clock(self.duration_s),
            counted(self.readings, "reading"),
            format!("{:.1} m driven", self.distance_m),
            counted(self.bumps, "bump"),
        ];
        if let Some([first, last]) = self.charge_percent {
            parts.push(format!("battery {first:.0} % to {last:.0} %"));
        }
        parts.push(counted(faults as u64, "fault"));
        parts.join(", ")
    }
}

/// Time, then text.
impl fmt::Display for TimelineEntry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}  {}", clock(self.time_s), self.text)
    }
}

/// Minutes and seconds.
pub(super) fn clock(seconds: f64) -> String {
    let tenths = (10.0 * seconds).round() as u64;
    format!("{}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10)
}

/// A number of things.
pub(super) fn counted(count: u64, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

/// Things in a sentence.
pub(super) fn listed(names: &[&str]) -> String {
    match names {
        [others @ .., before, last] if !others.is_empty() => format!("{}, {before} and {last}", others.join(", ")),
        [before, last] => format!("{before} and {last}"),
        _ => names.concat(),
    }
}

/// The names of the bits that are set.
pub(super) fn named(bits: u8, names: &[(u8, &'static str)]) -> String {
    let set: Vec<&str> = names.iter().filter(|(bit, _)| bits & bit != 0).map(|(_, name)| *name).collect();
    listed(&set)
}

/// How long something lasted; empty for a moment.
pub(super) fn lasting(seconds: f64) -> String {
    match seconds {
        ..0.05 => String::new(),
        ..10.0 => format!(" for {seconds:.1} s"),
        ..100.0 => format!(" for {seconds:.0} s"),
        _ => format!(" for {:.0} min {:.0} s", (seconds / 60.0).floor(), seconds % 60.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_words() {
        assert_eq!([0.04, 59.96, 72.4, 3600.0].map(clock), ["0:00.0", "1:00.0", "1:12.4", "60:00.0"]);
        assert_eq!([0.0, 2.06, 12.3, 130.0].map(lasting), ["", " for 2.1 s", " for 12 s", " for 2 min 10 s"]);
        assert_eq!([&["a"][..], &["a", "b"], &["a", "b", "c"]].map(listed), ["a", "a and b", "a, b and c"]);
        assert_eq!((counted(1, "fault"), counted(0, "fault")), ("1 fault".into(), "0 faults".into()));
    }
}
