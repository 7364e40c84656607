//! The Robot tab: what its map and room display in addition to [`robovac_link::connection::ConnectionView`].

use crate::amount::amount;
use robovac_core::geometry::{Pose, difference};
use robovac_sim::controller::{BEHAVIOURS, BehaviourInfo};
use std::fmt;

/// Largest distance from the start, m and rad, that counts as being there: less than can be seen, since experiments that
/// measure odometry begin there.
const AT: [f64; 2] = [0.001, 0.0035];
/// Largest distance from the start at which programs begin without asking, m and rad.
const NEAR: [f64; 2] = [0.15, 0.35];

/// Behaviours that can drive a connected robot: those that need neither a laser scanner nor a person. Unlike in Explore, they
/// may keep a map.
pub fn behaviours() -> impl Iterator<Item = &'static BehaviourInfo> {
    BEHAVIOURS.iter().copied().filter(|info| !info.claims.manual && !info.claims.needs_laser)
}

/// A robot's place relative to the start that programs assume.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StartPlace {
    /// At the start.
    At,
    /// Near enough to begin.
    Near,
    /// Elsewhere: its position estimate would be wrong.
    Elsewhere,
}

impl StartPlace {
    /// The place of a robot at `pose`.
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

/// Input of the live map's description.
#[derive(Debug, Clone, Copy)]
pub struct LiveMapWords<'a> {
    /// The room's name.
    pub room: &'a str,
    /// Mode of the robot; empty if unknown.
    pub mode: &'a str,
    /// What drives; empty if nothing does.
    pub driver: &'a str,
    /// Its estimated pose; `None` without a robot.
    pub estimate: Option<Pose>,
    /// Swept share of the reachable floor, if known.
    pub coverage: Option<f64>,
    /// Swept floor, m².
    pub swept_m2: f64,
    /// Number of bumps.
    pub bumps: usize,
    /// Number of cliff detections.
    pub cliffs: usize,
}

impl fmt::Display for LiveMapWords<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Live map of {}: ", self.room)?;
        let Some(Pose { x, y, heading }) = self.estimate else { return f.write_str("no robot") };
        let degrees = heading.to_degrees().round() as i64;
        let mode = if self.mode.is_empty() { "unknown" } else { self.mode };
        let by = if self.driver.is_empty() { "" } else { ", driven by " };
        write!(
            f,
            "estimated position {x:.2} m, {y:.2} m, heading {degrees} degrees, mode {mode}{by}{}. The robot has swept ",
            self.driver
        )?;
        match self.coverage {
            Some(share) => write!(f, "{:.0} % of the reachable floor", 100.0 * share)?,
            None => write!(f, "{:.1} square metres", self.swept_m2)?,
        }
        write!(f, "; {}, {}.", amount(self.bumps as i64, "bump"), amount(self.cliffs as i64, "cliff"))
    }
}
