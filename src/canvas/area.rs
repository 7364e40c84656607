//! The part of the picture that changes between two frames, so that the rest isn't drawn again.

use super::robot;
use robovac_app::{Scene, Viewport};
use robovac_core::{coverage::CoverageTracker, geometry::Point};

/// Room around lines and bodies for their halos, shadows and widths, CSS pixels.
const MARGIN: f64 = 8.0;
/// How far a body's halo, shadow and pressed bumper reach beyond it, in radii.
const REACH: f64 = 1.4;
/// How far side brushes take dirt beyond the body, m.
const BRUSHED: f64 = 0.12;
/// How far people and pets reach around where they are, m.
const FIGURE: f64 = 0.25;
/// Share of the picture from which on all of it is drawn.
const MOST: f64 = 0.7;

/// A rectangle of the canvas, CSS pixels: left, top, right, bottom. Empty if right < left.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CanvasArea([f64; 4]);

impl CanvasArea {
    const NONE: Self = Self([f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY]);

    /// Where the scene's moving parts are: robot, estimate, trails.
    pub fn of_moving(scene: &Scene<'_>, viewport: &Viewport) -> Self {
        let mut area = Self::NONE;
        let around = beside(scene) * viewport.scale + MARGIN;
        for point in scene.trail.iter().chain(scene.estimated_trail) {
            area.add(viewport.to_screen(*point), around);
        }
        if let Some(view) = &scene.robot {
            let body = REACH * (view.radius * viewport.scale).max(robot::LEAST_RADIUS);
            let reach = body.max((view.radius + BRUSHED) * viewport.scale) + MARGIN;
            for pose in std::iter::once(&view.pose).chain(&view.estimate) {
                area.add(viewport.to_screen(pose.position()), reach);
            }
        }
        area
    }

    /// Where people and pets are.
    pub fn of_figures(scene: &Scene<'_>, viewport: &Viewport) -> Self {
        let mut area = Self::NONE;
        if let Some(life) = scene.life {
            for &(at, _) in life.movers() {
                area.add(viewport.to_screen(at), FIGURE * viewport.scale + MARGIN);
            }
        }
        area
    }

    /// Where rows of the swept floor are, the lowest and highest given, with the dirt that went from beside them.
    pub fn of_rows(scene: &Scene<'_>, tracker: &CoverageTracker, rows: (usize, usize), viewport: &Viewport) -> Self {
        let row = scene.plan.height_m() / tracker.visits().height() as f64;
        // A cell fades into its neighbours.
        let (low, high) = (row * (rows.0 as f64 - 2.0), row * (rows.1 as f64 + 3.0));
        let mut area = Self::NONE;
        let beside = beside(scene);
        area.add(viewport.to_screen(Point::new(0.0, low - beside)), MARGIN);
        area.add(viewport.to_screen(Point::new(scene.plan.width_m(), high + beside)), MARGIN);
        area
    }

    fn add(&mut self, at: Point, around: f64) {
        self.join(&Self([at.x - around, at.y - around, at.x + around, at.y + around]));
    }

    /// Takes in another area.
    pub fn join(&mut self, other: &Self) {
        for i in 0..2 {
            self.0[i] = self.0[i].min(other.0[i]);
            self.0[i + 2] = self.0[i + 2].max(other.0[i + 2]);
        }
    }

    /// Left, top, width and height in whole device pixels within the canvas; `None` if that is most of it.
    pub fn to_device(self, viewport: &Viewport) -> Option<[f64; 4]> {
        let ratio = viewport.pixel_ratio;
        let size = viewport.size * ratio;
        let [left, top, right, bottom] = self.0.map(|edge| edge * ratio);
        let (left, top) = (left.floor().max(0.0), top.floor().max(0.0));
        let (width, height) = (right.ceil().min(size.x) - left, bottom.ceil().min(size.y) - top);
        let is_most = width.max(0.0) * height.max(0.0) > MOST * size.x * size.y;
        (!is_most).then_some([left, top, width.max(0.0), height.max(0.0)])
    }
}

/// How far from the robot's way dirt can have gone, m.
fn beside(scene: &Scene<'_>) -> f64 {
    let has_dirt = scene.life.is_some_and(|life| !life.spots().is_empty());
    scene.robot.filter(|_| has_dirt).map_or(0.0, |view| view.radius + BRUSHED)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn areas_join_and_keep_to_the_canvas() {
        let viewport = Viewport::new(10.0, 10.0, 200.0, 100.0, 2.0);
        let mut area = CanvasArea::NONE;
        assert_eq!(area.to_device(&viewport).map(|[_, _, width, height]| width * height), Some(0.0));
        area.add(Point::new(20.0, 10.0), 4.25);
        area.join(&CanvasArea([-5.0, 8.0, 0.0, 9.0]));
        assert_eq!(area.to_device(&viewport), Some([0.0, 11.0, 49.0, 18.0]));
        area.join(&CanvasArea([0.0, 0.0, 500.0, 500.0]));
        assert_eq!(area.to_device(&viewport), None);
    }
}
