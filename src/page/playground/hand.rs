//! Manual input: joystick, lifting and putting down, and sensor readings.

use super::Playground;
use js_sys::{Array, Float32Array};
use robovac_app::{
    CarriedRobot, CarryStep,
    explore::{Action, DiaryEntry, diary},
};
use robovac_core::geometry::{Point, Pose, Vector};
use robovac_link::dashboard::SensorsView;
use robovac_playground::wire::to_js;
use robovac_sim::controller::Joystick;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Playground {
    /// Moves the joystick: forward and to the left, each -1 to 1.
    pub fn command(&mut self, forward: f64, left: f64) {
        self.session.command(Joystick { forward, left });
    }

    /// Lifts the robot, or puts it down where it is held.
    pub fn pick_up(&mut self) {
        match self.carried.take() {
            Some(carried) => self.session.put_down(carried.pose),
            None => self.take_robot(),
        }
    }

    /// Carries the lifted robot by a key: `left`, `right`, `up`, `down`, `turn_left`, `turn_right`; `apply` puts it
    /// down, `back` puts it where it stood.
    pub fn carry(&mut self, action: &str) {
        let Some(carried) = self.carried else { return };
        match carried.by_key(action, self.session.plan()) {
            Some(CarryStep::On(carried)) => self.carried = Some(carried),
            Some(CarryStep::PutDown) => self.pick_up(),
            Some(CarryStep::PutBack) => self.put_back(),
            None => {}
        }
    }

    /// The latest sensor reading, a `SensorsView`; `null` without a robot.
    #[wasm_bindgen(unchecked_return_type = "rust.SensorsView | null")]
    pub fn readings(&self) -> Result<JsValue, JsValue> {
        to_js(&self.session.recording().map(|recording| SensorsView::new(recording.run().sensors())))
    }

    /// The latest scan of the laser: ranges, m, infinite where there is nothing; empty without one.
    pub fn scan(&self) -> Float32Array {
        let scan = self.session.recording().and_then(|recording| recording.run().sensors().laser.as_deref());
        Float32Array::from(scan.unwrap_or(&[]))
    }

    /// The event log, latest first: seconds, text, and whether it was sensed, in turn.
    pub fn diary(&self) -> Array {
        let follows_plan = self.session.planned().is_some();
        let lines = self.session.recording().map_or(Vec::new(), |recording| diary(recording.run(), follows_plan));
        let values = |line: DiaryEntry| [JsValue::from(line.time_s), line.text.into(), line.is_felt.into()];
        lines.into_iter().flat_map(values).collect()
    }
}

impl Playground {
    /// Whether a running robot can be lifted.
    pub(super) fn may_lift(&self) -> bool {
        self.session.state().allows(Action::Lift)
    }

    /// Lifts the robot where it stands, unless it is lifted already.
    pub(super) fn take_robot(&mut self) {
        let pose = self.session.recording().map(|recording| recording.run().pose());
        let Some(pose) = pose.filter(|_| self.may_lift()) else { return };
        self.session.lift();
        self.carried = Some(CarriedRobot::lifted(pose));
    }

    /// Carries the robot such that the pointer, `grip` from its centre, is at `at`.
    pub(super) fn carry_to(&mut self, at: Point, grip: Vector) {
        let Some(carried) = self.carried else { return };
        let to = at + grip;
        self.carried = Some(carried.held_at(Pose::new(to.x, to.y, carried.pose.heading), self.session.plan()));
    }

    /// Puts the robot down at `at`, unless it is held there; returns whether it did.
    pub(super) fn put_down_at(&mut self, at: Point) -> bool {
        if self.carried.is_none() || self.is_on_robot(at) {
            return false;
        }
        self.carry_to(at, Vector::zeros());
        self.pick_up();
        true
    }

    /// Puts the robot down where it stood.
    pub(super) fn put_back(&mut self) {
        if let Some(carried) = self.carried.take() {
            self.session.put_down(carried.from);
        }
    }
}
