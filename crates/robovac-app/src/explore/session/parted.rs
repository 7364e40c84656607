//! A path from Floor plan belongs to the room that it was planned in: it stays there when another room comes.

use super::Session;
use robovac_core::{floor_plan::FloorPlan, geometry::MetricPath, robot::RobotModel};

/// A path that stayed with its room.
#[derive(Debug)]
pub(super) struct PartedPath {
    /// [Lineage](Session::room_lineage) of its room.
    lineage: u32,
    path: MetricPath,
    /// What it was planned for.
    robot: RobotModel,
}

impl Session {
    /// Whether a room has the floor of the present one.
    pub(super) fn is_same_floor(&self, next: &FloorPlan) -> bool {
        is_same(self.plan(), next)
    }

    /// Leaves the path out, unless the next room has the same floor; returns whether there was one.
    pub(super) fn part_with_path(&mut self, next: &FloorPlan) -> bool {
        !self.is_same_floor(next) && self.part(self.editor.lineage())
    }

    /// The same after undo or redo has left the room `before`; the path of the room to which it has come is back.
    pub(super) fn change_path(&mut self, lineage: u32, before: &FloorPlan) -> bool {
        let robot = self.settings.robot_model();
        let now = self.editor.lineage();
        let back = self.parted.take_if(|parted| parted.lineage == now && parted.robot == robot);
        let parted = !self.is_same_floor(before) && self.part(lineage);
        if let Some(PartedPath { path, .. }) = back {
            self.settings.path = Some(path);
            return false;
        }
        parted
    }

    fn part(&mut self, lineage: u32) -> bool {
        let Some(path) = self.settings.path.take() else { return false };
        self.parted = Some(PartedPath { lineage, path, robot: self.settings.robot_model() });
        true
    }

    /// Says that a path has stayed with its room, unless there is something more urgent.
    pub(super) fn tell_parted(&mut self, parted: bool) {
        if parted && self.message.is_none() {
            let title = self.settings.algorithm.title();
            let text = format!("The path from Floor plan belongs to another room. Here the algorithm is {title}.");
            self.say("notice", text);
        }
    }
}

fn is_same(one: &FloorPlan, other: &FloorPlan) -> bool {
    one.resolution == other.resolution && one.occupancy == other.occupancy && one.objects == other.objects
}
