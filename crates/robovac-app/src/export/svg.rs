//! A room and a path as an SVG drawing.

use robovac_core::{
    coverage::obstacles,
    floor_plan::FloorPlan,
    geometry::{Point, Shape},
    grid::{Cell, Grid, Occupancy, outlines},
};
use std::fmt::Write;

/// No limit: `outlines` always returns them.
const MOST_CORNERS: usize = usize::MAX;

/// Walls, unknown floor, furniture and, if it isn't empty, a path with its start and end. One unit is a millimetre, x to the
/// right; y is turned, as SVG counts downwards. The colours are those of a plan on paper.
pub fn to_svg(plan: &FloorPlan, path: &[Point]) -> String {
    let (width, height) = (plan.width_m() * MM, plan.height_m() * MM);
    let page = Page { height };
    let mut svg = String::new();
    // Writing to a string can't fail.
    let _ = write!(
        svg,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}mm\" height=\"{height:.0}mm\" viewBox=\"0 0 {width:.0} {height:.0}\">\n\
         <title>{title}</title>\n<desc>{width_m:.2} m x {height_m:.2} m; one unit is one millimetre</desc>\n\
         <rect id=\"floor\" width=\"{width:.0}\" height=\"{height:.0}\" fill=\"#fff\"/>\n",
        title = escaped(&plan.name),
        width_m = plan.width_m(),
        height_m = plan.height_m(),
    );
    for (id, fill, state) in [("unknown", "#ddd", Occupancy::Unknown), ("walls", "#333", Occupancy::Occupied)] {
        let shape = page.cells(&plan.occupancy.map(|&cell| cell == state), plan.resolution);
        if !shape.is_empty() {
            let _ = writeln!(svg, "<path id=\"{id}\" fill=\"{fill}\" fill-rule=\"evenodd\" d=\"{shape}\"/>");
        }
    }
    let shapes = obstacles(plan);
    if !shapes.is_empty() {
        svg.push_str("<g id=\"furniture\" fill=\"#999\">\n");
        for shape in &shapes {
            page.shape(&mut svg, shape);
        }
        svg.push_str("</g>\n");
    }
    if let (Some(first), Some(last)) = (path.first(), path.last()) {
        let line = page.line(path, false);
        let _ = write!(
            svg,
            "<g id=\"path\">\n\
             <path id=\"line\" fill=\"none\" stroke=\"#0072b2\" stroke-width=\"20\" stroke-linejoin=\"round\" d=\"{line}\"/>\n\
             <circle id=\"start\" cx=\"{:.0}\" cy=\"{:.0}\" r=\"60\" fill=\"#0072b2\"/>\n\
             <circle id=\"end\" cx=\"{:.0}\" cy=\"{:.0}\" r=\"50\" fill=\"none\" stroke=\"#d55e00\" stroke-width=\"25\"/>\n\
             </g>\n",
            first.x * MM,
            page.y(first.y),
            last.x * MM,
            page.y(last.y)
        );
    }
    svg.push_str("</svg>\n");
    svg
}

/// Units in a metre.
const MM: f64 = 1000.0;

/// Lower end of the drawing.
struct Page {
    height: f64,
}

impl Page {
    fn y(&self, metres: f64) -> f64 {
        self.height - metres * MM
    }

    fn line(&self, points: &[Point], is_closed: bool) -> String {
        let mut line = String::new();
        for (i, point) in points.iter().enumerate() {
            let _ = write!(line, "{}{:.1} {:.1}", if i == 0 { "M" } else { "L" }, point.x * MM, self.y(point.y));
        }
        if is_closed {
            line.push('Z');
        }
        line
    }

    fn cells(&self, cells: &Grid<bool>, resolution: f64) -> String {
        let corner = |cell: &Cell| Point::new(f64::from(cell.x) * resolution, f64::from(cell.y) * resolution);
        let loops = outlines(cells, MOST_CORNERS).unwrap_or_default();
        loops.iter().map(|outline| self.line(&outline.iter().map(corner).collect::<Vec<_>>(), true)).collect()
    }

    fn shape(&self, svg: &mut String, shape: &Shape) {
        let _ = match shape {
            Shape::Disc { centre, radius } => writeln!(
                svg,
                "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"{:.1}\"/>",
                centre.x * MM,
                self.y(centre.y),
                radius * MM
            ),
            Shape::Convex(corners) => writeln!(svg, "<path d=\"{}\"/>", self.line(corners, true)),
        };
    }
}

/// Text escaped for XML: names come from files.
fn escaped(text: &str) -> String {
    let is_allowed = |c: &char| !c.is_control();
    text.chars().filter(is_allowed).fold(String::new(), |mut escaped, c| {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            other => escaped.push(other),
        }
        escaped
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{floor_plan::Object, geometry::Pose, grid::from_picture};

    #[test]
    fn y_is_turned_and_names_are_escaped() {
        let plan = FloorPlan {
            name: "<a & b>".into(),
            note: String::new(),
            resolution: 0.5,
            occupancy: from_picture("#.\n..\n", |c| if c == '#' { Occupancy::Occupied } else { Occupancy::Free })
                .unwrap(),
            objects: vec![Object::Leg { at: Point::new(0.75, 0.25), radius: 0.1 }],
            start: None,
            origin: Pose::new(0.0, 0.0, 0.0),
        };
        let svg = to_svg(&plan, &[Point::new(0.25, 0.25), Point::new(0.75, 0.75)]);
        for part in [
            "viewBox=\"0 0 1000 1000\"",
            "<title>&lt;a &amp; b&gt;</title>",
            "d=\"M0.0 500.0L500.0 500.0L500.0 0.0L0.0 0.0Z\"",
            "<circle cx=\"750.0\" cy=\"750.0\" r=\"100.0\"/>",
            "d=\"M250.0 750.0L750.0 250.0\"",
        ] {
            assert!(svg.contains(part), "{part} isn't in {svg}");
        }
    }
}
