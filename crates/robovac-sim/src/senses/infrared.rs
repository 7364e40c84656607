//! Infrared receivers: the beams of docks and virtual walls.
//!
//! A dock sends a green and a red beam, each 30 of 50 degrees wide, which overlap in the middle, and a force field of 2
//! feet around it, as in iRobot's own simulation of the Create 3 (`create3_sim`, `gazebo_ros_ir_opcode.hpp`: docking
//! buoys of 50 degrees of which either takes 0.6, halo of 0.6096 m). Seen by a robot that faces the dock, the green beam is on
//! its left and the red one on its right (Open Interface specification). There the beams end at 1.5 m; here they reach
//! 2.5 m, which is ours: docks are found from across a room. Walls and movers stop them.
//!
//! The receiver all around is 153 mm ahead of the Roomba's middle (Create 3's place, at the front edge), and so are the
//! two front receivers, which look 35 degrees to their side and see 45 degrees to either side of that (ours).
//!
//! A virtual wall's beam widens by 5 degrees to either side of its line, and a halo of 0.4 m keeps robots from pushing
//! the lighthouse away (owners report that there is one; the figures are ours).
//!
//! Noise: at "typical" a receiver misses one character in twenty, at "harsh", in sunlight, every third (ours).

use super::{Around, BodyFrame, Noisy, sight};
use crate::{SensorKind, World};
use robovac_core::{
    coverage::{DOCK_BACK, FENCE, HALO},
    geometry::{Point, Pose, Vector},
    robot::{Infrared, RobotModel, SensorReadings},
};

/// Place of the receivers ahead of the origin, as a share of the body's radius.
const RECEIVERS: f64 = 0.878;
/// Direction of the left front receiver, (ahead, left): cosine and sine of 35 degrees.
const LOOKS: [f64; 2] = [0.819_152_044_288_992, 0.573_576_436_351_046];
/// Cosine of half the field of view of a front receiver.
const FIELD: f64 = core::f64::consts::FRAC_1_SQRT_2;
/// Length of a dock's beams, m.
const BEAMS: f64 = 2.5;
/// Tangents of the angles at which a beam ends, on its own side of the middle and on the other: 25 and 5 degrees.
const BEAM: (f64, f64) = (0.466_307_658_154_999, 0.087_488_663_525_924);
/// Radius of a dock's force field, m.
const FORCE_FIELD: f64 = 0.6096;
/// Depth in a wall at which emitters still work, m.
const SLACK: f64 = 0.05;
/// Character of a virtual wall.
const VIRTUAL_WALL: u8 = 162;
/// Characters of a dock are sums of these: all, force field, green and red beam.
const DOCK: [u8; 4] = [160, 1, 4, 8];
/// Largest distance of the robot's front from the dock's solid back while charging, m, largest offset from the dock's
/// middle, m, and sine of the largest angle. The dock's contacts are strips that meet those of the robot, 47 mm behind
/// its front and 44 mm to either side (Open Interface facts, section 6); their size is ours.
const CONTACT: (f64, f64, f64) = (0.015, 0.025, 0.15);

/// Whether the robot is on a dock with its contacts touching.
pub(super) fn is_docked(model: &RobotModel, world: &World, frame: &BodyFrame) -> bool {
    let is_on = |dock: &Pose| {
        let way = frame.position - dock.position();
        let touching = model.radius + DOCK_BACK[1];
        let reach = touching + CONTACT.0 + CONTACT.1;
        if way.norm_squared() > reach * reach {
            return false;
        }
        let looks = dock.direction();
        (looks.dot(&way) - touching).abs() < CONTACT.0
            && looks.perp(&way).abs() < CONTACT.1
            && looks.dot(&frame.ahead) < 0.0
            && looks.perp(&frame.ahead).abs() < CONTACT.2
    };
    model.battery.charge_ma > 0.0 && world.docks.iter().any(is_on)
}

/// Reads the three receivers.
pub(super) fn read(
    model: &RobotModel,
    around: Around<'_>,
    frame: &BodyFrame,
    noise: &Noisy<'_>,
    sensors: &mut SensorReadings,
) {
    sensors.infrared = Infrared::default();
    sensors.virtual_wall = false;
    let World { docks, virtual_walls, .. } = around.world;
    if docks.is_empty() && virtual_walls.is_empty() {
        return;
    }
    let receiver = frame.point([RECEIVERS * model.radius, 0.0]);
    let missed = noise.pick(SensorKind::Infrared, [0.0, 0.05, 0.33]);
    let misses = |index: usize| noise.happens(SensorKind::Infrared, index, missed);
    let is_fenced = |(pose, length): &(Pose, f64)| is_in_fence(around, receiver, *pose, *length);
    sensors.virtual_wall = virtual_walls.iter().any(is_fenced) && !misses(0);
    if sensors.virtual_wall {
        sensors.infrared.omni = VIRTUAL_WALL;
    }
    let (mut omni, mut left, mut right) = (0, 0, 0);
    for dock in docks {
        let character = character(around, receiver, *dock);
        if character == 0 {
            continue;
        }
        let way = dock.position() - receiver;
        let sees = |side: f64| way.dot(&frame.direction([LOOKS[0], side * LOOKS[1]])) >= FIELD * way.norm();
        omni |= character;
        left |= if sees(1.0) { character } else { 0 };
        right |= if sees(-1.0) { character } else { 0 };
    }
    if omni != 0 && !misses(0) {
        sensors.infrared.omni = omni;
    }
    if !misses(1) {
        (sensors.infrared.left, sensors.infrared.right) = (left, right);
    }
}

/// The dock's character at the receiver; 0 for none.
fn character(around: Around<'_>, receiver: Point, dock: Pose) -> u8 {
    let way = receiver - dock.position();
    let distance_squared = way.norm_squared();
    if distance_squared > BEAMS * BEAMS {
        return 0;
    }
    let (ahead, left) = resolve(way, dock);
    // The dock's left is the right of a robot that faces it.
    let is_green = -left < ahead * BEAM.0 && left < ahead * BEAM.1;
    let is_red = left < ahead * BEAM.0 && -left < ahead * BEAM.1;
    let is_field = distance_squared < FORCE_FIELD * FORCE_FIELD;
    let bits = [is_field, is_green, is_red];
    if bits == [false; 3] || !sight::is_in_sight(around, receiver, dock.position(), SLACK) {
        return 0;
    }
    bits.iter().zip(&DOCK[1..]).fold(DOCK[0], |sum, (&is_seen, bit)| sum + if is_seen { *bit } else { 0 })
}

/// Whether the receiver is in the beam of a lighthouse, or in its halo.
fn is_in_fence(around: Around<'_>, receiver: Point, lighthouse: Pose, length: f64) -> bool {
    let way = receiver - lighthouse.position();
    let distance_squared = way.norm_squared();
    let reach = length.max(HALO) + FENCE.0;
    if distance_squared > reach * reach {
        return false;
    }
    let (ahead, left) = resolve(way, lighthouse);
    let is_in_beam = ahead > 0.0 && ahead < length && left.abs() < FENCE.0 + FENCE.1 * ahead;
    (is_in_beam || distance_squared < HALO * HALO) && sight::is_in_sight(around, receiver, lighthouse.position(), SLACK)
}

/// A displacement in an emitter's frame: ahead of it, and to its left.
fn resolve(way: Vector, emitter: Pose) -> (f64, f64) {
    let looks = emitter.direction();
    (looks.dot(&way), looks.perp(&way))
}
