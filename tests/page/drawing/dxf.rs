//! The drawn content of DXFs.

use super::support::{drawn, dxf, entities, rounded, strokes};
use floor_drawing::Role;

#[test]
fn lines_on_layers_with_colours_and_roles() {
    let drawing = drawn(&dxf(&[
        ("HEADER", "9 $INSUNITS 70 4"),
        (
            "TABLES",
            "0 TABLE 2 LAYER 70 4 0 LAYER 2 WALL 70 0 62 1 0 LAYER 2 Furniture 70 0 62 3 \
             0 LAYER 2 HOUSE 70 0 62 -5 0 LAYER 2 FLOOR2 70 1 62 5 420 1193046 0 LAYER 2 Empty 70 0 62 2 0 ENDTAB",
        ),
        (
            "ENTITIES",
            "0 LINE 8 wall 10 1 20 2 11 3 21 4 0 LINE 8 FURNITURE 10 1 20 2 11 3 21 5 0 LINE 8 HOUSE 10 0 20 0 11 1 21 1 \
             0 LINE 8 floor2 10 0 20 0 11 1 21 1 0 LINE 8 new 10 0 20 0 11 1 21 1 0 TEXT 8 0 10 0 20 0 1 hello",
        ),
    ]))
    .unwrap();
    assert_eq!(drawing.metre, Some(0.001));
    let layers: Vec<_> = drawing.layers.iter().map(|l| (l.name.as_str(), l.colour, l.strokes, l.role)).collect();
    assert_eq!(
        layers,
        [
            ("WALL", [255, 0, 0], 1, Role::Wall),
            ("Furniture", [0, 255, 0], 1, Role::Obstacle),
            // Switched off and frozen.
            ("HOUSE", [0, 0, 255], 1, Role::Ignored),
            ("FLOOR2", [0x12, 0x34, 0x56], 1, Role::Ignored),
            ("new", [0, 0, 0], 1, Role::Wall),
        ]
    );
    assert_eq!(drawing.strokes.iter().map(|s| s.entity).collect::<Vec<_>>(), [1, 2, 3, 4, 5]);
    assert_eq!(drawing.left_out, ["texts (1)"]);
}

#[test]
fn a_unit_of_nothing_is_none() {
    let line = "0 LINE 8 0 10 0 20 0 11 1 21 0";
    for (header, metre) in [("9 $INSUNITS 70 0", None), ("9 $INSUNITS 70 1", Some(0.0254)), ("9 $LTSCALE 40 1", None)] {
        assert_eq!(drawn(&dxf(&[("HEADER", header), ("ENTITIES", line)])).unwrap().metre, metre, "{header}");
    }
}

#[test]
fn polylines_of_both_forms_are_the_same() {
    let new = "0 LWPOLYLINE 8 0 90 3 70 1 10 0 20 0 42 1 10 2 20 0 10 2 20 3";
    let old = "0 POLYLINE 8 0 66 1 70 1 10 0 20 0 0 VERTEX 8 0 10 0 20 0 42 1 0 VERTEX 8 0 10 2 20 0 0 VERTEX 8 0 10 2 20 3 \
               0 SEQEND";
    let [new, old] = [new, old].map(|text| drawn(&entities(text)).unwrap());
    assert_eq!(new, old);
    assert!(new.strokes[0].is_closed && new.points.len() == 36 + 2);
    let lowest = rounded(&new).into_iter().map(|(_, y)| y).fold(0.0, f64::min);
    assert_eq!(lowest, -1.0, "a bulge of 1 is half a circle");
}

#[test]
fn control_points_of_smoothed_polylines_and_meshes_are_no_corners() {
    let smooth = "0 POLYLINE 70 4 0 VERTEX 10 9 20 9 70 16 0 VERTEX 70 16 10 9 20 9 0 VERTEX 10 0 20 0 70 8 \
                  0 VERTEX 10 1 20 0 70 8 0 SEQEND 0 POLYLINE 70 64 0 VERTEX 10 0 20 0 70 192 0 SEQEND";
    let drawing = drawn(&entities(smooth)).unwrap();
    assert_eq!(rounded(&drawing), [(0.0, 0.0), (1.0, 0.0)]);
    assert_eq!(drawing.left_out, ["meshes (1)"]);
}

#[test]
fn extrusion_downwards_mirrors_what_has_a_plane_of_its_own() {
    let arc = "0 ARC 8 0 10 2 20 0 40 1 50 0 51 5 210 0 220 0 230 -1";
    assert_eq!(rounded(&drawn(&entities(arc)).unwrap()), [(-3.0, 0.0), (-2.996, 0.087)]);
    let line = "0 LINE 8 0 10 2 20 0 11 3 21 0 210 0 220 0 230 -1";
    assert_eq!(rounded(&drawn(&entities(line)).unwrap()), [(2.0, 0.0), (3.0, 0.0)]);
    let tilted = "0 CIRCLE 8 0 10 2 20 0 40 1 210 1 220 0 230 0";
    let drawing = drawn(&entities(&format!("{line} {tilted}"))).unwrap();
    assert_eq!((drawing.strokes.len(), drawing.left_out), (1, vec!["entities in tilted planes (1)".to_owned()]));
}

const BLOCKS: &str = "0 BLOCK 8 0 2 SEAT 70 0 10 1 20 1 0 LINE 8 0 10 1 20 1 11 2 21 1 0 LINE 8 TOP 10 1 20 1 11 1 21 2 0 ENDBLK \
    0 BLOCK 8 0 2 ROW 10 0 20 0 0 INSERT 8 0 2 seat 10 10 20 0 0 ENDBLK";

fn inserted(insert: &str) -> Vec<(f64, f64)> {
    rounded(&drawn(&dxf(&[("BLOCKS", BLOCKS), ("ENTITIES", insert)])).unwrap())
}

#[test]
fn blocks_are_scaled_turned_mirrored_and_nested() {
    for (insert, expected) in [
        ("0 INSERT 8 A 2 SEAT 10 5 20 5", [(5.0, 5.0), (6.0, 5.0), (5.0, 5.0), (5.0, 6.0)]),
        ("0 INSERT 8 A 2 SEAT 10 5 20 5 41 2 42 -3", [(5.0, 5.0), (7.0, 5.0), (5.0, 5.0), (5.0, 2.0)]),
        ("0 INSERT 8 A 2 SEAT 10 5 20 5 41 2 42 1 50 90", [(5.0, 5.0), (5.0, 7.0), (5.0, 5.0), (4.0, 5.0)]),
        ("0 INSERT 8 A 2 SEAT 10 5 20 5 50 90 230 -1", [(-5.0, 5.0), (-5.0, 6.0), (-5.0, 5.0), (-4.0, 5.0)]),
        ("0 INSERT 8 A 2 ROW 10 0 20 1 50 90 41 2", [(0.0, 21.0), (0.0, 23.0), (0.0, 21.0), (-1.0, 21.0)]),
    ] {
        assert_eq!(inserted(insert), expected, "{insert}");
    }
    let rows = inserted("0 INSERT 8 A 2 SEAT 10 0 20 0 50 90 70 2 71 3 44 10 45 100");
    let firsts: Vec<_> = rows.chunks(4).map(|seat| seat[0]).collect();
    assert_eq!(firsts, [(0.0, 0.0), (0.0, 10.0), (-100.0, 0.0), (-100.0, 10.0), (-200.0, 0.0), (-200.0, 10.0)]);
}

#[test]
fn layer_0_of_a_block_is_the_inserts() {
    let text = dxf(&[("BLOCKS", BLOCKS), ("ENTITIES", "0 LINE 8 Z 10 0 20 0 11 1 21 1 0 INSERT 8 A 2 ROW 10 0 20 0")]);
    let drawing = drawn(&text).unwrap();
    let seen: Vec<_> =
        drawing.strokes.iter().map(|s| (drawing.layers[s.layer as usize].name.as_str(), s.entity)).collect();
    assert_eq!(seen, [("Z", 1), ("A", 2), ("TOP", 2)]);
}

#[test]
fn what_is_not_in_model_space_is_left_out() {
    let text = "0 LINE 8 0 67 1 10 0 20 0 11 9 21 9 0 LINE 8 0 60 1 10 0 20 0 11 9 21 9 0 LINE 8 0 10 0 20 0 11 1 21 0 \
                0 INSERT 2 nowhere 10 0 20 0 0 HATCH 8 0 0 DIMENSION 8 0 0 HATCH 8 0 0 MTEXT 8 0 0 VIEWPORT 8 0";
    let drawing = drawn(&entities(text)).unwrap();
    assert_eq!(strokes(&drawing).len(), 1);
    assert_eq!(
        drawing.left_out,
        [
            "dimensions (1)",
            "entities in paper space (1)",
            "hatches (2)",
            "hidden entities (1)",
            "inserts of blocks that aren't in the file (1)",
            "texts (1)"
        ]
    );
}
