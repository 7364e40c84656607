//! Entities as the `dxf` crate reads them, as polylines.
//!
//! The crate gets them a few thousand at a time, as a drawing of nothing but entities whose group codes and numbers have
//! been checked (see [`super::entity`]): so its memory stays small, no damaged file reaches it, and what it thinks up for a
//! new drawing (time stamps, identifiers) is never looked at.

use super::local::{Affine, Content, Insert, Source};
use crate::{
    flatten::{Nurbs, bulge, ellipse, through},
    model::MAX_POINTS,
};
use dxf::entities::{EntityType, LwPolyline, Spline};
use robovac_core::{
    floorplan::DrawingFlaw,
    geometry::{Point, Vector},
    math::{TAU, sin_cos},
};
use std::fmt::Write;

/// Entities and bytes after which the crate reads what has come together.
const BATCH: (usize, usize) = (4096, 1 << 19);

/// Entities that wait to be read.
pub(super) struct Batch {
    text: String,
    /// Where they come from, and the block's name of inserts.
    sources: Vec<(Source, String)>,
}

impl Batch {
    pub fn new() -> Self {
        Self { text: String::new(), sources: Vec::new() }
    }

    /// Begins an entity.
    pub fn begin(&mut self, kind: &str, source: Source, block: String) {
        if self.sources.is_empty() {
            self.text.push_str("0\nSECTION\n2\nENTITIES\n");
        }
        self.text.push_str("0\n");
        self.text.push_str(kind);
        self.text.push('\n');
        self.sources.push((source, block));
    }

    /// A number of the entity that was begun last.
    pub fn real(&mut self, code: i32, value: f64) {
        // Writing to a string doesn't fail.
        let _ = writeln!(self.text, "{code}\n{value:?}");
    }

    /// An integer of the entity that was begun last.
    pub fn whole(&mut self, code: i32, value: i64) {
        let value = value.clamp(i16::MIN.into(), i16::MAX.into());
        let _ = writeln!(self.text, "{code}\n{value}");
    }

    pub fn is_full(&self) -> bool {
        self.sources.len() >= BATCH.0 || self.text.len() >= BATCH.1
    }

    /// Reads what waits.
    pub fn flush(&mut self, content: &mut Content, left_out: &mut dyn FnMut(&'static str)) -> Result<(), Refused> {
        if self.sources.is_empty() {
            return Ok(());
        }
        self.text.push_str("0\nENDSEC\n0\nEOF\n");
        let sources = std::mem::take(&mut self.sources);
        let refused = |at: usize, flaw| Refused { source: sources[at.min(sources.len() - 1)].0, flaw };
        let read = dxf::Drawing::load(&mut self.text.as_bytes());
        self.text.clear();
        let drawing = read.map_err(|error| refused(0, DrawingFlaw::Parser { cause: error.to_string() }))?;
        let mut count = 0;
        for (entity, (source, block)) in drawing.entities().zip(&sources) {
            let drawn = draw(&entity.specific, *source, block, content).map_err(|flaw| refused(count, flaw))?;
            if let Drawn::No(what) = drawn {
                left_out(what);
            }
            count += 1;
        }
        if count < sources.len() {
            return Err(refused(count, DrawingFlaw::Structure { what: "an entity can't be understood" }));
        }
        Ok(())
    }
}

/// An entity that is refused.
pub(super) struct Refused {
    pub source: Source,
    pub flaw: DrawingFlaw,
}

enum Drawn {
    Yes,
    No(&'static str),
}

/// Where a planar entity's own x axis points: an extrusion downwards mirrors it (the DXF reference's arbitrary axis
/// algorithm). `None` if its plane is tilted.
fn mirror(normal: &dxf::Vector) -> Option<Affine> {
    let level = 1e-3 * normal.z.abs();
    let is_level = normal.x.abs() <= level && normal.y.abs() <= level && normal.z != 0.0;
    let x = if normal.z < 0.0 { -1.0 } else { 1.0 };
    is_level.then_some(Affine { x: Vector::new(x, 0.0), ..Affine::IDENTITY })
}

fn at(point: &dxf::Point) -> Point {
    Point::new(point.x, point.y)
}

fn draw(entity: &EntityType, source: Source, block: &str, content: &mut Content) -> Result<Drawn, DrawingFlaw> {
    const TILTED: Drawn = Drawn::No("entities in tilted planes");
    match entity {
        EntityType::Line(line) => content.stroke(source, false, [at(&line.p1), at(&line.p2)])?,
        EntityType::LwPolyline(polyline) => {
            let Some(map) = mirror(&polyline.extrusion_direction) else { return Ok(TILTED) };
            let points = corners(polyline);
            content.stroke(source, polyline.flags & 1 != 0, points.into_iter().map(|point| map.apply(point)))?;
        }
        EntityType::Circle(circle) => {
            let Some(map) = mirror(&circle.normal) else { return Ok(TILTED) };
            round(content, source, &map, at(&circle.center), circle.radius, [0.0, TAU])?;
        }
        EntityType::Arc(arc) => {
            let Some(map) = mirror(&arc.normal) else { return Ok(TILTED) };
            let ends = [arc.start_angle.to_radians(), arc.end_angle.to_radians()];
            round(content, source, &map, at(&arc.center), arc.radius, ends)?;
        }
        EntityType::Ellipse(given) => {
            let Some(map) = mirror(&given.normal) else { return Ok(TILTED) };
            let major = Vector::new(given.major_axis.x, given.major_axis.y);
            // The centre and the axis are the world's; the minor axis is the normal times the major one.
            let minor = Vector::new(-major.y, major.x) * (given.minor_axis_ratio * map.x.x);
            let (points, is_closed) =
                ellipse(at(&given.center), major, minor, given.start_parameter, given.end_parameter);
            content.stroke(source, is_closed, points)?;
        }
        EntityType::Spline(spline) => content.stroke(source, spline.flags & 1 != 0, curve(spline))?,
        EntityType::Solid(solid) => {
            let Some(map) = mirror(&solid.extrusion_direction) else { return Ok(TILTED) };
            let [a, b, c, d] = [&solid.first_corner, &solid.second_corner, &solid.third_corner, &solid.fourth_corner];
            // The third and fourth corner are crossed.
            content.stroke(source, true, [a, b, d, c].map(|corner| map.apply(at(corner))))?;
        }
        EntityType::Trace(trace) => {
            let Some(map) = mirror(&trace.extrusion_direction) else { return Ok(TILTED) };
            let [a, b, c, d] = [&trace.first_corner, &trace.second_corner, &trace.third_corner, &trace.fourth_corner];
            content.stroke(source, true, [a, b, d, c].map(|corner| map.apply(at(corner))))?;
        }
        EntityType::Face3D(face) => {
            let corners = [&face.first_corner, &face.second_corner, &face.third_corner, &face.fourth_corner];
            content.stroke(source, true, corners.map(at))?;
        }
        EntityType::Insert(given) => {
            let Some(mirror) = mirror(&given.extrusion_direction) else { return Ok(TILTED) };
            let (sin, cos) = sin_cos(given.rotation.to_radians());
            let or_one = |scale: f64| if scale == 0.0 { 1.0 } else { scale };
            let turn = Affine {
                x: Vector::new(cos, sin),
                y: Vector::new(-sin, cos),
                origin: Vector::new(given.location.x, given.location.y),
            };
            let turn = mirror.after(&turn);
            let map =
                Affine { x: turn.x * or_one(given.x_scale_factor), y: turn.y * or_one(given.y_scale_factor), ..turn };
            let counted = |count: i16| u32::try_from(count).unwrap_or(1).max(1);
            let insert = Insert {
                source,
                block: block.to_owned(),
                map,
                count: [counted(given.column_count), counted(given.row_count)],
                step: [turn.x * given.column_spacing, turn.y * given.row_spacing],
            };
            content.insert(insert)?;
        }
        _ => return Ok(Drawn::No("other entities")),
    }
    Ok(Drawn::Yes)
}

/// A circle or an arc from one angle counter-clockwise to the other, radians.
fn round(
    content: &mut Content,
    source: Source,
    map: &Affine,
    centre: Point,
    radius: f64,
    [start, end]: [f64; 2],
) -> Result<(), DrawingFlaw> {
    let (points, is_closed) = ellipse(centre, Vector::new(radius, 0.0), Vector::new(0.0, radius), start, end);
    content.stroke(source, is_closed, points.into_iter().map(|point| map.apply(point)))
}

/// Its corners with those of its arcs; a little more than [`MAX_POINTS`] at most, which is refused then.
fn corners(polyline: &LwPolyline) -> Vec<Point> {
    let vertices = &polyline.vertices;
    let mut points = Vec::with_capacity(vertices.len());
    for (i, vertex) in vertices.iter().enumerate() {
        if points.len() > MAX_POINTS {
            break;
        }
        let here = Point::new(vertex.x, vertex.y);
        points.push(here);
        let next = match vertices.get(i + 1) {
            None if polyline.flags & 1 != 0 => vertices.first(),
            next => next,
        };
        if let Some(next) = next {
            bulge(here, Point::new(next.x, next.y), vertex.bulge, &mut points);
        }
    }
    points
}

fn curve(spline: &Spline) -> Vec<Point> {
    let points = |points: &[dxf::Point]| -> Vec<Point> { points.iter().map(at).collect() };
    if spline.control_points.is_empty() {
        return through(&points(&spline.fit_points), spline.flags & 1 != 0);
    }
    Nurbs {
        degree: usize::try_from(spline.degree_of_curve).unwrap_or(0),
        knots: &spline.knot_values,
        weights: &spline.weight_values,
        controls: &points(&spline.control_points),
    }
    .flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polyline_of_arcs_is_not_flattened_far_beyond_the_limit() {
        let vertex = |i: usize| dxf::LwPolylineVertex { x: (i % 2) as f64, bulge: 9.0, ..Default::default() };
        let polyline = LwPolyline { vertices: (0..100_000).map(vertex).collect(), ..LwPolyline::default() };
        let corners = corners(&polyline).len();
        assert!((MAX_POINTS + 1..MAX_POINTS + 80).contains(&corners), "{corners}");
    }
}
