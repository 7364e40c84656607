//! Kidnapping by pointer: lifts the robot and puts it down elsewhere.

use super::MapSession;
use robovac_app::{
    CarriedRobot, CarryStep,
    map::{self, MapAction, MapPhase},
};
use robovac_core::geometry::{Point, Pose, Vector};
use wasm_bindgen::prelude::*;

/// Least distance from the robot's centre at which the pointer grips it, CSS pixels.
const LEAST_GRIP_PX: f64 = 16.0;
/// Distance of the pointer at which a robot is lifted, CSS pixels; a click does nothing.
const LEAST_LIFT_PX: f64 = 4.0;

/// The lifted robot, and the pointer's gesture.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct RobotHand {
    /// The lifted robot.
    carried: Option<CarriedRobot>,
    gesture: Option<MapGesture>,
}

/// A gesture between pointer down and up.
#[derive(Debug, Clone, Copy)]
enum MapGesture {
    Pan {
        x: f64,
        y: f64,
    },
    /// Puts the lifted robot down here on release, unless the view is panned.
    Tap {
        x: f64,
        y: f64,
    },
    /// Grips the robot, whose centre is `grip` from the pointer that went down at (`x`, `y`).
    Grip {
        x: f64,
        y: f64,
        grip: Vector,
    },
    /// Carries it.
    Carry {
        grip: Vector,
    },
}

impl RobotHand {
    /// The pose of the lifted robot.
    pub fn pose(&self) -> Option<Pose> {
        self.carried.map(|carried| carried.pose)
    }

    /// Whether it holds the robot.
    pub fn holds(&self) -> bool {
        self.carried.is_some()
    }

    /// Drops the robot if it isn't lifted in the displayed run; takes it if it is.
    pub fn keep(&mut self, session: &map::MapSession) {
        let is_held = session.phase() == MapPhase::Held;
        let pose = session.run().map(robovac_sim::Run::pose).filter(|_| is_held);
        self.carried = pose.map(|pose| self.carried.unwrap_or(CarriedRobot::lifted(pose)));
    }
}

#[wasm_bindgen]
impl MapSession {
    /// Handles a pointer event at (`x`, `y`), CSS pixels: `down`, `move`, `up` or `cancel`. It pans the view, or
    /// carries the robot if it went down on it. A tap elsewhere puts a lifted robot down.
    pub fn pointer(&mut self, what: &str, x: f64, y: f64) {
        let at = self.viewport.to_world(x, y);
        match (what, self.hand.gesture) {
            ("down", _) => {
                let elsewhere = if self.hand.holds() { MapGesture::Tap { x, y } } else { MapGesture::Pan { x, y } };
                self.hand.gesture = Some(self.grip(at, x, y).unwrap_or(elsewhere));
            }
            ("move", Some(MapGesture::Tap { x: from_x, y: from_y }))
                if (Point::new(x, y) - Point::new(from_x, from_y)).norm() >= LEAST_LIFT_PX =>
            {
                self.viewport.pan(x - from_x, y - from_y);
                self.hand.gesture = Some(MapGesture::Pan { x, y });
            }
            ("up", Some(MapGesture::Tap { .. })) => {
                self.carry_to(at);
                self.put_down();
                self.hand.gesture = None;
            }
            ("move", Some(MapGesture::Pan { x: from_x, y: from_y })) => {
                self.viewport.pan(x - from_x, y - from_y);
                self.hand.gesture = Some(MapGesture::Pan { x, y });
            }
            ("move", Some(MapGesture::Grip { x: from_x, y: from_y, grip }))
                if (Point::new(x, y) - Point::new(from_x, from_y)).norm() >= LEAST_LIFT_PX =>
            {
                self.take_robot();
                self.hand.gesture = self.hand.holds().then_some(MapGesture::Carry { grip });
            }
            ("move", Some(MapGesture::Carry { grip })) => self.carry_to(at + grip),
            ("up", Some(MapGesture::Carry { .. })) => {
                self.put_down();
                self.hand.gesture = None;
            }
            ("cancel", Some(MapGesture::Carry { .. })) => {
                self.put_back();
                self.hand.gesture = None;
            }
            ("up" | "cancel", _) => self.hand.gesture = None,
            _ => {}
        }
    }

    /// Lifts the robot, or puts it down where it is held.
    pub fn pick_up(&mut self) {
        if self.hand.holds() { self.put_down() } else { self.take_robot() }
    }

    /// Carries the lifted robot by a key: `left`, `right`, `up`, `down`, `turn_left`, `turn_right`; `apply` puts it
    /// down, `back` puts it where it stood.
    pub fn carry(&mut self, action: &str) {
        let (Some(carried), Some(plan)) = (self.hand.carried, self.state.plan()) else { return };
        match carried.by_key(action, plan) {
            Some(CarryStep::On(carried)) => self.hand.carried = Some(carried),
            Some(CarryStep::PutDown) => self.put_down(),
            Some(CarryStep::PutBack) => self.put_back(),
            None => {}
        }
    }
}

impl MapSession {
    /// Grip of the robot, if it can be lifted and the pointer went down on it.
    fn grip(&self, at: Point, x: f64, y: f64) -> Option<MapGesture> {
        let centre = self.hand.pose().or(self.state.run().map(robovac_sim::Run::pose))?.position();
        let radius = self.state.prepared()?.robot.radius.max(LEAST_GRIP_PX / self.viewport.scale);
        let grip = centre - at;
        if grip.norm() > radius {
            return None;
        }
        if self.hand.holds() {
            return Some(MapGesture::Carry { grip });
        }
        self.state.can(MapAction::Lift).then_some(MapGesture::Grip { x, y, grip })
    }

    fn take_robot(&mut self) {
        self.state.lift();
        self.hand.keep(&self.state);
    }

    fn put_down(&mut self) {
        if let Some(carried) = self.hand.carried.take() {
            self.state.put_down(carried.pose);
        }
    }

    fn put_back(&mut self) {
        if let Some(carried) = self.hand.carried.take() {
            self.state.put_down(carried.from);
        }
    }

    /// Carries the lifted robot to a place within the room.
    fn carry_to(&mut self, to: Point) {
        let (Some(carried), Some(plan)) = (self.hand.carried, self.state.plan()) else { return };
        self.hand.carried = Some(carried.held_at(Pose::new(to.x, to.y, carried.pose.heading), plan));
    }
}
