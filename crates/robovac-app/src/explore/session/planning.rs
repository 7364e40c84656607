//! Planning in a session: requests, results and messages.

use super::{Planning, Session, sentence};
use crate::explore::{FilmPicture, PlanSearch, SessionState, Showing, opening, pictures};
use coverage_planners::{
    CoveragePath, PlanError, PlannerInfo, ProgressReport, Proof, metrics::SweepBound, smooth::SmoothSetup,
};
use robovac_core::{coverage::FloorError, floor_plan, trajectory::Trajectory};
use robovac_sim::{
    Life, Run, RunRecording,
    experiment::{
        Algorithm, Settings,
        planning::{PathToDrive, PlanAnswer, PlanRequest, Planned, RoomSetup},
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
                let frames = film.map_or_else(Vec::new, |film| film.ended(&answer.path, answer.proof));
                let pictures = self.prepared.as_ref().map(|prepared| pictures(&frames, &prepared.planning_grid));
                self.plan_finished(request.id, answer);
                self.plan_filmed(request.id, pictures.unwrap_or_default());
                self.smooth_now(request.id, &request.smooth_setup());
            }
            Err(PlanError::Cancelled) => self.cancel_plan(),
            Err(
                error @ (PlanError::Unlisted | PlanError::NoFloor | PlanError::OtherTool | PlanError::Unsuited { .. }),
            ) => {
                self.plan_failed(request.id, &error.to_string());
            }
        }
    }

    /// Rounds the corners of a plan synchronously, if that is chosen and the robot can.
    fn smooth_now(&mut self, id: u32, setup: &SmoothSetup) {
        let (Some(prepared), Some(planned)) = (&self.prepared, &self.planned) else { return };
        if self.settings.smooth
            && let Ok(path) = prepared.smooth(&planned.line, setup, false)
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
        self.planned = Some(planned.driven_along(prepared, Arc::new(trajectory)));
        if let Some(run) = self.fresh_run() {
            self.record(run);
        }
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

    /// The film of a plan that was found or kept. If it is to be shown, time pauses.
    pub fn plan_filmed(&mut self, id: u32, pictures: Vec<FilmPicture>) {
        if id == self.requests && self.planned.is_some() {
            self.film = Showing::new(pictures, self.holds_films);
            match &mut self.film {
                // The run is what the link shows.
                Some(film) if self.awaited.is_some_and(|moment| !moment.is_start()) => film.skip(),
                _ => self.begin_film(),
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

    /// What was proven of a request's plan after planning: its cost in the weights of comparisons; and its exact
    /// coverage, with what any path needs that sweeps as much.
    pub fn plan_proven(&mut self, id: u32, proof: Option<Proof>, least: Option<SweepBound>) {
        if id == self.requests
            && let Some(planned) = &mut self.planned
        {
            (planned.compared, planned.least) = (proof, least);
        }
    }

    /// A planner has finished.
    pub fn plan_finished(&mut self, id: u32, answer: PlanAnswer) {
        if self.planning.take_if(|p| p.id == id).is_none() {
            return;
        }
        self.previews += 1;
        let mut missed = None;
        if self.settings.algorithm.is_program() {
            let Some(prepared) = self.prepared.clone() else { return };
            match self.program_plans(&prepared, &answer.path) {
                Ok(found) => missed = found,
                Err(()) => return,
            }
        }
        let Some(prepared) = &self.prepared else { return };
        match Planned::new(prepared, &answer) {
            Ok(planned) => {
                let PlanAnswer { path, trace, .. } = answer;
                self.search = (!trace.is_empty()).then(|| PlanSearch::new(prepared, &planned, &path.cells, trace));
                let coverage = planned.drive.coverage;
                self.planned = Some(planned);
                if let Some(run) = self.fresh_run() {
                    self.record(run);
                }
                self.tell_missed(missed);
                self.warn_of_coarse_cells(coverage);
            }
            Err(error) => self.planner_failed(&error.to_string()),
        }
    }

    /// A run from the start: along `driven` for a planner or a path from elsewhere. `None` if the robot doesn't fit, or if the
    /// behaviour isn't available.
    pub(crate) fn new_run(&self, driven: &PathToDrive) -> Option<Run> {
        let prepared = self.prepared.as_ref()?;
        let Settings { algorithm, ref params, ref path, conditions, odometry, seed, .. } = self.settings;
        match algorithm {
            _ if path.is_some() => Some(prepared.run_driven(driven, conditions, odometry, seed)),
            Algorithm::Planner(_) => Some(prepared.run_driven(driven, conditions, odometry, seed)),
            Algorithm::Behaviour(_) if self.program_drives() => Some(self.program_run(prepared)),
            Algorithm::Behaviour(behaviour) => {
                prepared.run_one_of(self.settings.behaviours(), behaviour, params, conditions, seed)
            }
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
        let text = if self.settings.algorithm.is_program() {
            sentence(&format!("the program failed: {text}"))
        } else {
            format!("The planner failed: {text}. Try another planner or room.")
        };
        self.say("error", text);
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

    /// The room laid out for the robot: along its path, if that was planned elsewhere.
    fn room_setup(&self) -> Result<RoomSetup, FloorError> {
        let (plan, robot, start) = (self.plan(), self.settings.robot_model(), self.editor.start());
        let cells = self.settings.cells();
        match &self.settings.path {
            Some(path) => {
                let heading = start.or(plan.start).map_or(0.0, |start| start.heading);
                RoomSetup::along(plan, &robot, cells, path, heading)
            }
            None => RoomSetup::new(plan, &robot, cells, start),
        }
    }

    /// The room laid out for planners and behaviours, whatever path is driven in it.
    pub fn planning_room(&self) -> Option<RoomSetup> {
        if self.settings.path.is_none() {
            return self.prepared.clone();
        }
        RoomSetup::new(self.plan(), &self.settings.robot_model(), self.settings.cells(), self.editor.start()).ok()
    }

    /// A run from the start, once there is a path for those that need one.
    pub(super) fn fresh_run(&self) -> Option<Run> {
        let driven = self.planned.as_ref().map(Planned::driven);
        let needs_line = self.settings.path.is_some() || self.settings.algorithm.planner().is_some();
        if needs_line && driven.is_none() { None } else { self.new_run(&driven.unwrap_or_default()) }
    }

    /// Begins with a run.
    pub(super) fn record(&mut self, run: Run) {
        self.runs += 1;
        let run = match &self.before {
            Some(before) => run.after(before),
            None => run,
        };
        let recording = RunRecording::new(run);
        self.swept_before = if self.before.is_some() { recording.first_coverage() } else { 0.0 };
        self.recording = Some(recording);
        self.go_to_awaited();
    }

    /// Lays the room out again after a change of it; what was swept stays swept, where it still is floor.
    pub(super) fn prepare_changed(&mut self) {
        let run = self.recording.as_ref().map(RunRecording::run).filter(|run| run.steps() > 0).cloned();
        let before = run.or_else(|| self.before.take());
        let is_lost = before.is_some() && self.program_drives();
        self.lay_out(before);
        if is_lost && self.message.is_none() {
            self.say("notice", "The room changed: your program begins again.".to_owned());
        }
    }

    /// Lays the room out again and requests a plan.
    pub(super) fn prepare(&mut self) {
        self.lay_out(None);
    }

    fn lay_out(&mut self, before: Option<Run>) {
        // After a finished run a change starts the next one.
        self.playing |= self.state() == SessionState::Finished;
        self.planned = None;
        self.search = None;
        self.film = None;
        self.awaited = None;
        self.recording = None;
        // A program's own simulation begins with a floor that nobody has swept.
        self.before = before.filter(|_| !self.program_drives());
        self.program.restart();
        (self.swept_before, self.life_before) = (0.0, None);
        self.planning = None;
        self.pacer.restart();
        self.is_opening = self.is_opening
            && self.editor.room() == Some(floor_plan::ROOMS[0].id)
            && self.editor.start().is_none()
            && self.settings.plans_like(&self.settings.defaults());
        match self.room_setup() {
            Ok(prepared) => {
                self.requests += 1;
                let Settings { algorithm, ref params, ref path, seed, .. } = self.settings;
                match algorithm {
                    // No planning: it was planned elsewhere.
                    _ if let Some(path) = path => {
                        self.planned = Some(Planned::along(&prepared, path, 0.0));
                    }
                    Algorithm::Planner(planner) => {
                        let (params, job) = (params.clone(), prepared.job.clone().rounded(self.settings.smooth));
                        let request = Some(PlanRequest { id: self.requests, planner, params, seed, job });
                        let (path, preview) = (CoveragePath::default(), Vec::new());
                        let id = self.requests;
                        self.planning = Some(Planning { request, id, progress: 0.0, path, preview, proof: None });
                    }
                    // No planning: a behaviour doesn't know the room.
                    Algorithm::Behaviour(_) => {}
                }
                self.warn_of_closed_off(&prepared);
                let before = self.before.as_ref();
                self.swept_before = before.map_or(0.0, |run| run.tracker().coverage_on(&prepared.floor));
                let after = |run: &Run| Life::after(&prepared.world, &prepared.floor, seed, run.life());
                self.life_before = before.map(after);
                self.prepared = Some(prepared);
                if self.planning.is_none()
                    && let Some(run) = self.fresh_run()
                {
                    self.record(run);
                }
            }
            Err(error) => {
                self.prepared = None;
                self.say("error", sentence(&error.to_string()));
            }
        }
    }
}
