//! The figures that 002 (Hasan, Al-Nahid & Reza 2014) prints.

use super::{
    stairs::rooms,
    support::{conditions, drive, lay_out, run_with},
};
use robovac_core::{
    floor_plan::Sketch,
    geometry::normalize,
    registry::{ParamValue, Params},
    robot::{MODELS, model},
};
use robovac_sim::{
    NoiseLevel, Run,
    controller::{Timing, find},
};

/// The robot of section IV.A: r = 4 cm, R = 12 cm, N = 1.2 a second, L = 14.5 cm.
const DVR_1: Timing = Timing { wheel_radius: 0.04, half_base: 0.12, turns_per_s: 1.2, lane: 0.145 };

/// Whether `value` is printed as `printed` when cut or rounded to its number of decimals.
fn is_printed(value: f64, printed: &str) -> bool {
    let decimals = printed.split_once('.').map_or(0, |(_, d)| d.len());
    let scale = 10_f64.powi(decimals as i32);
    let printed: f64 = printed.parse().unwrap();
    (value - printed).abs() < 1e-9 + 0.5 / scale || (value * scale).floor() / scale == printed
}

#[test]
fn section_iv_a_i_corner_escape() {
    let least = DVR_1.corner_escape_s(120.0);
    assert!((least - 12.0 * 120.0 / (720.0 * 4.0 * 1.2)).abs() < 1e-12, "R theta / (720 r N)");
    assert!(is_printed(least, "0.41") && (0.41..0.42).contains(&least), "{least}");
    // "Time for 360 degrees = R / (r N)", and the least time turns by half of the bumper's angle.
    assert!((DVR_1.full_turn_s() - 2.5).abs() < 1e-12);
    assert!((360.0 * least / DVR_1.full_turn_s() - 60.0).abs() < 1e-12);
}

#[test]
fn section_iv_a_iii_back_turn_go() {
    assert!(is_printed(DVR_1.back_s(), "0.16"), "{}", DVR_1.back_s());
    assert!(is_printed(DVR_1.turn_s(), "0.625"), "{}", DVR_1.turn_s());
    assert!(is_printed(DVR_1.go_s(), "0.48"), "{}", DVR_1.go_s());
    // Back is L / 3 and go is L at the speed of the wheels.
    let speed = 2.0 * std::f64::consts::PI * DVR_1.wheel_radius * DVR_1.turns_per_s;
    assert!((DVR_1.back_s() * speed - 0.145 / 3.0).abs() < 1e-12 && (DVR_1.go_s() * speed - 0.145).abs() < 1e-12);
}

/// Distance back, m, and direction in which it goes on, in degrees off the old one, of DVR-1 after it has met a wall head-on.
fn after_the_first_bump(by: &str) -> [f64; 2] {
    let plan = Sketch::open(3.0, 3.0, 0.05).start(1.0, 1.5, 0.0).finish("open", "");
    let setup = lay_out(&plan, model("dvr1").unwrap(), conditions(NoiseLevel::Off)).unwrap();
    let info = find("s_path").unwrap();
    let params = Params::checked(info.params, [("by", ParamValue::Choice(by.to_owned()))]).unwrap();
    let mut run = run_with(&setup, info, &params, 1);
    let mut until = |is_there: &dyn Fn(&Run) -> bool| {
        while !is_there(&run) {
            assert!(run.time_s() < 60.0, "{by}: {}", run.activity());
            run.step();
        }
        run.pose()
    };
    let wall = until(&|run| run.activity() == "backing up");
    // On the spot, a turn leaves the distance to the wall as it is.
    let turned = until(&|run| run.activity() == "driving a short distance");
    let aside = until(&|run| run.activity().starts_with("turning"));
    [wall.x - turned.x, (aside.heading - wall.heading).to_degrees().abs()]
}

/// The formulas take wheels to be at full speed at once. DVR-1's need 0.38 s to stop alone, so that 0.16 s of "back" end
/// at the wall, and the turn begins there.
#[test]
fn printed_times_leave_the_robot_at_the_wall() {
    let [[timed, turn], [printed, other]] = ["time", "printed"].map(after_the_first_bump);
    println!("by time {timed:.4} m, {turn:.1}°; as printed {printed:.4} m, {other:.1}°");
    assert!((timed - 0.145 / 3.0).abs() < 0.01 && (turn - 90.0).abs() < 5.0);
    assert!(printed.abs() < 0.01);
}

/// "90° turn (right/left), go, 90° turn": both to one side, and to the other one at the next wall, as in Fig. 11.
#[test]
fn section_iv_a_iii_sides_alternate() {
    let plan = Sketch::open(3.0, 3.0, 0.05).start(1.0, 1.5, 0.0).finish("open", "");
    let setup = lay_out(&plan, model("dvr1").unwrap(), conditions(NoiseLevel::Off)).unwrap();
    let info = find("s_path").unwrap();
    let mut run = run_with(&setup, info, &Params::defaults(info.params), 1);
    let mut until = |activity: &str| {
        while !run.activity().starts_with(activity) {
            assert!(run.time_s() < 120.0, "{activity}: {}", run.activity());
            run.step();
        }
        run.pose().heading
    };
    // When a motion begins, the robot still turns a little from the one before.
    let turns = [(); 4].map(|()| {
        let [wall, aside] = ["backing up", "driving a short distance"].map(&mut until);
        let lane = until("driving a lane");
        [wall, normalize(aside - wall).to_degrees(), normalize(lane - aside).to_degrees()]
    });
    for (index, [_, first, second]) in turns.into_iter().enumerate() {
        let side = if index % 2 == 0 { 1.0 } else { -1.0 };
        assert!((60.0..100.0).contains(&(side * first)) && (60.0..100.0).contains(&(side * second)), "{turns:?}");
    }
    for pair in turns.windows(2) {
        assert!(normalize(pair[1][0] - pair[0][0]).to_degrees().abs() > 175.0, "lanes aren't parallel: {turns:?}");
    }
}

/// Switched motors or not, the cliff sensors are heeded.
// slow: rooms with stairs, harsh wheels
#[test]
fn printed_times_do_not_lead_over_an_edge() {
    let info = find("s_path").unwrap();
    let params = Params::checked(info.params, [("by", ParamValue::Choice("printed".to_owned()))]).unwrap();
    for plan in rooms() {
        for robot in MODELS.iter().filter(|robot| robot.sensors.cliffs.iter().any(Option::is_some)) {
            let Some(setup) = lay_out(&plan, robot, conditions(NoiseLevel::Harsh)) else { continue };
            let mut run = run_with(&setup, info, &params, 5);
            drive(&mut run, 4.0);
            assert!(!run.has_fallen(), "{} in {}", robot.id, plan.name);
        }
    }
}
