//! View model of the Map tab's numbers and texts: one snapshot a frame.

use super::{MapAction, MapErrorFigures, MapPhase, MapSession};
use robovac_sim::{Conditions, Run, mapping::Mark};
use serde::Serialize;

/// Snapshot of a survey. SI units; shares from 0 to 1.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct MapView {
    /// What the survey is doing.
    pub phase: MapPhase,
    /// What the user may do.
    pub can: MapActions,
    /// Why the robot can't be put into the room; empty if it can.
    pub complaint: String,
    /// Name of the room.
    pub title: String,
    /// Id of the behaviour.
    pub behaviour: &'static str,
    /// What the robot is doing, in a few words.
    pub activity: &'static str,
    /// Its parameters.
    pub params: robovac_core::registry::Params,
    /// How the robot keeps track of itself.
    pub tracking: &'static str,
    /// How wheel counts become motion.
    pub counts: &'static str,
    /// How well the wheels hold.
    pub wheels: &'static str,
    /// How much the sensors err; empty if each kind errs otherwise.
    pub senses: String,
    /// Layers that are shown.
    pub layers: Vec<&'static str>,
    /// Speed asked for, times real time; 0 for as fast as it goes.
    pub speed: f64,
    /// Speed reached lately, times real time.
    pub speed_factor: f64,
    /// Time shown, s.
    pub time_s: f64,
    /// Furthest simulated time, s.
    pub end_s: f64,
    /// How far the way back to a survey that was left is done; `None` if there is none.
    pub returned: Option<f64>,
    /// Figures of the map.
    pub figures: Option<MapErrorFigures>,
    /// Figures of a map by odometry alone.
    pub odometry: Option<MapErrorFigures>,
    /// How far off dead reckoning would be, one for each odometry model in the order of their registry: m and degrees.
    pub drifts: Vec<[f64; 2]>,
    /// Standard deviations that the robot believes in: along the longer axis of the ellipse (m), and heading (degrees).
    pub spread: Option<[f64; 2]>,
    /// Name of the map that the robot was given; `None` if it makes its own.
    pub known: Option<String>,
    /// Whether it is sure of its place on that; `None` if it was never lost.
    pub is_sure: Option<bool>,
    /// Id of the planner of what is left.
    pub planner: &'static str,
    /// Pieces of unknown floor that it could go for.
    pub frontiers: usize,
    /// Whether it is driving along a line to somewhere.
    pub has_route: bool,
    /// Whether it cleans by its map.
    pub is_cleaning: bool,
    /// Floor that it can get to by its map and believes to have swept, and all that it can get to, m²; `None` unless it cleans
    /// by that.
    pub by_map: Option<[f64; 2]>,
    /// Floor cleaned by the robot's own estimate, m².
    pub cleaned_m2: f64,
    /// Share of the reachable floor that it really has cleaned.
    pub coverage: f64,
    /// Places where it has found dirt, m².
    pub dirt_m2: f64,
    /// Number of samples of the curve; grows or shrinks with them.
    pub samples: usize,
    /// Changes whenever another run, or another moment of it, is shown.
    pub version: f64,
    /// Whether a hand holds the robot on the picture, which the session doesn't know.
    pub is_carried: bool,
}

/// What the user may do now.
#[expect(clippy::struct_excessive_bools)]
#[derive(Debug, Clone, Copy, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct MapActions {
    /// Let time go on.
    pub play: bool,
    /// Stop time.
    pub pause: bool,
    /// Go on by a few seconds.
    pub step: bool,
    /// Go to another point of time.
    pub seek: bool,
    /// Pick the robot up.
    pub lift: bool,
    /// Put it down.
    pub put_down: bool,
    /// Begin anew.
    pub forget: bool,
    /// Take the map away.
    pub use_map: bool,
    /// Let it clean by its map.
    pub clean: bool,
    /// Give the robot a map.
    pub open: bool,
}

impl MapSession {
    /// What the page shows now.
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
            // Who only guesses is sure of nothing: one cloud of many says little.
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
                use_map: can(MapAction::UseMap) && estimate.is_some_and(|estimate| estimate.map.bounds().is_some()),
                clean: self.can_clean(),
                open: can(MapAction::Open),
            },
            complaint: self.complaint().to_owned(),
            title: self.base.as_ref().map_or(String::new(), |base| base.title.clone()),
            behaviour: setup.behaviour.id,
            activity: run.map_or("", |run| run.activity()),
            params: setup.params.clone(),
            tracking: setup.tracking.id(),
            counts: setup.odometry.id(),
            wheels: conditions.slip.id(),
            senses: conditions.noise.to_string(),
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
            cleaned_m2: area(Mark::Cleaned),
            coverage: run.map_or(0.0, Run::coverage),
            dirt_m2: area(Mark::Dirty),
            samples: self.samples().len(),
            version: self.version() as f64,
            is_carried: false,
        }
    }
}
