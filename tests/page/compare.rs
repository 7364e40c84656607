//! Comparisons as the page makes them, without a page.

use coverage_planners::{PLANNERS, find, metrics::METRICS};
use robovac_app::{
    compare::{
        Comparison, ComparisonTable, MOST_LANES, ManyRuns, ManyRunsPlace, MedianAndRange, PrintedRow, RoomChoice, Row,
        TrialProgress, to_csv, to_json,
    },
    explore::{Session, SessionState},
};
use robovac_core::{floor_plan::room, registry::Params, robot::cell_robot};
use robovac_sim::experiment::{Algorithm, Arena, Entrant, TrialRequest};

fn session(room: &str) -> Session {
    let mut session = Session::new();
    session.select_room(room).expect("the room ships");
    session.configure(|s| s.select_robot("cell")).expect("the robot exists");
    session.configure(|s| s.set_cell_size(0.2)).expect("the size is in range");
    session
}

fn comparison(session: &Session, planners: &[&str]) -> Comparison {
    let mut comparison = Comparison::new();
    for (entrant, info) in PLANNERS.iter().enumerate() {
        comparison.choose(entrant, planners.contains(&info.id));
    }
    comparison.take(session);
    comparison
}

/// Number of a planner among the entrants.
fn planner(id: &str) -> usize {
    PLANNERS.iter().position(|info| info.id == id).expect("the planner exists")
}

/// Serves all trials; returns the planners of the requests.
fn work(comparison: &mut Comparison) -> Vec<String> {
    let mut asked = Vec::new();
    while let Some(request) = comparison.take_trial() {
        comparison.trial_finished(request.id, serve(&request));
        asked.push(request.entrant);
    }
    asked
}

fn serve(request: &TrialRequest) -> Result<robovac_sim::experiment::PlanOutcome, String> {
    request.arena().and_then(|arena| request.run(&arena, || 0.0, None))
}

fn column(id: &str) -> usize {
    METRICS.iter().position(|metric| metric.id == id).expect("the metric exists")
}

#[test]
fn table_has_the_numbers_that_the_planners_reach_alone() {
    let session = session("thesis8");
    let mut comparison = comparison(&session, &["boustrophedon", "snake"]);
    assert_eq!(work(&mut comparison), ["boustrophedon", "snake"]);
    let table = comparison.table(None);
    let plan = (room("thesis8").expect("it ships").build)();
    let arena = Arena::new(&plan, &cell_robot(0.2), 0.2, None).expect("the robot fits");
    for row in &table.rows {
        let info = row.entrant.algorithm.planner().expect("a planner");
        let alone = arena.run(info, &Params::defaults(info.params), 1, || 0.0, None).expect("it plans");
        for (value, metric) in row.values.iter().zip(METRICS) {
            assert_eq!(value.map(|v| v.median), metric.value(&alone.numbers), "{} of {}", metric.id, info.id);
        }
    }
    // Known from the golden walks: 14 and 34 quarter turns.
    let turns = column("turns");
    assert!(table.is_best(&table.rows[0], turns) && !table.is_best(&table.rows[1], turns));
    assert_eq!(table.rows[1].values[turns], Some(MedianAndRange { median: 34.0, min: 34.0, max: 34.0 }));
}

#[test]
fn only_what_changed_is_tried_again() {
    let mut session = session("thesis8");
    let mut comparison = comparison(&session, &["boustrophedon", "snake"]);
    work(&mut comparison);
    comparison.set_param(planner("snake"), "patience", "0").expect("the value is in range");
    assert_eq!(work(&mut comparison), ["snake~patience:0"]);
    comparison.set_param(planner("snake"), "patience", "2").expect("the value is in range");
    comparison.choose(planner("boustrophedon"), false);
    comparison.choose(planner("boustrophedon"), true);
    comparison.take(&session);
    assert_eq!(work(&mut comparison), [""; 0], "both are known");
    session.select_room("lshape").expect("it ships");
    comparison.take(&session);
    assert_eq!(work(&mut comparison).len(), 2);
    session.select_room("thesis8").expect("it ships");
    comparison.take(&session);
    // The walks to be raced are those of one room; the numbers of the other are still known.
    assert_eq!(comparison.count(), (2, 2));
}

#[test]
fn trial_under_way_does_not_answer_for_another_parameter() {
    let session = session("thesis8");
    let mut comparison = comparison(&session, &["snake"]);
    let before = comparison.take_trial().expect("there is work");
    comparison.set_param(planner("snake"), "patience", "0").expect("it is in range");
    assert!(!comparison.is_wanted(before.id));
    comparison.trial_finished(before.id, serve(&before));
    assert_eq!(comparison.count(), (0, 1));
    assert_eq!(work(&mut comparison), ["snake~patience:0"]);
}

#[test]
fn race_comes_back_with_the_room() {
    let mut session = session("thesis8");
    let mut comparison = comparison(&session, &["boustrophedon", "snake"]);
    work(&mut comparison);
    session.select_room("lshape").expect("it ships");
    comparison.take(&session);
    session.select_room("thesis8").expect("it ships");
    comparison.take(&session);
    work(&mut comparison);
    assert_eq!(comparison.race().map_or(0, |race| race.lanes().len()), 2);
}

#[test]
fn paths_are_there_beyond_the_lanes_of_the_race() {
    let session = session("thesis8");
    let ids: Vec<&str> = PLANNERS.iter().map(|planner| planner.id).collect();
    let mut comparison = comparison(&session, &ids);
    work(&mut comparison);
    let race = comparison.race().expect("there is a room");
    assert!(race.lanes().len() == MOST_LANES && ids.len() > MOST_LANES);
    for (entrant, id) in ids.iter().enumerate() {
        let line = comparison.path(entrant).and_then(|path| race.line(path));
        assert!(line.is_some_and(|line| line.len() > 10), "{id}");
    }
}

#[test]
fn cancelled_trials_are_forgotten_and_made_when_it_goes_on() {
    let session = session("thesis8");
    let mut comparison = comparison(&session, &["boustrophedon", "snake"]);
    let first = comparison.take_trial().expect("there is work");
    comparison.trial_progress(first.id, 0.5);
    assert_eq!(comparison.progress(0), TrialProgress::Trying(0.5));
    comparison.cancel();
    assert!(!comparison.is_wanted(first.id) && comparison.take_trial().is_none());
    comparison.trial_finished(first.id, serve(&first));
    assert_eq!(comparison.count(), (0, 2), "a late answer counts for nothing");
    comparison.resume();
    assert_eq!(work(&mut comparison).len(), 2);
    assert_eq!(comparison.progress(0), TrialProgress::Done);
}

#[test]
fn failure_is_told_and_the_others_go_on() {
    let session = session("thesis8");
    let mut comparison = comparison(&session, &["boustrophedon", "snake"]);
    let first = comparison.take_trial().expect("there is work");
    comparison.trial_finished(first.id, Err("it fell over".into()));
    work(&mut comparison);
    assert_eq!(comparison.progress(0), TrialProgress::Failed("it fell over"));
    let table = comparison.table(None);
    assert_eq!(table.rows[0].failure.as_deref(), Some("it fell over"));
    // A robot that fills its cell has no excess.
    let is_there = |value: &Option<MedianAndRange>, id: &str| value.is_some() || id.starts_with("excess");
    assert!(table.rows[0].values.iter().all(Option::is_none));
    assert!(table.rows[1].values.iter().zip(METRICS).all(|(value, metric)| is_there(value, metric.id)));
    assert!(comparison.race().is_some_and(|race| race.lanes().len() == 1));
}

#[test]
fn robots_race_under_one_clock_and_come_back_to_the_bit() {
    let session = session("thesis8");
    let mut comparison = comparison(&session, &["boustrophedon", "snake"]);
    work(&mut comparison);
    let race = comparison.race_mut().expect("there are plans");
    assert_eq!(race.state(), SessionState::Ready);
    race.set_speed(100.0);
    race.play();
    race.frame(0.1, &mut || true);
    let poses = |race: &robovac_app::compare::Race| -> Vec<(u64, _, _)> {
        race.lanes().iter().map(|lane| (lane.run().steps(), lane.run().pose(), lane.run().coverage())).collect()
    };
    let early = poses(race);
    let time = race.time_s();
    assert!((time - 10.0).abs() < 0.02 && early[0].0 == early[1].0 && early[0].1 != early[1].1, "{time} s: {early:?}");
    race.set_speed(0.0);
    while race.state() == SessionState::Playing {
        race.frame(0.016, &mut || true);
    }
    assert_eq!(race.state(), SessionState::Finished);
    let [first, second] = race.lanes() else { panic!("two robots") };
    assert!(first.run().time_s() < second.run().time_s(), "the snake turns more often");
    let planned = first.racer.planned_s.expect("a planner");
    assert!((first.run().time_s() - planned).abs() < 0.05 * planned);
    assert_eq!(race.time_s(), second.run().time_s(), "the clock stops with the last robot");
    race.seek(time);
    while race.state() == SessionState::Seeking {
        race.frame(0.016, &mut || true);
    }
    assert_eq!(poses(race), early);
    race.play();
    assert_eq!(race.state(), SessionState::Playing);
}

#[test]
fn pets_walk_and_dirt_goes_in_the_pictures_of_a_race() {
    let mut comparison = comparison(&session("living"), &["boustrophedon"]);
    work(&mut comparison);
    let race = comparison.race_mut().expect("there is a plan");
    let seen = |race: &robovac_app::compare::Race| {
        let life = race.scene(&race.lanes()[0]).life.expect("the room has a cat and dirt");
        (life.movers().to_vec(), life.dirt_left())
    };
    let (cat, dirt) = seen(race);
    assert!(!cat.is_empty() && dirt > 0.0);
    race.set_speed(0.0);
    race.play();
    while race.state() == SessionState::Playing {
        race.frame(0.016, &mut || true);
    }
    let (later, left) = seen(race);
    assert!(later != cat && left < dirt, "{left} of {dirt}");
}

#[test]
fn link_brings_the_comparison_back() {
    let session = session("thesis8");
    let mut comparison = comparison(&session, &["boustrophedon", "snake"]);
    comparison.set_param(planner("snake"), "patience", "5").expect("the value is in range");
    comparison.set_rooms("all").expect("there are rooms");
    comparison.set_seeds(5);
    let link = comparison.to_link();
    assert_eq!(link, "vs=boustrophedon,snake~patience:5&rooms=all&seeds=5");
    comparison.set_speed(0.0);
    let link = comparison.to_link();
    assert!(link.ends_with("&seeds=5&pace=0"), "{link}");
    let mut other = Comparison::new();
    other.take(&session);
    other.restore(&format!("#room=thesis8&place=compare&{link}")).expect("it was just written");
    assert_eq!(other.to_link(), link);
    for wrong in ["vs=snail", "vs=snake~patience:much", "rooms=none", "seeds=0", "seeds=1000", "pace=fast"] {
        assert!(other.restore(wrong).is_err(), "{wrong}");
        assert_eq!(other.to_link(), link, "{wrong} changed something");
    }
}

#[test]
fn behaviours_that_the_robot_lacks_a_laser_for_stay_out_of_the_race() {
    let (blind, mut seeing) = (session("thesis8"), session("thesis8"));
    seeing.configure(|s| s.select_robot("roomba600_lidar")).expect("it is in the registry");
    let mut comparison = comparison(&blind, &["boustrophedon"]);
    comparison.restore("vs=boustrophedon&behaviours=online_snake").expect("it is in the registry");
    let snake = comparison.entrants().iter().position(|entrant| entrant.id() == "online_snake").expect("it cleans");
    for (session, lacks, lanes) in [(&blind, "needs a laser scanner", 1), (&seeing, "", 2)] {
        comparison.take(session);
        work(&mut comparison);
        assert_eq!(comparison.lacks(snake), lacks);
        assert_eq!(comparison.race().expect("there is a plan").lanes().len(), lanes);
    }
    assert!(comparison.to_link().contains("online_snake"), "it takes part again with another robot");
}

#[test]
fn own_rooms_are_compared_in_too() {
    let mut session = session("thesis8");
    session.begin_stroke(robovac_app::explore::Brush::Wall, robovac_core::geometry::Point::new(0.9, 0.7));
    session.end_stroke();
    let mut comparison = comparison(&session, &["boustrophedon"]);
    assert_eq!(comparison.rooms(), [RoomChoice::Own]);
    let request = comparison.take_trial().expect("there is work");
    let outcome = serve(&request).expect("there is a plan");
    assert_eq!(outcome.numbers.walk.unwrap().reachable_cells, 53, "one of 54 cells is a wall now");
}

#[test]
fn sums_and_means_over_rooms_and_median_over_seeds() {
    let plan = (room("thesis8").expect("it ships").build)();
    let arena = Arena::new(&plan, &cell_robot(0.2), 0.2, None).expect("the robot fits");
    let info = find("snake").expect("it exists");
    let one = arena.run(info, &Params::defaults(info.params), 1, || 0.0, None).expect("it plans").numbers;
    let mut other = one;
    other.walk.as_mut().unwrap().turns = 40;
    other.drive.coverage = 0.5;
    let row = Row::new(Entrant::new(Algorithm::Planner(info)), 0, &[vec![Ok(one), Ok(other)], vec![Ok(one), Ok(one)]]);
    assert_eq!(row.values[column("turns")], Some(MedianAndRange { median: 71.0, min: 68.0, max: 74.0 }));
    assert_eq!(row.values[column("coverage")], Some(MedianAndRange { median: 87.5, min: 75.0, max: 100.0 }));
    assert_eq!((row.trials, row.missing), (4, 0));
    let unfinished = Row::new(Entrant::new(Algorithm::Planner(info)), 0, &[vec![Ok(one)], vec![]]);
    assert_eq!((unfinished.values[column("turns")], unfinished.missing), (None, 1));
    assert_eq!(ComparisonTable::new(vec![unfinished]).best[column("turns")], None);
}

#[test]
fn files_hold_every_trial_with_all_numbers() {
    let session = session("thesis8");
    let mut comparison = comparison(&session, &["boustrophedon", "snake"]);
    let first = comparison.take_trial().expect("there is work");
    comparison.trial_finished(first.id, Err("a \"reason\", with a comma".into()));
    work(&mut comparison);
    let csv = to_csv(&comparison.records());
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines.len(), 3);
    assert!(lines[0].starts_with(
        "room,robot,cell size [m],cell offset x [m],cell offset y [m],planner,seed,error,cells,bound steps,bound turns,bound steps + 2 turns,coverage [%],"
    ));
    assert!(lines[1].contains("\"a \"\"reason\"\", with a comma\",,,,,"));
    assert!(lines[2].starts_with("Thesis preset 8 x 8,cell,0.2,0,0,snake,1,,54,53,14,81,100,"));
    let json: serde_json::Value = serde_json::from_str(&to_json(&comparison.records())).expect("it is JSON");
    assert_eq!(json[1]["numbers"]["turns"], 34.0);
    assert_eq!(json[0]["error"], "a \"reason\", with a comma");
}

#[test]
fn files_name_an_own_robot_with_what_makes_it_one() {
    let mut session = Session::new();
    session.restore("room=room12ft&robot=roomba600&own=tool:0.28,speed:0.25").expect("it is a link");
    let mut comparison = comparison(&session, &["snake"]);
    work(&mut comparison);
    let csv = to_csv(&comparison.records());
    assert!(csv.contains(",\"roomba600 own:tool:0.28,speed:0.25\",0."), "{csv}");
    let mut many = ManyRuns::new();
    many.take(&session);
    let place = ManyRunsPlace::new(&many).map(|place| serde_json::to_value(place).expect("it is JSON"));
    assert_eq!(place.expect("there is a room")["robot"], "Own robot");
}

#[test]
fn walk_that_misses_cells_is_the_best_in_nothing_but_coverage() {
    let session = session("room12ft");
    let mut comparison = comparison(&session, &[]);
    comparison.restore("vs=boustrophedon,snake~rules:program&rooms=this").expect("the rules exist");
    work(&mut comparison);
    let table = comparison.table(None);
    let [complete, printed] = &table.rows[..] else { panic!("there are two rows") };
    assert!(complete.is_complete && !printed.is_complete);
    let steps = column("steps");
    assert!(printed.values[steps].map(|v| v.median) < complete.values[steps].map(|v| v.median));
    assert!((0..METRICS.len()).all(|metric| !table.is_best(printed, metric)));
}

/// As a click on the button makes it.
fn table_2() -> (Comparison, ComparisonTable) {
    let mut session = session("empty");
    session.restore("room=thesis226&robot=cell&cell=0.2&seed=1").expect("the room ships");
    let mut comparison = comparison(&session, &[]);
    comparison.restore("vs=spiral,snake,genetic&rooms=this&seeds=1").expect("the planners exist");
    work(&mut comparison);
    let table = comparison.table(None);
    (comparison, table)
}

/// What the page and docs/planners.md say of Table 2: the printed values, ours, and in which order they are.
#[test]
fn order_of_table_2_is_as_the_documentation_claims() {
    let (_, table) = table_2();
    let order = |value: &dyn Fn(&Row) -> Option<f64>| {
        let mut rows: Vec<(f64, &str)> =
            table.rows.iter().map(|row| (value(row).expect("it is known"), row.entrant.id())).collect();
        rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        rows.into_iter().map(|(_, planner)| planner).collect::<Vec<_>>()
    };
    let ours = |metric: &str| order(&|row| Some(row.values[column(metric)]?.median));
    let printed = |metric: &str| order(&|row| row.printed?.value(metric));
    for metric in ["revisits", "length"] {
        assert_eq!(ours(metric), ["genetic", "snake", "spiral"], "{metric}");
        assert_eq!(ours(metric), printed(metric), "{metric}");
    }
    assert_eq!(ours("direction_changes"), ["genetic", "snake", "spiral"]);
    assert_eq!(printed("direction_changes"), ["snake", "genetic", "spiral"]);

    let page =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/planners.md")).expect("it can be read");
    for row in &table.rows {
        let PrintedRow { algorithm, turns, revisits, length_m, planner } = row.printed.expect("it is in the table");
        let [changes, again, length] =
            ["direction_changes", "revisits", "length"].map(|id| row.values[column(id)].expect("it is known").median);
        let line = format!(
            "| {algorithm} | {turns} | {revisits} | {length_m:.1} | `{planner}` | {changes} | {again} | {length:.1} |"
        );
        assert!(page.contains(&line), "{line}");
    }
    // The room was laid out so that the snake does about what is printed.
    let snake = table.rows.iter().find(|row| row.entrant.id() == "snake").expect("it takes part");
    for (metric, far) in [("direction_changes", 2.0), ("revisits", 1.0), ("length", 2.0)] {
        let value = snake.values[column(metric)].expect("it is known").median;
        assert!((value - snake.printed.and_then(|p| p.value(metric)).expect("it is printed")).abs() <= far, "{metric}");
    }
}

#[test]
fn printed_values_are_shown_only_beside_their_room() {
    let (mut comparison, _) = table_2();
    comparison.take(&session("thesis226"));
    assert!(comparison.table(None).rows.iter().all(|row| row.printed.is_some()));
    assert!(comparison.table(Some(RoomChoice::Shipped("flat"))).rows.iter().all(|row| row.printed.is_none()));
    let mut finer = session("thesis226");
    finer.configure(|s| s.set_cell_size(0.1)).expect("the size is in range");
    comparison.take(&finer);
    assert!(comparison.table(None).rows.iter().all(|row| row.printed.is_none()));
}

#[test]
fn robot_that_comes_late_catches_up_and_the_race_goes_on() {
    let session = session("thesis8");
    let mut comparison = comparison(&session, &["boustrophedon", "snake"]);
    let first = comparison.take_trial().expect("there is work");
    comparison.trial_finished(first.id, serve(&first));
    let race = comparison.race_mut().expect("there is a plan");
    race.set_speed(100.0);
    race.play();
    race.frame(0.1, &mut || true);
    let before = (race.time_s(), race.lanes()[0].run().pose());
    work(&mut comparison);
    let race = comparison.race_mut().expect("there are plans");
    assert_eq!(race.lanes().len(), 2);
    while race.state() == SessionState::Seeking {
        race.frame(0.0, &mut || true);
    }
    assert_eq!((race.time_s(), race.lanes()[0].run().pose()), before);
    assert_eq!(race.lanes()[0].run().steps(), race.lanes()[1].run().steps());
    assert_eq!(race.state(), SessionState::Playing);
    // Seeking ahead of the simulated time gets there, all robots together, even if the race is paused.
    race.seek(40.0);
    race.pause();
    race.step();
    while race.state() == SessionState::Seeking {
        race.frame(0.0, &mut || true);
    }
    assert!((race.time_s() - 40.0).abs() < 0.02, "{}", race.time_s());
    assert_eq!(race.lanes()[0].run().steps(), race.lanes()[1].run().steps());
    assert_eq!(race.state(), SessionState::Paused);
}

#[test]
fn who_stops_early_on_a_dirty_floor_is_not_first() {
    let mut session = session("room12ft");
    session.configure(|s| s.select_robot("roomba600")).expect("the robot exists");
    session.configure(|s| s.set_slip("harsh")).expect("the level exists");
    let mut comparison = comparison(&session, &["boustrophedon", "snake"]);
    work(&mut comparison);
    let race = comparison.race_mut().expect("there are plans");
    race.set_speed(0.0);
    race.play();
    while race.state() == SessionState::Playing {
        race.frame(0.016, &mut || true);
    }
    let lanes: Vec<(usize, f64, u64)> =
        race.places().into_iter().zip(race.lanes()).map(|(p, l)| (p, l.run().coverage(), l.run().steps())).collect();
    let (first, second) = if lanes[0].0 == 1 { (lanes[0], lanes[1]) } else { (lanes[1], lanes[0]) };
    assert!(second.1 < 0.95, "harsh slip leads the robot astray: {lanes:?}");
    assert!(first.1 > second.1 && second.0 == 2, "{lanes:?}");
}

#[test]
fn behaviours_race_too_and_stop_after_the_slowest_plan() {
    let session = session("thesis8");
    let mut comparison = comparison(&session, &["boustrophedon"]);
    let is_bounce = |entrant: &Entrant| entrant.algorithm.kind() == "behaviour" && entrant.id() == "random_walk";
    let bounce = comparison.entrants().iter().position(is_bounce).expect("it cleans");
    comparison.choose(bounce, true);
    assert_eq!(work(&mut comparison), ["boustrophedon"], "a behaviour needs no plan");
    assert!(comparison.to_link().contains("vs=boustrophedon&behaviours=random_walk&"), "{}", comparison.to_link());
    let race = comparison.race_mut().expect("there is a plan");
    assert_eq!(race.lanes().len(), 2);
    race.set_speed(0.0);
    race.play();
    while race.state() == SessionState::Playing {
        race.frame(0.016, &mut || true);
    }
    assert_eq!(race.state(), SessionState::Finished);
    let planned = race.lanes()[0].racer.planned_s.expect("a planner");
    assert!(race.end_s() <= 1.5 * planned + 1.0, "{} after {planned}", race.end_s());
    assert_eq!(race.places()[0], 1, "a plan is faster than chance");
    assert!(race.lanes()[1].run().coverage() > 0.2);
    assert!(comparison.table(None).rows.iter().all(|row| row.index != bounce), "it has no plan for the table");
}

#[test]
fn a_planner_races_against_itself_with_other_parameters() {
    let session = session("thesis8");
    let mut comparison = comparison(&session, &["snake"]);
    let snake = planner("snake");
    comparison.copy(snake);
    let copy = comparison.entrants().len() - 1;
    assert_eq!((comparison.copy_number(snake), comparison.copy_number(copy)), (1, 2));
    let told = |comparison: &Comparison| [snake, copy].map(|index| comparison.distinction(index));
    assert_eq!(told(&comparison), ["", "(2)"], "alike, they are counted");
    comparison.set_param(copy, "patience", "0").expect("it is in range");
    assert_eq!(told(&comparison), ["patience 2", "patience 0"], "each is named by what differs");
    assert_eq!(work(&mut comparison), ["snake", "snake~patience:0"]);
    assert_eq!(comparison.race().map_or(0, |race| race.lanes().len()), 2);
    assert_eq!(comparison.table(None).rows.len(), 2);
    let link = comparison.to_link();
    assert!(link.contains("vs=snake,snake~patience:0&"), "{link}");
    let mut other = Comparison::new();
    other.restore(&link).expect("it was just written");
    assert_eq!(other.to_link(), link);
    comparison.remove_copy(copy);
    assert!(comparison.copy_number(copy) == 0 && !comparison.is_chosen(copy));
    assert_eq!(comparison.distinction(snake), "");
    assert_eq!(comparison.race().map_or(0, |race| race.lanes().len()), 1);
    comparison.remove_copy(snake);
    assert!(comparison.is_chosen(snake), "an original stays");
}

#[test]
fn nine_that_race_are_chosen_by_the_user() {
    let session = session("thesis8");
    let ids: Vec<&str> = PLANNERS.iter().map(|planner| planner.id).collect();
    let mut comparison = comparison(&session, &ids);
    work(&mut comparison);
    let racing = |comparison: &Comparison| -> Vec<usize> {
        comparison.race().map_or(Vec::new(), |race| race.lanes().iter().map(|lane| lane.racer.entrant).collect())
    };
    let (first, waiting) = (racing(&comparison), comparison.waiting());
    assert_eq!(first.len() + waiting.len(), ids.len());
    // A tenth takes the place of the last one, who is told beforehand; who leaves makes room for the next.
    assert_eq!(comparison.leaves(), first.last().copied());
    comparison.set_racing(waiting[1], true);
    assert_eq!(racing(&comparison)[..], [&first[..MOST_LANES - 1], &[waiting[1]]].concat());
    assert_eq!(comparison.leaves(), Some(waiting[1]));
    comparison.set_racing(first[0], false);
    assert!(!racing(&comparison).contains(&first[0]) && racing(&comparison).len() == MOST_LANES);
    assert!(comparison.waiting().contains(&first[0]));
    // A link has the same race.
    let mut elsewhere = Comparison::new();
    elsewhere.take(&session);
    elsewhere.restore(&comparison.to_link()).unwrap();
    assert_eq!(elsewhere.to_link().matches("bench=").count(), 1, "also before there are plans");
    work(&mut elsewhere);
    let sorted = |mut racing: Vec<usize>| {
        racing.sort_unstable();
        racing
    };
    assert_eq!(sorted(racing(&elsewhere)), sorted(racing(&comparison)));
    for other in comparison.waiting().into_iter().chain([first[1]]) {
        comparison.choose(other, false);
    }
    assert_eq!((racing(&comparison).len(), comparison.leaves()), (MOST_LANES - 1, None));
}
