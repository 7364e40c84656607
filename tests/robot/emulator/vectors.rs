//! All vectors in the robot itself.

use super::support::Lab;
use crate::vectors::{bytes, mode, vectors};
use roomba_oi::{Mode, Opcode};

// slow: a robot of its own for each command in each mode
#[test]
fn commands_are_taken_where_they_are_allowed() {
    for vector in vectors("/commands", Opcode::ALL.len()) {
        let (id, accepted) = (&vector["id"], vector["accepted_in"].as_array().unwrap());
        for from in Mode::ALL {
            let mut lab = Lab::in_mode(from);
            lab.robot.take_heard();
            lab.send(&bytes(&vector));
            let heard = lab.robot.take_heard();
            assert_eq!(heard.len(), 1, "{id}");
            let is_accepted = accepted.iter().any(|name| mode(name) == from);
            let after = match &vector["mode_after"] {
                _ if !is_accepted => from,
                same if same == "same" => from,
                other => mode(other),
            };
            assert_eq!((lab.robot.mode(), heard[0].was_obeyed), (after, is_accepted), "{id} in {from}");
        }
    }
}

#[test]
fn wheels_turn_as_the_kinematics_say() {
    for vector in vectors("/drive_kinematics", 8) {
        let mut lab = Lab::in_mode(Mode::Full);
        lab.send(&bytes(&vector));
        let asked = lab.robot.asked_speeds();
        let wanted = ["right", "left"].map(|wheel| vector[wheel].as_f64().unwrap());
        assert!((asked.right - wanted[0]).abs() < 1e-9 && (asked.left - wanted[1]).abs() < 1e-9, "{vector}");
        lab.wait(1.0);
        let speed = lab.robot.robot().speed();
        assert!((1000.0 * speed.right - wanted[0]).abs() < 1e-6, "{vector}");
        assert!((1000.0 * speed.left - wanted[1]).abs() < 1e-6, "{vector}");
    }
}

#[test]
fn modes_follow_commands() {
    for vector in vectors("/modes/commands", 44) {
        let mut lab = Lab::in_mode(mode(&vector["from"]));
        lab.send(&[vector["cmd"].as_u64().unwrap() as u8]);
        assert_eq!(lab.robot.mode(), mode(&vector["to"]), "{vector}");
    }
}
