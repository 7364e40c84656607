//! Choices; each throws a message and changes nothing if the choice isn't possible.

use super::Playground;
use robovac_playground::wire::message;
use robovac_sim::experiment::{Settings, SettingsError};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Playground {
    /// Chooses a built-in room.
    pub fn select_room(&mut self, id: &str) -> Result<(), JsValue> {
        self.session.select_room(id).map_err(message)
    }

    /// Chooses a planner or behaviour.
    pub fn select_algorithm(&mut self, id: &str) -> Result<(), JsValue> {
        self.session.configure(|s| s.select_algorithm(id)).map_err(message)
    }

    /// Chooses a robot.
    pub fn select_robot(&mut self, id: &str) -> Result<(), JsValue> {
        self.session.configure(|s| s.select_robot(id)).map_err(message)
    }

    /// Chooses the side of the planning cells, m.
    pub fn set_cell_size(&mut self, metres: f64) -> Result<(), JsValue> {
        self.session.configure(|s| s.set_cell_size(metres)).map_err(message)
    }

    /// Chooses the side of the planning cells, m, and how far they begin to the left of the room's lower-left corner and below it.
    pub fn set_cells(&mut self, metres: f64, left: f64, below: f64) -> Result<(), JsValue> {
        let set = |s: &mut Settings| {
            s.set_cell_size(metres)?;
            s.set_cell_offset([left, below])
        };
        self.session.configure(set).map_err(message)
    }

    /// Shows or hides the planner's decisions.
    pub fn show_search(&mut self, on: bool) {
        self.session.show_search(on);
    }

    /// Nothing moves by itself: the run is paused, and films wait for [`Playground::turn_film`].
    pub fn hold_motion(&mut self) {
        self.session.hold_motion();
    }

    /// Shows the film's next or previous picture.
    pub fn turn_film(&mut self, forward: bool) {
        self.session.turn_film(forward);
    }

    /// Holds the film, or continues it.
    pub fn hold_film(&mut self, is_held: bool) {
        self.session.hold_film(is_held);
    }

    /// Sets a parameter of the planner from the text of a form.
    pub fn set_param(&mut self, id: &str, text: &str) -> Result<(), JsValue> {
        self.session.configure(|s| s.set_param(id, text)).map_err(message)
    }

    /// Sets the seed of everything random.
    pub fn set_seed(&mut self, seed: u32) -> Result<(), JsValue> {
        let set = |s: &mut Settings| {
            s.seed = u64::from(seed);
            Ok::<(), SettingsError>(())
        };
        self.session.configure(set).map_err(message)
    }

    /// Chooses the level of wheel slip: `none`, `typical` or `harsh`.
    pub fn set_slip(&mut self, id: &str) -> Result<(), JsValue> {
        self.session.configure(|s| s.set_slip(id)).map_err(message)
    }

    /// Chooses the level of noise, `off`, `typical` or `harsh`, of one kind of the catalogue's `sensors`, or of `all`.
    pub fn set_noise(&mut self, sensor: &str, level: &str) -> Result<(), JsValue> {
        self.session.configure(|s| s.set_noise(Some(sensor).filter(|&name| name != "all"), level)).map_err(message)
    }

    /// Limits wheel speeds to those that the motor controller can keep, or not.
    pub fn set_quantised(&mut self, on: bool) -> Result<(), JsValue> {
        let set = |s: &mut Settings| {
            s.conditions.quantised = on;
            Ok::<(), SettingsError>(())
        };
        self.session.configure(set).map_err(message)
    }

    /// Rounds the corners of plans, or not.
    pub fn set_smooth(&mut self, on: bool) -> Result<(), JsValue> {
        let set = |s: &mut Settings| {
            s.smooth = on;
            Ok::<(), SettingsError>(())
        };
        self.session.configure(set).map_err(message)
    }

    /// Sets the charge of the battery at the start from the text of a form, percent.
    pub fn set_start_charge(&mut self, text: &str) -> Result<(), JsValue> {
        self.session.configure(|s| s.set_start_charge(text.trim().parse().ok(), text)).map_err(message)
    }

    /// Shows or hides a layer of the picture: `coverage`, `dirt`, `sensors` or `estimate`.
    pub fn show(&mut self, layer: &str, on: bool) -> Result<(), JsValue> {
        self.session.show(layer, on).map_err(message)
    }

    /// Chooses how the follower computes its pose: `arc` or `straight`.
    pub fn set_odometry(&mut self, id: &str) -> Result<(), JsValue> {
        self.session.configure(|s| s.set_odometry(id)).map_err(message)
    }
}
