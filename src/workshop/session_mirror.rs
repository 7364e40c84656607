//! Mirror of the playground's session in another module.

use coverage_planners::CoveragePath;
use robovac_app::{Import, connection::StartPlace, explore::Session};
use robovac_core::geometry::Pose;
use robovac_playground::wire::message;
use robovac_playground::wire::{request, walk};
use robovac_sim::experiment::planning::PlanAnswer;
use wasm_bindgen::prelude::*;

/// A copy of the playground's room and settings, kept up to date by links and scenario files.
#[wasm_bindgen]
pub struct SessionMirror {
    session: Session,
    /// What it has followed: the link, and the room's version.
    link: String,
    room_version: f64,
}

#[wasm_bindgen]
impl SessionMirror {
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
        self.session.restore(link).map_err(message)?;
        self.session.forget_changes();
        (self.link, self.room_version) = (link.to_owned(), room_version);
        Ok(())
    }
}

#[wasm_bindgen]
impl SessionMirror {
    /// What the algorithm that is chosen has to plan, once; pass it to `plan` in a worker. Nothing for a behaviour, and for
    /// what is planned already.
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

impl Default for SessionMirror {
    fn default() -> Self {
        Self::new()
    }
}
