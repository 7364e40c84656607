//! Module for the sandbox of users' programs: the `ProgramRunner`.
// JavaScript calls what the module exports; there is nothing to be run at the start, and natively nothing but to be linted.
#![cfg_attr(target_arch = "wasm32", no_main)]

#[cfg(any(target_arch = "wasm32", clippy))]
#[path = "../program/mod.rs"]
mod program;

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    eprintln!("This program is for browsers: ./dev build makes the page.");
}
