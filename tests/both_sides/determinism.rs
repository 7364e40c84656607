//! The same seed gives the same run, natively and in WebAssembly, to the last bit.

use coverage_planners::PLANNERS;
use robovac_app::explore::Session;
use robovac_core::{
    coverage::ReachableFloor,
    floor_plan::room,
    registry::{ParamValue, Params},
    robot::{OdometryModel, model},
};
use robovac_link::{
    connection::{Connection, Request},
    emulator::{Emulator, personality},
};
use robovac_sim::{
    Conditions, Noise, NoiseLevel, Run, RunSetup, SlipLevel, World,
    controller::{self, Setup},
    experiment::planning::RoomSetup,
    mapping::{MapObserver, Mapper, MapperSetup, Tracking},
};
use std::sync::Arc;
use wasm_bindgen_test::wasm_bindgen_test;
#[cfg(target_arch = "wasm32")]
wasm_bindgen_test::wasm_bindgen_test_configure!(run_in_browser);

/// Digest of everything that a run of `seconds` leaves behind.
fn digest(link: &str, seconds: f64) -> u64 {
    let mut session = Session::new();
    session.restore(link).unwrap();
    session.plan_now(|| 0.0);
    session.run_ahead(seconds);
    session.recording().unwrap().run().digest()
}

/// Half an hour in the flat, with slipping wheels. If a change is meant to alter runs, commit the new number.
#[wasm_bindgen_test(unsupported = test)]
fn furnished_flat_with_slip() {
    assert_eq!(
        format!("{:016x}", digest("room=flat&planner=boustrophedon&slip=typical&seed=42", 1800.0)),
        "6007faa23a5d9cfc"
    );
}

/// The snake, with contact all the time: wheels that slip harshly.
#[wasm_bindgen_test(unsupported = test)]
fn twelve_foot_room_with_harsh_slip() {
    assert_eq!(format!("{:016x}", digest("room=room12ft&planner=snake&slip=harsh&seed=7", 1800.0)), "4661b563d000e9be");
}

/// Everything that errs, moves and is used up: a robot that reacts, in a room with a pet, a carpet, dirt and a dock.
#[wasm_bindgen_test(unsupported = test)]
fn cleaning_cycle_among_people_and_noise() {
    let link = "room=living&behaviour=cleaning_cycle&slip=typical&noise=typical&seed=3";
    assert_eq!(format!("{:016x}", digest(link, 900.0)), "6d33487270465f2a");
}

/// A polygon with a laser scanner.
#[wasm_bindgen_test(unsupported = test)]
fn rectangular_robot_by_stairs() {
    let link = "room=stairs&behaviour=bounce&robot=cbot&slip=harsh&noise=harsh&quantised=true&seed=4";
    assert_eq!(format!("{:016x}", digest(link, 300.0)), "9ef3774bb4a9a31c");
}

/// The two ends of the thesis' strategy, by chance and rule by rule, in a room with an island.
#[wasm_bindgen_test(unsupported = test)]
fn exploring_a_kitchen() {
    let link = |phase| format!("room=kitchen&behaviour=explore_{phase}&slip=typical&noise=typical&seed=5");
    let digests = ["look_around", "edge"].map(|phase| format!("{:016x}", digest(&link(phase), 600.0)));
    assert_eq!(digests, ["0ad98d998eb65dfd", "511b76edeadcb830"]);
}

/// A minute at the two ends of a bad line: every byte, and its time.
#[wasm_bindgen_test(unsupported = test)]
fn ride_over_a_bad_line() {
    let robot = model("roomba600").unwrap();
    let prepared = RoomSetup::new(&(room("living").unwrap().build)(), robot, 0.25, None).unwrap();
    let mut emulator = Emulator::new(&prepared.setup(Conditions::default(), 3), personality("noisy").unwrap());
    let mut link = Connection::new();
    link.opened(0.0);
    let mut bytes = Vec::new();
    for look in 0..12_000 {
        let now = f64::from(look) * 0.005;
        emulator.advance(0.005);
        emulator.transmit(115_200, &mut bytes);
        link.feed(now, &std::mem::take(&mut bytes));
        link.beat(now);
        link.tick(now);
        emulator.receive(&link.take_tx(), 115_200);
        if look == 400 {
            link.request(now, Request::Arm { full: false }).unwrap();
        }
        if look == 600 {
            let info = controller::find("bounce").unwrap();
            let controller = info.build(&Setup { robot, params: &Params::defaults(info.params), seed: 1 }).unwrap();
            link.ride(now, info.title, controller, prepared.floor.start, false).unwrap();
        }
    }
    assert!(link.view(60.0).distance_m > 5.0);
    // FNV-1a over the recording.
    let digest = link
        .recording()
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
    assert_eq!(format!("{digest:016x}"), "479bbf48f4627f31");
}

/// Every planner finds the same path on both sides: no float of a planner may depend on the machine.
///
/// `UPDATE=1 cargo test --test both_sides walks` writes the digests, for a new planner or after an intended change.
#[wasm_bindgen_test(unsupported = test)]
fn walks_of_all_planners() {
    let known = include_str!("../golden/walks.txt");
    let mut digests = String::new();
    for info in PLANNERS {
        for room in ["room12ft", "slanted"] {
            let mut session = Session::new();
            session.restore(&format!("room={room}&planner={}&robot=roomba600&seed=5", info.id)).unwrap();
            let mut request = session.take_plan_request().unwrap();
            // Those that go on as long as one lets them are let for a moment: browsers don't wait for tests.
            if let Some(effort) = info.effort().filter(|_| info.is_anytime() || info.is_in_metres()) {
                request.params.set(info.params, effort.id, ParamValue::Number(0.1)).unwrap();
            }
            let path = request.serve(|| 0.0, None).unwrap().path;
            // FNV-1a over the cells, or over the corners of a path in metres.
            let cells = path.cells.iter().flat_map(|cell| [cell.x.to_le_bytes(), cell.y.to_le_bytes()]).flatten();
            let corners = path.line.iter().flat_map(|at| [at.x.to_le_bytes(), at.y.to_le_bytes()]).flatten();
            let bytes = cells.chain(corners);
            let digest = bytes.fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
                (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
            });
            digests.extend([info.id, " ", room, &format!(" {} {digest:016x}\n", path.cells.len() + path.line.len())]);
        }
    }
    #[cfg(not(target_arch = "wasm32"))]
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/walks.txt"), &digests).unwrap();
        return;
    }
    let new: String = digests.split_inclusive('\n').filter(|line| !known.contains(line)).collect();
    assert_eq!(new, "", "these lines aren't in tests/golden/walks.txt; UPDATE=1 writes them");
    assert_eq!(digests, known, "tests/golden/walks.txt has another order, or lines of planners that are gone");
}

/// Five minutes of mapping with correction, with its looking again: the pose and every cell.
#[wasm_bindgen_test(unsupported = test)]
fn map_of_a_bedroom() {
    let (plan, robot) = ((room("bedroom").unwrap().build)(), model("roomba600").unwrap().clone());
    let floor = Arc::new(ReachableFloor::new(&plan, &robot, None).unwrap());
    let info = controller::find("bounce").unwrap();
    let params = Params::defaults(info.params);
    let behaviour = info.build(&Setup { robot: &robot, params: &params, seed: 5 }).unwrap();
    let (start, tracking, odometry) = (floor.start, Tracking::Corrected, OdometryModel::Arc);
    let mapper = Mapper::new(MapperSetup { robot: robot.clone(), start, tracking, odometry, seed: 5 });
    let noise = Noise::all(NoiseLevel::Typical);
    let conditions = Conditions { slip: SlipLevel::Typical, noise, ..Conditions::default() };
    let setup = RunSetup { floor, world: Arc::new(World::new(&plan)), robot, conditions, seed: 5 };
    let mut run = Run::new(&setup, behaviour).observed(Box::new(MapObserver::default().with_mapper(mapper)));
    while run.time_s() < 300.0 {
        run.step();
    }
    let mapper = run.mapper().unwrap();
    let pose = mapper.pose();
    let cells = mapper.map().iter().flat_map(|(cell, odds)| [cell.x as u64, cell.y as u64, odds.to_bits()]);
    let words = [pose.x, pose.y, pose.heading].map(f64::to_bits).into_iter().chain(cells);
    let digest = words.fold(0xcbf2_9ce4_8422_2325_u64, |hash, word| (hash ^ word).wrapping_mul(0x0100_0000_01b3));
    assert_eq!(format!("{digest:016x}"), "94ec9ba049efd3de");
}
