//! Commands: data and encoding.
//!
//! Any complete bytes are decoded to a [`Command`], even with values out of range, as the emulator decides on their
//! effect and the console shows them. They are never *written*: [`Command::encode`] refuses what [`Command::check`]
//! refuses.

use super::{
    bits::{Buttons, Lamps, Motors, ScheduleLamps, Weekdays},
    limits::CommandRefusal,
    opcode::Opcode,
};
use thiserror::Error;

/// A note of a song: MIDI number (69 is A4, 440 Hz) and duration in 1/64 s. Numbers other than 31 to 127 are rests; the
/// specification's table of frequencies ends at 107.
pub type Note = [u8; 2];

/// Hour, 0 to 23, and minute, 0 to 59.
pub type Time = [u8; 2];

/// Longest command that can be written: a stream of 255 packets.
pub const MAX_WRITTEN: usize = 257;

/// Longest command that can arrive: a song that claims 255 notes.
pub const MAX_RECEIVED: usize = 513;

/// A command with its data. Ranges are those that [`Self::check`](Command::check) holds them to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Command<'a> {
    /// Restarts the robot (7).
    Reset,
    /// Starts the interface (128).
    Start,
    /// Changes the baud rate (129).
    Baud {
        /// 0 to 11: see [`BAUD_RATES`].
        code: u8,
    },
    /// The old name of Safe (130).
    Control,
    /// Goes to Safe (131).
    Safe,
    /// Goes to Full (132).
    Full,
    /// Goes to sleep (133).
    Power,
    /// Cleans a spot (134).
    Spot,
    /// Cleans (135).
    Clean,
    /// Cleans until the battery is empty (136).
    Max,
    /// Drives along an arc (137).
    Drive {
        /// Mean of both wheels, -500 to 500 mm/s.
        velocity: i16,
        /// -2000 to 2000 mm, positive to the left; 0x8000 and 0x7FFF straight on, 1 and -1 on the spot: see
        /// [`WheelSpeeds::of_drive`](super::motion::WheelSpeeds::of_drive).
        radius: i16,
    },
    /// Switches brushes and vacuum (138).
    Motors(Motors),
    /// Lights around the Clean button (139).
    Leds {
        /// Those that are on or off.
        lamps: Lamps,
        /// Colour of the Clean button, 0 green to 255 red.
        colour: u8,
        /// Its brightness, 0 to 255.
        intensity: u8,
    },
    /// Stores a song (140).
    Song {
        /// 0 to 3.
        number: u8,
        /// 1 to 16 notes.
        notes: &'a [Note],
    },
    /// Plays a stored song (141).
    Play {
        /// 0 to 3.
        number: u8,
    },
    /// Requests one packet or group (142).
    SensorReadings {
        /// 0 to 58, 100, 101, 106 or 107.
        packet: u8,
    },
    /// Looks for the dock (143).
    SeekDock,
    /// Brushes and vacuum, duty cycles in 1/128 (144).
    PwmMotors {
        /// Main brush, -127 to 127; inward positive.
        main_brush: i8,
        /// Side brush, -127 to 127; counter-clockwise positive.
        side_brush: i8,
        /// Vacuum, 0 to 127.
        vacuum: u8,
    },
    /// Wheel speeds (145).
    DriveDirect {
        /// -500 to 500 mm/s.
        right: i16,
        /// -500 to 500 mm/s.
        left: i16,
    },
    /// Duty cycles of the wheels in 1/255 (146).
    DrivePwm {
        /// -255 to 255.
        right: i16,
        /// -255 to 255.
        left: i16,
    },
    /// Asks for a frame with these packets every 15 ms (148). One driver stops the stream with an empty list, whose
    /// effect isn't documented.
    Stream {
        /// Ids as in Sensors.
        packets: &'a [u8],
    },
    /// Requests several packets at once (149).
    QueryList {
        /// Ids as in Sensors.
        packets: &'a [u8],
    },
    /// Pauses the stream, or lets it go on (150).
    PauseResume {
        /// 0 pauses, 1 resumes.
        state: u8,
    },
    /// Lights of the schedule display (162).
    SchedulingLeds {
        /// Of the weekdays.
        weekdays: Weekdays,
        /// Of the rest.
        lamps: ScheduleLamps,
    },
    /// Segments of the four digits, from left to right, bits 0 to 6 for A to G (163). It has no effect on the 500 and
    /// 600 series: a known bug of their firmware.
    DigitsRaw {
        /// 0 to 127 each.
        segments: [u8; 4],
    },
    /// Characters on the four digits, from left to right (164).
    DigitsAscii {
        /// 32 to 126 each.
        text: [u8; 4],
    },
    /// Presses buttons (165).
    Buttons(Buttons),
    /// Sets the weekly schedule (167).
    Schedule {
        /// Days to clean on; none switches it off.
        days: Weekdays,
        /// When, from Sunday to Saturday.
        times: [Time; 7],
    },
    /// Sets the clock (168).
    DayTime {
        /// 0 Sunday to 6 Saturday.
        day: u8,
        /// Hour and minute.
        time: Time,
    },
    /// Ends the interface (173).
    Stop,
}

/// Baud rates, by the code of opcode 129.
pub const BAUD_RATES: [u32; 12] = [300, 600, 1200, 2400, 4800, 9600, 14_400, 19_200, 28_800, 38_400, 57_600, 115_200];

/// Why bytes are not a command.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum ParseError {
    /// No robot of the 500 or 600 series knows this opcode.
    #[error("{0} isn't an opcode")]
    Unknown(u8),
    /// The data bytes are not all there.
    #[error("{0} needs more data bytes")]
    Incomplete(Opcode),
    /// There is nothing.
    #[error("a command needs at least one byte")]
    Empty,
}

impl<'a> Command<'a> {
    /// The command at the start of `bytes`; what follows it is not looked at.
    pub fn parse(bytes: &'a [u8]) -> Result<Self, ParseError> {
        let &[first, ref rest @ ..] = bytes else { return Err(ParseError::Empty) };
        let opcode = Opcode::from_byte(first).ok_or(ParseError::Unknown(first))?;
        Self::from_data(opcode, rest).ok_or(ParseError::Incomplete(opcode))
    }

    fn from_data(opcode: Opcode, data: &'a [u8]) -> Option<Self> {
        Some(match opcode {
            Opcode::Reset => Self::Reset,
            Opcode::Start => Self::Start,
            Opcode::Baud => Self::Baud { code: *data.first()? },
            Opcode::Control => Self::Control,
            Opcode::Safe => Self::Safe,
            Opcode::Full => Self::Full,
            Opcode::Power => Self::Power,
            Opcode::Spot => Self::Spot,
            Opcode::Clean => Self::Clean,
            Opcode::Max => Self::Max,
            Opcode::Drive => {
                let [velocity, radius] = two_words(data)?;
                Self::Drive { velocity, radius }
            }
            Opcode::Motors => Self::Motors(Motors::from_byte(*data.first()?)),
            Opcode::Leds => {
                let &[lamps, colour, intensity] = data.first_chunk()?;
                Self::Leds { lamps: Lamps::from_byte(lamps), colour, intensity }
            }
            Opcode::Song => {
                let &[number, count, ref rest @ ..] = data else { return None };
                Self::Song { number, notes: rest.as_chunks().0.get(..usize::from(count))? }
            }
            Opcode::Play => Self::Play { number: *data.first()? },
            Opcode::SensorReadings => Self::SensorReadings { packet: *data.first()? },
            Opcode::SeekDock => Self::SeekDock,
            Opcode::PwmMotors => {
                let &[main_brush, side_brush, vacuum] = data.first_chunk()?;
                Self::PwmMotors { main_brush: main_brush.cast_signed(), side_brush: side_brush.cast_signed(), vacuum }
            }
            Opcode::DriveDirect => {
                let [right, left] = two_words(data)?;
                Self::DriveDirect { right, left }
            }
            Opcode::DrivePwm => {
                let [right, left] = two_words(data)?;
                Self::DrivePwm { right, left }
            }
            Opcode::Stream => Self::Stream { packets: counted(data)? },
            Opcode::QueryList => Self::QueryList { packets: counted(data)? },
            Opcode::PauseResume => Self::PauseResume { state: *data.first()? },
            Opcode::SchedulingLeds => {
                let &[weekdays, lamps] = data.first_chunk()?;
                let (weekdays, lamps) = (Weekdays::from_byte(weekdays), ScheduleLamps::from_byte(lamps));
                Self::SchedulingLeds { weekdays, lamps }
            }
            Opcode::DigitsRaw => Self::DigitsRaw { segments: *data.first_chunk()? },
            Opcode::DigitsAscii => Self::DigitsAscii { text: *data.first_chunk()? },
            Opcode::Buttons => Self::Buttons(Buttons::from_byte(*data.first()?)),
            Opcode::Schedule => {
                let &[days, ref rest @ ..] = data else { return None };
                Self::Schedule { days: Weekdays::from_byte(days), times: *rest.as_chunks().0.first_chunk()? }
            }
            Opcode::DayTime => {
                let &[day, hour, minute] = data.first_chunk()?;
                Self::DayTime { day, time: [hour, minute] }
            }
            Opcode::Stop => Self::Stop,
        })
    }

    /// Its opcode.
    pub const fn opcode(&self) -> Opcode {
        match self {
            Self::Reset => Opcode::Reset,
            Self::Start => Opcode::Start,
            Self::Baud { .. } => Opcode::Baud,
            Self::Control => Opcode::Control,
            Self::Safe => Opcode::Safe,
            Self::Full => Opcode::Full,
            Self::Power => Opcode::Power,
            Self::Spot => Opcode::Spot,
            Self::Clean => Opcode::Clean,
            Self::Max => Opcode::Max,
            Self::Drive { .. } => Opcode::Drive,
            Self::Motors(_) => Opcode::Motors,
            Self::Leds { .. } => Opcode::Leds,
            Self::Song { .. } => Opcode::Song,
            Self::Play { .. } => Opcode::Play,
            Self::SensorReadings { .. } => Opcode::SensorReadings,
            Self::SeekDock => Opcode::SeekDock,
            Self::PwmMotors { .. } => Opcode::PwmMotors,
            Self::DriveDirect { .. } => Opcode::DriveDirect,
            Self::DrivePwm { .. } => Opcode::DrivePwm,
            Self::Stream { .. } => Opcode::Stream,
            Self::QueryList { .. } => Opcode::QueryList,
            Self::PauseResume { .. } => Opcode::PauseResume,
            Self::SchedulingLeds { .. } => Opcode::SchedulingLeds,
            Self::DigitsRaw { .. } => Opcode::DigitsRaw,
            Self::DigitsAscii { .. } => Opcode::DigitsAscii,
            Self::Buttons(_) => Opcode::Buttons,
            Self::Schedule { .. } => Opcode::Schedule,
            Self::DayTime { .. } => Opcode::DayTime,
            Self::Stop => Opcode::Stop,
        }
    }

    /// Bytes that it takes on the line, opcode included.
    pub fn encoded_len(&self) -> usize {
        use super::opcode::DataLength;
        match (*self, self.opcode().data_length()) {
            (Self::Song { notes, .. }, _) => 3 + 2 * notes.len(),
            (Self::Stream { packets } | Self::QueryList { packets }, _) => 2 + packets.len(),
            (_, DataLength::Fixed(length)) => 1 + length,
            (_, DataLength::Ids | DataLength::Notes) => MAX_RECEIVED,
        }
    }

    /// Writes it at the start of `buffer`, which [`MAX_WRITTEN`] bytes are always enough for, and returns its bytes.
    ///
    /// ```
    /// use roomba_oi::{Command, MAX_WRITTEN};
    /// let mut buffer = [0; MAX_WRITTEN];
    /// let drive = Command::Drive { velocity: -200, radius: 500 };
    /// assert_eq!(drive.encode(&mut buffer), Ok(&[137, 255, 56, 1, 244][..]));
    /// ```
    pub fn encode<'b>(&self, buffer: &'b mut [u8]) -> Result<&'b [u8], CommandRefusal> {
        self.check()?;
        let (needed, got) = (self.encoded_len(), buffer.len());
        let Some(out) = buffer.get_mut(..needed) else { return Err(CommandRefusal::BufferTooSmall { needed, got }) };
        if let [first, data @ ..] = &mut *out {
            *first = self.opcode() as u8;
            self.write_data(data);
        }
        Ok(out)
    }

    fn write_data(&self, out: &mut [u8]) {
        match *self {
            Self::Baud { code: byte }
            | Self::Play { number: byte }
            | Self::SensorReadings { packet: byte }
            | Self::PauseResume { state: byte } => put(out, [byte]),
            Self::Motors(motors) => put(out, [motors.byte()]),
            Self::Buttons(buttons) => put(out, [buttons.byte()]),
            Self::Drive { velocity: first, radius: second }
            | Self::DriveDirect { right: first, left: second }
            | Self::DrivePwm { right: first, left: second } => {
                put(out, first.to_be_bytes().into_iter().chain(second.to_be_bytes()));
            }
            Self::Leds { lamps, colour, intensity } => put(out, [lamps.byte(), colour, intensity]),
            Self::Song { number, notes } => {
                put(out, [number, notes.len() as u8].into_iter().chain(notes.as_flattened().iter().copied()));
            }
            Self::PwmMotors { main_brush, side_brush, vacuum } => {
                put(out, [main_brush.cast_unsigned(), side_brush.cast_unsigned(), vacuum]);
            }
            Self::Stream { packets } | Self::QueryList { packets } => {
                put(out, [packets.len() as u8].into_iter().chain(packets.iter().copied()));
            }
            Self::SchedulingLeds { weekdays, lamps } => put(out, [weekdays.byte(), lamps.byte()]),
            Self::DigitsRaw { segments: bytes } | Self::DigitsAscii { text: bytes } => put(out, bytes),
            Self::Schedule { days, times } => {
                put(out, [days.byte()].into_iter().chain(times.as_flattened().iter().copied()));
            }
            Self::DayTime { day, time: [hour, minute] } => put(out, [day, hour, minute]),
            Self::Reset
            | Self::Start
            | Self::Control
            | Self::Safe
            | Self::Full
            | Self::Power
            | Self::Spot
            | Self::Clean
            | Self::Max
            | Self::SeekDock
            | Self::Stop => {}
        }
    }
}

fn put(out: &mut [u8], bytes: impl IntoIterator<Item = u8>) {
    for (to, from) in out.iter_mut().zip(bytes) {
        *to = from;
    }
}

/// Two 16-bit values, high bytes first.
fn two_words(data: &[u8]) -> Option<[i16; 2]> {
    let &[a, b, c, d] = data.first_chunk()?;
    Some([i16::from_be_bytes([a, b]), i16::from_be_bytes([c, d])])
}

/// A count and that many bytes.
fn counted(data: &[u8]) -> Option<&[u8]> {
    let &[count, ref rest @ ..] = data else { return None };
    rest.get(..usize::from(count))
}
