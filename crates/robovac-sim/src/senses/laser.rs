//! Laser scanner: distances all around, several times a second.
//!
//! All beams of a scan are measured at once, at the robot's pose when the scan is due. Obstacles out of the scanner's
//! range aren't detected.
//!
//! Noise, from data sheets: at "typical" the error of Hokuyo's URG-04LX, 10 mm up to 1 m and 1 % beyond; at "harsh" that of
//! its cheaper twin URG-04LX-UG01, 30 mm and 3 %, while one beam in fifty gets lost, as on dark or shining surfaces (Kneip,
//! Tâche, Caprari & Siegwart 2009, Characterization of the compact Hokuyo URG-04LX 2D laser range scanner, ICRA; how
//! often is ours). Both are taken as one standard deviation.

use super::{Around, BodyFrame, sight};
use crate::{NoiseLevel, RandomStream, STEP_S, noise::Normals};
use rand::Rng as _;
use robovac_core::{math, rng::Rng, robot::Laser};
use std::sync::Arc;

/// One beam in this many is lost.
const LOST: u64 = 50;

/// The scanner of one robot.
#[derive(Debug, Clone)]
pub(super) struct Scanner {
    laser: Laser,
    /// Directions of the beams, (ahead, left).
    directions: Arc<[[f64; 2]]>,
    /// Seconds until the next scan.
    due_s: f64,
    errors: Option<Errors>,
}

/// Errors of distances.
#[derive(Debug, Clone)]
struct Errors {
    rng: Rng,
    normals: Normals,
    /// Standard deviation, m; from 1 m on, per metre.
    deviation: f64,
    loses_beams: bool,
}

impl Scanner {
    pub fn new(laser: Laser, level: NoiseLevel, seed: u64) -> Self {
        let angle = |beam: usize| laser.first + laser.step * beam as f64;
        let directions = (0..laser.beams).map(|beam| [math::cos(angle(beam)), math::sin(angle(beam))]).collect();
        let errors = (level != NoiseLevel::Off).then(|| Errors {
            rng: RandomStream::Laser.seeded(seed),
            normals: Normals::new(),
            deviation: if level == NoiseLevel::Harsh { 0.03 } else { 0.01 },
            loses_beams: level == NoiseLevel::Harsh,
        });
        Self { laser, directions, due_s: 0.0, errors }
    }

    /// A new scan, if one is due.
    pub fn read(&mut self, around: Around<'_>, frame: &BodyFrame) -> Option<Arc<[f32]>> {
        self.due_s -= STEP_S;
        if self.due_s > 0.0 {
            return None;
        }
        self.due_s += 1.0 / self.laser.rate_hz;
        let from = frame.point(self.laser.at);
        let [nearest, farthest] = self.laser.range;
        let errors = &mut self.errors;
        let scan = self.directions.iter().map(|&direction| {
            let hit = sight::look(around, from, frame.direction(direction), farthest);
            let distance = hit.map(|hit| hit.distance).filter(|&d| d >= nearest);
            let measured = distance.and_then(|d| errors.as_mut().map_or(Some(d), |errors| errors.apply(d)));
            measured.map_or(f32::INFINITY, |d| d.clamp(nearest, farthest) as f32)
        });
        Some(scan.collect())
    }
}

impl Errors {
    /// The measured distance; `None` if the beam is lost.
    fn apply(&mut self, distance: f64) -> Option<f64> {
        let bits = self.rng.next_u64();
        let is_lost = self.loses_beams && (bits >> 8).is_multiple_of(LOST);
        let error = self.deviation * distance.max(1.0) * self.normals.of(bits as u8);
        (!is_lost).then_some(distance + error)
    }
}
