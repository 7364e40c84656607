//! The Open Interface codec against the specification's examples, recorded bytes and noise.

mod commands;
mod noise;
mod packets;
mod stream;
mod vectors;
