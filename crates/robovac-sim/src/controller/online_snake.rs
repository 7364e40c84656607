//! The improved snake in an unknown room (Emu & Obaida 2020, sections 1.5 and 4.2).
//!
//! The thesis' robot detects obstacles with its laser scanner while it drives. Cells lie on the grid of its start. A cell is
//! free if the robot's body fits around its centre by the map that it makes on the way. [`OnlineSnake`] decides where to go
//! next.
//!
//! Ours: the map and the pose estimate of [`Mapper`]; an obstacle that it meets blocks the cell ahead until nothing else
//! is left to clean, and for ever when it is met again; edges and virtual walls block at once.
//!
//! ```
//! use robovac_sim::controller::*;
//! use robovac_core::{registry::Params, robot::*};
//! let info = find("online_snake").unwrap();
//! let (robot, params) = (model("cbot").unwrap(), Params::defaults(info.params));
//! let mut snake = info.build(&Setup { robot, params: &params, seed: 1 }).unwrap();
//! snake.step(&SensorReadings::default(), 0.015);
//! assert!(snake.mapper().is_some());
//! ```

use super::{
    BehaviourClaims, BehaviourInfo, BuildBehaviour, Intent, Setup,
    parts::{
        Behaviour, Lookout, Move, Obstruction, ObstructionKind, Pilot, Reactive, RelocaliseSearch, Route, Searched,
    },
};
use crate::mapping::{Mapper, MapperSetup, Tracking};
use coverage_planners::OnlineSnake;
use robovac_core::{
    geometry::{Point, Pose, Vector},
    grid::{Cell, Direction, Occupancy},
    math,
    registry::{Example, Explainer, ParamKind, ParamSpec},
    robot::{Drive, OdometryModel, SensorReadings},
};
use std::collections::BTreeMap;

/// Cells on each side of the grid, with the start in its middle.
const CELLS: usize = 256;
/// Distance up to which cells are looked at, m: farther away a scanner's points lie too far apart.
const SIGHT: f64 = 3.0;
/// How much nearer to the centre of an occupied cell of the map than its radius the body may come, m.
const SLACK: f64 = 0.01;
/// Distance from a cell's centre at which the robot has arrived, m.
const THERE: f64 = 0.03;
/// Distance off the line between two centres from which on it first returns to the one that it comes from, m.
const OFF: f64 = 0.05;
/// Room ahead in which it slows down, m, and share of the speed there.
const NEAR: f64 = 0.15;
const CAREFUL: f64 = 0.45;
/// Cosine of the heading error up to which the scanner shows what is on the line.
const ALIGNED: f64 = 0.99;
/// Room that is short of the next centre by so much shows that something stands in the way, m.
const SHORT: f64 = 0.03;
/// Way back from obstacles and from edges, m.
const BACK: f64 = 0.03;
/// How often it backs off from an obstacle that keeps it from turning, before it takes the way there for blocked.
const MOST_TURNS: u32 = 4;
const BACK_FROM_EDGE: f64 = 0.1;
/// Time for a cell, s: at first, and per metre of the way to it.
const PATIENCE: (f64, f64) = (12.0, 15.0);

pub(super) const INFO: BehaviourInfo = BehaviourInfo {
    id: "online_snake",
    title: "Snake in an unknown room",
    summary: "Follows the rules of the improved snake in a room that it discovers with its laser scanner.",
    claims: BehaviourClaims { ends: true, cleans: true, needs_laser: true, ..BehaviourClaims::NONE },
    params: &[ParamSpec {
        id: "cell",
        label: "Cell size",
        help: "Distance between neighbouring lanes, as a share of the tool's width.",
        kind: ParamKind::Number { min: 50.0, max: 100.0, step: 5.0, default: 75.0, unit: "%" },
    }],
};

/// Its explanation.
pub(super) const EXPLAINER: Explainer = Explainer {
    idea: "The robot knows nothing of the room and maps it as it drives. After each cell it decides by the rules of \
           the planner Improved snake, with the cells that it has seen so far. If its scanner sees all of the thesis' \
           room at once, it walks exactly as the planner does.",
    complexity: "O(k) time for each cell, with k cells in sight; O(n) memory for n cells.",
    use_when: "To clean an unknown room in straight lanes. It needs a laser scanner: choose the CBot or the Roomba \
               with laser.",
    shines: Example { room: "empty", why: "It sees the walls from afar and drives lanes from wall to wall." },
    fails: Example {
        room: "clutter",
        why: "It finds many small obstacles late, and comes back for the cells behind them.",
    },
    source: "Emu & Obaida 2020, thesis, East West University: sections 1.5 and 4.2; the map is ours",
    link: "",
};

pub(super) const BUILD: BuildBehaviour = |setup| {
    let mapper = MapperSetup {
        robot: setup.robot.clone(),
        start: Pose::new(0.0, 0.0, 0.0),
        tracking: Tracking::Corrected,
        odometry: OdometryModel::default(),
        seed: setup.seed,
    };
    Reactive::boxed(setup, SnakeDrive::new(setup, Mapper::new(mapper)))
};

/// The behaviour.
#[derive(Clone)]
struct SnakeDrive {
    mapper: Mapper,
    snake: OnlineSnake,
    /// Side of the cells, m.
    cell: f64,
    /// Cells in which it met something.
    met: BTreeMap<Cell, Met>,
    phase: OnlineSnakePhase,
    /// Whether it has turned round since it came to the cell, and how often it couldn't turn there.
    has_looked: bool,
    stuck_turns: u32,
    lookout: Option<Lookout>,
    is_lifted: bool,
    search: RelocaliseSearch,
}

/// What it knows of a cell in which it met something.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Met {
    /// It doesn't go there, for now.
    Once,
    /// It tries again.
    Forgiven,
    /// It never goes there.
    Barred,
}

#[derive(Clone)]
enum OnlineSnakePhase {
    /// Turns round for its scanner to see what is behind: at the start, and before it takes the room for clean.
    Look,
    /// Decides where to go.
    Choose,
    /// Drives to the next cell, and on past it if the rules lead straight on, with a time limit for the next one, s.
    Drive {
        route: Route,
        next: Cell,
        towards: Direction,
        patience: f64,
    },
    /// Relocalises on its map: it was kidnapped.
    Search,
    Done,
    /// It couldn't relocalise.
    Lost,
    /// It has no scanner.
    Blind,
}

impl SnakeDrive {
    fn new(setup: &Setup<'_>, mapper: Mapper) -> Self {
        let cell = setup.robot.tool_width * setup.params.number("cell") / 100.0;
        let middle = Cell::new((CELLS / 2) as i32, (CELLS / 2) as i32);
        Self {
            mapper,
            // Along x of its own grid.
            snake: OnlineSnake::new(CELLS, CELLS, middle, Direction::Right),
            cell,
            met: BTreeMap::new(),
            phase: if setup.robot.sensors.laser.is_some() { OnlineSnakePhase::Look } else { OnlineSnakePhase::Blind },
            has_looked: true,
            stuck_turns: 0,
            lookout: Lookout::new(setup.robot),
            is_lifted: false,
            search: RelocaliseSearch::new(setup),
        }
    }

    /// Centre of a cell, in the frame of the map.
    fn centre(&self, cell: Cell) -> Point {
        let half = (CELLS / 2) as i32;
        let (x, y) = (f64::from(cell.x - half), f64::from(cell.y - half));
        self.mapper.setup().start.to_world(Point::new(x * self.cell, y * self.cell))
    }

    /// The direction of a step on the grid, in the frame of the map.
    fn along(&self, towards: Direction) -> Vector {
        let at = self.snake.at();
        (self.centre(at.step(towards)) - self.centre(at)).normalize()
    }

    /// Whether the body fits around the centre of a cell by the map; `None` if that isn't known yet. It fits where it is.
    fn fits(&self, cell: Cell) -> Option<bool> {
        let (map, centre, here) = (self.mapper.map(), self.centre(cell), self.centre(self.snake.at()));
        let radius = self.mapper.setup().robot.radius;
        let (middle, reach) = (map.cell_at(centre), (radius / map.resolution()).ceil() as i32);
        let mut is_known = true;
        for y in middle.y - reach..=middle.y + reach {
            for x in middle.x - reach..=middle.x + reach {
                let at = Cell::new(x, y);
                let away = (map.centre(at) - centre).norm();
                match map.occupancy(at) {
                    Occupancy::Occupied if away < radius - SLACK => return Some(false),
                    Occupancy::Unknown if away < radius - SLACK => {
                        is_known &= (map.centre(at) - here).norm() < radius;
                    }
                    _ => {}
                }
            }
        }
        is_known.then_some(true)
    }

    /// Takes over what the map shows of the cells in sight.
    fn look(&mut self) {
        let at = self.snake.at();
        let reach = (SIGHT / self.cell) as i32;
        for y in at.y - reach..=at.y + reach {
            for x in at.x - reach..=at.x + reach {
                let cell = Cell::new(x, y);
                let is_shut = self.met.get(&cell).is_some_and(|&met| met != Met::Forgiven);
                if is_shut || self.snake.is_visited(cell) {
                    continue;
                }
                if let Some(fits) = self.fits(cell) {
                    self.snake.see(cell, fits);
                }
            }
        }
    }

    /// Decides where to go from where it is.
    fn choose(&mut self) {
        self.look();
        let Some(next) = self.snake.next_cell() else {
            self.phase = if !self.has_looked {
                OnlineSnakePhase::Look
            } else if self.forgive() {
                OnlineSnakePhase::Choose
            } else {
                OnlineSnakePhase::Done
            };
            self.has_looked = true;
            return;
        };
        let (at, here) = (self.snake.at(), self.mapper.pose().position());
        let Some(towards) = at.direction_to(next) else { return };
        let mut line = Vec::new();
        if self.along(towards).perp(&(here - self.centre(at))).abs() > OFF {
            line.push(self.centre(at));
        }
        let end = self.end(next, towards);
        line.push(self.centre(end));
        self.phase =
            OnlineSnakePhase::Drive { route: Route::new(here, line), next, towards, patience: self.patience(next) };
    }

    /// The last cell that it comes to without a turn.
    fn end(&mut self, next: Cell, towards: Direction) -> Cell {
        (1..self.snake.straight_on()).fold(next, |cell, _| cell.step(towards))
    }

    /// Time for the way to a cell, s.
    fn patience(&self, next: Cell) -> f64 {
        PATIENCE.0 + PATIENCE.1 * (self.centre(next) - self.mapper.pose().position()).norm()
    }

    /// It has come to the next cell; goes on without a stop where the rules lead straight on.
    fn arrive(&mut self, next: Cell, towards: Direction) {
        self.snake.arrive();
        (self.has_looked, self.stuck_turns) = (false, 0);
        self.look();
        let onward = self.snake.next_cell().filter(|&cell| next.direction_to(cell) == Some(towards));
        let Some(cell) = onward else { return self.choose() };
        let end = self.end(cell, towards);
        let end = self.centre(end);
        let (patience_s, from) = (self.patience(cell), self.centre(next));
        if let OnlineSnakePhase::Drive { route, next, patience, .. } = &mut self.phase {
            (*next, *patience) = (cell, patience_s);
            // What it sees now can lead it farther, or less far.
            if route.rest() != [end] {
                *route = Route::new(from, vec![end]);
            }
        }
    }

    /// Something is in the way to the next cell.
    fn meet(&mut self, is_barred: bool) {
        let OnlineSnakePhase::Drive { next, .. } = self.phase else { return };
        let before = self.met.get(&next);
        let met = if is_barred || before.is_some() { Met::Barred } else { Met::Once };
        self.met.insert(next, met);
        self.snake.see(next, false);
        self.phase = OnlineSnakePhase::Choose;
    }

    /// Tries once more where it met something that can have gone, and where it can't see; whether there is such a place.
    fn forgive(&mut self) -> bool {
        let once: Vec<Cell> = self.met.iter().filter(|(_, met)| **met == Met::Once).map(|(cell, _)| *cell).collect();
        let unseen: Vec<Cell> =
            self.snake.border().filter(|cell| !self.met.contains_key(cell) && self.fits(*cell).is_none()).collect();
        let mut is_any = !unseen.is_empty();
        for cell in unseen {
            self.snake.see(cell, true);
        }
        for cell in once {
            let fits = self.fits(cell) != Some(false);
            self.met.insert(cell, if fits { Met::Forgiven } else { Met::Barred });
            if fits {
                self.snake.see(cell, true);
                is_any = true;
            }
        }
        is_any
    }

    /// Starts to relocalise.
    fn search(&mut self, pilot: &mut Pilot) {
        let can = self.search.begin(pilot, &self.mapper);
        self.phase = if can { OnlineSnakePhase::Search } else { OnlineSnakePhase::Lost };
    }
}

impl Behaviour for SnakeDrive {
    fn begin(&mut self, pilot: &mut Pilot) {
        if std::mem::take(&mut self.is_lifted)
            && self.mapper.is_lost()
            && !matches!(self.phase, OnlineSnakePhase::Blind)
        {
            self.search(pilot);
        } else if matches!(self.phase, OnlineSnakePhase::Drive { .. }) {
            self.phase = OnlineSnakePhase::Choose;
        }
    }

    fn watch(&mut self, sensed: &SensorReadings, dt_s: f64) {
        self.is_lifted |= sensed.wheel_drop_left && sensed.wheel_drop_right;
        self.mapper.update(sensed);
        if matches!(self.phase, OnlineSnakePhase::Search) {
            match self.search.watch(&mut self.mapper, sensed, dt_s) {
                Searched::Looking => {}
                Searched::Found => self.phase = OnlineSnakePhase::Choose,
                Searched::InVain => self.phase = OnlineSnakePhase::Lost,
            }
        }
    }

    fn roam(&mut self, pilot: &mut Pilot, sensed: &SensorReadings, dt_s: f64) -> Drive {
        if matches!(self.phase, OnlineSnakePhase::Search) {
            return self.search.roam(pilot, sensed, dt_s);
        }
        if self.mapper.is_lost() && !self.is_done() {
            // Only its scans have told that it was carried elsewhere.
            self.search(pilot);
            return Drive::STOP;
        }
        let pose = self.mapper.pose();
        let (next, towards) = match &mut self.phase {
            OnlineSnakePhase::Look => {
                pilot.go(&[Move::Turn(math::PI), Move::Turn(math::PI)]);
                self.phase = OnlineSnakePhase::Choose;
                return Drive::STOP;
            }
            OnlineSnakePhase::Choose => {
                self.choose();
                return Drive::STOP;
            }
            OnlineSnakePhase::Drive { next, towards, patience, .. } => {
                *patience -= dt_s;
                if *patience < 0.0 {
                    self.meet(false);
                    return Drive::STOP;
                }
                (*next, *towards)
            }
            OnlineSnakePhase::Search | OnlineSnakePhase::Done | OnlineSnakePhase::Lost | OnlineSnakePhase::Blind => {
                return Drive::STOP;
            }
        };
        let along = self.along(towards);
        let left = (self.centre(next) - pose.position()).dot(&along);
        if left < THERE {
            self.arrive(next, towards);
        }
        let room = self.lookout.as_ref().map_or(f64::INFINITY, |lookout| lookout.room_ahead(sensed));
        let OnlineSnakePhase::Drive { route, .. } = &mut self.phase else { return Drive::STOP };
        let is_on_line = route.is_driving() && route.rest().len() == 1 && left >= THERE;
        if is_on_line && room < left - SHORT && pose.direction().dot(&along) > ALIGNED {
            self.meet(false);
            return Drive::STOP;
        }
        let is_near = sensed.light_bumper[1..5].contains(&true) || room < NEAR;
        let speed = pilot.speed * if is_near { CAREFUL } else { 1.0 };
        let drive = route.steer(pose, &pilot.robot, speed);
        if drive.is_none() && left >= THERE {
            // Its estimate has jumped.
            self.phase = OnlineSnakePhase::Choose;
        }
        drive.unwrap_or(Drive::STOP)
    }

    fn on_obstruction(&mut self, pilot: &mut Pilot, obstruction: Obstruction) {
        if matches!(self.phase, OnlineSnakePhase::Search) {
            return self.search.on_obstruction(pilot, obstruction);
        }
        let is_bump = obstruction.kind == ObstructionKind::Bump;
        let is_turning = matches!(&self.phase, OnlineSnakePhase::Drive { route, .. } if !route.is_driving());
        if is_bump && is_turning && self.stuck_turns < MOST_TURNS {
            self.stuck_turns += 1;
            self.phase = OnlineSnakePhase::Choose;
        } else {
            self.meet(!is_bump);
        }
        pilot.answer(obstruction, if is_bump { BACK } else { BACK_FROM_EDGE }, &[]);
    }

    fn is_done(&self) -> bool {
        matches!(self.phase, OnlineSnakePhase::Done | OnlineSnakePhase::Lost | OnlineSnakePhase::Blind)
    }

    fn activity(&self) -> &'static str {
        match &self.phase {
            OnlineSnakePhase::Look => "looking around",
            OnlineSnakePhase::Choose => "choosing the next cell",
            OnlineSnakePhase::Drive { .. } => "driving from cell to cell",
            OnlineSnakePhase::Search => "relocalising on its map",
            OnlineSnakePhase::Done => "done: all cells that it can reach are clean",
            OnlineSnakePhase::Lost => "done: relocalisation failed",
            OnlineSnakePhase::Blind => "it needs a laser scanner",
        }
    }

    fn mapper(&self) -> Option<&Mapper> {
        Some(&self.mapper)
    }

    fn intent(&self) -> Option<Intent<'_>> {
        let route = if let OnlineSnakePhase::Drive { route, .. } = &self.phase { route.rest() } else { &[] };
        let locator = self.search.locator().filter(|_| matches!(self.phase, OnlineSnakePhase::Search));
        Some(Intent { route, locator, ..Intent::default() })
    }

    fn start_at(&mut self, start: Pose) {
        self.mapper = Mapper::new(MapperSetup { start, ..self.mapper.setup().clone() });
    }

    fn boxed_clone(&self) -> Box<dyn Behaviour> {
        Box::new(self.clone())
    }
}
