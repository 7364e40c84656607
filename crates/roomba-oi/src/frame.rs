//! One frame of the stream: header, length, packets, checksum.

use super::{
    packet::{Packet, PacketId, PacketSet},
    readings::Readings,
};
use thiserror::Error;

/// First byte of a frame. It occurs in no text of a robot, but possibly in numbers.
pub const HEADER: u8 = 19;

/// Bytes of the longest frame: header, length, 255 bytes of packets, checksum.
pub const MAX_FRAME: usize = 258;

/// Bytes around the packets: header, length, checksum.
pub const FRAMING: usize = 3;

/// Bytes that fit into one slot of 15 ms, ten bits each: 172 at 115200 baud. A longer stream is garbled.
pub const fn slot_bytes(baud: u32) -> usize {
    baud as usize / 10 * 15 / 1000
}

/// Why bytes are no frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum FrameError {
    /// The first byte is not the header.
    #[error("it does not begin with 19")]
    NoHeader,
    /// A length of 0: such a frame would be empty, and 19 0 is common in numbers.
    #[error("its length is 0")]
    Empty,
    /// Where the number of a packet should stand there is another one.
    #[error("there is no packet {0}")]
    UnknownPacket(u8),
    /// The length ends inside a packet.
    #[error("it ends within packet {0}")]
    CutPacket(u8),
    /// It contains other packets than requested.
    #[error("its packets aren't those requested")]
    NotExpected,
    /// All bytes are there, and their sum is wrong: its low byte is given, which should be 0.
    #[error("its bytes add up to {0} instead of 0")]
    Checksum(u8),
    /// Bytes are missing.
    #[error("it is incomplete")]
    Incomplete,
}

/// A frame whose checksum and packets are right.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StreamFrame<'a> {
    fields: &'a [u8],
}

impl<'a> StreamFrame<'a> {
    /// Of what stands between length and checksum; the caller has looked at it.
    pub(super) const fn of_fields(fields: &'a [u8]) -> Self {
        Self { fields }
    }

    /// The packets with their numbers, as they are on the line.
    pub fn content(&self) -> &'a [u8] {
        self.fields
    }

    /// The frame at the start of `bytes`; what follows it is not looked at.
    ///
    /// ```
    /// use roomba_oi::{StreamFrame, FrameError, Packet};
    /// // The specification's example: light from the floor at the front left, virtual wall.
    /// let frame = StreamFrame::parse(&[19, 5, 29, 2, 25, 13, 0, 163]).unwrap();
    /// assert!(frame.values().eq([(Packet::CliffFrontLeftSignal, 537), (Packet::VirtualWall, 0)]));
    /// assert_eq!(StreamFrame::parse(&[19, 5, 29, 2, 25, 13, 0, 164]), Err(FrameError::Checksum(1)));
    /// ```
    pub fn parse(bytes: &'a [u8]) -> Result<Self, FrameError> {
        let (&header, rest) = bytes.split_first().ok_or(FrameError::Incomplete)?;
        if header != HEADER {
            return Err(FrameError::NoHeader);
        }
        let (&length, rest) = rest.split_first().ok_or(FrameError::Incomplete)?;
        let length = usize::from(length);
        if length == 0 {
            return Err(FrameError::Empty);
        }
        let mut at = 0;
        while at < length {
            let &id = rest.get(at).ok_or(FrameError::Incomplete)?;
            at += 1 + PacketId::size_of(id).ok_or(FrameError::UnknownPacket(id))?;
            if at > length {
                return Err(FrameError::CutPacket(id));
            }
        }
        let whole = bytes.get(..length + FRAMING).ok_or(FrameError::Incomplete)?;
        match sum(whole) {
            0 => Ok(Self { fields: rest.get(..length).ok_or(FrameError::Incomplete)? }),
            sum => Err(FrameError::Checksum(sum)),
        }
    }

    /// Bytes of the frame on the line.
    pub fn size(&self) -> usize {
        self.fields.len() + FRAMING
    }

    /// The requested packets, in the order of the frame, with their bytes. A group is one field.
    pub fn fields(&self) -> impl Iterator<Item = (PacketId, &'a [u8])> + use<'a> {
        let mut rest = self.fields;
        core::iter::from_fn(move || {
            let (&id, after) = rest.split_first()?;
            let id = PacketId::from_byte(id)?;
            let (field, after) = after.split_at_checked(id.size())?;
            rest = after;
            Some((id, field))
        })
    }

    /// The bits of every single packet, in the order of the frame: see [`Packet::value`].
    pub fn values(&self) -> impl Iterator<Item = (Packet, u16)> + use<'a> {
        self.fields().flat_map(|(id, mut rest)| {
            id.packets().map_while(move |packet| {
                let raw = packet.read(rest)?;
                rest = rest.get(packet.format().size()..)?;
                Some((packet, raw))
            })
        })
    }

    /// Whether every value is one that a robot can report. One garbled frame in 256 has a right checksum by chance.
    pub fn is_plausible(&self) -> bool {
        self.values().all(|(packet, raw)| packet.is_plausible(raw))
    }

    /// Writes all of it into `readings`; which packets that were.
    pub fn apply(&self, readings: &mut Readings) -> PacketSet {
        let mut applied = PacketSet::default();
        for (packet, raw) in self.values() {
            readings.set_raw(packet, raw);
            applied.insert(packet);
        }
        applied
    }
}

/// Why no frame is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("the frame needs {needed} bytes, but there is room for {room}")]
pub struct FrameTooLong {
    /// Bytes of the frame.
    pub needed: usize,
    /// Available bytes: those of the caller's buffer, or 258 by the limit of the length byte.
    pub room: usize,
}

/// Bytes of a frame with these packets on the line.
pub fn frame_size(packets: &[PacketId]) -> usize {
    FRAMING + packets.iter().map(|id| 1 + id.size()).sum::<usize>()
}

/// Writes a frame at the start of `out` and returns its bytes. To keep to the slot, give a buffer of [`slot_bytes`].
///
/// ```
/// use roomba_oi::{Packet, Readings, slot_bytes, write_frame};
/// let readings = Readings { left_counts: 65_535, right_counts: 1, ..Readings::default() };
/// let mut slot = [0; slot_bytes(115_200)];
/// let frame = write_frame(&[Packet::LeftEncoder.into(), Packet::RightEncoder.into()], &readings, &mut slot);
/// assert_eq!(frame, Ok(&[19, 6, 43, 255, 255, 44, 0, 1, 145][..]));
/// ```
pub fn write_frame<'b>(packets: &[PacketId], readings: &Readings, out: &'b mut [u8]) -> Result<&'b [u8], FrameTooLong> {
    let (needed, room) = (frame_size(packets), out.len().min(MAX_FRAME));
    let too_long = FrameTooLong { needed, room };
    if needed > room {
        return Err(too_long);
    }
    let [header, length, rest @ ..] = out.get_mut(..needed).ok_or(too_long)? else { return Err(too_long) };
    (*header, *length) = (HEADER, (needed - FRAMING) as u8);
    let mut at = 0;
    for id in packets {
        let [number, field @ ..] = rest.get_mut(at..).ok_or(too_long)? else { return Err(too_long) };
        *number = id.byte();
        at += 1 + readings.write(*id, field).ok_or(too_long)?;
    }
    if let Some(last) = rest.last_mut() {
        *last = 0;
    }
    let checksum = sum(out.get(..needed).ok_or(too_long)?).wrapping_neg();
    let frame = out.get_mut(..needed).ok_or(too_long)?;
    if let Some(last) = frame.last_mut() {
        *last = checksum;
    }
    Ok(frame)
}

/// Low byte of the sum of all bytes.
fn sum(bytes: &[u8]) -> u8 {
    bytes.iter().fold(0, |sum, &byte| sum.wrapping_add(byte))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slots_are_those_of_the_specification() {
        assert_eq!([115_200, 57_600, 19_200].map(slot_bytes), [172, 86, 28]);
    }

    #[test]
    fn frames_that_overrun_the_slot_are_refused() {
        let readings = Readings::default();
        let everything: Vec<PacketId> = Packet::ALL.iter().map(|&p| p.into()).collect();
        assert_eq!(frame_size(&everything), 135);
        assert_eq!(write_frame(&everything, &readings, &mut [0; 172]).map(<[u8]>::len), Ok(135));
        let groups = [PacketId::from_byte(100).unwrap(); 3];
        assert_eq!(frame_size(&groups[..1]), 84);
        let refused = |packets: &[PacketId], out: &mut [u8]| write_frame(packets, &readings, out).unwrap_err();
        assert_eq!(refused(&groups, &mut [0; slot_bytes(115_200)]), FrameTooLong { needed: 246, room: 172 });
        let all_too_many = [groups, groups].concat();
        assert_eq!(refused(&all_too_many, &mut [0; 1000]), FrameTooLong { needed: 489, room: 258 });
        assert_eq!(refused(&[], &mut []), FrameTooLong { needed: 3, room: 0 });
    }

    #[test]
    fn what_is_no_frame_says_why() {
        let error = |bytes: &[u8]| StreamFrame::parse(bytes).unwrap_err();
        assert_eq!((error(&[]), error(&[18])), (FrameError::Incomplete, FrameError::NoHeader));
        assert_eq!((error(&[19, 0, 237]), error(&[19, 2, 59])), (FrameError::Empty, FrameError::UnknownPacket(59)));
        assert_eq!((error(&[19, 2, 22]), error(&[19, 3, 22, 0])), (FrameError::CutPacket(22), FrameError::Incomplete));
    }
}
