//! Editing of the room, with undo and redo.

use robovac_core::{
    floor_plan::FloorPlan,
    geometry::{Point, Pose},
    grid::{Cell, Occupancy},
};
use std::sync::Arc;

/// Most changes that can be undone.
const MOST_UNDO: usize = 200;
/// Most map cells, a byte each, kept for undoing: the largest map has 16 million.
const MOST_UNDO_CELLS: usize = 64 << 20;
/// Width of a drawn wall, m, if cells aren't larger.
const BRUSH_WIDTH: f64 = 0.1;

/// What a stroke draws.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Brush {
    /// Walls.
    Wall,
    /// Free floor.
    Erase,
}

/// The state that undo and redo restore.
#[derive(Debug, Clone)]
struct EditorState {
    plan: Arc<FloorPlan>,
    room: Option<&'static str>,
    start: Option<Pose>,
    lineage: u32,
}

/// A floor plan being edited.
#[derive(Debug, Clone)]
pub struct Editor {
    now: EditorState,
    undo: Vec<EditorState>,
    redo: Vec<EditorState>,
    /// What could be redone in the room that was left last, and in which state that was.
    left: Option<(Arc<FloorPlan>, Vec<EditorState>)>,
    stroke: Option<(Brush, Point)>,
    /// What could be redone before the stroke, which may come to nothing.
    before_stroke: Vec<EditorState>,
    version: u64,
    /// Number of rooms so far.
    lineages: u32,
}

impl Editor {
    /// Starts with a room; `id` if it is built in.
    pub fn new(plan: FloorPlan, id: Option<&'static str>) -> Self {
        let now = EditorState { plan: Arc::new(plan), room: id, start: None, lineage: 0 };
        let (undo, redo, before_stroke) = (Vec::new(), Vec::new(), Vec::new());
        Self { now, undo, redo, left: None, stroke: None, before_stroke, version: 0, lineages: 0 }
    }

    /// The floor plan.
    pub fn plan(&self) -> &Arc<FloorPlan> {
        &self.now.plan
    }

    /// Id of the room, if it is built in and unchanged.
    pub fn room(&self) -> Option<&'static str> {
        self.now.room
    }

    /// Start chosen by the user.
    pub fn start(&self) -> Option<Pose> {
        self.now.start
    }

    /// Changes with every change of walls.
    pub fn version(&self) -> u64 {
        self.version
    }

    /// Whether there is a change to undo.
    pub fn can_undo(&self) -> bool {
        !self.undo.is_empty()
    }

    /// Whether there is a change to redo.
    pub fn can_redo(&self) -> bool {
        !self.redo.is_empty()
    }

    /// Replaces the room, with a start chosen by the user if there is one; can be undone.
    pub fn replace(&mut self, plan: FloorPlan, id: Option<&'static str>, start: Option<Pose>) {
        let mut redo = std::mem::take(&mut self.redo);
        let others = redo.iter().rposition(|state| state.lineage != self.now.lineage).map_or(0, |index| index + 1);
        redo.drain(..others);
        if !redo.is_empty() {
            self.left = Some((Arc::clone(&self.now.plan), redo));
        }
        self.remember();
        self.lineages += 1;
        self.now = EditorState { plan: Arc::new(plan), room: id, start, lineage: self.lineages };
    }

    /// A number that changes with the room, but not with changes of it.
    pub fn lineage(&self) -> u32 {
        self.now.lineage
    }

    /// Goes on with the changes of a room that is opened again, as it was left: they are undone next, not the rooms in
    /// between. Returns whether it is that room.
    pub fn resume(&mut self, lineage: u32) -> bool {
        let is_left = |state: &EditorState| {
            let (before, now) = (&state.plan, &self.now.plan);
            state.lineage == lineage && before.occupancy == now.occupancy && before.objects == now.objects
        };
        let Some(index) = self.undo.iter().rposition(is_left) else { return false };
        self.redo.clear();
        if let Some((_, redo)) = self.left.take_if(|(plan, _)| Arc::ptr_eq(plan, &self.undo[index].plan)) {
            self.redo = redo;
        }
        self.undo.truncate(index);
        self.now.lineage = lineage;
        true
    }

    /// Id of the built-in room that this one was made of, as far as it can be undone.
    pub fn began_as(&self) -> Option<&'static str> {
        self.undo.iter().find(|state| state.lineage == self.now.lineage)?.room
    }

    /// Adds an older state of the room to what can be undone, before all that is known of it; `id` if it is built in.
    pub fn recall(&mut self, plan: FloorPlan, id: Option<&'static str>) {
        let EditorState { start, lineage, .. } = self.now;
        let known = self.undo.iter().position(|state| state.lineage == lineage).unwrap_or(self.undo.len());
        self.undo.insert(known, EditorState { plan: Arc::new(plan), room: id, start, lineage });
    }

    /// Renames the room, which is then an own one.
    pub fn rename(&mut self, name: &str) {
        name.clone_into(&mut Arc::make_mut(&mut self.now.plan).name);
        self.now.room = None;
        self.version += 1;
    }

    /// Clears the undo and redo history.
    pub fn forget(&mut self) {
        self.undo.clear();
        self.redo.clear();
        self.left = None;
    }

    /// Moves the start.
    pub fn set_start(&mut self, start: Option<Pose>) {
        self.remember();
        self.now.start = start;
    }

    /// Replaces the plan by one with other objects.
    pub fn furnish(&mut self, plan: FloorPlan) {
        self.remember();
        self.now.plan = Arc::new(plan);
        self.now.room = None;
    }

    /// Begins a stroke at a point in metres.
    pub fn begin(&mut self, brush: Brush, at: Point) {
        let undone = std::mem::take(&mut self.redo);
        self.remember();
        (self.stroke, self.before_stroke) = (Some((brush, at)), undone);
        self.paint(brush, at, at);
    }

    /// Continues the stroke to a point in metres.
    pub fn go_on(&mut self, at: Point) {
        if let Some((brush, from)) = self.stroke {
            self.stroke = Some((brush, at));
            self.paint(brush, from, at);
        }
    }

    /// Ends the stroke; returns whether there was one. One that has changed no cell is no change.
    pub fn end(&mut self) -> bool {
        if self.undo.last().is_some_and(|before| before.plan.occupancy == self.now.plan.occupancy) {
            self.abandon();
        }
        self.before_stroke.clear();
        self.stroke.take().is_some()
    }

    /// Cancels the current stroke.
    pub fn abandon(&mut self) {
        if self.stroke.take().is_some()
            && let Some(before) = self.undo.pop()
        {
            self.now = before;
            self.redo = std::mem::take(&mut self.before_stroke);
            self.version += 1;
        }
    }

    /// Undoes the last change; returns whether there was one.
    pub fn undo(&mut self) -> bool {
        // The current stroke must not continue in another room.
        self.stroke = None;
        let Some(before) = self.undo.pop() else { return false };
        let undone = self.show(before);
        self.redo.push(undone);
        true
    }

    /// Redoes the last undone change; returns whether there was one.
    pub fn redo(&mut self) -> bool {
        self.stroke = None;
        let Some(after) = self.redo.pop() else { return false };
        let before = self.show(after);
        self.undo.push(before);
        true
    }

    /// Takes another state of the past or future; returns the one before.
    fn show(&mut self, state: EditorState) -> EditorState {
        let before = std::mem::replace(&mut self.now, state);
        self.version += 1;
        // An own room keeps its name, whatever is undone of it.
        let is_own = self.now.lineage == before.lineage && self.now.room.or(before.room).is_none();
        if is_own && self.now.plan.name != before.plan.name {
            before.plan.name.clone_into(&mut Arc::make_mut(&mut self.now.plan).name);
        }
        before
    }

    fn remember(&mut self) {
        self.stroke = None;
        self.undo.push(self.now.clone());
        self.redo.clear();
        self.version += 1;
        let surplus = self.undo.len() - self.affordable_undo();
        self.undo.drain(..surplus);
    }

    /// Number of the latest changes that fit the limits; at least one.
    fn affordable_undo(&self) -> usize {
        let mut cells = 0;
        let mut newer = None;
        let affordable = self.undo.iter().rev().take(MOST_UNDO).take_while(|content| {
            // Moving the start doesn't copy the plan.
            if newer.replace(&content.plan).is_none_or(|plan| !Arc::ptr_eq(plan, &content.plan)) {
                cells += content.plan.occupancy.len();
            }
            cells <= MOST_UNDO_CELLS
        });
        affordable.count().max(1)
    }

    /// Paints all cells within the brush around the line from `from` to `to`.
    fn paint(&mut self, brush: Brush, from: Point, to: Point) {
        let plan = Arc::make_mut(&mut self.now.plan);
        let value = match brush {
            Brush::Wall => Occupancy::Occupied,
            Brush::Erase => Occupancy::Free,
        };
        let spread = ((BRUSH_WIDTH / plan.resolution).round() as i32 - 1).max(0);
        let steps = ((to - from).norm() / (0.5 * plan.resolution)).ceil().clamp(1.0, 1e5);
        for i in 0..=steps as u32 {
            let centre = plan.cell_at(from + (to - from) * (f64::from(i) / steps));
            for dy in 0..=spread {
                for dx in 0..=spread {
                    let cell = Cell::new(centre.x + dx - spread / 2, centre.y + dy - spread / 2);
                    if plan.occupancy.contains(cell) && plan.occupancy[cell] != value {
                        plan.occupancy[cell] = value;
                        self.now.room = None;
                    }
                }
            }
        }
        self.version += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::Grid;

    fn editor() -> Editor {
        let plan = FloorPlan {
            name: "test".into(),
            note: String::new(),
            resolution: 0.1,
            occupancy: Grid::filled(20, 10, Occupancy::Free),
            objects: Vec::new(),
            start: None,
            origin: Pose::new(0.0, 0.0, 0.0),
        };
        Editor::new(plan, Some("empty"))
    }

    fn walls(editor: &Editor) -> usize {
        editor.plan().blocked().count()
    }

    #[test]
    fn stroke_is_one_change_without_gaps() {
        let mut editor = editor();
        editor.begin(Brush::Wall, Point::new(0.05, 0.05));
        editor.go_on(Point::new(1.95, 0.05));
        assert!(editor.end());
        assert_eq!((walls(&editor), editor.room()), (20, None));
        assert!(editor.undo());
        assert_eq!((walls(&editor), editor.room()), (0, Some("empty")));
        assert!(editor.redo() && !editor.redo());
        assert_eq!(walls(&editor), 20);
    }

    #[test]
    fn a_new_name_outlives_undo() {
        let mut editor = editor();
        for x in [0.5, 0.9] {
            editor.begin(Brush::Wall, Point::new(x, 0.5));
            editor.end();
        }
        editor.rename("Loft");
        assert!(editor.undo());
        assert_eq!((editor.plan().name.as_str(), editor.room()), ("Loft", None));
        assert!(editor.undo());
        assert_eq!((editor.plan().name.as_str(), editor.room()), ("test", Some("empty")));
        assert!(editor.redo());
        assert_eq!(editor.plan().name, "Loft");
    }

    #[test]
    fn undo_in_a_room_that_is_opened_again_takes_its_own_changes_back() {
        let mut editor = editor();
        for x in [0.5, 0.9] {
            editor.begin(Brush::Wall, Point::new(x, 0.5));
            editor.end();
        }
        let (own, lineage) = (editor.plan().as_ref().clone(), editor.lineage());
        editor.replace(self::editor().plan().as_ref().clone(), Some("maze"), None);
        editor.replace(FloorPlan { name: "Loft".into(), ..own.clone() }, None, None);
        assert!(editor.resume(lineage) && editor.lineage() == lineage);
        assert!(editor.undo());
        assert_eq!((walls(&editor), editor.room()), (1, None), "the last wall is gone, and it's still the own room");
        // Another state than the one that was left has no changes to take back.
        editor.replace(own, None, None);
        assert!(!editor.resume(lineage));
    }

    #[test]
    fn what_was_undone_can_be_redone_after_a_way_through_another_room() {
        let (mut editor, maze) = (editor(), editor().plan().as_ref().clone());
        for x in [0.5, 0.9] {
            editor.begin(Brush::Wall, Point::new(x, 0.5));
            editor.end();
        }
        assert!(editor.undo());
        let (own, lineage) = (editor.plan().as_ref().clone(), editor.lineage());
        editor.replace(maze, Some("maze"), None);
        assert!(!editor.can_redo(), "not in another room");
        editor.replace(own, None, None);
        assert!(editor.resume(lineage) && editor.redo());
        assert_eq!((walls(&editor), editor.can_redo()), (2, false));
        assert!(editor.undo() && editor.undo());
        assert_eq!((walls(&editor), editor.room()), (0, Some("empty")));
    }

    #[test]
    fn what_is_recalled_is_undone_after_what_was_done_since() {
        let (mut editor, room) = (editor(), editor().plan().as_ref().clone());
        for x in [0.5, 0.7] {
            editor.begin(Brush::Wall, Point::new(x, 0.5));
            editor.end();
        }
        let (two, mut later) = (editor.plan().as_ref().clone(), self::editor());
        assert!(editor.undo());
        let one = editor.plan().as_ref().clone();
        // As after a reload: the room is there, and nothing else.
        later.replace(two, None, None);
        later.begin(Brush::Wall, Point::new(0.9, 0.5));
        later.end();
        later.recall(one, None);
        assert_eq!(later.began_as(), None);
        later.recall(room, Some("empty"));
        assert_eq!(later.began_as(), Some("empty"));
        for expected in [(2, None), (1, None), (0, Some("empty"))] {
            assert!(later.undo());
            assert_eq!((walls(&later), later.room()), expected);
        }
        assert!(later.redo() && later.redo() && later.redo());
        assert_eq!(walls(&later), 3);
    }

    #[test]
    fn abandoned_stroke_leaves_no_trace() {
        let mut editor = editor();
        editor.begin(Brush::Wall, Point::new(0.5, 0.5));
        editor.abandon();
        assert_eq!((walls(&editor), editor.room()), (0, Some("empty")));
        assert!(!editor.can_undo() && !editor.can_redo() && !editor.end());
    }

    #[test]
    fn strokes_may_leave_the_map() {
        let mut editor = editor();
        editor.begin(Brush::Wall, Point::new(-5.0, 0.55));
        editor.go_on(Point::new(50.0, 0.55));
        editor.end();
        assert_eq!(walls(&editor), 20);
    }

    #[test]
    fn a_stroke_that_changes_nothing_is_no_change() {
        let mut editor = editor();
        editor.begin(Brush::Wall, Point::new(-5.0, 0.55));
        editor.go_on(Point::new(-1.0, 3.0));
        assert_eq!((editor.end(), editor.can_undo(), editor.room()), (false, false, Some("empty")));
        // Walls over walls.
        for changes in [true, false] {
            editor.begin(Brush::Wall, Point::new(0.5, 0.5));
            assert_eq!((editor.end(), editor.can_redo()), (changes, false));
        }
        assert!(editor.undo() && !editor.can_undo());
        // What was undone can still be redone.
        editor.begin(Brush::Erase, Point::new(0.5, 0.5));
        assert_eq!((editor.end(), editor.can_redo()), (false, true));
    }

    #[test]
    fn stroke_does_not_go_on_in_another_room() {
        let mut editor = editor();
        editor.begin(Brush::Wall, Point::new(0.05, 0.05));
        assert!(editor.undo());
        editor.go_on(Point::new(1.95, 0.05));
        assert_eq!((walls(&editor), editor.room(), editor.end()), (0, Some("empty"), false));
        editor.begin(Brush::Wall, Point::new(0.05, 0.05));
        editor.replace(self::editor().plan().as_ref().clone(), None, None);
        editor.go_on(Point::new(1.95, 0.05));
        assert_eq!((walls(&editor), editor.end()), (0, false));
    }

    #[test]
    fn undo_of_large_rooms_does_not_fill_the_memory() {
        let mut editor = editor();
        let large =
            FloorPlan { occupancy: Grid::filled(4096, 4096, Occupancy::Free), ..editor.plan().as_ref().clone() };
        editor.replace(large, None, None);
        for _ in 0..2 * MOST_UNDO {
            editor.set_start(None);
        }
        assert_eq!(editor.undo.len(), MOST_UNDO, "starts alone cost nothing");
        for i in 0..6 {
            editor.begin(Brush::Wall, Point::new(f64::from(i), 0.0));
            editor.end();
        }
        let cells: usize =
            editor.undo.chunk_by(|a, b| Arc::ptr_eq(&a.plan, &b.plan)).map(|c| c[0].plan.occupancy.len()).sum();
        assert!(cells <= MOST_UNDO_CELLS && editor.undo.len() >= 3, "{cells} in {}", editor.undo.len());
    }

    #[test]
    fn new_change_forgets_what_was_undone() {
        let mut editor = editor();
        editor.set_start(Some(Pose::new(1.0, 0.5, 0.0)));
        editor.undo();
        editor.begin(Brush::Erase, Point::new(0.5, 0.5));
        assert!(!editor.can_redo());
        assert_eq!(editor.start(), None);
    }
}
