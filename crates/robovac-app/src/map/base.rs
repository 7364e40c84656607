//! The settings that the Map tab takes from the session.

use super::{Known, MapSetup, RoomTruth, numbers::digest};
use crate::explore::{Session, SessionSnapshot};
use robovac_core::{
    floor_plan::{FloorPlan, Scenario},
    program::Program,
};
use robovac_sim::{
    Conditions, Run,
    controller::{Controller, Setup},
    experiment::planning::RoomSetup,
    mapping::{MapObserver, Mapper, MapperSetup, ThesisMap, Tracking},
    program::{Logged, SharedLog},
};
use std::sync::Arc;

/// The settings taken over from the session.
pub(super) struct MapBase {
    pub plan: Arc<FloorPlan>,
    pub title: String,
    pub prepared: Result<RoomSetup, String>,
    pub conditions: Conditions,
    pub seed: u64,
    /// The user's program, whatever is chosen in Explore.
    pub program: Option<Arc<Program>>,
    /// Key of room, start, robot, conditions and seed; stable between sessions.
    pub place: String,
    /// Snapshot of the session.
    snapshot: SessionSnapshot,
}

impl MapBase {
    /// The session's settings.
    pub fn of(session: &Session) -> Self {
        let settings = session.settings();
        Self {
            plan: Arc::clone(session.plan()),
            title: session.room_title(),
            prepared: session.planning_room().ok_or_else(|| session.view().message),
            conditions: settings.conditions,
            seed: settings.seed,
            program: settings.program().cloned(),
            place: place_of(session),
            snapshot: session.snapshot(),
        }
    }

    /// Whether the session is unchanged.
    pub fn is_of(&self, session: &Session) -> bool {
        self.snapshot == session.snapshot()
    }

    /// A run with the robot at the start, and the ground truth; `None` if the robot doesn't fit or isn't in the
    /// registry, or if there is no program to drive it. A program's run repeats `log`.
    pub fn run(&self, setup: &MapSetup, known: Option<&Known>, log: &SharedLog) -> Option<(Run, RoomTruth)> {
        let prepared = self.prepared.as_ref().ok()?;
        let conditions = setup.conditions(self.conditions);
        let robot = &prepared.robot;
        let params = setup.driving_params();
        let controller = if setup.is_program() {
            self.driver().map(|_| Box::new(Logged::new(log.clone())) as Box<dyn Controller>)
        } else {
            setup.behaviour.build(&Setup { robot, params: &params, seed: self.seed })
        }?;
        let start = prepared.floor.start;
        let mapper = |tracking| {
            Mapper::new(MapperSetup {
                robot: robot.clone(),
                start,
                tracking,
                odometry: setup.odometry,
                seed: self.seed,
            })
        };
        let observer = MapObserver::default().with_baseline(mapper(Tracking::Odometry)).with_reckoning(robot, start);
        let observer = if let Some(known) = known {
            let mapper = mapper(setup.tracking).knowing(known.map().clone(), known.marks().clone());
            let mapper = match known.dock() {
                Some(dock) => mapper.knowing_dock(dock),
                None => mapper,
            };
            observer.with_mapper(mapper).with_locator(known.locator(robot, setup.odometry, self.seed)?)
        } else {
            let observer = observer.with_thesis(ThesisMap::new(robot, start));
            // A controller with a map of its own acts by that.
            if controller.mapper().is_none() { observer.with_mapper(mapper(setup.tracking)) } else { observer }
        };
        let run = Run::new(&prepared.setup(conditions, self.seed), controller).observed(Box::new(observer));
        let resolution = run.mapper()?.map().resolution();
        let truth = RoomTruth::new(&prepared.floor, robot.radius, resolution);
        Some((run, truth))
    }
}

/// Key of a session's room, start, robot, conditions and seed; stable between sessions.
fn place_of(session: &Session) -> String {
    let kept = session.link_pairs().filter(|(key, _)| {
        ["room", "robot", "twin", "own", "cell", "seed", "slip", "quantised", "charge", "start"].contains(&key.as_str())
            || key.starts_with("noise.")
    });
    let kept: Vec<String> = kept.map(|(key, value)| format!("{key}={value}")).collect();
    let is_own = session.room().is_none();
    let walls = is_own.then(|| format!(" {:016x}", digest(&Scenario::of(session.plan()).to_json())));
    format!("{}{}", kept.join(" "), walls.unwrap_or_default())
}
