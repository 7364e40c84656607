//! Colour and shape of an algorithm, the same in all lists and charts.

use coverage_planners::PLANNERS;
use robovac_core::program::ProgramKind;
use robovac_sim::{controller::BEHAVIOURS, experiment::Algorithm};
use serde::Serialize;

/// Number of colours in `www/compare/compare.css`.
const COLOURS: usize = 8;
/// Shapes there, one for each round of the colours.
const PLANNER_SHAPES: [u8; 3] = [0, 1, 4];
const BEHAVIOUR_SHAPES: [u8; 3] = [2, 3, 5];

const _: () = assert!(
    PLANNERS.len() < COLOURS * PLANNER_SHAPES.len() && BEHAVIOURS.len() < COLOURS * BEHAVIOUR_SHAPES.len(),
    "there are more algorithms than marks: add a shape here, and draw it as www/compare/*.css draws the others"
);

/// A mark that no other algorithm has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Mark {
    colour: usize,
    shape: u8,
}

impl Mark {
    /// The mark of an algorithm of the registries, by its position there. Programs of users come after them.
    pub fn of(algorithm: Algorithm) -> Self {
        let (shapes, position, count) = match algorithm {
            Algorithm::Planner(info) => {
                (PLANNER_SHAPES, PLANNERS.iter().position(|other| other.id == info.id), PLANNERS.len())
            }
            Algorithm::Behaviour(info) => {
                (BEHAVIOUR_SHAPES, BEHAVIOURS.iter().position(|other| other.id == info.id), BEHAVIOURS.len())
            }
        };
        let number = position.unwrap_or(count);
        Self { colour: number % COLOURS, shape: shapes[number / COLOURS] }
    }

    /// That of a copy: none of those `taken`, as long as there is another; in the same colour, if one is left.
    pub fn copied(self, taken: &[Self]) -> Self {
        let colours = (0..COLOURS).map(|step| (self.colour + step) % COLOURS);
        let shapes = || PLANNER_SHAPES.into_iter().chain(BEHAVIOUR_SHAPES);
        let mut all = colours.flat_map(|colour| shapes().map(move |shape| Self { colour, shape }));
        all.find(|mark| !taken.contains(mark)).unwrap_or(self)
    }

    /// The marks of all algorithms, and of programs.
    pub fn of_all() -> Vec<Self> {
        let programs = [ProgramKind::Behaviour, ProgramKind::Planner].map(Algorithm::of_program);
        Algorithm::all().chain(programs).map(Self::of).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_algorithms_look_the_same_and_the_page_draws_all() {
        let all = Mark::of_all();
        assert!((1..all.len()).all(|i| !all[..i].contains(&all[i])), "{all:?}");
        let css =
            [include_str!("../../../www/compare/compare.css"), include_str!("../../../www/compare/montecarlo.css")];
        let shapes = PLANNER_SHAPES.into_iter().chain(BEHAVIOUR_SHAPES).filter(|&shape| shape > 0);
        // A behaviour may have the colour of the planner that it races against.
        let wanted =
            shapes.flat_map(|shape| [".swatch", ".race-curves "].map(|of| format!("{of}[data-shape=\"{shape}\"]")));
        for rule in wanted.chain((0..COLOURS).map(|colour| format!("[data-colour=\"{colour}\"]"))) {
            assert!(css.iter().any(|css| css.contains(&rule)), "no style for {rule}");
        }
    }

    #[test]
    fn a_copy_of_boustrophedon_looked_like_subgoal_sweep() {
        let mut taken = Mark::of_all();
        for algorithm in [0, 0, 1, 0].map(|planner| Algorithm::Planner(PLANNERS[planner])) {
            let copy = Mark::of(algorithm).copied(&taken);
            assert!(!taken.contains(&copy), "{copy:?}");
            taken.push(copy);
        }
    }
}
