//! The sweeping planner of 001 in metres, and what is made of its path.

use coverage_planners::{
    stage::LineEndContact,
    sweep::{CLEARANCE, Sweep, SweepError, SweepSetup, sweep},
};
use robovac_app::floor_plan::overlays;
use robovac_core::{
    cspace::{CspaceError, Motion, Outline},
    floor_plan::{FloorPlan, Object, Sketch, room},
    geometry::{Point, Pose, Vector},
    robot::model,
};
use robovac_link::{
    commands,
    emulator::{Emulator, personality},
};
use robovac_sim::{
    Conditions,
    experiment::planning::{Placement, choose_robot},
};
use std::ops::ControlFlow;

fn setup(outline: Outline, cell: f64) -> SweepSetup {
    SweepSetup::new(outline, cell)
}

fn planned(plan: &FloorPlan, setup: &SweepSetup) -> Sweep {
    sweep(plan, setup, &mut |_| ControlFlow::Continue(())).unwrap()
}

fn hall() -> FloorPlan {
    (room("hall20").unwrap().build)()
}

/// 001, section 6: 20 m x 20 m, seven obstacles, an octagon; every collision gets its detour, and all is swept.
#[test]
fn the_papers_case() {
    // Collisions as docs/papers.md has them.
    for (width, cell, told) in [(0.36, 0.1, Some(44)), (0.36, 0.09, None), (1.0, 0.1, Some(29)), (1.0, 0.05, None)] {
        let outline = Outline::octagon(width).unwrap();
        let found = planned(&hall(), &setup(outline.clone(), cell));
        println!(
            "octagon of {width} m, cells of {cell} m: {} subgoals, {} collisions, {} resolved, {:.1} m, coverage {:.4} by links, \
             {:.4} with {} strokes more",
            found.subgoals.len(),
            found.collisions,
            found.resolved,
            found.length,
            found.linked_share,
            found.coverage,
            found.finish.len()
        );
        assert!(found.collisions > 0 && found.collisions == found.resolved);
        assert!(told.is_none_or(|told| found.collisions == told), "{}", found.collisions);
        assert!(found.linked_share > 0.975 && found.coverage > 0.985, "{}", found.coverage);
        assert_eq!(found.links.len() + 1, found.subgoals.len());
        // Section 3: the first entry is LEFT_WALL, in the upper left.
        assert_eq!((found.subgoals[0].contact, found.subgoals[0].line), (LineEndContact::LeftWall, 0));
        assert_eq!(found.path[0], found.subgoals[0].at);
        // Seven as in Fig. 2: the stage counts though it stands against the wall.
        let numbers: std::collections::BTreeSet<u32> = found.subgoals.iter().filter_map(|s| s.obstacle).collect();
        assert!(numbers.into_iter().eq(1..=7));
        // Section 3: scan lines half the robot's width apart, in whole cells.
        let (top, low) = (&found.subgoals[0], found.subgoals.iter().max_by_key(|subgoal| subgoal.line).unwrap());
        let apart = (top.at.y - low.at.y) / f64::from(low.line);
        assert!(apart <= 0.5 * width + 1e-9 && apart > 0.5 * width - cell, "{apart} m");
        // Section 4: every point once.
        let mut linked: Vec<usize> = found.links.iter().map(|link| link.to).collect();
        linked.push(0);
        linked.sort_unstable();
        assert!(linked.into_iter().eq(0..found.subgoals.len()));
        let motion = Motion::new(&hall(), &outline, CLEARANCE).unwrap();
        for subgoal in &found.subgoals {
            // It touches: a micrometre on it would overlap.
            let on = Vector::new(if subgoal.contact.is_left() { -1e-6 } else { 1e-6 }, 0.0);
            assert!(motion.is_free(subgoal.at, subgoal.at), "{subgoal:?}");
            assert!(!motion.is_free(subgoal.at, subgoal.at + on), "{subgoal:?}");
        }
        for link in &found.links {
            let (from, to) = (found.subgoals[link.from].at, found.subgoals[link.to].at);
            assert!((link.way[0] - from).norm() < 1e-9 && (link.way[link.way.len() - 1] - to).norm() < 1e-9);
        }
        // See `crates/coverage-planners/tests/sweep` for a check that shares nothing with the planner.
        assert!(found.path.windows(2).all(|piece| motion.is_free(piece[0], piece[1])));
    }
}

#[test]
fn the_robot_starts_where_it_is_and_goes_to_the_nearest_point() {
    let mut how = setup(Outline::circle(0.17).unwrap(), 0.1);
    how.start = Some(Pose::new(10.03, 4.0, 1.0));
    let found = planned(&hall(), &how);
    assert_eq!(found.path[0], Point::new(10.03, 4.0));
    assert!(found.collisions == found.resolved && found.coverage > 0.98);
    // In an obstacle: at the nearest place beside it.
    how.start = Some(Pose::new(5.0, 15.0, 0.0));
    assert!((planned(&hall(), &how).path[0] - Point::new(5.0, 15.0)).norm() < 1.5);
}

#[test]
fn what_cannot_be_reached_is_left_out() {
    // Two rooms without a door.
    let plan = Sketch::open(6.0, 3.0, 0.05).fill(&[[2.0, 0.0, 2.1, 3.0]]).finish("", "");
    let mut how = setup(Outline::circle(0.17).unwrap(), 0.05);
    let found = planned(&plan, &how);
    assert!(found.subgoals.iter().all(|s| s.at.x > 2.0) && found.coverage > 0.99, "the larger one");
    how.start = Some(Pose::new(1.0, 1.0, 0.0));
    assert!(planned(&plan, &how).subgoals.iter().all(|s| s.at.x < 2.0));
}

#[test]
fn contacts_tell_walls_from_obstacles() {
    let mut plan = Sketch::open(4.0, 3.0, 0.1).finish("", "");
    plan.objects.push(Object::Leg { at: Point::new(2.0, 1.5), radius: 0.25 });
    let found = planned(&plan, &setup(Outline::circle(0.15).unwrap(), 0.1));
    // The line nearest to the leg's middle: it stops 0.4 m from that, less the height.
    let solid: Vec<_> = found.subgoals.iter().filter(|s| s.obstacle.is_some()).collect();
    assert!(solid.iter().all(|s| s.obstacle == Some(1)) && solid.len() >= 4);
    for s in solid {
        assert!(((s.at - Point::new(2.0, 1.5)).norm() - 0.4 - CLEARANCE).abs() < 1e-6, "{s:?}");
        assert_eq!(s.contact == LineEndContact::RightObstacle, s.at.x < 2.0);
    }
    assert!(
        found
            .subgoals
            .iter()
            .any(|s| s.contact == LineEndContact::RightWall && (s.at.x - 3.85 + CLEARANCE).abs() < 1e-6)
    );
}

#[test]
fn bad_numbers_are_refused_and_cancelling_is_honoured() {
    let plan = hall();
    let error = |how: &SweepSetup| sweep(&plan, how, &mut |_| ControlFlow::Continue(())).unwrap_err();
    let good = setup(Outline::octagon(0.36).unwrap(), 0.1);
    for cell in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(error(&SweepSetup { cell, ..good.clone() }), SweepError::Value { .. }));
    }
    let thin = Outline::circle(0.02).unwrap();
    let message = error(&SweepSetup { outline: thin, ..good.clone() }).to_string();
    assert!(message.contains("at most the distance between scan lines, 0.020 m"), "{message}");
    for width in [0.0, f64::NAN, 1e9] {
        let scan_width = Some(width);
        assert!(matches!(error(&SweepSetup { scan_width, ..good.clone() }), SweepError::Value { .. }));
    }
    let start = Some(Pose { x: f64::NAN, y: 1.0, heading: 0.0 });
    assert!(matches!(error(&SweepSetup { start, ..good.clone() }), SweepError::Value { .. }));
    let outline = Outline::Polygon(vec![Point::origin(); 3]);
    assert!(matches!(error(&SweepSetup { outline, ..good.clone() }), SweepError::Cspace(CspaceError::Outline(_))));
    let outline = Outline::octagon(9.0).unwrap();
    assert!(matches!(error(&SweepSetup { outline, ..good.clone() }), SweepError::FitsNowhere { .. }));
    let cell = 0.001;
    assert!(matches!(error(&SweepSetup { cell, ..good.clone() }), SweepError::Cspace(CspaceError::TooLarge { .. })));
    let mut last = 0.0;
    let mut told = Vec::new();
    let mut observe = |done: f64| {
        assert!((last..=1.0).contains(&done));
        last = done;
        told.push(done);
        ControlFlow::Continue(())
    };
    sweep(&plan, &good, &mut observe).unwrap();
    assert!(last == 1.0);
    for stop in 0..told.len() {
        let mut calls = 0;
        let mut observe = |_: f64| {
            calls += 1;
            if calls > stop { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        assert_eq!(sweep(&plan, &good, &mut observe).unwrap_err(), SweepError::Cancelled);
        assert_eq!(calls, stop + 1);
    }
}

/// A desk whose lower edge lies between two lines: what the links leave under it is swept by a stroke of its own.
#[test]
fn edges_between_the_lines_are_swept_at_the_end() {
    let plan = Sketch::open(4.0, 4.0, 0.05).fill(&[[1.0, 2.1, 3.0, 2.75]]).finish("", "");
    let found = planned(&plan, &setup(Outline::rectangle(0.4, 0.4).unwrap(), 0.05));
    assert!(found.linked_share < 0.995 && found.coverage > 0.999, "{} {}", found.linked_share, found.coverage);
    assert!((1..4).contains(&found.finish.len()), "{:?}", found.finish);
    let last = &found.finish[found.finish.len() - 1];
    assert_eq!(found.path[found.path.len() - 1], last[last.len() - 1]);
}

#[test]
fn overlays_are_in_drawing_units() {
    let found = planned(&hall(), &setup(Outline::octagon(1.0).unwrap(), 0.1));
    // A drawing in millimetres.
    let layers = overlays(&found, |at| Point::from(Vector::new(5000.0, -1000.0) + at.coords / 0.001));
    let names: Vec<&str> = layers.iter().map(|layer| layer.layer.as_str()).collect();
    assert_eq!(names, ["SWEEP_SUBGOALS", "SWEEP_LINKS", "SWEEP_PATH", "SWEEP_FINISH"]);
    assert_eq!(layers[3].lines.len(), found.finish.len());
    assert_eq!(layers[0].lines.len(), 2 * found.subgoals.len());
    assert_eq!(layers[1].lines.len(), found.links.len());
    let first = layers[2].lines[0][0];
    let expected = Point::new(5000.0 + found.path[0].x * 1000.0, -1000.0 + found.path[0].y * 1000.0);
    assert!((first - expected).norm() < 1e-6);
}

/// The bytes for a Roomba, sent at their times to the emulated one on bare floor: it comes by every corner and ends
/// where the path does.
#[test]
fn emulated_roomba_follows_its_commands() {
    let plan = Sketch::open(6.0, 4.0, 0.05).start(1.0, 1.0, 0.0).finish("Hall", "");
    let roomba = model("roomba600").unwrap();
    let path = [(1.0, 1.0), (3.5, 1.0), (3.5, 1.2), (0.9, 1.25), (0.9, 3.0), (5.0, 1.4), (5.02, 3.4), (2.0, 3.4)]
        .map(|(x, y)| Point::new(x, y));
    let list = commands(&path, 0.0, roomba);
    let (robot, cell_size) = choose_robot("roomba600", &plan, None).unwrap();
    let placement = Placement { plan, robot, cells: cell_size.into(), start: None, heading_deg: None };
    for quantised in [false, true] {
        let conditions = Conditions { quantised, ..Conditions::default() };
        let run = placement.prepare().unwrap().setup(conditions, 7);
        let mut emulator = Emulator::new(&run, personality("model").unwrap());
        let from = emulator.pose().position() - path[0];
        let mut nearest = [f64::MAX; 8];
        for command in &list {
            assert!((emulator.time_s() - command.at_s).abs() < 1e-6);
            emulator.receive(&command.bytes, 115_200);
            let pieces = (command.wait_s / 0.01).ceil().max(1.0);
            for _ in 0..pieces as u32 {
                emulator.advance(command.wait_s / pieces);
                let at = emulator.pose().position() - from;
                for (nearest, corner) in nearest.iter_mut().zip(&path) {
                    *nearest = nearest.min((at - corner).norm());
                }
            }
        }
        let end = (emulator.pose().position() - from - path[7]).norm();
        println!("nearest to the corners {nearest:.3?} m, off the end by {end:.3} m");
        assert!(end < 0.03 && nearest.iter().all(|&off| off < 0.03), "{end} {nearest:?}");
        assert_eq!(emulator.mode(), roomba_oi::Mode::Off);
    }
}
