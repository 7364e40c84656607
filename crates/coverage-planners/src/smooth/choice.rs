//! Which of the ways round every unit is taken.

use super::{
    swept::{Runs, SweptCounts},
    units::{CornerGroup, CornerWay},
};
use robovac_core::{
    geometry::{Point, Vector},
    math,
    trajectory::{RoundedLine, Rounding},
};

/// Floor left out for a second saved, m²/s, from pass to pass; after the last of them anything goes that is within the budget.
const PRICES: [f64; 9] = [0.0, 1e-4, 2e-4, 4e-4, 8e-4, 1.6e-3, 3.2e-3, 6.4e-3, f64::MAX];

/// The shape of every corner of `line` such that at most `budget` m² of the floor are left out.
///
/// First come curves that leave out nothing, as other parts of the line sweep there, too; then those that leave out little for
/// the time that they save, at rising prices. Each curve counts as leaving out `unseen` samples more than it does.
pub(super) fn choose(
    line: &[Point],
    units: &[CornerGroup],
    counts: &mut SweptCounts<'_>,
    budget: f64,
    unseen: i64,
) -> Vec<Rounding> {
    let mut roundings = vec![Rounding::Stop; line.len()];
    for piece in between(line, units) {
        let runs = counts.runs(&piece);
        counts.add(&runs);
    }
    let mut states: Vec<State> = units.iter().map(|unit| State::new(line, unit, counts)).collect();
    let mut left = (budget / counts.area_of_sample()) as i64;
    for price in PRICES {
        for (unit, state) in units.iter().zip(&mut states) {
            left -= state.improve(line, unit, counts, (price, left, unseen));
        }
    }
    for (unit, state) in units.iter().zip(&states) {
        if let Some(way) = state.taken.map(|way| &unit.ways[way]) {
            roundings[unit.first..unit.first + unit.corners].copy_from_slice(&way.roundings[..unit.corners]);
        }
    }
    roundings
}

/// The parts of the line that no unit changes.
fn between(line: &[Point], units: &[CornerGroup]) -> Vec<Vec<Point>> {
    let mut pieces = Vec::with_capacity(units.len() + 1);
    let mut piece = vec![line[0]];
    let mut next = 1;
    for unit in units {
        piece.extend(&line[next..unit.first]);
        let [from, to] = ends(line, unit);
        piece.push(from);
        pieces.push(std::mem::replace(&mut piece, vec![to]));
        next = unit.first + unit.corners;
    }
    piece.extend(&line[next..]);
    pieces.push(piece);
    pieces
}

/// Where the longest way of a unit begins and ends.
fn ends(line: &[Point], unit: &CornerGroup) -> [Point; 2] {
    let along = |at: Point, to: Point, way: f64| {
        let whole: Vector = to - at;
        at + whole * (way / whole.norm()).min(1.0)
    };
    let last = unit.first + unit.corners - 1;
    [along(line[unit.first], line[unit.first - 1], unit.reach[0]), along(line[last], line[last + 1], unit.reach[1])]
}

/// What is taken at a unit.
struct State {
    /// Number of its way; `None` for stops.
    taken: Option<usize>,
    /// What that sweeps.
    runs: Runs,
}

impl State {
    /// With stops.
    fn new(line: &[Point], unit: &CornerGroup, counts: &mut SweptCounts<'_>) -> Self {
        let runs = counts.runs(&points(line, unit, None));
        counts.add(&runs);
        Self { taken: None, runs }
    }

    /// Takes a way that saves more time, if there is one that leaves out no more floor than its time is worth at `price` m²/s and
    /// than `left` samples. Returns how many samples more are left out.
    fn improve(
        &mut self,
        line: &[Point],
        unit: &CornerGroup,
        counts: &mut SweptCounts<'_>,
        (price, left, unseen): (f64, i64, i64),
    ) -> i64 {
        let saved = self.taken.map_or(0.0, |way| unit.ways[way].gain_s);
        let better = unit.ways.iter().enumerate().take_while(|(_, way)| way.gain_s > saved);
        for (number, way) in better {
            let runs = counts.runs(&points(line, unit, Some(way)));
            let gained = counts.with(&runs, 0);
            counts.take(&self.runs);
            counts.add(&runs);
            let unseen = if self.taken.is_none() { unseen } else { 0 };
            let lost = counts.with(&self.runs, 0) - gained + unseen;
            if lost <= left.max(0) && lost as f64 * counts.area_of_sample() <= price * (way.gain_s - saved) {
                (self.taken, self.runs) = (Some(number), runs);
                return lost;
            }
            counts.take(&runs);
            counts.add(&self.runs);
        }
        0
    }
}

/// The way round a unit, between the ends of its longest.
fn points(line: &[Point], unit: &CornerGroup, way: Option<&CornerWay>) -> Vec<Point> {
    let [from, to] = ends(line, unit);
    let mut local = vec![from];
    local.extend(&line[unit.first..unit.first + unit.corners]);
    local.push(to);
    let Some(way) = way else { return local };
    // Where the longest way begins, the piece has no length before the curve.
    let ahead = line[unit.first] - line[unit.first - 1];
    let heading = math::atan2(ahead.y, ahead.x);
    let roundings = [Rounding::Stop, way.roundings[0], way.roundings[1], Rounding::Stop];
    RoundedLine::new(&local, heading, &roundings[..local.len()]).points()
}
