//! The program of Emu & Obaida's thesis (000, Appendix B), transcribed line by line, and the walks held to it.
//!
//! It keeps the program's variables, branches and recursion. Functions that end without a `return` return false or 0.
//! The text that we have of the thesis is a scan without some of the braces, and with 'I' for 'l' in one condition.

use super::support::{EIGHT, drawn};
use coverage_planners::{CoverageJob, CoveragePath, PlanContext, THE_END, TraceStep, find, metrics::WalkMetrics};
use rand::RngExt;
use robovac_core::{
    floor_plan::{generate::random_clutter, room},
    grid::{Cell, Direction, Grid},
    registry::{ParamValue, Params},
    rng::seeded,
};
use std::{collections::BTreeMap, fmt::Write, fs, thread};

const BLOCK: i32 = 999_999;
const INF: i32 = -1_111_111;

/// Why the program stops.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum End {
    All,
    Exit,
    Return,
    OutOfGrid,
    Block,
    Jump,
    /// No new cell for much longer than the planner waits for one.
    Circles,
}

/// The program's global variables. Rows are counted from the top.
struct Program {
    n: i32,
    mat: Vec<Vec<i32>>,
    prev: Vec<(i32, i32)>,
    curr_x: i32,
    curr_y: i32,
    block_a: u32,
    block_b: u32,
    facing: char,
    /// Added: positions in their order, whether each cell has been visited, and how many are left.
    walk: Vec<(i32, i32)>,
    visited: Vec<Vec<bool>>,
    left: usize,
    last_new: usize,
    patience: usize,
}

impl Program {
    /// `main`, with another preset.
    fn main(free: &Grid<bool>) -> (Vec<Cell>, End) {
        let n = free.height() as i32;
        assert_eq!(free.width() as i32, n, "the program's rooms are square");
        let value = |x, y| if free[Cell::new(x, n - 1 - y)] { INF } else { BLOCK };
        let mut program = Self {
            n,
            mat: (0..n).map(|y| (0..n).map(|x| value(x, y)).collect()).collect(),
            prev: Vec::new(),
            curr_x: 0,
            curr_y: 0,
            block_a: 0,
            block_b: 0,
            facing: 'r',
            walk: Vec::new(),
            visited: vec![vec![false; n as usize]; n as usize],
            left: free.count(),
            last_new: 0,
            patience: 20 * free.count() + 500,
        };
        program.mat[0][0] = 0;
        let end = program.record().and_then(|()| program.make_move()).err().unwrap_or(End::Return);
        if end == End::Circles {
            program.walk.truncate(program.last_new);
        }
        (program.walk.iter().map(|&(x, y)| Cell::new(x, n - 1 - y)).collect(), end)
    }

    /// Added: after every change of the position.
    fn record(&mut self) -> Result<(), End> {
        let (x, y) = (self.curr_x, self.curr_y);
        if self.walk.last() == Some(&(x, y)) {
            return Ok(());
        }
        if x < 0 || y < 0 || x >= self.n || y >= self.n {
            return Err(End::OutOfGrid);
        }
        if self.at(x, y) == BLOCK {
            return Err(End::Block);
        }
        if self.walk.last().is_some_and(|&(a, b)| (a - x).abs() + (b - y).abs() != 1) {
            return Err(End::Jump);
        }
        self.walk.push((x, y));
        if !self.visited[y as usize][x as usize] {
            self.visited[y as usize][x as usize] = true;
            self.left -= 1;
            self.last_new = self.walk.len();
        }
        match self.walk.len() - self.last_new {
            _ if self.left == 0 => Err(End::All),
            since if since > self.patience => Err(End::Circles),
            _ => Ok(()),
        }
    }

    fn at(&self, x: i32, y: i32) -> i32 {
        self.mat[y as usize][x as usize]
    }

    fn increment(&mut self) {
        self.mat[self.curr_y as usize][self.curr_x as usize] += 1;
    }

    fn move_x(&self) -> i32 {
        match self.facing {
            'l' => -1,
            'r' => 1,
            _ => 0,
        }
    }

    fn move_y(&self) -> i32 {
        match self.facing {
            'u' => -1,
            'd' => 1,
            _ => 0,
        }
    }

    fn count_number_of_zeros(&mut self, direction: char) {
        self.block_a = 0;
        self.block_b = 0;
        if direction == 'h' {
            for i in 0..self.curr_y {
                for j in 0..self.n {
                    self.block_a += u32::from(self.at(j, i) == 0);
                }
            }
            for i in self.curr_y + 1..self.n {
                for j in 0..self.n {
                    self.block_b += u32::from(self.at(j, i) == 0);
                }
            }
        } else {
            for i in 0..self.n {
                for j in 0..self.curr_x {
                    self.block_a += u32::from(self.at(j, i) == 0 || self.at(j, i) == INF);
                }
            }
            for i in 0..self.n {
                for j in self.curr_x + 1..self.n {
                    self.block_b += u32::from(self.at(j, i) == 0 || self.at(j, i) == INF);
                }
            }
        }
    }

    fn both_neighbour_has_same_value_where_should_i_go(&mut self) -> i32 {
        if self.facing == 'l' || self.facing == 'r' {
            self.count_number_of_zeros('h');
            if self.block_a == 0 && self.block_b == 0 {
                -1
            } else if self.block_a == 0 {
                2
            } else if self.block_b == 0 {
                1
            } else if self.block_a == self.block_b {
                if self.curr_y < self.n - self.curr_y { 1 } else { 2 }
            } else if self.block_a < self.block_b {
                1
            } else {
                2
            }
        } else {
            self.count_number_of_zeros('v');
            if self.block_a == 0 && self.block_b == 0 {
                -1
            } else if self.block_a == self.block_b {
                if self.curr_x < self.n - self.curr_x { 3 } else { 4 }
            } else if self.block_a < self.block_b {
                3
            } else {
                4
            }
        }
    }

    fn make_all_inf_neighbours_zero(&mut self) {
        for (x, y) in [(1, 0), (-1, 0), (0, 1), (0, -1)].map(|(dx, dy)| (self.curr_x + dx, self.curr_y + dy)) {
            if x >= 0 && y >= 0 && x < self.n && y < self.n && self.at(x, y) == INF {
                self.mat[y as usize][x as usize] = 0;
            }
        }
    }

    fn collision_ahead(&self) -> bool {
        let (x, y) = (self.curr_x + self.move_x(), self.curr_y + self.move_y());
        x < 0 || x >= self.n || y < 0 || y >= self.n || self.at(x, y) == BLOCK
    }

    fn cleaned_area_ahead(&self) -> bool {
        self.at(self.curr_x + self.move_x(), self.curr_y + self.move_y()) > 0
    }

    fn find_minimum_neighbour(&self) -> i32 {
        let (x, y, n) = (self.curr_x, self.curr_y, self.n);
        if self.facing == 'u' || self.facing == 'd' {
            if x + 1 < n && x > 0 {
                let (right, left) = (self.at(x + 1, y), self.at(x - 1, y));
                if right == BLOCK && left == BLOCK {
                    5
                } else if right == BLOCK {
                    3
                } else if left == BLOCK {
                    4
                } else if right == left {
                    6
                } else if right < left {
                    4
                } else {
                    3
                }
            } else if x + 1 < n {
                if self.at(x + 1, y) == BLOCK { 5 } else { 4 }
            } else if x > 0 {
                if self.at(x - 1, y) == BLOCK { 5 } else { 3 }
            } else {
                0
            }
        } else if y + 1 < n && y > 0 {
            let (down, up) = (self.at(x, y + 1), self.at(x, y - 1));
            if down == BLOCK && up == BLOCK {
                5
            } else if (down > 0 && up == BLOCK) || (down == BLOCK && up > 0) {
                7
            } else if down == BLOCK {
                1
            } else if up == BLOCK {
                2
            } else if down == up {
                6
            } else if down < up {
                2
            } else {
                1
            }
        } else if y + 1 < n {
            if self.at(x, y + 1) == BLOCK { 5 } else { 2 }
        } else if y > 0 {
            if self.at(x, y - 1) == BLOCK { 5 } else { 1 }
        } else {
            0
        }
    }

    fn make_robot_face_toward(&mut self, direction: i32) {
        self.facing = match direction {
            1 => 'u',
            2 => 'd',
            3 => 'l',
            4 => 'r',
            _ => self.facing,
        };
    }

    fn more_than_one_same_neighbor(&self) -> bool {
        self.at(self.curr_x, self.curr_y + 1) == self.at(self.curr_x, self.curr_y - 1)
    }

    fn minimum_value_forward(&self) -> bool {
        let (x, y, n) = (self.curr_x, self.curr_y, self.n);
        if self.facing == 'r' && x + 1 < n {
            y + 1 > x + 1 && y - 1 > x + 1
        } else if self.facing == 'l' && x - 1 > 0 {
            y + 1 > x - 1 && y - 1 > x - 1
        } else if (self.facing == 'u' && y - 1 > 0) || (self.facing == 'd' && y + 1 > n) {
            x + 1 > y - 1 && x - 1 > y - 1
        } else {
            false
        }
    }

    fn push_next(&mut self) {
        self.prev.push((self.curr_x + self.move_x(), self.curr_y + self.move_y()));
    }

    fn push_opposite(&mut self) {
        self.prev.push((self.curr_x - self.move_x(), self.curr_y - self.move_y()));
    }

    fn go_back(&mut self) -> Result<(), End> {
        (self.curr_x, self.curr_y) = self.prev.pop().expect("the stack isn't empty");
        self.record()
    }

    fn go(&mut self) -> Result<(), End> {
        self.curr_x += self.move_x();
        self.curr_y += self.move_y();
        self.record()
    }

    /// Up to the label `secondturn`; in the branches that end with `goto secondturn`, too.
    fn make_move(&mut self) -> Result<(), End> {
        self.increment();
        self.make_all_inf_neighbours_zero();
        if !(self.collision_ahead() || self.cleaned_area_ahead()) {
            self.push_next();
            self.go()?;
            self.make_move()?;
            return self.second_turn();
        }
        let next = self.find_minimum_neighbour();
        if next == 7 {
            assert!(!self.more_than_one_same_neighbor());
            if self.minimum_value_forward() {
                self.increment();
                self.push_opposite();
                self.go()?;
                self.make_all_inf_neighbours_zero();
                return self.second_turn();
            }
            self.make_all_inf_neighbours_zero();
            self.push_opposite();
            self.go_back()?;
            self.make_move()?;
        }
        if next == 5 {
            self.increment();
            self.make_all_inf_neighbours_zero();
            self.push_next();
            self.go_back()?;
            self.make_move()?;
        } else {
            if next == 6 {
                let my_next_move = self.both_neighbour_has_same_value_where_should_i_go();
                if my_next_move == -1 {
                    return Err(End::Exit);
                }
                self.make_robot_face_toward(my_next_move);
            } else {
                self.make_robot_face_toward(next);
                if self.both_neighbour_has_same_value_where_should_i_go() == -1 {
                    return Err(End::Exit);
                }
            }
            self.push_next();
            self.go()?;
            self.increment();
            self.make_all_inf_neighbours_zero();
        }
        self.second_turn()
    }

    fn second_turn(&mut self) -> Result<(), End> {
        let next = self.find_minimum_neighbour();
        if next == 7 {
            assert!(!self.more_than_one_same_neighbor());
            self.increment();
            if self.minimum_value_forward() {
                self.push_next();
                self.go()?;
                self.make_all_inf_neighbours_zero();
                return self.second_turn();
            }
            self.make_all_inf_neighbours_zero();
            self.push_next();
            self.go_back()?;
            self.make_move()?;
        }
        if next == 5 {
            self.increment();
            self.make_all_inf_neighbours_zero();
            self.go_back()?;
        } else if next == 6 {
            let my_next_move = self.both_neighbour_has_same_value_where_should_i_go();
            if my_next_move == -1 {
                return Ok(());
            }
            self.make_robot_face_toward(my_next_move);
        } else {
            self.make_robot_face_toward(next);
        }
        self.push_next();
        self.go()?;
        self.make_move()
    }
}

/// The program calls itself at every step of its walk.
fn with_a_deep_stack(what: impl FnOnce() + Send + 'static) {
    thread::Builder::new().stack_size(1 << 28).spawn(what).expect("a thread starts").join().expect("it holds");
}

fn job(free: &Grid<bool>) -> CoverageJob {
    let top_left = Cell::new(0, free.height() as i32 - 1);
    CoverageJob::new(free, top_left, Direction::Right).expect("the start is free")
}

/// The planner with the rules of the program.
fn planned(job: &CoverageJob, ctx: &mut PlanContext<'_>) -> CoveragePath {
    let info = find("snake").expect("the planner exists");
    let rules = [("rules", ParamValue::Choice("program".to_owned()))];
    let planner = info.build(&Params::checked(info.params, rules).expect("the rules exist"));
    assert!(!planner.is_complete(), "it can stop early");
    planner.plan(job, ctx).expect("nobody cancels")
}

/// `UPDATE=1` writes the golden walk again.
#[test]
fn printed_program_makes_the_golden_walk() {
    let (walk, end) = Program::main(&drawn(EIGHT));
    assert_eq!(end, End::All);
    let mut text = String::from(
        "; walk of the thesis' printed program (Emu & Obaida 2020, Appendix B) on its own room of 8 x 8 cells\n\
         ; column, row from the bottom; top-left to start with, facing right; 65 steps, 12 revisits, 32 changes of \
         direction\n",
    );
    for cell in &walk {
        writeln!(text, "{} {}", cell.x, cell.y).expect("a string takes all");
    }
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/snake_8x8_program.txt");
    if std::env::var_os("UPDATE").is_some() {
        fs::write(file, &text).expect("the file can be written");
    }
    assert_eq!(text, fs::read_to_string(file).expect("the file is there"));
    assert_eq!(planned(&job(&drawn(EIGHT)), &mut PlanContext::new(0)).cells, walk);
}

/// In the room of Table 2 program and text come to the same.
#[test]
fn printed_program_cleans_our_room_of_table_2() {
    let plan = (room("thesis226").expect("it ships").build)();
    let free = plan.occupancy.map(|cell| cell.is_free());
    let (walk, end) = Program::main(&free);
    let info = find("snake").expect("the planner exists");
    let text = info.build(&Params::defaults(info.params)).plan(&job(&free), &mut PlanContext::new(0));
    assert_eq!((end, Ok(CoveragePath::walk(walk))), (End::All, text));
}

/// A square room with some blocks or with clutter; all its free cells are connected with the top-left one.
fn square_room(side: usize, seed: u64) -> Option<Grid<bool>> {
    let mut rng = seeded(seed, side as u64);
    let clutter = if seed.is_multiple_of(4) { rng.random_range(0.0..0.06) } else { 0.0 };
    let mut free = random_clutter(side, side, clutter, seed);
    for _ in 0..rng.random_range(0..4) {
        let (width, height) = (rng.random_range(1..=side / 3), rng.random_range(1..=side / 3));
        let (left, below) = (rng.random_range(0..=side - width), rng.random_range(0..=side - height));
        for (x, y) in (left..left + width).flat_map(|x| (below..below + height).map(move |y| (x, y))) {
            free[Cell::new(x as i32, y as i32)] = false;
        }
    }
    let top_left = Cell::new(0, side as i32 - 1);
    (free.is_set(top_left) && job(&free).cells() == free.count()).then_some(free)
}

/// Rooms of 6 to 20 cells on a side, so many of each.
fn program_is_walked_step_for_step(rooms: usize) {
    let mut ends: BTreeMap<End, usize> = BTreeMap::new();
    for side in 6..=20 {
        let mut complete = 0;
        for (seed, free) in (0..).filter_map(|seed| Some((seed, square_room(side, seed)?))).take(rooms) {
            let (walk, end) = Program::main(&free);
            let job = job(&free);
            let path = planned(&job, &mut PlanContext::new(0));
            assert_eq!(path.cells, walk, "{side} cells, seed {seed}: {end:?}");
            path.check(&job).expect("it can be driven");
            let metrics = WalkMetrics::of(&job, &path);
            assert_eq!(metrics.visited_cells == metrics.reachable_cells, end == End::All, "{side} cells, seed {seed}");
            complete += usize::from(end == End::All);
            *ends.entry(end).or_default() += 1;
        }
        assert!(2 * complete > rooms / 2, "completes {complete} of {rooms} rooms with {side} cells on a side");
    }
    println!("{ends:?}");
    assert!([End::All, End::Exit, End::OutOfGrid, End::Block, End::Circles].iter().all(|end| ends.contains_key(end)));
}

#[test]
fn printed_program_is_walked_step_for_step() {
    with_a_deep_stack(|| program_is_walked_step_for_step(30));
}

#[test]
#[ignore = "soak: many rooms"]
fn printed_program_is_walked_step_for_step_in_many_rooms() {
    with_a_deep_stack(|| program_is_walked_step_for_step(2_000));
}

/// At a second turn between two blocks the visit is counted before the robot goes back; else it would go in circles here.
#[test]
fn printed_program_counts_a_visit_before_it_goes_back() {
    let free = drawn("....\n..#.\n....\n..##");
    let (walk, end) = Program::main(&free);
    assert_eq!((walk.len() - 1, end), (14, End::All));
    assert_eq!(planned(&job(&free), &mut PlanContext::new(0)).cells, walk);
}

/// At the end of a corridor "back" is ahead, and ahead is no room any more.
#[test]
fn printed_program_says_where_it_ends() {
    let job = job(&drawn("....\n.###\n####\n####"));
    let mut told: Vec<TraceStep> = Vec::new();
    let mut tracer = |step: TraceStep| told.push(step);
    let path = planned(&job, &mut PlanContext::new(0).traced(&mut tracer));
    assert_eq!(path.cells.len(), 4);
    let steps: Vec<(usize, &str)> = told.iter().map(|step| (step.step, &*step.rule)).collect();
    assert_eq!(steps, [(0, "Ahead"), (1, "Ahead"), (2, "Ahead"), (3, THE_END)]);
    assert_eq!(told[3].note, "The walk ends here: the program would leave the grid");
}
