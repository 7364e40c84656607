//! `--units`, `--layer`, `--gap`, `--resolution`, `--region`: how a room is traced from a drawing.

use super::failure::Failure;
use floor_drawing::{Drawing, DrawingRegion, Role, Traced, Tracing, read, trace};
use robovac_core::{floor_plan::SourceFile, geometry::Point};

/// Only for drawings (DXF, SVG, GeoJSON).
#[derive(clap::Args)]
pub struct DrawingOptions {
    /// Drawing unit: mm, cm, m, in, ft or its length in metres [default: as stated in the drawing]
    #[arg(long)]
    units: Option<String>,
    /// Role of a layer: NAME=wall, NAME=obstacle or NAME=ignored; can be repeated [default: guessed from the name]
    #[arg(long = "layer", value_name = "NAME=ROLE")]
    layers: Vec<String>,
    /// Close gaps between wall ends up to this width, m
    #[arg(long, value_name = "M", default_value_t = 0.1)]
    gap: f64,
    /// Cell size of the room, m
    #[arg(long, value_name = "M", default_value_t = 0.05)]
    resolution: f64,
    /// Region to use: whole, room:X,Y (the room around that point), rectangle:X,Y,X,Y or polygon:X,Y,X,Y,...; in
    /// drawing units
    #[arg(long, default_value = "whole", allow_hyphen_values = true)]
    region: String,
}

impl DrawingOptions {
    /// The room in a drawing, and where it is there.
    pub fn trace(&self, file: &SourceFile) -> Result<Traced, Failure> {
        let drawing = read(file)?;
        let how = Tracing {
            roles: self.roles(&drawing)?,
            metre: self.metre(&drawing)?,
            gap: self.gap,
            resolution: self.resolution,
            region: self.region()?,
        };
        Ok(trace(&drawing, &how)?)
    }

    fn metre(&self, drawing: &Drawing) -> Result<f64, Failure> {
        let Some(units) = &self.units else {
            return drawing.metre.ok_or_else(|| {
                Failure::usage("the drawing doesn't state its unit; add --units, e.g. --units mm".to_owned())
            });
        };
        match units.as_str() {
            "mm" => Ok(0.001),
            "cm" => Ok(0.01),
            "m" => Ok(1.0),
            "in" => Ok(0.0254),
            "ft" => Ok(0.3048),
            other => other.parse().map_err(|_| {
                Failure::usage(format!("--units {other}: use mm, cm, m, in, ft or the length of a unit in metres"))
            }),
        }
    }

    fn roles(&self, drawing: &Drawing) -> Result<Vec<Role>, Failure> {
        let mut roles: Vec<Role> = drawing.layers.iter().map(|layer| layer.role).collect();
        for given in &self.layers {
            let bad = |what: &str| Err(Failure::usage(format!("--layer {given}: {what}")));
            let Some((name, role)) = given.rsplit_once('=') else {
                return bad("write NAME=wall, NAME=obstacle or NAME=ignored");
            };
            let role = match role {
                "wall" => Role::Wall,
                "obstacle" => Role::Obstacle,
                "ignored" => Role::Ignored,
                _ => return bad("a layer is wall, obstacle or ignored"),
            };
            let Some(index) = drawing.layers.iter().position(|layer| layer.name == name) else {
                let names: Vec<&str> = drawing.layers.iter().map(|layer| layer.name.as_str()).collect();
                return bad(&format!("the drawing has no such layer, it has {}", names.join(", ")));
            };
            roles[index] = role;
        }
        Ok(roles)
    }

    fn region(&self) -> Result<DrawingRegion, Failure> {
        let bad = || {
            let given = &self.region;
            Failure::usage(format!("--region {given}: use whole, room:X,Y, rectangle:X,Y,X,Y or polygon:X,Y,X,Y,X,Y"))
        };
        if self.region == "whole" {
            return Ok(DrawingRegion::WHOLE);
        }
        let (kind, numbers) = self.region.split_once(':').ok_or_else(bad)?;
        let numbers: Vec<f64> =
            numbers.split(',').map(|number| number.trim().parse()).collect::<Result<_, _>>().map_err(|_| bad())?;
        let points: Vec<Point> = numbers.chunks_exact(2).map(|pair| Point::new(pair[0], pair[1])).collect();
        match (kind, points.as_slice()) {
            _ if numbers.len() % 2 == 1 => Err(bad()),
            ("room", &[at]) => Ok(DrawingRegion::Room(at)),
            ("rectangle", &[low, high]) => Ok(DrawingRegion::Rectangle { low, high }),
            ("polygon", [_, _, _, ..]) => Ok(DrawingRegion::Polygon(points)),
            _ => Err(bad()),
        }
    }
}
