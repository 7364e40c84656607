//! The state machine of the Map tab: which action is legal when.

use serde::Serialize;

/// Phase of a mapping run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum MapPhase {
    /// The robot doesn't fit in the room.
    Failed,
    /// The robot stands at the start and has never moved.
    Ready,
    /// The run is playing.
    Playing,
    /// The run is paused.
    Paused,
    /// The robot is held.
    Held,
    /// Seeking another time.
    Seeking,
    /// A stored run is restored by simulating it again.
    Resuming,
    /// The run is over.
    Finished,
}

/// Actions of the user.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MapAction {
    /// Start or continue.
    Play,
    /// Pause.
    Pause,
    /// Advance by a few seconds.
    Step,
    /// Seek another time.
    Seek,
    /// Pick the robot up, and put it down elsewhere.
    Lift,
    /// Put down the robot that is held.
    PutDown,
    /// Drop the map and start again.
    Forget,
    /// Clean the remaining floor by the robot's map.
    Clean,
    /// Export the map as a room or as files.
    UseMap,
    /// Give the robot an existing map.
    Open,
    /// Change the behaviour, wheels and other choices.
    Choose,
}

impl MapPhase {
    /// All phases.
    pub const ALL: [Self; 8] = [
        Self::Failed,
        Self::Ready,
        Self::Playing,
        Self::Paused,
        Self::Held,
        Self::Seeking,
        Self::Resuming,
        Self::Finished,
    ];

    /// Whether `deed` is allowed in this phase.
    pub fn allows(self, deed: MapAction) -> bool {
        use MapAction as D;
        let allowed: &[MapAction] = match self {
            Self::Failed => &[D::Choose],
            Self::Ready => &[D::Play, D::Step, D::Open, D::Choose],
            Self::Playing => &[D::Pause, D::Step, D::Seek, D::Lift, D::Forget, D::Clean, D::UseMap, D::Open, D::Choose],
            Self::Paused => &[D::Play, D::Step, D::Seek, D::Lift, D::Forget, D::Clean, D::UseMap, D::Open, D::Choose],
            Self::Held => &[D::PutDown, D::Forget, D::UseMap, D::Choose],
            Self::Seeking => &[D::Pause, D::Seek, D::Forget, D::Choose],
            // The stored map is there already.
            Self::Resuming => &[D::Forget, D::UseMap, D::Choose],
            Self::Finished => &[D::Seek, D::Forget, D::Clean, D::UseMap, D::Open, D::Choose],
        };
        allowed.contains(&deed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with(deed: MapAction) -> Vec<MapPhase> {
        MapPhase::ALL.into_iter().filter(|phase| phase.allows(deed)).collect()
    }

    #[test]
    fn choices_are_free_in_every_phase() {
        assert_eq!(with(MapAction::Choose), MapPhase::ALL);
    }

    #[test]
    fn only_what_moves_can_be_paused_and_only_what_is_held_put_down() {
        assert_eq!(with(MapAction::Pause), [MapPhase::Playing, MapPhase::Seeking]);
        assert_eq!(with(MapAction::PutDown), [MapPhase::Held]);
        assert_eq!(with(MapAction::Lift), [MapPhase::Playing, MapPhase::Paused]);
        assert_eq!(with(MapAction::Play), [MapPhase::Ready, MapPhase::Paused]);
        assert_eq!(with(MapAction::Clean), [MapPhase::Playing, MapPhase::Paused, MapPhase::Finished]);
    }

    #[test]
    fn a_map_can_be_taken_away_whenever_there_may_be_one() {
        let none = [MapPhase::Failed, MapPhase::Ready, MapPhase::Seeking];
        assert!(MapPhase::ALL.into_iter().all(|phase| phase.allows(MapAction::UseMap) != none.contains(&phase)));
    }
}
