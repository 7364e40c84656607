//! Colour and shape of an algorithm, the same in all lists and charts.

use coverage_planners::PLANNERS;
use robovac_core::program::ProgramKind;
use robovac_sim::{controller::BEHAVIOURS, experiment::Algorithm};
use serde::Serialize;

/// The colours in `www/compare/compare.css` that nobody takes for each other, and those that resemble one of them: orange and sky
/// blue.
const CLEAR: [usize; 6] = [0, 1, 2, 3, 6, 7];
const ALIKE: [usize; 2] = [4, 5];
const COLOURS: usize = CLEAR.len() + ALIKE.len();
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
        // The first behaviour, a random walk, races against the first planner: their colours differ.
        let (shapes, first, position, count) = match algorithm {
            Algorithm::Planner(info) => {
                (PLANNER_SHAPES, 0, PLANNERS.iter().position(|other| other.id == info.id), PLANNERS.len())
            }
            Algorithm::Behaviour(info) => {
                (BEHAVIOUR_SHAPES, 1, BEHAVIOURS.iter().position(|other| other.id == info.id), BEHAVIOURS.len())
            }
        };
        let number = position.unwrap_or(count);
        // Those that resemble others once the others are used up.
        let (colours, number) = match number.checked_sub(CLEAR.len() * shapes.len()) {
            None => (&CLEAR[..], number),
            Some(number) => (&ALIKE[..], number),
        };
        Self { colour: colours[(first + number) % colours.len()], shape: shapes[number / colours.len()] }
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

    /// Lightness and two axes of colour, in which equal distances look equal (`OKLab`, Ottosson 2020).
    fn seen(hex: &str) -> [f64; 3] {
        let linear = [1, 3, 5].map(|at| {
            let value = f64::from(u8::from_str_radix(&hex[at..at + 2], 16).unwrap()) / 255.0;
            if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
        });
        let mixed = |rows: [[f64; 3]; 3], of: [f64; 3]| rows.map(|row| (0..3).map(|i| row[i] * of[i]).sum::<f64>());
        let cones = mixed([[0.4122, 0.5363, 0.0514], [0.2119, 0.6807, 0.1074], [0.0883, 0.2817, 0.63]], linear);
        mixed([[0.2105, 0.7936, -0.0041], [1.978, -2.4286, 0.4506], [0.0259, 0.7828, -0.8087]], cones.map(f64::cbrt))
    }

    #[test]
    fn random_walk_and_bounce_were_both_blue_diamonds() {
        let css = include_str!("../../../www/compare/compare.css");
        let colours: Vec<Vec<[f64; 3]>> = (0..COLOURS)
            .map(|colour| {
                let start = css.split_once(&format!("--c-{colour}: light-dark(")).unwrap().1;
                start.split_once(')').unwrap().0.split(", ").map(seen).collect()
            })
            .collect();
        let apart = |a: usize, b: usize, theme: usize| {
            let (a, b) = (colours[a][theme], colours[b][theme]);
            (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum::<f64>().sqrt()
        };
        let all = Mark::of_all();
        for (index, one) in all.iter().enumerate() {
            for other in all[..index].iter().filter(|other| other.shape == one.shape) {
                let least = apart(one.colour, other.colour, 0).min(apart(one.colour, other.colour, 1));
                assert!(least > 0.12, "{one:?} and {other:?} look alike: {least}");
            }
        }
    }

    #[test]
    fn random_walk_against_lanes_was_a_race_of_two_blues() {
        let [lanes, walk] = [Algorithm::Planner(PLANNERS[0]), Algorithm::Behaviour(BEHAVIOURS[0])].map(Mark::of);
        assert_ne!(lanes.colour, walk.colour);
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
