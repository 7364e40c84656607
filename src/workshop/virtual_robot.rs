//! The virtual robot, in a worker: the emulator, with the same bytes as a real robot.

use super::session_mirror::SessionMirror;
use robovac_core::geometry::Pose;
use robovac_link::emulator::{Emulator, PersonalityView, personality};
use robovac_playground::wire::to_js;
use robovac_sim::Input;
use roomba_oi::Buttons;
use wasm_bindgen::prelude::*;

/// A virtual robot. Its time advances by [`Self::advance`].
#[wasm_bindgen]
pub struct VirtualRobot {
    emulator: Emulator,
}

#[wasm_bindgen]
impl VirtualRobot {
    /// A robot in the room of `mirror`, at its start.
    #[wasm_bindgen(constructor)]
    pub fn new(mirror: &SessionMirror, personality_id: &str) -> Result<Self, JsValue> {
        let session = mirror.session();
        let prepared = session.prepared().ok_or("The robot doesn't fit into the room.")?;
        let who = personality(personality_id)
            .ok_or_else(|| format!("There is no personality \"{personality_id}\"; choose one from the list."))?;
        let settings = session.settings();
        Ok(Self { emulator: Emulator::new(&prepared.setup(settings.conditions, settings.seed), who) })
    }

    /// All personalities: `{ id, title, summary }[]`.
    #[wasm_bindgen(unchecked_return_type = "rust.PersonalityView[]")]
    pub fn personalities() -> Result<JsValue, JsValue> {
        to_js(&PersonalityView::all())
    }

    /// Takes bytes from a host that sends at `baud`.
    pub fn receive(&mut self, bytes: &[u8], baud: u32) {
        self.emulator.receive(bytes, baud);
    }

    /// Pulls the BRC wire low, or releases it.
    pub fn set_brc(&mut self, is_low: bool) {
        self.emulator.set_brc(is_low);
    }

    /// Advances the time, s.
    pub fn advance(&mut self, seconds: f64) {
        self.emulator.advance(seconds);
    }

    /// Bytes sent since the last call, as received by a host at `baud`.
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

    /// Lifts it.
    pub fn lift(&mut self) {
        self.emulator.apply(Input::Lift);
    }

    /// Puts it down at x, y in m, heading in rad, as near as it fits.
    pub fn put_down(&mut self, x: f64, y: f64, heading: f64) {
        self.emulator.apply(Input::PutDown(Pose::new(x, y, heading)));
    }

    /// Its true pose: x, y in m, heading in rad.
    pub fn pose(&self) -> Vec<f64> {
        let pose = self.emulator.pose();
        vec![pose.x, pose.y, pose.heading]
    }

    /// Its visible and audible state.
    #[wasm_bindgen(unchecked_return_type = "rust.VirtualView")]
    pub fn view(&mut self) -> Result<JsValue, JsValue> {
        to_js(&self.emulator.view())
    }
}
