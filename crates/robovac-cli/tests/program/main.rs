//! The program as people and other programs run it.

mod bridge;
mod cli;
mod examples;
mod grade;
mod monitor;
mod run;
mod study;
mod twin;
mod virtual_roomba;
