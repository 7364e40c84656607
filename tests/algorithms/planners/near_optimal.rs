//! What `near_optimal` says it has proven, against the best walks there are.

use super::bounds::{best, jobs};
use coverage_planners::{CoverageJob, Finish, Objective, PlanContext, find, stage::Costs};
use rand::RngExt;
use robovac_core::{
    grid::{Direction, picture},
    registry::{ParamValue, Params},
    rng::seeded,
};

/// The objective: where walks end, and the steps that a quarter turn counts as, 0 for the robot's time.
type Asked = (Finish, f64);

const ASKED: [Asked; 8] = [
    (Finish::Anywhere, 0.0),
    (Finish::Start, 0.0),
    (Finish::Anywhere, 2.0),
    (Finish::Start, 2.0),
    (Finish::Anywhere, 50.0),
    (Finish::Start, 50.0),
    (Finish::Anywhere, 0.5),
    (Finish::Start, 64.0),
];

/// The weights that the planner is to use.
fn objective_of(job: &CoverageJob, (finish, turn): Asked) -> Objective {
    let is_timed = turn == 0.0;
    let turn = if is_timed { job.turn_s / job.step_s } else { turn };
    let Costs { step, turn } = Costs::of(&CoverageJob { step_s: 1.0, turn_s: turn, ..job.clone() });
    Objective { step, turn, finish, counts_first_turn: is_timed && finish == Finish::Anywhere }
}

/// Plans and checks what is proven; whether the walk is proven to be the best.
fn is_proven(job: &CoverageJob, asked: Asked, seed: u64) -> bool {
    let (finish, turn) = asked;
    let finish = if finish == Finish::Start { "start" } else { "anywhere" };
    let info = find("near_optimal").unwrap();
    let mut params = Params::defaults(info.params);
    params.set(info.params, "turn", ParamValue::Number(turn)).unwrap();
    params.set(info.params, "finish", ParamValue::Choice(finish.to_owned())).unwrap();
    let mut ctx = PlanContext::new(seed);
    let path = info.build(&params).plan(job, &mut ctx).unwrap();
    let objective = objective_of(job, asked);
    let cost = objective.of_walk(job, &path.cells);
    let least = best(job, objective) as u64;
    let what = || {
        let room = picture(&job.free, |&free| if free { '.' } else { '#' });
        format!("{asked:?} from {} {:?} in\n{room}\nby {:?}", job.start, job.heading, path.cells)
    };
    assert!(path.visits(job).iter().all(|(cell, &visits)| visits > 0 || !job.free[cell]), "misses some: {}", what());
    path.check(job).unwrap_or_else(|error| panic!("{error} {}", what()));
    let is_closed = path.cells.first() == path.cells.last();
    assert!(is_closed || objective.finish == Finish::Anywhere, "not closed: {}", what());
    if job.cells() < 2 {
        return true;
    }
    let proof = ctx.proof.unwrap();
    assert_eq!(proof.cost, cost, "the cost of {}", what());
    assert!(proof.bound <= least, "{proof:?} is above {least} for {}", what());
    assert!(cost >= least, "{cost} is below {least} for {}", what());
    cost == proof.bound
}

/// Plans in some jobs with a random heading and robot; how many there are and how many are proven.
fn proven(jobs: impl Iterator<Item = CoverageJob>, seed: u64) -> [usize; 2] {
    let (mut rng, mut count, mut proven) = (seeded(seed, 1), 0, 0);
    for mut job in jobs {
        job.heading = Direction::ALL[rng.random_range(0..4)];
        job.turn_s = f64::from(rng.random_range(0..7)) * 0.7;
        let asked = ASKED[rng.random_range(0..ASKED.len())];
        count += 1;
        proven += usize::from(is_proven(&job, asked, rng.random()));
    }
    [count, proven]
}

// slow: each proof is checked against all walks that there are
#[test]
fn what_is_proven_of_small_rooms_is_true() {
    let mut rng = seeded(9, 0);
    let mut bits = |cells: u32| rng.random_range(1..1 << cells) | rng.random_range(0..1 << cells);
    let small = (0..40).map(|_| bits(9)).collect::<Vec<_>>().into_iter().flat_map(|bits| jobs(3, 3, bits).step_by(3));
    let flat = (0..20).map(|_| bits(10)).collect::<Vec<_>>().into_iter().flat_map(|bits| jobs(5, 2, bits).step_by(4));
    let narrow = (1..8).flat_map(|cells| jobs(1, cells, (1 << cells) - 1)).step_by(3);
    let [count, proven] = proven(small.chain(flat).chain(narrow), 9);
    println!("{proven} of {count} proven");
    // Walks through so small a room are all tried.
    assert_eq!(proven, count);
}
