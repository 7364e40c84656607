//! Stage: tells a finished walk decision by decision, for the display of the search.

use crate::{CoverageJob, PlanContext, TraceStep};
use robovac_core::grid::{Cell, Direction};

/// What a planner goes by, from one cell to the next.
pub(crate) trait Reasons {
    /// Takes a cell that is entered for the first time.
    fn visit(&mut self, _cell: Cell) {}

    /// The values of the uncleaned neighbours in these directions; none if it compares no values.
    fn values(&self, _at: Cell, _heading: Direction, _open: &[Direction]) -> Vec<u32> {
        Vec::new()
    }

    /// The rule that leads to an uncleaned cell, in a few words.
    fn rule(&self, at: Cell, heading: Direction, towards: Direction) -> &'static str;
}

/// A rule that only knows whether the robot goes straight on.
pub(crate) struct Straight {
    /// Its words for a step straight on.
    pub on: &'static str,
    /// Its words for a turn.
    pub turn: &'static str,
}

impl Reasons for Straight {
    fn rule(&self, _at: Cell, heading: Direction, towards: Direction) -> &'static str {
        if towards == heading { self.on } else { self.turn }
    }
}

/// Traces every step of `walk`, made by `reasons`: the decision, and the cells beside the robot with the values that are
/// compared, or else how often they were visited. Does nothing for a context without tracer.
pub(crate) fn tell_walk(ctx: &mut PlanContext<'_>, job: &CoverageJob, walk: &[Cell], reasons: &mut dyn Reasons) {
    if !ctx.is_traced() {
        return;
    }
    let mut is_left = job.free.clone();
    let firsts: Vec<bool> = walk.iter().map(|&cell| std::mem::take(&mut is_left[cell])).collect();
    let mut visits = job.free.map(|_| 0_u32);
    let mut heading = job.heading;
    for (step, pair) in walk.windows(2).enumerate() {
        let (at, to) = (pair[0], pair[1]);
        let Some(towards) = at.direction_to(to) else { continue };
        visits[at] += 1;
        if visits[at] == 1 {
            reasons.visit(at);
        }
        let mut free = vec![heading, heading.left(), heading.right(), heading.opposite()];
        free.retain(|&look| job.free.is_set(at.step(look)));
        let open: Vec<Direction> = free.iter().copied().filter(|&look| visits[at.step(look)] == 0).collect();
        let values = reasons.values(at, heading, &open);
        let (rule, note) = if firsts[step + 1] {
            let rule = reasons.rule(at, heading, towards);
            let compared: Vec<String> =
                open.iter().zip(&values).map(|(&look, value)| format!("{value} {}", place(look))).collect();
            let compared = if compared.len() > 1 { format!("{}; ", compared.join(", ")) } else { String::new() };
            let go = if towards == heading { "straight on" } else { going(towards) };
            (rule, format!("{rule}: {compared}{go}"))
        } else {
            ("Over clean floor", way(&firsts[step + 1..], open.is_empty()))
        };
        let marks = if values.is_empty() {
            free.iter().map(|&look| (at.step(look), visits[at.step(look)])).collect()
        } else {
            open.iter().map(|&look| at.step(look)).zip(values).collect()
        };
        ctx.trace(|| TraceStep { step, rule: rule.into(), at, towards, marks, sides: None, note });
        heading = towards;
    }
}

/// A way over clean floor, of which `firsts` are the steps to come, in words.
fn way(firsts: &[bool], is_shut_in: bool) -> String {
    let steps = |steps: usize| if steps == 1 { "1 step".to_owned() } else { format!("{steps} steps") };
    match firsts.iter().position(|&is_first| is_first) {
        Some(left) if is_shut_in => format!("No uncleaned cell beside it: {} to the next one", steps(left + 1)),
        Some(left) => format!("Over clean floor to the next part: {} to go", steps(left + 1)),
        None => format!("All is clean: {} to the end", steps(firsts.len())),
    }
}

/// The words for a movement in a direction.
pub(crate) fn going(direction: Direction) -> &'static str {
    match direction {
        Direction::Right => "to the right",
        Direction::Up => "up",
        Direction::Left => "to the left",
        Direction::Down => "down",
    }
}

/// The words for a place in a direction.
pub(crate) fn place(direction: Direction) -> &'static str {
    match direction {
        Direction::Right => "on the right",
        Direction::Up => "above",
        Direction::Left => "on the left",
        Direction::Down => "below",
    }
}
