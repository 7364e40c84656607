//! Decodes commands from a byte stream: the robot's side.

use super::{
    command::{Command, MAX_RECEIVED, ParseError},
    opcode::Opcode,
};

/// Puts commands together as their bytes arrive.
///
/// Like the robot, it waits for missing data bytes for ever, and takes the next bytes for them. A byte that isn't an
/// opcode is reported and skipped, and the next one is taken as an opcode.
///
/// It ignores modes. The treatment of data bytes of a command that the mode ignores isn't documented; here they belong
/// to the command.
#[derive(Debug, Clone)]
pub struct CommandDecoder {
    bytes: [u8; MAX_RECEIVED],
    length: usize,
    complete: bool,
}

/// A command that arrived, or a byte that is none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Received<'a> {
    /// As they were on the line.
    pub bytes: &'a [u8],
    /// The command. Values can be out of range: see [`Command::check`].
    pub command: Result<Command<'a>, ParseError>,
}

impl Default for CommandDecoder {
    fn default() -> Self {
        Self { bytes: [0; MAX_RECEIVED], length: 0, complete: false }
    }
}

impl CommandDecoder {
    /// Takes the next byte; gives the command that it completes.
    ///
    /// ```
    /// use roomba_oi::{Command, CommandDecoder};
    /// let mut decoder = CommandDecoder::default();
    /// for byte in [145, 0, 200, 255] {
    ///     assert_eq!(decoder.push(byte), None);
    /// }
    /// let received = decoder.push(56).unwrap();
    /// assert_eq!(received.command, Ok(Command::DriveDirect { right: 200, left: -200 }));
    /// ```
    pub fn push(&mut self, byte: u8) -> Option<Received<'_>> {
        if self.complete {
            self.clear();
        }
        if let Some(free) = self.bytes.get_mut(self.length) {
            *free = byte;
            self.length += 1;
        }
        let bytes = self.bytes.get(..self.length)?;
        let opcode = bytes.first().and_then(|&first| Opcode::from_byte(first));
        self.complete = opcode.is_none_or(|opcode| opcode.command_length(bytes) == Some(self.length));
        self.complete.then(|| Received { bytes, command: Command::parse(bytes) })
    }

    /// The command whose data bytes it waits for, and how many of its bytes are there, opcode included.
    pub fn waiting(&self) -> Option<(Opcode, usize)> {
        let opcode = self.bytes.first().and_then(|&first| Opcode::from_byte(first))?;
        (self.length > 0 && !self.complete).then_some((opcode, self.length))
    }

    /// Discards all bytes, like a robot that is reset.
    pub fn clear(&mut self) {
        (self.length, self.complete) = (0, false);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_song_fits() {
        let mut decoder = CommandDecoder::default();
        for byte in [140, 0, 255].into_iter().chain([60; 509]) {
            assert_eq!(decoder.push(byte), None);
        }
        assert_eq!(decoder.waiting(), Some((Opcode::Song, 512)));
        let Some(Received { command: Ok(Command::Song { notes, .. }), .. }) = decoder.push(60) else { panic!() };
        assert_eq!((notes.len(), decoder.waiting()), (255, None));
    }

    #[test]
    fn unknown_bytes_are_skipped_one_by_one() {
        let mut decoder = CommandDecoder::default();
        for byte in [0, 147, 255] {
            assert_eq!(decoder.push(byte).map(|r| r.command), Some(Err(ParseError::Unknown(byte))));
        }
        assert_eq!(decoder.push(128).map(|r| r.command), Some(Ok(Command::Start)));
    }

    #[test]
    fn a_lost_data_byte_is_replaced_by_the_next_opcode() {
        let mut decoder = CommandDecoder::default();
        let commands: Vec<_> =
            [145, 0, 200, 255, 128, 131].iter().filter_map(|&b| Some(decoder.push(b)?.bytes.to_vec())).collect();
        assert_eq!(commands, [vec![145, 0, 200, 255, 128], vec![131]]);
    }
}
