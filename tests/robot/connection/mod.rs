//! Driver and emulator at the two ends of a line.

mod calibrating;
mod diagnosis;
mod motors;
mod noise;
mod odometry;
mod recording;
mod rides;
mod safety;
mod twin;
mod view;
mod wire;
