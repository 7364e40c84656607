//! Reading and tracing of large drawings.

fn main() {}
