//! SVG and GeoJSON.

use super::support::{file, rounded};
use floor_drawing::{Drawing, DrawingError, Role, is_drawing, read};

fn svg(attributes: &str, body: &str) -> Result<Drawing, DrawingError> {
    let text = format!(
        "<?xml version=\"1.0\"?><svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" \
         xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" {attributes}>{body}</svg>"
    );
    let file = file("plan.svg", text);
    assert!(is_drawing(&file));
    read(&file)
}

fn geo(text: &str) -> Result<Drawing, DrawingError> {
    let file = file("plan.geojson", text);
    assert!(is_drawing(&file), "{text}");
    read(&file)
}

const LINE: &str = "<path d=\"M0 0H50\" stroke=\"#ff0000\" fill=\"none\"/>";

#[test]
fn physical_sizes_are_millimetres_and_y_is_up() {
    let drawing = svg("width=\"200mm\" height=\"100mm\" viewBox=\"0 0 100 50\"", LINE).unwrap();
    assert_eq!((drawing.metre, rounded(&drawing)), (Some(1e-3), vec![(0.0, 100.0), (100.0, 100.0)]));
    assert_eq!((drawing.layers[0].name.as_str(), drawing.layers[0].colour), ("#ff0000", [255, 0, 0]));
    let inches = svg("width=\"1in\" height=\"1in\" viewBox=\"0 0 100 100\"", LINE).unwrap();
    assert_eq!(rounded(&inches), [(0.0, 25.4), (12.7, 25.4)]);
    let pixels = svg("width=\"100\" height=\"50px\"", LINE).unwrap();
    assert_eq!((pixels.metre, rounded(&pixels)), (None, vec![(0.0, 50.0), (50.0, 50.0)]));
}

#[test]
fn groups_are_layers_and_transforms_and_uses_are_resolved() {
    let drawing = svg(
        "viewBox=\"0 0 100 100\"",
        "<defs><rect id=\"seat\" width=\"10\" height=\"20\"/></defs>\
         <g id=\"layer1\" inkscape:groupmode=\"layer\" inkscape:label=\"Walls\" fill=\"none\" stroke=\"#000\">\
           <g id=\"g7\" transform=\"translate(5 10)\"><polyline points=\"0,0 1,0 1,1\"/></g></g>\
         <g id=\"furniture\"><use xlink:href=\"#seat\" x=\"30\" y=\"40\"/><text>no</text></g>",
    )
    .unwrap();
    let layers: Vec<_> = drawing.layers.iter().map(|l| (l.name.as_str(), l.strokes, l.role)).collect();
    assert_eq!(layers, [("Walls", 1, Role::Wall), ("furniture", 1, Role::Obstacle)]);
    let expected = [(5.0, 90.0), (6.0, 90.0), (6.0, 89.0), (30.0, 60.0), (40.0, 60.0), (40.0, 40.0), (30.0, 40.0)];
    assert_eq!(rounded(&drawing), expected);
    assert_eq!(drawing.strokes.iter().map(|s| s.is_closed).collect::<Vec<_>>(), [false, true]);
    assert_eq!(drawing.left_out, ["texts (1)"]);
}

#[test]
fn a_path_by_itself_has_its_own_name_if_that_says_what_it_is() {
    let rect =
        |id: &str| format!("<rect id=\"{id}\" x=\"1\" width=\"10\" height=\"20\" fill=\"none\" stroke=\"#000\"/>");
    let drawing = svg("viewBox=\"0 0 100 100\"", &["frame", "rect17", "path8", "sofa"].map(rect).concat()).unwrap();
    let layers: Vec<_> = drawing.layers.iter().map(|l| (l.name.as_str(), l.role)).collect();
    assert_eq!(layers, [("frame", Role::Ignored), ("#000000", Role::Wall), ("sofa", Role::Obstacle)]);
    // Groups within one that says nothing, and groups within one that does.
    let group = |id: &str, body: &str| format!("<g id=\"{id}\">{body}</g>");
    let of = |id: &str| group(id, &group("g7", LINE));
    let body = group("plan", &[of("Walls"), of("Doors"), of("g9")].concat()) + &group("Furniture", &of("Table"));
    let drawing = svg("viewBox=\"0 0 100 100\"", &body).unwrap();
    let layers: Vec<_> = drawing.layers.iter().map(|l| l.name.as_str()).collect();
    assert_eq!(layers, ["Walls", "Doors", "plan", "Furniture"]);
}

/// The widths of the strokes, rounded to a thousandth.
fn widths(drawing: &Drawing) -> Vec<f64> {
    drawing.strokes.iter().map(|stroke| (1e3 * stroke.width).round() / 1e3).collect()
}

#[test]
fn strokes_are_as_wide_as_they_are_drawn_and_hairlines_are_lines() {
    let line = |rest: &str| format!("<path d=\"M0 0H90\" {rest}/>");
    // 1 % and 0.3 % of the larger side; by attribute, by style and inherited, through scales and turns.
    let drawing = svg(
        "width=\"900\" height=\"450\" viewBox=\"0 0 90 45\"",
        &format!(
            "<g fill=\"none\" stroke=\"#000\" stroke-width=\"0.9\">{}{}{}{}{}</g>",
            line(""),
            line("stroke-width=\"0.3\""),
            line("style=\"stroke-width:2\""),
            line("transform=\"matrix(0 .5 -.5 0 9 0)\""),
            line("transform=\"scale(.5)\" style=\"stroke-width:1.8\""),
        ),
    );
    assert_eq!(widths(&drawing.unwrap()), [9.0, 0.0, 20.0, 4.5, 9.0]);
    let walls = "<path d=\"M0 0H90\" fill=\"none\" stroke=\"#000\" stroke-width=\"5\"";
    let millimetres = svg("width=\"90mm\" height=\"9mm\" viewBox=\"0 0 90 9\"", &format!("{walls}/>")).unwrap();
    assert_eq!(widths(&millimetres), [5.0]);
    // A width on the screen says nothing about the plan.
    let screen = svg("viewBox=\"0 0 90 9\"", &format!("{walls} vector-effect=\"non-scaling-stroke\"/>")).unwrap();
    assert_eq!(widths(&screen), [0.0]);
    // Caps reach beyond the ends.
    let capped = svg("viewBox=\"0 0 90 9\"", &format!("{walls} stroke-linecap=\"square\"/>")).unwrap();
    assert_eq!(rounded(&capped), [(-2.5, 9.0), (92.5, 9.0)]);
}

#[test]
fn svgs_that_cannot_be_are_refused() {
    let message = svg("viewBox=\"0 0 9 9\"", "<path d=\"M0 0\n\n H1\" stroke=\"red\"></g>").unwrap_err().to_string();
    assert!(message.starts_with("\"plan.svg\", line 3, column"), "{message}");
    let deep = svg("viewBox=\"0 0 9 9\"", &("<g>".repeat(5000) + LINE + &"</g>".repeat(5000)));
    assert!(deep.unwrap_err().to_string().contains("more than 100 nested elements"));
    let chain: String = (1..500).map(|i| format!("<g id=\"a{i}\"><use xlink:href=\"#a{}\"/></g>", i - 1)).collect();
    let chain = svg("viewBox=\"0 0 9 9\"", &format!("<g id=\"a0\">{LINE}</g>{chain}"));
    assert!(chain.unwrap_err().to_string().contains("more than 100 nested elements"));
    let laughs: String = (1..9)
        .map(|i| format!("<g id=\"a{i}\">{}</g>", format!("<use xlink:href=\"#a{}\"/>", i - 1).repeat(10)))
        .collect();
    assert!(svg("viewBox=\"0 0 9 9\"", &format!("<g id=\"a0\">{LINE}</g>{laughs}")).is_err());
    let itself = svg("viewBox=\"0 0 9 9\"", "<g id=\"a\"><use xlink:href=\"#a\"/></g>");
    assert!(itself.unwrap_err().to_string().contains("nothing in the drawing can be used"));
    assert!(svg("viewBox=\"0 0 9 9\"", "<path d=\"M0 0H1e30\" stroke=\"red\"/>").is_err());
    assert!(svg("width=\"0\" height=\"1\"", LINE).is_err());
}

#[test]
fn degrees_become_metres_around_their_middle() {
    let drawing = geo(
        "{\"type\":\"FeatureCollection\",\"features\":[{\"type\":\"Feature\",\"properties\":{\"name\":\"x\",\"layer\":\"walls\"},\
         \"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[[10.0,60.0],[10.001,60.0],[10.001,60.001],[10.0,60.0]]]}},\
         {\"type\":\"Feature\",\"properties\":{\"class\":\"furniture\"},\"geometry\":{\"type\":\"GeometryCollection\",\"geometries\":[\
         {\"type\":\"LineString\",\"coordinates\":[[10,60],[10.001,60.001]]},{\"type\":\"Point\",\"coordinates\":[10,60]}]}}]}",
    )
    .unwrap();
    assert_eq!(drawing.metre, Some(1.0));
    let names: Vec<_> = drawing.layers.iter().map(|l| (l.name.as_str(), l.role)).collect();
    assert_eq!(names, [("walls", Role::Wall), ("furniture", Role::Obstacle)]);
    // A thousandth of a degree is 111.195 m to the north, and half of that to the east at 60°.
    let size = drawing.points[2] - drawing.points[0];
    assert!((size.y - 111.195).abs() < 0.001 && (size.x - 55.597).abs() < 0.01, "{size}");
    assert_eq!((drawing.strokes[0].is_closed, drawing.strokes[1].is_closed), (true, false));
    assert_eq!(drawing.left_out, ["points (1)"]);
}

#[test]
fn plans_in_their_own_units_stay() {
    let room = "\"type\":\"Polygon\",\"coordinates\":[[[0,0],[8,0],[8,6],[0,6],[0,0]]]";
    let drawing = geo(&format!("{{{room}}}")).unwrap();
    assert_eq!((drawing.metre, drawing.points.len(), drawing.layers[0].name.as_str()), (None, 4, "0"));
    let crs = "\"crs\":{\"type\":\"name\",\"properties\":{\"name\":\"urn:ogc:def:crs:EPSG::25832\"}}";
    assert_eq!(geo(&format!("{{{crs},{room}}}")).unwrap().metre, Some(1.0));
}

#[test]
fn what_a_crs_calls_metres_need_not_be_any() {
    let crs = |name: &str, [x, y]: [f64; 2], size: f64| {
        let (right, top) = (x + size, y + size);
        let text = format!(
            "{{\"type\":\"Polygon\",\"crs\":{{\"type\":\"name\",\"properties\":{{\"name\":\"{name}\"}}}},\
             \"coordinates\":[[[{x},{y}],[{right},{y}],[{right},{top}],[{x},{y}]]]}}"
        );
        geo(&text).unwrap()
    };
    // The web maps' Mercator projection at 50° north: 31.11 of its units are 20 m.
    for name in ["urn:ogc:def:crs:EPSG::3857", "EPSG:900913"] {
        let metre = crs(name, [1e6, 6_446_275.0], 31.1).metre.unwrap();
        assert!((metre - 50.0_f64.to_radians().cos()).abs() < 1e-4, "{metre}");
    }
    // In unknown coordinate systems degrees stay degrees: a fifth of a thousandth of one is 22 m.
    let australia = crs("urn:ogc:def:crs:EPSG::4283", [151.0, -33.0], 0.0002);
    let height = australia.points[2].y - australia.points[0].y;
    assert!(australia.metre == Some(1.0) && (height - 22.24).abs() < 0.01, "{height}");
    // New York's grid is in feet.
    assert_eq!(crs("urn:ogc:def:crs:EPSG::2263", [1e6, 2e5], 30.0).metre, None);
    assert_eq!(crs("urn:ogc:def:crs:EPSG::32633", [4e5, 5e6], 30.0).metre, Some(1.0));
}

#[test]
fn curves_beyond_the_limit_are_refused_with_their_path() {
    let loops = "C900 900 0 900 900 0C900 900 0 900 0 300".repeat(20_000);
    let message = svg("viewBox=\"0 0 9 9\"", &format!("{LINE}<path stroke=\"red\" d=\"M0 0{loops}\"/>"));
    let message = message.unwrap_err().to_string();
    assert!(message.contains("path 2") && message.contains("more than 2000000 corners"), "{message}");
}

#[test]
fn geojson_that_cannot_be_is_refused() {
    for (text, expected) in [
        ("{\"type\":\"Feature\",\"geometry\":", "cut off"),
        ("{\"type\":\"FeatureCollection\",\"features\":[}", "line 1, column"),
        ("{\"type\":\"Polygon\",\"coordinates\":[[[1]]]}", "feature 1"),
        ("{\"type\":\"LineString\",\"coordinates\":[[0,0],[1e300,0]]}", "is out of range (-1e10 to 1e10)"),
        ("{\"type\":\"FeatureCollection\",\"features\":[]}", "nothing in the drawing can be used"),
    ] {
        let message = geo(text).unwrap_err().to_string();
        assert!(message.contains(expected), "{text}: {message}");
    }
    let deep = "{\"type\":\"GeometryCollection\",\"geometries\":[".repeat(5000);
    assert!(geo(&deep).is_err());
}
