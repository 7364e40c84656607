//! A mapping run as text, so that it survives a reload of the page.
//!
//! Both the inputs and the result are stored. A simulated run is deterministic: its recipe, a person's inputs and the
//! number of steps reproduce it to the last bit, particles included, by simulating it again (a few seconds). The map,
//! the marks and the estimated pose are stored as well: they are shown meanwhile, and remain valid if a newer program
//! simulates differently.

use super::numbers::{digest, from_text, push, take, to_text};
use coverage_planners;
use robovac_core::{geometry::Pose, grid::Cell};
use robovac_sim::{
    Input,
    mapping::{CellMark, Marks, OccupancyMap},
};
use serde::{Deserialize, Serialize};

/// Version of the format.
pub const STORE_VERSION: u32 = 2;
/// The oldest version that can be read: version 1 has no cleaning by the map and no given map, and is otherwise the
/// same.
const OLDEST: u32 = 1;
/// Identifies the format.
const FORMAT: &str = "robovac-survey";
/// Log odds are stored in hundredths.
const UNIT: f64 = 0.01;
/// Longest side of a stored map, cells; no robot drives further in a run.
const MOST_SIDE: i64 = 1 << 14;

/// Reasons why a text can't be restored. The text is left unchanged.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum StoreError {
    /// It isn't a stored run.
    #[error("the stored map can't be read: it wasn't saved by this page ({0})")]
    NotASurvey(String),
    /// It was stored by another version of the page.
    #[error(
        "the stored map was saved by another version of this page (format {found}, here {STORE_VERSION}), so it can't \
         be continued"
    )]
    Version {
        /// The version that it has.
        found: u32,
    },
    /// It is damaged.
    #[error("the stored map is damaged ({what}), so it can't be continued")]
    Damaged {
        /// The damaged part.
        what: &'static str,
    },
    /// The run uses a planner that this page doesn't have.
    #[error(
        "the stored run uses the planner \"{id}\", which this version of the page doesn't have, so it can't be \
         continued"
    )]
    Planner {
        /// The planner's id.
        id: String,
    },
    /// It was driven by another program.
    #[error(
        "the stored map was made by a version of the program \"{name}\" that isn't here, so it can't be continued; run \
         that program in the tab Program first"
    )]
    Program {
        /// The program's name.
        name: String,
    },
    /// It belongs to another room, robot or setup.
    #[error("the stored map belongs to another run, in \"{title}\"; choose that room, robot and behaviour first")]
    Another {
        /// The room's name.
        title: String,
    },
}

/// A stored run.
#[derive(Debug, Clone)]
pub struct Stored {
    /// The recipe of the run: see [`super::MapSession::recipe`].
    pub recipe: String,
    /// Name of the room.
    pub title: String,
    /// Number of simulated steps.
    pub end: u64,
    /// Steps of the displayed moment.
    pub shown: u64,
    /// Digest of the run at that moment.
    pub digest: u64,
    /// A person's inputs, with the number of steps before each.
    pub inputs: Vec<(u64, Input)>,
    /// The robot's estimated pose at that moment.
    pub pose: Pose,
    /// Its map at that moment.
    pub map: OccupancyMap,
    /// Floor that it had cleaned, and places where it had found dirt.
    pub marks: Marks,
    /// The map given to it, with its name.
    pub known: Option<(String, OccupancyMap)>,
    /// The docks on that map.
    pub docks: Vec<Pose>,
    /// Name of the user's program that drove; its fingerprint is in the recipe.
    pub program: Option<String>,
}

/// Map, marks and pose of a stored run.
#[derive(Debug, Clone)]
pub(super) struct StoredMap {
    pub map: OccupancyMap,
    pub marks: Marks,
    pub pose: Pose,
}

#[derive(Serialize, Deserialize)]
struct Envelope {
    format: String,
    version: u32,
    /// Digest of the body, in hexadecimal.
    check: String,
    body: String,
}

/// The fields that identify the version of any text.
#[derive(Deserialize)]
struct VersionStamp {
    format: String,
    version: u32,
}

#[derive(Serialize, Deserialize)]
struct StoredBody {
    recipe: String,
    title: String,
    end: u64,
    shown: u64,
    digest: String,
    inputs: Vec<(u64, StoredDeed)>,
    pose: [f64; 3],
    resolution: f64,
    map: String,
    marks: String,
    #[serde(default)]
    known: Option<[String; 2]>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    docks: Vec<[f64; 3]>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    program: Option<String>,
}

/// A stored input of a person.
#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum StoredDeed {
    Lift,
    PutDown([f64; 3]),
    /// By the planner with that id.
    Clean(String),
}

impl Stored {
    /// As text.
    pub fn to_text(&self) -> String {
        let deed = |&(step, input): &(u64, Input)| match input {
            Input::Lift => Some((step, StoredDeed::Lift)),
            Input::PutDown(pose) => Some((step, StoredDeed::PutDown([pose.x, pose.y, pose.heading]))),
            // Exploring behaviours have no joystick.
            Input::Command(_) => None,
            Input::Clean(planner) => Some((step, StoredDeed::Clean(planner.to_owned()))),
        };
        let packed =
            |map: &OccupancyMap| to_text(&cells(map.iter().map(|(cell, odds)| (cell, (odds / UNIT).round() as i64))));
        let bits = |cell| {
            i64::from(self.marks.has(cell, CellMark::Cleaned)) + 2 * i64::from(self.marks.has(cell, CellMark::Dirty))
        };
        let dirty = self.marks.cells(CellMark::Dirty).filter(|&cell| !self.marks.has(cell, CellMark::Cleaned));
        let noted = self.marks.cells(CellMark::Cleaned).chain(dirty).map(|cell| (cell, bits(cell)));
        let body = StoredBody {
            recipe: self.recipe.clone(),
            title: self.title.clone(),
            end: self.end,
            shown: self.shown,
            digest: format!("{:016x}", self.digest),
            inputs: self.inputs.iter().filter_map(deed).collect(),
            pose: [self.pose.x, self.pose.y, self.pose.heading],
            resolution: self.map.resolution(),
            map: packed(&self.map),
            docks: self.docks.iter().map(|dock| [dock.x, dock.y, dock.heading]).collect(),
            program: self.program.clone(),
            known: self.known.as_ref().map(|(name, map)| [name.clone(), packed(map)]),
            marks: to_text(&cells(noted)),
        };
        let body = serde_json::to_string(&body).unwrap_or_default();
        let check = format!("{:016x}", digest(&body));
        let envelope = Envelope { format: FORMAT.to_owned(), version: STORE_VERSION, check, body };
        serde_json::to_string(&envelope).unwrap_or_default()
    }

    /// The run that [`Stored::to_text`] wrote.
    pub fn from_text(text: &str) -> Result<Self, StoreError> {
        let stamp: VersionStamp = serde_json::from_str(text).map_err(|e| StoreError::NotASurvey(e.to_string()))?;
        if stamp.format != FORMAT {
            return Err(StoreError::NotASurvey(format!("its format is \"{}\"", stamp.format)));
        }
        if !(OLDEST..=STORE_VERSION).contains(&stamp.version) {
            return Err(StoreError::Version { found: stamp.version });
        }
        let damaged = |what| StoreError::Damaged { what };
        let envelope: Envelope = serde_json::from_str(text).map_err(|_| damaged("data is missing"))?;
        if envelope.check != format!("{:016x}", digest(&envelope.body)) {
            return Err(damaged("its checksum is wrong"));
        }
        let body: StoredBody =
            serde_json::from_str(&envelope.body).map_err(|_| damaged("its content can't be read"))?;
        if !(body.resolution.is_finite()
            && body.resolution > 0.0
            && body.pose.iter().chain(body.docks.iter().flatten()).all(|n| n.is_finite()))
        {
            return Err(damaged("its scale or pose isn't a number"));
        }
        let list = |text: &str| from_text(text).and_then(|bytes| cells_of(&bytes));
        let unpacked = |text: &str| {
            let mut map = OccupancyMap::new(body.resolution);
            for (cell, odds) in list(text).ok_or_else(|| damaged("its map can't be read"))? {
                // A little more than stored, so that rounding doesn't make it a little less.
                map.add(cell, (odds as f64 + 0.1 * odds.signum() as f64) * UNIT);
            }
            Ok(map)
        };
        let map = unpacked(&body.map)?;
        let known = body.known.as_ref().map(|[name, text]| Ok((name.clone(), unpacked(text)?))).transpose()?;
        let mut marks = Marks::new(body.resolution);
        for (cell, bits) in list(&body.marks).ok_or_else(|| damaged("its marks can't be read"))? {
            for mark in [CellMark::Cleaned, CellMark::Dirty] {
                if bits & mark as i64 != 0 {
                    marks.note(cell.centre(body.resolution), 0.1 * body.resolution, mark);
                }
            }
        }
        let pose = |[x, y, heading]: [f64; 3]| Pose::new(x, y, heading);
        let input = |(step, deed)| match deed {
            StoredDeed::Lift => Ok((step, Input::Lift)),
            StoredDeed::PutDown(place) => Ok((step, Input::PutDown(pose(place)))),
            StoredDeed::Clean(id) => match coverage_planners::find(&id) {
                Some(info) => Ok((step, Input::Clean(info.id))),
                None => Err(StoreError::Planner { id }),
            },
        };
        Ok(Self {
            recipe: body.recipe,
            title: body.title,
            end: body.end,
            shown: body.shown.min(body.end),
            digest: u64::from_str_radix(&body.digest, 16).map_err(|_| damaged("its digest is invalid"))?,
            inputs: body.inputs.into_iter().map(input).collect::<Result<_, _>>()?,
            pose: pose(body.pose),
            map,
            marks,
            known,
            docks: body.docks.into_iter().map(pose).collect(),
            program: body.program,
        })
    }
}

/// Cells with their values in few bytes: number of cells, then for each run of cells in a row with the same value how much
/// further up and how far to the right of the end of the last run it begins, its length, and its value.
fn cells(values: impl Iterator<Item = (Cell, i64)>) -> Vec<u8> {
    let mut values: Vec<_> = values.collect();
    values.sort_by_key(|(cell, _)| (cell.y, cell.x));
    let mut bytes = Vec::new();
    let (mut x, mut y) = (0, 0);
    let mut rest = &values[..];
    while let [(first, value), ..] = rest {
        let is_next = |(i, (cell, other)): (usize, &(Cell, i64))| {
            cell.y == first.y && cell.x == first.x + i as i32 && other == value
        };
        let length = rest.iter().enumerate().take_while(|&item| is_next(item)).count();
        let numbers = [i64::from(first.y - y), i64::from(first.x - x), length as i64, *value];
        for number in numbers {
            push(&mut bytes, number);
        }
        (x, y) = (first.x + length as i32, first.y);
        rest = &rest[length..];
    }
    bytes
}

/// The cells that [`cells`] wrote; `None` if the bytes are invalid.
fn cells_of(mut bytes: &[u8]) -> Option<Vec<(Cell, i64)>> {
    let mut values = Vec::new();
    let (mut x, mut y) = (0_i64, 0_i64);
    while !bytes.is_empty() {
        let mut next = || take(&mut bytes);
        let (up, right, length, value) = (next()?, next()?, next()?, next()?);
        (x, y) = (x.checked_add(right)?, y.checked_add(up)?);
        let is_near = |at: i64| (-MOST_SIDE..MOST_SIDE).contains(&at);
        if !(is_near(x) && is_near(y) && (1..MOST_SIDE).contains(&length)) || value.abs() > 1 << 20 {
            return None;
        }
        values.extend((0..length).map(|i| (Cell::new((x + i) as i32, y as i32), value)));
        x += length;
    }
    Some(values)
}
