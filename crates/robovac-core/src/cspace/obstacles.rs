//! Numbered obstacles.

use crate::grid::{Cell, Grid};

/// The obstacles of a slice: connected FULL cells, including diagonally.
///
/// So obstacles that leave no way between them are one to the robot. They are numbered from 1 in the order in which a
/// scan from the top left meets them (001, section 3: `obstacleNo`).
#[derive(Debug, Clone)]
pub struct ObstacleRuns {
    /// Start of every row's runs in `runs`, from the bottom row.
    starts: Vec<u32>,
    /// First and last column of a run of FULL cells, and its obstacle's number; 0 for a wall.
    runs: Vec<(i32, i32, u32)>,
    count: u32,
}

impl ObstacleRuns {
    /// The obstacles between FREE cells. Those connected with the outside are wall. O(n).
    pub fn of(free: &Grid<bool>) -> Self {
        let (width, height) = (free.width(), free.height());
        Self::numbered(RunSets::of(free, false), height, |y, (first, last)| {
            first == 0 || last as usize + 1 == width || y == 0 || y + 1 == height
        })
    }

    /// The obstacles that consist of these cells, none of them wall. O(n).
    pub fn of_cells(cells: &Grid<bool>) -> Self {
        Self::numbered(RunSets::of(cells, true), cells.height(), |_, _| false)
    }

    fn numbered(found: RunSets, height: usize, is_wall: impl Fn(usize, (i32, i32)) -> bool) -> Self {
        let RunSets { starts, mut runs, mut sets } = found;
        let rows = |y: usize| starts[y] as usize..starts[y + 1] as usize;
        for y in 0..height {
            for &(first, last, set) in &runs[rows(y)] {
                if is_wall(y, (first, last)) {
                    join(&mut sets, 0, set);
                }
            }
        }
        let mut numbers = vec![0; sets.len()];
        let mut count = 0;
        for y in (0..height).rev() {
            for run in &mut runs[rows(y)] {
                let set = root(&mut sets, run.2) as usize;
                if set != 0 && numbers[set] == 0 {
                    count += 1;
                    numbers[set] = count;
                }
                run.2 = numbers[set];
            }
        }
        Self { starts, runs, count }
    }

    /// Number of obstacles, without walls.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// The number of the obstacle in a cell; `None` in walls, outside and where nothing is.
    pub fn number(&self, cell: Cell) -> Option<u32> {
        let row = usize::try_from(cell.y).ok()?;
        let (from, to) = (*self.starts.get(row)?, *self.starts.get(row + 1)?);
        let runs = &self.runs[from as usize..to as usize];
        let &(first, _, number) = runs.get(runs.partition_point(|run| run.1 < cell.x))?;
        (first <= cell.x && number > 0).then_some(number)
    }
}

/// Runs of cells in rows, and the sets of those that touch each other, including diagonally.
#[derive(Debug)]
pub(super) struct RunSets {
    /// Start of every row's runs in `runs`, from the bottom row.
    pub starts: Vec<u32>,
    /// First and last column of a run, and its number in `sets`.
    pub runs: Vec<(i32, i32, u32)>,
    /// Disjoint sets; number 0 is no run's.
    sets: Vec<u32>,
}

impl RunSets {
    /// The runs of cells with a value.
    pub fn of(cells: &Grid<bool>, value: bool) -> Self {
        let width = cells.width();
        let mut starts = vec![0];
        let mut runs: Vec<(i32, i32, u32)> = Vec::new();
        let mut sets = vec![0_u32];
        let mut below = 0..0;
        for row in cells.values().chunks(width) {
            let begin = runs.len();
            let mut x = 0;
            while let Some(skipped) = row[x..].iter().position(|&cell| cell == value) {
                let first = x + skipped;
                let end = row[first..].iter().position(|&cell| cell != value).map_or(width, |run| first + run);
                let set = sets.len() as u32;
                sets.push(set);
                runs.push((first as i32, end as i32 - 1, set));
                x = end;
            }
            let mut under = below.start;
            for run in begin..runs.len() {
                let (first, last, set) = runs[run];
                while under < below.end && runs[under].1 + 1 < first {
                    under += 1;
                }
                let mut touching = under;
                while touching < below.end && runs[touching].0 <= last + 1 {
                    join(&mut sets, set, runs[touching].2);
                    touching += 1;
                }
            }
            below = begin..runs.len();
            starts.push(runs.len() as u32);
        }
        Self { starts, runs, sets }
    }

    /// For every run, what `of` says of all runs of its set together.
    pub fn marks(&mut self, of: impl Fn(usize, (i32, i32)) -> u8) -> Vec<u8> {
        let mut marks = vec![0; self.sets.len()];
        for y in 0..self.starts.len() - 1 {
            for &(first, last, set) in &self.runs[self.starts[y] as usize..self.starts[y + 1] as usize] {
                marks[root(&mut self.sets, set) as usize] |= of(y, (first, last));
            }
        }
        self.runs.iter().map(|run| marks[root(&mut self.sets, run.2) as usize]).collect()
    }
}

/// The root of a set; shortens the way there (Tarjan & van Leeuwen 1984, path halving).
fn root(sets: &mut [u32], mut set: u32) -> u32 {
    while sets[set as usize] != set {
        let above = sets[sets[set as usize] as usize];
        sets[set as usize] = above;
        set = above;
    }
    set
}

/// Joins two sets under the lower number, so that the wall keeps its number.
fn join(sets: &mut [u32], a: u32, b: u32) {
    let (a, b) = (root(sets, a), root(sets, b));
    sets[a.max(b) as usize] = a.min(b);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{from_picture, picture};

    #[test]
    fn obstacles_are_numbered_from_the_top_left_and_walls_are_none() {
        let free = from_picture(
            "
            ..........#
            .##....#..#
            .##...#.#..
            ......###..
            ..#........
            .#...##....
            ......#....
            ......#....",
            |c| c == '.',
        )
        .unwrap();
        let obstacles = ObstacleRuns::of(&free);
        let numbers =
            Grid::from_rows(free.width(), free.iter().map(|(cell, _)| obstacles.number(cell)).collect::<Vec<_>>())
                .unwrap();
        let drawn = picture(&numbers, |n| n.map_or('.', |n| char::from_digit(n, 10).unwrap()));
        let expected = "
            ...........
            .11....2...
            .11...2.2..
            ......222..
            ..3........
            .3.........
            ...........
            ...........";
        assert_eq!(drawn.trim(), expected.replace("            ", "").trim());
        assert_eq!(obstacles.count(), 3);
        assert_eq!(obstacles.number(Cell::new(-1, 2)), None);
        assert_eq!(obstacles.number(Cell::new(2, 99)), None);
        // Nothing is wall.
        let cells = free.map(|free| !free);
        assert_eq!(ObstacleRuns::of_cells(&cells).count(), 5);
    }
}
