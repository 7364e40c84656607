//! The configuration space against brute force: the outline is tested in every cell against every obstacle.

use proptest::prelude::*;
use robovac_core::{
    cspace::{ConfigurationSpace, CspaceError, Outline},
    floor_plan::{FloorPlan, Object, Sketch},
    geometry::{Point, Shape, Vector, edges, outward, overlap, overlap_disc, signed_area},
    grid::{Cell, Grid, Occupancy, picture},
    math,
};

/// Overlap that counts, m.
const HAIR: f64 = 1e-9;

/// A body turned and put somewhere.
enum Body {
    Disc(Point, f64),
    Convex(Vec<Point>),
}

fn placed(outline: &Outline, at: Point, heading: f64) -> Body {
    match outline {
        Outline::Circle { radius } => Body::Disc(at, *radius),
        Outline::Polygon(corners) => {
            let (sin, cos) = math::sin_cos(heading);
            let turned = corners.iter().map(|p| at + Vector::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y));
            Body::Convex(turned.collect())
        }
    }
}

/// How deep a body is in an obstacle, m; below 0 if they are apart.
fn depth(body: &Body, obstacle: &Shape) -> f64 {
    let normals = |corners: &[Point]| -> Vec<Vector> { edges(corners).map(|(a, b)| outward(a, b)).collect() };
    match (body, obstacle) {
        (Body::Disc(at, own), Shape::Disc { centre, radius }) => own + radius - (at - centre).norm(),
        (Body::Disc(at, own), Shape::Convex(_)) => own - (obstacle.nearest(*at) - at).norm(),
        (Body::Convex(corners), Shape::Disc { centre, radius }) => {
            overlap_disc(corners, *centre, *radius).map_or(-1.0, |(depth, _)| depth)
        }
        (Body::Convex(corners), Shape::Convex(other)) => {
            overlap(corners, &normals(corners), other).map_or(-1.0, |(depth, _)| depth)
        }
    }
}

fn square(x: f64, y: f64, side: f64) -> Shape {
    let corners = [[x, y], [x + side, y], [x + side, y + side], [x, y + side]];
    Shape::Convex(corners.map(|[x, y]| Point::new(x, y)).to_vec())
}

/// Which cells are FREE, by trying; `None` where a rounding error decides.
fn by_trying(plan: &FloorPlan, outline: &Outline, cell: f64, heading: f64, size: (usize, usize)) -> Grid<Option<bool>> {
    let mut obstacles: Vec<Shape> = plan
        .blocked()
        .iter()
        .filter(|&(_, &blocked)| blocked)
        .map(|(at, _)| square(f64::from(at.x) * plan.resolution, f64::from(at.y) * plan.resolution, plan.resolution))
        .collect();
    for object in &plan.objects {
        match object {
            Object::Leg { at, radius } => obstacles.push(Shape::Disc { centre: *at, radius: *radius }),
            Object::Furniture { outline } | Object::DropOff { outline } => {
                obstacles.push(Shape::Convex(outline.clone()));
            }
            _ => panic!("not in these rooms"),
        }
    }
    // The outside: four squares that are large enough.
    let (w, h) = (plan.width_m(), plan.height_m());
    obstacles.extend(
        [(-50.0 - w, -50.0), (w, -50.0)].map(|(x, y)| square(x + if x < 0.0 { w - 50.0 } else { 0.0 }, y, 100.0)),
    );
    obstacles.extend([square(-50.0, -100.0, 100.0), square(-50.0, h, 100.0)]);
    let mut free = Grid::filled(size.0, size.1, None);
    for index in 0..free.len() {
        let at = free.cell(index);
        let body = placed(outline, at.centre(cell), heading);
        let deepest = obstacles.iter().map(|obstacle| depth(&body, obstacle)).fold(-1.0, f64::max);
        free[at] = ((deepest - HAIR).abs() > 1e-12).then_some(deepest <= HAIR);
    }
    free
}

/// The convex hull of some points, counter-clockwise (Andrew 1979).
fn hull(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_by(|a, b| (a.x, a.y).partial_cmp(&(b.x, b.y)).unwrap());
    let chain = |points: &mut dyn Iterator<Item = Point>| {
        let mut chain: Vec<Point> = Vec::new();
        for p in points {
            while let [.., a, b] = chain[..] {
                if (b - a).perp(&(p - b)) > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut all = chain(&mut points.iter().copied());
    all.extend(chain(&mut points.iter().rev().copied()));
    all
}

fn cloud(size: f64, count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<Point>> {
    prop::collection::vec((-size..size, -size..size), count)
        .prop_map(|points| hull(points.into_iter().map(|(x, y)| Point::new(x, y)).collect()))
        .prop_filter("it has area", |hull| hull.len() > 2 && signed_area(hull) > 1e-3)
}

fn outline() -> impl Strategy<Value = Outline> {
    prop_oneof![
        (0.05..0.4_f64).prop_map(|radius| Outline::Circle { radius }),
        Just(Outline::octagon(0.36).unwrap()),
        Just(Outline::rectangle(0.4, 0.2).unwrap()),
        cloud(0.4, 3..9).prop_filter_map("it holds the origin", |corners| Outline::checked(corners).ok()),
    ]
}

fn object() -> impl Strategy<Value = Object> {
    let at = (0.0..2.4_f64, 0.0..1.8_f64);
    prop_oneof![
        (at.clone(), 0.005..0.3_f64).prop_map(|((x, y), radius)| Object::Leg { at: Point::new(x, y), radius }),
        (at, cloud(0.5, 3..7), any::<bool>()).prop_map(|((x, y), corners, is_stairs)| {
            let outline = corners.into_iter().map(|p| p + Vector::new(x, y)).collect();
            if is_stairs { Object::DropOff { outline } } else { Object::Furniture { outline } }
        }),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn cells_are_full_where_the_outline_overlaps_something(
        outline in outline(),
        walls in prop::collection::vec(0..24_usize * 18, 0..6),
        objects in prop::collection::vec(object(), 0..4),
        cell in prop_oneof![Just(0.1), Just(0.05), Just(0.18), 0.06..0.3_f64],
        headings in 1..9_usize,
        heading in any::<prop::sample::Index>(),
    ) {
        let mut plan = Sketch::open(2.4, 1.8, 0.1).finish("", "");
        for at in walls {
            let at = plan.occupancy.cell(at);
            plan.occupancy[at] = if at.x % 2 == 0 { Occupancy::Occupied } else { Occupancy::Unknown };
        }
        plan.objects = objects;
        let space = ConfigurationSpace::new(&plan, &outline, cell, headings).unwrap();
        let k = heading.index(headings);
        let angle = k as f64 * math::TAU / headings as f64;
        let expected = by_trying(&plan, &outline, cell, angle, (space.width, space.height));
        let slice = space.slice(k);
        for (at, &is_free) in slice.iter() {
            prop_assert_eq!(is_free, space.is_free(at, k));
            if let Some(expected) = expected[at] {
                prop_assert_eq!(is_free, expected, "{} at {} rad", at, angle);
            }
        }
    }
}

#[test]
fn an_l_is_not_its_hull() {
    // An L whose notch just takes the post.
    let corners = [(-0.3, -0.3), (0.3, -0.3), (0.3, 0.0), (0.05, 0.0), (0.05, 0.3), (-0.3, 0.3)];
    let outline = Outline::checked(corners.map(|(x, y)| Point::new(x, y)).to_vec()).unwrap();
    let mut plan = Sketch::open(2.0, 2.0, 0.1).finish("", "");
    plan.objects.push(Object::Leg { at: Point::new(1.2, 1.2), radius: 0.1 });
    let space = ConfigurationSpace::new(&plan, &outline, 0.1, 4).unwrap();
    // Origin at (1.05, 1.05): the notch goes from there by 0.05 and 0.0 on; the post from 1.1 on.
    assert!(space.is_free(Cell::new(10, 10), 0));
    // Turned by a quarter the notch is at the upper left.
    assert!(!space.is_free(Cell::new(10, 10), 1) && !space.is_free(Cell::new(10, 10), 2));
}

#[test]
fn a_body_as_wide_as_the_corridor_fits_and_touching_is_no_overlap() {
    let plan = Sketch::open(1.0, 0.36, 0.04).finish("", "");
    let space = ConfigurationSpace::new(&plan, &Outline::octagon(0.36).unwrap(), 0.04, 8).unwrap();
    let drawn = picture(&space.slice(0), |&f| if f { '.' } else { '#' });
    assert_eq!(drawn.lines().nth(4), Some("####.................####"), "\n{drawn}");
    assert_eq!(drawn.matches('.').count(), 17);
    // Turned by an eighth it looks the same; by a sixteenth its corners stick out.
    assert_eq!(space.slice(1).count(), 17);
    let odd = ConfigurationSpace::new(&plan, &Outline::octagon(0.36).unwrap(), 0.04, 16).unwrap();
    assert_eq!(odd.slice(1).count(), 0);
}

#[test]
fn what_is_too_large_or_no_size_at_all_is_refused_before_memory_is_taken() {
    let plan = Sketch::open(1000.0, 1000.0, 1.0).finish("", "");
    let outline = Outline::octagon(0.36).unwrap();
    let error = |cell, headings| ConfigurationSpace::new(&plan, &outline, cell, headings).unwrap_err();
    assert!(matches!(error(0.001, 1), CspaceError::TooLarge { width: 1_000_000, .. }));
    assert!(matches!(error(0.2, usize::MAX), CspaceError::TooLarge { .. }));
    assert!(matches!(error(1e-300, 1), CspaceError::TooLarge { .. }));
    for cell in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(error(cell, 1), CspaceError::Cell(_)));
    }
    let round = Outline::Circle { radius: f64::NAN };
    assert!(matches!(ConfigurationSpace::new(&plan, &round, 0.1, 1), Err(CspaceError::Outline(_))));
}
