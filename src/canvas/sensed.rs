//! Draws the beams of a robot's sensors and what they detect.

use crate::canvas::robot::disc;
use robovac_app::{Palette, RobotView, SensedFloor, Viewport};
use robovac_core::{
    geometry::{Pose, Vector},
    math::{self, TAU},
    robot::{Laser, LightBumper},
};
use wasm_bindgen::JsValue;
use web_sys::CanvasRenderingContext2d;

/// Largest value of a light bumper's signal.
const FULL: f64 = 4095.0;
/// Half the angle of a light bumper's cone, rad, as it is drawn.
const CONE: f64 = 0.09;

/// Draws what lies beside the robot, cones and rays; one unit of the context is a CSS pixel.
pub fn draw(
    context: &CanvasRenderingContext2d,
    palette: &Palette,
    robot: &RobotView,
    sensed: &SensedFloor<'_>,
    viewport: &Viewport,
) -> Result<(), JsValue> {
    if robot.is_lifted {
        return Ok(());
    }
    if let (Some(laser), Some(scan)) = (robot.suite.laser, &sensed.reading.laser) {
        draw_scan(context, palette, robot.pose, laser, scan, viewport)?;
    }
    if let Some(light) = robot.suite.light_bumper {
        draw_light(context, palette, robot, light, sensed, viewport)?;
    }
    Ok(())
}

/// Marks the cliff sensors, which sit under the body.
pub fn draw_cliffs(
    context: &CanvasRenderingContext2d,
    palette: &Palette,
    robot: &RobotView,
    sensed: &SensedFloor<'_>,
    viewport: &Viewport,
) -> Result<(), JsValue> {
    if robot.is_lifted {
        return Ok(());
    }
    for (index, spot) in robot.suite.cliffs.into_iter().enumerate() {
        let Some([x, y]) = spot else { continue };
        let at = viewport.to_screen(robot.pose.position() + turned(Vector::new(x, y), robot.pose.heading));
        let is_over_cliff = sensed.reading.cliff[index];
        let size = (0.012 * viewport.scale).max(2.5);
        disc(context, at.x, at.y, size + 1.5, palette.halo)?;
        disc(context, at.x, at.y, size, if is_over_cliff { palette.bump } else { palette.sensor })?;
    }
    Ok(())
}

/// The beams of the light bumper: each as a cone that ends where it hits something, the brighter the stronger its signal.
fn draw_light(
    context: &CanvasRenderingContext2d,
    palette: &Palette,
    robot: &RobotView,
    light: LightBumper,
    sensed: &SensedFloor<'_>,
    viewport: &Viewport,
) -> Result<(), JsValue> {
    for (index, angle) in light.angles.into_iter().enumerate() {
        let heading = robot.pose.heading + angle;
        let way = Vector::new(math::cos(heading), math::sin(heading));
        let from = robot.pose.position() + way * robot.body.reach(robot.radius, angle);
        let hit = sensed.floor.walls.ray(from, way, light.range).map(|hit| hit.distance);
        let (at, reach) = (viewport.to_screen(from), hit.unwrap_or(light.range) * viewport.scale);
        let strength = (f64::from(sensed.reading.light_signal[index]) / FULL).clamp(0.0, 1.0).sqrt();
        context.begin_path();
        context.move_to(at.x, at.y);
        context.arc(at.x, at.y, reach, -heading - CONE, -heading + CONE)?;
        context.close_path();
        context.set_fill_style_str(palette.sensor);
        context.set_global_alpha(0.22 + 0.6 * strength);
        context.fill();
        context.set_global_alpha(1.0);
        if let Some(distance) = hit {
            let end = viewport.to_screen(from + way * distance);
            disc(
                context,
                end.x,
                end.y,
                2.5,
                if sensed.reading.light_bumper[index] { palette.bump } else { palette.sensor },
            )?;
        }
    }
    Ok(())
}

/// A laser scan: a veil over the scanned area, and a point at the end of every beam.
fn draw_scan(
    context: &CanvasRenderingContext2d,
    palette: &Palette,
    pose: Pose,
    laser: Laser,
    scan: &[f32],
    viewport: &Viewport,
) -> Result<(), JsValue> {
    let origin = pose.position() + turned(Vector::new(laser.at[0], laser.at[1]), pose.heading);
    let middle = viewport.to_screen(origin);
    let ends = || {
        scan.iter().enumerate().map(|(beam, &range)| {
            let is_hit = range.is_finite();
            let range = if is_hit { f64::from(range) } else { laser.range[1] };
            let heading = pose.heading + laser.first + beam as f64 * laser.step;
            let end = origin + Vector::new(math::cos(heading), math::sin(heading)) * range;
            (viewport.to_screen(end), is_hit)
        })
    };
    context.begin_path();
    context.move_to(middle.x, middle.y);
    ends().for_each(|(end, _)| context.line_to(end.x, end.y));
    context.close_path();
    context.set_fill_style_str(palette.sensor);
    context.set_global_alpha(0.13);
    context.fill();
    context.set_global_alpha(1.0);
    context.begin_path();
    for (end, _) in ends().filter(|(_, is_hit)| *is_hit) {
        context.move_to(end.x + 1.6, end.y);
        context.arc(end.x, end.y, 1.6, 0.0, TAU)?;
    }
    context.fill();
    Ok(())
}

/// A vector of the robot's frame in the room's.
fn turned(at: Vector, heading: f64) -> Vector {
    let (sin, cos) = (math::sin(heading), math::cos(heading));
    Vector::new(at.x * cos - at.y * sin, at.x * sin + at.y * cos)
}
