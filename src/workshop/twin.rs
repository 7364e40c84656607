//! A twin made from a recording.

use robovac_link::{connection::LineRecording, twin::TwinFit};
use robovac_playground::wire::to_js;
use wasm_bindgen::prelude::*;

/// A twin that was fitted to a recording.
#[wasm_bindgen]
pub struct Twin {
    fit: TwinFit,
}

#[wasm_bindgen]
impl Twin {
    /// Fits a twin to a recording; throws a sentence for users if it can't be done.
    #[wasm_bindgen(constructor)]
    pub fn new(recording: &str) -> Result<Self, JsValue> {
        Ok(Self { fit: TwinFit::of(parse(recording)?).map_err(|e| sentence(&e.to_string()))? })
    }

    /// Its figures, `TwinFigure[]`.
    #[wasm_bindgen(unchecked_return_type = "rust.TwinFigure[]")]
    pub fn figures(&self) -> Result<JsValue, JsValue> {
        to_js(&self.fit.file().figures)
    }

    /// How well it predicts another recording, `Prediction[]`; throws a sentence for users if that can't be told.
    #[wasm_bindgen(unchecked_return_type = "rust.Prediction[]")]
    pub fn check(&self, recording: &str) -> Result<JsValue, JsValue> {
        to_js(&self.fit.check(parse(recording)?).map_err(|e| sentence(&e.to_string()))?)
    }

    /// The part of a link that makes it the robot in Explore.
    pub fn link(&self) -> String {
        self.fit.file().to_link()
    }

    /// Its file.
    pub fn json(&self) -> String {
        self.fit.file().to_json()
    }
}

fn parse(text: &str) -> Result<LineRecording, String> {
    LineRecording::parse(text).map_err(|e| sentence(&e.to_string()))
}

/// An error's text as a sentence.
fn sentence(text: &str) -> String {
    let mut chars = text.chars();
    let first = chars.next().map(|first| first.to_uppercase().to_string()).unwrap_or_default();
    format!("{first}{}.", chars.as_str())
}
