//! The rooms that the texts of the behaviours name, held to a table of measurements: tests/golden/behaviours.txt.
//!
//! `UPDATE=1 cargo test --release --test algorithms -- --ignored every_behaviour_in_every_room` measures all of it again,
//! `UPDATE=new` only what isn't in it yet, such as a new behaviour or room.

use super::support::{conditions, lay_out_from, run};
use coverage_planners::{PlanContext, find};
use rand::RngExt;
use robovac_core::{
    floor_plan::{FloorPlan, Object, ROOMS, RoomInfo, RoomKind, room},
    geometry::Pose,
    math,
    registry::{Explainer, Params},
    rng::seeded,
    robot::{OdometryModel, model},
};
use robovac_sim::{
    NoiseLevel,
    controller::{self, BEHAVIOURS, BehaviourClaims, BehaviourInfo, explainer},
    experiment::{Algorithm, Entrant, planning::RoomSetup},
    montecarlo::{Lab, Terms, quantile},
};
use std::{
    collections::BTreeMap,
    fmt::Write,
    fs,
    sync::{
        Mutex,
        atomic::{AtomicUsize, Ordering},
    },
    thread,
};

const TABLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/behaviours.txt");
const HEAD: &str = "\
# Behaviours of a Roomba 600 with typical slip and noise in 20 minutes; medians of 10 runs (seeds 1 to 10).
# Those that clean: swept share of the reachable floor, %. Those that explore: detected share of the boundary, %.
# dock: share of the 20 minutes that is left when the robot is home, from random places, %; - without a dock.
# manual, for which somebody drives: metres between two turns of the lanes of boustrophedon.
# online_snake, which needs a laser scanner: a Roomba 600 with one on top.
# UPDATE=1 cargo test --release --test algorithms -- --ignored every_behaviour_in_every_room writes it.
";
const MEASURE_NEW: &str = "UPDATE=new cargo test --test algorithms -- --ignored every_behaviour_in_every_room";
const MINUTES: f64 = 20.0;
const SEEDS: u64 = 10;
/// Stream of the random places from which robots go home.
const PLACES: u64 = 78;

/// Numbers by room and behaviour; higher is better. `None` where there is nothing to measure.
type Table = BTreeMap<(String, String), Option<f64>>;

/// One entry of the table.
fn measure(room: &RoomInfo, info: &BehaviourInfo) -> Option<f64> {
    let plan = (room.build)();
    let robot = model(if info.claims.needs_laser { "roomba600_lidar" } else { "roomba600" }).expect("it ships");
    if info.claims.manual {
        let job = RoomSetup::new(&plan, robot, robot.default_cell, None).expect("it fits").job;
        let lanes = find("boustrophedon").expect("it is in the registry");
        let path = lanes.build(&Params::defaults(lanes.params)).plan(&job, &mut PlanContext::new(1));
        let metrics = coverage_planners::metrics::WalkMetrics::of(&job, &path.expect("nobody cancels"));
        return Some(metrics.steps as f64 * robot.default_cell / (metrics.turns as f64).max(1.0));
    }
    let mut values: Vec<f64> = if info.id == "dock" {
        plan.objects.iter().find(|object| matches!(object, Object::Dock { .. }))?;
        (1..=SEEDS).map(|seed| time_left_at_home(&plan, info, seed)).collect()
    } else {
        let conditions = conditions(NoiseLevel::Typical);
        let odometry = OdometryModel::default();
        let terms = Terms { conditions, odometry, smooth: false, duration_s: 60.0 * MINUTES, plan_seed: 1 };
        let lab = Lab::new(&plan, robot, robot.default_cell, None, terms).expect("it fits");
        let entrant = Entrant::new(Algorithm::Behaviour(controller::find(info.id).expect("it is in the registry")));
        (1..=SEEDS).filter_map(|seed| lab.run(&entrant, seed)).map(|outcome| 100.0 * outcome.coverage()).collect()
    };
    values.sort_by(f64::total_cmp);
    quantile(&values, 0.5)
}

/// From a random place; 0 if the robot isn't home in time.
fn time_left_at_home(plan: &FloorPlan, info: &BehaviourInfo, seed: u64) -> f64 {
    let mut rng = seeded(seed, PLACES);
    let mut random = |most: f64| rng.random_range(0.0..most);
    let pose = Pose::new(random(plan.width_m()), random(plan.height_m()), random(math::TAU));
    let robot = model("roomba600").expect("it ships");
    let setup = lay_out_from(plan, robot, conditions(NoiseLevel::Typical), pose).expect("it fits");
    let mut run = run(&setup, info, seed);
    while !run.is_finished() && run.time_s() < 60.0 * MINUTES {
        run.step();
    }
    100.0 * (1.0 - run.time_s() / (60.0 * MINUTES)).max(0.0)
}

/// Rooms that are measured: offices and halls are too large for 20 minutes; one hall stands for them.
fn rooms() -> impl Iterator<Item = &'static RoomInfo> {
    let is_measured =
        |room: &&RoomInfo| !matches!(room.kind, RoomKind::Office | RoomKind::Large) || room.id == "hall20";
    ROOMS.iter().copied().filter(is_measured)
}

/// The entries of the table that aren't in `known`, on all cores.
fn measure_all(known: &Table) -> Table {
    let is_new = |&(room, info): &(&RoomInfo, &BehaviourInfo)| !known.contains_key(&key(room.id, info.id));
    let cells: Vec<(&RoomInfo, &BehaviourInfo)> =
        rooms().flat_map(|room| behaviours().map(move |info| (room, info))).filter(is_new).collect();
    let (next, table) = (AtomicUsize::new(0), Mutex::new(known.clone()));
    let work = || {
        while let Some((room, info)) = cells.get(next.fetch_add(1, Ordering::Relaxed)) {
            let value = measure(room, info);
            table.lock().expect("nobody panics").insert(key(room.id, info.id), value);
        }
    };
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
    });
    table.into_inner().expect("nobody panics")
}

fn key(room: &str, behaviour: &str) -> (String, String) {
    (room.to_owned(), behaviour.to_owned())
}

fn behaviours() -> impl Iterator<Item = &'static BehaviourInfo> {
    BEHAVIOURS.iter().copied()
}

fn to_text(table: &Table) -> String {
    let mut text = format!("{HEAD}{:11}", "room");
    for info in behaviours() {
        let _ = write!(text, " {}", info.id);
    }
    for room in rooms() {
        let _ = write!(text, "\n{:11}", room.id);
        for info in behaviours() {
            let value = table.get(&key(room.id, info.id)).copied().flatten();
            let cell = value.map_or("-".to_owned(), |value| format!("{value:.1}"));
            let _ = write!(text, " {cell:>width$}", width = info.id.len());
        }
    }
    text + "\n"
}

fn table() -> Table {
    let text = fs::read_to_string(TABLE).expect("it can be read");
    let mut lines = text.lines().filter(|line| !line.starts_with('#')).map(str::split_whitespace);
    let behaviours: Vec<&str> = lines.next().into_iter().flatten().skip(1).collect();
    let mut table = Table::new();
    for mut cells in lines {
        let room = cells.next().expect("a line begins with the room");
        table.extend(behaviours.iter().zip(cells).map(|(id, cell)| (key(room, id), cell.parse().ok())));
    }
    table
}

/// What a behaviour does in each room, compared with the best of the others of its kind there.
struct Standing<'a> {
    table: &'a Table,
    info: &'a BehaviourInfo,
}

impl Standing<'_> {
    fn value(&self, room: &str, id: &str) -> Option<f64> {
        self.table.get(&key(room, id)).copied().flatten()
    }

    /// What the others of its kind do; without a laser scanner, those that have none.
    fn others(&self, room: &str) -> Vec<f64> {
        let kind = |info: &BehaviourInfo| (info.claims.cleans, info.claims.explores);
        let BehaviourClaims { cleans, explores, needs_laser, .. } = self.info.claims;
        let is_fair = |other: &BehaviourInfo| needs_laser || !other.claims.needs_laser;
        let is_peer = |other: &&BehaviourInfo| {
            (cleans || explores) && kind(other) == kind(self.info) && is_fair(other) && other.id != self.info.id
        };
        behaviours().filter(is_peer).filter_map(|other| self.value(room, other.id)).collect()
    }

    /// What it does there for each of what the best of the others does; for those without peers, what it does.
    fn ratio(&self, room: &str) -> Option<f64> {
        let best = self.others(room).into_iter().reduce(f64::max).unwrap_or(100.0);
        Some(self.value(room, self.info.id)? / best.max(1e-9))
    }

    /// Shares of the other rooms in which it does better, and worse.
    fn rank(&self, room: &str) -> Option<[f64; 2]> {
        let own = self.ratio(room)?;
        let elsewhere: Vec<f64> =
            ROOMS.iter().filter(|other| other.id != room).filter_map(|other| self.ratio(other.id)).collect();
        let share = |is: &dyn Fn(f64) -> bool| {
            elsewhere.iter().filter(|&&other| is(other)).count() as f64 / elsewhere.len().max(1) as f64
        };
        Some([share(&|other| other > own), share(&|other| other < own)])
    }
}

/// Where a behaviour is said to work well it does better than in two thirds of the other rooms, and worse where it is said to
/// work poorly; and what the texts say of other behaviours is so.
#[test]
fn behaviours_work_well_and_poorly_where_they_say() {
    let table = table();
    let mut wrong = String::new();
    for info in behaviours() {
        let standing = Standing { table: &table, info };
        let Explainer { shines, fails, .. } = explainer(info.id).expect("it is listed");
        let mut expect = |holds: Option<bool>, what: &str| {
            if holds != Some(true) {
                let _ = writeln!(wrong, "{}: {what}", info.id);
            }
        };
        if rooms().all(|room| !table.contains_key(&key(room.id, info.id))) {
            expect(None, &format!("isn't measured: `{MEASURE_NEW}`"));
            continue;
        }
        // Places among the rooms: 0 is the best, or the worst.
        for (example, name, place) in [(shines, "shines", 0), (fails, "fails", 1)] {
            let fits = |room: &str| standing.rank(room).map(|ranks| ranks[place] < 0.34);
            let fitting: Vec<&str> = rooms().map(|room| room.id).filter(|room| fits(room) == Some(true)).collect();
            expect(fits(example.room), &format!("`{name}` names {}; these would do: {fitting:?}", example.room));
        }
        let ratios = standing.ratio(shines.room).zip(standing.ratio(fails.room));
        expect(
            ratios.map(|(best, worst)| best > 1.05 * worst),
            &format!("hardly better where it works well: {ratios:?}"),
        );
        for example in [shines, fails] {
            let own = standing.value(example.room, info.id);
            let values = standing.others(example.room);
            if example.why.contains("more than any other") {
                expect(
                    own.map(|own| values.iter().all(|&other| other <= own)),
                    &format!("not the best in {}", example.room),
                );
            }
            if example.why.contains("less than any other") {
                expect(
                    own.map(|own| values.iter().all(|&other| other >= own)),
                    &format!("not the last in {}", example.room),
                );
            }
        }
    }
    assert_eq!(wrong, "", "by tests/golden/behaviours.txt");
    // "In most rooms it cleans as much as the best of the four, or more."
    let cycle = Standing { table: &table, info: controller::find("cleaning_cycle").expect("it is in the registry") };
    let best_of_four = |room: &str| {
        let four = ["random_walk", "spiral_out", "s_path", "wall_follow"];
        four.iter().filter_map(|id| cycle.value(room, id)).reduce(f64::max)
    };
    let ratio = |room: &str| Some(cycle.value(room, "cleaning_cycle")? / best_of_four(room)?);
    let ratios: Vec<f64> = ROOMS.iter().filter_map(|room| ratio(room.id)).collect();
    assert!(2 * ratios.iter().filter(|&&ratio| ratio > 0.95).count() > ratios.len(), "{ratios:?}");
}

/// The table is what comes out today: one entry of each kind.
// slow: ten runs of twenty minutes each
#[test]
fn the_table_is_what_is_measured() {
    let table = table();
    for (room_id, id) in
        [("tshape", "bounce"), ("empty", "explore_until_obstacle"), ("maze", "manual"), ("thesis8", "online_snake")]
    {
        let value = measure(room(room_id).expect("it ships"), controller::find(id).expect("it is in the registry"));
        let [now, then] = [value, table[&key(room_id, id)]].map(|value| value.map(|value| format!("{value:.1}")));
        assert_eq!(now, then, "{id} in {room_id}: UPDATE=1 measures the table again");
    }
}

#[test]
#[ignore = "soak: all behaviours in all rooms"]
fn every_behaviour_in_every_room() {
    let update = std::env::var("UPDATE").unwrap_or_default();
    let known = if update == "new" { table() } else { Table::new() };
    let text = to_text(&measure_all(&known));
    if update.is_empty() {
        assert_eq!(text, fs::read_to_string(TABLE).expect("it can be read"), "UPDATE=1 writes the table again");
    } else {
        fs::write(TABLE, text).expect("it can be written");
    }
}
