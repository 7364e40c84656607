//! Links, scenarios and snapshots.

use super::{finish, opened};
use robovac_app::{
    Import,
    explore::{Brush, Session, SessionSnapshot, SessionState},
};
use robovac_core::{
    floor_plan::{SourceFile, generate::FlatId},
    geometry::{Point, Pose},
};
use robovac_sim::{controller, experiment::SettingsError};

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
fn link_leads_to_the_moment_of_a_run() {
    let follow = |link: &str| {
        let mut session = opened();
        session.restore(link).unwrap();
        session.plan_now(|| 0.0);
        session.frame(1.0 / 60.0, &mut || true);
        session
    };
    let state = |session: &Session| (session.state(), session.recording().unwrap().run().digest());
    for settings in
        ["planner=snake&smooth=true", "planner=near_optimal&p.effort=0&search=1", "behaviour=random_walk&slip=typical"]
    {
        let mut session = opened();
        session.restore(&format!("room=lshape&robot=roomba600&cell=0.25&seed=9&{settings}")).unwrap();
        session.plan_now(|| 0.0);
        if session.state() == SessionState::Playing {
            assert_eq!(session.moment_pair().unwrap(), "", "{settings}: at the start there is nothing to say");
        }
        session.pause();
        let waiting = format!("{}&{}", session.link(), session.moment_pair().unwrap());
        assert_eq!(state(&follow(&waiting)), state(&session), "{settings}: nor does it start elsewhere");
        assert_eq!(session.state(), SessionState::Ready, "{settings}");
        session.run_ahead(40.0);
        session.pause();
        let pair = session.moment_pair().unwrap();
        assert!(pair.ends_with(",paused"), "{pair}");
        let link = format!("{}&{pair}", session.link());
        assert!(!session.link_outline(&link).is_shown, "a moment is to be gone to");
        assert_eq!(state(&follow(&link)), state(&session), "{settings}");
        let mut playing = follow(link.trim_end_matches(",paused"));
        assert_eq!(playing.recording().unwrap().run().time_s(), session.recording().unwrap().run().time_s());
        playing.frame(1.0, &mut || true);
        assert_eq!(playing.state(), SessionState::Playing, "{settings}");
        assert!(playing.recording().unwrap().run().time_s() > session.recording().unwrap().run().time_s());
        // Whatever its user does next isn't undone by the link.
        playing.reset();
        playing.frame(1.0, &mut || true);
        assert_eq!(playing.recording().unwrap().run().steps(), 0, "{settings}");
        finish(&mut session);
        let end = format!("{}&{}", session.link(), session.moment_pair().unwrap());
        assert_eq!(state(&follow(&end)), state(&session), "{settings}: the end, too");
    }
}

#[test]
fn link_leads_to_no_moment_that_a_person_had_a_part_in() {
    let mut session = opened();
    session.restore("room=lshape&behaviour=random_walk&robot=roomba600").unwrap();
    session.run_ahead(5.0);
    session.lift();
    assert_eq!(session.moment_pair(), None);
    session.seek(1.995);
    session.frame(1.0 / 60.0, &mut || true);
    assert!(session.moment_pair().unwrap().starts_with("moment=1.995"), "before it, nobody had a part in it");
    session.reset();
    assert_eq!(session.moment_pair().as_deref(), Some("moment=0,paused"));
    session.run_ahead(5.0);
    session.begin_stroke(Brush::Wall, Point::new(1.0, 1.0));
    session.end_stroke();
    session.run_ahead(5.0);
    assert_eq!(session.moment_pair(), None, "what was swept before isn't in the link");
    for wrong in ["now", "-1", "1e9", "NaN", "3,playing", ""] {
        let error = session.restore(&format!("moment={wrong}")).unwrap_err().to_string();
        assert!(error.contains("the moment") && error.contains("e.g. 83.2"), "{error}");
    }
}

#[test]
fn back_to_a_room_without_slip_kept_the_slip_of_the_next_one() {
    let mut session = opened();
    let link = session.link();
    session.restore("room=room12ft&robot=dvr1&slip=typical&noise=typical&seed=9&show=sensors").unwrap();
    session.restore(&link).unwrap();
    assert_eq!(session.link(), link);
    // A part of a link leaves the rest as it is.
    session.restore("slip=typical").unwrap();
    session.restore("room=bedroom").unwrap();
    assert!(session.link().contains("slip=typical"), "{}", session.link());
}

#[test]
fn a_link_is_known_as_the_present_session_by_what_it_would_change() {
    let mut session = opened();
    session.restore("#room=lshape&planner=snake&robot=cell&cell=0.25&seed=9&slip=typical").unwrap();
    let link = session.link();
    let is_shown = |link: &str| session.link_outline(link).is_shown;
    assert!(is_shown(&format!("#{link}&tab=map&kept=3")), "{link}");
    let reversed: Vec<_> = link.split('&').rev().collect();
    assert!(is_shown(&reversed.join("&")), "{reversed:?}");
    assert!(!is_shown("room=lshape"), "what a link leaves out is asked for by nobody");
    for other in ["search=1", "noise.bumper=high", "p.rules=program", "speed=4", "start=1,1,90", "charge=50"] {
        assert!(!is_shown(&format!("{link}&{other}")), "{other}");
    }
    assert!(!is_shown(&link.replace("seed=9", "seed=10")));
    assert!(!is_shown(&link.replace("seed=9", "seed=nine")), "refused, and therefore not shown");
    assert!(session.link_outline("room=own&behaviour=program").has_own_room);
    assert!(session.link_outline("room=own&planner=program_planner").has_program);
    assert!(!session.link_outline("room=flat&planner=snake").has_program);
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
fn generated_flat_is_told_by_the_parts_of_its_name() {
    let mut session = opened();
    assert_eq!(session.view().room.flat, None);
    for [seed, area, more] in
        [["7", "", ""], ["7", "~area:40..60", "~rugs:no"], ["8", "~area:40..60", ""], ["9", "", "~furniture:0.5"]]
    {
        let id: FlatId = format!("{seed}{area}{more}").parse().unwrap();
        session.take_import(Import { plan: id.build(), choices: None }).unwrap();
        let room = session.view().room;
        let flat = room.flat.unwrap();
        assert_eq!([flat.seed.as_str(), &flat.area, &flat.more], [seed, area, more]);
        assert!(room.note.ends_with(" rooms.") && !room.note.contains("Generated"), "{}", room.note);
    }
}

#[test]
fn link_to_a_behaviour_that_explore_lacks_says_where_it_is() {
    let mut session = Session::with(controller::MAPLESS);
    let before = session.link();
    let refusal = session.restore("#room=flat&behaviour=learned").unwrap_err().to_string();
    assert!(refusal.contains("\"learned\" keeps a map") && refusal.contains("Compare or Map"), "{refusal}");
    assert_eq!(session.link(), before);
    assert!(Session::new().restore("#room=flat&behaviour=learned").is_ok());
}
