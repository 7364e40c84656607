//! Studies are read or refused with the place of what is wrong; runs are numbered and made.

use super::*;
use std::collections::HashSet;

const SMALL: &str = r#"{
  "format": "robovac-study",
  "version": 1,
  "rooms": [{ "room": "room12ft" }, { "flats": { "first": 5, "count": 2, "area_m2": [25, 30] } }],
  "robots": [{ "robot": "roomba600" }, { "robot": "roomba600", "cell_size_m": 0.2 }],
  "algorithms": [{ "behaviour": "bounce" }, { "planner": "snake", "params": { "patience": 3 } }],
  "conditions": [{ "name": "perfect" }, { "slip": "typical", "noise": { "cliff": "harsh" }, "quantised": true }],
  "seeds": { "first": 7, "count": 3 },
  "minutes": 0.5
}"#;

fn refusal(change: (&str, &str)) -> String {
    assert!(SMALL.contains(change.0), "{}", change.0);
    Study::read("a.json", SMALL.replacen(change.0, change.1, 1).as_bytes()).unwrap_err().to_string()
}

fn no_files(name: &str) -> Result<FloorPlan, String> {
    Err(format!("{name}: there are no files here"))
}

#[test]
fn runs_are_numbered_one_by_one() {
    let study = Study::read("a.json", SMALL.as_bytes()).unwrap();
    assert_eq!(study.runs(), 3 * 2 * 2 * 2 * 3);
    let all: Vec<_> = (0..study.runs()).map(|number| study.run(number).unwrap()).collect();
    assert!(study.run(study.runs()).is_none());
    let commands: HashSet<_> = all.iter().map(|run| study.command(run)).collect();
    assert_eq!(commands.len(), all.len(), "all are different");
    assert_eq!(all.iter().map(|run| run.lab).collect::<HashSet<_>>().len(), 6);
    assert!(all.is_sorted_by_key(|run| run.lab), "runs of one lab follow each other");
    assert_eq!(
        study.command(&all[71]),
        "robovac montecarlo --flat 6~area:25..30 --robot roomba600 --cell 0.2 --planner snake~patience:3 --seeds 1 \
         --seed 9 --plan-seed 1 --minutes 0.5 --slip typical --noise cliff=harsh --quantised --charge 100 --odometry arc \
         --json"
    );
}

#[test]
fn a_run_is_the_same_in_any_lab_and_order() {
    let study = Study::read("a.json", SMALL.as_bytes()).unwrap();
    let make = |number: u64| {
        let run = study.run(number).unwrap();
        study.make(&run, &study.lab(&run, &no_files))
    };
    let first = study.run(0).unwrap();
    let lab = study.lab(&first, &no_files);
    for number in [11, 0, 6, 5] {
        let row = study.make(&study.run(number).unwrap(), &lab);
        assert_eq!(row, make(number));
        let outcome = row.outcome.unwrap();
        assert!(outcome.coverage > 0.0 && outcome.curve.len() == 21 && outcome.digest.len() == 16);
        assert_eq!(outcome.curve[20], outcome.coverage as f32);
    }
}

#[test]
fn faults_are_named_with_their_place() {
    for (change, said) in [
        (("robovac-study", "robovac-scenario"), "format: this is not a study"),
        (("\"version\": 1", "\"version\": 9"), "version: this program reads version 1"),
        (("room12ft", "attic"), "rooms[0].room: there is no room \"attic\""),
        (("\"count\": 2", "\"count\": 0"), "rooms[1].flats.count: give a number from 1"),
        (("[25, 30]", "[30, 25]"), "rooms[1].flats: area_m2 [30, 25] isn't possible"),
        (("{ \"robot\": \"roomba600\" }", "{ \"robot\": \"r2d2\" }"), "robots[0].robot: there is no robot \"r2d2\""),
        (("0.2", "20"), "robots[1].cell_size_m: the cell size can't be \"20\""),
        (("bounce", "manual"), "algorithms[0].behaviour: \"manual\" is driven by hand"),
        (("snake", "snail"), "algorithms[1].planner: there is no planner \"snail\""),
        (("3 } }", "\"much\" } }"), "algorithms[1].params.patience: parameter \"patience\" can't be \"much\""),
        (("\"behaviour\": \"bounce\"", "\"params\": {}"), "algorithms[0]: give either a planner or a behaviour"),
        (("typical", "icy"), "conditions[1].slip: there is no slip \"icy\""),
        (("harsh", "loud"), "conditions[1].noise.cliff: there is no noise level \"loud\""),
        (("{ \"cliff\": \"harsh\" }", "3"), "conditions[1].noise: give a level"),
        (("\"count\": 3", "\"count\": 0"), "seeds.count: there is no run"),
        (("\"count\": 3", "\"count\": -1"), "seeds.count: invalid value: integer `-1`"),
        (("\"count\": 3", "\"count\": 9000000000"), "but at most 100000000 are allowed"),
        (("\"minutes\": 0.5", "\"minutes\": 0"), "minutes: give a number from 0.1"),
        (("\"minutes\": 0.5", "\"minutes\": 1, \"curve\": 7"), "curve: give 0 or a number that divides 200"),
        (("\"minutes\": 0.5", "\"minutes\": 1, \"hours\": 7"), "unknown field `hours`"),
    ] {
        let found = refusal(change);
        assert!(found.starts_with("a.json: ") && found.contains(said), "{found} instead of {said}");
    }
}
