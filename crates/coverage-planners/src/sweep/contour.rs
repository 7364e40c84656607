//! A linking order whose links don't cross.
//!
//! A scan line's free run reaches from contact to contact, so nothing gets past it without crossing it. A path that
//! sweeps every run in one go can therefore pass every channel between obstacles once only, which is impossible as soon
//! as an obstacle stands in the middle. So here runs are cut in two where a channel has to be passed twice: one half of
//! its lines is swept on the way there, the other on the way back.
//!
//! Runs on neighbouring lines are joined where the body can move straight from one to the other. A spanning tree of
//! these joints (Tarjan 1972) is walked round like a wall that one keeps a hand on, as in spanning tree coverage
//! (Gabriely & Rimon 2001): such a walk never crosses itself. From the first run to a leaf one needn't come back: on that
//! way runs are swept in one go, and what branches off is walked round first.
//!
//! Ours; the paper asks for it (abstract and section 2) without telling how.

use super::linker::CornerLine;
use crate::stage::Subgoal;
use robovac_core::{cspace::Motion, geometry::Point};

/// Shares of an overlap, from either end, at which a joint is looked for.
const SHARES: [f64; 7] = [0.0, 0.01, 0.03, 0.08, 0.16, 0.3, 0.5];
/// Shares of an overlap, from its middle, at which a cut is looked for.
const CUTS: [f64; 9] = [0.0, -0.05, 0.05, -0.15, 0.15, -0.3, 0.3, -0.45, 0.45];
/// Most distance of the ways there and back at a cut, as a share of the body's length.
const CUT: f64 = 0.1;

/// A free run of a scan line.
#[derive(Debug)]
struct FreeRun {
    /// Numbers of the subgoals at its left and right end, and their x, m.
    ends: [usize; 2],
    x: [f64; 2],
    y: f64,
    line: u32,
    /// Joints with runs below and above, from left to right.
    beside: [Vec<usize>; 2],
}

/// Where the body can move straight from a run to one on the next line.
#[derive(Debug)]
struct Joint {
    /// The upper and the lower run.
    runs: [usize; 2],
    /// The leftmost and the rightmost known place, m.
    reach: [f64; 2],
    /// The places for going there and back, from left to right, m.
    pair: [f64; 2],
    is_in_tree: bool,
}

/// A stop on the way round a run.
#[derive(Debug, Clone, Copy, PartialEq)]
enum RunStop {
    /// Its left or right end.
    End(usize),
    /// A joint.
    Joint(usize),
}

/// A walk along runs under construction. `reach` is called with every subgoal that is reached for the first time and with
/// the way there from the one before.
pub(super) struct ContourWalk<'a> {
    runs: Vec<FreeRun>,
    joints: Vec<Joint>,
    /// The run of every subgoal.
    run_of: Vec<usize>,
    /// Runs in its tree that hang on each.
    sizes: Vec<usize>,
    is_done: Vec<bool>,
    places: &'a [Point],
    is_reached: Vec<bool>,
    line: CornerLine,
    /// Links: the subgoal, and the way there.
    found: Vec<(usize, Vec<Point>)>,
}

impl<'a> ContourWalk<'a> {
    /// Joins the runs between subgoals, whose exact `places` are in the same order.
    pub fn new(points: &[Subgoal], places: &'a [Point], motion: &Motion) -> Self {
        let mut sorted: Vec<usize> = (0..points.len()).collect();
        sorted.sort_unstable_by_key(|&number| {
            let s = &points[number];
            (s.line, s.at.x, !s.contact.is_left())
        });
        let mut run_of = vec![0; points.len()];
        let runs: Vec<FreeRun> = sorted
            .chunks_exact(2)
            .enumerate()
            .map(|(index, pair)| {
                let ends = [pair[0], pair[1]];
                for end in ends {
                    run_of[end] = index;
                }
                let x = ends.map(|end| places[end].x);
                FreeRun { ends, x, y: places[ends[0]].y, line: points[ends[0]].line, beside: [Vec::new(), Vec::new()] }
            })
            .collect();
        let count = runs.len();
        let mut walk = Self {
            runs,
            joints: Vec::new(),
            run_of,
            sizes: vec![1; count],
            is_done: vec![false; count],
            places,
            is_reached: vec![false; points.len()],
            line: CornerLine::default(),
            found: Vec::new(),
        };
        walk.join(motion);
        walk
    }

    /// Joins neighbouring runs.
    fn join(&mut self, motion: &Motion) {
        let (low, high) = motion.outline().bounds();
        let length = high.x - low.x;
        let mut begin = 0;
        for upper in 0..self.runs.len() {
            let line = self.runs[upper].line;
            while begin < self.runs.len() && self.runs[begin].line <= line {
                begin += 1;
            }
            let below = (begin..self.runs.len()).take_while(|&lower| self.runs[lower].line == line + 1);
            for lower in below.collect::<Vec<_>>() {
                let (u, w) = (&self.runs[upper], &self.runs[lower]);
                let (left, right) = (u.x[0].max(w.x[0]), u.x[1].min(w.x[1]));
                if left > right {
                    continue;
                }
                let (high, low) = (u.y, w.y);
                let is_free = |x: f64| motion.is_free(Point::new(x, high), Point::new(x, low));
                let wide = right - left;
                let from = |end: f64, towards: f64| {
                    SHARES.iter().map(|share| end + towards * share * wide).find(|&x| is_free(x))
                };
                let (Some(first), Some(last)) = (from(left, 1.0), from(right, -1.0)) else { continue };
                // On every other line the ways there and back are in the middle: so the halves are swept to and fro.
                let middle = 0.5 * (left + right);
                let apart = (CUT * length).min(0.25 * wide);
                let is_cut = line % 2 == 1;
                let near = CUTS.iter().map(|share| middle + share * wide).find(|&x| is_free(x));
                let pair = match near.filter(|_| is_cut) {
                    None => [first, last],
                    Some(x) => {
                        let pair = [x - 0.5 * apart, x + 0.5 * apart];
                        let is_both = pair[0] >= left && pair[1] <= right && pair.iter().all(|&x| is_free(x));
                        if is_both { pair } else { [x; 2] }
                    }
                };
                let joint = self.joints.len();
                self.joints.push(Joint { runs: [upper, lower], reach: [first, last], pair, is_in_tree: false });
                self.runs[upper].beside[0].push(joint);
                self.runs[lower].beside[1].push(joint);
            }
        }
    }

    /// Walks from a subgoal to all that can be reached by joints. Returns them in order, each with the way there from the
    /// one before.
    pub fn walk(&mut self, from: usize) -> Vec<(usize, Vec<Point>)> {
        let root = self.run_of[from];
        let end = usize::from(self.runs[root].ends[1] == from);
        self.grow(root);
        self.line = CornerLine::default();
        self.is_reached[from] = true;
        self.line.extend(&[self.places[from]]);
        // Along the way that isn't gone back.
        let (mut run, mut came) = (root, RunStop::End(end));
        loop {
            let mut ring = self.ring(run, came);
            let size = |stop: &RunStop| match stop {
                RunStop::Joint(joint) => self.sizes[self.across(*joint, run)],
                RunStop::End(_) => 0,
            };
            let joints: Vec<RunStop> = ring.iter().copied().filter(|stop| matches!(stop, RunStop::Joint(_))).collect();
            // What comes last on the way round, in one direction or the other, is where one goes on.
            let is_forward = match joints[..] {
                [first, .., last] if joints.len() > 1 => size(&last) >= size(&first),
                // The nearer end first.
                _ => {
                    let place = ring.iter().position(|stop| matches!(stop, RunStop::Joint(_))).unwrap_or(0);
                    let begin = ring[place..].iter().rev().chain(&ring).find(|stop| matches!(stop, RunStop::End(_)));
                    (begin == Some(&RunStop::End(1))) == self.is_nearer_right(run, self.at().x)
                }
            };
            if !is_forward {
                ring.reverse();
            }
            let next = if is_forward { joints.last() } else { joints.first() }.copied();
            let place = ring.iter().position(|&stop| Some(stop) == next).unwrap_or(0);
            // One comes to it from the left below the run and from the right above it, or the other way round.
            let through = next.map(|next| {
                let joint = &self.joints[if let RunStop::Joint(joint) = next { joint } else { 0 }];
                joint.reach[usize::from((joint.runs[1] == run) == is_forward)]
            });
            // What is beyond it comes first, while nothing is in the way there.
            for stop in ring[place..].iter().rev() {
                if let RunStop::End(end) = *stop {
                    self.go_to_end(run, end);
                }
            }
            if let Some(through) = through.filter(|_| joints.len() > 1) {
                self.go(run, through);
            }
            for stop in &ring[..place] {
                match *stop {
                    RunStop::End(end) => self.go_to_end(run, end),
                    RunStop::Joint(joint) => self.walk_round(run, joint, is_forward),
                }
            }
            let (Some(RunStop::Joint(next)), Some(through)) = (next, through) else { break };
            self.go(run, through);
            run = self.across(next, run);
            self.go(run, through);
            came = RunStop::Joint(next);
        }
        std::mem::take(&mut self.found)
    }

    /// Walks round all that hangs on a joint of `run`, and comes back; `is_forward` is counter-clockwise.
    fn walk_round(&mut self, run: usize, joint: usize, is_forward: bool) {
        // Stops that are left of every run on the way, the last first, and the joint to it.
        let mut stack: Vec<(usize, usize, Vec<RunStop>)> = Vec::new();
        let enter = |walk: &mut Self, from: usize, joint: usize| {
            let there = walk.place(joint, from, is_forward);
            let run = walk.across(joint, from);
            walk.go(from, there);
            walk.go(run, there);
            let mut ring = walk.ring(run, RunStop::Joint(joint));
            if is_forward {
                ring.reverse();
            }
            (run, joint, ring)
        };
        stack.push(enter(self, run, joint));
        while let Some((run, joint, ring)) = stack.last_mut() {
            let (run, joint) = (*run, *joint);
            match ring.pop() {
                Some(RunStop::End(end)) => self.go_to_end(run, end),
                Some(RunStop::Joint(next)) => {
                    let entered = enter(self, run, next);
                    stack.push(entered);
                }
                None => {
                    // Back by the other place of the joint.
                    let back = self.place(joint, run, is_forward);
                    self.go(run, back);
                    let from = self.across(joint, run);
                    self.go(from, back);
                    stack.pop();
                }
            }
        }
    }

    /// The place at which one leaves a run by a joint. Counter-clockwise one goes down on the left and up on the right.
    fn place(&self, joint: usize, run: usize, is_forward: bool) -> f64 {
        let Joint { runs, pair, .. } = &self.joints[joint];
        let is_down = runs[0] == run;
        pair[usize::from(is_down != is_forward)]
    }

    /// The run on the other side of a joint.
    fn across(&self, joint: usize, run: usize) -> usize {
        let [upper, lower] = self.joints[joint].runs;
        if upper == run { lower } else { upper }
    }

    /// The stops round a run, counter-clockwise, after the one at which it was entered.
    fn ring(&self, run: usize, after: RunStop) -> Vec<RunStop> {
        let in_tree = |joint: &&usize| self.joints[**joint].is_in_tree;
        let [below, above] = &self.runs[run].beside;
        let mut ring = vec![RunStop::End(0)];
        ring.extend(below.iter().filter(in_tree).map(|&joint| RunStop::Joint(joint)));
        ring.push(RunStop::End(1));
        ring.extend(above.iter().rev().filter(in_tree).map(|&joint| RunStop::Joint(joint)));
        let entered = ring.iter().position(|&stop| stop == after).unwrap_or(0);
        ring.rotate_left(entered + 1);
        ring.pop();
        ring
    }

    fn is_nearer_right(&self, run: usize, x: f64) -> bool {
        let [left, right] = self.runs[run].x;
        right - x < x - left
    }

    fn at(&self) -> Point {
        self.line.corners.last().copied().unwrap_or_else(Point::origin)
    }

    fn go(&mut self, run: usize, x: f64) {
        self.line.extend(&[Point::new(x, self.runs[run].y)]);
    }

    fn go_to_end(&mut self, run: usize, end: usize) {
        let subgoal = self.runs[run].ends[end];
        self.line.extend(&[self.places[subgoal]]);
        if !std::mem::replace(&mut self.is_reached[subgoal], true) {
            let mut way = std::mem::take(&mut self.line).corners;
            // A run so short that both ends are one.
            if way.len() < 2 {
                way.push(self.places[subgoal]);
            }
            self.found.push((subgoal, way));
            self.line.extend(&[self.places[subgoal]]);
        }
    }

    /// Chooses the joints of a tree, depth first, and counts what hangs on every run.
    fn grow(&mut self, root: usize) {
        let mut order = Vec::new();
        let mut stack = vec![(root, usize::MAX)];
        while let Some((run, joint)) = stack.pop() {
            if std::mem::replace(&mut self.is_done[run], true) {
                continue;
            }
            order.push((run, joint));
            if let Some(joint) = self.joints.get_mut(joint) {
                joint.is_in_tree = true;
            }
            // Downwards first, from the left.
            let [below, above] = &self.runs[run].beside;
            let next = above.iter().rev().chain(below.iter().rev());
            stack.extend(next.map(|&joint| (self.across(joint, run), joint)));
        }
        for &(run, joint) in order.iter().rev().filter(|(_, joint)| *joint != usize::MAX) {
            let parent = self.across(joint, run);
            self.sizes[parent] += self.sizes[run];
        }
    }
}
