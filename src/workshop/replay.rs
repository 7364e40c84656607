//! Replay of a recording.

use robovac_app::export::recording_bag;
use robovac_link::{
    connection::{LineRecording, Replay as Player},
    recording::{Examination, csv},
};
use robovac_playground::wire::{message, to_js};
use std::{convert::Infallible, io::Cursor, sync::Arc};
use wasm_bindgen::prelude::*;

/// Playback of a recording.
#[wasm_bindgen]
pub struct Replay {
    recording: Arc<LineRecording>,
    player: Player,
    examination: Examination,
    name: String,
}

#[wasm_bindgen]
impl Replay {
    /// Reads a recording from the file of that name; throws a sentence for users that names the line if it isn't one.
    #[wasm_bindgen(constructor)]
    pub fn new(name: String, text: &str) -> Result<Self, JsValue> {
        let recording = Arc::new(LineRecording::parse(text).map_err(|e| e.to_string())?);
        let (player, examination) = (Player::new(Arc::clone(&recording)), Examination::new(Arc::clone(&recording)));
        Ok(Self { recording, player, examination, name })
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

    /// Examines the next seconds of the recording, for [`Self::timeline`]; whether there is more.
    pub fn examine(&mut self, seconds: f64) -> bool {
        self.examination.go_on(seconds)
    }

    /// What happened, a `Timeline`, as far as it was examined.
    #[wasm_bindgen(unchecked_return_type = "rust.Timeline")]
    pub fn timeline(&self) -> Result<JsValue, JsValue> {
        to_js(&self.examination.timeline())
    }

    /// Its figures in one line.
    pub fn summary(&self) -> String {
        self.examination.timeline().summary()
    }

    /// All readings as comma-separated values.
    pub fn csv(&self) -> String {
        let mut text = String::new();
        let written: Result<(), Infallible> = csv(Arc::clone(&self.recording), |piece| {
            text.push_str(piece);
            Ok(())
        });
        written.map_or_else(|never| match never {}, |()| text)
    }

    /// All readings and commands as an MCAP bag with ROS 2 messages. Throws a sentence for users.
    pub fn bag(&self) -> Result<Vec<u8>, JsValue> {
        let mut examination = Examination::new(Arc::clone(&self.recording));
        while examination.go_on(f64::INFINITY) {}
        let bag = recording_bag(&self.recording, &examination.timeline(), Cursor::new(Vec::new()));
        bag.map(Cursor::into_inner).map_err(message)
    }

    /// As `Connection.take_trace`.
    pub fn take_trace(&mut self) -> Vec<f64> {
        self.player.take_trace()
    }
}
