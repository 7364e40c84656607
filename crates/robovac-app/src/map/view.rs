//! View model of the Map tab's numbers and texts: one snapshot per frame.

use super::{MapAction, MapErrorFigures, MapPhase, MapProgramView, MapSession};
use robovac_sim::{Conditions, Run, mapping::CellMark};
use serde::Serialize;

/// Snapshot of a mapping run. SI units; shares from 0 to 1.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct MapView {
    /// Phase of the run.
    pub phase: MapPhase,
    /// Actions that are allowed now.
    pub can: MapActions,
    /// Why the robot can't be placed in the room, or the program can't drive it; empty if it can.
    pub complaint: String,
    /// Name of the room.
    pub title: String,
    /// Id of the behaviour.
    pub behaviour: &'static str,
    /// The user's program, if that is the method.
    pub program: Option<MapProgramView>,
    /// The robot's activity, in a few words.
    pub activity: &'static str,
    /// Its parameters.
    pub params: robovac_core::registry::Params,
    /// How the robot estimates its pose.
    pub tracking: &'static str,
    /// What to expect of the robot's maps, if it has nothing but a bumper, or lacks what the method needs;
    /// else empty.
    pub expectation: String,
    /// How wheel counts are converted to motion.
    pub counts: &'static str,
    /// Level of wheel slip.
    pub wheels: &'static str,
    /// Level of sensor noise; empty if the kinds differ.
    pub senses: String,
    /// The grid that is shown, measured and exported.
    pub grid: &'static str,
    /// Layers that are shown.
    pub layers: Vec<&'static str>,
    /// Set speed, times real time; 0 for as fast as possible.
    pub speed: f64,
    /// Achieved speed, times real time.
    pub speed_factor: f64,
    /// Displayed time, s.
    pub time_s: f64,
    /// Furthest simulated time, s.
    pub end_s: f64,
    /// Progress of restoring a stored run; `None` if none is being restored.
    pub returned: Option<f64>,
    /// Errors of the map.
    pub figures: Option<MapErrorFigures>,
    /// Errors of a map by odometry alone.
    pub odometry: Option<MapErrorFigures>,
    /// Errors of dead reckoning, one for each odometry model in the order of their registry: m and degrees.
    pub drifts: Vec<[f64; 2]>,
    /// Standard deviations of the estimate: along the longer axis of the ellipse (m), and heading (degrees).
    pub spread: Option<[f64; 2]>,
    /// Name of the map given to the robot; `None` if it makes its own.
    pub known: Option<String>,
    /// Whether it has relocalised on that map; `None` if it was never lost.
    pub is_sure: Option<bool>,
    /// Id of the planner for the remaining floor.
    pub planner: &'static str,
    /// Number of frontiers.
    pub frontiers: usize,
    /// Whether it follows a route.
    pub has_route: bool,
    /// Whether it cleans by its map.
    pub is_cleaning: bool,
    /// Floor reachable by its map that it has swept by its estimate, and all floor reachable by its map, m²; `None`
    /// unless it cleans by a map.
    pub by_map: Option<[f64; 2]>,
    /// Floor cleaned by the robot's own estimate, m².
    pub cleaned_m2: f64,
    /// Swept share of the reachable floor.
    pub coverage: f64,
    /// Area where it has found dirt, m².
    pub dirt_m2: f64,
    /// Number of samples of the curve; changes with them.
    pub samples: usize,
    /// Changes whenever another run, or another time of it, is displayed.
    pub version: f64,
    /// Whether the robot is held on the picture; not part of the session.
    pub is_carried: bool,
}

/// Actions that are allowed now.
#[expect(clippy::struct_excessive_bools)]
#[derive(Debug, Clone, Copy, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct MapActions {
    /// Start or continue.
    pub play: bool,
    /// Pause.
    pub pause: bool,
    /// Advance by a few seconds.
    pub step: bool,
    /// Seek another time.
    pub seek: bool,
    /// Pick the robot up.
    pub lift: bool,
    /// Put it down.
    pub put_down: bool,
    /// Start again.
    pub forget: bool,
    /// Export the map.
    pub use_map: bool,
    /// Clean by the map.
    pub clean: bool,
    /// Give the robot a map.
    pub open: bool,
}

impl MapSession {
    /// The snapshot of this session.
    pub fn view(&self) -> MapView {
        let can = |deed| self.can(deed);
        let setup = self.setup();
        let there = self.base.as_ref().map_or(Conditions::default(), |base| base.conditions);
        let conditions = setup.conditions(there);
        let run = self.run();
        let figures = self.figures();
        let estimate = self.estimate();
        let intent = self.intent();
        let reach = intent.filter(|intent| intent.reach.is_some());
        let area = |mark| {
            estimate.map_or(0.0, |estimate| {
                let side = estimate.marks.resolution();
                estimate.marks.cells(mark).count() as f64 * side * side
            })
        };
        let spread = estimate
            // A single covariance says little about several clouds of particles.
            .filter(|estimate| estimate.is_sure() != Some(false))
            .and_then(|estimate| estimate.pose_covariance())
            .map(|spread| [spread.ellipse().0[0], spread.heading.to_degrees()]);
        MapView {
            phase: self.phase(),
            can: MapActions {
                play: can(MapAction::Play),
                pause: can(MapAction::Pause),
                step: can(MapAction::Step),
                seek: can(MapAction::Seek),
                lift: can(MapAction::Lift),
                put_down: can(MapAction::PutDown),
                forget: can(MapAction::Forget),
                use_map: can(MapAction::UseMap) && self.shown().is_some_and(|map| map.bounds().is_some()),
                clean: self.can_clean(),
                open: can(MapAction::Open),
            },
            complaint: self.complaint(),
            title: self.base.as_ref().map_or(String::new(), |base| base.title.clone()),
            behaviour: setup.behaviour.id,
            program: self.program_view(),
            activity: run.map_or("", |run| if run.waits() { "waiting for the program" } else { run.activity() }),
            params: setup.params.clone(),
            tracking: setup.tracking.id(),
            expectation: self.expectation().unwrap_or_default(),
            counts: setup.odometry.id(),
            wheels: conditions.slip.id(),
            senses: conditions.noise.to_string(),
            grid: setup.grid.id(),
            layers: setup.layers.names(),
            speed: setup.speed,
            speed_factor: self.pacer.speed_factor(),
            time_s: run.map_or(0.0, Run::time_s),
            end_s: self.stage.as_ref().map_or(0.0, |stage| stage.recording.end_s()),
            returned: self.returned(),
            figures: figures.map(|[here, _]| here),
            odometry: figures.map(|[_, odometry]| odometry),
            drifts: run.map_or_else(Vec::new, |run| {
                run.drifts().into_iter().map(|[off, turned]| [off, turned.to_degrees()]).collect()
            }),
            spread,
            known: self.known.as_ref().map(|known| known.name().to_owned()),
            is_sure: estimate.and_then(|estimate| estimate.is_sure()),
            planner: setup.planner.id,
            frontiers: intent.map_or(0, |intent| intent.frontiers.len()),
            has_route: intent.is_some_and(|intent| !intent.route.is_empty()),
            is_cleaning: reach.is_some(),
            by_map: reach.zip(estimate).and_then(|(intent, estimate)| intent.swept(estimate.marks)),
            cleaned_m2: area(CellMark::Cleaned),
            coverage: run.map_or(0.0, Run::coverage),
            dirt_m2: area(CellMark::Dirty),
            samples: self.samples().len(),
            version: self.version() as f64,
            is_carried: false,
        }
    }
}
