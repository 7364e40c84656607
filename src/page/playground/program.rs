//! The user's program.

use super::{Playground, json};
use robovac_core::program::{Program, ProgramKind, ProgramLanguage};
use robovac_playground::wire::{message, to_js};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Playground {
    /// Keeps a user's program, `language` `python` or `javascript`, `kind` `behaviour` or `planner`, and chooses it if
    /// `is_chosen`. Throws a message and changes nothing if it isn't accepted.
    pub fn set_program(
        &mut self,
        name: String,
        language: &str,
        kind: &str,
        source: String,
        is_chosen: bool,
    ) -> Result<(), JsValue> {
        let (language, kind) =
            ProgramLanguage::parse(language).zip(ProgramKind::parse(kind)).ok_or("unknown kind of program")?;
        self.session.set_program(Program { name, language, kind, source }, is_chosen).map_err(message)
    }

    /// The program that is kept; `undefined` without one.
    #[wasm_bindgen(unchecked_return_type = "rust.Program | undefined")]
    pub fn program(&self) -> Result<JsValue, JsValue> {
        self.session.settings().program().map_or(Ok(JsValue::UNDEFINED), |program| to_js(&**program))
    }

    /// What the program needs to drive a simulation of its own, for `ProgramRunner`.
    pub fn program_job(&self) -> Result<Vec<u8>, JsValue> {
        Ok(json(&self.session.program_job())?.into_bytes())
    }

    /// Takes a part of the log of the program with that `version` of the view; of an older one, it is left out and the
    /// result is false. Throws a message if it doesn't continue the log.
    pub fn extend_program(&mut self, version: u32, part: &[u8]) -> Result<bool, JsValue> {
        self.session.extend_program(version, part).map_err(message)
    }

    /// Digest of the state that is shown, 16 hexadecimal digits as `robovac run` prints them; `undefined` without a run.
    pub fn digest(&self) -> Option<String> {
        self.session.recording().map(|recording| format!("{:016x}", recording.run().digest()))
    }

    /// The whole log of the program, for `run_bag`; `undefined` unless one drives.
    pub fn program_log(&self) -> Option<Vec<u8>> {
        self.session.program_log()
    }
}
