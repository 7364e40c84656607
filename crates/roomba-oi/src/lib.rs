//! The Open Interface of the Roomba 500 and 600 and of the Create 2: commands, sensor packets, streams.
//!
//! For programs that drive such a robot over its serial port, on a computer or a microcontroller, and for emulators of one.
//! Bytes in, bytes out: `no_std`, no allocation, no panic on bad input.
//!
//! - Host: [`Command`] makes bytes, [`StreamParser`] finds sensor frames, [`AnswerReader`] reads the reply to a query, all into
//!   [`Readings`].
//! - Robot: [`CommandDecoder`] reads commands, [`Mode`] has their effects on the mode, [`Readings::write`] and
//!   [`write_frame`] answer.
//!
//! ```
//! use roomba_oi::{Command, Packet, PacketId, Readings, StreamEvent, StreamParser, write_frame};
//!
//! let mut buffer = [0; 8];
//! assert_eq!(Command::DriveDirect { right: 100, left: 100 }.encode(&mut buffer), Ok(&[145, 0, 100, 0, 100][..]));
//!
//! // A frame as a robot streams it, here written by ourselves: voltage (22) and left encoder (43).
//! let packets = [Packet::Voltage, Packet::LeftEncoder].map(PacketId::from);
//! let sent = Readings { voltage_mv: 16_200, left_counts: 451, ..Readings::default() };
//! let mut line = [0; 16];
//! let bytes = write_frame(&packets, &sent, &mut line).unwrap();
//!
//! // Bytes may arrive in any pieces, with noise between frames.
//! let (mut parser, mut readings) = (StreamParser::default(), Readings::default());
//! for piece in [&[7, 255], bytes].concat().chunks(3) {
//!     parser.feed(piece, &mut |event| {
//!         if let StreamEvent::Frame(frame) = event {
//!             frame.apply(&mut readings);
//!         }
//!     });
//! }
//! assert_eq!((readings.voltage_mv, readings.left_counts), (16_200, 451));
//! ```
//!
//! On a microcontroller, with any serial port of `embedded-io` (an ESP32's UART, for instance):
//!
//! ```ignore
//! for command in [Command::Start, Command::Safe, Command::Stream { packets: &[7, 43, 44] }] {
//!     uart.write_all(command.encode(&mut buffer)?)?;
//! }
//! loop {
//!     let count = uart.read(&mut received)?;
//!     parser.feed(&received[..count], &mut |event| if let StreamEvent::Frame(frame) = event { frame.apply(&mut readings); });
//!     let speed = if readings.bumps.bump_left || readings.bumps.bump_right { 0 } else { 100 };
//!     uart.write_all(Command::DriveDirect { right: speed, left: speed }.encode(&mut buffer)?)?;
//! }
//! ```
//!
//! # Where the specification is unclear
//!
//! The source is iRobot's Create 2 Open Interface Specification in its edition of August 2016 ("2016" below). Where it
//! contradicts itself, older editions or measured robots, the choices are:
//!
//! - **Encoders.** Packet 43 is the left one, 44 the right one, as in 2016, in the edition of 2015 and in nearly all drivers;
//!   the Roomba 500 document and a driver that follows it have them the other way round. Only turning a given robot a
//!   little settles it. The values are signed in 2016 and unsigned before: differences modulo 65536 are the same either way
//!   ([`motion::encoder_delta`]).
//! - **Songs.** 2016 says four songs and numbers them 0 to 4, and packet 36 up to 15. Robots take 0 to 3, and so does
//!   [`Command::check`]; packet 36 is accepted up to 15.
//! - **Opcode 163** (segments of the digits) doesn't do what it should on the 500 and 600 series, as 2016 says itself. It is
//!   encoded as described all the same; for text there is 164. There is no packet 163.
//! - **Checksum.** Header included: 2016 and all robots measured. The Roomba 500 document leaves it out of its sum, and its
//!   example ends with 182 instead of 163.
//! - **Example of a stream.** All editions print bytes 2 and 25 as 549, which reads them as hexadecimal; they are decimal,
//!   537, as the example's checksum proves. It also calls packet 29 left; it is front left.
//! - **Packet 35** is one too high on some robots of the 600 series ([`Mode::from_report`]), and never shows Off.
//! - **Packets 17, 52, 53.** No infrared character is 0; 255 was that on robots before the 500.
//! - **Packet 14.** Bit 1 is reserved; drivers exist that take it for the main brush.
//! - **Packet 21** goes up to 6 in the table of 2016, which explains 0 to 5.
//! - **Packets 32 and 33** are one and two bytes: group 4 has 14 and group 6 has 52.
//! - **Battery charge** of a flat battery arrives as a small negative number in a field that 2016 calls unsigned
//!   ([`Readings::charge_left_mah`]).
//! - **Reset (7) in Off** is taken, as are Start and nothing else.
//! - **Not described anywhere**, and decided here: radius 0 drives straight ([`motion::WheelSpeeds::of_drive`]); a cliff while
//!   turning on the spot counts as a tight turn ([`Hazard::of_cliff`]); frames of length 0 are refused ([`FrameError`]).

#![cfg_attr(not(test), no_std)]

mod answer;
mod bits;
mod command;
mod decoder;
mod frame;
mod infrared;
mod limits;
mod mode;
pub mod motion;
mod opcode;
mod packet;
mod readings;
mod stream;
mod text;

pub use answer::{AnswerReader, MAX_ANSWER};
pub use bits::{
    BumpsAndDrops, Buttons, ChargingSources, Lamps, LightBumper, Motors, Overcurrents, ScheduleLamps, Stasis, Weekdays,
};
pub use command::{BAUD_RATES, Command, MAX_RECEIVED, MAX_WRITTEN, Note, ParseError, Time};
pub use decoder::{CommandDecoder, Received};
pub use frame::{
    FRAMING, FrameError, FrameTooLong, HEADER, MAX_FRAME, StreamFrame, frame_size, slot_bytes, write_frame,
};
pub use infrared::{DockBeams, InfraredCharacter};
pub use limits::{CommandRefusal, MAX_MOTOR_PWM, MAX_PWM, SONGS};
pub use mode::{Hazard, Mode, Reaction, SAFETY};
pub use opcode::{DataLength, ModeAfter, Opcode};
pub use packet::{GROUPS, Packet, PacketId, PacketSet, ValueFormat};
pub use readings::{ChargingState, InfraredSeen, Readings};
pub use stream::{StreamCounts, StreamEvent, StreamParser};
pub use text::{ChargingLog, Firmware, MAX_LINE, Said, Text};
