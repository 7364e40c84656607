//! The module `page`, loaded first: the Explore tab, without the planners' code.

mod playground;

#[allow(unused_imports, reason = "the boundary's tests are Rust; the page uses it by its exports")]
pub use playground::Playground;
