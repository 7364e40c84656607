//! The program as people and other programs run it.

mod cli;
mod examples;
mod monitor;
mod virtual_roomba;
