//! Home by the beams.

use super::support::{conditions, lay_out, lay_out_from, run_with};
use rand::RngExt;
use robovac_core::{
    floor_plan::{FloorPlan, Object, Sketch},
    geometry::Pose,
    math,
    registry::{ParamValue, Params},
    rng::seeded,
    robot::model,
};
use robovac_sim::{
    Conditions, NoiseLevel, Run, RunSetup,
    controller::{self, BehaviourInfo},
};

/// A furnished room of 4 m x 3 m with a dock in the middle of its lower wall.
pub fn room_with_dock() -> FloorPlan {
    let sketch = Sketch::open(4.0, 3.0, 0.05).fill(&[[0.0, 2.2, 0.9, 3.0], [3.4, 0.0, 4.0, 0.8]]).disc(2.6, 2.2, 0.2);
    let mut plan = sketch.start(1.0, 1.5, 0.0).finish("dock", "");
    plan.objects.push(Object::Dock { pose: Pose::new(1.8, 0.0, math::FRAC_PI_2) });
    plan
}

fn behaviour(id: &str) -> &'static BehaviourInfo {
    controller::find(id).expect("it is in the registry")
}

/// From a random place, seconds to the dock; `None` if it takes more than `minutes`.
fn seconds_home(plan: &FloorPlan, level: NoiseLevel, seed: u64, minutes: f64) -> Option<f64> {
    let mut rng = seeded(seed, 77);
    let mut random = |most: f64| rng.random_range(0.0..most);
    let pose = Pose::new(random(plan.width_m()), random(plan.height_m()), random(math::TAU));
    let setup = lay_out_from(plan, model("roomba600").expect("it ships"), conditions(level), pose)?;
    let info = behaviour("dock");
    let mut run = run_with(&setup, info, &Params::defaults(info.params), seed);
    while !run.is_finished() && run.time_s() < 60.0 * minutes {
        run.step();
    }
    assert!(!run.is_finished() || run.sensors().battery.on_dock, "done without being charged");
    run.is_finished().then(|| run.time_s())
}

#[test]
fn most_robots_come_home_within_a_quarter_of_an_hour() {
    for (level, least) in [(NoiseLevel::Off, 36), (NoiseLevel::Typical, 36), (NoiseLevel::Harsh, 32)] {
        let mut seconds: Vec<f64> =
            (0..40).filter_map(|seed| seconds_home(&room_with_dock(), level, seed, 15.0)).collect();
        seconds.sort_by(f64::total_cmp);
        let median = seconds.get(seconds.len() / 2);
        println!("{level:?}: {} of 40 home, median {median:?} s, last {:?} s", seconds.len(), seconds.last());
        assert!(seconds.len() >= least, "{level:?}: {} of 40 home", seconds.len());
    }
}

fn low_battery(plan: &FloorPlan, percent: u8) -> RunSetup {
    let conditions = Conditions { start_charge_percent: percent, ..conditions(NoiseLevel::Typical) };
    lay_out(plan, model("roomba600").expect("it ships"), conditions).expect("it fits")
}

fn step_until(run: &mut Run, minutes: f64, mut is_so: impl FnMut(&Run) -> bool) -> bool {
    let end = run.time_s() + 60.0 * minutes;
    while run.time_s() < end && !run.is_finished() {
        run.step();
        if is_so(run) {
            return true;
        }
    }
    false
}

#[test]
fn cleaning_robots_go_home_are_charged_and_go_on() {
    for id in ["random_walk", "cleaning_cycle"] {
        let info = behaviour(id);
        let given = [("home_at", ParamValue::Number(15.0)), ("leave_at", ParamValue::Number(20.0))];
        let params = Params::checked(info.params, given).expect("they are in range");
        let mut run = run_with(&low_battery(&room_with_dock(), 17), info, &params, 3);
        assert!(step_until(&mut run, 5.0, |run| run.activity() == "searching for the dock"), "{id} cleans on");
        assert!(step_until(&mut run, 15.0, |run| run.activity() == "charging"), "{id} doesn't get home");
        let place = run.pose().position();
        assert!(step_until(&mut run, 60.0, |run| run.activity() == "leaving the dock"), "{id} stays at home");
        assert!((run.pose().position() - place).norm() < 0.02, "{id} doesn't stand still on its dock");
        assert!(run.sensors().battery.share() >= 0.199);
        let distance = run.distance_m();
        step_until(&mut run, 2.0, |_| false);
        assert!(run.distance_m() > distance + 5.0 && !run.sensors().battery.on_dock, "{id} doesn't go on");
    }
}

#[test]
fn nobody_goes_home_who_is_told_not_to() {
    let info = behaviour("random_walk");
    let params = Params::checked(info.params, [("home_at", ParamValue::Number(0.0))]).expect("it is in range");
    let mut run = run_with(&low_battery(&room_with_dock(), 10), info, &params, 3);
    assert!(!step_until(&mut run, 2.0, |run| run.activity() == "searching for the dock"));
}
