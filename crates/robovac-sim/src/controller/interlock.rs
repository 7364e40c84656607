//! Interlock of manual commands: Tables I and II of 002 (Hasan, Al-Nahid & Reza 2014, section IV.B).
//!
//! In manual mode the robot doesn't back away by itself, so dangerous commands are blocked: forward with anything in
//! the way, and turns to the side on which a bumper switch is pressed or a cliff sensor sees no floor. Backward is
//! always allowed.
//!
//! The tables cover two bumper switches and three cliff sensors. They apply to a Roomba if its two front sensors are
//! combined. Beyond the tables: a dropped wheel blocks everything, a virtual wall blocks forward, and cliff sensors are
//! ignored on a dock, whose ramp is black.
//!
//! ```
//! use robovac_sim::controller::interlock;
//! use robovac_core::robot::SensorReadings;
//! let sensed = SensorReadings { bump_right: true, ..SensorReadings::default() };
//! let blocked = interlock::blocked(&sensed);
//! let allowed = interlock::allowed(&sensed);
//! assert!(allowed.backward && allowed.left && !allowed.forward && !allowed.right);
//! assert_eq!(blocked.right, Some("bumper pressed on the right"));
//! ```

use crate::controller::Joystick;
use robovac_core::robot::SensorReadings;

/// Allowed commands.
#[expect(clippy::struct_excessive_bools)]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Allowed {
    /// Drive ahead.
    pub forward: bool,
    /// Drive back.
    pub backward: bool,
    /// Turn to the left.
    pub left: bool,
    /// Turn to the right.
    pub right: bool,
}

/// Reasons why commands are blocked; `None` for allowed ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Blocked {
    /// Drive ahead.
    pub forward: Option<&'static str>,
    /// Drive back.
    pub backward: Option<&'static str>,
    /// Turn to the left.
    pub left: Option<&'static str>,
    /// Turn to the right.
    pub right: Option<&'static str>,
}

/// The allowed commands.
pub fn allowed(sensed: &SensorReadings) -> Allowed {
    blocked(sensed).allowed()
}

/// The blocked commands, with reasons.
pub fn blocked(sensed: &SensorReadings) -> Blocked {
    if sensed.wheel_dropped() {
        let why = Some("wheel drop");
        return Blocked { forward: why, backward: why, left: why, right: why };
    }
    let cliff = if sensed.battery.on_dock { [false; 4] } else { sensed.cliff };
    let [on_left, front_left, front_right, on_right] = cliff;
    let side = |bump: bool, cliff: bool, bumped: &'static str, no_floor: &'static str| {
        if cliff { Some(no_floor) } else { bump.then_some(bumped) }
    };
    let left = side(sensed.bump_left, on_left, "bumper pressed on the left", "no floor on the left");
    let right = side(sensed.bump_right, on_right, "bumper pressed on the right", "no floor on the right");
    let front = if front_left || front_right {
        Some("no floor in front")
    } else if sensed.bump_left && sensed.bump_right && !on_left && !on_right {
        Some("bumper pressed in front")
    } else {
        left.or(right).or(sensed.virtual_wall.then_some("virtual wall"))
    };
    Blocked { forward: front, backward: None, left, right }
}

impl Blocked {
    /// The allowed commands.
    pub fn allowed(&self) -> Allowed {
        let Self { forward, backward, left, right } = self;
        Allowed {
            forward: forward.is_none(),
            backward: backward.is_none(),
            left: left.is_none(),
            right: right.is_none(),
        }
    }
}

impl Allowed {
    /// The allowed part of a command: each of its two components is kept or set to 0.
    pub fn cut(&self, command: Joystick) -> Joystick {
        let part = |value: f64, plus: bool, minus: bool| {
            let is_allowed = if value > 0.0 { plus } else { minus };
            if is_allowed && value.is_finite() { value.clamp(-1.0, 1.0) } else { 0.0 }
        };
        Joystick {
            forward: part(command.forward, self.forward, self.backward),
            left: part(command.left, self.left, self.right),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::BatteryReading;

    fn sensed(bump: [u8; 2], cliff: [u8; 3]) -> SensorReadings {
        let [left, front, right] = cliff.map(|bit| bit == 1);
        SensorReadings {
            bump_left: bump[0] == 1,
            bump_right: bump[1] == 1,
            cliff: [left, front, front, right],
            ..SensorReadings::default()
        }
    }

    /// Allowed commands as the tables print them.
    fn printed(text: &str) -> Allowed {
        let all = text.starts_with("All");
        Allowed {
            forward: all && !text.contains("except Forward"),
            backward: all || text.contains("Backward"),
            left: all || text.contains("Left"),
            right: all || text.contains("Right"),
        }
    }

    #[test]
    fn table_1_bumper() {
        for (bump, text) in [
            ([0, 0], "All (Forward, Right, Left, Backward)"),
            ([0, 1], "Backward & Left"),
            ([1, 0], "Backward & Right"),
            ([1, 1], "Backward"),
        ] {
            assert_eq!(allowed(&sensed(bump, [0; 3])), printed(text), "{bump:?}");
        }
    }

    #[test]
    fn table_2_cliff_sensors() {
        for (cliff, text) in [
            ([0, 0, 0], "All"),
            ([0, 0, 1], "Backward & Left"),
            ([0, 1, 0], "All except Forward"),
            ([0, 1, 1], "Backward & Left"),
            ([1, 0, 0], "Backward & Right"),
            ([1, 0, 1], "Backward"),
            ([1, 1, 0], "Backward & Right"),
            ([1, 1, 1], "Backward"),
        ] {
            assert_eq!(allowed(&sensed([0; 2], cliff)), printed(text), "{cliff:?}");
        }
    }

    #[test]
    fn both_tables_hold_at_once_and_every_block_has_its_reason() {
        for bits in 0..32_u8 {
            let bit = |index: u8| bits >> index & 1;
            let (bump, cliff) = ([bit(0), bit(1)], [bit(2), bit(3), bit(4)]);
            let both = allowed(&sensed(bump, cliff));
            let (one, two) = (allowed(&sensed(bump, [0; 3])), allowed(&sensed([0; 2], cliff)));
            assert_eq!(both.forward, one.forward && two.forward, "{bump:?} {cliff:?}");
            assert_eq!((both.left, both.right), (one.left && two.left, one.right && two.right), "{bump:?} {cliff:?}");
            assert!(both.backward);
        }
        assert_eq!(blocked(&sensed([1, 1], [0; 3])).forward, Some("bumper pressed in front"));
        assert_eq!(blocked(&sensed([1, 0], [0; 3])).forward, Some("bumper pressed on the left"));
        assert_eq!(blocked(&sensed([1, 0], [1, 0, 0])).left, Some("no floor on the left"));
        assert_eq!(blocked(&sensed([0, 0], [0, 1, 0])).forward, Some("no floor in front"));
    }

    #[test]
    fn lifted_fenced_and_docked() {
        let nothing = Allowed { forward: false, backward: false, left: false, right: false };
        assert_eq!(allowed(&SensorReadings { wheel_drop_left: true, ..SensorReadings::default() }), nothing);
        let fenced = blocked(&SensorReadings { virtual_wall: true, ..SensorReadings::default() });
        assert_eq!(fenced, Blocked { forward: Some("virtual wall"), ..Blocked::default() });
        let battery = BatteryReading { on_dock: true, ..BatteryReading::default() };
        assert_eq!(
            blocked(&SensorReadings { battery, cliff: [true; 4], ..SensorReadings::default() }),
            Blocked::default()
        );
    }

    #[test]
    fn mixed_commands_are_cut_to_what_is_allowed() {
        let command = Joystick { forward: 1.0, left: 0.5 };
        let cut = |bump| allowed(&sensed(bump, [0; 3])).cut(command);
        assert_eq!(cut([0, 0]), command);
        assert_eq!(cut([0, 1]), Joystick { forward: 0.0, left: 0.5 });
        assert_eq!(cut([1, 0]), Joystick::default());
        let wild = Joystick { forward: f64::NAN, left: -9.0 };
        assert_eq!(allowed(&sensed([0, 0], [0; 3])).cut(wild), Joystick { forward: 0.0, left: -1.0 });
    }
}
