//! The program as people and other programs run it.

mod bridge;
mod cli;
mod examples;
mod monitor;
mod run;
mod twin;
mod virtual_roomba;
