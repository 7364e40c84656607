//! Plain text from robots: boot banners, the charging log, sleep messages.
//!
//! It comes on the line of the packets, unasked: when the robot boots or wakes up, and once a second while it charges.

use core::fmt;

/// Longest line that is handed out in one piece; those known have up to 100 characters.
pub const MAX_LINE: usize = 160;

/// Printable characters that noise must leave in a row to be handed out as a piece of text.
const SHORTEST_PIECE: usize = 4;

/// A line that the robot wrote.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Text<'a> {
    /// Without its end of line; never empty.
    pub line: &'a str,
    /// Whether an end of line followed. Otherwise it is a piece: noise followed, or it is the first part of a long line.
    pub ended: bool,
}

/// Puts lines together.
#[derive(Debug, Clone)]
pub(super) struct LineCollector {
    bytes: [u8; MAX_LINE],
    length: usize,
}

impl Default for LineCollector {
    fn default() -> Self {
        Self { bytes: [0; MAX_LINE], length: 0 }
    }
}

impl LineCollector {
    /// Takes a byte from outside of frames; how many bytes turned out to be noise.
    pub(super) fn push(&mut self, byte: u8, sink: &mut impl FnMut(Text<'_>)) -> u64 {
        match byte {
            b'\n' | b'\r' => self.finish(true, sink),
            b' '..=b'~' | b'\t' => {
                let noise = if self.length == MAX_LINE { self.finish(false, sink) } else { 0 };
                if let Some(free) = self.bytes.get_mut(self.length) {
                    *free = byte;
                    self.length += 1;
                }
                noise
            }
            _ => 1 + self.finish(false, sink),
        }
    }

    /// Returns the text so far, with the number of bytes that are noise.
    pub(super) fn finish(&mut self, ended: bool, sink: &mut impl FnMut(Text<'_>)) -> u64 {
        let length = core::mem::take(&mut self.length);
        let line = self.bytes.get(..length).and_then(|bytes| str::from_utf8(bytes).ok()).unwrap_or_default();
        if line.is_empty() || (!ended && length < SHORTEST_PIECE) {
            return length as u64;
        }
        sink(Text { line, ended });
        0
    }
}

/// Meaning of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Said {
    /// The log of a robot that charges.
    Charging(ChargingLog),
    /// Which firmware boots.
    Firmware(Firmware),
    /// It boots.
    Booting,
    /// It woke up, or reports how long it slept.
    Woke,
    /// Something else.
    Other,
}

impl Said {
    /// The meaning of a line. Lines lose characters on bad cables; unrecognised ones are [`Self::Other`].
    ///
    /// ```
    /// use roomba_oi::Said;
    /// let line = "bat:   min 0  sec 10  mV 5930  mA 302  tenths-deg-C 182  mAH 0  state 6  mode 8";
    /// let Said::Charging(log) = Said::of(line) else { panic!() };
    /// assert_eq!((log.voltage_mv, log.current_ma, log.temperature_tenths_c), (5930, 302, 182));
    /// ```
    pub fn of(line: &str) -> Self {
        const BOOTING: [&str; 5] = ["Soft reset!", "bl-start", "STR730", "str730", "Roomba by iRobot!"];
        if let Some(log) = ChargingLog::parse(line) {
            Self::Charging(log)
        } else if let Some(firmware) = Firmware::parse(line) {
            Self::Firmware(firmware)
        } else if BOOTING.iter().any(|start| line.trim_start().starts_with(start)) {
            Self::Booting
        } else if line.contains("key-wakeup") || line.contains("slept for") {
            Self::Woke
        } else {
            Self::Other
        }
    }
}

/// A line of the charging log: one a second.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ChargingLog {
    /// Minutes since it began.
    pub minutes: i32,
    /// Seconds of that minute.
    pub seconds: i32,
    /// Voltage of the battery, mV.
    pub voltage_mv: i32,
    /// Current into the battery, mA.
    pub current_ma: i32,
    /// Temperature of the battery, tenths of a degree Celsius.
    pub temperature_tenths_c: i32,
    /// Charge of the battery, mAh.
    pub charge_mah: i32,
    /// A state that isn't documented; not that of packet 21.
    pub state: i32,
    /// A mode that isn't documented; not that of packet 35.
    pub mode: i32,
}

impl ChargingLog {
    /// The log in that line; `None` if one of its values is missing.
    pub fn parse(line: &str) -> Option<Self> {
        let mut words = line.trim_start().strip_prefix("bat:")?.split_ascii_whitespace();
        let mut next = |name: &str| (words.next()? == name).then_some(()).and_then(|()| words.next()?.parse().ok());
        Some(Self {
            minutes: next("min")?,
            seconds: next("sec")?,
            voltage_mv: next("mV")?,
            current_ma: next("mA")?,
            temperature_tenths_c: next("tenths-deg-C")?,
            charge_mah: next("mAH")?,
            state: next("state")?,
            mode: next("mode")?,
        })
    }
}

/// As the robot writes it.
impl fmt::Display for ChargingLog {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { minutes, seconds, voltage_mv, current_ma, temperature_tenths_c, charge_mah, state, mode } = self;
        write!(f, "bat:   min {minutes}  sec {seconds}  mV {voltage_mv}  mA {current_ma}  ")?;
        write!(f, "tenths-deg-C {temperature_tenths_c}  mAH {charge_mah}  state {state}  mode {mode}")
    }
}

/// A release of the firmware, from the boot banner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Firmware {
    /// Whether the robot has the newer processor, an STM32; its releases are numbered apart.
    pub stm32: bool,
    /// Such as 3.5.4.
    pub version: [u16; 3],
}

impl Firmware {
    /// The release that a line such as `r3_robot/tags/release-3.5.4` names.
    ///
    /// ```
    /// use roomba_oi::Firmware;
    /// let firmware = Firmware::parse("r3-robot/tags/release-stm32-3.7.1:6118 CLEAN").unwrap();
    /// assert_eq!((firmware.stm32, firmware.version), (true, [3, 7, 1]));
    /// assert!(!firmware.has_angle_error());
    /// ```
    pub fn parse(line: &str) -> Option<Self> {
        let at = ["r3_robot/tags/", "r3-robot/tags/", "r3_orion/tags/", "r3-orion/tags/"]
            .iter()
            .find_map(|path| line.split_once(path))?
            .1;
        let release = at.split_once("release-")?.1;
        let (stm32, numbers) = release.strip_prefix("stm32-").map_or((false, release), |numbers| (true, numbers));
        let mut numbers = numbers.splitn(3, '.');
        let mut next = || {
            let number = numbers.next()?;
            let digits = number.find(|c: char| !c.is_ascii_digit()).unwrap_or(number.len());
            number.get(..digits)?.parse().ok()
        };
        Some(Self { stm32, version: [next()?, next()?, next()?] })
    }

    /// Whether packet 20 shows too small a turn: see [`ANGLE_ERROR`](super::motion::ANGLE_ERROR).
    pub fn has_angle_error(&self) -> bool {
        self.version <= [3, 4, 0]
    }

    /// Whether packets 19 and 40 can't be trusted.
    pub fn has_distance_error(&self) -> bool {
        self.version < [3, 3, 0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_longer_than_the_memory_come_in_pieces() {
        let mut collector = LineCollector::default();
        let mut pieces = Vec::new();
        for byte in [b'x'; 200].into_iter().chain(*b"\r\n") {
            assert_eq!(collector.push(byte, &mut |text| pieces.push((text.line.len(), text.ended))), 0);
        }
        assert_eq!(pieces, [(160, false), (40, true)]);
    }

    #[test]
    fn a_few_printable_bytes_in_noise_are_noise() {
        let mut collector = LineCollector::default();
        let mut pieces = Vec::new();
        let mut noise = 0;
        for byte in *b"abc\xFFabcd\xFEok\n" {
            noise += collector.push(byte, &mut |text| pieces.push((text.line.to_string(), text.ended)));
        }
        assert_eq!((noise, pieces), (5, vec![("abcd".into(), false), ("ok".into(), true)]));
    }

    #[test]
    fn lines_are_recognised() {
        assert_eq!(Said::of("Roomba by iRobot!"), Said::Booting);
        assert_eq!(Said::of("key-wakeup"), Said::Woke);
        assert_eq!(Said::of("bat:   min 0  sec"), Said::Other);
        let log = ChargingLog { minutes: 3, current_ma: -20, ..ChargingLog::default() };
        assert_eq!(Said::of(&log.to_string()), Said::Charging(log));
        let old = Firmware { stm32: false, version: [3, 2, 6] };
        assert_eq!(Said::of("r3_robot/tags/release-3.2.6:4975 CLEAN"), Said::Firmware(old));
        assert!(old.has_angle_error() && old.has_distance_error());
        assert_eq!(Firmware::parse("r3_robot/tags/release-3.2"), None);
    }
}
