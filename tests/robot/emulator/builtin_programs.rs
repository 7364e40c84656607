//! The robot's built-in programs: Clean, Spot, Max, Seek Dock.

use super::support::{Lab, plan};
use robovac_core::{
    floor_plan::{FloorPlan, Object},
    geometry::Pose,
};
use robovac_sim::{Conditions, Input};
use roomba_oi::{Buttons, Mode};

/// Metres driven in so many seconds.
fn driven(lab: &mut Lab, seconds: f64) -> f64 {
    let mut sum = 0.0;
    for _ in 0..(seconds / 0.1) as u32 {
        let from = lab.robot.pose().position();
        lab.wait(0.1);
        sum += (lab.robot.pose().position() - from).norm();
    }
    sum
}

#[test]
fn cleaning_commands_and_buttons_clean() {
    for opcode in [134, 135, 136] {
        for mode in [Mode::Passive, Mode::Safe, Mode::Full] {
            let mut lab = Lab::in_mode(mode);
            lab.send(&[opcode]);
            assert!(driven(&mut lab, 20.0) > 2.0, "{opcode}");
            assert_eq!((lab.robot.mode(), lab.robot.take_display().motors.byte()), (Mode::Passive, 7));
            // Once more pauses, and once more goes on.
            lab.send(&[opcode]);
            lab.wait(1.0);
            assert!(driven(&mut lab, 5.0) == 0.0 && lab.robot.take_display().motors.byte() == 0);
            lab.send(&[opcode]);
            assert!(driven(&mut lab, 20.0) > 2.0, "{opcode}");
        }
    }
    for (button, lamps) in [(0b1, 0), (0b10, 0b10), (0b100, 0b100)] {
        let mut lab = Lab::in_mode(Mode::Passive);
        lab.send(&[165, button]);
        assert!(lab.robot.runs_builtin_program());
        assert_eq!(lab.robot.take_display().lamps.byte(), lamps);
    }
}

#[test]
fn buttons_are_seen_in_every_mode_and_do_something_in_off_and_passive() {
    let clean = Buttons::from_byte(1);
    for mode in Mode::ALL {
        let mut lab = Lab::in_mode(mode);
        lab.robot.press(clean);
        lab.wait(0.01);
        assert_eq!(lab.robot.runs_builtin_program(), mode < Mode::Safe, "{mode}");
        assert_eq!(lab.robot.mode(), mode);
        if mode >= Mode::Safe {
            assert_eq!(lab.value(18), 1, "it is seen all the same");
            lab.wait(0.2);
            lab.send(&[165, 1]);
            assert_eq!((lab.robot.runs_builtin_program(), lab.robot.mode(), lab.value(18)), (false, mode, 1));
        }
    }
}

#[test]
fn safe_and_full_end_a_builtin_program_and_start_doesnt() {
    for opcode in [131, 132] {
        let mut lab = Lab::in_mode(Mode::Passive);
        lab.send(&[135]);
        lab.wait(2.0);
        lab.send(&[128]);
        assert!(lab.robot.runs_builtin_program());
        lab.send(&[opcode]);
        lab.wait(1.0);
        assert!(!lab.robot.runs_builtin_program() && driven(&mut lab, 5.0) == 0.0);
    }
}

#[test]
fn being_lifted_ends_a_builtin_program_with_a_complaint() {
    let mut lab = Lab::in_mode(Mode::Passive);
    lab.send(&[135]);
    lab.wait(2.0);
    lab.robot.take_display();
    lab.robot.apply(Input::Lift);
    lab.wait(0.1);
    let display = lab.robot.take_display();
    assert!(!lab.robot.runs_builtin_program() && display.lamps.check_robot && display.tunes.len() == 1);
    lab.robot.apply(Input::PutDown(Pose::new(3.0, 2.0, 0.0)));
    lab.wait(1.0);
    assert!(!lab.robot.runs_builtin_program());
    lab.robot.press(Buttons::from_byte(1));
    assert!(lab.robot.runs_builtin_program() && !lab.robot.take_display().lamps.check_robot);
}

#[test]
fn spot_ends_after_a_while_and_then_it_may_sleep() {
    let mut lab = Lab::in_mode(Mode::Passive);
    lab.send(&[134]);
    lab.wait(70.0);
    assert!(lab.robot.runs_builtin_program());
    lab.wait(10.0);
    assert!(!lab.robot.runs_builtin_program() && lab.robot.is_awake());
    lab.wait(290.0);
    assert!(lab.robot.is_awake(), "cleaning is activity");
    lab.wait(15.0);
    assert!(!lab.robot.is_awake());
}

#[test]
fn seek_dock_finds_the_dock_and_charges() {
    let dock = Object::Dock { pose: Pose::new(5.95, 2.0, std::f64::consts::PI) };
    let room = FloorPlan { objects: vec![dock], ..plan() };
    let conditions = Conditions { start_charge_percent: 50, ..Conditions::default() };
    let mut lab = Lab::in_room(room, "model", conditions);
    lab.go(Mode::Safe);
    lab.send(&[143]);
    for _ in 0..1000 {
        lab.wait(1.0);
        if !lab.robot.runs_builtin_program() {
            break;
        }
    }
    lab.wait(5.0);
    let readings = lab.readings();
    assert_eq!((readings.chargers.byte(), readings.charging.byte(), readings.mode), (2, 2, 1));
    // Safe can't be had there; Full can, and doesn't charge.
    lab.send(&[131]);
    lab.wait(0.05);
    assert_eq!(lab.robot.mode(), Mode::Passive);
    lab.send(&[132]);
    lab.wait(0.05);
    let readings = lab.readings();
    assert_eq!((readings.chargers.byte(), readings.charging.byte(), readings.mode), (2, 0, 3));
    assert!(readings.current_ma < 0);
}
