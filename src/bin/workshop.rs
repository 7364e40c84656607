//! Module loaded when first needed: planners and trials for workers, and the tabs Compare, Map and Robot.
// JavaScript calls what the module exports; there is nothing to be run at the start.
#![cfg_attr(target_arch = "wasm32", no_main)]

#[path = "../workshop/mod.rs"]
mod workshop;

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    eprintln!("This program is for browsers: ./dev build makes the page.");
}
