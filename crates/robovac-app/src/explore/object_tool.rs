//! Tool that places, selects and drags objects.

use super::objects::{PlaceableKind, handles, moved, object_at, reshaped, scaled, turned};
use crate::explore::Session;
use robovac_core::{
    floor_plan::{FloorPlan, Object},
    geometry::{Point, Vector},
    math,
};
use std::mem::discriminant;

/// Step of a key press when moving an object, m, if cells aren't larger.
const KEY_STEP: f64 = 0.05;
/// Step of a key press when turning an object, rad.
const KEY_TURN: f64 = math::PI / 12.0;
/// Factor of a key press when resizing an object.
const KEY_SCALE: f64 = 1.1;

/// The selection, and the current drag.
#[derive(Debug)]
pub struct ObjectTool {
    /// Kind of object that the next press places.
    pub kind: PlaceableKind,
    /// Index of the object, and the version of the plan for which the index is valid.
    selected: Option<(usize, u64)>,
    drag: Option<Drag>,
}

/// Action of a drag, with its first and current point.
#[derive(Debug, Clone, Copy)]
struct Drag {
    from: Point,
    to: Point,
    what: Dragged,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Dragged {
    New,
    Object(usize),
    Handle(usize, usize),
}

impl ObjectTool {
    /// Nothing selected.
    pub fn new() -> Self {
        Self { kind: PlaceableKind::Furniture, selected: None, drag: None }
    }

    /// The selected object's index.
    pub fn selected(&self, session: &Session) -> Option<usize> {
        // After undo, loading or drawing the index is no longer valid.
        let known = self.selected.filter(|&(_, version)| version == session.plan_version());
        known.map(|(index, _)| index).filter(|&index| index < session.plan().objects.len())
    }

    /// Selects an object, or nothing.
    pub fn select(&mut self, session: &Session, index: Option<usize>) {
        self.selected = index.map(|index| (index, session.plan_version()));
    }

    /// Starts dragging the object `index` if it, or one of its handles, is within `reach` metres of a point.
    pub fn take_selected(&mut self, session: &Session, index: usize, at: Point, reach: f64) -> bool {
        let Some(object) = session.plan().objects.get(index) else { return false };
        let near = |point: &Point| (point - at).norm();
        let handles = handles(object);
        let nearest = handles.iter().enumerate().min_by(|a, b| near(a.1).total_cmp(&near(b.1)));
        let what = match nearest.filter(|(_, point)| near(point) < reach) {
            Some((handle, _)) => Dragged::Handle(index, handle),
            None if object_at(std::slice::from_ref(object), at, reach).is_some() => Dragged::Object(index),
            None => return false,
        };
        self.drag = Some(Drag { from: at, to: at, what });
        true
    }

    /// Starts dragging an object within `reach` metres of a point, and selects it. Carpets and stairs have to be
    /// selected before they can be moved, as otherwise the view couldn't be panned where they fill it.
    pub fn take_any(&mut self, session: &Session, at: Point, reach: f64) -> bool {
        let objects = &session.plan().objects;
        let flat = |index: &usize| matches!(objects[*index], Object::Carpet { .. } | Object::DropOff { .. });
        let Some(index) = object_at(objects, at, reach).filter(|index| !flat(index)) else { return false };
        self.select(session, Some(index));
        self.drag = Some(Drag { from: at, to: at, what: Dragged::Object(index) });
        true
    }

    /// Starts dragging an object like those that are being placed, if there is one within `reach` metres of a point: nobody
    /// puts another one on top of it. Not carpets and stairs, as [`Self::take_any`].
    pub fn take_alike(&mut self, session: &Session, at: Point, reach: f64) -> bool {
        let Some(new) = self.kind.drawn(session.plan(), at, at).pop() else { return false };
        let is_alike = |object: &Object| discriminant(object) == discriminant(&new);
        let hit = object_at(&session.plan().objects, at, reach);
        hit.is_some_and(|index| is_alike(&session.plan().objects[index])) && self.take_any(session, at, reach)
    }

    /// Starts placing an object at a point.
    pub fn begin(&mut self, at: Point) {
        self.drag = Some(Drag { from: at, to: at, what: Dragged::New });
    }

    /// Selects the object at a click.
    pub fn click(&mut self, session: &Session, at: Point, reach: f64) {
        self.select(session, object_at(&session.plan().objects, at, reach));
    }

    /// Continues dragging.
    pub fn go_on(&mut self, to: Point) {
        if let Some(drag) = &mut self.drag {
            drag.to = to;
        }
    }

    /// Cancels dragging.
    pub fn let_go(&mut self) {
        self.drag = None;
    }

    /// Ends dragging: the object is placed where it is shown, if that is possible.
    pub fn release(&mut self, session: &mut Session) {
        let mut objects = self.in_hand(session);
        let Some(Drag { from, to, what }) = self.drag.take() else { return };
        match (what, objects.pop()) {
            (Dragged::New, Some(Object::Mover { .. })) if !is_floor(session.plan(), from) => {
                session.refuse_mover(from);
            }
            (Dragged::New, Some(last)) => {
                objects.push(last);
                let is_placed = session.add_objects(objects);
                let newest = session.plan().objects.len().checked_sub(1).filter(|_| is_placed);
                self.select(session, newest);
            }
            (Dragged::Object(index) | Dragged::Handle(index, _), Some(object)) if to != from => {
                self.change(session, index, object);
            }
            _ => {}
        }
    }

    /// The dragged objects, as they would be placed now.
    pub fn in_hand(&self, session: &Session) -> Vec<Object> {
        let Some(Drag { from, to, what }) = self.drag else { return Vec::new() };
        let plan = session.plan();
        match what {
            Dragged::New => self.kind.drawn(plan, from, to),
            Dragged::Object(index) => {
                plan.objects.get(index).map(|object| moved(plan, object, to - from)).into_iter().collect()
            }
            Dragged::Handle(index, handle) => {
                plan.objects.get(index).map(|object| reshaped(plan, object, handle, to)).into_iter().collect()
            }
        }
    }

    /// The object of the plan that is being dragged.
    pub fn lifted(&self) -> Option<usize> {
        match self.drag?.what {
            Dragged::Object(index) | Dragged::Handle(index, _) => Some(index),
            Dragged::New => None,
        }
    }

    /// Edits the selected object by the name of a key or button: `left`, `right`, `up`, `down`, `turn_left`,
    /// `turn_right`, `larger`, `smaller`, `delete`. Returns whether an object is selected.
    pub fn edit(&mut self, session: &mut Session, action: &str) -> bool {
        let Some(index) = self.selected(session) else { return false };
        let plan = session.plan();
        let object = &plan.objects[index];
        let step = KEY_STEP.max(plan.resolution);
        let by = |x: f64, y: f64| moved(plan, object, Vector::new(x, y) * step);
        let changed = match action {
            "left" => by(-1.0, 0.0),
            "right" => by(1.0, 0.0),
            "up" => by(0.0, 1.0),
            "down" => by(0.0, -1.0),
            "turn_left" => turned(plan, object, KEY_TURN),
            "turn_right" => turned(plan, object, -KEY_TURN),
            "larger" => scaled(plan, object, KEY_SCALE),
            "smaller" => scaled(plan, object, 1.0 / KEY_SCALE),
            "delete" => {
                session.remove_object(index);
                self.selected = None;
                return true;
            }
            _ => return false,
        };
        if changed != *object {
            self.change(session, index, changed);
        }
        true
    }

    /// Selects the object after the selected one, or the first.
    pub fn select_next(&mut self, session: &Session) {
        let count = session.plan().objects.len();
        let next = self.selected(session).map_or(0, |index| index + 1);
        self.select(session, (count > 0).then(|| next % count.max(1)));
    }

    fn change(&mut self, session: &mut Session, index: usize, object: Object) {
        session.change_object(index, object);
        // It stays selected if the edit wasn't possible, too.
        self.select(session, Some(index));
    }
}

/// Whether something can stand there.
fn is_floor(plan: &FloorPlan, at: Point) -> bool {
    plan.occupancy.get(plan.cell_at(at)).is_some_and(|cell| cell.is_free())
}

impl Default for ObjectTool {
    fn default() -> Self {
        Self::new()
    }
}
