use robovac_playground::{grid::*, planner::*, registry::ParamValue};
use std::time::Instant;
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let text = std::fs::read_to_string(&args[1]).unwrap();
    let picture: String = text.lines().filter(|l| !l.starts_with(';')).collect::<Vec<_>>().join("\n");
    let free = from_picture(&picture, |c| c != '#').unwrap();
    let chars = from_picture(&picture, |c| c).unwrap();
    let start = chars.iter().find(|&(_, &c)| c == 'S').or_else(|| chars.iter().find(|&(_, &c)| c == '.')).unwrap().0;
    let job = CoverageJob::new(&free, start, Direction::Right).unwrap();
    let closed = args[1].contains("turncost");
    let objective = if closed { Objective::closed(1, 50) } else { Objective::open(1, 2) };
    let info = find("near_optimal").unwrap();
    let mut params = Params::defaults(info.params);
    params.set(info.params, "effort", ParamValue::Number(args.get(2).map_or(1.0, |s| s.parse().unwrap()))).unwrap();
    params.set(info.params, "turn", ParamValue::Number(if closed { 50.0 } else { 2.0 })).unwrap();
    if closed {
        params.set(info.params, "finish", ParamValue::Choice("start".into())).unwrap();
    }
    let t = Instant::now();
    let mut last = 0;
    let mut observe = |r: Report<'_>| {
        let cost = if r.walk.is_empty() { 0 } else { objective.of_walk(&job, r.walk) };
        if cost != last {
            last = cost;
            println!("{:.3} {cost} {:?} {:?}", r.done, r.proof, t.elapsed());
        }
        std::ops::ControlFlow::Continue(())
    };
    let mut ctx = PlanContext::observed(0, &mut observe);
    let path = info.build(&params).plan(&job, &mut ctx).unwrap();
    let proof = ctx.proof;
    path.check(&job).unwrap();
    let visits = path.visits(&job);
    assert!(job.free.iter().all(|(c, &f)| !f || visits[c] > 0));
    println!("end {} {proof:?} {:?}", objective.of_walk(&job, &path.cells), t.elapsed());
}
