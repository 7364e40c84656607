//! One robot on one floor, step by step.

use super::{Gains, OwnMap, ReadingsEncoder, truth};
use crate::{Conditions, Life, STEP_S, SimRobot, World};
use robovac_core::{
    coverage::{CoverageTracker, FloorError, ReachableFloor},
    floor_plan::FloorPlan,
    geometry::{Pose, difference},
    robot::{Drive, RobotModel, RobotPort, SensorReadings},
};
use std::sync::Arc;

/// What all episodes of a training have in common.
#[derive(Debug, Clone)]
pub struct Task {
    /// The robot.
    pub robot: RobotModel,
    /// Simulation steps of [`STEP_S`] for each step of an episode, at least 1.
    pub sim_steps: u32,
    /// Steps after which an episode is cut off.
    pub most_steps: u32,
    /// Share of the reachable floor with which it is finished, 0 to 1.
    pub goal: f64,
    /// Whether the robot keeps its own map.
    pub keeps_map: bool,
}

/// A room laid out for the robot; shared by all episodes in it.
#[derive(Debug, Clone)]
pub struct EpisodeRoom {
    /// The reachable floor.
    pub floor: ReachableFloor,
    /// Objects of the room other than walls.
    pub world: World,
    /// The longer side of the room, m.
    extent_m: f64,
}

/// Where observations are written; sets that aren't wanted are `None`.
#[derive(Debug, Default)]
pub struct Observations<'a> {
    /// [`READINGS`](super::READINGS) values.
    pub readings: Option<&'a mut [f32]>,
    /// [`PATCH_LEN`](super::PATCH_LEN) values.
    pub map: Option<&'a mut [u8]>,
    /// [`truth::VALUES`] values.
    pub truth: Option<&'a mut [f32]>,
}

/// The end of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepOutcome {
    /// What the step gained.
    pub gains: Gains,
    /// The episode is over: the floor is done, the robot fell, or its battery is empty.
    pub is_over: bool,
    /// The episode was cut off by its time.
    pub is_late: bool,
}

/// The state of an episode.
#[derive(Debug, Clone)]
pub struct Episode {
    task: Arc<Task>,
    room: Arc<EpisodeRoom>,
    robot: SimRobot,
    life: Life,
    tracker: CoverageTracker,
    own_map: Option<OwnMap>,
    readings: ReadingsEncoder,
    steps: u32,
    is_finished: bool,
}

impl Task {
    /// Time of a step, s.
    pub fn step_s(&self) -> f64 {
        f64::from(self.sim_steps) * STEP_S
    }
}

impl EpisodeRoom {
    /// Lays `plan` out for `robot`.
    pub fn new(plan: &FloorPlan, robot: &RobotModel) -> Result<Self, FloorError> {
        let floor = ReachableFloor::new(plan, robot, None)?;
        Ok(Self { floor, world: World::new(plan), extent_m: plan.width_m().max(plan.height_m()) })
    }
}

impl Episode {
    /// The robot at rest at `start`, or at the room's start; `seed` determines everything random.
    pub fn new(
        task: &Arc<Task>,
        room: &Arc<EpisodeRoom>,
        conditions: Conditions,
        start: Option<Pose>,
        seed: u64,
    ) -> Self {
        let start = start.unwrap_or(room.floor.start);
        let mut tracker = CoverageTracker::new(&room.floor);
        tracker.sweep_to(&room.floor, start);
        let robot = SimRobot::new(&task.robot, start, conditions, seed);
        let mut own_map = task.keeps_map.then(|| OwnMap::new(&task.robot, room.extent_m));
        if let Some(map) = &mut own_map {
            map.update(&task.robot, robot.sensors());
        }
        Self {
            life: Life::new(&room.world, &room.floor, seed),
            task: Arc::clone(task),
            room: Arc::clone(room),
            robot,
            tracker,
            own_map,
            readings: ReadingsEncoder::default(),
            steps: 0,
            is_finished: false,
        }
    }

    /// Drives for a step's time.
    pub fn step(&mut self, drive: Drive) -> StepOutcome {
        let Self { task, room, robot, life, tracker, own_map, .. } = self;
        let before = tracker.coverage(&room.floor);
        let mut gains = Gains { time_s: task.step_s(), ..Gains::default() };
        robot.drive(drive);
        for _ in 0..task.sim_steps {
            let (heading, was_pressed) = (robot.pose().heading, robot.sensors().bumped());
            robot.step(&room.floor.walls, &room.world, life);
            let pose = robot.pose();
            if let Some(map) = own_map {
                map.update(&task.robot, robot.sensors());
            }
            if robot.has_fallen() {
                gains.falls = 1.0;
                break;
            }
            gains.turned_rad += difference(heading, pose.heading).abs();
            gains.bumps += f64::from(u8::from(robot.sensors().bumped() && !was_pressed));
            tracker.sweep_to(&room.floor, pose);
        }
        let coverage = tracker.coverage(&room.floor);
        gains.swept_m2 = (coverage - before) * room.floor.area();
        self.steps += 1;
        let is_done = coverage >= task.goal;
        gains.finished = f64::from(u8::from(is_done && !self.is_finished));
        self.is_finished |= is_done;
        let is_over = is_done || self.robot.has_fallen() || self.robot.is_empty();
        StepOutcome { gains, is_over, is_late: !is_over && self.steps >= self.task.most_steps }
    }

    /// Writes the observations. To be called once after the episode's begin and once after each step.
    pub fn observe(&mut self, out: Observations<'_>) {
        let Self { task, robot, own_map, readings, .. } = self;
        if let Some(out) = out.readings {
            readings.write(&task.robot, robot.sensors(), robot.commanded(), task.step_s(), out);
        }
        if let (Some(map), Some(out)) = (own_map, out.map) {
            map.look(&task.robot, robot.sensors());
            map.patches(out);
        }
        if let Some(out) = out.truth {
            truth::write(self, out);
        }
    }

    /// The room.
    pub fn room(&self) -> &EpisodeRoom {
        &self.room
    }

    /// The robot's true pose.
    pub fn pose(&self) -> Pose {
        self.robot.pose()
    }

    /// Its speed forward, m/s, and its turn rate, rad/s, by the present speeds of its wheels.
    pub fn motion(&self) -> (f64, f64) {
        let Drive { left, right, .. } = self.robot.speed();
        (0.5 * (left + right), (right - left) / self.task.robot.wheel_base)
    }

    /// The latest reading.
    pub fn sensors(&self) -> &SensorReadings {
        self.robot.sensors()
    }

    /// Swept share of the reachable floor, 0 to 1.
    pub fn coverage(&self) -> f64 {
        self.tracker.coverage(&self.room.floor)
    }

    /// Share of the episode's longest time that has passed, 0 to 1.
    pub fn time_share(&self) -> f64 {
        f64::from(self.steps) / f64::from(self.task.most_steps.max(1))
    }

    /// The swept floor.
    pub fn tracker(&self) -> &CoverageTracker {
        &self.tracker
    }
}

#[cfg(test)]
mod tests {
    use super::super::{PATCH_LEN, READINGS, RewardWeights};
    use super::*;
    use robovac_core::{
        floor_plan::{Sketch, room},
        robot::model,
    };

    fn task(most_steps: u32) -> Arc<Task> {
        let robot = model("roomba600").unwrap().clone();
        Arc::new(Task { robot, sim_steps: 7, most_steps, goal: 0.9, keeps_map: true })
    }

    #[test]
    fn driving_over_new_floor_gains_and_walls_bump() {
        let plan = Sketch::open(4.0, 1.0, 0.05).start(0.5, 0.5, 0.0).finish("lane", "");
        let task = task(1000);
        let room = Arc::new(EpisodeRoom::new(&plan, &task.robot).unwrap());
        let mut episode = Episode::new(&task, &room, Conditions::default(), None, 1);
        let (mut reward, mut bumps, mut swept) = (0.0, 0.0, 0.0);
        for _ in 0..200 {
            let outcome = episode.step(Drive::wheels(0.3, 0.3));
            assert!(!outcome.is_over && !outcome.is_late);
            reward += RewardWeights::default().reward(&outcome.gains);
            bumps += outcome.gains.bumps;
            swept += outcome.gains.swept_m2;
        }
        // 3.15 m at 17 cm, at 0.3 m/s, then against the wall for ten seconds.
        assert!((0.45..0.6).contains(&swept) && bumps >= 1.0, "{swept} m2, {bumps} bumps");
        assert!((7.0..10.0).contains(&reward), "{reward}");
        let mut map = vec![0; PATCH_LEN];
        episode.observe(Observations { map: Some(&mut map), ..Observations::default() });
        assert!(map.contains(&255) && map.contains(&0) && map.contains(&128));
    }

    #[test]
    fn episodes_end_by_time_by_falling_and_by_the_goal() {
        let flat = (room("stairs").unwrap().build)();
        let task = task(50);
        let room = Arc::new(EpisodeRoom::new(&flat, &task.robot).unwrap());
        let stand = |steps: usize| {
            let mut episode = Episode::new(&task, &room, Conditions::default(), None, 1);
            (0..steps).map(|_| episode.step(Drive::STOP)).last().unwrap()
        };
        assert!(!stand(49).is_late && stand(50).is_late && !stand(50).is_over);
        let small = Sketch::open(0.5, 0.4, 0.05).finish("closet", "");
        let easy = Arc::new(Task { goal: 0.01, ..(*task).clone() });
        let closet = Arc::new(EpisodeRoom::new(&small, &task.robot).unwrap());
        let mut episode = Episode::new(&easy, &closet, Conditions::default(), None, 1);
        let outcome = episode.step(Drive::STOP);
        assert!(outcome.is_over && outcome.gains.finished == 1.0);
        assert_eq!(episode.step(Drive::STOP).gains.finished, 0.0);
    }

    #[test]
    fn the_seed_determines_every_observation() {
        let plan = (room("flat").unwrap().build)();
        let task = task(1000);
        let room = Arc::new(EpisodeRoom::new(&plan, &task.robot).unwrap());
        let conditions = Conditions {
            slip: crate::SlipLevel::Harsh,
            noise: crate::Noise::all(crate::NoiseLevel::Harsh),
            ..Conditions::default()
        };
        let observed = |seed| {
            let mut episode = Episode::new(&task, &room, conditions, None, seed);
            let (mut readings, mut map) = (vec![0.0; READINGS], vec![0; PATCH_LEN]);
            let mut seen = vec![0.0; truth::VALUES];
            for step in 0..100 {
                episode.step(Drive::wheels(0.4, if step % 30 < 20 { 0.4 } else { -0.2 }));
                episode.observe(Observations {
                    readings: Some(&mut readings),
                    map: Some(&mut map),
                    truth: Some(&mut seen),
                });
            }
            (readings, map, seen)
        };
        assert_eq!(observed(3), observed(3));
        assert_ne!(observed(3).0, observed(4).0);
    }
}
