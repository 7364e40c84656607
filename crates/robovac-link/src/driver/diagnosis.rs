//! Diagnosis of the device on the line, with advice.

use std::fmt;

/// Step of the diagnosis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Step {
    /// Nothing.
    #[default]
    Idle,
    /// Listens without sending: a stream, text or noise is more informative than an answer.
    Listening,
    /// Starts the interface and queries the mode.
    Asking,
    /// Pulls the BRC wire low for a second, once; longer than the 50 to 500 ms that would change the baud rate.
    Waking,
    /// The line changes to another baud rate.
    Changing,
    /// Requests the stream.
    Subscribing,
    /// No answer; queries every other second, so that pressing CLEAN is enough.
    Waiting,
    /// A device was found.
    Done,
}

/// Content received on the line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Finding {
    /// Not listened yet.
    #[default]
    Nothing,
    /// No byte.
    Silence,
    /// Frames requested by another program.
    Stream,
    /// The charging log.
    Charging,
    /// A boot banner.
    Booting,
    /// The byte 0xFE repeatedly.
    Bootloader,
    /// Meaningless bytes.
    Garbage,
    /// Other text.
    Text,
    /// It answers but sends no stream.
    NoStream,
    /// A robot.
    Robot,
}

impl Finding {
    /// Name in views.
    pub fn id(self) -> &'static str {
        match self {
            Self::Nothing => "nothing",
            Self::Silence => "silence",
            Self::Stream => "stream",
            Self::Charging => "charging",
            Self::Booting => "booting",
            Self::Bootloader => "bootloader",
            Self::Garbage => "garbage",
            Self::Text => "text",
            Self::NoStream => "no_stream",
            Self::Robot => "robot",
        }
    }

    /// Its meaning, in one sentence for users.
    pub fn text(self) -> &'static str {
        match self {
            Self::Nothing => "Listening to the line.",
            Self::Silence => {
                "No answer. The robot is asleep or switched off, the cable isn't connected, or it is another model."
            }
            Self::Stream => "Another program already streams this robot's sensors.",
            Self::Charging => "The robot is charging: it writes its charging log.",
            Self::Booting => "The robot is starting up.",
            Self::Bootloader => "The robot is stuck in its bootloader.",
            Self::Garbage => "The received bytes make no sense: the baud rate is wrong, or it isn't a Roomba.",
            Self::Text => "Text is received, but there is no answer.",
            Self::NoStream => "A robot answers, but doesn't send sensor data.",
            Self::Robot => "A robot answers.",
        }
    }

    /// Advice; empty for none.
    pub fn remedy(self) -> &'static str {
        match self {
            Self::Nothing | Self::Robot => "",
            Self::Silence => {
                "Press CLEAN once on the robot to wake it; this page then continues automatically. If it starts \
                 cleaning, press again. Still no answer? Check that the plug is fully inserted and the battery is in. If \
                 it beeps when this page connects, its answer doesn't get through: see Cable and wiring, No telemetry."
            }
            Self::Charging => {
                "Wait a moment. If nothing happens, take the robot off its dock and press CLEAN once: some robots fall \
                 silent while charging."
            }
            Self::Booting => "Wait five seconds.",
            Self::Bootloader => "Remove its battery for ten seconds, put it back, and press CLEAN.",
            Self::Garbage => {
                "Check that this is the robot's port and that no other program uses it. To reset the robot's baud \
                 rate, remove its battery for a moment."
            }
            Self::Stream | Self::Text => {
                "Press CLEAN once on the robot. If nothing changes, close other programs that use the port, and check the \
                 wire from the adapter's TXD to pin 3 of the robot's socket."
            }
            Self::NoStream => {
                "It may be a Roomba 400, whose older protocol this page doesn't support. Otherwise, press CLEAN and connect \
                 again."
            }
        }
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Nothing | Self::Silence => "silence",
            Self::Stream => "a sensor stream",
            Self::Charging => "a charging log",
            Self::Booting => "a booting robot",
            Self::Bootloader => "a bootloader",
            Self::Garbage => "unreadable bytes",
            Self::Text => "text",
            Self::NoStream => "an answer, but no stream",
            Self::Robot => "a robot",
        })
    }
}

/// State of the diagnosis.
#[derive(Debug, Clone, Default)]
pub struct Diagnosis {
    /// The present step.
    pub step: Step,
    /// The last finding.
    pub finding: Finding,
    /// Tests so far and their results, in order.
    pub log: Vec<String>,
    /// When the step began, s.
    pub(super) since: f64,
    /// Queries in this step, and how often the line was given time to boot.
    pub(super) tries: u32,
    pub(super) boots: u32,
    pub(super) has_pulsed: bool,
    /// Whether a mode of 2 was queried twice.
    pub(super) has_doubted: bool,
}

/// Most lines of the log.
const MOST_LINES: usize = 40;

impl Diagnosis {
    /// Adds a line to the log.
    pub(super) fn note(&mut self, line: String) {
        if self.log.last() != Some(&line) && self.log.len() < MOST_LINES {
            self.log.push(line);
        }
    }

    pub(super) fn go(&mut self, step: Step, now: f64) {
        (self.step, self.since, self.tries) = (step, now, 0);
    }
}
