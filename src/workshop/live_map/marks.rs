//! Bumps and cliffs on the live map.

use robovac_app::{Palette, Viewport};
use robovac_core::{
    geometry::{Point, Pose, Vector},
    math::{self, TAU},
    robot::RobotModel,
};
use wasm_bindgen::JsValue;
use web_sys::CanvasRenderingContext2d;

/// Direction of the middle of either half of the bumper, rad from ahead.
const HALF: f64 = 0.7;

/// A place with a contact.
pub(super) struct FeltMark {
    /// In the room, m.
    at: Point,
    /// Whether it is a cliff rather than an obstacle.
    pub is_cliff: bool,
}

impl FeltMark {
    /// The contacts of a robot at `place`: bits as in `robovac_link::connection::Connection::take_trace`.
    pub fn of(robot: &RobotModel, place: Pose, felt: u8) -> impl Iterator<Item = Self> {
        let rim = |angle: f64| Point::new(robot.radius * math::cos(angle), robot.radius * math::sin(angle));
        let bumpers = [(1, HALF), (2, -HALF)].map(|(bit, angle)| (bit, rim(angle), false));
        let both = felt & 3 == 3;
        let bumpers = if both { [(1, rim(0.0), false), (0, rim(0.0), false)] } else { bumpers };
        let cliff = |index: usize| robot.sensors.cliffs[index].map_or(Point::origin(), |[x, y]| Point::new(x, y));
        let cliffs = [4, 8, 16, 32].into_iter().enumerate().map(move |(index, bit)| (bit, cliff(index), true));
        let all: Vec<_> = bumpers.into_iter().chain(cliffs).filter(|&(bit, ..)| felt & bit != 0).collect();
        all.into_iter().map(move |(_, at, is_cliff)| Self { at: place.to_world(at), is_cliff })
    }
}

/// Draws them: bumps as dots, cliffs as crosses, so that they don't differ in colour alone.
pub(super) fn draw(
    context: &CanvasRenderingContext2d,
    palette: &Palette,
    marks: &[FeltMark],
    shift: Vector,
    viewport: &Viewport,
) -> Result<(), JsValue> {
    let size = (0.03 * viewport.scale).clamp(2.5, 6.0);
    context.set_line_cap("round");
    for mark in marks {
        let at = viewport.to_screen(mark.at + shift);
        context.begin_path();
        if mark.is_cliff {
            context.move_to(at.x - size, at.y - size);
            context.line_to(at.x + size, at.y + size);
            context.move_to(at.x - size, at.y + size);
            context.line_to(at.x + size, at.y - size);
            for (width, colour) in [(4.5, palette.halo), (2.0, palette.warning)] {
                context.set_line_width(width);
                context.set_stroke_style_str(colour);
                context.stroke();
            }
        } else {
            context.arc(at.x, at.y, size, 0.0, TAU)?;
            context.set_fill_style_str(palette.bump);
            context.fill();
            context.set_line_width(1.5);
            context.set_stroke_style_str(palette.text);
            context.stroke();
        }
    }
    Ok(())
}
