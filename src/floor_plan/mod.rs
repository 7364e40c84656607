//! The module `floor_plan`: the tab Floor plan, and files that rooms and paths are saved as.

mod bench;
mod export;
mod session;
