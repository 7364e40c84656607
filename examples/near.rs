use robovac_playground::{grid::*, planner::*};
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
    let mut job = job;
    if closed {
        job.turn_s = 50.0;
    }
    let objective = if closed { Objective::closed(1, 50) } else { Objective::open(1, 2) };
    let t = Instant::now();
    let name = args.get(3).map_or("boustrophedon_cells", |s| s.as_str());
    let info = find(name).unwrap();
    let mut walk = info.build(&Params::defaults(info.params)).plan(&job, &mut PlanContext::new(0)).unwrap().cells;
    println!("first {} in {:?}", objective.of_walk(&job, &walk), t.elapsed());
    if closed {
        // back by breadth first
        let mut dist = Grid::filled(free.width(), free.height(), u32::MAX);
        dist[start] = 0;
        let mut q = std::collections::VecDeque::from([start]);
        while let Some(c) = q.pop_front() {
            for n in c.neighbours() {
                if job.free.is_set(n) && dist[n] == u32::MAX {
                    dist[n] = dist[c] + 1;
                    q.push_back(n);
                }
            }
        }
        let mut at = *walk.last().unwrap();
        while at != start {
            at = at.neighbours().into_iter().find(|&n| job.free.is_set(n) && dist[n] + 1 == dist[at]).unwrap();
            walk.push(at);
        }
        println!("closed {}", objective.of_walk(&job, &walk));
    }
    let rounds = args.get(2).map_or(5000, |s| s.parse().unwrap());
    let t = Instant::now();
    let out = near_optimal::experiment(&job, objective, &walk, rounds, |w, c, b, k| {
        println!("{w} {c} {b} {k} {:?}", t.elapsed())
    });
    let path = CoveragePath { cells: out };
    path.check(&job).unwrap();
    let visits = path.visits(&job);
    assert!(job.free.iter().all(|(c, &f)| !f || visits[c] > 0));
    println!("end {} in {:?}", objective.of_walk(&job, &path.cells), t.elapsed());
}
