//! View of a session: scene, numbers and texts.

use super::Session;
use crate::{
    FilmScene, RobotView, Scene, SearchScene, SensedFloor,
    explore::{
        Action, SessionState, SessionView, diary_version, in_words,
        view::{FlatView, PlanView, RoomView, SessionActions},
    },
};
use coverage_planners::{
    Proof,
    lanes::MetricBound,
    metrics::{DriveMetrics, WalkMetrics},
};
use robovac_core::{
    floor_plan::generate::FlatId,
    robot::{CustomRobot, OwnRobot},
    trajectory::DriveLimits,
};
use robovac_sim::experiment::Shows;
use robovac_sim::{Life, Run, RunRecording, SensorKind, SlipLevel, What};

impl Session {
    /// The scene, without the pointer's tools.
    pub fn scene(&self) -> Scene<'_> {
        let run = self.recording.as_ref().map(RunRecording::run);
        let model = self.settings.robot_model();
        let Shows { sensors, estimate, .. } = self.settings.shows;
        let is_lost = self.settings.conditions.slip != SlipLevel::None;
        let robot = run.map(|run| RobotView::of(run, &model, estimate || is_lost));
        let film = self.picture().map(|picture| FilmScene { picture, cells: self.settings.cells() });
        // A picture of the film shows the plan alone, without the robot.
        let robot = robot.filter(|_| film.is_none());
        let coverage = self.settings.shows.coverage && film.is_none();
        Scene {
            plan: self.editor.plan(),
            // Both only grow, and one of them with every change.
            plan_version: self.editor.version() + u64::from(self.requests),
            floor: self.prepared.as_ref().map(|p| &*p.floor),
            // While another path is planned, what was swept before is seen.
            tracker: run.or(self.before.as_ref()).map(Run::tracker),
            run_version: (u64::from(self.requests + self.runs) << 32)
                + self.recording.as_ref().map_or(0, RunRecording::version),
            planned: self.planned.as_ref().map_or(&[], |p| &p.line),
            preview: self.preview(),
            film,
            planned_version: u64::from(self.requests) + self.previews,
            trail: run.filter(|_| film.is_none()).map_or(&[], Run::trail),
            life: run.map_or(self.life_before.as_ref(), |run| Some(run.life())),
            steps: run.map_or(0, Run::steps),
            estimated_trail: run.filter(|_| estimate).map_or(&[], Run::estimated_trail),
            robot,
            search: self.decision().map(|step| SearchScene { step, cells: self.settings.cells() }),
            start: self.prepared.as_ref().map(|p| p.floor.start),
            start_radius: model.radius,
            start_body: model.body,
            shows: Shows { coverage, ..self.settings.shows },
            sensed: run.filter(|_| sensors).map(|run| SensedFloor { reading: run.sensors(), floor: run.floor() }),
            ..Scene::empty(self.editor.plan())
        }
    }

    /// Snapshot in numbers and words.
    pub fn view(&self) -> SessionView {
        let state = self.state();
        let run = self.recording.as_ref().map(RunRecording::run);
        let life = run.map_or(self.life_before.as_ref(), |run| Some(run.life()));
        let (plan, conditions) = (self.plan(), self.settings.conditions);
        let custom = self.settings.custom.as_ref();
        let (flat, about) = match FlatId::in_note(&plan.note) {
            Some((name, about)) if self.editor.room().is_none() => (Some(FlatView::new(name)), about),
            _ if self.is_changed_room() => (None, ""),
            _ => (None, plan.note.as_str()),
        };
        let least = run.filter(|_| state == SessionState::Finished).and_then(|run| self.least(run));
        let [width_m, height_m] = self.prepared.as_ref().map_or([plan.width_m(), plan.height_m()], |room| room.size);
        SessionView {
            state,
            can: self.can(state),
            message: self.message.as_ref().map(|m| m.text.clone()).unwrap_or_default(),
            message_kind: self.message.as_ref().map_or("", |m| m.kind),
            room: RoomView {
                id: self.editor.room().unwrap_or(""),
                title: self.room_title(),
                note: about.to_owned(),
                flat,
                width_m,
                height_m,
                resolution_m: plan.resolution,
                cells: plan.occupancy.len(),
                reachable_m2: self.prepared.as_ref().map_or(0.0, |p| p.floor.area()),
                left_out_m2: self.prepared.as_ref().map_or(0.0, |p| p.floor.left_out_area()),
            },
            robot: self.settings.robot,
            twin: custom.and_then(CustomRobot::twin).map(|twin| twin.to_string()).unwrap_or_default(),
            own_robot: custom.and_then(CustomRobot::own).map(own_text).unwrap_or_default(),
            path_corners: self.settings.path.as_ref().map_or(0, |path| path.corners().len()),
            algorithm: self.settings.algorithm.id(),
            kind: self.settings.algorithm.kind(),
            program: self.program_view(),
            activity: run.map_or("", activity),
            diary: run.map_or(0.0, diary_version),
            is_lifted: self.is_lifted(),
            blocked: run.and_then(Run::blocked).map(|b| [b.forward, b.left, b.right, b.backward]),
            dirt_left: life.filter(|life| !life.spots().is_empty()).map(Life::dirt_left),
            params: self.settings.params.clone(),
            cell_size_m: self.settings.cell_size,
            cell_offset_m: self.settings.cells().offset,
            seed: self.settings.seed,
            slip: conditions.slip.id(),
            noise: SensorKind::ALL.map(|(kind, _)| conditions.noise.of(kind).id()),
            quantised: conditions.quantised,
            start_charge_percent: conditions.start_charge_percent,
            shows: self.settings.shows,
            odometry: self.settings.odometry.id(),
            smooth: self.settings.smooth,
            can_smooth: self.prepared.as_ref().is_none_or(|prepared| DriveLimits::of(&prepared.robot).is_some()),
            speed: self.settings.speed,
            speed_factor: self.pacer.speed_factor(),
            time_s: run.map_or(0.0, Run::time_s),
            swept_before: self.swept_before,
            run_end_s: self.recording.as_ref().map_or(0.0, RunRecording::end_s),
            // While another path is planned, what was swept before counts.
            coverage: run.map_or(self.swept_before, Run::coverage),
            overlap: run.map_or(0.0, |r| r.tracker().overlap()),
            distance_m: run.map_or(0.0, Run::distance_m),
            least_m: least.map(|[length_m, _]| length_m),
            least_s: least.map(|[_, top_speed_s]| top_speed_s),
            turning_deg: run.map_or(0.0, |r| r.turning_rad().to_degrees()),
            bumps: run.map_or(0, Run::bumps),
            pose_error_m: run.and_then(Run::pose_error_m).unwrap_or(0.0),
            search: self.search_view(),
            plan: self.plan_view(),
        }
    }

    /// The least distance, m, for as much floor as a run has swept that nobody planned, and the time for it at top speed, s: such a
    /// run may sweep in curves, without stops. `None` if some of it was swept before, or if it is hardly any.
    fn least(&self, run: &Run) -> Option<[f64; 2]> {
        let robot = &self.prepared.as_ref()?.robot;
        let is_known = self.planned.is_none() && self.before.is_none();
        let least = MetricBound::of_run(run.coverage() * run.floor().area(), robot);
        least.filter(|&[length_m, _]| is_known && length_m > 1.0)
    }

    fn can(&self, state: SessionState) -> SessionActions {
        SessionActions {
            play: state.allows(Action::Play),
            pause: state.allows(Action::Pause),
            step: state.allows(Action::Step),
            // At the start, it begins anew with a dirty floor.
            reset: state.allows(Action::Reset) || (state == SessionState::Ready && self.before.is_some()),
            cancel: state.allows(Action::Cancel),
            keep: state.allows(Action::Cancel) && self.can_keep(),
            // Back at the start, what was recorded still lies ahead.
            seek: state.allows(Action::Seek)
                || (state == SessionState::Ready
                    && self.recording.as_ref().is_some_and(|recording| recording.end_s() > 0.0)),
            edit: state.allows(Action::Edit),
            lift: state.allows(Action::Lift) && !self.is_lifted(),
            undo: self.editor.can_undo(),
            redo: self.editor.can_redo(),
        }
    }

    /// Steps that a quarter turn counts as for a planner that proves its plans, and whether that is the robot's time.
    fn turn_weight(&self) -> Option<(f64, bool)> {
        let turn = self.settings.algorithm.planner()?.turn_weight(&self.settings.params)?;
        if turn > 0.0 {
            return Some((turn, false));
        }
        self.prepared.as_ref().map(|prepared| (prepared.job.turn_s / prepared.job.step_s, true))
    }

    fn plan_view(&self) -> Option<PlanView> {
        let (turn_weight, times_turns) = self.turn_weight().unzip();
        let times_turns = times_turns.unwrap_or(false);
        let planner = self.settings.algorithm.planner().filter(|_| self.settings.path.is_none());
        let asked_coverage = planner.and_then(|planner| planner.asked_coverage(&self.settings.params));
        if let Some(planning) = &self.planning {
            return Some(PlanView {
                running: true,
                progress: planning.progress,
                walk: WalkMetrics::default(),
                drive: DriveMetrics::default(),
                planning_s: None,
                gap: planning.proof.map(Proof::gap),
                above_bound: None,
                least: None,
                turn_weight,
                times_turns,
                kept_at: None,
                asked_coverage,
            });
        }
        self.planned.as_ref().map(|planned| PlanView {
            running: false,
            progress: 1.0,
            walk: planned.walk.unwrap_or_default(),
            drive: planned.drive,
            planning_s: (!self.is_opening && self.settings.path.is_none()).then_some(planned.planning_s),
            gap: planned.proof.map(Proof::gap),
            above_bound: planned.compared.map(Proof::gap),
            least: planned.least,
            turn_weight,
            times_turns,
            kept_at: planned.kept_at,
            asked_coverage,
        })
    }

    /// One or two sentences that describe the picture.
    pub fn description(&self) -> String {
        let view = self.view();
        let room = format!("{}, {:.1} m by {:.1} m", view.room.title, view.room.width_m, view.room.height_m);
        let doing = match view.state {
            SessionState::Failed => "there is no plan to drive",
            SessionState::Planning => "a path is being planned",
            SessionState::Ready => "the robot stands at the start",
            SessionState::Playing => "the robot is cleaning",
            SessionState::Paused | SessionState::Seeking => "the robot is paused",
            SessionState::Finished => "the run is finished",
        };
        let search = if view.search.text.is_empty() { String::new() } else { format!(" {}", view.search.text) };
        let objects = in_words(&self.plan().objects);
        let objects = if objects.is_empty() { objects } else { format!(" Objects: {objects}.") };
        format!(
            "Floor plan of {room}.{objects} {}: {doing}, {:.1} % of the reachable floor is clean after {:.0} min.{search}",
            self.settings.algorithm.title(),
            // Rounded down, as in the numbers: never 100 unless it is all.
            (1000.0 * view.coverage + 1e-6).floor() / 10.0,
            view.time_s / 60.0
        )
    }
}

/// An own robot as in links; one without choices needs a word, too.
fn own_text(own: &OwnRobot) -> String {
    let text = own.to_string();
    if text.is_empty() { "model".to_owned() } else { text }
}

/// The robot's activity, in a few words. A robot that was put down while paused hasn't sensed that yet.
fn activity(run: &Run) -> &'static str {
    let last = run.events().back();
    let is_put_down = last.is_some_and(|event| event.what == What::PutDown && event.step >= run.steps());
    if is_put_down { "put down, about to continue" } else { run.activity() }
}
