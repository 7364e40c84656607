//! Answers to Sensors (142) and Query List (149): bare values, readable only with the request.

use super::{
    limits::CommandRefusal,
    packet::{Packet, PacketId, PacketSet},
    readings::Readings,
};

/// Most bytes of an answer: a limit of ours, three times all packets. A long answer is late, as the line takes 15 ms
/// for 172 bytes.
pub const MAX_ANSWER: usize = 240;

/// Takes one answer.
///
/// It has no header, no numbers and no checksum: a lost or additional byte, such as text of a charging robot, shifts
/// everything after it. The only check is [`Self::is_plausible`]; a stream is more reliable.
#[derive(Debug, Clone)]
pub struct AnswerReader {
    ids: [PacketId; MAX_ANSWER],
    asked: usize,
    bytes: [u8; MAX_ANSWER],
    filled: usize,
    expected: usize,
}

impl AnswerReader {
    /// The answer to a question for these packets, nothing of which has arrived yet.
    pub fn to(packets: &[u8]) -> Result<Self, CommandRefusal> {
        let mut answer = Self {
            ids: [Packet::Wall.into(); MAX_ANSWER],
            asked: packets.len(),
            bytes: [0; MAX_ANSWER],
            filled: 0,
            expected: 0,
        };
        for &id in packets {
            answer.expected += PacketId::size_of(id).ok_or(CommandRefusal::UnknownPacket(id))?;
        }
        if answer.expected > MAX_ANSWER {
            return Err(CommandRefusal::BufferTooSmall { needed: answer.expected, got: MAX_ANSWER });
        }
        // Each takes a byte at least: they fit.
        for (to, id) in answer.ids.iter_mut().zip(packets.iter().filter_map(|&id| PacketId::from_byte(id))) {
            *to = id;
        }
        Ok(answer)
    }

    /// Takes bytes until it is complete; those that are left over.
    ///
    /// ```
    /// use roomba_oi::{AnswerReader, Readings};
    /// let mut answer = AnswerReader::to(&[7, 13]).unwrap();
    /// assert_eq!(answer.feed(&[3]), [0_u8; 0]);
    /// assert_eq!(answer.missing(), 1);
    /// assert_eq!(answer.feed(&[0, 99]), [99]);
    /// let mut readings = Readings::default();
    /// answer.apply(&mut readings).unwrap();
    /// assert!(readings.bumps.bump_left && readings.bumps.bump_right && !readings.virtual_wall);
    /// ```
    pub fn feed<'b>(&mut self, bytes: &'b [u8]) -> &'b [u8] {
        let (taken, left) = bytes.split_at(bytes.len().min(self.missing()));
        for (to, from) in self.bytes.iter_mut().skip(self.filled).zip(taken) {
            *to = *from;
        }
        self.filled += taken.len();
        left
    }

    /// Bytes that have not arrived.
    pub fn missing(&self) -> usize {
        self.expected - self.filled
    }

    /// The bits of every single packet, in the order of the question; none until it is complete.
    pub fn values(&self) -> impl Iterator<Item = (Packet, u16)> + '_ {
        let asked = if self.missing() == 0 { self.asked } else { 0 };
        let mut rest = &self.bytes[..];
        self.ids.iter().take(asked).flat_map(|id| id.packets()).map_while(move |packet| {
            let raw = packet.read(rest)?;
            rest = rest.get(packet.format().size()..)?;
            Some((packet, raw))
        })
    }

    /// Whether it is complete and every value is one that a robot can report.
    pub fn is_plausible(&self) -> bool {
        self.missing() == 0 && self.values().all(|(packet, raw)| packet.is_plausible(raw))
    }

    /// Writes it into `readings`; which packets that were, or `None` until it is complete.
    pub fn apply(&self, readings: &mut Readings) -> Option<PacketSet> {
        if self.missing() > 0 {
            return None;
        }
        let mut applied = PacketSet::default();
        for (packet, raw) in self.values() {
            readings.set_raw(packet, raw);
            applied.insert(packet);
        }
        Some(applied)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cannot_be_asked_is_refused() {
        assert_eq!(AnswerReader::to(&[7, 60]).unwrap_err(), CommandRefusal::UnknownPacket(60));
        assert!(AnswerReader::to(&[100; 3]).is_ok_and(|answer| answer.missing() == 240));
        assert_eq!(
            AnswerReader::to(&[100; 4]).unwrap_err(),
            CommandRefusal::BufferTooSmall { needed: 320, got: MAX_ANSWER }
        );
    }

    #[test]
    fn nothing_is_told_before_the_last_byte() {
        let mut answer = AnswerReader::to(&[2, 35]).unwrap();
        answer.feed(&[161, 1, 0, 10, 255, 166]);
        assert_eq!((answer.values().count(), answer.apply(&mut Readings::default())), (0, None));
        assert!(!answer.is_plausible());
        answer.feed(&[9]);
        assert_eq!(answer.values().last(), Some((Packet::OiMode, 9)));
        assert!(!answer.is_plausible());
    }
}
