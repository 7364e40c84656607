//! Layers drawn in the Map tab.

use robovac_sim::experiment::SettingsError;

/// Layers of the picture that can be shown or hidden.
pub const LAYERS: [&str; 12] = [
    "belief",
    "truth",
    "difference",
    "cleaned",
    "left",
    "goals",
    "dirt",
    "particles",
    "uncertainty",
    "robot",
    "trails",
    "odometry",
];

/// The layers shown at first.
const FIRST: [&str; 8] = ["belief", "truth", "cleaned", "left", "goals", "uncertainty", "robot", "trails"];

/// The layers that are shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layers([bool; LAYERS.len()]);

impl Layers {
    /// Whether a layer is shown.
    pub fn has(self, name: &str) -> bool {
        LAYERS.iter().zip(self.0).any(|(layer, on)| *layer == name && on)
    }

    /// Shows or hides a layer.
    pub fn set(&mut self, name: &str, on: bool) -> Result<(), SettingsError> {
        let index = LAYERS.iter().position(|layer| *layer == name).ok_or_else(|| SettingsError::Unknown {
            kind: "layer",
            id: name.to_owned(),
            known: LAYERS.join(", "),
        })?;
        self.0[index] = on;
        Ok(())
    }

    /// Names of the shown layers.
    pub fn names(self) -> Vec<&'static str> {
        LAYERS.into_iter().filter(|name| self.has(name)).collect()
    }

    /// The layers in a link.
    pub fn to_link(self) -> String {
        let names = self.names().join(",");
        if names.is_empty() { "none".to_owned() } else { names }
    }

    /// The layers by the text of a link.
    pub fn from_link(text: &str) -> Result<Self, SettingsError> {
        let mut layers = Self([false; LAYERS.len()]);
        for name in text.split(',').filter(|name| !name.is_empty() && *name != "none") {
            layers.set(name, true)?;
        }
        Ok(layers)
    }
}

impl Default for Layers {
    fn default() -> Self {
        Self(LAYERS.map(|layer| FIRST.contains(&layer)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_bring_back_every_choice() {
        let mut layers = Layers::default();
        for name in LAYERS {
            layers.set(name, !layers.has(name)).unwrap();
            assert_eq!(Layers::from_link(&layers.to_link()), Ok(layers));
        }
        assert_eq!(Layers::from_link("none"), Layers::from_link(""));
        assert!(Layers::from_link("walls").unwrap_err().to_string().contains("belief"));
    }
}
