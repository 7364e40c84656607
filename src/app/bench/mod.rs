//! The benchmark that runs natively (`robovac bench`) and in the browser (`bench.html`), so that both can be compared.

use super::{Session, link::Link, montecarlo::RunsRequest};
use crate::{
    floorplan::generate::random_hall,
    grid::{Cell, Direction},
    oi::{MAX_FRAME, PacketId, Readings, StreamParser, driver::FRAME_S, write_frame},
    planner::{CoverageJob, PLANNERS, Params, PlanContext, SLOW_CELLS},
    sim::{Run, STEP_S},
};
use serde::Serialize;
use std::array;

/// Samples of each case but long ones; the median is reported.
const SAMPLES: usize = 5;
/// Shortest sample, s: a browser's clock is coarse, and it optimises only what has run for a while. Shorter cases are
/// repeated.
const LEAST_S: f64 = 0.05;
/// A case that takes longer is measured once, s.
const LONG_S: f64 = 0.5;
/// Most repetitions, whatever the clock says.
const MOST_REPEATS: u32 = 1024;
/// Bytes of the stream that is parsed, those of one frame of it, and frames that a whole connection hears: a minute.
const STREAM_BYTES: usize = 10_000_000;
const FRAME_BYTES: usize = 84;
const HEARD_FRAMES: usize = 4000;
/// Frames after which the robot answers which mode it is in: by then it was asked.
const ANSWER_AFTER: usize = 40;
/// Steps of the simulator's case: half an hour, less than the flat takes.
const SIMULATED_STEPS: u32 = 120_000;

/// One case's result.
#[derive(Debug, Clone, Serialize)]
pub struct BenchResult {
    /// What was measured.
    pub name: String,
    /// Median time of one run, ms.
    pub ms: f64,
    /// Times real time, for the simulator.
    pub times_real_time: Option<f64>,
}

/// Runs all cases. `clock` gives seconds; `report` is told each result as it comes.
pub fn run(clock: &dyn Fn() -> f64, report: &mut dyn FnMut(&BenchResult)) -> Vec<BenchResult> {
    let mut results = Vec::new();
    let mut take = |name: String, case: &mut dyn FnMut(), simulated: Option<f64>| {
        let mut sample = |repeats: u32| {
            let began = clock();
            (0..repeats).for_each(|_| case());
            clock() - began
        };
        let (mut repeats, mut seconds) = (1, sample(1));
        while seconds < LEAST_S && repeats < MOST_REPEATS {
            repeats *= 2;
            seconds = sample(repeats);
        }
        if seconds < LONG_S {
            let mut times: [f64; SAMPLES] = array::from_fn(|_| sample(repeats) / f64::from(repeats));
            times.sort_by(f64::total_cmp);
            seconds = times[SAMPLES / 2];
        }
        let result = BenchResult { name, ms: 1000.0 * seconds, times_real_time: simulated.map(|s| s / seconds) };
        report(&result);
        results.push(result);
    };
    for side in [100, 1000] {
        let Some(job) = hall(side) else { continue };
        for info in PLANNERS.iter().filter(|info| info.claims.fast || job.cells() <= SLOW_CELLS) {
            let planner = info.build(&Params::defaults(info.params));
            let name = format!("plan {} {side} x {side}", info.id);
            take(name, &mut || drop(planner.plan(&job, &mut PlanContext::new(1))), None);
        }
    }
    if let Some(start) = opening_run() {
        let mut simulate = || {
            let mut run = start.clone();
            for _ in 0..SIMULATED_STEPS {
                run.step();
            }
        };
        take("simulate the furnished flat".to_owned(), &mut simulate, Some(f64::from(SIMULATED_STEPS) * STEP_S));
    }
    let request = cycle();
    if let Ok(mut lab) = request.lab() {
        let mut runs = || drop(request.run(&mut lab, None));
        take("simulate the cleaning cycle in the flat".to_owned(), &mut runs, Some(request.duration_s));
    }
    let stream = stream(STREAM_BYTES);
    let mut parse = || {
        let mut parser = StreamParser::default();
        parser.feed(&stream, &mut |_| {});
    };
    take(format!("parse {} MB of sensor stream", STREAM_BYTES / 1_000_000), &mut parse, None);
    let mut hear = || {
        let mut link = Link::new();
        for (index, frame) in stream.chunks_exact(FRAME_BYTES).take(HEARD_FRAMES).enumerate() {
            let now = index as f64 * FRAME_S;
            if index == 0 {
                link.opened(now);
            }
            link.feed(now, frame);
            if index == ANSWER_AFTER {
                link.feed(now, &[1]);
            }
            link.tick(now);
            let _ = (link.take_tx(), link.take_trace());
            // As often as a worker tells its page.
            if index % 3 == 0 {
                let _ = (link.view(now), link.take_traffic());
            }
        }
    };
    take("hear all sensors at full rate".to_owned(), &mut hear, Some(HEARD_FRAMES as f64 * FRAME_S));
    results
}

/// Frames of all packets, as a robot streams them, of which every value changes; `bytes` of them or a little less.
pub fn stream(bytes: usize) -> Vec<u8> {
    let mut stream = Vec::with_capacity(bytes);
    let mut buffer = [0; MAX_FRAME];
    let Some(all) = PacketId::from_byte(100) else { return stream };
    let mut readings = Readings { mode: 1, capacity_mah: 2696, voltage_mv: 15_000, ..Readings::default() };
    while stream.len() + FRAME_BYTES <= bytes {
        readings.left_counts = readings.left_counts.wrapping_add(7);
        readings.right_counts = readings.right_counts.wrapping_add(11);
        readings.light_signal = readings.light_signal.map(|signal| (signal + 13) % 4096);
        readings.current_ma = -400 - (readings.left_counts % 300) as i16;
        match write_frame(&[all], &readings, &mut buffer) {
            Ok(frame) => stream.extend_from_slice(frame),
            Err(_) => break,
        }
    }
    stream
}

/// One of many runs: half an hour of the cleaning cycle by a Roomba in the furnished flat, with typical slip and noise.
pub fn cycle() -> RunsRequest {
    RunsRequest {
        id: 0,
        room: Some("flat".to_owned()),
        scenario: None,
        settings: "robot=roomba600&slip=typical&noise=typical".to_owned(),
        duration_s: 1800.0,
        plan_seed: 1,
        behaves: true,
        entrant: "cleaning_cycle".to_owned(),
        seeds: vec![1],
        place: String::new(),
    }
}

/// The job of a hall of `side` x `side` cells, a tenth of it blocked by rectangles.
pub fn hall(side: usize) -> Option<CoverageJob> {
    // The generator keeps the lower-left cell free.
    CoverageJob::new(&random_hall(side, side, 1), Cell::new(0, 0), Direction::Right)
}

/// A Roomba about to clean the furnished flat, as the page opens with it.
pub fn opening_run() -> Option<Run> {
    let mut session = Session::new();
    session.plan_now(|| 0.0);
    session.recording().map(|recording| recording.run().clone())
}
