//! Drawings that are damaged, hostile or none at all: a message with a place, no panic and no hang.

use crate::support::{drawn, dxf, entities, file, refusal};
use robovac_playground::drawing::{MAX_POINTS, read};
use std::fmt::Write;

const LINE: &str = "0 LINE 8 WALL 10 0 20 0 11 1 21 0";

#[test]
fn other_files_are_called_by_their_name() {
    for (bytes, expected) in [
        (&b"AC1032\0\0\0"[..], "this is a DWG drawing, AutoCAD's own format; save it as DXF"),
        (b"\x89PNG\r\n\x1a\n", "this is a PNG image, not a drawing; choose a DXF, SVG or GeoJSON file"),
        (b"\xff\xd8\xff\xe0", "this is a JPEG image"),
        (b"####\n#..#\n", "this is text of unknown kind"),
        (b"\xfe\xed\xfa", "this is a file of unknown kind"),
        (b" \n", "is empty"),
    ] {
        let message = refusal(bytes);
        assert!(message.starts_with("\"plan.dxf\"") && message.contains(expected), "{message}");
    }
}

#[test]
fn nothing_to_draw_is_said_with_what_there_is() {
    assert!(refusal(entities("")).contains("nothing in it can be drawn;"));
    assert!(refusal(entities("0 TEXT 1 a 0 TEXT 1 b")).contains("nothing in it can be drawn, only 2 texts;"));
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

#[test]
fn a_damaged_line_is_named() {
    let damaged = entities(LINE).replace("\n20\n0\n", "\ntwenty\n0\n");
    assert_eq!(
        refusal(damaged),
        "\"plan.dxf\", line 11: a group code should be here, a number from -5 to 1071, but there is \"twenty\"; \
         the DXF is damaged from here on, export it again"
    );
    let damaged = entities(LINE).replace("\n11\n1\n", "\n11\n1,5\n");
    assert_eq!(
        refusal(damaged),
        "\"plan.dxf\", entity 1 on layer \"WALL\" (line 14): group code 11 takes a number, but there is \"1,5\"; \
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
