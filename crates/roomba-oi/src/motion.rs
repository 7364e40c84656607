//! Wheel speeds, encoder counts and the angle packet's error: the interface's arithmetic.

/// Distance between the wheels, mm.
pub const WHEEL_BASE_MM: f64 = 235.0;

/// Radius of the robot with its bumper, mm: half of 348.5.
pub const ROBOT_RADIUS_MM: f64 = 174.25;

/// Wheel travel per encoder count, mm: wheels of 72 mm, 508.8 counts a turn.
pub const MM_PER_COUNT: f64 = core::f64::consts::PI * 72.0 / 508.8;

/// Largest wheel speed of a command, mm/s.
pub const MAX_SPEED_MM_S: i16 = 500;

/// Greatest radius of Drive, mm; beyond it robots drive straight.
pub const MAX_RADIUS_MM: i16 = 2000;

/// Radius of Drive that means straight on.
pub const STRAIGHT: i16 = i16::MIN;

/// The other radius that means straight on, 0x7FFF.
pub const STRAIGHT_TOO: i16 = i16::MAX;

/// Radius of Drive that turns on the spot, clockwise for positive velocities.
pub const SPIN_CLOCKWISE: i16 = -1;

/// Radius of Drive that turns on the spot, counter-clockwise for positive velocities.
pub const SPIN_COUNTER_CLOCKWISE: i16 = 1;

/// Speeds of both wheels, mm/s, forward positive.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct WheelSpeeds {
    /// Right wheel.
    pub right: f64,
    /// Left wheel.
    pub left: f64,
}

impl WheelSpeeds {
    /// Wheel speeds of Drive (137): the velocity in mm/s is the mean of both, the radius in mm is that of the robot's
    /// middle, positive to the left.
    ///
    /// On small radii the outer wheel comes out faster than any robot drives: see [`Self::limited`]. Radius 0 isn't
    /// described anywhere; it is taken as straight on. Real robots of 2016 deviate on radii of 100 to 300 mm, by a factor
    /// of 1.6 in the one measurement known; that isn't modelled here.
    pub fn of_drive(velocity: i16, radius: i16) -> Self {
        let v = f64::from(velocity);
        match radius {
            STRAIGHT | STRAIGHT_TOO | 0 => Self { right: v, left: v },
            SPIN_COUNTER_CLOCKWISE => Self { right: v, left: -v },
            SPIN_CLOCKWISE => Self { right: -v, left: v },
            radius => {
                let r = f64::from(radius);
                let half = 0.5 * WHEEL_BASE_MM;
                Self { right: v * (r + half) / r, left: v * (r - half) / r }
            }
        }
    }

    /// The same curve, slowed down until no wheel is faster than [`MAX_SPEED_MM_S`]. How robots limit it isn't described.
    pub fn limited(self) -> Self {
        let (fastest, most) = (self.right.abs().max(self.left.abs()), f64::from(MAX_SPEED_MM_S));
        if fastest <= most {
            return self;
        }
        Self { right: self.right / fastest * most, left: self.left / fastest * most }
    }

    /// Radius on which the robot's middle moves, mm, positive to the left; `None` straight on and at rest.
    pub fn radius(self) -> Option<f64> {
        (self.right != self.left).then(|| 0.5 * WHEEL_BASE_MM * (self.right + self.left) / (self.right - self.left))
    }
}

/// Counts that an encoder made from one reading (packet 43 or 44) to the next.
///
/// The specification of 2016 calls them signed, those before it unsigned. Only differences modulo 65536 mean anything,
/// and those are right up to half a round, 14.57 m.
///
/// ```
/// use roomba_oi::motion::encoder_delta;
/// assert_eq!(encoder_delta(65_530, 5), 11);
/// assert_eq!(encoder_delta(5, 65_530), -11);
/// ```
pub fn encoder_delta(before: u16, now: u16) -> i16 {
    now.wrapping_sub(before) as i16
}

/// Factor from the true angle to packet 20 on firmware up to 3.4.0; 3.4.1 reports the angle itself.
pub const ANGLE_ERROR: f64 = 0.324_056;

/// Packet 20 of such a robot for a turn in degrees: robots report whole degrees, and lose the rest.
pub fn faulty_angle(true_degrees: f64) -> f64 {
    true_degrees * ANGLE_ERROR
}

/// The turn in degrees behind what packet 20 of such a robot reports.
pub fn true_angle(reported_degrees: f64) -> f64 {
    reported_degrees / ANGLE_ERROR
}

#[cfg(test)]
mod tests {
    use super::*;
    #[test]
    fn limiting_keeps_the_curve() {
        let tight = WheelSpeeds::of_drive(-300, 20);
        let limited = tight.limited();
        assert!((limited.right.abs().max(limited.left.abs()) - 500.0).abs() < 1e-9);
        let (before, after) = (tight.radius().unwrap(), limited.radius().unwrap());
        assert!((before - 20.0).abs() < 1e-9 && (after - 20.0).abs() < 1e-9, "{before} {after}");
        assert_eq!(WheelSpeeds::of_drive(500, STRAIGHT).limited(), WheelSpeeds { right: 500.0, left: 500.0 });
        assert_eq!(WheelSpeeds::of_drive(100, 0).radius(), None);
    }
}
