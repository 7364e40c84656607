//! Improved snake: go straight, turn where the way is blocked or clean, towards the least-visited neighbour.
//!
//! By Emu & Obaida 2020 (thesis, East West University), section 4.2, Table 1 and the program in Appendix B. Every cell
//! has a value: unseen, 0 for seen from a neighbouring cell, then the number of visits. The robot
//!
//! 1. goes straight on while the cell ahead has not been visited;
//! 2. else turns left or right to the neighbour of smaller value, goes one step and turns the same way once more
//!    (which makes a lawn mower's U-turn) or wherever the smaller value is by then;
//! 3. between equal neighbours takes the side with the *smaller block*, the one with fewer cells still to be cleaned;
//! 4. with nowhere to turn to goes on over cleaned cells, or back.
//!
//! On the program's own room of 8 x 8 cells this planner walks exactly as the program does: 65 steps, 12 revisits.
//!
//! # Where text, flowchart and program disagree
//!
//! - *Smaller block.* The text compares "descendants" on both sides of the robot. The program counts, when the robot
//!   faces along x, the cells of value 0 in all rows above and below its row, and when it faces along y, cells of value 0
//!   *and unseen* ones in all columns left and right of its column. Equal counts: the side whose edge of the grid is
//!   nearer. Facing along x a side without any such cell loses; facing along y it wins. All of this is kept.
//! - *Back.* The text turns round and visits the previous cell. The program keeps a stack, but pops what it has just
//!   pushed: after a straight piece between a block and a cleaned cell it backs out by one cell without turning; between
//!   two blocks, and after a turn, "back" drives *ahead*. Kept, while the cell there is free. One refinement of the
//!   program is kept as well: it sees "block on one side, cleaned on the other" only when it faces along x.
//! - *Minimum valued neighbour forward.* The text compares values; the program compares row and column *indices*.
//!   Values are compared here; on the program's room both come to the same.
//! - *Values.* The text adds one a visit; the program adds one more in some of its branches and none in others. Here a
//!   value is the number of visits.
//! - *The end.* The text has none; the program ends when both counts are 0, which may be too early (the robot's own row
//!   or column isn't counted), and goes on in the callers of the function that ended. Here it ends when all is clean.
//!
//! # Where the rules don't lead on
//!
//! Off its own room the program leaves the grid, drives through blocks or goes in circles. Here a rule that would leave
//! the free cells is not followed, and cleaned cells are crossed by the rules for at most *patience* times the
//! number of steps to the nearest cell that isn't clean (8 steps of 10 in the program's room). After that the robot takes
//! a shortest way to that cell and starts again from rule 1. So every walk ends and covers all.
//!
//! # The program itself
//!
//! *Rules* "program" does what the program does, with all of the above as in Appendix B, until it would
//! leave the grid, enter a block, jump, or has visited all. A second transcription in the tests walks the same, step for
//! step, in seeded rooms of 6 to 20 cells on a side.
//!
//! ```
//! use robovac_core::grid::*;
//! use coverage_planners::*;
//! let free = from_picture("....\n.#..\n....", |c| c == '.').unwrap();
//! let job = CoverageJob::new(&free, Cell::new(0, 2), Direction::Right).unwrap();
//! let info = find("snake").unwrap();
//! let planner = info.build(&Params::defaults(info.params));
//! let path = planner.plan(&job, &mut PlanContext::new(0)).unwrap();
//! assert_eq!(path.arrows(&job), ">>>v\no#v<\n^<>^\n");
//! ```

mod memory;
mod online;
mod program;
mod text;
mod walk;

pub use online::OnlineSnake;

use super::{BuildPlanner, PlannerClaims, PlannerInfo, Search};
use robovac_core::registry::{Example, Explainer, ParamKind, ParamSpec};

/// Entry in the registry.
pub const INFO: PlannerInfo = PlannerInfo {
    id: "snake",
    title: "Improved snake",
    summary: "Drives straight until the next cell is blocked or clean, then turns to the least-visited neighbour.",
    claims: PlannerClaims { complete: true, deterministic: true, fast: true, in_metres: None, search: Search::None },
    params: &[
        ParamSpec {
            id: "rules",
            label: "Rules",
            help: "The thesis' rules clean every cell. Its printed program differs: it can stop early or go in \
                   circles.",
            kind: ParamKind::Choice { options: &[("text", "text"), ("program", "program")] },
        },
        ParamSpec {
            id: "patience",
            label: "Patience",
            help: "How far the rules can lead over clean floor, relative to the distance to the nearest uncleaned \
                   cell.",
            kind: ParamKind::Number { min: 0.0, max: 20.0, step: 1.0, default: 2.0, unit: "" },
        },
    ],
};

/// Its explanation.
pub const EXPLAINER: Explainer = Explainer {
    idea: "The robot counts its visits to every cell and drives straight while the cell ahead is new. Otherwise it \
           turns to the least-visited neighbour and turns once more, which makes a lawn mower's U-turn. Between \
           equal neighbours it takes the side with fewer uncleaned cells, so that no small corner remains.",
    complexity: "O(n) steps by the rules, each O(width + height); O(n) memory for n cells.",
    use_when: "Uses only neighbouring cells, so it runs online on a small controller. It leaves islands that it \
               must return to.",
    shines: Example { room: "empty", why: "No obstacles: a lawn mower's U-turns from wall to wall." },
    fails: Example { room: "maze", why: "Branches that it passes stay uncleaned, so it keeps coming back." },
    source: "Emu & Obaida 2020, thesis, East West University: section 4.2 and Appendix B",
    link: "",
};

/// Makes the planner.
pub(super) const BUILD: BuildPlanner = |params| match params.choice("rules") {
    "program" => Box::new(program::SnakeByProgram),
    _ => Box::new(text::SnakeByText { patience: params.number("patience") as usize }),
};
