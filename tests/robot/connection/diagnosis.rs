//! The diagnosis of every kind of robot.

use super::wire::{Wire, hall, moves, roomba, setup_in};
use robovac_core::geometry::Point;
use robovac_link::{
    connection::{Calibration, Request, TransportKind, TransportState, TransportView},
    emulator::{PERSONALITIES, Personality, personality},
};
use robovac_sim::{Conditions, controller::FollowPath};
use roomba_oi::Packet;
use std::sync::Arc;

fn opened(personality: &str, seconds: f64) -> Wire {
    let mut wire = Wire::new(&setup_in(&hall(), Conditions::default(), 1), personality);
    wire.link.opened(wire.now);
    wire.pass(seconds);
    wire
}

#[test]
fn no_personality_is_moved_by_being_asked_who_it_is() {
    for personality in PERSONALITIES {
        let wire = opened(personality.id, 20.0);
        assert!(wire.commands.iter().all(|(_, bytes)| !moves(bytes)), "{}", personality.id);
        assert!(!wire.is_rolling(), "{}", personality.id);
    }
}

#[test]
fn a_robot_by_the_book_is_there_within_a_second() {
    let mut wire = opened("model", 1.0);
    let view = wire.view();
    assert_eq!((view.phase, view.diagnosis.finding, view.statistics.baud), ("connected", "robot", 115_200));
    assert!(!view.mode_offset);
    assert_eq!(view.statistics.slot, [84, 172]);
}

#[test]
fn a_mode_byte_that_is_one_too_high_is_found_out() {
    let mut wire = opened("mode_plus_one", 1.5);
    let view = wire.view();
    assert_eq!((view.phase, view.mode), ("connected", "Passive"));
    assert!(view.mode_offset);
    wire.arm();
    assert_eq!(wire.view().mode, "Safe");
}

#[test]
fn a_sleeping_robot_is_woken_by_one_long_pulse() {
    let mut wire = opened("asleep", 8.0);
    let view = wire.view();
    assert_eq!(view.phase, "connected", "{view:?}");
    assert!(view.diagnosis.log.iter().any(|line| line.contains("BRC")), "{view:?}");
}

#[test]
fn without_the_wire_the_user_is_asked_to_press_clean_and_that_is_enough() {
    let mut wire = opened("no_brc", 20.0);
    let view = wire.view();
    assert_eq!((view.phase, view.diagnosis.finding), ("waiting", "silence"), "{view:?}");
    assert!(view.diagnosis.remedy.contains("CLEAN"));
    wire.robot.press(roomba_oi::Buttons { clean: true, ..Default::default() });
    wire.pass_until(8.0, |wire| wire.view().phase == "connected");
}

#[test]
fn a_line_without_a_rate_and_a_wire_is_asked_at_once_and_told_apart() {
    for (personality, is_own_usb, picture) in [("silent", false, "asleep"), ("silent", true, "usb")] {
        let mut wire = Wire::new(&setup_in(&hall(), Conditions::default(), 1), personality);
        let (kind, state) = (TransportKind::Serial, TransportState::Open);
        wire.link.set_transport(TransportView { kind, state, is_own_usb, ..Default::default() });
        wire.link.opened(wire.now);
        wire.pass(2.0);
        let view = wire.view();
        assert_eq!((view.phase, view.diagnosis.picture, view.statistics.baud), ("waiting", picture, 115_200));
        assert!(view.diagnosis.log.iter().all(|line| !line.contains("BRC")), "{view:?}");
    }
}

#[test]
fn a_robot_that_falls_silent_is_not_taken_for_a_pulled_cable() {
    let mut wire = Wire::connected();
    let (kind, state) = (TransportKind::Serial, TransportState::Open);
    wire.link.set_transport(TransportView { kind, state, ..Default::default() });
    wire.link.tick(wire.now + 5.0);
    let view = wire.link.view(wire.now + 5.0);
    assert_eq!((view.phase, view.diagnosis.picture), ("lost", "asleep"));
    assert!(view.diagnosis.caption.note.contains("CLEAN"), "{:?}", view.diagnosis.caption);
}

#[test]
fn a_slow_robot_is_found_at_19200_with_what_fits_into_its_slot() {
    let mut wire = opened("slow", 12.0);
    let view = wire.view();
    assert_eq!((view.phase, view.statistics.baud), ("connected", 19_200), "{view:?}");
    assert!(view.statistics.slot[0] <= view.statistics.slot[1], "{:?}", view.statistics.slot);
    wire.arm();
    wire.hold_ahead(1.0);
    assert!(wire.is_rolling());
}

/// Of the packets of a Create 1, at its rate, and at the only rate of a Roomba 900's own USB port (`create_robot`, issue 106).
#[test]
fn a_robot_without_counts_drives_by_distance_and_angle() {
    let create = personality("create1").unwrap();
    let own_usb = Personality { default_baud: 115_200, baud: 115_200, ..create.clone() };
    for (who, is_own_usb) in [(create, false), (&own_usb, true)] {
        let mut wire = Wire::with(&setup_in(&hall(), Conditions::default(), 1), who);
        let (kind, state) = (TransportKind::Serial, TransportState::Open);
        let can_baud = !is_own_usb;
        wire.link.set_transport(TransportView { kind, state, is_own_usb, can_baud, ..Default::default() });
        wire.connect();
        let view = wire.view();
        assert_eq!((view.diagnosis.finding, view.statistics.baud), ("robot", who.baud), "{view:?}");
        assert!(view.notice.is_some_and(|notice| notice.text.contains("Create 1")));
        assert!(!wire.link.receives(Packet::LeftEncoder) && wire.link.receives(Packet::Voltage));
        assert!(wire.link.request(wire.now, Request::Calibrate { what: Calibration::Nudge }).is_err());
        wire.arm();
        let start = wire.pose();
        let line: Arc<[Point]> =
            [(3.0, 2.5), (4.5, 2.5), (4.5, 3.5), (3.0, 3.5)].into_iter().map(|(x, y)| Point::new(x, y)).collect();
        let follower = FollowPath::new(&wire.link.calibrated(&roomba()), wire.link.odometry(), start, line);
        wire.link.ride(wire.now, "Line", Box::new(follower), start, false).unwrap();
        wire.pass_until(60.0, |wire| wire.view().ride.unwrap().done);
        wire.pass(1.0);
        let (end, [x, y, _]) = (wire.pose(), wire.view().pose);
        let [missed, off] = [(3.0, 3.5), (x, y)].map(|(x, y)| (end.position() - Point::new(x, y)).norm());
        assert!(missed < 0.15 && off < 0.15, "{who:?}: ended at {end}, {missed} m away; it believes {x}, {y}");
        // A page that hangs stops it as any other.
        wire.hold_ahead(1.0);
        assert!(wire.is_rolling());
        wire.page_lives = false;
        let stopped = wire.pass_until(1.0, |wire| wire.last_motion().is_some_and(|at| wire.now - at > 0.1));
        assert!(stopped < 0.35, "{stopped}");
        wire.pass(1.0);
        assert!(!wire.is_rolling());
    }
}

#[test]
fn an_answer_without_any_stream_is_told() {
    let mut wire = Wire::new(&setup_in(&hall(), Conditions::default(), 1), "model");
    // Its answer is one byte.
    wire.fault = Some(Box::new(|bytes| if bytes.len() > 1 { Vec::new() } else { bytes }));
    wire.link.opened(wire.now);
    wire.pass(8.0);
    assert_eq!((wire.view().phase, wire.view().diagnosis.finding), ("waiting", "no_stream"), "{:?}", wire.view());
}

#[test]
fn a_bootloader_and_a_silent_line_are_told_apart() {
    let mut wire = opened("bootloader", 2.0);
    wire.ask(Request::Identify);
    wire.pass(20.0);
    let view = wire.view();
    assert_eq!((view.phase, view.diagnosis.finding), ("waiting", "bootloader"), "{view:?}");
    let mut wire = opened("silent", 20.0);
    assert_eq!((wire.view().phase, wire.view().diagnosis.finding), ("waiting", "silence"));
}

#[test]
fn chatter_is_shown_and_does_not_disturb() {
    for personality in ["chatty", "docked"] {
        let mut wire = opened(personality, 8.0);
        let view = wire.view();
        assert_eq!(view.phase, "connected", "{personality}: {view:?}");
        wire.pass(5.0);
        let view = wire.view();
        assert_eq!(view.phase, "connected");
        assert!(view.statistics.texts > 2, "{personality}: {:?}", view.statistics);
        assert!(view.statistics.frames > 500);
    }
}

#[test]
fn the_others_connect_as_well() {
    for personality in ["angle_bug", "noisy", "swapped", "wrap"] {
        let mut wire = opened(personality, 5.0);
        assert_eq!(wire.view().phase, "connected", "{personality}: {:?}", wire.view());
    }
}
