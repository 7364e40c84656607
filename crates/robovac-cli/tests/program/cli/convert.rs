//! What reads and writes rooms: `convert`, and maps of ROS.

use super::{failure, file, text};
use std::fs;

#[test]
fn convert_makes_a_room_of_a_drawing() {
    let corners: String = [(0, 0), (300, 0), (300, 200), (0, 200)].map(|(x, y)| format!("10\n{x}\n20\n{y}\n")).concat();
    let drawing = format!("0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nA\n70\n1\n{corners}0\nENDSEC\n0\nEOF\n");
    let drawing = file("convert/house.dxf", drawing.as_bytes());
    let out = file("convert/house.txt", b"");
    let options = ["--units", "cm", "--layer", "A=wall", "--resolution", "0.5", "--region", "room:150,100"];
    text(&[&["convert", "--map", &drawing, "--out", &out], &options[..]].concat());
    assert!(fs::read_to_string(&out).unwrap().ends_with("#######\n#.....#\n#.....#\n#.....#\n#######\n"));
    for (options, message) in [
        (&["--layer", "A=wall"][..], "add --units, e.g. --units mm"),
        (&["--units", "parsec"], "--units parsec: use mm, cm, m, in, ft"),
        (&["--units", "m", "--layer", "B=wall"], "the drawing has no such layer, it has A"),
        (&["--units", "m", "--region", "room:1"], "use whole, room:X,Y"),
        (&["--units", "cm", "--region", "room:-900,0"], "there is nothing drawn at (-900.00, 0.00)"),
    ] {
        let (_, said) = failure(&[&["convert", "--map", &drawing, "--out", &out], options].concat());
        assert!(said.contains(message), "{said}");
    }
    let (code, said) = failure(&["plan", "--planner", "boustrophedon", "--map", &drawing]);
    assert!(code == 3 && said.contains("is a DXF drawing, from which a room must be traced first"), "{said}");
}

#[test]
fn convert_writes_what_can_be_read_again() {
    let json = file("convert/flat.json", b"");
    let back = file("convert/flat.txt", b"");
    let direct = file("convert/direct.txt", b"");
    assert_eq!(text(&["convert", "--room", "flat", "--out", &json]), "");
    text(&["convert", "--map", &json, "--out", &back]);
    text(&["convert", "--room", "flat", "--out", &direct]);
    assert_eq!(fs::read_to_string(&back).unwrap(), fs::read_to_string(&direct).unwrap());
    assert!(fs::read_to_string(&back).unwrap().starts_with("; resolution 0.05\n; name Furnished flat\n"));
}

#[test]
fn ros_maps_of_any_mode_are_the_same_room() {
    let read_back = |image: &str, options: &[&str]| {
        let out = file(&format!("convert/{image}"), b"");
        text(&[&["convert", "--room", "flat", "--out", &out], options].concat());
        let yaml = out.replace(".pgm", ".yaml").replace(".png", ".yaml");
        let back = file("convert/ros.txt", b"");
        text(&["convert", "--map", &yaml, "--out", &back]);
        let map = fs::read_to_string(&back).unwrap();
        map.lines().filter(|line| !line.starts_with("; name")).collect::<Vec<_>>().join("\n")
    };
    let trinary = read_back("trinary.pgm", &[]);
    assert!(trinary.contains("; resolution 0.05") && trinary.contains("##"));
    assert_eq!(read_back("scale.png", &["--mode", "scale", "--negate"]), trinary);
    assert_eq!(read_back("raw.png", &["--mode", "raw"]), trinary);
}

#[test]
fn image_of_a_ros_map_is_found_beside_its_yaml() {
    let yaml = file("ros/map.yaml", b"image: map.pgm\nresolution: 0.2\norigin: [0, 0, 0]\n");
    let out = file("ros/map.txt", b"");
    file("ros/map.pgm", b"P5 3 1 255\n\xfe\xfe\x00");
    text(&["convert", "--map", &yaml, "--out", &out]);
    assert_eq!(fs::read_to_string(&out).unwrap(), "; resolution 0.2\n; name map\n..#\n");
    let lonely = file("ros_alone/map.yaml", b"image: gone.pgm\nresolution: 0.2\norigin: [0, 0, 0]\n");
    let (code, message) = failure(&["convert", "--map", &lonely, "--out", &out]);
    assert!(code == 3 && message.contains("\"gone.pgm\"; choose both files together"), "{code} {message}");
}
