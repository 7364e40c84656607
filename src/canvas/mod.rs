//! Draws scenes.
//!
//! Rarely changing parts are cached: the floor and the objects below the swept cells in one picture of the size of the
//! canvas, the walls and the planned line in another above them, the swept cells in a third with one pixel per cell. A
//! frame then costs three copies, the trail and the robot, whatever the size of the room; and where only these change, of
//! no more than the part of the picture that they are in.

mod area;
pub mod film;
pub mod layer;
pub mod lines;
pub mod objects;
pub mod robot;
pub mod scale_bar;
pub mod search;
pub mod sensed;
mod shapes;

use area::CanvasArea;
use layer::{OffscreenLayer, VisitsPicture};
use lines::{grid_lines, line, to_css, to_world, trail};
use objects::{CanvasPen, DrawPass};
use robovac_app::{Palette, RobotView, Scene, Viewport};
use robovac_core::{
    floor_plan::Object,
    geometry::{Point, Pose, Vector},
    grid::Cell,
};
use robovac_sim::experiment::Shows;
use shapes::{FillShape, Shapes};
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement, OffscreenCanvasRenderingContext2d};

/// Pixels per cell from which on the grid is drawn.
const GRID_FROM: f64 = 16.0;

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
    /// Whether a sensor reading is shown.
    senses: bool,
    /// Steps at that and at the positions of movers.
    steps: Option<u64>,
    estimated_trail: (usize, Option<Point>, Option<Point>),
    /// Where robot, estimate and trails are.
    moving: CanvasArea,
    /// Where people and pets are.
    figures: CanvasArea,
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
            senses: scene.sensed.is_some(),
            steps: (scene.sensed.is_some() || scene.life.is_some_and(|life| !life.movers().is_empty()))
                .then_some(scene.steps),
            estimated_trail: (
                scene.estimated_trail.len(),
                scene.estimated_trail.first().copied(),
                scene.estimated_trail.last().copied(),
            ),
            moving: CanvasArea::of_moving(scene, viewport),
            figures: CanvasArea::of_figures(scene, viewport),
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
        let parts = last.filter(|last| only_moves(last, &drawn)).and_then(|last| {
            let (mut area, mut figures) = (last.moving, last.figures);
            area.join(&drawn.moving);
            figures.join(&drawn.figures);
            if let (Some(tracker), Some(rows)) = (scene.tracker, scene.dirty_rows) {
                area.join(&CanvasArea::of_rows(scene, tracker, rows, viewport));
            }
            Some([area.to_device(viewport)?, figures.to_device(viewport)?])
        });
        let context = &self.context;
        context.save();
        if let Some(parts) = parts {
            context.set_transform(1.0, 0.0, 0.0, 1.0, 0.0, 0.0)?;
            context.begin_path();
            for [left, top, width, height] in parts {
                context.rect(left, top, width, height);
            }
            context.clip();
        }
        let composed = self.compose(scene, viewport, palette);
        context.restore();
        composed?;
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
                lines::hatch(below, path, viewport, floor.resolution, palette)?;
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
        // Beneath the robot.
        scale_bar::draw(as_layer(context), viewport, palette)?;
        draw_objects(as_layer(context), scene, viewport, palette, DrawPass::Live)?;
        draw_life(context, scene, viewport, palette)?;

        if let Some(search) = &scene.search {
            search::draw_sides(context, palette, search, scene.plan, viewport);
        }
        if let Some(start) = &scene.start {
            let centre = viewport.to_screen(start.position());
            robot::draw_start(context, palette, start, centre, (scene.start_body, scene.start_radius, viewport.scale))?;
        }
        trail(context, viewport, scene.estimated_trail, palette.estimate);
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
        Ok(())
    }
}

/// Whether nothing but robot, trails, people, pets, and floor and dirt that were swept can differ between two frames.
fn only_moves(last: &DrawnScene, drawn: &DrawnScene) -> bool {
    let is_lifted = |frame: &DrawnScene| frame.robot.is_some_and(|robot| robot.is_lifted);
    let still = |frame: &DrawnScene| {
        let DrawnScene { still, run_version, cursor, selected, shows, .. } = *frame;
        (still, run_version, cursor, selected, shows)
    };
    still(last) == still(drawn)
        && (last.search, last.in_hand, last.senses) == (None, false, false)
        && (drawn.search, drawn.in_hand, drawn.senses) == (None, false, false)
        && !is_lifted(last)
        && !is_lifted(drawn)
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
