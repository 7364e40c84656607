//! Shapes drawn in a picture.

use rand::RngExt;
use robovac_core::{
    geometry::{Point, Vector},
    grid::{Cell, Grid},
    math::{cos, sin},
    rng::Rng,
};

/// What is drawn, in metres, turned around its middle.
#[derive(Clone)]
pub struct Sheet {
    pub cells: Grid<bool>,
    /// Pixels per metre.
    pub scale: f64,
    pub turn: f64,
    /// Thickness of lines, pixels, and the share of their pixels that is missing.
    pub pen: f64,
    pub missing: f64,
    pub rng: Rng,
}

impl Sheet {
    fn turned(&self, place: Vector, turn: f64) -> Point {
        let middle = Vector::new(self.cells.width() as f64, self.cells.height() as f64) / 2.0;
        let (by, sin, cos) = (place - middle, sin(turn), cos(turn));
        Point::new(by.x * cos - by.y * sin, by.x * sin + by.y * cos) + middle
    }

    /// Where a place is in the picture.
    pub fn pixel(&self, at: Point) -> Point {
        self.turned(at.coords * self.scale, self.turn)
    }

    /// The pixels around some corners that are at most `far` metres from a shape.
    fn near(&self, corners: &[Point], far: f64, distance: impl Fn(Point) -> f64) -> Vec<Cell> {
        let corners: Vec<Point> = corners.iter().map(|&corner| self.pixel(corner)).collect();
        let low = corners.iter().fold(corners[0], |low, corner| low.inf(corner));
        let high = corners.iter().fold(corners[0], |high, corner| high.sup(corner));
        let beside = (far * self.scale) as i32 + 1;
        let rows = low.y as i32 - beside..=high.y as i32 + beside;
        let all = rows.flat_map(|y| (low.x as i32 - beside..=high.x as i32 + beside).map(move |x| Cell::new(x, y)));
        let place = |cell: Cell| self.turned(cell.centre(1.0).coords, -self.turn) / self.scale;
        all.filter(|&cell| self.cells.contains(cell) && distance(place(cell)) <= far).collect()
    }

    fn stroke(&mut self, corners: &[Point], distance: impl Fn(Point) -> f64) {
        for cell in self.near(corners, self.pen / 2.0 / self.scale, distance) {
            self.cells[cell] |= !self.rng.random_bool(self.missing);
        }
    }

    /// Fills a rectangle, or clears it.
    pub fn fill(&mut self, [x0, y0, x1, y1]: [f64; 4], is_dark: bool) {
        let corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)].map(|(x, y)| Point::new(x, y));
        for cell in self.near(&corners, 0.0, |at| (x0 - at.x).max(at.x - x1).max(y0 - at.y).max(at.y - y1)) {
            self.cells[cell] = is_dark;
        }
    }

    pub fn line(&mut self, a: Point, b: Point) {
        self.stroke(&[a, b], |at| {
            let share = (at - a).dot(&(b - a)) / (b - a).norm_squared();
            (at - (a + (b - a) * share.clamp(0.0, 1.0))).norm()
        });
    }

    pub fn frame(&mut self, [x0, y0, x1, y1]: [f64; 4]) {
        let corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)].map(|(x, y)| Point::new(x, y));
        (0..4).for_each(|side| self.line(corners[side], corners[(side + 1) % 4]));
    }

    /// The part of a circle between two perpendicular directions.
    pub fn quarter(&mut self, centre: Point, radius: f64, directions: [Vector; 2]) {
        let ends = directions.map(|direction| centre + direction * radius);
        self.stroke(&[centre, ends[0], ends[1], ends[0] + (ends[1] - centre)], |at| {
            let is_there = directions.iter().all(|direction| (at - centre).dot(direction) >= 0.0);
            if is_there { ((at - centre).norm() - radius).abs() } else { f64::MAX }
        });
    }

    pub fn circle(&mut self, centre: Point, radius: f64) {
        let [x, y] = [Vector::x(), Vector::y()];
        for pair in [[x, y], [-x, y], [x, -y], [-x, -y]] {
            self.quarter(centre, radius, pair);
        }
    }
}
