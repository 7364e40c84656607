//! Statements of the papers about their algorithms.

use coverage_planners::{CoverageJob, CoveragePath, PlanContext, TraceStep, find, metrics::WalkMetrics};
use proptest::prelude::*;
use robovac_core::{
    floor_plan::{generate::random_clutter, room},
    grid::{Cell, Direction, Grid},
    registry::{ParamValue, Params},
    robot::model,
};
use robovac_sim::experiment::planning::RoomSetup;

fn plan(id: &str, job: &CoverageJob, given: &[(&str, ParamValue)]) -> CoveragePath {
    let info = find(id).expect("the planner exists");
    let params = Params::checked(info.params, given.iter().cloned()).expect("the parameters are right");
    info.build(&params).plan(job, &mut PlanContext::new(0)).expect("nobody cancels")
}

fn choice(id: &'static str, word: &str) -> (&'static str, ParamValue) {
    (id, ParamValue::Choice(word.to_owned()))
}

/// A job in the upper left corner of an empty room.
fn empty(width: usize, height: usize) -> CoverageJob {
    let corner = Cell::new(0, height as i32 - 1);
    CoverageJob::new(&Grid::filled(width, height, true), corner, Direction::Right).expect("the start is free")
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    /// Gabriely & Rimon 2001, abstract: in a room of whole mega-cells no cell is visited twice.
    #[test]
    fn spanning_tree_visits_cells_of_whole_mega_cells_once(
        share in 0.0..0.5_f64,
        seed in 0..1000_u64,
        start in any::<prop::sample::Index>(),
        tree in prop::sample::select(vec!["spiral", "straight"]),
    ) {
        let coarse = random_clutter(9, 7, share, seed);
        let mut free = Grid::filled(18, 14, false);
        for y in 0..14 {
            for x in 0..18 {
                free[Cell::new(x, y)] = coarse[Cell::new(x / 2, y / 2)];
            }
        }
        let cells: Vec<Cell> = free.iter().filter(|&(_, &is_free)| is_free).map(|(cell, _)| cell).collect();
        let job = CoverageJob::new(&free, *start.get(&cells), Direction::Up).expect("the start is free");
        // Without a price of turns the walk with the fewest steps wins.
        let job = CoverageJob { turn_s: 0.0, ..job };
        let metrics = WalkMetrics::of(&job, &plan("spiral_stc", &job, &[choice("tree", tree)]));
        prop_assert_eq!(metrics.visited_cells, job.cells());
        prop_assert_eq!(metrics.steps, job.cells() - 1);
    }

    /// Zelinsky et al. 1993: without discomfort the path transform is the distance transform.
    #[test]
    fn path_transform_without_discomfort_is_the_distance_transform(share in 0.0..0.4_f64, seed in 0..1000_u64) {
        let free = random_clutter(17, 12, share, seed);
        let start = free.iter().find(|&(_, &is_free)| is_free).map_or(Cell::new(0, 0), |(cell, _)| cell);
        let job = CoverageJob::new(&free, start, Direction::Right).expect("the start is free");
        let path = plan("wavefront_path", &job, &[("alpha", ParamValue::Number(0.0))]);
        prop_assert_eq!(path, plan("wavefront_distance", &job, &[]));
    }
}

/// Zelinsky et al. 1993: the walk of complete coverage leads from the start to the goal.
#[test]
fn wavefront_walk_ends_beside_its_goal() {
    let job = empty(12, 9);
    let opposite = Cell::new(11, 0);
    for (word, goal) in [("start", job.start), ("farthest", opposite)] {
        let walk = plan("wavefront_distance", &job, &[choice("goal", word)]);
        let last = walk.cells.last().copied().expect("the walk has cells");
        assert!(last.manhattan(goal) <= 3, "ends in {last}, not at the {word} in {goal}");
    }
}

/// González et al. 2005: a spiral follows the walls on its reference side and ends in the middle.
#[test]
fn spiral_winds_to_the_middle_with_the_walls_on_its_reference_side() {
    let job = empty(8, 6);
    for (side, second) in [("left", Cell::new(1, 5)), ("right", Cell::new(0, 4))] {
        let path = plan("backtracking_spiral", &job, &[choice("side", side)]);
        let metrics = WalkMetrics::of(&job, &path);
        assert_eq!((metrics.steps, metrics.revisits), (47, 0), "{side}");
        assert_eq!(path.cells[1], second, "{side}");
        let last = path.cells.last().copied().expect("the walk has cells");
        assert!((2..6).contains(&last.x) && (2..4).contains(&last.y), "{side} ends in {last}");
    }
}

/// Hyun (001), section 6: the octagon in a hall of 20 m x 20 m with seven obstacles. Contacts are found, links that collide get a detour, and
/// all is swept; with lines two rows apart the finishing stage cleans what is left between them.
#[test]
fn subgoal_sweep_of_a_hall_with_seven_obstacles() {
    let (octagon, hall) = (model("octagon").expect("it exists"), room("hall20").expect("it ships"));
    let job = RoomSetup::new(&(hall.build)(), octagon, octagon.default_cell, None).expect("it fits").job;
    let info = find("subgoal_sweep").expect("it exists");
    for lines in [1.0, 2.0] {
        let params = Params::checked(info.params, [("scan_lines", ParamValue::Number(lines))]).expect("it is in range");
        let mut told: Vec<TraceStep> = Vec::new();
        let mut tracer = |step: TraceStep| told.push(step);
        let mut ctx = PlanContext::new(0).traced(&mut tracer);
        let path = info.build(&params).plan(&job, &mut ctx).expect("nobody cancels");
        let metrics = WalkMetrics::of(&job, &path);
        assert_eq!(metrics.visited_cells, metrics.reachable_cells);
        let contacts = told[0].marks.len();
        let detours: Vec<&TraceStep> = told.iter().filter(|step| step.rule == "Detour").collect();
        let last = detours.last().map_or("", |step| &step.note);
        let count = detours.len();
        assert!(last.ends_with(&format!("collision {count}, {count} resolved")), "{last}");
        let finished = told.iter().filter(|step| step.rule == "Finish").count();
        println!("{lines} rows: {contacts} subgoals, {count} collisions, {} steps; {last}", metrics.steps);
        // One link a contact, then at most a word on what is left.
        assert_eq!((told.len(), finished), (1 + contacts + finished, usize::from(lines > 1.0)));
    }
}
