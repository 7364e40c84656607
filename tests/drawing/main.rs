//! Drawings in, rooms out.

mod dxf;
mod hostile;
mod support;
mod tracing;
mod vector;
mod write;
