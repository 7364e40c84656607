//! Guided calibration.

use super::wire::{Wire, hall, setup_in};
use robovac_core::{
    floor_plan::room,
    geometry::{Point, Pose, difference},
    math::FRAC_PI_2,
};
use robovac_link::connection::{Calibration, Request};
use robovac_sim::{Conditions, Input, Slip, SlipLevel};

fn calibrate(wire: &mut Wire, what: Calibration) {
    wire.ask(Request::Calibrate { what });
    wire.pass_until(60.0, |wire| wire.view().calibration.step != "moving");
}

fn armed(personality: &str) -> Wire {
    let mut wire = Wire::new(&setup_in(&hall(), Conditions::default(), 1), personality);
    wire.connect();
    wire.arm();
    wire
}

#[test]
fn a_nudge_finds_swapped_encoders_and_odometry_is_right_after_it() {
    for (personality, swapped) in [("model", false), ("swapped", true)] {
        let mut wire = armed(personality);
        let before = wire.pose().heading;
        calibrate(&mut wire, Calibration::Nudge);
        let turned = difference(before, wire.pose().heading).to_degrees();
        assert!((8.0..13.0).contains(&turned), "{personality}: {turned}");
        let view = wire.view().calibration;
        assert_eq!((view.step, view.asks), ("asking", "yes"));
        wire.ask(Request::Answer { value: 1.0 });
        let view = wire.view().calibration;
        assert_eq!((view.step, view.swapped), ("done", swapped), "{personality}");
        let (before, estimated) = (wire.pose().heading, wire.view().pose[2]);
        calibrate(&mut wire, Calibration::Spin);
        let (turned, thinks) = (difference(before, wire.pose().heading), difference(estimated, wire.view().pose[2]));
        assert!(difference(turned, thinks).abs() < 0.03, "{personality}: {turned} {thinks}");
    }
}

#[test]
fn swapped_encoders_are_noticed_while_it_turns() {
    for (personality, is_odd) in [("model", false), ("swapped", true)] {
        let mut wire = armed(personality);
        for left in [1.0, -1.0] {
            for _ in 0..50 {
                wire.ask(Request::Drive { forward: 0.0, left });
                wire.pass(0.04);
            }
        }
        let notice = wire.view().notice.map(|notice| notice.text).unwrap_or_default();
        assert_eq!(notice.contains("swapped"), is_odd, "{personality}: {notice}");
    }
}

#[test]
fn spin_and_metre_move_as_they_say_and_take_the_answer() {
    let mut wire = armed("model");
    let before = wire.pose();
    calibrate(&mut wire, Calibration::Spin);
    assert!(difference(before.heading, wire.pose().heading).abs() < 0.06, "{} {}", before, wire.pose());
    wire.ask(Request::Answer { value: 350.0 });
    assert!((wire.view().calibration.base_factor - 360.0 / 350.0).abs() < 1e-9);
    let before = wire.pose();
    calibrate(&mut wire, Calibration::Metre);
    let went = (wire.pose().position() - before.position()).norm();
    assert!((went - 1.0).abs() < 0.01, "{went}");
    let refused = wire.link.request(wire.now, Request::Answer { value: 3.0 }).unwrap_err();
    assert!(refused.to_string().contains("Measure again"), "{refused}");
    wire.ask(Request::Answer { value: 1.02 });
    let view = wire.view().calibration;
    assert!((view.distance_factor - 1.02).abs() < 1e-9);
    // Turns, which were right, stay so.
    assert!((view.base_factor / view.distance_factor - 360.0 / 350.0).abs() < 1e-9);
}

#[test]
fn a_broken_off_calibration_changes_nothing_and_says_so() {
    let mut wire = armed("model");
    wire.ask(Request::Calibrate { what: Calibration::Square });
    wire.pass(2.0);
    wire.ask(Request::Stop);
    let view = wire.view().calibration;
    assert_eq!((view.step, view.distance_factor, view.base_factor), ("failed", 1.0, 1.0));
    assert!(view.text.contains("nothing has changed"), "{}", view.text);
    wire.pass(1.0);
    assert!(!wire.is_rolling());
    assert!(wire.link.request(wire.now, Request::Answer { value: 1.0 }).is_err());
}

#[test]
fn a_stored_calibration_that_can_not_be_is_refused() {
    let mut wire = armed("model");
    let request = |base_factor| Request::UseCalibration { swapped: false, distance_factor: 1.0, base_factor };
    assert!(wire.link.request(wire.now, request(f64::NAN)).is_err());
    assert!(wire.link.request(wire.now, request(9.0)).is_err());
    wire.ask(request(1.1));
}

#[test]
fn a_question_is_not_driven_away_by_mistake() {
    let mut wire = armed("model");
    calibrate(&mut wire, Calibration::Metre);
    let requests = [Request::Drive { forward: 1.0, left: 0.0 }, Request::Calibrate { what: Calibration::Spin }];
    for request in requests {
        let refused = wire.link.request(wire.now, request).unwrap_err();
        assert!(refused.to_string().contains("answer or skip it first"), "{refused}");
    }
    wire.pass(1.0);
    assert!(!wire.is_rolling() && wire.view().calibration.step == "asking");
    wire.ask(Request::Skip);
    let view = wire.view().calibration;
    assert_eq!((view.step, view.distance_factor), ("failed", 1.0));
    assert!(view.text.contains("nothing has changed"), "{}", view.text);
    assert!(wire.link.request(wire.now, Request::Skip).is_err());
    wire.hold_ahead(0.5);
    assert!(wire.is_rolling());
}

#[test]
fn a_robot_that_something_stands_before_says_so_and_stops() {
    let mut wire = armed("model");
    // Two metres and a half to the wall.
    for what in [Calibration::Metre, Calibration::Metre, Calibration::Metre] {
        calibrate(&mut wire, what);
        if wire.view().calibration.step == "asking" {
            wire.ask(Request::Answer { value: 1.0 });
        }
    }
    let view = wire.view().calibration;
    assert_eq!((view.step, view.distance_factor), ("failed", 1.0), "{}", view.text);
    assert!(view.text.contains("in the way") && view.text.contains("Nothing has changed"), "{}", view.text);
    wire.pass(0.5);
    assert!(!wire.is_rolling());
}

#[test]
fn what_is_in_use_is_shown_before_anything_is_calibrated() {
    let mut wire = armed("model");
    wire.ask(Request::UseCalibration { swapped: false, distance_factor: 1.01, base_factor: 0.98 });
    let view = wire.view().calibration;
    assert_eq!((view.what, view.step, view.distance_factor, view.base_factor), ("", "none", 1.01, 0.98));
}

/// A hand puts it at `start`, where its estimate begins anew.
fn put_at(wire: &mut Wire, start: Pose) {
    wire.robot.apply(Input::PutDown(start));
    wire.link.put_at(wire.now, start);
    wire.pass(0.1);
}

/// The numbers of what was measured, in order, as a student reads them.
fn measured(wire: &mut Wire) -> Vec<f64> {
    wire.pass(1.0);
    let text = wire.view().calibration.measured.replace('−', "-");
    let words = text.split([' ', '(', ')', ',', '°']);
    words.filter_map(|word| word.trim_end_matches('.').parse().ok()).collect()
}

#[test]
fn put_at_the_start_its_estimate_is_there_wherever_it_was_before() {
    let start = Pose::new(2.0, 2.0, 0.5);
    let mut wire = armed("model");
    wire.hold_ahead(1.0);
    wire.ask(Request::Calibrate { what: Calibration::Square });
    wire.pass(2.0);
    put_at(&mut wire, start);
    let view = wire.view();
    assert_eq!((view.calibration.step, view.is_moving), ("failed", false));
    assert!((wire.pose().position() - start.position()).norm() < 0.01);
    let [x, y, heading] = view.pose;
    assert!((Point::new(x, y) - start.position()).norm() < 0.01 && (heading - 0.5).abs() < 0.02, "{:?}", view.pose);
    // A hand that puts it elsewhere tells it nothing.
    wire.robot.apply(Input::PutDown(Pose::new(4.0, 3.0, 0.0)));
    wire.link.moved_by_hand();
    wire.pass(0.1);
    assert_eq!(wire.view().pose, [x, y, heading]);
}

/// Means of what squares to one side show, true minus estimated: x and y, m.
fn mean_error(wire: &mut Wire, what: Calibration, start: Pose, squares: u32) -> Point {
    let mut sum = Point::new(0.0, 0.0);
    for _ in 0..squares {
        put_at(wire, start);
        calibrate(wire, what);
        let numbers = measured(wire);
        sum += Point::new(numbers[4], numbers[5]).coords;
        wire.ask(Request::Skip);
    }
    sum / f64::from(squares)
}

/// The mean errors of squares to the left and to the right.
fn umbmark(wire: &mut Wire, start: Pose) -> [Point; 2] {
    [Calibration::Square, Calibration::SquareRight].map(|what| mean_error(wire, what, start, 5))
}

// slow: the twenty squares of lesson 7 take the virtual robot a quarter of an hour
#[test]
fn umbmark_of_lesson_7_finds_the_wheel_base_by_what_the_page_shows_and_calibrating_makes_the_error_smaller() {
    const SEED: u64 = 6;
    let start = Pose::new(1.5, 2.0, 0.0);
    let conditions = Conditions { slip: SlipLevel::Harsh, ..Conditions::default() };
    let plan = (room("empty").unwrap().build)();
    let mut wire = Wire::new(&setup_in(&plan, conditions, SEED), "model");
    wire.connect();
    wire.arm();
    let before = umbmark(&mut wire, start);
    let corner = |[left, right]: [Point; 2]| -(left.x + right.x) / 4.0;
    let base = 235.0 * FRAC_PI_2 / (FRAC_PI_2 - corner(before));
    let real = Slip::new(SlipLevel::Harsh, SEED).wheel_base(235.0);
    assert!((base - real).abs() < 0.4 * (235.0 - real).abs(), "{base} mm, in truth {real} mm");
    for what in [Calibration::Spin, Calibration::Metre] {
        put_at(&mut wire, start);
        calibrate(&mut wire, what);
        let value = measured(&mut wire)[0];
        wire.ask(Request::Answer { value });
    }
    let after = umbmark(&mut wire, start);
    println!("{before:?} {after:?} {base} {real} {:?}", wire.view().calibration);
    assert!(corner(after).abs() < 0.3 * corner(before).abs(), "{before:?} {after:?}");
    for (before, after) in before.iter().zip(after) {
        assert!(after.coords.norm() < 0.6 * before.coords.norm(), "{before} {after}");
    }
}
