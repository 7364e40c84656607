//! Rooms that ship and map files that come in.

use robovac_playground::{
    coverage::ReachableFloor,
    floorplan::{FloorPlan, MAX_SIDE, ROOMS, room},
    robot::{RobotModel, cell_robot, model},
};
use std::collections::HashSet;

/// Share of the free floor that a robot can sweep.
fn reachable_share(plan: &FloorPlan, robot: &RobotModel) -> f64 {
    let floor = ReachableFloor::new(plan, robot, None).unwrap_or_else(|e| panic!("{}: {e}", plan.name));
    let free = plan.occupancy.values().iter().filter(|o| o.is_free()).count();
    floor.area() / (free as f64 * plan.resolution * plan.resolution)
}

#[test]
fn rooms_are_unique_and_described() {
    let ids: HashSet<_> = ROOMS.iter().map(|room| room.id).collect();
    let titles: HashSet<_> = ROOMS.iter().map(|room| room.title).collect();
    assert_eq!((ids.len(), titles.len()), (ROOMS.len(), ROOMS.len()));
    for info in ROOMS {
        assert!(info.note.starts_with("Good for ") && info.note.ends_with('.') && info.note.len() < 110, "{}", info.id);
        let plan = (room(info.id).unwrap().build)();
        assert_eq!((plan.name.as_str(), plan.note.as_str()), (info.title, info.note));
        assert!(plan.occupancy.width() <= MAX_SIDE && plan.occupancy.height() <= MAX_SIDE);
        assert!(plan.start.is_some(), "{} has no start", info.id);
        assert_eq!(plan, (info.build)(), "{} differs from one time to the next", info.id);
    }
    assert!(room("nowhere").is_none());
}

#[test]
fn cell_robot_reaches_every_free_cell_of_every_room() {
    for info in ROOMS {
        let plan = (info.build)();
        let share = reachable_share(&plan, &cell_robot(plan.resolution));
        assert!((share - 1.0).abs() < 1e-9, "{}: {share}", info.id);
    }
}

#[test]
fn roomba_fits_and_reaches_most_of_every_room() {
    let roomba = model("roomba600").unwrap();
    for info in ROOMS {
        let plan = (info.build)();
        let start = plan.start.unwrap();
        let floor = ReachableFloor::new(&plan, roomba, None).unwrap();
        // It keeps 9 cm of floor along every wall unswept; that is much of a room of 1.6 m or of a maze.
        let least = if matches!(info.id, "thesis8" | "maze") { 0.5 } else { 0.7 };
        let share = reachable_share(&plan, roomba);
        println!("{} {:.1} % of {:.1} m2", info.id, 100.0 * share, floor.area() / share);
        assert!(share > least, "{}: {share}", info.id);
        if plan.resolution < 0.2 {
            assert_eq!(floor.start, start, "{}: the Roomba doesn't fit at the start", info.id);
        }
    }
}

#[test]
fn thesis_preset_is_the_printed_one() {
    let plan = (room("thesis8").unwrap().build)();
    let picture = robovac_playground::grid::picture(&plan.occupancy, |o| if o.is_free() { '.' } else { '#' });
    let expected = ["...##...\n".repeat(3), "........\n".repeat(3), "##......\n".repeat(2)].concat();
    assert_eq!(picture, expected);
    assert_eq!((plan.start.unwrap().x, plan.start.unwrap().y, plan.start.unwrap().heading), (0.1, 1.5, 0.0));
}
