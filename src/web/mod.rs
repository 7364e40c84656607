//! The only code that knows wasm-bindgen, web-sys and js-sys.
//!
//! It is compiled into six modules. The page's has one `Playground`, a handful of calls a frame. Compare's, which is
//! loaded when one first goes there, has a `Guest` that follows the playground, a `Comparison` and a `MonteCarlo`. Robot's
//! is loaded in the same way, by the page, which has a `Guest` and a `LiveMap`, and by a worker, which has a `Guest`, a
//! `Link` and perhaps a `VirtualRobot`. The workshop's, which runs in workers and is loaded when it is first needed, has
//! `plan` and `prove`, `Trials`, `Runner`, `read_map` and `bench`. Map's has a `Guest` and a `Survey`. The drafting room's has `export_files` for the page, and a
//! `Drafting` for a worker that draws by itself, beside `bench_draft`.
//! Plain objects and arrays go to and fro between them: `request` and `map` say how.

#[cfg(any(feature = "workshop", feature = "draft"))]
mod bench;
#[cfg(any(feature = "page", feature = "compare", feature = "robot"))]
mod canvas;
#[cfg(feature = "page")]
mod catalogue;
#[cfg(feature = "compare")]
mod comparison;
#[cfg(feature = "compare")]
mod comparison_view;
#[cfg(feature = "draft")]
mod drafting;
#[cfg(any(feature = "page", feature = "survey"))]
mod entry;
#[cfg(feature = "draft")]
mod export;
#[cfg(any(feature = "page", feature = "compare", feature = "robot"))]
mod film;
#[cfg(any(feature = "page", feature = "workshop"))]
mod frames;
#[cfg(feature = "page")]
mod furnish;
#[cfg(any(feature = "compare", feature = "robot", feature = "survey"))]
mod guest;
#[cfg(any(feature = "page", feature = "compare", feature = "robot", feature = "draft", feature = "survey"))]
mod layer;
#[cfg(feature = "robot")]
mod link;
#[cfg(feature = "robot")]
mod live_map;
#[cfg(any(feature = "page", feature = "workshop", feature = "draft", feature = "survey"))]
mod map;
#[cfg(feature = "compare")]
mod montecarlo;
#[cfg(any(feature = "page", feature = "compare", feature = "robot"))]
mod objects;
#[cfg(any(feature = "page", feature = "compare", feature = "survey"))]
mod param;
#[cfg(feature = "workshop")]
mod plan_job;
#[cfg(feature = "page")]
mod playground;
#[cfg(any(feature = "page", feature = "workshop"))]
mod proof;
#[cfg(feature = "robot")]
mod replay;
#[cfg(any(feature = "page", feature = "robot", feature = "workshop"))]
mod request;
#[cfg(any(feature = "page", feature = "compare", feature = "robot", feature = "survey"))]
mod robot;
#[cfg(feature = "workshop")]
mod runner;
#[cfg(any(feature = "page", feature = "compare", feature = "robot"))]
mod search;
#[cfg(any(feature = "page", feature = "compare", feature = "robot"))]
mod sensed;
#[cfg(feature = "survey")]
mod survey;
#[cfg(feature = "workshop")]
mod trial;
#[cfg(feature = "robot")]
mod virtual_robot;
#[cfg(any(feature = "page", feature = "compare", feature = "robot", feature = "workshop"))]
mod walk;

#[cfg(feature = "workshop")]
pub use bench::bench;
#[cfg(feature = "draft")]
pub use bench::{bench_draft, office_drawing};
#[cfg(feature = "compare")]
pub use comparison::Comparison;
#[cfg(feature = "draft")]
pub use drafting::Drafting;
#[cfg(feature = "draft")]
pub use export::{export_files, export_formats};
#[cfg(any(feature = "compare", feature = "robot", feature = "survey"))]
pub use guest::Guest;
#[cfg(feature = "robot")]
pub use link::Link;
#[cfg(feature = "robot")]
pub use live_map::LiveMap;
#[cfg(feature = "workshop")]
pub use map::read_map;
#[cfg(feature = "compare")]
pub use montecarlo::MonteCarlo;
#[cfg(feature = "workshop")]
pub use plan_job::{plan, prove};
#[cfg(feature = "page")]
pub use playground::Playground;
#[cfg(feature = "robot")]
pub use replay::Replay;
#[cfg(feature = "workshop")]
pub use runner::Runner;
#[cfg(feature = "survey")]
pub use survey::Survey;
#[cfg(feature = "workshop")]
pub use trial::Trials;
#[cfg(feature = "robot")]
pub use virtual_robot::VirtualRobot;

use serde::Serialize;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// Milliseconds since the page or worker started.
    #[wasm_bindgen(js_namespace = performance, js_name = now)]
    fn clock() -> f64;
}

/// A value as a plain JavaScript object.
fn to_js(value: &impl Serialize) -> Result<JsValue, JsValue> {
    let serializer = serde_wasm_bindgen::Serializer::json_compatible();
    value.serialize(&serializer).map_err(|e| JsValue::from(e.to_string()))
}

/// JavaScript catches the message.
#[cfg(any(feature = "page", feature = "compare", feature = "robot", feature = "survey"))]
impl From<crate::app::SettingsError> for JsValue {
    fn from(error: crate::app::SettingsError) -> Self {
        error.to_string().into()
    }
}
