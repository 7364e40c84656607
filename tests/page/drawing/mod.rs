//! Drawings in, rooms out.
// Drawings are short texts, built as they read.
#![expect(clippy::format_collect)]

mod dxf;
mod hostile;
mod support;
mod tracing;
mod vector;
mod write;
