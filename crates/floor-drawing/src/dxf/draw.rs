//! Entities as polylines.

use super::{
    entity::{Entity, EntityKind},
    local::{Affine, DxfContent, EntitySource, Insert},
};
use crate::{
    DrawingFlaw,
    flatten::{Nurbs, bulge, ellipse, through},
    model::MAX_POINTS,
};
use robovac_core::{
    geometry::{Point, Vector},
    math::{TAU, sin_cos},
};

impl Entity<'_> {
    /// Draws the entity; an `Err` is its name in the list of what is left out. `block` is the name of the block that it
    /// inserts.
    pub fn draw(
        &self,
        source: EntitySource,
        block: String,
        content: &mut DxfContent,
    ) -> Result<Option<&'static str>, DrawingFlaw> {
        let Some(map) = self.mirror() else { return Ok(Some("entities in tilted planes")) };
        let to_plan = |point| map.apply(point);
        match self.kind {
            EntityKind::Line => content.stroke(source, false, [10, 11].map(|code| self.point(code)))?,
            EntityKind::LwPolyline | EntityKind::Polyline => {
                content.stroke(source, self.is_closed(), self.corners().into_iter().map(to_plan))?;
            }
            EntityKind::Circle | EntityKind::Arc => {
                let radius = self.last(40, 0.0);
                let [start, end] = [self.last(50, 0.0), self.last(51, 360.0)].map(f64::to_radians);
                let (major, minor) = (Vector::new(radius, 0.0), Vector::new(0.0, radius));
                let (points, is_closed) = ellipse(self.point(10), major, minor, start, end);
                content.stroke(source, is_closed, points.into_iter().map(to_plan))?;
            }
            EntityKind::Ellipse => {
                let major = Vector::new(self.last(11, 1.0), self.last(21, 0.0));
                // The centre and the axis are the world's; the minor axis is the normal times the major one.
                let minor = Vector::new(-major.y, major.x) * (self.last(40, 1.0) * map.x.x);
                let (start, end) = (self.last(41, 0.0), self.last(42, TAU));
                let (points, is_closed) = ellipse(self.point(10), major, minor, start, end);
                content.stroke(source, is_closed, points)?;
            }
            EntityKind::Spline => content.stroke(source, self.is_closed(), self.curve())?,
            // The third and fourth corner are crossed.
            EntityKind::Solid => {
                content.stroke(source, true, [10, 11, 13, 12].map(|code| to_plan(self.point(code))))?;
            }
            EntityKind::Face => content.stroke(source, true, [10, 11, 12, 13].map(|code| self.point(code)))?,
            EntityKind::Insert => content.insert(self.insert(source, block, &map))?,
        }
        Ok(None)
    }

    /// Direction of its own x axis, if it has a plane of its own: an extrusion downwards mirrors it (the DXF
    /// reference's arbitrary axis algorithm). `None` if its plane is tilted.
    fn mirror(&self) -> Option<Affine> {
        if self.is_in_world() {
            return Some(Affine::IDENTITY);
        }
        let [x, y, z] = [self.last(210, 0.0), self.last(220, 0.0), self.last(230, 1.0)];
        let level = 1e-3 * z.abs();
        let is_level = x.abs() <= level && y.abs() <= level && z != 0.0;
        let x = if z < 0.0 { -1.0 } else { 1.0 };
        is_level.then_some(Affine { x: Vector::new(x, 0.0), ..Affine::IDENTITY })
    }

    fn point(&self, code: i32) -> Point {
        Point::new(self.last(code, 0.0), self.last(code + 10, 0.0))
    }

    /// Corners of a polyline with those of its arcs; at most a little more than [`MAX_POINTS`], which is then refused.
    fn corners(&self) -> Vec<Point> {
        let mut vertices: Vec<(Point, f64)> = Vec::new();
        for &(code, value) in &self.numbers {
            match (code, vertices.last_mut()) {
                (10, _) => vertices.push((Point::new(value, 0.0), 0.0)),
                (20, Some((at, _))) => at.y = value,
                (42, Some((_, bulge))) => *bulge = value,
                _ => {}
            }
        }
        let mut points = Vec::with_capacity(vertices.len());
        for (i, &(here, turn)) in vertices.iter().enumerate() {
            if points.len() > MAX_POINTS {
                break;
            }
            points.push(here);
            let first = vertices.first().filter(|_| self.is_closed());
            if let Some(&(next, _)) = vertices.get(i + 1).or(first) {
                bulge(here, next, turn, &mut points);
            }
        }
        points
    }

    fn curve(&self) -> Vec<Point> {
        let points = |code| self.all(code).zip(self.all(code + 10)).map(|(x, y)| Point::new(x, y)).collect::<Vec<_>>();
        let controls = points(10);
        if controls.is_empty() {
            return through(&points(11), self.is_closed());
        }
        let [knots, weights] = [40, 41].map(|code| self.all(code).collect::<Vec<_>>());
        let degree = self.last(71, 1.0) as usize;
        Nurbs { degree, knots: &knots, weights: &weights, controls: &controls }.flatten()
    }

    fn insert(&self, source: EntitySource, block: String, mirror: &Affine) -> Insert {
        let (sin, cos) = sin_cos(self.last(50, 0.0).to_radians());
        let turn = Affine { x: Vector::new(cos, sin), y: Vector::new(-sin, cos), origin: self.point(10).coords };
        let turn = mirror.after(&turn);
        let or_one = |scale: f64| if scale == 0.0 { 1.0 } else { scale };
        Insert {
            source,
            block,
            map: Affine { x: turn.x * or_one(self.last(41, 1.0)), y: turn.y * or_one(self.last(42, 1.0)), ..turn },
            count: [70, 71].map(|code| self.last(code, 1.0).max(1.0) as u32),
            step: [turn.x * self.last(44, 0.0), turn.y * self.last(45, 0.0)],
        }
    }

    /// Its last number with that group code.
    fn last(&self, code: i32, default: f64) -> f64 {
        self.numbers.iter().rev().find(|number| number.0 == code).map_or(default, |number| number.1)
    }

    /// All its numbers with that group code.
    fn all(&self, code: i32) -> impl Iterator<Item = f64> {
        self.numbers.iter().filter(move |number| number.0 == code).map(|number| number.1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_polyline_of_arcs_is_not_flattened_far_beyond_the_limit() {
        let mut polyline = Entity::new(EntityKind::LwPolyline, 1, 1, 0);
        polyline.numbers = (0..100_000).flat_map(|i| [(10, f64::from(i % 2)), (42, 9.0)]).collect();
        let corners = polyline.corners().len();
        assert!((MAX_POINTS + 1..MAX_POINTS + 80).contains(&corners), "{corners}");
    }
}
