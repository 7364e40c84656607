//! Overlay of the Floor plan tab: closed gaps, objects, region, pointer actions, scale bar.
//! One unit of the context is a CSS pixel.

use js_sys::Array;
use robovac_app::{
    Palette, Viewport,
    floor_plan::{DrawingPart, DrawingSession, DrawingTool},
};
use robovac_core::{
    floor_plan::Object,
    geometry::{Point, Pose},
    math::TAU,
};
use robovac_playground::canvas::scale_bar::Bar;
use wasm_bindgen::JsValue;
use web_sys::OffscreenCanvasRenderingContext2d as Context;

/// Half the length of the crosshair's arms, CSS pixels.
const ARM: f64 = 14.0;

/// A line through `points`, seen through `view`.
fn trace(context: &Context, view: &Viewport, points: &[Point], is_closed: bool) {
    context.begin_path();
    for (index, &point) in points.iter().enumerate() {
        let at = view.to_screen(point);
        if index == 0 { context.move_to(at.x, at.y) } else { context.line_to(at.x, at.y) }
    }
    if is_closed {
        context.close_path();
    }
}

/// Sets or clears the dashing of lines.
pub(super) fn dash(context: &Context, pattern: &[f64]) -> Result<(), JsValue> {
    context.set_line_dash(&pattern.iter().map(|&length| JsValue::from_f64(length)).collect::<Array>())
}

/// A line that is visible on every background.
fn stroke(context: &Context, colour: &str, width: f64, palette: &Palette) {
    context.set_line_width(width + 2.0);
    context.set_stroke_style_str(palette.halo);
    context.stroke();
    context.set_line_width(width);
    context.set_stroke_style_str(colour);
    context.stroke();
}

/// Gaps between walls that were closed: dashed, with a dot at each end. `view` is onto the room.
pub(super) fn gaps(context: &Context, view: &Viewport, gaps: &[[Point; 2]], dark: bool) -> Result<(), JsValue> {
    // Okabe and Ito's reddish purple.
    let colour = if dark { "#e59cc4" } else { "#b0478a" };
    context.begin_path();
    for [from, to] in gaps {
        let (from, to) = (view.to_screen(*from), view.to_screen(*to));
        context.move_to(from.x, from.y);
        context.line_to(to.x, to.y);
    }
    context.set_stroke_style_str(colour);
    context.set_line_width(2.5);
    dash(context, &[5.0, 4.0])?;
    context.stroke();
    dash(context, &[])?;
    context.begin_path();
    for &point in gaps.iter().flatten() {
        let at = view.to_screen(point);
        context.move_to(at.x + 3.0, at.y);
        context.arc(at.x, at.y, 3.0, 0.0, TAU)?;
    }
    context.set_fill_style_str(colour);
    context.fill();
    Ok(())
}

/// Objects of the room. `view` is onto the room.
pub(super) fn objects(
    context: &Context,
    view: &Viewport,
    objects: &[Object],
    palette: &Palette,
) -> Result<(), JsValue> {
    let disc = |at: Point, radius: f64| {
        let centre = view.to_screen(at);
        context.begin_path();
        context.arc(centre.x, centre.y, (radius * view.scale).max(1.5), 0.0, TAU)
    };
    let ahead = |pose: &Pose, length: f64| pose.to_world(Point::new(length, 0.0));
    for object in objects {
        let (fill, line) = match object {
            Object::Furniture { outline } => {
                trace(context, view, outline, true);
                (palette.furniture, palette.furniture_line)
            }
            Object::LowObstacle { outline, .. } => {
                trace(context, view, outline, true);
                (palette.carpet, palette.furniture_line)
            }
            Object::Leg { at, radius } => {
                disc(*at, *radius)?;
                (palette.furniture, palette.furniture_line)
            }
            Object::DropOff { outline } => {
                trace(context, view, outline, true);
                (palette.drop_off, palette.warning)
            }
            Object::Carpet { outline } => {
                trace(context, view, outline, true);
                (palette.carpet, palette.carpet_line)
            }
            Object::Dirt { at, radius } => {
                disc(*at, *radius)?;
                (palette.dirt, palette.dirt)
            }
            Object::Dock { pose } => {
                disc(ahead(pose, 0.07), 0.12)?;
                (palette.body, palette.body_line)
            }
            Object::VirtualWall { pose, length } => {
                trace(context, view, &[pose.position(), ahead(pose, *length)], false);
                (palette.fence, palette.fence_line)
            }
            Object::Mover { path, .. } => {
                trace(context, view, path, false);
                ("transparent", palette.person)
            }
        };
        context.set_fill_style_str(fill);
        context.fill();
        context.set_line_width(1.25);
        context.set_stroke_style_str(line);
        context.stroke();
    }
    Ok(())
}

/// The part of the drawing to be traced.
pub(super) fn part(
    context: &Context,
    session: &DrawingSession,
    viewport: &Viewport,
    palette: &Palette,
) -> Result<(), JsValue> {
    let place = |&[x, y]: &[f64; 2]| session.sheet().place(Point::new(x, y));
    match &session.settings().part {
        DrawingPart::Indoors | DrawingPart::Whole => return Ok(()),
        DrawingPart::Rectangle { corners: [a, b] } => {
            let corners = [*a, [b[0], a[1]], *b, [a[0], b[1]]];
            trace(context, viewport, &corners.each_ref().map(place), true);
        }
        DrawingPart::Polygon { corners } => {
            trace(context, viewport, &corners.iter().map(place).collect::<Vec<_>>(), true);
        }
        DrawingPart::Room { at } => {
            let at = viewport.to_screen(place(at));
            context.begin_path();
            context.arc(at.x, at.y, 5.0, 0.0, TAU)?;
        }
    }
    dash(context, &[8.0, 5.0])?;
    stroke(context, palette.select, 2.0, palette);
    dash(context, &[])
}

/// The places that an error or a hint is about: a ring around an opening, a cross on a point.
pub(super) fn faults(
    context: &Context,
    session: &DrawingSession,
    viewport: &Viewport,
    palette: &Palette,
) -> Result<(), JsValue> {
    let Some(metre) = session.settings().metre else { return Ok(()) };
    for mark in session.marks() {
        let at = viewport.to_screen(session.sheet().place(mark.at));
        context.begin_path();
        if mark.width > 0.0 {
            let radius = 0.75 * mark.width / metre * session.sheet().scale * viewport.scale;
            context.arc(at.x, at.y, radius.clamp(12.0, 120.0), 0.0, TAU)?;
        } else {
            for (x, y) in [(7.0, 7.0), (7.0, -7.0)] {
                context.move_to(at.x - x, at.y - y);
                context.line_to(at.x + x, at.y + y);
            }
        }
        stroke(context, palette.warning, 3.0, palette);
    }
    Ok(())
}

/// Set points, the shape that they begin, and the crosshair.
pub(super) fn hand(
    context: &Context,
    session: &DrawingSession,
    viewport: &Viewport,
    palette: &Palette,
) -> Result<(), JsValue> {
    let hand = &session.hand;
    let place = |point: Point| session.sheet().place(point);
    let mut line: Vec<Point> = hand.points.iter().map(|&point| place(point)).collect();
    let next = hand.crosshair.or(hand.hover).map(place);
    match (hand.tool, next, line.first()) {
        (DrawingTool::Rectangle, Some(next), Some(&first)) => {
            line = vec![first, Point::new(next.x, first.y), next, Point::new(first.x, next.y), first];
        }
        (DrawingTool::Scale, ..) if line.len() == 2 => {}
        (DrawingTool::Scale | DrawingTool::Polygon, Some(next), Some(_)) => line.push(next),
        _ => {}
    }
    trace(context, viewport, &line, false);
    stroke(context, palette.accent, 2.0, palette);
    for &point in &hand.points {
        let at = viewport.to_screen(place(point));
        context.begin_path();
        context.arc(at.x, at.y, 4.0, 0.0, TAU)?;
        context.set_fill_style_str(palette.accent);
        stroke(context, palette.accent, 1.0, palette);
        context.fill();
    }
    if let Some(at) = hand.crosshair.filter(|_| hand.tool != DrawingTool::View) {
        let at = viewport.to_screen(place(at));
        context.begin_path();
        context.move_to(at.x - ARM, at.y);
        context.line_to(at.x + ARM, at.y);
        context.move_to(at.x, at.y - ARM);
        context.line_to(at.x, at.y + ARM);
        stroke(context, palette.text, 1.5, palette);
    }
    Ok(())
}

/// A scale bar in the lower left corner; `metre` is the length of a unit of the sheet, m.
pub(super) fn scale_bar(context: &Context, viewport: &Viewport, metre: f64, palette: &Palette) -> Result<(), JsValue> {
    Bar::of(viewport.scale / metre).map_or(Ok(()), |bar| bar.draw(context, 22.0, viewport.size.y - 24.0, palette))
}
