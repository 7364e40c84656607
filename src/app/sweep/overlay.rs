//! A sweep as lines on layers of a drawing.

use super::Sweep;
use crate::{
    drawing::Overlay,
    geometry::{Point, Vector},
};

/// Half the size of the cross that marks a subgoal, as a share of the distance between scan lines.
const CROSS: f64 = 0.25;

/// The sweep on three layers in drawing units: SUBGOALS, a cross a point (AutoCAD colour 1, red); LINKS, the straight
/// links of Fig. 4, through obstacles or not (2, yellow); SWEEP, the path of Fig. 5 (5, blue). `corner` is where the
/// room's lower left corner lies in the drawing, and `metre` how many metres a drawing unit has, as in
/// [`crate::drawing::Traced`].
pub fn overlays(sweep: &Sweep, corner: Vector, metre: f64) -> Vec<Overlay> {
    let place = |point: Point| Point::from(corner + point.coords / metre);
    let arm = CROSS * sweep.scan_width;
    let crosses = sweep.subgoals.iter().flat_map(|subgoal| {
        [Vector::new(arm, arm), Vector::new(arm, -arm)]
            .map(|arm| vec![place(subgoal.at - arm), place(subgoal.at + arm)])
    });
    let links = sweep.links.iter().map(|link| [link.from, link.to].map(|end| place(sweep.subgoals[end].at)).to_vec());
    let layer = |name: &str, colour, lines| Overlay { layer: name.to_owned(), colour, lines };
    vec![
        layer("SUBGOALS", 1, crosses.collect()),
        layer("LINKS", 2, links.collect()),
        layer("SWEEP", 5, vec![sweep.path.iter().copied().map(place).collect()]),
    ]
}
