//! The modes Off, Passive, Safe and Full, and their transitions.

use super::{
    motion::{ROBOT_RADIUS_MM, WheelSpeeds},
    opcode::{ModeAfter, Opcode},
};
use core::fmt;

/// The commands that a robot accepts. Each mode allows everything that the modes below it allow.
///
/// A robot doesn't report changes of its mode; it must be read from packet 35.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[repr(u8)]
pub enum Mode {
    /// Listens for Start only, and answers nothing: packet 35 never shows it.
    #[default]
    Off,
    /// Reports its sensors, cleans by itself; falls asleep after five minutes.
    Passive,
    /// Can be driven; stops by itself when something looks dangerous. Never sleeps and doesn't charge.
    Safe,
    /// Can be driven, and does nothing by itself. Never sleeps and doesn't charge.
    Full,
}

impl Mode {
    /// All modes, in the order of their numbers in packet 35.
    pub const ALL: [Self; 4] = [Self::Off, Self::Passive, Self::Safe, Self::Full];

    /// The mode that packet 35 names. Some robots of the 600 series report one too much: `offset` is 1 for them, else 0.
    pub fn from_report(byte: u8, offset: u8) -> Option<Self> {
        Self::ALL.get(usize::from(byte.checked_sub(offset)?)).copied()
    }

    /// The byte of packet 35, on a robot that adds `offset`.
    pub fn report(self, offset: u8) -> u8 {
        (self as u8).saturating_add(offset)
    }

    /// The mode after a command; `None` if this mode doesn't allow it and the robot ignores it.
    ///
    /// Safe commanded on a powered charger falls back to Passive at once: that is [`Hazard::Charger`].
    pub fn after_command(self, opcode: Opcode) -> Option<Self> {
        opcode.allowed_in(self).then(|| match opcode.mode_after() {
            ModeAfter::Same => self,
            ModeAfter::Is(mode) => mode,
        })
    }

    /// Effect of a hazard in this mode. Passive robots protect themselves: nothing changes for the interface.
    pub fn after_hazard(self, hazard: Hazard) -> Reaction {
        let entry = SAFETY.iter().find(|(mode, what, _)| *mode == self && *what == hazard);
        entry.map_or(Reaction { mode: self, stops: false }, |entry| entry.2)
    }
}

/// Name in the specification.
impl fmt::Display for Mode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(["Off", "Passive", "Safe", "Full"][*self as usize])
    }
}

/// Causes for a robot to leave Safe.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Hazard {
    /// A cliff while the robot moves in a way that could take it over the edge: see [`Hazard::of_cliff`].
    Cliff,
    /// A wheel hangs down.
    WheelDrop,
    /// A charger is plugged in and powered, or the robot stands on its dock.
    Charger,
    /// The bumper is pressed.
    Bumper,
    /// The light bumper sees something.
    LightBumper,
    /// The beam of a virtual wall is seen.
    VirtualWall,
}

impl Hazard {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Cliff, Self::WheelDrop, Self::Charger, Self::Bumper, Self::LightBumper, Self::VirtualWall];

    /// The hazard of a cliff for the commanded wheel speeds: while driving forward, or backward on a radius below the
    /// robot's own, 174 mm.
    ///
    /// The specification doesn't name turning on the spot; with a radius of 0 it is taken as the second case. A robot at
    /// rest, or one that backs away from the edge, is in no danger.
    pub fn of_cliff(told: WheelSpeeds) -> Option<Self> {
        let forward = told.right + told.left > 0.0;
        let tight = told.radius().is_some_and(|radius| radius.abs() < ROBOT_RADIUS_MM);
        (forward || tight).then_some(Self::Cliff)
    }
}

/// In the words of a sentence such as "it left Safe because of a dropped wheel".
impl fmt::Display for Hazard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Cliff => "a cliff",
            Self::WheelDrop => "a dropped wheel",
            Self::Charger => "a powered charger",
            Self::Bumper => "the bumper",
            Self::LightBumper => "the light bumper",
            Self::VirtualWall => "a virtual wall",
        })
    }
}

/// A robot's reaction to a hazard.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Reaction {
    /// The mode after it.
    pub mode: Mode,
    /// Whether all motors stop.
    pub stops: bool,
}

/// The safety features, the whole list: in every other case mode and motors stay (a bumper changes nothing even in Safe,
/// which follows from its absence in the specification's list).
pub const SAFETY: [(Mode, Hazard, Reaction); 3] = {
    let drop = Reaction { mode: Mode::Passive, stops: true };
    [(Mode::Safe, Hazard::Cliff, drop), (Mode::Safe, Hazard::WheelDrop, drop), (Mode::Safe, Hazard::Charger, drop)]
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_off_ignores_nearly_everything() {
        for &opcode in Opcode::ALL {
            let wakes = matches!(opcode, Opcode::Start | Opcode::Reset);
            assert_eq!(Mode::Off.after_command(opcode).is_some(), wakes, "{opcode}");
            assert!(Mode::Full.after_command(opcode).is_some(), "{opcode}");
        }
    }

    #[test]
    fn reports_are_read_with_and_without_the_offset() {
        for mode in Mode::ALL {
            for offset in 0..=1 {
                assert_eq!(Mode::from_report(mode.report(offset), offset), Some(mode));
            }
        }
        assert_eq!((Mode::from_report(0, 1), Mode::from_report(4, 0)), (None, None));
        assert_eq!((Mode::from_report(5, 1), Mode::from_report(255, 1)), (None, None));
    }

    #[test]
    fn a_cliff_is_no_danger_to_a_robot_that_backs_away() {
        let told = |right: f64, left: f64| Hazard::of_cliff(WheelSpeeds { right, left });
        assert_eq!(told(200.0, 200.0), Some(Hazard::Cliff));
        assert_eq!((told(-200.0, -200.0), told(0.0, 0.0)), (None, None));
        // On the spot, and backwards around one wheel (radius 117.5 mm); then 352.5 mm, wide enough.
        assert_eq!((told(100.0, -100.0), told(0.0, -100.0)), (Some(Hazard::Cliff), Some(Hazard::Cliff)));
        assert_eq!(told(-100.0, -200.0), None);
    }
}
