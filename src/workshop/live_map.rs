//! Live map of a connected robot: room, estimated pose, swept floor and contacts.

mod marks;
mod paper;

use self::{marks::FeltMark, paper::Paper};
use super::session_mirror::SessionMirror;
use robovac_app::{Palette, RobotView, Scene, Viewport, connection::LiveMapWords};
use robovac_core::{
    coverage::CoverageTracker,
    geometry::{Point, Pose, Vector},
    robot::RobotModel,
};
use robovac_link::connection::{SETS_OFF, SWEEPS};
use robovac_playground::canvas::Canvas;
use robovac_sim::experiment::Shows;
use wasm_bindgen::prelude::*;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

/// Most corners of the drawn trail; the latest are kept.
const MOST_TRAIL: usize = 4000;
/// Distance between two corners of the drawn trail, m.
const TRAIL_STEP: f64 = 0.02;
/// Distance between two readings that can't be driven, m: the robot was moved, or its estimate was set.
const JUMP: f64 = 0.3;
/// Contacts that leave a mark: bumpers and cliffs, see `robovac_link::connection::Connection::take_trace`.
const FELT: u16 = 1 | 2 | 4 | 8 | 16 | 32;

/// A driving robot on a canvas. Its poses are estimates; [`LiveMap::anchor`] transforms them to the room.
#[wasm_bindgen]
pub struct LiveMap {
    canvas: Canvas,
    context: CanvasRenderingContext2d,
    viewport: Viewport,
    paper: Paper,
    robot: RobotModel,
    tracker: Option<CoverageTracker>,
    /// Transform of estimated poses to the room: a turn, then a shift.
    anchor: Pose,
    pose: Option<Pose>,
    /// The robot's estimated pose.
    estimate: Option<Pose>,
    /// The robot's true pose, known for virtual robots only.
    truth: Option<Pose>,
    bumps: [bool; 2],
    /// Its trail, m on the paper.
    trail: Vec<Point>,
    /// Its whole trail in the room, for a larger paper, and whether it swept on the way there.
    places: Vec<(Point, bool)>,
    marks: Vec<FeltMark>,
    /// Its last contacts: a mark is left when they begin.
    felt: u8,
    planned: Vec<Point>,
    /// Versions, which grow with every paper, every new trail and every planned line.
    versions: [u64; 3],
    dark: bool,
    is_lifted: bool,
    has_changed: bool,
}

#[wasm_bindgen]
impl LiveMap {
    /// On a canvas, with the room of `mirror` if it is `known`, or else on blank paper.
    #[wasm_bindgen(constructor)]
    pub fn new(element: HtmlCanvasElement, mirror: &SessionMirror, known: bool) -> Result<Self, JsValue> {
        let context = element.get_context("2d")?.ok_or("no 2D canvas; use a current browser")?.unchecked_into();
        let canvas = Canvas::new(element)?;
        let robot = mirror.session().settings().robot_model();
        let paper = Paper::new(mirror.session(), &robot, known);
        let mut map = Self {
            canvas,
            context,
            viewport: Viewport::new(1.0, 1.0, 1.0, 1.0, 1.0),
            paper,
            robot,
            tracker: None,
            anchor: Pose::new(0.0, 0.0, 0.0),
            pose: None,
            estimate: None,
            truth: None,
            bumps: [false; 2],
            trail: Vec::new(),
            places: Vec::new(),
            marks: Vec::new(),
            felt: 0,
            planned: Vec::new(),
            versions: [0; 3],
            dark: false,
            is_lifted: false,
            has_changed: true,
        };
        map.spread();
        Ok(map)
    }

    /// Starts again, with the room of `mirror` if it is `known`, or else on blank paper.
    pub fn begin(&mut self, mirror: &SessionMirror, known: bool) {
        self.robot = mirror.session().settings().robot_model();
        self.paper = Paper::new(mirror.session(), &self.robot, known);
        self.planned.clear();
        self.wipe();
        self.spread();
    }

    /// Clears the trail, the swept floor and the contacts.
    pub fn wipe(&mut self) {
        self.trail.clear();
        self.places.clear();
        self.marks.clear();
        self.felt = 0;
        self.tracker = self.paper.floor.as_ref().map(CoverageTracker::new);
        self.versions[1] += 1;
        self.has_changed = true;
    }

    /// Anchors a robot with the estimated pose x, y, heading at the start, or in a known room at its true pose if
    /// known: `truth` is x, y and heading, or empty.
    pub fn place(&mut self, x: f64, y: f64, heading: f64, truth: &[f64]) {
        let really = match *truth {
            [x, y, heading] if self.paper.is_known => Some(Pose::new(x, y, heading)),
            _ => None,
        };
        self.anchor(Pose::new(x, y, heading), really.or_else(|| self.paper.start()));
    }

    /// Adds a trace of `robovac_link::connection::Connection::take_trace`.
    pub fn follow(&mut self, trace: &[f64]) {
        for &[x, y, heading, felt] in trace.as_chunks().0 {
            if ![x, y, heading].into_iter().all(f64::is_finite) {
                continue;
            }
            if felt == f64::from(SETS_OFF) {
                // In a known room at its start; on blank paper at its present place.
                let here = if self.paper.is_known { self.paper.start() } else { self.pose };
                self.anchor(Pose::new(x, y, heading), here);
                self.wipe();
                continue;
            }
            let place = self.placed(x, y, heading);
            let bits = felt as u16;
            // Those that fit into a byte are contacts.
            let felt = (bits & FELT) as u8;
            for mark in FeltMark::of(&self.robot, place, felt & !self.felt) {
                self.marks.push(mark);
            }
            self.felt = felt;
            self.go_to(place, bits & SWEEPS != 0);
        }
    }

    /// Sets its estimated pose, whether it is lifted, and whether each half of its bumper is pressed.
    pub fn show_robot(&mut self, x: f64, y: f64, heading: f64, is_lifted: bool, left: bool, right: bool) {
        let pose = self.placed(x, y, heading);
        self.estimate = Some(Pose::new(x, y, heading));
        self.has_changed |= self.pose != Some(pose) || self.bumps != [left, right] || self.is_lifted != is_lifted;
        (self.pose, self.bumps, self.is_lifted) = (Some(pose), [left, right], is_lifted);
    }

    /// Sets its true pose in the room.
    pub fn show_truth(&mut self, x: f64, y: f64, heading: f64) {
        let truth = Some(Pose::new(x, y, heading));
        self.has_changed |= self.truth != truth;
        self.truth = truth;
    }

    /// Hides the robot.
    pub fn hide_robot(&mut self) {
        (self.pose, self.estimate, self.truth) = (None, None, None);
        self.has_changed = true;
    }

    /// Sets the planned line: corners in the room, x and y in turn, m.
    pub fn set_planned(&mut self, corners: &[f64]) {
        self.planned = corners.as_chunks().0.iter().map(|&[x, y]| Point::new(x, y)).collect();
        self.versions[2] += 1;
        self.has_changed = true;
    }

    /// Swept share of the reachable floor, 0 to 1; `None` on blank paper.
    pub fn coverage(&self) -> Option<f64> {
        self.paper.is_known.then_some(())?;
        Some(self.tracker.as_ref()?.coverage(self.paper.floor.as_ref()?))
    }

    /// Swept floor, m².
    pub fn swept_m2(&self) -> f64 {
        let (Some(tracker), Some(floor)) = (&self.tracker, &self.paper.floor) else { return 0.0 };
        tracker.coverage(floor) * floor.area()
    }

    /// The map in words: with the room's name, the robot's mode, and what drives it.
    pub fn words(&self, room: &str, mode: &str, driver: &str) -> String {
        let cliffs = self.marks.iter().filter(|mark| mark.is_cliff).count();
        let (estimate, coverage, swept_m2) = (self.estimate, self.coverage(), self.swept_m2());
        let bumps = self.marks.len() - cliffs;
        LiveMapWords { room, mode, driver, estimate, coverage, swept_m2, bumps, cliffs }.to_string()
    }

    // ---- the picture

    /// The canvas is `width` x `height` CSS pixels on a screen with `ratio` device pixels each.
    pub fn resize(&mut self, width: f64, height: f64, ratio: f64) {
        self.viewport.resize(width, height, ratio);
        self.has_changed = true;
    }

    /// Keeps the uppermost `told` CSS pixels free where all of the paper is shown, and `right` x `low` of the lower right corner.
    /// If neither legend nor zoom floats over it, `foot` is the height of what does at its bottom.
    pub fn keep_clear(&mut self, told: f64, foot: Option<f64>, right: f64, low: f64) {
        self.viewport.keep_clear(told, foot, Vector::new(right, low), Vector::zeros());
        self.has_changed = true;
    }

    /// Dark or light colours.
    pub fn set_dark(&mut self, dark: bool) {
        self.dark = dark;
        self.has_changed = true;
    }

    /// Pans by CSS pixels.
    pub fn pan(&mut self, dx: f64, dy: f64) {
        self.viewport.pan(dx, dy);
        self.has_changed = true;
    }

    /// Zooms by `factor` around (`x`, `y`), CSS pixels.
    pub fn zoom(&mut self, x: f64, y: f64, factor: f64) {
        self.viewport.zoom_at(x, y, factor);
        self.has_changed = true;
    }

    /// Shows all of the paper.
    pub fn fit(&mut self) {
        self.viewport.fit();
        self.has_changed = true;
    }

    /// The place in the room at (`x`, `y`) CSS pixels: x and y, m.
    pub fn place_at(&self, x: f64, y: f64) -> Vec<f64> {
        let place = self.viewport.to_world(x, y) - self.paper.shift;
        vec![place.x, place.y]
    }

    /// Whether the robot's true pose is at (`x`, `y`) CSS pixels.
    pub fn is_on_robot(&self, x: f64, y: f64) -> bool {
        let Some(truth) = self.truth else { return false };
        let centre = self.viewport.to_screen(truth.position() + self.paper.shift);
        (centre - Point::new(x, y)).norm() <= (self.robot.radius * self.viewport.scale).max(16.0)
    }

    /// Draws, if anything has changed.
    pub fn draw(&mut self) -> Result<(), JsValue> {
        let dirty_rows = self.tracker.as_mut().and_then(CoverageTracker::take_dirty_rows);
        if !std::mem::take(&mut self.has_changed) && dirty_rows.is_none() {
            return Ok(());
        }
        let shift = self.paper.shift;
        let on_paper = |pose: Pose| Pose::new(pose.x + shift.x, pose.y + shift.y, pose.heading);
        let robot = &self.robot;
        // The dashed robot is at the true pose here, as the page shows the robot's estimate.
        let view = self.pose.map(|pose| RobotView {
            pose: on_paper(pose),
            estimate: self.truth.map(on_paper),
            body: robot.body,
            radius: robot.radius,
            wheels: [robot.wheel_base, robot.wheel_radius],
            castors: robot.castors,
            suite: robot.sensors,
            is_lifted: self.is_lifted,
            tool_width: robot.tool_width,
            bump_left: self.bumps[0],
            bump_right: self.bumps[1],
        });
        let planned: Vec<Point> = self.planned.iter().map(|&corner| corner + shift).collect();
        let known = self.paper.is_known;
        let scene = Scene {
            plan_version: self.versions[0],
            floor: self.paper.floor.as_ref().filter(|_| known),
            tracker: self.tracker.as_ref(),
            run_version: self.versions[1],
            dirty_rows,
            planned: &planned,
            planned_version: self.versions[2],
            trail: &self.trail,
            robot: view,
            start: self.paper.start().filter(|_| known).map(on_paper),
            start_radius: robot.radius,
            start_body: robot.body,
            dark: self.dark,
            shows: Shows::DEFAULT,
            ..Scene::empty(&self.paper.plan)
        };
        self.canvas.draw(&scene, &self.viewport)?;
        marks::draw(&self.context, Palette::of(self.dark), &self.marks, shift, &self.viewport)
    }
}

impl LiveMap {
    /// Sets the anchor such that the estimated pose `from` is at `to` in the room.
    fn anchor(&mut self, from: Pose, to: Option<Pose>) {
        let Some(to) = to else { return };
        let turn = to.heading - from.heading;
        let moved = Pose::new(0.0, 0.0, turn).to_world(from.position());
        self.anchor = Pose::new(to.x - moved.x, to.y - moved.y, turn);
        self.lift();
    }

    /// An estimated pose, transformed to the room.
    fn placed(&self, x: f64, y: f64, heading: f64) -> Pose {
        let place = self.anchor.to_world(Point::new(x, y));
        Pose::new(place.x, place.y, heading + self.anchor.heading)
    }

    fn go_to(&mut self, place: Pose, sweeps: bool) {
        let point = place.position();
        if let Some((last, swept)) = self.places.last_mut() {
            let distance = (point - *last).norm();
            if distance < TRAIL_STEP {
                // Brushes that start at rest sweep where they are.
                if sweeps && !std::mem::replace(swept, true) {
                    let last = *last;
                    self.sweep_to(last);
                }
                return;
            }
            if distance > JUMP {
                self.lift();
            }
        }
        self.has_changed = true;
        self.places.push((point, sweeps));
        if self.paper.is_too_small_for(point) {
            // Larger paper, on which everything is drawn again.
            self.paper = self.paper.larger(point, &self.robot);
            self.spread();
        } else {
            self.draw_to(point, sweeps);
        }
    }

    /// It didn't drive from its last place to the next.
    fn lift(&mut self) {
        if let Some(tracker) = &mut self.tracker {
            tracker.lift();
        }
        self.trail.clear();
        self.has_changed = true;
    }

    fn sweep_to(&mut self, place: Point) {
        let at = place + self.paper.shift;
        if let (Some(tracker), Some(floor)) = (&mut self.tracker, &self.paper.floor) {
            // A connected robot's tool is in the middle, so that its heading doesn't matter.
            tracker.sweep_to(floor, Pose { x: at.x, y: at.y, heading: 0.0 });
        }
    }

    /// Extends the trail, and what was swept along it.
    fn draw_to(&mut self, place: Point, sweeps: bool) {
        let at = place + self.paper.shift;
        if sweeps {
            self.sweep_to(place);
        } else if let Some(tracker) = &mut self.tracker {
            tracker.lift();
        }
        if self.trail.len() >= MOST_TRAIL {
            self.trail.drain(..MOST_TRAIL / 4);
        }
        self.trail.push(at);
    }

    /// Draws the trail so far on new paper.
    fn spread(&mut self) {
        self.tracker = self.paper.floor.as_ref().map(CoverageTracker::new);
        self.viewport.set_room(self.paper.plan.width_m(), self.paper.plan.height_m());
        self.versions = self.versions.map(|version| version + 1);
        self.has_changed = true;
        self.trail.clear();
        for (place, sweeps) in std::mem::take(&mut self.places) {
            if self.places.last().is_some_and(|(last, _)| (place - *last).norm() > JUMP) {
                self.lift();
            }
            self.draw_to(place, sweeps);
            self.places.push((place, sweeps));
        }
    }
}
