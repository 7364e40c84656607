//! One leaf of a door, and the arc along which it swings.

use super::{
    marking::{beside_lines, mark_around},
    strokes::Strokes,
};
use robovac_core::{
    geometry::{Point, Vector},
    grid::Grid,
    math::{PI, ceil, cos, floor, sin},
};

/// Share of the samples on a line that are dark, at least.
const DRAWN: f64 = 0.9;
/// Share of the samples on either side of an arc that are, at most: tiles and hatching are everywhere. And how far away
/// these are, as a share of the leaf.
const CLUTTER: f64 = 0.3;
const BESIDE: f64 = 0.12;
/// Pixels between leaf and arc that are dark, at most, by pixels of the leaf's length.
const FILLED: f64 = 0.3;
/// How far lines are from where they are looked for, as a share of the leaf: for a first look, and for a thorough one.
const NEAR: f64 = 0.1;
const AT: f64 = 0.02;
/// How much less is drawn counts as much as lines that lie elsewhere, by shares of the leaf; and the least fit.
const OFFSET: f64 = 0.3;
const LEAST_FIT: f64 = 0.89;
/// Pixels between samples, and most samples that are missed at the start.
const STEP: f64 = 1.5;
const MOST_MISSED: i32 = 4;
/// Angles, in degrees: of the first and the last sample of an arc from its ends, and the least and greatest of a leaf.
const FROM_END: f64 = 10.0;
const LEAST_ANGLE: f64 = 72.0;
const MOST_ANGLE: f64 = 95.0;
/// Angles at which lines are looked for between them, where there are few.
const WITHIN: [f64; 6] = [20.0, 29.0, 38.0, 47.0, 56.0, 65.0];
/// Directions of the first samples: at 45, 28, 15 and 65 degrees.
const LOOKS: [[f64; 2]; 4] = [[0.707, 0.707], [0.883, 0.469], [0.966, 0.259], [0.423, 0.906]];
/// A leaf that swings from the doorway.
#[derive(Debug, Clone)]
pub(super) struct Swing {
    hinge: Point,
    /// Directions from the hinge to the other jamb, and into the room.
    along: Vector,
    across: Vector,
    radius: f64,
    /// Angle of the leaf, degrees, and the direction away from it, out of what it swings over.
    angle: f64,
    past: Vector,
    /// How well it fits what is drawn, up to 1.
    pub drawn: f64,
}

impl Swing {
    /// The leaf that hangs at `hinge` and shuts at `jamb`, or about there, and opens to the left or to the right of the
    /// way there.
    pub fn fit(strokes: &Strokes, hinge: Point, jamb: Point, is_left: bool) -> Option<Self> {
        let width = (jamb - hinge).norm();
        let along = (jamb - hinge) / width;
        let across = Vector::new(-along.y, along.x) * if is_left { 1.0 } else { -1.0 };
        let guess = Self { hinge, along, across, radius: width, angle: 90.0, past: -along, drawn: 0.0 };
        let middle = guess.look(LOOKS[1], 0.55);
        let clear = ceil(NEAR * width);
        if strokes.to_thin(middle).min(strokes.to_thick(middle)) < clear {
            return None;
        }
        let (near, leaf) = (clear + 1, guess.look([0.1, 0.99], 0.6));
        if strokes.to_thin(leaf).min(strokes.to_thick(leaf)) > 2 * near {
            return None;
        }
        if LOOKS.into_iter().any(|look| strokes.to_thin(guess.look(look, 1.0)) > near) {
            return None;
        }
        if guess.is_cluttered(strokes) {
            return None;
        }
        let mut best: Option<Self> = None;
        // The leaf can hang within the wall, or at a frame.
        for index in 0..5 * 6 * 4 {
            let by = [index % 5 - 2, index / 5 % 6 - 4, index / 30 - 2].map(|steps| f64::from(steps) * 0.04 * width);
            let swing =
                Self { hinge: hinge + along * by[0] + across * by[1], radius: width - by[0] + by[2], ..guess.clone() };
            let Some(mut swing) = swing.drawn(strokes) else { continue };
            // The nearest of those that are drawn as well.
            swing.drawn -= OFFSET * by.iter().map(|by| by.abs()).sum::<f64>() / width;
            if best.as_ref().is_none_or(|best| swing.drawn > best.drawn) {
                best = Some(swing);
            }
        }
        best.filter(|swing| swing.drawn >= LEAST_FIT && swing.is_clear(strokes))
    }

    /// Whether lines are in much of what a leaf swings over, well within its lines: a look at a few places spares trying all leaves
    /// in a picture full of specks.
    fn is_cluttered(&self, strokes: &Strokes) -> bool {
        let near = self.near();
        let places = WITHIN.iter().flat_map(|&degrees| [0.3, 0.42, 0.54, 0.66].map(|share| self.at(degrees, share)));
        let dark = places.filter(|&at| strokes.to_thin(at).min(strokes.to_thick(at)) <= near).count();
        dark as f64 > CLUTTER * 4.0 * WITHIN.len() as f64
    }

    /// The place in a direction, and at a share of the radius.
    fn look(&self, [along, across]: [f64; 2], share: f64) -> Point {
        self.hinge + (self.along * along + self.across * across) * (share * self.radius)
    }

    /// The place at an angle in degrees, and a share of the radius.
    fn at(&self, degrees: f64, share: f64) -> Point {
        let angle = degrees * PI / 180.0;
        self.look([cos(angle), sin(angle)], share)
    }

    /// The same with its angle, and how much of it is drawn; `None` if that is too little.
    fn drawn(self, strokes: &Strokes) -> Option<Self> {
        let near = self.near() + 1;
        if [LOOKS[0], LOOKS[2], LOOKS[3]].into_iter().any(|look| strokes.to_thin(self.look(look, 1.0)) > near) {
            return None;
        }
        let (arc, end) = self.arc(strokes)?;
        let end = end + FROM_END;
        if end < LEAST_ANGLE {
            return None;
        }
        let mut best: Option<(f64, f64)> = None;
        for by in [0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0, -4.0] {
            let angle = (end + 2.0 * by).clamp(LEAST_ANGLE, MOST_ANGLE);
            let share = self.leaf(strokes, angle);
            if share >= DRAWN && best.is_none_or(|(most, _)| share > most) {
                best = Some((share, angle));
            }
        }
        let (leaf, angle) = best?;
        let turned = angle * PI / 180.0;
        let past = self.across * cos(turned) - self.along * sin(turned);
        Some(Self { angle, past, drawn: f64::midpoint(arc, leaf), ..self })
    }

    /// How near a line has to be, pixels.
    fn near(&self) -> i32 {
        ceil(AT * self.radius).max(1)
    }

    /// The share of an arc that is drawn, and the angle up to which it is, degrees.
    fn arc(&self, strokes: &Strokes) -> Option<(f64, f64)> {
        let near = self.near();
        let step = STEP / self.radius;
        let (sin, cos) = (sin(step), cos(step));
        let mut to = self.at(FROM_END, 1.0) - self.hinge;
        // A quarter of a turn on.
        let turned = |to: Vector| self.across * to.dot(&self.along) - self.along * to.dot(&self.across);
        let (mut hits, mut count, mut found) = (0, 0, None);
        let mut degrees = FROM_END;
        while degrees <= MOST_ANGLE - FROM_END {
            count += 1;
            hits += i32::from(strokes.to_thin(self.hinge + to) <= near);
            let share = f64::from(hits) / f64::from(count);
            if share >= DRAWN {
                found = Some((share, degrees));
            } else if count - hits > MOST_MISSED {
                break;
            }
            to = to * cos + turned(to) * sin;
            degrees += step * 180.0 / PI;
        }
        found
    }

    /// The share of the leaf at an angle in degrees that is drawn, or is close to a wall; 0 if that is too little.
    fn leaf(&self, strokes: &Strokes, degrees: f64) -> f64 {
        let near = self.near();
        let count = ceil(0.7 * self.radius / STEP);
        let tip = self.at(degrees, 1.0) - self.hinge;
        let mut samples = (0..count).map(|step| self.hinge + tip * (0.2 + 0.7 * f64::from(step) / f64::from(count)));
        let mut left_to_miss = floor((1.0 - DRAWN) * f64::from(count) + 1e-9);
        let missed = samples.try_fold(0, |missed, at| {
            let is_missed = strokes.to_thin(at).min(strokes.to_thick(at)) > near;
            left_to_miss -= i32::from(is_missed);
            (left_to_miss >= 0).then_some(missed + i32::from(is_missed))
        });
        missed.map_or(0.0, |missed| f64::from(count - missed) / f64::from(count))
    }

    /// Whether there is hardly anything between the doorway, the leaf and the arc, nor beyond the arc.
    fn is_clear(&self, strokes: &Strokes) -> bool {
        let beside = self.beside() / self.radius;
        let near = self.near();
        let ring = |share: f64| {
            let degrees = (15..=self.angle as i32 - 15).step_by(3);
            let (dark, all) = degrees.fold((0, 0), |(dark, all), degrees| {
                let at = self.at(f64::from(degrees), share);
                (dark + i32::from(strokes.to_thin(at).min(strokes.to_thick(at)) <= near), all + 1)
            });
            f64::from(dark) / f64::from(all)
        };
        if ring(1.0 + beside) > CLUTTER || ring(1.0 - beside) > CLUTTER {
            return false;
        }
        let mut dark = 0;
        let far = ceil(self.radius);
        for y in -far..=far {
            for x in -far..=far {
                let by = Vector::new(f64::from(x), f64::from(y));
                dark += i32::from(self.is_inside(by) && strokes.is_dark(self.hinge + by));
            }
        }
        f64::from(dark) <= FILLED * self.radius
    }

    /// Whether another leaf swings over the same floor.
    pub fn overlaps(&self, other: &Self) -> bool {
        (self.at(45.0, 0.6) - other.at(45.0, 0.6)).norm() < 0.4 * self.radius.max(other.radius)
    }

    /// Marks the lines of the symbol.
    pub fn mark(&self, strokes: &Strokes, found: &mut Grid<bool>) {
        let beside = beside_lines(self.radius);
        let far = self.radius + beside;
        mark_around(strokes, found, self.hinge, far, |by| {
            let is_in = by.norm() <= far && by.dot(&self.across) >= -beside && by.dot(&self.past) <= beside;
            is_in && !self.is_inside(by)
        });
    }

    /// Whether a place, seen from the hinge, is well within the leaf, the arc and the doorway.
    fn is_inside(&self, by: Vector) -> bool {
        let beside = self.beside();
        by.dot(&self.across) > beside && by.dot(&self.past) < -beside && by.norm() < self.radius - beside
    }

    /// How far from its lines it has to be clear, pixels.
    fn beside(&self) -> f64 {
        (BESIDE * self.radius).max(4.0)
    }
}
