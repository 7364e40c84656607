//! The line below a robot's bytes, as whoever holds it reports it.

use serde::{Deserialize, Serialize};

/// The line below a robot's bytes.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct TransportView {
    /// What it is.
    pub kind: TransportKind,
    /// Whether it is there.
    pub state: TransportState,
    /// Name of the adapter, bridge or personality.
    pub name: String,
    /// A sentence on the state; empty if there is nothing to tell.
    pub text: String,
    /// Baud rate.
    pub baud: u32,
    /// Whether the baud rate can be changed.
    pub can_baud: bool,
    /// The BRC wire at the adapter's RTS.
    pub brc: BrcWire,
    /// What the adapter reported and recovered from.
    pub errors: TransportErrors,
    /// How often it has come back by itself.
    pub returns: u32,
}

/// Kinds of lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum TransportKind {
    /// None, or that of a recording.
    #[default]
    #[serde(rename = "")]
    None,
    /// To a virtual robot.
    Virtual,
    /// A serial port.
    Serial,
    /// A bridge over WebSocket.
    Socket,
}

/// States of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum TransportState {
    /// Not open.
    #[default]
    Closed,
    /// Being opened.
    Opening,
    /// Open, maybe after it came back by itself. The robot behind it is then found out about anew and gets no command to move
    /// before the user takes control again.
    Open,
    /// It went away and is waited for.
    Lost,
}

/// The wire that wakes a robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum BrcWire {
    /// Pulled low.
    Low,
    /// Let go.
    High,
    /// There is none, as far as the adapter knows.
    #[default]
    None,
}

/// Errors of an adapter.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct TransportErrors {
    /// Breaks.
    pub r#break: u32,
    /// Framing errors.
    pub framing: u32,
    /// Parity errors.
    pub parity: u32,
    /// Overruns.
    pub overrun: u32,
}
