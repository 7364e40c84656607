//! Commands: worked examples of the specification, and round trips.

use proptest::{collection::vec, prelude::*};
use roomba_oi::{
    BAUD_RATES, Buttons, Command, CommandDecoder, Lamps, MAX_WRITTEN, Mode, Motors, Opcode, PacketId, ScheduleLamps,
    Weekdays,
};

/// Worked examples (Create 2 specification of 2016), extremes, and one of each opcode.
pub const EXAMPLES: &[(Command<'static>, &[u8])] = &[
    (Command::Reset, &[7]),
    (Command::Start, &[128]),
    (Command::Baud { code: 11 }, &[129, 11]),
    (Command::Control, &[130]),
    (Command::Safe, &[131]),
    (Command::Full, &[132]),
    (Command::Power, &[133]),
    (Command::Spot, &[134]),
    (Command::Clean, &[135]),
    (Command::Max, &[136]),
    (Command::Drive { velocity: -200, radius: 500 }, &[137, 255, 56, 1, 244]),
    (Command::Drive { velocity: 200, radius: i16::MIN }, &[137, 0, 200, 128, 0]),
    (Command::Drive { velocity: 200, radius: i16::MAX }, &[137, 0, 200, 127, 255]),
    (Command::Drive { velocity: 100, radius: -1 }, &[137, 0, 100, 255, 255]),
    (Command::Drive { velocity: 500, radius: -2000 }, &[137, 1, 244, 248, 48]),
    (
        Command::Motors(Motors {
            side_brush: true,
            vacuum: false,
            main_brush: true,
            side_brush_clockwise: true,
            main_brush_outward: false,
        }),
        &[138, 13],
    ),
    (
        Command::Leds {
            lamps: Lamps { debris: false, spot: false, dock: true, check_robot: false },
            colour: 0,
            intensity: 128,
        },
        &[139, 4, 0, 128],
    ),
    (Command::Song { number: 2, notes: &[[60, 16], [64, 16]] }, &[140, 2, 2, 60, 16, 64, 16]),
    (Command::Play { number: 0 }, &[141, 0]),
    (Command::SensorReadings { packet: 100 }, &[142, 100]),
    (Command::SeekDock, &[143]),
    (Command::PwmMotors { main_brush: 32, side_brush: -127, vacuum: 127 }, &[144, 32, 129, 127]),
    (Command::DriveDirect { right: 200, left: -200 }, &[145, 0, 200, 255, 56]),
    (Command::DriveDirect { right: -1, left: 1 }, &[145, 255, 255, 0, 1]),
    (Command::DrivePwm { right: 255, left: -255 }, &[146, 0, 255, 255, 1]),
    (Command::Stream { packets: &[29, 13] }, &[148, 2, 29, 13]),
    (Command::QueryList { packets: &[7, 13] }, &[149, 2, 7, 13]),
    (Command::PauseResume { state: 1 }, &[150, 1]),
    (Command::DigitsRaw { segments: [127; 4] }, &[163, 127, 127, 127, 127]),
    (Command::DigitsAscii { text: *b"ABCD" }, &[164, 65, 66, 67, 68]),
    (Command::DayTime { day: 3, time: [15, 30] }, &[168, 3, 15, 30]),
    (Command::Stop, &[173]),
];

fn decode(bytes: &[u8]) -> Vec<Vec<u8>> {
    let mut decoder = CommandDecoder::default();
    bytes.iter().filter_map(|&byte| Some(decoder.push(byte)?.bytes.to_vec())).collect()
}

#[test]
fn examples_are_written_and_read() {
    let mut buffer = [0; MAX_WRITTEN];
    for (command, bytes) in EXAMPLES {
        assert_eq!(command.encode(&mut buffer), Ok(*bytes));
        assert_eq!(Command::parse(bytes).as_ref(), Ok(command));
    }
}

#[test]
fn schedule_of_the_specification() {
    // Wednesday at 3 PM and Friday at 10:36.
    let bytes = [167, 40, 0, 0, 0, 0, 0, 0, 15, 0, 0, 0, 10, 36, 0, 0];
    let mut times = [[0; 2]; 7];
    (times[3], times[5]) = ([15, 0], [10, 36]);
    let days = Weekdays { wednesday: true, friday: true, ..Weekdays::default() };
    assert_eq!(Command::parse(&bytes), Ok(Command::Schedule { days, times }));
    assert_eq!(Command::Schedule { days, times }.encode(&mut [0; 16]), Ok(&bytes[..]));
}

#[test]
fn a_day_of_commands_on_one_line() {
    let line: Vec<u8> = EXAMPLES.iter().flat_map(|(_, bytes)| bytes.iter().copied()).collect();
    assert_eq!(decode(&line), EXAMPLES.iter().map(|(_, bytes)| bytes.to_vec()).collect::<Vec<_>>());
}

#[test]
fn a_command_waits_for_its_data_for_ever() {
    for (command, bytes) in EXAMPLES {
        let mut decoder = CommandDecoder::default();
        let (last, before) = bytes.split_last().unwrap();
        for (arrived, &byte) in before.iter().enumerate() {
            assert_eq!(decoder.push(byte), None, "{command:?}");
            assert_eq!(decoder.waiting(), Some((command.opcode(), arrived + 1)));
        }
        assert_eq!(decoder.push(*last).map(|received| received.command), Some(Ok(*command)));
        assert_eq!(decoder.waiting(), None);
    }
}

#[test]
fn builders_refuse_and_clamp() {
    let drive = Command::drive(600, -3000);
    assert_eq!(drive.unwrap_err().to_string(), "velocity in mm/s is 600, but must be -500 to 500");
    let wild = Command::Drive { velocity: 600, radius: -3000 };
    assert_eq!(wild.clamped(), Command::Drive { velocity: 500, radius: -2000 });
    let straight = Command::Drive { velocity: i16::MIN, radius: i16::MAX };
    assert_eq!(straight.clamped(), Command::Drive { velocity: -500, radius: i16::MAX });
    let wild = Command::PwmMotors { main_brush: -128, side_brush: -128, vacuum: 255 };
    assert_eq!(wild.clamped(), Command::PwmMotors { main_brush: -127, side_brush: -127, vacuum: 127 });
    assert_eq!(Command::digits("OK"), Ok(Command::DigitsAscii { text: *b"OK  " }));
    assert!(BAUD_RATES.iter().all(|&rate| Command::baud(rate).is_ok()));
    assert!(Command::song(3, &[[69, 32]; 16]).is_ok() && Command::song(3, &[[69, 32]; 17]).is_err());
    assert!(Command::play(4).is_err() && Command::query_list(&[0, 6, 58, 107]).is_ok());
    assert!(Command::Stream { packets: &[7; 256] }.encode(&mut [0; 300]).is_err());
}

/// Commands that a robot can carry out.
fn valid() -> impl Strategy<Value = Vec<u8>> {
    let ids = || {
        let known: Vec<u8> = (0..=255).filter(|&id| PacketId::from_byte(id).is_some()).collect();
        vec(proptest::sample::select(known), 0..40)
    };
    let speed = || -500_i16..=500;
    let bytes = |command: Command| command.encode(&mut [0; MAX_WRITTEN]).unwrap().to_vec();
    prop_oneof![
        proptest::sample::select(EXAMPLES).prop_map(|(_, bytes)| bytes.to_vec()),
        (speed(), -2000_i16..=2000).prop_map(move |(velocity, radius)| bytes(Command::Drive { velocity, radius })),
        (speed(), speed()).prop_map(move |(right, left)| bytes(Command::DriveDirect { right, left })),
        (-255_i16..=255, -255_i16..=255).prop_map(move |(right, left)| bytes(Command::DrivePwm { right, left })),
        (-127_i8..=127, -127_i8..=127, 0_u8..=127).prop_map(move |(main_brush, side_brush, vacuum)| bytes(
            Command::PwmMotors { main_brush, side_brush, vacuum }
        )),
        (0_u8..4, vec(any::<[u8; 2]>(), 1..=16))
            .prop_map(move |(number, notes)| bytes(Command::Song { number, notes: &notes })),
        ids().prop_map(move |packets| bytes(Command::Stream { packets: &packets })),
        ids().prop_map(move |packets| bytes(Command::QueryList { packets: &packets })),
        any::<[u8; 5]>().prop_map(move |[lamps, colour, intensity, days, more]| {
            let lamps = Lamps::from_byte(lamps);
            [
                bytes(Command::Leds { lamps, colour, intensity }),
                bytes(Command::Motors(Motors::from_byte(days))),
                bytes(Command::Buttons(Buttons::from_byte(more))),
                bytes(Command::SchedulingLeds {
                    weekdays: Weekdays::from_byte(days),
                    lamps: ScheduleLamps::from_byte(more),
                }),
            ]
            .concat()
        }),
        (any::<u8>(), proptest::array::uniform7((0_u8..24, 0_u8..60))).prop_map(move |(days, times)| bytes(
            Command::Schedule { days: Weekdays::from_byte(days), times: times.map(|(hour, minute)| [hour, minute]) }
        )),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_written_is_read(commands in vec(valid(), 0..20)) {
        let line = commands.concat();
        let mut decoder = CommandDecoder::default();
        let mut again = Vec::new();
        for &byte in &line {
            if let Some(received) = decoder.push(byte) {
                let command = received.command.unwrap();
                prop_assert_eq!(command.checked(), Ok(command));
                prop_assert_eq!(command.clamped(), command);
                let mut buffer = [0; MAX_WRITTEN];
                prop_assert_eq!(command.encode(&mut buffer), Ok(received.bytes));
                again.extend_from_slice(received.bytes);
            }
        }
        prop_assert_eq!(again, line);
    }

    #[test]
    fn any_bytes_are_commands_or_named(line in vec(any::<u8>(), 0..2000)) {
        let mut decoder = CommandDecoder::default();
        let mut seen = 0;
        for &byte in &line {
            let Some(received) = decoder.push(byte) else { continue };
            seen += received.bytes.len();
            let Ok(command) = received.command else {
                prop_assert_eq!(Opcode::from_byte(byte), None);
                continue;
            };
            prop_assert_eq!(command.encoded_len(), received.bytes.len());
            for mode in Mode::ALL {
                prop_assert_eq!(mode.after_command(command.opcode()).is_some(), command.opcode().allowed_in(mode));
            }
            // Commands that check refuses are refused when written, and vice versa.
            let mut buffer = [0; 1000];
            let written = command.encode(&mut buffer);
            prop_assert_eq!(written.is_ok(), command.check().is_ok());
            if let Ok(written) = written {
                prop_assert_eq!(Command::parse(written), Ok(command));
            }
        }
        let waiting = decoder.waiting().map_or(0, |(_, arrived)| arrived);
        prop_assert_eq!(seen + waiting, line.len());
    }

    #[test]
    fn clamped_motion_is_always_taken(first in any::<i16>(), second in any::<i16>(), bytes in any::<[u8; 3]>()) {
        let [main, side, vacuum] = bytes;
        let pwm = Command::PwmMotors { main_brush: main as i8, side_brush: side as i8, vacuum };
        for command in [
            Command::Drive { velocity: first, radius: second },
            Command::DriveDirect { right: first, left: second },
            Command::DrivePwm { right: first, left: second },
            pwm,
        ] {
            prop_assert_eq!(command.clamped().check(), Ok(()));
        }
    }
}
