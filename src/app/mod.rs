//! What the page and the command line have in common, above planners and robots.

pub mod planning;
