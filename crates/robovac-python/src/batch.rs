//! Many robots, stepped over all cores, with their observations in arrays that they share with Python.

use crate::{
    conditions::{charge, noise_level, slip_level},
    failure::Failure,
    picture::{SIDE, picture},
    room::Room,
    rooms::Rooms,
    watch::SignalWatch,
};
use numpy::{
    PyArray1, PyArray3, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyReadwriteArray1, PyReadwriteArray2,
    PyReadwriteArray4,
};
use pyo3::prelude::*;
use rand::RngExt;
use robovac_core::{
    floor_plan::generate::FlatSpec,
    rng::Rng,
    robot::{Drive, RobotModel, model},
};
use robovac_sim::{
    Conditions, Noise, NoiseLevel, RandomStream, SlipLevel,
    learning::{Episode, Gains, Observations, PATCH_LEN, READINGS, RewardWeights, Task, truth},
};
use std::{
    sync::{Arc, Mutex, PoisonError},
    thread,
    time::Instant,
};

/// Environments below which another thread isn't worth its start.
const FEW: usize = 16;

/// Parts of an episode's [`Gains`].
const PARTS: usize = Gains::NAMES.len();

/// Arguments of a batch.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct BatchArguments {
    num_envs: usize,
    /// Rooms; without them flats are generated.
    rooms: Option<Vec<Py<Room>>>,
    flats: usize,
    first_flat: u64,
    area_m2: (f64, f64),
    furniture: f64,
    robot: String,
    sim_steps: u32,
    most_steps: u32,
    goal: f64,
    observes: Vec<String>,
    action: String,
    weights: [f64; PARTS],
    slip: Vec<String>,
    noise: Vec<String>,
    charge_percent: (f64, f64),
    anywhere: bool,
    autoreset: String,
    threads: Option<usize>,
}

/// Arrays that are written in each step.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Buffers<'py> {
    oi: Option<PyReadwriteArray2<'py, f32>>,
    map: Option<PyReadwriteArray4<'py, u8>>,
    truth: Option<PyReadwriteArray2<'py, f32>>,
    rewards: PyReadwriteArray1<'py, f64>,
    terminated: PyReadwriteArray1<'py, bool>,
    truncated: PyReadwriteArray1<'py, bool>,
    gains: PyReadwriteArray2<'py, f64>,
    coverage: PyReadwriteArray1<'py, f64>,
    /// Observations of episodes that ended in this step, with autoreset in the same step.
    final_oi: Option<PyReadwriteArray2<'py, f32>>,
    final_map: Option<PyReadwriteArray4<'py, u8>>,
    final_truth: Option<PyReadwriteArray2<'py, f32>>,
}

/// When an environment begins its next episode.
#[derive(Clone, Copy, PartialEq)]
enum Autoreset {
    NextStep,
    SameStep,
    Disabled,
}

/// What actions mean.
#[derive(Clone, Copy)]
enum ActionSpace {
    Wheels,
    Twist,
}

/// What all environments have in common.
struct Common {
    task: Arc<Task>,
    rooms: Rooms,
    action: ActionSpace,
    weights: RewardWeights,
    slip: Vec<SlipLevel>,
    noise: Vec<NoiseLevel>,
    charge: (u8, u8),
    anywhere: bool,
    autoreset: Autoreset,
}

/// What chance chose for an episode: a room's name, or the seed of a flat; slip, noise, and the charge, %.
type Drawn = (Option<String>, Option<u64>, &'static str, &'static str, u8);

/// One environment.
struct Env {
    episode: Option<Episode>,
    /// What chance chose for it: the room's number, slip, noise, and the charge, %.
    drawn: Option<(usize, SlipLevel, NoiseLevel, u8)>,
    rng: Rng,
    is_done: bool,
}

/// The environments.
#[pyclass(module = "robovac._native")]
pub struct Batch {
    common: Common,
    envs: Vec<Env>,
    threads: usize,
}

/// The part of the arrays that belongs to one or more environments.
#[derive(Default)]
struct Parts<'a> {
    now: ObservationArrays<'a>,
    last: ObservationArrays<'a>,
    rewards: &'a mut [f64],
    terminated: &'a mut [bool],
    truncated: &'a mut [bool],
    gains: &'a mut [f64],
    coverage: &'a mut [f64],
}

#[derive(Default)]
struct ObservationArrays<'a> {
    oi: Option<&'a mut [f32]>,
    map: Option<&'a mut [u8]>,
    truth: Option<&'a mut [f32]>,
}

#[pymethods]
impl Batch {
    #[new]
    fn new(py: Python<'_>, arguments: BatchArguments) -> PyResult<Self> {
        Ok(py.detach(|| arguments.batch())?)
    }

    /// Begins new episodes where `mask` is set, with those seeds where there are any.
    fn reset(
        &mut self,
        py: Python<'_>,
        mask: PyReadonlyArray1<'_, bool>,
        seeds: Vec<Option<u64>>,
        mut buffers: Buffers<'_>,
    ) -> PyResult<()> {
        let mask = mask.as_slice()?;
        let parts = buffers.parts()?;
        self.check_sizes(&parts, &[mask.len(), seeds.len()])?;
        // Flats are generated and laid out here, which takes seconds for hundreds.
        let watch = Mutex::new(SignalWatch::new());
        let work = |index: usize, env: &mut Env, common: &Common, part: Parts<'_>| {
            let is_interrupted = watch.lock().unwrap_or_else(PoisonError::into_inner).look().is_break();
            if is_interrupted || !mask[index] {
                return Ok(());
            }
            if let Some(seed) = seeds[index] {
                env.rng = RandomStream::Environment.seeded(seed);
            }
            let mut part = part;
            part.clear();
            env.begin(common)?;
            env.show(part.now, part.coverage);
            Ok(())
        };
        let Self { common, envs, threads } = self;
        let done = py.detach(|| over_all(common, envs, *threads, parts, work));
        watch.into_inner().unwrap_or_else(PoisonError::into_inner).finish()?;
        Ok(done?)
    }

    /// One step of all environments. Actions are shares of the largest speeds, -1 to 1.
    fn step(&mut self, py: Python<'_>, actions: PyReadonlyArray2<'_, f32>, mut buffers: Buffers<'_>) -> PyResult<()> {
        let actions = actions.as_slice()?;
        let parts = buffers.parts()?;
        self.check(actions, &parts)?;
        Ok(py.detach(|| self.advance(actions, parts))?)
    }

    /// `steps` steps with the same actions without returning to Python in between; returns the time, s.
    fn bench(
        &mut self,
        py: Python<'_>,
        actions: PyReadonlyArray2<'_, f32>,
        mut buffers: Buffers<'_>,
        steps: u32,
    ) -> PyResult<f64> {
        let actions = actions.as_slice()?;
        self.check(actions, &buffers.parts()?)?;
        let begin = Instant::now();
        for _ in 0..steps {
            let parts = buffers.parts()?;
            py.detach(|| self.advance(actions, parts))?;
        }
        Ok(begin.elapsed().as_secs_f64())
    }

    /// A picture of one environment: rows, columns, red, green and blue; the top row first.
    fn picture<'py>(&self, py: Python<'py>, index: usize) -> PyResult<Bound<'py, PyArray3<u8>>> {
        let episode = self.envs.get(index).and_then(|env| env.episode.as_ref());
        let episode = episode.ok_or_else(|| Failure::usage("call reset() before render()".to_owned()))?;
        let pixels = py.detach(|| picture(episode, self.common.task.robot.radius));
        PyArray1::from_vec(py, pixels).reshape([SIDE, SIDE, 3])
    }

    /// What chance chose for each episode.
    fn drawn(&self) -> PyResult<Vec<Drawn>> {
        let told = |(index, slip, noise, charge): (usize, SlipLevel, NoiseLevel, u8)| {
            let (name, flat) = self.common.rooms.name(index);
            (name, flat, slip.id(), noise.id(), charge)
        };
        let all: Option<Vec<Drawn>> = self.envs.iter().map(|env| env.drawn.map(told)).collect();
        Ok(all.ok_or_else(|| Failure::usage("call reset() before drawn()".to_owned()))?)
    }

    /// Time of a step, s.
    #[getter]
    fn step_s(&self) -> f64 {
        self.common.task.step_s()
    }

    /// Threads that are used.
    #[getter]
    fn threads(&self) -> usize {
        self.threads
    }
}

impl Batch {
    fn check(&self, actions: &[f32], parts: &Parts<'_>) -> Result<(), Failure> {
        self.check_sizes(parts, &[actions.len() / 2])?;
        if let Some(index) = actions.iter().position(|number| !number.is_finite()) {
            let (row, number) = (index / 2, actions[index]);
            return Err(Failure::usage(format!(
                "the action of environment {row} has {number}; use numbers from -1 to 1"
            )));
        }
        if self.envs.iter().any(|env| env.episode.is_none()) {
            return Err(Failure::usage("call reset() before step()".to_owned()));
        }
        let is_stuck = |env: &Env| env.is_done && self.common.autoreset == Autoreset::Disabled;
        if let Some(index) = self.envs.iter().position(is_stuck) {
            let way = "reset it first: reset(options={\"reset_mask\": ...})";
            return Err(Failure::usage(format!("the episode of environment {index} is over; {way}")));
        }
        Ok(())
    }

    fn check_sizes(&self, parts: &Parts<'_>, others: &[usize]) -> Result<(), Failure> {
        let count = self.envs.len();
        let sizes = [parts.rewards.len(), parts.terminated.len(), parts.truncated.len(), parts.coverage.len()];
        let seen = [&parts.now, &parts.last];
        let fits = |len: Option<usize>, each: usize| len.is_none_or(|len| len == count * each);
        let is_right = sizes.iter().chain(others).all(|&size| size == count)
            && parts.gains.len() == count * PARTS
            && seen.iter().all(|seen| {
                fits(seen.oi.as_ref().map(|oi| oi.len()), READINGS)
                    && fits(seen.map.as_ref().map(|map| map.len()), PATCH_LEN)
                    && fits(seen.truth.as_ref().map(|truth| truth.len()), truth::VALUES)
            });
        is_right
            .then_some(())
            .ok_or_else(|| Failure::usage(format!("give one action for each of {count} environments")))
    }

    fn advance(&mut self, actions: &[f32], parts: Parts<'_>) -> Result<(), Failure> {
        let Self { common, envs, threads } = self;
        over_all(common, envs, *threads, parts, |index, env, common, part| {
            env.advance(common, [actions[2 * index], actions[2 * index + 1]], part)
        })
    }
}

/// Does `work` for every environment, on some threads. They are started for each call: that takes some ten microseconds, and
/// needs no care when a program forks.
fn over_all(
    common: &Common,
    envs: &mut [Env],
    threads: usize,
    mut parts: Parts<'_>,
    work: impl Fn(usize, &mut Env, &Common, Parts<'_>) -> Result<(), Failure> + Sync,
) -> Result<(), Failure> {
    let each = envs.len().div_ceil(threads.min(envs.len() / FEW).max(1)).max(1);
    let do_all = |first: usize, envs: &mut [Env], mut parts: Parts<'_>| {
        for (index, env) in envs.iter_mut().enumerate() {
            work(first + index, env, common, parts.take(1))?;
        }
        Ok(())
    };
    if each >= envs.len() {
        return do_all(0, envs, parts);
    }
    thread::scope(|scope| {
        let mut others = Vec::new();
        let mut chunks = envs.chunks_mut(each).enumerate();
        let own = chunks.next().map(|(_, envs)| (parts.take(envs.len()), envs));
        for (number, envs) in chunks {
            let part = parts.take(envs.len());
            let do_all = &do_all;
            others.push(scope.spawn(move || do_all(number * each, envs, part)));
        }
        let mut result = own.map_or(Ok(()), |(part, envs)| do_all(0, envs, part));
        for other in others {
            let ended = other
                .join()
                .unwrap_or_else(|_| Err(Failure::planner("a thread panicked; please report this".to_owned())));
            result = result.and(ended);
        }
        result
    })
}

impl Env {
    /// Begins an episode in a room, under conditions and from a start that chance decides.
    fn begin(&mut self, common: &Common) -> Result<(), Failure> {
        let rng = &mut self.rng;
        let (index, room) = common.rooms.choose(&common.task.robot, rng)?;
        let slip = common.slip[rng.random_range(0..common.slip.len())];
        let noise = common.noise[rng.random_range(0..common.noise.len())];
        let start_charge_percent = rng.random_range(common.charge.0..=common.charge.1);
        self.drawn = Some((index, slip, noise, start_charge_percent));
        let noise = Noise::all(noise);
        let conditions = Conditions { slip, noise, quantised: false, start_charge_percent, spare_batteries: false };
        let start = if common.anywhere { room.floor.anywhere(rng) } else { None };
        self.episode = Some(Episode::new(&common.task, &room, conditions, start, rng.random()));
        self.is_done = false;
        Ok(())
    }

    /// Observes once.
    fn show(&mut self, seen: ObservationArrays<'_>, coverage: &mut [f64]) {
        if let Some(episode) = &mut self.episode {
            let ObservationArrays { oi, map, truth } = seen;
            episode.observe(Observations { readings: oi, map, truth });
            coverage.fill(episode.coverage());
        }
    }

    fn advance(&mut self, common: &Common, action: [f32; 2], mut part: Parts<'_>) -> Result<(), Failure> {
        if self.is_done {
            part.clear();
            self.begin(common)?;
            self.show(part.now, part.coverage);
            return Ok(());
        }
        let Some(episode) = &mut self.episode else { return Ok(()) };
        let outcome = episode.step(common.action.drive(&common.task.robot, action));
        part.rewards.fill(common.weights.reward(&outcome.gains));
        part.terminated.fill(outcome.is_over);
        part.truncated.fill(outcome.is_late);
        part.gains.copy_from_slice(&outcome.gains.parts());
        self.is_done = outcome.is_over || outcome.is_late;
        if self.is_done && common.autoreset == Autoreset::SameStep {
            // The coverage that counts is that of the episode that ended.
            self.show(std::mem::take(&mut part.last), part.coverage);
            self.begin(common)?;
            self.show(part.now, &mut []);
            return Ok(());
        }
        self.show(part.now, part.coverage);
        Ok(())
    }
}

impl ActionSpace {
    fn drive(self, robot: &RobotModel, [a, b]: [f32; 2]) -> Drive {
        let [a, b] = [a, b].map(|share| f64::from(share.clamp(-1.0, 1.0)));
        let most = robot.max_wheel_speed;
        match self {
            Self::Wheels => Drive::wheels(a * most, b * most),
            Self::Twist => {
                // The same curve, slower, where a wheel can't turn so fast.
                let (left, right) = (a - b, a + b);
                let slower = most / left.abs().max(right.abs()).max(1.0);
                Drive::wheels(left * slower, right * slower)
            }
        }
    }
}

impl BatchArguments {
    fn batch(&self) -> Result<Batch, Failure> {
        let robot = model(&self.robot).ok_or_else(|| Failure::unknown("robot", &self.robot, "robots"))?;
        if self.num_envs == 0 || self.sim_steps == 0 || self.most_steps == 0 {
            return Err(Failure::usage("num_envs, step_s and time_limit_s must be greater than 0".to_owned()));
        }
        if !(self.goal > 0.0 && self.goal.is_finite()) {
            return Err(Failure::usage(format!("goal can't be {}; use a share of the floor, e.g. 0.95", self.goal)));
        }
        if self.weights.iter().any(|weight| !weight.is_finite()) {
            return Err(Failure::usage("all weights of the reward must be finite".to_owned()));
        }
        let rooms = if let Some(rooms) = &self.rooms {
            Rooms::given(rooms, robot)?
        } else {
            let spec = FlatSpec { area_m2: self.area_m2.into(), furniture: self.furniture, ..FlatSpec::default() };
            Rooms::flats(self.flats, self.first_flat, spec)?
        };
        let charge = (charge(self.charge_percent.0)?, charge(self.charge_percent.1)?);
        let slip = self.slip.iter().map(|name| slip_level(name)).collect::<Result<Vec<_>, _>>()?;
        let noise = self.noise.iter().map(|name| noise_level(name)).collect::<Result<Vec<_>, _>>()?;
        if slip.is_empty() || noise.is_empty() || charge.0 > charge.1 {
            let message = "slip and noise need at least one level, and charge_percent two numbers, the lower first";
            return Err(Failure::usage(message.to_owned()));
        }
        let [swept_m2, turned_rad, bump, second, fall, finish] = self.weights;
        let task = Task {
            robot: robot.clone(),
            sim_steps: self.sim_steps,
            most_steps: self.most_steps,
            goal: self.goal,
            keeps_map: self.observes.iter().any(|set| set == "map"),
        };
        let threads = self.threads.unwrap_or_else(|| thread::available_parallelism().map_or(1, usize::from));
        Ok(Batch {
            common: Common {
                task: Arc::new(task),
                rooms,
                action: if self.action == "wheels" { ActionSpace::Wheels } else { ActionSpace::Twist },
                weights: RewardWeights { swept_m2, turned_rad, bump, second, fall, finish },
                slip,
                noise,
                charge,
                anywhere: self.anywhere,
                autoreset: match &*self.autoreset {
                    "SameStep" => Autoreset::SameStep,
                    "Disabled" => Autoreset::Disabled,
                    _ => Autoreset::NextStep,
                },
            },
            envs: (0..self.num_envs)
                .map(|_| Env { episode: None, drawn: None, rng: RandomStream::Environment.seeded(0), is_done: false })
                .collect(),
            threads: threads.max(1),
        })
    }
}

impl Buffers<'_> {
    fn parts(&mut self) -> PyResult<Parts<'_>> {
        fn slice<'a, T: numpy::Element, D: numpy::ndarray::Dimension>(
            array: &'a mut Option<numpy::PyReadwriteArray<'_, T, D>>,
        ) -> PyResult<Option<&'a mut [T]>> {
            Ok(array.as_mut().map(|array| array.as_slice_mut()).transpose()?)
        }
        Ok(Parts {
            now: ObservationArrays {
                oi: slice(&mut self.oi)?,
                map: slice(&mut self.map)?,
                truth: slice(&mut self.truth)?,
            },
            last: ObservationArrays {
                oi: slice(&mut self.final_oi)?,
                map: slice(&mut self.final_map)?,
                truth: slice(&mut self.final_truth)?,
            },
            rewards: self.rewards.as_slice_mut()?,
            terminated: self.terminated.as_slice_mut()?,
            truncated: self.truncated.as_slice_mut()?,
            gains: self.gains.as_slice_mut()?,
            coverage: self.coverage.as_slice_mut()?,
        })
    }
}

impl Parts<'_> {
    /// Takes what belongs to the first `count` environments.
    fn take(&mut self, count: usize) -> Self {
        Self {
            now: self.now.take(count),
            last: self.last.take(count),
            rewards: first(&mut self.rewards, count),
            terminated: first(&mut self.terminated, count),
            truncated: first(&mut self.truncated, count),
            gains: first(&mut self.gains, count * PARTS),
            coverage: first(&mut self.coverage, count),
        }
    }

    /// As after a step in which nothing happened.
    fn clear(&mut self) {
        self.rewards.fill(0.0);
        self.terminated.fill(false);
        self.truncated.fill(false);
        self.gains.fill(0.0);
    }
}

impl ObservationArrays<'_> {
    fn take(&mut self, count: usize) -> Self {
        Self {
            oi: self.oi.as_mut().map(|oi| first(oi, count * READINGS)),
            map: self.map.as_mut().map(|map| first(map, count * PATCH_LEN)),
            truth: self.truth.as_mut().map(|values| first(values, count * truth::VALUES)),
        }
    }
}

/// Takes the first `count` values off a slice.
#[allow(clippy::mut_mut, reason = "what is left of the slice is given back")]
fn first<'a, T>(rest: &mut &'a mut [T], count: usize) -> &'a mut [T] {
    let (taken, left) = std::mem::take(rest).split_at_mut(count);
    *rest = left;
    taken
}
