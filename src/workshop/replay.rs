//! Replay of a recording.

use robovac_link::connection::{LineRecording, Replay as Player};
use robovac_playground::wire::to_js;
use wasm_bindgen::prelude::*;

/// Playback of a recording.
#[wasm_bindgen]
pub struct Replay {
    player: Player,
    name: String,
}

#[wasm_bindgen]
impl Replay {
    /// Reads a recording from the file of that name; throws a sentence for users that names the line if it isn't one.
    #[wasm_bindgen(constructor)]
    pub fn new(name: String, text: &str) -> Result<Self, JsValue> {
        let recording = LineRecording::parse(text).map_err(|e| e.to_string())?;
        Ok(Self { player: Player::new(recording), name })
    }

    /// Duration, s.
    pub fn duration_s(&self) -> f64 {
        self.player.duration_s()
    }

    /// Current time, s.
    pub fn time_s(&self) -> f64 {
        self.player.time_s()
    }

    /// Advances to a time; for an earlier one, restarts from the beginning.
    pub fn advance(&mut self, time_s: f64) {
        self.player.advance(time_s);
    }

    /// The snapshot, a `ConnectionView`; no request is allowed.
    #[wasm_bindgen(unchecked_return_type = "rust.ConnectionView")]
    pub fn view(&mut self) -> Result<JsValue, JsValue> {
        to_js(&self.player.view().of_recording(&self.name))
    }

    /// Traffic since the last call, as `Traffic[]`.
    #[wasm_bindgen(unchecked_return_type = "rust.Traffic[]")]
    pub fn take_traffic(&mut self) -> Result<JsValue, JsValue> {
        to_js(&self.player.take_traffic())
    }

    /// As `Connection.take_trace`.
    pub fn take_trace(&mut self) -> Vec<f64> {
        self.player.take_trace()
    }
}
