//! Robots that clean by the map that they have made themselves.

use robovac_app::{
    explore::Session,
    map::{MapAction, MapPhase, MapSession, STORE_VERSION, StoreError, Stored, cleaners},
};
use robovac_core::{
    floor_plan::room,
    geometry::Pose,
    registry::Params,
    robot::{BatteryReading, OdometryModel, SensorReadings},
};
use robovac_sim::{
    Conditions, Input, Noise, NoiseLevel, Run, STEP_S, SlipLevel,
    controller::{self, clean_by_map},
    mapping::{CellMark, MapObserver, Mapper, MapperSetup, Tracking},
};

/// A mapping run in the room of a link.
fn map_session(link: &str) -> MapSession {
    let mut explore = Session::new();
    explore.restore(link).expect("a link of ours");
    let mut session = MapSession::new();
    session.take(&explore);
    session
}

/// A furnished room, mapped for so long, s.
fn mapped(seconds: f64) -> MapSession {
    let mut session = map_session("room=bedroom&robot=roomba600&seed=3");
    session.run_ahead(seconds);
    session
}

/// Lets it go on until it is done, at most so long, s.
fn finish(session: &mut MapSession, most_s: f64) {
    let end = run(session).time_s() + most_s;
    while session.phase() != MapPhase::Finished && run(session).time_s() < end {
        session.run_ahead(30.0);
    }
}

fn arrive(session: &mut MapSession) {
    for _ in 0..100_000 {
        if !matches!(session.phase(), MapPhase::Resuming | MapPhase::Seeking) {
            return;
        }
        session.frame(0.016, &mut || true);
    }
    panic!("still {:?}", session.phase());
}

fn run(session: &MapSession) -> &Run {
    session.run().expect("there is a run")
}

#[test]
fn a_furnished_room_is_cleaned_by_the_robots_own_map() {
    let mut session = mapped(60.0);
    finish(&mut session, 1500.0);
    assert_eq!(session.phase(), MapPhase::Finished, "its map is complete");
    let before = run(&session).coverage();
    assert!(session.can(MapAction::Clean) && session.view().by_map.is_none());
    session.clean();
    assert_eq!(session.phase(), MapPhase::Playing, "it sets out at once");
    finish(&mut session, 3600.0);
    let (view, after) = (session.view(), run(&session).coverage());
    assert_eq!((session.phase(), view.activity.starts_with("done")), (MapPhase::Finished, true), "{}", view.activity);
    let [swept, all] = view.by_map.expect("it has cleaned by its map");
    assert!(after > before + 0.1 && after > 0.88, "{before} mapping, {after} in the end");
    assert!(swept > 0.93 * all, "{swept} of {all} m² as it believes");
    let off = session.figures().expect("there is a run")[0].position_m.expect("it has an idea");
    assert!(off < 0.1, "{off} m off");
}

#[test]
fn what_it_senses_is_all_that_it_goes_by() {
    let mut session = mapped(400.0);
    session.clean();
    session.run_ahead(3.0 * STEP_S);
    let mut here = run(&session).clone();
    // Another controller, which has the map and the readings and nothing else, does the same.
    let mapper = here.mapper().expect("it maps").clone();
    here.apply(Input::Clean("boustrophedon"));
    let mut other = clean_by_map(mapper, "boustrophedon");
    for _ in 0..8000 {
        let sensed = here.sensors().clone();
        here.step();
        other.step(&sensed, STEP_S);
    }
    let pose = |mapper: &Mapper| mapper.pose();
    assert_eq!(other.mapper().map(pose), here.mapper().map(pose));
    assert_eq!(other.activity(), here.activity());
    let route = here.intent().expect("it drives by its map").route.to_vec();
    assert_eq!(other.intent().map(|intent| intent.route.to_vec()), Some(route));
}

#[test]
fn cleaning_is_gone_back_to_and_survives_a_reload() {
    let mut session = mapped(300.0);
    session.clean();
    let began = run(&session).time_s();
    session.run_ahead(120.0);
    let (digest, end) = (run(&session).digest(), run(&session).time_s());
    session.seek(began - 20.0);
    arrive(&mut session);
    assert!(!session.view().is_cleaning, "it was still exploring");
    session.seek(end);
    arrive(&mut session);
    assert_eq!((run(&session).digest(), session.view().is_cleaning), (digest, true));

    let text = session.store().expect("there is a map");
    let mut back = mapped(0.0);
    back.resume(&text).expect("it is one of ours");
    arrive(&mut back);
    assert!(!back.take_strayed() && back.view().is_cleaning);
    assert_eq!(run(&back).digest(), digest);
    for session in [&mut session, &mut back] {
        session.run_ahead(30.0);
    }
    assert_eq!(run(&back).digest(), run(&session).digest());
}

/// Regression: a run that had ended and was then continued by cleaning ended at the same step when it was simulated
/// again.
#[test]
fn a_run_that_was_over_and_goes_on_does_so_again() {
    let mut session = map_session("room=room12ft&robot=roomba600&seed=3");
    finish(&mut session, 1500.0);
    assert_eq!(session.phase(), MapPhase::Finished);
    let over = run(&session).time_s();
    session.clean();
    session.run_ahead(40.0);
    let digest = run(&session).digest();
    let text = session.store().expect("there is a map");
    session.seek(over);
    arrive(&mut session);
    assert!(session.can(MapAction::Play), "{:?}", session.phase());
    let mut back = map_session("room=room12ft&robot=roomba600&seed=3");
    back.resume(&text).expect("it is one of ours");
    arrive(&mut back);
    assert_eq!(run(&back).digest(), digest);
}

// slow: relocalising takes minutes of driving
#[test]
fn a_kidnapped_robot_relocalises_and_goes_on_cleaning() {
    let mut session = mapped(700.0);
    session.clean();
    session.run_ahead(60.0);
    let marks =
        |session: &MapSession| session.estimate().expect("there is a robot").marks.cells(CellMark::Cleaned).count();
    session.lift();
    session.put_down(Pose::new(1.0, 1.6, 2.0));
    session.run_ahead(2.0);
    assert_eq!((session.view().is_sure, session.view().activity), (Some(false), "relocalising on its map"));
    let before = marks(&session);
    let mut waited = 0;
    while session.view().is_sure.is_some() && waited < 40 {
        assert_eq!(session.view().is_sure, Some(false), "it doesn't go by what it guesses yet");
        assert_eq!(marks(&session), before, "who is lost doesn't know what it cleans");
        session.run_ahead(15.0);
        waited += 1;
    }
    assert_eq!(session.view().is_sure, None, "it is found");
    session.run_ahead(60.0);
    let off = session.figures().expect("there is a run")[0].position_m.expect("it has an idea");
    assert!(off < 0.15, "{off} m off");
    assert!(marks(&session) > before, "it goes on");
}

#[test]
fn a_map_that_it_was_given_is_cleaned_by_once_it_knows_where_it_is() {
    let mut session = map_session("room=kitchen&robot=roomba600&seed=1");
    session.open(&(room("kitchen").expect("it ships").build)()).expect("it has walls");
    assert!(!session.can_clean(), "it has never set off");
    session.run_ahead(1.0);
    session.clean();
    session.run_ahead(1.0);
    assert_eq!(session.view().is_sure, Some(false));
    session.run_ahead(240.0);
    let off = session.figures().expect("there is a run")[0].position_m.expect("it has an idea");
    assert!(session.view().is_sure.is_none() && off < 0.15, "{off} m off");
    assert!(session.view().by_map.is_some_and(|[swept, all]| all > 2.0 && swept > 0.0));
}

#[test]
fn what_was_stored_by_other_versions_is_read_or_explained() {
    let session = mapped(60.0);
    let mine = session.store().expect("there is a map");
    let older = mine.replacen(&format!("\"version\":{STORE_VERSION}"), "\"version\":1", 1);
    assert_ne!(older, mine);
    let mut back = mapped(0.0);
    back.resume(&older).expect("version 1 has nothing that this one doesn't have");
    arrive(&mut back);
    assert_eq!(run(&back).digest(), run(&session).digest());
    let mut stored = Stored::from_text(&mine).expect("it is one of ours");
    stored.inputs.push((10, Input::Clean("mole_tunnels")));
    let error = back.resume(&stored.to_text()).expect_err("there is no such planner");
    assert_eq!(error, StoreError::Planner { id: "mole_tunnels".to_owned() });
}

#[test]
fn planners_of_what_is_left_are_offered_and_links_bring_them_back() {
    assert!(cleaners().count() > 3);
    for info in cleaners() {
        let mut session = mapped(0.0);
        let recipe = session.recipe();
        session.set("clean", info.id).expect("it is offered");
        assert_eq!(session.recipe(), recipe, "what was mapped is kept");
        let mut other = mapped(0.0);
        other.restore(&format!("place=map&{}", session.setup().to_link())).expect("a link of ours");
        assert_eq!(other.view().planner, info.id);
    }
    let refused = mapped(0.0).set("clean", "genetic").unwrap_err().to_string();
    assert!(refused.contains("boustrophedon"), "{refused}");
}

// slow: the search for its place is made twice
#[test]
fn a_search_on_a_map_that_was_given_survives_a_reload() {
    let mut session = map_session("room=kitchen&robot=roomba600&seed=1");
    let home = session.recipe();
    session.open(&(room("kitchen").expect("it ships").build)()).expect("it has walls");
    session.run_ahead(20.0);
    assert_eq!(session.home(), home);
    let text = session.store().expect("there is something to look for");
    let mut back = map_session("room=kitchen&robot=roomba600&seed=1");
    back.resume(&text).expect("it is one of ours");
    arrive(&mut back);
    assert!(!back.take_strayed());
    assert_eq!((run(&back).digest(), back.recipe()), (run(&session).digest(), session.recipe()));
    assert_eq!((back.view().known, back.view().is_sure), (session.view().known, session.view().is_sure));
    let particles = |session: &MapSession| session.estimate().expect("there is a robot").particles().len();
    assert_eq!(particles(&back), particles(&session));
    // Where it is of no use, it is refused, and what is there stays.
    let mut other = map_session("room=bedroom&robot=roomba600&seed=1");
    assert!(matches!(other.resume(&text), Err(StoreError::Another { .. })));
    assert_eq!(other.view().known, None);
}

#[test]
fn who_began_on_a_dock_goes_back_to_it() {
    let mut explore = Session::new();
    explore.restore("room=living&robot=roomba600&seed=3&start=0.6,1,180").expect("a link of ours");
    let prepared = explore.prepared().expect("it fits");
    let (robot, start, odometry) = (prepared.robot.clone(), prepared.floor.start, OdometryModel::Arc);
    assert!(start.heading.abs() > 3.0, "it looks at its dock, which is on the left: {start}");
    let mut mapper = Mapper::new(MapperSetup { robot, start, tracking: Tracking::Corrected, odometry, seed: 3 });
    let battery = BatteryReading { on_dock: true, ..BatteryReading::default() };
    mapper.update(&SensorReadings { battery, ..SensorReadings::default() });
    assert_eq!(mapper.berth(), Some(start));
    let noise = Noise::all(NoiseLevel::Typical);
    let conditions = Conditions { slip: SlipLevel::Typical, noise, ..Conditions::default() };
    let info = controller::find("bounce").expect("it exists");
    let params = Params::defaults(info.params);
    let run = prepared.run_behaviour(info, &params, conditions, 3).expect("it exists");
    let mut run = run.observed(Box::new(MapObserver::default().with_mapper(mapper)));
    while run.time_s() < 400.0 {
        run.step();
    }
    run.apply(Input::Clean("boustrophedon"));
    while !run.is_finished() && run.time_s() < 5000.0 {
        run.step();
    }
    assert!(run.is_finished() && run.activity().starts_with("done"), "{}", run.activity());
    assert!(run.sensors().battery.on_dock, "it stands at {} in the end, {}", run.pose(), run.activity());
}
