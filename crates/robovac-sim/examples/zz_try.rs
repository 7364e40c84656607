//! scratch
use robovac_core::{floor_plan::generate::{FlatSpec, generate_flat}, registry::*, robot::model};
use robovac_sim::{*, controller::{self, Setup, learned::*}, experiment::RoomSetup};
use std::{sync::Arc, time::Instant};
fn main() {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let n: u64 = args[0].parse().unwrap();
    let robot = model("roomba600").unwrap();
    let t = Instant::now();
    let from: u64 = std::env::var("FROM").ok().map_or(300_000, |t| t.parse().unwrap());
    let flats: Vec<_> = (0..n).map(|s| RoomSetup::new(&generate_flat(from + s, &FlatSpec::default()), robot, robot.default_cell, None).unwrap()).collect();
    eprintln!("prep {:.3} s", t.elapsed().as_secs_f64());
    for what in &args[1..] {
        let t = Instant::now();
        let mut cov = vec![]; let (mut bumps, mut dist) = (0, 0.0); let mut err = vec![]; let mut jumps = vec![];let mut errs=[0.0_f64;10]; let mut times=[0.0_f64;5]; let (mut area, mut whole) = (0.0, 0.0);
        for (i, f) in flats.iter().enumerate() {
            let mut parts = what.split(':');
            let (id, track) = (parts.next().unwrap(), parts.next());
            let slip = match parts.next() { Some("none") => SlipLevel::None, _ => SlipLevel::Typical };
            let cond = Conditions { slip, noise: Noise::all(NoiseLevel::Typical), ..Conditions::default() };
            let (id, file) = if id.contains('/') { ("learned", Some(id)) } else { (id, None) };
            let info = controller::find(id).unwrap();
            let params = match track { Some(t) if !t.is_empty() => Params::checked(info.params, [("tracking", ParamValue::Choice(t.to_owned()))]).unwrap(), _ => Params::defaults(info.params) };
            let setup = Setup { robot, params: &params, seed: i as u64 };
            let c = match file { Some(f) => drive_by(&setup, Arc::new(Network::parse(&std::fs::read_to_string(f).unwrap()).unwrap())), None => info.build(&setup).unwrap() };
            let mut run = Run::new(&f.setup(cond, i as u64), c);
            while !run.is_finished() && run.time_s() < 1200.0 { let before = run.controller().estimate().map(|p| p.position()); run.step(); if let (Some(b), Some(a)) = (before, run.controller().estimate()) { let d = (a.position()-b).norm(); if d > 0.03 { jumps.push((d*100.0) as i32); } let e = (a.position() - run.pose().position()).norm(); if run.steps() % 8000 == 7999 { errs[(run.steps()/8000) as usize] += e / n as f64; } }
                let a = run.activity(); let v = run.commanded(); let (f, w) = (0.5*(v.left+v.right), (v.right-v.left).abs());
                let k = if a.starts_with("turning") { 0 } else if a.starts_with("backing") { 1 } else if f.abs() < 0.05 && w > 0.1 { 2 } else if f < 0.2 { 3 } else { 4 };
                times[k] += 0.015; }
            area += run.coverage() * f.floor.area(); whole += f.floor.area();
            cov.push(100.0*run.coverage()); bumps += run.bumps(); dist += run.distance_m();
            if let Some(e) = run.controller().estimate() { err.push((e.position() - run.pose().position()).norm()); }
        }
        if std::env::var("J").is_ok() { println!("jumps {jumps:?}"); } println!("errs by 2 min {errs:.2?}"); let s = t.elapsed().as_secs_f64() / n as f64;
        let mean = cov.iter().sum::<f64>() / n as f64;
        cov.sort_by(f64::total_cmp); err.sort_by(f64::total_cmp);
        println!("{what:40} mean {mean:.1} median {:.1} p10 {:.1} p90 {:.1}  {:.0} ms/run bumps {:.0} dist {:.0} err {:?}", cov[n as usize/2], cov[n as usize/10], cov[9*n as usize/10], 1e3*s, f64::from(bumps)/n as f64, dist/n as f64, err.get(err.len()/2)); println!("   s: turn move {:.0} back {:.0} | roam: spot {:.0} slow {:.0} fast {:.0} | swept {:.1} of {:.1} m2, per m {:.3}", times[0]/n as f64, times[1]/n as f64, times[2]/n as f64, times[3]/n as f64, times[4]/n as f64, area/n as f64, whole/n as f64, area/dist);
    }
}
