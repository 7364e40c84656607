//! Module loaded when first needed: planners and trials for workers, and the Compare, Map and Robot tabs.
// JavaScript calls what the module exports; there is nothing to be run at the start, and natively nothing but to be linted.
#![cfg_attr(target_arch = "wasm32", no_main)]

#[cfg(any(target_arch = "wasm32", clippy))]
#[path = "../workshop/mod.rs"]
mod workshop;

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    eprintln!("This program is for browsers: ./dev build makes the page.");
}
