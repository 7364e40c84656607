//! The grid that is shown, measured and exported.

use super::MapSession;
use robovac_core::floor_plan::FloorPlan;
use robovac_sim::mapping::{OccupancyMap, ThesisMap};

/// A grid of the tab Map. The run is the same with each of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MapGrid {
    /// The robot's: cells of 5 cm with probabilities, at the estimated pose.
    #[default]
    Probabilities,
    /// That of Krapinec 2025: 100 x 100 cells of 10 cm around the start, by odometry, as printed.
    Thesis,
}

impl MapGrid {
    /// All grids, with their names in links.
    pub const ALL: [(Self, &'static str); 2] = [(Self::Probabilities, "own"), (Self::Thesis, "thesis")];

    /// The grid of that name.
    pub fn parse(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(_, n)| *n == name).map(|(grid, _)| grid)
    }

    /// Name in links.
    pub fn id(self) -> &'static str {
        Self::ALL[self as usize].1
    }
}

impl MapSession {
    /// The thesis' grid, if it is chosen. A robot with a given map makes none, and stored runs have it once they are restored.
    pub fn thesis(&self) -> Option<&ThesisMap> {
        let stage = self.stage.as_ref().filter(|stage| stage.returning.is_none())?;
        stage.run().thesis().filter(|_| self.setup().grid == MapGrid::Thesis)
    }

    /// The map on the chosen grid, in cells of the robot's.
    pub fn shown(&self) -> Option<&OccupancyMap> {
        let own = self.estimate()?.map;
        Some(self.thesis().map_or(own, ThesisMap::map))
    }

    /// The map on the chosen grid, in its own cells. `None` if nothing is known.
    pub fn to_plan(&self, name: &str) -> Option<FloorPlan> {
        match self.thesis() {
            Some(thesis) => thesis.to_plan(name),
            None => self.estimate()?.map.to_plan(name),
        }
    }
}
