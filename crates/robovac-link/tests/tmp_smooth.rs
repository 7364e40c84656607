#[path = "../../../tests/robot/connection/wire.rs"]
mod wire;
#[path = "../../../tests/robot/connection/rides.rs"]
mod rides;
