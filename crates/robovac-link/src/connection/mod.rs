//! A connection to a robot: driver, controller, view model and recording.
//!
//! It has no clock and no line of its own. The caller passes the time in seconds and the received bytes, and must
//! execute [`Connection::take_tx`] and [`Connection::take_line`] at once, as they include stop commands.

mod asked;
mod calibration;
mod captions;
mod drive_session;
mod floor_measure;
mod moves;
mod page_watch;
mod reading;
mod recording;
mod replay;
mod request;
mod snapshot;
mod traffic;
mod transport;
mod typed;
mod view;
mod wheel_watch;

pub use crate::driver::LineRequest;
pub use captions::Caption;
pub use recording::{LineRecording, RecordedEvent, RecordingError};
pub use replay::Replay;
pub use request::{Calibration, PressedButton, Request};
pub use transport::{BrcWire, TransportErrors, TransportKind, TransportState, TransportView};
pub use typed::TypedBytes;
pub use view::{
    CalibrationView, ConnectionActions, ConnectionView, DiagnosisView, DriveSessionView, DropView, LightsView, Notice,
    Statistics, Traffic, TrafficKind,
};

use self::{
    calibration::{Calibrated, Calibrating, UNCOUNTED},
    drive_session::DriveSession,
    floor_measure::FloorMeasure,
    page_watch::PageWatch,
    recording::Recorder,
    traffic::Console,
    wheel_watch::WheelWatch,
};
use crate::{
    driver::{CLEANING_MOTORS, ConnectionPhase, Driver},
    recording::LineEvent,
};
use robovac_core::{
    geometry::Pose,
    robot::{self, Drive, Odometry, OdometryModel, RobotModel, RobotPort},
};
use robovac_sim::controller::Controller;
use roomba_oi::{Command, Mode, Packet, Readings};
use thiserror::Error;

/// Time without a stick command after which the stick counts as released, s.
const STICK_S: f64 = 0.2;
/// Time without a stick command after which manual control ends, s; long enough to roll back from an edge.
const LEFT_ALONE_S: f64 = 1.5;
/// Counts in the wrong direction that can't be the end of an earlier turn: 30 degrees.
const ODD_COUNTS: i32 = 138;
/// Time after which robots in Passive fall asleep, s.
const SLEEP_S: f64 = 300.0;
/// Most points of the trace kept until they are fetched: one minute.
const MOST_TRACE: usize = 4 * 64 * 60;

/// Flag of a trace point at which a program begins with an assumed pose; the trail before it is separate.
pub const SETS_OFF: u16 = 256;
/// Flag of a trace point at which the main brush was sweeping.
pub const SWEEPS: u16 = 512;
/// Least current of a main brush that turns, mA (ours: values of robots aren't published).
const TURNING_MA: u16 = 50;

/// Reason for refusing a request, as a sentence for users.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{0}")]
pub struct RequestRefused(pub String);

fn refuse<T>(why: impl Into<String>) -> Result<T, RequestRefused> {
    Err(RequestRefused(why.into()))
}

/// A connection to a robot.
pub struct Connection {
    driver: Driver,
    model: RobotModel,
    known: Calibrated,
    ride: Option<DriveSession>,
    calibrating: Option<Calibrating>,
    odometry: Odometry,
    /// The true pose, known of virtual robots.
    truth: Option<Pose>,
    odometry_model: OdometryModel,
    distance_m: f64,
    /// Time of the latest call.
    now: f64,
    page: PageWatch,
    stick_at: f64,
    /// Counts of encoder packets 43 and 44 while it turned on the spot to the left, and whether they were reported as
    /// swapped.
    turned: [i32; 2],
    /// The latest counts: left, right.
    counts: [u16; 2],
    is_odd: bool,
    wheel_watch: WheelWatch,
    transport: TransportView,
    /// Whether the correction of packet 20 was reported, and that the robot has the packets of a Create 1 only.
    is_old: bool,
    is_older: bool,
    /// The robot's mode, and since when.
    mode: Option<(Mode, f64)>,
    notice: Option<Notice>,
    notices: u32,
    trace: Vec<f64>,
    console: Console,
    recorder: Recorder,
    /// What happens, if it is watched.
    watched: Option<Vec<(f64, LineEvent)>>,
}

impl Default for Connection {
    fn default() -> Self {
        Self::new()
    }
}

impl Connection {
    /// Not connected.
    pub fn new() -> Self {
        let model = robot::model("roomba600").unwrap_or(robot::MODELS[0]).clone();
        let odometry = Odometry::new(&model, OdometryModel::Arc, Pose::new(0.0, 0.0, 0.0));
        Self {
            driver: Driver::new(),
            model,
            known: Calibrated::default(),
            ride: None,
            calibrating: None,
            odometry,
            truth: None,
            odometry_model: OdometryModel::Arc,
            distance_m: 0.0,
            now: 0.0,
            page: PageWatch::default(),
            stick_at: f64::NEG_INFINITY,
            turned: [0; 2],
            counts: [0; 2],
            is_odd: false,
            wheel_watch: WheelWatch::default(),
            transport: TransportView::default(),
            is_old: false,
            is_older: false,
            mode: None,
            notice: None,
            notices: 0,
            trace: Vec::new(),
            console: Console::default(),
            recorder: Recorder::default(),
            watched: None,
        }
    }

    // ---- the line

    /// The line is open at 115200 baud: starts the diagnosis.
    pub fn opened(&mut self, now: f64) {
        self.now = now;
        self.page.start(now);
        self.end_ride("The connection was reopened.");
        self.recorder.note(now, RecordedEvent::Line("open".into()));
        self.driver.open(now);
        self.place(self.odometry.pose());
    }

    /// The line is lost, with the reason as a sentence; `for_good` if it won't return by itself.
    pub fn lost(&mut self, now: f64, why: &str, for_good: bool) {
        self.now = now;
        self.recorder.note(now, RecordedEvent::Line(format!("lost {why}")));
        let is_loose = self.is_acting() || (self.driver.is_stalled() && self.driver.target() > Mode::Passive);
        let warning = if is_loose { self.loose() } else { "" };
        self.end_ride(why);
        self.driver.closed(now, why);
        if for_good {
            self.driver.leave(now);
        }
        self.say("error", format!("{why} {warning}").trim_end().to_owned());
    }

    /// Takes bytes from the line.
    pub fn feed(&mut self, now: f64, bytes: &[u8]) {
        self.now = now;
        self.recorder.note(now, RecordedEvent::Received(bytes.to_vec()));
        let mut rest = bytes;
        while !rest.is_empty() {
            let taken = self.driver.feed(now, rest);
            rest = rest.get(taken..).unwrap_or_default();
            if let Some(dt_s) = self.driver.take_reading() {
                self.reading(now, dt_s);
            }
        }
        self.listen();
    }

    /// The true pose of a virtual robot; `None` for others. To be said before every [`Self::tick`].
    pub fn know_truth(&mut self, truth: Option<Pose>) {
        self.truth = truth;
        let measure = self.calibrating.as_mut().and_then(Calibrating::measure);
        if let (Some(truth), Some(measure)) = (truth, measure) {
            measure.go_on(truth, self.odometry.pose());
        }
    }

    /// A hand lifts the virtual robot or puts it elsewhere, of which the real one would know nothing.
    pub fn moved_by_hand(&mut self) {
        if let Some(measure) = self.calibrating.as_mut().and_then(Calibrating::measure) {
            measure.end();
        }
    }

    /// The robot was put at `start`, where its estimate begins anew.
    pub fn put_at(&mut self, now: f64, start: Pose) {
        self.now = now;
        self.moved_by_hand();
        self.end_ride("The robot was put at its start.");
        let json = serde_json::json!({ "do": "put_at", "start": [start.x, start.y, start.heading] });
        self.recorder.note(now, RecordedEvent::Asked(json.to_string()));
        self.place(start);
        self.mark(start);
    }

    /// The page's sign of life.
    pub fn beat(&mut self, now: f64) {
        if now.is_finite() {
            self.page.heard(now);
        }
    }

    /// Stops the robot and leaves it in Passive, as the page is closed or hidden; `why` is shown to a returning user.
    pub fn leave(&mut self, now: f64, why: &str) {
        self.now = now;
        let had_control = self.driver.target() > Mode::Passive;
        self.page.forgo();
        self.end_ride(why);
        if self.driver.phase() != ConnectionPhase::Closed {
            // Twice, as nothing can be repeated later: closing the page closes the line.
            self.driver.stop(now);
            self.driver.put_in(now, Mode::Passive);
        }
        if had_control {
            self.say("notice", format!("{why} Take control again to continue."));
        }
    }

    /// Stops what drives: the caller won't call [`Self::tick`] for a while.
    pub fn pause(&mut self, now: f64) {
        self.now = now;
        if self.is_acting() {
            self.end_ride("The page was busy.");
            self.driver.halt(now);
        }
    }

    /// Advances the time; to be called at least every 20 ms.
    pub fn tick(&mut self, now: f64) {
        self.now = now;
        self.driver.tick(now);
        if self.driver.phase() != ConnectionPhase::Connected {
            self.wheel_watch.forget();
        }
        if self.recorder.has_filled_up() {
            let text = "The recording is full. Save it; what follows is not recorded until the page is reloaded.";
            self.say("notice", text.to_owned());
        }
        self.page.tick(now);
        // A controller slows down first; brushes and raw bytes have nothing between on and off.
        let is_silent = self.page.hangs() || (!self.rides() && self.page.share() <= 0.0);
        if (self.is_acting() || self.page.is_awaited()) && is_silent {
            let why = "The page stopped responding, so the robot was stopped. Close other programs that keep this \
                       computer busy, then start again.";
            self.leave(now, why);
        }
        if self.rides() && self.page.share() <= 0.0 {
            // Not only when the next reading comes, which can be late on a busy computer.
            self.driver.drive(now, Drive::STOP);
        }
        if self.is_acting() && self.driver.is_stalled() {
            self.stalled();
        }
        if self.rides() && !self.driver.is_armed() {
            let dropped = self.driver.dropped().map(ToString::to_string);
            self.end_ride(dropped.as_deref().unwrap_or("The robot is no longer under control."));
        }
        self.listen();
    }

    /// Bytes to be sent at once; empty if there are none.
    pub fn take_tx(&mut self) -> Vec<u8> {
        let bytes = self.driver.take_tx();
        if !bytes.is_empty() {
            self.recorder.note(self.now, RecordedEvent::Sent(bytes.clone()));
        }
        bytes
    }

    /// Request to the line, to be executed before the next bytes are sent.
    pub fn take_line(&mut self) -> Option<LineRequest> {
        let request = self.driver.take_line()?;
        let words = match request {
            LineRequest::Baud(baud) => format!("baud {baud}"),
            LineRequest::Brc(is_low) => format!("brc {}", if is_low { "low" } else { "high" }),
            LineRequest::Stop => "stop".to_owned(),
        };
        self.recorder.note(self.now, RecordedEvent::Line(words));
        Some(request)
    }

    /// The robot is silent while it should be moving.
    fn stalled(&mut self) {
        let what = self.loose();
        self.end_ride("No data from the robot, so a stop command was sent.");
        self.driver.halt(self.now);
        self.page.await_sign();
        self.say(
            "error",
            format!("No data from the robot. A stop command was sent, but it may not have arrived. {what}"),
        );
    }

    /// Advice for a robot that can be moving out of reach.
    fn loose(&self) -> &'static str {
        if self.driver.target() == Mode::Full {
            "It may still be moving: in Full mode nothing stops it. Hold it and press its CLEAN button."
        } else {
            "It may still be moving: lift it up, which stops its wheels and brushes in Safe mode."
        }
    }

    fn listen(&mut self) {
        for (time_s, happening) in self.driver.take_happenings() {
            self.console.take(time_s, &happening);
            if let Some(watched) = &mut self.watched {
                watched.push((time_s, LineEvent::Happening(happening)));
            }
        }
    }

    /// Whether a controller drives.
    fn rides(&self) -> bool {
        self.ride.as_ref().is_some_and(|ride| !ride.is_done)
    }

    /// Whether the robot is driven by this program, or is about to be.
    fn is_moving(&self) -> bool {
        // Once the line is closed, what was commanded last isn't any more.
        let is_commanded = self.driver.wheels().sent() != (0, 0) || self.driver.wheels().is_other() || self.rides();
        is_commanded && self.driver.phase() != ConnectionPhase::Closed
    }

    /// Whether its main brush sweeps: as commanded, or by the robot's own report while it cleans by itself.
    fn sweeps(&self) -> bool {
        let motors = self.driver.actuators().motors;
        let reported = self.driver.readings().map_or(0, |readings| readings.main_brush_ma.unsigned_abs());
        if motors.main_brush { !motors.main_brush_outward } else { reported >= TURNING_MA }
    }

    /// Whether anything moves or is switched on.
    pub fn is_acting(&self) -> bool {
        self.driver.actuators().is_running() || self.driver.wheels().is_moving() || self.rides()
    }

    // ---- what drives

    /// Starts `controller` under the name `title`; the robot's pose is set to `start`. If it `cleans`, brushes and vacuum
    /// run until it ends, for whatever reason.
    pub fn ride(
        &mut self,
        now: f64,
        title: &str,
        controller: Box<dyn Controller>,
        start: Pose,
        cleans: bool,
    ) -> Result<(), RequestRefused> {
        self.now = now;
        if !self.can().drive {
            return refuse("Take control of the robot first.");
        }
        self.nothing_asked()?;
        let mut json = serde_json::json!({ "do": "ride", "title": title, "start": [start.x, start.y, start.heading] });
        if cleans {
            json["cleans"] = true.into();
        }
        self.recorder.note(now, RecordedEvent::Asked(json.to_string()));
        self.set_off(now, title, controller, start, false);
        self.mark(start);
        if cleans {
            self.send(now, Command::Motors(CLEANING_MOTORS))?;
            if let Some(ride) = &mut self.ride {
                ride.cleans = true;
            }
        }
        Ok(())
    }

    /// Refuses to drive on while a calibration asks for a measurement.
    fn nothing_asked(&self) -> Result<(), RequestRefused> {
        match &self.calibrating {
            Some(calibrating) if calibrating.is_asking() => {
                refuse("A calibration waits for an answer: answer or skip it first, in Tools, Calibrate.")
            }
            _ => Ok(()),
        }
    }

    /// The robot model with calibrated values, for controllers.
    pub fn calibrated(&self, model: &RobotModel) -> RobotModel {
        self.known.apply(model)
    }

    /// The odometry model in use, also for controllers.
    pub fn odometry(&self) -> OdometryModel {
        self.odometry_model
    }

    fn set_off(&mut self, now: f64, title: &str, mut controller: Box<dyn Controller>, start: Pose, is_manual: bool) {
        controller.start_at(start);
        self.end_ride("Another action started.");
        self.page.heard(now);
        self.place(start);
        self.ride = Some(DriveSession {
            title: title.to_owned(),
            controller,
            is_manual,
            cleans: false,
            time_s: 0.0,
            is_done: false,
            ended: String::new(),
        });
    }

    /// Sets the robot's pose.
    fn place(&mut self, pose: Pose) {
        let mut odometry = Odometry::new(&self.known.apply(&self.model), self.odometry_model, pose);
        if self.driver.readings().is_some() {
            odometry.update(self.driver.port(self.now).sensors());
        }
        self.odometry = odometry;
    }

    /// A program begins at `pose`.
    fn mark(&mut self, pose: Pose) {
        self.trace.extend([pose.x, pose.y, pose.heading, f64::from(SETS_OFF)]);
    }

    /// Sets the state of the line: for the view, and for what can be done on it.
    pub fn set_transport(&mut self, transport: TransportView) {
        self.driver.fix_rate(!transport.can_baud);
        self.driver.watch(transport.is_watching);
        self.transport = transport;
    }

    /// Discards pending bytes, as there is no line.
    pub fn discard(&mut self) {
        let _ = self.driver.take_tx();
        while self.driver.take_line().is_some() {}
    }

    fn use_known(&mut self) {
        (self.turned, self.is_odd) = ([0; 2], false);
        self.driver.swap_encoders(self.known.swapped);
        self.place(self.odometry.pose());
    }

    fn encoders(&self) -> Option<[u16; 2]> {
        self.driver.readings().map(|Readings { left_counts, right_counts, .. }| [*left_counts, *right_counts])
    }

    /// Ends the present controller for a reason.
    fn end_ride(&mut self, why: &str) {
        let Some(ride) = self.ride.as_mut().filter(|ride| !ride.is_done) else { return };
        ride.is_done = true;
        why.clone_into(&mut ride.ended);
        let cleans = ride.cleans;
        self.driver.stop(self.now);
        if cleans {
            self.driver.stop_brushes(self.now);
        }
        if let Some(calibrating) = self.calibrating.as_mut().filter(|c| c.is_moving()) {
            calibrating.fail(&format!("Calibration aborted; nothing has changed. {why}"));
        }
    }

    /// The controller is done.
    fn ride_ended(&mut self) {
        let encoders = self.encoders();
        let Some(ride) = self.ride.as_mut() else { return };
        let activity = ride.controller.activity();
        // It gave up, and isn't done.
        if let Some(why) = activity.strip_prefix("stopped: ") {
            ride.ended = format!("Stopped: {why}.");
        }
        if let Some(calibrating) = self.calibrating.as_mut().filter(|c| c.is_moving()) {
            match encoders {
                Some(_) if activity == moves::STUCK_WORDS => {
                    calibrating.fail(&format!("{UNCOUNTED} Nothing has changed."));
                }
                Some(now) if !activity.starts_with("stopped") => calibrating.stopped(now),
                _ => calibrating.fail("Calibration aborted: something was in the way. Nothing has changed."),
            }
        }
    }

    fn say(&mut self, kind: &'static str, text: String) {
        self.notices += 1;
        self.notice = Some(Notice { number: self.notices, kind, text });
    }

    // ---- output

    /// Traffic since the last call, oldest first.
    pub fn take_traffic(&mut self) -> Vec<Traffic> {
        self.console.lines()
    }

    /// Keeps what happens from here on, for [`Self::take_events`].
    pub fn watch(&mut self) {
        self.watched = Some(Vec::new());
    }

    /// What happened since the last call, with its times, s.
    pub fn take_events(&mut self) -> Vec<(f64, LineEvent)> {
        self.watched.as_mut().map(std::mem::take).unwrap_or_default()
    }

    /// The robot's estimated trail since the last call, four numbers for each reading: x and y in m, heading in rad,
    /// and its contacts as the sum of 1 bumper left, 2 bumper right, 4 cliff left, 8 cliff front left, 16 cliff front
    /// right, 32 cliff right, 64 wheel drop, 128 virtual wall, and [`SWEEPS`]; or [`SETS_OFF`].
    pub fn take_trace(&mut self) -> Vec<f64> {
        std::mem::take(&mut self.trace)
    }

    /// All traffic so far, as a recording.
    pub fn recording(&self) -> String {
        self.recorder.text()
    }

    /// What a recording of the line has had since the last call, beginning with its header. It is forgotten here: for
    /// whoever writes it to a file, however long it becomes, or needs none.
    pub fn take_recording(&mut self) -> String {
        self.recorder.take()
    }

    /// Whether the robot's stream contains this packet, so that its value isn't just a default.
    pub fn receives(&self, packet: Packet) -> bool {
        self.driver.receives(packet)
    }
}
