//! Which layers of a run are drawn on the floor.

use super::SettingsError;
use serde::Serialize;

/// Layers of the picture that can be shown or hidden.
#[expect(clippy::struct_excessive_bools)]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Shows {
    /// Passes over the floor.
    pub coverage: bool,
    /// Remaining dirt.
    pub dirt: bool,
    /// Sensor beams and detections.
    pub sensors: bool,
    /// The robot's estimated trail.
    pub estimate: bool,
}

impl Shows {
    /// The defaults of the page.
    pub const DEFAULT: Self = Self { coverage: true, dirt: true, sensors: false, estimate: false };

    /// The layers with their names in links.
    fn layers(&mut self) -> [(&'static str, &mut bool); 4] {
        let Self { coverage, dirt, sensors, estimate } = self;
        [("coverage", coverage), ("dirt", dirt), ("sensors", sensors), ("estimate", estimate)]
    }

    /// Shows or hides a layer.
    pub fn set(&mut self, name: &str, on: bool) -> Result<(), SettingsError> {
        let mut layers = self.layers();
        let known = layers.each_ref().map(|(name, _)| *name).join(", ");
        match layers.iter_mut().find(|(known, _)| *known == name) {
            Some((_, layer)) => **layer = on,
            None => return Err(SettingsError::Unknown { kind: "layer", id: name.to_owned(), known }),
        }
        Ok(())
    }

    /// The shown layers, for a link.
    pub fn to_link(mut self) -> String {
        let shown = self.layers().into_iter().filter(|(_, on)| **on).map(|(name, _)| name);
        let names = shown.collect::<Vec<_>>().join(",");
        if names.is_empty() { "none".to_owned() } else { names }
    }

    /// The layers by the text of a link.
    pub fn from_link(text: &str) -> Result<Self, SettingsError> {
        let mut shows = Self { coverage: false, dirt: false, sensors: false, estimate: false };
        for name in text.split(',').filter(|name| !name.is_empty() && *name != "none") {
            shows.set(name, true)?;
        }
        Ok(shows)
    }
}

impl Default for Shows {
    fn default() -> Self {
        Self::DEFAULT
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_bring_back_every_choice() {
        for bits in 0..16 {
            let is = |bit: u8| bits & (1 << bit) != 0;
            let shows = Shows { coverage: is(0), dirt: is(1), sensors: is(2), estimate: is(3) };
            assert_eq!(Shows::from_link(&shows.to_link()), Ok(shows));
        }
        assert!(Shows::from_link("walls").unwrap_err().to_string().contains("sensors"));
    }
}
