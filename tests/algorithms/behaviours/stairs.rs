//! No robot falls down the stairs, in any room, with any noise.

use super::support::{conditions, lay_out, run_with, starting_from};
use rand::RngExt;
use robovac_core::{
    floor_plan::{FloorPlan, Object, Sketch},
    geometry::{Point, Pose},
    math,
    registry::{ParamValue, Params},
    rng::{Rng, seeded},
    robot::MODELS,
};
use robovac_sim::{
    Input, NoiseLevel, Run, RunSetup,
    controller::{BEHAVIOURS, Joystick},
};

/// 3 m x 2.5 m with a drop-off of these corners.
fn room(name: &str, outline: &[(f64, f64)]) -> FloorPlan {
    let mut plan = Sketch::open(3.0, 2.5, 0.05).disc(0.9, 1.7, 0.1).start(0.6, 0.6, 0.0).finish(name, "");
    plan.objects.push(Object::DropOff { outline: outline.iter().map(|&(x, y)| Point::new(x, y)).collect() });
    plan
}

/// Stairs along a wall, a hole in the floor, a slanted edge across a corner, and a spit of floor between two edges.
pub fn rooms() -> Vec<FloorPlan> {
    let mut spit = room("spit", &[(1.6, 0.0), (3.0, 0.0), (3.0, 0.95), (1.6, 0.95)]);
    let upper = [(1.6, 1.55), (3.0, 1.55), (3.0, 2.5), (1.6, 2.5)];
    spit.objects.push(Object::DropOff { outline: upper.iter().map(|&(x, y)| Point::new(x, y)).collect() });
    vec![
        room("along the wall", &[(2.3, 0.0), (3.0, 0.0), (3.0, 2.5), (2.3, 2.5)]),
        room("hole", &[(1.5, 0.9), (2.1, 0.8), (2.2, 1.5), (1.6, 1.6)]),
        room("corner", &[(3.0, 0.6), (3.0, 2.5), (1.2, 2.5)]),
        spit,
    ]
}

/// Random joystick commands near stairs.
fn play(run: &mut Run, rng: &mut Rng, backward: bool) {
    let least = if backward { -1.0 } else { 0.0 };
    let command = Joystick { forward: rng.random_range(least..1.0), left: rng.random_range(-1.0..1.0) };
    run.apply(Input::Command(command));
}

/// Drives all behaviours with all robots in all of these rooms; returns those that fell, or had a wheel over an edge,
/// with the places.
fn falls(seeds: std::ops::Range<u64>, minutes: f64) -> (u32, Vec<String>, Vec<String>) {
    let (mut runs, mut fallen, mut wheels) = (0, Vec::new(), Vec::new());
    for plan in rooms() {
        for robot in MODELS.iter().filter(|robot| robot.sensors.cliffs.iter().any(Option::is_some)) {
            let Some(laid_out) = lay_out(&plan, robot, conditions(NoiseLevel::Typical)) else { continue };
            for info in BEHAVIOURS {
                for seed in seeds.clone() {
                    let mut rng = seeded(seed, 78);
                    let level = [NoiseLevel::Typical, NoiseLevel::Harsh][(seed % 2) as usize];
                    let mut random = |most: f64| rng.random_range(0.0..most);
                    let pose = Pose::new(random(3.0), random(2.5), random(math::TAU));
                    let setup = RunSetup { conditions: conditions(level), ..starting_from(&laid_out, pose) };
                    let careful = seed % 4 < 2;
                    let mut params = Params::defaults(info.params);
                    if info.claims.manual {
                        params.set(info.params, "careful", ParamValue::Flag(careful)).expect("it is a flag");
                    }
                    let mut run = run_with(&setup, info, &params, seed);
                    let mut wheel = None;
                    while run.time_s() < 60.0 * minutes && !run.is_finished() && !run.has_fallen() {
                        if info.claims.manual && run.steps().is_multiple_of(100) {
                            play(&mut run, &mut rng, careful);
                        }
                        run.step();
                        let half = 0.5 * robot.wheel_base;
                        let is_over = |y: f64| setup.world.is_drop_off(run.pose().to_world(Point::new(0.0, y)));
                        if wheel.is_none() && (is_over(half) || is_over(-half)) {
                            wheel = Some(run.time_s());
                        }
                    }
                    runs += 1;
                    let what = format!(
                        "{} {} {} seed {seed} {level:?}: {:.2} s {} {}",
                        plan.name,
                        robot.id,
                        info.id,
                        wheel.unwrap_or_default(),
                        run.pose(),
                        run.activity()
                    );
                    if run.has_fallen() {
                        fallen.push(what.clone());
                    }
                    // A person can turn a robot on the spot beside an edge that its sensors don't look at.
                    if wheel.is_some() && !info.claims.manual {
                        wheels.push(what);
                    }
                }
            }
        }
    }
    (runs, fallen, wheels)
}

// slow: the contract of drop-offs, every behaviour with every robot; more seeds and minutes are the soak's
#[test]
fn nobody_falls_down_the_stairs() {
    let (runs, fallen, wheels) = falls(0..2, 1.0);
    assert!(runs > 250, "only {runs} runs");
    assert!(fallen.is_empty(), "{} of {runs}:\n{}", fallen.len(), fallen.join("\n"));
    assert!(wheels.is_empty(), "{} of {runs} have a wheel over the edge:\n{}", wheels.len(), wheels.join("\n"));
}

#[test]
#[ignore = "soak: many seeds"]
fn nobody_falls_down_the_stairs_with_many_seeds() {
    let number = |name: &str, default: u64| std::env::var(name).ok().and_then(|n| n.parse().ok()).unwrap_or(default);
    let seeds = number("SEEDS", 50);
    let (runs, fallen, wheels) = falls(100..100 + seeds, number("MINUTES", 10) as f64);
    println!("{runs} runs, {} fell, {} had a wheel over the edge", fallen.len(), wheels.len());
    println!("fell:\n{}\nwheel over the edge:\n{}", fallen.join("\n"), wheels.join("\n"));
    assert!(fallen.is_empty() && wheels.is_empty());
}
