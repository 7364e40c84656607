//! A user's session from opening to undo, without a browser.

use coverage_planners::{CoveragePath, ProgressReport, Proof};
use robovac_app::explore::{Brush, Session, SessionSnapshot, SessionState, diary};
use robovac_core::{
    floor_plan::{Object, ROOMS, SourceFile},
    geometry::{Point, Pose},
    grid::Cell,
};
use robovac_sim::experiment::{SettingsError, planning::PlanAnswer};
use std::ops::ControlFlow;

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
fn link_brings_the_same_session_back() {
    let mut session = opened();
    session.restore("#room=lshape&planner=snake&robot=cell&cell=0.25&seed=9&slip=typical").unwrap();
    session.move_start(Pose::new(1.0, 1.0, 1.5));
    let link = session.link();
    let mut other = opened();
    other.restore(&link).unwrap();
    assert_eq!(other.link(), link);
    session.plan_now(|| 0.0);
    other.plan_now(|| 0.0);
    finish(&mut session);
    finish(&mut other);
    let digest = |s: &Session| s.recording().unwrap().run().digest();
    assert_eq!(digest(&session), digest(&other));
}

#[test]
fn rounded_corners_take_less_time_and_are_kept_by_links_and_scenarios() {
    let mut session = opened();
    session.select_room("bedroom").unwrap();
    session.plan_now(|| 0.0);
    let stopping = session.planned().unwrap().drive;
    assert!(!session.link().contains("smooth") && !session.view().smooth);
    session
        .configure(|settings| {
            settings.smooth = true;
            Ok::<(), SettingsError>(())
        })
        .unwrap();
    session.plan_now(|| 0.0);
    let smooth = session.planned().unwrap().clone();
    assert!(smooth.drive.duration_s < 0.9 * stopping.duration_s, "{:?} {stopping:?}", smooth.drive);
    finish(&mut session);
    let view = session.view();
    assert!((view.time_s - smooth.drive.duration_s).abs() < 0.03 * view.time_s, "{} s", view.time_s);
    assert!(view.coverage > stopping.coverage - 0.01, "{}", view.coverage);
    let mut second = opened();
    second.restore(&session.link()).unwrap();
    let file = SourceFile { name: "room.json".to_owned(), bytes: session.scenario_json().into_bytes() };
    let mut third = opened();
    third.load(&[file]).unwrap();
    for other in [&mut second, &mut third] {
        other.plan_now(|| 0.0);
        assert!(other.view().smooth);
        assert_eq!(other.planned().unwrap().drive, smooth.drive);
    }
    // A robot without corners keeps to its line.
    session.configure(|settings| settings.select_robot("octagon")).unwrap();
    session.plan_now(|| 0.0);
    assert!(!session.view().can_smooth && session.planned().unwrap().smooth.is_none());
}

#[test]
fn planner_keeps_its_parameters_while_another_is_tried() {
    let mut session = opened();
    session.configure(|s| s.set_param("effort", "6")).unwrap();
    session.configure(|s| s.select_algorithm("snake")).unwrap();
    session.configure(|s| s.select_algorithm("boustrophedon")).unwrap();
    assert_eq!(session.settings().params.number("effort"), 6.0);
    session.restore("planner=boustrophedon").unwrap();
    assert_eq!(session.settings().params.number("effort"), 1.0);
}

#[test]
fn links_may_say_things_in_any_order() {
    let mut session = opened();
    session.restore("p.patience=5&cell=0.2&planner=snake&robot=cell&room=empty").unwrap();
    let link = session.link();
    for part in ["room=empty", "planner=snake", "p.patience=5", "robot=cell", "cell=0.2"] {
        assert!(link.split('&').any(|p| p == part), "{part} is not in {link}");
    }
}

#[test]
fn bad_links_name_what_is_wrong_and_change_nothing() {
    let mut session = opened();
    let before = session.link();
    for (link, expected) in [
        ("planner=magic", "there is no algorithm \"magic\""),
        ("room=attic", "there is no room \"attic\""),
        ("robot=dalek", "there is no robot \"dalek\""),
        ("cell=0", "the cell size can't be \"0\""),
        ("cell=NaN", "the cell size can't be"),
        ("seed=-1", "the seed can't be \"-1\""),
        ("start=1,2", "the start can't be \"1,2\""),
        ("p.wings=2", "there is no parameter \"wings\""),
        ("slip=icy", "there is no slip \"icy\""),
    ] {
        let error = session.restore(link).unwrap_err().to_string();
        assert!(error.starts_with(expected), "{link}: {error}");
        assert_eq!(session.link(), before, "{link}");
    }
}

#[test]
fn room_of_ones_own_survives_by_scenario_and_link() {
    let mut session = opened();
    session.select_room("empty").unwrap();
    session.begin_stroke(Brush::Wall, Point::new(2.0, 1.5));
    session.go_on_stroke(Point::new(3.0, 2.5));
    session.end_stroke();
    session.configure(|s| s.set_slip("typical")).unwrap();
    let (link, saved) = (session.link(), session.scenario_json());
    assert!(link.starts_with("room=own&"), "{link}");
    let mut other = opened();
    other.load(&[SourceFile { name: "saved.json".into(), bytes: saved.into_bytes() }]).unwrap();
    other.restore(&link).unwrap();
    assert_eq!(other.link(), link);
    assert_eq!(other.plan().occupancy, session.plan().occupancy);
}

#[test]
fn a_twin_is_kept_by_links_scenarios_and_other_tabs_until_another_robot_is_chosen() {
    let mut session = opened();
    session.restore("room=empty&behaviour=bounce&robot=roomba600&twin=base:242,acceleration:1.4").unwrap();
    let twin = session.settings().custom.clone();
    assert_eq!(twin.as_ref().and_then(|custom| custom.twin()?.wheel_base_mm), Some(242.0));
    assert_eq!(session.view().twin, "base:242,acceleration:1.4");
    let (link, saved) = (session.link(), session.scenario_json());
    let (mut by_link, mut by_file, mut by_tab) = (opened(), opened(), opened());
    by_link.restore(&link).unwrap();
    by_file.load(&[SourceFile { name: "saved.json".into(), bytes: saved.into_bytes() }]).unwrap();
    by_tab.follow(&session.snapshot()).unwrap();
    for other in [&by_link, &by_file, &by_tab] {
        assert_eq!(other.settings().custom, twin);
    }
    // A connected robot is itself.
    assert_eq!(session.snapshot().for_connection("bounce").unwrap().choices.twin, None);
    let refused = session.restore("twin=base:2420").unwrap_err().to_string();
    assert!(refused.contains("wheel_base_mm can't be 2420") && session.settings().custom == twin, "{refused}");
    session.configure(|settings| settings.select_robot("roomba600")).unwrap();
    assert_eq!(session.settings().custom, None);
}

#[test]
fn snapshot_is_followed_by_other_tabs() {
    let mut session = opened();
    session.select_room("empty").unwrap();
    session.begin_stroke(Brush::Wall, Point::new(2.0, 1.5));
    session.go_on_stroke(Point::new(3.0, 2.5));
    session.end_stroke();
    session.configure(|s| s.set_seed(Some(7), "7")).unwrap();
    session.configure(|s| s.select_algorithm("bounce")).unwrap();
    let mut other = opened();
    other.follow(&SessionSnapshot { own: Some(session.own_room()), ..session.snapshot() }).unwrap();
    assert_eq!((other.link(), &other.plan().occupancy), (session.link(), &session.plan().occupancy));

    // The room is there already; what is as at first again isn't left as it was.
    session.configure(|s| s.set_seed(Some(1), "1")).unwrap();
    session.move_start(Pose::new(1.0, 1.0, 0.0));
    other.follow(&session.snapshot()).unwrap();
    assert_eq!((other.link(), &other.plan().occupancy), (session.link(), &session.plan().occupancy));

    let unknown = SessionSnapshot { room: Some("nowhere".to_owned()), ..session.snapshot() };
    assert!(other.follow(&unknown).unwrap_err().to_string().starts_with("there is no room \"nowhere\""));
    assert_eq!(other.link(), session.link());
}

#[test]
fn connected_robot_has_the_room_and_the_conditions_but_not_the_body() {
    let mut session = opened();
    session.configure(|s| s.select_robot("dvr1")).unwrap();
    session.configure(|s| s.set_seed(Some(7), "7")).unwrap();
    let snapshot = session.snapshot();
    let mut guest = opened();
    guest.follow(&snapshot.clone().for_connection("bounce").unwrap()).unwrap();
    let settings = guest.settings();
    assert_eq!((settings.robot, settings.cell_size, settings.seed), ("roomba600", 0.12, 7));
    assert_eq!(settings.algorithm.id(), "bounce");
    // What Explore has chosen keeps its parameters.
    let here = snapshot.choices.algorithm().unwrap().to_owned();
    assert_eq!(snapshot.clone().for_connection(&here).unwrap().choices.params, snapshot.choices.params);
    assert!(snapshot.for_connection("levitate").is_err());
}

#[test]
fn scenario_with_a_seed_that_no_link_can_hold_is_refused() {
    let mut session = opened();
    let before = session.link();
    let saved = session.scenario_json().replace("\"seed\": 1", "\"seed\": 18446744073709551615");
    assert!(saved.contains("18446744073709551615"), "{saved}");
    let error = session.load(&[SourceFile { name: "seed.json".into(), bytes: saved.into_bytes() }]).unwrap_err();
    assert!(error.to_string().contains("the seed can't be \"18446744073709551615\""), "{error}");
    assert_eq!(session.link(), before);
}

fn answer(cells: Vec<Cell>) -> PlanAnswer {
    PlanAnswer { path: CoveragePath::walk(cells), seconds: 0.1, proof: None, trace: Vec::new() }
}

#[test]
fn late_answers_of_older_plans_are_dropped() {
    let mut session = Session::new();
    session.select_room("lshape").unwrap();
    let old = session.take_plan_request().unwrap();
    session.select_room("empty").unwrap();
    session.plan_finished(old.id, answer(vec![old.job.start]));
    assert_eq!(session.state(), SessionState::Planning);
    session.plan_progress(old.id, ProgressReport { done: 0.5, walk: &[Cell::new(0, 0)], line: &[], proof: None });
    session.plan_proven(old.id, Some(Proof { cost: 2, bound: 1 }), None);
    assert!(session.preview().is_empty());
}

#[test]
fn walk_through_walls_is_refused() {
    let mut session = Session::new();
    session.select_room("empty").unwrap();
    let request = session.take_plan_request().unwrap();
    session.plan_finished(request.id, answer(vec![request.job.start, Cell::new(-1, 100_000)]));
    assert_eq!(session.state(), SessionState::Failed);
    let view = session.view();
    assert!(view.message.starts_with("The planner failed: step 1 leads into (-1, 100000)"), "{}", view.message);
}

#[test]
fn cancelled_plan_leaves_the_room_and_says_so() {
    let mut session = Session::new();
    session.cancel_plan();
    assert_eq!(session.state(), SessionState::Failed);
    assert_eq!(session.view().message_kind, "notice");
    session.play();
    session.plan_now(|| 0.0);
    assert_eq!(session.state(), SessionState::Playing);
}

#[test]
fn gap_is_shown_while_planning_and_afterwards() {
    let mut session = Session::new();
    session.select_room("empty").unwrap();
    let request = session.take_plan_request().unwrap();
    let shown = |session: &Session| session.view().plan.unwrap().gap;
    assert_eq!(shown(&session), None);
    let proof = Some(Proof { cost: 110, bound: 100 });
    session.plan_progress(request.id, ProgressReport { done: 0.5, walk: &[request.job.start], line: &[], proof });
    assert_eq!(shown(&session), Some(0.1));
    let mut answer = request.serve(|| 0.0, None).unwrap();
    answer.proof = proof;
    session.plan_finished(request.id, answer);
    assert_eq!(shown(&session), Some(0.1));
    // As plans are compared is another number.
    let compared = |session: &Session| session.view().plan.unwrap().above_bound;
    assert_eq!(compared(&session), None);
    session.plan_proven(request.id, Some(Proof { cost: 120, bound: 100 }), Some([3.0, 9.0]));
    assert_eq!((shown(&session), compared(&session)), (Some(0.1), Some(0.2)));
    // Of another plan it says nothing.
    session.plan_now(|| 0.0);
    session.plan_proven(request.id + 1, Some(Proof { cost: 3, bound: 1 }), None);
    assert_eq!(compared(&session), Some(0.2));
}

#[test]
fn best_walk_so_far_is_kept() {
    let mut session = Session::new();
    session.select_room("office").unwrap();
    session.configure(|s| s.select_algorithm("near_optimal")).unwrap();
    let request = session.take_plan_request().unwrap();
    let mut gaps = Vec::new();
    // As on the page: the button is pressed as soon as there is one.
    let mut watch = |report: ProgressReport<'_>| {
        session.plan_progress(request.id, report);
        gaps.extend(session.view().plan.unwrap().gap);
        if session.view().can.keep { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    assert!(request.serve(|| 0.0, Some(&mut watch)).is_err());
    session.keep_plan(1.5);
    let plan = session.view().plan.unwrap();
    assert_eq!((session.state(), plan.planning_s), (SessionState::Playing, Some(1.5)));
    let walk = plan.walk;
    assert_eq!(walk.visited_cells, walk.reachable_cells);
    assert!(plan.gap.is_some_and(|gap| gap > 0.0 && Some(&gap) == gaps.last()), "{gaps:?}");
}

/// Lets a film run to its end, and collects what is said meanwhile.
fn watched(session: &mut Session) -> Vec<String> {
    let mut told: Vec<String> = Vec::new();
    let mut frames = 0;
    for _ in 0..20 * 200 {
        let text = session.view().search.text;
        assert_eq!(session.picture().is_none(), text.contains("finished"), "{text}");
        if told.last() != Some(&text) {
            // Nobody reads more than 18 characters a second, and looks at the picture, too.
            let (seconds, length) = (f64::from(frames) / 20.0, told.last().map_or(0, String::len));
            assert!(seconds >= length as f64 / 18.0, "{seconds} s for {:?}", told.last());
            told.push(text);
            frames = 0;
        }
        frames += 1;
        session.frame(0.05, &mut || true);
    }
    assert!(told.len() > 1 && told[told.len() - 1].contains("finished"), "{told:?}");
    told
}

// slow: a search that runs to its proof
#[test]
fn search_of_a_small_room_is_a_film() {
    let mut session = Session::new();
    session.select_room("lshape").unwrap();
    session.configure(|s| s.select_algorithm("near_optimal")).unwrap();
    session.plan_now(|| 0.0);
    assert_eq!((session.picture(), session.state()), (None, SessionState::Playing), "it isn't shown unasked");
    session.show_search(true);
    assert_eq!(session.state(), SessionState::Ready, "the robot waits");
    let told = watched(&mut session);
    assert!(told[0].starts_with("Construction, 1 of 3: Boustrophedon (parallel lanes) needs "), "{told:?}");
    assert_eq!(told.iter().filter(|text| text.contains("The search starts from it")).count(), 1, "{told:?}");
    // Every improvement in three pictures, the way from what it was to what it is.
    let improvements = &told[3..told.len() - 1];
    assert!(!improvements.is_empty(), "{told:?}");
    for three in improvements.chunks(3) {
        assert!(three[0].starts_with("Improvement") && three[0].ends_with("will change."), "{three:?}");
        assert!(three[1].contains("is cut there; "), "{three:?}");
        assert!(three[2].contains("rejoined, ") && three[2].contains(" % of the bound); now "), "{three:?}");
    }
    assert!(told[told.len() - 1].starts_with("Search finished: the plan is "), "{told:?}");
    session.show_search(false);
    assert_eq!(session.view().search.text, "");
    session.show_search(true);
    assert_eq!(session.view().search.text, told[0]);
}

#[test]
fn film_waits_while_the_robot_drives() {
    let mut session = Session::new();
    session.select_room("lshape").unwrap();
    session.configure(|s| s.select_algorithm("near_optimal")).unwrap();
    session.configure(|s| s.set_param("effort", "0")).unwrap();
    session.show_search(true);
    session.plan_now(|| 0.0);
    assert_eq!(session.state(), SessionState::Ready, "a film that was asked for has the floor first");
    let first = session.view().search.text;
    assert!(session.scene().robot.is_none(), "no robot is parked on what the film shows");
    session.play();
    for _ in 0..600 {
        session.frame(1.0 / 60.0, &mut || true);
    }
    assert!(session.picture().is_none() && session.scene().robot.is_some());
    assert!(session.view().search.text.contains("is hidden while the robot drives"), "{}", session.view().search.text);
    session.pause();
    assert_eq!(session.view().search.text, first, "it hasn't gone on meanwhile");
}

#[test]
fn film_that_is_held_goes_on_by_hand() {
    let mut session = Session::new();
    session.select_room("lshape").unwrap();
    session.configure(|s| s.select_algorithm("near_optimal")).unwrap();
    session.configure(|s| s.set_param("effort", "0")).unwrap();
    session.hold_films();
    session.plan_now(|| 0.0);
    session.show_search(true);
    let at = |session: &Session| session.view().search.film.unwrap().at;
    for _ in 0..600 {
        session.frame(1.0 / 60.0, &mut || true);
    }
    assert_eq!(at(&session), 0);
    session.turn_film(true);
    session.turn_film(true);
    session.turn_film(false);
    assert_eq!(at(&session), 1);
    session.hold_film(false);
    for _ in 0..60 * 12 {
        session.frame(1.0 / 60.0, &mut || true);
        if at(&session) != 1 {
            break;
        }
    }
    assert_eq!(at(&session), 2);
    for _ in 0..100 {
        session.turn_film(true);
    }
    let film = session.view().search.film.unwrap();
    assert_eq!((film.at, session.picture()), (film.pictures, None));
    session.hold_film(false);
    assert_eq!(at(&session), 0, "once it's over, it begins again");
}

// slow: a search has to be under way before it is kept
#[test]
fn plan_that_is_kept_early_has_a_film_and_says_so() {
    let mut session = Session::new();
    session.select_room("lshape").unwrap();
    session.configure(|s| s.select_algorithm("near_optimal")).unwrap();
    let request = session.take_plan_request().unwrap();
    let (mut film, mut last) = (request.film().unwrap(), None);
    let mut watch = |report: ProgressReport<'_>| {
        film.take(&report);
        last = report.proof.map(|proof| (report.done, report.walk.to_vec(), proof));
        if report.done > 0.3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    assert!(request.serve(|| 0.0, Some(&mut watch)).is_err());
    let (done, walk, proof) = last.unwrap();
    session.plan_filmed(request.id, film.take_frames());
    session.plan_progress(request.id, ProgressReport { done, walk: &walk, line: &[], proof: Some(proof) });
    session.keep_plan(1.5);
    let plan = session.view().plan.unwrap();
    assert_eq!((plan.kept_at, plan.planning_s), (Some(done), Some(1.5)));
    session.show_search(true);
    let told = watched(&mut session);
    assert!(told.len() > 4 && told.iter().any(|text| text.starts_with("Improvement")), "{told:?}");
    session.configure(|s| s.select_algorithm("snake")).unwrap();
    session.plan_now(|| 0.0);
    assert_eq!(session.view().plan.unwrap().kept_at, None);
}

#[test]
fn cancelled_walk_is_no_longer_drawn() {
    let mut session = Session::new();
    session.select_room("lshape").unwrap();
    let request = session.take_plan_request().unwrap();
    let (start, other) = (request.job.start, Cell::new(request.job.start.x + 1, request.job.start.y));
    session.plan_progress(request.id, ProgressReport { done: 0.5, walk: &[start, other], line: &[], proof: None });
    let drawn = session.scene().planned_version;
    assert_eq!(session.scene().preview.len(), 2);
    session.cancel_plan();
    assert!(session.scene().preview.is_empty() && session.scene().planned_version != drawn);
}

#[test]
fn half_a_walk_is_not_kept() {
    let mut session = Session::new();
    session.select_room("empty").unwrap();
    session.configure(|s| s.select_algorithm("snake")).unwrap();
    let request = session.take_plan_request().unwrap();
    session.plan_progress(request.id, ProgressReport { done: 0.5, walk: &[request.job.start], line: &[], proof: None });
    assert!(session.view().can.cancel && !session.view().can.keep);
    session.keep_plan(1.0);
    assert_eq!((session.state(), session.planned().is_some()), (SessionState::Failed, false));
}

#[test]
fn bad_file_leaves_the_room() {
    let mut session = opened();
    let before = session.link();
    let error = session.load(&[SourceFile { name: "notes.txt".into(), bytes: b"hello".to_vec() }]).unwrap_err();
    assert!(!error.to_string().is_empty());
    assert_eq!(session.link(), before);
    assert!(session.planned().is_some());
}

#[test]
fn cells_finer_than_the_map_are_refused_before_memory_runs_out() {
    let mut session = opened();
    let hall = format!("; resolution 5\n{}", format!("{}\n", ".".repeat(400)).repeat(400));
    session.load(&[SourceFile { name: "hall.txt".into(), bytes: hall.into_bytes() }]).unwrap();
    session.configure(|s| s.select_robot("cell")).unwrap();
    session.configure(|s| s.set_cell_size(0.02)).unwrap();
    assert_eq!(session.state(), SessionState::Failed);
    assert!(session.view().message.contains("too small for this map"), "{}", session.view().message);
}

#[test]
fn search_of_the_snake_follows_the_robot() {
    use robovac_core::grid::Direction;
    let mut session = opened();
    session.restore("room=thesis8&robot=cell&planner=snake").unwrap();
    session.show_search(true);
    session.plan_now(|| 0.0);
    session.pause();
    // A decision at every step of the walk, each where the one before has led to.
    let steps = session.search().unwrap().steps().to_vec();
    assert_eq!(steps.len(), session.planned().unwrap().walk.unwrap().steps);
    for (i, pair) in steps.windows(2).enumerate() {
        assert_eq!((pair[0].step, pair[0].at.step(pair[0].towards)), (i, pair[1].at));
    }
    let block = steps.iter().find(|step| step.sides.is_some()).expect("a smaller block decides");
    let [(first, a), (second, b)] = block.sides.unwrap();
    assert_eq!(second, first.opposite());
    assert!(
        block.note.contains(&format!("cells to clean: {a} ")) && block.note.contains(&b.to_string()),
        "{}",
        block.note
    );
    assert!(steps.iter().any(|step| step.rule == "Shortest path" || step.rule == "Back"));

    // The decision shown is the one that the robot carries out, all along the run.
    let cell = session.settings().cell_size;
    let mut shown = Vec::new();
    while session.state() != SessionState::Finished {
        session.step();
        let Some(decision) = session.decision() else { break };
        shown.push(decision.step);
        let at = session.recording().unwrap().run().pose().position();
        assert!((decision.at.centre(cell) - at).norm() < 1.2 * cell, "{decision:?} while the robot is at {at}");
        assert!(session.description().contains(&decision.note));
    }
    assert!(shown.is_sorted() && shown.len() > steps.len() / 2, "{shown:?}");

    // Back in time it's the same as on the way there.
    let (time, decision) = (session.view().time_s / 2.0, |session: &Session| session.decision().cloned());
    session.seek(time);
    session.frame(0.0, &mut || true);
    let middle = decision(&session).expect("a decision in the middle");
    assert!((1..steps.len() - 1).contains(&middle.step) && middle.towards != Direction::opposite(middle.towards));
    session.seek(0.0);
    session.frame(0.0, &mut || true);
    assert_eq!(decision(&session).as_ref(), steps.first());
    assert_eq!(session.view().search.text, format!("{}.", steps[0].note));
}

#[test]
fn search_says_why_a_walk_ends_early() {
    let mut session = opened();
    session.restore("room=room12ft&robot=cell&planner=snake&p.rules=program").unwrap();
    session.show_search(true);
    session.plan_now(|| 0.0);
    session.seek(session.planned().unwrap().drive.duration_s * 2.0);
    while session.state() != SessionState::Finished {
        session.frame(1.0, &mut || true);
    }
    let planned = session.planned().unwrap();
    let walk = planned.walk.unwrap();
    assert!(!walk.is_complete());
    let ending = session.search().unwrap().ending().expect("it ends early");
    assert_eq!((ending.step, &session.view().search.text), (walk.steps, &format!("{}.", ending.note)));
}

#[test]
fn search_is_only_shown_where_there_is_one() {
    let mut session = opened();
    session.show_search(true);
    session.restore("room=living&behaviour=random_walk").unwrap();
    let search = session.view().search;
    assert!(search.on && !search.offered && search.text.is_empty(), "a behaviour has no search");
    session.restore("room=living&planner=lanes").unwrap();
    let search = session.view().search;
    assert!(search.offered && !search.on && !search.fits_small && search.refusal.contains("in metres"), "{search:?}");
    for (planner, refusal) in [
        ("snake", "shown only in rooms of up to 20000 planning cells"),
        ("near_optimal", "filmed only in rooms of up to 2000 planning cells"),
    ] {
        session.restore(&format!("room=hall20&planner={planner}")).unwrap();
        let search = session.view().search;
        assert!(search.offered && !search.on && search.fits_small && search.text.is_empty(), "{search:?}");
        assert!(search.refusal.contains(refusal), "{}", search.refusal);
    }
    session.show_search(false);
    assert!(session.view().search.text.is_empty() && session.decision().is_none());
}

#[test]
fn start_in_a_closet_is_told_with_the_floor_that_is_left_out() {
    let map = "; resolution 0.5\n........\n........\n######..\n.....#..\n#####...\n........\n";
    let mut session = Session::new();
    session.load(&[SourceFile { name: "closet.txt".into(), bytes: map.into() }]).unwrap();
    session.configure(|s| s.select_robot("cell")).unwrap();
    session.configure(|s| s.set_cell_size(0.5)).unwrap();
    assert_eq!(session.view().message, "", "the default start is in the large part");
    assert_eq!(session.view().room.left_out_m2, 5.0 * 0.25);
    session.move_start(Pose::new(0.25, 1.25, 0.0));
    let view = session.view();
    assert_eq!((view.room.reachable_m2, view.room.left_out_m2), (1.25, 31.0 * 0.25));
    assert!(
        view.message.starts_with("From this start the robot can reach only 1.2 m² of floor; 7.8 m² (hatched)"),
        "{}",
        view.message
    );
    session.move_start(Pose::new(0.25, 0.25, 0.0));
    assert_eq!(session.view().message, "");
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
fn planned_robot_that_is_carried_off_is_told_to_go_on_blindly() {
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
    let before = session.view().coverage;
    assert!(before > 0.1, "{before}");
    session.begin_stroke(Brush::Wall, Point::new(2.0, 1.5));
    session.go_on_stroke(Point::new(2.4, 1.5));
    session.end_stroke();
    session.plan_now(|| 0.0);
    let view = session.view();
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
fn link_says_whether_the_search_is_shown() {
    let mut session = opened();
    assert!(!session.link().contains("search="));
    session.show_search(true);
    let link = session.link();
    let mut other = opened();
    other.restore(&link).expect("it was just written");
    assert!(other.link() == link && link.ends_with("&search=1"), "{link}");
    // A link that changes only the robot leaves it as it is.
    other.restore("robot=cell").expect("the robot exists");
    assert!(other.link().contains("search=1"));
}
