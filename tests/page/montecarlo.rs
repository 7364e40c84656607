//! Studies as the page and the command line make them, without either.

use robovac_app::{compare::ManyRuns, explore::Session};
use robovac_core::{
    floor_plan::room,
    robot::{OdometryModel, model},
};
use robovac_sim::{
    Conditions, NoiseLevel, SlipLevel,
    experiment::{BEHAVIOUR, Entrant, PLANNER},
    montecarlo::{Band, GOALS, Lab, RunOutcome, RunTally, SAMPLES, Summary, Terms, to_csv, to_json},
};
use serde_json::Value;

/// A lab in an empty room, for runs of so many seconds.
fn lab(duration_s: f64) -> Lab {
    let conditions = Conditions { slip: SlipLevel::Typical, ..Conditions::default() };
    let terms = Terms { conditions, odometry: OdometryModel::Arc, smooth: false, duration_s, plan_seed: 1 };
    let robot = model("roomba600").expect("it ships");
    Lab::new(&(room("room12ft").expect("it ships").build)(), robot, 0.12, None, terms).expect("the robot fits")
}

fn entrant(name: &str) -> Entrant {
    Entrant::parse(BEHAVIOUR, name).or_else(|_| Entrant::parse(PLANNER, name)).expect("it exists")
}

/// An outcome made by hand: coverage grows evenly to `end`, and the goals are reached at those times.
fn outcome(seed: u64, end: f64, reached_s: [f64; GOALS.len()]) -> RunOutcome {
    let curve = (0..=SAMPLES).map(|i| end * i as f64 / SAMPLES as f64).collect();
    RunOutcome {
        seed,
        curve,
        reached_s,
        time_s: 60.0,
        distance_m: 10.0 * end,
        bumps: seed as u32,
        falls: 0,
        dirt_left: None,
        excess: Some([0.5 * end, end]),
        digest: seed,
    }
}

#[test]
fn run_is_the_same_each_time_and_different_for_each_seed() {
    let lab = lab(120.0);
    for name in ["bounce", "snake"] {
        let entrant = entrant(name);
        assert!(name == "bounce" || lab.run(&entrant, 7).is_none(), "nothing is driven before it is planned");
        lab.plan(&entrant, None).expect("there is a plan");
        let [first, again, other] = [7, 7, 8].map(|seed| lab.run(&entrant, seed).expect("it runs"));
        assert_eq!(first, again, "{name}");
        assert_ne!(first.digest, other.digest, "{name}");
        assert_eq!(first.curve.len(), SAMPLES + 1);
        assert!(first.curve.is_sorted() && first.curve[0] > 0.0 && first.coverage() > 0.15, "{name}");
        assert!((first.time_s - 120.0).abs() < 0.015 && first.distance_m > 10.0, "{name}");
    }
}

#[test]
fn curve_and_times_tell_of_the_same_run() {
    let lab = lab(1800.0);
    let entrant = entrant("boustrophedon");
    lab.plan(&entrant, None).expect("there is a plan");
    let outcome = lab.run(&entrant, 1).expect("it runs");
    assert!(outcome.time_s < 1000.0, "it comes to an end by itself");
    let last = outcome.curve.partition_point(|&coverage| coverage < outcome.coverage());
    assert!(outcome.curve[last..].iter().all(|&c| c == outcome.coverage()), "and coverage stays");
    assert!(outcome.coverage() >= GOALS[0]);
    let sample = (outcome.reached_s[0] / 1800.0 * SAMPLES as f64) as usize;
    assert!(outcome.curve[sample] <= GOALS[0] && GOALS[0] <= outcome.curve[sample + 1]);
}

/// Those that explore are measured by the boundary that they have met, and stop when their map is complete.
#[test]
fn exploring_behaviours_are_measured_by_the_boundary() {
    let lab = lab(600.0);
    let boundary = |name: &str| lab.run(&entrant(name), 3).expect("it runs");
    let [chance, edge, frontier] = ["explore_left_right", "explore_edge", "explore_frontier"].map(boundary);
    for outcome in [&chance, &edge, &frontier] {
        assert_eq!(outcome.curve[0], 0.0, "nothing is met in the middle of a room");
        assert!(outcome.curve.is_sorted() && outcome.coverage() <= 1.0);
    }
    assert!(edge.coverage() > 0.9 && frontier.coverage() > 0.95 && chance.coverage() < 0.7);
    assert!(frontier.reached_s[0] < edge.reached_s[0] && edge.reached_s[0] < 600.0, "{:?}", edge.reached_s);
    assert_eq!(lab.run(&entrant("explore_edge"), 3), Some(edge));
    // In the same lab, others are measured by the floor.
    assert!(lab.run(&entrant("bounce"), 3).expect("it runs").curve[0] > 0.0);
}

#[test]
fn a_study_offers_those_that_explore_and_exports_say_what_is_measured() {
    let session = session("room=room12ft&robot=roomba600");
    let usual = ManyRuns::new();
    let explores =
        |many: &ManyRuns| (0..many.entrants().len()).filter(|&i| many.entrants()[i].explores()).collect::<Vec<_>>();
    assert_eq!(explores(&usual).len(), 7);
    assert!(explores(&usual).iter().all(|&i| !usual.is_chosen(i)), "only cleaners are chosen at first");
    let mut many = many(&session, "bounce,explore_edge", "", 1);
    work(&mut many);
    let (head, entries) = many.export().expect("there is a room");
    let csv = to_csv(&head, &entries);
    let ends: Vec<&str> = csv.lines().filter_map(|line| line.rsplit(',').next()).collect();
    assert_eq!(ends, ["measure", "floor", "boundary"]);
    let json: Value = serde_json::from_str(&to_json(&head, &entries)).expect("it is JSON");
    assert_eq!([0, 1].map(|i| json["algorithms"][i]["measure"].clone()), ["floor", "boundary"]);
}

#[test]
fn outcomes_cross_to_another_thread_and_back() {
    let outcomes = [
        outcome(3, 0.95, [20.0, f64::INFINITY]),
        RunOutcome { digest: u64::MAX - 5, dirt_left: Some(0.25), excess: None, ..outcome(4, 0.5, [1.0, 2.0]) },
    ];
    let numbers: Vec<f64> = outcomes.iter().flat_map(RunOutcome::to_numbers).collect();
    assert_eq!(RunOutcome::from_numbers(&numbers), outcomes);
    assert_eq!(RunOutcome::from_numbers(&numbers[..numbers.len() - 1]), outcomes[..1], "half an outcome is none");
    assert!(RunOutcome::from_numbers(&[f64::NAN; 22]).len() <= 2, "nonsense ends somewhere");
}

#[test]
fn summary_has_the_quantiles_of_the_definition_and_no_times_that_nobody_knows() {
    let never = f64::INFINITY;
    // Coverage 0.1 to 1.0: the 10 % quantile of ten values lies at place 0.9.
    let runs: Vec<RunOutcome> =
        (1..=10).map(|i| outcome(i, i as f64 / 10.0, [if i > 3 { 100.0 * i as f64 } else { never }, never])).collect();
    let runs: Vec<&RunOutcome> = runs.iter().collect();
    let summary = Summary::of(&runs).expect("there are runs");
    let near = |band: Band, low: f64, median: f64, high: f64| {
        for (found, expected) in [(band.low, low), (band.median, median), (band.high, high)] {
            assert!((found - expected).abs() < 1e-9, "{band:?}");
        }
    };
    near(summary.coverage, 0.19, 0.55, 0.91);
    near(summary.distance_m, 1.9, 5.5, 9.1);
    near(summary.bumps, 1.9, 5.5, 9.1);
    near(summary.excess.expect("they sweep")[1], 0.19, 0.55, 0.91);
    near(Band::curve(&runs)[SAMPLES / 2], 0.095, 0.275, 0.455);
    let [to_90, to_99] = summary.time_to;
    // 400, 500, ..., 1000 and three that never got there: places 0.9, 4.5 and 8.1.
    assert_eq!((to_90.percent, to_90.reached), (90.0, 7));
    assert!((to_90.low_s.expect("reached") - 490.0).abs() < 1e-9);
    assert!((to_90.median_s.expect("reached") - 850.0).abs() < 1e-9);
    assert_eq!(to_90.high_s, None, "nobody knows when nine in ten were there");
    assert_eq!((to_99.reached, to_99.low_s, to_99.median_s), (0, None, None));
    assert_eq!(Summary::of(&[]), None);
}

#[test]
fn order_of_outcomes_makes_no_difference() {
    let all: Vec<RunOutcome> = (0..7).map(|i| outcome(i, 0.1 * i as f64, [i as f64, f64::INFINITY])).collect();
    let tally = |order: &[usize]| {
        let mut tally = RunTally::default();
        for &i in order {
            tally.add(all[i].clone());
        }
        tally
    };
    let (one, other) = (tally(&[0, 1, 2, 3, 4, 5, 6]), tally(&[6, 2, 4, 0, 2, 5, 1, 3]));
    assert_eq!(one, other);
    assert_eq!(Summary::of(&one.runs(0, 7)), Summary::of(&other.runs(0, 7)));
    assert_eq!(one.runs(2, 3).iter().map(|run| run.seed).collect::<Vec<_>>(), [2, 3, 4]);
}

fn session(link: &str) -> Session {
    let mut session = Session::new();
    session.restore(link).expect("the link is good");
    session
}

/// Many runs, short and few, in the session's room.
fn many(session: &Session, behaviours: &str, planners: &str, seeds: u32) -> ManyRuns {
    let mut many = ManyRuns::new();
    many.choose_only(BEHAVIOUR, behaviours).expect("they exist");
    many.choose_only(PLANNER, planners).expect("they exist");
    many.set_seeds(seeds);
    many.set_minutes(1);
    many.take(session);
    many
}

/// Makes all missing runs; returns the names and seeds of the requests.
fn work(many: &mut ManyRuns) -> Vec<(String, Vec<u64>)> {
    let mut asked = Vec::new();
    many.run();
    while let Some(request) = many.take_batch() {
        assert!(many.is_wanted(request.id));
        let outcomes = request.lab().and_then(|lab| request.run(&lab, None));
        many.batch_finished(request.id, outcomes);
        asked.push((request.entrant, request.seeds));
    }
    asked
}

#[test]
fn study_makes_each_run_once_and_only_what_is_missing() {
    let session = session("room=empty&robot=roomba600&seed=5");
    let mut many = many(&session, "bounce", "boustrophedon", 2);
    assert!(many.take_batch().is_none(), "not before it is started");
    let names: Vec<_> = work(&mut many);
    assert_eq!(names.iter().map(|(_, seeds)| seeds.len()).sum::<usize>(), 4);
    assert!(names.iter().all(|(_, seeds)| *seeds == [5, 6]), "a request holds as many runs as it can: {names:?}");
    assert_eq!((many.count(), many.is_running()), ((4, 4), false));
    many.set_seeds(3);
    assert_eq!(many.count(), (4, 6));
    assert!(work(&mut many).iter().all(|(_, seeds)| *seeds == [7]));
    many.set_seeds(2);
    assert_eq!((many.count(), many.runs(0).len()), ((4, 4), 2), "fewer are shown than are known");
    let bounce = (0..many.entrants().len()).find(|&i| many.entrants()[i].id() == "bounce").expect("it exists");
    many.choose(bounce, false);
    assert_eq!(many.count(), (2, 2));
    many.choose(bounce, true);
    assert!(work(&mut many).is_empty(), "what was known is still known");
}

#[test]
fn outcome_is_that_of_the_run_that_explore_shows() {
    let link = "room=room12ft&robot=roomba600&slip=typical&noise=typical&seed=3&start=1.5,2,30";
    let mut explore = session(&format!("{link}&behaviour=bounce"));
    explore.run_ahead(60.0);
    let shown = explore.recording().expect("it runs").run();
    let mut many = many(&session(link), "bounce", "", 1);
    work(&mut many);
    let index = (0..many.entrants().len()).find(|&i| many.is_chosen(i)).expect("one is chosen");
    let runs = many.runs(index);
    assert_eq!((runs[0].seed, runs[0].digest), (3, shown.digest()));
    assert_eq!(runs[0].coverage(), shown.coverage());
}

#[test]
fn cancelled_runs_are_dropped_and_begun_again() {
    let session = session("room=empty");
    let mut many = many(&session, "bounce", "", 100);
    many.run();
    let request = many.take_batch().expect("there is something to do");
    many.cancel();
    assert!(!many.is_wanted(request.id) && many.take_batch().is_none());
    many.batch_finished(request.id, Ok(vec![outcome(1, 1.0, [1.0, 1.0])]));
    assert_eq!(many.count().0, 0, "what nobody waits for is not taken");
    many.run();
    assert_eq!(many.take_batch().expect("again").seeds, request.seeds);
}

#[test]
fn another_room_has_results_of_its_own_and_the_old_ones_are_kept() {
    let mut session = session("room=empty");
    let mut many = many(&session, "bounce", "", 1);
    work(&mut many);
    session.select_room("lshape").expect("it ships");
    many.take(&session);
    assert_eq!(many.count(), (0, 1));
    work(&mut many);
    session.select_room("empty").expect("it ships");
    many.take(&session);
    assert_eq!(many.count(), (1, 1));
    session.configure(|settings| settings.set_noise(None, NoiseLevel::Harsh.id())).expect("there is such a level");
    many.take(&session);
    assert_eq!(many.count(), (0, 1), "other conditions, other runs");
    session.configure(|settings| settings.set_noise(None, NoiseLevel::Off.id())).expect("there is such a level");
    session.set_speed(1024.0);
    many.take(&session);
    assert_eq!(many.count(), (1, 1), "how fast Explore plays is nobody's business");
}

#[test]
fn failure_is_told_and_tried_again() {
    let session = session("room=empty");
    let mut many = many(&session, "bounce", "", 1);
    many.run();
    let request = many.take_batch().expect("there is something to do");
    many.batch_finished(request.id, Err("no room".to_owned()));
    let index = (0..many.entrants().len()).find(|&i| many.is_chosen(i)).expect("one is chosen");
    assert_eq!((many.failure(index), many.is_running()), (Some("no room"), false));
    many.run();
    assert!(many.failure(index).is_none() && many.take_batch().is_some());
}

#[test]
fn link_brings_back_the_choices_and_bad_ones_are_refused() {
    let mut many = ManyRuns::new();
    many.restore("#room=flat&runs=spiral_out,bounce&paths=spiral,snake~patience:3&times=10&minutes=60")
        .expect("it is good");
    let link = many.to_link();
    assert!(link.contains("runs=spiral_out,bounce&") && link.ends_with("&times=10&minutes=60"), "{link}");
    assert!(link.contains("paths=spiral,snake~patience:3&"), "{link}");
    for (bad, why) in [
        ("runs=snail", "there is no behaviour \"snail\""),
        ("runs=manual", "there is no autonomous cleaning or exploring algorithm \"manual\""),
        ("paths=bounce", "there is no planner \"bounce\""),
        ("paths=snake~patience:99", "use a whole number from 0 to 20"),
        ("times=0", "can't be \"0\"; use a whole number from 1 to 1000"),
        ("minutes=1e9", "whole minutes from 1 to 600"),
    ] {
        let message = many.restore(&format!("minutes=10&{bad}")).expect_err(bad).to_string();
        assert!(message.contains(why), "{message}");
        assert_eq!(many.minutes(), 60, "nothing is changed");
    }
}

#[test]
fn exports_tell_every_run_and_the_same_summary() {
    let session = session("room=empty&slip=typical");
    let mut many = many(&session, "bounce", "boustrophedon", 2);
    work(&mut many);
    let (head, entries) = many.export().expect("there is a room");
    let csv = to_csv(&head, &entries);
    let lines: Vec<&str> = csv.lines().collect();
    let columns = lines[0].split(',').count();
    assert_eq!(lines.len(), 5, "a head and a line for each run");
    assert!(lines.iter().all(|line| line.split(',').count() == columns), "{csv}");
    let json: Value = serde_json::from_str(&to_json(&head, &entries)).expect("it is JSON");
    assert_eq!((&json["slip"], &json["noise"]), (&Value::from("typical"), &Value::from("off")));
    assert_eq!(json["times_s"][SAMPLES], 60.0);
    for algorithm in json["algorithms"].as_array().expect("a list") {
        assert_eq!(algorithm["each"].as_array().map(Vec::len), Some(2));
        assert_eq!(algorithm["curve"]["median"][SAMPLES], algorithm["coverage"]["median"]);
        assert!(algorithm["time_to"][1]["median_s"].is_null(), "a minute isn't enough for 99 %");
    }
    let failed = [(entries[0].0, Err("no, thanks"))];
    assert!(
        to_csv(&head, &failed).lines().all(|line| line.replace("\"no, thanks\"", "").split(',').count() == columns)
    );
}

#[test]
fn time_of_a_run_follows_from_the_room_until_it_is_chosen() {
    let minutes = |link: &str, many: &mut ManyRuns| {
        many.take(&session(link));
        many.minutes()
    };
    let mut many = ManyRuns::new();
    let small = minutes("room=room12ft&robot=roomba600", &mut many);
    let large = minutes("room=flat&robot=roomba600", &mut many);
    assert!(small < large, "{small} and {large}");
    many.set_minutes(10);
    assert_eq!(minutes("room=warehouse&robot=roomba600", &mut many), 10);
}
