//! The state machine of the Map tab: which action is legal when.

use serde::Serialize;

/// What the survey is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum MapPhase {
    /// The robot doesn't fit into the room.
    Failed,
    /// The robot stands at the start and has never set off.
    Ready,
    /// Time goes on.
    Playing,
    /// Time stands still.
    Paused,
    /// The robot is held.
    Held,
    /// On the way to another point of time.
    Seeking,
    /// A survey that was left is driven again up to where it was left.
    Resuming,
    /// The run is over.
    Finished,
}

/// What the user may ask for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MapAction {
    /// Let time go on.
    Play,
    /// Stop time.
    Pause,
    /// Go on by a few seconds.
    Step,
    /// Go to another point of time, the start above all.
    Seek,
    /// Pick the robot up, and put it down elsewhere.
    Lift,
    /// Put down the robot that is held.
    PutDown,
    /// Forget the map and begin anew.
    Forget,
    /// Let the robot clean what is left by its map.
    Clean,
    /// Take the map away: as a room, as files.
    UseMap,
    /// Give the robot a map that was made before.
    Open,
    /// Choose another behaviour, other wheels, ...
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

    /// Whether `deed` is offered in this phase.
    pub fn allows(self, deed: MapAction) -> bool {
        use MapAction as D;
        let allowed: &[MapAction] = match self {
            Self::Failed => &[D::Choose],
            Self::Ready => &[D::Play, D::Step, D::Open, D::Choose],
            Self::Playing => &[D::Pause, D::Step, D::Seek, D::Lift, D::Forget, D::Clean, D::UseMap, D::Open, D::Choose],
            Self::Paused => &[D::Play, D::Step, D::Seek, D::Lift, D::Forget, D::Clean, D::UseMap, D::Open, D::Choose],
            Self::Held => &[D::PutDown, D::Forget, D::UseMap, D::Choose],
            Self::Seeking => &[D::Pause, D::Seek, D::Forget, D::Choose],
            // The map that was stored is there already.
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
