//! Connecting: identifies the device on the line, step by step.

use super::{ConnectionPhase, Driver, Finding, LineRequest, Step, distance_angle_poll::CREATE_1};
use roomba_oi::{Command, Mode};

/// Time to listen before sending anything, s.
const LISTEN_S: f64 = 0.4;
/// Time to listen to a booting robot, s, and how often.
const BOOT_S: f64 = 1.5;
const MOST_BOOTS: u32 = 4;
/// Time for an answer, s; slower lines take longer.
const ANSWER_S: f64 = 0.3;
/// Queries before another test.
const QUESTIONS: u32 = 2;
/// Duration of the low pulse on BRC, s, and delay of the query after it.
const PULSE_S: f64 = 1.0;
const AWAKE_S: f64 = 1.7;
/// Time for the line to change its baud rate, s.
const CHANGE_S: f64 = 0.3;
/// Time between queries without an answer, s.
const PATIENCE_S: f64 = 2.0;
/// Time for the first frame, s, and number of stream requests.
const FRAME_WAIT_S: f64 = 0.4;
const SUBSCRIPTIONS: u32 = 4;

/// Baud rates that are tried in turn: usual, fallback, Create 1.
const RATES: [u32; 3] = [115_200, 19_200, 57_600];

impl Driver {
    /// Starts the diagnosis.
    pub(super) fn begin(&mut self, now: f64) {
        self.phase = ConnectionPhase::Diagnosing;
        self.question = None;
        self.diagnosis.go(Step::Listening, now);
        self.classifier.clear();
    }

    /// Continues the diagnosis.
    pub(super) fn find_out(&mut self, now: f64) {
        if self.is_watching {
            // The first frame connects.
            self.diagnosis.step = Step::Subscribing;
            return;
        }
        let passed = now - self.diagnosis.since;
        match self.diagnosis.step {
            Step::Idle | Step::Done => {}
            Step::Listening => {
                let is_booting = self.diagnosis.boots > 0;
                if passed >= if is_booting { BOOT_S } else { LISTEN_S } {
                    let finding = self.listen();
                    self.diagnosis.note(format!("Listened at {} baud: {finding}.", self.baud));
                    self.ask(now);
                }
            }
            Step::Asking => {
                if self.take_mode(now) {
                    return;
                }
                let patience = if self.baud < 115_200 { 2.0 * ANSWER_S } else { ANSWER_S };
                if passed >= patience * f64::from(self.diagnosis.tries) {
                    if self.diagnosis.tries < QUESTIONS {
                        // The rest of another program's stream can have garbled the answer.
                        self.classifier.clear();
                        self.question(now);
                    } else {
                        self.nobody_answered(now);
                    }
                }
            }
            Step::Waking => {
                if passed >= PULSE_S && !self.diagnosis.has_pulsed {
                    self.diagnosis.has_pulsed = true;
                    self.line.push_back(LineRequest::Brc(false));
                }
                if passed >= AWAKE_S {
                    let finding = self.listen();
                    self.diagnosis.note(format!("Held the wake-up wire (BRC) low for a second: {finding}."));
                    self.ask(now);
                }
            }
            Step::Changing => {
                if passed >= CHANGE_S {
                    self.ask(now);
                }
            }
            Step::Subscribing => {
                if passed >= FRAME_WAIT_S * f64::from(self.diagnosis.tries) {
                    if self.diagnosis.tries < SUBSCRIPTIONS {
                        self.diagnosis.tries += 1;
                        self.subscribe(now);
                    } else if !self.is_older && CREATE_1.fits(self.baud) {
                        self.diagnosis
                            .note("It sends no sensor data of a Create 2: asking for those of a Create 1.".to_owned());
                        self.begin_stream(now, true);
                    } else {
                        self.diagnosis.finding = Finding::NoStream;
                        self.diagnosis.note("It doesn't send sensor data.".to_owned());
                        self.wait(now);
                    }
                }
            }
            Step::Waiting => {
                if self.take_mode(now) {
                    return;
                }
                if passed >= PATIENCE_S {
                    if self.diagnosis.finding != Finding::NoStream {
                        self.listen();
                    }
                    self.diagnosis.go(Step::Waiting, now);
                    self.classifier.clear();
                    self.question(now);
                }
            }
        }
    }

    fn listen(&mut self) -> Finding {
        let finding = self.classifier.classify().finding();
        // Silence after a charging log still means a charging robot.
        let is_news = finding != Finding::Silence || self.diagnosis.finding == Finding::Nothing;
        if is_news {
            self.diagnosis.finding = finding;
        }
        finding
    }

    fn ask(&mut self, now: f64) {
        // In a replay the recorded queries are used.
        if self.is_replay {
            return;
        }
        self.diagnosis.go(Step::Asking, now);
        self.classifier.clear();
        self.question(now);
    }

    /// Starts the interface and queries the mode; neither moves anything.
    fn question(&mut self, now: f64) {
        self.diagnosis.tries += 1;
        if self.diagnosis.finding == Finding::Stream {
            let _ = self.send(now, Command::PauseResume { state: 0 });
        }
        let _ = self.send(now, Command::Start);
        let _ = self.send(now, Command::SensorReadings { packet: 35 });
    }

    /// Whether the mode was received, in which case the diagnosis continues from there.
    fn take_mode(&mut self, now: f64) -> bool {
        let heard = self.classifier.classify();
        // After Start the mode is Passive: 1, or 2 on robots whose mode byte is one too high.
        let offset = match heard.mode_byte() {
            Some(1) => 0,
            // If Start was lost, a robot in Safe reports 2 as well, so it is queried once more.
            Some(2) if !self.diagnosis.has_doubted => {
                self.diagnosis.has_doubted = true;
                self.classifier.clear();
                self.question(now);
                return false;
            }
            Some(2) => 1,
            _ => return false,
        };
        self.mode_offset = offset;
        self.aim(Mode::Passive, now);
        let odd = if offset == 1 { " Its mode byte is one too high, as on some robots of the 600 series." } else { "" };
        self.diagnosis.note(format!("Started it at {} baud: it answers.{odd}", self.baud));
        self.phase = ConnectionPhase::Diagnosing;
        self.parser.clear();
        self.filter.forget();
        self.begin_stream(now, false);
        true
    }

    /// Requests the stream; with `is_older`, of what a Create 1 can report.
    fn begin_stream(&mut self, now: f64, is_older: bool) {
        self.diagnosis.go(Step::Subscribing, now);
        self.diagnosis.tries = 1;
        self.has_packets_of_create_1(is_older);
        self.subscribe(now);
    }

    fn nobody_answered(&mut self, now: f64) {
        let finding = self.listen();
        self.diagnosis.note(format!("Started it at {} baud and asked for its mode: {finding}.", self.baud));
        match (self.baud, finding) {
            (_, Finding::Booting) if self.diagnosis.boots < MOST_BOOTS => {
                self.diagnosis.boots += 1;
                self.diagnosis.go(Step::Listening, now);
                self.classifier.clear();
            }
            (_, Finding::Bootloader) => self.wait(now),
            _ if self.is_rate_fixed => self.wait(now),
            // Garbage means a robot that is awake at another rate.
            (115_200, finding) if !self.diagnosis.has_pulsed && finding != Finding::Garbage => {
                self.line.push_back(LineRequest::Brc(true));
                self.diagnosis.go(Step::Waking, now);
                self.classifier.clear();
            }
            (baud, _) => {
                let next = RATES.iter().skip_while(|&&rate| rate != baud).nth(1).copied();
                self.set_rate(now, next.unwrap_or(RATES[0]));
                if next.is_none() {
                    self.wait(now);
                }
            }
        }
    }

    pub(super) fn set_rate(&mut self, now: f64, baud: u32) {
        self.baud = baud;
        self.line.push_back(LineRequest::Baud(baud));
        self.diagnosis.go(Step::Changing, now);
        self.classifier.clear();
    }

    fn wait(&mut self, now: f64) {
        if self.baud != RATES[0] {
            self.set_rate(now, RATES[0]);
        }
        self.phase = ConnectionPhase::Waiting;
        self.diagnosis.go(Step::Waiting, now);
        self.classifier.clear();
    }
}
