//! Executes motions for behaviours: drives a distance, turns by an angle, backs off over known ground, and reports
//! obstructions.

use super::{
    braking::{off_edge, safe_speed},
    obstruction::{Obstruction, ObstructionKind, ObstructionSide},
    trail::WheelTrail,
    travel::EncoderTravel,
    voids::Voids,
};
use crate::controller::Setup;
use rand::RngExt;
use robovac_core::{
    math,
    rng::{Rng, seeded},
    robot::{Drive, RobotModel, SensorReadings},
};
use std::collections::VecDeque;

/// Stream of the behaviours' random numbers.
const STREAM: u64 = 3;
/// Reversing is this share of the forward speed: nothing looks back.
const REVERSE: f64 = 0.6;
/// Wheel travel that may be left when a distance or angle counts as done, m.
const CLOSE_ENOUGH: f64 = 0.001;
/// Slowest wheel speed of a motion that isn't done, m/s: slower, and quantised wheels would stand.
const LEAST_SPEED: f64 = 0.025;
/// Way back after the beam of a virtual wall is no longer seen, m.
const OFF_BEAM: f64 = 0.05;
/// Time without a sight of the beam after which the robot is out of it, s.
const BEAM_GONE_S: f64 = 0.3;
/// Way back before a turn is tried again that would have got a wheel over an edge, m.
const OFF_TURN: f64 = 0.04;
/// Turns that are undone before one is made all the same.
const MOST_UNDONE: u32 = 5;
/// Way between two hits below which the robot has got nowhere, and goes on turning the way it has begun, m.
const NOWHERE: f64 = 0.03;

/// How distances and angles are told.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::controller) enum By {
    /// By the encoders' counts.
    Counts,
    /// By the clock: wheel travel divided by wheel speed, as robots without encoders do.
    Time,
}

/// A motion from rest to rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::controller) enum Move {
    /// So far backward, m, but never farther than over ground that was driven just before.
    Back(f64),
    /// Backward until the beam of a virtual wall is no longer seen.
    BackOutOfBeam,
    /// So far ahead, m.
    Ahead(f64),
    /// On the spot, rad, counter-clockwise positive.
    Turn(f64),
    /// Back from a turn that would have got a wheel over an edge.
    Undo(f64),
}

/// Where a motion stands.
#[derive(Debug, Clone, Copy, PartialEq)]
enum MotionPhase {
    /// Waits until the wheels stand still.
    Settle,
    /// Under way since the wheels had rolled this far (ahead, m; turned, rad), for so long, s.
    Under { ahead: f64, turned: f64, clock: f64 },
}

/// Drives one robot.
#[derive(Debug, Clone)]
pub(in crate::controller) struct Pilot {
    /// The robot.
    pub robot: RobotModel,
    /// Random numbers of whatever behaves.
    pub rng: Rng,
    /// Wheel speed ahead, m/s: cruise speed, or less where the cliff sensors sit too near the wheels for it.
    pub speed: f64,
    /// Wheel speed of turns on the spot, m/s.
    pub turn_speed: f64,
    /// How motions are told.
    pub by: By,
    /// Way back from an edge, beside the braking distance, m.
    off_edge: f64,
    travel: EncoderTravel,
    trail: WheelTrail,
    voids: Voids,
    /// Whether it was told to go back along the trail.
    is_retreating: bool,
    /// How many turns of the motions under way were undone.
    undone: u32,
    moves: VecDeque<Move>,
    phase: MotionPhase,
    /// What the motions answer, which need not be answered again.
    answering: Option<ObstructionKind>,
    /// Whether the robot is on its way out of the beam of a virtual wall, and for how long it hasn't seen it, s.
    leaving_beam: bool,
    beam_unseen: f64,
    /// Where the last answer ended, m ahead, and the way it turned.
    last: (f64, f64),
    /// Where the last hit was, m ahead.
    hit_at: f64,
}

impl Pilot {
    pub(in crate::controller) fn new(setup: &Setup<'_>) -> Self {
        let robot = setup.robot.clone();
        let speed = safe_speed(&robot);
        Self {
            rng: seeded(setup.seed, STREAM),
            speed,
            turn_speed: robot.turn_wheel_speed,
            by: By::Counts,
            off_edge: off_edge(&robot),
            travel: EncoderTravel::new(&robot),
            trail: WheelTrail::default(),
            voids: Voids::new(&robot),
            is_retreating: false,
            undone: 0,
            moves: VecDeque::new(),
            phase: MotionPhase::Settle,
            answering: None,
            leaving_beam: false,
            beam_unseen: 0.0,
            last: (f64::NEG_INFINITY, 1.0),
            hit_at: 0.0,
            robot,
        }
    }

    /// Takes the next reading.
    pub(super) fn sense(&mut self, sensed: &SensorReadings, dt_s: f64) {
        let rolled = self.travel.update(sensed);
        self.voids.update(sensed, &self.robot.sensors.cliffs);
        // Whether the trail is to outlast what the wheels do: turns are undone where an edge comes too near.
        let is_backing = self.is_retreating || self.moves.front().is_some_and(|step| !matches!(step, Move::Ahead(_)));
        self.trail.roll(rolled, sensed.bumped(), is_backing);
        self.is_retreating = false;
        self.beam_unseen = if sensed.virtual_wall { 0.0 } else { self.beam_unseen + dt_s };
        self.leaving_beam &= self.beam_unseen < BEAM_GONE_S;
    }

    /// Forgets what it was at and what it knows: the robot was kidnapped.
    pub(super) fn reset(&mut self) {
        self.moves.clear();
        self.trail.clear();
        self.voids.clear();
        self.phase = MotionPhase::Settle;
        self.answering = None;
        self.leaving_beam = false;
    }

    /// What is in the way, unless the robot isn't going ahead or is already answering it.
    pub(super) fn obstruction(&mut self, sensed: &SensorReadings) -> Option<Obstruction> {
        let is_rolling = self.phase == MotionPhase::Settle && !self.travel.is_resting();
        let goes_ahead = match (self.moves.front(), self.answering) {
            (None, _) => self.phase == MotionPhase::Settle,
            (Some(Move::Ahead(_)), _) => true,
            (Some(_), None) => is_rolling,
            // Braking before a wall, it may slide along it to an edge.
            (Some(_), Some(ObstructionKind::Bump | ObstructionKind::Beam)) => is_rolling && sensed.sees_cliff(),
            (Some(_), Some(ObstructionKind::Cliff)) => false,
        };
        if !goes_ahead {
            return None;
        }
        let edge = self.voids.ahead().map(|side| Obstruction { kind: ObstructionKind::Cliff, side });
        let obstruction = Obstruction::of(sensed, !self.leaving_beam).or(edge)?;
        self.hit_at = self.travel.ahead();
        Some(obstruction)
    }

    /// Replaces what is under way by `moves`.
    pub(in crate::controller) fn go(&mut self, moves: &[Move]) {
        self.moves.clear();
        self.moves.extend(moves);
        self.phase = MotionPhase::Settle;
        self.undone = 0;
        self.answering = None;
    }

    /// Answers a hit: back by at least `back` metres and farther if need be, then `moves`.
    pub(in crate::controller) fn answer(&mut self, obstruction: Obstruction, back: f64, moves: &[Move]) {
        self.go(moves);
        self.answering = Some(obstruction.kind);
        match obstruction.kind {
            ObstructionKind::Bump if back <= 0.0 => {}
            ObstructionKind::Bump => self.moves.push_front(Move::Back(back)),
            ObstructionKind::Cliff => self.moves.push_front(Move::Back(back.max(self.off_edge))),
            ObstructionKind::Beam => {
                self.leaving_beam = true;
                self.moves.push_front(Move::BackOutOfBeam);
            }
        }
    }

    /// The way to turn away from a hit, 1 for left and -1 for right: to the other side; by chance if it is straight ahead.
    ///
    /// A robot that got nowhere since the last hit goes on turning the same way, or it would swing to and fro before an
    /// edge that it sees on both sides.
    pub(in crate::controller) fn away_from(&mut self, obstruction: Obstruction) -> f64 {
        let chance = if self.rng.random_bool(0.5) { 1.0 } else { -1.0 };
        let way = match obstruction.side {
            _ if (self.travel.ahead() - self.last.0).abs() < NOWHERE => self.last.1,
            ObstructionSide::Left => -1.0,
            ObstructionSide::Right => 1.0,
            ObstructionSide::Front => chance,
        };
        self.last.1 = way;
        way
    }

    /// Whether motions are under way.
    pub(in crate::controller) fn is_busy(&self) -> bool {
        !self.moves.is_empty()
    }

    /// Way ahead less way back since the start, m.
    pub(in crate::controller) fn ahead(&self) -> f64 {
        self.travel.ahead()
    }

    /// Sum of all turning since the start, counter-clockwise positive, rad.
    pub(in crate::controller) fn turned(&self) -> f64 {
        self.travel.turned()
    }

    /// Speed and turn rate (rad/s, counter-clockwise positive) as wheel speeds of this robot.
    pub(in crate::controller) fn twist(&self, speed: f64, turn_rate: f64) -> Drive {
        Drive::from_twist(speed, turn_rate, self.robot.wheel_base)
    }

    /// Straight ahead.
    pub(in crate::controller) fn straight(&self) -> Drive {
        Drive::wheels(self.speed, self.speed)
    }

    /// Whether it knows the ground behind it.
    pub(in crate::controller) fn knows_way_back(&self) -> bool {
        self.trail.length() > CLOSE_ENOUGH
    }

    /// How much of the ground behind it it knows, m.
    pub(in crate::controller) fn way_back(&self) -> f64 {
        self.trail.length()
    }

    /// Takes so many metres straight behind it for known ground.
    pub(in crate::controller) fn assume_way_back(&mut self, metres: f64) {
        self.trail.assume(metres);
    }

    /// Back the way it came, at a share of the speed for that; stops where that ends.
    pub(in crate::controller) fn retreat(&mut self, share: f64) -> Drive {
        self.is_retreating = true;
        let Some(way) = self.trail.back() else { return Drive::STOP };
        let speed = (REVERSE * self.speed).min((2.0 * self.robot.acceleration * self.trail.length()).sqrt());
        Drive::wheels(way[0], way[1]).times(share * speed.max(LEAST_SPEED))
    }

    /// Goes on with what is under way; `None` if nothing is.
    pub(super) fn perform(&mut self, sensed: &SensorReadings, dt_s: f64) -> Option<Drive> {
        loop {
            let Some(&step) = self.moves.front() else {
                if self.phase == MotionPhase::Settle {
                    return None;
                }
                if !self.travel.is_resting() {
                    return Some(Drive::STOP);
                }
                self.phase = MotionPhase::Settle;
                self.answering = None;
                self.last.0 = self.travel.ahead();
                return None;
            };
            if self.phase == MotionPhase::Settle {
                if !self.travel.is_resting() {
                    return Some(Drive::STOP);
                }
                self.phase = MotionPhase::Under { ahead: self.begin(step), turned: self.travel.turned(), clock: 0.0 };
            }
            let MotionPhase::Under { ahead, turned, clock } = self.phase else { return Some(Drive::STOP) };
            self.phase = MotionPhase::Under { ahead, turned, clock: clock + dt_s };
            let drive = match step {
                Move::Back(distance) => self.back(distance - (ahead - self.travel.ahead()), distance, (clock, dt_s)),
                Move::BackOutOfBeam => self.back_out(sensed),
                Move::Ahead(distance) => {
                    let left = distance - (self.travel.ahead() - ahead);
                    match self.pace(left, distance, self.speed, (clock, dt_s)) {
                        Some(v) => Some(Drive::wheels(v, v)),
                        // As long as it rolls ahead, it must look ahead.
                        None => (!self.travel.is_resting()).then_some(Drive::STOP),
                    }
                }
                Move::Turn(angle)
                    if self.undone < MOST_UNDONE && self.voids.are_near() && self.trail.length() > NOWHERE =>
                {
                    self.undone += 1;
                    let turned = self.travel.turned() - turned;
                    self.moves.pop_front();
                    for step in [Move::Turn(angle), Move::Back(OFF_TURN), Move::Undo(-turned)] {
                        self.moves.push_front(step);
                    }
                    self.phase = MotionPhase::Settle;
                    continue;
                }
                Move::Turn(angle) | Move::Undo(angle) => {
                    let half = 0.5 * self.robot.wheel_base * angle.signum();
                    let left = (angle - (self.travel.turned() - turned)) * half;
                    let speed = self.pace(left, angle * half, self.turn_speed, (clock, dt_s));
                    speed.map(|v| Drive::wheels(-v * angle.signum(), v * angle.signum()))
                }
            };
            if drive.is_some() {
                return drive;
            }
            self.moves.pop_front();
            if !self.moves.is_empty() {
                self.phase = MotionPhase::Settle;
            }
        }
    }

    /// Where a motion counts from, m ahead: for the way back from an edge, where it was first seen.
    fn begin(&self, step: Move) -> f64 {
        match step {
            Move::Back(way) if self.answering == Some(ObstructionKind::Cliff) && way > OFF_TURN => self.hit_at,
            _ => self.travel.ahead(),
        }
    }

    /// Speed with `left` metres of wheel travel to go of `all`, so as to come to rest there; `None` if it is time to stop.
    ///
    /// By the clock, a motion of d metres at v lasts d / v: the wheels then roll on as far as they fell short while they
    /// picked up speed. A motion too short to reach v lasts sqrt(d / a) instead, for the same reason.
    fn pace(&self, left: f64, all: f64, speed: f64, (clock, dt_s): (f64, f64)) -> Option<f64> {
        let a = self.robot.acceleration;
        match self.by {
            By::Time => {
                let lasts = (all / speed).max((all / a).sqrt());
                // Commands last for whole steps; what is too much in time is taken off the speed.
                let steps = (lasts / dt_s).ceil();
                (clock + 0.5 * dt_s < steps * dt_s).then_some(speed * lasts / (steps * dt_s))
            }
            By::Counts if left < CLOSE_ENOUGH || clock > 3.0 + 4.0 * all / speed => None,
            By::Counts => Some(speed.min((2.0 * a * left).sqrt()).max(LEAST_SPEED)),
        }
    }

    fn back(&mut self, left: f64, all: f64, (clock, dt_s): (f64, f64)) -> Option<Drive> {
        let way = self.trail.back()?;
        let known = self.trail.length();
        let speed = match self.by {
            // An edge is no matter of the clock: it wants to be left behind by the way that was driven towards it.
            By::Time if self.answering != Some(ObstructionKind::Cliff) => {
                self.pace(left, all, self.speed, (clock, dt_s))?
            }
            _ if left.min(known) < CLOSE_ENOUGH || clock > 3.0 + 4.0 * all / self.speed => return None,
            _ => (REVERSE * self.speed).min((2.0 * self.robot.acceleration * left).sqrt()),
        };
        let speed = speed.min((2.0 * self.robot.acceleration * known).sqrt()).max(LEAST_SPEED);
        Some(Drive::wheels(way[0] * speed, way[1] * speed))
    }

    fn back_out(&mut self, sensed: &SensorReadings) -> Option<Drive> {
        let is_out = !sensed.virtual_wall && self.beam_unseen > OFF_BEAM / self.speed;
        let speed = REVERSE * self.speed;
        match self.trail.back() {
            Some(way) if !is_out => Some(Drive::wheels(way[0] * speed, way[1] * speed)),
            Some(_) => None,
            None => {
                if !is_out {
                    // Still in it where the way back ends: turn round and go, wherever that leads.
                    let turn = math::PI * self.rng.random_range(0.8..1.2);
                    self.moves.clear();
                    self.moves.extend([Move::BackOutOfBeam, Move::Turn(turn)]);
                }
                None
            }
        }
    }

    /// What it is doing; empty if nothing is under way.
    pub(super) fn activity(&self) -> &'static str {
        match self.moves.front() {
            None => "",
            Some(Move::Back(_) | Move::BackOutOfBeam) => "backing up",
            Some(Move::Ahead(_)) => "driving a short distance",
            Some(Move::Turn(angle) | Move::Undo(angle)) if *angle > 0.0 => "turning left",
            Some(Move::Turn(_) | Move::Undo(_)) => "turning right",
        }
    }
}
