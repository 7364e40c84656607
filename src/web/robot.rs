//! Draws a robot as it is seen from above.

use crate::{
    app::{Palette, RobotView},
    geometry::{Point, Pose},
    math::{FRAC_PI_2, TAU},
};
use wasm_bindgen::JsValue;
use web_sys::CanvasRenderingContext2d;

/// Radius below which a robot is no longer drawn to scale, CSS pixels: it would get lost.
const LEAST_RADIUS: f64 = 5.0;
/// Half the angle that the bumper spans, radians.
const BUMPER: f64 = 1.35;

/// Draws `robot` at `centre`; one unit of the context is a CSS pixel.
pub(super) fn draw(
    context: &CanvasRenderingContext2d,
    palette: &Palette,
    robot: &RobotView,
    centre: Point,
    scale: f64,
) -> Result<(), JsValue> {
    let radius = (robot.radius * scale).max(LEAST_RADIUS);
    context.save();
    context.translate(centre.x, centre.y)?;
    disc(context, 0.0, 0.12 * radius, 1.06 * radius, "rgb(0 0 0 / 0.22)")?;
    // From here on, x is ahead, y to the right.
    context.rotate(-robot.pose.heading)?;
    disc(context, 0.0, 0.0, radius + 0.05 * radius + 1.5, palette.halo)?;
    disc(context, 0.0, 0.0, radius, palette.body)?;

    let thickness = 0.15 * radius;
    context.set_line_width(thickness);
    context.set_line_cap("butt");
    for (from, to, is_pressed) in [(-BUMPER, -0.02, robot.bump_left), (0.02, BUMPER, robot.bump_right)] {
        context.begin_path();
        context.arc(0.0, 0.0, radius - 0.5 * thickness, from, to)?;
        context.set_stroke_style_str(if is_pressed { palette.bump } else { palette.bumper });
        context.stroke();
        if is_pressed {
            context.begin_path();
            context.arc(0.0, 0.0, 1.16 * radius, from, to)?;
            context.set_global_alpha(0.55);
            context.stroke();
            context.set_global_alpha(1.0);
        }
    }
    if radius > 12.0 {
        details(context, palette, robot, radius)?;
    }
    // Which way it looks.
    context.begin_path();
    context.move_to(0.66 * radius, 0.0);
    context.line_to(0.28 * radius, -0.24 * radius);
    context.line_to(0.28 * radius, 0.24 * radius);
    context.close_path();
    context.set_fill_style_str(palette.accent);
    context.fill();
    context.restore();
    Ok(())
}

/// Brush, wheels and button, for those who look closely.
fn details(
    context: &CanvasRenderingContext2d,
    palette: &Palette,
    robot: &RobotView,
    radius: f64,
) -> Result<(), JsValue> {
    context.set_stroke_style_str(palette.body_line);
    context.set_line_width((0.03 * radius).max(1.0));
    context.begin_path();
    context.arc(0.0, 0.0, 0.78 * radius, 0.0, TAU)?;
    context.stroke();
    context.begin_path();
    context.arc(-0.2 * radius, 0.0, 0.24 * radius, 0.0, TAU)?;
    context.stroke();
    // The strip that is being cleaned, which the body hides.
    let half = (0.5 * robot.tool_width / robot.radius * radius).min(0.95 * radius);
    context.set_line_width((0.07 * radius).max(1.5));
    context.set_line_cap("round");
    context.begin_path();
    context.move_to(-0.02 * radius, -half);
    context.line_to(-0.02 * radius, half);
    context.stroke();
    Ok(())
}

/// Marks the start: a dashed ring with the way to set off.
pub(super) fn draw_start(
    context: &CanvasRenderingContext2d,
    palette: &Palette,
    start: &Pose,
    centre: Point,
    radius: f64,
) -> Result<(), JsValue> {
    let radius = radius.max(LEAST_RADIUS);
    context.save();
    context.translate(centre.x, centre.y)?;
    context.rotate(-start.heading)?;
    disc(context, 0.0, 0.0, radius, "rgb(255 255 255 / 0.22)")?;
    context.set_stroke_style_str(palette.start);
    context.set_line_width(2.0);
    context.set_line_cap("round");
    context.set_line_join("round");
    dash(context, &[5.0, 5.0])?;
    context.begin_path();
    context.arc(0.0, 0.0, radius, 0.0, TAU)?;
    context.stroke();
    dash(context, &[])?;
    context.begin_path();
    context.move_to(-0.12 * radius, -0.34 * radius);
    context.line_to(0.26 * radius, 0.0);
    context.line_to(-0.12 * radius, 0.34 * radius);
    context.stroke();
    context.restore();
    Ok(())
}

/// Marks where the robot believes to be.
pub(super) fn draw_estimate(
    context: &CanvasRenderingContext2d,
    palette: &Palette,
    estimate: &Pose,
    centre: Point,
    radius: f64,
) -> Result<(), JsValue> {
    let radius = radius.max(LEAST_RADIUS);
    context.save();
    context.translate(centre.x, centre.y)?;
    context.rotate(-estimate.heading)?;
    context.set_stroke_style_str(palette.estimate);
    context.set_line_width(2.0);
    dash(context, &[4.0, 4.0])?;
    context.begin_path();
    context.arc(0.0, 0.0, radius, 0.0, TAU)?;
    context.stroke();
    dash(context, &[])?;
    context.begin_path();
    context.move_to(0.5 * radius, 0.0);
    context.line_to(radius, 0.0);
    context.stroke();
    context.restore();
    Ok(())
}

fn disc(context: &CanvasRenderingContext2d, x: f64, y: f64, radius: f64, colour: &str) -> Result<(), JsValue> {
    context.begin_path();
    context.arc(x, y, radius, 0.0, 4.0 * FRAC_PI_2)?;
    context.set_fill_style_str(colour);
    context.fill();
    Ok(())
}

fn dash(context: &CanvasRenderingContext2d, pattern: &[f64]) -> Result<(), JsValue> {
    let list: js_sys::Array = pattern.iter().map(|&length| JsValue::from_f64(length)).collect();
    context.set_line_dash(&list)
}
