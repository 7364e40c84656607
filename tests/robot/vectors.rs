//! Vectors of the Open Interface: those of this repository, and the project's fact sheet where it is at hand beside it.

use roomba_oi::Mode;
use serde_json::Value;

/// Each with the same sections; the first is always there.
pub fn sheets() -> Vec<Value> {
    let shared = concat!(env!("CARGO_MANIFEST_DIR"), "/../shared/oi/vectors.json");
    let texts = [Some(include_str!("vectors.json").to_owned()), std::fs::read_to_string(shared).ok()];
    texts.into_iter().flatten().map(|text| serde_json::from_str(&text).expect("vectors.json")).collect()
}

/// A section of all sheets; of this repository's own there are at least that many.
pub fn vectors(section: &str, own: usize) -> Vec<Value> {
    let all: Vec<Vec<Value>> =
        sheets().iter().map(|sheet| sheet.pointer(section).and_then(Value::as_array).expect(section).clone()).collect();
    assert!(all[0].len() >= own, "{section} holds {}", all[0].len());
    all.concat()
}

pub fn bytes(vector: &Value) -> Vec<u8> {
    vector["bytes"].as_array().unwrap().iter().map(|byte| byte.as_u64().unwrap().try_into().unwrap()).collect()
}

pub fn mode(name: &Value) -> Mode {
    Mode::ALL.into_iter().find(|mode| mode.to_string().to_lowercase() == name.as_str().unwrap()).unwrap()
}
