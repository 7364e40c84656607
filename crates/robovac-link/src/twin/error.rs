//! Why no twin can be made from a recording.

use thiserror::Error;

/// Reasons why no twin can be made from a recording, each with what to do.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum TwinError {
    /// The robot never sent anything.
    #[error(
        "the robot never answered in this recording; check the cable with the page's Robot tab, then record a drive"
    )]
    Silent,
    /// Bytes arrived, but no frame.
    #[error(
        "the bytes in this recording are not a Roomba's sensor frames: damaged, or of another baud rate; connect with the \
         page's Robot tab, which finds the rate, and record again"
    )]
    Garbled,
    /// Bytes arrived, but next to no frame was whole.
    #[error(
        "{lost} of {all} frames in this recording are damaged, which leaves too little of the drive; check the cable and \
         its speed (the Robot tab shows lost frames), then record again"
    )]
    Damaged {
        /// Lost frames.
        lost: u64,
        /// All frames.
        all: u64,
    },
    /// There are readings, but none with both encoders.
    #[error(
        "the readings of this recording lack the wheel encoders (packets 43 and 44); record with the page or with \
         \"robovac monitor\", which ask for them. Robots before the 500 series have none"
    )]
    NoEncoders,
    /// It is too short.
    #[error("the recording covers {seconds:.0} s of readings; a twin needs {least:.0} s of driving at least", least = super::LEAST_S)]
    Short {
        /// Time covered by readings, s.
        seconds: f64,
    },
    /// The wheels hardly turned.
    #[error(
        "the robot hardly moved in this recording: its wheels rolled {metres:.2} m; take control, drive it for a minute, \
         and record that"
    )]
    Still {
        /// Way of the wheels, m.
        metres: f64,
    },
    /// Nothing in it tells a figure.
    #[error(
        "this recording determines no figure of a twin: no command drove the robot, it never turned twice on the spot \
         beside a wall or met a wall head-on, and nothing was calibrated; drive it from the Robot tab and record that"
    )]
    Untold,
}
