//! Exploring behaviours: they drive so that the room can be mapped with a bumper and a light bumper of short range.
//!
//! The first six are the phases of the exploration strategy of Krapinec 2025 (004, chapter 7), from random motion to
//! edge following; [`options`] (phases 1 to 4) and [`obstacles`] (definition of obstacles) are shared. The thesis
//! prints code for the last phase only and describes the others in a paragraph each.
//!
//! The seventh, [`frontier`], makes a map as it goes and drives by it: [`chart`] finds reachable floor and goals,
//! [`trace`] records followed walls, [`AttemptBudget`](super::parts::AttemptBudget) limits attempts.

mod chart;
pub(super) mod edge;
mod edge_machine;
pub(super) mod forward_rotate;
pub(super) mod frontier;
mod goals;
pub(super) mod left_right;
pub(super) mod look_ahead;
pub(super) mod look_around;
mod obstacles;
mod options;
mod position;
mod trace;
pub(super) mod until_obstacle;

#[cfg(test)]
mod edge_rules;
#[cfg(test)]
mod kidnapped;

use super::parts::{Move, Obstruction, Pilot};
use rand::RngExt;

/// Address of the thesis.
const THESIS: &str = "https://urn.nsk.hr/urn:nbn:hr:168:101738";
/// Way back from the edge of the floor, m, over known ground: safer for random turns (ours).
const BACK_FROM_EDGE: f64 = 0.15;
/// Turn away from the edge of the floor or from a virtual wall, rad, drawn from this range (ours).
const LEAVE: (f64, f64) = (1.6, 2.6);

/// Reaction of all phases to edges and virtual walls, which aren't in the thesis.
fn turn_back(pilot: &mut Pilot, obstruction: Obstruction) {
    let side = pilot.away_from(obstruction);
    let turn = leave(pilot, side);
    pilot.answer(obstruction, BACK_FROM_EDGE, &[turn]);
}

/// A turn away, to the left for a `side` of 1 and to the right for -1.
fn leave(pilot: &mut Pilot, side: f64) -> Move {
    Move::Turn(side * pilot.rng.random_range(LEAVE.0..LEAVE.1))
}
