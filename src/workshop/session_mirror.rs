//! Mirror of the playground's session in another module.

use coverage_planners::CoveragePath;
use robovac_app::{
    connection::StartPlace,
    explore::{Session, SessionSnapshot},
};
use robovac_core::geometry::Pose;
use robovac_playground::wire::{message, request, walk};
use robovac_sim::experiment::planning::PlanAnswer;
use wasm_bindgen::prelude::*;

/// A copy of the playground's room and settings.
#[wasm_bindgen]
#[derive(Default)]
pub struct SessionMirror {
    session: Session,
    /// What it has followed.
    followed: Option<SessionSnapshot>,
}

#[wasm_bindgen]
impl SessionMirror {
    /// A copy that hasn't followed anything yet.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Version of the room that it has, for `Playground.snapshot`; nothing at first.
    pub fn room_version(&self) -> Option<f64> {
        self.followed.as_ref().map(|followed| followed.room_version as f64)
    }

    /// Whether there is something to follow in `snapshot`.
    pub fn is_behind(
        &self,
        #[wasm_bindgen(unchecked_param_type = "rust.SessionSnapshot")] snapshot: JsValue,
        algorithm: Option<String>,
    ) -> Result<bool, JsValue> {
        let snapshot = read(snapshot, algorithm)?;
        Ok(self.followed.as_ref() != Some(&SessionSnapshot { own: None, ..snapshot }))
    }

    /// Becomes a copy of the playground by its `snapshot`; cheap if nothing has changed. For a robot that is connected, driven
    /// by `algorithm`, if there is one.
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
        // A room of one's own that is here already may have been sent again.
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
    /// What the algorithm that is chosen has to plan, once; pass it to `plan` in a worker. Nothing for a behaviour, and for
    /// what is planned already.
    #[wasm_bindgen(unchecked_return_type = "{ id: number } | undefined")]
    pub fn take_plan_request(&mut self) -> Result<JsValue, JsValue> {
        let request = self.session.take_plan_request();
        request.map_or(Ok(JsValue::UNDEFINED), |request| request::request_to_js(&request))
    }

    /// The worker is done. Throws a sentence for users if its plan can't be driven.
    pub fn plan_finished(&mut self, id: u32, cells: &[u32], seconds: f64) -> Result<(), JsValue> {
        let path = CoveragePath { cells: walk::cells(cells) };
        self.session.plan_finished(id, PlanAnswer { path, seconds, proof: None, trace: Vec::new() });
        if self.session.planned().is_some() { Ok(()) } else { Err(self.session.view().message.into()) }
    }

    /// Corners of the line that was planned, x and y in turn, m; none if there is no plan.
    pub fn corners(&self) -> Vec<f64> {
        self.session.planned().map_or(Vec::new(), |planned| planned.line.iter().flat_map(|p| [p.x, p.y]).collect())
    }

    /// Where the robot starts: x, y in m and heading in rad; nothing if it doesn't fit in.
    pub fn start(&self) -> Vec<f64> {
        self.session.prepared().map_or(Vec::new(), |prepared| {
            let start = prepared.floor.start;
            vec![start.x, start.y, start.heading]
        })
    }

    /// Where a robot at x, y, heading is, seen from there: `at`, `near` enough to set off, or `elsewhere`.
    pub fn start_place(&self, x: f64, y: f64, heading: f64) -> String {
        let place = self.session.prepared().map(|room| StartPlace::of(Pose::new(x, y, heading), room.floor.start));
        place.map_or("at", StartPlace::id).to_owned()
    }

    /// What is wrong with the room for this robot, as a sentence for users; empty if nothing.
    pub fn complaint(&self) -> String {
        if self.session.prepared().is_some() { String::new() } else { self.session.view().message }
    }
}

impl SessionMirror {
    /// The copy.
    pub(super) fn session(&self) -> &Session {
        &self.session
    }
}
