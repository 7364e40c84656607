//! How a behaviour that keeps a map of its own estimates its pose.

use crate::{controller::Setup, mapping::Tracking};
use robovac_core::registry::{ParamKind, ParamSpec};

/// The user's choice.
pub(in crate::controller) const TRACKING: ParamSpec = ParamSpec {
    id: "tracking",
    label: "Pose",
    help: "Odometry alone, or corrected for drift by matching contacts to earlier ones.",
    kind: ParamKind::Choice { options: &[("corrected", "corrected"), ("odometry", "odometry alone")] },
};

/// What was chosen.
pub(in crate::controller) fn chosen_tracking(setup: &Setup<'_>) -> Tracking {
    Tracking::parse(setup.params.choice(TRACKING.id)).unwrap_or_default()
}
