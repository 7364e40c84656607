//! Infrared receivers: the beams of docks and virtual walls.
//!
//! The light of docks is described in [`docking`](crate::docking). Walls and movers stop it.
//!
//! A virtual wall's beam widens by 5 degrees to either side of its line, and a halo of 0.4 m keeps robots from pushing
//! the lighthouse away (owners report that there is one; the figures are ours).
//!
//! Noise: at "typical" a receiver misses one character in twenty, at "harsh", in sunlight, every third (ours).

use super::{Around, BodyFrame, Noisy, sight};
use crate::{
    SensorKind, World,
    docking::{self, CONTACT, RECEIVERS, SLACK, resolve},
};
use robovac_core::{
    coverage::{DOCK_BACK, FENCE, HALO},
    geometry::{Point, Pose},
    robot::{Infrared, RobotModel, SensorReadings},
};

/// Character of a virtual wall.
const VIRTUAL_WALL: u8 = 162;
/// Characters of a dock are sums of these: all, force field, green and red beam.
const DOCK: [u8; 4] = [160, 1, 4, 8];

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
        let [sees_left, sees_right] = docking::front_sees(way, frame.ahead);
        omni |= character;
        left |= if sees_left { character } else { 0 };
        right |= if sees_right { character } else { 0 };
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
    let bits = docking::light_at(dock, receiver);
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
