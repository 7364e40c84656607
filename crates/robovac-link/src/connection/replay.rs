//! Replay of a recording through the same driver.

use super::{Connection, ConnectionView, LineRecording, RecordedEvent, Request, Traffic};
use crate::recording::LineEvent;
use robovac_core::geometry::Pose;
use std::sync::Arc;

/// Time between two ticks, s; the same as in the worker.
const TICK_S: f64 = 0.01;

/// Playback of a recording. The robot's bytes are received again; the recorded commands are taken as sent, and the
/// driver's own are discarded.
pub struct Replay {
    recording: Arc<LineRecording>,
    link: Connection,
    next: usize,
    time_s: f64,
}

impl Replay {
    /// At the start of the recording.
    pub fn new(recording: impl Into<Arc<LineRecording>>) -> Self {
        Self { recording: recording.into(), link: replaying(), next: 0, time_s: 0.0 }
    }

    /// Duration, s.
    pub fn duration_s(&self) -> f64 {
        self.recording.entries.last().map_or(0.0, |(at, _)| *at)
    }

    /// Current time, s since the start.
    pub fn time_s(&self) -> f64 {
        self.time_s
    }

    /// Advances to `time_s`; for an earlier time, restarts from the beginning.
    pub fn advance(&mut self, time_s: f64) {
        let goal = time_s.clamp(0.0, self.duration_s());
        if goal < self.time_s {
            (self.link, self.next, self.time_s) = (replaying(), 0, 0.0);
        }
        loop {
            let entry = self.recording.entries.get(self.next).filter(|(at, _)| *at <= goal);
            let at = entry.map_or(goal, |(at, _)| *at);
            while self.time_s + TICK_S < at {
                self.time_s += TICK_S;
                self.link.replay_tick(self.time_s);
            }
            self.time_s = self.time_s.max(at);
            let Some((at, entry)) = entry else { break };
            self.link.replay_seen(*at, entry);
            match entry {
                RecordedEvent::Received(bytes) => self.link.feed(*at, bytes),
                RecordedEvent::Sent(bytes) => self.link.replay_sent(*at, bytes),
                RecordedEvent::Line(words) if words == "open" => self.link.opened(*at),
                RecordedEvent::Line(words) => {
                    if let Some(why) = words.strip_prefix("lost ") {
                        self.link.lost(*at, why, false);
                    }
                }
                RecordedEvent::Asked(json) => self.link.replay_asked(*at, json),
            }
            self.next += 1;
            self.link.replay_tick(self.time_s);
        }
    }

    /// The view at the current time. No request is allowed.
    pub fn view(&mut self) -> ConnectionView {
        ConnectionView { can: super::ConnectionActions::default(), ..self.link.view(self.time_s) }
    }

    /// Keeps what happens from here on.
    pub(crate) fn watch(&mut self) {
        self.link.watch();
    }

    /// What happened since the last call.
    pub(crate) fn take_events(&mut self) -> Vec<(f64, LineEvent)> {
        self.link.take_events()
    }

    /// See [`Connection::take_traffic`].
    pub fn take_traffic(&mut self) -> Vec<Traffic> {
        self.link.take_traffic()
    }

    /// See [`Connection::take_trace`].
    pub fn take_trace(&mut self) -> Vec<f64> {
        self.link.take_trace()
    }
}

fn replaying() -> Connection {
    let mut link = Connection::new();
    link.driver.replay();
    link
}

impl Connection {
    fn replay_tick(&mut self, now: f64) {
        self.beat(now);
        self.tick(now);
        self.discard();
    }

    fn replay_seen(&mut self, now: f64, entry: &RecordedEvent) {
        let Some(watched) = &mut self.watched else { return };
        match entry {
            RecordedEvent::Line(words) => watched.push((now, LineEvent::Line(words.clone()))),
            RecordedEvent::Asked(json) => watched.push((now, LineEvent::Asked(json.clone()))),
            RecordedEvent::Sent(_) | RecordedEvent::Received(_) => {}
        }
    }

    fn replay_sent(&mut self, now: f64, bytes: &[u8]) {
        self.driver.was_sent(now, bytes);
        self.listen();
    }

    /// Repeats requests that affect the interpretation of readings; the others are visible in the sent bytes.
    fn replay_asked(&mut self, now: f64, json: &str) {
        #[derive(serde::Deserialize)]
        struct RideStart {
            start: [f64; 3],
        }
        if let Ok(RideStart { start: [x, y, heading] }) = serde_json::from_str(json) {
            self.place(Pose::new(x, y, heading));
            self.mark(Pose::new(x, y, heading));
        } else if let Ok(request @ (Request::UseCalibration { .. } | Request::Odometry { .. })) =
            serde_json::from_str(json)
        {
            // A request that was refused then is refused again.
            let _ = self.request(now, request);
        }
    }
}
