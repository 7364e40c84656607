//! Personalities: how real robots deviate from the specification.
//!
//! Each is a robot, a cable or a firmware seen in practice; the sources are in the project's fact sheet on the Open
//! Interface (sections 1, 2 and 7). Rates of faults are ours unless stated otherwise.

use roomba_oi::motion::ANGLE_ERROR;

/// Acceleration of the wheels, m/s²: the only published figure, the default of `wheel_accel` in the robot description of
/// the ROS driver `AutonomyLab/create_robot` (`create_description/urdf/create_base.urdf.xacro`); iRobot publishes none. It
/// isn't known to be measured. Behaviours, in the simulator and on a real robot, count on the less that is in the robot
/// model: whoever brakes for an edge must not count on too much.
const ACCELERATION: f64 = 1.8;

/// A way in which a robot, or the line to it, differs from the specification.
#[derive(Debug, Clone, PartialEq)]
#[expect(clippy::struct_excessive_bools)]
pub struct Personality {
    /// Name in links, menus and on the command line.
    pub id: &'static str,
    /// Name in menus.
    pub title: &'static str,
    /// One sentence: its effect, and where it occurs.
    pub summary: &'static str,
    /// Baud rate after power-on.
    pub default_baud: u32,
    /// Baud rate at the start, as set by an earlier program.
    pub baud: u32,
    /// Whether it sleeps at the start.
    pub starts_asleep: bool,
    /// Whether it stands on its dock at the start, regardless of the floor plan. A dock is added if there is none.
    pub starts_docked: bool,
    /// Whether the cable has the wire for BRC.
    pub has_brc: bool,
    /// Added to the mode in packet 35.
    pub mode_offset: u8,
    /// Factor from the true angle to packet 20.
    pub angle_factor: f64,
    /// Whether packets 43 and 44 are swapped.
    pub swaps_encoders: bool,
    /// Counts of the left and right wheel at the start and after a reset.
    pub first_counts: [u16; 2],
    /// Last supported packet; groups with later ones are unsupported as well.
    pub last_packet: u8,
    /// Text written when it boots.
    pub banner: Banner,
    /// Whether it stays in its boot loader after a reset.
    pub stays_in_boot_loader: bool,
    /// When it writes its charging log, one line per second.
    pub log: ChargingLogTimes,
    /// Whether it reports falling asleep and waking up.
    pub tells_of_sleep: bool,
    /// Whether its bytes arrive at all.
    pub is_heard: bool,
    /// Share of the bytes to the host that are lost.
    pub lost_to_host: f64,
    /// Share of the bytes to the host of which one bit is flipped.
    pub flipped_to_host: f64,
    /// Share of the bytes to the robot that are lost.
    pub lost_to_robot: f64,
    /// Time on the dock after which it becomes silent and can't be woken by BRC, s.
    pub silent_on_dock_s: Option<f64>,
    /// Acceleration of its wheels, m/s².
    pub acceleration: f64,
}

/// Text written by a booting robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Banner {
    /// That of the newer processor, release 3.7.1.
    Stm32,
    /// That of the older processor, release 3.4.0.
    Str730,
    /// Nothing, as on a 690.
    None,
}

/// When a robot writes its charging log.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChargingLogTimes {
    /// Never.
    Never,
    /// While it charges.
    Charging,
    /// Always.
    Always,
}

const BY_THE_BOOK: Personality = Personality {
    id: "model",
    title: "As specified",
    summary: "A Create 2 that follows the specification.",
    default_baud: 115_200,
    baud: 115_200,
    starts_asleep: false,
    starts_docked: false,
    has_brc: true,
    mode_offset: 0,
    angle_factor: 1.0,
    swaps_encoders: false,
    first_counts: [0, 0],
    last_packet: 58,
    banner: Banner::Stm32,
    stays_in_boot_loader: false,
    log: ChargingLogTimes::Never,
    tells_of_sleep: false,
    is_heard: true,
    lost_to_host: 0.0,
    flipped_to_host: 0.0,
    lost_to_robot: 0.0,
    silent_on_dock_s: None,
    acceleration: ACCELERATION,
};

/// All personalities; the first is a robot that follows the specification.
pub const PERSONALITIES: &[Personality] = &[
    BY_THE_BOOK,
    Personality {
        id: "asleep",
        title: "Asleep",
        summary: "Silent until its Clean button or the cable's BRC wire wakes it, as after five idle minutes.",
        starts_asleep: true,
        tells_of_sleep: true,
        ..BY_THE_BOOK
    },
    Personality {
        id: "no_brc",
        title: "Asleep, cable without BRC",
        summary: "Asleep; only its Clean button wakes it, as many cables lack the BRC wire.",
        starts_asleep: true,
        has_brc: false,
        ..BY_THE_BOOK
    },
    Personality {
        id: "slow",
        title: "19200 baud",
        summary: "Communicates at 19200 baud, as after three short pulses on BRC; any other rate is garbled.",
        baud: 19_200,
        ..BY_THE_BOOK
    },
    Personality {
        id: "mode_plus_one",
        title: "Mode one too high",
        summary: "Reports modes 2, 3 and 4 instead of 1, 2 and 3, as some robots of the 600 series do.",
        mode_offset: 1,
        ..BY_THE_BOOK
    },
    Personality {
        id: "chatty",
        title: "Chatty",
        summary: "Mixes text about its battery into the data every second, and when it wakes or sleeps.",
        // Most robots do so only while they charge (see "docked"). Some logged text within the data of an active
        // interface, away from any dock: the worse case, which a driver must handle.
        log: ChargingLogTimes::Always,
        tells_of_sleep: true,
        ..BY_THE_BOOK
    },
    Personality {
        id: "docked",
        title: "On its dock",
        summary: "Charges on its dock, logs this every second, and falls back from Safe to Passive at once.",
        starts_docked: true,
        log: ChargingLogTimes::Charging,
        tells_of_sleep: true,
        ..BY_THE_BOOK
    },
    Personality {
        id: "dozes",
        title: "Silent on its dock",
        summary: "Falls silent after half a minute on its dock; BRC doesn't wake it, as with firmware 3 on a 650.",
        starts_docked: true,
        silent_on_dock_s: Some(30.0),
        ..BY_THE_BOOK
    },
    Personality {
        id: "angle_bug",
        title: "Old firmware",
        summary: "Reports a third of every angle in packet 20 and boots with the older banner, like firmware up to 3.4.0.",
        angle_factor: ANGLE_ERROR,
        banner: Banner::Str730,
        ..BY_THE_BOOK
    },
    Personality {
        id: "noisy",
        title: "Noisy line",
        summary: "One in a thousand bytes sent by the robot is lost or has a flipped bit, as with a bad cable.",
        lost_to_host: 0.0005,
        flipped_to_host: 0.0005,
        ..BY_THE_BOOK
    },
    Personality {
        id: "deaf",
        title: "Lossy receiver",
        summary: "Loses one in two hundred bytes sent to it, and reads the next command as the missing data.",
        lost_to_robot: 0.005,
        ..BY_THE_BOOK
    },
    Personality {
        id: "swapped",
        title: "Encoders swapped",
        summary: "Packet 43 is the right wheel and 44 the left one, as in the Roomba 500 document.",
        swaps_encoders: true,
        ..BY_THE_BOOK
    },
    Personality {
        id: "wrap",
        title: "Encoders about to wrap",
        summary: "The left encoder wraps after about 10 cm ahead, the right one as soon as the robot backs up.",
        // 89 mm ahead for the left one, 22 mm back for the right one.
        first_counts: [65_336, 50],
        ..BY_THE_BOOK
    },
    Personality {
        id: "bootloader",
        title: "Stuck in its bootloader",
        summary: "Works until it is reset, then sends only 254, as seen on a robot of the 600 series.",
        stays_in_boot_loader: true,
        ..BY_THE_BOOK
    },
    Personality {
        id: "create1",
        title: "Create 1",
        summary: "Communicates at 57600 baud, without encoder counts and light bumper (no packets after 42), like a Create 1.",
        default_baud: 57_600,
        baud: 57_600,
        last_packet: 42,
        banner: Banner::None,
        ..BY_THE_BOOK
    },
    Personality {
        id: "silent",
        title: "Never answers",
        summary: "Receives and obeys, but nothing that it sends arrives: a broken wire.",
        is_heard: false,
        ..BY_THE_BOOK
    },
];

/// The personality with that id.
pub fn personality(id: &str) -> Option<&'static Personality> {
    PERSONALITIES.iter().find(|p| p.id == id)
}
