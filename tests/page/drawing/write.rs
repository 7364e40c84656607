//! Lines beside a drawing.

use super::support::{drawn, dxf, entities, file, pairs, strokes};
use floor_drawing::{Overlay, Role, outlines, read, to_dxf, trace};
use robovac_core::{
    floor_plan::{SourceFile, load},
    geometry::Point,
};

fn path() -> Vec<Point> {
    [(0.5, 0.25), (1.0 / 3.0, 7.0), (-2.0, 1e-7)].map(|(x, y)| Point::new(x, y)).to_vec()
}

fn overlay(layer: &str) -> Overlay {
    Overlay { layer: layer.to_owned(), colour: 1, lines: vec![path()] }
}

const LINE: &str = "0 LINE 5 1AF 8 WALL 10 0 20 0 11 1 21 0";

fn header(release: &str) -> String {
    format!("9 $ACADVER 1 {release} 9 $HANDSEED 5 200")
}

const TABLES: &str = "0 TABLE 2 LAYER 5 2 70 1 0 LAYER 5 10 2 WALL 70 0 62 3 390 F 0 ENDTAB \
    0 TABLE 2 BLOCK_RECORD 5 1 70 1 0 BLOCK_RECORD 5 1F 2 *Model_Space 0 ENDTAB";

#[test]
fn what_was_there_stays_and_the_path_is_added() {
    for text in [
        dxf(&[("HEADER", &header("AC1015")), ("TABLES", TABLES), ("ENTITIES", LINE)]),
        dxf(&[("HEADER", &header("AC1032")), ("TABLES", TABLES), ("ENTITIES", LINE)]).replace('\n', "\r\n"),
        dxf(&[("HEADER", "9 $ACADVER 1 AC1009"), ("TABLES", TABLES), ("ENTITIES", LINE)]),
        dxf(&[("TABLES", "0 TABLE 2 LTYPE 70 0 0 ENDTAB"), ("ENTITIES", LINE)]),
        entities(LINE),
    ] {
        let before = drawn(&text).unwrap();
        let written = to_dxf(Some(text.as_bytes()), &[overlay("path")]).unwrap();
        let after = read(&file("plan.dxf", written.clone())).unwrap();
        assert_eq!(strokes(&after)[..1], strokes(&before)[..]);
        assert_eq!(strokes(&after)[1..], [path()], "coordinates come back bit by bit");
        let layer = &after.layers[after.strokes[1].layer as usize];
        assert_eq!(
            (layer.name.to_lowercase().as_str(), layer.colour, layer.role),
            ("path", [255, 0, 0], Role::Ignored)
        );
        // All bytes of the original are still there, in their order, apart from the seed of handles.
        let mut rest = written.as_slice();
        for line in text.split_inclusive('\n').filter(|line| line.trim() != "200") {
            let place = rest.windows(line.len()).position(|window| window == line.as_bytes());
            rest = &rest[place.unwrap_or_else(|| panic!("{line:?} is gone"))..][line.len()..];
        }
    }
}

#[test]
fn handles_are_new_and_the_seed_is_above_them() {
    let text = dxf(&[("HEADER", &header("AC1015")), ("TABLES", TABLES), ("ENTITIES", LINE)]);
    let written = String::from_utf8(to_dxf(Some(text.as_bytes()), &[overlay("path")]).unwrap()).unwrap();
    let lines: Vec<&str> = written.lines().map(str::trim).collect();
    let handles: Vec<&str> = lines.chunks(2).filter(|pair| pair[0] == "5").map(|pair| pair[1]).collect();
    assert_eq!(handles, ["203", "2", "10", "201", "1", "1F", "1AF", "202"]);
    assert!(written.contains("330\n1F\n100\nAcDbEntity"), "it belongs to model space");
    assert!(written.contains("390\nF\n  0\nENDTAB") || written.contains("390\nF\n0\nENDTAB"), "as the other layers");
}

#[test]
fn names_that_are_taken_or_cannot_be_are_changed() {
    let text = dxf(&[("HEADER", &header("AC1015")), ("TABLES", TABLES), ("ENTITIES", LINE)]);
    let names = |text: &str| -> Vec<String> {
        let written = to_dxf(Some(text.as_bytes()), &[overlay("wall"), overlay("a:b*"), overlay("Weg ü")]).unwrap();
        let after = read(&file("plan.dxf", written)).unwrap();
        after.layers.iter().map(|layer| layer.name.clone()).collect()
    };
    assert_eq!(names(&text), ["WALL", "wall_2", "a_b_", "Weg ü"]);
    assert_eq!(names(&text.replace("AC1015", "AC1009")), ["WALL", "WALL_2", "A_B_", "WEG__"]);
}

#[test]
fn binary_drawings_stay_binary() {
    let sentinel = b"AutoCAD Binary DXF\r\n\x1a\0";
    let words = |text: &str, wide: bool| -> Vec<u8> {
        let words: Vec<&str> = text.split_whitespace().collect();
        let mut bytes = sentinel.to_vec();
        for pair in words.chunks(2) {
            let code: u8 = pair[0].parse().unwrap();
            bytes.push(code);
            if wide {
                bytes.push(0);
            }
            match code {
                10..=59 => bytes.extend(pair[1].parse::<f64>().unwrap().to_le_bytes()),
                60..=79 => bytes.extend(pair[1].parse::<i16>().unwrap().to_le_bytes()),
                _ => bytes.extend(pair[1].bytes().chain([0])),
            }
        }
        bytes
    };
    for (release, wide) in [("AC1009", false), ("AC1015", true)] {
        let text =
            format!("0 SECTION 2 HEADER {} 0 ENDSEC 0 SECTION 2 ENTITIES {LINE} 0 ENDSEC 0 EOF", header(release));
        let original = words(&text, wide);
        let written = to_dxf(Some(&original), &[overlay("path")]).unwrap();
        assert!(written.starts_with(sentinel));
        let after = read(&file("plan.dxf", written)).unwrap();
        assert_eq!(strokes(&after), [vec![Point::new(0.0, 0.0), Point::new(1.0, 0.0)], path()]);
    }
}

#[test]
fn what_is_no_drawing_is_not_written_beside() {
    assert!(to_dxf(Some(b"AC1032"), &[]).unwrap_err().to_string().contains("not a DXF file"));
    let cut = pairs("0 SECTION 2 ENTITIES 0 LINE");
    assert!(to_dxf(Some(cut.as_bytes()), &[]).unwrap_err().to_string().contains("cut off"));
}

#[test]
fn a_room_comes_back_from_its_outlines() {
    let text = "; resolution 0.5\n########\n#...#..#\n#......#\n#......#\n########\n";
    let room = load(&[SourceFile { name: "room.txt".into(), bytes: text.into() }]).unwrap();
    let bytes = to_dxf(None, &outlines(&room)).unwrap();
    let drawing = read(&file("room.dxf", bytes)).unwrap();
    let how = floor_drawing::Tracing {
        roles: vec![Role::Wall],
        metre: drawing.metre.unwrap(),
        gap: 0.0,
        resolution: 0.05,
        region: floor_drawing::DrawingRegion::WHOLE,
    };
    let traced = trace(&drawing, &how).unwrap().plan;
    let area = |plan: &robovac_core::floor_plan::FloorPlan| {
        let free = plan.occupancy.values().iter().filter(|cell| cell.is_free()).count();
        free as f64 * plan.resolution * plan.resolution
    };
    // The walls' lines take some of the small cells.
    assert!((area(&room) - area(&traced)).abs() < 0.06 * area(&room), "{} {}", area(&room), area(&traced));
}
