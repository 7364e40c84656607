//! Module loaded on the first visit to the Floor plan tab, or with the first file: `web::Drafting`, which runs in its
//! worker.
// JavaScript calls what the library exports; there is nothing to be run at the start.
#![cfg_attr(target_arch = "wasm32", no_main)]

use robovac_playground as _;

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    eprintln!("This program is for browsers: ./dev build makes the page.");
}
