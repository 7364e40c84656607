//! Objects in the session's room.

use super::{Session, sentence};
use robovac_core::{
    floor_plan::{FloorPlan, Object},
    geometry::Point,
};

impl Session {
    /// Adds objects to the room, as one change; returns whether they fit, and reports an error if not.
    pub fn add_objects(&mut self, objects: Vec<Object>) -> bool {
        let mut all = self.plan().objects.clone();
        all.extend(objects);
        self.take_objects(all)
    }

    /// Says why nobody is placed at a point without floor.
    pub(in crate::explore) fn refuse_mover(&mut self, at: Point) {
        let is_wall = self.plan().occupancy.contains(self.plan().cell_at(at));
        let place = if is_wall { "there is no floor there" } else { "that is outside the room" };
        self.say("error", format!("Not placed: {place}. Click on free floor."));
    }

    /// Replaces an object; returns whether the new one fits.
    pub fn change_object(&mut self, index: usize, object: Object) -> bool {
        let mut all = self.plan().objects.clone();
        let Some(place) = all.get_mut(index) else { return false };
        *place = object;
        self.take_objects(all)
    }

    /// Removes an object.
    pub fn remove_object(&mut self, index: usize) {
        let mut all = self.plan().objects.clone();
        if index < all.len() {
            all.remove(index);
            self.take_objects(all);
        }
    }

    fn take_objects(&mut self, objects: Vec<Object>) -> bool {
        let plan = FloorPlan { objects, ..FloorPlan::clone(self.plan()) };
        if let Err(refusal) = plan.check_objects(self.start().or(plan.start)) {
            self.say("error", sentence(&refusal.fault.to_string()));
            return false;
        }
        self.message = None;
        self.editor.furnish(plan);
        self.prepare_changed();
        true
    }
}
