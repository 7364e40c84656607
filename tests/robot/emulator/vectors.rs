//! The fact sheet's vectors, where it is at hand beside the repository, in the robot itself.

use super::support::Lab;
use roomba_oi::Mode;
use serde_json::Value;

fn read() -> Option<Value> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../shared/oi/vectors.json");
    let text = std::fs::read_to_string(path).ok()?;
    Some(serde_json::from_str(&text).expect("vectors.json"))
}

fn bytes(vector: &Value) -> Vec<u8> {
    vector["bytes"].as_array().unwrap().iter().map(|byte| byte.as_u64().unwrap() as u8).collect()
}

fn mode(name: &Value) -> Mode {
    Mode::ALL.into_iter().find(|mode| mode.to_string().to_lowercase() == name.as_str().unwrap()).unwrap()
}

#[test]
fn commands_are_taken_where_they_are_allowed() {
    let Some(all) = read() else { return };
    for vector in all["commands"].as_array().unwrap() {
        let (id, accepted) = (&vector["id"], vector["accepted_in"].as_array().unwrap());
        for from in Mode::ALL {
            let mut lab = Lab::in_mode(from);
            lab.robot.take_heard();
            lab.send(&bytes(vector));
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
    let Some(all) = read() else { return };
    for vector in all["drive_kinematics"].as_array().unwrap() {
        let mut lab = Lab::in_mode(Mode::Full);
        lab.send(&bytes(vector));
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
    let Some(all) = read() else { return };
    for vector in all["modes"]["commands"].as_array().unwrap() {
        let mut lab = Lab::in_mode(mode(&vector["from"]));
        lab.send(&[vector["cmd"].as_u64().unwrap() as u8]);
        assert_eq!(lab.robot.mode(), mode(&vector["to"]), "{vector}");
    }
}
