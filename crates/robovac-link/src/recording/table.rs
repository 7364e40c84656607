//! The readings of a recording as comma-separated values.

use super::{LineEvent, RecordedReading, Watch};
use crate::connection::LineRecording;
use roomba_oi::{Packet, PacketSet, Readings};
use std::{fmt::Write, sync::Arc};

/// Length of the pieces in which a table is passed on, bytes.
const PIECE: usize = 1 << 16;
/// Columns before the packets'.
const FIRST: [&str; 6] = ["time (s)", "mode", "pose_x (m)", "pose_y (m)", "pose_heading (rad)", "path (m)"];

/// Packets whose value is a set of flags: the mask and the column of each.
const FLAGS: [(Packet, &[(u8, &str)]); 6] = [
    (Packet::BumpsAndDrops, &[(2, "bump_left"), (1, "bump_right"), (8, "wheel_drop_left"), (4, "wheel_drop_right")]),
    (
        Packet::Overcurrents,
        &[
            (16, "overcurrent_left_wheel"),
            (8, "overcurrent_right_wheel"),
            (4, "overcurrent_main_brush"),
            (1, "overcurrent_side_brush"),
        ],
    ),
    (
        Packet::Buttons,
        &[
            (1, "button_clean"),
            (2, "button_spot"),
            (4, "button_dock"),
            (8, "button_minute"),
            (16, "button_hour"),
            (32, "button_day"),
            (64, "button_schedule"),
            (128, "button_clock"),
        ],
    ),
    (Packet::ChargingSources, &[(1, "charger_plugged_in"), (2, "on_dock")]),
    (
        Packet::LightBumper,
        &[
            (1, "light_bumper_left"),
            (2, "light_bumper_front_left"),
            (4, "light_bumper_center_left"),
            (8, "light_bumper_center_right"),
            (16, "light_bumper_front_right"),
            (32, "light_bumper_right"),
        ],
    ),
    (Packet::Stasis, &[(1, "stasis_toggling"), (2, "stasis_disabled")]),
];

fn flags(packet: Packet) -> Option<&'static [(u8, &'static str)]> {
    FLAGS.iter().find(|(with_flags, _)| *with_flags == packet).map(|(_, flags)| *flags)
}

fn packets() -> impl Iterator<Item = Packet> {
    Packet::ALL.into_iter().filter(|packet| !matches!(packet, Packet::Unused1 | Packet::Unused2 | Packet::Unused3))
}

/// Names of the columns, with units in parentheses.
pub fn table_header() -> String {
    let mut columns: Vec<String> = FIRST.map(str::to_owned).to_vec();
    for packet in packets() {
        match (flags(packet), packet.unit()) {
            (Some(flags), _) => columns.extend(flags.iter().map(|(_, name)| (*name).to_owned())),
            (None, "") => columns.push(packet.name().to_owned()),
            (None, "counts") => columns.push(format!("{} (counts modulo 65536)", packet.name())),
            (None, unit) => columns.push(format!("{} ({unit})", packet.name())),
        }
    }
    columns.join(",") + "\n"
}

/// Appends a row. Packets that its frame didn't contain are left empty: distance and angle would otherwise count twice.
pub fn table_row(time_s: f64, reading: &RecordedReading, out: &mut String) {
    let RecordedReading { readings, contained, pose, .. } = reading;
    let mode = reading.mode.map(|mode| mode.to_string()).unwrap_or_default();
    // Writing to a string doesn't fail.
    let _ = write!(out, "{time_s:.4},{mode},{:.4},{:.4},{:.4},{:.4}", pose.x, pose.y, pose.heading, reading.distance_m);
    for packet in packets() {
        cells(packet, readings, *contained, out);
    }
    out.push('\n');
}

fn cells(packet: Packet, readings: &Readings, contained: PacketSet, out: &mut String) {
    let is_there = contained.contains(packet);
    let raw = readings.raw(packet);
    if let Some(flags) = flags(packet) {
        for (mask, _) in flags {
            out.push_str(match (is_there, raw & u16::from(*mask) != 0) {
                (false, _) => ",",
                (true, false) => ",0",
                (true, true) => ",1",
            });
        }
        return;
    }
    out.push(',');
    if is_there {
        let value = match packet {
            Packet::LeftEncoder | Packet::RightEncoder => raw.into(),
            Packet::BatteryCharge => readings.charge_left_mah().into(),
            _ => packet.value(raw),
        };
        let _ = write!(out, "{value}");
    }
}

/// All readings of a recording as a table, in pieces.
pub fn csv<E>(recording: impl Into<Arc<LineRecording>>, mut write: impl FnMut(&str) -> Result<(), E>) -> Result<(), E> {
    let mut text = table_header();
    let mut watch = Watch::new(recording);
    let mut has_more = true;
    while has_more {
        has_more = watch.go_on(1.0, |at, event| {
            if let LineEvent::Reading(reading) = event {
                table_row(at, &reading, &mut text);
            }
        });
        if text.len() > PIECE || !has_more {
            write(&text)?;
            text.clear();
        }
    }
    Ok(())
}
