//! Sleep, wake, reset, battery and charger.

use super::support::{BAUD, Lab, plan};
use robovac_sim::Conditions;
use roomba_oi::{Buttons, Command, Mode, Said, motion::STRAIGHT};

const CLEAN: Buttons = Buttons::from_byte(1);

#[test]
fn passive_sleeps_after_five_minutes_and_safe_and_full_never() {
    for (mode, sleeps) in [(Mode::Off, false), (Mode::Passive, true), (Mode::Safe, false), (Mode::Full, false)] {
        let mut lab = Lab::in_mode(mode);
        lab.wait(299.0);
        assert!(lab.robot.is_awake());
        lab.wait(2.0);
        assert_eq!(lab.robot.is_awake(), !sleeps, "{mode}");
    }
}

#[test]
fn commands_and_pulses_restart_the_five_minutes() {
    let mut lab = Lab::in_mode(Mode::Passive);
    for round in 0..4 {
        lab.wait(200.0);
        if round % 2 == 0 {
            lab.send(&[142, 35]);
        } else {
            lab.robot.set_brc(true);
            lab.wait(1.0);
            lab.robot.set_brc(false);
        }
    }
    assert!(lab.robot.is_awake());
    // Its own output isn't activity, and neither is a command that it ignores.
    lab.send(&[148, 1, 35]);
    lab.wait(200.0);
    lab.command(Command::Drive { velocity: 100, radius: STRAIGHT });
    lab.wait(101.0);
    assert!(!lab.robot.is_awake());
}

#[test]
fn asleep_is_silent_and_only_the_clean_button_or_brc_wakes() {
    for by_button in [true, false] {
        let mut lab = Lab::in_mode(Mode::Passive);
        lab.send(&[133]);
        lab.wait(1.0);
        assert!(!lab.robot.is_awake());
        lab.send(&[128, 131, 142, 35, 7, 135, 148, 1, 7]);
        lab.robot.press(Buttons::from_byte(0b10));
        lab.wait(10.0);
        assert_eq!((lab.take(), lab.robot.is_awake()), (vec![], false));
        if by_button {
            lab.robot.press(CLEAN);
        } else {
            lab.robot.set_brc(true);
            lab.wait(0.2);
            assert!(!lab.robot.is_awake(), "the end of the pulse wakes it");
            lab.robot.set_brc(false);
        }
        lab.wait(0.1);
        assert!(lab.robot.is_awake() && !lab.robot.runs_builtin_program());
        assert_eq!((lab.take(), lab.ask(35)), (vec![], vec![1]));
        // Awake, the button cleans.
        lab.robot.press(CLEAN);
        assert!(lab.robot.runs_builtin_program());
        assert_eq!(lab.value(18), 1);
    }
}

#[test]
fn reset_takes_its_time_and_tells_who_it_is() {
    let mut lab = Lab::in_mode(Mode::Full);
    lab.command(Command::DriveDirect { right: 300, left: 300 });
    lab.wait(1.0);
    assert!(lab.value(43) > 300);
    lab.send(&[7]);
    lab.wait(0.05);
    assert_eq!((lab.robot.mode(), lab.robot.is_awake()), (Mode::Off, false));
    assert_eq!(lab.take(), b"Soft reset!\n");
    lab.wait(1.0);
    assert_eq!(lab.take(), [0xFE]);
    // Too early: it doesn't listen yet.
    lab.send(&[128]);
    lab.wait(3.2);
    let text = String::from_utf8(lab.take()).unwrap();
    let said: Vec<Said> = text.lines().map(Said::of).collect();
    assert!(said.contains(&Said::Booting), "{text}");
    let firmware = said.iter().find_map(|said| if let Said::Firmware(firmware) = said { Some(firmware) } else { None });
    assert!(firmware.is_some_and(|firmware| firmware.stm32 && firmware.version == [3, 7, 1]), "{text}");
    lab.wait(0.5);
    assert_eq!(lab.robot.mode(), Mode::Off);
    lab.send(&[128]);
    assert_eq!((lab.ask(35), lab.value(43)), (vec![1], 0));
}

#[test]
fn reset_forgets_songs_and_schedule_and_half_a_command() {
    let mut lab = Lab::in_mode(Mode::Safe);
    lab.send(&[140, 0, 1, 60, 10, 7]);
    lab.send(&[137, 0]);
    lab.wait(5.0);
    lab.send(&[128, 131, 141, 0]);
    assert_eq!((lab.robot.mode(), lab.value(37)), (Mode::Safe, 0));
}

#[test]
fn charging_goes_through_its_states() {
    let conditions = Conditions { start_charge_percent: 99, ..Conditions::default() };
    let mut lab = Lab::in_room(plan(), "docked", conditions);
    lab.go(Mode::Passive);
    lab.wait(0.5);
    let state = |lab: &mut Lab| {
        lab.send(&[128]);
        lab.take();
        // Between two lines of its log.
        while lab.ask(21).len() != 1 {}
        let readings = loop {
            let answer = lab.ask(100);
            if answer.len() == 80 {
                let mut readings = roomba_oi::Readings::default();
                let all = roomba_oi::PacketId::from_byte(100).unwrap();
                readings.read(all, &answer).unwrap();
                break readings;
            }
        };
        assert_eq!((readings.chargers.byte(), readings.cliff), (2, [true; 4]));
        (readings.charging.byte(), readings.current_ma)
    };
    assert_eq!(state(&mut lab).0, 4);
    lab.wait(2.0);
    let (charging, current) = state(&mut lab);
    assert!(charging == 2 && (1225..=1240).contains(&current), "{charging} {current}");
    lab.wait(120.0);
    assert_eq!(state(&mut lab).0, 3);
}

#[test]
fn an_empty_battery_ends_it_and_a_charger_boots_it() {
    let conditions = Conditions { start_charge_percent: 1, ..Conditions::default() };
    let mut lab = Lab::in_room(plan(), "model", conditions);
    lab.go(Mode::Full);
    lab.send(&[138, 7]);
    let mut last = 0;
    for _ in 0..100_000 {
        if !lab.robot.is_awake() {
            break;
        }
        last = lab.ask(25).first_chunk().map_or(last, |&bytes| u16::from_be_bytes(bytes));
        lab.wait(0.3);
    }
    assert_eq!((lab.robot.is_awake(), last), (false, 65_529));
    lab.robot.press(CLEAN);
    lab.wait(1.0);
    assert!(!lab.robot.is_awake());
    lab.take();
    lab.robot.plug_charger(true);
    lab.wait(10.0);
    assert!(lab.robot.is_awake() && lab.take().starts_with(b"Soft reset!"));
    lab.send(&[128]);
    let readings = lab.readings();
    assert_eq!(readings.charging.byte(), 1);
    assert!((301..=302).contains(&readings.current_ma), "{}", readings.current_ma);
}

#[test]
fn standing_it_lasts_for_hours_in_full_and_asleep_for_days() {
    let mut lab = Lab::in_mode(Mode::Full);
    lab.wait(3600.0);
    let awake = lab.value(25);
    assert!((2500..2600).contains(&awake), "{awake}");
    let mut lab = Lab::in_mode(Mode::Passive);
    lab.send(&[133]);
    lab.wait(3600.0);
    lab.robot.press(CLEAN);
    lab.robot.receive(&[128], BAUD);
    let asleep = lab.value(25);
    assert!(asleep > 2690, "{asleep}");
}
