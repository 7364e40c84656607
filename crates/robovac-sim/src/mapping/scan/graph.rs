//! The pose graph: key frames and what is known about their relative poses.
//!
//! The squared errors of all edges are minimised by Gauss and Newton's method; the linear systems are solved by
//! conjugate gradients, which need no more memory than the graph.

use nalgebra::{Matrix3, Vector3};
use robovac_core::{
    geometry::{Point, Pose, normalize},
    math,
};
use std::{cmp::Reverse, collections::BinaryHeap};

/// Steps of the optimisation, and largest change in the last of them, m or rad.
const STEPS: usize = 8;
const DONE: f64 = 1e-4;
/// Share of the first residual at which conjugate gradients end, and most iterations.
const ACCURACY: f64 = 1e-7;
const ITERATIONS: usize = 600;
/// Steps in which every loop is believed: an error that has grown on the way is no contradiction.
const BELIEVING: usize = 3;
/// Weighted squared error from which an edge that closes a loop, or a known heading, counts less.
const DOUBTFUL: f64 = 12.0;

/// What is known about the pose of `to` as seen from `from`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edge {
    pub from: usize,
    pub to: usize,
    pub relative: Pose,
    pub information: Matrix3<f64>,
    /// Whether it was found by a search, and could be wrong.
    pub closes_loop: bool,
}

/// What is known about the heading of a pose by itself.
#[derive(Debug, Clone, Copy)]
pub(super) struct KnownHeading {
    pub pose: usize,
    pub heading: f64,
    /// Standard deviation, rad.
    pub deviation: f64,
}

/// Poses, edges and headings.
#[derive(Debug, Clone, Default)]
pub(super) struct PoseGraph {
    pub poses: Vec<Pose>,
    edges: Vec<Edge>,
    headings: Vec<KnownHeading>,
}

/// The pose of `to` as seen from `from`.
pub(super) fn between(from: Pose, to: Pose) -> Pose {
    let (sin, cos) = math::sin_cos(from.heading);
    let (x, y) = (to.x - from.x, to.y - from.y);
    Pose::new(cos * x + sin * y, cos * y - sin * x, to.heading - from.heading)
}

/// The pose that is `relative` as seen from `from`.
pub(super) fn compose(from: Pose, relative: Pose) -> Pose {
    let at = from.to_world(Point::new(relative.x, relative.y));
    Pose::new(at.x, at.y, from.heading + relative.heading)
}

impl PoseGraph {
    /// Adds a pose and returns its number.
    pub fn add(&mut self, pose: Pose) -> usize {
        self.poses.push(pose);
        self.poses.len() - 1
    }

    pub fn link(&mut self, edge: Edge) {
        self.edges.push(edge);
    }

    pub fn face(&mut self, known: KnownHeading) {
        self.headings.push(known);
    }

    /// Drops all known headings; returns whether there were any.
    pub fn forget_headings(&mut self) -> bool {
        !std::mem::take(&mut self.headings).is_empty()
    }

    /// Mean by which the last `count` known headings are missed, rad; 0 until there are so many.
    pub fn missed_by(&self, count: usize) -> f64 {
        let last = self.headings.len().checked_sub(count).map_or(&[][..], |first| &self.headings[first..]);
        last.iter().map(|known| known.error(&self.poses)).sum::<f64>() / count.max(1) as f64
    }

    /// Length of the way along edges from `begin` to every pose, m; infinite beyond `most`.
    pub fn ways(&self, begin: usize, most: f64) -> Vec<f64> {
        let mut ways = vec![f64::INFINITY; self.poses.len()];
        let mut joined = vec![Vec::new(); self.poses.len()];
        for edge in &self.edges {
            let length = (self.poses[edge.to].position() - self.poses[edge.from].position()).norm();
            joined[edge.from].push((edge.to, length));
            joined[edge.to].push((edge.from, length));
        }
        // Lengths in whole micrometres, which have an order.
        let mut queue = BinaryHeap::from([(Reverse(0_u64), begin)]);
        ways[begin] = 0.0;
        while let Some((Reverse(micrometres), at)) = queue.pop() {
            let way = micrometres as f64 * 1e-6;
            if way > ways[at] + 1e-5 {
                continue;
            }
            for &(next, length) in &joined[at] {
                let further = way + length;
                if further < most && further + 1e-5 < ways[next] {
                    ways[next] = further;
                    queue.push((Reverse((further * 1e6) as u64), next));
                }
            }
        }
        ways
    }

    /// Moves all poses but the first to where they contradict the edges least; returns the largest change of a place, m.
    pub fn optimise(&mut self) -> f64 {
        let before = self.poses.clone();
        for step in 0..STEPS {
            let doubts = step >= BELIEVING;
            let change = self.step(doubts);
            if !change.iter().all(|change| change.iter().all(|value| value.is_finite())) {
                self.poses = before;
                return 0.0;
            }
            for (pose, change) in self.poses.iter_mut().zip(&change) {
                *pose = Pose::new(pose.x + change.x, pose.y + change.y, pose.heading + change.z);
            }
            if doubts && change.iter().all(|change| change.amax() < DONE) {
                break;
            }
        }
        let moved = self.poses.iter().zip(&before).map(|(now, then)| (now.position() - then.position()).norm());
        moved.fold(0.0, f64::max)
    }

    /// One step of Gauss and Newton; whether edges in contradiction to the others count less.
    fn step(&self, doubts: bool) -> Vec<Vector3<f64>> {
        let mut diagonal = vec![Matrix3::zeros(); self.poses.len()];
        let mut right = vec![Vector3::zeros(); self.poses.len()];
        let mut off_diagonal = Vec::with_capacity(self.edges.len());
        for edge in &self.edges {
            let (error, from, to) = edge.linearised(&self.poses);
            let squared = (error.transpose() * edge.information * error)[0];
            let scale = if doubts && edge.closes_loop { trust(squared) } else { 1.0 };
            let information = edge.information * (scale * scale);
            diagonal[edge.from] += from.transpose() * information * from;
            diagonal[edge.to] += to.transpose() * information * to;
            right[edge.from] -= from.transpose() * (information * error);
            right[edge.to] -= to.transpose() * (information * error);
            off_diagonal.push((edge.from, edge.to, from.transpose() * information * to));
        }
        for known in &self.headings {
            let error = known.error(&self.poses);
            let information = 1.0 / (known.deviation * known.deviation);
            let scale = if doubts { trust(information * error * error) } else { 1.0 };
            diagonal[known.pose][(2, 2)] += information * scale * scale;
            right[known.pose].z -= information * scale * scale * error;
        }
        // The first pose stays.
        right[0] = Vector3::zeros();
        let inverses: Vec<Matrix3<f64>> =
            diagonal.iter().map(|block| block.try_inverse().unwrap_or_else(Matrix3::zeros)).collect();
        let times = |x: &[Vector3<f64>]| {
            let mut product: Vec<Vector3<f64>> = diagonal.iter().zip(x).map(|(block, x)| block * x).collect();
            for (from, to, block) in &off_diagonal {
                product[*from] += block * x[*to];
                product[*to] += block.transpose() * x[*from];
            }
            product[0] = Vector3::zeros();
            product
        };
        let dot = |a: &[Vector3<f64>], b: &[Vector3<f64>]| a.iter().zip(b).map(|(a, b)| a.dot(b)).sum::<f64>();
        let precondition = |r: &[Vector3<f64>]| -> Vec<Vector3<f64>> {
            r.iter().zip(&inverses).map(|(r, inverse)| inverse * r).collect()
        };
        let mut x = vec![Vector3::zeros(); right.len()];
        let mut residual = right;
        let mut scaled = precondition(&residual);
        let mut direction = scaled.clone();
        let mut squared = dot(&residual, &scaled);
        let goal = squared * ACCURACY * ACCURACY;
        for _ in 0..ITERATIONS {
            if squared <= goal || squared <= 0.0 {
                break;
            }
            let product = times(&direction);
            let length = squared / dot(&direction, &product);
            for i in 0..x.len() {
                x[i] += direction[i] * length;
                residual[i] -= product[i] * length;
            }
            scaled = precondition(&residual);
            let next = dot(&residual, &scaled);
            for (direction, scaled) in direction.iter_mut().zip(&scaled) {
                *direction = scaled + *direction * (next / squared);
            }
            squared = next;
        }
        x
    }

    /// Approximate memory, bytes.
    pub fn bytes(&self) -> usize {
        self.poses.len() * size_of::<Pose>()
            + self.edges.len() * size_of::<Edge>()
            + self.headings.len() * size_of::<KnownHeading>()
    }
}

/// How much something counts whose weighted squared error is this, 0 to 1.
fn trust(squared: f64) -> f64 {
    (2.0 * DOUBTFUL / (DOUBTFUL + squared)).min(1.0)
}

impl KnownHeading {
    /// By how much a pose's heading is more, rad.
    fn error(&self, poses: &[Pose]) -> f64 {
        normalize(poses[self.pose].heading - self.heading)
    }
}

impl Edge {
    /// The edge's error, with its derivatives by the two poses.
    fn linearised(&self, poses: &[Pose]) -> (Vector3<f64>, Matrix3<f64>, Matrix3<f64>) {
        let (from, to) = (poses[self.from], poses[self.to]);
        let now = between(from, to);
        let error = Vector3::new(
            now.x - self.relative.x,
            now.y - self.relative.y,
            normalize(now.heading - self.relative.heading),
        );
        let (sin, cos) = math::sin_cos(from.heading);
        let by_to = Matrix3::new(cos, sin, 0.0, -sin, cos, 0.0, 0.0, 0.0, 1.0);
        let by_from = Matrix3::new(-cos, -sin, now.y, sin, -cos, -now.x, 0.0, 0.0, -1.0);
        (error, by_from, by_to)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::math::{FRAC_PI_2, TAU};

    fn edge(from: usize, to: usize, relative: Pose, closes_loop: bool) -> Edge {
        Edge { from, to, relative, information: Matrix3::from_diagonal(&Vector3::new(1e4, 1e4, 1e4)), closes_loop }
    }

    /// A ring of 40 poses whose every step is measured a little too short and turned too far.
    fn ring() -> (PoseGraph, Vec<Pose>) {
        let truth: Vec<Pose> = (0..40)
            .map(|i| {
                let angle = TAU * f64::from(i) / 40.0;
                Pose::new(3.0 * math::sin(angle), 3.0 - 3.0 * math::cos(angle), angle)
            })
            .collect();
        let mut graph = PoseGraph::default();
        graph.add(truth[0]);
        for i in 1..40 {
            let step = between(truth[i - 1], truth[i]);
            let wrong = Pose::new(0.99 * step.x, step.y, step.heading + 0.004);
            graph.add(compose(graph.poses[i - 1], wrong));
            graph.link(edge(i - 1, i, wrong, false));
        }
        (graph, truth)
    }

    fn most_off(graph: &PoseGraph, truth: &[Pose]) -> f64 {
        graph.poses.iter().zip(truth).map(|(a, b)| (a.position() - b.position()).norm()).fold(0.0, f64::max)
    }

    #[test]
    fn closing_a_ring_spreads_its_error() {
        let (mut graph, truth) = ring();
        let before = most_off(&graph, &truth);
        graph.link(edge(39, 0, between(truth[39], truth[0]), true));
        assert!(graph.optimise() > 0.1);
        let after = most_off(&graph, &truth);
        assert!(before > 0.3 && after < 0.2 * before, "{before} m before, {after} m after");
    }

    #[test]
    fn a_wrong_edge_among_right_ones_does_little() {
        let (mut graph, truth) = ring();
        for i in 0..5 {
            graph.link(edge(39 - i, i, between(truth[39 - i], truth[i]), true));
        }
        graph.optimise();
        let before = most_off(&graph, &truth);
        graph.link(edge(10, 30, Pose::new(0.0, 0.0, FRAC_PI_2), true));
        graph.optimise();
        assert!(most_off(&graph, &truth) < before + 0.05);
    }

    #[test]
    fn known_headings_straighten_a_bent_way() {
        // A straight way on which one step was measured turned by 0.02 rad.
        let mut graph = PoseGraph::default();
        graph.add(Pose::new(0.0, 0.0, 0.0));
        let stiff = Matrix3::from_diagonal(&Vector3::new(1e5, 1e5, 4e5));
        for i in 1..40 {
            let step = Pose::new(0.4, 0.0, if i == 20 { 0.02 } else { 0.0 });
            graph.add(compose(graph.poses[i - 1], step));
            graph.link(Edge { from: i - 1, to: i, relative: step, information: stiff, closes_loop: false });
        }
        let end = |graph: &PoseGraph| graph.poses[39].y.abs();
        assert!(end(&graph) > 0.14 && graph.missed_by(6) == 0.0);
        for pose in 1..40 {
            graph.face(KnownHeading { pose, heading: 0.0, deviation: 0.006 });
        }
        assert!((graph.missed_by(6) - 0.02).abs() < 1e-9);
        graph.optimise();
        assert!(end(&graph) < 0.02 && graph.missed_by(6).abs() < 0.001, "{} m", end(&graph));
        // What lies at another angle is no wall of theirs.
        graph.face(KnownHeading { pose: 30, heading: 0.5, deviation: 0.006 });
        graph.optimise();
        assert!(end(&graph) < 0.06, "{} m", end(&graph));
    }

    #[test]
    fn ways_follow_the_edges() {
        let (mut graph, truth) = ring();
        let far = graph.ways(0, f64::INFINITY)[39];
        assert!((far - 39.0 * 0.4667).abs() < 0.3, "{far}");
        assert_eq!(graph.ways(0, 5.0)[39], f64::INFINITY);
        graph.link(edge(39, 0, between(truth[39], truth[0]), true));
        assert!(graph.ways(0, 5.0)[39] < 2.0);
    }
}
