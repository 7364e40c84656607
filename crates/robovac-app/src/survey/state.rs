//! The state machine of the Map tab: which action is legal when.

use serde::Serialize;

/// What the survey is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Phase {
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
pub enum Deed {
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

impl Phase {
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
    pub fn allows(self, deed: Deed) -> bool {
        use Deed as D;
        let allowed: &[Deed] = match self {
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

    fn with(deed: Deed) -> Vec<Phase> {
        Phase::ALL.into_iter().filter(|phase| phase.allows(deed)).collect()
    }

    #[test]
    fn choices_are_free_in_every_phase() {
        assert_eq!(with(Deed::Choose), Phase::ALL);
    }

    #[test]
    fn only_what_moves_can_be_paused_and_only_what_is_held_put_down() {
        assert_eq!(with(Deed::Pause), [Phase::Playing, Phase::Seeking]);
        assert_eq!(with(Deed::PutDown), [Phase::Held]);
        assert_eq!(with(Deed::Lift), [Phase::Playing, Phase::Paused]);
        assert_eq!(with(Deed::Play), [Phase::Ready, Phase::Paused]);
        assert_eq!(with(Deed::Clean), [Phase::Playing, Phase::Paused, Phase::Finished]);
    }

    #[test]
    fn a_map_can_be_taken_away_whenever_there_may_be_one() {
        let none = [Phase::Failed, Phase::Ready, Phase::Seeking];
        assert!(Phase::ALL.into_iter().all(|phase| phase.allows(Deed::UseMap) != none.contains(&phase)));
    }
}
