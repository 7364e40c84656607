//! Frontier-based exploration (Yamauchi 1997).
//!
//! Yamauchi's robot sees far, and drives to the nearest border between free and unknown cells that it can reach. A
//! Roomba senses a few centimetres, and knows only floor that it has visited. So there are two kinds of borders here:
//!
//! - *Walls*, which are followed by light, with the law of [`wall_follow`](super::super::wall_follow), until the robot
//!   reaches a part that it has followed before. After a number of metres it leaves a wall for nearer goals and returns
//!   later, so that loops stay short, and walls are revisited while the error of the pose is small.
//! - *Floor*, which is crossed in lanes. A lane is a line of unknown cells on which the robot fits, entered from known floor.
//!   The nearest one is next, long ones before short ones. A wall that it meets there for the first time is followed.
//!
//! A robot with a laser scanner is Yamauchi's again: it sees walls and floor from afar, drives to the nearest floor that it
//! hasn't seen, and stops before obstacles.
//!
//! All of it is planned on the map of the robot's own [`Mapper`] and driven by the Mapper's pose. As poses can jump and
//! maps can be wrong, attempts at each place are limited, unexpected obstacles are driven around, edges and virtual
//! walls are barred, and ways that take too long are given up. The map is complete when no lane is left. A kidnapped
//! robot relocalises on its map so far before it continues.
//!
//! Distances, numbers of tries and the order of the two kinds are ours.
//!
//! ```
//! use robovac_sim::controller::*;
//! use robovac_core::{registry::Params, robot::*};
//! let info = find("explore_frontier").unwrap();
//! let (robot, params) = (model("roomba600").unwrap(), Params::defaults(info.params));
//! let mut explorer = info.build(&Setup { robot, params: &params, seed: 1 }).unwrap();
//! let ahead = explorer.step(&SensorReadings::default(), 0.015);
//! assert!(ahead.left > 0.0 && ahead.left == ahead.right);
//! assert_eq!(explorer.activity(), "searching for a wall");
//! assert!(explorer.mapper().is_some() && !explorer.is_done());
//! ```

use super::{BACK_FROM_EDGE, trace::WallTrace};
use crate::controller::parts::{AttemptBudget, THERE};
use crate::{
    controller::{
        BehaviourClaims, BehaviourInfo, BuildBehaviour, Intent, Setup,
        parts::{
            Barred, Behaviour, Lookout, Obstruction, ObstructionKind, ObstructionSide, Pilot, Reactive,
            RelocaliseSearch, Route, Searched, TRACKING, chosen_tracking,
        },
        wall_follow::WallFollow,
    },
    mapping::{Mapper, MapperSetup},
};
use robovac_core::{
    geometry::{Point, Pose},
    registry::{Example, Explainer, ParamKind, ParamSpec},
    robot::{Drive, OdometryModel, SensorReadings},
};

/// Distance along a known wall after which following ends, m.
const OVERLAP: f64 = 0.6;
/// How often it tries to return to the start.
const WAYS_HOME: u32 = 5;
/// Way back from obstacles, m.
const BACK: f64 = 0.03;
/// Direction of a bumper contact on one side, rad.
const SIDE: f64 = 0.6;
/// Signal of the two middle light sensors that counts as an obstacle ahead: a wall at 8 cm.
const AHEAD: u16 = 600;
/// Room ahead of a robot with a laser that counts as an obstacle, and that in which it slows down, m.
const ROOM: f64 = 0.05;
const NEAR: f64 = 0.25;
/// Share of the speed with something in sight.
const CAREFUL: f64 = 0.45;
/// Distance for which it searches for a lost wall, m.
const LOST: f64 = 1.5;
/// A robot that moves less than this distance in this time is stuck, m and s.
const STUCK: (f64, f64) = (0.15, 25.0);

pub(in crate::controller) const INFO: BehaviourInfo = BehaviourInfo {
    id: "explore_frontier",
    title: "Frontiers",
    summary: "Drives to the nearest frontier of its map, following walls and crossing open floor in lanes, until no \
        frontier is left.",
    claims: BehaviourClaims { ends: true, explores: true, ..BehaviourClaims::NONE },
    params: &[
        TRACKING,
        ParamSpec {
            id: "odometry",
            label: "Odometry",
            help: "Odometry from encoder counts or distance and angle packets, along arcs or straight segments.",
            kind: ParamKind::Choice {
                options: &[
                    ("arc", "counts, arcs"),
                    ("straight", "counts, straight"),
                    ("packet_arc", "packets, arcs"),
                    ("packet_straight", "packets, straight"),
                ],
            },
        },
        ParamSpec {
            id: "lane",
            label: "Lanes",
            help: "Distance between lanes on open floor; obstacles narrower than the gaps may be missed.",
            kind: ParamKind::Number { min: 20.0, max: 100.0, step: 5.0, default: 45.0, unit: "cm" },
        },
        ParamSpec {
            id: "leg",
            label: "Along a wall",
            help: "Distance it follows a wall before visiting nearby frontiers; shorter legs close loops sooner.",
            kind: ParamKind::Number { min: 2.0, max: 100.0, step: 1.0, default: 25.0, unit: "m" },
        },
        ParamSpec {
            id: "home",
            label: "Return to start",
            help: "Drives back to the start once the map is complete.",
            kind: ParamKind::Flag { default: false },
        },
    ],
};

/// Its explanation.
pub(in crate::controller) const EXPLAINER: Explainer = Explainer {
    idea: "The robot builds a map as it drives, always to the nearest frontier, where known floor borders on \
           unknown. It follows new walls by its light bumper until it reaches a part already followed, and crosses \
           open floor in lanes. When no frontier can be reached any more, the map is complete.",
    complexity: "O(n log n) time for each new goal in a map of n cells, and O(n) memory.",
    use_when: "To map a whole flat: it finds what is missing and knows when the map is complete. It depends on a \
        good pose estimate, which drifts in large halls with few landmarks.",
    shines: Example {
        room: "flat",
        why: "It visits every room, goes round every piece of furniture once, and stops when the map is complete.",
    },
    fails: Example {
        room: "hotel",
        why: "Corridors and small rooms are one long wall: following it finds as much, without a map.",
    },
    source: "Yamauchi 1997, A frontier-based approach for autonomous exploration, CIRA; wall following and lanes for a \
             short-sighted robot are ours",
    link: "https://doi.org/10.1109/CIRA.1997.613851",
};

pub(in crate::controller) const BUILD: BuildBehaviour = |setup| {
    let tracking = chosen_tracking(setup);
    let start = Pose::new(0.0, 0.0, 0.0);
    let odometry = OdometryModel::parse(setup.params.choice("odometry")).unwrap_or_default();
    let mapper = MapperSetup { robot: setup.robot.clone(), start, tracking, odometry, seed: setup.seed };
    Reactive::boxed(setup, Frontier::new(setup, Mapper::new(mapper)))
};

/// The behaviour.
#[derive(Clone)]
pub(super) struct Frontier {
    pub(super) mapper: Mapper,
    /// Distance between lanes, cells.
    pub(super) spacing: i32,
    /// Distance along a wall before it is left, m.
    leg: f64,
    /// How often it can still try to return to the start.
    pub(super) ways_home: u32,
    wall: WallFollow,
    pub(super) trace: WallTrace,
    pub(super) phase: ExplorePhase,
    /// Poses at which it left unfinished walls.
    pub(super) ends: Vec<Pose>,
    /// Attempts at places.
    pub(super) budget: AttemptBudget,
    /// Cells of the map that must not be entered.
    pub(super) barred: Barred,
    pub(super) doubts: u32,
    /// Candidate lanes of the last decision, m.
    pub(super) lanes: Vec<[Point; 2]>,
    /// Position of the last motion, and time since, s.
    moved: (Point, f64),
    /// Whether it is, or was, lifted.
    is_lifted: bool,
    search: RelocaliseSearch,
    /// Its scanner; `None` for a robot that sees no farther than its light bumper.
    pub(super) lookout: Option<Lookout>,
}

#[derive(Clone)]
pub(super) enum ExplorePhase {
    /// Searches for a wall or follows one; distances of the pilot, m, at the start and at the last contact.
    Follow {
        began: f64,
        felt: f64,
        has_met: bool,
    },
    /// Chooses the next goal.
    Choose,
    /// Drives to a goal, with a time limit, s.
    Drive {
        route: Route,
        patience: f64,
        to: DriveGoal,
        place: Point,
    },
    /// Relocalises on its map: it was kidnapped.
    Search,
    Done,
    /// It couldn't relocalise.
    Lost {
        has_looked: bool,
    },
}

/// Goal of a drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum DriveGoal {
    /// To explore a lane.
    Floor,
    /// To continue along a wall where it was left.
    Wall(Pose),
    Home,
}

impl Frontier {
    pub(super) fn new(setup: &Setup<'_>, mapper: Mapper) -> Self {
        let resolution = mapper.map().resolution();
        Self {
            spacing: ((setup.params.number("lane") / 100.0 / resolution).round() as i32).max(1),
            leg: setup.params.number("leg"),
            ways_home: if setup.params.flag("home") { WAYS_HOME } else { 0 },
            wall: WallFollow::endless(setup),
            trace: WallTrace::default(),
            phase: ExplorePhase::Choose,
            ends: Vec::new(),
            budget: AttemptBudget::default(),
            barred: Barred::new(resolution),
            doubts: 0,
            lanes: Vec::new(),
            moved: (Point::origin(), 0.0),
            is_lifted: false,
            search: RelocaliseSearch::new(setup),
            lookout: Lookout::new(setup.robot),
            mapper,
        }
    }

    /// Follows a wall. A robot with a laser sees walls from afar, and goes on to the next frontier.
    pub(super) fn follow(&mut self, pilot: &mut Pilot) {
        if self.lookout.is_some() {
            self.choose();
            return;
        }
        self.wall.begin(pilot);
        self.phase = ExplorePhase::Follow { began: pilot.ahead(), felt: pilot.ahead(), has_met: false };
    }

    /// The wall that it was following or approaching when it was kidnapped; the pose is still that of the lift.
    fn unfinished(&self) -> Option<Pose> {
        match self.phase {
            ExplorePhase::Follow { has_met: true, .. } => Some(self.mapper.pose()),
            ExplorePhase::Drive { to: DriveGoal::Wall(end), .. } => Some(end),
            _ => None,
        }
    }

    fn choose(&mut self) {
        if let ExplorePhase::Drive { place, .. } = self.phase {
            self.budget.stopped_at(self.mapper.pose().position(), place);
        }
        self.trace.stop();
        self.phase = ExplorePhase::Choose;
    }

    /// Reacts to an obstacle on a route, at an angle to the left of straight ahead, rad: a new wall is followed,
    /// anything else driven around.
    fn meet(&mut self, pilot: &mut Pilot, aside: f64) {
        let pose = self.mapper.pose();
        if let ExplorePhase::Drive { to: DriveGoal::Wall(end), .. } = self.phase {
            if (pose.position() - end.position()).norm() < THERE {
                self.follow(pilot);
                return;
            }
            self.ends.push(end);
        }
        if self.lookout.is_some() || self.trace.has_any(pose) {
            self.barred.met(pose, pilot.robot.radius, aside);
            self.choose();
        } else {
            self.follow(pilot);
        }
    }

    /// Whether it has made no progress for long.
    fn is_stuck(&mut self, dt_s: f64) -> bool {
        let here = self.mapper.pose().position();
        let (place, since) = self.moved;
        self.moved = if (here - place).norm() > STUCK.0 { (here, 0.0) } else { (place, since + dt_s) };
        self.moved.1 > STUCK.1
    }

    fn roam_along(&mut self, pilot: &mut Pilot, sensed: &SensorReadings, dt_s: f64) -> Drive {
        let ExplorePhase::Follow { began, mut felt, mut has_met } = self.phase else { return Drive::STOP };
        let drive = self.wall.roam(pilot, sensed, dt_s);
        let ahead = pilot.ahead();
        let mut overlap = 0.0;
        if self.wall.has_wall() {
            (felt, has_met) = (ahead, true);
            overlap = self.trace.follow(self.mapper.pose());
        }
        self.phase = ExplorePhase::Follow { began, felt, has_met };
        let is_lost = has_met && (!self.wall.has_wall() || ahead - felt > LOST);
        if overlap > OVERLAP || is_lost {
            self.choose();
        } else if ahead - began > self.leg && has_met && overlap == 0.0 {
            self.ends.push(self.mapper.pose());
            self.choose();
        }
        drive
    }
}

impl Behaviour for Frontier {
    fn begin(&mut self, pilot: &mut Pilot) {
        let is_carried = std::mem::take(&mut self.is_lifted);
        if matches!(self.phase, ExplorePhase::Search) && !is_carried {
            return;
        }
        self.trace.stop();
        self.moved.1 = 0.0;
        if !self.mapper.is_lost() {
            self.follow(pilot);
            return;
        }
        self.ends.extend(self.unfinished());
        let has_looked = self.search.begin(pilot, &self.mapper);
        self.phase = if has_looked { ExplorePhase::Search } else { ExplorePhase::Lost { has_looked } };
    }

    fn watch(&mut self, sensed: &SensorReadings, dt_s: f64) {
        self.is_lifted |= sensed.wheel_drop_left && sensed.wheel_drop_right;
        self.mapper.update(sensed);
        if matches!(self.phase, ExplorePhase::Search) {
            match self.search.watch(&mut self.mapper, sensed, dt_s) {
                Searched::Looking => {}
                Searched::Found => {
                    self.moved = (self.mapper.pose().position(), 0.0);
                    self.phase = ExplorePhase::Choose;
                }
                Searched::InVain => self.phase = ExplorePhase::Lost { has_looked: true },
            }
        }
    }

    fn roam(&mut self, pilot: &mut Pilot, sensed: &SensorReadings, dt_s: f64) -> Drive {
        if matches!(self.phase, ExplorePhase::Search) {
            return self.search.roam(pilot, sensed, dt_s);
        }
        if self.lookout.is_some() && self.mapper.is_lost() && !self.is_done() {
            // Only its scans have told that it was carried elsewhere.
            let has_looked = self.search.begin(pilot, &self.mapper);
            self.phase = if has_looked { ExplorePhase::Search } else { ExplorePhase::Lost { has_looked } };
            return Drive::STOP;
        }
        if self.is_stuck(dt_s) && !self.is_done() {
            self.moved.1 = 0.0;
            self.doubts += 1;
            self.choose();
        }
        match &mut self.phase {
            ExplorePhase::Search | ExplorePhase::Done | ExplorePhase::Lost { .. } => Drive::STOP,
            ExplorePhase::Choose => {
                self.decide(pilot);
                Drive::STOP
            }
            ExplorePhase::Follow { .. } => self.roam_along(pilot, sensed, dt_s),
            ExplorePhase::Drive { route, patience, to, .. } => {
                *patience -= dt_s;
                let to = *to;
                let [_, lights @ .., _] = sensed.light_signal;
                let room = self.lookout.as_ref().map_or(f64::INFINITY, |lookout| lookout.room_ahead(sensed));
                if (lights[1].max(lights[2]) > AHEAD || room < ROOM) && route.is_driving() {
                    self.meet(pilot, 0.0);
                    return Drive::STOP;
                }
                let is_near = sensed.light_bumper[1..5].contains(&true) || room < NEAR;
                let speed = pilot.speed * if is_near { CAREFUL } else { 1.0 };
                let drive = if *patience > 0.0 { route.steer(self.mapper.pose(), &pilot.robot, speed) } else { None };
                if drive.is_none() {
                    match to {
                        DriveGoal::Wall(_) => self.follow(pilot),
                        DriveGoal::Floor => self.choose(),
                        // After an interrupted return it can try again.
                        DriveGoal::Home if *patience < 0.0 => self.choose(),
                        DriveGoal::Home => self.phase = ExplorePhase::Done,
                    }
                }
                drive.unwrap_or(Drive::STOP)
            }
        }
    }

    fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction) {
        if matches!(self.phase, ExplorePhase::Search) {
            return self.search.on_obstruction(pilot, obstruction);
        }
        let pose = self.mapper.pose();
        if obstruction.kind != ObstructionKind::Bump {
            self.barred.edge(pose, pilot.robot.radius);
            pilot.answer(obstruction, BACK_FROM_EDGE, &[]);
            self.choose();
            return;
        }
        match &self.phase {
            ExplorePhase::Follow { .. } => self.wall.on_obstruction(pilot, obstruction),
            // After turning away from a contact it can start.
            ExplorePhase::Drive { route, .. } if !route.is_driving() => {}
            ExplorePhase::Drive { to: DriveGoal::Floor, .. } if self.lookout.is_none() && !self.trace.has_any(pose) => {
                self.follow(pilot);
                self.wall.on_obstruction(pilot, obstruction);
            }
            ExplorePhase::Drive { .. } => {
                let aside = match obstruction.side {
                    ObstructionSide::Left => SIDE,
                    ObstructionSide::Front => 0.0,
                    ObstructionSide::Right => -SIDE,
                };
                self.meet(pilot, aside);
                pilot.answer(obstruction, BACK, &[]);
            }
            ExplorePhase::Choose | ExplorePhase::Search | ExplorePhase::Done | ExplorePhase::Lost { .. } => {
                pilot.answer(obstruction, BACK, &[]);
            }
        }
    }

    fn is_done(&self) -> bool {
        matches!(self.phase, ExplorePhase::Done | ExplorePhase::Lost { .. })
    }

    fn activity(&self) -> &'static str {
        match &self.phase {
            ExplorePhase::Follow { .. } => self.wall.activity(),
            ExplorePhase::Choose => "choosing the next frontier",
            ExplorePhase::Drive { to: DriveGoal::Floor, .. } => "driving to a frontier",
            ExplorePhase::Drive { to: DriveGoal::Wall(_), .. } => "driving to the end of a known wall",
            ExplorePhase::Drive { to: DriveGoal::Home, .. } => "driving back to the start",
            ExplorePhase::Search => "relocalising on its map",
            ExplorePhase::Done => "done: the map is complete",
            ExplorePhase::Lost { has_looked: true } => "done: relocalisation failed",
            ExplorePhase::Lost { has_looked: false } => "done: kidnapped, and the map is too empty to relocalise",
        }
    }

    fn mapper(&self) -> Option<&Mapper> {
        Some(&self.mapper)
    }

    fn intent(&self) -> Option<Intent<'_>> {
        let route = if let ExplorePhase::Drive { route, .. } = &self.phase { route.rest() } else { &[] };
        let locator = self.search.locator().filter(|_| matches!(self.phase, ExplorePhase::Search));
        Some(Intent { route, frontiers: &self.lanes, locator, ..Intent::default() })
    }

    fn start_at(&mut self, start: Pose) {
        self.mapper = Mapper::new(MapperSetup { start, ..self.mapper.setup().clone() });
    }

    fn boxed_clone(&self) -> Box<dyn Behaviour> {
        Box::new(self.clone())
    }
}
