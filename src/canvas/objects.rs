//! Draws the objects in a room.

use js_sys::Array;
use robovac_app::{Palette, Viewport, explore::handles};
use robovac_core::{
    floor_plan::{Object, Who, middle},
    geometry::{Point, Pose, Vector},
    math,
};
use robovac_sim::Spot;
use wasm_bindgen::JsValue;
use web_sys::OffscreenCanvasRenderingContext2d;

/// Depth of a stair's tread, m.
const TREAD: f64 = 0.26;
/// Distance of the lines on a carpet, CSS pixels.
const WEAVE: f64 = 6.0;
/// Depth and width of a dock, m: iRobot's home base.
const DOCK: (f64, f64) = (0.13, 0.16);
/// Reach of a dock's beams and of its force field, m, and the angles between which a beam is, rad; as they are simulated
/// (`sim::senses`).
const DOCK_BEAMS: (f64, f64, [f64; 2]) = (2.5, 0.61, [-25.0 * math::PI / 180.0, 5.0 * math::PI / 180.0]);
/// By how much a virtual wall's beam widens to either side with every metre.
const FENCE: f64 = 0.0875;
/// Radius of a handle, CSS pixels.
const HANDLE: f64 = 5.0;

/// Layers of an object's picture, from below.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DrawPass {
    /// Objects on the floor, below the swept cells.
    Ground,
    /// The part of these that is visible where the floor was swept.
    Texture,
    /// Objects as large as walls, and drop-offs.
    Body,
    /// Small standing objects.
    Small,
    /// Moving and consumable objects.
    Live,
}

impl DrawPass {
    /// All parts, from below.
    pub const ALL: [Self; 5] = [Self::Ground, Self::Texture, Self::Body, Self::Small, Self::Live];
}

/// Draws onto one context; one unit is a CSS pixel.
pub struct CanvasPen<'a> {
    /// The context.
    pub context: &'a OffscreenCanvasRenderingContext2d,
    /// The colours.
    pub palette: &'a Palette,
    /// The visible part of the world.
    pub viewport: &'a Viewport,
    /// Whether dirt, people and pets are drawn in their present state rather than as placed.
    pub has_life: bool,
}

impl CanvasPen<'_> {
    /// Draws one part of an object.
    pub fn draw(&self, object: &Object, part: DrawPass) -> Result<(), JsValue> {
        let Palette { furniture, furniture_line, carpet, carpet_line, .. } = *self.palette;
        match (object, part) {
            (Object::Carpet { outline }, DrawPass::Ground) => {
                self.trace(outline, true);
                self.fill(carpet);
            }
            (Object::Carpet { outline }, DrawPass::Texture) => self.weave(outline, carpet_line),
            (Object::Furniture { outline } | Object::LowObstacle { outline, .. }, DrawPass::Body) => {
                self.trace(outline, true);
                self.fill(if matches!(object, Object::Furniture { .. }) { furniture } else { carpet });
                self.stroke(furniture_line, 1.25);
            }
            (Object::DropOff { outline }, DrawPass::Body) => self.stairs(outline)?,
            (Object::Leg { at, radius }, DrawPass::Small) => {
                self.circle(*at, radius.max(1.75 / self.viewport.scale))?;
                self.fill(furniture);
                self.stroke(furniture_line, 1.25);
            }
            (Object::Dock { pose }, DrawPass::Small) => self.dock(pose)?,
            (Object::VirtualWall { pose, length }, DrawPass::Small) => self.virtual_wall(pose, *length)?,
            (Object::Dirt { at, radius }, DrawPass::Live) if !self.has_life => self.dirt(*at, *radius),
            (Object::Mover { who, path }, DrawPass::Live) => {
                self.trace(path, false);
                self.dash(&[5.0, 5.0])?;
                self.stroke(if *who == Who::Person { self.palette.person } else { self.palette.pet }, 1.5);
                self.dash(&[])?;
                if let Some(&at) = path.first().filter(|_| !self.has_life) {
                    let ahead = path.get(1).map_or(Vector::new(1.0, 0.0), |next| next - at);
                    self.figure(*who, at, ahead)?;
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// Draws the selection of an object.
    pub fn select(&self, object: &Object) -> Result<(), JsValue> {
        let Palette { select, halo, .. } = *self.palette;
        match object {
            Object::Furniture { outline }
            | Object::LowObstacle { outline, .. }
            | Object::DropOff { outline }
            | Object::Carpet { outline } => self.trace(outline, true),
            Object::Mover { path, .. } => self.trace(path, false),
            Object::Leg { at, radius } | Object::Dirt { at, radius } => self.circle(*at, *radius)?,
            Object::Dock { pose } => {
                self.dock_beams(pose)?;
                self.lead(pose, 0.4);
            }
            Object::VirtualWall { pose, length } => self.lead(pose, *length),
        }
        self.stroke(halo, 4.0);
        self.stroke(select, 2.0);
        for handle in handles(object) {
            let at = self.viewport.to_screen(handle);
            self.context.begin_path();
            self.context.arc(at.x, at.y, HANDLE, 0.0, math::TAU)?;
            self.fill(halo);
            self.stroke(select, 2.0);
        }
        Ok(())
    }

    /// A person or a pet at a point, going some way.
    pub fn figure(&self, who: Who, at: Point, ahead: Vector) -> Result<(), JsValue> {
        let Palette { person, pet, halo, .. } = *self.palette;
        let pose = Pose::new(at.x, at.y, math::atan2(ahead.y, ahead.x));
        let spot = |x: f64, y: f64| pose.to_world(Point::new(x, y));
        match who {
            Who::Person => {
                self.circle(at, 0.15)?;
                self.fill(person);
                self.stroke(halo, 1.5);
                self.circle(spot(0.02, 0.0), 0.08)?;
                self.fill(halo);
            }
            Who::Pet => {
                // Tail, body, and a head with two ears.
                self.trace(&[spot(-0.08, 0.0), spot(-0.17, 0.03), spot(-0.21, -0.02)], false);
                self.stroke(pet, (0.03 * self.viewport.scale).max(1.5));
                for side in [1.0, -1.0] {
                    self.trace(&[spot(0.08, 0.02 * side), spot(0.17, 0.075 * side), spot(0.07, 0.09 * side)], true);
                    self.fill(pet);
                }
                self.circle(at, 0.12)?;
                self.fill(pet);
                self.stroke(halo, 1.5);
            }
        }
        Ok(())
    }

    /// Slanted lines and a border, so that a carpet is visible where it was swept.
    fn weave(&self, outline: &[Point], colour: &str) {
        let context = self.context;
        context.save();
        self.trace(outline, true);
        context.clip();
        let (low, high) = self.screen_box(outline);
        context.begin_path();
        // In the other direction than the hatching of unreachable floor; fixed to the floor.
        let origin = self.viewport.origin;
        let mut at = low.x - (high.y - low.y) - (low.x - origin.x - (high.y - origin.y)).rem_euclid(WEAVE);
        while at < high.x {
            context.move_to(at, low.y);
            context.line_to(at + high.y - low.y, high.y);
            at += WEAVE;
        }
        self.stroke(colour, 1.0);
        context.restore();
        self.trace(outline, true);
        self.stroke(colour, 1.5);
    }

    /// Treads that get darker on their way down, and an edge that warns.
    fn stairs(&self, outline: &[Point]) -> Result<(), JsValue> {
        let Palette { drop_off, tread, warning, .. } = *self.palette;
        let context = self.context;
        context.save();
        self.trace(outline, true);
        context.clip();
        self.fill(drop_off);
        // They go down along the longest edge.
        let edges = outline.iter().zip(outline.iter().cycle().skip(1)).map(|(a, b)| b - a);
        let run = edges.max_by(|a, b| a.norm().total_cmp(&b.norm())).unwrap_or(Vector::new(1.0, 0.0)).normalize();
        let across = Vector::new(-run.y, run.x);
        let centre = middle(outline);
        let along = |v: Vector| outline.iter().map(move |p| (p - centre).dot(&v));
        let (begin, end) = (along(run).fold(0.0, f64::min), along(run).fold(0.0, f64::max));
        let half = along(across).fold(0.0, |most: f64, d| most.max(d.abs()));
        let count = ((end - begin) / TREAD.max(5.0 / self.viewport.scale)).round().max(1.0);
        let line = |share: f64| centre + run * (begin + (end - begin) * share);
        for i in 0..count as u32 {
            let (from, to) = (line(f64::from(i) / count), line(f64::from(i + 1) / count));
            self.trace(&[from - across * half, from + across * half, to + across * half, to - across * half], true);
            context.set_global_alpha(0.6 * f64::from(i) / count);
            self.fill(tread);
            context.set_global_alpha(1.0);
            self.trace(&[to - across * half, to + across * half], false);
            self.stroke(tread, 1.0);
        }
        context.restore();
        self.trace(outline, true);
        self.stroke(warning, 3.0);
        self.dash(&[6.0, 5.0])?;
        self.stroke(drop_off, 1.5);
        self.dash(&[])
    }

    fn dock(&self, pose: &Pose) -> Result<(), JsValue> {
        let Palette { body, halo, estimate, .. } = *self.palette;
        let half = 0.5 * DOCK.1;
        let corner = |x: f64, y: f64| pose.to_world(Point::new(x, y));
        self.trace(&[corner(0.0, -half), corner(DOCK.0, -half), corner(DOCK.0, half), corner(0.0, half)], true);
        self.fill(body);
        self.stroke(halo, 1.5);
        // The tower with its eye.
        self.trace(&[corner(0.0, -half), corner(0.04, -half), corner(0.04, half), corner(0.0, half)], true);
        self.fill(estimate);
        self.circle(corner(0.085, 0.0), 0.018)?;
        self.fill(estimate);
        Ok(())
    }

    /// The beams of a dock.
    pub fn dock_beams(&self, pose: &Pose) -> Result<(), JsValue> {
        let (reach, field, [low, high]) = DOCK_BEAMS;
        // The green one is on the left of a robot that faces the dock.
        for (colour, from, to) in [(self.palette.beams[0], low, high), (self.palette.beams[1], -high, -low)] {
            self.wedge(pose, reach, from, to)?;
            self.fill(colour);
        }
        self.circle(pose.position(), field)?;
        self.dash(&[3.0, 4.0])?;
        self.stroke(self.palette.select, 1.0);
        self.dash(&[])
    }

    fn virtual_wall(&self, pose: &Pose, length: f64) -> Result<(), JsValue> {
        let Palette { body, halo, fence, fence_line, .. } = *self.palette;
        let spread = 0.02 + FENCE * length;
        let spot = |x: f64, y: f64| pose.to_world(Point::new(x, y));
        self.trace(&[spot(0.0, -0.02), spot(length, -spread), spot(length, spread), spot(0.0, 0.02)], true);
        self.fill(fence);
        self.trace(&[spot(0.0, 0.0), spot(length, 0.0)], false);
        self.stroke(fence_line, 1.5);
        self.trace(&[spot(-0.04, -0.05), spot(0.06, -0.05), spot(0.06, 0.05), spot(-0.04, 0.05)], true);
        self.fill(body);
        self.stroke(halo, 1.5);
        self.circle(spot(0.02, 0.0), 0.022)?;
        self.fill(fence_line);
        Ok(())
    }

    /// Specks, as dense everywhere, the same ones every time.
    fn dirt(&self, at: Point, radius: f64) {
        let count = (radius * radius * 1100.0).clamp(12.0, 160.0) as u32;
        self.context.set_fill_style_str(self.palette.dirt);
        let mut random = 0x9e37_79b9_u32;
        let mut next = || {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(random >> 8) / f64::from(1 << 24)
        };
        for _ in 0..count {
            let (distance, angle) = (radius * next().sqrt(), math::TAU * next());
            let speck = self.viewport.to_screen(at + Vector::new(math::cos(angle), math::sin(angle)) * distance);
            let size = ((0.008 + 0.016 * next()) * self.viewport.scale).clamp(1.2, 4.0);
            self.context.fill_rect(speck.x - 0.5 * size, speck.y - 0.5 * size, size, size);
        }
    }

    /// The remaining dirt of a spot.
    pub fn spot(&self, spot: &Spot) {
        let share = (spot.radius / spot.cell_size()).powi(2) * math::PI;
        let count = (spot.radius * spot.radius * 1100.0).clamp(12.0, 160.0);
        self.context.set_fill_style_str(self.palette.dirt);
        for (at, _) in spot.cells() {
            // The same cells always get a speck.
            let (x, y) = ((at.x / spot.cell_size()) as u32, (at.y / spot.cell_size()) as u32);
            let hash = (x.wrapping_mul(0x9e37_79b9) ^ y.wrapping_mul(0x85eb_ca6b)).wrapping_mul(0xc2b2_ae35);
            if f64::from(hash >> 8) / f64::from(1 << 24) * share < count {
                let size = ((0.008 + 0.016 * f64::from(hash & 0xff) / 255.0) * self.viewport.scale).clamp(1.2, 4.0);
                let speck = self.viewport.to_screen(at);
                self.context.fill_rect(speck.x - 0.5 * size, speck.y - 0.5 * size, size, size);
            }
        }
    }

    /// A line ahead of an object with a heading.
    fn lead(&self, pose: &Pose, length: f64) {
        self.trace(&[pose.position(), pose.to_world(Point::new(length, 0.0))], false);
    }

    fn wedge(&self, pose: &Pose, reach: f64, from: f64, to: f64) -> Result<(), JsValue> {
        let (tip, heading) = (self.viewport.to_screen(pose.position()), pose.heading);
        self.context.begin_path();
        self.context.move_to(tip.x, tip.y);
        // On the screen y points down, so angles go the other way round.
        self.context.arc(tip.x, tip.y, reach * self.viewport.scale, -heading - to, -heading - from)?;
        self.context.close_path();
        Ok(())
    }

    fn circle(&self, at: Point, radius: f64) -> Result<(), JsValue> {
        let centre = self.viewport.to_screen(at);
        self.context.begin_path();
        self.context.arc(centre.x, centre.y, radius * self.viewport.scale, 0.0, math::TAU)
    }

    fn trace(&self, points: &[Point], closed: bool) {
        self.context.begin_path();
        for (i, &point) in points.iter().enumerate() {
            let at = self.viewport.to_screen(point);
            if i == 0 { self.context.move_to(at.x, at.y) } else { self.context.line_to(at.x, at.y) }
        }
        if closed {
            self.context.close_path();
        }
    }

    fn screen_box(&self, points: &[Point]) -> (Point, Point) {
        let first = self.viewport.to_screen(points.first().copied().unwrap_or_default());
        points.iter().fold((first, first), |(low, high), &point| {
            let at = self.viewport.to_screen(point);
            (low.inf(&at), high.sup(&at))
        })
    }

    fn fill(&self, colour: &str) {
        self.context.set_fill_style_str(colour);
        self.context.fill();
    }

    fn stroke(&self, colour: &str, width: f64) {
        self.context.set_line_join("round");
        self.context.set_stroke_style_str(colour);
        self.context.set_line_width(width);
        self.context.stroke();
    }

    fn dash(&self, lengths: &[f64]) -> Result<(), JsValue> {
        self.context.set_line_dash(&lengths.iter().map(|&length| JsValue::from(length)).collect::<Array>())
    }
}
