//! The sweeping planner touches nothing, nor do the files of its paths: checked with geometry of its own.

mod rooms;
mod touching;

use coverage_planners::sweep::{
    CLEARANCE, LinkOrder, Sweep, SweepError, SweepSetup, program, sweep, to_csv, to_ros_path, waypoints,
};
use rand::RngExt;

use robovac_core::{
    cspace::Outline,
    floor_plan::{FloorPlan, Object, Sketch, room},
    geometry::{Point, Vector},
    rng,
    robot::model,
};
use rooms::{random_room, random_setup};
use std::ops::ControlFlow;
use touching::{Solid, nearest, solids};

fn planned(plan: &FloorPlan, setup: &SweepSetup) -> Result<Sweep, SweepError> {
    sweep(plan, setup, &mut |_| ControlFlow::Continue(()))
}

/// The path that a table tells.
fn of_csv(text: &str) -> Vec<Point> {
    let value = |field: Option<&str>| field.unwrap().parse::<f64>().unwrap();
    let lines = text.lines().skip(1).map(|line| line.split(','));
    lines.map(|mut fields| Point::new(value(fields.next()), value(fields.next()))).collect()
}

/// The path that a ROS path tells.
fn of_ros_path(text: &str) -> Vec<Point> {
    let value = |line: &str, name: &str| {
        let rest = &line[line.find(name).unwrap() + name.len()..];
        rest[..rest.find([',', '}']).unwrap()].trim().parse::<f64>().unwrap()
    };
    let lines = text.lines().filter(|line| line.contains("position:"));
    lines.map(|line| Point::new(value(line, "x:"), value(line, "y:"))).collect()
}

/// The path of whoever executes a program.
fn of_program(text: &str) -> Vec<Point> {
    let value = |line: &str, word: usize| line.split_whitespace().nth(word).unwrap().parse::<f64>().unwrap();
    let start = text.lines().find(|line| line.starts_with("; start")).unwrap().replace(',', "");
    let (x, y, mut heading) = (value(&start, 3), value(&start, 6), value(&start, 9).to_radians());
    let mut path = vec![Point::new(x, y)];
    for line in text.lines() {
        let (metres, towards) = match line.split(' ').next().unwrap() {
            "TURN" => {
                heading += if line.contains("left") { 1.0 } else { -1.0 } * value(line, 2).to_radians();
                continue;
            }
            "FORWARD" => (value(line, 1), heading),
            "MOVE" => (value(line, 1), heading + value(line, 4).to_radians()),
            _ => continue,
        };
        path.push(path[path.len() - 1] + metres * Vector::new(towards.cos(), towards.sin()));
    }
    path
}

/// The least distance of the path and of what its files tell.
fn checked(plan: &FloorPlan, setup: &SweepSetup, found: &Sweep) -> f64 {
    let solids = solids(plan);
    let least = nearest(plan, &solids, &setup.outline, setup.turns, &found.path);
    // A robot that keeps its heading stands at 0.
    let (robot, heading) = if setup.turns { ("roomba600", 0.7) } else { ("octagon", 0.0) };
    let robot = model(robot).unwrap();
    let files = [
        of_csv(&to_csv(&waypoints(&found.path, heading, robot))),
        of_ros_path(&to_ros_path(&waypoints(&found.path, heading, robot))),
        of_program(&program(&found.path, heading, robot, "it")),
    ];
    let told = files.iter().map(|path| nearest(plan, &solids, &setup.outline, setup.turns, path));
    told.fold(least, f64::min)
}

/// Sweeps so many random rooms with random outlines. Returns how many had a path.
fn nothing_is_touched(rounds: std::ops::Range<u64>) -> usize {
    let mut paths = 0;
    for round in rounds {
        let mut rng = rng::seeded(round, 19);
        let plan = random_room(&mut rng);
        let setup = random_setup(&mut rng, &plan);
        let found = match planned(&plan, &setup) {
            Ok(found) => found,
            Err(SweepError::FitsNowhere { .. } | SweepError::Value { .. }) => continue,
            Err(error) => panic!("round {round}: {error}"),
        };
        paths += 1;
        let least = checked(&plan, &setup, &found);
        assert!(least >= 0.0, "round {round}: {least} m, {setup:?}");
        assert_eq!(found.collisions, found.resolved, "round {round}");
        assert_eq!(found.links.len() + 1, found.subgoals.len(), "round {round}");
    }
    paths
}

#[test]
fn no_outline_touches_anything_in_random_rooms() {
    assert!(nothing_is_touched(0..60) > 45);
}

#[test]
#[ignore = "soak: 10,000 random rooms and outlines take minutes"]
fn no_outline_touches_anything_in_ten_thousand_random_rooms() {
    let paths = nothing_is_touched(0..10_000);
    println!("{paths} of 10,000 rooms have a path");
    assert!(paths > 8000);
}

/// 001, section 6. Once 17 of 690 pieces came up to 5 cm into an obstacle, between the centres of FREE cells.
#[test]
fn no_piece_overlaps_an_obstacle_in_the_hall_of_the_paper() {
    let plan = (room("hall20").unwrap().build)();
    for (width, cell) in [(0.36, 0.1), (0.36, 0.09), (1.0, 0.1), (1.0, 0.05)] {
        let setup = SweepSetup::new(Outline::octagon(width).unwrap(), cell);
        let found = planned(&plan, &setup).unwrap();
        let least = nearest(&plan, &solids(&plan), &setup.outline, false, &found.path);
        println!("octagon of {width} m, cells of {cell} m: at least {:.3} mm from everything", 1000.0 * least);
        assert!(least > 0.0 && least < 1.1 * CLEARANCE, "{least}");
    }
}

/// Abstract and sections 2 and 4: the connected segments should not cross.
#[test]
fn links_do_not_cross_in_the_hall_of_the_paper_if_asked() {
    let plan = (room("hall20").unwrap().build)();
    for (width, cell) in [(0.36, 0.1), (0.36, 0.09), (1.0, 0.1), (1.0, 0.05)] {
        let setup = SweepSetup::new(Outline::octagon(width).unwrap(), cell);
        let plans = LinkOrder::ALL.map(|order| planned(&plan, &SweepSetup { order, ..setup.clone() }).unwrap());
        for (order, found) in LinkOrder::ALL.into_iter().zip(&plans) {
            println!(
                "octagon of {width} m, cells of {cell} m, {}: {} crossings, {} collisions, {:.1} m, {:.4} by links, {:.4} \
                 with {} strokes more, {:.1} m",
                order.id(),
                found.crossings,
                found.collisions,
                found.length,
                found.linked_share,
                found.coverage,
                found.finish.len(),
                found.finish_length
            );
            assert_eq!((found.collisions, found.links.len() + 1), (found.resolved, found.subgoals.len()));
        }
        let [nearest_first, printed, uncrossed] = &plans;
        assert!(nearest_first.crossings > 0 && printed.crossings > 0);
        assert_eq!(uncrossed.crossings, 0);
        // At a price that is told.
        assert!(uncrossed.length > nearest_first.length && uncrossed.length < 1.12 * nearest_first.length);
        let cost = uncrossed.nearest.unwrap();
        assert_eq!((cost.crossings, cost.length), (nearest_first.crossings, nearest_first.length));
        assert!(uncrossed.linked_share > 0.97 && uncrossed.coverage > 0.985);
        let least = nearest(&plan, &solids(&plan), &setup.outline, false, &uncrossed.path);
        assert!(least > 0.0, "{least}");
    }
}

/// Rooms of blocks and round columns, with gaps that are wider than a line's distance.
#[test]
fn links_do_not_cross_in_rooms_full_of_columns() {
    for seed in 0..100 {
        let mut rng = rng::seeded(seed, 20);
        let mut plan = Sketch::open(6.0, 5.0, 0.05).finish("", "");
        // One in every field of a chessboard, away from its edges.
        for field in 0..12 {
            let (x, y) = (0.75 + 1.5 * f64::from(field % 4), 0.83 + 1.66 * f64::from(field / 4));
            let mut side = || rng.random_range(0.05..0.35);
            let (w, h) = (side(), side());
            plan.objects.push(if w > h {
                Object::Leg { at: Point::new(x, y), radius: h }
            } else {
                let corners = [(-w, -h), (w, -h), (w, h), (-w, h)];
                Object::Furniture { outline: corners.map(|(dx, dy)| Point::new(x + dx, y + dy)).to_vec() }
            });
        }
        let setup = SweepSetup { order: LinkOrder::Uncrossed, ..SweepSetup::new(Outline::octagon(0.3).unwrap(), 0.05) };
        let found = planned(&plan, &setup).unwrap();
        assert_eq!(found.crossings, 0, "room {seed}");
        assert!(found.nearest.unwrap().crossings > 0 && found.linked_share > 0.97, "room {seed}");
        let least = nearest(&plan, &solids(&plan), &setup.outline, false, &found.path);
        assert!(least > 0.0, "room {seed}: {least}");
    }
}

/// A robot with two driven wheels turns at every corner: so its rectangle needs the circle around it.
#[test]
fn a_rectangle_that_turns_keeps_the_room_for_it() {
    let plan = Sketch::open(3.0, 2.0, 0.05).fill(&[[1.0, 0.8, 1.6, 1.0]]).finish("", "");
    let setup = SweepSetup { turns: true, ..SweepSetup::new(Outline::rectangle(0.4, 0.2).unwrap(), 0.05) };
    let found = planned(&plan, &setup).unwrap();
    assert_eq!(found.outline, setup.outline.turning_circle());
    assert!(nearest(&plan, &solids(&plan), &setup.outline, true, &found.path) >= 0.0);
    // As if it kept its heading, its corners would hit walls in turning; and it doesn't sweep what only the circle covers.
    let straight = planned(&plan, &SweepSetup { turns: false, ..setup.clone() }).unwrap();
    assert!(nearest(&plan, &solids(&plan), &setup.outline, true, &straight.path) < 0.0);
    assert!(found.coverage < straight.coverage);
}

/// The distance that the user asks for is kept.
#[test]
fn clearance_is_kept() {
    let plan = (room("hall20").unwrap().build)();
    let setup = SweepSetup { clearance: 0.03, ..SweepSetup::new(Outline::circle(0.17).unwrap(), 0.08) };
    let least = nearest(&plan, &solids(&plan), &setup.outline, false, &planned(&plan, &setup).unwrap().path);
    assert!((0.03 - 1e-9..0.032).contains(&least), "{least}");
    let error = planned(&plan, &SweepSetup { clearance: f64::NAN, ..setup }).unwrap_err();
    assert!(matches!(error, SweepError::Value { what: "the clearance", .. }));
}

/// The check finds what it is for.
#[test]
fn an_overlap_is_found() {
    let plan = Sketch::open(3.0, 2.0, 0.05).fill(&[[1.0, 0.8, 1.6, 1.0]]).finish("", "");
    let all = solids(&plan);
    assert!(matches!(all[..], [Solid::Polygon(_), ..]));
    let path = [Point::new(0.5, 0.6), Point::new(2.5, 0.6)];
    for (width, is_free) in [(0.39, true), (0.41, false)] {
        let least = nearest(&plan, &all, &Outline::octagon(width).unwrap(), false, &path);
        assert_eq!(least > 0.0, is_free, "{least}");
    }
    let outside = nearest(&plan, &all, &Outline::circle(0.61).unwrap(), false, &path);
    assert!(outside < 0.0);
}
