//! The state machine of the Explore tab: which action is legal when.

use serde::Serialize;

/// State of the session.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum SessionState {
    /// Nothing to run: the robot doesn't fit, or planning was cancelled or failed.
    Failed,
    /// A planner is running.
    Planning,
    /// There is a plan and the robot stands at the start.
    Ready,
    /// The run is playing.
    Playing,
    /// The run is paused.
    Paused,
    /// Seeking another time.
    Seeking,
    /// The run is over.
    Finished,
}

/// Actions of the user.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Action {
    /// Start or continue.
    Play,
    /// Pause.
    Pause,
    /// Advance by one move.
    Step,
    /// Return to the start.
    Reset,
    /// Cancel planning.
    Cancel,
    /// Seek another time.
    Seek,
    /// Change room, robot, planner or walls.
    Edit,
    /// Pick the robot up. Before it has started, moving the start does the same.
    Lift,
}

impl SessionState {
    /// All states.
    pub const ALL: [Self; 7] =
        [Self::Failed, Self::Planning, Self::Ready, Self::Playing, Self::Paused, Self::Seeking, Self::Finished];

    /// Whether `action` is offered in this state.
    pub fn allows(self, action: Action) -> bool {
        use Action as A;
        let allowed: &[Action] = match self {
            // Playing plans again.
            Self::Failed => &[A::Play, A::Edit],
            Self::Planning => &[A::Cancel, A::Edit],
            Self::Ready => &[A::Play, A::Step, A::Edit],
            Self::Playing => &[A::Pause, A::Step, A::Reset, A::Seek, A::Edit, A::Lift],
            Self::Paused => &[A::Play, A::Step, A::Reset, A::Seek, A::Edit, A::Lift],
            Self::Seeking => &[A::Pause, A::Reset, A::Seek, A::Edit],
            Self::Finished => &[A::Play, A::Reset, A::Seek, A::Edit],
        };
        allowed.contains(&action)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn room_can_be_changed_in_every_state() {
        assert!(SessionState::ALL.iter().all(|s| s.allows(Action::Edit)));
    }

    #[test]
    fn only_planning_can_be_cancelled_and_only_motion_paused() {
        let with = |action| SessionState::ALL.into_iter().filter(|s| s.allows(action)).collect::<Vec<_>>();
        assert_eq!(with(Action::Cancel), [SessionState::Planning]);
        assert_eq!(with(Action::Pause), [SessionState::Playing, SessionState::Seeking]);
        assert_eq!(with(Action::Lift), [SessionState::Playing, SessionState::Paused]);
        assert_eq!(
            with(Action::Play),
            [SessionState::Failed, SessionState::Ready, SessionState::Paused, SessionState::Finished]
        );
    }
}
