//! The behaviours: the printed rules of their authors, the claims of the registry, and that no robot falls.

mod contract;
mod docking;
mod exploring;
mod online_snake;
mod papers;
mod paths;
mod rooms;
mod stairs;
mod support;

pub use docking::room_with_dock;
