//! Cleaning by the robot's own map: the remaining floor is planned on it and driven by the estimated pose.
//!
//! 1. *Remaining floor* is the floor reachable by the map, less the floor swept by its
//!    [`Marks`](crate::mapping::Marks). It consists of connected parts.
//! 2. The *nearest part* is next. One of the planners plans a walk that covers it, which is driven as a line. Then the
//!    remaining floor is computed again, with the new map and pose.
//! 3. *Obstacles that aren't on the map* are barred, in addition to the mapper's update, and the remaining floor is
//!    computed again. Edges and virtual walls are barred for ever; other obstacles get another chance when nothing else
//!    is left.
//! 4. A robot that was *picked up* doesn't know its pose. It follows walls until only one pose on its map is possible
//!    ([`locate`](crate::mapping::locate)), or it comes to its dock, and continues cleaning.
//! 5. It is *done* when no reachable floor is left, narrow gaps included. If it has been on its dock, it goes there.
//!
//! It always ends: every start, every passed place and every stop is counted ([`AttemptBudget`]), and ways that take
//! too long are given up.
//!
//! Planning by parts of what is left, on a map that changes, and all figures here are ours.

mod aims;
mod remains;

use crate::controller::parts::AttemptBudget;

use self::remains::name_at;
use super::{
    Controller, Intent, Setup,
    dock::Dock,
    parts::{
        Barred, Behaviour, GO_HOME, LEAVE_HOME, Lookout, Move, Obstruction, ObstructionKind, ObstructionSide, Pilot,
        Reactive, RelocaliseSearch, Route, Searched,
    },
};
use crate::mapping::{Mapper, TiledLayer};
use robovac_core::{
    geometry::Point,
    grid::Cell,
    registry::Params,
    robot::{Drive, SensorReadings},
};
use std::sync::Arc;

/// A robot that moves less than this distance in this time is stuck, m and s; and how often that can happen.
const STUCK: (f64, f64) = (0.15, 25.0);
const MOST_STUCK: u32 = 12;
/// Way back and turn when stuck, m and rad.
const LOOSE: (f64, f64) = (0.1, 1.2);
/// Way back from obstacles and from the edge of the floor, m.
const BACK: f64 = 0.03;
const BACK_FROM_EDGE: f64 = 0.15;
/// Direction of a bumper contact on one side, rad.
const SIDE: f64 = 0.6;
/// Room ahead in which a robot with a laser slows down, m.
const NEAR: f64 = 0.15;
/// Share of the speed with something in sight.
const CAREFUL: f64 = 0.45;
/// Time limit for docking, s.
const DOCK_S: f64 = 400.0;

/// Cleans the floor that `mapper` has left, with plans of the planner `planner`.
pub fn clean_by_map(mapper: Mapper, planner: &'static str) -> Box<dyn Controller> {
    let (robot, seed) = (mapper.setup().robot.clone(), mapper.setup().seed);
    // A robot that has never been on a dock doesn't know of one.
    let params = Params::defaults(if mapper.berth().is_some() { &[GO_HOME, LEAVE_HOME] } else { &[] });
    let setup = Setup { robot: &robot, params: &params, seed };
    Reactive::boxed(&setup, ByMap::new(&setup, mapper, planner))
}

/// The behaviour.
#[derive(Clone)]
struct ByMap {
    mapper: Mapper,
    planner: &'static str,
    phase: CleaningPhase,
    barred: Barred,
    budget: AttemptBudget,
    /// The planning cell that it is in.
    at: Option<Cell>,
    /// Reachable floor, in cells of the map.
    reach: Arc<TiledLayer<bool>>,
    /// Cells swept when it last found nothing left.
    swept: usize,
    stuck: u32,
    /// Position of the last motion, and time since, s.
    moved: (Point, f64),
    /// Whether it is, or was, lifted.
    is_lifted: bool,
    search: RelocaliseSearch,
    lookout: Option<Lookout>,
    dock: Dock,
}

#[derive(Clone)]
enum CleaningPhase {
    /// Decides what is next.
    Choose,
    /// Cleans along a line, with a time limit, s.
    Clean {
        route: Route,
        patience: f64,
        goal: Cell,
    },
    /// Relocalises on its map.
    Search,
    /// Returns to its start, with a time limit, s.
    Return {
        route: Route,
        patience: f64,
        end: RunEnd,
    },
    /// Drives onto its dock, with a time limit, s.
    Dock {
        patience: f64,
        end: RunEnd,
    },
    Done(RunEnd),
}

/// Outcome of the run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum RunEnd {
    Clean,
    NothingReachable,
    Lost,
    Stuck,
}

impl ByMap {
    fn new(setup: &Setup<'_>, mapper: Mapper, planner: &'static str) -> Self {
        Self {
            barred: Barred::new(mapper.map().resolution()),
            planner,
            phase: CleaningPhase::Choose,
            budget: AttemptBudget::default(),
            at: None,
            reach: Arc::default(),
            swept: 0,
            stuck: 0,
            moved: (mapper.pose().position(), 0.0),
            is_lifted: mapper.is_lost(),
            search: RelocaliseSearch::new(setup),
            lookout: Lookout::new(setup.robot),
            dock: Dock::new(setup),
            mapper,
        }
    }

    /// Records a stop on the way to the present goal, which limits further attempts.
    fn stop(&mut self) {
        if let CleaningPhase::Clean { goal, .. } = self.phase {
            self.budget.stopped(goal);
            let pose = self.mapper.pose();
            let radius = self.mapper.setup().robot.radius;
            for ahead in [0.0, radius] {
                self.budget.stopped(self.name(pose.to_world(Point::new(ahead, 0.0))));
            }
        }
        match self.phase {
            CleaningPhase::Clean { .. } => self.phase = CleaningPhase::Choose,
            // It can still be able to dock by the beams.
            CleaningPhase::Return { end, .. } => self.phase = CleaningPhase::Dock { patience: DOCK_S, end },
            _ => {}
        }
    }

    /// Starts to relocalise.
    fn search(&mut self, pilot: &mut Pilot) {
        let can = self.search.begin(pilot, &self.mapper);
        self.phase = if can { CleaningPhase::Search } else { CleaningPhase::Done(RunEnd::Lost) };
    }

    /// Whether it has made no progress for long.
    fn is_stuck(&mut self, dt_s: f64) -> bool {
        let here = self.mapper.pose().position();
        let (place, since) = self.moved;
        self.moved = if (here - place).norm() > STUCK.0 { (here, 0.0) } else { (place, since + dt_s) };
        self.moved.1 > STUCK.1
    }

    /// Backs off and turns away when stuck.
    fn get_loose(&mut self, pilot: &mut Pilot) {
        self.moved.1 = 0.0;
        self.stuck += 1;
        self.barred.met(self.mapper.pose(), pilot.robot.radius, 0.0);
        self.stop();
        if self.stuck > MOST_STUCK {
            self.phase = CleaningPhase::Done(RunEnd::Stuck);
        }
        let turn = if self.stuck.is_multiple_of(2) { LOOSE.1 } else { -LOOSE.1 };
        pilot.go(&[Move::Back(LOOSE.0), Move::Turn(turn)]);
    }

    /// The planning cell at a place.
    fn name(&self, place: Point) -> Cell {
        name_at(place, &self.mapper.setup().robot, self.mapper.map().resolution())
    }

    /// Records that it passes a place.
    fn come_by(&mut self) {
        let cell = self.name(self.mapper.pose().position());
        if self.at.replace(cell) != Some(cell) {
            self.budget.came_by(cell);
        }
    }
}

impl Behaviour for ByMap {
    fn begin(&mut self, pilot: &mut Pilot) {
        self.moved = (self.mapper.pose().position(), 0.0);
        if std::mem::take(&mut self.is_lifted) {
            self.search(pilot);
        } else if !matches!(self.phase, CleaningPhase::Search | CleaningPhase::Done(_)) {
            self.phase = CleaningPhase::Choose;
        }
    }

    fn watch(&mut self, sensed: &SensorReadings, dt_s: f64) {
        self.is_lifted |= sensed.wheel_drop_left && sensed.wheel_drop_right;
        self.mapper.update(sensed);
        match &mut self.phase {
            CleaningPhase::Search => match self.search.watch(&mut self.mapper, sensed, dt_s) {
                Searched::Looking => {}
                Searched::Found => self.phase = CleaningPhase::Choose,
                Searched::InVain => self.phase = CleaningPhase::Done(RunEnd::Lost),
            },
            CleaningPhase::Dock { patience, end } => {
                *patience -= dt_s;
                self.dock.watch(sensed, dt_s);
                if self.dock.is_done() || *patience < 0.0 {
                    self.phase = CleaningPhase::Done(*end);
                }
            }
            _ => {}
        }
    }

    fn roam(&mut self, pilot: &mut Pilot, sensed: &SensorReadings, dt_s: f64) -> Drive {
        if matches!(self.phase, CleaningPhase::Clean { .. } | CleaningPhase::Return { .. }) {
            self.come_by();
            if self.is_stuck(dt_s) {
                self.get_loose(pilot);
                return Drive::STOP;
            }
        }
        let pose = self.mapper.pose();
        match &mut self.phase {
            CleaningPhase::Choose => {
                self.decide(pilot);
                Drive::STOP
            }
            CleaningPhase::Clean { route, patience, .. } | CleaningPhase::Return { route, patience, .. } => {
                *patience -= dt_s;
                let room = self.lookout.as_ref().map_or(f64::INFINITY, |lookout| lookout.room_ahead(sensed));
                let is_near = sensed.light_bumper[2..4].contains(&true) || room < NEAR;
                let speed = pilot.speed * if is_near { CAREFUL } else { 1.0 };
                if *patience < 0.0 {
                    self.stop();
                    return Drive::STOP;
                }
                let drive = route.steer(pose, &pilot.robot, speed);
                match (drive, &self.phase) {
                    (Some(drive), _) => return drive,
                    (None, &CleaningPhase::Return { end, .. }) => {
                        self.dock.begin(pilot);
                        self.phase = CleaningPhase::Dock { patience: DOCK_S, end };
                    }
                    (None, _) => self.phase = CleaningPhase::Choose,
                }
                Drive::STOP
            }
            CleaningPhase::Search => self.search.roam(pilot, sensed, dt_s),
            CleaningPhase::Dock { .. } => self.dock.roam(pilot, sensed, dt_s),
            CleaningPhase::Done(_) => Drive::STOP,
        }
    }

    fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction) {
        let pose = self.mapper.pose();
        match &self.phase {
            CleaningPhase::Search => return self.search.on_obstruction(pilot, obstruction),
            CleaningPhase::Dock { .. } => return self.dock.on_obstruction(pilot, obstruction),
            _ => {}
        }
        if obstruction.kind != ObstructionKind::Bump {
            self.barred.edge(pose, pilot.robot.radius);
            pilot.answer(obstruction, BACK_FROM_EDGE, &[]);
            self.stop();
            return;
        }
        // After turning away from a contact it can start.
        if matches!(&self.phase, CleaningPhase::Clean { route, .. } | CleaningPhase::Return { route, .. } if !route.is_driving())
        {
            return;
        }
        let aside = match obstruction.side {
            ObstructionSide::Left => SIDE,
            ObstructionSide::Front => 0.0,
            ObstructionSide::Right => -SIDE,
        };
        self.barred.met(pose, pilot.robot.radius, aside);
        pilot.answer(obstruction, BACK, &[]);
        self.stop();
    }

    fn is_done(&self) -> bool {
        matches!(self.phase, CleaningPhase::Done(_))
    }

    fn activity(&self) -> &'static str {
        match &self.phase {
            CleaningPhase::Choose => "planning the remaining floor",
            CleaningPhase::Clean { .. } => "cleaning by its map",
            CleaningPhase::Search => "relocalising on its map",
            CleaningPhase::Return { .. } => "driving back to its dock",
            CleaningPhase::Dock { .. } => self.dock.activity(),
            CleaningPhase::Done(RunEnd::Clean) => "done: nothing on its map is worth another pass",
            CleaningPhase::Done(RunEnd::NothingReachable) => "done: the remaining floor is unreachable",
            CleaningPhase::Done(RunEnd::Lost) => "done: relocalisation failed",
            CleaningPhase::Done(RunEnd::Stuck) => "done: the robot is stuck",
        }
    }

    fn mapper(&self) -> Option<&Mapper> {
        Some(&self.mapper)
    }

    fn intent(&self) -> Option<Intent<'_>> {
        let route: &[Point] = match &self.phase {
            CleaningPhase::Clean { route, .. } | CleaningPhase::Return { route, .. } => route.rest(),
            _ => &[],
        };
        let locator = self.search.locator().filter(|_| matches!(self.phase, CleaningPhase::Search));
        Some(Intent { route, frontiers: &[], reach: Some(&self.reach), locator })
    }

    fn boxed_clone(&self) -> Box<dyn Behaviour> {
        Box::new(self.clone())
    }
}
