//! Why a frame was refused.

use roomba_oi::FrameError;
use thiserror::Error;

/// Reasons for refusing a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum FrameRefusal {
    /// It belongs to another program's stream.
    #[error("it was not requested")]
    NotRequested,
    /// Its values jump. If the next frame confirms them, nothing is lost.
    #[error("its values jump: the next reading must confirm them")]
    Unconfirmed,
    /// A robot can't report such values.
    #[error("its checksum is right, but its values are impossible")]
    Impossible,
    /// It was held back by a false header.
    #[error("it came too late")]
    TooLate,
    /// It is none: bytes were lost or changed.
    #[error(transparent)]
    Damaged(#[from] FrameError),
}

impl FrameRefusal {
    /// Whether readings were lost with it.
    pub fn is_loss(self) -> bool {
        matches!(self, Self::Impossible | Self::TooLate | Self::Damaged(_))
    }
}
