//! A mapping run that can be rewound.

use super::{CurveSample, Known, MapErrorFigures, MapEstimate, RoomTruth, Stored, curve::Curve, store::StoredMap};
use robovac_sim::{Input, Run, RunRecording, STEP_S};

/// A mapping run with its given map and error figures.
pub(super) struct MapStage {
    pub recording: RunRecording,
    pub truth: RoomTruth,
    /// The map given to the robot.
    pub known: Option<Known>,
    pub curve: Curve,
    /// Errors of the map, and of a map by odometry alone, with the number of steps at which they were computed.
    pub figures: [MapErrorFigures; 2],
    /// Errors of the thesis' grid, if it is made.
    pub thesis: Option<MapErrorFigures>,
    counted: Option<u64>,
    /// The stored state, while the run is restored.
    pub returning: Option<Return>,
}

/// A run being restored.
pub(super) struct Return {
    pub still: StoredMap,
    pub end: u64,
    shown: u64,
    digest: u64,
    is_seeking: bool,
}

impl Return {
    /// The start of restoring a stored run.
    pub fn to(Stored { end, shown, digest, map, marks, pose, .. }: Stored) -> Self {
        Self { still: StoredMap { map, marks, pose }, end, shown, digest, is_seeking: false }
    }
}

impl MapStage {
    /// A run at its start.
    pub fn new(run: Run, truth: RoomTruth, known: Option<Known>) -> Self {
        let mut stage = Self {
            recording: RunRecording::new(run),
            truth,
            known,
            curve: Curve::new(),
            figures: [MapErrorFigures::default(); 2],
            thesis: None,
            counted: None,
            returning: None,
        };
        stage.sample();
        stage
    }

    /// The run at the displayed time.
    pub fn run(&self) -> &Run {
        self.recording.run()
    }

    /// Applies an input of a person now.
    pub fn input(&mut self, input: Input) {
        self.recording.input(input);
        let run = self.recording.run();
        self.curve.cut(run.steps(), run.time_s());
        // The robot can be elsewhere without a step.
        self.counted = None;
    }

    /// The stored estimates while a run is restored.
    pub fn left(&self) -> Option<MapEstimate<'_>> {
        self.returning.as_ref().map(|way| MapEstimate::left(&way.still))
    }

    /// The robot's estimates.
    pub fn estimate(&self) -> Option<MapEstimate<'_>> {
        let run = self.run();
        if let (Some(known), Some(locator)) = (&self.known, run.locator()) {
            return Some(MapEstimate::on(known, locator));
        }
        let mapper = run.mapper()?;
        let locator = run.intent().and_then(|intent| intent.locator);
        Some(locator.map_or(MapEstimate::of(mapper), |locator| MapEstimate::lost(mapper, locator)))
    }

    /// Up to `steps` steps, with regular updates of the figures; returns the number taken.
    pub fn advance(&mut self, steps: u64, has_time: &mut dyn FnMut() -> bool) -> u64 {
        let mut taken = 0;
        while taken < steps && has_time() {
            let now = self.run().steps();
            let due = self.curve.due();
            let piece = if due > now { due - now } else { u64::MAX };
            let done = self.recording.advance(piece.min(steps - taken), has_time);
            taken += done;
            if self.run().steps() == due {
                self.sample();
            }
            if done == 0 {
                break;
            }
        }
        taken
    }

    fn sample(&mut self) {
        self.count();
        let (steps, time_s) = (self.run().steps(), self.run().time_s());
        let [MapErrorFigures { boundary, position_m, .. }, MapErrorFigures { position_m: odometry_m, .. }] =
            self.figures;
        let thesis = self.thesis.map(|figures| (figures.boundary, figures.position_m));
        self.curve.add(steps, CurveSample { time_s, boundary, position_m, odometry_m, thesis });
    }

    /// Computes the errors, unless they are current.
    pub fn count(&mut self) {
        let run = self.recording.run();
        let now = (self.recording.version() << 40) + run.steps();
        if self.counted == Some(now) {
            return;
        }
        self.counted = Some(now);
        let of = |map, estimate| MapErrorFigures::of(map, estimate, run.pose(), &self.truth);
        let here = self.estimate().map(|estimate| of(estimate.map, estimate.pose()));
        let odometry = run.baseline().map(|mapper| of(mapper.map(), Some(mapper.pose())));
        self.thesis = run.thesis().map(|thesis| of(thesis.map(), Some(thesis.pose())));
        self.figures = [here, odometry].map(Option::unwrap_or_default);
    }

    /// Continues restoring a run. At its end, returns whether the state is the stored one.
    pub fn go_back(&mut self, has_time: &mut dyn FnMut() -> bool) -> Option<bool> {
        let &Return { end, shown, digest, is_seeking, .. } = self.returning.as_ref()?;
        if !is_seeking {
            let before = self.run().steps();
            self.advance(end.saturating_sub(before), has_time);
            let now = self.run().steps();
            // One that has ended early comes to no further input.
            let is_stuck = now == before && self.run().is_finished();
            if now < end && !self.recording.is_over() && !is_stuck {
                return None;
            }
            self.recording.seek(shown as f64 * STEP_S);
            if let Some(way) = &mut self.returning {
                way.is_seeking = true;
            }
        }
        self.recording.seek_on(has_time);
        if self.recording.is_seeking() {
            return None;
        }
        self.returning = None;
        Some(self.run().digest() == digest)
    }
}
