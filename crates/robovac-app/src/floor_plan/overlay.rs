//! A sweep as lines on layers of a drawing.

use coverage_planners::sweep::Sweep;
use floor_drawing::{DrawingError, Overlay, Traced, outlines, to_dxf};
use robovac_core::geometry::{Point, Vector};

/// Half the size of the cross that marks a subgoal, as a share of the distance between scan lines.
const CROSS: f64 = 0.25;

/// A DXF of the sweep on layers of its own, added to `original`, the DXF that `room` was traced from, or otherwise to
/// the room's outlines in metres from the map's origin.
pub fn sweep_dxf(sweep: &Sweep, room: &Traced, original: Option<&[u8]>) -> Result<Vec<u8>, DrawingError> {
    if original.is_some() {
        return to_dxf(original, &overlays(sweep, |point| room.to_drawing(point)));
    }
    let mut layers = overlays(sweep, |point| room.plan.origin.to_world(point));
    layers.extend(outlines(&room.plan));
    to_dxf(None, &layers)
}

/// The sweep on layers in drawing units: `SWEEP_SUBGOALS`, a cross a point (AutoCAD colour 1, red);
/// `SWEEP_LINKS`, the straight links of Fig. 4, through obstacles or not (2, yellow); `SWEEP_PATH`, the path of Fig. 5
/// with the last stage (5, blue); `SWEEP_FINISH`, the strokes of that stage, if there are any (3, green). `place` makes a
/// point of the drawing of one of the room.
pub fn overlays(sweep: &Sweep, place: impl Fn(Point) -> Point) -> Vec<Overlay> {
    let arm = CROSS * sweep.scan_width;
    let crosses = sweep.subgoals.iter().flat_map(|subgoal| {
        [Vector::new(arm, arm), Vector::new(arm, -arm)]
            .map(|arm| vec![place(subgoal.at - arm), place(subgoal.at + arm)])
    });
    let links = sweep.links.iter().map(|link| [link.from, link.to].map(|end| place(sweep.subgoals[end].at)).to_vec());
    let layer = |name: &str, colour, lines| Overlay { layer: name.to_owned(), colour, lines };
    let finish: Vec<Vec<Point>> = sweep.finish.iter().map(|way| way.iter().copied().map(&place).collect()).collect();
    let mut layers = vec![
        layer("SWEEP_SUBGOALS", 1, crosses.collect()),
        layer("SWEEP_LINKS", 2, links.collect()),
        layer("SWEEP_PATH", 5, vec![sweep.path.iter().copied().map(&place).collect()]),
    ];
    if !finish.is_empty() {
        layers.push(layer("SWEEP_FINISH", 3, finish));
    }
    layers
}
