//! The curves that fit at every corner.

use super::SmoothSetup;
use robovac_core::{
    coverage::{ReachableFloor, Walls},
    geometry::Point,
    trajectory::{CornerShape, DriveLimits, RoundedLine, Rounding, Stretch},
};

/// Sizes of curves round a corner that are tried, as shares of the largest that fits.
const SIZES: [f64; 4] = [1.0, 0.6, 0.35, 0.2];
/// Longest piece between the corners of a U-turn, m.
const U_TURN: f64 = 0.4;
/// Longest tangent, m: more saves no time.
const LONGEST: f64 = 0.5;
/// Straight way before and behind a curve along which times are compared, m.
const LEAD: f64 = 0.25;
/// Accuracy of the check against obstacles, m.
const HAIR: f64 = 2e-4;
/// Least time worth a curve, s.
const LEAST_GAIN: f64 = 0.005;

/// A corner, or the two corners of a U-turn, with the ways round it.
pub(super) struct CornerGroup {
    /// Number of the first corner, and how many there are.
    pub first: usize,
    pub corners: usize,
    /// How far the longest of the ways begins before the first corner and ends behind the last, m.
    pub reach: [f64; 2],
    /// Ways that save time, those that save most first.
    pub ways: Vec<CornerWay>,
}

/// A way round a unit.
pub(super) struct CornerWay {
    /// Shapes of its corners.
    pub roundings: [Rounding; 2],
    /// Seconds saved.
    pub gain_s: f64,
}

/// The units of a line, from its start to its end, without overlap.
pub(super) fn units(
    floor: &ReachableFloor,
    line: &[Point],
    limits: &DriveLimits,
    setup: &SmoothSetup,
) -> Vec<CornerGroup> {
    let turns = RoundedLine::turns(line);
    let lengths: Vec<f64> = line.windows(2).map(|pair| (pair[1] - pair[0]).norm()).collect();
    let wanted: Vec<f64> = turns
        .iter()
        .map(|&turn| CornerShape::alone(turn, 1.0).map_or(0.0, |shape| (setup.cut / shape.cut).min(LONGEST)))
        .collect();
    let pairs = u_turns(&turns, &lengths, setup.cut);
    // What U-turns take of the end and of the start of each piece.
    let mut taken = vec![[0.0; 2]; lengths.len()];
    for (i, [before, behind]) in &pairs {
        taken[i - 1][1] = *before;
        taken[i + 1][0] = *behind;
    }
    let is_pair = |i: usize| pairs.binary_search_by_key(&i, |pair| pair.0).is_ok();
    // Room for a curve alone at corner `i` on a piece that leads to its other corner.
    let room = |i: usize, piece: usize, side: usize, other: usize| {
        let rest = lengths[piece] - taken[piece][side];
        if taken[piece][side] > 0.0 { rest } else { rest * wanted[i] / (wanted[i] + wanted[other]).max(1e-12) }
    };
    let alone = |i: usize| wanted[i].min(room(i, i - 1, 0, i - 1)).min(room(i, i, 1, i + 1)).max(0.0);
    let mut found = Vec::new();
    let mut i = 1;
    while i + 1 < line.len() {
        let is_u_turn = is_pair(i);
        let corners = 1 + usize::from(is_u_turn);
        let mut options = Vec::new();
        if is_u_turn {
            options.push([Rounding::First, Rounding::Second]);
            // As two corners, within what the U-turn takes.
            let [before, behind] = pairs[pairs.binary_search_by_key(&i, |pair| pair.0).unwrap_or(0)].1;
            let middle = 0.5 * lengths[i];
            let tangents = [wanted[i].min(before).min(middle), wanted[i + 1].min(behind).min(middle)];
            options.extend(SIZES.map(|size| tangents.map(|tangent| Rounding::Alone(size * tangent))));
        } else if wanted[i] > 0.0 {
            let tangent = alone(i);
            options.extend(SIZES.map(|size| [Rounding::Alone(size * tangent), Rounding::Stop]));
        }
        let ways = ways(floor, &line[i - 1..=i + corners], &options, limits, setup);
        let reach = ways.iter().fold([0.0_f64; 2], |[before, behind], way| {
            let tangents = tangents(&turns[i..i + corners], lengths[i], &way.roundings);
            [before.max(tangents[0]), behind.max(tangents[1])]
        });
        if !ways.is_empty() {
            found.push(CornerGroup { first: i, corners, reach, ways });
        }
        i += corners;
    }
    found
}

/// The pairs of corners that become U-turns: number of the first, and what they take of the pieces before and behind, m.
fn u_turns(turns: &[f64], lengths: &[f64], cut: f64) -> Vec<(usize, [f64; 2])> {
    let mut found: Vec<(usize, [f64; 2])> = Vec::new();
    let mut free = 0.0;
    let mut i = 1;
    while i + 2 < turns.len() {
        let between = lengths[i];
        let before = lengths[i - 1] - free;
        free = 0.0;
        let shapes = (between <= U_TURN).then(|| CornerShape::u_turn([turns[i], turns[i + 1]], between)).flatten();
        let shapes = shapes.filter(|[first, second]| {
            let fits = first.tangents[0] > 0.0 && second.tangents[1] > 0.0 && first.tangents[0] <= before;
            fits && second.tangents[1] <= lengths[i + 1] && first.cut.max(second.cut) <= cut
        });
        if let Some([first, second]) = shapes {
            found.push((i, [first.tangents[0], second.tangents[1]]));
            free = second.tangents[1];
            // The piece behind leads to the corner after next.
            i += 2;
        } else {
            i += 1;
        }
    }
    found
}

/// How far a way begins before its first corner and ends behind its last.
fn tangents(turns: &[f64], between: f64, roundings: &[Rounding; 2]) -> [f64; 2] {
    match (roundings, turns) {
        ([Rounding::First, _], &[a, b]) => {
            CornerShape::u_turn([a, b], between).map_or([0.0; 2], |[a, b]| [a.tangents[0], b.tangents[1]])
        }
        (&[Rounding::Alone(a), Rounding::Alone(b)], _) => [a, b],
        (&[Rounding::Alone(a), _], _) => [a, a],
        _ => [0.0; 2],
    }
}

/// The options that touch nothing and save time round the inner corners of `line`.
fn ways(
    floor: &ReachableFloor,
    line: &[Point],
    options: &[[Rounding; 2]],
    limits: &DriveLimits,
    setup: &SmoothSetup,
) -> Vec<CornerWay> {
    let Some((&first, &last)) = line.first().zip(line.last()) else { return Vec::new() };
    let mut local = line.to_vec();
    let end = local.len() - 1;
    let lead = |from: Point, to: Point| to + (from - to) * ((LONGEST + LEAD) / (from - to).norm()).min(1.0);
    (local[0], local[end]) = (lead(first, line[1]), lead(last, line[end - 1]));
    let ahead = local[1] - local[0];
    let heading = robovac_core::math::atan2(ahead.y, ahead.x);
    let stopped = RoundedLine::new(&local, heading, &[]).passing_time(limits);
    let reach = floor.limits().body_radius + setup.clearance - HAIR;
    let mut ways: Vec<CornerWay> = Vec::new();
    for &roundings in options {
        let rounded = RoundedLine::new(&local, heading, &[Rounding::Stop, roundings[0], roundings[1], Rounding::Stop]);
        let gain_s = stopped - rounded.passing_time(limits);
        let mut curves = rounded.stretches().filter(|stretch| stretch.is_curved());
        if gain_s > LEAST_GAIN && curves.all(|stretch| is_free(floor.limits(), stretch, reach)) {
            ways.push(CornerWay { roundings, gain_s });
        }
    }
    ways.sort_by(|a, b| b.gain_s.total_cmp(&a.gain_s));
    ways
}

/// Whether the middle keeps `reach` metres from everything all along a stretch. Distances change no faster than the way, so
/// that one more by half of a stretch in its middle is enough; otherwise its halves are looked at.
fn is_free(walls: &Walls, stretch: &Stretch, reach: f64) -> bool {
    let half = 0.5 * stretch.length;
    let middle = stretch.at(0.5);
    if walls.nearest(middle.position(), reach + half).is_none() {
        return true;
    }
    if half < 0.5 * HAIR || walls.nearest(middle.position(), reach).is_some() {
        return false;
    }
    let bend = 0.5 * (stretch.curvature[0] + stretch.curvature[1]);
    let first = Stretch { length: half, curvature: [stretch.curvature[0], bend], ..*stretch };
    let second = Stretch { start: middle, length: half, curvature: [bend, stretch.curvature[1]], ..*stretch };
    is_free(walls, &first, reach) && is_free(walls, &second, reach)
}
