//! A connection to a robot: the driver, what rides on it, what is shown and kept of it.
//!
//! It has no clock and no line of its own. Whoever has both tells it the time in seconds, brings it the bytes that arrive,
//! and sends what [`Link::take_tx`] and [`Link::take_line`] ask for, at once: the stop is among it.

mod request;
mod view;

pub use request::{Calibration, PressedButton, Request};
pub use view::{
    CalibrationView, Can, DiagnosisView, DropView, LinkView, Notice, RideView, Statistics, Traffic, TrafficKind,
};

use crate::{controller::Controller, geometry::Pose};
use thiserror::Error;

/// Why a request is refused. Its text is a sentence for users.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{0}")]
pub struct Refused(pub String);

/// What the transport is to do with the line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LineRequest {
    /// Go on at another baud rate: close and open again, if that is what it takes.
    Baud(u32),
    /// Pull the BRC wire low (`true`: RTS asserted) or let it go.
    Brc(bool),
}

/// A connection to a robot.
#[derive(Default)]
pub struct Link {}

impl Link {
    /// Not connected.
    pub fn new() -> Self {
        Self::default()
    }

    /// The transport is open at 115200 baud: finds out who is there.
    pub fn opened(&mut self, _now: f64) {}

    /// The transport is gone, and why; `for_good` if it won't come back by itself.
    pub fn lost(&mut self, _now: f64, _why: &str, _for_good: bool) {}

    /// Takes bytes from the line.
    pub fn feed(&mut self, _now: f64, _bytes: &[u8]) {}

    /// The page is alive.
    pub fn beat(&mut self, _now: f64) {}

    /// Stops the robot and leaves it in Passive, as the page goes away or is hidden.
    pub fn leave(&mut self, _now: f64, _why: &str) {}

    /// Lets time pass; call it at least every 20 ms.
    pub fn tick(&mut self, _now: f64) {}

    /// Bytes to be sent, now; empty if there are none.
    pub fn take_tx(&mut self) -> Vec<u8> {
        Vec::new()
    }

    /// What is to be done with the line before the next bytes are sent.
    pub fn take_line(&mut self) -> Option<LineRequest> {
        None
    }

    /// Does what the user asks for, or says why not.
    pub fn request(&mut self, _now: f64, _request: Request) -> Result<(), Refused> {
        Ok(())
    }

    /// Lets `controller` drive, which is called `title`; the robot is taken to stand at `start`.
    pub fn ride(
        &mut self,
        _now: f64,
        _title: &str,
        _controller: Box<dyn Controller>,
        _start: Pose,
    ) -> Result<(), Refused> {
        Ok(())
    }

    /// What the page shows.
    pub fn view(&mut self, _now: f64) -> LinkView {
        LinkView::default()
    }

    /// What went over the line since this was last asked for, oldest first.
    pub fn take_traffic(&mut self) -> Vec<Traffic> {
        Vec::new()
    }

    /// Where the robot believes to have been since this was last asked for, a reading after the other, four numbers each:
    /// x and y in m, heading in rad, and what it felt there, as the sum of 1 bumper left, 2 bumper right, 4 cliff left, 8
    /// cliff front left, 16 cliff front right, 32 cliff right, 64 wheel drop, 128 virtual wall.
    pub fn take_trace(&mut self) -> Vec<f64> {
        Vec::new()
    }

    /// Everything that went over the line so far, as a recording.
    pub fn recording(&self) -> String {
        String::new()
    }
}
