//! State of the line below a robot's bytes, as reported by its holder.

use serde::{Deserialize, Serialize};

/// The line below a robot's bytes.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct TransportView {
    /// Kind of the line.
    pub kind: TransportKind,
    /// State of the line.
    pub state: TransportState,
    /// Name of the adapter, bridge or personality.
    pub name: String,
    /// A sentence on the state; empty for none.
    pub text: String,
    /// Baud rate.
    pub baud: u32,
    /// Whether the baud rate can be changed.
    pub can_baud: bool,
    /// Whether it is the USB port of a robot itself, without an adapter.
    pub is_own_usb: bool,
    /// The BRC wire at the adapter's RTS.
    pub brc: BrcWire,
    /// Errors that the adapter reported and recovered from.
    pub errors: TransportErrors,
    /// How often the line has returned by itself.
    pub returns: u32,
    /// Another client of the bridge drives: what is sent from here doesn't reach the robot.
    #[serde(default)]
    pub is_watching: bool,
}

/// Kinds of lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum TransportKind {
    /// None, or a recording's.
    #[default]
    #[serde(rename = "")]
    None,
    /// A virtual robot's.
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
    /// Open, possibly after it returned by itself. In that case the diagnosis starts again, and the robot gets no
    /// motion command before the user takes control again.
    Open,
    /// Lost, and expected to return.
    Lost,
}

/// State of the wire that wakes a robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum BrcWire {
    /// Pulled low.
    Low,
    /// Released.
    High,
    /// The adapter has no such wire.
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
