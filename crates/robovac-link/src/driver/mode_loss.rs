//! Why a robot left its commanded mode.

use roomba_oi::{Mode, Readings};
use std::fmt;

/// A robot that left Safe or Full by itself, with possible causes from the frame that reported it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ModeLoss {
    /// The mode that it was in, or was commanded to.
    pub from: Mode,
    /// Whether it had reached the mode.
    pub was_there: bool,
    /// Cliff sensors without floor: left, front left, front right, right.
    pub cliff: [bool; 4],
    /// Dropped wheels: left, right.
    pub wheel_drop: [bool; 2],
    /// Whether it charges: through its jack, on its dock.
    pub charger: [bool; 2],
    /// Whether a button was pressed.
    pub button: bool,
}

impl ModeLoss {
    /// From the latest two readings, as the cause can have ended when the mode is reported.
    pub(super) fn new(from: Mode, was_there: bool, [before, now]: [&Readings; 2]) -> Self {
        let either = |what: fn(&Readings) -> bool| what(before) || what(now);
        Self {
            from,
            was_there,
            cliff: std::array::from_fn(|i| before.cliff[i] || now.cliff[i]),
            wheel_drop: [either(|r| r.bumps.drop_left), either(|r| r.bumps.drop_right)],
            charger: [either(|r| r.chargers.internal_charger), either(|r| r.chargers.home_base)],
            button: either(|r| r.buttons.byte() != 0),
        }
    }

    /// Whether it would leave the mode again at once.
    pub fn is_lasting(&self) -> bool {
        self.charger.contains(&true)
    }

    /// Advice.
    pub fn remedy(&self) -> &'static str {
        match self {
            _ if self.charger[1] => "Take it off its dock first: there it returns to Passive at once, to charge.",
            _ if self.charger[0] => "Unplug the charger first.",
            _ if self.wheel_drop.contains(&true) => {
                "Put it down with both wheels on the floor, then take control again."
            }
            _ if self.cliff.contains(&true) => "Move it away from the edge, then take control again.",
            _ if self.button => "Take control again.",
            _ => {
                "Take control again. If this happens repeatedly, another program may be sending commands, or the \
                 battery is low."
            }
        }
    }
}

/// One sentence.
impl fmt::Display for ModeLoss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.was_there {
            write!(f, "The robot left {} and stopped: ", self.from)?;
        } else {
            write!(f, "The robot didn't switch to {}: ", self.from)?;
        }
        let mut causes = Vec::new();
        if self.wheel_drop == [true; 2] {
            causes.push("both wheels have dropped".to_owned());
        } else {
            let sides = ["left", "right"].iter().zip(self.wheel_drop).filter(|(_, drops)| *drops);
            causes.extend(sides.map(|(side, _)| format!("its {side} wheel has dropped")));
        }
        let names = ["left", "front left", "front right", "right"];
        let cliffs: Vec<_> = names.iter().zip(self.cliff).filter(|(_, sees)| *sees).map(|(name, _)| *name).collect();
        // On a dock all of them face its black ramp.
        if self.cliff == [true; 4] && !self.charger[1] {
            causes.push("no cliff sensor detects floor".to_owned());
        } else if !cliffs.is_empty() && !self.charger[1] {
            causes.push(format!("no floor under the cliff sensor {}", cliffs.join(" and ")));
        }
        if self.charger[0] {
            causes.push("the charger is plugged in".to_owned());
        }
        if self.charger[1] {
            causes.push("it stands on its dock".to_owned());
        }
        if causes.is_empty() {
            causes.push(if self.button { "a button was pressed" } else { "it reports no reason" }.to_owned());
        }
        write!(f, "{}.", causes.join(", "))
    }
}
