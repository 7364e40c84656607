//! Directions of walls: that of most of the room, and parts of the room with a direction of their own.

use super::scan::rotation;
use robovac_core::{
    coverage::ReachableFloor,
    geometry::{Point, Vector},
    grid::{Cell, Grid},
    math,
};

/// Directions tried, between 0 and a right angle.
const DIRECTIONS: u32 = 18;
/// How often the step between directions is halved around the best.
const FINER: u32 = 3;
/// Most lines across the room by which directions are compared.
const MOST_ACROSS: f64 = 400.0;
/// Length of what may be an edge's raggedness on the grid, m.
const RAGGED: f64 = 0.15;
/// Side of the tiles that have a direction each, m, and tiles around one whose walls count for it.
const TILE: f64 = 0.25;
const AROUND: i32 = 2;
/// Half the side of the square by which the direction of an edge is found, m.
const EDGE: f64 = 0.3;
/// How much the walls around a tile must agree for a direction, 0 to 1: those of a round table don't.
const AGREED: f64 = 0.75;
/// Directions so near are the same, rad: as near as lanes along one of them still fit walls along the other.
const SAME: f64 = 0.12;
/// Least length of walls with another direction, m, less for those that are a little off it, and least area of a part, m².
const LEAST_WALLS: f64 = 3.0;
const LEAST_AREA: f64 = 2.0;
/// So many more ends, as a share, are worth it that lanes along walls leave no wedges beside them.
const ALONG_WALLS: f64 = 0.1;
/// Most directions.
const MOST_DIRECTIONS: usize = 4;

/// A part of the floor and the direction of its walls.
pub(super) struct DirectedPart {
    /// Angle of the walls, rad.
    pub angle: f64,
    /// Its cells of the floor.
    pub floor: Grid<bool>,
}

/// The parts of the floor, first that in the direction of most of the room: all of it, unless walls elsewhere stand askew to that.
pub(super) fn directed_parts(floor: &ReachableFloor) -> Vec<DirectedPart> {
    let angle = best_direction(floor);
    let tiles = DirectedTiles::new(floor, angle);
    let mut parts = vec![DirectedPart { angle, floor: floor.floor.clone() }];
    if tiles.directions.len() > 1 {
        for (angle, part) in tiles.parts(floor) {
            let mask = masked(&floor.standing, &part, tiles.cells);
            let Some(angle) = own_direction(floor, &mask, angle, parts[0].angle) else { continue };
            let own = masked(&floor.floor, &part, tiles.cells);
            let rest = parts[0].floor.values_mut().iter_mut().zip(own.values());
            rest.for_each(|(rest, &is_own)| *rest &= !is_own);
            parts.push(DirectedPart { angle, floor: own });
        }
    }
    if parts.len() > 1 {
        // The rest has its direction to itself.
        let mut rest = floor.standing.clone();
        rest.values_mut().iter_mut().zip(parts[0].floor.values()).for_each(|(rest, &is_own)| *rest &= is_own);
        if let Some(extent) = Extent::of_part(floor, &rest) {
            let rated = |angle: f64| (chords(floor, &rest, extent, angle, 1.0), angle);
            parts[0].angle = near_best(rated(angle), rated).1;
        }
    }
    parts
}

/// The direction, among some, in which the free space has the fewest chords.
fn best_direction(floor: &ReachableFloor) -> f64 {
    let whole = Extent::of_map(floor);
    let step = math::FRAC_PI_2 / f64::from(DIRECTIONS);
    let rated = |angle: f64| (chords(floor, &floor.standing, whole, angle, 1.0), angle);
    let best = (0..DIRECTIONS).map(|i| rated(f64::from(i) * step)).fold((f64::MAX, 0.0), better);
    finer(best, step, rated).1
}

/// The direction near `angle` that fits a part best, if it fits about as well as that of the room, or better.
fn own_direction(floor: &ReachableFloor, part: &Grid<bool>, angle: f64, of_room: f64) -> Option<f64> {
    let extent = Extent::of_part(floor, part)?;
    let rated = |angle: f64| (chords(floor, part, extent, angle, 1.0), angle);
    let best = near_best(rated(angle), rated);
    // Lanes in the room's direction go on beyond the part.
    let with_room = chords(floor, part, extent, of_room, 0.0);
    (best.0 < (1.0 + ALONG_WALLS) * with_room && apart(best.1, of_room) > SAME).then_some(best.1)
}

/// The best direction up to [`SAME`] from one that is rated.
fn near_best(angle: (f64, f64), rated: impl Fn(f64) -> (f64, f64)) -> (f64, f64) {
    let near = [-SAME, -0.5 * SAME, 0.5 * SAME, SAME].map(|by| rated(angle.1 + by));
    finer(near.into_iter().fold(angle, better), 0.5 * SAME, rated)
}

fn better(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    if b.0 < a.0 { b } else { a }
}

fn finer(mut best: (f64, f64), step: f64, rated: impl Fn(f64) -> (f64, f64)) -> (f64, f64) {
    for halving in 1..=FINER {
        let finer = step / f64::from(1_u32 << halving);
        best = [best.1 - finer, best.1 + finer].map(&rated).into_iter().fold(best, better);
    }
    best
}

/// Angle between two directions, of which those at a right angle are the same, 0 to 45 degrees in rad.
pub(super) fn apart(one: f64, other: f64) -> f64 {
    let turns = (one - other) / math::FRAC_PI_2;
    (turns - turns.round()).abs() * math::FRAC_PI_2
}

/// Where chords are counted, m.
#[derive(Clone, Copy)]
struct Extent {
    middle: Point,
    reach: f64,
}

impl Extent {
    fn of_map(floor: &ReachableFloor) -> Self {
        let size = Vector::new(floor.floor.width() as f64, floor.floor.height() as f64) * floor.resolution;
        Self { middle: Point::from(size * 0.5), reach: size.norm() }
    }

    fn of_part(floor: &ReachableFloor, part: &Grid<bool>) -> Option<Self> {
        let mut cells = part.iter().filter(|&(_, &is_in)| is_in).map(|(cell, _)| floor.centre(cell));
        let first = cells.next()?;
        let (low, high) = cells.fold((first, first), |(low, high), at| (low.inf(&at), high.sup(&at)));
        Some(Self { middle: low + (high - low) * 0.5, reach: (high - low).norm() + 2.0 * RAGGED })
    }
}

/// How ill a direction fits the room or a part of it: the number of ends of chords along it, or across it if these are fewer. Where
/// the floor goes on beyond the part, they count `border` times.
fn chords(floor: &ReachableFloor, part: &Grid<bool>, Extent { middle, reach }: Extent, angle: f64, border: f64) -> f64 {
    let turn = rotation(angle);
    let pitch = (2.0 * floor.resolution).max(reach / MOST_ACROSS);
    // Less than a cell: the steps of a wall askew, about a cell long, mustn't beat with the samples.
    let step = 0.3 * pitch;
    let lines = (reach / pitch) as i32 / 2;
    let samples = (reach / step) as i32 / 2;
    // Walls askew are ragged on the grid: what is shorter than this is no end.
    let ragged = (RAGGED / step).ceil() as u32;
    let mut ends = [0.0; 2];
    for (way, ends) in [turn, Vector::new(-turn.y, turn.x)].into_iter().zip(&mut ends) {
        let aside = Vector::new(-way.y, way.x);
        for line in -lines..=lines {
            let (mut is_in, mut other) = (false, 0);
            for sample in -samples..=samples {
                let at = middle + aside * (f64::from(line) * pitch) + way * (f64::from(sample) * step);
                let is_floor = part.is_set(floor.cell_at(at));
                other = if is_floor == is_in { 0 } else { other + 1 };
                if other > ragged {
                    let outside = if is_floor { at - way * (f64::from(other) * step) } else { at };
                    *ends += if floor.standing.is_set(floor.cell_at(outside)) { border } else { 1.0 };
                    (is_in, other) = (is_floor, 0);
                }
            }
        }
    }
    ends[0].min(ends[1]) + 0.25 * ends[0].max(ends[1])
}

/// The cells of a grid that are on tiles of a part.
fn masked(cells: &Grid<bool>, part: &Grid<bool>, side: i32) -> Grid<bool> {
    let mut mask = cells.clone();
    for index in 0..mask.len() {
        let cell = mask.cell(index);
        mask[cell] &= part[Cell::new(cell.x / side, cell.y / side)];
    }
    mask
}

/// Walls of a tile: the sum of unit vectors at four times their angles, for which directions at right angles are the same, and their
/// length, m.
#[derive(Debug, Clone, Copy, Default)]
struct TileWalls {
    sum: Vector,
    length: f64,
}

/// Square tiles of the floor, and which of some directions the walls around have.
struct DirectedTiles {
    /// Cells along the side of a tile.
    cells: i32,
    /// Angles, rad; the first is that of the room.
    directions: Vec<f64>,
    /// Index of the direction of each tile whose walls have one.
    own: Grid<Option<u8>>,
}

impl DirectedTiles {
    fn new(floor: &ReachableFloor, angle: f64) -> Self {
        let cells = ((TILE / floor.resolution).round() as i32).max(1);
        let tiles = |cells_across: usize| cells_across.div_ceil(cells as usize);
        let (width, height) = (tiles(floor.standing.width()), tiles(floor.standing.height()));
        let mut walls = Grid::filled(width, height, TileWalls::default());
        for (cell, &is_standing) in floor.standing.iter() {
            if !is_standing || cell.neighbours().into_iter().all(|next| floor.standing.is_set(next)) {
                continue;
            }
            let Some(wall) = wall_at(floor, cell) else { continue };
            let tile = &mut walls[Cell::new(cell.x / cells, cell.y / cells)];
            // A wall along the diagonal has a cell for every 1.4 of its side.
            tile.length += floor.resolution / wall.x.abs().max(wall.y.abs());
            let (sin, cos) = math::sin_cos(4.0 * math::atan2(wall.y, wall.x));
            tile.sum += Vector::new(cos, sin) * floor.resolution / wall.x.abs().max(wall.y.abs());
        }
        let angles = tile_angles(&walls);
        let directions = directions(angle, &walls, &angles);
        let nearest = |angle: f64| {
            let of = |i: &u8| apart(angle, directions[usize::from(*i)]);
            (0..directions.len() as u8).min_by(|a, b| of(a).total_cmp(&of(b))).filter(|i| of(i) < SAME)
        };
        let own = angles.map(|angle| angle.and_then(nearest));
        Self { cells, directions, own }
    }

    /// Connected parts whose direction isn't the room's, large enough for lanes of their own: their angle and their tiles.
    fn parts(&self, floor: &ReachableFloor) -> Vec<(f64, Grid<bool>)> {
        let on_tiles = |cells: &Grid<bool>| {
            let mut tiles = self.own.map(|_| false);
            for (cell, _) in cells.iter().filter(|&(_, &is_set)| is_set) {
                tiles[Cell::new(cell.x / self.cells, cell.y / self.cells)] = true;
            }
            tiles
        };
        let (standing, all) = (on_tiles(&floor.standing), on_tiles(&floor.floor));
        let mut own = self.own.clone();
        spread(&mut own, &standing);
        spread(&mut own, &all);
        let side = f64::from(self.cells) * floor.resolution;
        let least = (LEAST_AREA / (side * side)) as usize;
        // What is too small goes with what is around it.
        let mut large = own.map(|_| None);
        for part in connected(&own).into_iter().filter(|part| part.len() >= least) {
            for tile in part {
                large[tile] = own[tile];
            }
        }
        spread(&mut large, &all);
        let mut parts = Vec::new();
        for part in connected(&large) {
            let Some(direction) = part.first().and_then(|&tile| large[tile]).filter(|&direction| direction > 0) else {
                continue;
            };
            let mut tiles = large.map(|_| false);
            for tile in part {
                tiles[tile] = true;
            }
            parts.push((self.directions[usize::from(direction)], tiles));
        }
        parts
    }
}

/// Direction of a wall at a cell beside it, of length 1: across the way to the middle of the free cells around.
fn wall_at(floor: &ReachableFloor, cell: Cell) -> Option<Vector> {
    let reach = (EDGE / floor.resolution).round().max(2.0) as i32;
    let stride = (reach / 6).max(1);
    let mut sum = Vector::zeros();
    for y in (-reach..=reach).step_by(stride as usize) {
        for x in (-reach..=reach).step_by(stride as usize) {
            if x * x + y * y <= reach * reach && floor.standing.is_set(Cell::new(cell.x + x, cell.y + y)) {
                sum += Vector::new(f64::from(x), f64::from(y));
            }
        }
    }
    let inwards = sum.try_normalize(1e-9)?;
    Some(Vector::new(-inwards.y, inwards.x))
}

/// The angle of the walls around each tile, where they agree.
fn tile_angles(walls: &Grid<TileWalls>) -> Grid<Option<f64>> {
    let mut angles = walls.map(|_| None);
    for (tile, own) in walls.iter().filter(|(_, own)| own.length > 0.0) {
        let mut around = TileWalls { sum: Vector::zeros(), length: 0.0 };
        for y in -AROUND..=AROUND {
            for x in -AROUND..=AROUND {
                if let Some(other) = walls.get(Cell::new(tile.x + x, tile.y + y)) {
                    around.sum += other.sum;
                    around.length += other.length;
                }
            }
        }
        if around.sum.norm() > AGREED * around.length && own.sum.norm() > AGREED * own.length {
            angles[tile] = Some(0.25 * math::atan2(around.sum.y, around.sum.x));
        }
    }
    angles
}

/// The directions of the walls, first `angle`, then others that many walls have.
fn directions(angle: f64, walls: &Grid<TileWalls>, angles: &Grid<Option<f64>>) -> Vec<f64> {
    let walls = walls.values().iter().zip(angles.values());
    let walls: Vec<(f64, f64)> = walls.filter_map(|(wall, &angle)| Some((angle?, wall.length))).collect();
    let mut directions = vec![angle];
    while directions.len() < MOST_DIRECTIONS {
        // The walls near other directions are theirs.
        let length_along = |angle: f64| -> f64 {
            let free = walls.iter().filter(|wall| directions.iter().all(|&other| apart(wall.0, other) > SAME));
            free.map(|wall| wall.1 * (1.0 - apart(wall.0, angle) / SAME).max(0.0)).sum()
        };
        let tried = (0..90).map(|degrees| f64::from(degrees).to_radians());
        let most = tried.map(|angle| (-length_along(angle), angle)).fold((0.0, 0.0), better);
        if -most.0 < LEAST_WALLS {
            break;
        }
        directions.push(most.1);
    }
    directions
}

/// Gives the direction of the nearest tile that has one to those of `free` that have none.
fn spread(own: &mut Grid<Option<u8>>, free: &Grid<bool>) {
    let mut reached: Vec<Cell> =
        own.iter().filter(|(_, direction)| direction.is_some()).map(|(tile, _)| tile).collect();
    let mut next = 0;
    while let Some(&tile) = reached.get(next) {
        next += 1;
        for other in tile.neighbours() {
            if free.is_set(other) && own[other].is_none() {
                own[other] = own[tile];
                reached.push(other);
            }
        }
    }
}

/// The connected parts of tiles with the same direction.
fn connected(own: &Grid<Option<u8>>) -> Vec<Vec<Cell>> {
    let mut is_taken = own.map(Option::is_none);
    let mut parts = Vec::new();
    for (first, _) in own.iter() {
        if is_taken[first] {
            continue;
        }
        is_taken[first] = true;
        let mut part = vec![first];
        let mut next = 0;
        while let Some(&tile) = part.get(next) {
            next += 1;
            for other in tile.neighbours() {
                if own.get(other).is_some_and(|&direction| direction == own[first]) && !is_taken[other] {
                    is_taken[other] = true;
                    part.push(other);
                }
            }
        }
        parts.push(part);
    }
    parts
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use robovac_core::{
        floor_plan::{Sketch, room},
        robot::model,
    };

    /// Two furnished rooms of 5 x 4 m with a passage between, of which the right one stands askew, and its middle.
    pub fn rooms_askew(degrees: f64) -> (ReachableFloor, Point) {
        let (middle, turn) = (Point::new(9.2, 3.5), rotation(degrees.to_radians()));
        let corner = |[x, y]: [f64; 2]| {
            let at = middle + Vector::new(turn.x * x - turn.y * y, turn.y * x + turn.x * y);
            (at.x, at.y)
        };
        let askew = |corners: [[f64; 2]; 4]| corners.map(corner);
        let room = [[2.5, 2.0], [-2.5, 2.0], [-2.5, -2.0], [2.5, -2.0], [2.5, 2.0]].map(corner);
        let mut outline = vec![(5.7, 0.0), (13.0, 0.0), (13.0, 7.0), (5.7, 7.0), (5.7, 0.0)];
        outline.extend(room);
        let plan = Sketch::open(13.0, 7.0, 0.05)
            .fill(&[[0.0, 0.0, 5.7, 1.5], [0.0, 5.5, 5.7, 7.0], [0.0, 0.0, 0.7, 7.0]])
            .polygon(&outline)
            .carve(&[[5.5, 3.0, 7.4, 4.0]])
            .fill(&[[2.0, 4.4, 3.1, 4.9]])
            .polygon(&askew([[-1.6, 0.7], [-0.6, 0.7], [-0.6, 1.4], [-1.6, 1.4]]))
            .polygon(&askew([[0.5, -1.2], [1.7, -1.2], [1.7, -0.6], [0.5, -0.6]]))
            .start(3.0, 3.5, 0.0)
            .finish("", "");
        (ReachableFloor::new(&plan, model("roomba600").unwrap(), None).unwrap(), middle)
    }

    #[test]
    fn rooms_with_parallel_walls_are_one_part() {
        for id in ["flat", "hotel", "office", "hall20", "living", "bedroom", "warehouse", "lshape"] {
            let plan = (room(id).unwrap().build)();
            let floor = ReachableFloor::new(&plan, model("roomba600").unwrap(), None).unwrap();
            let parts = directed_parts(&floor);
            assert_eq!(parts.len(), 1, "{id}");
            assert!(apart(parts[0].angle, 0.0) < 0.02 && parts[0].floor == floor.floor, "{id}: {}", parts[0].angle);
        }
    }

    #[test]
    fn a_room_askew_is_a_part() {
        for degrees in [10.0, 20.0, 35.0, 45.0, 60.0, 77.0] {
            let (floor, middle) = rooms_askew(degrees);
            let parts = directed_parts(&floor);
            let part_at = |at: Point| parts.iter().find(|part| part.floor.is_set(floor.cell_at(at))).unwrap();
            assert!(apart(part_at(middle).angle, f64::to_radians(degrees)).to_degrees() < 2.0, "{degrees}");
            assert!(apart(part_at(Point::new(3.0, 3.5)).angle, 0.0).to_degrees() < 2.0, "{degrees}");
            // Every cell belongs to one part.
            for (cell, &is_floor) in floor.floor.iter() {
                assert_eq!(parts.iter().filter(|part| part.floor.is_set(cell)).count(), usize::from(is_floor));
            }
        }
    }
}
