//! Draws the stages of a sweep as 001 shows them: subgoals (Fig. 3), links with their collisions (Fig. 4), detours (Figs 5
//! and 6), and the last stage, ours. One unit of the context is a CSS pixel.

use super::{marks::dash, paint::ShownPlan};
use coverage_planners::{
    stage::LineEndContact,
    sweep::{Subgoal, SubgoalLink, Sweep},
};
use robovac_app::Viewport;
use robovac_core::geometry::Point;
use wasm_bindgen::JsValue;
use web_sys::OffscreenCanvasRenderingContext2d as Context;

/// Colours of the left and the right side, of links, collisions and detours: those of Okabe and Ito, lightened on dark
/// ground and darkened on light. Shape and dashes distinguish them, too.
struct Colours {
    left: &'static str,
    right: &'static str,
    link: &'static str,
    collision: &'static str,
    detour: &'static str,
    finish: &'static str,
}

const LIGHT: Colours = Colours {
    left: "#0072b2",
    right: "#b35c00",
    link: "#4a5568",
    collision: "#d0342c",
    detour: "#00795a",
    finish: "#9a3f78",
};
const DARK: Colours = Colours {
    left: "#56b4e9",
    right: "#f0a93b",
    link: "#b6bfcc",
    collision: "#ff7a6e",
    detour: "#2fd6a4",
    finish: "#e39bc5",
};

/// Draws the displayed part of the sweep; `view` is onto the room.
pub(super) fn draw(
    context: &Context,
    view: &Viewport,
    sweep: &Sweep,
    shown: ShownPlan,
    dark: bool,
) -> Result<(), JsValue> {
    let colours = if dark { &DARK } else { &LIGHT };
    let first = |all: usize, stage: u8| match shown.stage {
        now if now > stage => all,
        now if now == stage => (all as f64 * shown.share).ceil() as usize,
        _ => 0,
    };
    let links = &sweep.links[..first(sweep.links.len(), 2).min(sweep.links.len())];
    let collided: Vec<&SubgoalLink> = links.iter().filter(|link| link.collides).collect();
    let resolved = first(collided.len(), 3).min(collided.len());
    context.set_line_join("round");
    context.set_line_cap("round");

    let straight = |link: &SubgoalLink| [link.from, link.to].map(|index| sweep.subgoals.get(index).map(|s| s.at));
    context.begin_path();
    for link in links.iter().filter(|link| !link.collides) {
        polyline(context, view, &link.way);
    }
    stroke(context, colours.link, 1.5);
    context.begin_path();
    for link in collided.iter().skip(resolved).chain(collided[..resolved].iter().filter(|link| link.way.is_empty())) {
        if let [Some(from), Some(to)] = straight(link) {
            polyline(context, view, &[from, to]);
        }
    }
    dash(context, &[6.0, 5.0])?;
    stroke(context, colours.collision, 2.25);
    dash(context, &[])?;
    context.begin_path();
    for link in &collided[..resolved] {
        polyline(context, view, &link.way);
    }
    stroke(context, colours.detour, 2.5);
    context.begin_path();
    for way in &sweep.finish[..first(sweep.finish.len(), 4).min(sweep.finish.len())] {
        polyline(context, view, way);
    }
    dash(context, &[2.0, 4.0])?;
    stroke(context, colours.finish, 2.5);
    dash(context, &[])?;

    let subgoals = &sweep.subgoals[..first(sweep.subgoals.len(), 1).min(sweep.subgoals.len())];
    let size = (0.28 * sweep.scan_width * view.scale).clamp(2.5, 7.0);
    for (contact, side, colour, is_filled) in [
        (LineEndContact::LeftWall, -1.0, colours.left, false),
        (LineEndContact::RightWall, 1.0, colours.right, false),
        (LineEndContact::LeftObstacle, -1.0, colours.left, true),
        (LineEndContact::RightObstacle, 1.0, colours.right, true),
    ] {
        triangles(context, view, subgoals.iter().filter(|subgoal| subgoal.contact == contact), side * size);
        context.set_fill_style_str(if is_filled {
            colour
        } else if dark {
            "#14171b"
        } else {
            "#ffffff"
        });
        context.fill();
        stroke(context, colour, 1.5);
    }
    Ok(())
}

/// Triangles that point to the side that touches something; `size` is negative for the left.
fn triangles<'a>(context: &Context, view: &Viewport, subgoals: impl Iterator<Item = &'a Subgoal<Point>>, size: f64) {
    context.begin_path();
    for subgoal in subgoals {
        let at = view.to_screen(subgoal.at);
        context.move_to(at.x + size, at.y);
        context.line_to(at.x - 0.6 * size, at.y - size.abs());
        context.line_to(at.x - 0.6 * size, at.y + size.abs());
        context.close_path();
    }
}

fn polyline(context: &Context, view: &Viewport, points: &[Point]) {
    for (index, &point) in points.iter().enumerate() {
        let at = view.to_screen(point);
        if index == 0 { context.move_to(at.x, at.y) } else { context.line_to(at.x, at.y) }
    }
}

fn stroke(context: &Context, colour: &str, width: f64) {
    context.set_line_width(width);
    context.set_stroke_style_str(colour);
    context.stroke();
}
