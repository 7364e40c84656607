//! The rules of `move_to_empty_space` one by one against the printed listing (004, section 7.1): state and sensors
//! before a call, command and state after it.

use super::{
    edge_machine::{EdgeMachine, ThesisText, Twist},
    position::{Position, Rotation},
};
use robovac_core::robot::SensorReadings;

/// Sensors in a picture: the bumper's left half, the six lights from left to right, the bumper's right half; `.` for
/// nothing.
fn sensors(picture: &str) -> SensorReadings {
    let on: Vec<bool> = picture.chars().map(|c| c != '.').collect();
    let [bump_left, l0, l1, l2, l3, l4, l5, bump_right] = on[..] else { panic!("{picture}: eight signs") };
    SensorReadings { bump_left, bump_right, light_bumper: [l0, l1, l2, l3, l4, l5], ..SensorReadings::default() }
}

/// A state in a picture: obstacle, rotation's side, rotation's counter, edge detected, forward counter; `-` for no side.
fn state(text: &str) -> EdgeMachine {
    let words: Vec<&str> = text.split_whitespace().collect();
    let [obstacle, rotation, counter, edge, forward] = words[..] else { panic!("{text}: five words") };
    let side = |word| match word {
        "L" => Position::Left,
        "R" => Position::Right,
        _ => Position::None,
    };
    EdgeMachine {
        obstacle: side(obstacle),
        rotation: Rotation { position: side(rotation), counter: counter.parse().unwrap() },
        edge_detected: edge.parse().unwrap(),
        forward_counter: forward.parse().unwrap(),
        ..EdgeMachine::new(ThesisText::Mended)
    }
}

const F: Option<Twist> = Some(Twist::Forward);
const L: Option<Twist> = Some(Twist::Left);
const R: Option<Twist> = Some(Twist::Right);

/// Place in the print, state, sensors, command, state after.
type PrintedRule = (&'static str, &'static str, &'static str, Option<Twist>, &'static str);

fn holds(rules: &[PrintedRule], text: ThesisText) {
    for &(place, before, picture, command, after) in rules {
        let mut machine = EdgeMachine { text, ..state(before) };
        let told = machine.call(&sensors(picture), || panic!("{place}: nothing is drawn here"));
        assert_eq!(told, command, "{place}: {before} [{picture}]");
        assert_eq!(machine, EdgeMachine { text, ..state(after) }, "{place}: {before} [{picture}]");
    }
}

/// Rules that read the same in print and mended.
const RULES: &[PrintedRule] = &[
    // Step one, "robot came to end of object edge": not before two rotations.
    ("edge_detected == 1, counter 1: rotates on", "R R 1 1 0", "........", R, "R R 2 1 0"),
    ("narrow corner, right", "R R 2 1 4", "L.......", None, "L - 0 0 0"),
    ("narrow corner, left", "L L 2 1 4", ".......R", None, "R - 0 0 0"),
    ("narrow corner comes before lights", "R R 2 1 4", "L....ll.", None, "L - 0 0 0"),
    ("edge detected again, right", "R R 2 1 4", "......l.", None, "R - 0 0 0"),
    ("edge detected again, middle right", "R R 2 1 4", "....l...", None, "R - 0 0 0"),
    ("edge detected again, left", "L L 2 1 4", "..l.....", None, "L - 0 0 0"),
    ("lights of the other side don't count", "R R 2 1 4", ".lll....", F, "R R 2 1 5"),
    ("bumper on the same side, right", "R R 2 1 4", ".......R", L, "R R 2 1 4"),
    ("bumper on the same side, left", "L L 2 1 4", "L.......", R, "L L 2 1 4"),
    ("forward_counter < 10", "L L 2 1 0", "........", F, "L L 2 1 1"),
    ("the tenth movement", "L L 2 1 9", "........", F, "L L 2 1 10"),
    ("go to next step", "L L 2 1 10", "........", None, "L L 0 2 0"),
    // Step two: 15 rotations by the rules of rotation, then these.
    ("edge_detected == 2, counter 14: the fifteenth", "L L 14 2 0", "........", L, "L L 15 2 0"),
    ("step two ends", "L L 15 2 0", "........", None, "L L 0 3 0"),
    ("step two, narrow corner, right", "R R 15 2 0", "L.......", None, "L - 0 0 0"),
    ("step two, narrow corner, left", "L L 15 2 0", ".......R", None, "R - 0 0 0"),
    ("step two, detected by a light", "R R 15 2 0", ".....l..", None, "R - 0 0 0"),
    ("step two, detected by the bumper", "R R 15 2 0", ".......R", None, "R - 0 0 0"),
    ("step two, detected by the left bumper", "L L 15 2 0", "L.......", None, "L - 0 0 0"),
    ("in step two a lone outer light ends the rotation", "L L 7 2 0", ".l......", F, "L - 0 0 0"),
    // Step three, the zig-zag.
    ("step three, narrow corner, right", "R R 5 3 0", "L.......", None, "L - 0 0 0"),
    ("step three, narrow corner, left", "L L 5 3 0", ".......R", None, "R - 0 0 0"),
    ("is_light_right", "R R 5 3 0", "......l.", None, "R - 0 0 0"),
    ("is_light_center_right", "R R 5 3 0", "....l...", None, "R - 0 0 0"),
    ("the front right light isn't asked", "R R 0 3 0", ".....l..", F, "R R 1 3 0"),
    ("is_right_pressed", "R R 5 3 0", ".......R", None, "R - 0 0 0"),
    ("is_light_left", "L L 5 3 0", ".l......", None, "L - 0 0 0"),
    ("is_light_center_left", "L L 5 3 0", "...l....", None, "L - 0 0 0"),
    ("the front left light isn't asked", "L L 0 3 0", "..l.....", F, "L L 1 3 0"),
    ("is_left_pressed", "L L 5 3 0", "L.......", None, "L - 0 0 0"),
    ("first of three", "R R 0 3 0", "........", F, "R R 1 3 0"),
    ("second of three", "R R 1 3 0", "........", F, "R R 2 3 0"),
    ("third of three, to the right", "R R 2 3 0", "........", R, "R R 3 3 0"),
    // "Rotate robot right until obstacle is only on the left side."
    ("rotates right", "L R 0 0 0", "........", R, "L R 1 0 0"),
    ("rotates right past both sides", "L R 3 0 0", ".llllll.", R, "L R 4 0 0"),
    ("rotates right until only the left light", "L R 7 0 0", ".l......", F, "L - 0 0 0"),
    ("front left light too", "L R 7 0 0", ".ll.....", R, "L R 8 0 0"),
    ("middle left light too", "L R 7 0 0", ".l.l....", R, "L R 8 0 0"),
    ("lights on the other side don't matter", "L R 7 0 0", ".l..lll.", F, "L - 0 0 0"),
    ("rotates right until only the right light", "R R 7 0 0", "......l.", F, "R - 0 0 0"),
    ("the wrong outer light", "R R 7 0 0", ".l......", R, "R R 8 0 0"),
    // "Rotate robot left until obstacle is only on the right side."
    ("rotates left", "R L 0 0 0", "........", L, "R L 1 0 0"),
    ("rotates left until only the right light", "R L 7 0 0", "......l.", F, "R - 0 0 0"),
    ("rotates left until only the left light", "L L 7 0 0", ".l......", F, "L - 0 0 0"),
    ("rotating, it doesn't look at the bumper", "R L 7 0 0", "L......R", L, "R L 8 0 0"),
    // Both bumpers.
    ("both, light on the right", "- - 0 0 0", "L....l.R", None, "R L 0 0 0"),
    ("both, light on the left", "- - 0 0 0", "L.l....R", None, "L R 0 0 0"),
    ("both, lights on both sides: right is asked first", "- - 0 0 0", "L.l..l.R", None, "R L 0 0 0"),
    ("both, obstacle already on the right", "R - 0 0 0", "L.....lR", None, "R L 0 0 0"),
    // Here the print lacks a return and runs into exit().
    ("both, obstacle already on the left (return is missing)", "L - 0 0 0", "Ll.....R", None, "L R 0 0 0"),
    // Here the print has exit().
    ("both, obstacle not detected (exit)", "- - 0 0 0", "L......R", None, "R L 0 0 0"),
    // One bumper.
    ("right bumper, no obstacle yet", "- - 0 0 0", ".......R", None, "R L 0 0 0"),
    ("left bumper, no obstacle yet", "- - 0 0 0", "L.......", None, "L R 0 0 0"),
    ("left bumper pressed, rotating right", "L - 0 0 0", "Ll......", R, "L - 0 0 0"),
    ("right bumper pressed, rotating left", "R - 0 0 0", "......lR", L, "R - 0 0 0"),
    ("the other bumper alone is no rule of its own", "L - 0 0 0", ".l.....R", F, "L - 0 0 0"),
    // "It is possible that robot came to end of the edge."
    ("end of the edge, left", "L - 0 0 0", "....lll.", None, "L L 0 1 0"),
    ("end of the edge, right", "R - 0 0 0", ".lll....", None, "R R 0 1 0"),
    // "Lost left light".
    ("front left light without the left one", "L - 0 0 0", "..l.....", None, "L R 0 0 0"),
    ("front right light without the right one", "R - 0 0 0", ".....l..", None, "R L 0 0 0"),
    // "Robot left side lost tract of objects edge."
    ("middle left light alone", "L - 0 0 0", "...l....", None, "L L 0 0 0"),
    ("middle right light alone", "R - 0 0 0", "....l...", None, "R R 0 0 0"),
    // "By default, the robot should move forward."
    ("along the left", "L - 0 0 0", ".l......", F, "L - 0 0 0"),
    ("along the right with a light in front", "R - 0 0 0", ".....ll.", F, "R - 0 0 0"),
    ("nothing known, nothing there", "- - 0 0 0", "........", F, "- - 0 0 0"),
    ("nothing known, lights alone don't matter", "- - 0 0 0", ".llllll.", F, "- - 0 0 0"),
];

#[test]
fn every_rule_does_what_is_printed() {
    holds(RULES, ThesisText::Printed);
    holds(RULES, ThesisText::Mended);
}

#[test]
fn the_zigzag_turns_right_as_printed_or_towards_the_edge() {
    let rule = |command| [("third of three, obstacle on the left", "L L 2 3 0", "........", command, "L L 3 3 0")];
    holds(&rule(R), ThesisText::Printed);
    holds(&rule(L), ThesisText::Mended);
}

/// Calls with nothing in sight until the obstacle is given up, with that number drawn; `None` if that takes a thousand.
fn calls_until_free(text: ThesisText, drawn: u32) -> Option<u32> {
    let mut machine = EdgeMachine { text, ..state("R L 0 0 0") };
    (1..1000).find(|_| {
        machine.call(&sensors("........"), || drawn);
        machine == EdgeMachine { text, random_number: Some(drawn), ..state("- - 0 0 0") }
    })
}

#[test]
fn a_rotation_that_does_not_end_is_given_up_after_a_random_number() {
    for text in [ThesisText::Printed, ThesisText::Mended] {
        // 100 rotations, the draw, which counts as one, the others, and the call that resets.
        assert_eq!(calls_until_free(text, 150), Some(100 + 1 + 49 + 1));
        assert_eq!(calls_until_free(text, 200), Some(201));
        assert_eq!(calls_until_free(text, 101), Some(102));
    }
}

/// `random.randint(100, 200)` gives 100 once in a hundred times, when the counter is already at 101.
#[test]
fn the_number_100_is_never_met_in_print() {
    assert_eq!(calls_until_free(ThesisText::Printed, 100), None);
    assert_eq!(calls_until_free(ThesisText::Mended, 100), Some(102));
}

/// A number drawn before doesn't cut later rotations short.
#[test]
fn a_former_number_counts_for_nothing() {
    for text in [ThesisText::Printed, ThesisText::Mended] {
        let mut machine = EdgeMachine { text, random_number: Some(120), ..state("R L 0 0 0") };
        for call in 0..100 {
            assert_eq!(machine.call(&sensors("........"), || panic!("not yet")), L, "call {call}");
        }
        assert_eq!(machine.call(&sensors("........"), || 180), None);
        assert_eq!(machine.random_number, Some(180));
    }
}

/// 004, figure "successfully traversed corner": an edge ends, and is found again in the zig-zag.
#[test]
fn around_the_end_of_an_edge() {
    let mut machine = state("R - 0 0 0");
    let nothing = sensors("........");
    let mut told = String::new();
    for _ in 0..(1 + 2 + 10 + 1 + 15 + 1 + 6) {
        told.push(match machine.call(&nothing, || panic!("not stuck")) {
            None => '.',
            F => 'f',
            L => 'l',
            R => 'r',
        });
    }
    assert_eq!(told, ".rrffffffffff.rrrrrrrrrrrrrrr.ffrffr");
    assert_eq!(machine.call(&sensors("......l."), || 0), None);
    assert_eq!(machine, state("R - 0 0 0"));
}
