//! The module `program`, for the sandbox in which users' programs run: a simulation to drive, without planners, maps and
//! drawing.

mod runner;
