//! Module loaded with the page: `web::Playground` and `web::Comparison`, without any planner.
// JavaScript calls what the library exports; there is nothing to be run at the start.
#![cfg_attr(target_arch = "wasm32", no_main)]

use robovac_playground as _;

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    eprintln!("This program is for browsers: ./dev build makes the page.");
}
