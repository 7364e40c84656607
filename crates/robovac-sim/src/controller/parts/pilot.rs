//! Executes motions for behaviours: drives a distance, turns by an angle, backs off over known ground, and reports
//! obstructions.

use super::{
    braking::{off_edge, safe_speed},
    obstruction::{Obstruction, ObstructionKind, ObstructionSide},
    trail::WheelTrail,
    travel::EncoderTravel,
    voids::Voids,
};
use crate::{RandomStream, controller::Setup};
use rand::RngExt;
use robovac_core::{
    math,
    rng::Rng,
    robot::{Body, Drive, RobotModel, SensorReadings},
};
use std::collections::VecDeque;

/// Speed of reversing as a share of the forward speed, as there are no rear sensors.
const REVERSE: f64 = 0.6;
/// Remaining wheel travel at which a distance or angle counts as done, m.
const CLOSE_ENOUGH: f64 = 0.001;
/// Slowest wheel speed of a motion, m/s; quantised wheels would stop below it.
const LEAST_SPEED: f64 = 0.025;
/// Way back after leaving the beam of a virtual wall, m.
const OFF_BEAM: f64 = 0.05;
/// Time without the beam after which the robot is out of it, s.
const BEAM_GONE_S: f64 = 0.3;
/// Way back before repeating a turn that would have brought a wheel over an edge, m.
const OFF_TURN: f64 = 0.04;
/// Undone turns after which one is made regardless.
const MOST_UNDONE: u32 = 5;
/// Least distance between two hits that counts as progress; below it the robot keeps turning the same way, m.
const NOWHERE: f64 = 0.03;
/// Time for which the bumper is pressed on the side to which a body with corners turns until it counts as wedged, s, and until
/// it is known how far it can turn the other way.
const WEDGED_S: f64 = 0.5;
const PRESSED_S: f64 = 0.2;
/// Way back out of where it was wedged, m, the least turn there, and the turn the other way after which it wasn't, rad.
const OFF_WEDGE: f64 = 0.3;
const WEDGE_TURN: f64 = 1.2;
const FREE_TURN: f64 = 2.6;

/// How distances and angles are measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::controller) enum By {
    /// By the encoders' counts.
    Counts,
    /// By time: wheel travel divided by wheel speed, as robots without encoders do.
    Time,
}

/// A motion from rest to rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::controller) enum Move {
    /// Backward by a distance, m, but only over ground just driven.
    Back(f64),
    /// Backward until the beam of a virtual wall is no longer seen.
    BackOutOfBeam,
    /// Ahead by a distance, m.
    Ahead(f64),
    /// On the spot, rad, counter-clockwise positive.
    Turn(f64),
    /// Back from a turn that would have brought a wheel over an edge.
    Undo(f64),
    /// On the spot, rad, until something presses the bumper, and half of it back.
    Swing(f64),
    /// Straight back by a distance, m, from where a body with corners can't turn: it can only have come from behind.
    BackOut(f64),
    /// These wheel speeds for so long, s, without waiting for rest before or after: motors that are switched, whatever
    /// comes of it.
    Timed(Drive, f64),
}

impl Move {
    /// Whether it leads ahead.
    fn is_ahead(self) -> bool {
        match self {
            Self::Ahead(_) => true,
            Self::Timed(drive, _) => drive.left > 0.0 && drive.right > 0.0,
            _ => false,
        }
    }
}

/// Phase of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
enum MotionPhase {
    /// Waits until the wheels stand still.
    Settle,
    /// In progress since these values of distance (m) and turn (rad), for so long, s.
    Under { ahead: f64, turned: f64, clock: f64 },
}

/// Drives one robot.
#[derive(Debug, Clone)]
pub(in crate::controller) struct Pilot {
    /// The robot.
    pub robot: RobotModel,
    /// Random numbers of the behaviour.
    pub rng: Rng,
    /// Wheel speed ahead, m/s: cruise speed, or less where the cliff sensors sit too near the wheels for it.
    pub speed: f64,
    /// Wheel speed of turns on the spot, m/s.
    pub turn_speed: f64,
    /// How motions are measured.
    pub by: By,
    /// Way back from an edge, in addition to the braking distance, m.
    off_edge: f64,
    travel: EncoderTravel,
    trail: WheelTrail,
    voids: Voids,
    /// For how long the bumper has been pressed on the side to which it turns, s, and the turn at which that began, rad.
    pressed: (f64, f64),
    /// Whether it reverses along the trail.
    is_retreating: bool,
    /// Number of undone turns in the present motions.
    undone: u32,
    moves: VecDeque<Move>,
    phase: MotionPhase,
    /// The obstruction to which the present motions react.
    answering: Option<ObstructionKind>,
    /// Whether the robot is leaving the beam of a virtual wall, and the time without the beam, s.
    leaving_beam: bool,
    beam_unseen: f64,
    /// End of the last reaction, m ahead, and its direction of turn.
    last: (f64, f64),
    /// Position of the last hit, m ahead.
    hit_at: f64,
}

impl Pilot {
    pub(in crate::controller) fn new(setup: &Setup<'_>) -> Self {
        let robot = setup.robot.clone();
        let speed = safe_speed(&robot);
        Self {
            rng: RandomStream::Behaviour.seeded(setup.seed),
            speed,
            turn_speed: robot.turn_wheel_speed,
            by: By::Counts,
            off_edge: off_edge(&robot),
            travel: EncoderTravel::new(&robot),
            trail: WheelTrail::default(),
            voids: Voids::new(&robot),
            pressed: (0.0, 0.0),
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
        // Whether to keep the trail regardless of the wheels: turns are undone near edges.
        let is_backing = self.is_retreating || self.moves.front().is_some_and(|step| !step.is_ahead());
        self.trail.roll(rolled, sensed.bumped(), is_backing);
        self.is_retreating = false;
        self.pressed =
            if self.presses(sensed) { (self.pressed.0 + dt_s, self.pressed.1) } else { (0.0, self.travel.turned()) };
        self.beam_unseen = if sensed.virtual_wall { 0.0 } else { self.beam_unseen + dt_s };
        self.leaving_beam &= self.beam_unseen < BEAM_GONE_S;
    }

    /// Whether it turns a body with corners towards what presses the bumper.
    fn presses(&self, sensed: &SensorReadings) -> bool {
        let Some(Move::Turn(angle) | Move::Swing(angle)) = self.moves.front() else { return false };
        let is_towards = if *angle > 0.0 { sensed.bump_left } else { sensed.bump_right };
        is_towards && self.robot.body != Body::Round && self.phase != MotionPhase::Settle
    }

    /// Resets all motions and knowledge: the robot was kidnapped.
    pub(super) fn reset(&mut self) {
        self.moves.clear();
        self.trail.clear();
        self.voids.clear();
        self.phase = MotionPhase::Settle;
        self.answering = None;
        self.leaving_beam = false;
    }

    /// The obstruction in a reading, unless the robot isn't driving ahead or is already reacting to it.
    pub(super) fn obstruction(&mut self, sensed: &SensorReadings) -> Option<Obstruction> {
        let is_rolling = self.phase == MotionPhase::Settle && !self.travel.is_resting();
        let goes_ahead = match (self.moves.front(), self.answering) {
            (None, _) => self.phase == MotionPhase::Settle,
            (Some(step), _) if step.is_ahead() => true,
            // The wheels may still roll ahead.
            (Some(Move::Timed(..)), _) => sensed.sees_cliff(),
            (Some(_), None) => is_rolling,
            // Braking before a wall, it can slide along it to an edge.
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

    /// Replaces the present motions by `moves`.
    pub(in crate::controller) fn go(&mut self, moves: &[Move]) {
        self.moves.clear();
        self.moves.extend(moves);
        self.phase = MotionPhase::Settle;
        self.undone = 0;
        self.answering = None;
    }

    /// Reacts to a bump with timed motions; to all else like [`Pilot::answer`] with `back` and `moves`.
    pub(in crate::controller) fn answer_timed(
        &mut self,
        obstruction: Obstruction,
        timed: &[Move],
        back: f64,
        moves: &[Move],
    ) {
        if obstruction.kind != ObstructionKind::Bump {
            return self.answer(obstruction, back, moves);
        }
        self.go(timed);
        self.answering = Some(obstruction.kind);
    }

    /// Reacts to a hit: back by at least `back` metres, then `moves`.
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

    /// The direction to turn away from a hit, 1 for left and -1 for right: to the other side; random if it is straight
    /// ahead.
    ///
    /// Without progress since the last hit it keeps the direction; otherwise the robot would oscillate before an edge
    /// that it detects on both sides.
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

    /// Whether there are motions in progress.
    pub(in crate::controller) fn is_busy(&self) -> bool {
        !self.moves.is_empty()
    }

    /// Distance ahead less distance back since the start, m.
    pub(in crate::controller) fn ahead(&self) -> f64 {
        self.travel.ahead()
    }

    /// Sum of all turning since the start, counter-clockwise positive, rad.
    pub(in crate::controller) fn turned(&self) -> f64 {
        self.travel.turned()
    }

    /// Wheel speeds of this robot for a speed and turn rate (rad/s, counter-clockwise positive).
    pub(in crate::controller) fn twist(&self, speed: f64, turn_rate: f64) -> Drive {
        Drive::from_twist(speed, turn_rate, self.robot.wheel_base)
    }

    /// Straight ahead.
    pub(in crate::controller) fn straight(&self) -> Drive {
        Drive::wheels(self.speed, self.speed)
    }

    /// Whether the ground behind is known.
    pub(in crate::controller) fn knows_way_back(&self) -> bool {
        self.trail.length() > CLOSE_ENOUGH
    }

    /// Length of the known ground behind, m.
    pub(in crate::controller) fn way_back(&self) -> f64 {
        self.trail.length()
    }

    /// Sets the known ground straight behind, m.
    pub(in crate::controller) fn assume_way_back(&mut self, metres: f64) {
        self.trail.assume(metres);
    }

    /// Reverses over the way it came, at a share of the reversing speed; stops at its end.
    pub(in crate::controller) fn retreat(&mut self, share: f64) -> Drive {
        self.is_retreating = true;
        let Some(way) = self.trail.back() else { return Drive::STOP };
        let speed = (REVERSE * self.speed).min((2.0 * self.robot.acceleration * self.trail.length()).sqrt());
        Drive::wheels(way[0], way[1]).times(share * speed.max(LEAST_SPEED))
    }

    /// Continues the present motions; `None` if there are none.
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
            if let Move::Timed(drive, seconds) = step {
                let clock = if let MotionPhase::Under { clock, .. } = self.phase { clock } else { 0.0 };
                if clock + 0.5 * dt_s < seconds {
                    let (ahead, turned) = (self.travel.ahead(), self.travel.turned());
                    self.phase = MotionPhase::Under { ahead, turned, clock: clock + dt_s };
                    return Some(drive);
                }
                self.moves.pop_front();
                self.phase = MotionPhase::Settle;
                continue;
            }
            if self.phase == MotionPhase::Settle {
                if !self.travel.is_resting() {
                    return Some(Drive::STOP);
                }
                self.phase = MotionPhase::Under { ahead: self.begin(step), turned: self.travel.turned(), clock: 0.0 };
                if let Move::BackOut(distance) = step {
                    self.trail.assume(distance);
                }
            }
            let MotionPhase::Under { ahead, turned, clock } = self.phase else { return Some(Drive::STOP) };
            self.phase = MotionPhase::Under { ahead, turned, clock: clock + dt_s };
            let drive = match step {
                Move::Timed(drive, _) => Some(drive),
                Move::Back(distance) | Move::BackOut(distance) => {
                    self.back(distance - (ahead - self.travel.ahead()), distance, (clock, dt_s))
                }
                Move::BackOutOfBeam => self.back_out(sensed),
                Move::Ahead(distance) => {
                    let left = distance - (self.travel.ahead() - ahead);
                    match self.pace(left, distance, self.speed, (clock, dt_s)) {
                        Some(v) => Some(Drive::wheels(v, v)),
                        // While it rolls ahead, it must look ahead.
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
                Move::Turn(angle) if self.pressed.0 > WEDGED_S => {
                    self.phase = MotionPhase::Settle;
                    self.moves[0] = Move::Turn(angle.signum() * angle.abs().max(WEDGE_TURN));
                    self.moves.push_front(Move::BackOut(OFF_WEDGE));
                    self.moves.push_front(Move::Swing(-angle.signum() * FREE_TURN));
                    continue;
                }
                Move::Swing(_) if self.pressed.0 > PRESSED_S => {
                    self.phase = MotionPhase::Settle;
                    self.moves[0] = Move::Undo(0.5 * (turned - self.pressed.1));
                    continue;
                }
                Move::Turn(angle) | Move::Undo(angle) | Move::Swing(angle) => {
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
            if matches!(step, Move::Swing(_)) {
                // There is room enough to turn.
                self.moves.clear();
            }
            if !self.moves.is_empty() {
                self.phase = MotionPhase::Settle;
            }
        }
    }

    /// Start of a motion, m ahead: for the way back from an edge, the place of its first detection.
    fn begin(&self, step: Move) -> f64 {
        match step {
            Move::Back(way) if self.answering == Some(ObstructionKind::Cliff) && way > OFF_TURN => self.hit_at,
            _ => self.travel.ahead(),
        }
    }

    /// Speed with `left` of `all` metres of wheel travel to go, so as to stop at the end; `None` if it is time to stop.
    ///
    /// By the clock, a motion of d metres at v lasts d / v: the wheels then roll on as far as they fell short while they
    /// picked up speed. A motion too short to reach v lasts sqrt(d / a) instead, for the same reason.
    fn pace(&self, left: f64, all: f64, speed: f64, (clock, dt_s): (f64, f64)) -> Option<f64> {
        let a = self.robot.acceleration;
        match self.by {
            By::Time => {
                let lasts = (all / speed).max((all / a).sqrt());
                // Commands last for whole steps; the excess time is compensated by the speed.
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
            // Leaving an edge isn't timed but measured by the distance driven towards it.
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
                    // Still in the beam at the end of the known ground: turns round and drives on.
                    let turn = math::PI * self.rng.random_range(0.8..1.2);
                    self.moves.clear();
                    self.moves.extend([Move::BackOutOfBeam, Move::Turn(turn)]);
                }
                None
            }
        }
    }

    /// Its activity; empty if there are no motions.
    pub(super) fn activity(&self) -> &'static str {
        match self.moves.front() {
            None => "",
            Some(Move::Back(_) | Move::BackOut(_) | Move::BackOutOfBeam) => "backing up",
            Some(step) if step.is_ahead() => "driving a short distance",
            Some(Move::Timed(drive, _)) if drive.left < 0.0 && drive.right < 0.0 => "backing up",
            Some(Move::Turn(angle) | Move::Undo(angle) | Move::Swing(angle)) if *angle > 0.0 => "turning left",
            Some(Move::Timed(drive, _)) if drive.right > 0.0 => "turning left",
            Some(_) => "turning right",
        }
    }
}
