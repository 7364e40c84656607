//! Planners against each other in the same rooms.

use crate::{failure::Failure, room::Room, watch::SignalWatch};
use coverage_planners::{Observer, ProgressReport, metrics::METRICS};
use pyo3::prelude::*;
use robovac_sim::experiment::{Arena, Entrant, planning::choose_robot};
use serde_json::{Value, json};
use std::{
    ops::ControlFlow,
    sync::{
        Mutex, PoisonError,
        atomic::{AtomicBool, AtomicUsize, Ordering},
    },
    thread,
    time::{Duration, Instant},
};

/// A trial: numbers of room and planner, and the seed.
type PythonTrial = (usize, usize, u64);

/// Every trial's outcome as JSON, in their order. `planners` are written as in links: `snake~patience:3`.
#[pyfunction]
pub fn compare(
    py: Python<'_>,
    rooms: Vec<Py<Room>>,
    planners: Vec<String>,
    robot: &str,
    cell_m: Option<f64>,
    smooth: bool,
    seeds: Vec<u64>,
    threads: Option<usize>,
) -> PyResult<String> {
    let parse = |text: &String| Ok(Entrant::parse_planner(text)?);
    let entrants = planners.iter().map(parse).collect::<Result<Vec<_>, Failure>>()?;
    let mut places = Vec::new();
    for room in &rooms {
        let plan = &room.get().plan;
        let chosen = choose_robot(robot, plan, cell_m);
        let (robot, cell_size) = chosen.ok_or_else(|| Failure::unknown("robot", robot, "robots"))?;
        places.push((plan, robot, cell_size));
    }
    let seeds_of =
        |entrant: usize| if entrants[entrant].0.is_deterministic() { &seeds[..seeds.len().min(1)] } else { &seeds };
    let trials: Vec<PythonTrial> = (0..places.len())
        .flat_map(|room| (0..entrants.len()).map(move |entrant| (room, entrant)))
        .flat_map(|(room, entrant)| seeds_of(entrant).iter().map(move |&seed| (room, entrant, seed)))
        .collect();
    let threads = threads.unwrap_or_else(|| thread::available_parallelism().map_or(1, usize::from)).max(1);
    let mut watch = SignalWatch::new();
    let results = py.detach(|| {
        let arenas: Vec<Result<Arena, String>> = places
            .iter()
            .map(|(plan, robot, cell)| {
                let arena = Arena::new(plan, robot, *cell, None).map_err(|error| error.to_string());
                arena.map(|arena| arena.smooth(smooth))
            })
            .collect();
        let attempt = |(room, entrant, seed): PythonTrial, observer: Observer<'_>| {
            let (entrant, planner) = &entrants[entrant];
            let arena = arenas[room].as_ref().map_err(Clone::clone)?;
            let begin = Instant::now();
            let outcome = arena.run(planner, &entrant.params, seed, || begin.elapsed().as_secs_f64(), Some(observer));
            let numbers = outcome.map_err(|error| error.to_string())?.numbers;
            Ok(METRICS.iter().map(|metric| (metric.id, metric.value(&numbers))).collect::<Value>())
        };
        try_all(&trials, threads.min(trials.len()), &mut watch, &attempt)
    });
    watch.finish()?;
    let rows = trials.iter().zip(results).map(|(&(room, entrant, seed), result)| {
        let (plan, robot, cell_size) = &places[room];
        let (entrant, _) = &entrants[entrant];
        let (metrics, error) = match result {
            Ok(metrics) => (metrics, None),
            Err(error) => (Value::Null, Some(error)),
        };
        json!({
            "room": plan.name, "robot": robot.id, "cell_m": cell_size, "planner": entrant.id(),
            "params": entrant.params, "seed": seed, "metrics": metrics, "error": error,
        })
    });
    Ok(rows.collect::<Value>().to_string())
}

/// Makes the trials on `threads` threads, while this one looks for signals.
fn try_all(
    trials: &[PythonTrial],
    threads: usize,
    watch: &mut SignalWatch,
    attempt: &(dyn Fn(PythonTrial, Observer<'_>) -> Result<Value, String> + Sync),
) -> Vec<Result<Value, String>> {
    let (next, left, is_over) = (AtomicUsize::new(0), AtomicUsize::new(threads), AtomicBool::new(false));
    let results = Mutex::new(vec![Err("not tried".to_owned()); trials.len()]);
    let work = || {
        while !is_over.load(Ordering::Relaxed) {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(&trial) = trials.get(index) else { break };
            let mut observe = |_: ProgressReport<'_>| {
                if is_over.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            };
            let result = attempt(trial, &mut observe);
            results.lock().unwrap_or_else(PoisonError::into_inner)[index] = result;
        }
        left.fetch_sub(1, Ordering::Relaxed);
    };
    thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(work);
        }
        while left.load(Ordering::Relaxed) > 0 {
            thread::sleep(Duration::from_millis(2));
            if watch.look().is_break() {
                is_over.store(true, Ordering::Relaxed);
            }
        }
    });
    results.into_inner().unwrap_or_else(PoisonError::into_inner)
}
