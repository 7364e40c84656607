//! Pointing on the drawing: two points of a known distance, corners of a region. By pointer, or by a crosshair moved
//! with keys.

use super::DrawingPart;
use robovac_core::geometry::{Point, Vector};
use serde::{Deserialize, Serialize};

/// Tools for clicks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum DrawingTool {
    /// None; dragging pans the view.
    #[default]
    View,
    /// Two points of a known distance.
    Scale,
    /// Two opposite corners of an axis-aligned rectangle.
    Rectangle,
    /// Corners of a polygon, until it is closed.
    Polygon,
    /// A point in a room.
    Room,
}

/// State of pointing; all points are in the drawing's unit.
#[derive(Debug, Clone, Default)]
pub struct DrawingHand {
    /// The tool for clicks.
    pub tool: DrawingTool,
    /// Points set so far.
    pub points: Vec<Point>,
    /// The crosshair, if keys are used.
    pub crosshair: Option<Point>,
    /// Position of the pointer.
    pub hover: Option<Point>,
}

impl DrawingHand {
    /// Selects another tool.
    pub fn take(&mut self, tool: DrawingTool) {
        // The crosshair stays: the next tool can be needed at the same place.
        *self = Self { tool, crosshair: self.crosshair, ..Self::default() };
    }

    /// A click; returns the part once it is complete. Points closer than `near` are the same.
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
                // A rectangle without area is a slip.
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

    /// Closes a polygon of at least three corners.
    pub fn close(&mut self) -> Option<DrawingPart> {
        if self.tool != DrawingTool::Polygon || self.points.len() < 3 {
            return None;
        }
        let corners = self.points.iter().map(|point| [point.x, point.y]).collect();
        Some(self.done(DrawingPart::Polygon { corners }))
    }

    /// A click by key at the crosshair; if it lies on the last corner, the polygon is closed.
    pub fn apply(&mut self, near: f64) -> Option<DrawingPart> {
        match self.crosshair {
            Some(at) => self.click(at, near),
            None => self.close(),
        }
    }

    /// Moves the crosshair, which starts at `from`.
    pub fn nudge(&mut self, by: Vector, from: Point) {
        self.crosshair = Some(self.crosshair.unwrap_or(from) + by);
    }

    /// Removes the points, or else deselects the tool; returns whether it did either.
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

    /// Distance of the two scale points, in the drawing's unit.
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
        assert_eq!(hand.measured(), None, "a third point starts again");
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
