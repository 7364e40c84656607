//! `ros2`: simulated robots as nodes of ROS 2, without an installation of it.

mod node;
mod watched;

pub use node::{NodeArguments, Participant, RosNode};
pub use watched::{WatchedArguments, WatchedNode};

use super::{
    conditions::ConditionsArguments,
    failure::Failure,
    output::say,
    plan,
    signals::end_requested,
    simulate::{DEFAULT_ROBOT, parse_seconds},
    task::{ParamArguments, PlacementArguments},
};
use robovac_core::{
    floor_plan::FloorPlan,
    geometry::Point,
    robot::{Drive, RobotModel, SensorReadings},
};
use robovac_ros::{Pace, RunTopics, SourceMap, message, message::Velocity, topic};
use robovac_sim::{
    Run, STEP_S,
    controller::{self, Controller},
    experiment::planning::{Placement, PlanningTask, RoomSetup},
};
use std::{
    cell::Cell,
    rc::Rc,
    sync::atomic::Ordering,
    thread,
    time::{Duration, Instant, SystemTime, UNIX_EPOCH},
};

/// Time between two looks at the clock and at commands.
const LOOK: Duration = Duration::from_millis(5);
/// Time without a command after which a robot stops: teleoperation and navigation send ten or more a second.
const LOST: Duration = Duration::from_millis(500);
/// Longest time by which the simulation lags before it gives up catching up, s.
const LAG_S: f64 = 0.5;

/// Simulate a robot as a node of ROS 2, which needn't be installed: the node publishes map, odometry, frames and sensors,
/// and is driven by velocity commands, or by --planner or --behaviour
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    placement: PlacementArguments,
    /// Planner that drives instead of commands, see "robovac planners"
    #[arg(long, value_name = "ID", conflicts_with = "behaviour")]
    planner: Option<String>,
    /// Behaviour that drives instead of commands, see "robovac behaviours"
    #[arg(long, value_name = "ID")]
    behaviour: Option<String>,
    #[command(flatten)]
    params: ParamArguments,
    #[command(flatten)]
    conditions: ConditionsArguments,
    /// Namespace of a robot; can be repeated: each robot has its own room and the next seed
    #[arg(long, value_name = "NAME")]
    namespace: Vec<String>,
    #[command(flatten)]
    node: NodeArguments,
    /// Simulated time: stamps count from 0, and /clock is published, for nodes that use it
    #[arg(long)]
    sim_time: bool,
    /// Speed, times real time; other than 1 implies --sim-time
    #[arg(long, value_name = "TIMES", default_value_t = 1.0, value_parser = parse_seconds)]
    speed: f64,
    /// Simulated time after which it ends [default: Ctrl-C]
    #[arg(long, value_name = "S", value_parser = parse_seconds, allow_hyphen_values = true)]
    seconds: Option<f64>,
}

/// A simulated robot with its node.
struct Robot {
    node: RosNode,
    run: Run,
    topics: RunTopics,
    remote: Option<Remote>,
    heard: Instant,
}

/// A controller that drives as it is told.
#[derive(Clone)]
struct Remote {
    wanted: Rc<Cell<Drive>>,
}

impl Controller for Remote {
    fn step(&mut self, _: &SensorReadings, _: f64) -> Drive {
        self.wanted.get()
    }

    fn is_done(&self) -> bool {
        false
    }

    fn boxed_clone(&self) -> Box<dyn Controller> {
        Box::new(self.clone())
    }
}

/// Simulates until it is to end.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let is_simulated = arguments.sim_time || arguments.speed != 1.0;
    let scene = NodeScene::new(arguments)?;
    let is_over = end_requested()?;
    let participant = Participant::new(&arguments.node)?;
    let pace = Pace { epoch_s: if is_simulated { 0.0 } else { since_1970() }, ..Pace::LIVE };
    let namespaces: &[String] = if arguments.namespace.is_empty() { &[String::new()] } else { &arguments.namespace };
    let robots = namespaces.iter().zip(0..).map(|(namespace, i)| scene.robot(&participant, namespace, i, pace));
    let mut robots = robots.collect::<Result<Vec<Robot>, Failure>>()?;
    for robot in &mut robots {
        robot.publish()?;
        say(&format!("{} is ready in domain {}", robot.node.name(), participant.domain()));
    }
    let mut began = Instant::now();
    let mut steps = 0_u64;
    let most = arguments.seconds.map_or(u64::MAX, |seconds| (seconds / STEP_S).ceil() as u64);
    while !is_over.load(Ordering::Relaxed) && steps < most && robots.iter().any(|robot| !robot.run.is_finished()) {
        let due = began.elapsed().as_secs_f64() * arguments.speed / STEP_S;
        if due - steps as f64 > LAG_S * arguments.speed.max(1.0) / STEP_S {
            // Time that this computer doesn't have isn't made up for.
            let simulated = Duration::from_secs_f64(steps as f64 * STEP_S / arguments.speed);
            began = Instant::now().checked_sub(simulated).unwrap_or(began);
        }
        for robot in &mut robots {
            robot.listen();
        }
        while steps < most.min(due as u64) {
            steps += 1;
            for robot in &mut robots {
                robot.step()?;
            }
            if is_simulated && let Some(first) = robots.first_mut() {
                let now = steps as f64 * STEP_S;
                first.node.publish([topic::CLOCK.stamped(now, message::clock(now))])?;
            }
        }
        thread::sleep(LOOK);
    }
    Ok(String::new())
}

/// The time of stamps in real time, s.
fn since_1970() -> f64 {
    SystemTime::now().duration_since(UNIX_EPOCH).map_or(0.0, |since| since.as_secs_f64())
}

/// What all robots have in common.
struct NodeScene<'a> {
    arguments: &'a Arguments,
    placement: Placement,
    prepared: RoomSetup,
    line: Vec<Point>,
}

impl<'a> NodeScene<'a> {
    fn new(arguments: &'a Arguments) -> Result<Self, Failure> {
        let placement = arguments.placement.placement(DEFAULT_ROBOT)?;
        let (prepared, line) = match &arguments.planner {
            None => (placement.prepare()?, Vec::new()),
            Some(id) => {
                let planner = plan::planner(id)?;
                let params = arguments.params.checked(planner.params)?;
                let task = PlanningTask {
                    placement: placement.clone(),
                    planner,
                    params,
                    seed: arguments.params.seed,
                    is_rounded: false,
                };
                let began = Instant::now();
                let solution = task.solve(|| began.elapsed().as_secs_f64(), None)?;
                (solution.prepared, solution.planned.line.to_vec())
            }
        };
        Ok(Self { arguments, placement, prepared, line })
    }

    fn robot(&self, participant: &Participant<'_>, namespace: &str, i: u64, pace: Pace) -> Result<Robot, Failure> {
        let mut node = participant.node(namespace)?;
        let (run, remote) = self.run(self.arguments.params.seed.wrapping_add(i))?;
        if remote.is_some() {
            node.subscribe()?;
        }
        let (plan, robot): (&FloorPlan, &RobotModel) = (&self.placement.plan, &self.prepared.robot);
        let topics = RunTopics::new(&SourceMap { plan, robot, path: &self.line, smooth: None }, &run, pace);
        Ok(Robot { node, run, topics, remote, heard: Instant::now() })
    }

    fn run(&self, seed: u64) -> Result<(Run, Option<Remote>), Failure> {
        let Arguments { params, conditions, behaviour, .. } = self.arguments;
        let (odometry, conditions) = (conditions.odometry, conditions.conditions());
        if let Some(id) = behaviour {
            let unknown = || Failure::unknown("behaviour", id, "behaviours");
            let info = controller::find(id).ok_or_else(unknown)?;
            let params = params.checked(info.params)?;
            let run = self.prepared.run_behaviour(info, &params, conditions, seed).ok_or_else(unknown)?;
            return Ok((run, None));
        }
        if !self.line.is_empty() {
            return Ok((self.prepared.run_along(&self.line.clone().into(), conditions, odometry, seed), None));
        }
        // So that a typing error isn't overlooked.
        params.checked(&[])?;
        let remote = Remote { wanted: Rc::new(Cell::new(Drive::STOP)) };
        let run = Run::new(&self.prepared.setup(conditions, seed), Box::new(remote.clone()));
        Ok((run, Some(remote)))
    }
}

impl Robot {
    /// Takes the latest command. Without one for a while, the robot stops.
    fn listen(&mut self) {
        let Some(remote) = &self.remote else { return };
        if let Some(command) = self.node.command() {
            self.heard = Instant::now();
            remote.wanted.set(drive(command, self.topics.robot()));
        } else if self.heard.elapsed() > LOST {
            remote.wanted.set(Drive::STOP);
        }
    }

    fn step(&mut self) -> Result<(), Failure> {
        if self.run.is_finished() {
            return Ok(());
        }
        self.run.step();
        self.topics.step(&self.run);
        if self.run.is_finished() {
            self.topics.finish(&self.run);
        }
        self.publish()
    }

    /// Publishes what there is; commands only if they don't come from that topic.
    fn publish(&mut self) -> Result<(), Failure> {
        let is_remote = self.remote.is_some();
        self.node.publish(self.topics.take().filter(|message| !is_remote || *message.topic != topic::CMD_VEL))
    }
}

/// Wheel speeds for a velocity; the robot limits them.
fn drive([ahead, left, turn]: Velocity, robot: &RobotModel) -> Drive {
    Drive { lateral: left, ..Drive::from_twist(ahead, turn, robot.wheel_base) }
}
