//! Draws the Map tab: the estimate as cells, ground truth as lines over them, the robot on top.
//!
//! The cells are one picture with a pixel each, which is updated at most some times a second while playing; everything
//! else is drawn every frame, but nothing if nothing has changed.

use super::{
    ink::MapInk,
    marks,
    picture::{CellPicture, Sign},
};
use robovac_app::{
    Palette, RobotView, Viewport,
    map::{CellVerdict, MapGrid, MapPhase, MapSession},
};
use robovac_core::{
    floor_plan::{FloorPlan, Object},
    geometry::{Point, Pose},
    grid::{Occupancy, outlines},
    math::TAU,
};
use robovac_playground::{canvas::robot, wire::clock};
use robovac_sim::Run;
use std::sync::Arc;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement, Path2d};

/// Corners above which walls are left to the cells.
const MOST_CORNERS: usize = 40_000;
/// Time between two pictures of the cells while playing, ms.
const PICTURE_EVERY_MS: f64 = 90.0;
/// Pixels per cell from which on the lines between cells are drawn.
const GRID_FROM: f64 = 7.0;

/// Draws onto one canvas of the page.
pub(super) struct MapPainter {
    element: HtmlCanvasElement,
    context: CanvasRenderingContext2d,
    cells: CellPicture,
    /// State of the picture of the cells, and its time.
    cells_of: Option<(ShownMap, f64)>,
    walls: Option<(Arc<FloorPlan>, Path2d)>,
    last: Option<(ShownMap, Viewport, Option<Pose>)>,
}

/// State of the picture.
#[derive(Debug, Clone, PartialEq)]
struct ShownMap {
    version: u64,
    steps: u64,
    returned: bool,
    grid: MapGrid,
    layers: Vec<&'static str>,
    dark: bool,
}

impl MapPainter {
    /// Draws onto `element` from now on.
    pub fn new(element: HtmlCanvasElement) -> Result<Self, JsValue> {
        let context = element.get_context("2d")?.ok_or("no 2D canvas; use a current browser")?.unchecked_into();
        Ok(Self { element, context, cells: CellPicture::new()?, cells_of: None, walls: None, last: None })
    }

    /// Draws, if anything has changed; `held` is the pose of a lifted robot.
    pub fn draw(
        &mut self,
        session: &MapSession,
        viewport: &Viewport,
        held: Option<Pose>,
        dark: bool,
    ) -> Result<(), JsValue> {
        let shown = ShownMap {
            version: session.version(),
            // While a stored run is restored, the stored map is shown.
            steps: session.run().filter(|_| session.returned().is_none()).map_or(0, Run::steps),
            returned: session.returned().is_none(),
            grid: session.setup().grid,
            layers: session.setup().layers.names(),
            dark,
        };
        let now = (shown.clone(), *viewport, held);
        if self.last.as_ref() == Some(&now) {
            return Ok(());
        }
        self.last = Some(now);
        let ink = MapInk::of(dark);
        self.update_cells(session, shown, ink)?;
        let size = viewport.size * viewport.pixel_ratio;
        let (width, height) = (size.x.round().max(1.0) as u32, size.y.round().max(1.0) as u32);
        if (self.element.width(), self.element.height()) != (width, height) {
            self.element.set_width(width);
            self.element.set_height(height);
        }
        let ratio = viewport.pixel_ratio;
        let context = self.context.clone();
        context.set_transform(ratio, 0.0, 0.0, ratio, 0.0, 0.0)?;
        context.set_fill_style_str(ink.unknown);
        context.fill_rect(0.0, 0.0, viewport.size.x, viewport.size.y);
        self.draw_cells(viewport)?;
        grid(&context, viewport, self.cells.resolution(), ink);
        self.draw_signs(viewport, ink)?;
        if session.setup().layers.has("truth") {
            self.draw_truth(session, viewport, ink)?;
        }
        draw_robots(&context, session, viewport, held, (ink, Palette::of(dark)))
    }

    fn update_cells(&mut self, session: &MapSession, shown: ShownMap, ink: &MapInk) -> Result<(), JsValue> {
        let now = clock();
        let is_new = match &self.cells_of {
            Some((drawn, _)) if *drawn == shown => false,
            Some((drawn, at)) => {
                let goes_on =
                    session.phase() == MapPhase::Playing && (ShownMap { steps: shown.steps, ..drawn.clone() }) == shown;
                // Another frame will come.
                !goes_on || now - at > PICTURE_EVERY_MS
            }
            None => true,
        };
        if is_new {
            self.cells.update(session, ink)?;
            self.cells_of = Some((shown, now));
        }
        Ok(())
    }

    fn draw_cells(&self, viewport: &Viewport) -> Result<(), JsValue> {
        let Some((corner, [width, height])) = self.cells.place() else { return Ok(()) };
        let at = viewport.to_screen(corner);
        let scale = viewport.scale;
        // Crisp cells once they are larger than pixels.
        self.context.set_image_smoothing_enabled(scale * self.cells.resolution() * viewport.pixel_ratio < 2.0);
        self.context.draw_image_with_offscreen_canvas_and_dw_and_dh(
            &self.cells.layer.canvas,
            at.x,
            at.y,
            width * scale,
            height * scale,
        )
    }

    /// Errors and dirt, by signs: × an obstacle that isn't there, □ one that was missed, · one that isn't known yet, ●
    /// dirt.
    fn draw_signs(&self, viewport: &Viewport, ink: &MapInk) -> Result<(), JsValue> {
        let resolution = self.cells.resolution();
        let half = (0.5 * resolution * viewport.scale).max(1.5);
        // Small squares side by side would be a blot.
        let is_fine = half < 3.5;
        let context = &self.context;
        let kinds = [
            (Sign::Verdict(CellVerdict::Unseen), ink.unseen),
            (Sign::Verdict(CellVerdict::Missed), ink.missed),
            (Sign::Verdict(CellVerdict::Phantom), ink.phantom),
            (Sign::Dirt, ink.dirt),
        ];
        context.set_line_cap("butt");
        for (kind, colour) in kinds {
            context.begin_path();
            for (cell, _) in self.cells.signs.iter().filter(|(_, sign)| *sign == kind) {
                let at = viewport.to_screen(cell.centre(resolution));
                let inner = 0.8 * half;
                match kind {
                    Sign::Verdict(CellVerdict::Phantom) => {
                        context.move_to(at.x - half, at.y - half);
                        context.line_to(at.x + half, at.y + half);
                        context.move_to(at.x - half, at.y + half);
                        context.line_to(at.x + half, at.y - half);
                    }
                    Sign::Verdict(CellVerdict::Missed) if is_fine && (cell.x + cell.y).rem_euclid(2) != 0 => {}
                    Sign::Verdict(CellVerdict::Missed) => {
                        context.rect(at.x - inner, at.y - inner, 2.0 * inner, 2.0 * inner);
                    }
                    Sign::Verdict(_) => context.rect(at.x - 0.25 * half, at.y - 0.25 * half, 0.5 * half, 0.5 * half),
                    // Every other one, as a pattern.
                    Sign::Dirt if (cell.x + cell.y).rem_euclid(2) == 0 => {
                        context.move_to(at.x + 0.45 * half, at.y);
                        context.arc(at.x, at.y, 0.45 * half, 0.0, TAU)?;
                    }
                    Sign::Dirt => {}
                }
            }
            if matches!(kind, Sign::Verdict(CellVerdict::Phantom | CellVerdict::Missed)) {
                context.set_line_width((0.4 * half).clamp(1.0, 2.5));
                context.set_stroke_style_str(colour);
                context.stroke();
            } else {
                context.set_fill_style_str(colour);
                context.fill();
            }
        }
        Ok(())
    }

    /// Outlines of walls and objects.
    fn draw_truth(&mut self, session: &MapSession, viewport: &Viewport, ink: &MapInk) -> Result<(), JsValue> {
        let Some(plan) = session.plan() else { return Ok(()) };
        if self.walls.as_ref().is_none_or(|(drawn, _)| !Arc::ptr_eq(drawn, plan)) {
            self.walls = Some((Arc::clone(plan), truth_path(plan)?));
        }
        let Some((_, path)) = &self.walls else { return Ok(()) };
        let context = &self.context;
        let (ratio, scale) = (viewport.pixel_ratio, viewport.scale * viewport.pixel_ratio);
        let origin = viewport.origin * ratio;
        context.save();
        context.set_transform(scale, 0.0, 0.0, -scale, origin.x, origin.y)?;
        context.set_line_join("round");
        // Thin, and without contrast, as the robot's estimate lies right below.
        context.set_line_width(1.25 / viewport.scale);
        context.set_stroke_style_str(ink.truth);
        context.stroke_with_path(path);
        context.restore();
        Ok(())
    }
}

/// Outlines of obstacles, in metres.
fn truth_path(plan: &FloorPlan) -> Result<Path2d, JsValue> {
    let path = Path2d::new()?;
    let line = |points: &mut dyn Iterator<Item = Point>| {
        for (i, at) in points.enumerate() {
            if i == 0 { path.move_to(at.x, at.y) } else { path.line_to(at.x, at.y) }
        }
        path.close_path();
    };
    let solid = plan.occupancy.map(|&cell| cell == Occupancy::Occupied);
    for corners in outlines(&solid, MOST_CORNERS).unwrap_or_default() {
        let metres =
            |cell: &robovac_core::grid::Cell| Point::new(f64::from(cell.x), f64::from(cell.y)) * plan.resolution;
        line(&mut corners.iter().map(metres));
    }
    // The outside counts as wall.
    let (width, height) = (plan.width_m(), plan.height_m());
    line(&mut [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)].into_iter().map(|(x, y)| Point::new(x, y)));
    for object in &plan.objects {
        match object {
            Object::Furniture { outline } | Object::DropOff { outline } => line(&mut outline.iter().copied()),
            Object::Leg { at, radius } => {
                path.move_to(at.x + radius, at.y);
                path.arc(at.x, at.y, *radius, 0.0, TAU)?;
            }
            _ => {}
        }
    }
    Ok(path)
}

/// A line every metre; where cells are large, fainter ones between them.
fn grid(context: &CanvasRenderingContext2d, viewport: &Viewport, resolution: f64, ink: &MapInk) {
    let (low, high) = viewport.bounds();
    let lines = |unit: f64| {
        context.begin_path();
        for x in (low.x / unit).ceil() as i32..=(high.x / unit).floor() as i32 {
            let x = viewport.to_screen(Point::new(f64::from(x) * unit, 0.0)).x.round() + 0.5;
            context.move_to(x, 0.0);
            context.line_to(x, viewport.size.y);
        }
        for y in (low.y / unit).ceil() as i32..=(high.y / unit).floor() as i32 {
            let y = viewport.to_screen(Point::new(0.0, f64::from(y) * unit)).y.round() + 0.5;
            context.move_to(0.0, y);
            context.line_to(viewport.size.x, y);
        }
        context.stroke();
    };
    context.set_stroke_style_str(ink.grid);
    context.set_line_width(1.0);
    lines(1.0);
    if resolution * viewport.scale >= GRID_FROM {
        lines(resolution);
    }
}

/// Trails, uncertainty, and the robot: solid at the estimated pose, in outline at the true one.
fn draw_robots(
    context: &CanvasRenderingContext2d,
    session: &MapSession,
    viewport: &Viewport,
    held: Option<Pose>,
    (ink, palette): (&MapInk, &Palette),
) -> Result<(), JsValue> {
    let (Some(run), Some(prepared), Some(estimate)) = (session.run(), session.prepared(), session.estimate()) else {
        return Ok(());
    };
    let has = |layer: &str| session.setup().layers.has(layer);
    let model = &prepared.robot;
    let view = RobotView { is_lifted: false, ..RobotView::of(run, model, false) };
    let solid = |pose: Pose, is_lifted: bool| {
        let view = RobotView { pose, is_lifted, ..view };
        robot::draw(context, palette, &view, viewport.to_screen(pose.position()), viewport.scale)
    };
    if let (Some(pose), true) = (estimate.pose(), session.returned().is_some()) {
        return solid(pose, false);
    }
    let robot = (model.radius, viewport);
    // A robot that doesn't know where it is has none that mean anything on its map.
    if let (true, Some(intent)) = (has("goals") && estimate.is_sure() != Some(false), run.intent()) {
        marks::frontiers(context, viewport, intent.frontiers, ink.goal)?;
        if let Some(pose) = estimate.pose() {
            marks::route(context, viewport, (pose.position(), intent.route), (ink.goal, ink.halo))?;
        }
    }
    if has("trails") {
        marks::trail(context, viewport, run.trail(), (ink.truth, 1.75));
        if run.locator().is_none() {
            marks::trail(context, viewport, run.estimated_trail(), (ink.estimate, 2.5));
        }
    }
    if has("odometry")
        && let Some(other) = run.baseline()
    {
        marks::ghost(context, robot, other.pose(), (ink.odometry_line, ink.halo, [2.0, 4.0]))?;
    }
    if has("robot") && held.is_none() {
        marks::ghost(context, robot, run.pose(), (ink.truth, ink.halo, [6.0, 4.0]))?;
    }
    // A lost robot has many possible poses.
    if has("particles") || estimate.is_sure() == Some(false) {
        marks::particles(context, viewport, &estimate.particles(), ink.estimate);
    }
    if let (true, Some(pose), Some(spread)) = (has("uncertainty"), estimate.pose(), estimate.pose_covariance()) {
        marks::doubt(context, robot, pose, &spread, (ink.doubt, ink.estimate))?;
    }
    if let Some(pose) = estimate.pose() {
        // An uncertain pose is drawn faintly.
        if held.is_some() || estimate.is_sure() == Some(false) {
            context.set_global_alpha(0.45);
        }
        solid(pose, false)?;
        context.set_global_alpha(1.0);
    }
    if let Some(pose) = held {
        solid(pose, true)?;
        marks::ghost(context, robot, pose, (ink.truth, ink.halo, [6.0, 4.0]))?;
    }
    Ok(())
}
