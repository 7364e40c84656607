//! Overlay of the map: trails, robot outlines, particles, uncertainty.

use robovac_app::Viewport;
use robovac_core::{
    geometry::{Point, Pose},
    math::{self, TAU},
};
use robovac_playground::canvas::robot::dash;
use robovac_sim::mapping::PoseCovariance;
use wasm_bindgen::JsValue;
use web_sys::CanvasRenderingContext2d;

/// Standard deviations that are drawn: two contain 86 % of a normal distribution in the plane.
const DEVIATIONS: f64 = 2.0;
/// Most particles that are drawn; of more, a regular selection.
const MOST_PARTICLES: usize = 400;
/// Widest half of a wedge, rad; beyond it the heading is unknown.
const WIDEST: f64 = 3.0;

/// A trail, fading out.
pub(super) fn trail(
    context: &CanvasRenderingContext2d,
    viewport: &Viewport,
    points: &[Point],
    (colour, width): (&str, f64),
) {
    const PIECES: usize = 12;
    context.set_line_width(width);
    context.set_line_join("round");
    context.set_stroke_style_str(colour);
    let piece = points.len().div_ceil(PIECES).max(1);
    let pieces = points.len().div_ceil(piece).max(1);
    for i in 0..pieces {
        let part = &points[(i * piece).min(points.len())..(i * piece + piece + 1).min(points.len())];
        context.set_global_alpha((i + 1) as f64 / pieces as f64);
        context.begin_path();
        for (j, &point) in part.iter().enumerate() {
            let at = viewport.to_screen(point);
            if j == 0 { context.move_to(at.x, at.y) } else { context.line_to(at.x, at.y) }
        }
        context.stroke();
    }
    context.set_global_alpha(1.0);
}

/// Frontiers, from where they can be entered.
pub(super) fn frontiers(
    context: &CanvasRenderingContext2d,
    viewport: &Viewport,
    pieces: &[[Point; 2]],
    colour: &str,
) -> Result<(), JsValue> {
    context.set_stroke_style_str(colour);
    context.set_fill_style_str(colour);
    context.set_line_width(1.0);
    context.set_global_alpha(0.7);
    dash(context, &[1.5, 3.0])?;
    context.begin_path();
    for [entry, end] in pieces.iter().map(|piece| piece.map(|at| viewport.to_screen(at))) {
        context.move_to(entry.x, entry.y);
        context.line_to(end.x, end.y);
    }
    context.stroke();
    dash(context, &[])?;
    for at in pieces.iter().map(|[entry, _]| viewport.to_screen(*entry)) {
        context.fill_rect(at.x - 1.75, at.y - 1.75, 3.5, 3.5);
    }
    context.set_global_alpha(1.0);
    Ok(())
}

/// The route, with a ring at its end.
pub(super) fn route(
    context: &CanvasRenderingContext2d,
    viewport: &Viewport,
    (from, corners): (Point, &[Point]),
    (colour, halo): (&str, &str),
) -> Result<(), JsValue> {
    let Some(&last) = corners.last() else { return Ok(()) };
    context.set_line_join("round");
    context.begin_path();
    for (i, at) in std::iter::once(&from).chain(corners).map(|&at| viewport.to_screen(at)).enumerate() {
        if i == 0 { context.move_to(at.x, at.y) } else { context.line_to(at.x, at.y) }
    }
    context.set_line_width(1.25);
    context.set_stroke_style_str(colour);
    context.stroke();
    let at = viewport.to_screen(last);
    for (width, colour) in [(4.5, halo), (2.0, colour)] {
        context.begin_path();
        context.arc(at.x, at.y, 5.0, 0.0, TAU)?;
        context.set_line_width(width);
        context.set_stroke_style_str(colour);
        context.stroke();
    }
    Ok(())
}

/// A robot as a dashed circle with its heading.
pub(super) fn ghost(
    context: &CanvasRenderingContext2d,
    (radius, viewport): (f64, &Viewport),
    pose: Pose,
    (colour, halo, dashes): (&str, &str, [f64; 2]),
) -> Result<(), JsValue> {
    let at = viewport.to_screen(pose.position());
    let radius = (radius * viewport.scale).max(5.0);
    context.save();
    context.translate(at.x, at.y)?;
    context.rotate(-pose.heading)?;
    context.set_line_cap("butt");
    context.begin_path();
    context.arc(0.0, 0.0, radius, 0.0, TAU)?;
    context.move_to(0.45 * radius, 0.0);
    context.line_to(1.25 * radius, 0.0);
    for (width, colour, dashes) in [(4.5, halo, &[][..]), (2.25, colour, &dashes[..])] {
        dash(context, dashes)?;
        context.set_line_width(width);
        context.set_stroke_style_str(colour);
        context.stroke();
    }
    context.restore();
    Ok(())
}

/// Possible poses, fainter if less likely.
pub(super) fn particles(context: &CanvasRenderingContext2d, viewport: &Viewport, poses: &[(Pose, f64)], colour: &str) {
    let most = poses.iter().map(|(_, weight)| *weight).fold(0.0, f64::max);
    context.set_stroke_style_str(colour);
    context.set_fill_style_str(colour);
    context.set_line_width(1.25);
    for (pose, weight) in poses.iter().step_by(poses.len().div_ceil(MOST_PARTICLES).max(1)) {
        let at = viewport.to_screen(pose.position());
        let (sin, cos) = math::sin_cos(pose.heading);
        context.set_global_alpha(if most > 0.0 { 0.25 + 0.6 * weight / most } else { 0.5 });
        context.fill_rect(at.x - 1.5, at.y - 1.5, 3.0, 3.0);
        context.begin_path();
        context.move_to(at.x, at.y);
        context.line_to(at.x + 9.0 * cos, at.y - 9.0 * sin);
        context.stroke();
    }
    context.set_global_alpha(1.0);
}

/// The robot's uncertainty: an ellipse around its estimated position, a wedge for its heading.
pub(super) fn doubt(
    context: &CanvasRenderingContext2d,
    (radius, viewport): (f64, &Viewport),
    pose: Pose,
    spread: &PoseCovariance,
    (fill, line): (&str, &str),
) -> Result<(), JsValue> {
    let at = viewport.to_screen(pose.position());
    let (axes, direction) = spread.ellipse();
    let [long, short] = axes.map(|axis| DEVIATIONS * axis * viewport.scale);
    context.set_fill_style_str(fill);
    context.set_stroke_style_str(line);
    context.set_line_width(1.25);
    if long.is_finite() && long > 0.5 {
        context.begin_path();
        context.ellipse(at.x, at.y, long, short.max(0.5), -direction, 0.0, TAU)?;
        context.fill();
        context.stroke();
    }
    let half = (DEVIATIONS * spread.heading).min(WIDEST);
    if half > 0.005 {
        let reach = 2.6 * radius * viewport.scale;
        context.begin_path();
        context.move_to(at.x, at.y);
        context.arc(at.x, at.y, reach, -pose.heading - half, -pose.heading + half)?;
        context.close_path();
        context.fill();
        context.stroke();
    }
    Ok(())
}
