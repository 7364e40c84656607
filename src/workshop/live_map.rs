//! Live map of a connected robot: room, estimated pose, swept floor and contacts.

mod marks;
mod paper;

use self::{marks::FeltMark, paper::Paper};
use super::session_mirror::SessionMirror;
use robovac_app::{Palette, RobotView, Scene, Viewport, connection::LiveMapWords};
use robovac_core::{
    coverage::CoverageTracker,
    geometry::{Point, Pose},
    robot::RobotModel,
};
use robovac_link::connection::SETS_OFF;
use robovac_playground::canvas::Canvas;
use robovac_sim::experiment::Shows;
use wasm_bindgen::prelude::*;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

/// Corners of the way that are drawn; of a longer one, the latest.
const MOST_TRAIL: usize = 4000;
/// Distance between two corners of the drawn way, m.
const TRAIL_STEP: f64 = 0.02;
/// Distance between two readings that no robot drives, m: it was taken elsewhere, or believes to be.
const JUMP: f64 = 0.3;
/// Sum of what a robot can feel that leaves a mark: bumpers and cliffs, see `app::connection::Connection::take_trace`.
const FELT: u8 = 1 | 2 | 4 | 8 | 16 | 32;

/// A robot on its way, drawn on a canvas. Poses that come in are those that the robot believes in; [`LiveMap::anchor`]
/// says where they are in the room.
#[wasm_bindgen]
pub struct LiveMap {
    canvas: Canvas,
    context: CanvasRenderingContext2d,
    viewport: Viewport,
    paper: Paper,
    robot: RobotModel,
    tracker: Option<CoverageTracker>,
    /// Takes believed poses into the room: a turn, then a shift.
    anchor: Pose,
    pose: Option<Pose>,
    /// The pose that the robot believes in.
    estimate: Option<Pose>,
    /// Where the robot really is, which only virtual ones tell.
    truth: Option<Pose>,
    bumps: [bool; 2],
    /// Where it has been, m on the paper.
    trail: Vec<Point>,
    /// All places of this way in the room, for a larger paper.
    places: Vec<Point>,
    marks: Vec<FeltMark>,
    /// What it felt last: a mark is left when that begins.
    felt: u8,
    planned: Vec<Point>,
    /// Grow with every paper, every way that begins anew, and every planned line.
    versions: [u64; 3],
    dark: bool,
    is_lifted: bool,
    has_changed: bool,
}

#[wasm_bindgen]
impl LiveMap {
    /// On that canvas, in the room that `guest` shows if it is `known`, or else on blank paper.
    #[wasm_bindgen(constructor)]
    pub fn new(element: HtmlCanvasElement, guest: &SessionMirror, known: bool) -> Result<Self, JsValue> {
        let context = element.get_context("2d")?.ok_or("no 2D canvas; use a current browser")?.unchecked_into();
        let canvas = Canvas::new(element)?;
        let robot = guest.session().settings().robot_model();
        let paper = Paper::new(guest.session(), &robot, known);
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

    /// Begins anew, in the room that `guest` shows if it is `known`, or else on blank paper.
    pub fn begin(&mut self, guest: &SessionMirror, known: bool) {
        self.robot = guest.session().settings().robot_model();
        self.paper = Paper::new(guest.session(), &self.robot, known);
        self.planned.clear();
        self.wipe();
        self.spread();
    }

    /// Forgets the way, what was swept and felt.
    pub fn wipe(&mut self) {
        self.trail.clear();
        self.places.clear();
        self.marks.clear();
        self.felt = 0;
        self.tracker = self.paper.floor.as_ref().map(CoverageTracker::new);
        self.versions[1] += 1;
        self.has_changed = true;
    }

    /// A robot whose estimated pose is x, y, heading is at the start, or in a known room where it really is, as far as that
    /// is known: `truth` is x, y and heading, too, or empty.
    pub fn place(&mut self, x: f64, y: f64, heading: f64, truth: &[f64]) {
        let really = match *truth {
            [x, y, heading] if self.paper.is_known => Some(Pose::new(x, y, heading)),
            _ => None,
        };
        self.anchor(Pose::new(x, y, heading), really.or_else(|| self.paper.start()));
    }

    /// Where it has been, as `app::connection::Connection::take_trace` tells it.
    pub fn follow(&mut self, trace: &[f64]) {
        for &[x, y, heading, felt] in trace.as_chunks().0 {
            if ![x, y, heading].into_iter().all(f64::is_finite) {
                continue;
            }
            if felt == f64::from(SETS_OFF) {
                // In a known room at its start; on blank paper it stays where it is drawn.
                let here = if self.paper.is_known { self.paper.start() } else { self.pose };
                self.anchor(Pose::new(x, y, heading), here);
                self.wipe();
                continue;
            }
            let place = self.placed(x, y, heading);
            let felt = felt as u8;
            for mark in FeltMark::of(&self.robot, place, felt & FELT & !self.felt) {
                self.marks.push(mark);
            }
            self.felt = felt;
            self.go_to(place);
        }
    }

    /// Its estimated pose now, whether it is in somebody's hand, and whether each half of its bumper is pressed.
    pub fn show_robot(&mut self, x: f64, y: f64, heading: f64, is_lifted: bool, left: bool, right: bool) {
        let pose = self.placed(x, y, heading);
        self.estimate = Some(Pose::new(x, y, heading));
        self.has_changed |= self.pose != Some(pose) || self.bumps != [left, right] || self.is_lifted != is_lifted;
        (self.pose, self.bumps, self.is_lifted) = (Some(pose), [left, right], is_lifted);
    }

    /// Where it really is in the room.
    pub fn show_truth(&mut self, x: f64, y: f64, heading: f64) {
        let truth = Some(Pose::new(x, y, heading));
        self.has_changed |= self.truth != truth;
        self.truth = truth;
    }

    /// There is no robot.
    pub fn hide_robot(&mut self) {
        (self.pose, self.estimate, self.truth) = (None, None, None);
        self.has_changed = true;
    }

    /// The line that it is to drive: corners in the room, x and y in turn, m.
    pub fn set_planned(&mut self, corners: &[f64]) {
        self.planned = corners.as_chunks().0.iter().map(|&[x, y]| Point::new(x, y)).collect();
        self.versions[2] += 1;
        self.has_changed = true;
    }

    /// Share of the reachable floor that was swept, 0 to 1; of blank paper nothing is known.
    pub fn coverage(&self) -> Option<f64> {
        self.paper.is_known.then_some(())?;
        Some(self.tracker.as_ref()?.coverage(self.paper.floor.as_ref()?))
    }

    /// Floor that was swept, m².
    pub fn swept_m2(&self) -> f64 {
        let (Some(tracker), Some(floor)) = (&self.tracker, &self.paper.floor) else { return 0.0 };
        tracker.coverage(floor) * floor.area()
    }

    /// The map in words: the room's name, the robot's mode, and who drives it, if anybody.
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

    /// Dark or light colours.
    pub fn set_dark(&mut self, dark: bool) {
        self.dark = dark;
        self.has_changed = true;
    }

    /// Moves what is seen by CSS pixels.
    pub fn pan(&mut self, dx: f64, dy: f64) {
        self.viewport.pan(dx, dy);
        self.has_changed = true;
    }

    /// Enlarges `factor` times around (`x`, `y`), CSS pixels.
    pub fn zoom(&mut self, x: f64, y: f64, factor: f64) {
        self.viewport.zoom_at(x, y, factor);
        self.has_changed = true;
    }

    /// Shows all of the paper.
    pub fn fit(&mut self) {
        self.viewport.fit();
        self.has_changed = true;
    }

    /// The place in the room that is seen at (`x`, `y`) CSS pixels: x and y, m.
    pub fn place_at(&self, x: f64, y: f64) -> Vec<f64> {
        let place = self.viewport.to_world(x, y) - self.paper.shift;
        vec![place.x, place.y]
    }

    /// Whether the robot that really is there is seen at (`x`, `y`) CSS pixels.
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
        // What is dashed is the truth here: the page believes what the robot believes.
        let view = self.pose.map(|pose| RobotView {
            pose: on_paper(pose),
            estimate: self.truth.map(on_paper),
            body: robot.body,
            radius: robot.radius,
            wheels: [robot.wheel_base, robot.wheel_radius],
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
    /// From now on, a robot whose estimated pose is `from` is at `to` in the room.
    fn anchor(&mut self, from: Pose, to: Option<Pose>) {
        let Some(to) = to else { return };
        let turn = to.heading - from.heading;
        let moved = Pose::new(0.0, 0.0, turn).to_world(from.position());
        self.anchor = Pose::new(to.x - moved.x, to.y - moved.y, turn);
        self.lift();
    }

    /// A believed pose, in the room.
    fn placed(&self, x: f64, y: f64, heading: f64) -> Pose {
        let place = self.anchor.to_world(Point::new(x, y));
        Pose::new(place.x, place.y, heading + self.anchor.heading)
    }

    fn go_to(&mut self, place: Pose) {
        let point = place.position();
        if self.places.last().is_some_and(|last| (point - last).norm() < TRAIL_STEP) {
            return;
        }
        self.has_changed = true;
        if self.places.last().is_some_and(|last| (point - last).norm() > JUMP) {
            self.lift();
        }
        self.places.push(point);
        if self.paper.is_too_small_for(point) {
            // Larger paper, onto which everything is drawn again.
            self.paper = self.paper.larger(point, &self.robot);
            self.spread();
        } else {
            self.sweep_to(point);
        }
    }

    /// It didn't drive from where it was to where it comes next.
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
            tracker.sweep_to(floor, at);
        }
        if self.trail.len() >= MOST_TRAIL {
            self.trail.drain(..MOST_TRAIL / 4);
        }
        self.trail.push(at);
    }

    /// Draws the way so far onto paper that is new.
    fn spread(&mut self) {
        self.tracker = self.paper.floor.as_ref().map(CoverageTracker::new);
        self.viewport.set_room(self.paper.plan.width_m(), self.paper.plan.height_m());
        self.versions = self.versions.map(|version| version + 1);
        self.has_changed = true;
        self.trail.clear();
        for place in std::mem::take(&mut self.places) {
            if self.places.last().is_some_and(|last: &Point| (place - last).norm() > JUMP) {
                self.lift();
            }
            self.sweep_to(place);
            self.places.push(place);
        }
    }
}
