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
fn survey(link: &str) -> MapSession {
    let mut session = Session::new();
    session.restore(link).expect("a link of ours");
    let mut survey = MapSession::new();
    survey.take(&session);
    survey
}

/// A furnished room, mapped for so long, s.
fn mapped(seconds: f64) -> MapSession {
    let mut survey = survey("room=bedroom&robot=roomba600&seed=3");
    survey.run_ahead(seconds);
    survey
}

/// Lets it go on until it is done, at most so long, s.
fn finish(survey: &mut MapSession, most_s: f64) {
    let end = run(survey).time_s() + most_s;
    while survey.phase() != MapPhase::Finished && run(survey).time_s() < end {
        survey.run_ahead(30.0);
    }
}

fn arrive(survey: &mut MapSession) {
    for _ in 0..100_000 {
        if !matches!(survey.phase(), MapPhase::Resuming | MapPhase::Seeking) {
            return;
        }
        survey.frame(0.016, &mut || true);
    }
    panic!("still {:?}", survey.phase());
}

fn run(survey: &MapSession) -> &Run {
    survey.run().expect("there is a run")
}

#[test]
fn a_furnished_room_is_cleaned_by_the_robots_own_map() {
    let mut survey = mapped(60.0);
    finish(&mut survey, 1500.0);
    assert_eq!(survey.phase(), MapPhase::Finished, "its map is complete");
    let before = run(&survey).coverage();
    assert!(survey.can(MapAction::Clean) && survey.view().by_map.is_none());
    survey.clean();
    assert_eq!(survey.phase(), MapPhase::Playing, "it sets out at once");
    finish(&mut survey, 3600.0);
    let (view, after) = (survey.view(), run(&survey).coverage());
    assert_eq!((survey.phase(), view.activity.starts_with("done")), (MapPhase::Finished, true), "{}", view.activity);
    let [swept, all] = view.by_map.expect("it has cleaned by its map");
    assert!(after > before + 0.1 && after > 0.88, "{before} mapping, {after} in the end");
    assert!(swept > 0.93 * all, "{swept} of {all} m² as it believes");
    let off = survey.figures().expect("there is a run")[0].position_m.expect("it has an idea");
    assert!(off < 0.1, "{off} m off");
}

#[test]
fn what_it_senses_is_all_that_it_goes_by() {
    let mut survey = mapped(400.0);
    survey.clean();
    survey.run_ahead(3.0 * STEP_S);
    let mut here = run(&survey).clone();
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
    let mut survey = mapped(300.0);
    survey.clean();
    let began = run(&survey).time_s();
    survey.run_ahead(120.0);
    let (digest, end) = (run(&survey).digest(), run(&survey).time_s());
    survey.seek(began - 20.0);
    arrive(&mut survey);
    assert!(!survey.view().is_cleaning, "it was still exploring");
    survey.seek(end);
    arrive(&mut survey);
    assert_eq!((run(&survey).digest(), survey.view().is_cleaning), (digest, true));

    let text = survey.store().expect("there is a map");
    let mut back = mapped(0.0);
    back.resume(&text).expect("it is one of ours");
    arrive(&mut back);
    assert!(!back.take_strayed() && back.view().is_cleaning);
    assert_eq!(run(&back).digest(), digest);
    for survey in [&mut survey, &mut back] {
        survey.run_ahead(30.0);
    }
    assert_eq!(run(&back).digest(), run(&survey).digest());
}

/// Regression: a run that had ended and was then continued by cleaning ended at the same step when it was simulated
/// again.
#[test]
fn a_run_that_was_over_and_goes_on_does_so_again() {
    let mut survey = survey("room=room12ft&robot=roomba600&seed=3");
    finish(&mut survey, 1500.0);
    assert_eq!(survey.phase(), MapPhase::Finished);
    let over = run(&survey).time_s();
    survey.clean();
    survey.run_ahead(40.0);
    let digest = run(&survey).digest();
    let text = survey.store().expect("there is a map");
    survey.seek(over);
    arrive(&mut survey);
    assert!(survey.can(MapAction::Play), "{:?}", survey.phase());
    let mut back = self::survey("room=room12ft&robot=roomba600&seed=3");
    back.resume(&text).expect("it is one of ours");
    arrive(&mut back);
    assert_eq!(run(&back).digest(), digest);
}

// slow: relocalising takes minutes of driving
#[test]
fn a_robot_that_is_carried_off_finds_itself_and_goes_on_cleaning() {
    let mut survey = mapped(700.0);
    survey.clean();
    survey.run_ahead(60.0);
    let marks =
        |survey: &MapSession| survey.estimate().expect("there is a robot").marks.cells(CellMark::Cleaned).count();
    survey.lift();
    survey.put_down(Pose::new(1.0, 1.6, 2.0));
    survey.run_ahead(2.0);
    assert_eq!((survey.view().is_sure, survey.view().activity), (Some(false), "relocalising on its map"));
    let before = marks(&survey);
    let mut waited = 0;
    while survey.view().is_sure.is_some() && waited < 40 {
        assert_eq!(survey.view().is_sure, Some(false), "it doesn't go by what it guesses yet");
        assert_eq!(marks(&survey), before, "who is lost doesn't know what it cleans");
        survey.run_ahead(15.0);
        waited += 1;
    }
    assert_eq!(survey.view().is_sure, None, "it is found");
    survey.run_ahead(60.0);
    let off = survey.figures().expect("there is a run")[0].position_m.expect("it has an idea");
    assert!(off < 0.15, "{off} m off");
    assert!(marks(&survey) > before, "it goes on");
}

#[test]
fn a_map_that_it_was_given_is_cleaned_by_once_it_knows_where_it_is() {
    let mut survey = survey("room=kitchen&robot=roomba600&seed=1");
    survey.open(&(room("kitchen").expect("it ships").build)()).expect("it has walls");
    assert!(!survey.can_clean(), "it has never set off");
    survey.run_ahead(1.0);
    survey.clean();
    survey.run_ahead(1.0);
    assert_eq!(survey.view().is_sure, Some(false));
    survey.run_ahead(240.0);
    let off = survey.figures().expect("there is a run")[0].position_m.expect("it has an idea");
    assert!(survey.view().is_sure.is_none() && off < 0.15, "{off} m off");
    assert!(survey.view().by_map.is_some_and(|[swept, all]| all > 2.0 && swept > 0.0));
}

#[test]
fn what_was_stored_by_other_versions_is_read_or_explained() {
    let survey = mapped(60.0);
    let mine = survey.store().expect("there is a map");
    let older = mine.replacen(&format!("\"version\":{STORE_VERSION}"), "\"version\":1", 1);
    assert_ne!(older, mine);
    let mut back = mapped(0.0);
    back.resume(&older).expect("version 1 has nothing that this one doesn't have");
    arrive(&mut back);
    assert_eq!(run(&back).digest(), run(&survey).digest());
    let mut stored = Stored::from_text(&mine).expect("it is one of ours");
    stored.inputs.push((10, Input::Clean("mole_tunnels")));
    let error = back.resume(&stored.to_text()).expect_err("there is no such planner");
    assert_eq!(error, StoreError::Planner { id: "mole_tunnels".to_owned() });
}

#[test]
fn planners_of_what_is_left_are_offered_and_links_bring_them_back() {
    assert!(cleaners().count() > 3);
    for info in cleaners() {
        let mut survey = mapped(0.0);
        let recipe = survey.recipe();
        survey.set("clean", info.id).expect("it is offered");
        assert_eq!(survey.recipe(), recipe, "what was mapped is kept");
        let mut other = mapped(0.0);
        other.restore(&format!("place=map&{}", survey.setup().to_link())).expect("a link of ours");
        assert_eq!(other.view().planner, info.id);
    }
    let refused = mapped(0.0).set("clean", "genetic").unwrap_err().to_string();
    assert!(refused.contains("boustrophedon"), "{refused}");
}

// slow: the search for its place is made twice
#[test]
fn a_search_on_a_map_that_was_given_survives_a_reload() {
    let mut survey = survey("room=kitchen&robot=roomba600&seed=1");
    let home = survey.recipe();
    survey.open(&(room("kitchen").expect("it ships").build)()).expect("it has walls");
    survey.run_ahead(20.0);
    assert_eq!(survey.home(), home);
    let text = survey.store().expect("there is something to look for");
    let mut back = self::survey("room=kitchen&robot=roomba600&seed=1");
    back.resume(&text).expect("it is one of ours");
    arrive(&mut back);
    assert!(!back.take_strayed());
    assert_eq!((run(&back).digest(), back.recipe()), (run(&survey).digest(), survey.recipe()));
    assert_eq!((back.view().known, back.view().is_sure), (survey.view().known, survey.view().is_sure));
    let particles = |survey: &MapSession| survey.estimate().expect("there is a robot").particles().len();
    assert_eq!(particles(&back), particles(&survey));
    // Where it is of no use, it is refused, and what is there stays.
    let mut other = self::survey("room=bedroom&robot=roomba600&seed=1");
    assert!(matches!(other.resume(&text), Err(StoreError::Another { .. })));
    assert_eq!(other.view().known, None);
}

#[test]
fn who_began_on_a_dock_goes_back_to_it() {
    let mut session = Session::new();
    session.restore("room=living&robot=roomba600&seed=3&start=0.6,1,180").expect("a link of ours");
    let prepared = session.prepared().expect("it fits");
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
