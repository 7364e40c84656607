//! Known properties of a robot and its line.

use super::{ConnectionPhase, Diagnosis, Driver, Happening, LinkStats, WheelCommand};
use roomba_oi::{FRAMING, PacketId, Readings, StreamCounts, slot_bytes};

impl Driver {
    /// How far it is.
    pub fn phase(&self) -> ConnectionPhase {
        self.phase
    }

    /// What was found out about who is there.
    pub fn diagnosis(&self) -> &Diagnosis {
        &self.diagnosis
    }

    /// The latest value of every packet; `None` before the first frame.
    pub fn readings(&self) -> Option<&Readings> {
        self.has_read.then_some(&self.readings)
    }

    /// Whether the robot has not been heard of for so long that it was stopped.
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

    /// Rate, gaps and round trips.
    pub fn link_stats(&self) -> &LinkStats {
        &self.link_stats
    }

    /// What came of the bytes.
    pub fn counts(&self) -> StreamCounts {
        self.parser.counts()
    }

    /// Frames with a right checksum that weren't believed.
    pub fn implausible(&self) -> u64 {
        self.filter.refused()
    }

    /// Frames that were believed a frame late, as something in them jumped.
    pub fn late(&self) -> u64 {
        self.filter.late()
    }

    /// Bytes received and sent.
    pub fn bytes(&self) -> [u64; 2] {
        self.bytes
    }

    /// Bytes of a frame, and of the slot that it has to fit in.
    pub fn slot(&self) -> [usize; 2] {
        let packets = self.subscription().iter();
        let size = packets.filter_map(|&id| PacketId::size_of(id)).map(|size| size + 1).sum::<usize>() + FRAMING;
        [size, slot_bytes(self.baud)]
    }

    /// What the robot said of its firmware.
    pub fn firmware(&self) -> Option<&str> {
        self.firmware.as_deref()
    }

    /// Takes encoder packets 43 and 44 the other way round, or as they should be.
    pub fn swap_encoders(&mut self, swapped: bool) {
        if swapped != self.swapped {
            std::mem::swap(&mut self.sensors.left_counts, &mut self.sensors.right_counts);
        }
        self.swapped = swapped;
    }

    /// What went over the line since this was last asked for, oldest first, with its time.
    pub fn take_happenings(&mut self) -> impl Iterator<Item = (f64, Happening)> + use<> {
        std::mem::take(&mut self.happenings).into_iter()
    }
}
