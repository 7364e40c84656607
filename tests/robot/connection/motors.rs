//! Brushes, vacuum and lights: what runs, when it stops, and what is shown of it.

use super::wire::{Wire, hall, roomba, setup_in};
use robovac_core::{
    floor_plan::{FloorPlan, Object},
    geometry::{Point, Pose},
    registry::Params,
    robot::OdometryModel,
};
use robovac_link::connection::{LineRecording, PressedButton, Replay, Request, SWEEPS};
use robovac_sim::{
    Conditions, Input,
    controller::{BEHAVIOURS, Controller, FollowPath, Setup, find},
    experiment::Algorithm,
};
use roomba_oi::Mode;

/// What happens to a robot, and its name.
type Event = (&'static str, fn(&mut Wire));

const START: Pose = Pose { x: 3.0, y: 2.5, heading: 0.0 };

/// Drives 1.2 m ahead.
fn ahead() -> Box<dyn Controller> {
    let line = [3.0, 4.2].map(|x| Point::new(x, 2.5));
    Box::new(FollowPath::new(&roomba(), OdometryModel::Arc, START, line.into()))
}

fn bounce() -> Box<dyn Controller> {
    let info = find("bounce").unwrap();
    info.build(&Setup { robot: &roomba(), params: &Params::defaults(info.params), seed: 7 }).unwrap()
}

fn riding(cleans: bool) -> Wire {
    let mut wire = Wire::armed();
    wire.link.ride(wire.now, "Bounce", bounce(), START, cleans).unwrap();
    wire.pass(0.5);
    assert!(wire.is_rolling());
    wire
}

/// Motors that run, and those that the page shows.
fn motors(wire: &mut Wire) -> [u8; 2] {
    [wire.robot.take_display().motors.byte(), wire.view().motors]
}

#[test]
fn the_dirt_under_a_cleaning_ride_is_gone_and_stays_under_others() {
    let objects = vec![Object::Dirt { at: Point::new(3.7, 2.5), radius: 0.07 }];
    for cleans in [true, false] {
        let mut wire =
            Wire::new(&setup_in(&FloorPlan { objects: objects.clone(), ..hall() }, Conditions::default(), 1), "model");
        wire.connect();
        wire.arm();
        wire.link.ride(wire.now, "Line", ahead(), START, cleans).unwrap();
        wire.pass(0.5);
        assert_eq!(motors(&mut wire), if cleans { [7; 2] } else { [0; 2] });
        assert_eq!(wire.view().doing.note.ends_with("brushes and vacuum on"), cleans);
        wire.pass_until(60.0, |wire| wire.view().ride.unwrap().done);
        let left = wire.robot.life().dirt_left();
        assert!(if cleans { left < 1e-9 } else { left == 1.0 }, "{left}");
        wire.pass(0.1);
        assert_eq!(motors(&mut wire), [0; 2], "they stop with the ride");
        let recording = wire.link.recording();
        assert_eq!(recording.contains("\"cleans\":true"), cleans);
        assert_eq!(recording.contains("cleans"), cleans);
    }
}

#[test]
fn whatever_ends_a_cleaning_ride_stops_the_brushes() {
    let clean = Request::Press { button: PressedButton::Power };
    let bytes = Request::Raw { bytes: vec![142, 35] };
    for request in [Request::Stop, Request::Disarm, Request::Disconnect, Request::Identify, clean, bytes] {
        let mut wire = riding(true);
        assert_eq!(motors(&mut wire), [7; 2]);
        wire.ask(request.clone());
        assert_eq!(wire.view().motors, 0, "{request:?}");
        wire.pass(0.2);
        assert_eq!(motors(&mut wire), [0; 2], "{request:?}");
    }
    let events: [Event; 6] = [
        ("lifted", |wire| wire.robot.apply(Input::Lift)),
        ("charger", |wire| wire.robot.plug_charger(true)),
        ("hung", |wire| wire.page_lives = false),
        ("left", |wire| wire.link.leave(wire.now, "The tab was hidden.")),
        ("paused", |wire| wire.link.pause(wire.now)),
        ("another ride", |wire| wire.link.ride(wire.now, "Line", ahead(), START, false).unwrap()),
    ];
    for (what, happens) in events {
        let mut wire = riding(true);
        happens(&mut wire);
        wire.pass(0.6);
        assert_eq!(motors(&mut wire), [0; 2], "{what}");
    }
}

#[test]
fn brushes_that_did_not_hear_the_stop_are_told_again_by_a_robot_that_returns() {
    let mut wire = riding(true);
    wire.is_plugged = false;
    wire.pass(2.0);
    // A stop was sent into nothing.
    assert_eq!(motors(&mut wire), [7, 0]);
    wire.is_plugged = true;
    wire.pass(1.0);
    assert_eq!((motors(&mut wire), wire.is_rolling()), ([0; 2], false));
}

#[test]
fn a_lost_line_shows_no_brushes() {
    let mut wire = riding(true);
    wire.is_plugged = false;
    wire.link.lost(wire.now, "The cable was pulled.", false);
    assert_eq!(wire.view().motors, 0);
    assert!(!wire.link.is_acting());
    let text = wire.view().notice.unwrap().text;
    assert!(text.contains("stops its wheels and brushes"), "{text}");
}

#[test]
fn brushes_switched_on_by_hand_outlast_the_stick_and_other_rides() {
    let mut wire = Wire::armed();
    wire.ask(Request::Motors { bits: 0b1_0110 });
    wire.hold_ahead(0.5);
    assert_eq!(wire.view().doing.note, "main brush and vacuum on");
    wire.pass(3.0);
    assert!(wire.view().ride.unwrap().done);
    assert_eq!(motors(&mut wire), [0b1_0110; 2]);
    assert!(wire.view().doing.note.ends_with("; main brush and vacuum on"), "{:?}", wire.view().doing);
    wire.link.ride(wire.now, "Line", ahead(), START, false).unwrap();
    wire.pass(0.5);
    assert_eq!(motors(&mut wire), [0b1_0110; 2]);
    wire.ask(Request::Stop);
    wire.pass(0.1);
    assert_eq!(motors(&mut wire), [0; 2]);
}

#[test]
fn whoever_disconnects_in_mid_ride_can_choose_again() {
    let mut wire = riding(false);
    assert!(wire.view().is_moving);
    wire.ask(Request::Disconnect);
    wire.pass(0.5);
    let view = wire.view();
    assert!(!view.is_open && !view.is_moving, "odometry and algorithm wait for a robot that stands");
    wire.link.opened(wire.now);
    assert!(wire.view().ride.is_none(), "the next robot begins anew");
}

#[test]
fn whoever_disconnects_after_a_ride_that_ended_by_itself_begins_anew() {
    let mut wire = riding(false);
    wire.pass(1.0);
    wire.ask(Request::Stop);
    wire.pass(0.5);
    assert!(wire.view().ride.is_some_and(|ride| ride.done) && wire.view().distance_m > 0.0);
    wire.ask(Request::Disconnect);
    wire.link.opened(wire.now);
    assert!(wire.view().ride.is_none() && wire.view().distance_m == 0.0);
    // The line that comes back by itself is another matter.
    let mut wire = riding(false);
    wire.pass(1.0);
    wire.link.lost(wire.now, "The cable was pulled.", false);
    wire.link.opened(wire.now);
    assert!(wire.view().ride.is_some());
}

/// Flags of the trace since the last call: whether it swept at all, and all the time.
fn swept(wire: &mut Wire) -> [bool; 2] {
    let trace = wire.link.take_trace();
    let flags: Vec<bool> = trace.as_chunks::<4>().0.iter().map(|point| point[3] as u16 & SWEEPS != 0).collect();
    assert!(!flags.is_empty());
    [flags.contains(&true), !flags.contains(&false)]
}

#[test]
fn floor_counts_as_swept_while_the_main_brush_runs() {
    let mut wire = Wire::armed();
    wire.hold_ahead(0.3);
    assert_eq!(swept(&mut wire), [false; 2]);
    for (bits, sweeps) in [(4, true), (3, false), (0b1_0100, false), (0, false)] {
        wire.ask(Request::Motors { bits });
        wire.hold_ahead(0.2);
        let _ = wire.link.take_trace();
        wire.hold_ahead(0.2);
        assert_eq!(swept(&mut wire), [sweeps; 2], "{bits:05b}");
    }
    // By its own program.
    wire.ask(Request::Press { button: PressedButton::Clean });
    wire.pass(1.0);
    let _ = wire.link.take_trace();
    wire.pass(1.0);
    assert_eq!((swept(&mut wire), wire.view().motors), ([true; 2], 0));
}

#[test]
fn motors_and_lights_are_shown_as_they_are() {
    let mut wire = Wire::armed();
    let lights = |wire: &mut Wire| {
        let (display, lights) = (wire.robot.take_display(), wire.view().lights);
        if wire.robot.mode() >= Mode::Safe {
            assert_eq!((lights.lamps, lights.clean_light), (display.lamps.byte(), display.clean_light));
            assert_eq!(lights.digits.as_bytes(), display.digits);
            assert_eq!((lights.weekdays, lights.schedule), (display.weekdays.byte(), display.schedule.byte()));
        }
        assert_eq!(wire.view().motors, display.motors.byte());
        (lights.lamps, lights.digits)
    };
    let all = [
        Request::Leds { lamps: 5, colour: 200, intensity: 100 },
        Request::Digits { text: "HI".into() },
        Request::ScheduleLeds { weekdays: 0b100_0001, lamps: 0b1_0001 },
        Request::Motors { bits: 3 },
    ];
    let on = |wire: &mut Wire| {
        for request in all.clone() {
            wire.ask(request);
        }
        wire.pass(0.1);
        assert_eq!((lights(wire), wire.view().motors), ((5, "HI  ".into()), 3));
    };
    on(&mut wire);
    // A stop in Safe ends what moves, and leaves the lights on.
    wire.ask(Request::Stop);
    wire.pass(0.1);
    assert_eq!((lights(&mut wire), wire.view().motors), ((5, "HI  ".into()), 0));
    for end in [Request::Disarm, Request::Raw { bytes: vec![128] }] {
        on(&mut wire);
        wire.ask(end);
        wire.pass(0.2);
        assert_eq!((lights(&mut wire), wire.view().motors), ((0, "    ".into()), 0));
        wire.arm();
        assert_eq!(lights(&mut wire).0, 0, "Safe begins in the dark");
    }
    on(&mut wire);
    wire.robot.apply(Input::Lift);
    wire.pass(0.2);
    assert_eq!((lights(&mut wire), wire.view().motors), ((0, "    ".into()), 0));
    // Passive ignores them.
    wire.ask(Request::Raw { bytes: vec![138, 7] });
    wire.pass(0.1);
    assert_eq!(motors(&mut wire), [0; 2]);
}

#[test]
fn duty_cycles_run_the_brushes_and_turn_the_wheels_while_they_are_renewed() {
    let mut wire = Wire::armed();
    wire.ask(Request::PwmMotors { main_brush: 64, side_brush: -127, vacuum: 0 });
    wire.pass(0.1);
    assert_eq!((motors(&mut wire), wire.view().duty), ([0b0_1101; 2], [64, -127, 0]));
    wire.ask(Request::Stop);
    assert!(wire.link.request(wire.now, Request::DrivePwm { right: 300, left: 0 }).is_err());
    let from = wire.pose();
    for _ in 0..20 {
        wire.ask(Request::DrivePwm { right: 120, left: 120 });
        wire.pass(0.05);
    }
    let view = wire.view();
    assert!(view.is_moving && !view.can.ride && view.doing.title == "Driven without checks", "{:?}", view.doing);
    assert!((wire.pose().position() - from.position()).norm() > 0.1);
    wire.pass(0.8);
    assert!(!wire.is_rolling() && !wire.view().is_moving, "nobody renewed them");
    wire.ask(Request::DrivePwm { right: 120, left: -120 });
    wire.pass(0.1);
    assert!(wire.is_rolling());
    wire.ask(Request::DrivePwm { right: 0, left: 0 });
    wire.pass(0.3);
    assert!(!wire.is_rolling());
}

#[test]
fn clock_and_schedule_make_it_clean_by_itself() {
    let mut wire = Wire::connected();
    let bad = wire.link.request(wire.now, Request::Clock { day: 7, hour: 0, minute: 0 }).unwrap_err();
    assert!(bad.to_string().contains("day of the week"), "{bad}");
    wire.ask(Request::Clock { day: 1, hour: 13, minute: 58 });
    wire.ask(Request::Schedule { days: 0b10, times: [[13, 59]; 7] });
    wire.pass(55.0);
    assert!(!wire.robot.runs_builtin_program());
    wire.pass_until(10.0, |wire| wire.robot.runs_builtin_program());
    wire.ask(Request::Stop);
    wire.ask(Request::Press { button: PressedButton::Max });
    wire.pass_until(5.0, |wire| wire.robot.runs_builtin_program());
}

#[test]
fn a_replay_shows_the_brushes_of_then() {
    let mut wire = riding(true);
    let during = wire.now - 100.0;
    wire.ask(Request::Stop);
    wire.pass(0.5);
    let mut replay = Replay::new(LineRecording::parse(&wire.link.recording()).unwrap());
    replay.advance(during);
    assert_eq!(replay.view().motors, 7);
    assert!(replay.take_trace().as_chunks::<4>().0.iter().any(|point| point[3] as u16 & SWEEPS != 0));
    replay.advance(f64::INFINITY);
    assert_eq!(replay.view().motors, 0);
}

#[test]
fn exploring_and_docking_do_not_clean() {
    let cleaning: Vec<_> = Algorithm::all().filter(|algorithm| algorithm.cleans()).map(Algorithm::id).collect();
    assert!(cleaning.contains(&"boustrophedon") && cleaning.contains(&"bounce"));
    for info in BEHAVIOURS.iter().filter(|info| info.claims.explores || info.claims.manual || info.id == "dock") {
        assert!(!cleaning.contains(&info.id), "{}", info.id);
    }
}
