//! Gestures of the pointer, and drawing by keyboard.

use super::Playground;
use robovac_app::explore::{Brush, FloorTool};
use robovac_core::{
    geometry::{Point, Pose, Vector},
    grid::Cell,
    math,
};
use wasm_bindgen::prelude::*;

/// Least distance from the robot's centre at which the pointer grips it, CSS pixels.
const LEAST_GRIP_PX: f64 = 16.0;
/// Distance of the pointer at which a robot is picked up, CSS pixels; a click does nothing.
const LEAST_LIFT_PX: f64 = 4.0;

/// A gesture between pointer down and up.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum FloorGesture {
    Pan {
        x: f64,
        y: f64,
    },
    Paint,
    /// Drags an object.
    Object,
    /// Places the start here on release; dragging turns it if `turns`, else moves it.
    Start {
        pose: Pose,
        turns: bool,
    },
    /// Grips a running robot, whose centre is `grip` from the pointer that went down at (`x`, `y`).
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

#[wasm_bindgen]
impl Playground {
    /// Selects the pointer's tool: `view`, `wall`, `erase`, `start` or `place`.
    pub fn set_tool(&mut self, id: &str) {
        self.tool = match id {
            "wall" => FloorTool::Wall,
            "erase" => FloorTool::Erase,
            "start" => FloorTool::Start,
            "place" => FloorTool::Place,
            _ => FloorTool::View,
        };
        self.cursor = None;
        self.end_gesture();
    }

    /// The pointer at (`x`, `y`), CSS pixels on the canvas: `down`, `move`, `up` or `cancel`.
    pub fn pointer(&mut self, kind: &str, x: f64, y: f64) {
        let at = self.viewport.to_world(x, y);
        if self.tool == FloorTool::View {
            self.watch_for_click(kind, x, y);
        }
        match (kind, self.gesture) {
            ("down", _) => self.press(at, x, y),
            ("move", Some(FloorGesture::Pan { x: from_x, y: from_y })) => {
                self.viewport.pan(x - from_x, y - from_y);
                self.gesture = Some(FloorGesture::Pan { x, y });
            }
            ("move", Some(FloorGesture::Paint)) => self.session.go_on_stroke(at),
            ("move", Some(FloorGesture::Object)) => self.object_tool.go_on(at),
            ("move", Some(FloorGesture::Start { pose, turns: true })) => {
                let aim = at - pose.position();
                if aim.norm() > 0.1 {
                    let heading = math::atan2(aim.y, aim.x);
                    self.gesture = Some(FloorGesture::Start { pose: Pose::new(pose.x, pose.y, heading), turns: true });
                }
            }
            ("move", Some(FloorGesture::Start { pose, turns: false })) => {
                self.gesture = Some(FloorGesture::Start { pose: Pose::new(at.x, at.y, pose.heading), turns: false });
            }
            ("move", Some(FloorGesture::Grip { x: from_x, y: from_y, grip }))
                if (x - from_x).abs().max((y - from_y).abs()) >= LEAST_LIFT_PX =>
            {
                self.take_robot();
                self.gesture = Some(FloorGesture::Carry { grip });
                self.carry_to(at, grip);
            }
            ("move", Some(FloorGesture::Carry { grip })) => self.carry_to(at, grip),
            // Picked up by its button, it is where the pointer is.
            ("move", None) => self.carry_to(at, Vector::zeros()),
            ("cancel", Some(FloorGesture::Carry { .. })) => {
                self.put_back();
                self.gesture = None;
            }
            ("cancel", Some(FloorGesture::Start { .. })) => self.gesture = None,
            ("cancel", Some(FloorGesture::Object)) => {
                self.object_tool.let_go();
                self.gesture = None;
            }
            ("cancel", Some(FloorGesture::Paint)) => {
                self.session.abandon_stroke();
                self.gesture = None;
            }
            ("up" | "cancel", _) => self.end_gesture(),
            _ => {}
        }
    }

    /// Drawing by keyboard: `left`, `right`, `up`, `down` move a cursor by a planning cell, `apply` draws there.
    pub fn key_edit(&mut self, action: &str) {
        let plan = self.session.plan();
        let stride = (self.session.settings().cell_size / plan.resolution).round().max(1.0) as i32;
        let (width, height) = (plan.occupancy.width() as i32, plan.occupancy.height() as i32);
        let cursor = self.cursor.unwrap_or(Cell::new(width / 2, height / 2));
        let (dx, dy) = match action {
            "left" => (-stride, 0),
            "right" => (stride, 0),
            "up" => (0, stride),
            "down" => (0, -stride),
            _ => (0, 0),
        };
        let at = Cell::new((cursor.x + dx).clamp(0, width - 1), (cursor.y + dy).clamp(0, height - 1));
        if action == "apply" {
            let point = plan.centre(at);
            let heading = self.session.prepared().map_or(0.0, |p| p.floor.start.heading);
            match self.tool {
                FloorTool::Wall => self.session.begin_stroke(Brush::Wall, point),
                FloorTool::Erase => self.session.begin_stroke(Brush::Erase, point),
                FloorTool::Start => self.session.move_start(Pose::new(point.x, point.y, heading)),
                FloorTool::Place => {
                    self.object_tool.begin(point);
                    self.object_tool.release(&mut self.session);
                }
                FloorTool::View => {}
            }
            self.session.end_stroke();
        }
        self.cursor = Some(at);
    }
}

impl Playground {
    fn press(&mut self, at: Point, x: f64, y: f64) {
        self.cursor = None;
        let heading = self.session.prepared().map_or(0.0, |p| p.floor.start.heading);
        let tool = self.tool;
        self.gesture = Some(match tool {
            FloorTool::Wall | FloorTool::Erase => {
                let brush = if self.tool == FloorTool::Wall { Brush::Wall } else { Brush::Erase };
                self.session.begin_stroke(brush, at);
                FloorGesture::Paint
            }
            FloorTool::Start => FloorGesture::Start { pose: Pose::new(at.x, at.y, heading), turns: true },
            // A click puts down a lifted robot; see `watch_for_click`.
            FloorTool::View if self.carried.is_some() && !self.is_on_robot(at) => FloorGesture::Pan { x, y },
            FloorTool::View | FloorTool::Place if self.takes_selected(at) => FloorGesture::Object,
            FloorTool::Place if self.takes_alike(at) => FloorGesture::Object,
            FloorTool::Place => {
                self.object_tool.begin(at);
                FloorGesture::Object
            }
            FloorTool::View if self.is_on_robot(at) && (self.carried.is_some() || self.may_lift()) => {
                self.grip(at, x, y)
            }
            FloorTool::View if self.is_on_robot(at) => {
                FloorGesture::Start { pose: Pose::new(at.x, at.y, heading), turns: false }
            }
            FloorTool::View if self.takes_object(at) => FloorGesture::Object,
            FloorTool::View => FloorGesture::Pan { x, y },
        });
    }

    fn end_gesture(&mut self) {
        match self.gesture.take() {
            Some(FloorGesture::Paint) => self.session.end_stroke(),
            Some(FloorGesture::Start { pose, .. }) => self.session.move_start(pose),
            Some(FloorGesture::Object) => self.object_tool.release(&mut self.session),
            Some(FloorGesture::Carry { .. }) if self.carried.is_some() => self.pick_up(),
            _ => {}
        }
    }

    /// Grips the robot at `at`, which is (`x`, `y`) on the screen.
    fn grip(&self, at: Point, x: f64, y: f64) -> FloorGesture {
        let pose = self.carried.map(|c| c.pose).or(self.session.recording().map(|r| r.run().pose()));
        let grip = pose.map_or(Vector::zeros(), |pose| pose.position() - at);
        if self.carried.is_some() { FloorGesture::Carry { grip } } else { FloorGesture::Grip { x, y, grip } }
    }

    pub(super) fn is_on_robot(&self, at: Point) -> bool {
        // No grip during a film.
        if self.session.picture().is_some() {
            return false;
        }
        let radius = self.session.settings().robot_model().radius;
        let robot = self.carried.map(|c| c.pose).or(self.session.recording().map(|r| r.run().pose()));
        let reach = radius.max(LEAST_GRIP_PX / self.viewport.scale);
        robot.is_some_and(|pose| (pose.position() - at).norm() < reach)
    }
}
