//! The drawing board: what comes of files, choices and the hand, without a browser.

use robovac_playground::{
    app::draft::{Board, BodyChoice, Part, Settings, Tool},
    floorplan::SourceFile,
    geometry::Point,
    grid::Occupancy,
};

fn file(name: &str, content: impl Into<Vec<u8>>) -> SourceFile {
    SourceFile { name: name.into(), bytes: content.into() }
}

/// A grey image of 4 x 2 pixels: wall, dark grey, light grey, floor in each row.
fn image() -> SourceFile {
    let mut bytes = b"P5\n4 2\n255\n".to_vec();
    bytes.extend([0, 100, 160, 255, 0, 100, 160, 255]);
    file("scan.pgm", bytes)
}

fn open(file: SourceFile) -> Board {
    Board::open(&[file]).unwrap()
}

fn change(board: &mut Board, what: impl FnOnce(&mut Settings)) {
    let mut settings = board.settings().clone();
    what(&mut settings);
    board.set(settings);
}

fn cells(board: &Board) -> Vec<Occupancy> {
    board.room().unwrap().plan.occupancy.values()[..4].to_vec()
}

#[test]
fn an_image_is_five_centimetres_a_pixel_until_somebody_knows_better() {
    let mut board = open(image());
    assert_eq!(board.view().size.as_deref(), Some("200 × 100 mm"));
    assert!(!board.view().says_unit && board.view().is_scalable);
    board.hand.take(Tool::Scale);
    board.hand.click(Point::new(0.0, 1.0), 0.01);
    board.hand.click(Point::new(4.0, 1.0), 0.01);
    assert_eq!(board.measured_m(), Some(0.2));
    board.scale_to(8.0).unwrap();
    assert_eq!(board.room().unwrap().plan.resolution, 2.0);
    assert_eq!((board.view().size.as_deref(), board.view().tool), (Some("8.0 × 4.0 m"), Tool::View));
}

#[test]
fn a_distance_of_nothing_changes_nothing() {
    let mut board = open(image());
    assert!(board.scale_to(1.0).unwrap_err().contains("two points"));
    board.hand.take(Tool::Scale);
    board.hand.click(Point::new(0.0, 1.0), 0.01);
    board.hand.click(Point::new(4.0, 1.0), 0.01);
    for metres in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(board.scale_to(metres).is_err(), "{metres}");
    }
    assert_eq!(board.settings().metre, Some(0.05));
}

#[test]
fn shades_are_wall_where_they_are_darker_than_said() {
    let mut board = open(image());
    use Occupancy::{Free, Occupied, Unknown};
    assert_eq!(cells(&board), [Occupied, Unknown, Unknown, Free], "the rules of the map server");
    change(&mut board, |settings| settings.shade = 0.5);
    assert_eq!(cells(&board), [Occupied, Occupied, Free, Free]);
    change(&mut board, |settings| settings.shade = 0.3);
    assert_eq!(cells(&board), [Occupied, Free, Free, Free]);
    change(&mut board, |settings| settings.negate = true);
    assert_eq!(cells(&board), [Free, Occupied, Occupied, Occupied]);
    change(&mut board, |settings| settings.shade = 0.0);
    assert!(board.room().is_none() && board.fault().contains("no free cell"), "{}", board.fault());
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
    let mut board = open(file("mine.json", SCENARIO));
    change(&mut board, |settings| settings.body = BodyChoice::Model { id: "dvr1".into() });
    let choices = board.import(true).unwrap().choices.unwrap();
    assert_eq!((choices.robot.as_deref(), choices.planner.as_deref()), (Some("dvr1"), Some("subgoal_sweep")));
    assert!(choices.params.is_empty());
    change(&mut board, |settings| settings.body = BodyChoice::Circle { radius: 0.2 });
    let choices = board.import(true).unwrap().choices.unwrap();
    assert_eq!(choices.robot.as_deref(), Some("octagon"), "that of the scenario");
}

#[test]
fn whatever_the_page_says_stays_within_what_is_possible() {
    let mut board = open(image());
    change(&mut board, |settings| {
        *settings = Settings {
            metre: Some(f64::NAN),
            gap: 1e9,
            resolution: -1.0,
            shade: 7.0,
            cell: 0.0,
            headings: 0,
            scan_width: Some(-3.0),
            part: Part::Polygon { corners: vec![[f64::NAN, 0.0]] },
            ..settings.clone()
        }
    });
    let settings = board.settings();
    assert_eq!((settings.metre, settings.gap, settings.shade, settings.headings), (None, 1.5, 1.0, 1));
    assert!(settings.resolution > 0.0 && settings.cell > 0.0 && settings.scan_width.is_none());
    assert!(board.description().contains("unit isn't known"));
}

#[test]
fn two_files_that_do_not_belong_together_are_refused() {
    let error = Board::open(&[image(), file("map.txt", "...\n...\n")]).err().unwrap().to_string();
    assert!(error.contains("scan.pgm") && error.contains("map.txt"), "{error}");
}
