//! Weighted poses, with which a particle filter represents its estimate.

use crate::mapping::PoseCovariance;
use rand::RngExt;
use robovac_core::{
    geometry::{Pose, difference, normalize},
    math,
    rng::{Rng, normal},
};
use std::collections::BTreeMap;

/// Extent of a possible place, m and rad.
const PLACE: (f64, f64) = (0.2, 0.35);
/// Side of the cells among which the best place is chosen, m.
const SPOT: f64 = 0.25;

#[derive(Debug, Clone, Copy)]
pub(super) struct Particle {
    pub pose: Pose,
    /// Natural logarithm.
    pub weight: f64,
}

/// The place that holds the most weight: mean pose and covariance there, and its share of the weight.
pub(super) struct BestPlace {
    pub pose: Pose,
    pub covariance: PoseCovariance,
    pub share: f64,
}

#[derive(Debug, Clone, Default)]
pub(super) struct Particles(pub Vec<Particle>);

impl Particles {
    /// Adds a particle at `pose` that differs from it by a random error with these standard deviations, m and rad.
    pub fn scatter(&mut self, pose: Pose, deviation: (f64, f64), rng: &mut Rng) {
        self.0.push(Particle { pose: scattered(pose, deviation, rng), weight: 0.0 });
    }

    /// Adds particles of equal weight: each that of an average one, or all together `share` of the weight so far.
    pub fn join(&mut self, drawn: Self, share: Option<f64>) {
        // Existing particles have earned as much weight as new ones.
        let old = self.0.len().max(1) as f64;
        let top = self.top();
        let mean = self.0.iter().map(|p| math::exp(p.weight - top)).sum::<f64>() / old;
        let mut weight = if self.0.is_empty() { 0.0 } else { top + math::ln(mean.max(1e-300)) };
        if let Some(share) = share {
            weight += math::ln(share * old / drawn.0.len().max(1) as f64);
        }
        self.0.extend(drawn.0.into_iter().map(|p| Particle { weight, ..p }));
    }

    /// Their weights, which add up to 1.
    pub fn weights(&self) -> Vec<f64> {
        let top = self.top();
        let weights: Vec<f64> = self.0.iter().map(|p| math::exp(p.weight - top)).collect();
        let sum: f64 = weights.iter().sum();
        weights.into_iter().map(|w| w / sum).collect()
    }

    fn top(&self) -> f64 {
        self.0.iter().map(|p| p.weight).fold(f64::NEG_INFINITY, f64::max)
    }

    /// `count` particles of equal weight, drawn by theirs (low variance sampler; Probabilistic Robotics, table 4.4).
    pub fn resampled(&self, count: usize, rng: &mut Rng) -> Self {
        let weights = self.weights();
        let mut drawn = Vec::with_capacity(count);
        if weights.is_empty() || count == 0 {
            return Self(drawn);
        }
        let step = 1.0 / count as f64;
        let first = rng.random_range(0.0..step);
        let (mut index, mut sum) = (0, weights[0]);
        for i in 0..count {
            let wanted = first + i as f64 * step;
            while sum < wanted && index + 1 < weights.len() {
                index += 1;
                sum += weights[index];
            }
            drawn.push(Particle { weight: 0.0, ..self.0[index] });
        }
        Self(drawn)
    }

    /// Number of places that contain nearly all the weight.
    pub fn possible_places(&self, weights: &[f64]) -> usize {
        let mut places: BTreeMap<(i32, i32, i32), f64> = BTreeMap::new();
        for (particle, weight) in self.0.iter().zip(weights) {
            let Pose { x, y, heading } = particle.pose;
            let key = [x / PLACE.0, y / PLACE.0, heading / PLACE.1].map(math::floor);
            *places.entry((key[0], key[1], key[2])).or_default() += weight;
        }
        places.values().filter(|&&weight| weight > 1e-4).count()
    }

    /// The place with the most weight; `None` without particles.
    pub fn best_place(&self) -> Option<BestPlace> {
        let weights = self.weights();
        let mut places: BTreeMap<(i32, i32), f64> = BTreeMap::new();
        for (particle, weight) in self.0.iter().zip(&weights) {
            let key = [particle.pose.x, particle.pose.y].map(|v| math::floor(v / SPOT));
            *places.entry((key[0], key[1])).or_default() += weight;
        }
        let around = |&(x, y): &(i32, i32)| -> f64 {
            let cells = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (x + dx, y + dy)));
            cells.filter_map(|key| places.get(&key)).sum()
        };
        let best = places.keys().map(|key| (around(key), *key)).reduce(|a, b| if b.0 > a.0 { b } else { a });
        let (x, y) = best?.1;
        let is_near = |pose: Pose| {
            let key = [pose.x, pose.y].map(|v| math::floor(v / SPOT));
            (key[0] - x).abs() <= 1 && (key[1] - y).abs() <= 1
        };
        let near: Vec<(Pose, f64)> =
            self.0.iter().zip(&weights).map(|(p, &w)| (p.pose, w)).filter(|(p, _)| is_near(*p)).collect();
        let share: f64 = near.iter().map(|(_, w)| w).sum();
        let mean = |f: &dyn Fn(Pose) -> f64| near.iter().map(|&(p, w)| w * f(p)).sum::<f64>() / share;
        let (mx, my) = (mean(&|p| p.x), mean(&|p| p.y));
        let heading = math::atan2(mean(&|p| math::sin(p.heading)), mean(&|p| math::cos(p.heading)));
        let position = [
            mean(&|p| (p.x - mx) * (p.x - mx)),
            mean(&|p| (p.x - mx) * (p.y - my)),
            mean(&|p| (p.y - my) * (p.y - my)),
        ];
        let turned = |p: Pose| difference(heading, p.heading);
        let covariance = PoseCovariance { position, heading: mean(&|p| turned(p) * turned(p)).sqrt() };
        Some(BestPlace { pose: Pose::new(mx, my, heading), covariance, share })
    }

    /// Moves the particles near `from` as `from` is moved to `to`.
    pub fn shift(&mut self, from: Pose, to: Pose) {
        for particle in &mut self.0 {
            let is_near = (particle.pose.position() - from.position()).norm() < SPOT
                && difference(particle.pose.heading, from.heading).abs() < PLACE.1;
            if is_near {
                particle.pose = moved(particle.pose, from, to);
            }
        }
    }
}

/// `pose` with a random error of these standard deviations, m and rad.
pub(super) fn scattered(pose: Pose, (position, heading): (f64, f64), rng: &mut Rng) -> Pose {
    let [a, b, c] = [normal(rng), normal(rng), normal(rng)];
    Pose::new(pose.x + position * a, pose.y + position * b, normalize(pose.heading + heading * c))
}

/// `pose` after the motion from `from` to `to`, seen in its own frame.
pub(super) fn moved(pose: Pose, from: Pose, to: Pose) -> Pose {
    let turn = pose.heading - from.heading;
    let (sin, cos) = math::sin_cos(turn);
    let way = to.position() - from.position();
    let heading = normalize(pose.heading + difference(from.heading, to.heading));
    Pose::new(pose.x + way.x * cos - way.y * sin, pose.y + way.x * sin + way.y * cos, heading)
}
