//! Mirror of the playground's session in another module.

use js_sys::Reflect;
use robovac_app::{
    CatalogueEntry,
    connection::{self, StartPlace},
    explore::{Session, SessionSnapshot},
};
use robovac_core::geometry::Pose;
use robovac_playground::wire::{message, request, to_js, walk};
use robovac_sim::experiment::{Algorithm, planning::PlanAnswer};
use wasm_bindgen::prelude::*;

/// A mirror of the playground's room and settings.
#[wasm_bindgen]
#[derive(Default)]
pub struct SessionMirror {
    session: Session,
    /// The snapshot that it follows.
    followed: Option<SessionSnapshot>,
}

#[wasm_bindgen]
impl SessionMirror {
    /// A mirror without a snapshot.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Version of its room, for `Playground.snapshot`; `undefined` at first.
    pub fn room_version(&self) -> Option<f64> {
        self.followed.as_ref().map(|followed| followed.room_version as f64)
    }

    /// Behaviours that can drive a connected robot, in the form of the catalogue.
    #[wasm_bindgen(unchecked_return_type = "rust.CatalogueEntry[]")]
    pub fn behaviours() -> Result<JsValue, JsValue> {
        let entries = connection::behaviours().map(|info| CatalogueEntry::new(Algorithm::Behaviour(info)));
        to_js(&entries.collect::<Vec<_>>())
    }

    /// Why a connected robot can't ride the path of `snapshot`, as a sentence for users; `undefined` if it can.
    pub fn path_refusal(
        #[wasm_bindgen(unchecked_param_type = "rust.SessionSnapshot")] snapshot: JsValue,
    ) -> Result<Option<String>, JsValue> {
        Ok(read(snapshot, None)?.path_refusal())
    }

    /// Whether `snapshot` is newer.
    pub fn is_behind(
        &self,
        #[wasm_bindgen(unchecked_param_type = "rust.SessionSnapshot")] snapshot: JsValue,
        algorithm: Option<String>,
    ) -> Result<bool, JsValue> {
        let snapshot = read(snapshot, algorithm)?;
        Ok(self.followed.as_ref() != Some(&SessionSnapshot { own: None, ..snapshot }))
    }

    /// Follows a `snapshot` of the playground; cheap if unchanged. If `algorithm` is given, for a connected robot that
    /// it drives.
    pub fn follow(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "rust.SessionSnapshot")] snapshot: JsValue,
        algorithm: Option<String>,
    ) -> Result<(), JsValue> {
        let mut snapshot = read(snapshot, algorithm)?;
        let own = snapshot.own.take();
        if self.followed.as_ref() == Some(&snapshot) {
            return Ok(());
        }
        // An own room that is here already can have been sent again.
        snapshot.own = own.filter(|_| self.followed.as_ref().map(|f| f.room_version) != Some(snapshot.room_version));
        self.session.follow(&snapshot).map_err(message)?;
        self.session.forget_changes();
        self.followed = Some(SessionSnapshot { own: None, ..snapshot });
        Ok(())
    }
}

fn read(snapshot: JsValue, algorithm: Option<String>) -> Result<SessionSnapshot, JsValue> {
    let snapshot: SessionSnapshot = serde_wasm_bindgen::from_value(snapshot).map_err(message)?;
    match algorithm {
        Some(id) => snapshot.for_connection(&id).map_err(message),
        None => Ok(snapshot),
    }
}

#[wasm_bindgen]
impl SessionMirror {
    /// The pending planning request of the chosen algorithm, returned once; pass it to `plan` in a worker. `undefined`
    /// for a behaviour, and for a finished plan.
    #[wasm_bindgen(unchecked_return_type = "{ id: number; planner: string; bytes: Uint8Array } | undefined")]
    pub fn take_plan_request(&mut self) -> Result<JsValue, JsValue> {
        let request = self.session.take_plan_request();
        let Some(request) = request else { return Ok(JsValue::UNDEFINED) };
        let object = request::request_to_js(&request)?;
        Reflect::set(&object, &"place".into(), &to_js(&self.session.whole_snapshot())?)?;
        Ok(object)
    }

    /// The worker has finished. Throws a sentence for users if its plan can't be driven.
    pub fn plan_finished(&mut self, id: u32, path: &JsValue, seconds: f64) -> Result<(), JsValue> {
        let path = walk::path_from_js(path);
        self.session.plan_finished(id, PlanAnswer { path, seconds, proof: None, trace: Vec::new() });
        if self.session.planned().is_some() { Ok(()) } else { Err(self.session.view().message.into()) }
    }

    /// Whether the chosen algorithm is for cleaning.
    pub fn cleans(&self) -> bool {
        self.session.settings().algorithm.cleans()
    }

    /// Corners of the line that was planned, x and y in turn, m; none if there is no plan.
    pub fn corners(&self) -> Vec<f64> {
        self.session.planned().map_or(Vec::new(), |planned| planned.line.iter().flat_map(|p| [p.x, p.y]).collect())
    }

    /// Start of the robot: x, y in m and heading in rad; empty if it doesn't fit.
    pub fn start(&self) -> Vec<f64> {
        self.session.prepared().map_or(Vec::new(), |prepared| {
            let start = prepared.floor.start;
            vec![start.x, start.y, start.heading]
        })
    }

    /// Place of a robot at x, y, heading relative to the start: `at`, `near` enough to begin, or `elsewhere`.
    pub fn start_place(&self, x: f64, y: f64, heading: f64) -> String {
        let place = self.session.prepared().map(|room| StartPlace::of(Pose::new(x, y, heading), room.floor.start));
        place.map_or("at", StartPlace::id).to_owned()
    }

    /// Why this robot can't be placed in the room, as a sentence for users; `undefined` if it can.
    pub fn complaint(&self) -> Option<String> {
        self.session.prepared().is_none().then(|| self.session.view().message)
    }
}

impl SessionMirror {
    /// The mirrored session.
    pub(super) fn session(&self) -> &Session {
        &self.session
    }
}
