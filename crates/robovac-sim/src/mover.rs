//! People and pets that walk back and forth.

use rand::RngExt;
use robovac_core::{
    floor_plan::Who,
    geometry::{Point, Vector},
    rng::Rng,
};

/// Gap between a mover and the robot, m: it never touches the robot by itself.
const GAP: f64 = 0.002;
/// Time after which a mover blocked by the robot turns round, s.
const PATIENCE: f64 = 5.0;
/// Average time that a pet walks before it stops, and longest stop, s (ours).
const PET: (f64, f64) = (4.0, 6.0);

/// A mover on its line.
#[derive(Debug, Clone)]
pub(super) struct Mover {
    who: Who,
    rng: Rng,
    at: Point,
    /// The corner that it walks to, and whether it walks towards the end of the line.
    next: usize,
    is_outward: bool,
    /// Remaining time of a stop, s.
    pause: f64,
    /// Time waited for the robot, s.
    waited: f64,
}

impl Mover {
    /// At the first corner of its line; if a robot of `radius` metres stands at `robot` there, at the next free one, or
    /// else beside the robot.
    pub fn new(who: Who, path: &[Point], rng: Rng, robot: Point, radius: f64) -> Self {
        let clear = radius + who.radius() + 2.0 * GAP;
        let is_free = |p: &Point| (p - robot).norm() > clear;
        let first = path.iter().position(is_free);
        let at = first.map_or(robot + Vector::new(clear + GAP, 0.0), |index| path[index]);
        Self { who, rng, at, next: first.unwrap_or(0), is_outward: true, pause: 0.0, waited: 0.0 }
    }

    /// Where it is, and its radius, m.
    pub fn disc(&self) -> (Point, f64) {
        (self.at, self.who.radius())
    }

    /// Walks for `dt` seconds along `path`; waits if it would touch the robot.
    pub fn step(&mut self, path: &[Point], dt: f64, mut is_taken: impl FnMut(Point, f64) -> bool) {
        if path.len() < 2 {
            return;
        }
        if self.pause > 0.0 {
            self.pause -= dt;
            return;
        }
        if self.who == Who::Pet && self.rng.random_bool(dt / PET.0) {
            self.pause = self.rng.random_range(0.0..PET.1);
            return;
        }
        let Some(&goal) = path.get(self.next) else { return };
        let (way, stride) = (goal - self.at, self.who.speed() * dt);
        let length = way.norm();
        let there = if length <= stride { goal } else { self.at + way * (stride / length) };
        if is_taken(there, self.who.radius() + GAP) {
            self.waited += dt;
            if self.waited > PATIENCE {
                self.turn_round(path);
            }
            return;
        }
        self.waited = 0.0;
        self.at = there;
        if length <= stride {
            let is_end = if self.is_outward { self.next + 1 == path.len() } else { self.next == 0 };
            if is_end {
                self.is_outward = !self.is_outward;
            }
            self.next = if self.is_outward { self.next + 1 } else { self.next - 1 };
        }
    }

    fn turn_round(&mut self, path: &[Point]) {
        self.waited = 0.0;
        self.is_outward = !self.is_outward;
        self.next = if self.is_outward { (self.next + 1).min(path.len() - 1) } else { self.next.saturating_sub(1) };
    }
}
