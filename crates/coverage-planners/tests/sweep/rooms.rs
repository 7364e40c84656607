//! Random rooms and outlines, told by their seed; the tests of the simulator share them.

use coverage_planners::sweep::{LinkOrder, SweepSetup};
use rand::RngExt;
use robovac_core::{
    cspace::Outline,
    floor_plan::{FloorPlan, Object, Sketch},
    geometry::{Point, Pose, Vector},
    rng::Rng,
};

/// A polygon around the origin, star-shaped and seldom convex.
fn star(rng: &mut Rng, corners: usize, [least, most]: [f64; 2]) -> Vec<Point> {
    let corner = |i: usize, rng: &mut Rng| {
        let angle = (i as f64 + rng.random_range(0.1..0.9)) / corners as f64 * std::f64::consts::TAU;
        Point::from(rng.random_range(least..most) * Vector::new(angle.cos(), angle.sin()))
    };
    (0..corners).map(|i| corner(i, rng)).collect()
}

/// A room with blocks of cells, and convex objects as small as table legs anywhere.
pub fn random_room(rng: &mut Rng) -> FloorPlan {
    let (width, height) = (rng.random_range(1.5..5.0), rng.random_range(1.5..4.0));
    let side = [0.03, 0.05, 0.1][rng.random_range(0..3)];
    let mut sketch = Sketch::open(width, height, side);
    for _ in 0..rng.random_range(0..4) {
        let (x, y) = (rng.random_range(0.0..width), rng.random_range(0.0..height));
        let (w, h) = (rng.random_range(0.05..0.9), rng.random_range(0.05..0.9));
        sketch = sketch.fill(&[[x, y, (x + w).min(width), (y + h).min(height)]]);
    }
    let mut plan = sketch.finish("", "");
    for _ in 0..rng.random_range(0..8) {
        let at = Vector::new(rng.random_range(0.0..width), rng.random_range(0.0..height));
        plan.objects.push(match rng.random_range(0..3) {
            0 => Object::Leg { at: at.into(), radius: rng.random_range(0.005..0.3) },
            1 => {
                let corners = rng.random_range(3..6);
                // Equally far corners make it convex.
                let size = rng.random_range(0.02..0.5);
                let outline = star(rng, corners, [size, size + 1e-6]).into_iter().map(|p| p + at).collect();
                Object::Furniture { outline }
            }
            // Thinner than any cell.
            _ => {
                let (along, across) = (rng.random_range(0.1..0.8), rng.random_range(0.002..0.02));
                let corners = [(-along, -across), (along, -across), (along, across), (-along, across)];
                let angle = rng.random_range(0.0..std::f64::consts::TAU);
                let turned = |(x, y): (f64, f64)| {
                    Point::new(x * angle.cos() - y * angle.sin(), x * angle.sin() + y * angle.cos()) + at
                };
                Object::Furniture { outline: corners.map(turned).to_vec() }
            }
        });
    }
    plan
}

/// A circle, an octagon, a rectangle or a star.
pub fn random_outline(rng: &mut Rng) -> Outline {
    let found = match rng.random_range(0..4) {
        0 => Outline::circle(rng.random_range(0.03..0.3)),
        1 => Outline::octagon(rng.random_range(0.06..0.6)),
        2 => Outline::rectangle(rng.random_range(0.06..0.6), rng.random_range(0.06..0.6)),
        _ => {
            let corners = rng.random_range(3..9);
            Outline::checked(star(rng, corners, [0.05, 0.35]))
        }
    };
    // A star with too wide an angle doesn't hold the origin.
    found.unwrap_or(Outline::Circle { radius: 0.15 })
}

/// A sweep of a room, anyhow.
pub fn random_setup(rng: &mut Rng, plan: &FloorPlan) -> SweepSetup {
    let outline = random_outline(rng);
    let scan_width = rng.random_bool(0.5).then(|| rng.random_range(0.03..0.5));
    let widest = scan_width.unwrap_or(0.5 * outline.width());
    let cell = widest.min(0.2) * rng.random_range(0.3..1.0);
    let mut place = |length: f64| rng.random_range(0.0..length);
    let at = Pose::new(place(plan.width_m()), place(plan.height_m()), place(6.0));
    let mut chance = |share: f64| rng.random_bool(share);
    SweepSetup {
        scan_width,
        start: chance(0.5).then_some(at),
        order: LinkOrder::ALL[usize::from(chance(0.5)) + usize::from(chance(0.4))],
        turns: chance(0.4),
        ..SweepSetup::new(outline, cell.max(0.02))
    }
}
