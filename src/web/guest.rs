//! The playground's session as the comparisons' module sees it: a copy that follows the original.

use crate::app::{Import, Session};
use wasm_bindgen::prelude::*;

/// A copy of the playground's room and settings, kept up to date by links and scenario files.
#[wasm_bindgen]
pub struct Guest {
    session: Session,
    /// What it has followed: the link, and the room's version.
    link: String,
    room_version: f64,
}

#[wasm_bindgen]
impl Guest {
    /// A copy that hasn't followed anything yet.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self { session: Session::new(), link: String::new(), room_version: -1.0 }
    }

    /// Whether the playground with that `link` and `room_version` isn't what this is a copy of.
    pub fn is_behind(&self, link: &str, room_version: f64) -> bool {
        self.link != link || self.room_version != room_version
    }

    /// Becomes a copy of the playground with that `link` and `room_version`. A room that links don't hold comes as a
    /// `scenario`; for others it's empty.
    pub fn follow(&mut self, link: &str, room_version: f64, scenario: &str) -> Result<(), JsValue> {
        if !scenario.is_empty() && self.room_version != room_version {
            let import = Import::scenario("the room", scenario.as_bytes()).map_err(|e| e.to_string())?;
            self.session.take_import(import).map_err(|e| e.to_string())?;
        }
        self.session.restore(link)?;
        self.session.forget_changes();
        (self.link, self.room_version) = (link.to_owned(), room_version);
        Ok(())
    }
}

impl Guest {
    /// The copy.
    pub(super) fn session(&self) -> &Session {
        &self.session
    }
}

impl Default for Guest {
    fn default() -> Self {
        Self::new()
    }
}
