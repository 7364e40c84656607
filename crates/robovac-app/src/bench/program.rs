//! Benchmarks of users' programs: what the simulation beside them takes, and the repetition of their logs.

use super::Bench;
use crate::explore::Session;
use robovac_sim::{
    Run,
    program::{Lockstep, Logged, SharedLog},
};

/// Simulated time, s: half an hour.
const SIMULATED_S: f64 = 1800.0;
/// Places of these readings: flags of the bumper, and the time.
const BUMPS: [usize; 2] = [7, 8];
const TIME: usize = 1;

/// Half an hour in the furnished flat by a program of a few lines, in Rust: it turns when it bumps.
pub fn programs(bench: &mut Bench<'_>) {
    let mut session = Session::new();
    if session.restore("room=flat&behaviour=bounce&slip=typical&noise=typical").is_err() {
        return;
    }
    let Some(room) = session.prepared().cloned() else { return };
    let conditions = session.settings().conditions;
    let lockstep = || Lockstep::new(&room, conditions, 1, Vec::new());
    let simulated_s = if bench.size(1, 0) == 1 { SIMULATED_S } else { 10.0 };
    bench.take("simulate for a program", &mut || drop(drive(lockstep(), simulated_s)), Some(simulated_s));
    let log = drive(lockstep(), simulated_s).log();
    let setup = room.setup(conditions, 1);
    let mut repeat = || {
        let mut run = Run::new(&setup, Box::new(Logged::new(SharedLog::new(log.clone()))));
        while !run.is_finished() && !run.waits() {
            run.step();
        }
    };
    bench.take("repeat the log of a program", &mut repeat, Some(simulated_s));
}

fn drive(mut lockstep: Lockstep, simulated_s: f64) -> Lockstep {
    let mut turn_until = 0.0;
    loop {
        let sensed = lockstep.readings();
        let (time, bumped) = (sensed[TIME], BUMPS.iter().any(|&bump| sensed[bump] != 0.0));
        let wheels = match () {
            () if bumped => {
                turn_until = time + 0.4 + time % 0.7;
                [-150.0, -150.0]
            }
            () if time < turn_until => [-200.0, 200.0],
            () => [300.0, 300.0],
        };
        if time >= simulated_s || !lockstep.step(wheels) {
            return lockstep;
        }
    }
}
