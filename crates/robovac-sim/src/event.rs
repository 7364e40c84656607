//! Events of a run, for the log.

use robovac_core::robot::SensorReadings;
use std::fmt;

/// An event of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Event {
    /// Number of steps before it.
    pub step: u64,
    /// Kind of the event.
    pub what: What,
}

/// Kinds of events.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum What {
    /// The bumper was pressed, on the left, on the right or both.
    Bump {
        /// Its left half.
        left: bool,
        /// Its right half.
        right: bool,
    },
    /// Cliff sensors lost the floor: left, front left, front right, right.
    Cliff([bool; 4]),
    /// The beam of a virtual wall was detected.
    VirtualWall,
    /// A wheel dropped.
    WheelDrop,
    /// The robot was on its dock and charging.
    Docked,
    /// The battery was empty.
    BatteryEmpty,
    /// The robot fell down a drop-off.
    Fell,
    /// The robot was picked up.
    Lifted,
    /// The robot was put down.
    PutDown,
    /// The controller started another activity.
    Began(&'static str),
    /// The controller was done.
    Done,
}

/// The parts of a reading that cause events. They are compared after every step, and a whole reading is long.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Signs {
    /// Left and right.
    bump: [bool; 2],
    cliff: [bool; 4],
    virtual_wall: bool,
    wheel_dropped: bool,
    on_dock: bool,
}

impl Signs {
    #[inline]
    pub fn of(sensed: &SensorReadings) -> Self {
        Self {
            bump: [sensed.bump_left, sensed.bump_right],
            cliff: sensed.cliff,
            virtual_wall: sensed.virtual_wall,
            wheel_dropped: sensed.wheel_dropped(),
            on_dock: sensed.battery.on_dock,
        }
    }

    #[inline]
    pub fn bumped(self) -> bool {
        self.bump.contains(&true)
    }
}

impl What {
    /// The events between two readings.
    pub(super) fn between(before: Signs, now: Signs, mut tell: impl FnMut(Self)) {
        if now.bumped() && !before.bumped() {
            tell(Self::Bump { left: now.bump[0], right: now.bump[1] });
        }
        if now.cliff.contains(&true) && !before.cliff.contains(&true) {
            tell(Self::Cliff(now.cliff));
        }
        if now.virtual_wall && !before.virtual_wall {
            tell(Self::VirtualWall);
        }
        if now.wheel_dropped && !before.wheel_dropped {
            tell(Self::WheelDrop);
        }
        if now.on_dock && !before.on_dock {
            tell(Self::Docked);
        }
    }
}

/// The text in the event log.
impl fmt::Display for What {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = match self {
            Self::Bump { left: true, right: true } => "bump in front",
            Self::Bump { left: true, .. } => "bump left",
            Self::Bump { .. } => "bump right",
            Self::Cliff([_, true, _, _] | [_, _, true, _]) => "cliff in front",
            Self::Cliff([true, ..]) => "cliff left",
            Self::Cliff(_) => "cliff right",
            Self::VirtualWall => "virtual wall",
            Self::WheelDrop => "wheel drop",
            Self::Docked => "docked, charging",
            Self::BatteryEmpty => "battery empty",
            Self::Fell => "fell off an edge",
            Self::Lifted => "lifted",
            Self::PutDown => "put down",
            Self::Began(activity) => activity,
            Self::Done => "done",
        };
        f.write_str(text)
    }
}
