//! What must be the same natively and in WebAssembly.

mod determinism;
