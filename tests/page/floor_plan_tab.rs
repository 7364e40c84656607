//! The Floor plan tab: results of files, settings and pointing, without a browser.

use floor_drawing::{Role, ShadeMethod};
use robovac_app::{
    export::{PathFormat, to_svg},
    floor_plan::{BodyChoice, DrawingPart, DrawingSession, DrawingSource, DrawingTool, FloorPlanSettings, coarse},
};
use robovac_core::{
    floor_plan::{SourceFile, TAKEN, room},
    geometry::Point,
    grid::{Grid, Occupancy},
};
use std::ops::ControlFlow;

fn file(name: &str, content: impl Into<Vec<u8>>) -> SourceFile {
    SourceFile { name: name.into(), bytes: content.into() }
}

/// A grey image of 4 x 2 pixels: wall, dark grey, light grey, floor in each row.
fn image() -> SourceFile {
    let mut bytes = b"P5\n4 2\n255\n".to_vec();
    bytes.extend([0, 100, 160, 255, 0, 100, 160, 255]);
    file("scan.pgm", bytes)
}

fn open(file: SourceFile) -> DrawingSession {
    DrawingSession::open(&[file]).unwrap()
}

fn change(board: &mut DrawingSession, what: impl FnOnce(&mut FloorPlanSettings)) {
    let mut settings = board.settings().clone();
    what(&mut settings);
    board.set(settings).unwrap();
}

fn cells(board: &DrawingSession) -> Vec<Occupancy> {
    board.room().unwrap().plan.occupancy.values()[..4].to_vec()
}

#[test]
fn an_image_is_five_centimetres_a_pixel_until_somebody_knows_better() {
    let mut board = open(image());
    assert_eq!(board.view().size.as_deref(), Some("200 × 100 mm"));
    assert!(!board.view().says_unit && board.view().is_scalable);
    board.hand.take(DrawingTool::Scale);
    board.hand.click(Point::new(0.0, 1.0), 0.01);
    board.hand.click(Point::new(4.0, 1.0), 0.01);
    assert_eq!(board.measured_m(), Some(0.2));
    board.scale_to(8.0).unwrap();
    assert_eq!(board.room().unwrap().plan.resolution, 2.0);
    assert_eq!((board.view().size.as_deref(), board.view().tool), (Some("8.0 × 4.0 m"), DrawingTool::View));
}

#[test]
fn a_distance_of_nothing_changes_nothing() {
    let mut board = open(image());
    assert!(board.scale_to(1.0).unwrap_err().contains("two points"));
    board.hand.take(DrawingTool::Scale);
    board.hand.click(Point::new(0.0, 1.0), 0.01);
    board.hand.click(Point::new(4.0, 1.0), 0.01);
    for metres in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(board.scale_to(metres).is_err(), "{metres}");
    }
    assert_eq!(board.settings().metre, Some(0.05));
}

#[test]
fn shades_are_wall_where_they_are_darker_than_said() {
    use Occupancy::{Free, Occupied, Unknown};
    let mut board = open(image());
    assert_eq!(cells(&board), [Occupied, Unknown, Unknown, Free], "the rules of the map server");
    change(&mut board, |settings| {
        (settings.method, settings.shade, settings.part) = (ShadeMethod::Level, 0.5, DrawingPart::Whole);
        settings.specks = 0.0;
    });
    assert_eq!(cells(&board), [Occupied, Occupied, Free, Free]);
    change(&mut board, |settings| settings.shade = 0.3);
    assert_eq!(cells(&board), [Occupied, Free, Free, Free]);
    change(&mut board, |settings| settings.negate = true);
    assert_eq!(cells(&board), [Free, Occupied, Occupied, Occupied]);
    let version = board.version();
    change(&mut board, |settings| settings.shade = 0.0);
    assert_ne!(board.version(), version, "the picture of the room goes with it");
    assert!(board.room().is_none() && board.fault().contains("No floor is left"), "{}", board.fault());
    assert!(board.import(false).is_err());
    change(&mut board, |settings| (settings.shade, settings.negate) = (0.5, false));
    assert_eq!(cells(&board), [Occupied, Occupied, Free, Free], "a fault can be mended");
}

#[test]
fn a_text_map_keeps_its_start_when_it_is_scaled() {
    let mut board = open(file("map.txt", "; resolution 0.1\n....\n.S..\n....\n"));
    change(&mut board, |settings| settings.metre = Some(0.2));
    let start = board.room().unwrap().plan.start.unwrap();
    assert!((start.x - 0.3).abs() < 1e-12 && (start.y - 0.3).abs() < 1e-12, "{start:?}");
}

const SCENARIO: &str = r#"{
    "format": "robovac-scenario", "version": 2, "name": "Mine", "robot": "octagon", "planner": "snake",
    "params": { "effort": 2 },
    "resolution": 0.1, "width": 3, "height": 2, "rows": ["...", "..."]
}"#;

#[test]
fn a_scenario_keeps_its_choices_and_its_metres() {
    let mut board = open(file("mine.json", SCENARIO));
    change(&mut board, |settings| settings.metre = Some(5.0));
    assert!(!board.view().is_scalable);
    let import = board.import(false).unwrap();
    assert_eq!(import.plan.resolution, 0.1);
    let choices = import.choices.unwrap();
    assert_eq!((choices.robot.as_deref(), choices.planner.as_deref()), (Some("octagon"), Some("snake")));
}

#[test]
fn the_sweep_takes_its_planner_and_its_robot_along_and_no_parameters_of_another() {
    let mut board = open(file("mine.json", SCENARIO.replace("\"resolution\": 0.1", "\"resolution\": 1")));
    change(&mut board, |settings| settings.body = BodyChoice::Model { id: "dvr1".into() });
    assert!(board.import(true).unwrap_err().contains("plan the sweep"));
    plan(&mut board).unwrap();
    let choices = board.import(true).unwrap().choices.unwrap();
    assert!(choices.path.is_some() && choices.own_robot.is_none());
    assert_eq!((choices.robot.as_deref(), choices.planner.as_deref()), (Some("dvr1"), Some("subgoal_sweep")));
    assert!(choices.params.is_empty());
    change(&mut board, |settings| settings.body = BodyChoice::Circle { radius: 0.2 });
    plan(&mut board).unwrap();
    let choices = board.import(true).unwrap().choices.unwrap();
    assert_eq!(
        (choices.robot.as_deref(), choices.own_robot.as_deref()),
        (Some("octagon"), Some("radius:0.2,tool:body"))
    );
}

#[test]
fn whatever_the_page_says_stays_within_what_is_possible() {
    let mut board = open(image());
    change(&mut board, |settings| {
        *settings = FloorPlanSettings {
            metre: None,
            gap: 1e9,
            resolution: -1.0,
            shade: 7.0,
            cell: 0.0,
            headings: 0,
            scan_width: Some(-3.0),
            part: DrawingPart::Polygon { corners: vec![[f64::NAN, 0.0]] },
            ..settings.clone()
        }
    });
    let settings = board.settings();
    assert_eq!((settings.metre, settings.gap, settings.shade, settings.headings), (Some(0.05), 1.5, 1.0, 1));
    assert!(settings.resolution > 0.0 && settings.cell > 0.0 && settings.scan_width.is_none());
}

#[test]
fn cells_that_no_map_has_are_refused_and_the_width_stays() {
    let mut board = open(image());
    for metre in [0.0, -0.05, 0.000_999, 100.1, f64::NAN, f64::INFINITY] {
        let error = board.set(FloorPlanSettings { metre: Some(metre), ..board.settings().clone() }).unwrap_err();
        assert!(error.contains("0.1 to 10000 cm"), "{error}");
        assert_eq!(board.settings().metre, Some(0.05));
    }
    for metre in [0.001, 100.0] {
        change(&mut board, |settings| settings.metre = Some(metre));
        assert_eq!(board.room().unwrap().plan.resolution, metre);
    }
    let mut drawing = furnished(None);
    assert!(drawing.view().words.contains("unit not chosen yet"));
    change(&mut drawing, |settings| settings.metre = Some(0.000_001));
    change(&mut drawing, |settings| settings.metre = Some(-1.0));
    assert_eq!(drawing.settings().metre, Some(0.000_001), "the unit of a drawing is no cell");
}

#[test]
fn a_slice_too_large_for_a_picture_is_coarser_and_free_only_where_all_of_it_is() {
    let mut free = Grid::filled(7, 4, true);
    free.values_mut()[6] = false;
    free.values_mut()[7 + 2] = false;
    let (grid, times) = coarse(free.clone(), 3);
    assert_eq!((grid.width(), grid.height(), times), (3, 2, 3));
    assert_eq!(grid.values(), [false, true, false, true, true, true]);
    assert_eq!(coarse(free.clone(), 7), (free, 1), "one that fits stays");
}

#[test]
fn a_refusal_lists_the_accepted_formats_once() {
    for (name, text) in [("letter.txt", "Dear reader,\n"), ("empty.svg", "<svg xmlns='http://www.w3.org/2000/svg'/>")] {
        let error = DrawingSession::open(&[file(name, text)]).err().unwrap();
        let why = error.with_formats();
        assert_eq!(why.matches(TAKEN).count(), 1, "{why}");
        assert!(why.starts_with(error.to_string().trim_end_matches('.')), "{why}");
    }
}

#[test]
fn two_files_that_do_not_belong_together_are_refused() {
    let error = DrawingSession::open(&[image(), file("map.txt", "...\n...\n")]).err().unwrap().to_string();
    assert!(error.contains("scan.pgm") && error.contains("map.txt"), "{error}");
}

/// A polyline: its layer, whether it is closed, its corners.
type Polyline = (&'static str, bool, &'static [(f64, f64)]);

const ROOM: Polyline = ("WALLS", true, &[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]);
const TABLE: Polyline = ("TABLES", true, &[(1.0, 1.0), (2.0, 1.0), (2.0, 2.0), (1.0, 2.0)]);

/// A DXF of polylines.
fn dxf(name: &str, units: Option<u8>, strokes: &[Polyline]) -> SourceFile {
    let units = units.map_or_else(String::new, |units| format!("9\n$INSUNITS\n70\n{units}\n"));
    let polyline = |&(layer, is_closed, corners): &Polyline| {
        let corners: Vec<String> = corners.iter().map(|(x, y)| format!("10\n{x}\n20\n{y}\n")).collect();
        format!("0\nLWPOLYLINE\n8\n{layer}\n90\n{}\n70\n{}\n{}", corners.len(), u8::from(is_closed), corners.concat())
    };
    let entities: Vec<String> = strokes.iter().map(polyline).collect();
    let head = format!("0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n{units}0\nENDSEC\n");
    file(name, format!("{head}0\nSECTION\n2\nENTITIES\n{}0\nENDSEC\n0\nEOF\n", entities.concat()))
}

/// 4 x 3 with a table of 1 x 1, in metres if `units` is 6.
fn furnished(units: Option<u8>) -> DrawingSession {
    let mut board = open(dxf("room.dxf", units, &[ROOM, TABLE]));
    change(&mut board, |settings| settings.roles = vec![Role::Wall, Role::Obstacle]);
    board
}

fn plan(board: &mut DrawingSession) -> Result<(), String> {
    board.sweep(&mut |_| ControlFlow::Continue(()))
}

#[test]
fn walls_drawn_as_wide_lines_take_up_their_width() {
    for thick in [10.0, 24.0, 70.0] {
        // 8 x 6 m between the middles of the walls, with a partition from face to face that has a door of 0.9 m.
        let half = 0.5 * thick;
        let svg = format!(
            "<svg xmlns='http://www.w3.org/2000/svg' width='1000cm' height='800cm' viewBox='0 0 1000 800'>\
             <g id='walls' fill='none' stroke='#000' stroke-width='{thick}'><path d='M100 100H900V700H100Z'/>\
             <path d='M500 {}V400M500 490V{}'/></g></svg>",
            100.0 + half,
            700.0 - half,
        );
        let board = open(file("flat.svg", svg));
        let thick = 0.01 * thick;
        let floor = (8.0 - thick) * (6.0 - thick) - thick * (6.0 - thick - 0.9);
        let found = board.floor_m2();
        // A cell with a part of a wall is wall: less than one on each of its sides.
        assert!(found <= floor && found > floor - 0.05 * 41.0, "{thick} m: {found} for {floor} m²");
        let view = board.view();
        let room = view.room.unwrap();
        assert_eq!(
            (room.gaps, room.cut_off_m2, view.notice.as_str()),
            (0, 0.0, ""),
            "{thick} m: one floor, nothing to close"
        );
        assert!((room.width_m - (8.0 - thick)).abs() <= 0.1, "{thick} m: {}", room.width_m);
    }
}

#[test]
fn a_drawing_without_unit_is_no_room_before_one_is_chosen() {
    let mut board = furnished(None);
    let view = board.view();
    assert!(view.size.is_none() && view.room.is_none() && view.fault.is_empty());
    assert!(board.import(false).unwrap_err().contains("unit"));
    assert!(plan(&mut board).unwrap_err().contains("unit"));
    let sizes: Vec<&str> = view.units.iter().map(|unit| unit.size.as_str()).collect();
    assert_eq!(sizes, ["4 × 3 mm", "40 × 30 mm", "4.0 × 3.0 m", "102 × 76 mm", "1.2 × 0.9 m"]);
    change(&mut board, |settings| settings.metre = Some(1.0));
    assert!(board.view().room.is_some());
}

#[test]
fn floor_is_counted_without_what_stands_on_it_once() {
    let mut board = furnished(Some(6));
    let near =
        |board: &DrawingSession, floor: f64| assert!((board.floor_m2() - floor).abs() < 0.8, "{}", board.floor_m2());
    near(&board, 11.0);
    change(&mut board, |settings| settings.roles[1] = Role::Ignored);
    near(&board, 12.0);
}

#[test]
fn a_sweep_is_for_the_room_and_the_robot_that_it_was_planned_for() {
    let mut board = furnished(Some(6));
    plan(&mut board).unwrap();
    let view = board.view().sweep.unwrap();
    assert_eq!(view.subgoals[0], view.subgoals[1..].iter().sum::<usize>());
    assert!(view.subgoals[3] > 0 && view.collisions == view.resolved, "{view:?}");
    board.set(board.settings().clone()).unwrap();
    assert!(board.planned().is_some(), "nothing has changed");
    change(&mut board, |settings| settings.scan_width = Some(0.3));
    assert!(board.planned().is_none());
    plan(&mut board).unwrap();
    change(&mut board, |settings| settings.roles[1] = Role::Ignored);
    assert!(board.planned().is_none());
    plan(&mut board).unwrap();
    change(&mut board, |settings| settings.body = BodyChoice::Circle { radius: 0.1 });
    assert!(board.planned().is_none() && board.room().is_some());
}

#[test]
fn what_can_not_be_swept_says_why_and_leaves_the_room() {
    let mut board = furnished(Some(6));
    change(&mut board, |settings| settings.body = BodyChoice::Circle { radius: 4.0 });
    assert!(plan(&mut board).unwrap_err().contains("fits nowhere"));
    change(&mut board, |settings| settings.body = BodyChoice::Polygon { corners: "1 1; 2".into() });
    assert!(plan(&mut board).unwrap_err().contains("corner 2"));
    assert!(board.view().body_fault.contains("corner 2") && board.room().is_some());
}

#[test]
fn a_sweep_leaves_in_every_format() {
    let mut board = furnished(Some(6));
    assert!(board.export(PathFormat::Csv).unwrap_err().contains("plan the sweep"));
    plan(&mut board).unwrap();
    let text = |format| String::from_utf8(board.export(format).unwrap().bytes).unwrap();
    let drawing = text(PathFormat::Dxf);
    for layer in ["WALLS", "TABLES", "SWEEP_PATH", "SWEEP_SUBGOALS", "SWEEP_LINKS"] {
        assert!(drawing.contains(layer), "{layer}");
    }
    // It can be opened again, with the path at its place.
    let again = DrawingSession::open(&[file("again.dxf", drawing)]).unwrap();
    assert_eq!(again.view().size.as_deref(), Some("4.0 × 3.0 m"));
    assert!(text(PathFormat::Program).contains("MOVE"));
    assert!(text(PathFormat::Csv).starts_with("x_m,"));
    assert!(text(PathFormat::Poses).contains("poses"));
    assert!(text(PathFormat::Commands).lines().count() > 10);
}

#[test]
fn files_of_a_sweep_agree_on_where_it_begins() {
    let mut board = furnished(Some(6));
    change(&mut board, |settings| settings.part = DrawingPart::Rectangle { corners: [[1.0, 0.5], [4.0, 3.0]] });
    plan(&mut board).unwrap();
    let origin = board.room().unwrap().plan.origin;
    let at = origin.to_world(board.planned().unwrap().path[0]);
    assert!((at - board.planned().unwrap().path[0]).norm() > 0.5, "the drawing's frame is another: {origin}");
    let text = |format| String::from_utf8(board.export(format).unwrap().bytes).unwrap();
    for format in [PathFormat::Program, PathFormat::Commands] {
        let head = text(format);
        let start = head.lines().find_map(|line| line[1..].trim().strip_prefix("start     x ")).unwrap();
        let numbers: Vec<f64> = start.split([' ', ',']).filter_map(|word| word.parse().ok()).collect();
        let [x, y, heading] = numbers[..] else { panic!("{start}") };
        // To a tenth of a millimetre.
        assert!((x - at.x).abs() < 6e-5 && (y - at.y).abs() < 6e-5 && heading == 0.0, "{start}: {at}");
    }
    let row = format!("\n{:.4},{:.4},0.000000,0.0000,0.000\n", at.x, at.y);
    assert!(text(PathFormat::Csv).contains(&row), "{row}: {}", text(PathFormat::Csv));
    let position = format!("position: {{x: {:.4}, y: {:.4}, z: 0.0}}", at.x, at.y);
    assert!(text(PathFormat::Poses).contains(&position), "{position}");
}

#[test]
fn sweeps_of_a_room_and_of_the_whole_drawing_have_names_of_their_own() {
    let mut board = furnished(Some(6));
    plan(&mut board).unwrap();
    let whole = board.export(PathFormat::Csv).unwrap().name;
    change(&mut board, |settings| settings.part = DrawingPart::Rectangle { corners: [[1.0, 0.5], [4.0, 3.0]] });
    plan(&mut board).unwrap();
    let part = board.export(PathFormat::Csv).unwrap().name;
    assert!(whole.ends_with("-sweep.csv") && part.ends_with("-part-sweep.csv") && whole != part, "{whole} {part}");
}

#[test]
fn files_of_a_sweep_name_the_robot_that_it_was_planned_for() {
    let mut board = furnished(Some(6));
    let mut heads = |body: BodyChoice| {
        change(&mut board, |settings| settings.body = body);
        plan(&mut board).unwrap();
        [PathFormat::Program, PathFormat::Commands].map(|format| {
            let text = String::from_utf8(board.export(format).unwrap().bytes).unwrap();
            let is_comment = |line: &&str| line.starts_with([';', '#']);
            text.lines().take_while(is_comment).collect::<Vec<_>>().join("\n")
        })
    };
    let [program, bytes] = heads(BodyChoice::Octagon { width: 0.4 });
    assert!(
        program
            .starts_with("; planned   for an octagon, 0.400 m wide\n; robot     moves as the Omnidirectional octagon"),
        "{program}"
    );
    assert!(!program.contains("Roomba 600"), "{program}");
    assert!(
        bytes.starts_with("# planned   for an octagon, 0.400 m wide\n# runs on   Roomba 600 / Create 2, a circle of")
    );
    assert!(bytes.contains("not the robot"), "{bytes}");
    let [program, bytes] = heads(BodyChoice::Model { id: "roomba600".into() });
    assert!(program.contains("for the Roomba 600 / Create 2, a circle of") && program.contains("turns on the spot"));
    assert!(!bytes.contains("not the robot"), "{bytes}");
    let [program, _] = heads(BodyChoice::Circle { radius: 0.2 });
    assert!(program.contains("for a circle of 0.200 m radius\n; robot     moves as the Roomba"), "{program}");
}

/// A flat of two rooms of 3 m x 3 m with a door of 80 cm between them, and one of 3 m x 3 m beside them without a door.
const FLAT: [Polyline; 4] = [
    ("WALLS", true, &[(0.0, 0.0), (9.4, 0.0), (9.4, 3.0), (0.0, 3.0)]),
    ("WALLS", true, &[(3.0, 0.0), (3.2, 0.0), (3.2, 1.2), (3.0, 1.2)]),
    ("WALLS", true, &[(3.0, 2.0), (3.2, 2.0), (3.2, 3.0), (3.0, 3.0)]),
    ("WALLS", false, &[(6.2, 0.0), (6.2, 3.0)]),
];

#[test]
fn a_room_that_reaches_on_through_doors_says_so_and_how_to_close_them() {
    let mut board = open(dxf("flat.dxf", Some(6), &FLAT));
    assert_eq!(board.doors(), None, "nobody has marked a room");
    board.set_part(DrawingPart::Room { at: [1.0, 1.5] }).unwrap();
    let (both, doors) = (board.floor_m2(), board.doors().cloned().expect("there is a door"));
    assert!(both > 17.0 && doors.count == 1, "{both} {doors:?}");
    assert!((0.75..=1.0).contains(&doors.gap) && (8.0..9.5).contains(&doors.floor_m2), "{doors:?}");
    assert!(board.view().words.contains("an opening as wide as a door"), "{}", board.view().words);
    let rings: Vec<_> = board.marks().map(|mark| (mark.at, mark.width)).collect();
    assert!(
        matches!(rings[..], [(at, width)] if (at - Point::new(3.1, 1.6)).norm() < 0.15 && (0.7..1.0).contains(&width)),
        "{rings:?}"
    );
    change(&mut board, |settings| settings.gap = doors.gap);
    assert_eq!((board.floor_m2(), board.doors()), (doors.floor_m2, None));
    assert_eq!(board.marks().count(), 0);
    // A room without a door reaches nowhere.
    change(&mut board, |settings| settings.gap = 0.1);
    board.set_part(DrawingPart::Room { at: [8.0, 1.5] }).unwrap();
    assert_eq!(board.doors(), None);
}

#[test]
fn a_tree_beside_the_house_is_no_room() {
    let indoors = open(dxf("flat.dxf", Some(6), &FLAT));
    let tree: Polyline = ("TREES", true, &[(12.0, 1.0), (13.0, 1.0), (13.0, 2.0), (12.0, 2.0)]);
    let with_tree: Vec<Polyline> = FLAT.into_iter().chain([tree]).collect();
    let board = open(dxf("flat.dxf", Some(6), &with_tree));
    assert_eq!(board.floor_m2(), indoors.floor_m2());
    // In a garden whose wall is open, it isn't all that counts either.
    let garden: Polyline =
        ("WALLS", false, &[(-4.0, 0.0), (-4.0, 8.0), (16.0, 8.0), (16.0, -6.0), (-4.0, -6.0), (-4.0, -2.0)]);
    let mut board = open(dxf("garden.dxf", Some(6), &[garden, tree]));
    board.set_part(DrawingPart::Whole).unwrap();
    assert!(board.floor_m2() > 250.0, "{}", board.floor_m2());
}

#[test]
fn a_room_that_leads_outside_through_doors_says_one_thing() {
    // Two rooms with two doors, and the front door of the other one is open.
    let flat: [Polyline; 4] = [
        ("WALLS", false, &[(6.8, 0.0), (0.0, 0.0), (0.0, 3.0), (8.0, 3.0), (8.0, 0.0), (7.9, 0.0)]),
        ("WALLS", true, &[(4.0, 0.0), (4.1, 0.0), (4.1, 0.4), (4.0, 0.4)]),
        ("WALLS", true, &[(4.0, 1.2), (4.1, 1.2), (4.1, 1.8), (4.0, 1.8)]),
        ("WALLS", true, &[(4.0, 2.6), (4.1, 2.6), (4.1, 3.0), (4.0, 3.0)]),
    ];
    let mut board = open(dxf("open.dxf", Some(6), &flat));
    board.set_part(DrawingPart::Room { at: [1.0, 1.5] }).unwrap();
    let doors = board.doors().cloned().expect("there are doors");
    assert!(doors.count == 2 && (10.0..12.5).contains(&doors.floor_m2), "{doors:?}");
    assert_eq!(board.view().fault, "This room isn't closed: close its doors, or choose a rectangle.");
    assert!(board.mark().is_none() && board.marks().count() == 2, "both doors are ringed, and nothing else");
    change(&mut board, |settings| settings.gap = doors.gap);
    assert_eq!(board.view().fault, "");
}

#[test]
fn an_opening_that_is_wider_than_gaps_can_be_closed_says_what_can_be_done() {
    let hall: [Polyline; 1] =
        [("WALLS", false, &[(2.6, 3.0), (8.0, 3.0), (8.0, 0.0), (0.0, 0.0), (0.0, 3.0), (1.0, 3.0)])];
    let mut board = open(dxf("hall.dxf", Some(6), &hall));
    board.set_part(DrawingPart::Room { at: [4.0, 1.5] }).unwrap();
    let rings: Vec<_> = board.marks().collect();
    assert!(rings.len() == 1 && (rings[0].at - Point::new(1.8, 3.0)).norm() < 0.15, "{rings:?}");
    assert!((1.6..=1.75).contains(&rings[0].width), "{rings:?}");
    assert!(board.view().fault.ends_with("Choose Indoors or a rectangle."), "{}", board.view().fault);
    board.set_part(DrawingPart::Indoors).unwrap();
    let outer = board.view().closes.expect("Indoors can close it");
    change(&mut board, |settings| settings.outer = outer);
    assert!((22.0..24.0).contains(&board.floor_m2()), "{}", board.floor_m2());
}

#[test]
fn closing_a_room_s_door_leaves_the_passages_beside_a_bed_open() {
    // Two rooms, a door of 0.8 m, and a bed with 0.9 m on either side and more behind it.
    let flat: [Polyline; 4] = [
        ("WALLS", true, &[(0.0, 0.0), (9.0, 0.0), (9.0, 6.0), (0.0, 6.0)]),
        ("WALLS", true, &[(4.0, 0.0), (4.1, 0.0), (4.1, 1.0), (4.0, 1.0)]),
        ("WALLS", true, &[(4.0, 1.8), (4.1, 1.8), (4.1, 6.0), (4.0, 6.0)]),
        ("WALLS", true, &[(0.9, 3.0), (3.1, 3.0), (3.1, 4.6), (0.9, 4.6)]),
    ];
    let mut board = open(dxf("bedroom.dxf", Some(6), &flat));
    board.set_part(DrawingPart::Room { at: [1.0, 1.5] }).unwrap();
    let doors = board.doors().cloned().expect("there is a door");
    assert!((0.7..0.9).contains(&doors.gap) && (19.0..20.5).contains(&doors.floor_m2), "{doors:?}");
    change(&mut board, |settings| settings.gap = 1.0);
    assert!(board.floor_m2() < doors.floor_m2 - 3.0, "so wide a gap takes the passages, too: {}", board.floor_m2());
}

#[test]
fn a_map_that_is_swept_leaves_as_a_drawing_with_its_walls() {
    let head = "#".repeat(20);
    let inside = "#..................#\n".repeat(18);
    let mut board = open(file("map.txt", format!("; resolution 0.1\n{head}\n{inside}{head}\n")));
    plan(&mut board).unwrap();
    let drawing = board.export(PathFormat::Dxf).unwrap();
    let again = DrawingSession::open(&[SourceFile { name: drawing.name, bytes: drawing.bytes }]).unwrap();
    let layers: Vec<String> = again.view().layers.into_iter().map(|layer| layer.name).collect();
    assert_eq!(again.view().size.as_deref(), Some("1.8 × 1.8 m"), "the floor within its walls, in metres");
    assert!(["WALLS", "SWEEP_PATH"].iter().all(|name| layers.iter().any(|layer| layer == name)), "{layers:?}");
}

#[test]
fn only_a_dxf_is_what_an_exported_drawing_begins_with() {
    const MARK: &str = "\u{feff}";
    let svg = "<svg xmlns='http://www.w3.org/2000/svg' width='4m' viewBox='0 0 4 3'><rect width='4' height='3' stroke='#000'/></svg>";
    let geojson = r#"{"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]]]}"#;
    let drawing = dxf("room.dxf", Some(6), &[ROOM]);
    for (name, content, is_dxf) in [
        ("room.svg", svg.as_bytes(), false),
        ("room.geojson", geojson.as_bytes(), false),
        ("room.dxf", drawing.bytes.as_slice(), true),
    ] {
        for mark in ["", MARK] {
            let board = open(file(name, [mark.as_bytes(), content].concat()));
            let DrawingSource::Drawing { original, .. } = board.source() else { panic!("{name} is no drawing") };
            assert_eq!(original.is_some(), is_dxf, "{name} with mark {mark:?}");
        }
    }
}

#[test]
fn the_part_that_is_meant_is_cut_out_and_a_part_outside_says_so() {
    let mut board = furnished(Some(6));
    board.set_part(DrawingPart::Rectangle { corners: [[4.0, 3.0], [2.5, 0.0]] }).unwrap();
    assert!((board.floor_m2() - 4.5).abs() < 0.5, "{}", board.floor_m2());
    board.set_part(DrawingPart::Room { at: [100.0, 100.0] }).unwrap();
    assert!(board.room().is_none() && !board.fault().is_empty());
    board.set_part(DrawingPart::Whole).unwrap();
    assert!(board.room().is_some() && board.fault().is_empty());
}

#[test]
fn the_sample_drawing_is_a_flat_in_millimetres() {
    let board = open(file("sample.dxf", include_bytes!("../../www/floor-plan/sample.dxf")));
    let view = board.view();
    assert_eq!(view.settings.metre, Some(0.001));
    let roles: Vec<(&str, Role)> = view.layers.iter().map(|layer| (layer.name.as_str(), layer.role)).collect();
    for role in
        [("WALLS", Role::Wall), ("FURNITURE", Role::Obstacle), ("DOORS", Role::Ignored), ("DIMENSIONS", Role::Ignored)]
    {
        assert!(roles.contains(&role), "{roles:?}");
    }
    let room = view.room.unwrap();
    assert!(room.floor_m2 > 30.0 && room.floor_m2 < 60.0 && room.objects > 20, "{room:?}");
}

#[test]
fn what_was_drawn_here_is_no_wall_when_it_is_opened_again() {
    let mut board = furnished(Some(6));
    plan(&mut board).unwrap();
    let floor = |board: &DrawingSession| board.view().room.map(|room| room.floor_m2);
    let drawing = board.export(PathFormat::Dxf).unwrap();
    let again = DrawingSession::open(&[SourceFile { name: drawing.name, bytes: drawing.bytes }]).unwrap();
    assert!(floor(&board).is_some());
    assert_eq!(floor(&again), floor(&board));
}

#[test]
fn the_path_of_a_room_that_was_saved_as_svg_is_no_wall_when_it_is_opened() {
    let plan = (room("flat").unwrap().build)();
    let path = [Point::new(1.0, 1.0), Point::new(9.0, 1.0), Point::new(9.0, 1.2), Point::new(1.0, 1.2)];
    let floor = |path: &[Point]| open(file("flat.svg", to_svg(&plan, path))).floor_m2();
    assert_eq!(floor(&path), floor(&[]), "the path is no wall");
    // Solid blocks of wall, too, come back; cells that an outline touches are wall.
    let free = plan.blocked().map(|&blocked| !blocked).count() as f64 * plan.resolution * plan.resolution;
    assert!((0.9..1.0).contains(&(floor(&[]) / free)), "{} of {free} m²", floor(&[]));
}

#[test]
fn walls_that_are_painted_as_areas_are_solid_and_rooms_may_be_painted_over_them() {
    let floor = |body: &str| {
        let svg = format!("<svg xmlns='http://www.w3.org/2000/svg' width='800cm' viewBox='0 0 800 600'>{body}</svg>");
        open(file("flat.svg", svg)).floor_m2()
    };
    // 6 x 4 m in walls of 0.5 m, with a pillar of 1 x 1 m: as one area with holes, as a house with light rooms in it, and as outlines.
    let holes = floor(
        "<path d='M50 50H750V550H50ZM100 100V500H700V100Z M300 200H400V300H300Z' fill-rule='evenodd' fill='#222'/>",
    );
    let house = floor(
        "<rect x='50' y='50' width='700' height='500' fill='#222'/><rect x='100' y='100' width='600' height='400' fill='#eee'/>\
                       <rect x='300' y='200' width='100' height='100' fill='#222'/>",
    );
    for (found, what) in [(holes, "an area with holes"), (house, "a room on a house")] {
        assert!((found - 23.0).abs() < 1.2, "{what}: {found} m²");
    }
    let outlines = floor("<g fill='none' stroke='#222'><rect x='100' y='100' width='600' height='400'/></g>");
    assert!((outlines - 24.0).abs() < 1.2, "lines alone enclose floor: {outlines} m²");
}
