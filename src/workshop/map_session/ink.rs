//! Colours of the Map tab. Blue is the robot's estimate, orange is ground truth.

/// One set of colours; those with four numbers are of cells: red, green, blue, opacity.
#[derive(Debug)]
pub(super) struct MapInk {
    /// Unknown area.
    pub unknown: &'static str,
    /// Grid lines: every metre, and every cell where there is room.
    pub grid: &'static str,
    /// Free cells of the map.
    pub free: [u8; 4],
    /// Free cells that are cleaned by the robot's estimate.
    pub cleaned: [u8; 4],
    /// Free cells that are reachable and not cleaned yet.
    pub left: [u8; 4],
    /// Occupied cells of the map.
    pub occupied: [u8; 4],
    /// Occupied cells of a map by odometry alone.
    pub odometry: [u8; 4],
    /// The same as a line.
    pub odometry_line: &'static str,
    /// Obstacles that exist.
    pub right: [u8; 4],
    /// Obstacles that don't exist.
    pub phantom: &'static str,
    /// Floor marked where an obstacle is.
    pub missed: &'static str,
    /// Obstacles that aren't on the map yet.
    pub unseen: &'static str,
    /// Ground truth.
    pub truth: &'static str,
    /// The robot's estimates.
    pub estimate: &'static str,
    /// The estimate's uncertainty.
    pub doubt: &'static str,
    /// Goal, and frontiers.
    pub goal: &'static str,
    /// Dirt that it found.
    pub dirt: &'static str,
    /// Contrast of lines with any background.
    pub halo: &'static str,
}

const LIGHT: MapInk = MapInk {
    unknown: "#e4e7ec",
    grid: "rgb(40 55 80 / 0.07)",
    free: [0xff, 0xfd, 0xf8, 0xff],
    cleaned: [0xc3, 0xd6, 0xee, 0xff],
    left: [0xfb, 0xe2, 0x9a, 0xff],
    occupied: [0x2a, 0x30, 0x3b, 0xff],
    odometry: [0x9a, 0x5b, 0x9c, 0x9c],
    odometry_line: "#7d3f80",
    right: [0x00, 0x7f, 0x5c, 0xff],
    phantom: "#c23b00",
    missed: "#8a2f73",
    unseen: "#6a7280",
    truth: "#d4530f",
    estimate: "#0062a3",
    doubt: "rgb(0 98 163 / 0.16)",
    goal: "#00664a",
    dirt: "#5a3a1c",
    halo: "rgb(255 255 255 / 0.9)",
};

const DARK: MapInk = MapInk {
    unknown: "#14171c",
    grid: "rgb(220 230 255 / 0.06)",
    free: [0x33, 0x37, 0x3f, 0xff],
    cleaned: [0x2f, 0x4a, 0x6e, 0xff],
    left: [0x6b, 0x56, 0x1c, 0xff],
    occupied: [0xe6, 0xe9, 0xef, 0xff],
    odometry: [0xd0, 0x8f, 0xd2, 0x9c],
    odometry_line: "#d9a0db",
    right: [0x2f, 0xc4, 0x98, 0xff],
    phantom: "#ff8a4a",
    missed: "#f29ad6",
    unseen: "#98a1b0",
    truth: "#ff8f4f",
    estimate: "#6cc0f5",
    doubt: "rgb(108 192 245 / 0.20)",
    goal: "#4fd6ab",
    dirt: "#d9b38c",
    halo: "rgb(10 12 15 / 0.8)",
};

impl MapInk {
    /// The colours for a dark or light background.
    pub fn of(dark: bool) -> &'static Self {
        if dark { &DARK } else { &LIGHT }
    }
}
