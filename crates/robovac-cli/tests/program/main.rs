//! The program as people and other programs run it.

mod cli;
mod virtual_roomba;
