//! The virtual robot, in a worker: the emulator, with the same bytes as a real robot.

use super::session_mirror::SessionMirror;
use robovac_core::geometry::Pose;
use robovac_link::emulator::{Display, Emulator, PERSONALITIES, personality};
use robovac_playground::wire::to_js;
use robovac_sim::Input;
use roomba_oi::Buttons;
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// A robot that isn't there. Its time is what [`Self::advance`] is told.
#[wasm_bindgen]
pub struct VirtualRobot {
    emulator: Emulator,
}

#[derive(Serialize)]
struct PersonalityView {
    id: &'static str,
    title: &'static str,
    summary: &'static str,
}

/// What is seen and heard of it.
#[derive(Serialize)]
struct VirtualView {
    /// x, y in m, heading in rad.
    pose: [f64; 3],
    mode: String,
    awake: bool,
    lifted: bool,
    fallen: bool,
    lamps: u8,
    clean_light: [u8; 2],
    digits: String,
    weekdays: u8,
    schedule: u8,
    motors: u8,
    /// Tunes that began to sound: notes of MIDI number and 1/64 s.
    tunes: Vec<Vec<[u8; 2]>>,
}

#[wasm_bindgen]
impl VirtualRobot {
    /// A robot in the room that `guest` shows, at its start.
    #[wasm_bindgen(constructor)]
    pub fn new(guest: &SessionMirror, personality_id: &str) -> Result<Self, JsValue> {
        let session = guest.session();
        let prepared = session.prepared().ok_or("The robot doesn't fit into the room.")?;
        let who = personality(personality_id)
            .ok_or_else(|| format!("There is no personality \"{personality_id}\"; choose one from the list."))?;
        let settings = session.settings();
        Ok(Self { emulator: Emulator::new(&prepared.setup(settings.conditions, settings.seed), who) })
    }

    /// All personalities: `{ id, title, summary }[]`.
    pub fn personalities() -> Result<JsValue, JsValue> {
        let views = PERSONALITIES.iter().map(|p| PersonalityView { id: p.id, title: p.title, summary: p.summary });
        to_js(&views.collect::<Vec<_>>())
    }

    /// Takes bytes from a host that sends at `baud`.
    pub fn receive(&mut self, bytes: &[u8], baud: u32) {
        self.emulator.receive(bytes, baud);
    }

    /// Pulls the BRC wire low, or lets it go.
    pub fn set_brc(&mut self, is_low: bool) {
        self.emulator.set_brc(is_low);
    }

    /// Lets time pass.
    pub fn advance(&mut self, seconds: f64) {
        self.emulator.advance(seconds);
    }

    /// What it has sent since this was last asked for, as a host hears it that listens at `baud`.
    pub fn transmit(&mut self, baud: u32) -> Vec<u8> {
        let mut bytes = Vec::new();
        self.emulator.transmit(baud, &mut bytes);
        bytes
    }

    /// Presses buttons on the robot: bits as in packet 18.
    pub fn press(&mut self, buttons: u8) {
        self.emulator.press(Buttons::from_byte(buttons));
    }

    /// Plugs the charger in or out.
    pub fn plug_charger(&mut self, is_plugged: bool) {
        self.emulator.plug_charger(is_plugged);
    }

    /// Picks it up.
    pub fn lift(&mut self) {
        self.emulator.apply(Input::Lift);
    }

    /// Puts it down at x, y in m, heading in rad, as near as it fits.
    pub fn put_down(&mut self, x: f64, y: f64, heading: f64) {
        self.emulator.apply(Input::PutDown(Pose::new(x, y, heading)));
    }

    /// What is seen and heard of it.
    pub fn view(&mut self) -> Result<JsValue, JsValue> {
        let Display { lamps, clean_light, digits, weekdays, schedule, motors, tunes } = self.emulator.take_display();
        let pose = self.emulator.pose();
        to_js(&VirtualView {
            pose: [pose.x, pose.y, pose.heading],
            mode: self.emulator.mode().to_string(),
            awake: self.emulator.is_awake(),
            lifted: self.emulator.robot().is_lifted(),
            fallen: self.emulator.robot().has_fallen(),
            lamps: lamps.byte(),
            clean_light,
            digits: digits.map(char::from).iter().collect(),
            weekdays: weekdays.byte(),
            schedule: schedule.byte(),
            motors: motors.byte(),
            tunes,
        })
    }
}
