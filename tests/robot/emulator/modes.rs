//! The mode machine.

use super::support::{Lab, plan_with_drop_off};
use robovac_core::geometry::Pose;
use robovac_sim::{Conditions, Input};
use roomba_oi::{Command, Mode, Note, Opcode, motion::STRAIGHT};

/// A command for each opcode that is within its ranges.
pub fn example(opcode: Opcode) -> Vec<u8> {
    let data: &[u8] = match opcode {
        Opcode::Baud => &[11],
        Opcode::Drive => &[0, 200, 128, 0],
        Opcode::Leds => &[4, 128, 255],
        Opcode::Song => &[0, 1, 69, 16],
        Opcode::Motors | Opcode::SensorReadings => &[7],
        Opcode::PwmMotors => &[100, 50, 20],
        Opcode::DriveDirect | Opcode::DrivePwm => &[0, 100, 0, 100],
        Opcode::Stream | Opcode::QueryList => &[1, 7],
        Opcode::Play | Opcode::PauseResume => &[0],
        Opcode::SchedulingLeds => &[1, 1],
        Opcode::DigitsRaw => &[1, 2, 3, 4],
        Opcode::DigitsAscii => b"ABCD",
        // A button that does nothing by itself.
        Opcode::Buttons => &[8],
        Opcode::Schedule => &[0; 15],
        Opcode::DayTime => &[0, 0, 0],
        _ => &[],
    };
    [&[opcode as u8], data].concat()
}

#[test]
fn every_opcode_in_every_mode() {
    for mode in Mode::ALL {
        for &opcode in Opcode::ALL {
            let mut lab = Lab::in_mode(mode);
            lab.robot.take_heard();
            lab.send(&example(opcode));
            let expected = mode.after_command(opcode);
            assert_eq!(lab.robot.mode(), expected.unwrap_or(mode), "{opcode} in {mode}");
            let heard = lab.robot.take_heard();
            assert_eq!(heard.len(), 1, "{opcode} in {mode}: {heard:?}");
            assert_eq!(
                (&heard[0].bytes, heard[0].was_obeyed),
                (&example(opcode), expected.is_some()),
                "{opcode} in {mode}"
            );
        }
    }
}

#[test]
fn every_way_from_mode_to_mode() {
    let to = |opcode: u8, mode: Mode| (opcode, mode);
    let ways = [
        to(128, Mode::Passive),
        to(130, Mode::Safe),
        to(131, Mode::Safe),
        to(132, Mode::Full),
        to(133, Mode::Passive),
        to(134, Mode::Passive),
        to(135, Mode::Passive),
        to(136, Mode::Passive),
        to(143, Mode::Passive),
        to(7, Mode::Off),
        to(173, Mode::Off),
    ];
    for from in Mode::ALL {
        for (opcode, mode) in ways {
            let mut lab = Lab::in_mode(from);
            lab.send(&[opcode]);
            let is_heard = from != Mode::Off || matches!(opcode, 7 | 128);
            assert_eq!(lab.robot.mode(), if is_heard { mode } else { Mode::Off }, "{opcode} in {from}");
        }
    }
}

#[test]
fn off_answers_nothing_and_start_beeps_only_there() {
    let mut lab = Lab::new("model");
    assert_eq!((lab.ask(35), lab.ask(7)), (vec![], vec![]));
    lab.send(&[128]);
    assert_eq!(lab.robot.take_display().tunes.len(), 1);
    assert_eq!(lab.ask(35), [1]);
    lab.send(&[128]);
    assert!(lab.robot.take_display().tunes.is_empty());
    // Queries before Stop are still answered.
    lab.send(&[142, 35, 173]);
    lab.wait(0.1);
    assert_eq!((lab.take(), lab.robot.take_display().tunes.len()), (vec![1], 1));
    assert_eq!(lab.ask(35), [0_u8; 0]);
}

fn driving(mode: Mode, right: i16, left: i16) -> Lab {
    let mut lab = Lab::in_mode(mode);
    lab.command(Command::DriveDirect { right, left });
    lab.wait(0.5);
    assert!(lab.speed() > 0.09);
    lab
}

#[test]
fn every_way_to_passive_or_off_stops_wheels_and_brushes() {
    for opcode in [128, 133, 7, 173] {
        let mut lab = driving(Mode::Full, 300, 300);
        lab.command(Command::PwmMotors { main_brush: 50, side_brush: -50, vacuum: 10 });
        lab.send(&[opcode]);
        let from = lab.ahead();
        lab.wait(1.0);
        assert!(lab.speed() == 0.0 && lab.ahead() - from < 0.05, "{opcode}");
        assert_eq!(lab.robot.take_display().motors.byte(), 0, "{opcode}");
    }
    // Between Safe and Full they go on.
    let mut lab = driving(Mode::Full, 300, 300);
    lab.send(&[131]);
    lab.wait(0.5);
    lab.send(&[132]);
    lab.wait(0.5);
    assert!(lab.speed() > 0.29);
}

#[test]
fn motion_has_no_timeout() {
    let mut lab = driving(Mode::Safe, 100, -100);
    lab.wait(3600.0);
    assert!((lab.speed() - 0.1).abs() < 1e-9 && lab.robot.mode() == Mode::Safe);
}

#[test]
fn a_dropped_wheel_ends_safe_but_not_full() {
    for (mode, after) in [(Mode::Safe, Mode::Passive), (Mode::Full, Mode::Full)] {
        let mut lab = driving(mode, 200, 200);
        lab.robot.apply(Input::Lift);
        lab.wait(0.05);
        assert_eq!((lab.robot.mode(), lab.value(7), lab.value(35)), (after, 12, after as i32));
        lab.wait(1.0);
        assert_eq!(lab.speed() > 0.0, mode == Mode::Full);
        // Safe can't be had while it hangs in the air.
        lab.send(&[131]);
        lab.wait(0.05);
        assert_eq!(lab.robot.mode(), Mode::Passive);
        lab.robot.apply(Input::PutDown(Pose::new(1.0, 2.0, 0.0)));
        lab.wait(0.05);
        lab.send(&[131]);
        lab.wait(0.05);
        assert_eq!(lab.robot.mode(), Mode::Safe);
    }
}

#[test]
fn a_cliff_ends_safe_before_the_robot_falls_at_any_speed() {
    for speed in [100, 300, 500] {
        let mut lab = Lab::in_room(plan_with_drop_off(1.5), "model", Conditions::default());
        lab.go(Mode::Safe);
        lab.command(Command::Drive { velocity: speed, radius: STRAIGHT });
        lab.wait(20.0);
        assert_eq!(lab.robot.mode(), Mode::Passive, "{speed}");
        assert!(!lab.robot.robot().has_fallen() && lab.speed() == 0.0, "{speed}");
        let readings = lab.readings();
        assert!(readings.cliff[1] && readings.cliff[2] && readings.cliff_signal[1] == 0);
        // It may back away from the edge in Safe, and stays there.
        lab.send(&[131]);
        lab.command(Command::Drive { velocity: -100, radius: STRAIGHT });
        lab.wait(3.0);
        assert_eq!((lab.robot.mode(), lab.value(10)), (Mode::Safe, 0), "{speed}");
    }
}

#[test]
fn full_drives_over_the_edge() {
    let mut lab = Lab::in_room(plan_with_drop_off(1.0), "model", Conditions::default());
    lab.go(Mode::Full);
    lab.command(Command::Drive { velocity: 300, radius: STRAIGHT });
    lab.wait(6.0);
    assert!(lab.robot.robot().has_fallen() && lab.robot.mode() == Mode::Full);
}

#[test]
fn turning_at_an_edge_is_a_hazard_and_a_wide_arc_back_is_none() {
    for (velocity, radius, mode) in [(-100, 150, Mode::Passive), (-100, 400, Mode::Safe), (100, 1, Mode::Passive)] {
        let mut lab = Lab::in_room(plan_with_drop_off(0.5), "model", Conditions::default());
        lab.go(Mode::Full);
        lab.command(Command::Drive { velocity: 60, radius: STRAIGHT });
        while !lab.robot.sensors().cliff[1] {
            lab.wait(0.015);
        }
        lab.command(Command::Drive { velocity: 0, radius: STRAIGHT });
        lab.wait(0.5);
        assert_eq!((lab.value(10), lab.value(11)), (1, 1));
        lab.send(&[131]);
        lab.wait(0.05);
        assert_eq!(lab.robot.mode(), Mode::Safe, "standing at an edge is no hazard");
        lab.command(Command::Drive { velocity, radius });
        lab.wait(0.05);
        assert_eq!(lab.robot.mode(), mode, "{velocity} {radius}");
    }
}

#[test]
fn bumper_and_light_bumper_change_nothing() {
    let mut lab = driving(Mode::Safe, 300, 300);
    lab.wait(20.0);
    let readings = lab.readings();
    assert!(readings.bumps.bump_left && readings.bumps.bump_right && readings.light_bumper.byte() != 0);
    assert_eq!(lab.robot.mode(), Mode::Safe);
    assert!(lab.speed() > 0.29, "the wheels go on turning");
    assert!(readings.overcurrents.left_wheel && readings.left_motor_ma > 1000 && !readings.stasis.toggling);
}

#[test]
fn a_powered_charger_ends_safe_but_not_full_and_doesnt_charge_there() {
    for (mode, after) in [(Mode::Safe, Mode::Passive), (Mode::Full, Mode::Full)] {
        let mut lab = driving(mode, 200, 200);
        lab.robot.plug_charger(true);
        lab.wait(5.0);
        let readings = lab.readings();
        assert_eq!((lab.robot.mode(), readings.chargers.byte()), (after, 1));
        assert_eq!(readings.charging.byte() == 0, mode == Mode::Full);
    }
}

#[test]
fn safe_switches_the_lights_off_and_full_leaves_them() {
    let mut lab = Lab::in_mode(Mode::Full);
    assert_eq!(lab.robot.take_display().clean_light, [0, 255]);
    lab.send(&[139, 4, 10, 20, 131]);
    let display = lab.robot.take_display();
    assert_eq!((display.lamps.byte(), display.clean_light), (0, [0, 0]));
    let mut lab = Lab::in_mode(Mode::Safe);
    assert_eq!(lab.robot.take_display().clean_light, [0, 0]);
    lab.send(&[128]);
    assert_eq!(lab.robot.take_display().clean_light, [0, 255], "its own lights are back");
}

#[test]
fn an_incomplete_command_waits_for_ever() {
    let mut lab = Lab::in_mode(Mode::Safe);
    lab.send(&[137, 0, 200]);
    lab.wait(3600.0);
    assert_eq!(lab.speed(), 0.0);
    // The radius takes the place of what would have been commands.
    lab.send(&[128, 0]);
    lab.wait(0.5);
    assert!(lab.speed() > 0.19 && lab.robot.mode() == Mode::Safe);
    lab.send(&[128]);
    assert_eq!(lab.robot.mode(), Mode::Passive);
}

#[test]
fn values_out_of_range_are_brought_in_or_ignored() {
    let song: &[Note] = &[[60, 16]];
    let mut lab = Lab::in_mode(Mode::Full);
    lab.robot.take_heard();
    lab.send(&[145, 3, 0, 252, 0]);
    assert_eq!((lab.value(41), lab.value(42)), (500, -500));
    lab.send(&[137, 3, 0, 9, 0]);
    assert_eq!((lab.value(39), lab.value(40)), (500, 2000));
    lab.send(&[145, 0, 0, 0, 0]);
    lab.robot.take_heard();
    // Baud code, song numbers, song lengths, a packet, a state of the stream, characters, times.
    let ignored: &[&[u8]] = &[
        &[129, 12],
        &[140, 4, 1, 60, 16],
        &[140, 0, 0],
        &[141, 4],
        &[142, 59],
        &[150, 2],
        &[164, 65, 66, 67, 31],
        &[168, 7, 0, 0],
        &[168, 0, 24, 0],
    ];
    for bytes in ignored {
        lab.send(bytes);
        let heard = lab.robot.take_heard();
        assert!(heard.len() == 1 && !heard[0].was_obeyed, "{bytes:?}: {heard:?}");
    }
    let seventeen = [[60_u8, 1]; 17].concat();
    lab.send(&[&[140, 0, 17], &seventeen[..]].concat());
    assert!(!lab.robot.take_heard()[0].was_obeyed);
    lab.send(&[141, 0]);
    assert_eq!(lab.value(37), 0, "no song was stored");
    lab.command(Command::song(3, song).unwrap());
    lab.send(&[141, 3]);
    assert_eq!((lab.value(36), lab.value(37)), (3, 1));
    // Lists: only what doesn't exist is left out.
    lab.take();
    lab.send(&[149, 3, 35, 59, 35]);
    lab.wait(0.02);
    assert_eq!(lab.take(), [3, 3]);
}
