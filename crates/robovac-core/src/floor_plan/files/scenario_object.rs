//! Objects in scenario files: the kind, then its properties.

use super::{Object, ScenarioPose, Who};
use crate::geometry::{Point, Pose};
use serde::{Deserialize, Serialize};

/// A point: x and y, m.
type At = [f64; 2];

/// An [`Object`] in JSON, e.g. `{ "leg": { "at": [1.2, 0.8], "radius": 0.02 } }`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields, expecting = "an object of one key, its kind")]
pub(super) enum ScenarioObject {
    Furniture { outline: Vec<At> },
    Leg { at: At, radius: f64 },
    LowObstacle { outline: Vec<At>, height: f64 },
    DropOff { outline: Vec<At> },
    Carpet { outline: Vec<At> },
    Dirt { at: At, radius: f64 },
    Dock(ScenarioPose),
    VirtualWall(Beam),
    Mover { who: Who, path: Vec<At> },
}

/// A virtual wall: a pose with a length, in one object.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "an object with x, y and length")]
pub(super) struct Beam {
    x: f64,
    y: f64,
    #[serde(default)]
    pub heading_deg: f64,
    length: f64,
}

impl From<&Object> for ScenarioObject {
    fn from(object: &Object) -> Self {
        let at = |point: &Point| [point.x, point.y];
        let all = |points: &[Point]| points.iter().map(at).collect();
        match object {
            Object::Furniture { outline } => Self::Furniture { outline: all(outline) },
            Object::Leg { at: centre, radius } => Self::Leg { at: at(centre), radius: *radius },
            Object::LowObstacle { outline, height } => Self::LowObstacle { outline: all(outline), height: *height },
            Object::DropOff { outline } => Self::DropOff { outline: all(outline) },
            Object::Carpet { outline } => Self::Carpet { outline: all(outline) },
            Object::Dirt { at: centre, radius } => Self::Dirt { at: at(centre), radius: *radius },
            Object::Dock { pose } => Self::Dock((*pose).into()),
            Object::VirtualWall { pose, length } => {
                let ScenarioPose { x, y, heading_deg } = (*pose).into();
                Self::VirtualWall(Beam { x, y, heading_deg, length: *length })
            }
            Object::Mover { who, path } => Self::Mover { who: *who, path: all(path) },
        }
    }
}

impl From<&ScenarioObject> for Object {
    fn from(object: &ScenarioObject) -> Self {
        let at = |&[x, y]: &At| Point::new(x, y);
        let all = |points: &[At]| points.iter().map(at).collect();
        match object {
            ScenarioObject::Furniture { outline } => Self::Furniture { outline: all(outline) },
            ScenarioObject::Leg { at: centre, radius } => Self::Leg { at: at(centre), radius: *radius },
            ScenarioObject::LowObstacle { outline, height } => {
                Self::LowObstacle { outline: all(outline), height: *height }
            }
            ScenarioObject::DropOff { outline } => Self::DropOff { outline: all(outline) },
            ScenarioObject::Carpet { outline } => Self::Carpet { outline: all(outline) },
            ScenarioObject::Dirt { at: centre, radius } => Self::Dirt { at: at(centre), radius: *radius },
            ScenarioObject::Dock(pose) => Self::Dock { pose: (*pose).into() },
            ScenarioObject::VirtualWall(beam) => {
                let pose = Pose::new(beam.x, beam.y, beam.heading_deg.to_radians());
                Self::VirtualWall { pose, length: beam.length }
            }
            ScenarioObject::Mover { who, path } => Self::Mover { who: *who, path: all(path) },
        }
    }
}
