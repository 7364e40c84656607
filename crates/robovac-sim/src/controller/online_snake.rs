//! The improved snake in an unknown room (Emu & Obaida 2020, sections 1.5 and 4.2).
//!
//! The thesis' robot detects obstacles with its laser scanner while it drives. Cells lie on the grid of its start. A cell is
//! free if the robot's body fits around its centre by the map that it makes on the way. [`OnlineSnake`] decides where to go
//! next.
//!
//! Ours: the map and the pose estimate of [`Mapper`]; an obstacle that it meets blocks the cell ahead until nothing else
//! is left to clean, and for ever when it is met again, or in a cell where it has been, six times; edges and virtual walls
//! block at once. A cell that its map showed as free and then not waits, too, until nothing else is left. Before it is done
//! it also tries ways that are only just too narrow by its map.
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
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// Cells on each side of the grid, with the start in its middle.
const CELLS: usize = 256;
/// Distance up to which cells are looked at, m: farther away a scanner's points lie too far apart.
const SIGHT: f64 = 3.0;
/// How much nearer to the centre of an occupied cell of the map than its radius the body may come, m.
const SLACK: f64 = 0.01;
/// The same where the map may be wrong, m: noise can paint a cell that is in truth free.
const DOUBT: f64 = 0.05;
/// Longest way on that may be only just too narrow by the map, in cells.
const LONGEST_NARROW: usize = 8;
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
const BACK_FROM_EDGE: f64 = 0.1;
/// How often an obstacle keeps it from turning in a cell, before it takes the way on for blocked.
const MOST_TURNS: u32 = 5;
/// How often it meets something in a cell before it never goes there again: at most, and where it has been before, and what
/// it met may be gone or its own fault.
const MOST_MET: u32 = 2;
const MOST_MET_AGAIN: u32 = 6;
/// How often the map may take back that a cell is free, before it counts as blocked whatever the map shows: at first, until
/// nothing else is left, and for ever. Beside walls noise can open and close cells for hours.
const MOST_CLOSED: (u32, u32) = (1, 4);
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
    /// How often the map has taken back that a cell is free.
    closed: BTreeMap<Cell, u32>,
    /// Cells that it has come to.
    been: BTreeSet<Cell>,
    phase: OnlineSnakePhase,
    /// Whether it has turned round since it came to the cell.
    has_looked: bool,
    /// How often it couldn't turn in a cell.
    stuck_turns: BTreeMap<Cell, u32>,
    lookout: Option<Lookout>,
    is_lifted: bool,
    search: RelocaliseSearch,
}

/// What it knows of a cell in which it met something.
#[derive(Debug, Clone, Copy, Default)]
struct Met {
    /// How often it did.
    times: u32,
    /// It doesn't go there, for now.
    is_shut: bool,
    /// It never goes there.
    is_barred: bool,
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
            closed: BTreeMap::new(),
            been: BTreeSet::from([middle]),
            phase: if setup.robot.sensors.laser.is_some() { OnlineSnakePhase::Look } else { OnlineSnakePhase::Blind },
            has_looked: true,
            stuck_turns: BTreeMap::new(),
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

    /// Whether the body fits around the centre of a cell by the map, if obstacles may be `slack` nearer, m; `None` if that
    /// isn't known yet. It fits where it is.
    fn fits(&self, cell: Cell, slack: f64) -> Option<bool> {
        let (map, centre, here) = (self.mapper.map(), self.centre(cell), self.centre(self.snake.at()));
        let radius = self.mapper.setup().robot.radius;
        let (middle, reach) = (map.cell_at(centre), (radius / map.resolution()).ceil() as i32);
        let mut is_known = true;
        for y in middle.y - reach..=middle.y + reach {
            for x in middle.x - reach..=middle.x + reach {
                let at = Cell::new(x, y);
                let away = (map.centre(at) - centre).norm();
                match map.occupancy(at) {
                    Occupancy::Occupied if away < radius - slack => return Some(false),
                    Occupancy::Unknown if away < radius - slack => {
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
                let slack = match self.met.get(&cell) {
                    None => SLACK,
                    Some(met) if met.is_shut => continue,
                    Some(_) => DOUBT,
                };
                if self.snake.is_visited(cell) {
                    continue;
                }
                let Some(fits) = self.fits(cell, slack) else { continue };
                let is_met = self.met.contains_key(&cell);
                match (self.snake.is_free(cell), fits) {
                    (true, false) if is_met => self.shut(cell, false),
                    (true, false) => *self.closed.entry(cell).or_default() += 1,
                    (false, true) if self.has_closed(cell, MOST_CLOSED.0) => continue,
                    _ => {}
                }
                self.snake.see(cell, fits);
            }
        }
    }

    /// Whether the map has taken back so many times that a cell is free.
    fn has_closed(&self, cell: Cell, times: u32) -> bool {
        self.closed.get(&cell).is_some_and(|&closed| closed >= times)
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
        self.been.insert(next);
        self.has_looked = false;
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
        self.shut(next, is_barred);
        self.snake.see(next, false);
        self.phase = OnlineSnakePhase::Choose;
    }

    /// Doesn't go to a cell for now, as something is there; or never.
    fn shut(&mut self, cell: Cell, is_barred: bool) {
        let most = if self.been.contains(&cell) { MOST_MET_AGAIN } else { MOST_MET };
        let met = self.met.entry(cell).or_default();
        met.times += 1;
        (met.is_shut, met.is_barred) = (true, is_barred || met.times >= most);
    }

    /// Tries once more where it met something that can have gone, where it can't see, where its map shows room by now, and
    /// where a way on may be only just too narrow by it; whether there is such a place.
    fn forgive(&mut self) -> bool {
        let again: Vec<Cell> =
            self.met.iter().filter(|(_, met)| met.is_shut && !met.is_barred).map(|(cell, _)| *cell).collect();
        let border: Vec<Cell> = self.snake.border().filter(|cell| !self.met.contains_key(cell)).collect();
        let (mut open, shut): (Vec<Cell>, Vec<Cell>) = border
            .into_iter()
            .partition(|&cell| self.fits(cell, SLACK) != Some(false) && !self.has_closed(cell, MOST_CLOSED.1));
        if open.is_empty() && again.is_empty() {
            open = self.narrow_way(&shut);
            // Until it meets something there.
            self.met.extend(open.iter().map(|&cell| (cell, Met { times: MOST_MET - 1, ..Met::default() })));
        }
        let mut is_any = !open.is_empty();
        for cell in open {
            self.snake.see(cell, true);
        }
        for cell in again {
            let slack = if self.been.contains(&cell) { DOUBT } else { SLACK };
            let fits = self.fits(cell, slack) != Some(false);
            let met = self.met.entry(cell).or_default();
            (met.is_shut, met.is_barred) = (!fits, !fits);
            if fits {
                self.snake.see(cell, true);
                is_any = true;
            }
        }
        is_any
    }

    /// The shortest way over cells in which the body may just fit, from one of `border` to a cell that isn't visited and in
    /// which it fits, or may fit; empty if there is none.
    fn narrow_way(&self, border: &[Cell]) -> Vec<Cell> {
        let is_narrow = |cell: &Cell| {
            !self.met.contains_key(cell) && !self.snake.is_visited(*cell) && self.fits(*cell, DOUBT) != Some(false)
        };
        let mut ways: VecDeque<Vec<Cell>> =
            border.iter().filter(|cell| is_narrow(cell)).map(|&cell| vec![cell]).collect();
        let mut seen: BTreeSet<Cell> = border.iter().copied().collect();
        while let Some(way) = ways.pop_front() {
            for next in way.last().into_iter().flat_map(|cell| cell.neighbours()) {
                if self.snake.is_visited(next) || !seen.insert(next) {
                    continue;
                }
                if self.fits(next, SLACK) != Some(false) {
                    return way;
                }
                if way.len() < LONGEST_NARROW && is_narrow(&next) {
                    ways.push_back([&way[..], &[next]].concat());
                }
            }
        }
        Vec::new()
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
        // Where it tries again, touch decides: beside jambs a scan may show less room than there is.
        let is_again = self.met.contains_key(&next);
        if is_on_line && !is_again && room < left - SHORT && pose.direction().dot(&along) > ALIGNED {
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
        let turn = match &self.phase {
            OnlineSnakePhase::Drive { route, towards, .. } if is_bump && !route.is_driving() => {
                let (heading, along) = (self.mapper.pose().direction(), self.along(*towards));
                Some(math::atan2(heading.perp(&along), heading.dot(&along)))
            }
            _ => None,
        };
        let tries = self.stuck_turns.entry(self.snake.at()).or_default();
        *tries += u32::from(turn.is_some());
        if turn.is_some() && !tries.is_multiple_of(MOST_TURNS) {
            self.phase = OnlineSnakePhase::Choose;
        } else {
            self.meet(!is_bump);
        }
        // A body with corners that can't turn where it is gets out of there.
        let rest: Vec<Move> = turn.into_iter().map(Move::Turn).collect();
        pilot.answer(obstruction, if is_bump { BACK } else { BACK_FROM_EDGE }, &rest);
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
