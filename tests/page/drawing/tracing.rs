//! Rooms from drawings.

use super::support::{drawn, entities};
use floor_drawing::{Drawing, DrawingError, DrawingRegion, Role, Traced, Tracing, trace};
use robovac_core::{
    floor_plan::{Object, to_ascii},
    geometry::{Point, Vector},
};

/// 4 m x 3 m in millimetres with a door of 80 cm, a table and a round leg.
const FLAT: &str = "0 LWPOLYLINE 8 WALL 70 0 10 1800 20 1000 10 1000 20 1000 10 1000 20 4000 10 5000 20 4000 10 5000 20 1000 \
    10 2600 20 1000 0 LWPOLYLINE 8 FURN 70 1 10 2000 20 2000 10 3000 20 2000 10 3000 20 3000 10 2000 20 3000 \
    0 CIRCLE 8 FURN 10 4000 20 2000 40 100";

fn traced(drawing: &Drawing, gap: f64, region: DrawingRegion) -> Result<Traced, DrawingError> {
    let roles = drawing.layers.iter().map(|layer| layer.role).collect();
    trace(drawing, &Tracing { roles, metre: 0.001, gap, resolution: 0.25, region })
}

#[test]
fn a_room_with_furniture_is_traced_exactly() {
    let flat = drawn(&entities(FLAT)).unwrap();
    let room = traced(&flat, 0.9, DrawingRegion::Room(Point::new(1500.0, 3500.0))).unwrap();
    assert_eq!(room.gaps.len(), 1);
    let plan = &room.plan;
    assert!(plan.check_objects(None).is_ok());
    let to_drawing = |p: &Point| Vector::new(p.x, p.y) / room.metre + room.corner;
    let [Object::Furniture { outline }, Object::Leg { at, radius }] = &plan.objects[..] else {
        panic!("{:?}", plan.objects)
    };
    assert!((to_drawing(&outline[0]) - Vector::new(2000.0, 2000.0)).norm() < 1e-6);
    assert!((to_drawing(at) - Vector::new(4000.0, 2000.0)).norm() < 1e-6 && (radius - 0.1).abs() < 1e-9);
    assert!((plan.origin.x - room.corner.x * 0.001).abs() < 1e-12);
    // Furniture stands on floor: 3.75 m x 2.75 m are free.
    assert_eq!(plan.occupancy.values().iter().filter(|cell| cell.is_free()).count(), 15 * 11, "{}", to_ascii(plan));
}

#[test]
fn furniture_whose_sides_are_single_lines_is_no_floor() {
    let flat = drawn(&entities(FLAT)).unwrap();
    let (start, rest) = FLAT.split_once("0 LWPOLYLINE 8 FURN").unwrap();
    let leg = rest.split_once("0 CIRCLE").unwrap().1;
    let sides = "0 LINE 8 FURN 10 2000 20 2000 11 3000 21 2000 0 LINE 8 FURN 10 3000 20 3000 11 3000 21 2000 \
        0 LINE 8 FURN 10 2000 20 3000 11 3000 21 3000 0 LINE 8 FURN 10 2000 20 2000 11 2000 21 3000";
    let lines = drawn(&entities(&format!("{start} {sides} 0 CIRCLE {leg}"))).unwrap();
    for region in
        [DrawingRegion::Indoors { outer: 1.25 }, DrawingRegion::WHOLE, DrawingRegion::Room(Point::new(1500.0, 3500.0))]
    {
        let [one, other] = [&flat, &lines].map(|drawing| traced(drawing, 0.9, region.clone()).unwrap().plan);
        assert_eq!(one.occupancy, other.occupancy, "{}", to_ascii(&other));
        let tables = other.objects.iter().filter(|object| matches!(object, Object::Furniture { .. }));
        assert_eq!((tables.count(), other.objects.len()), (1, one.objects.len()));
    }
    let message = traced(&lines, 0.9, DrawingRegion::Room(Point::new(2500.0, 2500.0))).unwrap_err().to_string();
    assert!(message.contains("there is an obstacle"), "{message}");
}

/// Walls on the lines between cells belong to the same cells, in whichever unit they were drawn.
fn the_unit_changes_nothing(seeds: std::ops::Range<u32>) {
    for seed in seeds {
        // A house of 6 to 10 m whose walls are lines at whole steps of 5 cm, and its lower-left corner, too.
        let step = |number: u32| f64::from(number) * 0.05;
        let [x, y] = [step(7 * seed % 53), step(11 * seed % 47)];
        let [width, height] = [step(120 + seed * 13 % 80), step(120 + seed * 17 % 80)];
        let [across, along] = [step(40 + seed * 5 % 30), step(40 + seed * 3 % 30)];
        let house = |unit: f64| {
            let lines = [
                [x, y, x + width, y],
                [x + width, y, x + width, y + height],
                [x + width, y + height, x, y + height],
                [x, y + height, x, y],
                [x + across, y, x + across, y + height - 0.9],
                [x, y + along, x + across - 0.8, y + along],
            ];
            let line = |[a, b, c, d]: [f64; 4]| {
                let [a, b, c, d] = [a, b, c, d].map(|length| length / unit);
                format!("0 LINE 8 WALL 10 {a:.6} 20 {b:.6} 11 {c:.6} 21 {d:.6} ")
            };
            let drawing = drawn(&entities(&lines.map(line).concat())).unwrap();
            let how = Tracing {
                roles: drawing.layers.iter().map(|layer| layer.role).collect(),
                metre: unit,
                gap: 0.0,
                resolution: 0.05,
                region: DrawingRegion::Indoors { outer: 1.25 },
            };
            to_ascii(&trace(&drawing, &how).unwrap().plan)
        };
        let metres = house(1.0);
        for unit in [0.001, 0.01, 0.0254] {
            assert!(metres == house(unit), "seed {seed}, unit {unit} m: {metres}\n{}", house(unit));
        }
    }
}

// slow: houses in four units
#[test]
fn the_unit_of_a_drawing_changes_nothing() {
    the_unit_changes_nothing(0..12);
}

#[test]
#[ignore = "soak: more houses"]
fn the_unit_of_more_drawings_changes_nothing() {
    the_unit_changes_nothing(12..40);
}

#[test]
fn an_open_room_leaks_where_its_door_is() {
    let flat = drawn(&entities(FLAT)).unwrap();
    let message = traced(&flat, 0.0, DrawingRegion::Room(Point::new(1500.0, 3500.0))).unwrap_err().to_string();
    assert!(message.contains("the room isn't closed: ") && message.contains(" m wide near (2"), "{message}");
    let message = traced(&flat, 0.9, DrawingRegion::Room(Point::new(2500.0, 2500.0))).unwrap_err().to_string();
    assert!(message.contains("there is an obstacle at (2500.00, 2500.00)"), "{message}");
    let message = traced(&flat, 0.9, DrawingRegion::Room(Point::new(1010.0, 2500.0))).unwrap_err().to_string();
    assert!(message.contains("there is a wall"), "{message}");
}

#[test]
fn the_whole_is_what_walls_enclose_or_the_box() {
    let flat = drawn(&entities(FLAT)).unwrap();
    let free = |traced: &Traced| traced.plan.occupancy.values().iter().filter(|cell| cell.is_free()).count();
    let closed = traced(&flat, 0.9, DrawingRegion::WHOLE).unwrap();
    assert_eq!((free(&closed), closed.plan.objects.len()), (15 * 11, 2));
    let open = traced(&flat, 0.0, DrawingRegion::WHOLE).unwrap();
    // 4 m x 3 m and a metre around.
    assert_eq!((open.plan.width_m(), open.plan.height_m()), (6.0, 5.0));
    assert!(free(&open) > 15 * 11 + 100, "{}", to_ascii(&open.plan));
}

#[test]
fn rectangles_and_polygons_cut_walls_off() {
    let flat = drawn(&entities(FLAT)).unwrap();
    let rectangle = DrawingRegion::Rectangle { low: Point::new(5000.0, 2250.0), high: Point::new(3500.0, 1250.0) };
    let room = traced(&flat, 0.0, rectangle).unwrap();
    assert_eq!((room.corner, room.plan.width_m(), room.plan.height_m()), (Vector::new(3500.0, 1250.0), 1.5, 1.0));
    assert_eq!(room.plan.objects.len(), 1);
    let corners = [(1000.0, 1000.0), (5000.0, 1000.0), (5000.0, 4000.0)].map(|(x, y)| Point::new(x, y));
    let half = traced(&flat, 0.0, DrawingRegion::Polygon(corners.to_vec())).unwrap();
    let free = half.plan.occupancy.values().iter().filter(|cell| cell.is_free()).count();
    assert!((80..=96).contains(&free), "{}", to_ascii(&half.plan));
    let crossed = [(0.0, 0.0), (9.0, 9.0), (9.0, 0.0), (0.0, 9.0)].map(|(x, y)| Point::new(x, y));
    assert!(traced(&flat, 0.0, DrawingRegion::Polygon(crossed.to_vec())).is_err());
}

#[test]
fn what_cannot_be_is_said() {
    let flat = drawn(&entities(FLAT)).unwrap();
    let message = |how: Tracing| trace(&flat, &how).unwrap_err().to_string();
    let how = Tracing {
        roles: vec![Role::Wall, Role::Obstacle],
        metre: 0.001,
        gap: 0.0,
        resolution: 0.05,
        region: DrawingRegion::WHOLE,
    };
    let huge = message(Tracing { metre: 1.0, ..how.clone() });
    assert!(huge.contains("use cells of 1 m"), "{huge}");
    assert!(message(Tracing { metre: f64::NAN, ..how.clone() }).contains("a drawing unit can't be NaN m long"));
    assert!(message(Tracing { resolution: 0.0, ..how.clone() }).contains("the cell size can't be 0 m"));
    assert!(message(Tracing { roles: vec![], ..how.clone() }).contains("2 layers, but 0 roles"));
    assert!(message(Tracing { roles: vec![Role::Ignored; 2], ..how.clone() }).contains("no layer is a wall"));
    let point = DrawingRegion::Rectangle { low: Point::origin(), high: Point::origin() };
    assert!(message(Tracing { region: point, ..how }).contains("less than three cells"));
}

/// Two rooms of 4 m x 3 m within walls drawn as outlines of 20 cm, with doors of 80 cm between them and to the outside.
const OUTLINED: &str = "0 LWPOLYLINE 8 WALL 70 1 10 0 20 0 10 1000 20 0 10 1000 20 200 10 200 20 200 10 200 20 3200 \
    10 4200 20 3200 10 4200 20 1800 10 4400 20 1800 10 4400 20 3200 10 8400 20 3200 10 8400 20 200 10 4400 20 200 \
    10 4400 20 1000 10 4200 20 1000 10 4200 20 200 10 1800 20 200 10 1800 20 0 10 8600 20 0 10 8600 20 3400 10 0 20 3400";

#[test]
fn doors_in_walls_drawn_as_outlines_are_closed() {
    let house = drawn(&entities(OUTLINED)).unwrap();
    let fine = |gap: f64, region: DrawingRegion| {
        trace(&house, &Tracing { roles: vec![Role::Wall], metre: 0.001, gap, resolution: 0.05, region })
    };
    let floor = |traced: &Traced| {
        traced.plan.occupancy.values().iter().filter(|cell| cell.is_free()).count() as f64 * 0.05 * 0.05
    };
    let click = || DrawingRegion::Room(Point::new(2000.0, 2000.0));
    assert!(fine(0.3, click()).unwrap_err().to_string().contains("the room isn't closed"));
    let room = fine(0.9, click()).unwrap();
    assert!((11.0..12.8).contains(&floor(&room)), "{}\n{}", floor(&room), to_ascii(&room.plan));
    assert_eq!(room.gaps.len(), 2, "a door to the other room and one to the outside");
    for [a, b] in &room.gaps {
        assert!((0.5..=1.2).contains(&(b - a).norm()), "{a} {b}");
    }
    let both = fine(0.9, DrawingRegion::WHOLE).unwrap();
    assert!((22.5..25.5).contains(&floor(&both)), "{}\n{}", floor(&both), to_ascii(&both.plan));
}

/// Two rooms of 3 m x 3 m side by side, the wall between them two blocks of 20 cm that leave a door of 80 cm.
const TWO_ROOMS: &str = "0 LWPOLYLINE 8 WALL 70 1 10 0 20 0 10 6200 20 0 10 6200 20 3000 10 0 20 3000 \
    0 LWPOLYLINE 8 WALL 70 1 10 3000 20 0 10 3200 20 0 10 3200 20 1200 10 3000 20 1200 \
    0 LWPOLYLINE 8 WALL 70 1 10 3000 20 2000 10 3200 20 2000 10 3200 20 3000 10 3000 20 3000";

#[test]
fn a_room_ends_at_its_open_doors_if_gaps_are_closed() {
    let flat = drawn(&entities(TWO_ROOMS)).unwrap();
    let roles = vec![Role::Wall];
    let room = |gap: f64| {
        let region = DrawingRegion::Room(Point::new(1000.0, 1500.0));
        let how = Tracing { roles: roles.clone(), metre: 0.001, gap, resolution: 0.05, region };
        trace(&flat, &how).unwrap()
    };
    let (both, one) = (room(0.0), room(1.0));
    assert!(both.plan.width_m() > 6.0 && both.gaps.is_empty());
    assert!((3.0..3.5).contains(&one.plan.width_m()), "{}", to_ascii(&one.plan));
    assert_eq!(one.gaps.len(), 1);
}

/// A flat of 7.4 m x 5.4 m whose walls are one outline of 30 cm, with a front door of 90 cm.
const OPEN_FLAT: &str = "0 LWPOLYLINE 8 WALL 70 1 10 3000 20 0 10 0 20 0 10 0 20 6000 10 8000 20 6000 10 8000 20 0 10 3900 20 0 \
    10 3900 20 300 10 7700 20 300 10 7700 20 5700 10 300 20 5700 10 300 20 300 10 3000 20 300";

#[test]
fn a_hollow_column_does_not_make_the_rest_of_the_flat_outside() {
    let column = "0 LWPOLYLINE 8 WALL 70 1 10 5000 20 3000 10 5650 20 3000 10 5650 20 3650 10 5000 20 3650";
    for text in [OPEN_FLAT.to_owned(), format!("{OPEN_FLAT} {column}")] {
        let flat = drawn(&entities(&text)).unwrap();
        let how =
            Tracing { roles: vec![Role::Wall], metre: 0.001, gap: 1.0, resolution: 0.05, region: DrawingRegion::WHOLE };
        let room = trace(&flat, &how).unwrap();
        let floor = room.plan.occupancy.values().iter().filter(|cell| cell.is_free()).count() as f64 * 0.05 * 0.05;
        assert!((36.0..41.0).contains(&floor), "{floor}\n{}", to_ascii(&room.plan));
        assert_eq!(room.gaps.len(), 1);
    }
}

#[test]
fn the_inside_of_an_outlined_wall_is_not_floor_at_coarse_cells() {
    let flat = drawn(&entities(OPEN_FLAT)).unwrap();
    for resolution in [0.1, 0.2] {
        let how = Tracing { roles: vec![Role::Wall], metre: 0.001, gap: 0.0, resolution, region: DrawingRegion::WHOLE };
        // The door stands open: all is outside, with a metre around.
        let room = trace(&flat, &how).unwrap();
        assert!((room.plan.width_m() - 10.0).abs() < 0.5, "{}", to_ascii(&room.plan));
    }
}
