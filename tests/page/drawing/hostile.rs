//! Drawings that are damaged, hostile or none at all: a message with a place, no panic and no hang.

use super::support::{drawn, dxf, entities, file, refusal};
use floor_drawing::{DrawingRegion, MAX_POINTS, Overlay, Role, Tracing, read, to_dxf, trace};
use proptest::prelude::*;
use robovac_core::geometry::Point;
use std::fmt::Write;

const LINE: &str = "0 LINE 8 WALL 10 0 20 0 11 1 21 0";

#[test]
fn other_files_are_called_by_their_name() {
    for (bytes, expected) in [
        (&b"AC1032\0\0\0"[..], "this is a DWG drawing, AutoCAD's own format: save it as DXF"),
        (b"\x89PNG\r\n\x1a\n", "this is an image: choose a drawing (DXF, SVG or GeoJSON)"),
        (b"%PDF-1.4", "this is a PDF document: export"),
        (b"####\n#..#\n", "this is text of an unknown format"),
        (b"\xfe\xed\xfa", "this is a file of an unknown format"),
        (b" \n", "is empty"),
    ] {
        let message = refusal(bytes);
        assert!(message.starts_with("\"plan.dxf\"") && message.contains(expected), "{message}");
    }
}

#[test]
fn nothing_to_draw_is_said_with_what_there_is() {
    assert!(refusal(entities("")).contains("nothing in the drawing can be used;"));
    assert!(refusal(entities("0 TEXT 1 a 0 TEXT 1 b")).contains("nothing in the drawing can be used, only texts (2);"));
}

#[test]
fn every_prefix_is_refused_with_its_line_or_is_whole() {
    let text = dxf(&[
        ("HEADER", "9 $INSUNITS 70 4"),
        ("BLOCKS", &format!("0 BLOCK 2 A 10 0 20 0 {LINE} 0 ENDBLK")),
        ("ENTITIES", &format!("{LINE} 0 INSERT 2 A 10 0 20 0")),
    ]);
    for end in 1..text.len() {
        match read(&file("plan.dxf", &text[..end])) {
            // Only the mark of the end is missing.
            Ok(_) => assert!(text[end..].len() < 14, "{end}"),
            Err(error) => {
                let message = error.to_string();
                assert!(message.contains("line ") || message.contains("this is text"), "{message}");
            }
        }
    }
    let cut = &text[..text.find("EOF").unwrap() - 20];
    assert!(refusal(cut).contains("the file is cut off"), "{}", refusal(cut));
}

/// Found by fuzzing: what was put in landed in a section that the reader skips, and ended it.
#[test]
fn sections_are_the_same_to_the_reader_and_to_the_writer() {
    let unnamed = entities(LINE).replacen("SECTION\n2\n", "SECTION\n1\n", 1);
    assert!(refusal(unnamed.as_str()).contains("line 3: the previous section has no name"), "{unnamed}");
    let skipped = format!("0 SECTION 2 BLOCKS 0 BLOCK 2 A 10 0 20 0 {LINE}");
    let text = dxf(&[("", &skipped), ("ENTITIES", LINE)]);
    let line = vec![Point::new(1.0, 2.0), Point::new(3.0, 4.5)];
    let overlay = Overlay { layer: "PATH".into(), colour: 1, lines: vec![line] };
    let written = to_dxf(Some(text.as_bytes()), &[overlay]).unwrap();
    assert_eq!(read(&file("plan.dxf", written)).unwrap().strokes.len(), 2);
}

#[test]
fn a_damaged_line_is_named() {
    let damaged = entities(LINE).replace("\n20\n0\n", "\ntwenty\n0\n");
    assert_eq!(
        refusal(damaged),
        "\"plan.dxf\", line 11: expected a group code (a number from -5 to 1071), found \"twenty\"; \
         the DXF is damaged from here on, export it again"
    );
    let damaged = entities(LINE).replace("\n11\n1\n", "\n11\n1,5\n");
    assert_eq!(
        refusal(damaged),
        "\"plan.dxf\", entity 1 on layer \"WALL\" (line 14): group code 11 needs a number, found \"1,5\"; \
         export the drawing again"
    );
}

#[test]
fn coordinates_are_numbers_of_this_world() {
    for value in ["1e300", "-2e10", "NaN", "inf", "1e999"] {
        let text = entities(&format!("{LINE} 0 LINE 8 FAR 10 {value} 20 0 11 1 21 0"));
        let message = refusal(text);
        assert!(message.contains("entity 2 on layer \"FAR\" (line 22)") && message.contains(value), "{message}");
    }
    // Numbers that are fine by themselves, but not what they make.
    let blocks = format!("0 BLOCK 2 A 10 0 20 0 {LINE} 0 ENDBLK");
    let text = dxf(&[("BLOCKS", &blocks), ("ENTITIES", "0 INSERT 8 X 2 A 10 9e9 20 0 41 9e9")]);
    assert!(refusal(text).contains("entity 1 of block \"A\""));
}

#[test]
fn blocks_that_insert_themselves_are_named() {
    let blocks = "0 BLOCK 2 A 10 0 20 0 0 INSERT 2 B 10 0 20 0 0 ENDBLK 0 BLOCK 2 B 10 0 20 0 0 INSERT 8 L 2 a 10 0 20 0 0 ENDBLK";
    let message = refusal(dxf(&[("BLOCKS", blocks), ("ENTITIES", "0 INSERT 2 A 10 0 20 0")]));
    assert!(
        message.contains("entity 1 of block \"B\" on layer \"L\"")
            && message.contains("the block \"A\" inserts itself through \"B\""),
        "{message}"
    );
}

#[test]
fn a_thousand_million_entities_by_nesting_are_refused_at_once() {
    let mut blocks = format!("0 BLOCK 2 B0 10 0 20 0 {LINE} 0 ENDBLK");
    for level in 1..=9 {
        write!(blocks, " 0 BLOCK 2 B{level} 10 0 20 0").unwrap();
        for _ in 0..10 {
            write!(blocks, " 0 INSERT 2 B{} 10 0 20 0", level - 1).unwrap();
        }
        blocks.push_str(" 0 ENDBLK");
    }
    let message = refusal(dxf(&[("BLOCKS", &blocks), ("ENTITIES", "0 INSERT 2 B9 10 0 20 0")]));
    assert!(message.contains(&format!("more than {MAX_POINTS} corners")) && message.contains("of block"), "{message}");
    // The same as an array, of something and of nothing.
    let array = "0 INSERT 2 A 10 0 20 0 70 32000 71 32000 44 1 45 1";
    let full = format!("0 BLOCK 2 A 10 0 20 0 {LINE} 0 ENDBLK");
    assert!(refusal(dxf(&[("BLOCKS", &full), ("ENTITIES", array)])).contains("entity 1 on layer \"0\""));
    let empty = dxf(&[("BLOCKS", "0 BLOCK 2 A 10 0 20 0 0 ENDBLK"), ("ENTITIES", &format!("{array} {LINE}"))]);
    assert_eq!(drawn(&empty).unwrap().strokes.len(), 1);
}

#[test]
fn inserts_that_draw_nothing_are_counted_too() {
    let array = "0 INSERT 8 ROWS 2 A 10 0 20 0 70 1000 71 900 44 1 45 1";
    let missing = format!("0 BLOCK 2 A 10 0 20 0 {LINE}{} 0 ENDBLK", " 0 INSERT 2 X".repeat(1000));
    let message = refusal(dxf(&[("BLOCKS", &missing), ("ENTITIES", &format!("{LINE} {array}"))]));
    assert!(
        message.contains("entity 2 on layer \"ROWS\"") && message.contains("more than 2000000 inserts"),
        "{message}"
    );
    // Strokes without a length aren't kept: these would be 2 500 million of them.
    let empty = format!("0 BLOCK 2 A 10 0 20 0 {LINE}{} 0 ENDBLK", " 0 LWPOLYLINE 8 0".repeat(10_000));
    let array = "0 INSERT 2 A 10 0 20 0 70 500 71 500 44 1 45 1";
    let drawing = drawn(&dxf(&[("BLOCKS", &empty), ("ENTITIES", array)])).unwrap();
    assert_eq!(drawing.strokes.len(), 250_000);
}

#[test]
fn deep_nesting_is_refused() {
    let mut blocks = format!("0 BLOCK 2 B0 10 0 20 0 {LINE} 0 ENDBLK");
    for level in 1..5000 {
        write!(blocks, " 0 BLOCK 2 B{level} 10 0 20 0 0 INSERT 2 B{} 10 0 20 0 0 ENDBLK", level - 1).unwrap();
    }
    let message = refusal(dxf(&[("BLOCKS", &blocks), ("ENTITIES", "0 INSERT 2 B4999 10 0 20 0")]));
    assert!(message.contains("nested more than 64 deep"), "{message}");
}

#[test]
fn odd_entities_are_read_or_refused() {
    for text in [
        "0 LWPOLYLINE 20 5 42 1 10 0 20 0 10 1 20 1",
        "0 SPLINE 71 3 40 0 40 0 10 0 20 0 10 1 20 1 10 2 20 0 10 3 20 0",
        "0 SPLINE 71 -3 10 0 20 0 10 1 20 1",
        "0 SPLINE 71 3 41 0 41 0 41 0 41 0 10 0 20 0 10 1 20 1 10 2 20 0 10 3 20 0",
        "0 SPLINE 71 3 11 0 21 0 11 1 21 1 11 2 21 0",
        "0 ELLIPSE 10 0 20 0 11 0 21 0 40 0 41 0 42 0",
        "0 CIRCLE 10 0 20 0 40 -1",
        "0 ARC 10 0 20 0 40 1 50 1e9 51 -1e9",
        "0 INSERT 10 0 20 0 70 -5 71 99999",
        "0 VERTEX 10 0 20 0 0 SEQEND 0 ATTRIB 1 x",
        "0 POLYLINE 70 1",
        "0 SOLID 10 0 20 0",
        "0 LINE 70 1e300 62 x",
    ] {
        let both = drawn(&entities(&format!("{LINE} {text}")));
        assert!(both.is_ok(), "{text}: {both:?}");
    }
}

/// One of each kind, with blocks and layers.
fn sampler() -> String {
    let blocks =
        format!("0 BLOCK 2 A 10 0 20 0 {LINE} 0 INSERT 2 B 10 1 20 1 0 ENDBLK 0 BLOCK 2 B 10 1 20 1 {LINE} 0 ENDBLK");
    dxf(&[
        ("HEADER", "9 $ACADVER 1 AC1015 9 $INSUNITS 70 4 9 $DWGCODEPAGE 3 ANSI_1251 9 $HANDSEED 5 FF"),
        ("TABLES", "0 TABLE 2 LAYER 5 2 70 1 0 LAYER 5 10 2 WALL 70 0 62 3 420 255 0 LAYER 2 F 70 1 62 -3 0 ENDTAB"),
        ("BLOCKS", &blocks),
        (
            "ENTITIES",
            "0 LINE 5 A1 8 WALL 10 0 20 0 11 900 21 0 0 CIRCLE 8 FURN 10 500 20 500 40 100 230 -1 0 ARC 10 0 20 0 40 9 50 1 51 99 \
             0 ELLIPSE 10 0 20 0 11 5 21 1 40 0.5 41 0 42 3 0 LWPOLYLINE 8 WALL 70 1 10 0 20 0 42 1 10 9 20 0 10 9 20 9 \
             0 POLYLINE 8 FURN 70 1 0 VERTEX 10 0 20 0 42 -1 0 VERTEX 10 700 20 0 0 VERTEX 10 700 20 700 0 SEQEND \
             0 SPLINE 70 8 71 3 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 10 0 20 0 10 1 20 1 10 2 20 1 10 3 20 0 41 1 41 2 41 1 41 1 \
             0 SPLINE 71 3 11 0 21 0 11 4 21 4 11 9 21 0 0 SOLID 10 0 20 0 11 1 21 0 12 0 22 1 13 1 23 1 0 TRACE 10 0 20 0 11 3 21 3 \
             0 3DFACE 10 0 20 0 11 5 21 0 12 5 22 5 0 INSERT 2 A 10 5 20 5 41 2 42 -1 50 30 70 2 71 2 44 10 45 10 0 TEXT 1 x",
        ),
    ])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]
    #[test]
    fn damaged_drawings_never_panic(
        damages in proptest::collection::vec((0_usize..1000, 0_usize..1000, 0_u8..5, any::<u8>()), 1..12)
    ) {
        const WORDS: [&str; 12] =
            ["0", "-1", "1e10", "32767", "LINE", "ENDSEC", "BLOCK", "VERTEX", "10", "70", "SECTION", "\u{e9}"];
        let text = sampler();
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        for (line, other, kind, byte) in damages {
            let (line, other) = (line % lines.len(), other % lines.len());
            match kind {
                0 => drop(lines.remove(line)),
                1 => lines.swap(line, other),
                2 => lines.insert(line, lines[other].clone()),
                3 => lines[line] = WORDS[usize::from(byte) % WORDS.len()].to_owned(),
                _ => lines.truncate(line.max(20)),
            }
        }
        let bytes = lines.join("\n").into_bytes();
        if let Ok(drawing) = read(&file("plan.dxf", bytes.clone())) {
            for (role, region) in [(Role::Wall, DrawingRegion::WHOLE), (Role::Obstacle, DrawingRegion::Room(drawing.points[0]))] {
                let roles = vec![role; drawing.layers.len()];
                if let Ok(traced) = trace(&drawing, &Tracing { roles, metre: 0.001, gap: 0.05, resolution: 0.01, region }) {
                    prop_assert_eq!(traced.plan.check_objects(None), Ok(()));
                }
            }
            let line = vec![Point::new(1.0, 2.0), Point::new(3.0, 4.5)];
            let overlay = Overlay { layer: "PATH".into(), colour: 1, lines: vec![line.clone()] };
            if let Ok(written) = to_dxf(Some(&bytes), &[overlay]) {
                let again = read(&file("again.dxf", written)).unwrap();
                prop_assert_eq!(again.strokes.len(), drawing.strokes.len() + 1);
                prop_assert!(again.strokes.iter().any(|stroke| again.corners(stroke) == line));
            }
        }
    }

    #[test]
    fn any_bytes_never_panic(bytes in proptest::collection::vec(any::<u8>(), 0..400), form in 0_usize..5) {
        let start: [&[u8]; 5] = [
            b"AutoCAD Binary DXF\r\n\x1a\0\0SECTION\0\x02ENTITIES\0\0LINE\0",
            b"AutoCAD Binary DXF\r\n\x1a\0\0\0SECTION\0\x02\0ENTITIES\0\0\0LINE\0",
            b"0\nSECTION\n",
            b"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 9 9\">",
            b"{\"type\":\"Polygon\",\"coordinates\":[[[",
        ];
        let bytes = [start[form], &bytes].concat();
        let _ = read(&file("any", bytes.clone()));
        let _ = to_dxf(Some(&bytes), &[]);
    }
}
