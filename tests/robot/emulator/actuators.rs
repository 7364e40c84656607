//! Wheels, brushes, lights, songs, buttons.

use super::support::{Lab, plan};
use robovac_core::{
    floor_plan::{FloorPlan, Object},
    geometry::Point,
};
use robovac_sim::Conditions;
use roomba_oi::{
    Command, Mode, Motors,
    motion::{SPIN_CLOCKWISE, SPIN_COUNTER_CLOCKWISE, STRAIGHT, STRAIGHT_TOO},
};

/// Wheel speeds after a second, left and right, mm/s.
fn speeds(lab: &mut Lab, bytes: &[u8]) -> [i32; 2] {
    lab.send(bytes);
    lab.wait(1.2);
    let speed = lab.robot.robot().speed();
    [speed.left, speed.right].map(|v| (1000.0 * v).round() as i32)
}

#[test]
fn drive_and_its_special_radii() {
    let mut lab = Lab::in_mode(Mode::Full);
    let drives = [
        (200, STRAIGHT, [200, 200]),
        (-200, STRAIGHT_TOO, [-200, -200]),
        (100, SPIN_COUNTER_CLOCKWISE, [-100, 100]),
        (100, SPIN_CLOCKWISE, [100, -100]),
        (200, 500, [153, 247]),
        (200, -500, [247, 153]),
        // Slowed down until the outer wheel can follow: its curve stays.
        (500, 235, [167, 500]),
        (0, STRAIGHT, [0, 0]),
    ];
    for (velocity, radius, expected) in drives {
        let [v, r] = [velocity, radius].map(i16::to_be_bytes);
        assert_eq!(speeds(&mut lab, &[137, v[0], v[1], r[0], r[1]]), expected, "{velocity} {radius}");
        assert_eq!((lab.value(39), lab.value(40)), (velocity.into(), radius.into()));
    }
    // The specification's example: -200 mm/s on a radius of 500 mm.
    assert_eq!(speeds(&mut lab, &[137, 255, 56, 1, 244]), [-153, -247]);
}

#[test]
fn drive_direct_takes_the_right_wheel_first() {
    let mut lab = Lab::in_mode(Mode::Safe);
    assert_eq!(speeds(&mut lab, &[145, 0, 100, 0, 50]), [50, 100]);
    assert_eq!(speeds(&mut lab, &[145, 255, 156, 1, 44]), [300, -100]);
    assert_eq!((lab.value(41), lab.value(42)), (-100, 300));
    assert_eq!(lab.value(39), 0, "packets 39 and 40 are Drive's");
}

#[test]
fn wheels_got_going_at_less_than_half_the_published_acceleration() {
    let mut lab = Lab::in_mode(Mode::Safe);
    lab.send(&[145, 1, 44, 0, 150]);
    lab.wait(0.2);
    let speed = lab.robot.robot().speed();
    // 300 mm/s at 1.8 m/s² take a sixth of a second.
    assert_eq!([speed.left, speed.right].map(|v| (1000.0 * v).round() as i32), [150, 300]);
}

#[test]
fn drive_pwm_has_a_dead_zone_that_is_wider_on_carpet() {
    let mut lab = Lab::in_mode(Mode::Full);
    assert_eq!(speeds(&mut lab, &[146, 0, 20, 255, 236]), [0, 0]);
    assert_eq!(speeds(&mut lab, &[146, 0, 255, 255, 1]), [-500, 500]);
    let [left, right] = speeds(&mut lab, &[146, 0, 60, 0, 30]);
    assert!(left > 0 && right > left && right < 150, "{left} {right}");
    let corner = |x, y| Point::new(x, y);
    let outline = vec![corner(0.1, 0.1), corner(5.9, 0.1), corner(5.9, 3.9), corner(0.1, 3.9)];
    let carpet = FloorPlan { objects: vec![Object::Carpet { outline }], ..plan() };
    let mut lab = Lab::in_room(carpet, "model", Conditions::default());
    lab.go(Mode::Full);
    assert_eq!(speeds(&mut lab, &[146, 0, 30, 0, 39]), [0, 0]);
}

#[test]
fn motors_run_as_bits_and_as_duty_cycles_and_draw_current() {
    let mut lab = Lab::in_mode(Mode::Safe);
    lab.wait(1.0);
    let rest = lab.value(23);
    lab.send(&[138, 0b1_1111]);
    lab.wait(0.1);
    let motors = lab.robot.take_display().motors;
    assert_eq!(motors, Motors::from_byte(0b1_1111));
    let readings = lab.readings();
    assert!(readings.main_brush_ma < -400 && readings.side_brush_ma < -100, "they turn the other way");
    assert!(i32::from(readings.current_ma) < rest - 1000);
    // Main brush, side brush, vacuum.
    lab.command(Command::PwmMotors { main_brush: 64, side_brush: 0, vacuum: 0 });
    lab.wait(0.1);
    let readings = lab.readings();
    assert_eq!(lab.robot.take_display().motors, Motors { main_brush: true, ..Motors::default() });
    assert!((200..350).contains(&readings.main_brush_ma) && readings.side_brush_ma == 0);
    lab.send(&[138, 0]);
    assert_eq!(lab.robot.take_display().motors, Motors::default());
}

#[test]
fn dirt_is_picked_up_only_by_what_runs() {
    let dirty = FloorPlan { objects: vec![Object::Dirt { at: Point::new(1.0, 2.0), radius: 0.4 }], ..plan() };
    let mut lab = Lab::in_room(dirty, "model", Conditions::default());
    lab.go(Mode::Full);
    lab.wait(1.0);
    assert_eq!(lab.robot.life().dirt_left(), 1.0);
    lab.send(&[138, 7]);
    lab.wait(1.0);
    assert!(lab.robot.life().dirt_left() < 1.0);
}

#[test]
fn lights_and_digits_show_what_they_are_told() {
    let mut lab = Lab::in_mode(Mode::Safe);
    lab.send(&[139, 0b0101, 200, 100, 162, 0b100_0001, 0b1_0001, 164, 72, 73, 33, 32]);
    let display = lab.robot.take_display();
    assert_eq!((display.lamps.byte(), display.clean_light), (0b0101, [200, 100]));
    assert_eq!((display.weekdays.byte(), display.schedule.byte()), (0b100_0001, 0b1_0001));
    assert_eq!(&display.digits, b"HI! ");
    // The raw segments don't work on this firmware.
    lab.send(&[163, 127, 127, 127, 127]);
    assert_eq!(&lab.robot.take_display().digits, b"HI! ");
    lab.send(&[128]);
    assert_eq!(&lab.robot.take_display().digits, b"    ", "in Passive it shows what it likes");
}

#[test]
fn songs_sound_and_last_as_long_as_their_notes() {
    let mut lab = Lab::in_mode(Mode::Passive);
    lab.send(&[140, 0, 2, 69, 32, 72, 64, 140, 1, 1, 60, 64]);
    lab.send(&[141, 0]);
    assert!(lab.robot.take_display().tunes.is_empty(), "Passive stores songs and doesn't play them");
    lab.send(&[131, 141, 0]);
    assert_eq!(lab.robot.take_display().tunes, [vec![[69, 32], [72, 64]]]);
    lab.wait(0.7);
    // While one plays, no other does.
    lab.send(&[141, 1]);
    assert_eq!((lab.value(36), lab.value(37)), (0, 1));
    assert!(lab.robot.take_display().tunes.is_empty());
    lab.wait(0.7);
    assert_eq!((lab.value(36), lab.value(37)), (0, 1));
    lab.wait(0.1);
    assert_eq!(lab.value(37), 0);
    lab.send(&[141, 1]);
    assert_eq!((lab.value(36), lab.value(37)), (1, 1));
    lab.send(&[141, 2]);
    lab.wait(1.1);
    lab.send(&[141, 2]);
    assert_eq!(lab.value(37), 0, "nothing is stored there");
}

#[test]
fn buttons_are_released_after_a_sixth_of_a_second() {
    let mut lab = Lab::in_mode(Mode::Safe);
    lab.send(&[165, 0b1000]);
    assert_eq!(lab.value(18), 0b1000);
    lab.wait(0.1);
    assert_eq!(lab.value(18), 0b1000);
    lab.wait(0.1);
    assert_eq!((lab.value(18), lab.robot.mode()), (0, Mode::Safe));
}

#[test]
fn the_schedule_makes_it_clean_when_its_time_has_come() {
    let mut lab = Lab::in_mode(Mode::Passive);
    // Every Monday at 0:02; it is Monday, 0:00.
    let mut schedule = vec![167, 0b10];
    schedule.extend([0, 2].repeat(7));
    lab.send(&schedule);
    lab.send(&[168, 1, 0, 0]);
    lab.wait(110.0);
    assert!(!lab.robot.runs_builtin_program());
    lab.wait(20.0);
    assert!(lab.robot.runs_builtin_program());
    // Not while it is controlled in Safe.
    let mut lab = Lab::in_mode(Mode::Safe);
    lab.send(&schedule);
    lab.send(&[168, 1, 0, 0]);
    lab.wait(200.0);
    assert!(!lab.robot.runs_builtin_program() && lab.robot.mode() == Mode::Safe);
}
