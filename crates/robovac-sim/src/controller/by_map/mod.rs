//! Cleaning by the robot's own map: the remaining floor is planned on it and driven by the estimated pose.
//!
//! 1. *What is left* is floor that the robot can get to by its map, less what its [`Marks`](crate::mapping::Marks) say is
//!    swept. It falls into connected parts.
//! 2. The *nearest part* is next. One of the planners plans a walk that covers it, which is driven as a line. Then what
//!    is left is computed again: by then the map has grown, and the pose has been corrected.
//! 3. *What the map doesn't have* and the robot meets is barred, beside what the mapper makes of it, and what is left is looked at
//!    anew. Edges and virtual walls are barred for ever; what else was met gets another chance when nothing else is left.
//! 4. A robot that was *picked up* doesn't know where it is. It follows walls until there is only one place on its map where
//!    it can be ([`locate`](crate::mapping::locate)), and goes on cleaning.
//! 5. It is *done* when nothing is left that it can get to, also by squeezing through where the map shows too little room. If it
//!    began on its dock, it goes there.
//!
//! It ends, whatever happens: every way that it sets out for, every place that it comes by and every stop is counted
//! ([`AttemptBudget`]), and ways that take too long are given up.
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
        Barred, Behaviour, GO_HOME, LEAVE_HOME, Move, Obstruction, ObstructionKind, ObstructionSide, Pilot, Reactive,
        RelocaliseSearch, Route, Searched,
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

/// A robot that has moved less than that in so long is stuck, m and s; and how often it may be.
const STUCK: (f64, f64) = (0.15, 25.0);
const MOST_STUCK: u32 = 12;
/// Way back and turn away when it is stuck, m and rad.
const LOOSE: (f64, f64) = (0.1, 1.2);
/// Way back from what was met and from the edge of the floor, m.
const BACK: f64 = 0.03;
const BACK_FROM_EDGE: f64 = 0.15;
/// Directions of what the bumper felt on one side, rad.
const SIDE: f64 = 0.6;
/// Share of the speed with something in sight.
const CAREFUL: f64 = 0.45;
/// How long it tries to get onto its dock, s.
const DOCK_S: f64 = 400.0;

/// Cleans what `mapper` has left, by a plan of the planner with that id.
pub fn clean_by_map(mapper: Mapper, planner: &'static str) -> Box<dyn Controller> {
    let (robot, seed) = (mapper.setup().robot.clone(), mapper.setup().seed);
    // Who hasn't begun on a dock doesn't know of any.
    let params = Params::defaults(if mapper.began_on_dock() { &[GO_HOME, LEAVE_HOME] } else { &[] });
    let setup = Setup { robot: &robot, params: &params, seed };
    Reactive::boxed(&setup, ByMap::new(&setup, mapper, planner))
}

/// The habit.
#[derive(Clone)]
struct ByMap {
    mapper: Mapper,
    planner: &'static str,
    phase: CleaningPhase,
    barred: Barred,
    budget: AttemptBudget,
    /// The planning cell that it is in.
    at: Option<Cell>,
    /// What it can get to, in cells of the map.
    reach: Arc<TiledLayer<bool>>,
    /// Cells that were swept when it last thought that nothing was left.
    swept: usize,
    stuck: u32,
    /// Where it was last seen to move, and how long ago, s.
    moved: (Point, f64),
    /// Whether it is, or was, held.
    is_lifted: bool,
    search: RelocaliseSearch,
    dock: Dock,
}

#[derive(Clone)]
enum CleaningPhase {
    /// Decides what is next.
    Choose,
    /// Cleans along a line, for so long yet, s.
    Clean {
        route: Route,
        patience: f64,
        goal: Cell,
    },
    /// Relocalises on its map.
    Search,
    /// Goes back to where it began, for so long yet, s.
    Return {
        route: Route,
        patience: f64,
        end: RunEnd,
    },
    /// Drives onto its dock, for so long yet, s.
    Dock {
        patience: f64,
        end: RunEnd,
    },
    Done(RunEnd),
}

/// How it ends.
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
            dock: Dock::new(setup),
            mapper,
        }
    }

    /// Something stops it: what it was going for, it won't go for again and again.
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
            // By its beams it may get there from here as well.
            CleaningPhase::Return { end, .. } => self.phase = CleaningPhase::Dock { patience: DOCK_S, end },
            _ => {}
        }
    }

    /// Starts to look for itself.
    fn search(&mut self, pilot: &mut Pilot) {
        let can = self.search.begin(pilot, &self.mapper);
        self.phase = if can { CleaningPhase::Search } else { CleaningPhase::Done(RunEnd::Lost) };
    }

    /// Whether it hasn't got anywhere for long.
    fn is_stuck(&mut self, dt_s: f64) -> bool {
        let here = self.mapper.pose().position();
        let (place, since) = self.moved;
        self.moved = if (here - place).norm() > STUCK.0 { (here, 0.0) } else { (place, since + dt_s) };
        self.moved.1 > STUCK.1
    }

    /// Backs off and turns away from wherever it hangs.
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

    /// Notes where it comes by.
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
                let is_near = sensed.light_bumper[2..4].contains(&true);
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
        // Turned away from what it touches, it may drive off.
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
            CleaningPhase::Done(RunEnd::Clean) => "done: all reachable floor on its map is clean",
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
