//! The diagnosis of every kind of robot.

use super::wire::{Wire, hall, moves, setup_in};
use robovac_link::{
    connection::{Request, TransportKind, TransportState, TransportView},
    emulator::PERSONALITIES,
};
use robovac_sim::Conditions;

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
