//! Obstacles and their Minkowski sums with the outline.

use super::{
    Outline,
    obstacles::RunSets,
    outline::{bounds, drawn_out},
    sum::{ConvexPiece, Sum},
};
use crate::{
    coverage::{drop_offs, obstacles},
    floor_plan::FloorPlan,
    geometry::{Point, Shape, Vector},
};

/// The obstacles of a room.
#[derive(Debug, Clone)]
pub(super) struct ObstacleScene {
    /// Side of the plan's cells, m.
    pub resolution: f64,
    /// Width and height, m.
    pub size: (f64, f64),
    /// Left and right end of every run of cells that aren't free, m, row by row from the bottom: first those of walls,
    /// then those of obstacles.
    ///
    /// Cells that are connected with the plan's edge are wall. Those that touch one side of it only are an obstacle that
    /// stands against the wall.
    pub rows: [Vec<Vec<(f64, f64)>>; 2],
    shapes: Vec<Shape>,
}

/// The sums of a scene and an outline at one heading.
#[derive(Debug, Clone)]
pub(super) struct Sums {
    /// The sums of every piece of the outline and a vertical line at the origin, as high as a cell of the plan.
    pub line: Vec<Sum>,
    /// The sums of every piece and every shape.
    pub shapes: Vec<Sum>,
    /// The box around the outline.
    pub reach: (Point, Point),
}

impl ObstacleScene {
    pub fn of(plan: &FloorPlan) -> Self {
        let resolution = plan.resolution;
        let (columns, rows) = (plan.occupancy.width(), plan.occupancy.height());
        let mut found = RunSets::of(&plan.occupancy.map(|cell| cell.is_free()), false);
        let sides = found.marks(|y, (first, last)| {
            [first == 0, last as usize + 1 == columns, y == 0, y + 1 == rows]
                .into_iter()
                .fold(0, |sides, touches| 2 * sides + u8::from(touches))
        });
        let runs_of = |walls: bool| -> Vec<Vec<(f64, f64)>> {
            let row = |ends: &[u32]| {
                let (begin, end) = (ends[0] as usize, ends[1] as usize);
                let mine = found.runs[begin..end].iter().zip(&sides[begin..end]);
                let mine = mine.filter(|&(_, sides)| (sides.count_ones() > 1) == walls);
                mine.map(|(&(first, last, _), _)| (f64::from(first) * resolution, (f64::from(last) + 1.0) * resolution))
                    .collect()
            };
            found.starts.windows(2).map(row).collect()
        };
        let runs = [true, false].map(runs_of);
        let mut shapes = obstacles(plan);
        shapes.extend(drop_offs(plan));
        Self { resolution, size: (plan.width_m(), plan.height_m()), rows: runs, shapes }
    }

    /// The sums of what an outline covers at a heading while it moves straight `along` a way, by the place where it
    /// begins. `margin` is the distance that it keeps, m; below 0 it may overlap as much.
    pub fn sums(&self, outline: &Outline, heading: f64, along: Vector, margin: f64) -> Sums {
        let line = [Point::origin(), Point::new(0.0, self.resolution)];
        match outline {
            Outline::Circle { radius } => {
                let (low, high) = outline.bounds();
                let round =
                    |corners: &[Point], own: f64| Sum::of_round(&drawn_out(corners, -along), radius + own, margin);
                Sums {
                    line: vec![round(&line, 0.0)],
                    shapes: self
                        .shapes
                        .iter()
                        .map(|shape| match shape {
                            Shape::Disc { centre, radius: own } => round(&[*centre], *own),
                            Shape::Convex(corners) => round(corners, 0.0),
                        })
                        .collect(),
                    reach: (low.inf(&(low + along)), high.sup(&(high + along))),
                }
            }
            Outline::Polygon(_) => {
                let pieces: Vec<_> = outline.pieces(heading).iter().map(|piece| drawn_out(piece, along)).collect();
                let reach = bounds(&pieces.concat());
                let pieces: Vec<ConvexPiece> = pieces.into_iter().map(ConvexPiece::new).collect();
                let sum = |shape: &Shape, piece: &ConvexPiece| match shape {
                    Shape::Disc { centre, radius } => Sum::of_disc(*centre, *radius, piece, margin),
                    Shape::Convex(corners) => Sum::of_polygons(corners, piece, margin),
                };
                Sums {
                    line: pieces.iter().map(|piece| Sum::of_polygons(&line, piece, margin)).collect(),
                    shapes: self
                        .shapes
                        .iter()
                        .flat_map(|shape| pieces.iter().map(move |piece| sum(shape, piece)))
                        .collect(),
                    reach,
                }
            }
        }
    }
}
