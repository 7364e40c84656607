//! Numbers for people who choose defaults; run with `--ignored --nocapture`.

use crate::support::{conditions, lay_out, run};
use robovac_playground::{
    controller::BEHAVIOURS,
    floorplan::{ROOMS, room},
    robot::{MODELS, model},
    sim::NoiseLevel,
};

/// Minutes to a share of the floor; infinite if it wasn't reached in time.
fn minutes_to(run: &mut robovac_playground::sim::Run, share: f64, most: f64) -> f64 {
    while run.coverage() < share && run.time_s() < 60.0 * most {
        for _ in 0..20 {
            run.step();
        }
    }
    if run.coverage() >= share { run.time_s() / 60.0 } else { f64::INFINITY }
}

fn setting(name: &str, default: &str) -> String {
    std::env::var(name).unwrap_or_else(|_| default.to_owned())
}

#[test]
#[ignore = "measures, tests nothing"]
fn minutes_to_ninety_percent() {
    let (room_id, only, seeds) = (setting("ROOM", "room12ft"), setting("ONLY", ""), setting("SEEDS", "30"));
    let seeds: u64 = seeds.parse().unwrap();
    for robot in setting("ROBOT", "roomba600").split(',').map(|id| model(id).unwrap()) {
        let plan = (room(&room_id).unwrap().build)();
        let setup = lay_out(&plan, robot, conditions(NoiseLevel::Typical)).unwrap();
        for info in BEHAVIOURS.iter().filter(|b| b.claims.cleans && b.id.contains(&only)) {
            let mut minutes: Vec<f64> = (0..seeds).map(|s| minutes_to(&mut run(&setup, info, s), 0.9, 120.0)).collect();
            minutes.sort_by(f64::total_cmp);
            let at = |share: f64| minutes[((minutes.len() - 1) as f64 * share).round() as usize];
            println!(
                "{:10} {room_id:10} {:14} median {:6.1} (10-90 %: {:.1} - {:.1})",
                robot.id,
                info.id,
                at(0.5),
                at(0.1),
                at(0.9)
            );
        }
    }
}

#[test]
#[ignore = "measures, tests nothing"]
fn coverage_of_all_rooms() {
    let minutes: f64 = setting("MINUTES", "20").parse().unwrap();
    let only = setting("ONLY", "");
    for robot in MODELS {
        if !setting("ROBOT", "roomba600").contains(robot.id) {
            continue;
        }
        for room in ROOMS {
            let Some(setup) = lay_out(&(room.build)(), robot, conditions(NoiseLevel::Typical)) else { continue };
            print!("{:10} {:10}", robot.id, room.id);
            for info in BEHAVIOURS.iter().filter(|b| b.claims.cleans && b.id.contains(&only)) {
                let mut run = run(&setup, info, 1);
                crate::support::drive(&mut run, minutes);
                print!("  {} {:3.0}", info.id, 100.0 * run.coverage());
            }
            println!();
        }
    }
}

#[test]
#[ignore = "shows what happens"]
fn diary() {
    let plan = (room(&setting("ROOM", "empty")).unwrap().build)();
    let robot = model(&setting("ROBOT", "roomba600")).unwrap();
    let setup = lay_out(&plan, robot, conditions(NoiseLevel::Typical)).unwrap();
    let info = robovac_playground::controller::find(&setting("ONLY", "s_path")).unwrap();
    let mut run = run(&setup, info, 1);
    let mut last = "";
    while run.time_s() < 60.0 * setting("MINUTES", "2").parse::<f64>().unwrap() {
        run.step();
        if run.activity() != last {
            last = run.activity();
            println!(
                "{:7.2} {:20} {} {:?}",
                run.time_s(),
                last,
                run.pose(),
                (run.sensors().bump_left, run.sensors().bump_right, run.sensors().cliff, run.sensors().virtual_wall)
            );
        }
    }
}

#[test]
#[ignore = "measures, tests nothing"]
fn distance_from_the_wall() {
    let plan = (room(&setting("ROOM", "empty")).unwrap().build)();
    for robot in MODELS {
        for noise in [NoiseLevel::Off, NoiseLevel::Typical, NoiseLevel::Harsh] {
            let Some(setup) = lay_out(&plan, robot, conditions(noise)) else { continue };
            let mut run = run(&setup, robovac_playground::controller::find("wall_follow").unwrap(), 1);
            let (mut near, mut steps) = ([0; 4], 0);
            crate::support::drive(&mut run, 2.0);
            let bumps = run.bumps();
            while run.time_s() < 600.0 {
                run.step();
                let walls = &run.floor().walls;
                let gap =
                    walls.nearest(run.pose().position(), robot.radius + 0.15).map_or(0.2, |(_, d)| d - robot.radius);
                for (count, limit) in near.iter_mut().zip([0.02, 0.04, 0.06, 0.1]) {
                    *count += u32::from(gap < limit);
                }
                steps += 1;
            }
            let shares = near.map(|n| format!("{:.0} %", 100.0 * f64::from(n) / f64::from(steps)));
            println!(
                "{:10} {noise:?}: nearer than 2, 4, 6, 10 cm: {shares:?}, {} bumps, {:.0} m, coverage {:.2}",
                robot.id,
                run.bumps() - bumps,
                run.distance_m(),
                run.coverage()
            );
        }
    }
}
