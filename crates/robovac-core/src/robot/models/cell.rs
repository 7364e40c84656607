//! The textbook robot, which fills one grid cell.

use crate::robot::{
    RobotModel,
    body::{Battery, Body, Bumper, SensorSuite, Tool, WheelLayout},
    model::PowerDraw,
};

/// The thesis' robot on its grid: one cell of 20 cm is what it stands on and cleans (000, section 5.1).
pub(super) const CELL_20: RobotModel = cell_robot(0.2);

/// An idealised robot that fills one grid cell of side `cell` metres and cleans the cell it stands on.
///
/// Its body is 90 % of the cell, so that it drives through corridors of one cell without rubbing along both walls. The
/// wheel base is three quarters of the body, it drives like the Roomba, and its encoders count hundredths of a
/// millimetre, as a textbook's robot knows its position.
///
/// Its power is the DVR-1's: 6 V x 4.5 Ah last for about an hour, 27 W, split as its motors are rated: 5 A for the vacuum,
/// two brushes of 0.5 A, two wheels of 2 A (002, section IV); turning as for the Roomba.
pub const fn cell_robot(cell: f64) -> RobotModel {
    RobotModel {
        id: "cell",
        title: "Grid robot (one cell)",
        summary: "The textbook robot: fills and cleans one grid cell",
        body: Body::Round,
        radius: 0.45 * cell,
        wheels: WheelLayout::Differential,
        sensors: SensorSuite {
            bumper: Some(Bumper { half_arc: core::f64::consts::FRAC_PI_2, both_within: 0.35, height: 0.0 }),
            cliffs: [
                Some([0.25 * cell, 0.4 * cell]),
                Some([0.44 * cell, 0.1 * cell]),
                Some([0.44 * cell, -0.1 * cell]),
                Some([0.25 * cell, -0.4 * cell]),
            ],
            light_bumper: None,
            infrared: true,
            wheel_drops: true,
            laser: None,
        },
        castors: &[],
        side_brushes: &[],
        battery: Battery { capacity_mah: 4500.0, voltage: 6.0, charge_ma: 818.0, has_gauge: true },
        tool_width: cell,
        tool: Tool::CENTRED,
        wheel_base: 0.675 * cell,
        counts_per_metre: 1e5,
        wheel_radius: 0.2 * cell,
        max_wheel_speed: 0.5,
        speed_steps: [0.0, 0.0],
        acceleration: 0.8,
        cruise_speed: 0.3,
        turn_wheel_speed: 0.2,
        default_cell: cell,
        fills_cell: true,
        power: PowerDraw { standing: 16.2, straight: 10.8, turning: 7.2 },
    }
}
