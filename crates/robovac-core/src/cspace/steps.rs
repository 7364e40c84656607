//! Steps of a body between the cells in which it fits.

use super::{
    CspaceError, ObstacleRuns, Outline,
    bits::Bits,
    canvas::BitCanvas,
    scene::ObstacleScene,
    space::{Slice, size},
};
use crate::{
    geometry::Vector,
    grid::{Cell, Direction, Grid},
};

/// Properties of a cell, as bits.
const FREE: u8 = 1;
/// The way to the right neighbour's centre is free, and the way up.
const RIGHT: u8 = 2;
const UP: u8 = 4;
/// The square between its centre and those of the neighbours right, up and diagonally is free.
const SQUARE: u8 = 8;
/// FULL because of a wall or the outside.
const WALL: u8 = 16;
const SEEN: u8 = 32;

/// FREE cells at heading 0, and where the body can move between their centres.
///
/// A body that fits in two neighbouring cells may still touch something narrow between them. So the steps are computed
/// like the cells, for what the body covers on the way (Minkowski sums of the obstacles and the outline drawn out by a
/// cell).
///
/// If all four sides of a square between four centres are free, so is the square: an obstacle grown by the body is
/// connected and wider than a cell, so it can't be inside without crossing a side.
#[derive(Debug, Clone)]
pub struct FreeSteps {
    cells: Grid<u8>,
}

impl FreeSteps {
    pub(super) fn new(scene: &ObstacleScene, outline: &Outline, cell: f64, margin: f64) -> Result<Self, CspaceError> {
        let (width, height) = size(scene.size.0, scene.size.1, cell, 1, 1)?;
        let draw = |along: Vector| {
            let sums = scene.sums(outline, 0.0, along, margin);
            let mut slice = Slice { canvas: BitCanvas::new(width, height, cell) };
            slice.draw_walls(scene, &sums, margin);
            let walls = (along == Vector::zeros()).then(|| slice.canvas.bits.clone());
            slice.draw_obstacles(scene, &sums);
            (slice.canvas.bits, walls)
        };
        let (full, walls) = draw(Vector::zeros());
        let walls = walls.unwrap_or_else(|| Bits::new(width, height));
        let [right, up] = [Vector::x(), Vector::y()].map(|along| draw(cell * along).0);
        let mut cells = Grid::filled(width, height, 0);
        for (y, row) in cells.values_mut().chunks_mut(width).enumerate() {
            for (x, value) in row.iter_mut().enumerate() {
                *value = if full.get(x, y) {
                    if walls.get(x, y) { WALL } else { 0 }
                } else {
                    let is_right = x + 1 < width && !right.get(x, y) && !full.get(x + 1, y);
                    let is_up = y + 1 < height && !up.get(x, y) && !full.get(x, y + 1);
                    FREE | if is_right { RIGHT } else { 0 } | if is_up { UP } else { 0 }
                };
            }
        }
        let (low, high) = outline.bounds();
        if high.x - low.x > cell || high.y - low.y > cell {
            let values = cells.values_mut();
            for index in 0..values.len().saturating_sub(width) {
                let is_square = values[index] & (RIGHT | UP) == RIGHT | UP
                    && values[index + 1] & UP != 0
                    && values[index + width] & RIGHT != 0;
                values[index] |= if is_square { SQUARE } else { 0 };
            }
        }
        Ok(Self { cells })
    }

    fn has(&self, cell: Cell, property: u8) -> bool {
        self.cells.get(cell).is_some_and(|value| value & property != 0)
    }

    /// Whether the body fits with its origin in the centre of a cell.
    pub fn is_free(&self, cell: Cell) -> bool {
        self.has(cell, FREE)
    }

    /// Whether the way from a cell's centre to the neighbour's is free.
    pub fn is_open(&self, cell: Cell, to: Direction) -> bool {
        match to {
            Direction::Right => self.has(cell, RIGHT),
            Direction::Up => self.has(cell, UP),
            Direction::Left | Direction::Down => {
                self.has(cell.step(to), if to == Direction::Left { RIGHT } else { UP })
            }
        }
    }

    /// Whether the square is free whose lower left corner is the cell's centre, and its upper right corner that of the
    /// next cell diagonally.
    pub fn is_square_free(&self, cell: Cell) -> bool {
        self.has(cell, SQUARE)
    }

    /// Whether the straight way between two cells' centres leads along free steps or through free squares only. If not,
    /// it can still be free.
    pub fn is_straight_free(&self, from: Cell, to: Cell) -> bool {
        if !self.is_free(from) {
            return false;
        }
        let (dx, dy) = (i64::from(to.x) - i64::from(from.x), i64::from(to.y) - i64::from(from.y));
        let (low_x, low_y) = (from.x.min(to.x), from.y.min(to.y));
        if dy == 0 {
            return (low_x..from.x.max(to.x)).all(|x| self.has(Cell::new(x, low_y), RIGHT));
        }
        if dx == 0 {
            return (low_y..from.y.max(to.y)).all(|y| self.has(Cell::new(low_x, y), UP));
        }
        let (wide, high, rises) = (dx.abs(), dy.abs(), (dx > 0) == (dy > 0));
        // From the left end: in every column of squares those between the heights at which the line enters and leaves.
        (0..wide).all(|column| {
            let (first, last) = (column * high / wide, ((column + 1) * high + wide - 1) / wide - 1);
            (first..=last).all(|row| {
                let row = if rises { row } else { high - 1 - row };
                self.has(Cell::new(low_x + column as i32, low_y + row as i32), SQUARE)
            })
        })
    }

    /// The FREE cells.
    pub fn free(&self) -> Grid<bool> {
        self.cells.map(|value| value & FREE != 0)
    }

    /// The obstacles: cells that are FULL, and not because of a wall or the outside. An obstacle that stands against a
    /// wall counts as one.
    pub fn obstacles(&self) -> ObstacleRuns {
        ObstacleRuns::of_cells(&self.cells.map(|value| value & (FREE | WALL) == 0))
    }

    /// The cells that the body can reach from `start` by free steps; from any cell of the largest such part for `None`.
    pub fn reachable(&self, start: Option<Cell>) -> Grid<bool> {
        let mut seen = self.cells.clone();
        let start = start.or_else(|| {
            let mut best = (0, None);
            for index in 0..seen.len() {
                let cell = seen.cell(index);
                let count = flood(&mut seen, cell, |_| ());
                if count > best.0 {
                    best = (count, Some(cell));
                }
            }
            seen.values_mut().iter_mut().for_each(|value| *value &= !SEEN);
            best.1
        });
        let mut reached = Grid::filled(seen.width(), seen.height(), false);
        if let Some(start) = start {
            flood(&mut seen, start, |index| reached.values_mut()[index] = true);
        }
        reached
    }
}

/// Marks and counts the cells that can be reached from `start` and aren't marked yet.
fn flood(cells: &mut Grid<u8>, start: Cell, mut found: impl FnMut(usize)) -> usize {
    let is_new = |value: u8| value & (FREE | SEEN) == FREE;
    if !cells.get(start).is_some_and(|&value| is_new(value)) {
        return 0;
    }
    let (width, start) = (cells.width(), cells.index(start));
    let values = cells.values_mut();
    values[start] |= SEEN;
    let (mut stack, mut count) = (vec![start], 0);
    while let Some(index) = stack.pop() {
        count += 1;
        found(index);
        let mut go = |next: usize, is_open: bool, values: &mut [u8]| {
            if is_open && is_new(values[next]) {
                values[next] |= SEEN;
                stack.push(next);
            }
        };
        let here = values[index];
        go(index + 1, here & RIGHT != 0, values);
        go(index + width, here & UP != 0, values);
        if index % width > 0 {
            go(index - 1, values[index - 1] & RIGHT != 0, values);
        }
        if index >= width {
            go(index - width, values[index - width] & UP != 0, values);
        }
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        cspace::Motion,
        floor_plan::{FloorPlan, Object, Sketch},
        geometry::Point,
        rng,
    };
    use rand::RngExt;

    fn furniture(corners: &[(f64, f64)]) -> Object {
        Object::Furniture { outline: corners.iter().map(|&(x, y)| Point::new(x, y)).collect() }
    }

    fn room(objects: Vec<Object>) -> FloorPlan {
        FloorPlan { objects, ..Sketch::open(3.0, 2.5, 0.05).finish("", "") }
    }

    #[test]
    fn a_thin_wall_between_two_centres_stops_the_body() {
        // The centres of rows 1 and 2 are at 0.75 and 1.25 m.
        let plan = room(vec![furniture(&[(0.0, 0.99), (1.5, 0.99), (1.5, 1.01), (0.0, 1.01)])]);
        let steps = Motion::new(&plan, &Outline::octagon(0.02).unwrap(), 0.0).unwrap().steps(0.5).unwrap();
        let (below, above) = (Cell::new(1, 1), Cell::new(1, 2));
        assert!(steps.is_free(below) && steps.is_free(above));
        assert!(steps.is_open(below, Direction::Right) && steps.is_open(below, Direction::Left));
        assert!(!steps.is_open(below, Direction::Up) && !steps.is_open(above, Direction::Down));
        assert!(steps.is_open(Cell::new(4, 1), Direction::Up) && !steps.is_straight_free(below, above));
        // Round its end.
        assert!(steps.reachable(Some(below)).is_set(above));
    }

    #[test]
    fn an_obstacle_against_the_wall_is_one_and_a_drawn_wall_is_none() {
        let octagon = Outline::octagon(0.3).unwrap();
        let count =
            |plan: &FloorPlan| Motion::new(plan, &octagon, 0.0).unwrap().steps(0.1).unwrap().obstacles().count();
        let stage = Sketch::open(3.0, 2.5, 0.05).fill(&[[1.0, 0.0, 2.0, 0.5], [0.8, 1.2, 1.0, 1.4]]).finish("", "");
        assert_eq!(count(&stage), 2);
        let walls = Sketch::open(3.0, 2.5, 0.05).fill(&[[0.0, 0.0, 0.1, 2.5], [0.0, 0.0, 3.0, 0.1]]);
        assert_eq!(count(&walls.finish("", "")), 0);
        assert_eq!(count(&room(vec![furniture(&[(1.0, 0.0), (2.0, 0.0), (1.5, 0.5)])])), 1);
    }

    /// Steps and squares agree with the exact motion.
    #[test]
    fn free_steps_and_squares_are_free_all_over() {
        let mut rng = rng::seeded(19, 4);
        for round in 0..20 {
            let objects = (0..6).map(|_| {
                let (x, y) = (rng.random_range(0.2..2.8), rng.random_range(0.2..2.3));
                let (a, b) = (rng.random_range(0.02..0.4), rng.random_range(0.02..0.4));
                if rng.random_bool(0.5) {
                    Object::Leg { at: Point::new(x, y), radius: 0.3 * a }
                } else {
                    furniture(&[(x, y), (x + a, y + 0.5 * b), (x + 0.3 * a, y + b)])
                }
            });
            let plan = room(objects.collect());
            let outline =
                if round % 2 == 0 { Outline::circle(0.15).unwrap() } else { Outline::rectangle(0.3, 0.2).unwrap() };
            let clearance = if round % 3 == 0 { 0.0 } else { 1e-3 };
            let motion = Motion::new(&plan, &outline, clearance).unwrap();
            let steps = motion.steps(0.1).unwrap();
            let free = steps.free();
            for (cell, &is_free) in free.iter() {
                let at = cell.centre(0.1);
                assert_eq!(motion.is_free(at, at), is_free, "{cell}");
                for to in Direction::ALL {
                    let way = motion.is_free(at, cell.step(to).centre(0.1));
                    assert_eq!(steps.is_open(cell, to), way && free.is_set(cell.step(to)), "{cell} {to:?}");
                }
                if steps.is_square_free(cell) {
                    for _ in 0..5 {
                        let [from, to] = [(); 2].map(|()| 0.1 * Vector::new(rng.random(), rng.random()));
                        assert!(motion.is_free(at + from, at + to));
                    }
                }
            }
            for _ in 0..200 {
                let mut cell = || Cell::new(rng.random_range(0..30), rng.random_range(0..25));
                let (from, to) = (cell(), cell());
                if steps.is_straight_free(from, to) {
                    assert!(motion.is_free(from.centre(0.1), to.centre(0.1)), "{from} {to}");
                }
            }
        }
    }
}
