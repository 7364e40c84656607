//! Robots of one's own, and paths in metres that Explore drives as they were planned.

use robovac_app::{
    Import,
    explore::{Brush, Session, SessionState},
    floor_plan::{BodyChoice, DrawingSession},
};
use robovac_core::{
    floor_plan::{SourceFile, generate::FlatId},
    geometry::{MetricPath, Point, Pose},
};
use std::ops::ControlFlow;

const WEDGE: &str =
    "corners:0.2_-0.15_0.2_0.15_-0.1_0.15_-0.2_0_-0.1_-0.15,tool:0.25,at:0.02_0,speed:0.25,without:light";

fn file(name: &str, text: String) -> SourceFile {
    SourceFile { name: name.to_owned(), bytes: text.into_bytes() }
}

fn opened(link: &str) -> Session {
    let mut session = Session::new();
    session.restore(link).unwrap();
    session
}

/// The session by its link, by its file, and in another tab. A link of a room that was drawn comes after the file, as on the
/// page.
fn again(session: &Session) -> Vec<Session> {
    let (mut by_link, mut by_file, mut by_tab) = (Session::new(), Session::new(), Session::new());
    let saved = file("saved.json", session.scenario_json());
    if session.room().is_none() || session.link().contains("room=own") {
        by_link.load(std::slice::from_ref(&saved)).unwrap();
    }
    by_link.restore(&session.link()).unwrap();
    by_file.load(&[saved]).unwrap();
    let mut snapshot = session.snapshot();
    snapshot.own = Some(session.own_room()).filter(|_| session.room().is_none());
    by_tab.follow(&snapshot).unwrap();
    vec![by_link, by_file, by_tab]
}

/// Drives to the end; coverage, time in s and bumps.
fn driven(session: &mut Session) -> (f64, f64, u32) {
    session.run_ahead(6.0 * 3600.0);
    assert_eq!(session.state(), SessionState::Finished);
    let view = session.view();
    (view.coverage, view.time_s, view.bumps)
}

/// The tab Floor plan with a room of Explore that ships, and the sweep of it by an outline.
fn swept(room: &str, body: BodyChoice) -> DrawingSession {
    let saved = opened(&format!("room={room}&behaviour=bounce")).scenario_json();
    let mut board = DrawingSession::open(&[file("room.json", saved)]).unwrap();
    let settings = board.settings().clone();
    board.set(robovac_app::floor_plan::FloorPlanSettings { body, ..settings }).unwrap();
    board.sweep(&mut |_| ControlFlow::Continue(())).unwrap();
    board
}

fn explored(board: &DrawingSession) -> Session {
    let mut session = Session::new();
    session.take_import(board.import(true).unwrap()).unwrap();
    session
}

#[test]
fn an_own_robot_is_kept_by_links_scenarios_and_other_tabs_until_another_is_chosen() {
    let mut session = opened(&format!("room=empty&behaviour=bounce&robot=roomba600&own={WEDGE}"));
    let robot = session.settings().robot_model();
    assert_eq!(
        (robot.tool_width, robot.cruise_speed, session.view().own_robot),
        (0.25, 0.25, WEDGE.replace(",at:0.02_0,speed:0.25", ",speed:0.25,at:0.02_0"))
    );
    for other in again(&session) {
        assert_eq!(other.settings().robot_model(), robot);
        assert_eq!(other.settings().cell_size, session.settings().cell_size);
    }
    assert_eq!(session.snapshot().for_connection("bounce").unwrap().choices.own_robot, None);
    session.run_ahead(60.0);
    assert!(session.view().coverage > 0.05 && session.view().distance_m > 3.0);
    // It plans, too.
    session.restore(&format!("room=empty&planner=boustrophedon&robot=roomba600&own={WEDGE}")).unwrap();
    session.plan_now(|| 0.0);
    let (coverage, ..) = driven(&mut session);
    assert!(coverage > 0.95, "{coverage}");
    session.configure(|settings| settings.select_robot("roomba600")).unwrap();
    assert_eq!((session.settings().custom.clone(), session.view().own_robot), (None, String::new()));
}

#[test]
fn what_no_robot_is_like_changes_nothing_and_says_why() {
    let mut session = opened(&format!("room=empty&behaviour=bounce&robot=roomba600&own={WEDGE}"));
    let before = session.link();
    for (own, why) in [
        ("corners:-0.2_-0.1_0.2_0.1_0.2_-0.1_-0.2_0.1", "sides 1 and 3 of the outline cross"),
        ("corners:0.1_0.1_0.2_0.1_0.2_0.2", "origin (0, 0) is outside the outline"),
        ("radius:0.2,tool:0.6", "the tool (a disc) reaches 0.300 m from the robot's centre, but its body only 0.200 m"),
        ("speed:0", "the robot's speed can't be 0 m/s; use 0.01 to 3 m/s"),
        ("nose:1", "the own robot can't be \"nose:1\""),
    ] {
        let error = session.restore(&format!("robot=roomba600&own={own}")).unwrap_err().to_string();
        assert!(error.contains(why), "{error}");
        assert_eq!(session.link(), before);
    }
}

#[test]
fn explore_drives_the_very_sweep_with_the_very_outline() {
    for (room, body) in [
        ("empty", BodyChoice::Octagon { width: 0.4 }),
        ("ushape", BodyChoice::Polygon { corners: "0.2 -0.2; 0.2 0.2; -0.1 0.2; -0.2 0; -0.1 -0.2".into() }),
        ("ushape", BodyChoice::Rectangle { length: 0.3, width: 0.5 }),
        ("ushape", BodyChoice::Model { id: "roomba600".into() }),
    ] {
        let board = swept(room, body.clone());
        let mut session = explored(&board);
        assert_eq!(session.view().message, "", "{body:?}");
        assert!(!session.view().search.offered && session.view().plan.unwrap().planning_s.is_none());
        let planned = MetricPath::new(&board.planned().unwrap().path).unwrap();
        assert_eq!(session.planned().unwrap().line, *planned.corners());
        assert_eq!((session.room(), session.view().path_corners), (Some(room), planned.corners().len()));
        let promised = board.driven().unwrap();
        let all = driven(&mut session);
        println!("{room}, {body:?}: promised {:.4} in {:.0} s; {all:?}", promised.coverage, promised.duration_s);
        assert!((all.0 - promised.coverage).abs() < 0.01, "{room}, {body:?}: {} for {}", all.0, promised.coverage);
        for mut other in again(&session) {
            assert_eq!(driven(&mut other), all, "{room}, {body:?}");
        }
    }
}

#[test]
fn a_path_begins_where_it_begins_until_something_else_drives() {
    let board = swept("ushape", BodyChoice::Octagon { width: 0.4 });
    let mut session = explored(&board);
    let start = session.prepared().unwrap().floor.start;
    session.move_start(Pose::new(start.x + 0.5, start.y, 0.0));
    assert!(session.view().message.contains("The path begins here"));
    assert_eq!(session.prepared().unwrap().floor.start, start);
    // Speeds don't change what it was planned for; a shape does.
    let own = session.view().own_robot;
    let slower = |text: &str| robovac_core::robot::OwnRobot::parse(text).unwrap();
    session.configure(|s| s.set_own_robot(slower(&format!("{own},speed:0.2")))).unwrap();
    assert!(session.settings().path.is_some());
    session.configure(|s| s.set_own_robot(slower("radius:0.1"))).unwrap();
    assert!(session.settings().path.is_none());
    let mut session = explored(&board);
    session.configure(|s| s.select_algorithm("boustrophedon")).unwrap();
    assert!(session.settings().path.is_none() && session.take_plan_request().is_some());
}

#[test]
fn a_path_too_long_for_a_link_stays_with_the_room() {
    let mut session = opened("room=empty&planner=subgoal_sweep&robot=octagon");
    let corners: Vec<Point> =
        (0..3000).map(|i| Point::new(1.0 + 0.5 * f64::from(i % 2), 1.0 + f64::from(i) * 1e-4)).collect();
    let path = MetricPath::new(&corners).unwrap();
    session
        .configure(|settings| {
            settings.path = Some(path.clone());
            Ok(())
        })
        .unwrap();
    let link = session.link();
    assert!(link.starts_with("room=own&") && link.contains("&path=kept"), "{link}");
    for other in again(&session) {
        assert_eq!(other.settings().path.as_ref(), Some(&path));
    }
    let error = Session::new().restore(&link).unwrap_err().to_string();
    assert!(error.contains("ask the link's author for the scenario file"), "{error}");
}

#[test]
fn a_path_stays_with_the_room_that_it_was_planned_in() {
    let board = swept("ushape", BodyChoice::Model { id: "roomba600".into() });
    let path = explored(&board).settings().path.clone();
    let other_drawing = swept("lshape", BodyChoice::Model { id: "roomba600".into() });
    let choices: [fn(&mut Session, &DrawingSession); 3] = [
        |session, _| session.select_room("living").unwrap(),
        |session, drawing| session.take_import(drawing.import(false).unwrap()).unwrap(),
        |session, _| {
            session.take_import(Import { plan: "7".parse::<FlatId>().unwrap().build(), choices: None }).unwrap();
        },
    ];
    for choose in choices {
        let mut session = explored(&board);
        choose(&mut session, &other_drawing);
        assert_eq!((session.settings().path.clone(), session.view().path_corners), (None, 0));
        let told = session.view().message;
        assert!(told.starts_with("The path from Floor plan belongs to another room. Here the algorithm is "), "{told}");
        session.plan_now(|| 0.0);
        assert!(session.recording().is_some(), "something else drives");
        // Undo brings room and path back, redo leaves them again.
        session.undo();
        assert_eq!(session.settings().path, path);
        assert!(session.planned().is_some() && session.view().message.is_empty());
        session.redo();
        assert_eq!(session.settings().path, None);
    }
    // The same room, its walls, a reload and links leave it.
    let mut session = explored(&board);
    session.begin_stroke(Brush::Wall, Point::new(0.5, 0.5));
    session.end_stroke();
    session.undo();
    assert_eq!(session.settings().path, path);
    for other in again(&session) {
        assert_eq!(other.settings().path, path);
    }
    session.restore("room=lshape").unwrap();
    assert_eq!(session.settings().path, None);
}

#[test]
fn an_own_room_that_is_chosen_brings_only_a_path_with_it() {
    let kept = |text: String| Import::read(&[file("kept.json", text)]).unwrap();
    let room = kept(opened("room=lshape&planner=boustrophedon&seed=5").scenario_json());
    let mut session = opened("room=empty&planner=contour&robot=octagon&seed=9");
    session.take_room(room.clone()).unwrap();
    let has = |session: &Session| {
        let settings = session.settings();
        (settings.algorithm.id(), settings.robot, settings.seed, settings.path.is_some())
    };
    assert_eq!(
        (has(&session), session.plan().name.as_str()),
        (("contour", "octagon", 9, false), room.plan.name.as_str())
    );
    let swept = explored(&swept("ushape", BodyChoice::Model { id: "roomba600".into() }));
    session.take_room(kept(swept.scenario_json())).unwrap();
    assert_eq!(session.settings().path, swept.settings().path);
    assert_eq!(session.settings().robot, "roomba600");
}

#[test]
fn a_roomba_rides_paths_of_outlines_that_it_fits_into() {
    for (body, fits) in [
        (BodyChoice::Model { id: "roomba600".into() }, true),
        (BodyChoice::Circle { radius: 0.18 }, true),
        (BodyChoice::Octagon { width: 0.36 }, true),
        (BodyChoice::Octagon { width: 0.34 }, false),
        (BodyChoice::Rectangle { length: 0.6, width: 0.3 }, false),
    ] {
        let session = explored(&swept("empty", body.clone()));
        let refusal = session.snapshot().path_refusal();
        assert_eq!(refusal.is_none(), fits, "{body:?}: {refusal:?}");
        let why = "which a Roomba doesn't fit into: it is 0.348 m wide";
        assert!(refusal.as_ref().is_none_or(|refusal| refusal.contains(why)), "{refusal:?}");
        let mut on_robot = Session::new();
        on_robot.follow(&session.snapshot().for_connection("path").unwrap()).unwrap();
        assert_eq!(on_robot.planned().unwrap().line, session.planned().unwrap().line);
        assert_eq!(on_robot.settings().robot_model().id, "roomba600");
        let mut other = Session::new();
        other.follow(&session.snapshot().for_connection("boustrophedon").unwrap()).unwrap();
        assert!(other.settings().path.is_none());
    }
    assert_eq!(opened("room=empty&behaviour=bounce").snapshot().path_refusal(), None);
}
