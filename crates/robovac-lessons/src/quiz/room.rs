//! Questions about random rooms.

use super::{Question, Right};
use rand::RngExt;
use robovac_core::rng::Rng;

/// A small room of square cells, rows from top to bottom.
struct QuizRoom {
    width: usize,
    free: Vec<bool>,
}

/// How many cells a robot of one cell reaches.
pub fn reachable(rng: &mut Rng) -> Question {
    loop {
        let room = QuizRoom::random(rng, 8, 6, 0.32);
        let Some(start) = room.free.iter().position(|free| *free) else { continue };
        let count = room.reached(start).iter().filter(|reached| **reached).count();
        let free = room.free.iter().filter(|free| **free).count();
        if count < 8 || free - count < 2 {
            continue;
        }
        let because = format!(
            "{count}: of {free} free cells, {} lie behind walls. Coverage is a share of the reachable floor only, so a robot \
             that sweeps those {count} cells has covered 100 %.",
            free - count
        );
        return Question {
            text: "A robot of one cell starts at S and moves up, down, left and right. How many cells can it reach, \
                   including its own?"
                .to_owned(),
            room: room.rows(Some(start)),
            options: Vec::new(),
            example: "e.g. 21".to_owned(),
            right: Right::Number(count as f64, 0.0),
            because,
        };
    }
}

/// Whether lanes along the rows or along the columns are fewer.
pub fn lanes(rng: &mut Rng) -> Question {
    loop {
        let room = QuizRoom::with_boxes(rng);
        let (along_rows, along_columns) = (room.lanes(false), room.lanes(true));
        if along_rows.abs_diff(along_columns) < 2 {
            continue;
        }
        let because = format!(
            "Counted piece by piece, rows make {along_rows} lanes and columns {along_columns}. Every lane ends in a \
             turn, so fewer lanes mean fewer turns."
        );
        return Question {
            text:
                "The robot sweeps in parallel lanes; a wall ends a lane. Along which direction are there fewer lanes?"
                    .to_owned(),
            room: room.rows(None),
            options: vec!["along the rows".to_owned(), "along the columns".to_owned()],
            example: String::new(),
            right: Right::Option(usize::from(along_columns < along_rows)),
            because,
        };
    }
}

/// Whether a closed walk visits every cell once.
pub fn parity(rng: &mut Rng) -> Question {
    let wants = rng.random_range(0..2) == 0;
    loop {
        let room = QuizRoom::random(rng, 5, 4, 0.2);
        let Some(start) = room.free.iter().position(|free| *free) else { continue };
        if room.reached(start) != room.free || room.free.iter().filter(|free| **free).count() < 10 {
            continue;
        }
        let [dark, light] = room.colours();
        let dead_end = (0..room.free.len()).any(|cell| room.free[cell] && room.neighbours(cell).count() < 2);
        let closes = room.closes(start);
        let because = if closes {
            "Yes, there is one: follow the walls, and fold the walk into the rest.".to_owned()
        } else if dark != light {
            format!(
                "No. Colour the cells like a chessboard: {dark} are dark and {light} light, but every step changes the colour, so a closed walk has as many of both."
            )
        } else if dead_end {
            "No. A cell with one free neighbour is a dead end: the robot must leave it the way it came.".to_owned()
        } else {
            continue;
        };
        if closes != wants {
            continue;
        }
        return Question {
            text: "Is there a walk that visits every free cell exactly once and returns to its first cell? Steps go up, down, \
                   left and right."
                .to_owned(),
            room: room.rows(None),
            options: vec!["yes".to_owned(), "no".to_owned()],
            example: String::new(),
            right: Right::Option(usize::from(!closes)),
            because,
        };
    }
}

impl QuizRoom {
    fn random(rng: &mut Rng, width: usize, height: usize, walls: f64) -> Self {
        Self { width, free: (0..width * height).map(|_| rng.random_range(0.0..1.0) >= walls).collect() }
    }

    /// A rectangle with three long boxes in it.
    fn with_boxes(rng: &mut Rng) -> Self {
        let (width, height) = (rng.random_range(7..11), rng.random_range(6..9));
        let mut room = Self { width, free: vec![true; width * height] };
        for _ in 0..3 {
            let (x, y) = (rng.random_range(1..width - 1), rng.random_range(1..height - 1));
            let (long, flat) = (rng.random_range(2..5), rng.random_range(0..2) == 0);
            for step in 0..long {
                let (x, y) = if flat { (x + step, y) } else { (x, y + step) };
                if x < width && y < height {
                    room.free[y * width + x] = false;
                }
            }
        }
        room
    }

    fn neighbours(&self, cell: usize) -> impl Iterator<Item = usize> {
        let (x, y) = (cell % self.width, cell / self.width);
        let height = self.free.len() / self.width;
        let all = [
            (x > 0).then(|| cell - 1),
            (x + 1 < self.width).then(|| cell + 1),
            (y > 0).then(|| cell - self.width),
            (y + 1 < height).then(|| cell + self.width),
        ];
        all.into_iter().flatten().filter(|next| self.free[*next])
    }

    fn reached(&self, start: usize) -> Vec<bool> {
        let mut reached = vec![false; self.free.len()];
        let mut open = vec![start];
        reached[start] = true;
        while let Some(cell) = open.pop() {
            for next in self.neighbours(cell) {
                if !std::mem::replace(&mut reached[next], true) {
                    open.push(next);
                }
            }
        }
        reached
    }

    /// Number of free pieces of all rows, or of all columns.
    fn lanes(&self, columns: bool) -> usize {
        let height = self.free.len() / self.width;
        let (lines, length) = if columns { (self.width, height) } else { (height, self.width) };
        let at = |line: usize, place: usize| {
            self.free[if columns { place * self.width + line } else { line * self.width + place }]
        };
        let starts = |line: usize| {
            (0..length).filter(move |&place| at(line, place) && (place == 0 || !at(line, place - 1))).count()
        };
        (0..lines).map(starts).sum()
    }

    /// Number of dark and of light free cells of a chessboard.
    fn colours(&self) -> [usize; 2] {
        let count = |colour: usize| {
            (0..self.free.len())
                .filter(|&cell| self.free[cell] && (cell % self.width + cell / self.width) % 2 == colour)
                .count()
        };
        [count(0), count(1)]
    }

    /// Whether a closed walk visits every cell once: by trying all.
    fn closes(&self, start: usize) -> bool {
        let count = self.free.iter().filter(|free| **free).count();
        let mut visited = vec![false; self.free.len()];
        visited[start] = true;
        self.goes_on(start, start, count - 1, &mut visited)
    }

    fn goes_on(&self, at: usize, start: usize, left: usize, visited: &mut [bool]) -> bool {
        if left == 0 {
            return self.neighbours(at).any(|next| next == start);
        }
        for next in self.neighbours(at).collect::<Vec<_>>() {
            if !visited[next] {
                visited[next] = true;
                if self.goes_on(next, start, left - 1, visited) {
                    return true;
                }
                visited[next] = false;
            }
        }
        false
    }

    fn rows(&self, start: Option<usize>) -> Vec<String> {
        let sign = |cell: usize| match self.free[cell] {
            _ if Some(cell) == start => 'S',
            true => '.',
            false => '#',
        };
        (0..self.free.len() / self.width).map(|y| (0..self.width).map(|x| sign(y * self.width + x)).collect()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn room(rows: &[&str]) -> QuizRoom {
        QuizRoom { width: rows[0].len(), free: rows.iter().flat_map(|row| row.chars().map(|c| c == '.')).collect() }
    }

    #[test]
    fn lanes_are_counted_piece_by_piece() {
        let room = room(&["....", ".##.", "...."]);
        assert_eq!((room.lanes(false), room.lanes(true)), (4, 6));
    }

    #[test]
    fn a_ring_closes_and_an_odd_room_does_not() {
        assert!(room(&["....", ".##.", "...."]).closes(0));
        assert!(!room(&["...", "...", "..."]).closes(0));
    }
}
