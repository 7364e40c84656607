//! Manual input: joystick, lifting and putting down, and sensor readings.

use super::Playground;
use js_sys::{Array, Float32Array};
use robovac_app::explore::{Action, DiaryEntry, diary};
use robovac_core::{
    geometry::{Point, Pose, Vector},
    math,
};
use robovac_link::dashboard::SensorsView;
use robovac_playground::wire::to_js;
use robovac_sim::controller::Joystick;
use wasm_bindgen::prelude::*;

/// Steps of a key press when carrying the robot, m, and when turning it, rad.
const STRIDE: f64 = 0.1;
const TURN: f64 = math::PI / 12.0;

/// A lifted robot.
#[derive(Debug, Clone, Copy)]
pub(super) struct Carried {
    /// Its pose.
    pub pose: Pose,
    /// Its pose before.
    from: Pose,
}

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
        let Some(Carried { pose, from }) = self.carried else { return };
        let (dx, dy, turn) = match action {
            "left" => (-STRIDE, 0.0, 0.0),
            "right" => (STRIDE, 0.0, 0.0),
            "up" => (0.0, STRIDE, 0.0),
            "down" => (0.0, -STRIDE, 0.0),
            "turn_left" => (0.0, 0.0, TURN),
            "turn_right" => (0.0, 0.0, -TURN),
            "apply" => return self.pick_up(),
            "back" => return self.put_back(),
            _ => return,
        };
        let to = Pose::new(pose.x + dx, pose.y + dy, pose.heading + turn);
        self.carried = Some(Carried { pose: self.above_floor(to), from });
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
        self.carried = Some(Carried { pose, from: pose });
    }

    /// Carries the robot such that the pointer, `grip` from its centre, is at `at`.
    pub(super) fn carry_to(&mut self, at: Point, grip: Vector) {
        let Some(Carried { pose, from }) = self.carried else { return };
        let to = at + grip;
        self.carried = Some(Carried { pose: self.above_floor(Pose::new(to.x, to.y, pose.heading)), from });
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

    /// The pose within the room.
    fn above_floor(&self, pose: Pose) -> Pose {
        let plan = self.session.plan();
        Pose::new(pose.x.clamp(0.0, plan.width_m()), pose.y.clamp(0.0, plan.height_m()), pose.heading)
    }
}
