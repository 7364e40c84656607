//! The session as a link, as a file and for other tabs, and back.

use super::{Playground, json};
use robovac_core::floor_plan;
use robovac_playground::wire::{map_file, message, to_js};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Playground {
    /// Takes a map or scenario read by `read_map` in a worker.
    pub fn take_map(&mut self, read: &[u8]) -> Result<(), JsValue> {
        let import = map_file::import_from_bytes(read)?;
        self.session.take_import(import).map_err(|e| JsValue::from(e.to_string()))
    }

    /// Takes only the room of a scenario read by `read_map`; all of it if a path was planned in that room.
    pub fn take_room(&mut self, read: &[u8]) -> Result<(), JsValue> {
        let import = map_file::import_from_bytes(read)?;
        self.session.take_room(import).map_err(|e| JsValue::from(e.to_string()))
    }

    /// The room and the settings as a scenario file.
    pub fn scenario_json(&self) -> Result<String, JsValue> {
        json(&self.session.scenario())
    }

    /// Restores the result of `link`. Throws a message and changes nothing if that isn't possible.
    pub fn restore(&mut self, link: &str) -> Result<(), JsValue> {
        self.session.restore(link).map_err(message)?;
        // A page that opens by a link begins there.
        if std::mem::take(&mut self.is_opening) {
            self.session.forget_changes();
        }
        Ok(())
    }

    /// What the result of `link`, or of a link with keys of other tabs too, asks for.
    #[wasm_bindgen(unchecked_return_type = "rust.LinkOutline")]
    pub fn link_outline(&self, link: &str) -> Result<JsValue, JsValue> {
        to_js(&self.session.link_outline(link))
    }

    /// The session as the part of a link behind `#`.
    pub fn link(&self) -> String {
        self.session.link()
    }

    /// What `link` needs to lead to the shown moment of the run; `undefined` if no link can.
    pub fn moment_pair(&self) -> Option<String> {
        self.session.moment_pair()
    }

    /// Changes whenever the room does.
    pub fn room_version(&self) -> f64 {
        self.session.plan_version() as f64
    }

    /// A number that changes with the room, but not with changes of it: undo brings it back.
    pub fn room_lineage(&self) -> u32 {
        self.session.room_lineage()
    }

    /// Goes on with the changes of a room that is opened again, if it is as it was left.
    pub fn resume_room(&mut self, lineage: u32) {
        self.session.resume_room(lineage);
    }

    /// Id of the built-in room that this one was made of, as far as it can be undone.
    pub fn room_began_as(&self) -> Option<String> {
        self.session.began_as().map(str::to_owned)
    }

    /// Adds an older state of the room, read by `read_map`, to what can be undone, before all that is known of it.
    pub fn recall_map(&mut self, read: &[u8]) -> Result<(), JsValue> {
        self.session.recall_room(map_file::import_from_bytes(read)?.plan, None);
        Ok(())
    }

    /// The same with the built-in room that it was made of.
    pub fn recall_room(&mut self, id: &str) {
        if let Some(room) = floor_plan::room(id) {
            self.session.recall_room((room.build)(), Some(room.id));
        }
    }

    /// Renames the room, which is then an own one.
    pub fn rename_room(&mut self, name: &str) {
        self.session.rename_room(name);
    }

    /// Room and settings for `SessionMirror.follow`, without an own room whose version is `known`.
    #[wasm_bindgen(unchecked_return_type = "rust.SessionSnapshot")]
    pub fn snapshot(&self, known: Option<f64>) -> Result<JsValue, JsValue> {
        let mut snapshot = self.session.snapshot();
        if snapshot.room.is_none() && known != Some(snapshot.room_version as f64) {
            snapshot.own = Some(self.session.own_room());
        }
        to_js(&snapshot)
    }
}
