//! Photographs, scans and drawings at an angle as floor plans: what is proposed, and what comes of it.

use floor_drawing::ShadeMethod;
use image::{GrayImage, ImageFormat, Luma};
use robovac_app::{
    explore::Session,
    floor_plan::{DrawingPart, DrawingSession, FloorPlanSettings, size_in_words},
};
use robovac_core::{
    floor_plan::{FloorPlan, SourceFile, generate::random_flat},
    geometry::Point,
    grid::Cell,
    rng::{normal, seeded},
};
use std::{io::Cursor, ops::ControlFlow};

/// Metres per pixel.
const PIXEL: f64 = 0.025;
/// White paper around the flat, pixels.
const MARGIN: f64 = 40.0;

/// A scan of a flat with an open front door, turned by `degrees` on its sheet.
fn scan(flat: &FloorPlan, degrees: f64) -> GrayImage {
    scan_with(flat, degrees, true)
}

fn scan_with(flat: &FloorPlan, degrees: f64, has_door: bool) -> GrayImage {
    let walls = flat.blocked();
    let [width, height] = [flat.width_m(), flat.height_m()].map(|metres| metres / PIXEL);
    let (sin, cos) = (-degrees).to_radians().sin_cos();
    let wide = (width * cos.abs() + height * sin.abs() + 2.0 * MARGIN) as u32;
    let high = (width * sin.abs() + height * cos.abs() + 2.0 * MARGIN) as u32;
    GrayImage::from_fn(wide, high, |x, y| {
        let (x, y) = (f64::from(x) + 0.5 - 0.5 * f64::from(wide), 0.5 * f64::from(high) - f64::from(y) - 0.5);
        let (x, y) = ((x * cos - y * sin + 0.5 * width) * PIXEL, (x * sin + y * cos + 0.5 * height) * PIXEL);
        let cell = Cell::new((x / flat.resolution).floor() as i32, (y / flat.resolution).floor() as i32);
        // The front door, through the left wall.
        let is_door = has_door && x < 0.2 && (0.5..1.4).contains(&y);
        Luma([if walls.is_set(cell) && !is_door { 45 } else { 228 }])
    })
}

fn file(image: &GrayImage, name: &str, format: ImageFormat) -> SourceFile {
    let mut bytes = Cursor::new(Vec::new());
    image.write_to(&mut bytes, format).unwrap();
    SourceFile { name: name.to_owned(), bytes: bytes.into_inner() }
}

fn opened(image: &GrayImage) -> DrawingSession {
    let mut session = DrawingSession::open(&[file(image, "scan.png", ImageFormat::Png)]).unwrap();
    change(&mut session, |settings| settings.metre = Some(PIXEL));
    session
}

fn change(session: &mut DrawingSession, what: impl FnOnce(&mut FloorPlanSettings)) {
    let mut settings = session.settings().clone();
    what(&mut settings);
    session.set(settings).unwrap();
}

/// Free floor of the flat, m².
fn floor(flat: &FloorPlan) -> f64 {
    flat.occupancy.values().iter().filter(|cell| cell.is_free()).count() as f64 * flat.resolution * flat.resolution
}

#[test]
fn a_scanned_flat_is_taken_indoors_whatever_lies_around_it() {
    for seed in 0..3 {
        let flat = random_flat(2, 2, seed);
        let mut session = opened(&scan(&flat, 0.0));
        let settings = session.settings();
        assert_eq!((settings.method, &settings.part), (ShadeMethod::Level, &DrawingPart::Indoors), "{seed}");
        let (found, true_floor) = (session.floor_m2(), floor(&flat));
        assert!((found / true_floor - 1.0).abs() < 0.05, "seed {seed}: {found} for {true_floor} m²");
        // The whole has the paper around the house, but the robot starts in it.
        change(&mut session, |settings| settings.part = DrawingPart::Whole);
        assert!(session.floor_m2() > true_floor + 5.0);
        let plan = &session.room().unwrap().plan;
        let start = plan.start.unwrap().position() - Point::new(MARGIN * PIXEL, MARGIN * PIXEL);
        assert!(start.min() > 0.1 && start.x < flat.width_m() && start.y < flat.height_m(), "{seed}: {start}");
        assert!(plan.occupancy.get(plan.cell_at(plan.start.unwrap().position())).unwrap().is_free());
    }
}

/// A dim photograph of the flat on its sheet, which may lie on a dark table; darker to the corners, with noise.
fn dim_photograph(flat: &FloorPlan, metre: f64, has_table: bool, seed: u64) -> (GrayImage, f64) {
    let [width, height] = [flat.width_m(), flat.height_m()].map(|metres| metres / metre);
    let (paper, table) = (0.18 * width, if has_table { 0.25 * width } else { 0.0 });
    let around = paper + table;
    let (wide, high) = ((width + 2.0 * around) as u32, (height + 2.0 * around) as u32);
    let mut rng = seeded(seed, 1);
    let image = GrayImage::from_fn(wide, high, |x, y| {
        let at = [f64::from(x) + 0.5, f64::from(high - y) - 0.5];
        let size = [width, height];
        let is_within = |margin: f64| (0..2).all(|i| (-margin..size[i] + margin).contains(&(at[i] - around)));
        let [column, row] = at.map(|at| ((at - around) * metre / flat.resolution).floor() as i32);
        let is_wall = is_within(0.0) && flat.occupancy.get(Cell::new(column, row)).is_some_and(|cell| !cell.is_free());
        let shade = if is_wall {
            45.0
        } else if is_within(paper) {
            215.0
        } else {
            70.0
        };
        let away = (at[0] / f64::from(wide) - 0.5).powi(2) + (at[1] / f64::from(high) - 0.5).powi(2);
        Luma([(0.5 * shade * (1.0 - 1.7 * away) + 6.0 * normal(&mut rng)).clamp(0.0, 255.0) as u8])
    });
    (image, around)
}

#[test]
fn dark_corners_and_the_table_of_a_dim_photograph_are_no_floor_before_and_after_its_size_is_set() {
    for (seed, metre, has_table) in [(0, 0.025, false), (1, 0.025, true), (0, 0.01, true)] {
        let flat = random_flat(2, 2, seed);
        let (image, around) = dim_photograph(&flat, metre, has_table, seed);
        let mut session = DrawingSession::open(&[file(&image, "photo.png", ImageFormat::Png)]).unwrap();
        for is_set in [false, true] {
            if is_set {
                change(&mut session, |settings| settings.metre = Some(metre));
            }
            let case = format!("seed {seed}, {metre} m a pixel, table: {has_table}, size set: {is_set}");
            let assumed = session.settings().metre.unwrap();
            assert!(f64::from(image.width().max(image.height())) * assumed <= 20.001 || is_set, "{case}: {assumed}");
            let found = session.floor_m2() * (metre / assumed).powi(2);
            assert!((found / floor(&flat) - 1.0).abs() < 0.06, "{case}: {found} for {} m²", floor(&flat));
            let corner = session.room().unwrap().corner.map(|side| side - around);
            assert!(corner.amax() < 0.4 / metre, "{case}: {corner}");
            // The question is about the plan.
            let asks = session.view().asks;
            let plan = &session.room().unwrap().plan;
            let width = plan.width_m() / assumed * metre;
            assert!((width - flat.width_m()).abs() < 0.5 && asks.is_empty() == is_set, "{case}: {width} m, {asks:?}");
        }
    }
}

#[test]
fn askew_scans_are_straightened_as_proposed() {
    for (seed, degrees) in [(1, 7.0), (2, -12.0)] {
        let flat = random_flat(2, 2, seed);
        let mut session = opened(&scan(&flat, degrees));
        let askew = session.askew().unwrap();
        assert!((askew - degrees).abs() < 0.2, "{askew} for {degrees}");
        let before = session.room().unwrap().plan.clone();
        session.turn_to(-askew).unwrap();
        assert_eq!(session.askew(), None, "nothing more is proposed");
        let after = &session.room().unwrap().plan;
        assert!(after.width_m() < before.width_m() - 0.3, "its box is the flat's: {}", after.width_m());
        let found = session.floor_m2();
        assert!((found / floor(&flat) - 1.0).abs() < 0.06, "seed {seed}: {found} for {} m²", floor(&flat));
        // All the way round is where it was.
        session.turn_to(360.0).unwrap();
        assert_eq!(session.room().unwrap().plan, before);
    }
}

#[test]
fn a_cut_with_no_more_than_the_arc_of_a_door_is_not_straightened() {
    for (door, line, way) in [(24, 1.5, 0), (36, 2.0, 1), (44, 3.0, 2), (40, 2.0, 3)] {
        let mut session = opened(&with_door_arc(door, line, way));
        // One of the rooms without its walls, by the side of the arc; rows count from below.
        let (left, right) = if way.is_multiple_of(2) { (40.0, 154.0) } else { (166.0, 280.0) };
        let part = DrawingPart::Rectangle { corners: [[left, 40.0], [right, 200.0]] };
        change(&mut session, |settings| settings.part = part);
        assert_eq!(session.askew(), None, "{door} pixels, {way}");
    }
    // The walls in a cut of an askew scan tell their angle.
    let mut session = opened(&scan(&random_flat(2, 2, 1), 7.0));
    let [width, height] = session.view().room.map(|room| [room.width_m / PIXEL, room.height_m / PIXEL]).unwrap();
    let part = DrawingPart::Rectangle { corners: [[10.0, 10.0], [10.0 + 0.7 * width, 10.0 + 0.7 * height]] };
    change(&mut session, |settings| settings.part = part);
    assert!((session.askew().unwrap() - 7.0).abs() < 0.3, "{:?}", session.askew());
}

/// An upright page frame with a title block, `gap` pixels from the walls of a scan.
fn framed(mut image: GrayImage, gap: u32) -> GrayImage {
    let is_wall = |&(_, _, pixel): &(u32, u32, &Luma<u8>)| pixel.0[0] < 128;
    let walls = || image.enumerate_pixels().filter(is_wall);
    let away = MARGIN as u32 - gap;
    let (right, bottom) = (image.width() - 1 - away, image.height() - 1 - away);
    assert!(walls().all(|(x, y, _)| x > away && y > away && x < right && y < bottom));
    for (x, y, pixel) in image.enumerate_pixels_mut() {
        let is_within = (away..=right).contains(&x) && (away..=bottom).contains(&y);
        let is_edge = [x - x.min(away), y - y.min(away), right - x.min(right), bottom - y.min(bottom)].contains(&0)
            || x == away + 1
            || y == away + 1;
        if is_within && is_edge {
            *pixel = Luma([45]);
        }
    }
    image
}

#[test]
fn an_askew_flat_in_an_upright_page_frame_is_straightened_and_stays_what_is_indoors() {
    for (seed, degrees) in [(1, 7.0), (4, 30.0)] {
        let flat = random_flat(2, 2, seed);
        let true_floor = floor(&flat);
        let mut session = opened(&framed(scan_with(&flat, degrees, false), 24));
        let askew = session.askew().unwrap_or(0.0);
        assert!((askew - degrees).abs() < 0.25, "seed {seed}: {askew}° for {degrees}°");
        session.turn_to(degrees).unwrap();
        let twice = session.askew().unwrap();
        let expected = (2.0 * degrees + 45.0).rem_euclid(90.0) - 45.0;
        assert!((twice - expected).abs() < 0.25, "seed {seed}: {twice}° for {expected}°");
        session.turn_to(-askew).unwrap();
        assert_eq!(session.askew(), None, "seed {seed}: straight");
        // slow: the turns and scales that a person may try.
        for turn in [0.0, 20.0] {
            session.turn_to(turn).unwrap();
            for metre in [PIXEL, 5.0 * PIXEL] {
                change(&mut session, |settings| settings.metre = Some(metre));
                let found = session.floor_m2() * (PIXEL / metre).powi(2);
                let share = found / true_floor;
                assert!((share - 1.0).abs() < 0.15, "seed {seed}, turned by {turn}°, {metre} m a pixel: {share}");
            }
        }
    }
}

#[test]
fn a_part_stays_where_it_is_on_a_picture_that_is_turned() {
    let flat = random_flat(2, 2, 5);
    let mut session = opened(&scan(&flat, 0.0));
    let corners = [[MARGIN + 20.0, MARGIN + 20.0], [MARGIN + 120.0, MARGIN + 100.0]];
    change(&mut session, |settings| settings.part = DrawingPart::Rectangle { corners });
    let (before, size) = (session.floor_m2(), session.view().size);
    for quarter in 1..4 {
        session.turn_to(90.0 * f64::from(quarter)).unwrap();
        assert!(matches!(session.settings().part, DrawingPart::Rectangle { .. }));
        assert!((session.floor_m2() - before).abs() < 1e-9, "{quarter} quarters");
    }
    session.turn_to(10.0).unwrap();
    assert!(matches!(session.settings().part, DrawingPart::Polygon { .. }));
    assert!((session.floor_m2() / before - 1.0).abs() < 0.1, "{} for {before}", session.floor_m2());
    assert_ne!(session.view().size, size);
}

#[test]
fn photographs_are_read_natively_as_the_browser_reads_them() {
    let image = scan(&random_flat(1, 2, 3), 0.0);
    let of = |name: &str, format| DrawingSession::open(&[file(&image, name, format)]).unwrap();
    let exact = of("scan.png", ImageFormat::Png).floor_m2();
    assert_eq!(of("scan.webp", ImageFormat::WebP).floor_m2(), exact);
    let lossy = of("scan.jpg", ImageFormat::Jpeg).floor_m2();
    assert!((lossy / exact - 1.0).abs() < 0.02, "{lossy} for {exact} m²");
}

#[test]
fn unusual_sizes_are_asked_about_until_they_are_confirmed() {
    let flat = random_flat(2, 2, 1);
    let mut session = opened(&scan(&flat, 0.0));
    assert_eq!(session.view().asks, "");
    for metre in [1.0, 0.002] {
        change(&mut session, |settings| settings.metre = Some(metre));
        assert!(session.view().asks.contains(" × "), "{metre}");
    }
    change(&mut session, |settings| settings.confirmed = settings.metre);
    assert_eq!(session.view().asks, "");
    change(&mut session, |settings| settings.metre = Some(0.5));
    assert_ne!(session.view().asks, "", "another size is asked about again");
}

#[test]
fn an_improbable_floor_is_asked_about_though_its_sides_are_usual() {
    let flat = random_flat(2, 2, 1);
    let mut session = opened(&scan_with(&flat, 0.0, false));
    assert_eq!(session.view().asks, "");
    for (metre, floor) in [(4.0 * PIXEL, 500.0..1e9), (0.28 * PIXEL, 0.0..5.0)] {
        change(&mut session, |settings| settings.metre = Some(metre));
        assert!(floor.contains(&session.floor_m2()), "{}", session.floor_m2());
        let asks = session.view().asks;
        assert!(asks.ends_with(" m² of floor"), "{metre}: {asks}");
    }
    // A part may be as small as it is.
    change(&mut session, |settings| settings.part = DrawingPart::Room { at: [MARGIN + 40.0, MARGIN + 40.0] });
    assert_eq!(session.view().asks, "");
}

/// A flat of two rooms on a scan, with a door of that many pixels whose leaf and arc, `line` pixels wide, are drawn in one of
/// four ways, as on usual plans.
fn with_door_arc(door: i32, line: f64, way: u32) -> GrayImage {
    let (left, right) = (way.is_multiple_of(2), way < 2);
    GrayImage::from_fn(320, 240, |x, y| {
        let (x, y) = (x as i32 - 160, y as i32 - 120);
        let is_outer = x.abs() <= 130 && y.abs() <= 90 && (x.abs() > 124 || y.abs() > 84);
        let is_between = x.abs() <= 3 && y.abs() <= 90 && !(0..door).contains(&y);
        // From the hinge.
        let (dx, dy) = (f64::from(if left { -x } else { x }), f64::from(if right { y } else { door - y }));
        let away = dx.hypot(dy);
        let is_arc = dx >= 0.0 && dy >= 0.0 && (away - f64::from(door)).abs() <= 0.5 * line;
        let is_leaf = (0.0..=f64::from(door)).contains(&dx) && dy.abs() <= 0.5 * line;
        Luma([if is_outer || is_between || is_arc || is_leaf { 45 } else { 228 }])
    })
}

#[test]
fn the_symbol_of_a_door_is_no_wall_or_the_floor_behind_it_is_told_before_the_room_is_used() {
    for (door, line, way) in [(24, 1.5, 0), (30, 2.5, 1), (36, 2.0, 2), (44, 3.0, 3)] {
        let mut session = opened(&with_door_arc(door, line, way));
        assert_eq!(session.view().room.unwrap().cut_off_m2, 0.0, "{door} pixels, {way}");
        // All marks stay.
        change(&mut session, |settings| settings.specks = 0.0);
        let room = session.view().room.unwrap();
        let half = 120.0 * 168.0 * PIXEL * PIXEL;
        assert!((room.cut_off_m2 / half - 1.0).abs() < 0.2, "{door} pixels, {way}: {} of {half} m²", room.cut_off_m2);
    }
    // An open door of the same width is none.
    let mut open = with_door_arc(36, 1.0, 0);
    for y in 120..156 {
        (120..164).for_each(|x| open.put_pixel(x, y, Luma([228])));
    }
    assert_eq!(opened(&open).view().room.unwrap().cut_off_m2, 0.0);
}

#[test]
fn floor_within_reach_is_what_explore_says_of_the_same_room() {
    for (door, line, way) in [(24, 1.5, 0), (36, 2.0, 2)] {
        let mut board = opened(&with_door_arc(door, line, way));
        change(&mut board, |settings| settings.specks = 0.0);
        let room = board.view().room.unwrap();
        let mut session = Session::new();
        session.take_import(board.import(false).unwrap()).unwrap();
        session.configure(|choices| choices.select_robot("roomba600")).unwrap();
        session.plan_now(|| 0.0);
        let explore = session.view().room;
        assert_eq!(room.reachable_m2, Some(explore.reachable_m2));
        assert!((room.floor_m2 - explore.reachable_m2 - explore.left_out_m2).abs() < 1e-6, "{room:?}");
    }
}

#[test]
fn a_scale_that_is_assumed_is_asked_about_though_the_size_is_usual() {
    let flat = random_flat(2, 2, 1);
    let mut session = DrawingSession::open(&[file(&scan(&flat, 0.0), "scan.png", ImageFormat::Png)]).unwrap();
    let view = session.view();
    let room = view.room.unwrap();
    assert_eq!(view.asks, size_in_words(room.width_m, room.height_m));
    // Its openings, and what is too narrow, aren't told before. At this scale the front door is 1.8 m wide, and closed all the same.
    assert!(view.assumes_size && session.room().unwrap().leak.is_none());
    assert_eq!((view.notice.as_str(), view.closes, session.mark(), room.cut_off_m2), ("", None, None, 0.0));
    change(&mut session, |settings| settings.confirmed = settings.metre);
    let confirmed = session.view().room.unwrap();
    assert_eq!((confirmed.width_m, confirmed.floor_m2), (room.width_m, room.floor_m2), "the room that was shown");
    assert!(session.view().asks.is_empty() && session.view().notice.is_empty() && session.mark().is_none());
    change(&mut session, |settings| settings.metre = Some(PIXEL));
    assert!(!session.view().assumes_size && session.view().notice.is_empty());
    change(&mut session, |settings| settings.metre = Some(2.0 * PIXEL));
    change(&mut session, |settings| settings.confirmed = settings.metre);
    assert_eq!(session.view().asks, "");
    // A robot's map has cells of 5 cm.
    change(&mut session, |settings| (settings.confirmed, settings.method) = (None, ShadeMethod::Map));
    assert_eq!(session.view().asks, "");
}

#[test]
fn the_size_of_a_room_is_that_between_its_walls() {
    // 260 x 180 pixels, with walls of six.
    let room = opened(&with_door_arc(30, 1.0, 0)).view().room.unwrap();
    let size = [249.0, 169.0].map(|pixels| pixels * PIXEL);
    assert!((room.width_m - size[0]).abs() <= 2.0 * PIXEL, "{room:?}");
    assert!((room.height_m - size[1]).abs() <= 2.0 * PIXEL, "{room:?}");
}

#[test]
fn an_outer_door_that_is_closed_is_no_gap_that_was_asked_for() {
    let mut session = opened(&scan(&random_flat(2, 2, 0), 0.0));
    let room = session.view().room.unwrap();
    assert_eq!((room.gaps, room.outer_doors, session.settings().outer), (1, 1, 1.25));
    change(&mut session, |settings| settings.gap = 1.5);
    assert_eq!(session.view().room.unwrap().outer_doors, 0, "now it was");
}

#[test]
fn an_opening_that_lets_the_outside_in_is_told_with_its_place() {
    let flat = random_flat(2, 2, 0);
    let mut session = opened(&scan(&flat, 0.0));
    assert_eq!((session.view().notice.as_str(), session.mark()), ("", None));
    // Five times too large: the front door, 0.9 m wide in the left wall, isn't closed.
    change(&mut session, |settings| settings.metre = Some(5.0 * PIXEL));
    let (notice, mark, closes) = (session.view().notice, session.mark().unwrap(), session.view().closes);
    assert!(notice.contains("open to the outside") && notice.contains("Check the size"), "{notice}");
    assert!((4.4..=4.8).contains(&mark.width) && closes.is_none(), "{mark:?}");
    let door = Point::new(MARGIN, MARGIN + 0.95 / PIXEL);
    assert!((mark.at - door).norm() < 0.8 / PIXEL, "{mark:?} for {door}");
}

#[test]
fn a_picture_that_is_reduced_keeps_its_scale() {
    let flat = random_flat(1, 2, 3);
    let small = scan_with(&flat, 0.0, false);
    // As at a high resolution, with a few more than 4096 pixels on its longer side.
    let times = 4096 / small.width().max(small.height()) + 1;
    let large = GrayImage::from_fn(times * small.width(), times * small.height(), |x, y| {
        *small.get_pixel(x / times, y / times)
    });
    let mut session = DrawingSession::open(&[file(&large, "scan.png", ImageFormat::Png)]).unwrap();
    let view = session.view();
    assert_eq!((view.reduced, &view.reduced_from), (2, &format!("{} × {} pixels", large.width(), large.height())));
    // 20 m are assumed for the longer side.
    let metre = view.settings.metre.unwrap();
    assert!((metre * f64::from(large.width().max(large.height()) / 2) - 20.0).abs() < 0.02, "{metre}");
    assert_eq!(view.assumed_pixel, format!("{}\u{a0}cm", (5000.0 * metre).round() / 100.0));
    change(&mut session, |settings| settings.metre = Some(2.0 * PIXEL / f64::from(times)));
    let (found, expected) = (session.view().room.unwrap(), opened(&small).view().room.unwrap());
    assert_eq!(session.view().size, opened(&small).view().size);
    // Its cells are of 5 cm.
    for (found, expected) in [(found.width_m, expected.width_m), (found.height_m, expected.height_m)] {
        assert!((found - expected).abs() <= 0.1, "{found} for {expected} m");
    }
    assert_eq!((opened(&small).view().reduced, opened(&small).view().reduced_from), (1, String::new()));
}

#[test]
fn a_picture_without_walls_says_that_none_were_found() {
    let blank = GrayImage::from_pixel(300, 200, Luma([255]));
    let mut session = opened(&blank);
    assert!(session.view().notice.starts_with("No walls that enclose floor"), "{}", session.view().notice);
    change(&mut session, |settings| settings.part = DrawingPart::Whole);
    assert_eq!(session.view().notice, "", "all of it is what was chosen");
}

/// A rectangle of 4 x 3 m, askew by 7 degrees, in millimetres, as a closed polyline; `door` leaves a gap.
fn askew_room(door: bool) -> SourceFile {
    let (sin, cos) = 7.0_f64.to_radians().sin_cos();
    let corners = [(900.0, 0.0), (4000.0, 0.0), (4000.0, 3000.0), (0.0, 3000.0), (0.0, 0.0), (100.0, 0.0)];
    let count = if door { corners.len() } else { 5 };
    let corners = corners[..count]
        .iter()
        .map(|(x, y)| format!("10\n{}\n20\n{}\n", 5000.0 + x * cos - y * sin, 2000.0 + x * sin + y * cos));
    let corners: String = corners.collect();
    let closed = u8::from(!door);
    let text = format!(
        "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n\
         WALLS\n90\n{count}\n70\n{closed}\n{corners}0\nENDSEC\n0\nEOF\n"
    );
    SourceFile { name: "askew.dxf".to_owned(), bytes: text.into_bytes() }
}

#[test]
fn a_straightened_drawing_is_swept_along_its_walls_and_exported_where_it_was() {
    let mut session = DrawingSession::open(&[askew_room(false)]).unwrap();
    let askew = session.askew().unwrap();
    assert!((askew - 7.0).abs() < 0.01, "{askew}");
    let (low, high) = (session.source().extent().0, session.source().extent().0 + session.source().extent().1);
    session.turn_to(-askew).unwrap();
    let room = session.room().unwrap();
    assert!((room.plan.width_m() - 4.0).abs() < 0.2 && (room.plan.height_m() - 3.0).abs() < 0.2);
    session.sweep(&mut |_| ControlFlow::Continue(())).unwrap();
    let room = session.room().unwrap();
    for &point in &session.planned().unwrap().path {
        let at = room.to_drawing(point);
        assert!(at.x > low.x && at.y > low.y && at.x < high.x && at.y < high.y, "{at} is outside of the drawing");
        let in_metres = room.plan.origin.to_world(point) - at * 0.001;
        assert!(in_metres.norm() < 1e-9, "the room's origin says the same");
    }
}

#[test]
fn a_leak_is_marked_where_it_is() {
    let mut session = DrawingSession::open(&[askew_room(true)]).unwrap();
    change(&mut session, |settings| settings.part = DrawingPart::Room { at: [6500.0, 3500.0] });
    let marks: Vec<_> = session.marks().collect();
    let [mark] = marks[..] else { panic!("{marks:?}") };
    assert!((mark.at - Point::new(5500.0, 2060.0)).norm() < 150.0, "{:?}", mark.at);
    assert!((0.6..1.0).contains(&mark.width), "{}", mark.width);
    assert!(session.fault().contains("close its door") && !session.fault().contains('('), "{}", session.fault());
    change(&mut session, |settings| settings.gap = 0.9);
    assert!(session.marks().next().is_none() && session.room().is_some());
    change(&mut session, |settings| settings.part = DrawingPart::Room { at: [-99.0, -99.0] });
    assert_eq!(session.mark().unwrap().width, 0.0);
}

#[test]
fn plans_on_paper_offer_its_scales() {
    let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="210mm" height="297mm" viewBox="0 0 210 297">
        <rect width="210" height="297" fill="white"/>
        <path id="Wand" d="M20 20 H140 V120 H20 Z" fill="none" stroke="black"/></svg>"#;
    let svg = SourceFile { name: "paper.svg".to_owned(), bytes: svg.into() };
    let mut session = DrawingSession::open(&[svg]).unwrap();
    let ignored = session.view().layers.into_iter().find(|layer| layer.role == floor_drawing::Role::Ignored);
    assert_eq!(ignored.unwrap().name, "background");
    assert!(session.view().asks.contains("mm"), "a doll's house: {}", session.view().asks);
    assert!(session.room().is_none() && session.import(false).unwrap_err().contains("size"), "no room of paper");
    change(&mut session, |settings| settings.confirmed = settings.metre);
    assert!(session.room().is_some(), "unless it is one");
    change(&mut session, |settings| settings.confirmed = None);
    assert!(session.room().is_none());
    let papers: Vec<String> = session.view().papers.into_iter().map(|paper| paper.name).collect();
    assert_eq!(papers, ["1:50", "1:100", "1:200"], "offered beside the question");
    let paper = session.view().units.into_iter().find(|unit| unit.name == "on paper, 1:100").unwrap();
    change(&mut session, |settings| settings.metre = Some(paper.metre));
    let room = session.view().room.unwrap();
    assert!((room.floor_m2 - 120.0).abs() < 4.0, "12 x 10 m: {}", room.floor_m2);
    assert_eq!((session.view().asks.as_str(), session.view().papers.len()), ("", 0));
    // A scanned sheet.
    let sheet = GrayImage::from_fn(424, 300, |x, y| Luma([if x % 100 < 4 || y % 100 < 4 { 0 } else { 255 }]));
    let mut session = opened(&sheet);
    // Turned, it is the same sheet.
    for turn in [0.0, 8.0] {
        change(&mut session, |settings| settings.turn = turn);
        let units = session.view().units;
        let sheet = units.iter().find(|unit| unit.name == "A4 sheet, 1:100").unwrap();
        assert!((sheet.metre - 29.7 / 424.0).abs() < 1e-9, "{turn}: {units:?}");
        assert!(units.iter().all(|unit| !unit.name.contains("Letter")), "{turn}: {units:?}");
    }
    change(&mut session, |settings| settings.turn = 0.0);
    let names: Vec<String> = session.view().units.into_iter().map(|unit| unit.name).collect();
    assert!(names.contains(&"A4 sheet, 1:100".to_owned()) && names.contains(&"A3 sheet, 1:50".to_owned()), "{names:?}");
    let letter = GrayImage::from_fn(440, 340, |x, y| Luma([if x % 100 < 4 || y % 100 < 4 { 0 } else { 255 }]));
    let units = opened(&letter).view().units;
    let quarter = units.iter().find(|unit| unit.name == "Letter sheet, 1:48").unwrap();
    assert!((quarter.metre - 48.0 * 0.2794 / 440.0).abs() < 1e-9 && units.len() == 5, "{units:?}");
}

/// A flat of 8.4 x 6.3 m with three rooms, 1:100 on A4 with a frame and a title block, at 60 pixels a metre.
fn on_a_sheet() -> GrayImage {
    const WALLS: [[f64; 4]; 8] = [
        [0.0, 0.0, 8.4, 0.2],
        [0.0, 6.1, 8.4, 6.3],
        [0.0, 0.0, 0.2, 6.3],
        [8.2, 0.0, 8.4, 6.3],
        // With doors between them.
        [4.0, 0.0, 4.1, 3.7],
        [4.0, 4.6, 4.1, 6.3],
        [4.1, 2.8, 5.6, 2.9],
        [6.5, 2.8, 8.4, 2.9],
    ];
    let is_in =
        |x: f64, y: f64, [left, low, right, high]: [f64; 4]| (left..right).contains(&x) && (low..high).contains(&y);
    GrayImage::from_fn(1782, 1260, |x, y| {
        let (x, y) = (f64::from(x) / 60.0, 21.0 - f64::from(y) / 60.0);
        let is_line = |rectangle: [f64; 4]| {
            let [left, low, right, high] = rectangle;
            is_in(x, y, rectangle) && !is_in(x, y, [left + 0.05, low + 0.05, right - 0.05, high - 0.05])
        };
        let is_wall = WALLS.iter().any(|&wall| is_in(x - 7.0, y - 10.0, wall));
        let is_sheet = is_line([0.7, 0.7, 29.0, 20.3]) || is_line([21.0, 0.7, 29.0, 3.2]);
        Luma([if is_wall || is_sheet { 30 } else { 250 }])
    })
}

#[test]
fn a_small_flat_on_its_sheet_is_what_is_indoors() {
    let mut session = DrawingSession::open(&[file(&on_a_sheet(), "a4.png", ImageFormat::Png)]).unwrap();
    let paper = session.view().units.into_iter().find(|unit| unit.name == "A4 sheet, 1:100").unwrap();
    change(&mut session, |settings| settings.metre = Some(paper.metre));
    let found = session.floor_m2();
    assert!((45.0..47.0).contains(&found), "8.0 x 5.9 m, 0.8 m² of it walls: {found}");
}
