//! Trajectories from a worker: eight numbers for each knot.

use js_sys::Float64Array;
use robovac_core::{
    geometry::Pose,
    trajectory::{Knot, Trajectory},
};

/// Time, way, x, y, heading, curvature, speed and corner of each knot in turn.
pub fn trajectory_to_js(trajectory: &Trajectory) -> Float64Array {
    let flat = trajectory.knots().iter().flat_map(|knot| {
        let Knot { time_s, distance_m, pose, curvature, speed, corner } = *knot;
        [time_s, distance_m, pose.x, pose.y, pose.heading, curvature, speed, corner as f64]
    });
    Float64Array::from(flat.collect::<Vec<f64>>().as_slice())
}

/// The inverse.
pub fn trajectory_from_js(flat: &[f64]) -> Trajectory {
    let knot = |&[time_s, distance_m, x, y, heading, curvature, speed, corner]: &[f64; 8]| Knot {
        time_s,
        distance_m,
        pose: Pose { x, y, heading },
        curvature,
        speed,
        corner: corner as usize,
    };
    Trajectory::of_knots(flat.as_chunks().0.iter().map(knot).collect())
}
