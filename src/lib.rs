//! Shared by the WebAssembly modules of the Robovac Playground: drawing on a canvas, and values passed to JavaScript and
//! between workers.
//!
//! The root package is the only code that knows wasm-bindgen, web-sys and js-sys. It is linked into two modules, so that
//! the page is there soon: `page` (`src/bin/page`), which everyone loads first, has the `Playground` of the tab Explore;
//! `workshop` (`src/bin/workshop`) has all the rest, for the other tabs and for workers. What they decide and show comes from
//! `robovac-app`.

pub mod canvas;
pub mod wire;
