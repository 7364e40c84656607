//! All modules in one, for development: it is linked and bound once after every change.
// JavaScript calls what the module exports; there is nothing to be run at the start, and natively nothing but to be linted.
#![cfg_attr(target_arch = "wasm32", no_main)]

#[cfg(any(target_arch = "wasm32", clippy))]
#[path = "../floor_plan/mod.rs"]
mod floor_plan;
#[cfg(any(target_arch = "wasm32", clippy))]
#[path = "../learn/mod.rs"]
mod learn;
#[cfg(any(target_arch = "wasm32", clippy))]
#[path = "../page/mod.rs"]
mod page;
#[cfg(any(target_arch = "wasm32", clippy))]
#[path = "../program/mod.rs"]
mod program;
#[cfg(any(target_arch = "wasm32", clippy))]
#[path = "../workshop/mod.rs"]
mod workshop;

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    eprintln!("This program is for browsers: ./dev serve makes the page.");
}
