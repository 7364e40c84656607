//! The improved snake in a room that it discovers.

use super::{
    memory::SnakeMemory,
    walk::{SnakeStep, SnakeWalk},
};
use crate::stage::NearestGoalBfs;
use robovac_core::grid::{Cell, Direction, Grid};

/// Steps over cleaned cells that the rules may take, for each step to the nearest uncleaned cell: the planner's default.
const PATIENCE: usize = 2;

/// The walk of the planner `snake` by the rules of the text, for a robot that doesn't know the room: it is told what
/// the robot sees ([`see`](Self::see)), and says where to go next ([`next_cell`](Self::next_cell)).
///
/// Cells that weren't seen count as blocked until they are. Rows and columns, by which the thesis' rules break ties, are those
/// from the first to the last free cell seen so far.
///
/// ```
/// use robovac_core::grid::{Cell, Direction};
/// use coverage_planners::OnlineSnake;
/// // A corridor of three cells, seen as the robot comes.
/// let mut snake = OnlineSnake::new(8, 8, Cell::new(4, 4), Direction::Right);
/// let mut walk = Vec::new();
/// while walk.len() < 10 {
///     snake.see(snake.at().step(Direction::Right), walk.len() < 2);
///     let Some(next) = snake.next_cell() else { break };
///     walk.push(next);
///     snake.arrive();
/// }
/// assert_eq!(walk, [Cell::new(5, 4), Cell::new(6, 4)]);
/// ```
#[derive(Debug, Clone)]
pub struct OnlineSnake {
    free: Grid<bool>,
    walk: SnakeWalk,
    seeker: NearestGoalBfs,
    /// The next step, if it was chosen.
    step: Option<SnakeStep>,
}

impl OnlineSnake {
    /// A robot on cell `start` of a grid of `width` x `height` cells, in which the room must lie.
    ///
    /// # Panics
    ///
    /// If `start` isn't on the grid.
    pub fn new(width: usize, height: usize, start: Cell, heading: Direction) -> Self {
        let mut free = Grid::filled(width, height, false);
        free[start] = true;
        let mut memory = SnakeMemory::blank(width, height);
        memory.open(start);
        let seeker = NearestGoalBfs::new(&free);
        Self { free, walk: SnakeWalk::new(memory, start, heading, PATIENCE), seeker, step: None }
    }

    /// The robot sees whether a cell is free. Cells off the grid are blocked for ever.
    pub fn see(&mut self, cell: Cell, is_free: bool) {
        if !self.free.contains(cell) || self.free[cell] == is_free || cell == self.at() {
            return;
        }
        self.free[cell] = is_free;
        // By the rules of the cells known now.
        if is_free {
            self.walk.memory.open(cell);
            if matches!(self.step, Some(SnakeStep::Rule(_))) {
                self.step = None;
            }
        } else {
            self.walk.memory.block(cell);
            self.walk.forget_way();
            self.step = None;
        }
    }

    /// The cell that the robot is on, or has just left for the next.
    pub fn at(&self) -> Cell {
        self.walk.at
    }

    /// Whether a cell is free, as far as it has been seen.
    pub fn is_free(&self, cell: Cell) -> bool {
        self.free.is_set(cell)
    }

    /// Whether a cell has been visited.
    pub fn is_visited(&self, cell: Cell) -> bool {
        self.free.is_set(cell) && !self.walk.memory.is_left(cell)
    }

    /// Cells that aren't free as far as it has seen, beside visited ones.
    pub fn border(&self) -> impl Iterator<Item = Cell> {
        let is_border = |cell: Cell| cell.neighbours().into_iter().any(|next| self.is_visited(next));
        self.free.iter().filter(move |&(cell, &is_free)| !is_free && is_border(cell)).map(|(cell, _)| cell)
    }

    /// Cells that have been seen and not visited.
    pub fn left(&self) -> usize {
        self.walk.memory.left
    }

    /// The neighbouring cell to go to next; `None` if no seen cell that isn't clean can be reached.
    pub fn next_cell(&mut self) -> Option<Cell> {
        if self.step.is_none() {
            self.step = self.walk.choose(&self.free, &mut self.seeker);
        }
        Some(self.at().step(self.step?.towards()))
    }

    /// How many cells straight on, from the next one on, will follow, unless something else is seen until then; 0 without a
    /// next one.
    pub fn straight_on(&mut self) -> usize {
        let Some(mut cell) = self.next_cell() else { return 0 };
        let Some(step) = self.step else { return 0 };
        let on = |cell: Cell| cell.step(step.towards());
        match step {
            SnakeStep::Way(..) => self.walk.straight_way(),
            SnakeStep::Rule(_) => {
                let mut cells = 1;
                while step.goes_straight() && self.free.is_set(on(cell)) && self.walk.memory.is_left(on(cell)) {
                    (cell, cells) = (on(cell), cells + 1);
                }
                cells
            }
        }
    }

    /// The robot has come to the [`next_cell`](Self::next_cell) cell.
    pub fn arrive(&mut self) {
        if let Some(step) = self.step.take() {
            self.walk.take(step);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CoverageJob, PlanContext, find};
    use rand::RngExt;
    use robovac_core::{grid::from_picture, registry::Params, rng::seeded};

    /// Walks through a room of which it sees, from each cell, what `sees` says: from, to.
    fn discover(free: &Grid<bool>, start: Cell, heading: Direction, sees: impl Fn(Cell, Cell) -> bool) -> Vec<Cell> {
        // Somewhere on a larger grid.
        let off = |cell: Cell| Cell::new(cell.x + 7, cell.y + 5);
        let mut snake = OnlineSnake::new(free.width() + 20, free.height() + 20, off(start), heading);
        let (mut at, mut walk) = (start, vec![start]);
        loop {
            for (cell, &is_free) in free.iter() {
                if sees(at, cell) {
                    snake.see(off(cell), is_free);
                }
            }
            let Some(next) = snake.next_cell() else { return walk };
            at = Cell::new(next.x - 7, next.y - 5);
            snake.arrive();
            walk.push(at);
            assert!(free.is_set(at) && walk.len() < 100 * free.len(), "it goes to {at:?}");
        }
    }

    /// Whether a straight line between the centres of two cells touches no blocked cell before the last.
    fn is_in_sight(free: &Grid<bool>, from: Cell, to: Cell) -> bool {
        let (dx, dy) = (f64::from(to.x - from.x), f64::from(to.y - from.y));
        let steps = 16 * (dx.abs().max(dy.abs()) as i32).max(1);
        (0..=steps).all(|i| {
            let share = f64::from(i) / f64::from(steps);
            let (x, y) = (f64::from(from.x) + dx * share, f64::from(from.y) + dy * share);
            let cell = Cell::new(x.round() as i32, y.round() as i32);
            cell == to || free.is_set(cell)
        })
    }

    fn preset() -> (Grid<bool>, CoverageJob) {
        // The room of Appendix B.
        let rows = ["...##...", "...##...", "...##...", "........", "........", "........", "##......", "##......"];
        let free = from_picture(&rows.join("\n"), |c| c == '.').unwrap();
        let job = CoverageJob::new(&free, Cell::new(0, 7), Direction::Right).unwrap();
        (free, job)
    }

    fn planned(job: &CoverageJob) -> Vec<Cell> {
        let info = find("snake").unwrap();
        info.build(&Params::defaults(info.params)).plan(job, &mut PlanContext::new(0)).unwrap().cells
    }

    #[test]
    fn in_the_preset_it_walks_as_the_planner_that_knows_the_room() {
        let (free, job) = preset();
        let walk = discover(&free, job.start, job.heading, |from, to| is_in_sight(&free, from, to));
        assert_eq!(walk, planned(&job));
        assert_eq!(walk.len(), 66);
    }

    #[test]
    fn whoever_sees_all_walks_as_planned_and_the_short_sighted_cleans_all_too() {
        let (mut rng, mut compared) = (seeded(9, 0), 0);
        for round in 0..60 {
            let (width, height) = (rng.random_range(4..20), rng.random_range(4..20));
            let mut free = Grid::filled(width, height, true);
            free.values_mut().iter_mut().for_each(|value| *value = rng.random_bool(0.8));
            for x in 0..width as i32 {
                (free[Cell::new(x, 0)], free[Cell::new(x, height as i32 - 1)]) = (true, true);
            }
            let start = Cell::new(0, 0);
            let Some(job) = CoverageJob::new(&free, start, Direction::Up) else { continue };
            // Else the robot knows of a smaller grid than the planner does.
            let touches = |edge: fn(&Grid<bool>, Cell) -> bool| {
                job.free.iter().any(|(c, &is_free)| is_free && edge(&job.free, c))
            };
            if touches(|_, c| c.x == 0)
                && touches(|_, c| c.y == 0)
                && touches(|free, c| c.x + 1 == free.width() as i32)
                && touches(|free, c| c.y + 1 == free.height() as i32)
            {
                assert_eq!(discover(&job.free, start, Direction::Up, |_, _| true), planned(&job), "room {round}");
                compared += 1;
            }
            let walk = discover(&job.free, start, Direction::Up, |from, to| from.direction_to(to).is_some());
            let mut visited = job.free.map(|_| false);
            for &cell in &walk {
                visited[cell] = true;
            }
            assert_eq!(visited, job.free, "room {round}");
        }
        assert!(compared > 40, "{compared} rooms");
    }

    #[test]
    fn what_turns_out_to_be_blocked_is_walked_around() {
        let mut snake = OnlineSnake::new(9, 9, Cell::new(1, 1), Direction::Right);
        (1..5).for_each(|x| (1..4).for_each(|y| snake.see(Cell::new(x, y), true)));
        assert_eq!((snake.next_cell(), snake.straight_on()), (Some(Cell::new(2, 1)), 3));
        snake.arrive();
        snake.see(Cell::new(3, 1), false);
        let mut walk = vec![Cell::new(2, 1)];
        while let Some(next) = snake.next_cell() {
            walk.push(next);
            snake.arrive();
        }
        assert!(!walk.contains(&Cell::new(3, 1)) && walk.contains(&Cell::new(4, 1)) && snake.left() == 0, "{walk:?}");
    }
}
