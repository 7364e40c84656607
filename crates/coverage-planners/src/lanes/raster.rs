//! How often each sample of the floor is swept, counted up and down while a path changes.

use super::{
    row_ends::RowEnds,
    scan::rotation,
    stroke::{SampleRun, SweptDisc},
    tool::ToolPlace,
};
use robovac_core::{
    coverage::ReachableFloor,
    geometry::{Point, Vector},
    math,
};

/// Angle of the raster to the lanes, rad: neither walls nor lanes are parallel to it, so that what is missed between two lanes
/// can't hide between two rows of samples. A small one: lanes in one of two directions meet few rows.
const ANGLE: f64 = 0.19;
/// As far from lanes in other directions is far enough, rad.
const LEAST_ANGLE: f64 = 0.1;
/// Samples across the tool: in rooms below so many m², where each counts for more, and in larger ones.
const ACROSS: (f64, f64, f64) = (30.0, 10.0, 7.0);
/// Samples along a side of a block, as a power of two.
const BLOCK: i32 = 4;
/// Most samples.
const MOST_SAMPLES: f64 = 12e6;
/// Bits of a count: strokes over a sample are counted modulo 32.
const BITS: usize = 5;
/// Samples in a word from which on it's chosen for certain.
const CROWD: u32 = 8;

/// 64 samples of a row in a cache line, a bit each.
#[derive(Debug, Clone, Copy, Default)]
#[repr(align(64))]
struct Word {
    /// The bits of the counts, lowest first.
    counts: [u64; BITS],
    floor: u64,
    /// On the floor, with count 0 and with count 1.
    unswept: u64,
    once: u64,
}

/// Samples of the floor at a spacing of a tenth or a seventh of the tool's width, and how often each is swept.
#[derive(Debug, Clone)]
pub(super) struct SweptRaster {
    /// Metres between samples.
    pub spacing: f64,
    /// Cosine and sine of the raster's angle.
    turn: Vector,
    /// Position of the first sample in the turned frame, m.
    origin: Vector,
    /// In samples.
    width: i32,
    height: i32,
    /// The tool, and its radius, in samples.
    pub tool: ToolPlace,
    radius: f64,
    words: Vec<Word>,
    words_across: i32,
    /// Number of samples on the floor, of those with count 0, and of these in each square block.
    samples: i64,
    unswept: i64,
    blocks: Vec<u16>,
    blocks_across: i32,
    /// The words with floor.
    floor: Vec<u32>,
    /// Strokes of an exchange with +1 if new and -1 if old, and where they begin and end in a row; kept for their memory.
    strokes: Vec<StrokeRuns>,
    runs: Vec<SampleRun>,
    /// Rows and runs in which the last exchange changes counts, and by how much.
    changes: Vec<(i32, SampleRun, i32)>,
}

impl Word {
    /// Counts one stroke more for the samples of `mask`.
    #[inline]
    fn add(&mut self, mask: u64) {
        let mut carry = mask;
        for bits in &mut self.counts {
            (*bits, carry) = (*bits ^ carry, *bits & carry);
        }
    }

    /// Counts one stroke less.
    #[inline]
    fn take(&mut self, mask: u64) {
        let mut borrow = mask;
        for bits in &mut self.counts {
            (*bits, borrow) = (*bits ^ borrow, !*bits & borrow);
        }
    }

    /// Sets which samples have count 0 and 1.
    #[inline]
    fn update(&mut self) {
        let more = self.counts[1..].iter().fold(0, |more, bits| more | bits);
        self.unswept = self.floor & !(more | self.counts[0]);
        self.once = self.floor & self.counts[0] & !more;
    }

    /// The samples on the floor with a count of at least 1.
    #[inline]
    fn counted(&self, count: u32) -> u64 {
        if count == 1 {
            return self.once;
        }
        let equal = |equal, (bit, bits): (usize, &u64)| equal & if count >> bit & 1 == 1 { *bits } else { !bits };
        self.counts.iter().enumerate().fold(self.floor, equal)
    }
}

/// The bits of a word, the `word`th of its row, that belong to a run.
#[inline]
fn mask(word: i32, (from, to): SampleRun) -> u64 {
    let below = |end: i32| {
        let bits = (end - (word << 6)).clamp(0, 64);
        if bits < 64 { (1_u64 << bits) - 1 } else { u64::MAX }
    };
    below(to) & !below(from)
}

impl SweptRaster {
    /// Samples of a floor for lanes along the directions `along`, of length 1, or across them.
    pub fn new(floor: &ReachableFloor, along: &[Vector]) -> Self {
        let (width, height) = (floor.floor.width() as f64, floor.floor.height() as f64);
        let size = Vector::new(width, height) * floor.resolution;
        let turn = askew_to(along);
        let corners = [[0.0, 0.0], [size.x, 0.0], [0.0, size.y], [size.x, size.y]];
        let corners = corners.map(|[x, y]| into_frame(turn, Point::new(x, y)));
        let low = corners.iter().fold(corners[0], |low, c| low.inf(c));
        let high = corners.iter().fold(corners[0], |high, c| high.sup(c));
        let extent = high - low;
        let least = (extent.x * extent.y / MOST_SAMPLES).sqrt();
        let across = if floor.area() < ACROSS.0 { ACROSS.1 } else { ACROSS.2 };
        let spacing = (2.0 * floor.tool_radius / across).max(least);
        let count = |metres: f64| (metres / spacing) as i32 + 1;
        let (width, height) = (count(extent.x), count(extent.y));
        let words_across = (width + 63) >> 6;
        let blocks_across = words_across << (6 - BLOCK);
        let mut raster = Self {
            spacing,
            turn,
            origin: low,
            width,
            height,
            tool: ToolPlace::of(floor),
            radius: floor.tool_radius / spacing,
            words: vec![Word::default(); (words_across * height) as usize],
            words_across,
            samples: 0,
            unswept: 0,
            blocks: vec![0; (blocks_across * ((height >> BLOCK) + 1)) as usize],
            blocks_across,
            floor: Vec::new(),
            strokes: Vec::new(),
            runs: Vec::new(),
            changes: Vec::new(),
        };
        for row in 0..height {
            for word in 0..words_across {
                let index = row * words_across + word;
                let mut bits = 0_u64;
                for bit in 0..64.min(width - (word << 6)) {
                    let at = raster.sample(row, (word << 6) + bit);
                    bits |= u64::from(floor.floor.is_set(floor.cell_at(at))) << bit;
                }
                if bits == 0 {
                    continue;
                }
                raster.words[index as usize] = Word { floor: bits, unswept: bits, ..Word::default() };
                raster.floor.push(index as u32);
                raster.samples += i64::from(bits.count_ones());
                raster.change_blocks(row, word, 0, bits);
            }
        }
        raster.unswept = raster.samples;
        raster
    }

    /// Position of a sample.
    fn sample(&self, row: i32, column: i32) -> Point {
        let at = self.origin + Vector::new(f64::from(column), f64::from(row)) * self.spacing;
        Point::new(self.turn.x * at.x - self.turn.y * at.y, self.turn.y * at.x + self.turn.x * at.y)
    }

    /// The position of some floor that isn't swept, chosen by two numbers from 0 to 1, or nothing: then try others.
    pub fn unswept_at(&self, word: f64, sample: f64) -> Option<Point> {
        let index = *self.floor.get((word * self.floor.len() as f64) as usize)? as i32;
        let unswept = self.words[index as usize].unswept;
        // One that many others are near is as likely as one alone.
        let choice = (sample * f64::from(CROWD.max(unswept.count_ones()))) as u32;
        let bit = (0..64).filter(|bit| unswept >> bit & 1 == 1).nth(choice as usize)?;
        Some(self.sample(index / self.words_across, ((index % self.words_across) << 6) + bit))
    }

    /// Floor that isn't swept, m².
    #[inline]
    pub fn unswept_area(&self) -> f64 {
        self.unswept as f64 * self.spacing * self.spacing
    }

    /// Area of the floor by samples, m².
    pub fn floor_area(&self) -> f64 {
        self.samples as f64 * self.spacing * self.spacing
    }

    /// Floor that a path would leave unswept, m². Nothing must have been counted.
    pub fn left_by(&mut self, path: &[Point]) -> f64 {
        path.windows(2).for_each(|pair| self.add(pair[0], pair[1]));
        let left = self.unswept_area();
        path.windows(2).for_each(|pair| self.remove(pair[0], pair[1]));
        left
    }

    /// Counts a stroke of the tool from `a` to `b`.
    pub fn add(&mut self, a: Point, b: Point) {
        self.exchange(&[], &[(a, b)]);
    }

    /// Takes a stroke back.
    pub fn remove(&mut self, a: Point, b: Point) {
        self.exchange(&[(a, b)], &[]);
    }

    /// How much more floor would stay unswept if the strokes `new` took the place of `old`, m²; infinite if more than `most`
    /// is lost, whatever is won.
    pub fn missed_by(&mut self, old: &[(Point, Point)], new: &[(Point, Point)], most: f64) -> f64 {
        let area = self.spacing * self.spacing;
        let (mut won, mut lost, most) = (0_u32, 0_u32, (most / area).min(1e9) as u32);
        let rows = self.begin_exchange(old, new);
        let mut changes = std::mem::take(&mut self.changes);
        changes.clear();
        let mut ends = RowEnds::new();
        for row in rows.0..rows.1 {
            self.ends_in_row(row, &mut ends);
            let line = &self.words[(row * self.words_across) as usize..][..self.words_across as usize];
            ends.each_run(|run, by| {
                changes.push((row, run, by));
                for word in run.0 >> 6..=(run.1 - 1) >> 6 {
                    let (mask, word) = (mask(word, run), &line[word as usize]);
                    if by > 0 {
                        won += (word.unswept & mask).count_ones();
                    } else {
                        // Nobody but the old strokes sweeps what is counted as often as it's taken.
                        lost += (word.counted(by.unsigned_abs()) & mask).count_ones();
                    }
                }
            });
            if lost > most {
                break;
            }
        }
        self.changes = changes;
        if lost > most { f64::INFINITY } else { (f64::from(lost) - f64::from(won)) * area }
    }

    /// Makes the exchange that [`Self::missed_by`] has looked at last, and not broken off.
    pub fn make_exchange(&mut self) {
        let changes = std::mem::take(&mut self.changes);
        for &(row, run, by) in &changes {
            self.change(row, run, by);
        }
        self.changes = changes;
    }

    /// No more floor than this, m², could the strokes `new` sweep anew, other than those that are among `old`.
    pub fn could_win(&self, old: &[(Point, Point)], new: &[(Point, Point)]) -> f64 {
        let mut samples = 0_u32;
        for &(a, b) in new.iter().filter(|piece| !old.contains(piece)) {
            let SweptDisc { low, high, rows, slope, radius, .. } = self.stroke(a, b);
            let (left, right) = (low.x.min(high.x), low.x.max(high.x));
            // A piece that nobody has checked can lie off the map.
            if rows.0 >= rows.1 {
                continue;
            }
            for block_row in rows.0 >> BLOCK..=(rows.1 - 1) >> BLOCK {
                // The part of the segment that is no farther from these rows than the tool reaches.
                let bottom = f64::from(block_row << BLOCK) - radius;
                let top = f64::from((block_row + 1) << BLOCK) + radius;
                let at = |y: f64| low.x + slope * (y.clamp(low.y, high.y) - low.y);
                let (mut from, mut to) = (left, right);
                if slope.is_finite() {
                    let ends = (at(bottom), at(top));
                    (from, to) = (ends.0.min(ends.1), ends.0.max(ends.1));
                }
                let first = math::floor(from - radius).clamp(0, self.width - 1) >> BLOCK;
                let last = math::ceil(to + radius).clamp(0, self.width - 1) >> BLOCK;
                let start = block_row * self.blocks_across;
                let blocks = &self.blocks[(start + first) as usize..=(start + last) as usize];
                samples += blocks.iter().map(|&count| u32::from(count)).sum::<u32>();
            }
        }
        f64::from(samples) * self.spacing * self.spacing
    }

    /// Counts the strokes `new` instead of `old`; only where they differ are samples visited.
    pub fn exchange(&mut self, old: &[(Point, Point)], new: &[(Point, Point)]) {
        let _ = self.missed_by(old, new, f64::MAX);
        self.make_exchange();
    }

    /// Takes the strokes in which `old` and `new` differ; returns the rows that they meet.
    fn begin_exchange(&mut self, old: &[(Point, Point)], new: &[(Point, Point)]) -> (i32, i32) {
        let (mut strokes, mut runs) = (std::mem::take(&mut self.strokes), std::mem::take(&mut self.runs));
        strokes.clear();
        runs.clear();
        let mut all = (i32::MAX, i32::MIN);
        for (these, others, is_new) in [(old, new, false), (new, old, true)] {
            for &(a, b) in these.iter().filter(|piece| !others.contains(piece)) {
                let stroke = self.stroke(a, b);
                let rows = stroke.rows;
                strokes.push(StrokeRuns { rows, first: runs.len(), is_new });
                stroke.push_runs(self.width, &mut runs);
                all = (all.0.min(rows.0), all.1.max(rows.1));
            }
        }
        (self.strokes, self.runs) = (strokes, runs);
        all
    }

    /// Where the strokes of the exchange begin and end in a row.
    #[inline]
    fn ends_in_row(&self, row: i32, ends: &mut RowEnds) {
        ends.clear();
        for stroke in &self.strokes {
            if row >= stroke.rows.0 && row < stroke.rows.1 {
                ends.push(self.runs[stroke.first + (row - stroke.rows.0) as usize], stroke.is_new);
            }
        }
    }

    /// Adds to the counts of a run.
    fn change(&mut self, row: i32, run: SampleRun, by: i32) {
        for word in run.0 >> 6..=(run.1 - 1) >> 6 {
            let mask = mask(word, run);
            let words = &mut self.words[(row * self.words_across + word) as usize];
            let before = words.unswept;
            for _ in 0..by.abs() {
                if by > 0 { words.add(mask) } else { words.take(mask) }
            }
            words.update();
            let after = words.unswept;
            if before != after {
                self.unswept += i64::from(after.count_ones()) - i64::from(before.count_ones());
                self.change_blocks(row, word, before, after);
            }
        }
    }

    /// Counts what isn't swept in the blocks of a word.
    fn change_blocks(&mut self, row: i32, word: i32, before: u64, after: u64) {
        let first = ((row >> BLOCK) * self.blocks_across + (word << (6 - BLOCK))) as usize;
        let part = |bits: u64, block: usize| (bits >> (block << BLOCK) & 0xffff).count_ones() as u16;
        for block in 0..1_usize << (6 - BLOCK) {
            let count = &mut self.blocks[first + block];
            *count = *count + part(after, block) - part(before, block);
        }
    }

    fn stroke(&self, a: Point, b: Point) -> SweptDisc {
        let (a, b) = self.tool.stroke(a, b);
        let local = |p: Point| (into_frame(self.turn, p) - self.origin) / self.spacing;
        SweptDisc::new(local(a), local(b), self.radius, self.height)
    }
}

/// A direction at the angle of the raster to the first of `along`, or if that is too near another one, to one that leaves more room.
fn askew_to(along: &[Vector]) -> Vector {
    let candidates = along.iter().flat_map(|along| {
        [ANGLE, -ANGLE].map(|angle| {
            let by = rotation(angle);
            Vector::new(along.x * by.x - along.y * by.y, along.x * by.y + along.y * by.x)
        })
    });
    // The sine of the angle to the nearest lane.
    let room = |turn: Vector| {
        along.iter().map(|way| way.dot(&turn).abs().min(way.perp(&turn).abs())).fold(LEAST_ANGLE, f64::min)
    };
    let better = |best: (f64, Vector), turn: Vector| if room(turn) > best.0 { (room(turn), turn) } else { best };
    candidates.fold((f64::MIN, Vector::new(1.0, 0.0)), better).1
}

fn into_frame(turn: Vector, p: Point) -> Vector {
    Vector::new(turn.x * p.x + turn.y * p.y, turn.x * p.y - turn.y * p.x)
}

/// Where a stroke's runs are, one for each of its rows.
#[derive(Debug, Clone)]
struct StrokeRuns {
    rows: (i32, i32),
    first: usize,
    is_new: bool,
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::RngExt;
    use robovac_core::{floor_plan::Sketch, geometry::nearest_on_segment, rng::seeded, robot::model};

    #[test]
    fn rows_are_askew_to_all_lanes() {
        let by = |degrees: f64| rotation(degrees.to_radians());
        assert_eq!(askew_to(&[by(0.0)]), rotation(ANGLE));
        for degrees in 0..90 {
            let along = [by(0.0), by(f64::from(degrees)), by(33.0)];
            let turn = askew_to(&along);
            let room = along.map(|way| way.dot(&turn).abs().min(way.perp(&turn).abs()));
            assert!(room.into_iter().all(|room| room > 0.09), "{degrees} degrees: {room:?}");
        }
    }

    #[test]
    fn counts_are_those_of_every_sample_and_return_to_what_they_were() {
        let plan = Sketch::open(2.0, 1.5, 0.05).fill(&[[0.9, 0.6, 1.1, 0.8]]).finish("", "");
        let floor = ReachableFloor::new(&plan, model("roomba600").unwrap(), None).unwrap();
        let mut raster = SweptRaster::new(&floor, &[Vector::new(1.0, 0.0)]);
        let mut rng = seeded(5, 0);
        let mut at = || Point::new(rng.random_range(0.1..1.9), rng.random_range(0.1..1.4));
        let all = raster.unswept;
        for _ in 0..200 {
            let (a, b, c, d) = (at(), at(), at(), at());
            raster.add(a, b);
            let could = raster.could_win(&[(a, b)], &[(c, d)]);
            let lone = raster.unswept_area();
            let missed = raster.missed_by(&[(a, b)], &[(c, d)], 1e9);
            let before = raster.unswept_area();
            raster.exchange(&[(a, b)], &[(c, d)]);
            assert!((raster.unswept_area() - before - missed).abs() < 1e-9);
            raster.add(a, b);
            assert!(lone - raster.unswept_area() <= could + 1e-9);
            raster.remove(a, b);
            assert_eq!(raster.blocks.iter().map(|&count| i64::from(count)).sum::<i64>(), raster.unswept);
            let near = |p: Point| (nearest_on_segment(c, d, p) - p).norm() < floor.tool_radius;
            let samples = (0..raster.height).flat_map(|row| (0..raster.width).map(move |column| (row, column)));
            let is_floor = |p: Point| floor.floor.is_set(floor.cell_at(p));
            let at = samples.map(|(row, column)| raster.sample(row, column)).filter(|&p| is_floor(p));
            let left = at.filter(|&p| !near(p)).count() as i64;
            // A sample at the very edge may be rounded either way.
            assert!((raster.unswept - left).abs() <= 1, "{} {left}", raster.unswept);
            let unswept: u32 = raster.words.iter().map(|word| word.unswept.count_ones()).sum();
            assert_eq!(i64::from(unswept), raster.unswept);
            raster.remove(c, d);
            assert_eq!(raster.unswept, all);
        }
    }
}
