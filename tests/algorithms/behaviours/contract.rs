//! What every behaviour holds to, over the registry.

use super::support::{conditions, drive, lay_out, run, run_with};
use robovac_core::{
    floor_plan::{ROOMS, Sketch, room},
    registry::{ParamKind, ParamValue, Params},
    robot::{Body, MODELS, RobotModel, model},
};
use robovac_sim::{
    NoiseLevel, Run, RunSetup,
    controller::{self, BEHAVIOURS, BehaviourInfo},
};

/// Whether no wall is in the largest circle around the origin that fits into the body; a millimetre is forgiven.
fn is_outside_walls(robot: &RobotModel, run: &Run) -> bool {
    let inner = match robot.body {
        Body::Round => robot.radius,
        Body::Polygon(corners) => {
            let edges = corners.iter().zip(corners.iter().cycle().skip(1));
            edges.map(|(a, b)| (a[0] * b[1] - a[1] * b[0]) / (b[0] - a[0]).hypot(b[1] - a[1])).fold(f64::MAX, f64::min)
        }
    };
    run.floor().walls.has_room(run.pose().position(), inner - 0.001)
}

/// Whether the robot has the sensors without which the behaviour does nothing.
fn has_what_it_needs(info: &BehaviourInfo, robot: &RobotModel) -> bool {
    !info.claims.needs_laser || robot.sensors.laser.is_some()
}

/// Half a minute of each behaviour in each room, with every `stride`th of the robots that fit; of those that it can do
/// something with, unless it's each of them.
fn nobody_enters_a_wall(stride: usize) {
    for (place, room) in ROOMS.iter().enumerate() {
        let plan = (room.build)();
        let fit = |(number, robot)| Some((number, lay_out(&plan, robot, conditions(NoiseLevel::Typical))?));
        let setups: Vec<(usize, RunSetup)> = MODELS.iter().copied().enumerate().filter_map(fit).collect();
        for (kind, info) in BEHAVIOURS.iter().enumerate() {
            let suits = |setup: &RunSetup| stride == 1 || has_what_it_needs(info, &setup.robot);
            let suited: Vec<_> = setups.iter().filter(|(_, setup)| suits(setup)).collect();
            assert!(!suited.is_empty(), "no robot for {} fits into {}", info.id, room.id);
            let stride = stride.min(suited.len());
            // Another robot for each behaviour, and for the same one in the next room.
            for (number, setup) in suited.iter().skip((place + kind) % stride).step_by(stride) {
                let robot = &setup.robot;
                let mut run = run(setup, info, *number as u64);
                for _ in 0..10 {
                    drive(&mut run, 0.05);
                    let what = format!("{} with {} in {} after {} s", info.id, robot.id, room.id, run.time_s());
                    assert!(is_outside_walls(&setup.robot, &run), "{what}: in a wall at {}", run.pose());
                    assert!(!run.activity().is_empty(), "{what}: no activity");
                }
                let is_still = info.claims.manual || info.claims.ends;
                // Where chance decides, it may have a robot turn and turn.
                let least = if info.claims.explores { 0.05 } else { 0.5 };
                assert!(
                    is_still || run.distance_m() > least,
                    "{} with {} in {}: {} m",
                    info.id,
                    robot.id,
                    room.id,
                    run.distance_m()
                );
            }
        }
    }
}

// slow: the contract, every behaviour in every room; each with every robot is the soak's
#[test]
fn nobody_enters_a_wall_and_everybody_says_what_it_does() {
    nobody_enters_a_wall(3);
}

#[test]
#[ignore = "soak: every behaviour with every robot in every room"]
fn nobody_enters_a_wall_with_any_robot_in_any_room() {
    nobody_enters_a_wall(1);
}

#[test]
fn the_same_seed_gives_the_same_run_and_another_seed_another_one() {
    let plan = (room("room12ft").expect("it ships").build)();
    let setup =
        lay_out(&plan, model("roomba600").expect("it ships"), conditions(NoiseLevel::Typical)).expect("it fits");
    for info in BEHAVIOURS {
        let digest = |seed| {
            let mut run = run(&setup, info, seed);
            drive(&mut run, 3.0);
            run.digest()
        };
        assert_eq!(digest(1), digest(1), "{}", info.id);
        assert!(
            info.claims.manual || info.claims.needs_laser || digest(1) != digest(2),
            "{} drives the same way with every seed",
            info.id
        );
    }
}

#[test]
fn a_copy_of_a_run_goes_on_the_same_way() {
    let plan = (room("room12ft").expect("it ships").build)();
    let setup =
        lay_out(&plan, model("roomba600").expect("it ships"), conditions(NoiseLevel::Typical)).expect("it fits");
    for info in BEHAVIOURS {
        let mut run = run(&setup, info, 5);
        drive(&mut run, 1.23);
        let mut copy = run.clone();
        drive(&mut run, 1.0);
        drive(&mut copy, 1.0);
        assert_eq!(run.digest(), copy.digest(), "{}", info.id);
    }
}

// slow: a run for each value of each parameter
#[test]
fn every_value_at_the_end_of_its_range_works() {
    let plan = (room("clutter").expect("it ships").build)();
    let setup =
        lay_out(&plan, model("roomba600").expect("it ships"), conditions(NoiseLevel::Typical)).expect("it fits");
    for info in BEHAVIOURS {
        for spec in info.params {
            let values: Vec<ParamValue> = match spec.kind {
                ParamKind::Number { min, max, .. } => vec![ParamValue::Number(min), ParamValue::Number(max)],
                ParamKind::Choice { options } => options.iter().map(|o| ParamValue::Choice(o.0.to_owned())).collect(),
                ParamKind::Flag { .. } => vec![ParamValue::Flag(false), ParamValue::Flag(true)],
            };
            for value in values {
                let what = format!("{} with {} = {value}", info.id, spec.id);
                let params = Params::checked(info.params, [(spec.id, value)]).expect("it is in range");
                let mut run = run_with(&setup, info, &params, 3);
                drive(&mut run, 3.0);
                assert!(is_outside_walls(&setup.robot, &run), "{what}");
                assert!(
                    !info.claims.cleans || !has_what_it_needs(info, &setup.robot) || run.distance_m() > 1.0,
                    "{what}: only {} m",
                    run.distance_m()
                );
            }
        }
    }
}

// slow: a quarter of an hour of every behaviour with every robot
#[test]
fn those_that_clean_clean_an_open_room() {
    let plan = Sketch::open(3.5, 3.0, 0.05).start(1.0, 1.0, 20.0).finish("open", "");
    for robot in MODELS {
        let setup = lay_out(&plan, robot, conditions(NoiseLevel::Typical)).expect("it fits");
        for info in BEHAVIOURS.iter().filter(|info| info.claims.cleans && has_what_it_needs(info, robot)) {
            let mut run = run(&setup, info, 7);
            // Walls alone are about a third of the room.
            let least = if info.claims.walls_only { 0.18 } else { 0.55 };
            for _ in 0..15 {
                drive(&mut run, 1.0);
                // Who may end needn't go on.
                if info.claims.ends && run.coverage() > least {
                    break;
                }
            }
            assert!(run.coverage() > least, "{} with {}: {}", info.id, robot.id, run.coverage());
            assert!(!run.is_finished() || info.claims.ends, "{} claims to go on", info.id);
        }
    }
}

#[test]
fn everybody_is_found_by_id() {
    for info in BEHAVIOURS {
        assert!(controller::find(info.id).is_some_and(|found| found.title == info.title), "{}", info.id);
    }
}

/// A row a behaviour, in the order of the menus.
#[test]
fn documentation_lists_all_behaviours() {
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/behaviours.md")).expect("it exists");
    let listed = page.lines().filter_map(|line| line.strip_prefix("| `")?.split('`').next());
    assert_eq!(
        listed.collect::<Vec<_>>(),
        BEHAVIOURS.iter().map(|info| info.id).collect::<Vec<_>>(),
        "rows of docs/behaviours.md, and behaviours in the order of `registry!`"
    );
}

/// The DVR-1's bumper is narrow: in a corner it once felt only the nearer wall, beside it, and pushed for ever.
#[test]
fn nobody_jams_in_a_corner() {
    let plan = Sketch::open(3.5, 3.0, 0.05).start(1.0, 1.0, 20.0).finish("open", "");
    for robot in MODELS {
        let setup = lay_out(&plan, robot, conditions(NoiseLevel::Off)).expect("it fits");
        for info in BEHAVIOURS.iter().filter(|info| info.claims.cleans && has_what_it_needs(info, robot)) {
            let mut run = run(&setup, info, 1);
            for minute in 1..=5 {
                let before = run.distance_m();
                drive(&mut run, 1.0);
                let way = run.distance_m() - before;
                assert!(way > 2.0 || run.is_finished(), "{} with {}: {way} m in minute {minute}", info.id, robot.id);
            }
        }
    }
}

/// Behind a cupboard of the office the `CBot`, twice as long as wide, once turned against both sides for ever.
#[test]
fn a_long_body_comes_out_of_where_it_can_not_turn() {
    let sides = [[0.0, 0.0, 0.8, 0.8], [0.0, 1.2, 0.8, 2.0]];
    let plan = Sketch::open(3.0, 2.0, 0.05).fill(&sides).start(1.5, 1.0, 180.0).finish("niche", "");
    let setup = lay_out(&plan, model("cbot").expect("it is in the registry"), conditions(NoiseLevel::Typical))
        .expect("it fits");
    for id in ["wall_follow", "bounce", "random_walk"] {
        let info = controller::find(id).expect("it is in the registry");
        for seed in 0..4 {
            let mut run = run(&setup, info, seed);
            let mut comes = |is_there: fn(f64) -> bool| {
                (0..300).any(|_| {
                    drive(&mut run, 1.0 / 60.0);
                    is_there(run.pose().x)
                })
            };
            assert!(comes(|x| x < 0.4), "{id} {seed}: it wasn't in the niche");
            assert!(comes(|x| x > 1.1), "{id} {seed}: it is still in the niche");
        }
    }
}
