//! View model of the Floor plan tab, as one plain object.

use super::{
    Doors, DrawingPart, DrawingSession, DrawingSource, DrawingTool, FloorPlanSettings, UNITS, paper_units,
    settings::MOST_OUTER, size_in_words,
};
use crate::amount::{amount, grouped};
use coverage_planners::{metrics::DriveMetrics, stage::LineEndContact, sweep::Sweep};
use floor_drawing::{FreeStandingBuilding, OUTER_DOOR, OutsideLeak, Role};
use robovac_core::{cspace::Outline, geometry::Point};
use serde::Serialize;

/// What is said of openings that were closed, and can be left open.
const INDOORS: &str = "Outer doors are closed, so a robot stays indoors.";
/// Lengths of a floor plan's longer side, m, that nobody is asked about (ours): from a closet to a house.
const USUAL: [f64; 2] = [2.0, 60.0];
/// Floors of flats and houses, m², likewise, where the file doesn't state its unit.
const USUAL_FLOOR: [f64; 2] = [5.0, 500.0];

fn is_usual(longer_side: f64) -> bool {
    (USUAL[0]..=USUAL[1]).contains(&longer_side)
}

/// Snapshot of a drawing session.
// Independent facts, not states of one.
#[allow(clippy::struct_excessive_bools)]
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct DrawingView {
    /// Its name.
    pub name: String,
    /// `drawing`, `image` or `map`.
    #[cfg_attr(feature = "types", ts(type = "\"drawing\" | \"image\" | \"map\""))]
    pub kind: &'static str,
    /// Whether a file states its unit.
    pub says_unit: bool,
    /// Pixels of the file on a side of one that is shown: more than 1 for a picture that was reduced.
    pub reduced: usize,
    /// The size of the file then, in words; empty otherwise.
    pub reduced_from: String,
    /// Whether it can be scaled.
    pub is_scalable: bool,
    /// Size of the source, in words, if known.
    pub size: Option<String>,
    /// The units in the menu, with the size that the source would have in each.
    pub units: Vec<UnitView>,
    /// Whether a room's cells can be chosen: an image's pixels are finer than they.
    pub has_cells: bool,
    /// Whether a picture's size is only assumed.
    pub assumes_size: bool,
    /// The side of a pixel of an image's file that is assumed, in words; empty once another is chosen.
    pub assumed_pixel: String,
    /// Width of outer doors, m, up to which openings to the outside are closed at first.
    pub outer_door: f64,
    /// A size that is unusual for a room, in words, until it is confirmed; empty otherwise.
    pub asks: String,
    /// The scales of a plan on paper that would give a usual size, while the size is asked about.
    pub papers: Vec<UnitView>,
    /// Angle by which the walls are askew, degrees; `None` if they are straight or have no common direction.
    pub askew: Option<f64>,
    /// Layers of a drawing.
    pub layers: Vec<LayerView>,
    /// Number of strokes of a drawing.
    pub strokes: usize,
    /// Content that isn't drawn.
    pub left_out: Vec<String>,
    /// Its settings.
    pub settings: FloorPlanSettings,
    /// The room, if there is one.
    pub room: Option<TracedRoomView>,
    /// Open doors through which a chosen room extends.
    pub doors: Option<Doors>,
    /// The width up to which openings to the outside have to be closed, m, so that the one that the notice is about is.
    pub closes: Option<f64>,
    /// Whether the notice is about openings that were closed, and can be left open.
    pub opens: bool,
    /// What can be wrong with the room, in words; empty for nothing.
    pub notice: String,
    /// Why there is no room; empty if there is one or the user has yet to choose.
    pub fault: String,
    /// The tool for clicks.
    pub tool: DrawingTool,
    /// Number of points set.
    pub points: usize,
    /// Whether two scale points are set.
    pub is_measured: bool,
    /// Their present distance, m.
    pub measured_m: Option<f64>,
    /// Width of the robot, m; `None` if it is invalid.
    pub body_width: Option<f64>,
    /// Corners of its outline for a small picture, m; x ahead, y to the left. Empty for a circle.
    pub body: Vec<[f64; 2]>,
    /// Error of the robot's outline.
    pub body_fault: String,
    /// The sweep, once planned.
    pub sweep: Option<SweepView>,
    /// One or two sentences that describe the picture.
    pub words: String,
}

/// Snapshot of a floor plan, and of the displayed part of its sweep.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct FloorPlanView {
    /// The floor plan.
    #[serde(flatten)]
    pub plan: DrawingView,
    /// Time taken to plan the sweep, s.
    pub seconds: f64,
    /// Displayed stage of the sweep, 0 for none.
    pub stage: u8,
    /// Heading of the displayed slice, -1 for none.
    pub slice: i32,
}

/// A unit in the menu.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct UnitView {
    /// Its name.
    pub name: String,
    /// Metres per unit.
    pub metre: f64,
    /// The size that the drawing would have.
    pub size: String,
}

/// A layer.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct LayerView {
    /// Its name.
    pub name: String,
    /// `#rrggbb`, as in the file.
    pub colour: String,
    /// Number of strokes.
    pub strokes: usize,
    /// Its role.
    pub role: Role,
}

/// The resulting room.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct TracedRoomView {
    /// Width of its floor, without walls, m.
    pub width_m: f64,
    /// Height of its floor, m.
    pub height_m: f64,
    /// Columns and rows.
    pub cells: [usize; 2],
    /// Floor without objects, m².
    pub floor_m2: f64,
    /// Side of a cell, m.
    pub resolution: f64,
    /// Number of objects.
    pub objects: usize,
    /// Gaps that were closed.
    pub gaps: usize,
    /// Those of them that are wider than was asked for: openings to the outside, indoors.
    pub outer_doors: usize,
    /// Floor round the building that is left out, m².
    pub around_m2: f64,
    /// Floor that a robot can't get to, m²; 0 if it is hardly any.
    pub cut_off_m2: f64,
    /// Floor that the brush of a Roomba reaches, m², as Explore counts it, if it can't get to some.
    pub reachable_m2: Option<f64>,
}

/// Results of a sweep.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct SweepView {
    /// Subgoals in all, then by contact: left and right wall, left and right obstacle.
    pub subgoals: [usize; 5],
    /// Links.
    pub links: usize,
    /// Links whose straight way collides.
    pub collisions: usize,
    /// Of these, those with a detour.
    pub resolved: usize,
    /// How often the ways of links cross each other.
    pub crossings: usize,
    /// Crossings and length, m, in the order *nearest*, for another one.
    pub nearest: Option<(usize, f64)>,
    /// Length of the path, m.
    pub length: f64,
    /// Strokes of the last stage, and their length with the ways there, m.
    pub finish: (usize, f64),
    /// Share of the reachable floor that is swept by the links, 0 to 1.
    pub linked_share: f64,
    /// Share of the reachable floor that is swept, 0 to 1.
    pub coverage: f64,
    /// The same by the finer cells of Explore, and the time, s: what a run without slip gives there.
    pub driven: (f64, f64),
    /// What is kept free, if it isn't the outline.
    pub kept_free: Option<String>,
    /// Distance between scan lines, m.
    pub scan_width: f64,
}

impl DrawingSession {
    /// The snapshot of this session.
    pub fn view(&self) -> DrawingView {
        let (source, settings) = (self.source(), self.settings());
        let (_, size) = source.extent();
        let asks = self.asks().unwrap_or_default();
        let papers = || paper_units(source).into_iter().filter(|(_, metre)| is_usual(size.max() * metre));
        let unit_view = |(name, metre): (String, f64)| UnitView {
            name,
            metre,
            size: size_in_words(size.x * metre, size.y * metre),
        };
        let drawing = source.drawing();
        let outline = self.outline();
        let mut view = DrawingView {
            name: source.name().to_owned(),
            kind: match source {
                DrawingSource::Drawing { .. } => "drawing",
                DrawingSource::Image { .. } => "image",
                DrawingSource::Map { .. } => "map",
            },
            says_unit: !matches!(source, DrawingSource::Image { .. }) && source.metre().is_some(),
            reduced: source.reduced().map_or(1, |(times, _)| times),
            reduced_from: source.reduced().map_or(String::new(), |(_, [x, y])| format!("{x} × {y} pixels")),
            is_scalable: source.is_scalable(),
            size: settings.metre.map(|metre| size_in_words(size.x * metre, size.y * metre)),
            units: UNITS
                .iter()
                .filter(|_| drawing.is_some())
                .map(|unit| (unit.name.to_owned(), unit.metre))
                .chain(papers())
                .map(unit_view)
                .collect(),
            has_cells: drawing.is_some()
                || matches!(source, DrawingSource::Image { .. })
                    && settings.metre.is_some_and(|metre| settings.has_fine_pixels(metre)),
            papers: papers()
                .filter(|_| !asks.is_empty())
                .map(|(name, metre)| unit_view((name.replace("on paper, ", "").replace(" sheet,", ""), metre)))
                .collect(),
            assumes_size: self.assumes_size(),
            assumed_pixel: self.assumed_pixel(),
            outer_door: OUTER_DOOR,
            asks,
            askew: self.askew(),
            layers: drawing.map_or(Vec::new(), |drawing| {
                let with_role = drawing.layers.iter().zip(&settings.roles);
                with_role.map(|(layer, &role)| layer_view(layer, role)).collect()
            }),
            strokes: drawing.map_or(0, |drawing| drawing.strokes.len()),
            left_out: drawing.map_or(Vec::new(), |drawing| drawing.left_out.clone()),
            settings: settings.clone(),
            room: self.room_view(),
            doors: self.doors().cloned(),
            closes: self.leak_that_closes().map(|leak| leak.width).or(self.left_open().then_some(OUTER_DOOR)),
            opens: self.notice() == INDOORS,
            notice: self.notice(),
            fault: self.fault().to_owned(),
            tool: self.hand.tool,
            points: self.hand.points.len(),
            is_measured: self.hand.measured().is_some(),
            measured_m: self.measured_m(),
            body_width: outline.as_ref().ok().map(Outline::width),
            body: match &outline {
                Ok(Outline::Polygon(corners)) => corners.iter().map(|&Point { coords }| coords.into()).collect(),
                _ => Vec::new(),
            },
            body_fault: outline.err().unwrap_or_default(),
            sweep: self.planned().map(|sweep| sweep_view(sweep, self.outline().ok().as_ref(), self.driven())),
            words: String::new(),
        };
        view.words = description(&view);
        view
    }

    /// The size of the room, or of all of it where there is none, if nobody has confirmed that it is so large or small, or
    /// if a picture's scale is assumed.
    fn asks(&self) -> Option<String> {
        let (settings, whole) = (self.settings(), self.source().extent().1);
        let metre = settings.metre?;
        if matches!(self.source(), DrawingSource::Map { .. }) || settings.confirmed == Some(metre) {
            return None;
        }
        let (width, height) = (whole.x * metre, whole.y * metre);
        // There can be floor around what walls don't enclose.
        let is_tiny = width.max(height) < USUAL[0];
        let room = self.room().filter(|_| !is_tiny).map(|room| room.plan.floor_size().into());
        let (width, height) = room.unwrap_or((width, height));
        let size = size_in_words(width, height);
        if !is_usual(width.max(height)) || self.assumes_size() {
            return Some(size);
        }
        // A part can be small.
        let is_stated = self.source().drawing().is_some_and(|drawing| drawing.metre.is_some());
        let floor = self.floor_m2();
        let is_odd = room.is_some()
            && settings.part == DrawingPart::Indoors
            && !(USUAL_FLOOR[0]..=USUAL_FLOOR[1]).contains(&floor);
        (is_odd && !is_stated).then(|| format!("{size}, with {} m² of floor", grouped(floor.round() as usize)))
    }

    fn assumed_pixel(&self) -> String {
        let source = self.source();
        let is_image = matches!(source, DrawingSource::Image { .. });
        let metre = self.settings().metre.filter(|&metre| is_image && source.metre() == Some(metre));
        let times = source.reduced().map_or(1, |(times, _)| times) as f64;
        metre.map_or_else(String::new, |metre| format!("{}\u{a0}cm", (10_000.0 * metre / times).round() / 100.0))
    }

    fn room_view(&self) -> Option<TracedRoomView> {
        let room = self.room()?;
        let (plan, cells) = (&room.plan, &room.plan.occupancy);
        let [width_m, height_m] = plan.floor_size();
        let is_wide = |[a, b]: &&[Point; 2]| (*b - *a).norm() > self.settings().gap;
        let is_cut = !matches!(self.settings().part, DrawingPart::Indoors | DrawingPart::Whole);
        Some(TracedRoomView {
            width_m,
            height_m,
            cells: [cells.width(), cells.height()],
            floor_m2: self.floor_m2(),
            resolution: plan.resolution,
            objects: plan.objects.len(),
            gaps: room.gaps.len(),
            outer_doors: room.gaps.iter().filter(|gap| !is_cut && is_wide(gap)).count(),
            around_m2: room.around_m2,
            cut_off_m2: self.cut_off().map_or(0.0, |(_, area)| *area),
            reachable_m2: self.reachable_m2(),
        })
    }

    /// The opening to the outside, if it can be closed.
    fn leak_that_closes(&self) -> Option<OutsideLeak> {
        self.room().filter(|_| !self.assumes_size())?.leak.filter(|leak| leak.closes && leak.width <= MOST_OUTER)
    }

    /// Whether openings to the outside were closed of a drawing all of which counts.
    fn keeps_indoors(&self) -> bool {
        self.settings().part == DrawingPart::Whole && self.room_view().is_some_and(|room| room.outer_doors > 0)
    }

    /// Whether a robot gets out because openings aren't to be closed.
    fn left_open(&self) -> bool {
        self.settings().outer == 0.0 && self.room().is_some_and(|room| room.goes_out)
    }

    /// What is in doubt about the room, in words.
    fn notice(&self) -> String {
        let Some(room) = self.room() else { return String::new() };
        if let Some(OutsideLeak { width, floor_m2, to_garden, .. }) = room.leak {
            if self.assumes_size() {
                return String::new();
            }
            let mend = match self.leak_that_closes() {
                Some(_) => "",
                None => " Check the size; if it is right, choose Rectangle or Polygon.",
            };
            let counts = if room.is_open || to_garden {
                "so the outside counts as floor, too"
            } else {
                "so they don't count as floor"
            };
            let floor_m2 = grouped(floor_m2.round() as usize);
            return format!(
                "About {floor_m2} m² are open to the outside through an opening about {width:.2} m wide, where the ring \
                 is, {counts}.{mend}"
            );
        }
        if let Some(building) = room.free_standing.filter(|_| !self.assumes_size()) {
            return beside(building);
        }
        if self.keeps_indoors() {
            return INDOORS.to_owned();
        }
        if room.goes_out && !self.assumes_size() {
            return "The floor round the building counts, too, and a robot gets out to it through an opening in the walls. \
                    Indoors takes only the floor within the walls."
                .to_owned();
        }
        let notice = match self.source() {
            _ if !room.is_open => "",
            DrawingSource::Image { .. } => {
                "No walls that enclose floor were found, so all of the picture counts as floor. Read the walls in \
                 another way, or choose Rectangle or Polygon."
            }
            _ => {
                "The walls enclose hardly any floor, so all of the drawing counts as floor. Set the layers of its \
                 walls to Wall, close wider gaps, or choose Rectangle or Polygon."
            }
        };
        notice.to_owned()
    }
}

/// What is in doubt about a building that stands free within walls, in words.
fn beside(building: FreeStandingBuilding) -> String {
    let floor_m2 = grouped(building.floor_m2.round() as usize);
    if building.is_taken {
        return format!(
            "A building of about {floor_m2} m² stands free within the outermost walls. Only its floor counts, as for a \
             house in its garden. If it is all one building, choose Whole, and open its doors there."
        );
    }
    format!(
        "A building of about {floor_m2} m² stands free within the outermost walls. All floor counts, and the robot starts \
         in the building. If it is a house in its garden, choose Rectangle or Polygon, or click a room with This room."
    )
}

/// Description of the picture for screen readers.
fn description(view: &DrawingView) -> String {
    let mut words = format!("Floor plan {}", view.name);
    let mut say = |text: String| {
        words.push_str(", ");
        words.push_str(&text);
    };
    if view.kind == "drawing" {
        let walls = view.layers.iter().filter(|layer| layer.role == Role::Wall).count();
        let (strokes, layers) = (amount(view.strokes as i64, "stroke"), amount(view.layers.len() as i64, "layer"));
        say(format!("{strokes} on {layers}, walls on {walls} of them"));
    }
    match (&view.size, &view.room) {
        (None, _) => say("unit not chosen yet".to_owned()),
        (Some(size), None) if view.fault.is_empty() => say(format!("{size} overall; no room yet")),
        (Some(size), None) => {
            say(format!("{size} overall; no room could be traced: {}", view.fault.trim_end_matches('.')));
        }
        (Some(size), Some(room)) if view.assumes_size => say(format!(
            "{size} overall, and the floor {}, if the assumed scale is right",
            size_in_words(room.width_m, room.height_m)
        )),
        (Some(size), Some(room)) => {
            say(format!(
                "{size} overall; the floor is {} with {:.1} free square metres",
                size_in_words(room.width_m, room.height_m),
                room.floor_m2
            ));
            let gaps = room.gaps - room.outer_doors;
            let counts = [(room.objects, "obstacle"), (gaps, "closed gap"), (room.outer_doors, "closed outer opening")];
            for (count, what) in counts {
                if count > 0 {
                    say(amount(count as i64, what));
                }
            }
            if room.cut_off_m2 > 0.0 {
                say(format!("a robot can't get to {:.1} square metres of it", room.cut_off_m2));
            }
            if room.around_m2 > 0.0 {
                say(format!("{:.1} square metres round the building are left out", room.around_m2));
            }
        }
    }
    if let Some(Doors { count, gap, floor_m2, .. }) = &view.doors {
        let openings = if *count <= 1 { "an opening".to_owned() } else { format!("{count} openings") };
        say(format!(
            "it extends through {openings} as wide as a door; closing gaps up to {gap:.2} metres leaves \
             {floor_m2:.1} square metres"
        ));
    }
    if let Some(sweep) = &view.sweep {
        say(format!(
            "a sweep of {:.1} metres with {}, collisions resolved: {} of {}, {}",
            sweep.length,
            amount(sweep.subgoals[0] as i64, "subgoal"),
            sweep.resolved,
            sweep.collisions,
            amount(sweep.crossings as i64, "crossing")
        ));
    }
    words.push('.');
    words
}

fn layer_view(layer: &floor_drawing::DrawingLayer, role: Role) -> LayerView {
    let [red, green, blue] = layer.colour;
    LayerView {
        name: layer.name.clone(),
        colour: format!("#{red:02x}{green:02x}{blue:02x}"),
        strokes: layer.strokes,
        role,
    }
}

fn sweep_view(sweep: &Sweep, outline: Option<&Outline>, driven: Option<&DriveMetrics>) -> SweepView {
    let count = |contact| sweep.subgoals.iter().filter(|subgoal| subgoal.contact == contact).count();
    SweepView {
        subgoals: [
            sweep.subgoals.len(),
            count(LineEndContact::LeftWall),
            count(LineEndContact::RightWall),
            count(LineEndContact::LeftObstacle),
            count(LineEndContact::RightObstacle),
        ],
        links: sweep.links.len(),
        collisions: sweep.collisions,
        resolved: sweep.resolved,
        crossings: sweep.crossings,
        nearest: sweep.nearest.map(|cost| (cost.crossings, cost.length)),
        length: sweep.length,
        finish: (sweep.finish.len(), sweep.finish_length),
        linked_share: sweep.linked_share,
        coverage: sweep.coverage,
        driven: driven.map_or((0.0, 0.0), |drive| (drive.coverage, drive.duration_s)),
        kept_free: (outline != Some(&sweep.outline)).then(|| sweep.outline.to_string()),
        scan_width: sweep.scan_width,
    }
}
