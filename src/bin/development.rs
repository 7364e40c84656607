//! All modules in one, for development: it is linked and bound once after every change.
// JavaScript calls what the module exports; there is nothing to be run at the start.
#![cfg_attr(target_arch = "wasm32", no_main)]

#[path = "../floor_plan/mod.rs"]
mod floor_plan;
#[path = "../learn/mod.rs"]
mod learn;
#[path = "../page/mod.rs"]
mod page;
#[path = "../program/mod.rs"]
mod program;
#[path = "../workshop/mod.rs"]
mod workshop;

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    eprintln!("This program is for browsers: ./dev serve makes the page.");
}
