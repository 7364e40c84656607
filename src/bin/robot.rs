//! Module loaded on the first visit to the Robot tab: `web::Link` and `web::VirtualRobot`, which run in its worker, and
//! `web::Guest` and `web::LiveMap` for the page.
// JavaScript calls what the library exports; there is nothing to be run at the start.
#![cfg_attr(target_arch = "wasm32", no_main)]

use robovac_playground as _;

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    eprintln!("This program is for browsers: ./dev build makes the page.");
}
