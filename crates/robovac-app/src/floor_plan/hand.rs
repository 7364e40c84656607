//! Pointing on the drawing: two points of a known distance, corners of a region. By pointer, or by a crosshair moved
//! with keys.

use super::DrawingPart;
use robovac_core::geometry::{Point, Vector};
use serde::{Deserialize, Serialize};

/// What clicks mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum DrawingTool {
    /// Nothing; dragging moves the view.
    #[default]
    View,
    /// Two points whose distance is known.
    Scale,
    /// Two corners of an upright rectangle.
    Rectangle,
    /// Corners of a polygon, until it is closed.
    Polygon,
    /// A point in a room.
    Room,
}

/// The hand; all points are in the drawing's unit.
#[derive(Debug, Clone, Default)]
pub struct DrawingHand {
    /// What clicks mean.
    pub tool: DrawingTool,
    /// Points so far.
    pub points: Vec<Point>,
    /// The crosshair, if keys are used.
    pub crosshair: Option<Point>,
    /// Where the pointer is.
    pub hover: Option<Point>,
}

impl DrawingHand {
    /// Takes another tool.
    pub fn take(&mut self, tool: DrawingTool) {
        // The crosshair stays where it is: the next tool may be wanted at the same place.
        *self = Self { tool, crosshair: self.crosshair, ..Self::default() };
    }

    /// A click; the part that is meant, once that is known. Points closer than `near` are the same.
    pub fn click(&mut self, at: Point, near: f64) -> Option<DrawingPart> {
        let is_near = |point: Option<&Point>| point.is_some_and(|point| (point - at).norm() <= near);
        match self.tool {
            DrawingTool::View => None,
            DrawingTool::Scale => {
                if self.points.len() >= 2 {
                    self.points.clear();
                }
                if !is_near(self.points.first()) {
                    self.points.push(at);
                }
                None
            }
            DrawingTool::Rectangle => match self.points.first() {
                // A rectangle without an inside is a slip of the hand.
                Some(first) if (first.x - at.x).abs() > near && (first.y - at.y).abs() > near => {
                    let corners = [[first.x, first.y], [at.x, at.y]];
                    Some(self.done(DrawingPart::Rectangle { corners }))
                }
                Some(_) => None,
                None => {
                    self.points.push(at);
                    None
                }
            },
            DrawingTool::Polygon if is_near(self.points.last()) || is_near(self.points.first()) => self.close(),
            DrawingTool::Polygon => {
                self.points.push(at);
                None
            }
            DrawingTool::Room => Some(self.done(DrawingPart::Room { at: [at.x, at.y] })),
        }
    }

    /// Closes a polygon that has three corners.
    pub fn close(&mut self) -> Option<DrawingPart> {
        if self.tool != DrawingTool::Polygon || self.points.len() < 3 {
            return None;
        }
        let corners = self.points.iter().map(|point| [point.x, point.y]).collect();
        Some(self.done(DrawingPart::Polygon { corners }))
    }

    /// The key that clicks: at the crosshair; where nothing is between it and the last corner, a polygon is closed.
    pub fn apply(&mut self, near: f64) -> Option<DrawingPart> {
        match self.crosshair {
            Some(at) => self.click(at, near),
            None => self.close(),
        }
    }

    /// Moves the crosshair, which begins at `from`.
    pub fn nudge(&mut self, by: Vector, from: Point) {
        self.crosshair = Some(self.crosshair.unwrap_or(from) + by);
    }

    /// Takes back the points, or else lays the tool down; whether there was anything to do.
    pub fn escape(&mut self) -> bool {
        if self.points.is_empty() {
            let had_tool = self.tool != DrawingTool::View;
            self.take(DrawingTool::View);
            self.crosshair = None;
            return had_tool;
        }
        self.points.clear();
        true
    }

    /// Distance of the two points whose distance is to be said, in the drawing's unit.
    pub fn measured(&self) -> Option<f64> {
        match self.points[..] {
            [a, b] if self.tool == DrawingTool::Scale => Some((b - a).norm()),
            _ => None,
        }
    }

    fn done(&mut self, part: DrawingPart) -> DrawingPart {
        self.take(DrawingTool::View);
        part
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hand(tool: DrawingTool) -> DrawingHand {
        let mut hand = DrawingHand::default();
        hand.take(tool);
        hand
    }

    #[test]
    fn a_polygon_closes_at_its_first_or_last_corner_and_not_before_it_has_three() {
        let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0)].map(|(x, y)| Point::new(x, y));
        for last in [corners[0], corners[2]] {
            let mut hand = hand(DrawingTool::Polygon);
            assert_eq!(hand.click(corners[0], 0.1), None);
            assert_eq!(hand.click(corners[0], 0.1), None, "one corner is no polygon");
            assert_eq!(hand.click(corners[1], 0.1), None);
            assert_eq!(hand.click(corners[2], 0.1), None);
            let part = hand.click(last, 0.1);
            assert_eq!(part, Some(DrawingPart::Polygon { corners: vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0]] }));
            assert_eq!(hand.tool, DrawingTool::View);
        }
    }

    #[test]
    fn keys_do_what_clicks_do() {
        let mut hand = hand(DrawingTool::Scale);
        hand.nudge(Vector::new(1.0, 0.0), Point::new(5.0, 5.0));
        hand.apply(0.1);
        assert_eq!(hand.measured(), None);
        hand.nudge(Vector::new(0.0, 3.0), Point::new(5.0, 5.0));
        hand.apply(0.1);
        assert_eq!(hand.measured(), Some(3.0));
        hand.apply(0.1);
        assert_eq!(hand.measured(), None, "a third point begins anew");
    }

    #[test]
    fn a_flat_rectangle_is_none() {
        let mut hand = hand(DrawingTool::Rectangle);
        hand.click(Point::new(0.0, 0.0), 0.1);
        assert_eq!(hand.click(Point::new(9.0, 0.0), 0.1), None);
        assert_eq!(
            hand.click(Point::new(2.0, 1.0), 0.1),
            Some(DrawingPart::Rectangle { corners: [[0.0, 0.0], [2.0, 1.0]] })
        );
    }

    #[test]
    fn escape_takes_back_points_before_the_tool() {
        let mut hand = hand(DrawingTool::Polygon);
        hand.click(Point::new(0.0, 0.0), 0.1);
        assert!(hand.escape() && hand.tool == DrawingTool::Polygon && hand.points.is_empty());
        assert!(hand.escape() && hand.tool == DrawingTool::View);
        assert!(!hand.escape());
    }
}
