//! What a person changes: walls, start, and where the robot is.

use super::{opened, play};
use robovac_app::explore::{Brush, Session, SessionState, diary};
use robovac_core::geometry::{Point, Pose};

#[test]
fn wall_is_drawn_planned_around_and_undone() {
    let mut session = opened();
    session.select_room("empty").unwrap();
    session.plan_now(|| 0.0);
    let before = session.planned().unwrap().walk.unwrap().reachable_cells;
    session.begin_stroke(Brush::Wall, Point::new(2.0, 1.5));
    session.go_on_stroke(Point::new(3.0, 2.5));
    session.end_stroke();
    assert_eq!(session.state(), SessionState::Planning);
    session.plan_now(|| 0.0);
    assert!(session.planned().unwrap().walk.unwrap().reachable_cells < before);
    assert_eq!(session.view().room.id, "");
    session.undo();
    session.plan_now(|| 0.0);
    assert_eq!((session.planned().unwrap().walk.unwrap().reachable_cells, session.view().room.id), (before, "empty"));
    assert!(session.view().can.redo);
}

#[test]
fn start_in_a_wall_is_refused_and_nothing_is_lost() {
    let mut session = opened();
    let run = session.view().run_end_s;
    session.move_start(Pose::new(-3.0, 0.0, 0.0));
    let view = session.view();
    assert_eq!(view.message_kind, "error");
    assert!(view.message.starts_with("The start at (-3.000 m, 0.000 m) lies outside the room"), "{}", view.message);
    assert!(session.planned().is_some() && view.run_end_s == run);
}

#[test]
fn robot_that_is_picked_up_drops_its_wheels_and_goes_on_elsewhere() {
    let mut session = Session::new();
    session.configure(|s| s.select_algorithm("bounce")).unwrap();
    session.run_ahead(20.0);
    let run = |session: &Session| session.recording().unwrap().run().pose();
    let before = run(&session);
    session.lift();
    session.run_ahead(2.0);
    assert!(session.is_lifted() && session.recording().unwrap().run().sensors().wheel_dropped());
    assert_eq!(run(&session), before, "it hangs in the air");
    session.put_down(Pose::new(4.0, 3.0, 1.0));
    session.run_ahead(0.1);
    let sensed = session.recording().unwrap().run().sensors();
    assert!(!sensed.wheel_dropped() && (run(&session).position() - Point::new(4.0, 3.0)).norm() < 0.1);
    let events: Vec<_> = session.recording().unwrap().run().events().iter().map(|e| e.what.to_string()).collect();
    for expected in ["lifted", "wheel drop", "put down"] {
        assert!(events.iter().any(|event| event == expected), "{expected} is missing in {events:?}");
    }
}

#[test]
fn time_is_real_while_one_holds_the_robot() {
    let mut session = opened();
    session.set_speed(64.0);
    session.lift();
    let before = session.view().time_s;
    play(&mut session, 2.0);
    let passed = session.view().time_s - before;
    assert!((passed - 2.0).abs() < 0.1, "{passed} s in two seconds");
    let there = session.recording().unwrap().run().pose();
    session.put_down(there);
    play(&mut session, 1.0);
    assert!(session.view().time_s - before > 60.0);
}

#[test]
fn a_kidnapped_planned_robot_is_told_to_go_on_blindly() {
    let mut session = opened();
    session.run_ahead(20.0);
    let there = session.recording().unwrap().run().pose();
    session.lift();
    session.put_down(there);
    assert_eq!(session.view().message, "", "it stands where it stood");
    session.lift();
    session.put_down(Pose::new(there.x + 0.4, there.y, there.heading));
    assert!(session.view().message.contains("can't detect that it was kidnapped"), "{}", session.view().message);
    session.run_ahead(1.0);
    let lines = diary(session.recording().unwrap().run(), true);
    assert!(lines.iter().any(|line| line.text.contains("put down, follows its plan as before")), "{lines:?}");
    // Unless it has sensed that it was lifted, and knows a dock.
    session.lift();
    session.run_ahead(1.0);
    session.put_down(there);
    assert!(session.view().message.contains("It searches for its dock"), "{}", session.view().message);
    session.run_ahead(1.0);
    let last = diary(session.recording().unwrap().run(), true).remove(0);
    assert!(last.text.contains("searching for the dock") && !last.text.contains("follows its plan"), "{last:?}");
    // Before that it was not.
    session.seek(10.0);
    assert_eq!(session.view().message, "");
    // A behaviour feels its way on.
    session.configure(|s| s.select_algorithm("bounce")).unwrap();
    session.run_ahead(20.0);
    session.lift();
    session.put_down(Pose::new(4.0, 3.0, 1.0));
    assert_eq!(session.view().message, "");
}

#[test]
fn what_a_person_did_happens_again_after_scrubbing() {
    let mut session = Session::new();
    session.configure(|s| s.select_algorithm("bounce")).unwrap();
    session.run_ahead(70.0);
    session.lift();
    session.run_ahead(1.0);
    session.put_down(Pose::new(4.0, 3.0, 1.0));
    session.run_ahead(100.0);
    let state = |session: &Session| session.recording().unwrap().run().digest();
    let (end, now) = (session.recording().unwrap().end_s(), state(&session));
    for back in [0.0, 70.5, 61.44, 120.0] {
        session.seek(back);
        while session.state() == SessionState::Seeking {
            session.frame(0.0, &mut || true);
        }
        session.seek(end);
        while session.state() == SessionState::Seeking {
            session.frame(0.0, &mut || true);
        }
        assert_eq!(state(&session), now, "after going back to {back} s");
    }
    session.seek(30.0);
    session.frame(0.0, &mut || true);
    session.lift();
    assert!((session.recording().unwrap().end_s() - 30.0).abs() < 0.02, "the future is another one");
}

#[test]
fn what_is_clean_stays_clean_when_the_room_is_changed() {
    let mut session = opened();
    session.run_ahead(600.0);
    let (before, again) = (session.view().coverage, session.view().overlap);
    assert!(before > 0.1 && again > 0.05, "{before} {again}");
    session.begin_stroke(Brush::Wall, Point::new(2.0, 1.5));
    session.go_on_stroke(Point::new(2.4, 1.5));
    session.end_stroke();
    // So it is while the new path is planned, which can take long.
    let view = session.view();
    assert!(view.state == SessionState::Planning && (view.coverage - before).abs() < 0.05, "{}", view.coverage);
    assert_eq!(view.swept_before, view.coverage);
    session.plan_now(|| 0.0);
    let view = session.view();
    assert!(view.overlap < 0.02, "the new run has swept next to nothing again: {}", view.overlap);
    assert!(view.time_s < 1.0 && (view.coverage - before).abs() < 0.05, "{} after {before}", view.coverage);
    assert!((view.swept_before - view.coverage).abs() < 0.01, "{}", view.swept_before);
    // A second change before the robot has moved, and its undo, lose nothing.
    session.begin_stroke(Brush::Wall, Point::new(3.0, 1.5));
    session.end_stroke();
    session.plan_now(|| 0.0);
    session.undo();
    session.plan_now(|| 0.0);
    assert!((session.view().coverage - before).abs() < 0.05, "{} after {before}", session.view().coverage);
    // Back to the start begins with a dirty floor, and so does another room.
    session.reset();
    assert!(session.view().coverage < 0.02 && session.view().swept_before == 0.0);
    session.run_ahead(300.0);
    session.select_room("empty").expect("it ships");
    session.plan_now(|| 0.0);
    assert!(session.view().coverage < 0.02);
}

#[test]
fn dirt_that_is_gone_stays_gone_while_another_path_is_planned_and_when_that_is_cancelled() {
    let mut session = opened();
    session.select_room("living").expect("it ships");
    session.plan_now(|| 0.0);
    session.run_ahead(3600.0);
    let before = session.view().dirt_left.expect("there is dirt");
    assert!(before < 0.9, "{before}");
    session.begin_stroke(Brush::Wall, Point::new(2.0, 1.5));
    session.end_stroke();
    for state in [SessionState::Planning, SessionState::Failed] {
        let view = session.view();
        let left = view.dirt_left.expect("there is dirt");
        assert!(view.state == state && (left - before).abs() < 1e-9, "{:?}: {left} after {before}", view.state);
        assert!(!session.scene().life.expect("the room has a cat").movers().is_empty());
        session.cancel_plan();
    }
}

#[test]
fn what_is_clean_stays_clean_with_rounded_corners_too() {
    let mut session = opened();
    session
        .configure(|settings| {
            settings.smooth = true;
            Ok(())
        })
        .unwrap();
    session.plan_now(|| 0.0);
    session.run_ahead(600.0);
    let before = session.view().coverage;
    assert!(before > 0.1, "{before}");
    session.begin_stroke(Brush::Wall, Point::new(2.0, 1.5));
    session.go_on_stroke(Point::new(2.4, 1.5));
    session.end_stroke();
    session.plan_now(|| 0.0);
    for change in [None, Some(Session::undo as fn(&mut Session)), Some(Session::redo)] {
        if let Some(change) = change {
            change(&mut session);
            session.plan_now(|| 0.0);
        }
        let view = session.view();
        assert!(session.planned().unwrap().smooth.is_some());
        assert!((view.coverage - before).abs() < 0.05 && view.swept_before > 0.1, "{} after {before}", view.coverage);
    }
    // Back at the start the floor is dirty, and the corners are still rounded.
    session.reset();
    assert!(session.view().coverage < 0.02 && session.view().swept_before == 0.0);
    let expected = session.planned().unwrap().drive.duration_s;
    session.run_ahead(6.0 * 3600.0);
    let view = session.view();
    assert!((view.time_s - expected).abs() < 0.03 * expected, "{} s, not {expected} s", view.time_s);
}

#[test]
fn the_end_of_a_run_without_a_plan_knows_the_least_distance_for_as_much_floor() {
    let mut session = opened();
    session.restore("room=thesis8&behaviour=online_snake&robot=cbot").unwrap();
    session.run_ahead(5.0);
    assert_eq!(session.view().least_m, None, "it goes on");
    super::finish(&mut session);
    let view = session.view();
    let (least, width) = (view.least_m.unwrap(), session.settings().robot_model().tool_width);
    // A disc as wide as the tool sweeps no more per metre, but for itself at the start.
    let strip = view.coverage * session.prepared().unwrap().floor.area() / width;
    assert!(strip - width < least && least < strip && least < view.distance_m, "{least} m, {strip} m");
    let (least_s, top_speed) = (view.least_s.unwrap(), session.settings().robot_model().max_wheel_speed);
    assert!((least_s - least / top_speed).abs() < 1e-9 && least_s < view.time_s, "{least_s} s of {} s", view.time_s);
    session.restore("room=thesis8&planner=snake&robot=cbot").unwrap();
    session.plan_now(|| 0.0);
    super::finish(&mut session);
    assert_eq!(session.view().least_m, None, "a plan has its own");
}
