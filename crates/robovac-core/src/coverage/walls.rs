//! Walls and furniture, and a body's distance from them.

use super::shapes::ShapeIndex;
use crate::{
    geometry::{Point, Shape, Vector},
    grid::{Cell, Grid, chessboard, clearance},
};

/// Range beyond the body in which clearance is known, fine cells; with more room no exact test is needed.
const SPARE_CELLS: f64 = 3.0;

/// The obstacles of a floor: squares of a fine grid, and convex shapes anywhere between; the outside is wall.
#[derive(Debug, Clone)]
pub struct Walls {
    /// Room around each fine cell's centre, m, up to three cells more than the body's radius: exact for squares, a lower
    /// bound near shapes, as if they filled every cell that they touch; 0 in those and in walls.
    pub clearance: Grid<f32>,
    /// Side of a fine cell, m.
    pub resolution: f64,
    /// Radius of the body, m.
    pub body_radius: f64,
    /// King's moves from each fine cell to the nearest wall or cell that a shape touches; used by ray casting.
    moves: Grid<u8>,
    /// Fine cells that are wall.
    squares: Grid<bool>,
    /// Fine cells from each one to the next wall in its row, to the left and to the right; 0 in walls.
    in_row: Grid<[u16; 2]>,
    shapes: ShapeIndex,
}

/// A convex obstacle near a body.
#[derive(Debug, Clone, Copy)]
pub enum Obstacle<'a> {
    /// Squares side by side in a row of the grid: lower left and upper right corner.
    Squares(Point, Point),
    /// A shape.
    Shape(&'a Shape),
}

impl Walls {
    /// Walls in the cells of `squares`, `resolution` metres wide, and `shapes`, for a body of `body_radius` metres.
    pub fn new(squares: Grid<bool>, shapes: Vec<Shape>, resolution: f64, body_radius: f64) -> Self {
        let mut touched = squares.clone();
        for shape in &shapes {
            rasterise(shape, resolution, &mut touched);
        }
        let limit = body_radius / resolution + SPARE_CELLS;
        let clearance = clearance(&touched, limit as f32).map(|&c| c * resolution as f32);
        let (moves, in_row) = (chessboard(&touched), in_row(&squares));
        Self { clearance, resolution, body_radius, moves, squares, in_row, shapes: ShapeIndex::new(shapes) }
    }

    /// Whether a disc of `radius` metres around `point` touches no wall. `radius` is at most a cell more than the body's.
    #[inline]
    pub fn has_room(&self, point: Point, radius: f64) -> bool {
        self.has_room_around_cell(point, radius) || self.nearest(point, radius).is_none()
    }

    /// Like [`Walls::has_room`], but can return false where there is room: checks only the room around the cell's
    /// centre, which is at most 0.71 cells away.
    #[inline]
    pub fn has_room_around_cell(&self, point: Point, radius: f64) -> bool {
        let around = self.clearance.get(self.cell_at(point)).map_or(0.0, |&c| f64::from(c));
        around > radius + 0.7072 * self.resolution
    }

    /// Whether nothing is within `reach` metres of a point; quick, but can return false where nothing is.
    #[inline]
    pub fn are_far_from(&self, point: Point, reach: f64) -> bool {
        f64::from(self.moves_from(self.cell_at(point)) - 1) * self.resolution > reach
    }

    /// King's moves from a fine cell to the nearest wall or cell that a shape touches; 0 there and outside.
    #[inline]
    pub(super) fn moves_from(&self, cell: Cell) -> i32 {
        self.moves.get(cell).map_or(0, |&moves| i32::from(moves))
    }

    /// The nearest point of a wall or shape less than `reach` metres from `point`, and its distance; exact.
    pub fn nearest(&self, point: Point, reach: f64) -> Option<(Point, f64)> {
        let mut best = (reach * reach, None);
        self.nearest_square(point, &mut best);
        let reach = Vector::new(reach, reach);
        self.shapes.in_box(point - reach, point + reach, |shape| nearer(&mut best, point, shape.nearest(point)));
        best.1.map(|wall| (wall, best.0.sqrt()))
    }

    /// Searches for a square that is nearer to `point` than the best so far (squared distance, and point), row by row.
    fn nearest_square(&self, point: Point, best: &mut (f64, Option<Point>)) {
        let (cell, size) = (self.cell_at(point), self.resolution);
        if !self.in_row.contains(cell) {
            // The outside is wall.
            *best = (0.0, Some(point));
            return;
        }
        let mut look = |row: i32, y: f64| {
            let height = y - point.y;
            if height * height >= best.0 {
                return false;
            }
            let [left, right] = self.in_row.get(Cell::new(cell.x, row)).map_or([0; 2], |cells| cells.map(i32::from));
            if left == 0 {
                nearer(best, point, Point::new(point.x, y));
            } else {
                let ends = [f64::from(cell.x - left + 1) * size, f64::from(cell.x + right) * size];
                nearer(best, point, Point::new(ends[0].min(point.x), y));
                nearer(best, point, Point::new(ends[1].max(point.x), y));
            }
            true
        };
        look(cell.y, point.y);
        let (mut is_open_above, mut is_open_below) = (true, true);
        let mut rows = 1;
        while is_open_above || is_open_below {
            let (above, below) = (cell.y + rows, cell.y - rows);
            is_open_above = is_open_above && look(above, (f64::from(above) * size).max(point.y));
            is_open_below = is_open_below && look(below, (f64::from(below + 1) * size).min(point.y));
            rows += 1;
        }
    }

    /// Calls `visit` with every obstacle that can reach into the box between `low` and `high`; squares in runs.
    #[inline]
    pub fn near<'a>(&'a self, low: Point, high: Point, mut visit: impl FnMut(Obstacle<'a>)) {
        let size = self.resolution;
        let (first, last) = (self.cell_at(low), self.cell_at(high));
        let (width, height) = (self.squares.width() as i32, self.squares.height() as i32);
        for y in first.y..=last.y {
            let mut run = |from: i32, to: i32| {
                let corner = |x: i32, y: i32| Point::new(f64::from(x) * size, f64::from(y) * size);
                visit(Obstacle::Squares(corner(from, y), corner(to, y + 1)));
            };
            if !(0..height).contains(&y) {
                run(first.x, last.x + 1);
                continue;
            }
            let start = y as usize * self.squares.width();
            let row = &self.squares.values()[start..start + width as usize];
            let is_wall = |x: i32| row.get(x as usize).copied().unwrap_or(true);
            let mut since = None;
            for x in first.x..=last.x {
                match (is_wall(x), since) {
                    (true, None) => since = Some(x),
                    (false, Some(from)) => {
                        run(from, x);
                        since = None;
                    }
                    _ => {}
                }
            }
            if let Some(from) = since {
                run(from, last.x + 1);
            }
        }
        self.shapes.in_box(low, high, |shape| visit(Obstacle::Shape(shape)));
    }

    /// Whether a point lies in a wall or shape.
    pub fn contains(&self, point: Point) -> bool {
        let is_wall = self.squares.get(self.cell_at(point)).copied().unwrap_or(true);
        let mut is_inside = is_wall;
        if !is_wall {
            self.shapes.in_box(point, point, |shape| is_inside |= shape.contains(point));
        }
        is_inside
    }

    /// Calls `visit` with every shape that can reach into the box between `low` and `high`.
    #[inline]
    pub fn shapes_in_box<'a>(&'a self, low: Point, high: Point, visit: impl FnMut(&'a Shape)) {
        self.shapes.in_box(low, high, visit);
    }

    /// All shapes.
    pub fn shapes(&self) -> &[Shape] {
        self.shapes.all()
    }

    /// Fine cells that are wall, without the shapes.
    pub fn squares(&self) -> &Grid<bool> {
        &self.squares
    }

    fn cell_at(&self, point: Point) -> Cell {
        Cell::at(point, self.resolution)
    }
}

/// Takes a point of a wall that is nearer to `point` than the best so far.
#[inline]
fn nearer(best: &mut (f64, Option<Point>), point: Point, wall: Point) {
    let distance = (wall - point).norm_squared();
    if distance < best.0 {
        *best = (distance, Some(wall));
    }
}

/// Cells from each one to the next in its row that is set, to the left and to the right; the outside counts as set.
fn in_row(squares: &Grid<bool>) -> Grid<[u16; 2]> {
    let mut cells = squares.map(|_| [0_u16; 2]);
    let width = squares.width();
    for (row, out) in squares.values().chunks(width).zip(cells.values_mut().chunks_mut(width)) {
        let mut since = 0_u16;
        let mut next = |is_wall: bool| {
            since = if is_wall { 0 } else { since.saturating_add(1) };
            since
        };
        row.iter().zip(out.iter_mut()).for_each(|(&is_wall, cell)| cell[0] = next(is_wall));
        next(true);
        row.iter().zip(out.iter_mut()).rev().for_each(|(&is_wall, cell)| cell[1] = next(is_wall));
    }
    cells
}

/// Sets every cell of `touched` that a shape overlaps.
fn rasterise(shape: &Shape, resolution: f64, touched: &mut Grid<bool>) {
    let (low, high) = shape.bounds();
    let last = |n: usize| n as i32 - 1;
    let (first, end) = (Cell::at(low, resolution), Cell::at(high, resolution));
    let corner = |x: i32, y: i32| Point::new(f64::from(x) * resolution, f64::from(y) * resolution);
    for y in first.y.max(0)..=end.y.min(last(touched.height())) {
        for x in first.x.max(0)..=end.x.min(last(touched.width())) {
            if shape.overlaps_box(corner(x, y), corner(x + 1, y + 1)) {
                touched[Cell::new(x, y)] = true;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thin_leg_is_met_where_it_stands_and_blocks_its_cells() {
        let leg = Shape::Disc { centre: Point::new(0.51, 0.51), radius: 0.0025 };
        let walls = Walls::new(Grid::filled(20, 20, false), vec![leg], 0.05, 0.1);
        let (wall, distance) = walls.nearest(Point::new(0.41, 0.51), 0.2).unwrap();
        assert!((distance - 0.0975).abs() < 1e-12 && (wall - Point::new(0.5075, 0.51)).norm() < 1e-12);
        assert_eq!(walls.clearance[Cell::new(10, 10)], 0.0);
        assert!(walls.clearance[Cell::new(9, 10)] > 0.0 && !walls.contains(Point::new(0.53, 0.53)));
        assert!(walls.has_room(Point::new(0.41, 0.51), 0.09) && !walls.has_room(Point::new(0.41, 0.51), 0.1));
    }

    #[test]
    fn nearest_agrees_with_every_square_and_shape() {
        use rand::RngExt;
        let mut rng = crate::rng::seeded(4, 99);
        for _ in 0..50 {
            let mut squares = Grid::filled(30, 20, false);
            squares.values_mut().iter_mut().for_each(|s| *s = rng.random_bool(0.03));
            let mut at = || Point::new(rng.random_range(0.0..1.5), rng.random_range(0.0..1.0));
            let corner = at();
            let triangle = vec![corner, corner + Vector::new(0.3, 0.1), corner + Vector::new(0.1, 0.2)];
            let shapes = vec![Shape::Convex(triangle), Shape::Disc { centre: at(), radius: 0.03 }];
            let walls = Walls::new(squares, shapes.clone(), 0.05, 0.15);
            let point = at();
            let outside = point.x.min(point.y).min(1.5 - point.x).min(1.0 - point.y);
            let in_grid = walls.squares().iter().filter(|(_, s)| **s).map(|(cell, _)| {
                let (x, y) = (f64::from(cell.x) * 0.05, f64::from(cell.y) * 0.05);
                (Point::new(point.x.clamp(x, x + 0.05), point.y.clamp(y, y + 0.05)) - point).norm()
            });
            let to_shapes = shapes.iter().map(|s| (s.nearest(point) - point).norm());
            let expected = in_grid.chain(to_shapes).fold(outside, f64::min);
            let found = walls.nearest(point, 0.2).map_or(f64::MAX, |(_, distance)| distance);
            assert!((found.min(0.2) - expected.min(0.2)).abs() < 1e-9, "{found} {expected}");
            let promised = walls.clearance.get(Cell::at(point, 0.05)).map_or(0.0, |&c| f64::from(c));
            assert!(promised - 0.7072 * 0.05 <= expected + 1e-6, "{promised} m promised, {expected} m there");
        }
    }
}
