//! Infrared characters (packets 17, 52 and 53): what remote controls, docks and virtual walls send.

use core::fmt;

/// Source of a character (Roomba 500 and Create 2 specifications).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum InfraredCharacter {
    /// No character. Robots before the 500 said 255 instead, which is [`Self::Other`] here.
    None,
    /// A key of a remote control, 129 to 143.
    Remote(&'static str),
    /// Beams of a dock, of the 600 series (160 to 173) or older (240 to 254).
    Dock(DockBeams),
    /// A virtual wall (162).
    VirtualWall,
    /// A virtual wall with the lighthouse function: 0LLLL0BB.
    AutoWall {
        /// 1 to 10; 11 if it isn't bound to a robot.
        id: u8,
        /// 0 fence, 1 force field, 2 green beam, 3 red beam.
        beam: u8,
    },
    /// A number without a meaning.
    Other(u8),
}

/// Beams that a dock sends. For a robot that faces it, the green one is on the left and the red one on the right. With none
/// it is the number that is reserved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct DockBeams {
    /// All around, near the dock.
    pub force_field: bool,
    /// The left half of the approach.
    pub green: bool,
    /// The right half of the approach.
    pub red: bool,
}

/// Keys of remote controls by their characters, from 129.
const KEYS: [&str; 15] = [
    "left",
    "forward",
    "right",
    "spot",
    "max",
    "small",
    "medium",
    "large/clean",
    "stop",
    "power",
    "arc left",
    "arc right",
    "stop",
    "download",
    "seek dock",
];

impl InfraredCharacter {
    /// The source of a character.
    ///
    /// ```
    /// use roomba_oi::{DockBeams, InfraredCharacter};
    /// let all = InfraredCharacter::Dock(DockBeams { force_field: true, green: true, red: true });
    /// assert_eq!((InfraredCharacter::of(173), InfraredCharacter::of(254)), (all, all));
    /// assert_eq!(InfraredCharacter::of(139).to_string(), "remote control: arc left");
    /// ```
    pub fn of(character: u8) -> Self {
        let has = |bit: u8| character & bit != 0;
        match character {
            0 => Self::None,
            162 => Self::VirtualWall,
            160 | 161 | 164 | 165 | 168 | 169 | 172 | 173 => {
                Self::Dock(DockBeams { force_field: has(1), green: has(4), red: has(8) })
            }
            240 | 242 | 244 | 246 | 248 | 250 | 252 | 254 => {
                Self::Dock(DockBeams { force_field: has(2), green: has(4), red: has(8) })
            }
            8..=91 if !has(4) => Self::AutoWall { id: character >> 3, beam: character & 3 },
            other => match other.checked_sub(129).and_then(|key| KEYS.get(usize::from(key))) {
                Some(key) => Self::Remote(key),
                None => Self::Other(other),
            },
        }
    }
}

/// As it is shown beside the number.
impl fmt::Display for InfraredCharacter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::None => f.write_str("nothing"),
            Self::Remote(key) => write!(f, "remote control: {key}"),
            Self::Dock(beams) => {
                f.write_str("dock")?;
                let names = [(beams.force_field, "force field"), (beams.green, "green"), (beams.red, "red")];
                let mut between = ": ";
                for (_, name) in names.into_iter().filter(|&(seen, _)| seen) {
                    write!(f, "{between}{name}")?;
                    between = ", ";
                }
                Ok(())
            }
            Self::VirtualWall => f.write_str("virtual wall"),
            Self::AutoWall { id, beam } => {
                let beam = ["fence", "force field", "green", "red"].get(usize::from(beam)).unwrap_or(&"");
                write!(f, "auto-on virtual wall {id}: {beam}")
            }
            Self::Other(byte) => write!(f, "unknown, {byte}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn characters_of_the_specification() {
        let name = |character| InfraredCharacter::of(character).to_string();
        assert_eq!((name(0).as_str(), name(162).as_str()), ("nothing", "virtual wall"));
        assert_eq!((name(129).as_str(), name(143).as_str()), ("remote control: left", "remote control: seek dock"));
        assert_eq!((name(160).as_str(), name(165).as_str()), ("dock", "dock: force field, green"));
        assert_eq!((name(242).as_str(), name(252).as_str()), ("dock: force field", "dock: green, red"));
        assert_eq!(InfraredCharacter::of(0b0101_1001), InfraredCharacter::AutoWall { id: 11, beam: 1 });
        assert_eq!((name(128).as_str(), name(144).as_str()), ("unknown, 128", "unknown, 144"));
        assert_eq!((name(163).as_str(), name(0b0000_1100).as_str()), ("unknown, 163", "unknown, 12"));
    }
}
