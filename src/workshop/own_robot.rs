//! The form of an own robot.

use robovac_core::robot::{OwnRobot, OwnRobotForm};
use robovac_playground::wire::{message, to_js};
use wasm_bindgen::prelude::*;

/// The form with the own robot of a link in it; with the model's figures if it can't be read.
#[wasm_bindgen(unchecked_return_type = "rust.OwnRobotForm")]
pub fn own_robot_form(text: &str) -> Result<JsValue, JsValue> {
    to_js(&OwnRobotForm::of(&OwnRobot::parse(text).unwrap_or_default()))
}

/// The own robot as in links; throws a sentence for users that names the field that isn't a number.
#[wasm_bindgen]
pub fn own_robot_text(
    #[wasm_bindgen(unchecked_param_type = "rust.OwnRobotForm")] form: JsValue,
) -> Result<String, JsValue> {
    let own = read(form)?.read().map_err(message)?;
    Ok(own.to_string())
}

/// Corners of its body, m: x ahead, y to the left; `null` for a circle, or the model's body. Throws like the text.
#[wasm_bindgen(unchecked_return_type = "number[][] | null")]
pub fn own_robot_corners(
    #[wasm_bindgen(unchecked_param_type = "rust.OwnRobotForm")] form: JsValue,
) -> Result<JsValue, JsValue> {
    to_js(&read(form)?.corners().map_err(message)?)
}

fn read(form: JsValue) -> Result<OwnRobotForm, JsValue> {
    serde_wasm_bindgen::from_value(form).map_err(message)
}
