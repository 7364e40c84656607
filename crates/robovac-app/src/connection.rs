//! The Robot tab: what its map and room show beside [`robovac_link::connection::ConnectionView`].

use robovac_core::geometry::{Pose, difference};
use std::fmt;

/// How far from the start a robot may stand, m and rad, to be there: nobody offers to put it there.
const AT: [f64; 2] = [0.05, 0.1];
/// How far it may stand from there when it sets off, without a question.
const NEAR: [f64; 2] = [0.15, 0.35];

/// Where a robot stands, seen from where programs assume that it starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StartPlace {
    /// There.
    At,
    /// Near enough to set off.
    Near,
    /// Elsewhere: its position estimate would be wrong.
    Elsewhere,
}

impl StartPlace {
    /// Of a robot at `pose`.
    pub fn of(pose: Pose, start: Pose) -> Self {
        let distance = (pose.position() - start.position()).norm();
        let turn = difference(start.heading, pose.heading).abs();
        let is_within = |[m, rad]: [f64; 2]| distance <= m && turn <= rad;
        if is_within(AT) {
            Self::At
        } else if is_within(NEAR) {
            Self::Near
        } else {
            Self::Elsewhere
        }
    }

    /// Name for the page.
    pub fn id(self) -> &'static str {
        match self {
            Self::At => "at",
            Self::Near => "near",
            Self::Elsewhere => "elsewhere",
        }
    }
}

/// The live map in words.
#[derive(Debug, Clone, Copy)]
pub struct LiveMapWords<'a> {
    /// The room's name.
    pub room: &'a str,
    /// Mode of the robot; empty if unknown.
    pub mode: &'a str,
    /// Who drives; empty for nobody.
    pub driver: &'a str,
    /// Its estimated pose; `None` without a robot.
    pub estimate: Option<Pose>,
    /// Share of the reachable floor that was swept, if that is known.
    pub coverage: Option<f64>,
    /// Floor that was swept, m².
    pub swept_m2: f64,
    /// How often it bumped.
    pub bumps: usize,
    /// How often it saw a cliff.
    pub cliffs: usize,
}

impl fmt::Display for LiveMapWords<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Live map of {}: ", self.room)?;
        let Some(Pose { x, y, heading }) = self.estimate else { return f.write_str("no robot yet") };
        let degrees = heading.to_degrees().round() as i64;
        let mode = if self.mode.is_empty() { "unknown" } else { self.mode };
        let by = if self.driver.is_empty() { "" } else { ", driven by " };
        write!(
            f,
            "the robot is estimated to be at {x:.2} m, {y:.2} m, heading {degrees} degrees, in mode {mode}{by}{}. It has swept ",
            self.driver
        )?;
        match self.coverage {
            Some(share) => write!(f, "{:.0} % of the reachable floor", 100.0 * share)?,
            None => write!(f, "{:.1} square metres", self.swept_m2)?,
        }
        write!(f, ", bumped {} times and seen {} cliffs.", self.bumps, self.cliffs)
    }
}
