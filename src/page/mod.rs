//! The module `page`: what everyone loads first. The tab Explore, without the planners' code.

mod catalogue;
mod furnish;
mod playground;

#[allow(unused_imports, reason = "the boundary's tests are Rust; the page uses it by its exports")]
pub use playground::Playground;
