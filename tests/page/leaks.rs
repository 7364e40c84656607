//! Openings by which the outside gets into a floor plan: what is told about them, and what closes them.

use image::{GrayImage, ImageFormat, Luma};
use rand::RngExt;
use robovac_app::floor_plan::{DrawingPart, DrawingSession, FloorPlanSettings};
use robovac_core::{floor_plan::SourceFile, geometry::Point, rng::seeded, robot::model};
use robovac_sim::experiment::planning::RoomSetup;
use std::io::Cursor;

/// A wall: from, to, m.
type Wall = [f64; 4];

/// A flat of four rooms with doors between them; m.
struct Flat {
    size: [f64; 2],
    walls: Vec<Wall>,
    /// Where its left wall is open, and how wide.
    opening: [f64; 2],
    at: Point,
    /// Floor of the room behind the opening, and of all.
    behind_m2: f64,
}

impl Flat {
    /// One with an opening `wide` in its left wall, and everything else by the seed.
    fn of(seed: u64, wide: f64) -> Self {
        let mut rng = seeded(seed, 0);
        let mut any = |low: f64, high: f64| rng.random_range(low..high);
        let (width, height) = (any(8.5, 12.0), any(8.0, 10.0));
        let (middle, sill) = (any(3.6, 4.8), any(4.8, 5.6));
        let other = any(2.9, 5.0);
        let [one, two, three] = [0; 3].map(|_| any(0.8, 1.1));
        // 0.3 m of wall at least on either side.
        let low = any(0.3, sill - wide - 0.3);
        let door = any(0.4, 1.5);
        let walls = vec![
            [0.0, 0.0, width, 0.0],
            [width, 0.0, width, height],
            [width, height, 0.0, height],
            [0.0, height, 0.0, low + wide],
            [0.0, low, 0.0, 0.0],
            // The room behind the opening, with a door to each neighbour.
            [0.0, sill, 1.2, sill],
            [1.2 + one, sill, middle, sill],
            [middle, 0.0, middle, door],
            [middle, door + two, middle, height],
            [middle, other, middle + 1.5, other],
            [middle + 1.5 + three, other, width, other],
        ];
        let at = Point::new(0.0, low + 0.5 * wide);
        Self { size: [width, height], walls, opening: [low, wide], at, behind_m2: middle * sill }
    }

    fn floor_m2(&self) -> f64 {
        self.size[0] * self.size[1]
    }

    /// Lines in millimetres, which the file states.
    fn drawing(&self) -> SourceFile {
        let [width, height] = self.size.map(|side| 1000.0 * side);
        let line = |wall: &Wall| {
            let [a, b, c, d] = wall.map(|metres| 1000.0 * metres);
            format!("<path d='M{a} {b}L{c} {d}'/>", b = height - b, d = height - d)
        };
        let lines: String = self.walls.iter().map(line).collect();
        let svg = format!(
            "<svg xmlns='http://www.w3.org/2000/svg' width='{width}mm' height='{height}mm' \
             viewBox='0 0 {width} {height}'><g id='walls' stroke='#000' fill='none'>{lines}</g></svg>"
        );
        SourceFile { name: "flat.svg".to_owned(), bytes: svg.into() }
    }

    /// Walls 15 cm thick on 2 m of paper, with `metre` metres a pixel.
    fn picture(&self, metre: f64) -> SourceFile {
        self.picture_with(metre, &[])
    }

    /// The same with thin lines.
    fn picture_with(&self, metre: f64, thin: &[Wall]) -> SourceFile {
        let [wide, high] = self.size.map(|side| ((side + 4.0) / metre) as u32);
        let image = GrayImage::from_fn(wide, high, |x, y| {
            let at = [(f64::from(x) + 0.5) * metre - 2.0, (f64::from(high - y) - 0.5) * metre - 2.0];
            let is_wall = self.walls.iter().any(|&[a, b, c, d]| {
                let is_upright = a == c;
                let half = |is_across: bool| if is_across { 0.075 } else { 0.0 };
                let (from, to) = ([a.min(c), b.min(d)], [a.max(c), b.max(d)]);
                // The corners of the house are filled.
                let end = |value: f64, most: f64| if value == 0.0 || value == most { 0.075 } else { 0.0 };
                (0..2).all(|axis| {
                    let across: f64 = half((axis == 0) == is_upright);
                    let [low, high] = [from[axis], to[axis]].map(|at| across.max(end(at, self.size[axis])));
                    (from[axis] - low..=to[axis] + high).contains(&at[axis])
                })
            });
            let is_line = thin.iter().any(|&[a, b, c, d]| {
                let (x, y) = (at[0].clamp(a.min(c), a.max(c)) - at[0], at[1].clamp(b.min(d), b.max(d)) - at[1]);
                x.abs().max(y.abs()) < 0.02
            });
            Luma([if is_wall || is_line { 30 } else { 240 }])
        });
        let mut bytes = Cursor::new(Vec::new());
        image.write_to(&mut bytes, ImageFormat::Png).unwrap();
        SourceFile { name: "flat.png".to_owned(), bytes: bytes.into_inner() }
    }
}

fn change(session: &mut DrawingSession, what: impl FnOnce(&mut FloorPlanSettings)) {
    let mut settings = session.settings().clone();
    what(&mut settings);
    session.set(settings).unwrap();
}

/// The opening is told with its width and place, and closing it makes the whole flat one floor.
fn check(mut session: DrawingSession, flat: &Flat, metre: f64, moved: f64, case: &str) {
    let view = session.view();
    assert!(view.notice.contains("open to the outside"), "{case}: {:?}", view.notice);
    let [_, wide] = flat.opening;
    let mark = session.mark().unwrap();
    assert!((mark.width - wide).abs() <= 0.11, "{case}: {} for {wide} m", mark.width);
    let at = Point::from(mark.at.coords * metre).map(|side| side - moved);
    assert!((at - flat.at).norm() < 0.3, "{case}: {at} for {}", flat.at);
    let leak = session.room().unwrap().leak.unwrap();
    assert!((leak.floor_m2 / flat.behind_m2 - 1.0).abs() < 0.2, "{case}: {} m²", leak.floor_m2);
    let outer = view.closes.unwrap();
    assert!((outer - mark.width).abs() < 1e-9, "{case}");
    // Closing gaps between walls is another matter: the opening is told until it is closed.
    if wide > 1.65 {
        change(&mut session, |settings| settings.gap = 1.5);
        assert!(session.view().notice.contains("open to the outside"), "{case}");
        change(&mut session, |settings| settings.gap = 0.1);
    }
    change(&mut session, |settings| settings.outer = outer);
    let view = session.view();
    assert_eq!((view.notice.as_str(), session.mark(), view.closes), ("", None, None), "{case}");
    let share = session.floor_m2() / flat.floor_m2();
    assert!((0.9..1.0).contains(&share), "{case}: {share} of the floor");
    let room = view.room.unwrap();
    assert_eq!((room.cut_off_m2, room.outer_doors, room.gaps), (0.0, 1, 1), "{case}: the doors between rooms are open");
}

/// As drawings, and every `stride`th as a picture as well, which takes ten times as long.
fn check_flats(seeds: std::ops::Range<u64>, stride: u64) {
    for seed in seeds {
        let wide = [1.5, 1.6, 2.0, 2.3, 2.7, 3.2][seed as usize % 6] + 0.013 * (seed / 6) as f64;
        let flat = Flat::of(seed, wide);
        let session = DrawingSession::open(&[flat.drawing()]).unwrap();
        check(session, &flat, 0.001, 0.0, &format!("drawing {seed}, {wide} m"));
        if seed % stride == 0 {
            let mut session = DrawingSession::open(&[flat.picture(0.025)]).unwrap();
            change(&mut session, |settings| settings.metre = Some(0.025));
            check(session, &flat, 0.025, 2.0, &format!("picture {seed}, {wide} m"));
        }
    }
}

// slow: a flat for each width, and a picture
#[test]
fn an_opening_of_any_width_in_a_flat_with_inner_doors_is_told_and_closed_without_them() {
    check_flats(0..6, 6);
}

#[test]
#[ignore = "soak: half a minute"]
fn openings_of_more_flats_are_told_and_closed() {
    check_flats(4..24, 4);
}

#[test]
fn a_court_as_wide_as_its_opening_is_outside() {
    for (wide, depth) in [(2.0, 3.3), (3.1, 3.6), (2.6, 3.9)] {
        let outline = [
            [0.0, 0.0],
            [10.0, 0.0],
            [10.0, 8.0],
            [5.0 + wide, 8.0],
            [5.0 + wide, 8.0 - depth],
            [5.0, 8.0 - depth],
            [5.0, 8.0],
            [0.0, 8.0],
        ];
        let corners: Vec<String> = outline.iter().map(|[x, y]| format!("{} {}", 1000.0 * x, 1000.0 * y)).collect();
        let svg = format!(
            "<svg xmlns='http://www.w3.org/2000/svg' width='10000mm' height='8000mm' viewBox='0 0 10000 8000'>\
             <path id='walls' fill='none' stroke='#000' d='M{}Z'/></svg>",
            corners.join("L")
        );
        let file = SourceFile { name: "court.svg".to_owned(), bytes: svg.into() };
        let session = DrawingSession::open(&[file]).unwrap();
        assert_eq!((session.view().notice.as_str(), session.mark()), ("", None), "{wide} x {depth} m");
    }
}

fn check_flats_at_an_angle(seeds: std::ops::Range<u64>) {
    for seed in seeds {
        let wide = [2.0, 2.3, 2.7, 3.2][seed as usize % 4];
        let flat = Flat::of(seed, wide);
        let mut session = DrawingSession::open(&[flat.drawing()]).unwrap();
        session.turn_to([7.0, 30.0, 45.0][seed as usize % 3]).unwrap();
        let width = session.mark().unwrap().width;
        assert!((width - wide).abs() < 0.16, "seed {seed}: {width} for {wide} m");
        let outer = session.view().closes.unwrap();
        change(&mut session, |settings| settings.outer = outer);
        let (view, share) = (session.view(), session.floor_m2() / flat.floor_m2());
        let room = view.room.unwrap();
        assert_eq!((view.notice.as_str(), room.cut_off_m2, room.outer_doors), ("", 0.0, 1), "seed {seed}");
        assert!((0.9..1.0).contains(&share), "seed {seed}: {share} of the floor");
    }
}

// slow: a flat for each width
#[test]
fn an_opening_of_a_flat_at_an_angle_is_told_with_its_width_and_closed() {
    check_flats_at_an_angle(0..4);
}

#[test]
#[ignore = "soak: more flats"]
fn openings_of_more_flats_at_an_angle_are_told_and_closed() {
    check_flats_at_an_angle(4..6);
}

fn check_openings_to_the_garden(seeds: std::ops::Range<u64>) {
    for seed in seeds {
        let wide = [1.5, 1.6, 2.0, 2.3, 2.7][seed as usize % 5];
        let garden = [1.6, 2.5, 3.5][seed as usize % 3];
        let mut flat = Flat::of(seed, wide);
        let [width, height] = flat.size;
        let (low, right, high) = (-garden, width + garden, height + garden);
        flat.walls.extend([[low, low, right, low], [right, low, right, high]]);
        flat.walls.extend([[right, high, low, high], [low, high, low, low]]);
        let mut session = DrawingSession::open(&[flat.drawing()]).unwrap();
        let check = |session: &DrawingSession, what: &str| {
            let share = session.floor_m2() / flat.floor_m2();
            assert!((0.9..1.0).contains(&share), "seed {seed}, {what}: {share} of the floor");
            assert_eq!((session.view().notice.as_str(), session.mark()), ("", None), "seed {seed}, {what}");
        };
        check(&session, "at once");
        change(&mut session, |settings| settings.outer = wide + 0.1);
        check(&session, "with openings of its width closed");
    }
}

// slow: a flat for each width, in all gardens
#[test]
fn an_opening_to_the_garden_is_closed_whatever_the_width_of_both() {
    check_openings_to_the_garden(0..5);
}

#[test]
#[ignore = "soak: more flats and gardens"]
fn openings_to_more_gardens_are_closed() {
    check_openings_to_the_garden(5..10);
}

fn check_thin_lines(seeds: std::ops::Range<u64>) {
    for seed in seeds {
        let flat = Flat::of(seed, 1.0);
        let [width, height] = flat.size;
        let thin = [
            [0.0, -0.5, width, -0.5],
            [-0.55, 0.0, -0.55, height],
            [-1.7, -1.7, width + 1.7, -1.7],
            [width + 1.7, -1.7, width + 1.7, height + 1.7],
            [width + 1.7, height + 1.7, -1.7, height + 1.7],
            [-1.7, height + 1.7, -1.7, -1.7],
        ];
        let mut session = DrawingSession::open(&[flat.picture_with(0.02, &thin)]).unwrap();
        change(&mut session, |settings| settings.metre = Some(0.02));
        let share = session.floor_m2() / flat.floor_m2();
        assert!((0.9..1.0).contains(&share), "seed {seed}: {share} of the floor");
        let room = session.view().room.unwrap();
        assert_eq!((room.outer_doors, room.around_m2), (1, 0.0), "seed {seed}: the front door alone is closed");
    }
}

// slow: a picture takes ten times as long as lines
#[test]
fn dimension_lines_and_a_thin_fence_of_a_picture_are_no_walls() {
    check_thin_lines(0..1);
}

#[test]
#[ignore = "soak: more pictures"]
fn dimension_lines_and_thin_fences_of_more_pictures_are_no_walls() {
    check_thin_lines(1..3);
}

/// Whether the room starts within the walls of the flat.
fn starts_in(session: &DrawingSession, flat: &Flat) -> bool {
    let room = session.room().unwrap();
    let Some(start) = room.plan.start else { return false };
    let Point { coords: at } = room.to_drawing(start.position());
    (0..2).all(|axis| (0.0..flat.size[axis]).contains(&(0.001 * at[axis])))
}

/// Floor that a Roomba reaches from the start, m².
fn reached_m2(session: &DrawingSession) -> f64 {
    RoomSetup::new(&session.room().unwrap().plan, model("roomba600").unwrap(), 0.12, None).unwrap().floor.area()
}

#[test]
fn all_of_a_flat_with_an_opening_starts_indoors_and_stays_there() {
    for (seed, wide, turn) in [(0, 0.9, 0.0), (1, 1.2, 0.0), (2, 0.2, 0.0), (3, 0.9, 0.3)] {
        let flat = Flat::of(seed, wide);
        let mut session = DrawingSession::open(&[flat.drawing()]).unwrap();
        change(&mut session, |settings| settings.turn = turn);
        let indoors = reached_m2(&session);
        change(&mut session, |settings| settings.part = DrawingPart::Whole);
        assert!(session.floor_m2() > flat.floor_m2(), "seed {seed}: what is outside counts");
        let view = session.view();
        // A Roomba doesn't get through the narrow one.
        assert_eq!(view.opens, wide > 0.35, "seed {seed}: {:?}", view.notice);
        assert_eq!(view.notice.contains("Outer doors are closed"), view.opens, "seed {seed}: {:?}", view.notice);
        let reached = reached_m2(&session);
        assert!((reached - indoors).abs() < 0.02 * indoors, "seed {seed}: {reached} of {indoors} m²");
        if !view.opens {
            continue;
        }
        assert_eq!(view.room.unwrap().outer_doors, 1, "seed {seed}");
        change(&mut session, |settings| settings.outer = 0.0);
        let open = session.view();
        assert!(open.notice.contains("a robot gets out") && !open.opens, "seed {seed}: {:?}", open.notice);
        assert!(reached_m2(&session) > indoors + 1.0, "seed {seed}");
        change(&mut session, |settings| settings.outer = open.closes.unwrap());
        assert!(session.view().opens, "seed {seed}: closed again");
        session.set_part(DrawingPart::Indoors).unwrap();
        assert_eq!(session.view().notice, "", "seed {seed}");
    }
}

#[test]
fn all_of_a_flat_whose_opening_is_too_wide_to_be_closed_shows_it() {
    for seed in 0..3 {
        // As a front door on a drawing that is taken for twice as large.
        let flat = Flat::of(seed, 1.8);
        let mut session = DrawingSession::open(&[flat.drawing()]).unwrap();
        session.set_part(DrawingPart::Whole).unwrap();
        let view = session.view();
        assert!(view.notice.contains("opening about 1.8"), "seed {seed}: {:?}", view.notice);
        assert!(session.room().unwrap().leak.is_some(), "seed {seed}: it is marked");
        change(&mut session, |settings| settings.outer = view.closes.unwrap());
        assert!(session.view().opens && starts_in(&session, &flat), "seed {seed}: {:?}", session.view().notice);
    }
}

#[test]
fn a_room_full_of_desks_is_closed_at_its_door_whatever_the_size_of_a_pixel() {
    // Its aisles are narrower than an outer door, and the sheet has wide margins.
    let mut image = GrayImage::from_pixel(700, 620, Luma([255]));
    let mut fill = |[left, top, right, bottom]: [u32; 4], shade: u8| {
        (top..bottom).for_each(|y| (left..right).for_each(|x| image.put_pixel(x, y, Luma([shade]))));
    };
    fill([100, 80, 600, 480], 0);
    fill([110, 90, 590, 470], 255);
    fill([500, 470, 545, 480], 255);
    for (column, row) in (0..4).flat_map(|column| (0..5).map(move |row| (column, row))) {
        let [left, top] = [160 + 105 * column, 145 + 60 * row];
        fill([left, top, left + 60, top + 25], 0);
    }
    let mut bytes = Cursor::new(Vec::new());
    image.write_to(&mut bytes, ImageFormat::Png).unwrap();
    let mut session =
        DrawingSession::open(&[SourceFile { name: "classroom.png".to_owned(), bytes: bytes.into_inner() }]).unwrap();
    for metre in [0.015, 0.02, 0.025] {
        change(&mut session, |settings| settings.metre = Some(metre));
        let pixels = 480.0 * 380.0 - 20.0 * 60.0 * 25.0;
        let share = session.floor_m2() / (pixels * metre * metre);
        assert!((0.9..1.05).contains(&share), "{metre} m a pixel: {share} of the floor");
        assert_eq!(session.view().room.unwrap().outer_doors, 1, "{metre} m a pixel");
    }
}

/// A flat in its garden, whose wall is drawn as so many lines.
fn in_a_garden(seed: u64, lines: u32) -> Flat {
    let mut flat = Flat::of(seed, 1.0);
    let [width, height] = flat.size;
    for line in 0..lines {
        let garden = 8.0 + 0.2 * f64::from(line);
        let (low, right, high) = (-garden, width + garden, height + garden);
        flat.walls.extend([[low, low, right, low], [right, low, right, high]]);
        flat.walls.extend([[right, high, low, high], [low, high, low, low]]);
    }
    flat
}

#[test]
fn a_house_in_a_large_garden_is_taken_and_told() {
    let flat = in_a_garden(0, 1);
    let mut session = DrawingSession::open(&[flat.drawing()]).unwrap();
    let share = session.floor_m2() / flat.floor_m2();
    assert!((0.9..1.0).contains(&share), "{share} of the floor");
    let notice = session.view().notice;
    assert!(notice.contains("Only its floor counts") && notice.contains("Whole"), "{notice:?}");
    session.set_part(DrawingPart::Whole).unwrap();
    assert!(session.floor_m2() > 3.0 * flat.floor_m2(), "all");
    assert!(starts_in(&session, &flat), "in the garden");
}

#[test]
fn a_house_with_walls_of_two_lines_is_taken_within_a_garden_wall_of_two_lines() {
    let mut flat = in_a_garden(1, 2);
    let ([width, height], [low, wide], out) = (flat.size, flat.opening, 0.35);
    let (right, high) = (width + out, height + out);
    flat.walls.extend([[-out, -out, right, -out], [right, -out, right, high], [right, high, -out, high]]);
    flat.walls.extend([[-out, high, -out, low + wide], [-out, low, -out, -out]]);
    flat.walls.extend([[-out, low, 0.0, low], [-out, low + wide, 0.0, low + wide]]);
    let session = DrawingSession::open(&[flat.drawing()]).unwrap();
    let share = session.floor_m2() / flat.floor_m2();
    assert!((0.9..1.05).contains(&share), "{share} of the floor");
}

#[test]
fn a_building_that_may_be_a_block_in_a_hall_is_told_and_the_robot_starts_in_it() {
    // The walls round all are two lines, those of the building one.
    let flat = in_a_garden(1, 2);
    let session = DrawingSession::open(&[flat.drawing()]).unwrap();
    assert!(session.floor_m2() > 3.0 * flat.floor_m2(), "all");
    let notice = session.view().notice;
    assert!(notice.contains("All floor counts") && notice.contains("Polygon"), "{notice:?}");
    assert!(starts_in(&session, &flat), "{:?}", session.room().unwrap().plan.start);
}
