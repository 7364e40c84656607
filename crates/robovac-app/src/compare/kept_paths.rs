//! Paths of finished trials, kept for the race.

use super::trials::TrialKey;
use coverage_planners::CoveragePath;
use robovac_core::trajectory::Trajectory;
use std::{collections::BTreeMap, sync::Arc};

/// Most cells of all paths together, 8 bytes each.
const MOST_CELLS: usize = 8_000_000;

/// A path, and its trajectory with rounded corners, if they are rounded.
pub(super) struct KeptPath {
    pub path: CoveragePath,
    pub smooth: Option<Arc<Trajectory>>,
}

impl KeptPath {
    /// Its length in cells of as much memory.
    fn size(&self) -> usize {
        let smooth = self.smooth.as_ref().map_or(0, |smooth| size_of_val(smooth.knots()) / 8);
        self.path.cells.len() + 2 * self.path.line.len() + smooth
    }
}

#[derive(Default)]
pub(super) struct KeptPaths(BTreeMap<TrialKey, KeptPath>);

impl KeptPaths {
    pub fn get(&self, key: &TrialKey) -> Option<&KeptPath> {
        self.0.get(key)
    }

    /// Whether there is room for one more.
    pub fn has_room_for(&self, path: &KeptPath) -> bool {
        self.0.values().map(KeptPath::size).sum::<usize>() + path.size() <= MOST_CELLS
    }

    /// Keeps a path, if there is room for it.
    pub fn keep(&mut self, key: TrialKey, path: KeptPath) {
        if self.has_room_for(&path) {
            self.0.insert(key, path);
        }
    }

    pub fn retain(&mut self, mut is_kept: impl FnMut(&TrialKey) -> bool) {
        self.0.retain(|key, _| is_kept(key));
    }
}
