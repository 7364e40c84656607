//! Draws the Floor plan tab. The room and the drawing are slow to draw, so they are cached in one picture of the size
//! of the canvas, which moves with the view.

use super::{marks, sweeping};
use floor_drawing::{Drawing, Role, ShadeMethod, Traced};
use robovac_app::{
    Palette, Viewport,
    floor_plan::{DrawingSession, DrawingSource, seen_on},
};
use robovac_core::{
    geometry::{Point, Vector},
    grid::{Grid, Occupancy},
    math::{cos, sin},
};
use robovac_playground::{
    canvas::layer::{OffscreenLayer, cell_picture},
    wire::clock,
};
use std::collections::{BTreeMap, btree_map::Entry};
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{OffscreenCanvas, OffscreenCanvasRenderingContext2d, Path2d};

/// Drawing time above which the picture isn't redrawn while the view moves, ms.
const QUICK_MS: f64 = 12.0;
/// Pixels between the lines of the grid, at least.
const GRID_FROM: f64 = 28.0;

/// Displayed parts of a session besides the room.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct ShownPlan {
    /// Stage of the sweep, 1 to 4; 0 for none.
    pub stage: u8,
    /// Displayed share of the stage, 0 to 1.
    pub share: f64,
    /// Heading of the obstacle map's slice.
    pub slice: Option<usize>,
}

/// State of the cached picture, without the view.
#[derive(Debug, Clone, PartialEq)]
struct PlanStill {
    room: u32,
    roles: Vec<Role>,
    slice: Option<usize>,
    dark: bool,
}

/// Draws onto one canvas.
#[derive(Debug)]
pub(super) struct FloorPlanPainter {
    canvas: OffscreenCanvas,
    context: OffscreenCanvasRenderingContext2d,
    /// Lines of the drawing, on the sheet.
    lines: Vec<LayerLines>,
    room: Option<((u32, bool), OffscreenLayer)>,
    /// The hatched floor that a robot can't get to, if there is some.
    cut: Option<OffscreenLayer>,
    /// The image that the room is traced from.
    image: Option<OffscreenLayer>,
    slice: Option<(OffscreenLayer, f64)>,
    picture: OffscreenLayer,
    drawn: Option<(PlanStill, Viewport)>,
    /// Drawing time of the picture, ms.
    took: f64,
}

impl FloorPlanPainter {
    /// Draws onto `canvas` from now on.
    pub fn new(canvas: OffscreenCanvas) -> Result<Self, JsValue> {
        let context = canvas.get_context("2d")?.ok_or("no off-screen canvas; use a current browser")?.unchecked_into();
        let picture = OffscreenLayer::new(1, 1)?;
        Ok(Self {
            canvas,
            context,
            lines: Vec::new(),
            room: None,
            cut: None,
            image: None,
            slice: None,
            picture,
            drawn: None,
            took: 0.0,
        })
    }

    /// Takes another file.
    pub fn take(&mut self, session: &DrawingSession) -> Result<(), JsValue> {
        (self.room, self.slice, self.drawn) = (None, None, None);
        self.lines.clear();
        self.image = match session.source() {
            DrawingSource::Image { shades, .. } => Some(cell_picture(shades, |&shade| [shade, shade, shade, 255])?),
            _ => None,
        };
        if let Some(drawing) = session.source().drawing() {
            let place = |point: &Point| session.sheet().place(*point);
            self.lines = lines(drawing, place, session.sheet().scale)?;
        }
        Ok(())
    }

    /// Takes a slice of the obstacle map: cells that are FREE, and their side in metres.
    pub fn take_slice(&mut self, free: &Grid<bool>, cell: f64) -> Result<(), JsValue> {
        // Okabe and Ito's bluish green and vermilion, which differ in lightness, too.
        let colour = |&is_free: &bool| if is_free { [0, 158, 115, 70] } else { [213, 94, 0, 150] };
        self.slice = Some((cell_picture(free, colour)?, cell));
        self.drawn = None;
        Ok(())
    }

    /// Draws; see [`super::FloorPlanSession::draw`].
    pub fn draw(
        &mut self,
        session: Option<&DrawingSession>,
        viewport: &Viewport,
        shown: ShownPlan,
        dark: bool,
        hurries: bool,
    ) -> Result<bool, JsValue> {
        let palette = Palette::of(dark);
        let size = viewport.size * viewport.pixel_ratio;
        let (width, height) = (size.x.round().max(1.0) as u32, size.y.round().max(1.0) as u32);
        if (self.canvas.width(), self.canvas.height()) != (width, height) {
            self.canvas.set_width(width);
            self.canvas.set_height(height);
            self.drawn = None;
        }
        let context = &self.context;
        context.set_transform(1.0, 0.0, 0.0, 1.0, 0.0, 0.0)?;
        context.set_fill_style_str(palette.outside);
        context.fill_rect(0.0, 0.0, f64::from(width), f64::from(height));
        let Some(session) = session else { return Ok(false) };

        let still =
            PlanStill { room: session.version(), roles: session.settings().roles.clone(), slice: shown.slice, dark };
        let is_same = self.drawn.as_ref().is_some_and(|(drawn, _)| *drawn == still);
        let is_moved = self.drawn.as_ref().is_some_and(|(_, view)| view != viewport);
        let makes_do = is_same && is_moved && hurries && self.took > QUICK_MS;
        if !makes_do && (!is_same || is_moved) {
            let began = clock();
            self.draw_picture(session, viewport, &still)?;
            self.took = clock() - began;
            self.drawn = Some((still, *viewport));
        }
        let from = self.drawn.as_ref().map_or(*viewport, |(_, view)| *view);
        self.copy(&from, viewport)?;

        let ratio = viewport.pixel_ratio;
        self.context.set_transform(ratio, 0.0, 0.0, ratio, 0.0, 0.0)?;
        if let Some(room) = session.room() {
            let view = room_view(session, room, viewport);
            marks::gaps(&self.context, &view, &room.gaps, dark)?;
            if let (Some(sweep), true) = (session.planned(), shown.stage > 0) {
                sweeping::draw(&self.context, &view, sweep, shown, dark)?;
            }
        }
        marks::part(&self.context, session, viewport, palette)?;
        marks::faults(&self.context, session, viewport, palette)?;
        marks::hand(&self.context, session, viewport, palette)?;
        if let Some(metre) = session.settings().metre {
            marks::scale_bar(&self.context, viewport, metre / session.sheet().scale, palette)?;
        }
        Ok(makes_do)
    }

    /// Shows the picture that was drawn for `from`, moved for `to`.
    fn copy(&self, from: &Viewport, to: &Viewport) -> Result<(), JsValue> {
        let factor = to.scale / from.scale;
        let shift = (to.origin - from.origin * factor) * to.pixel_ratio;
        self.context.set_transform(factor, 0.0, 0.0, factor, shift.x, shift.y)?;
        self.context.draw_image_with_offscreen_canvas(&self.picture.canvas, 0.0, 0.0)
    }

    /// Whether the room lies on the image that it is traced from. The pixels of a map are its cells.
    fn sees_through(&self, session: &DrawingSession) -> bool {
        self.image.is_some() && (session.settings().method != ShadeMethod::Map || session.settings().turn != 0.0)
    }

    /// The image, turned.
    fn draw_image(&self, session: &DrawingSession, viewport: &Viewport) -> Result<(), JsValue> {
        let (Some(image), DrawingSource::Image { turn, .. }) = (&self.image, session.source()) else { return Ok(()) };
        let sheet = session.sheet();
        let (sin, cos) = (sin(*turn), cos(*turn));
        let side = viewport.scale * sheet.scale * viewport.pixel_ratio;
        // Its upper left corner.
        let height = f64::from(image.canvas.height());
        let corner = viewport.to_screen(sheet.place(Point::new(-height * sin, height * cos))) * viewport.pixel_ratio;
        let context = &self.picture.context;
        context.set_transform(side * cos, -side * sin, side * sin, side * cos, corner.x, corner.y)?;
        context.set_image_smoothing_enabled(side < 2.0);
        context.draw_image_with_offscreen_canvas(&image.canvas, 0.0, 0.0)
    }

    /// The room, the grid and the drawing's lines.
    fn draw_picture(
        &mut self,
        session: &DrawingSession,
        viewport: &Viewport,
        still: &PlanStill,
    ) -> Result<(), JsValue> {
        let palette = Palette::of(still.dark);
        let key = (still.room, still.dark);
        if let Some(room) = session.room()
            && self.room.as_ref().is_none_or(|(made, _)| *made != key)
        {
            let is_seen_through = self.sees_through(session);
            self.room = Some((key, room_picture(room, palette, is_seen_through)?));
            self.cut = session.cut_off().map(|(cut, _)| hatched(cut)).transpose()?;
        }
        self.picture.clear(self.canvas.width(), self.canvas.height());
        let context = &self.picture.context;
        let ratio = viewport.pixel_ratio;
        if self.sees_through(session) {
            self.draw_image(session, viewport)?;
        }
        context.set_transform(ratio, 0.0, 0.0, ratio, 0.0, 0.0)?;
        if let Some(room) = session.room() {
            let view = room_view(session, room, viewport);
            if let Some((_, picture)) = &self.room {
                stretch(context, &view, picture, room.plan.resolution)?;
            }
            if let Some(cut) = &self.cut {
                stretch(context, &view, cut, room.plan.resolution)?;
            }
            if let Some(metre) = session.settings().metre {
                grid(context, viewport, metre / session.sheet().scale, palette);
            }
            marks::objects(context, &view, &room.plan.objects, palette)?;
            if let (Some((picture, cell)), true) = (&self.slice, still.slice.is_some()) {
                stretch(context, &view, picture, *cell)?;
            }
        }
        let Some(drawing) = session.source().drawing() else { return Ok(()) };
        let scale = viewport.scale * ratio;
        context.set_transform(scale, 0.0, 0.0, -scale, viewport.origin.x * ratio, viewport.origin.y * ratio)?;
        for lines in &self.lines {
            let (Some(layer), Some(role)) = (drawing.layers.get(lines.layer), still.roles.get(lines.layer)) else {
                continue;
            };
            let [red, green, blue] = seen_on(layer.colour, still.dark);
            let (width, alpha) = match role {
                Role::Wall => (1.75, 1.0),
                Role::Obstacle => (1.25, 0.95),
                Role::Ignored => (1.0, 0.3),
            };
            context.set_line_join(if lines.width > 0.0 { "miter" } else { "bevel" });
            context.set_line_width(lines.width.max(width / viewport.scale));
            context.set_global_alpha(alpha);
            context.set_stroke_style_str(&format!("rgb({red} {green} {blue})"));
            context.stroke_with_path(&lines.path);
        }
        context.set_global_alpha(1.0);
        Ok(())
    }
}

/// The window onto the room, in metres from its lower left corner.
fn room_view(session: &DrawingSession, room: &Traced, viewport: &Viewport) -> Viewport {
    let sheet = session.sheet();
    viewport.onto(sheet.place(Point::from(room.corner)), sheet.scale / room.metre)
}

/// The strokes of a layer that are equally wide as one path, so that they cost one call.
#[derive(Debug)]
struct LayerLines {
    layer: usize,
    /// On the sheet.
    width: f64,
    path: Path2d,
}

fn lines(drawing: &Drawing, place: impl Fn(&Point) -> Point, scale: f64) -> Result<Vec<LayerLines>, JsValue> {
    let mut paths: BTreeMap<(u32, u64), Path2d> = BTreeMap::new();
    for stroke in &drawing.strokes {
        let path = match paths.entry((stroke.layer, stroke.width.to_bits())) {
            Entry::Occupied(found) => found.into_mut(),
            Entry::Vacant(new) => new.insert(Path2d::new()?),
        };
        for (index, corner) in drawing.corners(stroke).iter().enumerate() {
            let at = place(corner);
            if index == 0 { path.move_to(at.x, at.y) } else { path.line_to(at.x, at.y) }
        }
        if stroke.is_closed {
            path.close_path();
        }
    }
    let lines = |((layer, width), path): ((u32, u64), Path2d)| {
        let width = f64::from_bits(width) * scale;
        LayerLines { layer: layer as usize, width, path }
    };
    Ok(paths.into_iter().map(lines).collect())
}

/// One pixel for each cell of the room.
fn room_picture(room: &Traced, palette: &Palette, is_seen_through: bool) -> Result<OffscreenLayer, JsValue> {
    let [mut free, mut occupied, mut unknown] = [palette.floor, palette.wall_line, palette.unknown].map(opaque);
    if is_seen_through {
        // Okabe and Ito's blue and vermilion, which differ in lightness, too.
        (free, occupied, unknown) = ([86, 180, 233, 60], [213, 94, 0, 130], [213, 94, 0, 60]);
    }
    cell_picture(&room.plan.occupancy, |cell| match cell {
        Occupancy::Free => free,
        Occupancy::Occupied => occupied,
        Occupancy::Unknown => unknown,
    })
}

/// Okabe and Ito's reddish purple in stripes, as in www/floor-plan/floor-plan.css.
fn hatched(cut: &Grid<bool>) -> Result<OffscreenLayer, JsValue> {
    // About 50 stripes across, of two cells at least.
    let stripe = (cut.width().max(cut.height()) / 100).max(2) as i32;
    let mut stripes = cut.clone();
    for index in 0..cut.len() {
        let cell = cut.cell(index);
        stripes[cell] &= (cell.x + cell.y).rem_euclid(2 * stripe) < stripe;
    }
    cell_picture(&stripes, |&is_stripe| if is_stripe { [204, 121, 167, 215] } else { [0; 4] })
}

/// Draws a picture of cells, each `cell` metres wide; one unit of the context is a CSS pixel.
fn stretch(
    context: &OffscreenCanvasRenderingContext2d,
    view: &Viewport,
    picture: &OffscreenLayer,
    cell: f64,
) -> Result<(), JsValue> {
    let size = Vector::new(f64::from(picture.canvas.width()), f64::from(picture.canvas.height())) * cell;
    let top_left = view.to_screen(Point::new(0.0, size.y));
    // Crisp cells once they are larger than pixels.
    context.set_image_smoothing_enabled(cell * view.scale < 2.0);
    context.draw_image_with_offscreen_canvas_and_dw_and_dh(
        &picture.canvas,
        top_left.x,
        top_left.y,
        size.x * view.scale,
        size.y * view.scale,
    )
}

/// Grid lines of a round distance over the visible area; `metre` is the length of a unit of the sheet, m.
fn grid(context: &OffscreenCanvasRenderingContext2d, viewport: &Viewport, metre: f64, palette: &Palette) {
    let per_metre = viewport.scale / metre;
    let Some(step) = [0.1, 0.5, 1.0, 5.0, 10.0, 50.0, 100.0].into_iter().find(|m| m * per_metre >= GRID_FROM) else {
        return;
    };
    let step = step * per_metre;
    context.begin_path();
    let mut x = viewport.origin.x.rem_euclid(step);
    while x < viewport.size.x {
        context.move_to(x.round() + 0.5, 0.0);
        context.line_to(x.round() + 0.5, viewport.size.y);
        x += step;
    }
    let mut y = viewport.origin.y.rem_euclid(step);
    while y < viewport.size.y {
        context.move_to(0.0, y.round() + 0.5);
        context.line_to(viewport.size.x, y.round() + 0.5);
        y += step;
    }
    context.set_line_width(1.0);
    context.set_stroke_style_str(palette.grid);
    context.stroke();
}

/// A colour of the palette in its notation `#rrggbb`.
fn opaque(css: &str) -> [u8; 4] {
    let byte = |from: usize| css.get(from..from + 2).and_then(|hex| u8::from_str_radix(hex, 16).ok()).unwrap_or(0);
    [byte(1), byte(3), byte(5), 255]
}
