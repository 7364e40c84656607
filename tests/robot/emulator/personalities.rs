//! What each personality does differently, as a host sees it.

use super::support::{BAUD, Lab, plan, setup};
use robovac_link::emulator::{Emulator, PERSONALITIES, personality};
use robovac_sim::Conditions;
use roomba_oi::{Buttons, Command, Mode, Said, StreamEvent, StreamParser};

#[test]
fn ids_are_unique_and_everybody_is_introduced() {
    for (index, who) in PERSONALITIES.iter().enumerate() {
        assert_eq!(PERSONALITIES.iter().position(|p| p.id == who.id), Some(index));
        assert!(!who.title.is_empty() && who.summary.ends_with('.'), "{}", who.id);
        assert_eq!(personality(who.id), Some(who));
    }
    assert_eq!((PERSONALITIES[0].id, personality("nobody")), ("model", None));
}

#[test]
fn all_are_the_same_again_with_the_same_seed_however_time_is_cut() {
    for who in PERSONALITIES {
        let session = |seed: u64, pieces: u32| {
            let mut robot = Emulator::new(&setup(plan(), Conditions::default(), seed), who);
            let mut heard = Vec::new();
            for bytes in [&[128, 132, 145, 0, 100, 0, 200][..], &[148, 3, 7, 43, 44], &[142, 35], &[7]] {
                robot.receive(bytes, BAUD);
                for _ in 0..pieces {
                    robot.advance(3.0 / f64::from(pieces));
                    robot.transmit(BAUD, &mut heard);
                }
            }
            (heard, robot.pose())
        };
        assert_eq!(session(1, 7), session(1, 7), "{}", who.id);
        assert_eq!(session(1, 1), session(1, 300), "{}", who.id);
    }
}

#[test]
fn sleepers_are_woken_by_brc_if_the_wire_is_there() {
    for (id, has_wire) in [("asleep", true), ("no_brc", false)] {
        let mut lab = Lab::new(id);
        lab.send(&[128]);
        assert_eq!((lab.ask(35), lab.robot.is_awake()), (vec![], false));
        lab.robot.set_brc(true);
        lab.wait(1.0);
        lab.robot.set_brc(false);
        lab.wait(0.2);
        assert_eq!(lab.robot.is_awake(), has_wire, "{id}");
        lab.robot.press(Buttons::from_byte(1));
        lab.wait(0.2);
        assert!(lab.robot.is_awake());
        assert_eq!(lab.robot.runs_builtin_program(), has_wire, "the one that was awake cleans");
        lab.send(&[128]);
        assert_eq!(lab.ask(35), [1]);
    }
}

#[test]
fn a_sleeper_tells_how_long_it_slept() {
    let mut lab = Lab::new("asleep");
    lab.wait(65.0);
    lab.robot.press(Buttons::from_byte(1));
    lab.wait(0.1);
    let text = String::from_utf8(lab.take()).unwrap();
    assert!(text.contains("slept for 1 minutes 5 seconds"), "{text}");
    assert!(text.lines().all(|line| Said::of(line) == Said::Woke), "{text}");
}

#[test]
fn slow_talks_at_19200_until_it_is_reset() {
    let mut lab = Lab::new("slow");
    lab.send(&[128]);
    assert_eq!((lab.ask(35), lab.robot.mode()), (vec![], Mode::Off));
    lab.baud = 19_200;
    lab.send(&[128]);
    assert_eq!(lab.ask(35), [1]);
    lab.send(&[7]);
    lab.wait(5.0);
    lab.baud = BAUD;
    lab.send(&[128]);
    assert_eq!(lab.ask(35), [1]);
}

#[test]
fn modes_are_one_too_high() {
    let mut lab = Lab::new("mode_plus_one");
    for (opcode, byte) in [(128, 2), (131, 3), (132, 4)] {
        lab.send(&[opcode]);
        assert_eq!(lab.ask(35), [byte]);
    }
}

/// Frames and lines of text that were heard.
fn parsed(bytes: &[u8]) -> (usize, Vec<String>) {
    let (mut frames, mut lines) = (0, Vec::new());
    StreamParser::default().feed(bytes, &mut |event| match event {
        StreamEvent::Frame(_) => frames += 1,
        StreamEvent::Text(text) => lines.push(text.line.to_owned()),
        StreamEvent::Refused { .. } => {}
    });
    (frames, lines)
}

#[test]
fn chatty_writes_every_second_between_the_frames_even_while_it_drives() {
    let mut lab = Lab::new("chatty");
    lab.go(Mode::Safe);
    lab.send(&[148, 2, 35, 22]);
    lab.command(Command::DriveDirect { right: 100, left: 100 });
    lab.wait(0.5);
    lab.take();
    lab.wait(10.0);
    let (frames, lines) = parsed(&lab.take());
    assert!((666..=667).contains(&frames) && lines.len() == 10, "{frames} {lines:?}");
    let logs: Vec<_> = lines
        .iter()
        .map(|line| match Said::of(line) {
            Said::Charging(log) => log,
            other => panic!("{line}: {other:?}"),
        })
        .collect();
    assert!(logs.windows(2).all(|pair| pair[1].seconds == pair[0].seconds + 1));
    assert!(logs.iter().all(|log| log.current_ma < 0 && log.voltage_mv > 13_000));
}

#[test]
fn docked_charges_writes_and_bounces_out_of_safe() {
    let conditions = Conditions { start_charge_percent: 50, ..Conditions::default() };
    let mut lab = Lab::in_room(plan(), "docked", conditions);
    lab.go(Mode::Passive);
    lab.wait(10.5);
    let (_, lines) = parsed(&lab.take());
    assert!((9..=11).contains(&lines.len()), "{lines:?}");
    lab.send(&[131]);
    lab.wait(0.02);
    assert_eq!(lab.robot.mode(), Mode::Passive);
    assert!(lab.robot.sensors().battery.on_dock);
    // In Full it doesn't charge, is silent about it, and can back off the dock.
    lab.send(&[132]);
    lab.wait(0.1);
    lab.take();
    lab.command(Command::DriveDirect { right: -100, left: -100 });
    lab.wait(3.0);
    assert_eq!(lab.take(), [0_u8; 0]);
    lab.send(&[131]);
    lab.wait(0.05);
    assert_eq!(lab.robot.mode(), Mode::Safe);
}

#[test]
fn dozes_falls_silent_on_its_dock_and_brc_is_no_use() {
    let mut lab = Lab::new("dozes");
    lab.go(Mode::Passive);
    lab.wait(25.0);
    assert!(lab.robot.is_awake());
    lab.wait(10.0);
    lab.robot.set_brc(true);
    lab.wait(1.0);
    lab.robot.set_brc(false);
    lab.wait(1.0);
    assert!(!lab.robot.is_awake());
    lab.robot.press(Buttons::from_byte(1));
    lab.send(&[128]);
    assert_eq!(lab.ask(35), [1]);
}

#[test]
fn old_firmware_reports_a_third_of_every_angle() {
    let mut lab = Lab::new("angle_bug");
    lab.go(Mode::Full);
    lab.value(20);
    lab.command(Command::DriveDirect { right: 100, left: -100 });
    lab.wait(3.0);
    lab.command(Command::DriveDirect { right: 0, left: 0 });
    lab.wait(1.0);
    let (reported, turned) = (f64::from(lab.value(20)), lab.robot.pose().heading.to_degrees());
    assert!((reported - 0.324_056 * turned).abs() < 1.0, "{reported} {turned}");
    lab.send(&[7]);
    lab.wait(5.0);
    let (_, lines) = parsed(&lab.take());
    let firmware = lines.iter().find_map(|line| match Said::of(line) {
        Said::Firmware(firmware) => Some(firmware),
        _ => None,
    });
    assert!(firmware.is_some_and(|firmware| firmware.has_angle_error() && !firmware.has_distance_error()));
}

#[test]
fn noisy_loses_and_flips_one_byte_in_a_thousand() {
    let mut lab = Lab::new("noisy");
    lab.go(Mode::Full);
    lab.send(&[148, 2, 8, 9]);
    lab.wait(0.1);
    lab.take();
    let (mut total, mut expected, mut flipped) = (0_usize, 0_usize, 0_usize);
    let frame = [19, 4, 8, 0, 9, 0, 216];
    for _ in 0..250 {
        lab.wait(4.5);
        let heard = lab.take();
        total += heard.len();
        expected += 300 * frame.len();
        flipped += heard.iter().filter(|byte| !frame.contains(byte)).count();
    }
    let lost = expected.abs_diff(total) as f64 / expected as f64;
    let flipped = flipped as f64 / expected as f64;
    assert!((0.000_35..0.000_65).contains(&lost), "{lost}");
    assert!((0.000_3..0.000_65).contains(&flipped), "{flipped}");
}

#[test]
fn deaf_takes_the_next_command_for_what_it_missed() {
    let mut lab = Lab::new("deaf");
    lab.go(Mode::Full);
    lab.robot.take_heard();
    for _ in 0..2000 {
        lab.command(Command::DriveDirect { right: 0, left: 0 });
    }
    let heard = lab.robot.take_heard();
    let bytes: usize = heard.iter().map(|heard| heard.bytes.len()).sum();
    assert!((9900..9980).contains(&bytes), "{bytes}");
    assert!(heard.iter().any(|heard| heard.bytes != [145, 0, 0, 0, 0]));
}

#[test]
fn swapped_has_the_right_wheel_first() {
    for (id, packet) in [("model", 43), ("swapped", 44)] {
        let mut lab = Lab::new(id);
        lab.go(Mode::Full);
        lab.command(Command::DriveDirect { right: 0, left: 200 });
        lab.wait(1.0);
        assert!(lab.value(packet) > 200, "{id}");
        assert_eq!(lab.value(87 - packet), 0, "{id}");
    }
}

#[test]
fn wrap_wraps_both_ways_soon() {
    let mut lab = Lab::new("wrap");
    lab.go(Mode::Full);
    let counts = |lab: &mut Lab| [lab.value(43), lab.value(44)].map(|counts| counts as u16);
    let before = counts(&mut lab);
    lab.command(Command::DriveDirect { right: -100, left: 100 });
    lab.wait(2.0);
    let after = counts(&mut lab);
    assert!(before[0] > 65_000 && after[0] < 1000, "{before:?} {after:?}");
    assert!(before[1] < 1000 && after[1] > 65_000, "{before:?} {after:?}");
}

#[test]
fn bootloader_sends_nothing_but_254_after_a_reset() {
    let mut lab = Lab::new("bootloader");
    lab.go(Mode::Safe);
    lab.send(&[7]);
    lab.wait(10.0);
    let heard = lab.take();
    assert!(heard.len() > 90 && heard.iter().all(|&byte| byte == 0xFE), "{heard:?}");
    lab.robot.press(Buttons::from_byte(1));
    lab.send(&[7, 128, 142, 35]);
    lab.wait(20.0);
    assert!(lab.take().iter().all(|&byte| byte == 0xFE) && lab.robot.mode() == Mode::Off);
}

#[test]
fn create1_talks_at_57600_and_has_no_encoders() {
    let mut lab = Lab::new("create1");
    lab.send(&[128]);
    assert_eq!(lab.robot.mode(), Mode::Off);
    let mut lab = Lab::new("create1");
    lab.baud = 57_600;
    lab.send(&[128]);
    assert_eq!((lab.ask(35), lab.ask(6).len(), lab.ask(43), lab.ask(100)), (vec![1], 52, vec![], vec![]));
    lab.send(&[7]);
    lab.wait(5.0);
    lab.send(&[128]);
    assert_eq!(lab.ask(35), [1]);
}

#[test]
fn silent_obeys_and_never_answers() {
    let mut lab = Lab::new("silent");
    lab.send(&[128, 131, 148, 1, 7]);
    lab.wait(1.0);
    assert_eq!((lab.robot.mode(), lab.ask(35)), (Mode::Safe, vec![]));
}
