//! The text messages between a client and the bridge.

use core::{fmt, str::FromStr};

/// Version of these words; a client that doesn't know it should not drive.
pub const VERSION: u8 = 1;

/// What a client says besides the robot's bytes. Every message of the driver, of either kind, is a sign of life.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ToBridge {
    /// `alive`: a sign of life, to be sent every 50 ms while anything of the robot is on, and once a second otherwise.
    Alive,
    /// `baud 19200`: sets the serial port's rate.
    Baud(u32),
    /// `brc low`, `brc high`: sets the robot's wake-up pin.
    Brc {
        /// Pulled low.
        is_low: bool,
    },
}

/// Text that is none of [`ToBridge`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct UnknownWord;

impl FromStr for ToBridge {
    type Err = UnknownWord;

    fn from_str(text: &str) -> Result<Self, UnknownWord> {
        match text {
            "alive" => Ok(Self::Alive),
            "brc low" => Ok(Self::Brc { is_low: true }),
            "brc high" => Ok(Self::Brc { is_low: false }),
            _ => {
                let baud = text.strip_prefix("baud ").and_then(|baud| baud.parse().ok()).ok_or(UnknownWord)?;
                roomba_oi::BAUD_RATES.contains(&baud).then_some(Self::Baud(baud)).ok_or(UnknownWord)
            }
        }
    }
}

/// What the bridge says besides the robot's bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FromBridge {
    /// `hello roomba-bridge 1`: the first message, with [`VERSION`]. [`Self::Drive`] or [`Self::Watch`] follows.
    Hello,
    /// `drive`: this client drives from now on. The robot has been stopped.
    Drive,
    /// `watch`: another client drives. What this one sends to the robot is dropped.
    Watch,
    /// `halted silent`, for instance: the bridge stopped the wheels.
    Halted(Halted),
    /// `unknown`: the last text message is none of [`ToBridge`].
    Unknown,
}

/// Why the bridge stopped the robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Halted {
    /// The driver wasn't heard of, but may be back.
    Silent,
    /// The driver was disconnected after a longer silence.
    Lost,
    /// The driver has left.
    Left,
    /// The bridge ends.
    Ended,
}

impl fmt::Display for Halted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Silent => "silent",
            Self::Lost => "lost",
            Self::Left => "left",
            Self::Ended => "ended",
        })
    }
}

impl fmt::Display for FromBridge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Hello => write!(f, "hello roomba-bridge {VERSION}"),
            Self::Drive => f.write_str("drive"),
            Self::Watch => f.write_str("watch"),
            Self::Halted(why) => write!(f, "halted {why}"),
            Self::Unknown => f.write_str("unknown"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_clients() {
        assert_eq!("alive".parse(), Ok(ToBridge::Alive));
        assert_eq!("baud 19200".parse(), Ok(ToBridge::Baud(19_200)));
        assert_eq!("brc low".parse(), Ok(ToBridge::Brc { is_low: true }));
        for bad in
            ["", "Alive", "alive ", "baud", "baud 0", "baud 12345", "baud -1", "baud 99999999999", "brc", "brc lower"]
        {
            assert_eq!(bad.parse::<ToBridge>(), Err(UnknownWord), "{bad:?}");
        }
    }

    #[test]
    fn words_of_the_bridge() {
        let words = [FromBridge::Hello, FromBridge::Drive, FromBridge::Watch, FromBridge::Halted(Halted::Silent)];
        assert_eq!(words.map(|word| word.to_string()), ["hello roomba-bridge 1", "drive", "watch", "halted silent"]);
    }
}
