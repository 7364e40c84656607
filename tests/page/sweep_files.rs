//! Sweeps as drawings and bags: what these files tell touches nothing, by geometry that the planner doesn't share.

#[path = "../../crates/coverage-planners/tests/sweep/rooms.rs"]
mod rooms;
#[path = "../../crates/coverage-planners/tests/sweep/touching.rs"]
mod touching;

use coverage_planners::sweep::{SweepError, sweep};
use floor_drawing::Traced;
use mcap::MessageStream;
use rand::RngExt;
use robovac_app::{
    export::{SavedPath, path_bag},
    floor_plan::sweep_dxf,
};
use robovac_core::{
    geometry::{Point, Pose, Vector},
    rng,
    robot::model,
};
use rooms::{random_room, random_setup};
use std::ops::ControlFlow;
use touching::{nearest, solids};

/// The lines on a layer of a DXF, by group codes: 8 is the layer, 10 and 20 are coordinates.
fn of_dxf(bytes: &[u8], layer: &str) -> Vec<Vec<Point>> {
    let text = std::str::from_utf8(bytes).unwrap();
    let words: Vec<&str> = text.lines().map(str::trim).collect();
    let mut lines: Vec<Vec<Point>> = Vec::new();
    let (mut is_line, mut is_on, mut x) = (false, false, 0.0);
    for pair in words.chunks_exact(2) {
        match (pair[0], pair[1]) {
            ("0", "VERTEX") => {}
            ("0", kind) => (is_line, is_on) = (matches!(kind, "LWPOLYLINE" | "POLYLINE" | "LINE"), false),
            ("8", name) if is_line && !is_on && name == layer => {
                is_on = true;
                lines.push(Vec::new());
            }
            ("10", value) if is_on => x = value.parse().unwrap(),
            ("20", value) if is_on => lines.last_mut().unwrap().push(Point::new(x, value.parse().unwrap())),
            _ => {}
        }
    }
    lines
}

/// The poses of the `nav_msgs/Path` of a bag: little-endian CDR, whose values are aligned to their sizes.
fn of_bag(bytes: &[u8]) -> Vec<Point> {
    let messages = MessageStream::new(bytes).unwrap().map(Result::unwrap);
    let plans: Vec<_> = messages.filter(|message| message.channel.topic == "/plan").collect();
    assert_eq!(plans.len(), 1);
    let data = &plans[0].data;
    assert_eq!(data[..4], [0, 1, 0, 0], "little-endian CDR");
    let data = &data[4..];
    let word = |at: usize| u32::from_le_bytes(data[at..at + 4].try_into().unwrap()) as usize;
    let number = |at: usize| f64::from_le_bytes(data[at..at + 8].try_into().unwrap());
    // Time, and the frame's name.
    let after_header = |at: usize| {
        let at = at.next_multiple_of(4) + 8;
        at + 4 + word(at)
    };
    let mut at = after_header(0).next_multiple_of(4);
    let count = word(at);
    at += 4;
    let mut path = Vec::new();
    for _ in 0..count {
        at = after_header(at).next_multiple_of(8);
        path.push(Point::new(number(at), number(at + 8)));
        at += 7 * 8;
    }
    assert_eq!(at, data.len());
    path
}

/// A point of the map as one of a room that lies there.
fn in_room(origin: Pose, at: Point) -> Point {
    let (sin, cos) = origin.heading.sin_cos();
    let off: Vector = at - origin.position();
    Point::new(cos * off.x + sin * off.y, cos * off.y - sin * off.x)
}

#[test]
fn drawings_and_bags_touch_nothing() {
    let mut paths = 0;
    for round in 0..40 {
        let mut rng = rng::seeded(round, 23);
        let mut plan = random_room(&mut rng);
        let setup = random_setup(&mut rng, &plan);
        // The room stands anywhere in its map.
        let mut anywhere = || rng.random_range(-6.0..6.0);
        plan.origin = Pose::new(anywhere(), anywhere(), anywhere());
        let found = match sweep(&plan, &setup, &mut |_| ControlFlow::Continue(())) {
            Ok(found) => found,
            Err(SweepError::FitsNowhere { .. } | SweepError::Value { .. }) => continue,
            Err(error) => panic!("round {round}: {error}"),
        };
        paths += 1;
        let origin = plan.origin;
        let room = Traced::of_map(plan, 1.0);
        let drawing = sweep_dxf(&found, &room, None).unwrap();
        let robot = model(if setup.turns { "roomba600" } else { "octagon" }).unwrap();
        let bag = path_bag(&room.plan, robot, SavedPath::with_stops(&found.path, 0.0)).unwrap();
        let drawn = of_dxf(&drawing, "SWEEP_PATH");
        assert_eq!(drawn.len(), 1, "round {round}");
        let strokes = of_dxf(&drawing, "SWEEP_FINISH");
        assert_eq!(strokes.len(), found.finish.len(), "round {round}");
        let solids = solids(&room.plan);
        for line in drawn.into_iter().chain(strokes).chain([of_bag(&bag)]) {
            let path: Vec<Point> = line.into_iter().map(|at| in_room(origin, at)).collect();
            let least = nearest(&room.plan, &solids, &setup.outline, setup.turns, &path);
            assert!(least >= 0.0, "round {round}: {least} m, {setup:?}");
        }
    }
    assert!(paths > 25, "{paths}");
}
