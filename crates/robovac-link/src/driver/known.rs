//! Known properties of a robot and its line.

use super::{ConnectionPhase, Diagnosis, Driver, Happening, LinkStats, WheelCommand, distance_angle_poll::frame_bytes};
use roomba_oi::{Packet, PacketId, PacketSet, Readings, StreamCounts, slot_bytes};

impl Driver {
    /// Phase of the connection.
    pub fn phase(&self) -> ConnectionPhase {
        self.phase
    }

    /// Diagnosis of the device on the line.
    pub fn diagnosis(&self) -> &Diagnosis {
        &self.diagnosis
    }

    /// The latest value of every packet; `None` before the first frame.
    pub fn readings(&self) -> Option<&Readings> {
        self.has_read.then_some(&self.readings)
    }

    /// Packets that the last accepted frame contained; the others are of earlier frames.
    pub fn contained(&self) -> PacketSet {
        self.contained
    }

    /// Whether the robot has been silent for so long that it was stopped.
    pub fn is_stalled(&self) -> bool {
        self.is_stalled
    }

    /// The wheel commands.
    pub fn wheels(&self) -> &WheelCommand {
        &self.wheels
    }

    /// Baud rate of the line.
    pub fn baud(&self) -> u32 {
        self.baud
    }

    /// Statistics of the link.
    pub fn link_stats(&self) -> &LinkStats {
        &self.link_stats
    }

    /// Counts of frames and other bytes.
    pub fn counts(&self) -> StreamCounts {
        self.parser.counts()
    }

    /// Refused frames with a right checksum.
    pub fn implausible(&self) -> u64 {
        self.filter.refused()
    }

    /// Frames accepted one frame late, after a jump of a value.
    pub fn late(&self) -> u64 {
        self.filter.late()
    }

    /// Bytes received and sent.
    pub fn bytes(&self) -> [u64; 2] {
        self.bytes
    }

    /// Bytes of a frame, and of the slot into which it must fit.
    pub fn slot(&self) -> [usize; 2] {
        [frame_bytes(self.subscription()), slot_bytes(self.baud)]
    }

    /// Whether the stream contains this packet.
    pub fn receives(&self, packet: Packet) -> bool {
        let subscribed = self.subscription().iter().filter_map(|&id| PacketId::from_byte(id));
        subscribed.flat_map(PacketId::packets).any(|one| one == packet)
    }

    /// Firmware reported by the robot.
    pub fn firmware(&self) -> Option<&str> {
        self.firmware.as_deref()
    }

    /// Sets whether encoder packets 43 and 44 are swapped.
    pub fn swap_encoders(&mut self, swapped: bool) {
        if swapped != self.swapped && !self.is_older {
            std::mem::swap(&mut self.sensors.left_counts, &mut self.sensors.right_counts);
        }
        self.swapped = swapped;
    }

    /// Traffic since the last call, oldest first, with times.
    pub fn take_happenings(&mut self) -> impl Iterator<Item = (f64, Happening)> + use<> {
        std::mem::take(&mut self.happenings).into_iter()
    }
}
