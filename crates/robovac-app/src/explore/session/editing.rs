//! Changes of the session's room: walls, start and name.

use super::{Session, rounded, sentence};
use crate::explore::{Brush, Editor};
use robovac_core::{
    floor_plan::{FloorPlan, PlacementFault, PlacementRefusal},
    geometry::{Point, Pose},
};
use robovac_sim::experiment::planning::RoomSetup;
use std::sync::Arc;

impl Session {
    /// Begins to draw or erase walls at a point in metres.
    pub fn begin_stroke(&mut self, brush: Brush, at: Point) {
        self.editor.begin(brush, at);
    }

    /// Goes on drawing to a point in metres.
    pub fn go_on_stroke(&mut self, at: Point) {
        self.editor.go_on(at);
    }

    /// Cancels the current stroke.
    pub fn abandon_stroke(&mut self) {
        self.editor.abandon();
    }

    /// Ends drawing and plans again; walls can't replace floor needed by objects.
    pub fn end_stroke(&mut self) {
        if let Err(refusal) = self.plan().check_objects(None) {
            self.editor.abandon();
            let words = self.blocked_path(&refusal).unwrap_or_else(|| sentence(&refusal.fault.to_string()));
            self.say("error", words);
        }
        if self.editor.end() {
            self.message = None;
            self.prepare_changed();
        }
    }

    /// Whose path a drawn wall would cross, and what to do; `None` for other faults.
    fn blocked_path(&self, refusal: &PlacementRefusal) -> Option<String> {
        let PlacementFault::PathInWall { x, y } = refusal.fault else { return None };
        let index: usize = refusal.path.split(['[', ']']).nth(1)?.parse().ok()?;
        let name = self.plan().objects.get(index)?.name();
        Some(format!(
            "The {name} walks here: a wall at ({x:.2} m, {y:.2} m) would be in the way. Move the {name}'s path first."
        ))
    }

    /// Moves the start; if the robot can't stand there, reports that and leaves it.
    pub fn move_start(&mut self, to: Pose) {
        if let Err(refusal) = self.plan().check_objects(Some(to)) {
            self.say("error", sentence(&refusal.fault.to_string()));
            return;
        }
        if self.settings.path.is_some() {
            self.say("error", "The path begins here. Choose a planner to start elsewhere.".to_owned());
            return;
        }
        let robot = self.settings.robot_model();
        match RoomSetup::new(self.editor.plan(), &robot, self.settings.cells(), Some(to)) {
            Ok(prepared) => {
                self.message = None;
                self.editor.set_start(Some(rounded(prepared.floor.start)));
                self.prepare_changed();
            }
            Err(error) => self.say("error", sentence(&error.to_string())),
        }
    }

    /// Undoes the last change of the room.
    pub fn undo(&mut self) {
        self.go_to_room(Editor::undo);
    }

    /// Redoes the last undone change.
    pub fn redo(&mut self) {
        self.go_to_room(Editor::redo);
    }

    fn go_to_room(&mut self, go: fn(&mut Editor) -> bool) {
        let (lineage, before) = (self.editor.lineage(), Arc::clone(self.plan()));
        if !go(&mut self.editor) {
            return;
        }
        self.message = None;
        if self.editor.lineage() == lineage {
            return self.prepare_changed();
        }
        let parted = self.change_path(lineage, &before);
        self.prepare();
        self.tell_parted(parted);
    }

    /// A number that changes with the room, but not with changes of it.
    pub fn room_lineage(&self) -> u32 {
        self.editor.lineage()
    }

    /// Goes on with the changes of a room that is opened again.
    pub fn resume_room(&mut self, lineage: u32) {
        self.editor.resume(lineage);
    }

    /// Id of the built-in room that this one was made of, as far as it can be undone.
    pub fn began_as(&self) -> Option<&'static str> {
        self.editor.began_as()
    }

    /// Adds an older state of the room to what can be undone, before all that is known of it; `id` if it is built in.
    pub fn recall_room(&mut self, plan: FloorPlan, id: Option<&'static str>) {
        self.editor.recall(plan, id);
    }

    /// Renames the room, which is then an own one.
    pub fn rename_room(&mut self, name: &str) {
        self.editor.rename(name);
    }

    /// Clears the undo and redo history.
    pub fn forget_changes(&mut self) {
        self.editor.forget();
    }
}
