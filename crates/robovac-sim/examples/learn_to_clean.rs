//! Trains the network of the behaviour `learned`, from a simple rule on, by cleaning generated flats:
//! `cargo run --release -p robovac-sim --example learn_to_clean -- [FOLDER [GENERATIONS [THREADS]]]`
//!
//! Writes `weights.txt` and `curve.csv` into the folder. The same number of generations gives the same weights, on every
//! machine and with any number of threads.

use robovac_core::{
    floor_plan::generate::{FlatSpec, generate_flat},
    registry::Params,
    rng::{Rng, normal, seeded},
    robot::model,
};
use robovac_sim::{
    Conditions, Noise, NoiseLevel, Run, SlipLevel,
    controller::{
        self, Setup,
        learned::{LAYERS, Network, drive_by},
    },
    experiment::RoomSetup,
};
use std::{
    env,
    error::Error,
    fs,
    path::Path,
    sync::{
        Arc, Mutex, PoisonError,
        atomic::{AtomicUsize, Ordering},
    },
    thread,
    time::Instant,
};

/// Seed of the evolution's random numbers, and its stream.
const SEED: (u64, u64) = (24, 90);
/// Seeds of the flats that it learns in, new ones for each generation, and of those that choose the weights that are kept.
/// The flats of 0 to 99,999 stay unseen.
const LEARN_FROM: u64 = 1_000_000;
const CHOOSE_FROM: u64 = 500_000;
/// Flats in which each candidate cleans, and in which the best is chosen.
const FLATS: u64 = 6;
const CHOICE: u64 = 24;
/// Generations between two choices.
const CHOOSE_EVERY: u32 = 10;
/// Pairs of candidates of a generation, each as far from the mean as the other, on opposite sides.
const PAIRS: usize = 8;
/// Spread of the candidates at first.
const SPREAD: f64 = 0.1;
/// The rule that it begins with, a weight for each input, and its speed: towards new floor, near before far, without turning much,
/// not where something is near, and else along the way to the nearest new floor.
const RULE: [f64; LAYERS[0]] = [0.4, 0.3, 0.2, 0.06, -0.4, 0.06, 0.06, -0.3, 0.0, 0.16, 0.3, 0.0, -0.1, 0.0, -0.2, 0.0];
const FAST: f64 = 3.0;
/// What the file of weights begins with.
const HEAD: &str = "\
# Weights of the behaviour `learned`, by crates/robovac-sim/examples/learn_to_clean.rs.
# Sizes of the layers; then a line for each neuron, layer by layer: its bias, then a weight for each neuron before it.
";
/// Time of a run, s.
const TIME_S: f64 = 1200.0;

/// Mean and spread of each weight.
struct Search {
    mean: Vec<f64>,
    spread: Vec<f64>,
}

impl Search {
    fn new(rng: &mut Rng) -> Self {
        // One hidden neuron has the rule, and alone counts for the score. The others see the inputs by chance, and do not count
        // yet. The speed is high.
        let inputs = LAYERS[0] + 1;
        let (hidden, outputs) = (inputs * LAYERS[1], LAYERS[1] + 1);
        let mut mean = vec![0.0; Network::weights_of(&LAYERS)];
        mean[1..inputs].copy_from_slice(&RULE);
        mean[inputs..hidden].iter_mut().for_each(|weight| *weight = 0.25 * normal(rng));
        (mean[hidden + 1], mean[hidden + outputs]) = (1.0, FAST);
        let spread = vec![SPREAD; mean.len()];
        Self { mean, spread }
    }

    /// Steps of a generation's candidates, in units of the spread: pairs of opposites.
    fn steps(&self, rng: &mut Rng) -> Vec<Vec<f64>> {
        let pair = |_| {
            let step: Vec<f64> = self.mean.iter().map(|_| normal(rng)).collect();
            let opposite = step.iter().map(|x| -x).collect();
            [step, opposite]
        };
        (0..PAIRS).flat_map(pair).collect()
    }

    fn candidate(&self, step: &[f64]) -> Result<Network, Box<dyn Error>> {
        let weights = self.mean.iter().zip(&self.spread).zip(step).map(|((mean, spread), step)| mean + spread * step);
        Ok(Network::new(&LAYERS, weights.map(|weight| weight as f32).collect())?)
    }

    fn best(&self) -> Result<Network, Box<dyn Error>> {
        self.candidate(&vec![0.0; self.mean.len()])
    }

    /// Moves towards the better candidates (separable natural evolution strategy).
    fn learn(&mut self, steps: &[Vec<f64>], values: &[f64]) {
        let mut order: Vec<usize> = (0..steps.len()).collect();
        order.sort_by(|&a, &b| values[b].total_cmp(&values[a]));
        let count = steps.len() as f64;
        let raw: Vec<f64> =
            (1..=steps.len()).map(|rank| ((0.5 * count + 1.0).ln() - (rank as f64).ln()).max(0.0)).collect();
        let sum: f64 = raw.iter().sum();
        let weights = raw.iter().map(|weight| weight / sum - 1.0 / count);
        let weighted: Vec<(f64, &Vec<f64>)> = weights.zip(&order).map(|(weight, &i)| (weight, &steps[i])).collect();
        let dimensions = self.mean.len() as f64;
        let rate = 0.5 * (3.0 + dimensions.ln()) / (5.0 * dimensions.sqrt());
        for (i, (mean, spread)) in self.mean.iter_mut().zip(&mut self.spread).enumerate() {
            let slope: f64 = weighted.iter().map(|(weight, step)| weight * step[i]).sum();
            let widening: f64 = weighted.iter().map(|(weight, step)| weight * (step[i] * step[i] - 1.0)).sum();
            *mean += *spread * slope;
            *spread *= (rate * widening).exp();
        }
    }
}

/// Flats with typical slip and noise.
struct Flats(Vec<RoomSetup>);

impl Flats {
    fn new(from: u64, count: u64) -> Result<Self, Box<dyn Error>> {
        let robot = model("roomba600").ok_or("no such robot")?;
        let flat = |seed| RoomSetup::new(&generate_flat(seed, &FlatSpec::default()), robot, robot.default_cell, None);
        Ok(Self((from..from + count).map(flat).collect::<Result<_, _>>()?))
    }

    /// Share that a network sweeps of one of them.
    fn clean(&self, flat: usize, network: &Arc<Network>, seed: u64) -> Result<f64, Box<dyn Error + Send + Sync>> {
        let room = &self.0[flat];
        let info = controller::find("learned").ok_or("no such behaviour")?;
        let params = Params::defaults(info.params);
        let noise = Noise::all(NoiseLevel::Typical);
        let conditions = Conditions { slip: SlipLevel::Typical, noise, ..Conditions::default() };
        let controller = drive_by(&Setup { robot: &room.robot, params: &params, seed }, Arc::clone(network));
        let mut run = Run::new(&room.setup(conditions, seed), controller);
        while !run.is_finished() && run.time_s() < TIME_S {
            run.step();
        }
        Ok(run.coverage())
    }
}

/// Values of some networks, in parallel: mean swept shares of `flats`.
fn values(networks: &[Arc<Network>], flats: &Flats, seed: u64, threads: usize) -> Result<Vec<f64>, Box<dyn Error>> {
    let count = flats.0.len();
    let next = AtomicUsize::new(0);
    let shares = Mutex::new(vec![0.0; networks.len() * count]);
    let failed = Mutex::new(None);
    let work = || {
        loop {
            let i = next.fetch_add(1, Ordering::Relaxed);
            let Some(network) = networks.get(i / count) else { return };
            match flats.clean(i % count, network, seed) {
                Ok(share) => shares.lock().unwrap_or_else(PoisonError::into_inner)[i] = share,
                Err(error) => *failed.lock().unwrap_or_else(PoisonError::into_inner) = Some(error),
            }
        }
    };
    thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(work);
        }
    });
    if let Some(error) = failed.into_inner().unwrap_or_else(PoisonError::into_inner) {
        return Err(error);
    }
    let shares = shares.into_inner().unwrap_or_else(PoisonError::into_inner);
    Ok(shares.chunks(count).map(|shares| shares.iter().sum::<f64>() / count as f64).collect())
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut args = env::args().skip(1);
    let folder = args.next().unwrap_or_else(|| "learned".to_owned());
    let generations: u32 = args.next().map_or(Ok(100), |text| text.parse())?;
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let threads: usize = args.next().map_or(Ok(cores), |text| text.parse())?;
    fs::create_dir_all(&folder)?;

    let mut rng = seeded(SEED.0, SEED.1);
    let mut search = Search::new(&mut rng);
    let choice = Flats::new(CHOOSE_FROM, CHOICE)?;
    let mut best = f64::NEG_INFINITY;
    let mut curve = "generation,candidates_mean_percent,candidates_best_percent,chosen_flats_percent\n".to_owned();
    let began = Instant::now();
    for generation in 0..=generations {
        let mut chosen = String::new();
        if generation % CHOOSE_EVERY == 0 || generation == generations {
            let network = search.best()?;
            let value = 100.0 * values(&[Arc::new(network.clone())], &choice, u64::from(generation), threads)?[0];
            chosen = format!("{value:.2}");
            if value > best {
                best = value;
                fs::write(Path::new(&folder).join("weights.txt"), format!("{HEAD}{network}"))?;
            }
        }
        let flats = Flats::new(LEARN_FROM + FLATS * u64::from(generation), FLATS)?;
        let steps = search.steps(&mut rng);
        let candidates =
            steps.iter().map(|step| search.candidate(step).map(Arc::new)).collect::<Result<Vec<_>, _>>()?;
        let found = values(&candidates, &flats, u64::from(generation), threads)?;
        search.learn(&steps, &found);
        let mean = 100.0 * found.iter().sum::<f64>() / found.len() as f64;
        let most = 100.0 * found.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let line = format!("{generation},{mean:.2},{most:.2},{chosen}\n");
        print!("{:6.0} s  {line}", began.elapsed().as_secs_f64());
        curve += &line;
        fs::write(Path::new(&folder).join("curve.csv"), &curve)?;
    }
    Ok(())
}
