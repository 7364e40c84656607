//! A user's session from opening to undo, without a browser.

mod changes;
mod planning;
mod saved;
mod search;

use robovac_app::explore::{Session, SessionState};
use robovac_core::floor_plan::{Object, ROOMS};

fn opened() -> Session {
    let mut session = Session::new();
    session.plan_now(|| 0.0);
    session
}

/// Lets the session run for `seconds` of display time at its speed, with all the computing time it wants.
fn play(session: &mut Session, seconds: f64) {
    for _ in 0..(seconds * 60.0) as u32 {
        session.frame(1.0 / 60.0, &mut || true);
    }
}

fn finish(session: &mut Session) {
    session.set_speed(0.0);
    session.play();
    session.frame(1.0 / 60.0, &mut || true);
}

#[test]
fn opens_with_a_robot_that_cleans_the_flat() {
    let mut session = Session::new();
    assert_eq!(session.state(), SessionState::Planning);
    session.plan_now(|| 0.0);
    assert_eq!(session.state(), SessionState::Playing);
    play(&mut session, 1.0);
    let view = session.view();
    assert!((view.time_s - 16.0).abs() < 0.1, "{} s after a second at 16x", view.time_s);
    assert!(view.coverage > 0.0 && view.distance_m > 1.0);
    assert!(view.can.pause && !view.can.play && view.can.seek);
}

#[test]
fn a_behaviour_whose_battery_is_empty_says_so_and_not_what_it_was_about_to_do() {
    let mut session = opened();
    session.restore("room=empty&behaviour=bounce&charge=1").unwrap();
    session.plan_now(|| 0.0);
    finish(&mut session);
    let view = session.view();
    assert_eq!((view.state, view.activity), (SessionState::Finished, "battery empty"));
}

// slow: the contract of the rooms that ship: each is planned and driven to its end
#[test]
fn every_room_is_cleaned_to_the_end() {
    for room in ROOMS {
        let mut session = opened();
        session.select_room(room.id).unwrap();
        session.plan_now(|| 0.0);
        assert!(session.planned().is_some(), "{}: {}", room.id, session.view().message);
        let planned = session.planned().unwrap().clone();
        assert!(planned.walk.unwrap().is_complete(), "{}", room.id);
        finish(&mut session);
        let view = session.view();
        assert_eq!(session.state(), SessionState::Finished, "{}", room.id);
        // A follower that waits for people in the way can leave some floor out.
        let is_alone = !session.plan().objects.iter().any(|object| matches!(object, Object::Mover { .. }));
        let (least, spare) = if is_alone { (0.95, 0.01) } else { (0.9, 0.05) };
        assert!(view.coverage > least, "{}: {:.4} covered of {:.4}", room.id, view.coverage, planned.drive.coverage);
        assert!(view.coverage > planned.drive.coverage - spare, "{}", room.id);
    }
}

#[test]
fn textbook_robot_cleans_the_empty_room_to_the_last_cell() {
    let mut session = opened();
    session.restore("room=empty&robot=cell&cell=0.2").unwrap();
    session.plan_now(|| 0.0);
    finish(&mut session);
    assert_eq!(session.view().coverage, 1.0);
}

#[test]
fn scrubbing_back_and_forth_shows_the_same_moment() {
    let mut session = opened();
    session.set_speed(1024.0);
    play(&mut session, 1.0);
    session.pause();
    let at_end = session.recording().unwrap().run().digest();
    let end = session.view().time_s;
    session.seek(123.45);
    while session.state() == SessionState::Seeking {
        session.frame(0.0, &mut || true);
    }
    assert!((session.view().time_s - 123.45).abs() < 0.015);
    assert_eq!(session.view().run_end_s, end);
    let there = session.recording().unwrap().run().digest();
    session.seek(end);
    while session.state() == SessionState::Seeking {
        session.frame(0.0, &mut || true);
    }
    assert_eq!(session.recording().unwrap().run().digest(), at_end);
    session.seek(123.45);
    session.frame(0.0, &mut || true);
    assert_eq!(session.recording().unwrap().run().digest(), there);
}

#[test]
fn busy_machine_slows_time_instead_of_skipping() {
    let mut session = opened();
    session.set_speed(1024.0);
    let mut looks = 0;
    session.frame(0.1, &mut || {
        looks += 1;
        looks <= 3
    });
    assert!(session.view().time_s < 5.0, "{}", session.view().time_s);
}

#[test]
fn step_moves_by_about_a_cell() {
    let mut session = opened();
    session.reset();
    assert_eq!(session.state(), SessionState::Ready);
    for _ in 0..5 {
        let before = session.view();
        session.step();
        let after = session.view();
        assert!(after.time_s > before.time_s);
        assert!(after.distance_m - before.distance_m <= session.settings().cell_size + 0.01);
    }
    assert_eq!(session.state(), SessionState::Paused);
}
