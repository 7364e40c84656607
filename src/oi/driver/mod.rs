//! The host's side of the line.
