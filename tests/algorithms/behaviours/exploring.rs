//! How much of a room those that explore get to know.

use super::support::{conditions, lay_out, run_with};
use robovac_core::{
    coverage::{Boundary, BoundaryTracker},
    floor_plan::{FloorPlan, Object, Sketch, Who, room},
    geometry::{Point, Pose, difference},
    registry::{ParamValue, Params},
    robot::model,
};
use robovac_sim::{
    NoiseLevel, Run,
    controller::{self, BEHAVIOURS},
};
use std::sync::Arc;

/// The subject of Image 7.1.
fn closed_loop() -> FloorPlan {
    (room("closed_loop").expect("it ships").build)()
}

/// A run of a behaviour that explores, with what it has met.
struct Explored {
    run: Run,
    tracker: BoundaryTracker,
}

impl Explored {
    fn new(plan: &FloorPlan, id: &str, given: &[(&str, &str)], noise: NoiseLevel, seed: u64) -> Self {
        let robot = model("roomba600").expect("it ships");
        let info = controller::find(id).expect("it is in the registry");
        let value = |word: &str| match word {
            "yes" | "no" => ParamValue::Flag(word == "yes"),
            _ => ParamValue::Choice(word.to_owned()),
        };
        let given = given.iter().map(|&(id, word)| (id, value(word)));
        let params = Params::checked(info.params, given).expect("they are choices and flags");
        let setup = lay_out(plan, robot, conditions(noise)).expect("it fits");
        let tracker = BoundaryTracker::new(&Arc::new(Boundary::new(&setup.floor, robot)));
        Self { run: run_with(&setup, info, &params, seed), tracker }
    }

    /// Goes on for some minutes; returns the share of the boundary that it has met.
    fn explore(&mut self, minutes: f64) -> f64 {
        let end = self.run.time_s() + 60.0 * minutes;
        while self.run.time_s() < end && !self.run.is_finished() {
            self.run.step();
            self.tracker.update(self.run.pose(), self.run.sensors());
        }
        self.tracker.share()
    }

    /// Poses, ten a second, on the way through some minutes.
    fn poses(&mut self, minutes: f64) -> Vec<Pose> {
        let record = |_| {
            self.explore(0.1 / 60.0);
            self.run.pose()
        };
        (0..(600.0 * minutes) as u32).map(record).collect()
    }
}

/// Whether two poses are the same but for 6 cm and 6 degrees: what a robot drives in a fifth of a second.
fn is_same(a: &Pose, b: &Pose) -> bool {
    (a.position() - b.position()).norm() < 0.06 && difference(a.heading, b.heading).abs() < 0.1
}

#[test]
fn phase_5_goes_round_the_closed_loop_for_ever() {
    for direction in ["left", "right"] {
        let given = [("direction", direction)];
        let mut explored = Explored::new(&closed_loop(), "explore_until_obstacle", &given, NoiseLevel::Off, 1);
        let soon = explored.explore(20.0);
        let loop_ = explored.poses(5.0);
        // The motion has become periodic: half an hour later it is nowhere where it wasn't before.
        explored.explore(30.0);
        let later = explored.poses(2.0);
        let new = later.iter().filter(|pose| !loop_.iter().any(|known| is_same(pose, known))).count();
        assert!(new * 50 < later.len(), "{direction}: {new} of {} poses are new", later.len());
        let share = explored.explore(30.0);
        assert!(
            share < 0.2 && share < soon + 0.02,
            "{direction}: {soon} after 20 min, {share} after an hour and a half"
        );
    }
}

#[test]
fn edge_following_completes_the_closed_loop() {
    for noise in [NoiseLevel::Off, NoiseLevel::Typical] {
        for text in ["mended", "printed"] {
            for seed in 1..4 {
                let mut explored = Explored::new(&closed_loop(), "explore_edge", &[("text", text)], noise, seed);
                let share = explored.explore(12.0);
                assert!(share >= 0.9, "{text}, {noise:?}, seed {seed}: {share}");
            }
        }
    }
}

/// What each of them knows of a bare room after ten minutes.
#[test]
fn everybody_who_explores_gets_to_know_a_room() {
    let plan = Sketch::open(3.0, 2.5, 0.05).start(1.5, 1.2, 20.0).finish("open", "");
    for info in BEHAVIOURS.iter().filter(|info| info.claims.explores) {
        let mut explored = Explored::new(&plan, info.id, &[], NoiseLevel::Typical, 1);
        let share = explored.explore(10.0);
        println!("{}: {share}", info.id);
        assert!(share > 0.3, "{}: {share}", info.id);
    }
}

/// A run of the frontier explorer in one of the rooms that ship.
fn frontier(id: &str, given: &[(&str, &str)], seed: u64) -> Explored {
    let plan = (room(id).expect("it ships").build)();
    Explored::new(&plan, "explore_frontier", given, NoiseLevel::Typical, seed)
}

// slow: half an hour of mapping; no less meets all of these rooms
#[test]
fn the_frontier_explorer_meets_what_there_is_to_be_met() {
    for (id, minutes) in [("tshape", 6.0), ("kitchen", 8.0), ("maze", 11.0)] {
        let share = frontier(id, &[], 2).explore(minutes);
        assert!(share > 0.9, "{id}: {share}");
    }
}

/// How long it takes depends on how much of what it senses its map understands.
#[test]
fn the_frontier_explorer_knows_when_its_map_is_complete() {
    for home in ["no", "yes"] {
        let mut explored = frontier("room12ft", &[("home", home)], 2);
        let share = explored.explore(40.0);
        assert!(explored.run.is_finished(), "{}", explored.run.activity());
        assert!(share > 0.95, "{share}");
        assert!(explored.run.mapper().is_some_and(|mapper| mapper.map().bounds().is_some()));
    }
}

#[test]
fn the_frontier_explorer_maps_by_odometry_alone_as_well() {
    let share = frontier("kitchen", &[("tracking", "odometry")], 1).explore(12.0);
    assert!(share > 0.8, "{share}");
}

/// People who walk about stand in its way, and leave feet on its map where none are any more.
#[test]
fn the_frontier_explorer_copes_with_people() {
    let mut plan = (room("living").expect("it ships").build)();
    let walk = |x: f64, y: f64| Point::new(x, y);
    let (width, height) = (plan.width_m(), plan.height_m());
    let path =
        vec![walk(0.3 * width, 0.35 * height), walk(0.7 * width, 0.35 * height), walk(0.5 * width, 0.7 * height)];
    plan.objects.push(Object::Mover { who: Who::Person, path });
    let mut explored = Explored::new(&plan, "explore_frontier", &[], NoiseLevel::Typical, 4);
    let share = explored.explore(20.0);
    assert!(share > 0.85, "{share}");
}
