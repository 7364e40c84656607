//! What other people's planners reach on the shared grids, where they are there, and what ours have reached before in rooms of
//! our own: no walk may become worse.
//!
//! Figures of others are those of `../shared/maps/peers.md`: steps + 2 x quarter turns of planners measured as their authors
//! wrote them. Those that miss cells aren't peers, but for the wavefronts, whose walks are held to be no longer even so.

use super::support::measured;
use coverage_planners::{PlanContext, find, metrics::WalkMetrics};
use robovac_core::registry::{ParamValue, Params};

/// Our planners.
const PLANNERS: [&str; 7] = [
    "wavefront_distance",
    "wavefront_path",
    "spiral_stc",
    "backtracking_spiral",
    "boustrophedon",
    "energy",
    "boustrophedon_cells",
];

/// What each of them may cost in a room.
const COSTS: &[(&str, [usize; 7])] = &[
    ("own: empty", [299, 287, 259, 259, 259, 259, 259]),
    ("own: clutter", [306, 325, 299, 321, 294, 313, 278]),
    ("own: hall", [769, 751, 669, 687, 667, 687, 649]),
    // The last is one less than the best complete peer, 1632, 9381 and 17180; the optimum on the first two.
    ("a_", [516, 516, 480, 475, 476, 475, 475]),
    ("b_", [124, 128, 108, 97, 81, 81, 81]),
    ("c_", [2430, 2352, 1874, 1632, 2923, 1899, 1631]),
    ("d_", [12456, 12422, 9796, 10570, 11702, 9961, 9380]),
    ("e_", [25612, 23566, 18560, 22689, 28217, 18011, 17179]),
];

// slow: up to a million cells where the shared grids are there
#[test]
fn walks_cost_no_more_than_those_of_the_same_planner_elsewhere() {
    for (scenario, most) in measured(COSTS) {
        let job = scenario.jobs().next().expect("the grid has a start");
        for (id, most) in PLANNERS.into_iter().zip(most) {
            let info = find(id).expect("the planner exists");
            let planner = info.build(&Params::defaults(info.params));
            let path = planner.plan(&job, &mut PlanContext::new(1)).expect("nobody cancels");
            let metrics = WalkMetrics::of(&job, &path);
            assert_eq!(metrics.visited_cells, metrics.reachable_cells, "{id} on {}", scenario.name);
            assert!(metrics.cost() <= most, "{id} on {}: {}, not {most}", scenario.name, metrics.cost());
        }
    }
}

/// The optimum, proven, in small rooms, and in the third at most 1.2 % above the bound of `../shared/maps/peers.md`, 1556.
// slow: a proof is a search to its end
#[test]
fn near_optimal_is_near_the_optimum_and_proves_it_where_rooms_are_small() {
    let asked = [
        ("own: empty", (259, true)),
        ("own: clutter", (258, false)),
        ("own: hall", (647, false)),
        ("a_", (475, true)),
        ("b_", (81, true)),
        ("c_", (1574, false)),
    ];
    for (scenario, (most, is_proven)) in measured(&asked) {
        let job = scenario.jobs().next().expect("the grid has a start");
        let info = find("near_optimal").expect("the planner exists");
        let params = Params::checked(info.params, [("turn", ParamValue::Number(2.0))]).expect("it's in range");
        let mut ctx = PlanContext::new(1);
        let path = info.build(&params).plan(&job, &mut ctx).expect("nobody cancels");
        let metrics = WalkMetrics::of(&job, &path);
        assert_eq!(metrics.visited_cells, metrics.reachable_cells, "{}", scenario.name);
        let (cost, proof) = (metrics.cost(), ctx.proof.expect("it proves something"));
        assert!(cost <= most, "{}: {cost}, asked {most}", scenario.name);
        assert!(proof.bound <= proof.cost, "{}", scenario.name);
        assert!(!is_proven || proof.bound == proof.cost, "{}: {proof:?}", scenario.name);
    }
}
