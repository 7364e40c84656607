//! Colours of the floor and the robot; those of the page around it are in `www/style.css`.

/// One set of colours, as CSS.
#[derive(Debug)]
pub struct Palette {
    /// Around the room.
    pub outside: &'static str,
    /// Floor that hasn't been swept.
    pub floor: &'static str,
    /// Laid over floor that the robot can't reach.
    pub unreachable: &'static str,
    /// Hatching of floor that the robot can't reach.
    pub hatch: &'static str,
    /// Walls and furniture.
    pub wall: &'static str,
    /// Edges of walls and furniture.
    pub wall_line: &'static str,
    /// Unknown cells.
    pub unknown: &'static str,
    /// Lines between cells.
    pub grid: &'static str,
    /// The line that the planner found.
    pub planned: &'static str,
    /// The best line so far while planning.
    pub preview: &'static str,
    /// The robot's recent trail; marks of editing.
    pub accent: &'static str,
    /// The robot's body.
    pub body: &'static str,
    /// Lines on the body.
    pub body_line: &'static str,
    /// Ring around the body for contrast with any floor.
    pub halo: &'static str,
    /// Bumper at rest.
    pub bumper: &'static str,
    /// Bumper pressed.
    pub bump: &'static str,
    /// The start.
    pub start: &'static str,
    /// The robot's estimated pose.
    pub estimate: &'static str,
    /// Sensor beams and detections.
    pub sensor: &'static str,
    /// The side of the room that a planner prefers, and the other one.
    pub sides: [&'static str; 2],
    /// Parts of a walk that was taken apart, one after the other (Okabe & Ito).
    pub parts: [&'static str; 4],
    /// New part of a walk.
    pub link: &'static str,
    /// Cells where a walk changes.
    pub tint: &'static str,
    /// Furniture that was placed.
    pub furniture: &'static str,
    /// Edges of furniture.
    pub furniture_line: &'static str,
    /// Carpet.
    pub carpet: &'static str,
    /// Lines on a carpet.
    pub carpet_line: &'static str,
    /// Stairs.
    pub drop_off: &'static str,
    /// Treads.
    pub tread: &'static str,
    /// Edge of a drop-off.
    pub warning: &'static str,
    /// Specks of dirt.
    pub dirt: &'static str,
    /// Beam of a virtual wall.
    pub fence: &'static str,
    /// Middle of a virtual wall's beam.
    pub fence_line: &'static str,
    /// Beams of a dock, the green one first.
    pub beams: [&'static str; 2],
    /// A person and their way.
    pub person: &'static str,
    /// A pet and its way.
    pub pet: &'static str,
    /// Selection.
    pub select: &'static str,
    /// Scale bar.
    pub text: &'static str,
    /// Colours of floor swept once to five times and more; see [`Palette::visits`].
    pub passes: [[u8; 3]; 5],
}

/// Colours on a light background. The passes follow cividis, lightened at its dark end so that a single pass looks
/// clean, not dark.
const LIGHT: Palette = Palette {
    outside: "#f5f6f8",
    floor: "#f6eee0",
    unreachable: "rgb(120 112 100 / 0.14)",
    hatch: "rgb(96 88 76 / 0.30)",
    wall: "#cfccc6",
    wall_line: "#55524c",
    unknown: "#e3e5e9",
    grid: "rgb(60 50 35 / 0.10)",
    planned: "rgb(38 45 60 / 0.42)",
    preview: "rgb(38 45 60 / 0.75)",
    accent: "#d4530f",
    body: "#22262d",
    body_line: "#4a505b",
    halo: "rgb(255 255 255 / 0.92)",
    bumper: "#8d95a3",
    bump: "#ffb000",
    start: "#1d2129",
    estimate: "#0072b2",
    sensor: "#00866a",
    sides: ["rgb(0 158 115 / 0.30)", "rgb(204 121 167 / 0.30)"],
    parts: ["#0072b2", "#d55e00", "#009e73", "#a8488a"],
    link: "#d4530f",
    tint: "rgb(86 180 233 / 0.38)",
    furniture: "#e6d0a8",
    furniture_line: "#86683a",
    carpet: "rgb(204 121 167 / 0.20)",
    carpet_line: "rgb(140 60 105 / 0.34)",
    drop_off: "#d9dce2",
    tread: "#59616e",
    warning: "#d55e00",
    dirt: "#5a3a1c",
    fence: "rgb(0 114 178 / 0.22)",
    fence_line: "#0072b2",
    beams: ["rgb(0 158 115 / 0.20)", "rgb(213 94 0 / 0.20)"],
    person: "#a8488a",
    pet: "#00785a",
    select: "#0b5fff",
    text: "#565e6c",
    passes: [[0x7f, 0x93, 0xb6], [0xa3, 0xa0, 0x98], [0xb9, 0xae, 0x80], [0xd6, 0xc6, 0x72], [0xfe, 0xe8, 0x38]],
};

/// Colours on a dark background.
const DARK: Palette = Palette {
    outside: "#14171b",
    floor: "#332d26",
    unreachable: "rgb(0 0 0 / 0.30)",
    hatch: "rgb(200 190 170 / 0.16)",
    wall: "#3b424c",
    wall_line: "#8a93a2",
    unknown: "#1e2228",
    grid: "rgb(255 245 225 / 0.08)",
    planned: "rgb(235 238 245 / 0.34)",
    preview: "rgb(235 238 245 / 0.75)",
    accent: "#ff8f4f",
    body: "#e8eaee",
    body_line: "#b4bac4",
    halo: "rgb(10 12 15 / 0.75)",
    bumper: "#7d8592",
    bump: "#ffb000",
    start: "#e9ebef",
    estimate: "#56b4e9",
    sensor: "#2fd6ad",
    sides: ["rgb(0 190 140 / 0.30)", "rgb(220 120 180 / 0.30)"],
    parts: ["#56b4e9", "#e69f00", "#2fd6ad", "#dc8cc0"],
    link: "#ff8f4f",
    tint: "rgb(86 180 233 / 0.30)",
    furniture: "#5b4a31",
    furniture_line: "#c0a06a",
    carpet: "rgb(204 121 167 / 0.20)",
    carpet_line: "rgb(226 160 196 / 0.34)",
    drop_off: "#4a515c",
    tread: "#0f1216",
    warning: "#ff7a1a",
    dirt: "#d9b38c",
    fence: "rgb(86 180 233 / 0.24)",
    fence_line: "#56b4e9",
    beams: ["rgb(0 190 140 / 0.22)", "rgb(255 122 26 / 0.22)"],
    person: "#dc8cc0",
    pet: "#2fbf95",
    select: "#7db1ff",
    text: "#a3abb8",
    passes: [[0x3f, 0x53, 0x80], [0x62, 0x68, 0x75], [0x92, 0x8b, 0x74], [0xc8, 0xb6, 0x60], [0xfe, 0xe8, 0x38]],
};

impl Palette {
    /// The colours for a dark or light background.
    pub fn of(dark: bool) -> &'static Self {
        if dark { &DARK } else { &LIGHT }
    }

    /// Colour (red, green, blue, opacity) of floor by the number of passes over it; none at all for 0.
    pub fn visits(&self) -> [[u8; 4]; 256] {
        let mut table = [[0; 4]; 256];
        for (passes, colour) in table.iter_mut().enumerate().skip(1) {
            let [red, green, blue] = self.passes[passes.min(self.passes.len()) - 1];
            *colour = [red, green, blue, 255];
        }
        table
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance as WCAG defines it.
    fn luminance(rgb: [u8; 3]) -> f64 {
        let [r, g, b] = rgb.map(|c| {
            let c = f64::from(c) / 255.0;
            if c <= 0.040_45 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        });
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }

    #[test]
    fn more_passes_are_lighter_and_never_look_unswept() {
        for palette in [&LIGHT, &DARK] {
            assert!(palette.passes.windows(2).all(|w| luminance(w[0]) < luminance(w[1]) + 0.02), "{palette:?}");
            assert_eq!(palette.visits()[0][3], 0);
            assert_eq!(palette.visits()[255], palette.visits()[5]);
        }
    }

    #[test]
    fn the_legend_of_a_film_shows_its_colours() {
        let css = include_str!("../../../www/explore/film.css");
        let parts = LIGHT.parts.into_iter().zip(DARK.parts);
        let others = [(LIGHT.preview, DARK.preview), (LIGHT.tint, DARK.tint), (LIGHT.link, DARK.link)];
        for (light, dark) in parts.chain(others) {
            let colour = format!("light-dark({light}, {dark})");
            assert!(css.contains(&colour), "film.css lacks {colour}");
        }
    }

    #[test]
    fn the_legend_of_the_page_shows_the_same_colours() {
        let css = include_str!("../../../www/style.css");
        for (i, (light, dark)) in LIGHT.passes.iter().zip(DARK.passes).enumerate() {
            let hex = |[r, g, b]: [u8; 3]| format!("#{r:02x}{g:02x}{b:02x}");
            let line = format!("--pass-{}: light-dark({}, {});", i + 1, hex(*light), hex(dark));
            assert!(css.contains(&line), "style.css lacks {line}");
        }
    }
}
