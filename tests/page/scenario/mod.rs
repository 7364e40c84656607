//! Scenario files: accepted and refused ones with their errors, and agreement with the schema.

mod schema;

use proptest::prelude::*;
use robovac_app::explore::Session;
use robovac_core::{
    floor_plan::{FloorPlan, MAX_CORNERS, MAX_OBJECTS, Object, ROOMS, Scenario, SourceFile, Who, load},
    geometry::{Point, Pose},
    program::{Program, ProgramKind, ProgramLanguage},
};
use serde_json::Value;

/// A room of 4 m x 3 m with a wall in the right part, and one of everything.
const SAMPLE: &str = r#"{
  "$schema": "scenario.schema.json",
  "format": "robovac-scenario",
  "version": 2,
  "name": "Nook",
  "resolution": 0.5,
  "width": 8,
  "height": 6,
  "rows": [
    "........",
    "........",
    "......#.",
    "......#.",
    "........",
    "........"
  ],
  "start": { "x": 1.25, "y": 1.25, "heading_deg": 90 },
  "objects": [
    { "furniture": { "outline": [[0, 2.5], [1.5, 2.5], [1.5, 3], [0, 3]] } },
    { "leg": { "at": [2, 0.5], "radius": 0.02 } },
    { "drop_off": { "outline": [[3, 0], [4, 0], [4, 0.5]] } },
    { "carpet": { "outline": [[2, 2], [2.5, 2], [2.5, 3], [2, 3]] } },
    { "dirt": { "at": [0.5, 2], "radius": 0.25 } },
    { "dock": { "x": 0, "y": 0.75, "heading_deg": 0 } },
    { "virtual_wall": { "x": 1.75, "y": 3, "heading_deg": -90, "length": 1.5 } },
    { "mover": { "who": "pet", "path": [[0.5, 0.5], [2.5, 1.5]] } }, { "low_obstacle": { "outline": [[3, 2], [3.5, 2], [3.5, 2.25]], "height": 0.015 } }
  ],
  "robot": "roomba600",
  "behaviour": "bounce",
  "params": {},
  "cell_size": 0.15,
  "seed": 7,
  "slip": "typical",
  "noise": { "cliff": "harsh" },
  "quantised": true,
  "start_charge_percent": 40,
  "odometry": "straight"
}"#;

fn file(text: &str) -> SourceFile {
    SourceFile { name: "a.json".to_owned(), bytes: text.as_bytes().to_vec() }
}

fn read(text: &str) -> Result<FloorPlan, String> {
    load(&[file(text)]).map_err(|error| error.to_string())
}

/// The sample with something else in place of `from`, which must be there.
fn with(from: &str, to: &str) -> String {
    assert_eq!(SAMPLE.matches(from).count(), 1, "{from}");
    SAMPLE.replace(from, to)
}

fn the_schema() -> Value {
    serde_json::from_str(include_str!("../../../docs/scenario.schema.json")).unwrap()
}

fn schema_complains(text: &str) -> Option<String> {
    let schema = the_schema();
    schema::complaint(&schema, &schema, &serde_json::from_str(text).unwrap())
}

#[test]
fn everything_in_a_scenario_is_read() {
    let point = Point::new;
    let plan = read(SAMPLE).unwrap();
    assert_eq!(
        plan.objects[1..],
        [
            Object::Leg { at: point(2.0, 0.5), radius: 0.02 },
            Object::DropOff { outline: vec![point(3.0, 0.0), point(4.0, 0.0), point(4.0, 0.5)] },
            Object::Carpet { outline: vec![point(2.0, 2.0), point(2.5, 2.0), point(2.5, 3.0), point(2.0, 3.0)] },
            Object::Dirt { at: point(0.5, 2.0), radius: 0.25 },
            Object::Dock { pose: Pose::new(0.0, 0.75, 0.0) },
            Object::VirtualWall { pose: Pose::new(1.75, 3.0, -std::f64::consts::FRAC_PI_2), length: 1.5 },
            Object::Mover { who: Who::Pet, path: vec![point(0.5, 0.5), point(2.5, 1.5)] },
            Object::LowObstacle { outline: vec![point(3.0, 2.0), point(3.5, 2.0), point(3.5, 2.25)], height: 0.015 },
        ]
    );
    let mut session = Session::new();
    session.load(&[file(SAMPLE)]).unwrap();
    let view = session.view();
    assert_eq!(
        (view.algorithm, view.robot, view.seed, view.slip, view.odometry),
        ("bounce", "roomba600", 7, "typical", "straight")
    );
    assert!(session.link().contains("noise.cliff=harsh&quantised=true&charge=40"), "{}", session.link());
    assert_eq!(*session.plan().as_ref(), plan);
}

#[test]
fn what_a_session_writes_brings_back_the_same_run() {
    let mut first = Session::new();
    first.load(&[file(SAMPLE)]).unwrap();
    let written = first.scenario_json();
    let mut second = Session::new();
    second.restore("room=empty&noise=typical&quantised=true&slip=harsh").unwrap();
    second.load(&[file(&written)]).unwrap();
    assert_eq!(second.scenario_json(), written);
    assert_eq!(second.link(), first.link());
    for session in [&mut first, &mut second] {
        session.run_ahead(60.0);
    }
    let digest = |session: &Session| session.recording().unwrap().run().digest();
    assert_eq!(digest(&first), digest(&second));
}

#[test]
fn files_are_laid_out_for_people() {
    let text = Scenario::of(&read(SAMPLE).unwrap()).to_json();
    assert!(
        text.starts_with(
            "{\n  \"$schema\": \"scenario.schema.json\",\n  \"format\": \"robovac-scenario\",\n  \"version\": 2,"
        ),
        "{text}"
    );
    assert!(text.contains("\n    \"......#.\",\n"), "{text}");
    assert!(text.contains("\n    { \"dock\": { \"x\": 0.0, \"y\": 0.75, \"heading_deg\": 0.0 } },\n"), "{text}");
    assert!(
        text.contains(
            "\n    { \"virtual_wall\": { \"x\": 1.75, \"y\": 3.0, \"heading_deg\": -90.0, \"length\": 1.5 } },\n"
        ),
        "{text}"
    );
}

#[test]
fn version_1_means_what_it_meant() {
    let old = r#"{ "format": "robovac-scenario", "version": 1, "name": "Nook", "resolution": 0.2, "width": 3, "height": 2,
        "rows": ["...", "..#"], "start": { "x": 0.3, "y": 0.1 }, "robot": "cell", "planner": "snake", "cell_size": 0.2, "seed": 7 }"#;
    let mut session = Session::new();
    session.restore("room=empty&slip=typical&noise=harsh").unwrap();
    session.load(&[file(old)]).unwrap();
    let view = session.view();
    assert_eq!((view.algorithm, view.robot, view.seed), ("snake", "cell", 7));
    assert_eq!(view.slip, "typical", "what it doesn't mention stays");
    assert!(session.plan().objects.is_empty());
    assert_eq!(schema_complains(old), None);
}

/// A change of the sample, and what is said about it.
type Case = (&'static str, &'static str, &'static str);

fn assert_refused(cases: &[Case], read: impl Fn(&str) -> Option<String>) {
    let mut wrong = Vec::new();
    for (from, to, expected) in cases {
        let said = read(&with(from, to)).unwrap_or_else(|| panic!("{to} was taken"));
        if said != *expected {
            wrong.push(format!("said: {said}\ninstead of {expected}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Refusals that a schema can express, too, so it must.
const STRUCTURE: &[Case] = &[
    (
        "\"version\": 2",
        "\"version\": 3",
        "\"a.json\", line 4, column 14, version: this scenario has version 3, but this program reads 1 and 2; reload the page or update the program",
    ),
    (
        "\"version\": 2",
        "\"version\": \"2\"",
        "\"a.json\", line 4, column 16, version: this scenario has version \"2\", but this program reads 1 and 2; reload the page or update the program",
    ),
    (
        "\"version\": 2,",
        "",
        "\"a.json\", line 38, column 1: missing field `version`; fix that line or export the file again",
    ),
    (
        "\"name\": \"Nook\"",
        "\"title\": \"Nook\"",
        "\"a.json\", line 5, column 9, title: unknown field `title`, expected one of `$schema`, `format`, `version`, `name`, `note`, `resolution`, `width`, `height`, `rows`, `origin`, `objects`, `start`, `robot`, `twin`, `own_robot`, `planner`, `behaviour`, `program`, `params`, `path`, `cell_size`, `cell_offset`, `seed`, `slip`, `noise`, `quantised`, `start_charge_percent`, `odometry`, `smooth`; fix that line or export the file again",
    ),
    (
        "\"radius\": 0.02",
        "\"radius\": 0.02, \"colour\": \"red\"",
        "\"a.json\", line 20, column 55, objects[1].leg.colour: unknown field `colour`, expected `at` or `radius`; fix that line or export the file again",
    ),
    (
        "\"drop_off\"",
        "\"stairs\"",
        "\"a.json\", line 21, column 14, objects[2]: unknown variant `stairs`, expected one of `furniture`, `leg`, `low_obstacle`, `drop_off`, `carpet`, `dirt`, `dock`, `virtual_wall`, `mover`; fix that line or export the file again",
    ),
    (
        "\"quantised\": true",
        "\"quantised\": 1",
        "\"a.json\", line 35, column 16, quantised: invalid type: integer `1`, expected a boolean; fix that line or export the file again",
    ),
    (
        "\"start_charge_percent\": 40",
        "\"start_charge_percent\": 0",
        "\"a.json\", line 36, column 27, start_charge_percent: 0 is out of range; use a percentage from 1 to 100",
    ),
    (
        "\"width\": 8",
        "\"width\": 8.5",
        "\"a.json\", line 7, column 14, width: invalid type: floating point `8.5`, expected a whole number; fix that line or export the file again",
    ),
    (
        "\"width\": 8",
        "\"width\": 4097",
        "\"a.json\", line 7, column 15, width: 4097 cells are too many, the limit is 4096; crop the room or save it at a coarser resolution",
    ),
    (
        "\"resolution\": 0.5",
        "\"resolution\": -0.5",
        "\"a.json\", line 6, column 20, resolution: -0.5 is out of range; use metres per cell from 0.001 to 100",
    ),
    (
        "\"resolution\": 0.5",
        "\"resolution\": 1e999",
        "\"a.json\", line 6, column 21, resolution: number out of range; fix that line or export the file again",
    ),
    (
        "......#.\",\n    \"......#.\",",
        "......#.\",\n    \"......S.\",",
        "\"a.json\", line 13, column 14, rows[3]: a cell can't be \"S\"; write # for wall, . for floor or ? for unknown",
    ),
    (
        "\"radius\": 0.02",
        "\"radius\": -0.02",
        "\"a.json\", line 20, column 46, objects[1].leg.radius: -0.02 is out of range; use metres from 0.005 to 5",
    ),
    (
        "\"radius\": 0.02",
        "\"radius\": 0",
        "\"a.json\", line 20, column 42, objects[1].leg.radius: 0 is out of range; use metres from 0.005 to 5",
    ),
    (
        "\"radius\": 0.02",
        "\"radius\": \"thin\"",
        "\"a.json\", line 20, column 47, objects[1].leg.radius: invalid type: string \"thin\", expected a number; fix that line or export the file again",
    ),
    (
        ", \"radius\": 0.02",
        "",
        "\"a.json\", line 20, column 31, objects[1].leg: missing field `radius`; fix that line or export the file again",
    ),
    (
        "\"radius\": 0.25",
        "\"radius\": 1e999",
        "\"a.json\", line 23, column 47, objects[4].dirt.radius: number out of range; fix that line or export the file again",
    ),
    (
        "\"length\": 1.5",
        "\"length\": 100",
        "\"a.json\", line 25, column 76, objects[6].virtual_wall.length: 100 is out of range; use metres from 0.1 to 20",
    ),
    (
        "\"heading_deg\": -90",
        "\"heading_deg\": 900",
        "\"a.json\", line 25, column 61, objects[6].virtual_wall.heading_deg: 900 is out of range; use degrees from -360 to 360",
    ),
    (
        "\"heading_deg\": 90 }",
        "\"heading_deg\": 900 }",
        "\"a.json\", line 17, column 53, start.heading_deg: 900 is out of range; use degrees from -360 to 360",
    ),
    (
        "[[3, 0], [4, 0], [4, 0.5]]",
        "[[3, 0], [4, 0]]",
        "\"a.json\", line 21, column 32, objects[2].drop_off.outline: there are 2 corners, but at least 3 are needed; add the missing ones",
    ),
    (
        "[[3, 0], [4, 0], [4, 0.5]]",
        "[[3, 0], [4, 0], [4]]",
        "\"a.json\", line 21, column 51, objects[2].drop_off.outline[2]: invalid length 1, expected an array of length 2; fix that line or export the file again",
    ),
    (
        "[[0.5, 0.5], [2.5, 1.5]]",
        "[]",
        "\"a.json\", line 26, column 41, objects[7].mover.path: there are 0 points, but at least 1 are needed; add the missing ones",
    ),
    (
        "\"who\": \"pet\"",
        "\"who\": \"elephant\"",
        "\"a.json\", line 26, column 34, objects[7].mover.who: unknown variant `elephant`, expected `person` or `pet`; fix that line or export the file again",
    ),
    (
        "\"behaviour\": \"bounce\"",
        "\"behaviour\": \"bounce\", \"planner\": \"snake\"",
        "\"a.json\", line 29, column 23, behaviour: a robot follows either a planner or a behaviour; remove \"planner\" or \"behaviour\"",
    ),
];

/// Refusals for which one has to look at the room.
const WORLD: &[Case] = &[
    (
        "\"height\": 6",
        "\"height\": 5",
        "\"a.json\", line 10, column 4, rows: found 6, but \"height\" is 5; correct \"height\" or the rows",
    ),
    (
        "......#.\",\n    \"......#.\",",
        "......#.\",\n    \"......#\",",
        "\"a.json\", line 13, column 13, rows[3]: found 7, but \"width\" is 8; correct \"width\" or the rows",
    ),
    (
        "\"x\": 1.25, \"y\": 1.25",
        "\"x\": 1.25, \"y\": 3.25",
        "\"a.json\", line 17, column 13, start: the start at (1.250 m, 3.250 m) lies outside the room, which is 4.00 m x 3.00 m; move it inside",
    ),
    (
        "\"x\": 1.25, \"y\": 1.25",
        "\"x\": 3.25, \"y\": 1.25",
        "\"a.json\", line 17, column 13, start: the start at (3.250 m, 1.250 m) lies in a wall or unknown floor; move it to free floor",
    ),
    (
        "\"x\": 1.25, \"y\": 1.25",
        "\"x\": 1.25, \"y\": 2.75",
        "\"a.json\", line 17, column 13, start: the start at (1.250 m, 2.750 m) lies in furniture; move it to free floor",
    ),
    (
        "\"x\": 1.25, \"y\": 1.25",
        "\"x\": 2.01, \"y\": 0.5",
        "\"a.json\", line 17, column 13, start: the start at (2.010 m, 0.500 m) lies in a leg; move it to free floor",
    ),
    (
        "\"x\": 1.25, \"y\": 1.25",
        "\"x\": 3.75, \"y\": 0.25",
        "\"a.json\", line 17, column 13, start: the start at (3.750 m, 0.250 m) lies in a drop-off; move it to free floor",
    ),
    (
        "\"at\": [2, 0.5]",
        "\"at\": [4.5, 0.5]",
        "\"a.json\", line 20, column 22, objects[1].leg.at: the leg at (4.500 m, 0.500 m) lies outside the room, which is 4.00 m x 3.00 m; move it inside",
    ),
    (
        "\"at\": [0.5, 2]",
        "\"at\": [0.5, -0.01]",
        "\"a.json\", line 23, column 23, objects[4].dirt.at: the dirt at (0.500 m, -0.010 m) lies outside the room, which is 4.00 m x 3.00 m; move it inside",
    ),
    (
        "[1.5, 3], [0, 3]]",
        "[1.5, 3.5], [0, 3]]",
        "\"a.json\", line 19, column 56, objects[0].furniture.outline[2]: the point at (1.500 m, 3.500 m) lies outside the room, which is 4.00 m x 3.00 m; move it inside",
    ),
    (
        "[[2, 2], [2.5, 2], [2.5, 3], [2, 3]]",
        "[[2, 2], [2.5, 2], [2, 3], [2.5, 3]]",
        "\"a.json\", line 22, column 30, objects[3].carpet.outline: the outline crosses itself: the edge from corner 1 meets the one from corner 3; list the corners in order around the outline",
    ),
    (
        "[[2, 2], [2.5, 2], [2.5, 3], [2, 3]]",
        "[[2, 2], [2.5, 2], [3, 2]]",
        "\"a.json\", line 22, column 30, objects[3].carpet.outline: the outline crosses itself: the edge from corner 0 meets the one from corner 2; list the corners in order around the outline",
    ),
    (
        "[[2, 2], [2.5, 2], [2.5, 3], [2, 3]]",
        "[[2, 2], [2.005, 2], [2.005, 2.005]]",
        "\"a.json\", line 22, column 30, objects[3].carpet.outline: the outline encloses no floor; move its corners apart",
    ),
    (
        "\"x\": 0, \"y\": 0.75",
        "\"x\": -0.1, \"y\": 0.75",
        "\"a.json\", line 24, column 16, objects[5].dock: the dock at (-0.100 m, 0.750 m) lies outside the room, which is 4.00 m x 3.00 m; move it inside",
    ),
    (
        "\"x\": 0, \"y\": 0.75",
        "\"x\": 3.25, \"y\": 1.25",
        "\"a.json\", line 24, column 16, objects[5].dock: the dock at (3.250 m, 1.250 m) faces a wall or unknown floor; put its back to a wall so that it faces the room",
    ),
    (
        "\"x\": 0, \"y\": 0.75",
        "\"x\": 0.5, \"y\": 2.75",
        "\"a.json\", line 24, column 16, objects[5].dock: the dock at (0.500 m, 2.750 m) faces furniture; put its back to a wall so that it faces the room",
    ),
    (
        "\"heading_deg\": -90",
        "\"heading_deg\": 90",
        "\"a.json\", line 25, column 24, objects[6].virtual_wall: the virtual wall at (1.750 m, 3.000 m) faces a wall or unknown floor; put its back to a wall so that it faces the room",
    ),
    (
        "[[0.5, 0.5], [2.5, 1.5]]",
        "[[0.5, 0.5], [2.5, 4.5]]",
        "\"a.json\", line 26, column 53, objects[7].mover.path[1]: the point at (2.500 m, 4.500 m) lies outside the room, which is 4.00 m x 3.00 m; move it inside",
    ),
    (
        "[[0.5, 0.5], [2.5, 1.5]]",
        "[[0.5, 1.25], [3.75, 1.25]]",
        "\"a.json\", line 26, column 54, objects[7].mover.path[1]: the path crosses a wall at (3.00 m, 1.25 m); add points to lead it around",
    ),
    (
        "[[0.5, 0.5], [2.5, 1.5]]",
        "[[3.25, 1.25]]",
        "\"a.json\", line 26, column 41, objects[7].mover.path[0]: the path crosses a wall at (3.25 m, 1.25 m); add points to lead it around",
    ),
];

/// Refusals for which one has to know robots and algorithms; what there are instead is left out here.
const SESSION: &[Case] = &[
    ("\"roomba600\"", "\"mop\"", "the scenario can't be run: robot: there is no robot \"mop\""),
    ("\"bounce\"", "\"snake\"", "the scenario can't be run: behaviour: there is no behaviour \"snake\""),
    (
        "\"params\": {}",
        "\"params\": { \"rate\": 1 }",
        "the scenario can't be run: params.rate: there is no parameter \"rate\"",
    ),
    ("\"seed\": 7", "\"seed\": 4294967296", "the scenario can't be run: seed: the seed can't be \"4294967296\""),
    ("\"cell_size\": 0.15", "\"cell_size\": 0", "the scenario can't be run: cell_size: the cell size can't be \"0\""),
    ("\"cell_size\": 0.15", "\"cell_size\": 3", "the scenario can't be run: cell_size: the cell size can't be \"3\""),
    ("\"typical\"", "\"icy\"", "the scenario can't be run: slip: there is no slip \"icy\""),
    (
        "\"cliff\": \"harsh\"",
        "\"cliff\": \"wild\"",
        "the scenario can't be run: noise.cliff: there is no noise level \"wild\"",
    ),
    (
        "\"cliff\": \"harsh\"",
        "\"nose\": \"harsh\"",
        "the scenario can't be run: noise.nose: there is no sensor \"nose\"",
    ),
    ("\"straight\"", "\"guess\"", "the scenario can't be run: odometry: there is no odometry model \"guess\""),
];

#[test]
fn what_a_file_cannot_be_made_of_is_refused_and_the_schema_agrees() {
    assert_refused(STRUCTURE, |text| read(text).err());
    for (from, to, _) in STRUCTURE {
        if let Ok(value) = serde_json::from_str::<Value>(&with(from, to)) {
            let schema = the_schema();
            assert!(schema::complaint(&schema, &schema, &value).is_some(), "the schema takes {to}");
        }
    }
}

#[test]
fn what_a_room_cannot_hold_is_refused() {
    assert_refused(WORLD, |text| read(text).err());
}

#[test]
fn what_a_session_cannot_run_is_refused_and_nothing_changes() {
    let mut session = Session::new();
    let before = (session.scenario_json(), session.link());
    for (from, to, expected) in SESSION {
        let said = session.load(&[file(&with(from, to))]).expect_err(to).to_string();
        assert!(said.starts_with(expected), "{said}");
    }
    assert_eq!((session.scenario_json(), session.link()), before);
}

#[test]
fn size_limits_are_kept() {
    let objects = |count: usize| {
        let leg = r#"{ "leg": { "at": [2, 0.5], "radius": 0.02 } }"#;
        let all = vec![leg; count].join(", ");
        with(leg, &all)
    };
    // The sample has eight others.
    assert!(read(&objects(MAX_OBJECTS - 8)).is_ok());
    assert_eq!(
        read(&objects(MAX_OBJECTS - 7)).unwrap_err(),
        "\"a.json\", line 19, column 4, objects: there are 501 objects, but at most 500 are allowed; remove some"
    );
    assert!(schema_complains(&objects(MAX_OBJECTS - 7)).is_some());
    // Corners on a circle, as an outline and as a path.
    let points = |count: usize| {
        let point = |i: usize| {
            let angle = i as f64 / count as f64 * std::f64::consts::TAU;
            format!("[{}, {}]", 1.5 + 0.5 * angle.cos(), 2.0 + 0.5 * angle.sin())
        };
        (0..count).map(point).collect::<Vec<_>>().join(", ")
    };
    for (from, path, what) in [
        ("[2, 2], [2.5, 2], [2.5, 3], [2, 3]", "line 22, column 30, objects[3].carpet.outline", "corners"),
        ("[0.5, 0.5], [2.5, 1.5]", "line 26, column 40, objects[7].mover.path", "points"),
    ] {
        assert_eq!(read(&with(from, &points(MAX_CORNERS))).err(), None);
        let too_many = with(from, &points(MAX_CORNERS + 1));
        assert_eq!(
            read(&too_many).unwrap_err(),
            format!("\"a.json\", {path}: there are 201 {what}, but at most 200 are allowed; remove some")
        );
        assert!(schema_complains(&too_many).is_some());
    }
}

#[test]
fn version_1_has_no_keys_of_version_2() {
    for (key, value) in [
        ("objects", "[]"),
        ("behaviour", "\"bounce\""),
        ("slip", "\"none\""),
        ("noise", "{}"),
        ("quantised", "false"),
        ("start_charge_percent", "50"),
        ("odometry", "\"arc\""),
        ("smooth", "true"),
        ("own_robot", "{}"),
        ("path", "[[1, 1]]"),
        ("program", "{}"),
    ] {
        let text = format!(
            "{{ \"format\": \"robovac-scenario\", \"version\": 1, \"resolution\": 0.2, \"width\": 1, \"height\": 1,\n\
             \"rows\": [\".\"],\n \"{key}\": {value} }}"
        );
        let said = read(&text).unwrap_err();
        assert!(said.starts_with("\"a.json\", line 3, column "), "{said}");
        let end = format!("{key}: version 1 has no such key; write \"version\": 2, or remove the key");
        assert!(said.ends_with(&end), "{said}");
    }
}

#[test]
fn the_schema_takes_what_is_written() {
    let mut session = Session::new();
    session.load(&[file(SAMPLE)]).unwrap();
    let written = session.scenario_json();
    assert_eq!(schema_complains(&written), None);
    assert_eq!(schema_complains(SAMPLE), None);
    for room in ROOMS {
        assert_eq!(schema_complains(&Scenario::of(&(room.build)()).to_json()), None, "{}", room.id);
    }
    // Every key of the schema is written for the sample, but for those that say where room and robot came from, and where its cells begin:
    // in the corner.
    let written: Value = serde_json::from_str(&written).unwrap();
    let schema = the_schema();
    let keys = schema["properties"].as_object().unwrap().keys();
    let missing: Vec<_> = keys.filter(|key| written.get(key.as_str()).is_none()).collect();
    assert_eq!(missing, ["cell_offset", "note", "origin", "own_robot", "params", "path", "planner", "program", "twin"]);
    let kinds: Vec<_> = schema["$defs"]["object"]["properties"].as_object().unwrap().keys().collect();
    let objects = written["objects"].as_array().unwrap();
    let mut found: Vec<_> = objects.iter().flat_map(|object| object.as_object().unwrap().keys()).collect();
    found.sort();
    assert_eq!(found, kinds);
    // A program.
    let (language, kind) = (ProgramLanguage::JavaScript, ProgramKind::Planner);
    let program = Program { name: "Rows".into(), language, kind, source: "function* plan(room) {}".into() };
    session.set_program(program, true).unwrap();
    let written = session.scenario_json();
    assert_eq!(schema_complains(&written), None, "{written}");
    // An own robot with everything, and a path.
    let own =
        "corners:0.2_-0.15_0.2_0.15_-0.2_0,tool:0.25,speed:0.25,turn:90,at:0.02_0,wheels:omnidirectional,without:light";
    session.restore(&format!("room=empty&planner=snake&robot=roomba600&own={own}&path=ginBginBg99HAAwmhB")).unwrap();
    let written = session.scenario_json();
    assert_eq!(schema_complains(&written), None, "{written}");
    session.load(&[file(&written)]).unwrap();
    assert_eq!(session.scenario_json(), written);
}

/// Places in the sample where something is written over something else.
fn mutations() -> impl Strategy<Value = Vec<(usize, usize, String)>> {
    let piece = prop_oneof![
        Just("null".to_owned()),
        Just("[]".to_owned()),
        Just("{}".to_owned()),
        Just("1e999".to_owned()),
        Just("-1e308".to_owned()),
        Just("5e-324".to_owned()),
        Just("\"\"".to_owned()),
        Just("[[0, 0], [0, 0], [0, 0]]".to_owned()),
        (-1e4..1e4).prop_map(|number: f64| number.to_string()),
        "[\\[\\]{}:,\"0-9.e#-]{0,4}",
    ];
    proptest::collection::vec((0..SAMPLE.len(), 0..6_usize, piece), 1..4)
}

/// Numbers of the sample, where they begin and end.
fn numbers() -> Vec<(usize, usize)> {
    let is_digit = |c: u8| c.is_ascii_digit() || b"-.".contains(&c);
    let bytes = SAMPLE.as_bytes();
    let begins = (1..bytes.len()).filter(|&i| is_digit(bytes[i]) && b" [".contains(&bytes[i - 1]));
    begins.map(|begin| (begin, begin + bytes[begin..].iter().take_while(|&&c| is_digit(c)).count())).collect()
}

proptest! {
    #[test]
    fn mutated_scenarios_never_panic_and_what_is_taken_can_be_written(mutations in mutations()) {
        let mut text = SAMPLE.to_owned();
        for (at, length, piece) in mutations {
            let at = at.min(text.len());
            text.replace_range(at..(at + length).min(text.len()), &piece);
        }
        if let Ok(plan) = read(&text) {
            let again = read(&Scenario::of(&plan).to_json());
            prop_assert_eq!(again, Ok(plan));
        }
    }

}

proptest! {
    // Each opens a session.
    #![proptest_config(ProptestConfig::with_cases(60))]

    // slow: each number of a file is replaced by each that is wild
    #[test]
    fn wild_numbers_are_refused_or_survived(which in 0..60_usize, number in prop_oneof![
        -10.0..10.0_f64, Just(0.0), Just(-0.0), Just(f64::MAX), Just(f64::MIN_POSITIVE), Just(1e9), Just(-1e300)
    ]) {
        let numbers = numbers();
        let (begin, end) = numbers[which % numbers.len()];
        let mut text = SAMPLE.to_owned();
        text.replace_range(begin..end, &number.to_string());
        let mut session = Session::new();
        if session.load(&[file(&text)]).is_ok() {
            session.run_ahead(1.0);
            let written = session.scenario_json();
            prop_assert_eq!(schema_complains(&written), None);
            prop_assert!(read(&written).is_ok(), "{}", written);
        }
    }
}

/// The example of docs/studies.md is read and agrees with its schema; what the reader refuses, the schema does too.
#[test]
fn studies_agree_with_their_schema() {
    let page = include_str!("../../../docs/studies.md");
    let (_, example) = page.split_once("```json\n").unwrap();
    let (example, _) = example.split_once("```").unwrap();
    let schema: Value = serde_json::from_str(include_str!("../../../docs/study.schema.json")).unwrap();
    let complaint = |text: &str| schema::complaint(&schema, &schema, &serde_json::from_str(text).unwrap());
    assert_eq!(complaint(example), None);
    let study = robovac_sim::study::Study::read("study.json", example.as_bytes()).unwrap();
    assert!(study.runs() > 100);
    for (from, to) in [
        ("\"version\": 1", "\"version\": 2"),
        ("\"robots\"", "\"robot\""),
        ("\"count\": 10", "\"count\": 0"),
        ("\"minutes\": 20", "\"minutes\": 0"),
        ("\"slip\": \"typical\"", "\"slip\": \"icy\""),
    ] {
        assert!(example.contains(from), "{from}");
        let text = example.replacen(from, to, 1);
        assert!(complaint(&text).is_some(), "{to}");
        assert!(robovac_sim::study::Study::read("study.json", text.as_bytes()).is_err(), "{to}");
    }
}
