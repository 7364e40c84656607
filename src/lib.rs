//! Shared by the WebAssembly modules of the Robovac Playground: drawing on a canvas, the clock of frames, and values passed to
//! JavaScript and between workers.
//!
//! The root package is the only code that knows wasm-bindgen, web-sys and js-sys. It is linked into several modules, so
//! that the page loads quickly: `page` (`src/bin/page`), which is loaded first, has the `Playground` of the tab
//! Explore; `workshop` (`src/bin/workshop`) has the other tabs and the code of workers. Their logic and view models are
//! in `robovac-app`.

pub mod canvas;
pub mod frame_clock;
pub mod wire;
