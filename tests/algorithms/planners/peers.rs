//! What other people's planners reach on the shared grids: ours must not be worse. Skipped where the folder doesn't exist.
//!
//! The figures are those of `../shared/maps/peers.md`: steps + 2 x quarter turns of planners measured as their authors
//! wrote them. Those that miss cells aren't peers, but for the wavefronts, whose walks are held to be no longer even so.

use super::support::shared_grids;
use coverage_planners::{PlanContext, find, metrics::WalkMetrics};
use robovac_core::registry::{ParamValue, Params};

/// Our planner, and the cost of the same planner elsewhere on the grids a, b, c, d, e.
const PEERS: &[(&str, [usize; 5])] = &[
    ("wavefront_distance", [516, 124, 2430, 12456, 25612]),
    ("wavefront_path", [516, 128, 2352, 12422, 23566]),
    ("spiral_stc", [480, 108, 1874, 9796, 18560]),
    ("backtracking_spiral", [475, 97, 1632, 10570, 22689]),
    ("boustrophedon", [476, 81, 2923, 11702, 28217]),
    ("energy", [475, 81, 1899, 9961, 18011]),
    // One less than the best complete peer, 1632, 9381 and 17180; the optimum on the first two.
    ("boustrophedon_cells", [475, 81, 1631, 9380, 17179]),
];

#[test]
fn walks_cost_no_more_than_those_of_the_same_planner_elsewhere() {
    for scenario in shared_grids() {
        let Some(grid) = ["a_", "b_", "c_", "d_", "e_"].iter().position(|start| scenario.name.starts_with(start))
        else {
            continue;
        };
        let job = scenario.jobs().next().expect("the grid has a start");
        for (id, costs) in PEERS {
            let info = find(id).expect("the planner exists");
            let planner = info.build(&Params::defaults(info.params));
            let path = planner.plan(&job, &mut PlanContext::new(1)).expect("nobody cancels");
            let WalkMetrics { steps, turns, visited_cells, reachable_cells, .. } = WalkMetrics::of(&job, &path);
            assert_eq!(visited_cells, reachable_cells, "{id} on {}", scenario.name);
            let (cost, peer) = (steps + 2 * turns, costs[grid]);
            assert!(cost <= peer, "{id} on {}: {cost}, elsewhere {peer}", scenario.name);
        }
    }
}

/// What the project asks of `near_optimal` on the rooms that take it seconds: the optimum, proven, on the first two, and on
/// the third at most 1.2 % above the bound of `../shared/maps/peers.md`, 1556.
#[test]
fn near_optimal_is_near_the_optimum_and_proves_it_where_rooms_are_small() {
    for scenario in shared_grids() {
        let asked = [("a_", 475, true), ("b_", 81, true), ("c_", 1574, false)];
        let Some((_, most, is_proven)) = asked.into_iter().find(|(start, ..)| scenario.name.starts_with(start)) else {
            continue;
        };
        let job = scenario.jobs().next().expect("the grid has a start");
        let info = find("near_optimal").expect("the planner exists");
        let params = Params::checked(info.params, [("turn", ParamValue::Number(2.0))]).expect("it's in range");
        let mut ctx = PlanContext::new(1);
        let path = info.build(&params).plan(&job, &mut ctx).expect("nobody cancels");
        let WalkMetrics { steps, turns, visited_cells, reachable_cells, .. } = WalkMetrics::of(&job, &path);
        assert_eq!(visited_cells, reachable_cells, "{}", scenario.name);
        let (cost, proof) = (steps + 2 * turns, ctx.proof.expect("it proves something"));
        assert!(cost <= most, "{}: {cost}, asked {most}", scenario.name);
        assert!(proof.bound <= proof.cost, "{}", scenario.name);
        assert!(!is_proven || proof.bound == proof.cost, "{}: {proof:?}", scenario.name);
    }
}
