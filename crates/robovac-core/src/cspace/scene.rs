//! Obstacles and their Minkowski sums with the outline.

use super::{
    Outline,
    outline::bounds,
    sum::{ConvexPiece, Sum},
};
use crate::{
    coverage::{drop_offs, obstacles},
    floor_plan::FloorPlan,
    geometry::{Point, Shape},
};

/// The obstacles of a room.
#[derive(Debug, Clone)]
pub(super) struct ObstacleScene {
    /// Side of the plan's cells, m.
    pub resolution: f64,
    /// Width and height, m.
    pub size: (f64, f64),
    /// Left and right end of every run of cells that aren't free, m, row by row from the bottom.
    pub rows: Vec<Vec<(f64, f64)>>,
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
        let columns = plan.occupancy.width();
        let rows = plan.occupancy.values().chunks(columns).map(|row| {
            let (mut runs, mut x) = (Vec::new(), 0);
            while x < columns {
                let is_free = row[x].is_free();
                let end = row[x..].iter().position(|o| o.is_free() != is_free).map_or(columns, |run| x + run);
                if !is_free {
                    runs.push((x as f64 * resolution, end as f64 * resolution));
                }
                x = end;
            }
            runs
        });
        let mut shapes = obstacles(plan);
        shapes.extend(drop_offs(plan));
        Self { resolution, size: (plan.width_m(), plan.height_m()), rows: rows.collect(), shapes }
    }

    pub fn sums(&self, outline: &Outline, heading: f64) -> Sums {
        let line = [Point::origin(), Point::new(0.0, self.resolution)];
        match outline {
            Outline::Circle { radius } => Sums {
                line: vec![Sum::of_round(&line, *radius)],
                shapes: self
                    .shapes
                    .iter()
                    .map(|shape| match shape {
                        Shape::Disc { centre, radius: own } => Sum::of_round(&[*centre], radius + own),
                        Shape::Convex(corners) => Sum::of_round(corners, *radius),
                    })
                    .collect(),
                reach: outline.bounds(),
            },
            Outline::Polygon(_) => {
                let pieces = outline.pieces(heading);
                let reach = bounds(&pieces.concat());
                let pieces: Vec<ConvexPiece> = pieces.into_iter().map(ConvexPiece::new).collect();
                let sum = |shape: &Shape, piece: &ConvexPiece| match shape {
                    Shape::Disc { centre, radius } => Sum::of_disc(*centre, *radius, piece),
                    Shape::Convex(corners) => Sum::of_polygons(corners, piece),
                };
                Sums {
                    line: pieces.iter().map(|piece| Sum::of_polygons(&line, piece)).collect(),
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
