//! Draws scenes.
//!
//! Rarely changing parts are cached: the floor and the objects below the swept cells in one picture of the size of the
//! canvas, the walls and the planned line in another above them, the swept cells in a third with one pixel per cell. A
//! frame then costs three copies, the trail and the robot, whatever the size of the room.

pub mod film;
pub mod layer;
pub mod objects;
pub mod robot;
pub mod search;
pub mod sensed;

use layer::{OffscreenLayer, VisitsPicture, cell_picture};
use objects::{CanvasPen, DrawPass};
use robovac_app::{Palette, RobotView, Scene, Viewport};
use robovac_core::{
    floor_plan::Object,
    geometry::{Point, Pose, Vector},
    grid::{Cell, Grid, Occupancy, outlines},
};
use robovac_sim::experiment::Shows;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement, OffscreenCanvasRenderingContext2d, Path2d};

/// Corners above which shapes are drawn as pictures of cells.
const MOST_CORNERS: usize = 40_000;
/// Corners in view above which the planned line isn't drawn: it would only be a grey veil.
const MOST_PLANNED: usize = 60_000;
/// Pixels per cell from which on the grid is drawn.
const GRID_FROM: f64 = 16.0;
/// Width of the canvas below which there is no room for a scale bar between legend and zoom, CSS pixels.
const LEAST_FOR_SCALE_BAR: f64 = 626.0;
/// Pieces of different strength in the trail.
const TRAIL_PIECES: usize = 16;

/// Draws onto one canvas of the page.
#[derive(Debug)]
pub struct Canvas {
    element: HtmlCanvasElement,
    context: CanvasRenderingContext2d,
    below: OffscreenLayer,
    above: OffscreenLayer,
    shapes: Option<Shapes>,
    visits: Option<VisitsPicture>,
    last: Option<DrawnScene>,
}

/// State of the drawn scene; if the next scene has the same, nothing is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
struct DrawnScene {
    still: SceneStill,
    run_version: u64,
    robot: Option<RobotView>,
    trail: (usize, Option<Point>, Option<Point>),
    cursor: Option<Cell>,
    /// Index in the walk of the shown decision.
    search: Option<usize>,
    selected: Option<usize>,
    in_hand: bool,
    shows: Shows,
    /// Steps at the shown sensor reading and positions of movers.
    steps: Option<u64>,
    believed: (usize, Option<Point>, Option<Point>),
}

/// The part of the state that the layers depend on.
#[derive(Debug, Clone, Copy, PartialEq)]
struct SceneStill {
    plan_version: u64,
    planned_version: u64,
    viewport: Viewport,
    start: Option<Pose>,
    lifted: Option<usize>,
    dark: bool,
}

/// Cells in a form that can be filled.
#[derive(Debug)]
enum FillShape {
    Path(Path2d),
    Picture(OffscreenLayer),
}

/// Shapes made from one version of the plan.
#[derive(Debug)]
struct Shapes {
    version: (u64, bool),
    walls: FillShape,
    unknown: FillShape,
    unreachable: Option<FillShape>,
}

impl Canvas {
    /// A canvas that draws onto `element`.
    pub fn new(element: HtmlCanvasElement) -> Result<Self, JsValue> {
        let context = element.get_context("2d")?.ok_or("no 2D canvas; use a current browser")?.unchecked_into();
        let (below, above) = (OffscreenLayer::new(1, 1)?, OffscreenLayer::new(1, 1)?);
        Ok(Self { element, context, below, above, shapes: None, visits: None, last: None })
    }

    /// Draws `scene` through `viewport`, unless it is shown already.
    pub fn draw(&mut self, scene: &Scene<'_>, viewport: &Viewport) -> Result<(), JsValue> {
        let palette = Palette::of(scene.dark);
        let still = SceneStill {
            plan_version: scene.plan_version,
            planned_version: scene.planned_version,
            viewport: *viewport,
            start: scene.start,
            lifted: scene.lifted,
            dark: scene.dark,
        };
        let drawn = DrawnScene {
            still,
            run_version: scene.run_version,
            robot: scene.robot,
            trail: (scene.trail.len(), scene.trail.first().copied(), scene.trail.last().copied()),
            cursor: scene.cursor,
            search: scene.search.map(|search| search.step.step),
            selected: scene.selected,
            in_hand: !scene.in_hand.is_empty(),
            shows: scene.shows,
            steps: (scene.sensed.is_some() || scene.life.is_some_and(|life| !life.movers().is_empty()))
                .then_some(scene.steps),
            believed: (scene.believed.len(), scene.believed.first().copied(), scene.believed.last().copied()),
        };
        if self.last == Some(drawn) && !drawn.in_hand && scene.dirty_rows.is_none() {
            return Ok(());
        }
        let last = self.last.take();
        let is_new_run = last.is_none_or(|l| {
            (l.run_version, l.still.plan_version, l.still.dark) != (drawn.run_version, still.plan_version, still.dark)
        });
        self.update_visits(scene, palette, is_new_run)?;
        if last.is_none_or(|l| l.still != still) {
            self.update_layers(scene, viewport, palette)?;
        }
        self.compose(scene, viewport, palette)?;
        self.last = Some(drawn);
        Ok(())
    }

    fn update_visits(&mut self, scene: &Scene<'_>, palette: &Palette, is_new_run: bool) -> Result<(), JsValue> {
        match (scene.tracker, &mut self.visits) {
            (None, visits) => *visits = None,
            (Some(tracker), visits) if is_new_run || visits.is_none() => {
                *visits = Some(VisitsPicture::new(tracker, palette)?);
            }
            (Some(tracker), Some(visits)) => {
                if let Some(rows) = scene.dirty_rows {
                    visits.update(tracker, rows)?;
                }
            }
            (Some(_), None) => {}
        }
        Ok(())
    }

    /// Draws the layers below and above the swept cells.
    fn update_layers(&mut self, scene: &Scene<'_>, viewport: &Viewport, palette: &Palette) -> Result<(), JsValue> {
        let version = (scene.plan_version, scene.dark);
        if self.shapes.as_ref().is_none_or(|s| s.version != version) {
            self.shapes = Some(Shapes::new(scene, palette)?);
        }
        let (width, height) = device_size(viewport);
        if (self.element.width(), self.element.height()) != (width, height) {
            self.element.set_width(width);
            self.element.set_height(height);
        }
        let Some(shapes) = &self.shapes else { return Ok(()) };
        let (room, fine) = (scene.plan, scene.floor);

        self.below.clear(width, height);
        let below = &self.below.context;
        below.set_fill_style_str(palette.outside);
        below.fill_rect(0.0, 0.0, f64::from(width), f64::from(height));
        to_world(below, viewport, 1.0)?;
        below.set_fill_style_str(palette.floor);
        below.fill_rect(0.0, 0.0, room.width_m(), room.height_m());
        if let (Some(unreachable), Some(floor)) = (&shapes.unreachable, fine) {
            unreachable.fill(below, viewport, floor.resolution, floor.floor.height(), palette.unreachable)?;
            if let FillShape::Path(path) = unreachable {
                hatch(below, path, viewport, floor.resolution, palette)?;
            }
        }
        to_css(below, viewport)?;
        draw_objects(below, scene, viewport, palette, DrawPass::Ground)?;

        self.above.clear(width, height);
        let above = &self.above.context;
        if viewport.scale * room.resolution >= GRID_FROM {
            to_world(above, viewport, 1.0)?;
            grid_lines(above, viewport, scene, palette);
        }
        to_css(above, viewport)?;
        draw_objects(above, scene, viewport, palette, DrawPass::Texture)?;
        if let Some(film) = &scene.film {
            film::draw(above, film, viewport, palette);
        } else if scene.preview.is_empty() {
            line(above, viewport, scene.planned, palette.planned, 1.25);
        } else {
            line(above, viewport, scene.preview, palette.preview, 1.75);
        }
        draw_objects(above, scene, viewport, palette, DrawPass::Body)?;
        let rows = room.occupancy.height();
        shapes.unknown.fill(above, viewport, room.resolution, rows, palette.unknown)?;
        shapes.walls.fill(above, viewport, room.resolution, rows, palette.wall)?;
        shapes.walls.edge(above, viewport, room.resolution, palette.wall_line)?;
        // The outside counts as wall.
        to_css(above, viewport)?;
        let (left_top, scale) = (viewport.to_screen(Point::new(0.0, room.height_m())), viewport.scale);
        above.set_stroke_style_str(palette.wall_line);
        above.set_line_width(1.25);
        above.stroke_rect(left_top.x, left_top.y, scale * room.width_m(), scale * room.height_m());
        draw_objects(above, scene, viewport, palette, DrawPass::Small)
    }

    /// Combines the layers and draws the moving parts.
    fn compose(&self, scene: &Scene<'_>, viewport: &Viewport, palette: &Palette) -> Result<(), JsValue> {
        let context = &self.context;
        context.set_transform(1.0, 0.0, 0.0, 1.0, 0.0, 0.0)?;
        context.draw_image_with_offscreen_canvas(&self.below.canvas, 0.0, 0.0)?;
        let ratio = viewport.pixel_ratio;
        context.set_transform(ratio, 0.0, 0.0, ratio, 0.0, 0.0)?;
        if let Some(visits) = self.visits.as_ref().filter(|_| scene.shows.coverage) {
            let top_left = viewport.to_screen(Point::new(0.0, scene.plan.height_m()));
            let (width, height) = (scene.plan.width_m() * viewport.scale, scene.plan.height_m() * viewport.scale);
            context.draw_image_with_offscreen_canvas_and_dw_and_dh(
                &visits.layer.canvas,
                top_left.x,
                top_left.y,
                width,
                height,
            )?;
        }
        context.set_transform(1.0, 0.0, 0.0, 1.0, 0.0, 0.0)?;
        context.draw_image_with_offscreen_canvas(&self.above.canvas, 0.0, 0.0)?;
        context.set_transform(ratio, 0.0, 0.0, ratio, 0.0, 0.0)?;
        draw_objects(as_layer(context), scene, viewport, palette, DrawPass::Live)?;
        draw_life(context, scene, viewport, palette)?;

        if let Some(search) = &scene.search {
            search::draw_sides(context, palette, search, scene.plan, viewport);
        }
        if let Some(start) = &scene.start {
            let centre = viewport.to_screen(start.position());
            robot::draw_start(context, palette, start, centre, (scene.start_body, scene.start_radius, viewport.scale))?;
        }
        trail(context, viewport, scene.believed, palette.estimate);
        trail(context, viewport, scene.trail, palette.accent);
        if let (Some(view), Some(sensed)) = (&scene.robot, &scene.sensed) {
            sensed::draw(context, palette, view, sensed, viewport)?;
        }
        if let Some(view) = &scene.robot {
            if let Some(estimate) = &view.estimate {
                let centre = viewport.to_screen(estimate.position());
                robot::draw_estimate(context, palette, estimate, centre, (view.body, view.radius, viewport.scale))?;
            }
            robot::draw(context, palette, view, viewport.to_screen(view.pose.position()), viewport.scale)?;
            if let Some(sensed) = &scene.sensed {
                sensed::draw_cliffs(context, palette, view, sensed, viewport)?;
            }
        }
        if let Some(search) = &scene.search {
            search::draw_marks(context, palette, search, scene.robot.map_or(0.0, |robot| robot.radius), viewport)?;
        }
        draw_hand(context, scene, viewport, palette)?;
        if let Some(cell) = scene.cursor {
            let size = scene.plan.resolution * viewport.scale;
            let corner = viewport.to_screen(scene.plan.centre(cell));
            let side = size.max(6.0);
            context.set_line_width(4.0);
            context.set_stroke_style_str(palette.halo);
            context.stroke_rect(corner.x - 0.5 * side, corner.y - 0.5 * side, side, side);
            context.set_line_width(2.0);
            context.set_stroke_style_str(palette.accent);
            context.stroke_rect(corner.x - 0.5 * side, corner.y - 0.5 * side, side, side);
        }
        scale_bar(context, viewport, palette)
    }
}

impl Shapes {
    fn new(scene: &Scene<'_>, palette: &Palette) -> Result<Self, JsValue> {
        let occupancy = &scene.plan.occupancy;
        let unreachable = scene.floor.map(|floor| {
            let mut left_out = floor.floor.map(|&reached| !reached);
            for (index, value) in left_out.values_mut().iter_mut().enumerate() {
                let fine = floor.floor.cell(index);
                *value &= occupancy.get(scene.plan.cell_at(floor.centre(fine))).is_some_and(|o| o.is_free());
            }
            FillShape::new(&left_out, palette.unreachable)
        });
        Ok(Self {
            version: (scene.plan_version, scene.dark),
            // Single cells have no edge, so a picture has the edge's colour.
            walls: FillShape::new(&occupancy.map(|&o| o == Occupancy::Occupied), palette.wall_line)?,
            unknown: FillShape::new(&occupancy.map(|&o| o == Occupancy::Unknown), palette.unknown)?,
            unreachable: unreachable.transpose()?,
        })
    }
}

impl FillShape {
    /// The set cells, as a path in units of cells if that isn't too long.
    fn new(cells: &Grid<bool>, colour: &str) -> Result<Self, JsValue> {
        let Some(loops) = outlines(cells, MOST_CORNERS) else {
            let colour = parse_colour(colour);
            return Ok(Self::Picture(cell_picture(cells, |&is_set| if is_set { colour } else { [0; 4] })?));
        };
        let path = Path2d::new()?;
        for corners in &loops {
            for (i, corner) in corners.iter().enumerate() {
                let (x, y) = (f64::from(corner.x), f64::from(corner.y));
                if i == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
            }
            path.close_path();
        }
        Ok(Self::Path(path))
    }

    /// Draws the edges of the cells, if they are known as a path.
    fn edge(
        &self,
        context: &OffscreenCanvasRenderingContext2d,
        viewport: &Viewport,
        resolution: f64,
        colour: &str,
    ) -> Result<(), JsValue> {
        if let Self::Path(path) = self {
            to_world(context, viewport, resolution)?;
            context.set_line_width(1.25 / (viewport.scale * resolution));
            context.set_line_join("miter");
            context.set_stroke_style_str(colour);
            context.stroke_with_path(path);
        }
        Ok(())
    }

    /// Fills the cells, each `resolution` metres wide, of a grid with `rows` rows.
    fn fill(
        &self,
        context: &OffscreenCanvasRenderingContext2d,
        viewport: &Viewport,
        resolution: f64,
        rows: usize,
        colour: &str,
    ) -> Result<(), JsValue> {
        match self {
            Self::Path(path) => {
                to_world(context, viewport, resolution)?;
                context.set_fill_style_str(colour);
                context.fill_with_path_2d(path);
            }
            Self::Picture(layer) => {
                to_css(context, viewport)?;
                let top_left = viewport.to_screen(Point::new(0.0, rows as f64 * resolution));
                let size = resolution * viewport.scale;
                let (width, height) = (f64::from(layer.canvas.width()) * size, f64::from(layer.canvas.height()) * size);
                // Crisp cells once they are larger than pixels.
                context.set_image_smoothing_enabled(size < 2.0);
                context.draw_image_with_offscreen_canvas_and_dw_and_dh(
                    &layer.canvas,
                    top_left.x,
                    top_left.y,
                    width,
                    height,
                )?;
            }
        }
        Ok(())
    }
}

/// Draws one part of all objects that aren't being dragged.
fn draw_objects(
    context: &OffscreenCanvasRenderingContext2d,
    scene: &Scene<'_>,
    viewport: &Viewport,
    palette: &Palette,
    part: DrawPass,
) -> Result<(), JsValue> {
    let pen = CanvasPen { context, palette, viewport, has_life: scene.life.is_some() };
    let mut placed = scene.plan.objects.iter().enumerate().filter(|&(index, _)| scene.lifted != Some(index));
    placed.try_for_each(|(_, object)| pen.draw(object, part))
}

/// Draws moving and consumable objects: remaining dirt, people and pets.
fn draw_life(
    context: &CanvasRenderingContext2d,
    scene: &Scene<'_>,
    viewport: &Viewport,
    palette: &Palette,
) -> Result<(), JsValue> {
    let Some(life) = scene.life else { return Ok(()) };
    let pen = CanvasPen { context: as_layer(context), palette, viewport, has_life: true };
    if scene.shows.dirt {
        life.spots().iter().for_each(|spot| pen.spot(spot));
    }
    let movers = scene.plan.objects.iter().filter_map(|object| match object {
        Object::Mover { who, path } => Some((*who, path)),
        _ => None,
    });
    for ((who, path), &(at, _)) in movers.zip(life.movers()) {
        pen.figure(who, at, way_at(path, at))?;
    }
    if let (Some(sensed), Some(robot)) = (&scene.sensed, &scene.robot) {
        let seen = sensed.reading.infrared;
        if robot.suite.infrared && (seen.omni, seen.left, seen.right) != (0, 0, 0) {
            for object in &scene.plan.objects {
                if let Object::Dock { pose } = object {
                    pen.dock_beams(pose)?;
                }
            }
        }
    }
    Ok(())
}

/// The way along the side of `path` that is nearest to `at`.
fn way_at(path: &[Point], at: Point) -> Vector {
    let beside = |pair: &&[Point]| {
        let (along, to) = (pair[1] - pair[0], at - pair[0]);
        let share = (to.dot(&along) / along.norm_squared().max(1e-9)).clamp(0.0, 1.0);
        (to - along * share).norm()
    };
    let nearest = path.windows(2).min_by(|a, b| beside(a).total_cmp(&beside(b)));
    nearest.map_or(Vector::new(1.0, 0.0), |pair| pair[1] - pair[0])
}

/// Draws dragged objects and the selection.
fn draw_hand(
    context: &CanvasRenderingContext2d,
    scene: &Scene<'_>,
    viewport: &Viewport,
    palette: &Palette,
) -> Result<(), JsValue> {
    let pen = CanvasPen { context: as_layer(context), palette, viewport, has_life: false };
    let selected = scene.selected.filter(|&index| scene.lifted != Some(index));
    for object in scene.in_hand.iter().chain(selected.and_then(|index| scene.plan.objects.get(index))) {
        if scene.lifted.is_some() || !scene.in_hand.is_empty() {
            DrawPass::ALL.into_iter().try_for_each(|part| pen.draw(object, part))?;
        }
        pen.select(object)?;
    }
    Ok(())
}

/// Contexts of both kinds have the same methods.
fn as_layer(context: &CanvasRenderingContext2d) -> &OffscreenCanvasRenderingContext2d {
    context.unchecked_ref()
}

/// Size of the canvas in device pixels.
fn device_size(viewport: &Viewport) -> (u32, u32) {
    let size = viewport.size * viewport.pixel_ratio;
    (size.x.round().max(1.0) as u32, size.y.round().max(1.0) as u32)
}

/// One unit is `unit` metres from now on, y up.
fn to_world(context: &OffscreenCanvasRenderingContext2d, viewport: &Viewport, unit: f64) -> Result<(), JsValue> {
    let ratio = viewport.pixel_ratio;
    let scale = viewport.scale * ratio * unit;
    context.set_transform(scale, 0.0, 0.0, -scale, viewport.origin.x * ratio, viewport.origin.y * ratio)
}

/// One unit is a CSS pixel from now on, y down.
fn to_css(context: &OffscreenCanvasRenderingContext2d, viewport: &Viewport) -> Result<(), JsValue> {
    let ratio = viewport.pixel_ratio;
    context.set_transform(ratio, 0.0, 0.0, ratio, 0.0, 0.0)
}

/// Slanted lines over the cells of `path`, always as far apart on the screen.
fn hatch(
    context: &OffscreenCanvasRenderingContext2d,
    path: &Path2d,
    viewport: &Viewport,
    resolution: f64,
    palette: &Palette,
) -> Result<(), JsValue> {
    context.save();
    to_world(context, viewport, resolution)?;
    context.clip_with_path_2d(path);
    to_css(context, viewport)?;
    let (width, height) = (viewport.size.x, viewport.size.y);
    // Fixed to the floor, so that the pattern moves with it.
    let spacing = 7.0;
    let shift = (viewport.origin.x + viewport.origin.y).rem_euclid(spacing);
    context.begin_path();
    let mut at = shift;
    while at < width + height {
        context.move_to(at, 0.0);
        context.line_to(at - height, height);
        at += spacing;
    }
    context.set_line_width(1.0);
    context.set_stroke_style_str(palette.hatch);
    context.stroke();
    context.restore();
    Ok(())
}

/// Lines between the map's cells, where they are in view; one unit is a metre.
fn grid_lines(context: &OffscreenCanvasRenderingContext2d, viewport: &Viewport, scene: &Scene<'_>, palette: &Palette) {
    let (low, high) = viewport.bounds();
    let (cell, width, height) = (scene.plan.resolution, scene.plan.width_m(), scene.plan.height_m());
    let range =
        |from: f64, to: f64, most: f64| (from.max(0.0) / cell).floor() as i32..=(to.min(most) / cell).ceil() as i32;
    context.begin_path();
    for x in range(low.x, high.x, width) {
        context.move_to(f64::from(x) * cell, low.y.max(0.0));
        context.line_to(f64::from(x) * cell, high.y.min(height));
    }
    for y in range(low.y, high.y, height) {
        context.move_to(low.x.max(0.0), f64::from(y) * cell);
        context.line_to(high.x.min(width), f64::from(y) * cell);
    }
    context.set_line_width(1.0 / viewport.scale);
    context.set_stroke_style_str(palette.grid);
    context.stroke();
}

/// The pieces of a line that are in view; one unit is a CSS pixel.
pub fn line(
    context: &OffscreenCanvasRenderingContext2d,
    viewport: &Viewport,
    points: &[Point],
    colour: &str,
    width: f64,
) {
    let (low, high) = viewport.bounds();
    let is_seen = |a: &Point, b: &Point| {
        a.x.max(b.x) >= low.x && a.x.min(b.x) <= high.x && a.y.max(b.y) >= low.y && a.y.min(b.y) <= high.y
    };
    if points.windows(2).filter(|w| is_seen(&w[0], &w[1])).count() > MOST_PLANNED {
        return;
    }
    context.begin_path();
    let mut is_drawing = false;
    for pair in points.windows(2) {
        if !is_seen(&pair[0], &pair[1]) {
            is_drawing = false;
            continue;
        }
        let (from, to) = (viewport.to_screen(pair[0]), viewport.to_screen(pair[1]));
        if !is_drawing {
            context.move_to(from.x, from.y);
        }
        context.line_to(to.x, to.y);
        is_drawing = true;
    }
    context.set_line_join("round");
    context.set_line_cap("round");
    context.set_line_width(width);
    context.set_stroke_style_str(colour);
    context.stroke();
}

/// The robot's recent trail, fading out.
fn trail(context: &CanvasRenderingContext2d, viewport: &Viewport, points: &[Point], colour: &str) {
    if points.len() < 2 {
        return;
    }
    context.set_line_width((0.035 * viewport.scale).clamp(2.0, 5.0));
    context.set_line_join("round");
    context.set_line_cap("butt");
    context.set_stroke_style_str(colour);
    let piece = points.len().div_ceil(TRAIL_PIECES).max(1);
    let pieces = points.len().div_ceil(piece);
    for i in 0..pieces {
        let part = &points[i * piece..(i * piece + piece + 1).min(points.len())];
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

/// A scale bar of a round length.
fn scale_bar(context: &CanvasRenderingContext2d, viewport: &Viewport, palette: &Palette) -> Result<(), JsValue> {
    if viewport.size.x < LEAST_FOR_SCALE_BAR {
        return Ok(());
    }
    let lengths = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0];
    let metres = lengths.into_iter().find(|m| m * viewport.scale >= 48.0).unwrap_or(100.0);
    let (length, right, bottom) = (metres * viewport.scale, viewport.size.x - 194.0, viewport.size.y - 24.0);
    // With a background, in case the room lies behind it.
    context.set_fill_style_str(palette.outside);
    context.set_global_alpha(0.8);
    context.fill_rect(right - length - 6.0, bottom - 20.0, length + 12.0, 26.0);
    context.set_global_alpha(1.0);
    context.set_stroke_style_str(palette.text);
    context.set_line_width(1.5);
    context.begin_path();
    context.move_to(right - length, bottom - 5.0);
    context.line_to(right - length, bottom);
    context.line_to(right, bottom);
    context.line_to(right, bottom - 5.0);
    context.stroke();
    context.set_fill_style_str(palette.text);
    context.set_font("12px -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif");
    context.set_text_align("center");
    context.set_text_baseline("alphabetic");
    let label = if metres < 1.0 { format!("{} cm", metres * 100.0) } else { format!("{metres} m") };
    context.fill_text(&label, right - 0.5 * length, bottom - 6.0)
}

/// Red, green, blue and opacity of the palette's own notations: `#rrggbb` and `rgb(r g b / opacity)`.
fn parse_colour(css: &str) -> [u8; 4] {
    if let Some(hex) = css.strip_prefix('#') {
        let byte = |i: usize| hex.get(i..i + 2).and_then(|h| u8::from_str_radix(h, 16).ok()).unwrap_or(0);
        return [byte(0), byte(2), byte(4), 255];
    }
    let numbers: Vec<f64> =
        css.split(|c: char| !c.is_ascii_digit() && c != '.').filter_map(|n| n.parse().ok()).collect();
    let part = |i: usize| numbers.get(i).copied().unwrap_or(1.0);
    [part(0) as u8, part(1) as u8, part(2) as u8, (255.0 * part(3)) as u8]
}
