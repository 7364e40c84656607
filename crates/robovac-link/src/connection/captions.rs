//! What a connection is doing, in words.

use super::{ConnectionView, TransportKind, TransportState};
use serde::Serialize;

/// Time in control from which the battery is worth a word, s; 0.1 Ah or so by then (our own choice).
const LONG_AWAKE_S: f64 = 120.0;
/// Time until it sleeps from which that is worth a word, s.
const SOON_ASLEEP_S: f64 = 240.0;

const LISTENING: &str = "Listening for a robot…";

/// A few words, and a few more; these may be empty.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Caption {
    /// A title.
    pub title: String,
    /// A sentence.
    pub note: String,
}

impl Caption {
    fn new(title: impl Into<String>, note: impl Into<String>) -> Self {
        Self { title: title.into(), note: note.into() }
    }
}

impl ConnectionView {
    /// Fills in what follows from the rest.
    pub(super) fn captioned(mut self) -> Self {
        self.is_recording = self.transport.kind == TransportKind::None && self.transport.state == TransportState::Open;
        self.is_open = self.phase != "closed" || self.transport.state != TransportState::Closed;
        let is_there = self.is_recording || (self.phase == "connected" && !self.is_lost());
        self.diagnosis.is_shown = self.is_open && !is_there;
        (self.diagnosis.picture, self.diagnosis.caption) = self.found();
        self.doing = self.doing_now();
        self.line = self.line_caption();
        self.clock = self.clock_words();
        self
    }

    /// The same as part of a recording: what could be done then can't be done now.
    pub fn of_recording(mut self, name: &str) -> Self {
        self.can = super::ConnectionActions { disconnect: true, ..Default::default() };
        (self.drop, self.notice) = (None, None);
        (self.transport.state, self.transport.name) = (TransportState::Open, format!("Recording {name}"));
        self.captioned()
    }

    fn is_lost(&self) -> bool {
        self.phase == "lost" || self.transport.state == TransportState::Lost
    }

    /// Picture and words for who was found, while nobody is connected.
    fn found(&self) -> (&'static str, Caption) {
        let diagnosis = &self.diagnosis;
        let or_listening =
            |text: &str| Caption::new(if text.is_empty() { LISTENING } else { text }, &*diagnosis.remedy);
        if self.is_lost() {
            let why = if self.transport.text.is_empty() { &diagnosis.text } else { &self.transport.text };
            return ("unplugged", or_listening(why));
        }
        if self.phase == "diagnosing" {
            // Who is still trying doesn't send anybody to press buttons.
            let trying = match diagnosis.step {
                "asking" => "Waiting for an answer…",
                "waking" => "Waking it through the cable's wake-up wire…",
                "slow" => "Trying 19,200 baud…",
                "create1" => "Trying 57,600 baud…",
                _ => LISTENING,
            };
            return ("listening", Caption::new(trying, ""));
        }
        let picture = match diagnosis.finding {
            "silence" => "asleep",
            "stream" | "robot" | "text" | "no_stream" => "awake",
            "charging" => "dock",
            "booting" | "bootloader" => "boot",
            "garbage" => "speed",
            _ => "listening",
        };
        (picture, or_listening(&diagnosis.text))
    }

    /// Who is there while nothing can be done with it.
    fn waited_for(&self) -> (&'static str, &'static str) {
        match self.diagnosis.finding {
            "no_stream" => ("A robot answers", "but doesn't stream its sensors"),
            "stream" | "robot" | "text" => ("Robot detected", "but it doesn't answer yet"),
            "charging" => ("Robot is charging", "but it doesn't answer yet"),
            "booting" => ("Robot is starting", "it should answer soon"),
            "bootloader" => ("Robot is in its bootloader", "it doesn't answer there"),
            "garbage" => ("Unreadable data", "maybe another speed"),
            _ => ("No answer", "still trying"),
        }
    }

    /// Name and state of the line.
    fn line_caption(&self) -> Caption {
        let transport = &self.transport;
        if !self.is_open {
            return Caption::new("Not connected", "Connect a real robot by cable, or the virtual one.");
        }
        if self.is_recording {
            return Caption::new(&*transport.name, "Playback: nothing can be driven.");
        }
        match self.phase {
            "connected" => Caption::new(
                if transport.name.is_empty() { "Connected" } else { &transport.name },
                if transport.text.is_empty() { &*self.diagnosis.text } else { &transport.text },
            ),
            "waiting" => Caption::new(self.waited_for().0, &*transport.text),
            "lost" => Caption::new("Connection lost", &*transport.text),
            _ => Caption::new("Connecting…", &*transport.text),
        }
    }

    /// What the robot is doing.
    fn doing_now(&self) -> Caption {
        let ride = self.ride.as_ref();
        let going = ride.filter(|ride| !ride.done);
        let title =
            |manual: bool, title: &str, by_hand: &str| if manual { by_hand.to_owned() } else { title.to_owned() };
        if self.is_recording {
            let then = going
                .map_or(String::new(), |ride| format!(". Then: {}", title(ride.manual, &ride.title, "driven by hand")));
            return Caption::new("Recording", format!("nothing can be driven{then}"));
        }
        if !self.is_open {
            return Caption::new("No robot", "connect one, or try the virtual one");
        }
        if matches!(self.phase, "diagnosing" | "closed") {
            return Caption::new("Looking for a robot", &*self.transport.name);
        }
        if self.phase == "waiting" {
            let (what, more) = self.waited_for();
            return Caption::new(what, more);
        }
        if self.is_lost() {
            return Caption::new("Connection lost", &*self.transport.text);
        }
        if self.calibration.step == "moving" {
            return Caption::new("Calibrating", &*self.calibration.text);
        }
        let turns = self.wheels != [0.0; 2];
        // Control by hand goes on for a while after one has let go; who stands still isn't driven.
        if let Some(ride) = going.filter(|ride| turns || !ride.manual) {
            let activity = if ride.manual { "" } else { ride.activity };
            return Caption::new(title(ride.manual, &ride.title, "You drive"), activity);
        }
        if turns {
            return Caption::new("Driven by your bytes", "Stop ends it");
        }
        if self.moves_alone {
            return Caption::new("Moves by itself", "Stop ends it");
        }
        if self.calibration.step == "asking" {
            return Caption::new("Calibrating", "waiting for your answer: Tools, Calibrate");
        }
        let program = ride.filter(|ride| !ride.manual);
        if self.drop.is_some() {
            // Why control was lost is said above the map already.
            let what = program.map_or("Not in control".to_owned(), |ride| format!("{}: ended", ride.title));
            return Caption::new(what, "take control again to drive");
        }
        if let Some(ride) = program {
            let end = if ride.ended.is_empty() { "done" } else { "ended" };
            // Nor what a notice says.
            let is_said = self.notice.as_ref().is_some_and(|notice| notice.text.starts_with(&ride.ended));
            return Caption::new(format!("{}: {end}", ride.title), if is_said { "" } else { &ride.ended });
        }
        match self.mode {
            "Passive" => Caption::new("Watching", "take control to drive"),
            mode => Caption::new("Ready", format!("{mode}: drive, or start an algorithm")),
        }
    }

    /// How long the robot stays awake, where that matters.
    fn clock_words(&self) -> String {
        let clock = |seconds: f64| format!("{}:{:02}", seconds as u64 / 60, seconds as u64 % 60);
        match (self.sleeps_in_s, self.awake_s) {
            (Some(left), _) if left < SOON_ASLEEP_S => {
                format!("Falls asleep in {}; then only its Clean button wakes it.", clock(left))
            }
            (None, Some(awake)) => {
                let drain = " It doesn't sleep or charge meanwhile: release control when you are done.";
                format!("In control for {}.{}", clock(awake), if awake > LONG_AWAKE_S { drain } else { "" })
            }
            _ => String::new(),
        }
    }
}
