//! Planning in a session: requests, results and messages.

use super::{Planning, Session, sentence};
use crate::explore::{PlanSearch, SessionState, Showing, opening};
use coverage_planners::{
    CoveragePath, Film, FilmFrame, PlanError, PlannerInfo, ProgressReport, Proof, smooth::SmoothSetup,
};
use robovac_core::{floor_plan, trajectory::Trajectory};
use robovac_sim::{
    RunRecording,
    experiment::{
        Algorithm, Settings,
        planning::{PlanAnswer, PlanRequest, Planned, RoomSetup},
    },
};
use std::{ops::ControlFlow, sync::Arc};

/// Least coverage of the reachable floor without a warning.
const LEAST_COVERAGE: f64 = 0.75;

impl Session {
    /// The pending plan request, returned once. Answer it with the methods below.
    ///
    /// The opening scene uses its precomputed plan instead.
    pub fn take_plan_request(&mut self) -> Option<PlanRequest> {
        let request = self.planning.as_mut()?.request.take()?;
        if !self.is_opening {
            return Some(request);
        }
        let path = CoveragePath::walk(opening::from_runs(request.job.start, opening::WALK));
        let answer = PlanAnswer { path, seconds: 0.0, proof: None, trace: Vec::new() };
        self.plan_finished(request.id, answer);
        self.plan_proven(request.id, Some(opening::PROOF), Some(opening::LEAST));
        None
    }

    /// Plans synchronously; for small rooms and tests. `clock` returns seconds.
    pub fn plan_now(&mut self, clock: impl Fn() -> f64) {
        let Some(request) = self.take_plan_request() else { return };
        let mut film = request.film();
        let mut watch = |report: ProgressReport<'_>| {
            if let Some(film) = &mut film {
                film.take(&report);
            }
            ControlFlow::Continue(())
        };
        match request.serve(clock, Some(&mut watch)) {
            Ok(answer) => {
                self.plan_filmed(request.id, film.map_or(Vec::new(), |mut film| film.take_frames()));
                self.plan_finished(request.id, answer);
                self.smooth_now(request.id);
            }
            Err(PlanError::Cancelled) => self.cancel_plan(),
            Err(error @ (PlanError::Unlisted | PlanError::NoFloor)) => self.plan_failed(request.id, &error.to_string()),
        }
    }

    /// Rounds the corners of a plan synchronously, if that is chosen and the robot can.
    fn smooth_now(&mut self, id: u32) {
        let (Some(prepared), Some(planned)) = (&self.prepared, &self.planned) else { return };
        if self.settings.smooth
            && let Ok(path) = prepared.smooth(&planned.line, &SmoothSetup::default(), false)
        {
            self.plan_smoothed(id, path.trajectory);
        }
    }

    /// The trajectory of a request's plan with rounded corners. The robot begins again with it.
    pub fn plan_smoothed(&mut self, id: u32, trajectory: Trajectory) {
        if id != self.requests || !self.settings.smooth {
            return;
        }
        let (Some(prepared), Some(planned)) = (&self.prepared, self.planned.take()) else { return };
        let planned = planned.driven_along(prepared, Arc::new(trajectory));
        let Settings { conditions, odometry, seed, .. } = self.settings;
        self.recording = Some(RunRecording::new(planned.run(prepared, conditions, odometry, seed)));
        self.planned = Some(planned);
        self.pacer.restart();
    }

    /// Progress of a planner: its share done, its best path so far, and the proof.
    pub fn plan_progress(&mut self, id: u32, ProgressReport { done, walk, line, proof }: ProgressReport<'_>) {
        let Some(planning) = self.planning.as_mut().filter(|p| p.id == id) else { return };
        (planning.progress, planning.proof) = (done, proof);
        planning.path = CoveragePath { cells: walk.to_vec(), line: line.to_vec() };
        if let Some(prepared) = &self.prepared {
            planning.preview = if line.is_empty() { prepared.planning_grid.anchors(walk) } else { line.to_vec() };
            self.previews += 1;
        }
    }

    /// New frames of a planner's film since the last call.
    pub fn plan_filmed(&mut self, id: u32, frames: Vec<FilmFrame>) {
        if let Some(planning) = self.planning.as_mut().filter(|p| p.id == id) {
            for frame in frames {
                planning.film.add(frame);
            }
        }
    }

    /// Whether the running planner can be stopped with a path that cleans all that it shall: walks of such planners have a
    /// proof, and every path in metres is one.
    pub(super) fn can_keep(&self) -> bool {
        let is_anytime = self.settings.algorithm.planner().is_some_and(PlannerInfo::is_anytime);
        let is_kept = |planning: &Planning| is_anytime && planning.proof.is_some() || planning.path.is_in_metres();
        self.planning.as_ref().is_some_and(is_kept)
    }

    /// Ends planning with the best walk so far, `seconds` after the planner began. Cancels if there is none.
    pub fn keep_plan(&mut self, seconds: f64) {
        let Some(planning) = self.planning.as_mut() else { return };
        let (id, proof, path, done) = (planning.id, planning.proof, planning.path.clone(), planning.progress);
        if !self.can_keep() {
            return self.cancel_plan();
        }
        self.plan_finished(id, PlanAnswer { path, seconds, proof, trace: Vec::new() });
        if let Some(planned) = &mut self.planned {
            planned.kept_at = Some(done);
        }
    }

    /// What was proven of a request's plan after planning: its cost in the weights of comparisons, and least length, m, and
    /// time, s, of any path that sweeps as much.
    pub fn plan_proven(&mut self, id: u32, proof: Option<Proof>, least: Option<[f64; 2]>) {
        if id == self.requests
            && let Some(planned) = &mut self.planned
        {
            (planned.compared, planned.least) = (proof, least);
        }
    }

    /// A planner has finished.
    pub fn plan_finished(&mut self, id: u32, answer: PlanAnswer) {
        let Some(mut planning) = self.planning.take_if(|p| p.id == id) else { return };
        self.previews += 1;
        let Some(prepared) = &self.prepared else { return };
        match Planned::new(prepared, &answer) {
            Ok(planned) => {
                let Settings { conditions, odometry, seed, .. } = self.settings;
                self.recording = Some(RunRecording::new(planned.run(prepared, conditions, odometry, seed)));
                let PlanAnswer { path, trace, proof, .. } = answer;
                planning.film.take(&ProgressReport { done: 1.0, walk: &path.cells, line: &[], proof });
                self.film = Showing::new(&planning.film.take_frames(), &prepared.planning_grid, self.holds_films);
                self.search = (!trace.is_empty()).then(|| PlanSearch::new(prepared, &planned, &path.cells, trace));
                let coverage = planned.drive.coverage;
                self.planned = Some(planned);
                self.warn_of_coarse_cells(coverage);
                self.begin_film();
            }
            Err(error) => self.planner_failed(&error.to_string()),
        }
    }

    /// A planner has failed.
    pub fn plan_failed(&mut self, id: u32, text: &str) {
        if self.planning.as_ref().is_some_and(|p| p.id == id) {
            self.planning = None;
            self.planner_failed(text);
        }
    }

    fn planner_failed(&mut self, text: &str) {
        self.say("error", format!("The planner failed: {text}. Try another planner or room."));
    }

    /// Cancels planning.
    pub fn cancel_plan(&mut self) {
        if self.planning.take().is_some() {
            self.playing = false;
            // Its preview is no longer drawn.
            self.previews += 1;
            self.say("notice", "Planning was cancelled. Press play to plan again, or change the settings.".into());
        }
    }

    /// Warns if much of the floor can't be reached from the start.
    fn warn_of_closed_off(&mut self, prepared: &RoomSetup) {
        let floor = &prepared.floor;
        if floor.closed_off_area() > floor.area() {
            let (reached, left_out) = (floor.area(), floor.left_out_area());
            self.say(
                "notice",
                format!(
                    "From this start the robot can reach only {reached:.1} m² of floor; {left_out:.1} m² (hatched) are \
                     behind walls or passages too narrow for it. Move the start, or choose a smaller robot."
                ),
            );
        }
    }

    /// Warns of a plan that covers all its cells but little of the floor.
    fn warn_of_coarse_cells(&mut self, coverage: f64) {
        if coverage < LEAST_COVERAGE && self.message.is_none() {
            let (percent, cell) = (100.0 * coverage, 100.0 * self.settings.cell_size);
            self.say(
                "notice",
                format!(
                    "This plan covers only {percent:.0} % of the reachable floor: planning cells of {cell:.0} cm \
                     don't fit through the room's passages, or the tool is narrower than a cell. Choose smaller cells."
                ),
            );
        }
    }

    /// Lays the room out again and requests a plan.
    pub(super) fn prepare(&mut self) {
        // After a finished run a change starts the next one.
        self.playing |= self.state() == SessionState::Finished;
        self.planned = None;
        self.search = None;
        self.film = None;
        self.recording = None;
        self.planning = None;
        self.pacer.restart();
        self.is_opening = self.is_opening
            && self.editor.room() == Some(floor_plan::ROOMS[0].id)
            && self.editor.start().is_none()
            && self.settings.plans_like(&self.settings.defaults());
        let robot = self.settings.robot_model();
        match RoomSetup::new(self.editor.plan(), &robot, self.settings.cell_size, self.editor.start()) {
            Ok(prepared) => {
                self.requests += 1;
                let Settings { algorithm, ref params, conditions, seed, .. } = self.settings;
                match algorithm {
                    Algorithm::Planner(planner) => {
                        let (params, job) = (params.clone(), prepared.job.clone());
                        let request = Some(PlanRequest { id: self.requests, planner, params, seed, job });
                        let (path, preview) = (CoveragePath::default(), Vec::new());
                        let id = self.requests;
                        self.planning = Some(Planning {
                            request,
                            id,
                            progress: 0.0,
                            path,
                            preview,
                            proof: None,
                            film: Film::default(),
                        });
                    }
                    // No planning: a behaviour doesn't know the room.
                    Algorithm::Behaviour(behaviour) => {
                        let behaviours = self.settings.behaviours();
                        let run = prepared.run_one_of(behaviours, behaviour, params, conditions, seed);
                        self.recording = run.map(RunRecording::new);
                    }
                }
                self.warn_of_closed_off(&prepared);
                self.prepared = Some(prepared);
            }
            Err(error) => {
                self.prepared = None;
                self.say("error", sentence(&error.to_string()));
            }
        }
    }
}
