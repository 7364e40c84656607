//! A flat of its own for each seed, with doors, windows and furniture.

use super::sheet::Sheet;
use rand::RngExt;
use robovac_core::{
    geometry::{Point, Vector},
    grid::{Cell, Grid, reachable},
    math::ceil,
    rng::{Rng, seeded},
};

/// A doorway: its jambs where the leaf shuts, and the direction in which it opens.
pub struct Doorway {
    hinge: Point,
    jamb: Point,
    into: Vector,
    /// That of the wall, m.
    thickness: f64,
    leaves: usize,
}

/// A plan without symbols of doors and with them, and its doorways.
pub struct DrawnPlan {
    pub bare: Sheet,
    pub drawn: Sheet,
    pub doors: Vec<Doorway>,
}

/// Where the rooms begin, and the thickness of the walls, m.
struct Rooms {
    xs: Vec<f64>,
    ys: Vec<f64>,
    outer: f64,
    inner: f64,
}

impl Rooms {
    fn new(margin: f64, scale: f64, rng: &mut Rng) -> Self {
        let outer = rng.random_range(0.15..0.3);
        let inner = rng.random_range(0.1_f64.max(5.0 / scale)..0.2);
        let mut lines = |count: usize| {
            let mut lines = vec![margin + outer];
            for index in 0..count {
                lines.push(lines[index] + rng.random_range(2.6..4.5) + inner);
            }
            lines
        };
        let (xs, ys) = (lines(2), lines(2));
        Self { xs, ys, outer, inner }
    }

    /// Lower left and upper right corner of a room.
    fn room(&self, column: usize, row: usize) -> [f64; 4] {
        [self.xs[column], self.ys[row], self.xs[column + 1] - self.inner, self.ys[row + 1] - self.inner]
    }

    fn walls(&self) -> Vec<[f64; 4]> {
        let ([left, bottom, ..], [.., right, top]) = (self.room(0, 0), self.room(1, 1));
        let (outer, inner) = (self.outer, self.inner);
        vec![
            [left - outer, bottom - outer, right + outer, bottom],
            [left - outer, top, right + outer, top + outer],
            [left - outer, bottom, left, top],
            [right, bottom, right + outer, top],
            [self.xs[1] - inner, bottom, self.xs[1], top],
            [left, self.ys[1] - inner, right, self.ys[1]],
        ]
    }

    fn windows(&self, rng: &mut Rng) -> Vec<[f64; 4]> {
        let [_, _, right, top] = self.room(1, 1);
        let upright = |y: f64, width: f64| [right, y + 0.6, right + self.outer, y + 0.6 + width];
        let level = |x: f64, width: f64| [x + 0.6, top, x + 0.6 + width, top + self.outer];
        let mut windows: Vec<[f64; 4]> = self.ys[..2].iter().map(|&y| upright(y, rng.random_range(0.8..1.6))).collect();
        windows.extend(self.xs[..2].iter().map(|&x| level(x, rng.random_range(0.8..1.6))));
        windows
    }

    fn doors(&self, rng: &mut Rng) -> Vec<Doorway> {
        let ([x0, x1, _], [y0, y1, _]) = ([self.xs[0], self.xs[1], 0.0], [self.ys[0], self.ys[1], 0.0]);
        let (inner, outer) = (self.inner, self.outer);
        let mut from = |low: f64, high: f64| rng.random_range(low + 0.1..high - inner - 1.9);
        // The front door, those between the columns, and those between the rows.
        let places = [
            (Point::new(x0 + 0.3, y0 - outer), false, outer),
            (Point::new(x1 - inner, from(y0, y1)), true, inner),
            (Point::new(x1 - inner, from(y1, self.ys[2])), true, inner),
            (Point::new(from(x0, x1), y1 - inner), false, inner),
        ];
        places.into_iter().map(|(at, is_upright, thickness)| Doorway::new(at, is_upright, thickness, rng)).collect()
    }
}

impl Doorway {
    /// A doorway up or to the right of the wall's corner `at`.
    fn new(at: Point, is_upright: bool, thickness: f64, rng: &mut Rng) -> Self {
        let leaves = if rng.random_bool(0.15) { 2 } else { 1 };
        let width = if leaves == 2 { rng.random_range(1.2..1.8) } else { rng.random_range(0.7..1.1) };
        let [along, across] = if is_upright { [Vector::y(), Vector::x()] } else { [Vector::x(), Vector::y()] };
        let is_far = rng.random_bool(0.5);
        let low = if is_far { at + across * thickness } else { at };
        let (hinge, jamb) = (low, low + along * width);
        let (hinge, jamb) = if rng.random_bool(0.5) { (hinge, jamb) } else { (jamb, hinge) };
        Self { hinge, jamb, into: if is_far { across } else { -across }, thickness, leaves }
    }

    /// The rectangle around the places that are so far before and behind the doorway.
    fn around(&self, before: f64, behind: f64) -> [f64; 4] {
        let ends = [self.hinge, self.jamb].map(|jamb| [jamb + self.into * before, jamb - self.into * behind]);
        let low = ends.as_flattened().iter().fold(self.hinge, |low, end| low.inf(end));
        let high = ends.as_flattened().iter().fold(self.hinge, |high, end| high.sup(end));
        [low.x, low.y, high.x, high.y]
    }

    fn width(&self) -> f64 {
        (self.jamb - self.hinge).norm()
    }

    fn draw(&self, sheet: &mut Sheet, is_box: bool, is_central: bool, has_threshold: bool) {
        let back = self.into * if is_central { self.thickness / 2.0 } else { 0.0 };
        let (width, along) = (self.width() / self.leaves as f64, (self.jamb - self.hinge).normalize());
        let hinges = [(self.hinge - back, along), (self.jamb - back, -along)];
        for &(hinge, along) in &hinges[..self.leaves] {
            let tip = hinge + self.into * width;
            sheet.line(hinge, tip);
            if is_box {
                let by = along * 0.04;
                sheet.line(hinge + by, tip + by);
                sheet.line(tip, tip + by);
            }
            sheet.quarter(hinge, width, [along, self.into]);
        }
        if has_threshold {
            let by = self.into * self.thickness;
            sheet.line(self.hinge, self.jamb);
            sheet.line(self.hinge - by, self.jamb - by);
        }
    }
}

/// Draws furniture with lines: corner baths, stairs, boxes and round tables, where no door swings.
fn furnish(sheet: &mut Sheet, room: [f64; 4], doors: &[Doorway], rng: &mut Rng) {
    let is_free = |[x0, y0, x1, y1]: [f64; 4]| {
        doors.iter().all(|door| {
            let around = door.around(door.width() + 0.5, door.thickness + 0.5);
            x0 > around[2] + 0.1 || x1 < around[0] - 0.1 || y0 > around[3] + 0.1 || y1 < around[1] - 0.1
        })
    };
    let (corner, radius) = (Point::new(room[2], room[1]), rng.random_range(0.8..1.3));
    if is_free([corner.x - radius, corner.y, corner.x, corner.y + radius]) {
        sheet.quarter(corner, radius, [-Vector::x(), Vector::y()]);
        sheet.quarter(corner, radius - 0.08, [-Vector::x(), Vector::y()]);
    }
    for index in 0..6 {
        let size = Vector::new(rng.random_range(0.3..1.6), rng.random_range(0.3..1.6));
        let at = [0, 1].map(|axis| rng.random_range(room[axis]..room[axis + 2] - size[axis]));
        let x = if index % 2 == 0 { room[0] } else { at[0] };
        let bounds = [x, at[1], x + size.x, at[1] + size.y];
        if !is_free(bounds) {
            continue;
        }
        if index % 3 == 0 {
            let radius = size.min() / 2.0;
            sheet.circle(Point::new(x + radius, at[1] + radius), radius);
        } else {
            sheet.frame(bounds);
        }
        if index == 4 {
            let steps = (1..5).map(|step| bounds[1] + f64::from(step) / 5.0 * size.y);
            steps.for_each(|y| sheet.line(Point::new(bounds[0], y), Point::new(bounds[2], y)));
        }
    }
}

pub fn drawn_plan(seed: u64) -> DrawnPlan {
    let mut rng = seeded(seed, 0x646f);
    let rng = &mut rng;
    let root: f64 = rng.random_range(6.4..12.2);
    let scale = root * root;
    let turn = [0.0, 0.0, 0.03, -0.02, 0.35][rng.random_range(0..5)];
    let rooms = Rooms::new(if turn == 0.35 { 3.7 } else { 1.7 }, scale, rng);
    let [_, _, right, top] = rooms.room(1, 1);
    let sides = [right + rooms.xs[0], top + rooms.ys[0]].map(|metres| (metres * scale) as usize);
    let mut bare = Sheet {
        cells: Grid::filled(sides[0], sides[1], false),
        scale,
        turn,
        pen: rng.random_range(1.0..3.0_f64.min(0.4 * rooms.inner * scale)),
        missing: if rng.random_bool(0.3) { 0.2 } else { 0.0 },
        rng: seeded(seed, 0x696e),
    };
    let (doors, windows) = (rooms.doors(rng), rooms.windows(rng));
    rooms.walls().into_iter().for_each(|wall| bare.fill(wall, true));
    for door in &doors {
        bare.fill(door.around(0.0, door.thickness), false);
    }
    for window @ [x0, y0, x1, y1] in windows {
        bare.fill(window, false);
        bare.frame(window);
        // The pane.
        let (low, high) = (Point::new(x0, y0), Point::new(x1, y1));
        let across = if x1 - x0 < y1 - y0 { Vector::new(x1 - x0, 0.0) } else { Vector::new(0.0, y1 - y0) };
        bare.line(low + across / 2.0, high - across / 2.0);
    }
    for index in 0..4 {
        furnish(&mut bare, rooms.room(index % 2, index / 2), &doors, rng);
    }
    let mut drawn = bare.clone();
    let [is_box, is_central, has_threshold] = [0.4, 0.25, 0.3].map(|share| rng.random_bool(share));
    for door in &doors {
        door.draw(&mut drawn, is_box, is_central, has_threshold);
    }
    DrawnPlan { bare, drawn, doors }
}

impl DrawnPlan {
    /// Whether something 20 cm wide gets through a doorway, by the moves from each pixel to the next dark one.
    pub fn is_passable(&self, door: &Doorway, moves: &Grid<u8>) -> bool {
        let middle = door.hinge + (door.jamb - door.hinge) * 0.5;
        let before = door.into * (door.width() / door.leaves as f64 + 0.25);
        let [centre, from, to] = [Vector::zeros(), before, -door.into * (door.thickness + 0.25)]
            .map(|by| self.drawn.pixel(middle + by))
            .map(|at| Cell::new(at.x as i32, at.y as i32));
        let far = ceil((1.5 * door.width() + 0.5) * self.drawn.scale);
        let mut free = Grid::filled(2 * far as usize, 2 * far as usize, false);
        let inner = |cell: Cell| Cell::new(cell.x - centre.x + far, cell.y - centre.y + far);
        for (cell, &moves) in moves.iter() {
            if free.contains(inner(cell)) {
                free[inner(cell)] = i32::from(moves) >= ceil(0.1 * self.drawn.scale);
            }
        }
        let [from, to] = [from, to].map(inner);
        free.is_set(from) && free.is_set(to) && reachable(&free, from)[to]
    }
}
