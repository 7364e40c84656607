//! The behaviours: what their authors print, what the registry claims, and that nobody falls.

mod contract;
mod docking;
mod exploring;
mod papers;
mod paths;
mod stairs;
mod support;
