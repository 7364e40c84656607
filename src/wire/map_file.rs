//! Map files, read in a worker; the room is returned as bytes.

use super::bytes::{from_bytes, to_bytes};
use js_sys::{Array, Reflect, Uint8Array};
use robovac_app::{Import, ScenarioChoices, pack, unpack};
use robovac_core::{
    floor_plan::{FloorPlan, SourceFile},
    geometry::Pose,
    grid::{Grid, Occupancy},
};
use serde::{Deserialize, Serialize};
use wasm_bindgen::JsValue;

/// A map in the form for the page; its cells are passed as bytes, and its objects as numbers. Poses are x, y, heading
/// in metres and radians.
#[derive(Debug, Serialize, Deserialize)]
struct WireMap<'a> {
    name: String,
    note: String,
    resolution: f64,
    width: usize,
    cells: &'a [u8],
    objects: Vec<f64>,
    start: Option<[f64; 3]>,
    origin: [f64; 3],
    choices: Option<ScenarioChoices>,
}

/// States of cells, by their bytes.
const CODES: [Occupancy; 3] = [Occupancy::Free, Occupancy::Occupied, Occupancy::Unknown];

/// The argument of `Playground.take_map`.
pub fn import_to_bytes(Import { plan, choices }: Import) -> Result<Vec<u8>, JsValue> {
    let numbers = |pose: Pose| [pose.x, pose.y, pose.heading];
    let code = |cell: &Occupancy| CODES.iter().position(|code| code == cell).unwrap_or_default() as u8;
    let cells: Vec<u8> = plan.occupancy.values().iter().map(code).collect();
    to_bytes(&WireMap {
        name: plan.name,
        note: plan.note,
        resolution: plan.resolution,
        width: plan.occupancy.width(),
        cells: &cells,
        objects: pack(&plan.objects),
        start: plan.start.map(numbers),
        origin: numbers(plan.origin),
        choices,
    })
}

/// Files from an array of `{ name, bytes }`.
pub fn source_files(files: &Array) -> Result<Vec<SourceFile>, JsValue> {
    files.iter().map(|file| source_file(&file)).collect()
}

fn source_file(file: &JsValue) -> Result<SourceFile, JsValue> {
    let name = Reflect::get(file, &"name".into())?.as_string().unwrap_or_default();
    let bytes = Uint8Array::new(&Reflect::get(file, &"bytes".into())?).to_vec();
    Ok(SourceFile { name, bytes })
}

/// The import of bytes made by [`import_to_bytes`].
pub fn import_from_bytes(bytes: &[u8]) -> Result<Import, JsValue> {
    let wire: WireMap = from_bytes(bytes)?;
    let cells = wire.cells.iter().map(|&code| CODES[usize::from(code).min(CODES.len() - 1)]).collect();
    let pose = |[x, y, heading]: [f64; 3]| Pose::new(x, y, heading);
    let plan = FloorPlan {
        name: wire.name,
        note: wire.note,
        resolution: wire.resolution,
        occupancy: Grid::from_rows(wire.width, cells).ok_or("the map has no cells")?,
        objects: unpack(&wire.objects),
        start: wire.start.map(pose),
        origin: pose(wire.origin),
    };
    Ok(Import { plan, choices: wire.choices })
}
