//! State of a connection in words.

use super::{ConnectionView, TransportKind, TransportState};
use roomba_oi::Motors;
use serde::Serialize;

/// Time in control after which the battery is mentioned, s; about 0.1 Ah by then (ours).
const LONG_AWAKE_S: f64 = 120.0;
/// Time until sleep from which it is mentioned, s.
const SOON_ASLEEP_S: f64 = 240.0;

const LISTENING: &str = "Listening for a robot…";

const WATCHED: &str = "you are watching; Stop stops the robot";

const FELL_SILENT: &str = "The robot no longer sends data.";
const LOOK_AFTER_IT: &str =
    "Press CLEAN once on the robot. If nothing changes, check that the plug is fully inserted and the battery charged.";

// A Roomba 980 was driven with the packets of a Create 1 and sent nothing to a driver that asked for those of a Create 2
// (github.com/AutonomyLab/create_robot/issues/106); a 960 answers a query for all of the latter
// (github.com/duck-5/CrazyRoomba). Nobody has tried this page.
const OWN_USB_SILENT: &str = "No answer over the robot's own USB port.";
const OWN_USB_WAKE: &str = "Press CLEAN once on the robot; this page then continues automatically. If it starts cleaning, press \
                            again. Still no answer? Pull out the USB plug and put it in again.";
const OWN_USB_NO_STREAM: &str =
    "The robot answers over its own USB port, but doesn't send the sensor data that this page asks for.";
const OWN_USB_OTHER: &str = "It sent neither the data of a Create 2 nor those of a Create 1, so this page can't drive it. Press CLEAN \
                             once on the robot and connect again.";
const OWN_USB_UNTRIED: &str =
    "The robot's own USB port. This page was never tried with a Roomba 900: stay within reach.";

/// A title and a note; both can be empty.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Caption {
    /// A title.
    pub title: String,
    /// A sentence; empty for none.
    pub note: String,
}

impl Caption {
    fn new(title: impl Into<String>, note: impl Into<String>) -> Self {
        Self { title: title.into(), note: note.into() }
    }
}

/// Names of the motors that run, beside those of the wheels; empty for none.
fn running(motors: Motors) -> String {
    let brushes = match (motors.main_brush, motors.side_brush) {
        (true, true) => "brushes",
        (true, false) => "main brush",
        (false, true) => "side brush",
        (false, false) => "",
    };
    let names = [brushes, if motors.vacuum { "vacuum" } else { "" }];
    let names: Vec<_> = names.into_iter().filter(|name| !name.is_empty()).collect();
    if names.is_empty() { String::new() } else { format!("{} on", names.join(" and ")) }
}

impl ConnectionView {
    /// Fills in the captions, which depend on the other fields.
    pub(super) fn captioned(mut self) -> Self {
        self.is_recording = self.transport.kind == TransportKind::None && self.transport.state == TransportState::Open;
        self.is_open = self.phase != "closed" || self.transport.state != TransportState::Closed;
        let is_there = self.is_recording || (self.phase == "connected" && !self.is_lost());
        self.diagnosis.is_shown = self.is_open && !is_there;
        (self.diagnosis.picture, self.diagnosis.caption) = self.found();
        self.doing = self.doing_now();
        let on = running(Motors::from_byte(self.motors));
        let gap = if self.doing.note.is_empty() || on.is_empty() { "" } else { "; " };
        self.doing.note = format!("{}{gap}{on}", self.doing.note);
        self.line = self.line_caption();
        self.clock = self.clock_words();
        self
    }

    /// The same for a recording: no request is allowed.
    pub fn of_recording(mut self, name: &str) -> Self {
        self.can = super::ConnectionActions { disconnect: true, ..Default::default() };
        (self.drop, self.notice) = (None, None);
        (self.transport.state, self.transport.name) = (TransportState::Open, format!("Recording {name}"));
        self.captioned()
    }

    fn is_lost(&self) -> bool {
        self.phase == "lost" || self.transport.state == TransportState::Lost
    }

    /// Picture and caption of the diagnosis, while not connected.
    fn found(&self) -> (&'static str, Caption) {
        let diagnosis = &self.diagnosis;
        let or_listening =
            |text: &str| Caption::new(if text.is_empty() { LISTENING } else { text }, &*diagnosis.remedy);
        if self.is_lost() {
            return self.lost();
        }
        if self.phase == "diagnosing" {
            // While tests continue, no advice is given yet.
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
            "silence" if self.transport.is_own_usb => return ("usb", Caption::new(OWN_USB_SILENT, OWN_USB_WAKE)),
            "no_stream" if self.transport.is_own_usb => return ("usb", Caption::new(OWN_USB_NO_STREAM, OWN_USB_OTHER)),
            "silence" => "asleep",
            "stream" | "text" => "unheard",
            "charging" => "dock",
            "booting" => "booting",
            "bootloader" => "bootloader",
            "garbage" => "speed",
            "no_stream" => "older",
            _ => "listening",
        };
        (picture, or_listening(&diagnosis.text))
    }

    /// The same when the line or the robot on it has fallen silent.
    fn lost(&self) -> (&'static str, Caption) {
        let transport = &self.transport;
        match (transport.state, transport.kind) {
            // A recording has no line that could fail.
            (TransportState::Open, kind) if kind != TransportKind::None => {
                ("asleep", Caption::new(FELL_SILENT, LOOK_AFTER_IT))
            }
            (_, TransportKind::Socket) => ("listening", Caption::new(&*transport.text, "")),
            _ if transport.text.is_empty() => ("unplugged", Caption::new("The connection is lost.", "")),
            _ => ("unplugged", Caption::new(&*transport.text, "")),
        }
    }

    /// Picture and caption of a robot that can't be controlled yet.
    fn waited_for(&self) -> (&'static str, &'static str) {
        match self.diagnosis.finding {
            "no_stream" => ("A robot answers", "but doesn't stream its sensors"),
            "stream" | "robot" | "text" => ("Robot detected", "but it doesn't answer yet"),
            "charging" => ("Robot is charging", "but it doesn't answer yet"),
            "booting" => ("Robot is starting", "it should answer soon"),
            "bootloader" => ("Robot is in its bootloader", "it doesn't answer there"),
            "garbage" => ("Unreadable data", "perhaps another baud rate"),
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
            return Caption::new(&*transport.name, "Playback: you can't drive the robot.");
        }
        match self.phase {
            "connected" => Caption::new(
                if transport.name.is_empty() { "Connected" } else { &transport.name },
                if !transport.text.is_empty() {
                    &*transport.text
                } else if transport.is_own_usb {
                    OWN_USB_UNTRIED
                } else {
                    &*self.diagnosis.text
                },
            ),
            "waiting" => Caption::new(self.waited_for().0, &*transport.text),
            "lost" => Caption::new("Connection lost", &*transport.text),
            _ => Caption::new("Connecting…", &*transport.text),
        }
    }

    /// Caption of the robot's activity.
    fn doing_now(&self) -> Caption {
        let ride = self.ride.as_ref();
        let going = ride.filter(|ride| !ride.done);
        let title =
            |manual: bool, title: &str, by_hand: &str| if manual { by_hand.to_owned() } else { title.to_owned() };
        if self.is_recording {
            let then = going
                .map_or(String::new(), |ride| format!(". Then: {}", title(ride.manual, &ride.title, "driven by hand")));
            let mode = match (self.phase, self.mode) {
                ("connected", "Passive") => "Passive: the robot itself was in control",
                ("connected", "Safe") => "Safe: the page was in control, guarded",
                ("connected", "Full") => "Full: the page was in control, unguarded",
                _ => "no sensor readings",
            };
            return Caption::new("Recording", format!("{mode}{then}"));
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
        if self.transport.is_watching {
            return match (self.moves_alone, self.mode) {
                (true, _) => Caption::new("Another client drives", WATCHED),
                (false, "Safe" | "Full") => Caption::new("Another client is in control", WATCHED),
                _ => Caption::new("Watching", "you can drive when the other client has left"),
            };
        }
        let turns = self.wheels != [0.0; 2];
        // Manual control lasts a little longer than the touch; a robot at rest isn't driven.
        if let Some(ride) = going.filter(|ride| turns || !ride.manual) {
            let activity = match ride {
                _ if self.is_slowed => "at half speed: this page responds slowly",
                ride if ride.manual => "",
                ride => ride.activity,
            };
            return Caption::new(title(ride.manual, &ride.title, "You drive"), activity);
        }
        if turns || (self.is_moving && going.is_none()) {
            return Caption::new("Driven without checks", "Stop ends it");
        }
        if self.moves_alone {
            return Caption::new("Moves by itself", "Stop ends it");
        }
        if self.calibration.step == "asking" {
            return Caption::new("Calibrating", "waiting for your answer: Tools, Calibrate");
        }
        let program = ride.filter(|ride| !ride.manual);
        if self.drop.is_some() {
            // The reason for losing control is shown above the map already.
            let what = program.map_or("Not in control".to_owned(), |ride| format!("{}: ended", ride.title));
            return Caption::new(what, "take control again to drive");
        }
        if let Some(ride) = program {
            let end = if ride.ended.is_empty() { "done" } else { "ended" };
            // Nor the text of a notice.
            let is_said = self.notice.as_ref().is_some_and(|notice| notice.text.starts_with(&ride.ended));
            return Caption::new(format!("{}: {end}", ride.title), if is_said { "" } else { &ride.ended });
        }
        match self.mode {
            "Passive" => Caption::new("Watching", "take control to drive"),
            mode => Caption::new("Ready", format!("{mode}: drive, or start an algorithm")),
        }
    }

    /// How long the robot stays awake, if relevant.
    fn clock_words(&self) -> String {
        let clock = |seconds: f64| format!("{}:{:02} min", seconds as u64 / 60, seconds as u64 % 60);
        match (self.sleeps_in_s, self.awake_s) {
            (Some(left), _) if left < SOON_ASLEEP_S => {
                format!("Falls asleep in {}; then only its Clean button wakes it.", clock(left))
            }
            (None, Some(awake)) => {
                let drain = " Under control it doesn't sleep or charge: release control when you are done.";
                format!("In control for {}.{}", clock(awake), if awake > LONG_AWAKE_S { drain } else { "" })
            }
            _ => String::new(),
        }
    }
}
