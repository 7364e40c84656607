//! A robot that a person has lifted.

use robovac_core::{floor_plan::FloorPlan, geometry::Pose, math};

/// Steps of a key press when carrying the robot, m, and when turning it, rad.
const STRIDE: f64 = 0.1;
const TURN: f64 = math::PI / 12.0;

/// A lifted robot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CarriedRobot {
    /// Its pose.
    pub pose: Pose,
    /// Its pose before.
    pub from: Pose,
}

/// What a key does with a lifted robot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CarryStep {
    /// It is carried on.
    On(CarriedRobot),
    /// It is put down where it is held.
    PutDown,
    /// It is put where it stood.
    PutBack,
}

impl CarriedRobot {
    /// A robot that was lifted where it stood.
    pub fn lifted(pose: Pose) -> Self {
        Self { pose, from: pose }
    }

    /// Held at `pose`, or at the place within the room that is nearest to it.
    pub fn held_at(self, pose: Pose, plan: &FloorPlan) -> Self {
        let (x, y) = (pose.x.clamp(0.0, plan.width_m()), pose.y.clamp(0.0, plan.height_m()));
        Self { pose: Pose::new(x, y, pose.heading), ..self }
    }

    /// What a key does: `left`, `right`, `up`, `down`, `turn_left`, `turn_right`, `apply` or `back`; `None` for any other.
    pub fn by_key(self, key: &str, plan: &FloorPlan) -> Option<CarryStep> {
        let (dx, dy, turn) = match key {
            "left" => (-STRIDE, 0.0, 0.0),
            "right" => (STRIDE, 0.0, 0.0),
            "up" => (0.0, STRIDE, 0.0),
            "down" => (0.0, -STRIDE, 0.0),
            "turn_left" => (0.0, 0.0, TURN),
            "turn_right" => (0.0, 0.0, -TURN),
            "apply" => return Some(CarryStep::PutDown),
            "back" => return Some(CarryStep::PutBack),
            _ => return None,
        };
        let Pose { x, y, heading } = self.pose;
        Some(CarryStep::On(self.held_at(Pose::new(x + dx, y + dy, heading + turn), plan)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::floor_plan::room;

    #[test]
    fn keys_carry_and_turn_it_within_the_room() {
        let plan = (room("empty").unwrap().build)();
        let stood = Pose::new(0.15, 1.0, 0.0);
        let mut robot = CarriedRobot::lifted(stood);
        for key in ["left", "left", "up", "turn_left", "turn_left"] {
            let Some(CarryStep::On(carried)) = robot.by_key(key, &plan) else { panic!("{key} carries it") };
            robot = carried;
        }
        assert_eq!((robot.pose.x, robot.from), (0.0, stood));
        assert!((robot.pose.y - 1.1).abs() < 1e-12 && (robot.pose.heading - math::PI / 6.0).abs() < 1e-12);
        let ends = ["apply", "back", "jump"].map(|key| robot.by_key(key, &plan));
        assert_eq!(ends, [Some(CarryStep::PutDown), Some(CarryStep::PutBack), None]);
    }
}
