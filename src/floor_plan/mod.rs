//! The module `floor_plan`: the Floor plan tab, and the export of rooms and paths.

mod bench;
mod export;
mod session;
