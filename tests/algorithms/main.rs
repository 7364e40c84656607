//! Planners, behaviours, maps and the simulator.

mod behaviours;
mod cleaning;
mod cspace;
mod landmark;
mod life;
mod mapping;
mod planners;
mod scan_mapping;
mod senses;
mod simulation;
mod sweep;
mod world;
