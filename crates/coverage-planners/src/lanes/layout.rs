//! The first lanes: parts of the room get a direction each, and lanes are laid as far apart as the tool allows.

use super::{
    directions::{DirectedPart, directed_parts},
    free_space::FreeSpace,
    scan::{across, rotation},
};
use robovac_core::{
    coverage::ReachableFloor,
    geometry::{Point, Vector},
};

/// Spacing of samples in small rooms, m, and most samples.
const SPACING: f64 = 0.0125;
const MOST_SAMPLES: f64 = 6e6;
/// Shortest lane that is laid for what other lanes miss, m; what is shorter is left to the search.
const SHORTEST: f64 = 0.12;
/// Lanes are joined over gaps of so much in which nothing is left to sweep, m.
const JOINED: f64 = 0.35;
/// A lane goes on where it sweeps at least this share of the tool's width anew.
const WORTH: f64 = 0.5;
/// Half the side of the square over which the better direction is averaged, m.
const BLUR: f64 = 0.6;
/// Difference of chords beyond which a direction isn't the better for it, m.
const CLEARLY: f64 = 2.0;
/// Chords shorter than this count as so long, m: they are lost either way.
const LEAST_CHORD: f64 = 0.4;
/// Which lanes cover which part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Directions {
    /// All along the first direction.
    First,
    /// All across it.
    Second,
    /// Each part along its longer chords.
    Both,
    /// Each part in the direction in which fewer lanes end: narrow parts get their way.
    Fewest,
}

/// A straight pass, m.
pub(super) type Lane = (Point, Point);

/// The parts of a room, each with a direction of its own.
pub(super) struct RoomLayout {
    parts: Vec<LaneLayout>,
}

/// Samples of a part's floor and of free space in a frame turned by the first direction.
struct LaneLayout {
    spacing: f64,
    turn: Vector,
    origin: Vector,
    width: usize,
    height: usize,
    is_floor: Vec<bool>,
    is_free: Vec<bool>,
    radius: f64,
}

/// Free and floor samples seen row by row, or column by column.
struct SampleView<'a> {
    layout: &'a LaneLayout,
    is_turned: bool,
    width: usize,
    height: usize,
}

impl LaneLayout {
    /// Samples in the direction of a part's walls, over `corners` in that frame.
    fn new(floor: &ReachableFloor, space: &FreeSpace, part: &DirectedPart, corners: &[Vector]) -> Self {
        let turn = rotation(part.angle);
        let low = corners.iter().fold(corners[0], |low, c| low.inf(c));
        let high = corners.iter().fold(corners[0], |high, c| high.sup(c));
        let extent = high - low;
        let spacing = (extent.x * extent.y / MOST_SAMPLES).sqrt().max(SPACING);
        let count = |metres: f64| (metres / spacing).ceil() as usize + 1;
        let (width, height) = (count(extent.x), count(extent.y));
        let mut layout = Self {
            spacing,
            turn,
            origin: low + Vector::new(0.5, 0.5) * spacing,
            width,
            height,
            is_floor: Vec::with_capacity(width * height),
            is_free: Vec::with_capacity(width * height),
            radius: floor.tool_radius,
        };
        for y in 0..height {
            for x in 0..width {
                let at = layout.point(x as f64, y as f64);
                let cell = floor.cell_at(at);
                layout.is_floor.push(part.floor.is_set(cell));
                // The body's centre is on floor that its tool sweeps.
                layout.is_free.push(floor.floor.is_set(cell) && space.has_room(at));
            }
        }
        layout
    }

    /// A point of the frame, in samples.
    fn point(&self, x: f64, y: f64) -> Point {
        let at = self.origin + Vector::new(x, y) * self.spacing;
        Point::new(self.turn.x * at.x - self.turn.y * at.y, self.turn.y * at.x + self.turn.x * at.y)
    }

    fn view(&self, is_turned: bool) -> SampleView<'_> {
        let (width, height) = if is_turned { (self.height, self.width) } else { (self.width, self.height) };
        SampleView { layout: self, is_turned, width, height }
    }

    /// Lanes that sweep nearly all floor of the part that `others` leave.
    fn laid(&self, directions: Directions, others: &[Lane]) -> Vec<Lane> {
        let mut left: Vec<bool> = self.is_floor.clone();
        for &lane in others {
            self.take(&mut left, lane);
        }
        let mut lanes = Vec::new();
        match directions {
            Directions::First => self.view(false).lay(&mut left, |_| true, &mut lanes),
            Directions::Second => self.view(true).lay(&mut left, |_| true, &mut lanes),
            Directions::Both | Directions::Fewest => {
                let across = self.across(directions);
                self.view(false).lay(&mut left, |i| !across[i], &mut lanes);
                self.view(true).lay(&mut left, |i| across[i], &mut lanes);
                self.view(false).lay(&mut left, |_| true, &mut lanes);
            }
        }
        lanes
    }

    /// Takes what a lane in any direction sweeps off what is left.
    fn take(&self, left: &mut [bool], (a, b): Lane) {
        let into = |p: Point| (into(self.turn, p) - self.origin) / self.spacing;
        let (a, b) = (into(a), into(b));
        let radius = self.radius / self.spacing;
        let first = (a.y.min(b.y) - radius).max(0.0).ceil() as usize;
        let last = (a.y.max(b.y) + radius).min(self.height as f64 - 1.0);
        for y in (first..).take_while(|&y| y as f64 <= last) {
            let Some((from, to)) = across(a, b, radius, y as f64) else { continue };
            let (from, to) = (from.max(0.0).ceil() as usize, (to + 1.0).clamp(0.0, self.width as f64) as usize);
            if from < to {
                left[y * self.width..][from..to].fill(false);
            }
        }
    }

    /// Where chords in the second direction are longer, averaged over about a metre.
    fn across(&self, directions: Directions) -> Vec<bool> {
        let (rows, columns) = (self.view(false).chord_lengths(), self.view(true).chord_lengths());
        let score = |i: usize| {
            let difference = (f64::from(columns[i]) - f64::from(rows[i])) * self.spacing;
            if self.is_floor[i] { difference.clamp(-CLEARLY, CLEARLY) as f32 } else { 0.0 }
        };
        // Lanes end once in a chord's length.
        let ends = |chord: u32| 1.0 / (f64::from(chord) * self.spacing).max(LEAST_CHORD);
        let fewer = |i: usize| if self.is_floor[i] { (ends(rows[i]) - ends(columns[i])) as f32 } else { 0.0 };
        let all = 0..self.is_floor.len();
        let mut scores: Vec<f32> =
            if directions == Directions::Fewest { all.map(fewer).collect() } else { all.map(score).collect() };
        let half = (BLUR / self.spacing) as usize;
        for _ in 0..2 {
            blur(&mut scores, self.width, half);
        }
        scores.iter().map(|&score| score > 0.0).collect()
    }
}

impl RoomLayout {
    /// Samples of all parts of a floor, each in the direction of its walls.
    pub fn new(floor: &ReachableFloor, space: &FreeSpace) -> Self {
        let size = space.size();
        let corners = [[0.0, 0.0], [size.x, 0.0], [0.0, size.y], [size.x, size.y]].map(|[x, y]| Point::new(x, y));
        let mut parts = Vec::new();
        for (number, part) in directed_parts(floor).iter().enumerate() {
            let turn = rotation(part.angle);
            let cells = || part.floor.iter().filter(|&(_, &is_own)| is_own).map(|(cell, _)| floor.centre(cell));
            // The first part is nearly everywhere.
            let corners: Vec<Vector> = if number == 0 {
                corners.iter().map(|&corner| into(turn, corner)).collect()
            } else {
                cells().map(|at| into(turn, at)).collect()
            };
            parts.push(LaneLayout::new(floor, space, part, &corners));
        }
        Self { parts }
    }

    /// The first direction of each part, of length 1.
    pub fn along(&self) -> Vec<Vector> {
        self.parts.iter().map(|part| part.turn).collect()
    }

    /// Lanes in `space` that sweep nearly all floor, in the order in which they were laid.
    pub fn lanes(&self, space: &FreeSpace, directions: Directions) -> Vec<Lane> {
        let mut free = Vec::new();
        for part in &self.parts {
            part.laid(directions, &free).into_iter().for_each(|lane| keep_free(space, lane, &mut free));
        }
        free
    }
}

impl SampleView<'_> {
    fn index(&self, x: usize, y: usize) -> usize {
        if self.is_turned { x * self.layout.width + y } else { y * self.layout.width + x }
    }

    fn point(&self, x: f64, y: f64) -> Point {
        if self.is_turned { self.layout.point(y, x) } else { self.layout.point(x, y) }
    }

    /// Length of the chord of free space through every sample, in samples; 0 off it.
    fn chord_lengths(&self) -> Vec<u32> {
        let mut lengths = vec![0; self.layout.is_free.len()];
        for y in 0..self.height {
            let mut x = 0;
            while x < self.width {
                let start = x;
                while x < self.width && self.layout.is_floor[self.index(x, y)] {
                    x += 1;
                }
                for column in start..x {
                    lengths[self.index(column, y)] = (x - start) as u32;
                }
                x += 1;
            }
        }
        lengths
    }

    /// Lays lanes from the lowest row up. A lane is laid where it's the last to sweep some floor below it.
    fn lay(&self, left: &mut [bool], is_own: impl Fn(usize) -> bool, lanes: &mut Vec<Lane>) {
        let layout = self.layout;
        let radius = (layout.radius / layout.spacing) as usize;
        let shortest = (SHORTEST / layout.spacing) as usize;
        let joined = (JOINED / layout.spacing) as usize;
        let worth = (WORTH * 2.0 * layout.radius / layout.spacing) as usize;
        for y in 0..self.height {
            let mut x = 0;
            while x < self.width {
                if !layout.is_free[self.index(x, y)] {
                    x += 1;
                    continue;
                }
                let start = x;
                while x < self.width && layout.is_free[self.index(x, y)] {
                    x += 1;
                }
                let chord = (start, x);
                let is_due: Vec<bool> = (start..x).map(|x| self.is_due(x, y, radius, left, &is_own)).collect();
                if !is_due.contains(&true) {
                    continue;
                }
                let gain = |x: usize, left: &[bool]| {
                    let low = y.saturating_sub(radius);
                    (low..(y + radius + 1).min(self.height))
                        .filter(|&y| left[self.index(x, y)] && is_own(self.index(x, y)))
                        .count()
                };
                // Stretches that are due or worth it, joined over short gaps.
                let mut stretches: Vec<(usize, usize, usize)> = Vec::new();
                for x in chord.0..chord.1 {
                    let due = is_due[x - chord.0];
                    if !due && gain(x, left) < worth.max(1) {
                        continue;
                    }
                    match stretches.last_mut() {
                        Some(last) if x - last.1 <= joined => {
                            last.1 = x;
                            last.2 += usize::from(due);
                        }
                        _ => stretches.push((x, x, usize::from(due))),
                    }
                }
                for (from, to, due) in stretches {
                    if due < shortest.min((to - from).div_ceil(2) + 1) || to - from < shortest / 2 {
                        continue;
                    }
                    lanes.push((self.point(from as f64, y as f64), self.point(to as f64, y as f64)));
                    self.sweep(left, (from, to), y);
                }
            }
        }
    }

    /// Whether a lane through a sample is the last that sweeps some floor of its column: the floor at the tool's lower
    /// edge, or all of it where the free space ends above.
    fn is_due(&self, x: usize, y: usize, radius: usize, left: &[bool], is_own: &impl Fn(usize) -> bool) -> bool {
        let is_left = |y: usize| {
            let i = self.index(x, y);
            left[i] && is_own(i)
        };
        if y >= radius && is_left(y - radius) {
            return true;
        }
        let ends = y + 1 >= self.height || !self.layout.is_free[self.index(x, y + 1)];
        ends && (y.saturating_sub(radius)..(y + radius + 1).min(self.height)).any(is_left)
    }

    /// Takes what a lane sweeps off what is left.
    fn sweep(&self, left: &mut [bool], (from, to): (usize, usize), y: usize) {
        let radius = self.layout.radius / self.layout.spacing;
        let reach = radius as i64;
        for dy in -reach..=reach {
            let row = y as i64 + dy;
            if row < 0 || row >= self.height as i64 {
                continue;
            }
            let half = (radius * radius - (dy * dy) as f64).max(0.0).sqrt() as usize;
            for x in from.saturating_sub(half)..(to + half + 1).min(self.width) {
                left[self.index(x, row as usize)] = false;
            }
        }
    }
}

/// Keeps a lane, or the halves of it that are free: between samples it can meet an obstacle's corner.
fn keep_free(space: &FreeSpace, (a, b): Lane, free: &mut Vec<Lane>) {
    if space.is_free(a, b) {
        free.push((a, b));
    } else if (b - a).norm() > SHORTEST {
        let middle = a + (b - a) * 0.5;
        keep_free(space, (a, middle), free);
        keep_free(space, (middle, b), free);
    }
}

fn into(turn: Vector, p: Point) -> Vector {
    Vector::new(turn.x * p.x + turn.y * p.y, turn.x * p.y - turn.y * p.x)
}

/// The mean over squares, rows then columns.
fn blur(values: &mut [f32], width: usize, half: usize) {
    let height = values.len() / width;
    let mut line = Vec::new();
    let mut pass = |values: &mut [f32], start: usize, stride: usize, count: usize| {
        line.clear();
        line.push(0.0_f64);
        for i in 0..count {
            line.push(line[i] + f64::from(values[start + i * stride]));
        }
        for i in 0..count {
            let (low, high) = (i.saturating_sub(half), (i + half + 1).min(count));
            values[start + i * stride] = (line[high] - line[low]) as f32;
        }
    };
    for y in 0..height {
        pass(values, y * width, 1, width);
    }
    for x in 0..width {
        pass(values, x, width, height);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{
        floor_plan::{Object, Sketch},
        geometry::Pose,
        math,
        robot::model,
    };

    #[test]
    fn lanes_are_parallel_to_walls_that_stand_askew() {
        // A hall of 4 x 2.5 m, at an angle.
        for degrees in [12.0, 33.0, 71.0_f64] {
            let frame = Pose::new(3.0, 3.0, degrees.to_radians());
            let mut plan = Sketch::open(6.0, 6.0, 0.05).start(3.0, 3.0, 0.0).finish("", "");
            let walls =
                [[-6.0, -6.0, 6.0, -1.25], [-6.0, 1.25, 6.0, 6.0], [-6.0, -6.0, -2.0, 6.0], [2.0, -6.0, 6.0, 6.0]];
            for [left, bottom, right, top] in walls {
                let corners = [[left, bottom], [right, bottom], [right, top], [left, top]];
                let outline = corners.map(|[x, y]| frame.to_world(Point::new(x, y))).to_vec();
                plan.objects.push(Object::Furniture { outline });
            }
            let floor = ReachableFloor::new(&plan, model("roomba600").unwrap(), None).unwrap();
            let space = FreeSpace::new(floor.limits(), floor.limits().body_radius + 0.003);
            let layout = RoomLayout::new(&floor, &space);
            let lanes = layout.lanes(&space, Directions::Both);
            let (mut all, mut along) = (0.0, 0.0);
            for (a, b) in lanes {
                assert!(space.is_free(a, b));
                let turned = math::atan2((b - a).y, (b - a).x).to_degrees() - degrees;
                let off = (turned - 90.0 * (turned / 90.0).round()).abs();
                all += (b - a).norm();
                along += if off < 1.6 { (b - a).norm() } else { 0.0 };
            }
            // The free 3.6 x 2.1 m need about fourteen lanes.
            assert!(all > 40.0 && along > 0.95 * all, "{degrees} degrees: {along} of {all} m");
        }
    }

    #[test]
    fn a_bare_room_gets_as_few_lanes_as_the_tool_allows() {
        let plan = Sketch::open(4.0, 2.0, 0.05).start(1.0, 1.0, 0.0).finish("", "");
        let floor = ReachableFloor::new(&plan, model("roomba600").unwrap(), None).unwrap();
        let space = FreeSpace::new(floor.limits(), floor.limits().body_radius + 0.003);
        let lanes = RoomLayout::new(&floor, &space).lanes(&space, Directions::Both);
        // 2 m less what the body keeps from the tool on both sides, in lanes of 17 cm, rounded down to samples.
        assert!((11..=13).contains(&lanes.len()), "{} lanes", lanes.len());
        assert!(lanes.iter().all(|(a, b)| (b - a).norm() > 3.5 && (b - a).y.abs() < 1e-9), "{lanes:?}");
    }
}
