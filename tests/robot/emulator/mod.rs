//! The emulated Roomba against the specification's tables and the project's fact sheet.

mod actuators;
mod builtin_programs;
mod line;
mod modes;
mod packets;
mod personalities;
mod power;
mod properties;
mod support;
mod vectors;
