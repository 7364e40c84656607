//! State of the Floor plan tab: loaded file, settings, and the resulting room.

use super::{Doors, DrawingHand, DrawingPart, DrawingSource, FloorPlanSettings, Sheet, cut_off, settings::MOST_GAP};
use crate::{Import, ImportError, ScenarioChoices};
use coverage_planners::{
    metrics::DriveMetrics,
    sweep::{Sweep, SweepError, SweepSetup, sweep},
};
use floor_drawing::{
    self, DrawingError, DrawingFlaw, ShadeMethod, Traced, Tracing, dominant_direction, picture_direction, trace_picture,
};
use robovac_core::{
    coverage::ReachableFloor,
    cspace::{ConfigurationSpace, Outline},
    floor_plan::{FloorPlan, Object, Sketch, SourceFile},
    geometry::{MetricPath, Point, Pose, Vector, contains},
    grid::{Cell, Grid},
    math::{cos, sin},
    robot::{self, OwnRobot, RobotModel},
};
use std::ops::ControlFlow;

/// Id of the planner that drives the sweep.
pub const PLANNER: &str = "subgoal_sweep";
/// Id of the robot that is asked about before a room is used: the most usual one, and that of Explore.
const USUAL: &str = "roomba600";
/// Id of the model that robots with an outline of their own are built on: that of 001.
const OWN_MODEL: &str = "octagon";

/// A loaded file, its settings and the traced room.
#[derive(Debug)]
pub struct DrawingSession {
    source: DrawingSource,
    settings: FloorPlanSettings,
    sheet: Sheet,
    room: Option<Traced>,
    /// Free floor of the room, m².
    floor: f64,
    /// Floor of the room that a robot can't get to, with its area, m².
    cut: Option<(Grid<bool>, f64)>,
    /// Floor that the usual robot sweeps, m², if it can't get to some.
    reachable: Option<f64>,
    doors: Option<Doors>,
    fault: String,
    /// The place that the fault is about, in the turned file.
    mark: Option<FaultMark>,
    /// Angle by which the walls of the unturned file are askew, degrees.
    askew: Option<f64>,
    version: u32,
    space: Option<ConfigurationSpace>,
    sweep: Option<Sweep>,
    /// Numbers of driving the sweep in Explore, without slip.
    driven: Option<DriveMetrics>,
    /// State of pointing.
    pub hand: DrawingHand,
}

/// A place that a fault is about.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FaultMark {
    /// In the turned file.
    pub at: Point,
    /// Width of an opening there, m; 0 for a point.
    pub width: f64,
}

/// Longer sides of drawings below this are those of a sheet of paper or in another unit, m.
const LEAST_SIDE: f64 = 2.0;
/// Walls less askew than this are straight, degrees.
const STRAIGHT: f64 = 0.2;

impl DrawingSession {
    /// Reads files that belong together.
    pub fn open(files: &[SourceFile]) -> Result<Self, ImportError> {
        let mut source = DrawingSource::read(files)?;
        let settings = FloorPlanSettings::of(&source);
        source.shade(&settings.shades());
        let sheet = Sheet::of(&source);
        let mut board = Self {
            source,
            settings,
            sheet,
            room: None,
            floor: 0.0,
            cut: None,
            reachable: None,
            doors: None,
            fault: String::new(),
            mark: None,
            askew: None,
            version: 0,
            space: None,
            sweep: None,
            driven: None,
            hand: DrawingHand::default(),
        };
        board.trace();
        Ok(board)
    }

    /// The loaded source.
    pub fn source(&self) -> &DrawingSource {
        &self.source
    }

    /// Its settings.
    pub fn settings(&self) -> &FloorPlanSettings {
        &self.settings
    }

    /// Placement of the source on the sheet.
    pub fn sheet(&self) -> &Sheet {
        &self.sheet
    }

    /// The room, if there is one.
    pub fn room(&self) -> Option<&Traced> {
        self.room.as_ref()
    }

    /// Free floor of the room, m².
    pub fn floor_m2(&self) -> f64 {
        self.floor
    }

    /// Floor of the room that a robot can't get to, with its area, m².
    pub fn cut_off(&self) -> Option<&(Grid<bool>, f64)> {
        self.cut.as_ref()
    }

    /// Floor that the brush of a Roomba reaches, m², as Explore counts it, if it can't get to some.
    pub fn reachable_m2(&self) -> Option<f64> {
        self.reachable
    }

    /// Whether a drawing is too small for a room, so that its size must be chosen first.
    pub fn lacks_size(&self) -> bool {
        let side = self.settings.metre.map_or(0.0, |metre| metre * self.source.extent().1.max());
        self.source.drawing().is_some() && side < LEAST_SIDE && self.settings.confirmed != self.settings.metre
    }

    /// Whether the size of a picture is only assumed: what is a door, a gap or too narrow for a robot isn't known then.
    pub fn assumes_size(&self) -> bool {
        self.has_assumed_scale() && self.settings.confirmed != self.settings.metre
    }

    /// Whether a picture has the scale that was assumed of it, even if that is confirmed now.
    pub fn has_assumed_scale(&self) -> bool {
        let Self { source, settings, .. } = self;
        matches!(source, DrawingSource::Image { .. })
            && settings.method != ShadeMethod::Map
            && settings.metre == source.metre()
    }

    /// Open doors through which a chosen room extends.
    pub fn doors(&self) -> Option<&Doors> {
        self.doors.as_ref()
    }

    /// Error of the room or its settings; empty for none.
    pub fn fault(&self) -> &str {
        &self.fault
    }

    /// The place that the error is about.
    pub fn mark(&self) -> Option<FaultMark> {
        self.mark
    }

    /// That place, and the open doors through which a chosen room extends.
    pub fn marks(&self) -> impl Iterator<Item = FaultMark> {
        self.mark.into_iter().chain(self.doors.iter().flat_map(|doors| doors.openings.iter().copied()))
    }

    /// Angle by which the walls are askew as the file is turned now, degrees, above -45 to 45; `None` if they are straight
    /// or have no common direction.
    pub fn askew(&self) -> Option<f64> {
        self.askew_now(self.askew?)
    }

    /// How much walls at an angle in the file are askew as it is turned now.
    fn askew_now(&self, angle: f64) -> Option<f64> {
        let askew = (angle + self.settings.turn).rem_euclid(90.0);
        let askew = if askew > 45.0 { askew - 90.0 } else { askew };
        (askew.abs() >= STRAIGHT).then_some(askew)
    }

    /// Measured on the walls round the floor, where there is some: a page frame that is left out can lie at another angle.
    fn direction(&self) -> Option<f64> {
        let floor = self.room.as_ref().map(|room| room.plan.occupancy.map(|cell| cell.is_free()));
        // In the turned file.
        let is_by_floor = |point: Point| {
            let (Some(room), Some(floor)) = (&self.room, &floor) else { return true };
            let cell = room.plan.cell_at(((point.coords - room.corner) * room.metre).into());
            cell.block().any(|near| floor.is_set(near))
        };
        let found = self.direction_of(is_by_floor)?;
        // In a cut there can be no more than furniture.
        let is_cut = !matches!(self.settings.part, DrawingPart::Indoors | DrawingPart::Whole);
        let is_straight = |angle: f64| self.askew_now(angle).is_none();
        let whole = if is_cut { self.direction_of(|_| true) } else { None };
        (!whole.is_some_and(is_straight)).then_some(found)
    }

    /// That of the walls at points that are meant, in the turned file.
    fn direction_of(&self, is_meant: impl Fn(Point) -> bool) -> Option<f64> {
        let turn = self.settings.turn.to_radians();
        let angle = match &self.source {
            DrawingSource::Drawing { drawing, .. } => {
                dominant_direction(drawing, &self.settings.roles, is_meant)? - turn
            }
            DrawingSource::Image { cells, .. } if self.settings.method != ShadeMethod::Map => {
                let (sin, cos) = (sin(turn), cos(turn));
                let walls = cells.map(|cell| !cell.is_free());
                picture_direction(&walls, |pixel| {
                    let at = pixel.centre(1.0);
                    is_meant(Point::new(at.x * cos - at.y * sin, at.x * sin + at.y * cos))
                })?
            }
            DrawingSource::Image { .. } | DrawingSource::Map { .. } => return None,
        };
        Some(angle.to_degrees())
    }

    /// Turns the file to `degrees` from how it was, and the part with it.
    pub fn turn_to(&mut self, degrees: f64) -> Result<(), String> {
        self.set(self.settings.turned(degrees))
    }

    /// Changes whenever the room does.
    pub fn version(&self) -> u32 {
        self.version
    }

    /// The sweep, once planned for this room and robot.
    pub fn planned(&self) -> Option<&Sweep> {
        self.sweep.as_ref()
    }

    /// Numbers of driving the planned sweep in Explore, without slip.
    pub fn driven(&self) -> Option<&DriveMetrics> {
        self.driven.as_ref().filter(|_| self.sweep.is_some())
    }

    /// The obstacle map, once made for this room and robot.
    pub fn space(&self) -> Option<&ConfigurationSpace> {
        self.space.as_ref()
    }

    /// Applies settings and recomputes what depends on them. Changes nothing if a map's cell size is out of range.
    pub fn set(&mut self, settings: FloorPlanSettings) -> Result<(), String> {
        let settings = settings.checked(&self.source, &self.settings)?;
        let had_size = [self.lacks_size(), self.assumes_size()];
        let before = std::mem::replace(&mut self.settings, settings);
        let now = &self.settings;
        let shades = now.shades();
        if before.shades() != shades {
            self.source.shade(&shades);
        }
        if before.turn != now.turn {
            self.source.turn(now.turn.to_radians());
            self.sheet = Sheet::of(&self.source);
            // What was pointed at lies somewhere else now.
            self.hand = DrawingHand::default();
        }
        let room = |s: &FloorPlanSettings| {
            (s.metre, s.roles.clone(), s.gap, s.outer, s.resolution, s.part.clone(), s.turn, s.shades())
        };
        if room(&before) != room(now) || [self.lacks_size(), self.assumes_size()] != had_size {
            self.trace();
            return Ok(());
        }
        let space = |s: &FloorPlanSettings| (s.body.clone(), s.cell, s.headings);
        if space(&before) != space(now) {
            (self.space, self.sweep) = (None, None);
        } else if (before.scan_width, before.order, before.clearance) != (now.scan_width, now.order, now.clearance) {
            self.sweep = None;
        }
        Ok(())
    }

    /// Sets the part of the drawing.
    pub fn set_part(&mut self, part: DrawingPart) -> Result<(), String> {
        self.set(FloorPlanSettings { part, ..self.settings.clone() })
    }

    /// Traces the room again.
    fn trace(&mut self) {
        (self.room, self.cut, self.reachable, self.doors) = (None, None, None, None);
        (self.space, self.sweep) = (None, None);
        self.version += 1;
        self.fault.clear();
        self.mark = None;
        self.trace_room();
        self.askew = self.direction();
    }

    fn trace_room(&mut self) {
        let Some(metre) = self.settings.metre.filter(|_| !self.lacks_size()) else { return };
        let traced = self.traced(metre);
        match traced {
            Ok(traced) => {
                let free = free_cells(&traced.plan);
                self.floor = free.count() as f64 * traced.plan.resolution * traced.plan.resolution;
                let assumes_size = self.assumes_size();
                self.cut = cut_off(&traced.plan, &free).filter(|_| !assumes_size);
                let usual = robot::model(USUAL).filter(|_| self.cut.is_some());
                let reached = usual.and_then(|robot| ReachableFloor::new(&traced.plan, robot, None).ok());
                self.reachable = reached.map(|floor| floor.area());
                self.mark =
                    traced.leak.filter(|_| !assumes_size).map(|leak| FaultMark { at: leak.at, width: leak.width });
                self.room = Some(traced);
            }
            Err(error) => {
                let is_image = matches!(self.source, DrawingSource::Image { .. });
                (self.fault, self.mark) = told(&error, is_image);
            }
        }
        let now = self.room.as_ref().map(|room| (room, self.floor));
        let how = self.settings.tracing(metre);
        self.doors = match &self.source {
            DrawingSource::Drawing { drawing, .. } => {
                let trace = |how: &Tracing| floor_drawing::trace(drawing, how);
                Doors::of(trace, &how, now, |traced| free_floor(&traced.plan))
            }
            DrawingSource::Image { .. } => self.source.picture().and_then(|picture| {
                let how = Tracing { resolution: self.settings.image_resolution(metre), ..how };
                Doors::of(|how: &Tracing| trace_picture(&picture, how), &how, now, |traced| free_floor(&traced.plan))
            }),
            DrawingSource::Map { .. } => None,
        };
        if let (None, Some(doors @ 1..)) = (&self.room, self.doors.as_ref().map(|doors| doors.count)) {
            // The ring would be at the narrowest opening on the way outside, perhaps that of another room.
            self.mark = None;
            let doors = if doors == 1 { "door" } else { "doors" };
            self.fault = format!("This room isn't closed: close its {doors}, or choose a rectangle.");
        }
    }

    fn traced(&self, metre: f64) -> Result<Traced, DrawingError> {
        let (settings, turn) = (&self.settings, self.settings.turn.to_radians());
        match &self.source {
            DrawingSource::Drawing { drawing, .. } => {
                Ok(floor_drawing::trace(drawing, &settings.tracing(metre))?.turned(turn))
            }
            DrawingSource::Image { name, cells, .. }
                if settings.method == ShadeMethod::Map && settings.part == DrawingPart::Whole && turn == 0.0 =>
            {
                let plan = FloorPlan {
                    name: name.clone(),
                    note: String::new(),
                    resolution: metre,
                    occupancy: cells.clone(),
                    objects: Vec::new(),
                    start: None,
                    origin: Pose::new(0.0, 0.0, 0.0),
                };
                if plan.occupancy.values().iter().any(|cell| cell.is_free()) {
                    return Ok(Traced::of_map(plan, metre));
                }
                Err(nothing())
            }
            DrawingSource::Image { .. } => {
                let resolution = settings.image_resolution(metre);
                let how = Tracing { resolution, ..settings.tracing(metre) };
                let picture = self.source.picture().ok_or_else(nothing)?;
                let traced = trace_picture(&picture, &how)?;
                match self.assumed_outer(&traced) {
                    Some(outer) => trace_picture(&picture, &Tracing { region: settings.part.region(outer), ..how }),
                    None => Ok(traced),
                }
            }
            DrawingSource::Map { plan, .. } => Ok(Traced::of_map(scaled(plan, metre), metre)),
        }
    }

    /// The robot's outline, or its error.
    pub fn outline(&self) -> Result<Outline, String> {
        self.settings.body.outline().map_err(|error| error.to_string())
    }

    /// Plans the sweep of the room; `observe` receives the progress, 0 to 1, and returns whether to continue.
    pub fn sweep(&mut self, observe: &mut dyn FnMut(f64) -> ControlFlow<()>) -> Result<(), String> {
        let outline = self.outline()?;
        let Some(room) = &self.room else { return Err(self.no_room()) };
        let FloorPlanSettings { scan_width, cell, order, clearance, .. } = self.settings;
        let (start, turns) = (room.plan.start, self.settings.body.turns());
        let setup = SweepSetup { scan_width, start, order, turns, clearance, ..SweepSetup::new(outline, cell) };
        let planned = sweep(&room.plan, &setup, observe).map_err(|error: SweepError| error.to_string())?;
        let path = MetricPath::new(&planned.path).map_err(|error| error.to_string())?;
        let robot = self.robot()?;
        let heading = room.plan.start.filter(|_| turns).map_or(0.0, |start| start.heading);
        let start = Pose::new(path.start().x, path.start().y, heading);
        let floor = ReachableFloor::of_path(&room.plan, &robot, start).map_err(|error| error.to_string())?;
        self.driven = Some(DriveMetrics::of(&floor, &robot, path.corners()));
        self.sweep = Some(planned);
        Ok(())
    }

    /// The robot of Explore that drives the sweep: a model, or one with the outline that cleans all floor under it.
    fn robot(&self) -> Result<RobotModel, String> {
        let missing = || format!("the robot model {OWN_MODEL} is missing from this build");
        match self.settings.body.model() {
            Some(id) => robot::model(id).cloned().ok_or_else(missing),
            None => Ok(own_robot(self.outline()?).of(robot::model(OWN_MODEL).ok_or_else(missing)?)),
        }
    }

    /// Makes the obstacle map of all headings, if needed.
    pub fn make_space(&mut self) -> Result<&ConfigurationSpace, String> {
        if self.space.is_none() {
            let outline = self.outline()?;
            let Some(room) = &self.room else { return Err(self.no_room()) };
            let FloorPlanSettings { cell, headings, .. } = self.settings;
            let space = ConfigurationSpace::new(&room.plan, &outline, cell, headings);
            self.space = Some(space.map_err(|error| error.to_string())?);
        }
        self.space.as_ref().ok_or_else(String::new)
    }

    /// The import for Explore: the room, with the other choices of a scenario. If `sweeps` is set, with the planned sweep
    /// and the robot that it was planned for.
    pub fn import(&self, sweeps: bool) -> Result<Import, String> {
        let Some(room) = &self.room else { return Err(self.no_room()) };
        let choices = match &self.source {
            DrawingSource::Map { choices, .. } => choices.clone(),
            _ => None,
        };
        if !sweeps {
            return Ok(Import { plan: room.plan.clone(), choices });
        }
        let sweep = self.planned().ok_or("plan the sweep first")?;
        let path = MetricPath::new(&sweep.path).map_err(|error| error.to_string())?;
        let body = &self.settings.body;
        let own = if body.model().is_some() { None } else { Some(own_robot(self.outline()?)) };
        let choices = ScenarioChoices {
            planner: Some(PLANNER.to_owned()),
            behaviour: None,
            params: Vec::new(),
            path: Some(path.to_string()),
            robot: Some(body.model().unwrap_or(OWN_MODEL).to_owned()),
            own_robot: own.map(|own| own.to_string()),
            twin: None,
            cell_size: None,
            cell_offset: None,
            ..choices.unwrap_or_default()
        };
        Ok(Import { plan: room.plan.clone(), choices: Some(choices) })
    }

    /// Metres between the two scale points, if the drawing's unit is known.
    pub fn measured_m(&self) -> Option<f64> {
        Some(self.hand.measured()? * self.settings.metre?)
    }

    /// Scales the drawing so that the two scale points are `metres` apart.
    pub fn scale_to(&mut self, metres: f64) -> Result<(), String> {
        let units = self.hand.measured().ok_or("set two points first, then enter the distance between them")?;
        if !(metres > 0.0 && metres.is_finite()) {
            return Err(format!("the distance can't be {metres} m; enter a length greater than 0"));
        }
        self.set(FloorPlanSettings { metre: Some(metres / units), ..self.settings.clone() })?;
        self.hand.escape();
        self.hand.escape();
        Ok(())
    }

    fn no_room(&self) -> String {
        match (self.settings.metre, self.fault.is_empty()) {
            _ if self.lacks_size() => "choose the size of the drawing first".to_owned(),
            (None, _) => "choose the unit of the drawing first".to_owned(),
            (_, false) => self.fault.clone(),
            _ => "there is no room yet".to_owned(),
        }
    }
}

/// The robot with that outline, which cleans all floor under it as in 001.
fn own_robot(outline: Outline) -> OwnRobot {
    let (radius, corners) = match outline {
        Outline::Circle { radius } => (Some(radius), Vec::new()),
        Outline::Polygon(corners) => (None, corners.into_iter().map(|corner| corner.coords.into()).collect()),
    };
    OwnRobot { radius, corners, cleans_all: true, ..OwnRobot::default() }
}

/// The error for someone who sees the file, and the place that it is about.
fn told(error: &DrawingError, is_image: bool) -> (String, Option<FaultMark>) {
    let DrawingError::Bad { flaw, .. } = error else { return (error.to_string(), None) };
    match **flaw {
        DrawingFlaw::Leak { x, y, width } => {
            let words = if width <= MOST_GAP {
                format!(
                    "This room isn't closed: it has an opening at most {width:.2} m wide, where the ring is. Close gaps \
                     up to {width:.2} m, or choose a rectangle."
                )
            } else {
                "This room isn't closed: it has a wide opening, where the ring is. Choose Indoors or a rectangle."
                    .to_owned()
            };
            (words, Some(FaultMark { at: Point::new(x, y), width }))
        }
        DrawingFlaw::NotFloor { what, x, y } => {
            let words = format!("There is {what} where you clicked. Click on free floor, or use smaller cells.");
            (words, Some(FaultMark { at: Point::new(x, y), width: 0.0 }))
        }
        DrawingFlaw::NoFloor if is_image => {
            ("No floor is left. Read the walls in another way, or choose another part.".to_owned(), None)
        }
        _ => (error.to_string(), None),
    }
}

fn nothing() -> DrawingError {
    DrawingError::Bad { name: String::new(), place: String::new(), flaw: Box::new(DrawingFlaw::NoFloor) }
}

/// Runs all stages of a sweep, collisions and strokes along edges included, in a tiny room.
pub fn warm_up() {
    let plan = Sketch::open(4.0, 4.0, 0.1).fill(&[[1.0, 2.1, 3.0, 2.75]]).disc(1.5, 1.0, 0.3).finish("", "");
    let Ok(outline) = Outline::octagon(0.4) else { return };
    let setup = SweepSetup::new(outline, 0.1);
    let _ = sweep(&plan, &setup, &mut |_| ControlFlow::Continue(()));
}

/// Floor without objects, m².
fn free_floor(plan: &FloorPlan) -> f64 {
    free_cells(plan).count() as f64 * plan.resolution * plan.resolution
}

/// Floor without objects, by the centres of the cells.
fn free_cells(plan: &FloorPlan) -> Grid<bool> {
    let mut free = plan.occupancy.map(|cell| cell.is_free());
    let mut take = |low: Point, high: Point, holds: &dyn Fn(Point) -> bool| {
        let (low, high) = (plan.cell_at(low), plan.cell_at(high));
        for y in low.y.max(0)..=high.y.min(free.height() as i32 - 1) {
            for x in low.x.max(0)..=high.x.min(free.width() as i32 - 1) {
                let cell = Cell::new(x, y);
                free[cell] &= !holds(plan.centre(cell));
            }
        }
    };
    for object in &plan.objects {
        match object {
            Object::Furniture { outline } | Object::DropOff { outline } => {
                let first = outline.first().copied().unwrap_or_else(Point::origin);
                let (low, high) = outline.iter().fold((first, first), |(low, high), point| {
                    (low.coords.inf(&point.coords).into(), high.coords.sup(&point.coords).into())
                });
                take(low, high, &|at| contains(outline, at));
            }
            Object::Leg { at, radius } => {
                let reach = Vector::new(*radius, *radius);
                take(at - reach, at + reach, &|place| (place - at).norm() <= *radius);
            }
            _ => {}
        }
    }
    free
}

/// A map whose cells are `metre` wide, with its start at the same place in the picture.
fn scaled(plan: &FloorPlan, metre: f64) -> FloorPlan {
    let factor = metre / plan.resolution;
    let start = plan.start.map(|start| Pose::new(start.x * factor, start.y * factor, start.heading));
    FloorPlan { resolution: metre, start, ..plan.clone() }
}
