//! Where a body fits that keeps its heading, or turns within its circle: exact in the centre of every fine cell.

use super::{
    Obstacle, Walls,
    stamp::{PolygonStamp, StampRun, fitting},
};
use crate::{
    geometry::{Point, Shape, Vector, convex_pieces, edges, outward, overlap, overlap_box, overlap_disc},
    grid::Grid,
    math,
};

/// Overlap that counts as touching, m.
const HAIR: f64 = 1e-6;

/// Fine cells in whose centre a disc of `radius` metres fits.
pub(super) fn for_disc(limits: &Walls, radius: f64) -> Grid<bool> {
    let mut fits = limits.clearance.map(|&c| f64::from(c) >= radius);
    for index in 0..fits.len() {
        let cell = fits.cell(index);
        // Shapes count as if they filled every cell that they touch, which is at most a diagonal too much.
        if !fits[cell] && f64::from(limits.clearance[cell]) >= radius - 1.5 * limits.resolution {
            fits[cell] = limits.nearest(cell.centre(limits.resolution), radius - HAIR).is_none();
        }
    }
    fits
}

/// Fine cells in whose centre the polygon with these `corners` (m, counter-clockwise) fits at `heading` rad. `covered` are
/// the cells whose centre is in an obstacle.
pub(super) fn for_polygon(limits: &Walls, covered: &Grid<bool>, corners: &[[f64; 2]], heading: f64) -> Grid<bool> {
    let runs = PolygonStamp::new(corners, limits.resolution).around(heading);
    // By centres of cells it is right but for half a cell; certain where even a cell more is free of all that is touched.
    let mut fits = fitting(&covered.map(|&is_covered| !is_covered), &runs);
    let larger: Vec<StampRun> =
        runs.iter().flat_map(|&(dy, first, last)| [-1, 0, 1].map(|up| (dy + up, first - 1, last + 1))).collect();
    let certain = fitting(&limits.clearance.map(|&c| c > 0.0), &larger);
    let body = TurnedBody::new(corners, heading);
    for index in 0..fits.len() {
        let cell = fits.cell(index);
        if fits[cell] && !certain[cell] {
            fits[cell] = body.fits(limits, cell.centre(limits.resolution));
        }
    }
    fits
}

/// Convex pieces of a body at a heading, with the normals of their sides, and the box around them.
struct TurnedBody {
    pieces: Vec<(Vec<Point>, Vec<Vector>)>,
    low: Vector,
    high: Vector,
}

impl TurnedBody {
    fn new(corners: &[[f64; 2]], heading: f64) -> Self {
        let (sin, cos) = math::sin_cos(heading);
        let turned = |&[x, y]: &[f64; 2]| Point::new(cos * x - sin * y, sin * x + cos * y);
        let corners: Vec<Point> = corners.iter().map(turned).collect();
        let (low, high) = corners
            .iter()
            .fold((Vector::zeros(), Vector::zeros()), |(low, high), p| (low.inf(&p.coords), high.sup(&p.coords)));
        let with_normals = |piece: Vec<Point>| {
            let normals = edges(&piece).map(|(a, b)| outward(a, b)).collect();
            (piece, normals)
        };
        Self { pieces: convex_pieces(&corners).into_iter().map(with_normals).collect(), low, high }
    }

    fn fits(&self, limits: &Walls, at: Point) -> bool {
        let placed: Vec<Vec<Point>> =
            self.pieces.iter().map(|(piece, _)| piece.iter().map(|p| p + at.coords).collect()).collect();
        let mut is_free = true;
        limits.near(at + self.low, at + self.high, |obstacle| {
            is_free = is_free
                && placed.iter().zip(&self.pieces).all(|(piece, (_, normals))| {
                    let found = match obstacle {
                        Obstacle::Squares(low, high) => overlap_box(piece, normals, low, high),
                        Obstacle::Shape(Shape::Convex(corners)) => overlap(piece, normals, corners),
                        Obstacle::Shape(&Shape::Disc { centre, radius }) => overlap_disc(piece, centre, radius),
                    };
                    found.is_none_or(|(depth, _)| depth < HAIR)
                });
        });
        is_free
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        coverage::ReachableFloor,
        cspace::{Motion, Outline},
        floor_plan::{Object, Sketch},
        geometry::Pose,
        grid::Cell,
        robot::{OwnRobot, WheelLayout, model},
    };

    /// What the configuration space finds with other geometry.
    #[test]
    fn standing_places_are_those_of_the_configuration_space() {
        let mut plan = Sketch::open(3.0, 2.5, 0.05).fill(&[[1.2, 0.0, 1.3, 1.1], [2.0, 1.6, 2.6, 2.5]]).finish("", "");
        plan.objects.push(Object::Leg { at: Point::new(0.7, 1.6), radius: 0.02 });
        let sliver = [(1.5, 1.5), (1.9, 1.9), (1.897, 1.903), (1.497, 1.503)];
        plan.objects.push(Object::Furniture { outline: sliver.map(|(x, y)| Point::new(x, y)).to_vec() });
        let start = Pose::new(0.45, 0.45, 0.0);
        for corners in [
            vec![],
            vec![[0.21, -0.13], [0.21, 0.13], [-0.21, 0.13], [-0.21, -0.13]],
            vec![[0.3, -0.1], [0.3, 0.1], [0.0, 0.1], [0.0, 0.3], [-0.15, 0.3], [-0.15, -0.1]],
        ] {
            let radius = corners.is_empty().then_some(0.183);
            let own = OwnRobot { radius, corners, wheels: Some(WheelLayout::Omnidirectional), ..OwnRobot::default() };
            let robot = own.of(model("octagon").unwrap());
            let floor = ReachableFloor::of_path(&plan, &robot, start).unwrap();
            let free = Motion::new(&plan, &Outline::of(&robot), 0.0).unwrap().steps(floor.resolution).unwrap().free();
            let wrong: Vec<Cell> =
                floor.standing.iter().filter(|&(cell, &stands)| stands && !free[cell]).map(|(cell, _)| cell).collect();
            assert_eq!(wrong, [], "{own:?}");
            let missed = free.count() - floor.standing.count();
            assert_eq!(missed, floor.closed_off_cells, "{own:?}: {missed} of {}", free.count());
        }
    }
}
