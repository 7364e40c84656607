//! A robot stops when it should, and never moves when it shouldn't.

use super::wire::{Wire, flat, hall, moves, setup_in};
use robovac_core::{geometry::Pose, registry::Params, robot::model};
use robovac_link::connection::{Calibration, PressedButton, Request, TrafficKind};
use robovac_sim::{
    Conditions, Input,
    controller::{self, Setup},
};
use roomba_oi::Mode;

/// The latest that a stop may reach the robot after the page has gone, s.
const LATEST_S: f64 = 0.25;

fn bounce() -> Box<dyn controller::Controller> {
    let info = controller::find("bounce").unwrap();
    let params = Params::defaults(info.params);
    info.build(&Setup { robot: model("roomba600").unwrap(), params: &params, seed: 7 }).unwrap()
}

fn riding() -> Wire {
    let mut wire = Wire::armed();
    wire.link.ride(wire.now, "Bounce", bounce(), Pose::new(3.0, 2.5, 0.0), false).unwrap();
    wire.pass(1.0);
    assert!(wire.is_rolling(), "{:?}", wire.view());
    wire
}

/// No command that moves is sent after `since`, and the robot stands `LATEST_S` (and its brakes' 0.5 s) later.
fn stays_stopped(wire: &mut Wire, since: f64) {
    wire.pass(3.0);
    let last = wire.last_motion().unwrap();
    assert!(last <= since + LATEST_S, "motion {:.3} s after", last - since);
    assert!(!wire.is_rolling());
}

#[test]
fn connecting_sends_no_motion_and_the_robot_stays_passive() {
    let wire = Wire::connected();
    assert!(wire.commands.iter().all(|(_, bytes)| !moves(bytes)), "{:?}", wire.commands);
    assert_eq!(wire.robot.mode(), Mode::Passive);
}

#[test]
fn nothing_drives_before_control_was_taken() {
    let mut wire = Wire::connected();
    assert!(wire.link.request(wire.now, Request::Drive { forward: 1.0, left: 0.0 }).is_err());
    assert!(wire.link.ride(wire.now, "Bounce", bounce(), Pose::new(0.0, 0.0, 0.0), false).is_err());
    assert!(wire.link.request(wire.now, Request::Calibrate { what: Calibration::Spin }).is_err());
    assert!(wire.link.request(wire.now, Request::Motors { bits: 7 }).is_err());
    wire.pass(1.0);
    assert!(wire.commands.iter().all(|(_, bytes)| !moves(bytes)));
}

#[test]
fn a_stick_that_is_held_drives_and_one_that_is_let_go_stops() {
    let mut wire = Wire::armed();
    wire.hold_ahead(1.0);
    assert!(wire.pose().x > 3.1, "{}", wire.pose());
    let let_go = wire.now;
    stays_stopped(&mut wire, let_go);
}

#[test]
fn a_page_that_hangs_stops_a_ride_in_time_and_lets_the_robot_go() {
    let mut wire = riding();
    wire.page_lives = false;
    let hung = wire.now;
    stays_stopped(&mut wire, hung);
    assert_eq!(wire.robot.mode(), Mode::Passive);
    // Coming back doesn't set it in motion.
    wire.page_lives = true;
    let back = wire.now;
    wire.pass(3.0);
    assert!(wire.last_motion().unwrap() < back);
    assert!(wire.view().notice.unwrap().text.contains("Take control again"));
}

#[test]
fn a_page_that_hung_stopped_the_robot_only_when_a_reading_came() {
    let mut wire = riding();
    wire.page_lives = false;
    let hung = wire.now;
    wire.pass(0.12);
    wire.fault = Some(Box::new(|_| Vec::new()));
    wire.pass(1.0);
    let last = wire.last_motion().unwrap();
    let stop = wire.commands.iter().find(|(at, bytes)| *at > last && bytes[..] == [145, 0, 0, 0, 0]).unwrap();
    assert!(stop.0 - hung < 0.2, "{} s", stop.0 - hung);
}

#[test]
fn a_stick_that_arrives_late_prolonged_the_life_of_a_page_that_hangs() {
    let mut wire = Wire::armed();
    wire.hold_ahead(1.0);
    wire.page_lives = false;
    let hung = wire.now;
    while wire.now - hung < 0.14 {
        wire.ask(Request::Drive { forward: 1.0, left: 0.0 });
        wire.pass(0.02);
    }
    wire.pass(1.0);
    assert!(wire.last_motion().unwrap() - hung < 0.2);
}

#[test]
fn a_page_that_is_slow_slows_the_robot_but_keeps_control() {
    let mut wire = riding();
    for _ in 0..40 {
        wire.page_lives = false;
        wire.pass(0.3);
        wire.page_lives = true;
        wire.pass(0.1);
    }
    let view = wire.view();
    assert!(!view.ride.as_ref().unwrap().done && view.mode == "Safe" && view.is_slowed, "{:?}", view.notice);
    assert!(view.doing.note.contains("responds slowly"), "{:?}", view.doing);
    let before = wire.view().distance_m;
    wire.pass(2.0);
    assert!(wire.view().distance_m > before, "it drives on");
    // A quick page gets the whole speed back.
    wire.pass(20.0);
    assert!(!wire.view().is_slowed);
}

#[test]
fn a_hidden_page_stops_at_once() {
    let mut wire = riding();
    wire.link.leave(wire.now, "The tab was hidden.");
    wire.flush();
    let hidden = wire.now;
    wire.pass(3.0);
    assert!(wire.last_motion().unwrap() <= hidden);
    assert!(!wire.is_rolling());
    assert_eq!(wire.robot.mode(), Mode::Passive);
}

#[test]
fn stop_and_disconnect_stop_at_once_and_leave_the_robot_off() {
    for request in
        [Request::Stop, Request::Disarm, Request::Disconnect, Request::Press { button: PressedButton::Power }]
    {
        let mut wire = riding();
        wire.ask(request.clone());
        wire.flush();
        let asked = wire.now;
        wire.pass(3.0);
        assert!(wire.last_motion().unwrap() <= asked, "{request:?}");
        assert!(!wire.is_rolling(), "{request:?}");
        if request == Request::Disconnect {
            assert_eq!(wire.robot.mode(), Mode::Off);
        }
    }
}

#[test]
fn a_robot_that_cleans_by_itself_stops_as_well() {
    for button in [PressedButton::Clean, PressedButton::Spot] {
        let mut wire = Wire::connected();
        wire.ask(Request::Press { button });
        wire.pass(3.0);
        assert!(wire.is_rolling(), "{button:?}");
        wire.ask(Request::Stop);
        wire.pass(1.0);
        assert!(!wire.is_rolling(), "{button:?}");
        wire.pass(5.0);
        assert!(!wire.is_rolling(), "{button:?}");
        assert_eq!(wire.robot.mode(), Mode::Passive);
    }
}

#[test]
fn brushes_stop_with_a_hanging_page() {
    let mut wire = Wire::armed();
    wire.ask(Request::Motors { bits: 7 });
    wire.pass(0.5);
    assert_ne!(wire.robot.take_display().motors.byte(), 0);
    wire.page_lives = false;
    wire.pass(0.5);
    assert_eq!(wire.robot.take_display().motors.byte(), 0);
}

#[test]
fn a_lifted_robot_says_why_it_stopped_and_can_be_taken_again() {
    let mut wire = riding();
    wire.robot.apply(Input::Lift);
    wire.pass(1.0);
    let drop = wire.view().drop.expect("a mode drop");
    assert_eq!(drop.from, "Safe");
    assert!(drop.text.contains("wheels have dropped"), "{drop:?}");
    let lifted = wire.now;
    let pose = wire.pose();
    wire.robot.apply(Input::PutDown(pose));
    wire.pass(2.0);
    assert!(wire.last_motion().unwrap() < lifted, "nothing moves by itself");
    assert!(wire.view().drop.unwrap().can_rearm);
    wire.arm();
    assert!(wire.view().drop.is_none());
    wire.hold_ahead(0.5);
    assert!(wire.is_rolling());
}

#[test]
fn a_cut_cable_ends_the_ride_and_a_plugged_one_begins_with_a_stop() {
    let mut wire = riding();
    wire.is_plugged = false;
    wire.link.lost(wire.now, "The cable was pulled.", false);
    wire.pass(1.0);
    assert!(wire.view().notice.unwrap().text.contains("may still be moving"));
    assert!(wire.is_rolling(), "nothing can be told to it");
    wire.is_plugged = true;
    let count = wire.commands.len();
    wire.link.opened(wire.now);
    wire.pass(0.2);
    let first: Vec<_> = wire.commands[count..].iter().map(|(_, bytes)| bytes[0]).collect();
    assert_eq!(first.iter().find(|&&byte| byte != 0), Some(&145), "{first:?}");
    wire.pass(0.4);
    assert!(!wire.is_rolling());
    wire.pass_until(10.0, |wire| wire.view().phase == "connected");
    wire.pass(1.0);
    assert!(wire.commands[count..].iter().all(|(_, bytes)| !moves(bytes)));
    assert!(!wire.view().can.drive, "only the user takes control again");
}

#[test]
fn a_robot_that_falls_silent_is_told_to_stop_again_and_again() {
    let mut wire = riding();
    wire.fault = Some(Box::new(|_| Vec::new()));
    let silent = wire.now;
    wire.pass(5.0);
    assert!(wire.last_motion().unwrap() - silent < 0.35);
    assert_eq!(wire.view().phase, "lost");
    wire.fault = None;
    wire.pass_until(3.0, |wire| wire.view().phase == "connected");
    wire.pass(1.0);
    assert!(!wire.is_rolling());
}

#[test]
fn a_page_that_hangs_loses_control_though_the_robot_was_stopped_for_its_own_silence_before() {
    let mut wire = Wire::armed();
    wire.hold_ahead(1.0);
    wire.page_lives = false;
    wire.stand_still(0.45);
    wire.pass(1.0);
    assert!(!wire.is_rolling());
    wire.page_lives = true;
    // The stick is still held.
    assert!(wire.link.request(wire.now, Request::Drive { forward: 1.0, left: 0.0 }).is_err());
    assert!(wire.view().notice.unwrap().text.contains("The page stopped responding"));
}

#[test]
fn a_robot_that_is_heard_again_goes_on_if_the_page_was_there() {
    let mut wire = Wire::armed();
    wire.hold_ahead(1.0);
    wire.stand_still(0.45);
    wire.pass(1.0);
    assert!(!wire.is_rolling());
    wire.hold_ahead(1.0);
    assert!(wire.is_rolling());
}

#[test]
fn a_robot_that_lost_the_stop_is_told_again() {
    let mut wire = riding();
    // Bytes of another program: the robot is commanded to drive without the driver.
    wire.ask(Request::Stop);
    wire.pass(1.0);
    wire.robot.receive(&[145, 0, 100, 0, 100], 115_200);
    wire.pass(0.02);
    assert!(wire.is_rolling());
    wire.pass(1.0);
    assert!(!wire.is_rolling());
}

#[test]
fn motion_typed_by_hand_lasts_until_the_stop() {
    let mut wire = Wire::armed();
    wire.ask(Request::Raw { bytes: vec![145, 0, 100, 0, 100] });
    wire.pass(2.0);
    assert!(wire.is_rolling(), "{:?}", wire.wheels());
    wire.ask(Request::Stop);
    wire.pass(1.0);
    assert!(!wire.is_rolling());
    assert!(wire.link.request(wire.now, Request::Raw { bytes: vec![] }).is_err());
    assert!(wire.link.request(wire.now, Request::Raw { bytes: vec![0; 300] }).is_err());
}

#[test]
fn a_robot_on_its_dock_says_why_it_can_not_be_controlled() {
    let mut wire = Wire::new(&setup_in(&flat(), Conditions::default(), 1), "docked");
    wire.connect();
    wire.ask(Request::Arm { full: false });
    wire.pass(2.0);
    let drop = wire.view().drop.expect("a mode drop");
    assert!(drop.text.contains("dock") && !drop.can_rearm, "{drop:?}");
    assert!(wire.commands.iter().all(|(_, bytes)| !moves(bytes)));
}

#[test]
fn a_ride_towards_a_wall_ends_at_it_by_hand() {
    let mut wire = Wire::new(&setup_in(&hall(), Conditions::default(), 1), "model");
    wire.connect();
    wire.arm();
    wire.hold_ahead(15.0);
    assert!(wire.bumped(), "{}", wire.pose());
    assert_eq!(wire.view().ride.unwrap().blocked[0], Some("bumper pressed in front"));
    assert!(wire.is_safe(), "a bumper changes no mode");
    assert!(!wire.is_rolling());
}

#[test]
fn a_question_that_waits_is_not_sent_after_the_stop() {
    for request in [Request::Stop, Request::Disarm] {
        let mut wire = Wire::armed();
        wire.ask(Request::Raw { bytes: vec![145, 0, 200, 0, 200, 142, 7] });
        wire.pass(0.02);
        wire.ask(request);
        wire.pass(2.0);
        assert!(wire.last_motion().is_none());
        assert!(!wire.is_rolling());
        assert_eq!(wire.view().phase, "connected");
        assert!(wire.view().statistics.rate_hz > 50.0, "the stream goes on");
    }
}

#[test]
fn a_question_is_answered_and_the_stream_goes_on() {
    let mut wire = Wire::armed();
    wire.link.take_traffic();
    wire.ask(Request::Raw { bytes: vec![142, 22] });
    wire.pass(0.5);
    let lines = wire.link.take_traffic();
    let answer = lines.iter().find(|line| line.kind == TrafficKind::Bytes).expect("an answer");
    assert!(answer.text.contains("mV") && !answer.text.contains("plausible"), "{answer:?}");
    assert!(wire.view().can.drive);
}

#[test]
fn a_robot_that_missed_being_given_back_is_told_when_it_is_heard_again() {
    let mut wire = riding();
    // The plug falls out on the robot's side; the tab is hidden, and it comes back much later.
    wire.is_plugged = false;
    wire.pass(1.0);
    wire.link.leave(wire.now, "The tab was hidden.");
    wire.pass(12.0);
    assert!(wire.is_rolling(), "nothing reached it");
    wire.is_plugged = true;
    wire.pass(3.0);
    assert!(!wire.is_rolling());
    assert_eq!(wire.robot.mode(), Mode::Passive);
}

#[test]
fn a_stall_warns_of_a_robot_that_may_be_moving() {
    let mut wire = riding();
    wire.fault = Some(Box::new(|_| Vec::new()));
    wire.pass(0.6);
    let notice = wire.view().notice.unwrap();
    assert!(notice.kind == "error" && notice.text.contains("may still be moving"), "{notice:?}");
}

#[test]
fn every_line_begins_with_a_stop_whatever_was_cut_off() {
    for cut in 1..5 {
        let mut wire = riding();
        // A page that crashed in the middle of a command; the next one knows nothing.
        wire.robot.receive(&[145, 0, 200, 0][..cut], 115_200);
        let before = wire.commands.len();
        wire.link = robovac_link::connection::Connection::new();
        wire.link.opened(wire.now);
        wire.pass(0.8);
        assert!(!wire.is_rolling(), "cut after {cut}");
        wire.pass_until(10.0, |wire| wire.view().phase == "connected");
        assert!(!wire.view().mode_offset, "cut after {cut}");
        assert_eq!(wire.robot.mode(), Mode::Passive);
        assert!(wire.commands[before..].iter().all(|(_, bytes)| !moves(bytes)));
    }
}

#[test]
fn whatever_way_to_drive_is_typed_a_hanging_page_ends_it() {
    for bytes in [vec![137, 0, 200, 128, 0], vec![146, 0, 100, 0, 100]] {
        let mut wire = Wire::armed();
        wire.ask(Request::Raw { bytes: bytes.clone() });
        wire.pass(1.0);
        assert!(wire.is_rolling(), "{bytes:?}");
        wire.page_lives = false;
        wire.pass(1.5);
        assert!(!wire.is_rolling(), "{bytes:?}");
    }
    let mut wire = Wire::armed();
    wire.ask(Request::Raw { bytes: vec![138, 7] });
    wire.pass(0.2);
    wire.page_lives = false;
    wire.pass(0.5);
    assert_eq!(wire.robot.take_display().motors.byte(), 0);
}

#[test]
fn stop_is_sent_while_it_is_still_found_out_who_is_there() {
    let mut wire = Wire::new(&setup_in(&hall(), Conditions::default(), 1), "model");
    wire.robot.receive(&[128, 131, 145, 0, 200, 0, 200], 115_200);
    wire.pass(1.0);
    assert!(wire.is_rolling());
    wire.link.opened(wire.now);
    // The first bytes of the line are lost.
    let _ = wire.link.take_tx();
    wire.pass(0.1);
    assert!(wire.is_rolling());
    wire.ask(Request::Stop);
    wire.pass(0.7);
    assert!(!wire.is_rolling());
}

#[test]
fn bytes_that_would_swallow_the_stop_are_refused() {
    let mut wire = Wire::armed();
    for (bytes, why) in [(vec![145, 0, 100], "Drive Direct"), (vec![140, 0, 255], "Song"), (vec![129, 7], "baud")] {
        let refused = wire.link.request(wire.now, Request::Raw { bytes }).unwrap_err().to_string();
        assert!(refused.contains(why), "{refused}");
    }
}

#[test]
fn a_stick_that_was_let_go_long_ago_drives_nothing_any_more() {
    let mut wire = Wire::armed();
    wire.hold_ahead(0.5);
    wire.pass(3.0);
    assert!(wire.view().ride.unwrap().done);
    let before = wire.last_motion();
    wire.page_lives = false;
    wire.pass(1.0);
    assert!(wire.is_safe(), "nothing moved, so nothing had to be stopped");
    assert_eq!(wire.last_motion(), before);
}
