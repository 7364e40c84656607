//! Map files, read in a worker; the room is returned as a plain object.

use js_sys::Array;
use js_sys::{Float64Array, Reflect, Uint8Array};
use robovac_app::pack;
use robovac_app::unpack;
use robovac_app::{Import, ScenarioChoices};
use robovac_core::floor_plan::SourceFile;
use robovac_core::{
    floor_plan::FloorPlan,
    geometry::Pose,
    grid::{Grid, Occupancy},
};
use serde::{Deserialize, Serialize};
use wasm_bindgen::JsValue;

/// A map in the form for the page; its cells are passed as bytes, and its objects as numbers. Poses are x, y, heading
/// in metres and radians.
#[derive(Debug, Serialize, Deserialize)]
struct WireMap {
    name: String,
    note: String,
    resolution: f64,
    width: usize,
    start: Option<[f64; 3]>,
    origin: [f64; 3],
    choices: Option<ScenarioChoices>,
}

/// States of cells, by their bytes.
const CODES: [Occupancy; 3] = [Occupancy::Free, Occupancy::Occupied, Occupancy::Unknown];

/// The argument of `Playground.take_map`.
pub fn import_to_js(Import { plan, choices }: Import) -> Result<JsValue, JsValue> {
    let numbers = |pose: Pose| [pose.x, pose.y, pose.heading];
    let (width, origin) = (plan.occupancy.width(), numbers(plan.origin));
    let (resolution, start) = (plan.resolution, plan.start.map(numbers));
    let code = |cell: &Occupancy| CODES.iter().position(|code| code == cell).unwrap_or_default() as u8;
    let cells: Vec<u8> = plan.occupancy.values().iter().map(code).collect();
    let wire = WireMap { name: plan.name, note: plan.note, resolution, width, start, origin, choices };
    let object = crate::wire::to_js(&wire)?;
    Reflect::set(&object, &"cells".into(), &Uint8Array::from(cells.as_slice()))?;
    Reflect::set(&object, &"objects".into(), &Float64Array::from(pack(&plan.objects).as_slice()))?;
    Ok(object)
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

/// The import of an object made by [`import_to_js`].
pub fn import_from_js(object: &JsValue) -> Result<Import, JsValue> {
    let wire: WireMap = serde_wasm_bindgen::from_value(object.clone()).map_err(|e| e.to_string())?;
    let cells = Uint8Array::new(&Reflect::get(object, &"cells".into())?).to_vec();
    let cells = cells.into_iter().map(|code| CODES[usize::from(code).min(CODES.len() - 1)]).collect();
    let pose = |[x, y, heading]: [f64; 3]| Pose::new(x, y, heading);
    let plan = FloorPlan {
        name: wire.name,
        note: wire.note,
        resolution: wire.resolution,
        occupancy: Grid::from_rows(wire.width, cells).ok_or("the map has no cells")?,
        objects: unpack(&Float64Array::new(&Reflect::get(object, &"objects".into())?).to_vec()),
        start: wire.start.map(pose),
        origin: pose(wire.origin),
    };
    Ok(Import { plan, choices: wire.choices })
}
