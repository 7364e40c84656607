//! Rooms and paths as files.

use js_sys::{Array, Object, Reflect, Uint8Array};
use robovac_app::export::{Exported, FORMATS, RUN};
use robovac_core::{
    floor_plan::{OccupancyMode, Scenario},
    geometry::Point,
};
use robovac_playground::wire::{to_js, trajectory::trajectory_from_js};
use wasm_bindgen::prelude::*;

/// The export formats: `{ id, title, note, needs_path }`. The last one is the run's, which `run_bag` writes.
#[wasm_bindgen]
pub fn export_formats() -> Result<JsValue, JsValue> {
    to_js(&[FORMATS, &[RUN]].concat())
}

/// The files of a format, `{ name, kind, bytes }`: of the room in `scenario` (JSON) and of the path with the corners
/// `path` (x and y in turn, m; empty for none), driven along the trajectory with the knots `knots` (see `Playground.knots`) or, without
/// any, with stops. `stem` is their name without ending, `mode` the mode of a ROS map
/// (`trinary`, `scale` or `raw`), `negate` whether its light cells are occupied. Throws a message for users.
#[wasm_bindgen]
pub fn export_files(
    format: &str,
    scenario: &str,
    path: &[f64],
    knots: &[f64],
    stem: &str,
    mode: &str,
    negate: bool,
) -> Result<Array, JsValue> {
    let scenario = Scenario::read(stem, scenario.as_bytes()).map_err(|e| e.to_string())?;
    let plan = scenario.clone().plan(stem).map_err(|e| e.to_string())?;
    let path: Vec<Point> = path.chunks_exact(2).map(|at| Point::new(at[0], at[1])).collect();
    let smooth = (!knots.is_empty()).then(|| trajectory_from_js(knots));
    let mode = OccupancyMode::named(mode).ok_or_else(|| format!("there is no mode \"{mode}\""))?;
    let smooth = smooth.as_ref();
    let exported = Exported { scenario: &scenario, plan: &plan, path: &path, smooth, stem, mode, negate };
    let files = exported.files(format).map_err(|e| e.to_string())?;
    files
        .into_iter()
        .map(|file| {
            let object = Object::new();
            Reflect::set(&object, &"name".into(), &file.name.into())?;
            Reflect::set(&object, &"kind".into(), &file.kind.into())?;
            Reflect::set(&object, &"bytes".into(), &Uint8Array::from(file.bytes.as_slice()))?;
            Ok(object)
        })
        .collect()
}
