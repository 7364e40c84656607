//! A connection to a robot, in a worker: bytes in, bytes out, and the view model for the page.

use super::session_mirror::SessionMirror;
use robovac_core::geometry::{Point, Pose};
use robovac_link::connection;
use robovac_playground::wire::{to_js, trajectory::trajectory_from_js};
use robovac_sim::{
    controller::{Controller, Setup},
    experiment::{Algorithm, planning::PathToDrive},
    program::{Piloted, RemotePilot, RobotFacts},
};
use std::sync::Arc;
use wasm_bindgen::prelude::*;

/// Bytes that the user types, and what they would do.
#[wasm_bindgen(unchecked_return_type = "rust.TypedBytes")]
pub fn typed_bytes(text: &str) -> Result<JsValue, JsValue> {
    to_js(&connection::TypedBytes::read(text))
}

/// A connection to a robot. Times are in seconds of one clock, the worker's.
#[wasm_bindgen]
pub struct Connection {
    link: connection::Connection,
    /// What asks the user's program, if it drives.
    pilot: RemotePilot,
}

#[wasm_bindgen]
impl Connection {
    /// Not connected.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self { link: connection::Connection::new(), pilot: RemotePilot::default() }
    }

    /// The line is open at 115200 baud: starts the diagnosis. `transport` is its state.
    pub fn opened(
        &mut self,
        now: f64,
        #[wasm_bindgen(unchecked_param_type = "rust.TransportView")] transport: JsValue,
    ) -> Result<(), JsValue> {
        self.link.set_transport(serde_wasm_bindgen::from_value(transport)?);
        self.link.opened(now);
        Ok(())
    }

    /// The line is lost, with the reason as a sentence for users; `for_good` if it won't return by itself.
    pub fn lost(&mut self, now: f64, why: &str, for_good: bool) {
        self.link.lost(now, why, for_good);
    }

    /// Discards pending bytes, as there is no line.
    pub fn discard(&mut self) {
        self.link.discard();
    }

    /// Takes bytes from the line.
    pub fn feed(&mut self, now: f64, bytes: &[u8]) {
        self.link.feed(now, bytes);
    }

    /// The true pose of a virtual robot, before every [`Self::tick`]; empty for others.
    pub fn know_truth(&mut self, truth: &[f64]) {
        self.link.know_truth(match *truth {
            [x, y, heading] => Some(Pose::new(x, y, heading)),
            _ => None,
        });
    }

    /// A hand lifts the virtual robot, or puts it elsewhere.
    pub fn moved_by_hand(&mut self) {
        self.link.moved_by_hand();
    }

    /// The robot was put at x, y, heading, where its estimate begins anew.
    pub fn put_at(&mut self, now: f64, x: f64, y: f64, heading: f64) {
        self.link.put_at(now, Pose::new(x, y, heading));
    }

    /// The page's sign of life.
    pub fn beat(&mut self, now: f64) {
        self.link.beat(now);
    }

    /// Stops the robot and leaves it in Passive, as the page is closed or hidden; `why` is shown to a returning user.
    pub fn leave(&mut self, now: f64, why: &str) {
        self.link.leave(now, why);
    }

    /// Stops what drives before a long task.
    pub fn pause(&mut self, now: f64) {
        self.link.pause(now);
    }

    /// Advances the time; to be called every 10 ms.
    pub fn tick(&mut self, now: f64) {
        self.link.tick(now);
    }

    /// Whether the robot may be moving, or a motor running, because of this connection.
    pub fn is_acting(&self) -> bool {
        self.link.is_acting()
    }

    /// Bytes to be sent at once; empty if there are none.
    pub fn take_tx(&mut self) -> Vec<u8> {
        self.link.take_tx()
    }

    /// Request to the line, to be executed before the next bytes are sent: `{ baud: 19200 }`, `{ brc: true }`,
    /// `"stop"` or `null`.
    #[wasm_bindgen(unchecked_return_type = "rust.LineRequest | null")]
    pub fn take_line(&mut self) -> Result<JsValue, JsValue> {
        to_js(&self.link.take_line())
    }

    /// Executes a `Request`; throws a sentence for users if it is refused.
    pub fn request(
        &mut self,
        now: f64,
        #[wasm_bindgen(unchecked_param_type = "rust.Request")] request: JsValue,
    ) -> Result<(), JsValue> {
        let request = serde_wasm_bindgen::from_value(request).map_err(|e| e.to_string())?;
        self.link.request(now, request).map_err(|e| e.to_string().into())
    }

    /// Starts the algorithm chosen in `mirror`: a behaviour, or the planned line with these `corners`, x and y in turn,
    /// m, and its trajectory with rounded corners, `knots`, if it isn't empty. Brushes and vacuum run for one that cleans, if
    /// `cleans`.
    pub fn ride(
        &mut self,
        now: f64,
        mirror: &SessionMirror,
        corners: &[f64],
        knots: &[f64],
        cleans: bool,
    ) -> Result<(), JsValue> {
        let session = mirror.session();
        let prepared = session.prepared().ok_or("The robot doesn't fit into the room.")?;
        let (settings, start) = (session.settings(), prepared.floor.start);
        let (robot, odometry) = (self.link.calibrated(&prepared.robot), self.link.odometry());
        self.pilot = RemotePilot::default();
        let controller: Box<dyn Controller> = match settings.algorithm {
            Algorithm::Behaviour(_) if settings.algorithm.is_program() => {
                Box::new(Piloted::new(self.pilot.clone(), &robot, start))
            }
            Algorithm::Behaviour(behaviour) => {
                let mut params = settings.params.clone();
                // Only behaviours with their own odometry have this parameter.
                let _ = params.set_text(behaviour.params, "odometry", odometry.id());
                let setup = Setup { robot: &robot, params: &params, seed: settings.seed };
                behaviour.build(&setup).ok_or("This behaviour doesn't exist.")?
            }
            Algorithm::Planner(_) => {
                let line: Vec<Point> = corners.as_chunks().0.iter().map(|&[x, y]| Point::new(x, y)).collect();
                let line: Arc<[Point]> = line.into();
                let smooth = (!knots.is_empty()).then(|| Arc::new(trajectory_from_js(knots)));
                // The stairs of a real flat aren't in the room.
                let follower = prepared.follower(&robot, &line, odometry).carefully();
                Box::new(PathToDrive { line, smooth }.follower(&robot, follower))
            }
        };
        let (title, cleans) = (settings.algorithm.title(), cleans && settings.algorithm.cleans());
        self.link.ride(now, title, controller, start, cleans).map_err(|e| e.to_string().into())
    }

    /// The latest readings for the user's program, if it drives: for its `step`. Each is returned once.
    pub fn take_readings(&mut self) -> Vec<f64> {
        self.pilot.take_readings().unwrap_or_default()
    }

    /// The program's answer: speeds of both wheels, mm/s; not a number if it is done.
    pub fn answer(&mut self, left: f64, right: f64) {
        self.pilot.answer((!left.is_nan() && !right.is_nan()).then_some([left, right]));
    }

    /// Facts about the robot for a program, as JSON, as it is calibrated.
    pub fn program_facts(&self, mirror: &SessionMirror) -> Result<String, JsValue> {
        let prepared = mirror.session().prepared().ok_or("The robot doesn't fit into the room.")?;
        Ok(RobotFacts::of(&self.link.calibrated(&prepared.robot)).to_json())
    }

    /// The snapshot for the page; `transport` is the state of the line.
    #[wasm_bindgen(unchecked_return_type = "rust.ConnectionView")]
    pub fn view(
        &mut self,
        now: f64,
        #[wasm_bindgen(unchecked_param_type = "rust.TransportView")] transport: JsValue,
    ) -> Result<JsValue, JsValue> {
        self.link.set_transport(serde_wasm_bindgen::from_value(transport)?);
        to_js(&self.link.view(now))
    }

    /// The snapshot without a connection.
    #[wasm_bindgen(unchecked_return_type = "rust.ConnectionView")]
    pub fn closed() -> Result<JsValue, JsValue> {
        to_js(&connection::Connection::new().view(0.0))
    }

    /// Traffic since the last call, as `Traffic[]`.
    #[wasm_bindgen(unchecked_return_type = "rust.Traffic[]")]
    pub fn take_traffic(&mut self) -> Result<JsValue, JsValue> {
        to_js(&self.link.take_traffic())
    }

    /// The robot's estimated trail since the last call: x and y in m, heading in rad and contacts, in turn; see
    /// `robovac_link::connection::Connection::take_trace`.
    pub fn take_trace(&mut self) -> Vec<f64> {
        self.link.take_trace()
    }

    /// All traffic so far, as a recording.
    pub fn recording(&self) -> String {
        self.link.recording()
    }
}

impl Default for Connection {
    fn default() -> Self {
        Self::new()
    }
}
