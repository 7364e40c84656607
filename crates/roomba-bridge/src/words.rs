//! The text messages between a client and the bridge.

use core::{fmt, str::FromStr};

/// Version of these words; a client that doesn't know it should not drive.
pub const VERSION: u8 = 2;

/// What a client says besides the robot's bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ToBridge {
    /// `alive 1234`: the answer to [`FromBridge::Beat`], with its number, to be sent at once.
    Alive(u64),
    /// `take 3`: the answer to [`FromBridge::Drive`], with its number. What the client sends from here on goes to the robot.
    Take(u32),
    /// `stop`: stops the robot, whoever drives it and whatever it does. Every client may say it.
    Stop,
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
        let (word, value) = text.split_once(' ').unwrap_or((text, ""));
        match (word, value) {
            ("stop", "") if text == "stop" => Ok(Self::Stop),
            ("alive", number) => number.parse().map(Self::Alive).map_err(|_| UnknownWord),
            ("take", number) => number.parse().map(Self::Take).map_err(|_| UnknownWord),
            ("brc", "low") => Ok(Self::Brc { is_low: true }),
            ("brc", "high") => Ok(Self::Brc { is_low: false }),
            ("baud", rate) => {
                let baud = rate.parse().map_err(|_| UnknownWord)?;
                roomba_oi::BAUD_RATES.contains(&baud).then_some(Self::Baud(baud)).ok_or(UnknownWord)
            }
            _ => Err(UnknownWord),
        }
    }
}

/// What the bridge says besides the robot's bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FromBridge {
    /// `hello roomba-bridge 2`: the first message, with [`VERSION`]. [`Self::Drive`] or [`Self::Watch`] follows.
    Hello,
    /// `drive 3`: this client may drive, once it has answered with [`ToBridge::Take`]. It is said again, with another number,
    /// whenever the bridge has stopped the robot: what was sent before that answer is dropped.
    Drive(u32),
    /// `watch`: another client drives. What this one sends to the robot is dropped.
    Watch,
    /// `beat 1234`: to be answered at once with [`ToBridge::Alive`]. The numbers grow.
    Beat(u64),
    /// `halted silent`, for instance: the bridge stopped the robot, or did not let it start.
    Halted(Halted),
    /// `unknown`: the last text message is none of [`ToBridge`].
    Unknown,
}

/// Why the bridge stopped the robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Halted {
    /// The driver wasn't heard of in time, but may be back. Only the wheels were stopped.
    Silent,
    /// The driver was disconnected after a longer silence.
    Lost,
    /// The driver has left.
    Left,
    /// A command of the driver came too late to be carried out.
    Late,
    /// The driver sends more than the serial line can carry.
    Flooded,
    /// A client said [`ToBridge::Stop`].
    Stopped,
    /// The bridge ends.
    Ended,
}

impl fmt::Display for Halted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Silent => "silent",
            Self::Lost => "lost",
            Self::Left => "left",
            Self::Late => "late",
            Self::Flooded => "flooded",
            Self::Stopped => "stopped",
            Self::Ended => "ended",
        })
    }
}

impl fmt::Display for FromBridge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Hello => write!(f, "hello roomba-bridge {VERSION}"),
            Self::Drive(number) => write!(f, "drive {number}"),
            Self::Watch => f.write_str("watch"),
            Self::Beat(number) => write!(f, "beat {number}"),
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
        assert_eq!("alive 1234".parse(), Ok(ToBridge::Alive(1234)));
        assert_eq!("take 3".parse(), Ok(ToBridge::Take(3)));
        assert_eq!("stop".parse(), Ok(ToBridge::Stop));
        assert_eq!("baud 19200".parse(), Ok(ToBridge::Baud(19_200)));
        assert_eq!("brc low".parse(), Ok(ToBridge::Brc { is_low: true }));
        for bad in [
            "",
            "alive",
            "alive ",
            "Alive 1",
            "alive -1",
            "alive 1 2",
            "alive 99999999999999999999",
            "take",
            "take 4294967296",
            "stop ",
            "stop 1",
            "baud",
            "baud 0",
            "baud 12345",
            "baud -1",
            "baud 99999999999",
            "brc",
            "brc lower",
        ] {
            assert_eq!(bad.parse::<ToBridge>(), Err(UnknownWord), "{bad:?}");
        }
    }

    #[test]
    fn words_of_the_bridge() {
        let words = [FromBridge::Hello, FromBridge::Drive(3), FromBridge::Watch, FromBridge::Beat(40)];
        assert_eq!(words.map(|word| word.to_string()), ["hello roomba-bridge 2", "drive 3", "watch", "beat 40"]);
        assert_eq!(FromBridge::Halted(Halted::Silent).to_string(), "halted silent");
    }
}
