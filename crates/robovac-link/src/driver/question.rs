//! A query during a stream.
//!
//! Answers have neither header nor checksum: between frames they couldn't be recognised. So the stream is paused, and
//! the query is sent after the last frame has arrived.

use roomba_oi::{AnswerReader, Command, CommandDecoder};

/// Time for the last frame to arrive, s.
const DRAIN_S: f64 = 0.05;
/// Time for the answer, s: two frames, and the line's 240 bytes at most.
const ANSWER_S: f64 = 0.1;

/// A query in progress.
#[derive(Debug)]
pub(super) struct PendingQuery {
    bytes: Vec<u8>,
    ids: Vec<u8>,
    began: f64,
    is_sent: bool,
    heard: Vec<u8>,
}

/// The next action.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Next {
    Wait,
    Send(Vec<u8>),
    /// Finished: the answer as bytes, and in words.
    Done(Vec<u8>, String),
}

impl PendingQuery {
    /// The query in these bytes; `None` if there is none.
    pub fn of(bytes: &[u8], now: f64) -> Option<Self> {
        let mut decoder = CommandDecoder::default();
        let mut ids = Vec::new();
        for &byte in bytes {
            match decoder.push(byte).map(|received| received.command) {
                Some(Ok(Command::SensorReadings { packet })) => ids.push(packet),
                Some(Ok(Command::QueryList { packets })) => ids.extend_from_slice(packets),
                _ => {}
            }
        }
        (!ids.is_empty()).then(|| Self { bytes: bytes.to_vec(), ids, began: now, is_sent: false, heard: Vec::new() })
    }

    /// Whether received bytes belong to the answer.
    pub fn is_sent(&self) -> bool {
        self.is_sent
    }

    /// Takes a byte of the answer.
    pub fn hear(&mut self, byte: u8) {
        self.heard.push(byte);
    }

    /// Advances the query.
    pub fn advance(&mut self, now: f64) -> Next {
        let passed = now - self.began;
        if !self.is_sent && passed >= DRAIN_S {
            self.is_sent = true;
            return Next::Send(std::mem::take(&mut self.bytes));
        }
        if passed < DRAIN_S + ANSWER_S {
            return Next::Wait;
        }
        let words = self.words();
        Next::Done(std::mem::take(&mut self.heard), words)
    }

    fn words(&self) -> String {
        let mut answer = match AnswerReader::to(&self.ids) {
            Ok(answer) => answer,
            Err(error) => return format!("the answer can't be read: {error}"),
        };
        let rest = answer.feed(&self.heard);
        if answer.missing() > 0 {
            return format!("bytes missing from the answer: {}", answer.missing());
        }
        let values: Vec<String> = answer
            .values()
            .map(|(packet, raw)| format!("{packet} {} {}", packet.value(raw), packet.unit()).trim_end().to_owned())
            .collect();
        let doubt = if answer.is_plausible() { "" } else { "; not plausible" };
        let more = if rest.is_empty() { String::new() } else { format!("; extra bytes: {}", rest.len()) };
        values.join(", ") + doubt + &more
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_are_put_in_words() {
        let mut question = PendingQuery::of(&[142, 22, 149, 2, 7, 35], 0.0).unwrap();
        assert_eq!(question.advance(0.01), Next::Wait);
        assert!(matches!(question.advance(0.06), Next::Send(bytes) if bytes.len() == 6));
        for byte in [58, 152, 3, 1] {
            question.hear(byte);
        }
        let Next::Done(bytes, words) = question.advance(1.0) else { panic!() };
        assert_eq!(bytes, [58, 152, 3, 1]);
        assert!(words.contains("15000 mV"), "{words}");
        assert!(PendingQuery::of(&[128, 131], 0.0).is_none());
    }
}
