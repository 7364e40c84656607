//! Objects under a user's hand: placed, moved, turned, resized, taken away, undone, saved.

use robovac_app::explore::{Brush, ObjectTool, PlaceableKind, Session, SessionState};
use robovac_core::{
    floor_plan::{Object, SourceFile},
    geometry::{Point, Vector},
};

/// The empty room, 5 m x 4 m; a behaviour needs no plan.
fn empty_room() -> Session {
    let mut session = Session::new();
    session.restore("room=empty&behaviour=bounce").unwrap();
    session.forget_changes();
    session
}

/// Places what a drag from one point to another draws.
fn place(session: &mut Session, hand: &mut ObjectTool, kind: PlaceableKind, from: (f64, f64), to: (f64, f64)) {
    hand.kind = kind;
    hand.begin(Point::new(from.0, from.1));
    hand.go_on(Point::new(to.0, to.1));
    hand.release(session);
}

fn outline(object: &Object) -> &[Point] {
    let (Object::Furniture { outline }
    | Object::LowObstacle { outline, .. }
    | Object::DropOff { outline }
    | Object::Carpet { outline }) = object
    else {
        panic!("{object:?} has no outline")
    };
    outline
}

// slow: every kind of object at many places
#[test]
fn every_kind_can_be_clicked_and_drawn_anywhere_on_free_floor() {
    let (mut session, mut hand, mut again) = (empty_room(), ObjectTool::new(), Session::new());
    for (kind, name) in PlaceableKind::ALL {
        for from in [(0.01, 0.01), (2.5, 3.9), (4.99, 2.0)] {
            for to in [from, (3.0, 1.2)] {
                place(&mut session, &mut hand, kind, from, to);
                let objects = &session.plan().objects;
                // What would stand on the robot is refused; it starts in the corner.
                let is_refused = objects.is_empty() && session.view().message.contains("start");
                let count = if kind == PlaceableKind::Table { 4 } else { 1 };
                assert!(objects.len() == count || is_refused, "{name} {from:?} {to:?}: {}", session.view().message);
                if !is_refused {
                    assert_eq!(hand.selected(&session), Some(count - 1));
                    assert_eq!(session.room(), None, "it isn't the room any more that ships");
                    let file = SourceFile { name: "a.json".into(), bytes: session.scenario_json().into_bytes() };
                    again.load(&[file]).unwrap_or_else(|e| panic!("{name} {from:?} {to:?}: {e}"));
                    assert_eq!(again.plan().objects, *objects, "{name} {from:?} {to:?}");
                    session.undo();
                }
            }
        }
    }
}

#[test]
fn changes_are_undone_and_redone_one_by_one() {
    let (mut session, mut hand) = (empty_room(), ObjectTool::new());
    place(&mut session, &mut hand, PlaceableKind::Table, (2.0, 1.0), (3.2, 2.0));
    let placed = session.plan().objects.clone();
    assert_eq!(placed.len(), 4);
    assert!(hand.edit(&mut session, "right"));
    let moved = session.plan().objects.clone();
    assert!(hand.edit(&mut session, "delete"));
    assert_eq!((session.plan().objects.len(), hand.selected(&session)), (3, None));
    session.undo();
    assert_eq!(session.plan().objects, moved);
    session.undo();
    assert_eq!(session.plan().objects, placed);
    session.undo();
    assert!(session.plan().objects.is_empty() && session.room() == Some("empty") && !session.view().can.undo);
    for _ in 0..3 {
        session.redo();
    }
    assert_eq!(session.plan().objects.len(), 3);
    assert_eq!(session.state(), SessionState::Playing, "the run goes on in the changed room");
}

#[test]
fn keys_move_turn_and_resize() {
    let (mut session, mut hand) = (empty_room(), ObjectTool::new());
    place(&mut session, &mut hand, PlaceableKind::Furniture, (2.0, 1.0), (3.0, 1.5));
    let corners = |session: &Session| outline(&session.plan().objects[0]).to_vec();
    let before = corners(&session);
    for action in ["right", "up", "up", "left", "down", "down"] {
        assert!(hand.edit(&mut session, action));
        assert_eq!(hand.selected(&session), Some(0), "it stays selected");
    }
    assert_eq!(corners(&session), before);
    for _ in 0..6 {
        hand.edit(&mut session, "turn_left");
    }
    // A quarter turn, to the millimetres to which corners are rounded.
    let expected = [(2.75, 0.75), (2.75, 1.75), (2.25, 1.75), (2.25, 0.75)];
    for (corner, (x, y)) in corners(&session).iter().zip(expected) {
        assert!((corner - Point::new(x, y)).norm() < 0.006, "{corner} instead of {x} {y}");
    }
    hand.edit(&mut session, "larger");
    let sides = corners(&session);
    assert!(((sides[1] - sides[0]).norm() - 1.1).abs() < 0.01, "{sides:?}");
    assert!(!ObjectTool::new().edit(&mut session, "left"), "nothing is selected there");
}

#[test]
fn a_press_on_a_leg_takes_it_and_places_no_second_table() {
    let (mut session, mut hand) = (empty_room(), ObjectTool::new());
    place(&mut session, &mut hand, PlaceableKind::Table, (1.0, 1.0), (2.2, 1.8));
    let Object::Leg { at, .. } = session.plan().objects[0] else { panic!("a table has legs") };
    assert!(!hand.take_alike(&session, Point::new(1.6, 1.4), 0.1), "between the legs there is place");
    assert!(hand.take_alike(&session, at + Vector::new(0.03, 0.0), 0.1));
    hand.release(&mut session);
    assert_eq!((session.plan().objects.len(), hand.selected(&session)), (4, Some(0)));
    hand.kind = PlaceableKind::Furniture;
    assert!(!hand.take_alike(&session, at, 0.1), "other things may stand there");
}

#[test]
fn handles_reshape_and_drags_move() {
    let (mut session, mut hand) = (empty_room(), ObjectTool::new());
    place(&mut session, &mut hand, PlaceableKind::Furniture, (2.0, 1.0), (3.0, 1.5));
    // The upper right corner; the lower left one stays, and it stays a rectangle.
    assert!(hand.take_selected(&session, 0, Point::new(3.02, 1.51), 0.1));
    hand.go_on(Point::new(3.5, 2.0));
    assert_eq!(hand.lifted(), Some(0));
    hand.release(&mut session);
    let expected = [(2.0, 1.0), (3.5, 1.0), (3.5, 2.0), (2.0, 2.0)].map(|(x, y)| Point::new(x, y));
    assert_eq!(outline(&session.plan().objects[0]), expected);
    // In its middle it is moved, at most up to the wall.
    assert!(hand.take_any(&session, Point::new(2.7, 1.5), 0.1));
    hand.go_on(Point::new(9.0, 1.5));
    hand.release(&mut session);
    let expected = expected.map(|corner| corner + Vector::new(1.5, 0.0));
    assert_eq!(outline(&session.plan().objects[0]), expected);
    // A drag that is let go changes nothing.
    assert!(hand.take_any(&session, Point::new(4.0, 1.5), 0.1));
    hand.go_on(Point::new(1.0, 1.5));
    hand.let_go();
    hand.release(&mut session);
    assert_eq!(outline(&session.plan().objects[0]), expected);

    place(&mut session, &mut hand, PlaceableKind::VirtualWall, (1.0, 3.0), (2.0, 3.0));
    assert!(hand.take_selected(&session, 1, Point::new(2.0, 3.0), 0.1));
    hand.go_on(Point::new(1.0, 1.5));
    hand.release(&mut session);
    let Object::VirtualWall { pose, length } = session.plan().objects[1] else { panic!() };
    assert_eq!((pose.heading.to_degrees().round(), length), (-90.0, 1.5));
}

#[test]
fn carpets_have_to_be_selected_before_they_are_dragged() {
    let (mut session, mut hand) = (empty_room(), ObjectTool::new());
    place(&mut session, &mut hand, PlaceableKind::Carpet, (1.0, 1.0), (4.0, 3.0));
    hand.select(&session, None);
    let middle = Point::new(2.5, 2.0);
    assert!(!hand.take_any(&session, middle, 0.1), "the view is moved instead");
    hand.click(&session, middle, 0.1);
    assert_eq!(hand.selected(&session), Some(0));
    assert!(hand.take_selected(&session, 0, middle, 0.1));
}

#[test]
fn a_dock_is_put_to_the_wall_that_is_near() {
    for (x, y, heading) in [(0.3, 2.0, 0.0), (4.8, 2.0, 180.0), (2.5, 3.8, -90.0), (2.5, 0.4, 90.0), (2.5, 2.0, 0.0)] {
        let (mut session, mut hand) = (empty_room(), ObjectTool::new());
        place(&mut session, &mut hand, PlaceableKind::Dock, (x, y), (x, y));
        let Object::Dock { pose } = session.plan().objects[0] else { panic!() };
        assert_eq!(pose.heading.to_degrees().round(), heading, "{x} {y}");
        let at_wall = [pose.x, 5.0 - pose.x, pose.y, 4.0 - pose.y].into_iter().fold(f64::MAX, f64::min);
        assert!(at_wall < 0.02 || (x, y) == (2.5, 2.0), "{pose}");
    }
}

#[test]
fn what_cannot_be_there_is_refused_with_the_reason_and_nothing_changes() {
    let (mut session, mut hand) = (empty_room(), ObjectTool::new());
    let start = session.prepared().unwrap().floor.start;
    place(
        &mut session,
        &mut hand,
        PlaceableKind::Furniture,
        (start.x - 0.1, start.y - 0.1),
        (start.x + 0.1, start.y + 0.1),
    );
    let message = session.view().message;
    assert!(message.starts_with("The start at (") && message.contains("lies in furniture"), "{message}");
    assert!(session.plan().objects.is_empty() && !session.view().can.undo);

    place(&mut session, &mut hand, PlaceableKind::Dock, (2.5, 2.0), (3.0, 2.0));
    assert_eq!(session.view().message, "");
    place(&mut session, &mut hand, PlaceableKind::Furniture, (2.3, 1.8), (3.0, 2.2));
    let message = session.view().message;
    assert!(message.starts_with("The dock at (2.500 m, 2.000 m) faces furniture"), "{message}");
    assert_eq!(session.plan().objects.len(), 1);

    // Nor can a wall be drawn there, or a start.
    session.begin_stroke(Brush::Wall, Point::new(2.0, 2.0));
    session.go_on_stroke(Point::new(3.0, 2.0));
    session.end_stroke();
    assert!(session.view().message.contains("faces a wall"), "{}", session.view().message);
    assert_eq!(session.plan().blocked().count(), 0);
    place(&mut session, &mut hand, PlaceableKind::Stairs, (3.5, 2.5), (4.5, 3.5));
    session.move_start(robovac_core::geometry::Pose::new(4.0, 3.0, 0.0));
    assert!(session.view().message.contains("lies in a drop-off"), "{}", session.view().message);
    assert_eq!(session.start(), None);

    // A wall across a path: whose it is.
    place(&mut session, &mut hand, PlaceableKind::Pet, (1.0, 3.0), (2.0, 3.0));
    session.begin_stroke(Brush::Wall, Point::new(1.5, 2.6));
    session.go_on_stroke(Point::new(1.5, 3.4));
    session.end_stroke();
    let message = session.view().message;
    assert!(
        message.starts_with("The pet walks here: a wall at (1.") && message.ends_with("Move the pet's path first."),
        "{message}"
    );
    assert_eq!(session.plan().blocked().count(), 0);
}

#[test]
fn selection_ends_with_the_room_and_goes_round() {
    let (mut session, mut hand) = (empty_room(), ObjectTool::new());
    hand.select_next(&session);
    assert_eq!(hand.selected(&session), None);
    place(&mut session, &mut hand, PlaceableKind::Dirt, (1.5, 1.5), (1.5, 1.5));
    place(&mut session, &mut hand, PlaceableKind::Pet, (2.5, 2.5), (3.5, 2.5));
    let mut seen = Vec::new();
    for _ in 0..3 {
        hand.select_next(&session);
        seen.push(hand.selected(&session).unwrap());
    }
    assert_eq!(seen, [0, 1, 0]);
    assert!(session.description().contains("Objects: dirt, a pet."), "{}", session.description());
    session.undo();
    assert_eq!(hand.selected(&session), None);
}
