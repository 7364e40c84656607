//! View model of the virtual robot.

use super::{Display, Emulator, PERSONALITIES};
use serde::Serialize;

/// A personality, for menus.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct PersonalityView {
    id: &'static str,
    title: &'static str,
    summary: &'static str,
}

impl PersonalityView {
    /// All personalities.
    pub fn all() -> Vec<Self> {
        PERSONALITIES.iter().map(|p| Self { id: p.id, title: p.title, summary: p.summary }).collect()
    }
}

/// Visible and audible state of the virtual robot. Bit sets are encoded as on the line.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct VirtualView {
    /// Its true pose: x, y in m, heading in rad.
    pose: [f64; 3],
    mode: String,
    awake: bool,
    lifted: bool,
    fallen: bool,
    lamps: u8,
    /// Colour, 0 green to 255 red, and brightness.
    clean_light: [u8; 2],
    digits: String,
    weekdays: u8,
    schedule: u8,
    motors: u8,
    /// Share of the room's dirt that is left; `None` in a room without any.
    dirt_left: Option<f64>,
    /// Tunes started since the last view: notes of MIDI number and 1/64 s.
    tunes: Vec<Vec<[u8; 2]>>,
}

impl Emulator {
    /// The snapshot of this robot.
    pub fn view(&mut self) -> VirtualView {
        let Display { lamps, clean_light, digits, weekdays, schedule, motors, tunes } = self.take_display();
        let pose = self.pose();
        VirtualView {
            pose: [pose.x, pose.y, pose.heading],
            mode: self.mode().to_string(),
            awake: self.is_awake(),
            lifted: self.robot().is_lifted(),
            fallen: self.robot().has_fallen(),
            lamps: lamps.byte(),
            clean_light,
            digits: digits.map(char::from).iter().collect(),
            weekdays: weekdays.byte(),
            schedule: schedule.byte(),
            motors: motors.byte(),
            dirt_left: Some(self.life().dirt_left()).filter(|_| !self.life().spots().is_empty()),
            tunes,
        }
    }
}
