//! Rooms that ship and map files that come in.

use robovac_core::{
    coverage::{ReachableFloor, drop_offs, with_objects},
    floor_plan::{FloorPlan, MAX_SIDE, ROOMS, RoomKind, room},
    grid::Cell,
    robot::{RobotModel, cell_robot, model},
};
use std::collections::HashSet;

/// Share of the free floor that a robot can sweep.
fn reachable_share(plan: &FloorPlan, robot: &RobotModel) -> f64 {
    let floor = ReachableFloor::new(plan, robot, None).unwrap_or_else(|e| panic!("{}: {e}", plan.name));
    let free = plan.occupancy.values().iter().filter(|o| o.is_free()).count();
    floor.area() / (free as f64 * plan.resolution * plan.resolution)
}

#[test]
fn rooms_are_unique_and_described() {
    let ids: HashSet<_> = ROOMS.iter().map(|room| room.id).collect();
    let titles: HashSet<_> = ROOMS.iter().map(|room| room.title).collect();
    assert_eq!((ids.len(), titles.len()), (ROOMS.len(), ROOMS.len()));
    for info in ROOMS {
        assert!(info.note.starts_with("Good for ") && info.note.ends_with('.') && info.note.len() < 110, "{}", info.id);
        let plan = (room(info.id).unwrap().build)();
        assert_eq!((plan.name.as_str(), plan.note.as_str()), (info.title, info.note));
        assert!(plan.occupancy.width() <= MAX_SIDE && plan.occupancy.height() <= MAX_SIDE);
        assert!(plan.start.is_some(), "{} has no start", info.id);
        assert_eq!(plan, (info.build)(), "{} differs from one time to the next", info.id);
    }
    assert!(room("nowhere").is_none());
}

#[test]
fn objects_of_rooms_can_be_there() {
    let furnished: Vec<_> = ROOMS.iter().map(|info| (info.build)()).filter(|plan| !plan.objects.is_empty()).collect();
    assert!(furnished.len() >= 2);
    for plan in furnished {
        assert_eq!(plan.check_objects(plan.start), Ok(()), "{}", plan.name);
    }
}

#[test]
fn cell_robot_reaches_every_free_cell_of_every_room() {
    for info in ROOMS {
        let plan = (info.build)();
        // What stands in a room isn't in its cells; a dock recessed in furniture takes no floor.
        if has_standing_objects(&plan) {
            continue;
        }
        let share = reachable_share(&plan, &cell_robot(plan.resolution));
        assert!((share - 1.0).abs() < 1e-9, "{}: {share}", info.id);
    }
}

fn has_standing_objects(plan: &FloorPlan) -> bool {
    with_objects(plan).occupancy != plan.occupancy || !drop_offs(plan).is_empty()
}

/// Width of the floor along walls that a Roomba may leave unswept, m.
const STRIP: f64 = 0.12;

// slow: the contract of the rooms that ship
#[test]
fn roomba_fits_and_reaches_most_of_every_room() {
    let roomba = model("roomba600").unwrap();
    let mut tight = Vec::new();
    for info in ROOMS {
        let plan = (info.build)();
        let start = plan.start.unwrap();
        let floor = ReachableFloor::new(&plan, roomba, None).unwrap();
        let free = |cell: Cell| plan.occupancy.get(cell).is_some_and(|o| o.is_free());
        let cells = plan.occupancy.iter().filter(|&(cell, _)| free(cell));
        let (area, edges) = cells.fold((0, 0), |(area, edges), (cell, _)| {
            (area + 1, edges + cell.neighbours().into_iter().filter(|&next| !free(next)).count())
        });
        // Along every wall it leaves a strip; that is much of a room of 1.6 m or of a maze.
        let least = f64::min(0.7, 1.0 - STRIP * edges as f64 / (f64::from(area) * plan.resolution));
        let share = reachable_share(&plan, roomba);
        println!("{} {:.1} % of {:.1} m2, at least {least:.3}", info.id, 100.0 * share, floor.area() / share);
        // Objects of a room aren't in its cells, so these don't give the reachable floor.
        if share <= least && !has_standing_objects(&plan) {
            tight.push(info.id);
        }
        if plan.resolution < 0.2 {
            assert_eq!(floor.start, start, "{}: the Roomba doesn't fit at the start", info.id);
        }
    }
    assert!(tight.is_empty(), "{tight:?}");
}

#[test]
fn benchmark_has_some_rooms_of_every_kind() {
    let benchmark = || ROOMS.iter().filter(|room| room.is_benchmark);
    assert!(benchmark().count() >= 22);
    for (kind, _, name) in RoomKind::ALL {
        assert!(benchmark().filter(|room| room.kind == kind).count() >= 3, "{name}");
    }
}

#[test]
fn room_of_the_thesis_table_has_as_many_cells_as_its_walk() {
    let plan = (room("thesis226").unwrap().build)();
    let free = plan.occupancy.values().iter().filter(|o| o.is_free()).count();
    // 45.2 m without a revisit in steps of 20 cm.
    assert_eq!((free, plan.resolution), (226, 0.2));
}

#[test]
fn thesis_preset_is_the_printed_one() {
    let plan = (room("thesis8").unwrap().build)();
    let picture = robovac_core::grid::picture(&plan.occupancy, |o| if o.is_free() { '.' } else { '#' });
    let expected = ["...##...\n".repeat(3), "........\n".repeat(3), "##......\n".repeat(2)].concat();
    assert_eq!(picture, expected);
    assert_eq!((plan.start.unwrap().x, plan.start.unwrap().y, plan.start.unwrap().heading), (0.1, 1.5, 0.0));
}

mod formats {
    use image::codecs::pnm::{PnmEncoder, PnmSubtype, SampleEncoding};
    use image::{DynamicImage, GrayImage, ImageFormat, Luma, Rgba, RgbaImage};
    use proptest::prelude::*;
    use rand::RngExt;
    use robovac_core::{
        floor_plan::{
            DEFAULT_ASCII_RESOLUTION, DEFAULT_IMAGE_RESOLUTION, FloorPlan, MapError, Scenario, SourceFile, TAKEN,
            image_of, load, load_shades, to_ascii,
        },
        geometry::Pose,
        grid::{Cell, Grid, Occupancy, picture},
        rng::seeded,
        robot::model,
    };
    use std::io::Cursor;

    const SCENARIO: &str = r#"{
  "format": "robovac-scenario",
  "version": 1,
  "name": "Nook",
  "resolution": 0.2,
  "width": 3,
  "height": 2,
  "rows": ["..?", "..#"],
  "start": { "x": 0.3, "y": 0.1, "heading_deg": 90 },
  "robot": "roomba600",
  "planner": "snake",
  "params": { "rate": 0.5 },
  "cell_size": 0.15,
  "seed": 7
}"#;
    const YAML: &str = "# written by map_saver\nimage: map.pgm\nresolution: 0.1\norigin: [-1.5, 2.0, 0.5]\n\
                        negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
    const PGM: &[u8] = b"P5\n# CREATOR: map_saver.cpp 0.100 m/pix\n3 2\n255\n\xfe\xcd\x00\xfe\xfe\xfe";

    fn file(name: &str, bytes: impl AsRef<[u8]>) -> SourceFile {
        SourceFile { name: name.to_owned(), bytes: bytes.as_ref().to_vec() }
    }

    fn load_one(name: &str, bytes: impl AsRef<[u8]>) -> Result<FloorPlan, MapError> {
        load(&[file(name, bytes)])
    }

    fn drawn(plan: &FloorPlan) -> String {
        picture(&plan.occupancy, |o| match o {
            Occupancy::Free => '.',
            Occupancy::Occupied => '#',
            Occupancy::Unknown => '?',
        })
    }

    fn message(files: &[SourceFile]) -> String {
        load(files).unwrap_err().to_string()
    }

    fn encoded(image: impl Into<DynamicImage>, format: ImageFormat) -> Vec<u8> {
        let mut bytes = Cursor::new(Vec::new());
        let image = image.into();
        if format == ImageFormat::Pnm {
            // The default would be a PAM, which is unusual for maps.
            let pgm = PnmEncoder::new(&mut bytes).with_subtype(PnmSubtype::Graymap(SampleEncoding::Binary));
            image.write_with_encoder(pgm).unwrap();
        } else {
            image.write_to(&mut bytes, format).unwrap();
        }
        bytes.into_inner()
    }

    fn ros_map(yaml: &str) -> [SourceFile; 2] {
        [file("maps/map.yaml", yaml), file("map.pgm", PGM)]
    }

    #[test]
    fn ascii_with_header_start_and_windows_line_ends() {
        let text = "\u{feff}; resolution 0.2\r\n; name Two rooms\r\n; free 5\r\n\r\n#S.\r\n#.?\r\n\r\n";
        let plan = load_one("rooms.txt", text).unwrap();
        assert_eq!((plan.name.as_str(), plan.resolution), ("Two rooms", 0.2));
        assert_eq!(drawn(&plan), "#..\n#.?\n");
        let start = plan.start.unwrap();
        assert!((start.x - 0.3).abs() < 1e-12 && (start.y - 0.3).abs() < 1e-12 && start.heading == 0.0, "{start}");
    }

    #[test]
    fn ascii_without_header_has_a_default_size_and_the_name_of_its_file() {
        let plan = load_one("/home/someone/den.v2.txt", "..\n##").unwrap();
        assert_eq!((plan.name.as_str(), plan.resolution, plan.start), ("den.v2", DEFAULT_ASCII_RESOLUTION, None));
    }

    #[test]
    fn bare_images_take_light_for_floor() {
        let shades = GrayImage::from_fn(3, 1, |x, _| Luma([[255, 205, 0][x as usize]]));
        for format in [ImageFormat::Png, ImageFormat::Pnm] {
            // The name doesn't matter, the content does.
            let plan = load_one("plan.txt", encoded(shades.clone(), format)).unwrap();
            assert_eq!((drawn(&plan).as_str(), plan.resolution), (".?#\n", DEFAULT_IMAGE_RESOLUTION));
        }
        let clear = RgbaImage::from_fn(2, 1, |x, _| Rgba([0, 0, 0, [0, 255][x as usize]]));
        assert_eq!(drawn(&load_one("a.png", encoded(clear, ImageFormat::Png)).unwrap()), ".#\n");
    }

    #[test]
    fn plain_and_deep_pgm_agree_with_the_usual_one() {
        let raw8 = b"P5 3 1 255\n\xff\xcd\x00".to_vec();
        let raw16 = [b"P5 3 1 65535\n".as_slice(), &[0xff, 0xff, 0xcd, 0xcd, 0, 0]].concat();
        let plain = b"P2\n# drawn by hand\n3 1\n255\n255 205\n0\n".to_vec();
        let coarse = b"P2 3 1 100 100 80 0\n".to_vec();
        for bytes in [raw8, raw16, plain, coarse] {
            assert_eq!(drawn(&load_one("a.pgm", &bytes).unwrap()), ".?#\n", "{bytes:?}");
        }
    }

    #[test]
    fn ros_map_in_any_order_keeps_its_origin() {
        let [yaml, image] = ros_map(YAML);
        let plan = load(&[image.clone(), yaml.clone()]).unwrap();
        assert_eq!(plan, load(&[yaml.clone(), image]).unwrap());
        assert_eq!((plan.name.as_str(), plan.resolution), ("map", 0.1));
        assert_eq!(plan.origin, Pose::new(-1.5, 2.0, 0.5));
        assert_eq!(drawn(&plan), ".?#\n...\n");
        assert_eq!(image_of(&yaml).as_deref(), Some("map.pgm"));
        assert_eq!(image_of(&file("a.txt", "..")), None);
    }

    #[test]
    fn ros_map_modes_and_block_lists() {
        let yaml = |mode: &str| {
            format!(
                "resolution: 1e-1\nimage: \"../maps/map.pgm\"\norigin:\n  - 0\n  - 0\n  - 0\nnegate: 0\nmode: {mode}\n"
            )
        };
        let loaded = |bytes: &[u8], mode: &str| load(&[file("map.yaml", yaml(mode)), file("map.pgm", bytes)]);
        // Shades 254, 205 and 0.
        assert_eq!(drawn(&loaded(PGM, "trinary").unwrap()), ".?#\n...\n");
        assert_eq!(drawn(&loaded(PGM, "scale").unwrap()), ".?#\n...\n");
        assert_eq!(drawn(&loaded(PGM, "raw").unwrap()), "??.\n???\n");
        let clear =
            encoded(RgbaImage::from_fn(2, 1, |x, _| Rgba([255, 255, 255, [254, 255][x as usize]])), ImageFormat::Png);
        assert_eq!(drawn(&loaded(&clear, "scale").unwrap()), "?.\n");
        assert_eq!(drawn(&loaded(&clear, "trinary").unwrap()), "..\n");
        let negated = load(&ros_map(&YAML.replace("negate: 0", "negate: 1"))).unwrap();
        assert_eq!(drawn(&negated), "##.\n###\n");
    }

    #[test]
    fn scenario_round_trip() {
        let scenario = Scenario::read("a.json", SCENARIO.as_bytes()).unwrap();
        assert_eq!(
            (scenario.planner.as_deref(), scenario.seed, scenario.cell_size),
            (Some("snake"), Some(7), Some(0.15))
        );
        assert_eq!(scenario, Scenario::read("b.json", scenario.to_json().as_bytes()).unwrap());
        let plan = load_one("a.json", SCENARIO).unwrap();
        assert_eq!(plan, scenario.plan("a.json").unwrap());
        assert_eq!(drawn(&plan), "..?\n..#\n");
        assert_eq!(plan.start, Some(Pose::new(0.3, 0.1, std::f64::consts::FRAC_PI_2)));
    }

    /// Every message names cause, place and mend; it's enough to compare how it begins.
    fn assert_messages(cases: &[(String, &str)]) {
        let wrong: Vec<_> = cases.iter().filter(|(message, expected)| !message.starts_with(expected)).collect();
        assert!(wrong.is_empty(), "{wrong:#?}");
    }

    #[test]
    fn messages_about_text_and_kinds() {
        let text = |text: &str| message(&[file("a.txt", text)]);
        assert_messages(&[
            (message(&[]), "no file was given; choose a floor plan"),
            (text(" \n"), "\"a.txt\" is empty; choose another file"),
            (
                text("Dear diary"),
                "\"a.txt\" is text of an unknown format: choose another file. Accepted formats: drawings (DXF,",
            ),
            (message(&[file("a.png", b"%PDF-1.7\n")]), "\"a.png\" is a PDF document: export its page as SVG"),
            (message(&[file("a.jpg", b"\0\0\0\x18ftypheic")]), "\"a.jpg\" is a HEIC photograph: export it as JPEG"),
            (
                message(&[file("a.zip", b"PK\x03\x04")]),
                "\"a.zip\" is a ZIP archive: unpack it and choose the floor plan inside. Accepted formats: drawings (DXF,",
            ),
            (message(&[file("a", b"\x00\xff\x01")]), "\"a\" is a file of an unknown format"),
            (text("..\n.x"), "\"a.txt\", line 2, column 2: 'x' is not allowed in a text map; use # for walls"),
            (
                text("; note\n..\n..."),
                "\"a.txt\", line 3: this row has 3 cells, but the rows above have 2; make all rows equally long",
            ),
            (text("..\n\n.."), "\"a.txt\", line 2: this row has 0 cells"),
            (text("S.\n.S"), "\"a.txt\", line 2: there is a second start S, the first one is in line 1; keep one"),
            (text("##\n#?"), "\"a.txt\" has no free cell; floor is . in text and light in images"),
            (text("; resolution 0.1\n"), "\"a.txt\" has no free cell"),
            (
                text("; resolution 0\n.."),
                "\"a.txt\", line 1: resolution can't be \"0\"; use metres per cell from 0.001 to 100",
            ),
            (text("; resolution\n.."), "\"a.txt\", line 1: resolution can't be \"\""),
            (text(&".".repeat(4097)), "\"a.txt\" has 4097 x 1 cells, but the limit is 4096 x 4096; crop it"),
            (text(&".\n".repeat(5000)), "\"a.txt\" has 1 x 4097 cells"),
        ]);
    }

    #[test]
    fn the_page_names_the_same_formats_where_the_browser_decodes() {
        assert!(include_str!("../../www/shared/pictures.js").contains(&format!("\"{TAKEN}.\"")));
    }

    #[test]
    fn files_that_are_no_floor_plan_are_told_with_all_formats() {
        let cases: [(&str, &[u8]); 9] = [
            ("a.json", b"{}"),
            ("a.json", b""),
            ("a.png", b""),
            ("a.png", b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0"),
            ("a.jpg", b"\xff\xd8\xff\xe0\0\x10JFIF"),
            ("a.webp", b"RIFF\x0a\0\0\0WEBPVP8 "),
            ("a.pgm", b"P5 9000 9000 255\n"),
            ("a.pgm", b"P5 2 2 255\nab"),
            ("a.pdf", b"%PDF-1.7"),
        ];
        for (name, bytes) in cases {
            let files = [file(name, bytes)];
            let messages = [message(&files), load_shades(&files[0]).map_or_else(|e| e.to_string(), |_| String::new())];
            for message in messages {
                assert!(message.ends_with(TAKEN), "{name}: {message}");
            }
        }
    }

    #[test]
    fn messages_about_images() {
        assert_messages(&[
            (message(&[file("a.pgm", "P5 5000 10 255\n")]), "\"a.pgm\" has 5000 x 10 cells"),
            (
                message(&[file("a.pgm", "P5 0 10 255\n")]),
                "\"a.pgm\" is damaged: its size is 0 x 10; save the image again",
            ),
            (
                message(&[file("a.pgm", "P5 2 2 255\nab")]),
                "\"a.pgm\" is cut off: its picture ends too early; copy or export",
            ),
            (message(&[file("a.pgm", "P2 2 2 255\n1 2 3")]), "\"a.pgm\" is cut off: its picture ends too early"),
            (message(&[file("a.pgm", "P2 2 2 255\n1 2 3 x")]), "\"a.pgm\" is damaged: "),
            (message(&[file("a.jpg", b"\xff\xd8\xff\xe0")]), "\"a.jpg\" is damaged: "),
            (
                message(&[file(
                    "a.png",
                    b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x02\0\0\0\x02\x08\0\0\0\0\x05\x05\x05\x05",
                )]),
                "\"a.png\" is damaged: CRC error; save the image again, best as PNG",
            ),
        ]);
    }

    #[test]
    fn messages_about_sizes_thresholds_and_magic_numbers_that_do_not_fit() {
        let yaml = |from: &str, to: &str| message(&ros_map(&YAML.replace(from, to)));
        let with_image = |bytes: &[u8]| message(&[ros_map(YAML)[0].clone(), file("map.pgm", bytes)]);
        let mut png = encoded(GrayImage::new(2, 2), ImageFormat::Png);
        png[1] = b'Q';
        let threshold = "\"map.yaml\", line 6: occupied_thresh can't be";
        assert_messages(&[
            (yaml("0.65", "high"), &format!("{threshold} \"high\"; use a number from 0 to 1")),
            (yaml("0.65", "nan"), &format!("{threshold} \"nan\"; use a number from 0 to 1")),
            (yaml("0.196", ""), "\"map.yaml\", line 7: free_thresh can't be \"\"; use one value"),
            (
                yaml("0.65", "0.1"),
                "\"map.yaml\", line 7: free_thresh can't be \"0.196\"; use at most occupied_thresh, which is 0.1",
            ),
            (with_image(b"P5 4 3 255\nabcdef"), "\"map.pgm\" is cut off: its picture ends too early; copy or export"),
            (with_image(b"P5 3 2 0\nabcdef"), "\"map.pgm\" is damaged: "),
            (with_image(b"P5 -3 2 255\nabcdef"), "\"map.pgm\" is damaged: "),
            (with_image(b"P9 3 2 255\nabcdef"), "\"map.pgm\" is text of an unknown format: choose"),
            (with_image(b"P7\nWIDTH 3\n"), "\"map.pgm\" is a PAM image: save it as PNG. Accepted formats"),
            (with_image(b""), "\"map.pgm\" is empty; choose another file"),
            (with_image(&png), "\"map.pgm\" is a file of an unknown format: choose"),
        ]);
    }

    #[test]
    fn messages_about_ros_maps_and_sets_of_files() {
        let yaml = |from: &str, to: &str| message(&ros_map(&YAML.replace(from, to)));
        let image = || file("a.pgm", PGM);
        assert_messages(&[
            (
                yaml("resolution: 0.1", "resolution: 0"),
                "\"map.yaml\", line 3: resolution can't be \"0\"; use metres per cell",
            ),
            (yaml("resolution: 0.1", "resolution: -0.05"), "\"map.yaml\", line 3: resolution can't be \"-0.05\""),
            (yaml("resolution: 0.1", "resolution: nan"), "\"map.yaml\", line 3: resolution can't be \"nan\""),
            (
                yaml("resolution: 0.1", "resolution: [1, 2]"),
                "\"map.yaml\", line 3: resolution can't be \"1, 2\"; use one value",
            ),
            (yaml("resolution", "resolutoin"), "\"map.yaml\" has no \"resolution\"; add the line \"resolution: 0.05\""),
            (yaml("image: map.pgm", "mode: raw"), "\"map.yaml\" has no \"image\"; add the line \"image: map.pgm\""),
            (yaml("negate: 0", "negate: maybe"), "\"map.yaml\", line 5: negate can't be \"maybe\"; use 0 or 1"),
            (
                yaml("negate: 0", "mode: best"),
                "\"map.yaml\", line 5: mode can't be \"best\"; use trinary, scale or raw",
            ),
            (yaml("0.65", "6.5"), "\"map.yaml\", line 6: occupied_thresh can't be \"6.5\"; use a number from 0 to 1"),
            (
                yaml("0.196", "0.7"),
                "\"map.yaml\", line 7: free_thresh can't be \"0.7\"; use at most occupied_thresh, which is 0.65",
            ),
            (
                yaml("[-1.5, 2.0, 0.5]", "[-1.5, 2.0]"),
                "\"map.yaml\", line 4: origin can't be \"-1.5, 2.0\"; use [x, y, yaw]",
            ),
            (yaml("[-1.5, 2.0, 0.5]", "[-1.5, 2.0"), "\"map.yaml\", line "),
            (
                message(&ros_map(YAML)[..1]),
                "\"map.yaml\" only describes a map; its cells are in \"map.pgm\"; choose both files together",
            ),
            (
                message(&[ros_map(YAML)[0].clone(), image()]),
                "\"map.yaml\" names the image \"map.pgm\", but \"a.pgm\" was given; choose \"map.pgm\" instead",
            ),
            (message(&[image(), file("b.pgm", PGM)]), "\"a.pgm\" and \"b.pgm\" are two maps; choose one of them"),
            (message(&[image(), file("b.txt", "..")]), "\"b.txt\" and \"a.pgm\" are two maps"),
        ]);
    }

    #[test]
    fn messages_about_scenarios() {
        // The others are in tests/scenario.
        let json = |from: &str, to: &str| message(&[file("a.json", SCENARIO.replace(from, to))]);
        assert_messages(&[
            (json("robovac-scenario", "replay"), "\"a.json\" is JSON but not a scenario (no "),
            (json("\"..?\",", "\"..?\""), "\"a.json\", line 8, column 18: expected `,` or `]`; fix that line"),
            (json("\"seed\": 7\n}", "\"seed\": 7"), "\"a.json\" is cut off: its JSON ends too early"),
        ]);
    }

    /// Files of every format, the ones of a ROS map together.
    fn samples() -> Vec<Vec<SourceFile>> {
        let shades = GrayImage::from_fn(9, 7, |x, y| Luma([(x * y * 5) as u8]));
        let rgba = DynamicImage::ImageRgba8(DynamicImage::ImageLuma8(shades.clone()).to_rgba8());
        vec![
            vec![file("a.txt", "; resolution 0.2\n; name Nook\nS..#\n...?\n")],
            vec![file("a.json", SCENARIO)],
            vec![file("a.png", encoded(shades.clone(), ImageFormat::Png))],
            vec![file("a.png", encoded(rgba, ImageFormat::Png))],
            vec![file("a.pgm", encoded(shades, ImageFormat::Pnm))],
            vec![file("a.pgm", "P2 3 2 9\n9 9 0\n9 5 0\n")],
            vec![file("a.pgm", [b"P5 2 1 65535\n".as_slice(), &[255, 255, 0, 0]].concat())],
            ros_map(YAML).to_vec(),
            ros_map("image: map.pgm\nresolution: 0.05\nmode: scale\n").into_iter().rev().collect(),
        ]
    }

    #[test]
    fn any_cut_is_an_error_or_a_smaller_map_but_never_a_panic() {
        for mut files in samples() {
            assert!(load(&files).is_ok(), "{}", files[0].name);
            let whole = std::mem::take(&mut files[0].bytes);
            for end in 0..whole.len() {
                files[0].bytes = whole[..end].to_vec();
                let result = load(&files);
                // Binary pictures and JSON can't end early; text can, e.g. after a whole row or within a number.
                if matches!(files[0].name.as_str(), "a.png" | "a.json") && end + 16 < whole.len() {
                    assert!(result.is_err(), "{} cut at {end}", files[0].name);
                }
            }
        }
    }

    #[test]
    fn any_changed_byte_is_survived() {
        for mut files in samples() {
            for index in 0..files[0].bytes.len() {
                let original = files[0].bytes[index];
                for value in [0, b'\n', b'"', b'{', b'-', b'9', 0xff, original ^ 1, original ^ 0x80] {
                    files[0].bytes[index] = value;
                    let _ = load(&files);
                }
                files[0].bytes[index] = original;
            }
        }
    }

    #[test]
    fn nested_and_aliased_yaml_neither_recurses_nor_explodes() {
        let deep = format!("image: map.pgm\nresolution: 0.1\nx: {}", "[".repeat(30_000));
        assert!(load(&ros_map(&deep)).is_err());
        let block = format!("image: map.pgm\nresolution: 0.1\nx:\n  {}1\n", "- ".repeat(20_000));
        let _ = load(&ros_map(&block));
        // Anchors and aliases are words like any other here: nothing is expanded.
        let aliases = "image: map.pgm\nresolution: 0.1\nx: &b [*a, *a, *a]\ny: [*b, *b, *b]\n";
        assert!(load(&ros_map(aliases)).is_ok());
    }

    #[test]
    fn decompression_bomb_is_refused_by_its_header() {
        // A PNG header of 100 000 x 100 000 pixels: 10 GB decoded.
        let mut png = encoded(GrayImage::new(1, 1), ImageFormat::Png);
        png[16..24].copy_from_slice(&[0, 1, 0x86, 0xa0, 0, 1, 0x86, 0xa0]);
        let crc = crc32(&png[12..29]);
        png[29..33].copy_from_slice(&crc.to_be_bytes());
        assert!(message(&[file("bomb.png", png)]).starts_with("\"bomb.png\" has 100000 x 100000 cells"));
    }

    fn crc32(bytes: &[u8]) -> u32 {
        !bytes.iter().fold(u32::MAX, |crc, &byte| {
            (0..8).fold(crc ^ u32::from(byte), |crc, _| (crc >> 1) ^ (0xedb8_8320 * (crc & 1)))
        })
    }

    /// A floor as a scanner would see it: rooms of 4 m along a corridor, each with a door and a cupboard, in walls of 0.1 m,
    /// with noise; grey around.
    fn building(seed: u64) -> GrayImage {
        let mut rng = seeded(seed, 0);
        let rooms = rng.random_range(2..6_u32);
        let doors: Vec<u32> = (0..rooms).map(|_| rng.random_range(4..60)).collect();
        GrayImage::from_fn(82 * rooms + 22, 202, |x, y| {
            let is_outside = x < 10 || y < 10 || x >= 82 * rooms + 12 || y >= 192;
            let (room, x, y) = (x.saturating_sub(10) / 82, x.saturating_sub(10) % 82, y.saturating_sub(10));
            let is_door = doors.get(room as usize).is_some_and(|door| (*door..door + 18).contains(&x));
            let is_corridor = (92..140).contains(&y) && (1..rooms).contains(&room);
            let is_wall =
                x < 2 && !is_corridor || !(2..180).contains(&y) || matches!(y, 90 | 91 | 140 | 141) && !is_door;
            let is_cupboard = (8..20).contains(&y) && (10..40).contains(&x);
            Luma([match (is_outside, is_wall || is_cupboard) {
                (true, _) => 205,
                (_, true) => rng.random_range(0..60),
                _ => rng.random_range(225..=255),
            }])
        })
    }

    #[test]
    fn plans_of_buildings_load() {
        let own = (1..=3).map(|seed| (format!("own {seed}.png"), encoded(building(seed), ImageFormat::Png)));
        // Scans of real ones, where they are at hand beside the repository.
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../shared/maps/floorplans");
        let scans = std::fs::read_dir(folder).into_iter().flatten().map(|entry| entry.unwrap().path());
        let scans = scans.map(|path| (path.to_string_lossy().into_owned(), std::fs::read(&path).unwrap()));
        for (name, bytes) in own.chain(scans) {
            let plan = load_one(&name, bytes).unwrap();
            let count = |wanted| plan.occupancy.values().iter().filter(|&&o| o == wanted).count() as f64;
            let total = plan.occupancy.len() as f64;
            let (free, occupied) = (count(Occupancy::Free) / total, count(Occupancy::Occupied) / total);
            println!("{}: {:.0} % free, {:.0} % occupied", plan.name, 100.0 * free, 100.0 * occupied);
            assert!(free > 0.15 && occupied > 0.005, "{}: {free} free, {occupied} occupied", plan.name);
            if name.starts_with("own") {
                // All rooms and the corridor are one floor.
                let share = super::reachable_share(&plan, model("roomba600").unwrap());
                assert!(share > 0.8 && count(Occupancy::Unknown) > 0.0, "{name}: {share}");
            }
        }
    }

    fn any_plan() -> impl Strategy<Value = FloorPlan> {
        let cell = prop_oneof![Just(Occupancy::Free), Just(Occupancy::Occupied), Just(Occupancy::Unknown)];
        (1..9_usize, 1..9_usize).prop_flat_map(move |(width, height)| {
            let cells = proptest::collection::vec(cell.clone(), width * height);
            (cells, 0..width * height, 1..2000_u32, -180..=180_i32, "[a-z0-9]{1,9}", -5..5_i32).prop_map(
                move |(mut cells, start, millimetres, heading, name, origin)| {
                    cells[start] = Occupancy::Free;
                    let occupancy = Grid::from_rows(width, cells).unwrap();
                    let cell = occupancy.cell(start);
                    let resolution = f64::from(millimetres) / 1000.0;
                    let mut plan = FloorPlan {
                        name,
                        note: String::new(),
                        resolution,
                        occupancy,
                        objects: Vec::new(),
                        start: None,
                        origin: Pose::new(f64::from(origin), 0.5, 0.0),
                    };
                    let centre = plan.centre(cell);
                    plan.start = Some(Pose::new(centre.x, centre.y, f64::from(heading).to_radians()));
                    plan
                },
            )
        })
    }

    fn same_pose(a: Pose, b: Pose) -> bool {
        (a.position() - b.position()).norm() < 1e-9 && (a.direction() - b.direction()).norm() < 1e-9
    }

    proptest! {
        #[test]
        fn text_map_round_trip(plan in any_plan()) {
            let again = load_one("a.txt", to_ascii(&plan)).unwrap();
            prop_assert_eq!((&again.occupancy, again.resolution, &again.name), (&plan.occupancy, plan.resolution, &plan.name));
            let cell = |plan: &FloorPlan| -> Cell { plan.cell_at(plan.start.unwrap().position()) };
            prop_assert_eq!(cell(&again), cell(&plan));
        }

        #[test]
        fn scenario_file_round_trip(plan in any_plan()) {
            let again = load_one("a.json", Scenario::of(&plan).to_json()).unwrap();
            prop_assert_eq!((&again.occupancy, again.resolution, &again.name), (&plan.occupancy, plan.resolution, &plan.name));
            prop_assert!(same_pose(again.start.unwrap(), plan.start.unwrap()) && same_pose(again.origin, plan.origin));
        }

        #[test]
        fn picture_round_trip(plan in any_plan()) {
            let shades = GrayImage::from_fn(plan.occupancy.width() as u32, plan.occupancy.height() as u32, |x, y| {
                let cell = Cell::new(x as i32, plan.occupancy.height() as i32 - 1 - y as i32);
                Luma([match plan.occupancy[cell] { Occupancy::Free => 254, Occupancy::Occupied => 0, Occupancy::Unknown => 205 }])
            });
            for format in [ImageFormat::Png, ImageFormat::Pnm] {
                prop_assert_eq!(&load_one("a", encoded(shades.clone(), format)).unwrap().occupancy, &plan.occupancy);
            }
        }

        #[test]
        fn arbitrary_bytes_never_panic(start in 0..9_usize, mut bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
            let heads: [&[u8]; 9] = [b"", b"P5 ", b"P2 3 3 9 ", b"\x89PNG\r\n\x1a\n", b"image: a\n", b"{\"format\":", b"; ", b"#.", b"resolution: "];
            let mut all = heads[start].to_vec();
            all.append(&mut bytes);
            let _ = load_one("a", all);
        }
    }
}
