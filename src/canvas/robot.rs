//! Draws a robot from above.

use robovac_app::{Palette, RobotView};
use robovac_core::{
    geometry::{Point, Pose},
    math::{self, FRAC_PI_2, TAU},
    robot::{Body, Bumper},
};
use wasm_bindgen::JsValue;
use web_sys::CanvasRenderingContext2d;

/// Radius below which a robot is no longer drawn to scale, CSS pixels, as it would be hard to see.
pub const LEAST_RADIUS: f64 = 5.0;

/// Enlargement of a lifted robot, and distance of its shadow, in radii.
const LIFTED: (f64, f64) = (1.08, 0.3);

/// Draws `robot` at `centre`; one unit of the context is a CSS pixel.
pub fn draw(
    context: &CanvasRenderingContext2d,
    palette: &Palette,
    robot: &RobotView,
    centre: Point,
    scale: f64,
) -> Result<(), JsValue> {
    let (grown, fall) = if robot.is_lifted { LIFTED } else { (1.0, 0.12) };
    let radius = (robot.radius * scale).max(LEAST_RADIUS) * grown;
    context.save();
    context.translate(centre.x, centre.y)?;
    context.save();
    context.translate(0.4 * fall * radius, fall * radius)?;
    context.rotate(-robot.pose.heading)?;
    context.begin_path();
    outline(context, &robot.body, robot.radius, 1.06 * radius)?;
    context.set_fill_style_str(if robot.is_lifted { "rgb(0 0 0 / 0.34)" } else { "rgb(0 0 0 / 0.22)" });
    context.fill();
    context.restore();
    // From here on, x is ahead, y to the right.
    context.rotate(-robot.pose.heading)?;
    context.begin_path();
    outline(context, &robot.body, robot.radius, radius)?;
    context.set_line_join("round");
    context.set_line_width(0.1 * radius + 3.0);
    context.set_stroke_style_str(palette.halo);
    context.stroke();
    context.set_fill_style_str(palette.body);
    context.fill();

    if let Some(Bumper { half_arc, .. }) = robot.suite.bumper {
        // The halves don't touch, so that a pressed one stands out.
        for (from, to, is_pressed) in [(-half_arc, -0.02, robot.bump_left), (0.02, half_arc, robot.bump_right)] {
            bumper(context, robot, radius, (from, to), if is_pressed { palette.bump } else { palette.bumper })?;
            if is_pressed {
                context.begin_path();
                context.arc(0.0, 0.0, 1.16 * radius, from, to)?;
                context.set_line_width(0.15 * radius);
                context.set_line_cap("butt");
                context.set_stroke_style_str(palette.bump);
                context.set_global_alpha(0.55);
                context.stroke();
                context.set_global_alpha(1.0);
            }
        }
    }
    if radius > 12.0 {
        details(context, palette, robot, radius)?;
    }
    // The heading.
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

/// Adds the outline of a body whose circle has a radius of `metres`, drawn with `radius`; x is ahead, y to the right.
fn outline(context: &CanvasRenderingContext2d, body: &Body, metres: f64, radius: f64) -> Result<(), JsValue> {
    match body {
        Body::Round => context.arc(0.0, 0.0, radius, 0.0, TAU)?,
        Body::Polygon(corners) => {
            let unit = radius / metres;
            for (index, [x, y]) in corners.iter().enumerate() {
                let (x, y) = (unit * x, -unit * y);
                if index == 0 { context.move_to(x, y) } else { context.line_to(x, y) }
            }
            context.close_path();
        }
    }
    Ok(())
}

/// Draws the rim of the body between two angles, clockwise from ahead.
fn bumper(
    context: &CanvasRenderingContext2d,
    robot: &RobotView,
    radius: f64,
    (from, to): (f64, f64),
    colour: &str,
) -> Result<(), JsValue> {
    context.save();
    context.begin_path();
    context.move_to(0.0, 0.0);
    context.arc(0.0, 0.0, 1.5 * radius, from, to)?;
    context.close_path();
    context.clip();
    context.begin_path();
    outline(context, &robot.body, robot.radius, radius)?;
    context.clip();
    // Half of the line is outside of the body and clipped away.
    context.set_line_width(0.3 * radius);
    context.set_stroke_style_str(colour);
    context.stroke();
    context.restore();
    Ok(())
}

/// Brush, castors and sensors, when zoomed in.
fn details(
    context: &CanvasRenderingContext2d,
    palette: &Palette,
    robot: &RobotView,
    radius: f64,
) -> Result<(), JsValue> {
    context.set_stroke_style_str(palette.body_line);
    context.set_line_width((0.03 * radius).max(1.0));
    if robot.body == Body::Round {
        context.begin_path();
        context.arc(0.0, 0.0, 0.78 * radius, 0.0, TAU)?;
        context.stroke();
    }
    context.begin_path();
    context.arc(-0.2 * radius, 0.0, 0.24 * radius, 0.0, TAU)?;
    context.stroke();
    let unit = radius / robot.radius;
    // Castors, under the body: a wheel seen from above, in the ring in which it swivels.
    for castor in robot.castors {
        let (x, y, size) = (unit * castor.at[0], -unit * castor.at[1], unit * castor.radius);
        context.begin_path();
        context.arc(x, y, size, 0.0, TAU)?;
        context.stroke();
        context.stroke_rect(x - 0.8 * size, y - 0.3 * size, 1.6 * size, 0.6 * size);
    }
    // Windows of the light bumper, in its rim.
    if let Some(light) = robot.suite.light_bumper {
        context.set_fill_style_str(palette.body);
        for angle in light.angles {
            let edge = 0.925 * unit * robot.body.reach(robot.radius, angle);
            let (x, y) = (edge * math::cos(angle), -edge * math::sin(angle));
            disc(context, x, y, (0.035 * radius).max(1.0), palette.body)?;
        }
    }
    if let Some(laser) = robot.suite.laser {
        disc(context, unit * laser.at[0], -unit * laser.at[1], 0.13 * radius, palette.sensor)?;
    }
    // The strip that is being cleaned, which the body hides.
    let half = (0.5 * robot.tool_width * unit).min(0.95 * radius);
    context.set_line_width((0.07 * radius).max(1.5));
    context.set_line_cap("round");
    context.begin_path();
    context.move_to(-0.02 * radius, -half);
    context.line_to(-0.02 * radius, half);
    context.stroke();
    Ok(())
}

/// Marks the start: a dashed ring with the heading.
pub fn draw_start(
    context: &CanvasRenderingContext2d,
    palette: &Palette,
    start: &Pose,
    centre: Point,
    (body, metres, scale): (Body, f64, f64),
) -> Result<(), JsValue> {
    let radius = (metres * scale).max(LEAST_RADIUS);
    context.save();
    context.translate(centre.x, centre.y)?;
    context.rotate(-start.heading)?;
    context.begin_path();
    outline(context, &body, metres, radius)?;
    context.set_fill_style_str("rgb(255 255 255 / 0.22)");
    context.fill();
    context.set_stroke_style_str(palette.start);
    context.set_line_width(2.0);
    context.set_line_cap("round");
    context.set_line_join("round");
    dash(context, &[5.0, 5.0])?;
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

/// Marks the robot's estimated pose.
pub fn draw_estimate(
    context: &CanvasRenderingContext2d,
    palette: &Palette,
    estimate: &Pose,
    centre: Point,
    (body, metres, scale): (Body, f64, f64),
) -> Result<(), JsValue> {
    let radius = (metres * scale).max(LEAST_RADIUS);
    context.save();
    context.translate(centre.x, centre.y)?;
    context.rotate(-estimate.heading)?;
    context.set_stroke_style_str(palette.estimate);
    context.set_line_width(2.0);
    dash(context, &[4.0, 4.0])?;
    context.begin_path();
    outline(context, &body, metres, radius)?;
    context.stroke();
    dash(context, &[])?;
    context.begin_path();
    context.move_to(0.5 * radius, 0.0);
    context.line_to(radius, 0.0);
    context.stroke();
    context.restore();
    Ok(())
}

/// A filled circle.
pub fn disc(context: &CanvasRenderingContext2d, x: f64, y: f64, radius: f64, colour: &str) -> Result<(), JsValue> {
    context.begin_path();
    context.arc(x, y, radius, 0.0, 4.0 * FRAC_PI_2)?;
    context.set_fill_style_str(colour);
    context.fill();
    Ok(())
}

/// Sets the dashes and gaps of lines; solid if there are none.
pub fn dash(context: &CanvasRenderingContext2d, pattern: &[f64]) -> Result<(), JsValue> {
    let list: js_sys::Array = pattern.iter().map(|&length| JsValue::from_f64(length)).collect();
    context.set_line_dash(&list)
}
