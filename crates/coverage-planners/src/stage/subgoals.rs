//! Stage: subgoal points, the contacts of a line-by-line scan (001, section 3).
//!
//! Steps 1 to 5 of the paper: the robot, turned to heading 0, begins at the upper left, moves along x until it
//! touches something, moves on by a line's distance, comes back, and so on to the lower right. Every contact is
//! recorded with what is touched, on which side, and the obstacle's number.
//!
//! # Where the paper is sloppy
//!
//! - *Ends of a line.* Step 2 records what is met on the way to the right as RIGHT, step 3 on the way back as LEFT,
//!   each on lines of its own: read as printed every line has one end only, and nothing is said of what lies behind
//!   an obstacle. Figure 3 and section 4, which looks for the point across on the same line, need both. Here every
//!   line gives both ends of each of its free runs: LEFT where the robot's left side touches in the paper's sense
//!   (smaller x), RIGHT at the other.
//! - *Step 4* moves by another line and goes back to step 1, which would reset `x`, `y` and `i`: read as going on
//!   with step 2.
//! - *Step 1* moves along x and y to find its first line: here the first line is the topmost row with a free cell.
//! - *The last line.* Step 3 ends at the lower right. The lowest row with a free cell is made a line too if none
//!   falls on it: so the floor along the lower wall isn't left out (ours).
//! - Lines are recorded to the right and to the left in turn, as the paper's robot moves.

use robovac_core::{
    cspace::ObstacleRuns,
    grid::{Cell, Grid},
};

/// What a body touches at the end of a scan line (001, section 3).
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LineEndContact {
    /// Its left side touches a wall of the workspace.
    LeftWall,
    /// Its right side touches a wall of the workspace.
    RightWall,
    /// Its left side touches an obstacle.
    LeftObstacle,
    /// Its right side touches an obstacle.
    RightObstacle,
}

impl LineEndContact {
    /// Whether the robot's left side touches.
    pub fn is_left(self) -> bool {
        matches!(self, Self::LeftWall | Self::LeftObstacle)
    }
}

/// A subgoal point, in a cell or (as a [`Point`](robovac_core::geometry::Point), m) at the exact place where the body
/// touches: the paper's `SubgoalPoints`, whose `tracked_flag` is kept by [`super::SubgoalScan`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Subgoal<P = Cell> {
    /// `posion`: where the robot is.
    pub at: P,
    /// `status`: what it touches.
    pub contact: LineEndContact,
    /// The scan line, counted from the top.
    pub line: u32,
    /// `obstacleNo`, counted from 1; `None` for a wall.
    pub obstacle: Option<u32>,
}

/// Rows of the scan lines, from the topmost free row to the lowest: `distance` rows apart, at least 1, not necessarily
/// a whole number.
pub fn scan_rows(free: &Grid<bool>, distance: f64) -> Vec<i32> {
    let width = free.width();
    let has_free = |&y: &i32| free.values()[y as usize * width..][..width].contains(&true);
    let height = free.height() as i32;
    let (Some(top), Some(bottom)) = ((0..height).rev().find(has_free), (0..height).find(has_free)) else {
        return Vec::new();
    };
    let distance = distance.max(1.0);
    let below = (0..).map(|line| robovac_core::math::floor(f64::from(line) * distance + 1e-9));
    let mut rows: Vec<i32> = below.map(|rows| top.saturating_sub(rows)).take_while(|&row| row >= bottom).collect();
    if rows.last() != Some(&bottom) {
        rows.push(bottom);
    }
    rows
}

/// Both ends of every run of free cells on the lines at `rows`, in the order of the scan. A run also ends between two
/// free cells if `is_joined` says of the left one that there is no way to the other.
pub fn subgoals(
    free: &Grid<bool>,
    rows: &[i32],
    obstacles: &ObstacleRuns,
    is_joined: impl Fn(Cell) -> bool,
) -> Vec<Subgoal> {
    let width = free.width();
    // What is between two free cells is seen in the rows beside them only.
    let touched = |x: i32, y: i32, side: i32| {
        let beside = [(side, 0), (0, 1), (0, -1), (side, 1), (side, -1)];
        let is_narrow = free.is_set(Cell::new(x + side, y));
        let looked_at = if is_narrow { &beside[..] } else { &beside[..1] };
        looked_at.iter().find_map(|&(dx, dy)| obstacles.number(Cell::new(x + dx, y + dy)))
    };
    let mut found: Vec<Subgoal> = Vec::new();
    for (&y, line) in rows.iter().zip(0..) {
        let begin = found.len();
        let row = &free.values()[y as usize * width..][..width];
        let mut x = 0;
        while let Some(skipped) = row[x..].iter().position(|&is_free| is_free) {
            let first = x + skipped;
            let mut end = first + 1;
            while end < width && row[end] && is_joined(Cell::new(end as i32 - 1, y)) {
                end += 1;
            }
            let (left, right) = (touched(first as i32, y, -1), touched(end as i32 - 1, y, 1));
            let subgoal = |x: usize, wall: LineEndContact, solid: LineEndContact, obstacle: Option<u32>| Subgoal {
                at: Cell::new(x as i32, y),
                contact: if obstacle.is_some() { solid } else { wall },
                line,
                obstacle,
            };
            found.push(subgoal(first, LineEndContact::LeftWall, LineEndContact::LeftObstacle, left));
            found.push(subgoal(end - 1, LineEndContact::RightWall, LineEndContact::RightObstacle, right));
            x = end;
        }
        if line % 2 == 1 {
            found[begin..].reverse();
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::from_picture;

    fn scanned(picture: &str, distance: f64) -> Vec<Subgoal> {
        let free = from_picture(picture, |c| c == '.').unwrap();
        subgoals(&free, &scan_rows(&free, distance), &ObstacleRuns::of(&free), |_| true)
    }

    /// 001, section 3, steps 1 to 3: from the upper left, to the right and to the left in turn, contacts with walls
    /// and obstacles.
    #[test]
    fn contacts_are_recorded_in_the_order_of_the_scan() {
        use LineEndContact::{LeftObstacle, LeftWall, RightObstacle, RightWall};
        let found = scanned(
            "
            ........
            ..##..#.
            ........",
            1.0,
        );
        let got: Vec<_> = found.iter().map(|s| (s.at.x, s.at.y, s.contact, s.obstacle)).collect();
        assert_eq!(
            got,
            [
                (0, 2, LeftWall, None),
                (7, 2, RightWall, None),
                (7, 1, RightWall, None),
                (7, 1, LeftObstacle, Some(2)),
                (5, 1, RightObstacle, Some(2)),
                (4, 1, LeftObstacle, Some(1)),
                (1, 1, RightObstacle, Some(1)),
                (0, 1, LeftWall, None),
                (0, 0, LeftWall, None),
                (7, 0, RightWall, None),
            ]
        );
        assert!(found.iter().zip([0, 0, 1, 1, 1, 1, 1, 1, 2, 2]).all(|(s, line)| s.line == line));
    }

    /// 001, section 3: "the separation can be varied".
    #[test]
    fn lines_are_as_far_apart_as_asked_and_reach_the_lowest_row() {
        let free = Grid::filled(3, 10, true);
        assert_eq!(scan_rows(&free, 3.0), [9, 6, 3, 0]);
        assert_eq!(scan_rows(&free, 4.0), [9, 5, 1, 0]);
        assert_eq!(scan_rows(&free, 2.5), [9, 7, 4, 2, 0]);
        assert_eq!(scan_rows(&free, 1e9), [9, 0]);
        assert_eq!(scan_rows(&free, 0.0).len(), 10);
        let narrow = from_picture("...\n###\n...\n###", |c| c == '.').unwrap();
        assert_eq!(scan_rows(&narrow, 1.0), [3, 2, 1]);
        assert!(scan_rows(&Grid::filled(3, 3, false), 1.0).is_empty());
    }

    #[test]
    fn runs_end_where_something_is_narrower_than_a_cell() {
        let free = from_picture("......\n..#...", |c| c == '.').unwrap();
        let tip = Cell::new(2, 1);
        let obstacles = ObstacleRuns::of_cells(&free.map(|free| !free));
        let found = subgoals(&free, &[1], &obstacles, |cell| cell != tip);
        let ends: Vec<_> = found.iter().map(|s| (s.at.x, s.obstacle)).collect();
        assert_eq!(ends, [(0, None), (2, Some(1)), (3, Some(1)), (5, None)]);
    }

    #[test]
    fn run_of_one_cell_is_touched_on_both_sides() {
        let found = scanned("#.#", 1.0);
        assert_eq!(found.len(), 2);
        assert!(found[0].at == found[1].at && found[0].contact.is_left() && !found[1].contact.is_left());
    }
}
