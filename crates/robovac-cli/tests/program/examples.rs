//! The examples of the crates, as their programs call them.

#![expect(dead_code, reason = "their main functions only print what is looked at here")]

#[path = "../../../coverage-planners/examples/own_planner.rs"]
mod own_planner;
#[path = "../../../coverage-planners/examples/plan_a_room.rs"]
mod plan_a_room;
#[path = "../../../robovac-sim/examples/simulate_and_measure.rs"]
mod simulate_and_measure;
#[path = "../../../robovac-link/examples/talk_to_a_roomba.rs"]
mod talk_to_a_roomba;

#[test]
fn a_room_is_planned_and_printed() {
    let text = plan_a_room::report("bedroom", "boustrophedon").unwrap();
    assert!(text.contains('>') && text.contains("no walk costs less than"), "{text}");
    let error = plan_a_room::report("bedroom", "nothing").unwrap_err();
    assert!(error.to_string().contains("no such planner"), "{error}");
}

#[test]
fn runs_are_measured() {
    let text = simulate_and_measure::report(1, 2).unwrap();
    assert_eq!(text.lines().count(), 7, "{text}");
    assert_eq!(text.matches("median coverage").count(), 2, "{text}");
}

// slow: the contract over all rooms, as in another crate
#[test]
fn a_planner_of_ones_own_keeps_the_contract() {
    let text = own_planner::report().unwrap();
    assert!(text.lines().count() == 5 && text.starts_with("Cost"), "{text}");
}

#[test]
fn a_virtual_roomba_answers_and_moves_only_if_it_may() {
    let text = talk_to_a_roomba::talk_to_virtual(false).unwrap();
    assert!(text.contains("battery") && !text.contains("drove"), "{text}");
    let text = talk_to_a_roomba::talk_to_virtual(true).unwrap();
    let driven: f64 = text.split("drove ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
    assert!((60.0..140.0).contains(&driven), "{text}");
}
