//! What a program commanded: all that a run needs to be repeated without the program.

use robovac_core::robot::Drive;

/// Begin of the bytes of a log.
const MAGIC: [u8; 4] = *b"RVPL";
/// The version that is written and read.
const VERSION: u8 = 1;
/// Bytes before the changes: magic, version, end, two unused, from, until, number of changes.
const HEAD: usize = 20;
/// Bytes of a change: step, left, right.
const CHANGE: usize = 8;

/// The wheel commands of a program, step by step, as far as it was run.
///
/// Bytes, little-endian: `RVPL`, version (1), end (0 for none, 1 for done, 2 for failed), two zeros, the steps
/// `from` and `until` and the number of changes (32 bits each), then for each change its step (32 bits) and the
/// speeds left and right in mm/s (16 bits each, signed).
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct CommandLog {
    changes: Vec<CommandChange>,
    until: u32,
    end: Option<LogEnd>,
}

/// A part of a log: what holds from a step on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LogPart {
    from: u32,
    log: CommandLog,
}

/// Other speeds than before.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CommandChange {
    /// Number of steps before it.
    pub step: u32,
    /// Left and right wheel, mm/s.
    pub wheels_mm_s: [i16; 2],
}

/// How a program ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LogEnd {
    /// It had nothing left to do.
    Done,
    /// An error or a limit ended it.
    Failed,
}

/// Reasons why bytes aren't a log, or don't continue one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum LogError {
    /// They begin with something else.
    #[error("this isn't the log of a program")]
    NotALog,
    /// They are of another version.
    #[error("this log has version {0}, and only version {VERSION} is known; run the program again")]
    Version(u8),
    /// Their number is wrong.
    #[error("the log is incomplete: it has {found} bytes of {expected}; run the program again")]
    Length {
        /// Bytes that there are.
        found: usize,
        /// Bytes that its head promises.
        expected: usize,
    },
    /// There is no such end.
    #[error("the log has an unknown end, {0}; run the program again")]
    End(u8),
    /// A change that is too early or too late.
    #[error("the log's change {0} is out of order; run the program again")]
    Order(usize),
    /// It begins after the end of the log that it is to continue.
    #[error("the log continues at step {from}, but the one before it ends at step {until}; run the program again")]
    Gap {
        /// Its first step.
        from: u32,
        /// Where the log ends.
        until: u32,
    },
    /// It would change what was shown already.
    #[error("the log begins at step {from}, but the run was shown up to step {shown}; run the program again")]
    Past {
        /// Its first step.
        from: u32,
        /// Steps that were shown.
        shown: u32,
    },
}

impl CommandLog {
    /// The changes in their order.
    pub fn changes(&self) -> &[CommandChange] {
        &self.changes
    }

    /// Number of steps for which the program has commanded.
    pub fn until(&self) -> u32 {
        self.until
    }

    /// How the program ended, if it has.
    pub fn end(&self) -> Option<LogEnd> {
        self.end
    }

    /// Adds the next step's command. Does nothing once the program has ended.
    pub fn push(&mut self, wheels_mm_s: [i16; 2]) {
        if self.end.is_some() || self.until == u32::MAX {
            return;
        }
        let last = self.changes.last().map_or([0; 2], |change| change.wheels_mm_s);
        if last != wheels_mm_s {
            self.changes.push(CommandChange { step: self.until, wheels_mm_s });
        }
        self.until += 1;
    }

    /// Ends it here.
    pub fn finish(&mut self, end: LogEnd) {
        self.end.get_or_insert(end);
    }

    /// Forgets everything from `step` on.
    pub fn truncate(&mut self, step: u32) {
        if step < self.until || self.end.is_some() && step <= self.until {
            self.until = step.min(self.until);
            self.end = None;
            let kept = self.changes.partition_point(|change| change.step < step);
            self.changes.truncate(kept);
        }
    }

    /// Replaces everything from the part's beginning on.
    pub fn extend(&mut self, part: LogPart) -> Result<(), LogError> {
        let LogPart { from, log } = part;
        if from > self.until {
            return Err(LogError::Gap { from, until: self.until });
        }
        self.truncate(from);
        self.changes.extend(log.changes);
        (self.until, self.end) = (log.until, log.end);
        Ok(())
    }

    /// The same, but refuses to change what holds before step `shown`. The part may repeat it.
    pub fn extend_beyond(&mut self, shown: u32, mut part: LogPart) -> Result<(), LogError> {
        if part.from < shown {
            let index = |changes: &[CommandChange], step| changes.partition_point(|change| change.step < step);
            // A part can end before what was shown.
            let both = shown.min(part.log.until);
            let [from, to] = [part.from, both].map(|step| index(&self.changes, step));
            let repeated = index(&part.log.changes, both);
            let is_same = self.changes[from..to] == part.log.changes[..repeated];
            // A run goes on for a moment after its program has ended.
            let same_end = (part.log.until, part.log.end) == (self.until, self.end);
            if !is_same || part.log.end.is_some() && part.log.until < shown && !same_end {
                return Err(LogError::Past { from: part.from, shown });
            }
            if part.log.until < shown {
                // Nothing new.
                return Ok(());
            }
            part.log.changes.drain(..repeated);
            part.from = shown;
        }
        self.extend(part)
    }

    /// What holds from the step `from` on, as bytes.
    pub fn to_bytes_from(&self, from: u32) -> Vec<u8> {
        let from = from.min(self.until);
        let first = self.changes.partition_point(|change| change.step < from);
        let changes = &self.changes[first..];
        let end = self.end.map_or(0, |end| end as u8 + 1);
        let mut bytes = Vec::with_capacity(HEAD + CHANGE * changes.len());
        bytes.extend(MAGIC);
        bytes.extend([VERSION, end, 0, 0]);
        bytes.extend([from, self.until, changes.len() as u32].into_iter().flat_map(u32::to_le_bytes));
        for change in changes {
            bytes.extend(change.step.to_le_bytes());
            bytes.extend(change.wheels_mm_s.into_iter().flat_map(i16::to_le_bytes));
        }
        bytes
    }

    /// All of it as bytes.
    pub fn to_bytes(&self) -> Vec<u8> {
        self.to_bytes_from(0)
    }

    /// The inverse of [`CommandLog::to_bytes`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, LogError> {
        let mut log = Self::default();
        log.extend(LogPart::from_bytes(bytes)?)?;
        Ok(log)
    }
}

impl LogPart {
    /// The inverse of [`CommandLog::to_bytes_from`]. Any bytes are safe.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, LogError> {
        let (head, rest) = bytes.split_first_chunk::<HEAD>().ok_or(LogError::NotALog)?;
        if head[..4] != MAGIC {
            return Err(LogError::NotALog);
        }
        if head[4] != VERSION {
            return Err(LogError::Version(head[4]));
        }
        let end = match head[5] {
            0 => None,
            1 => Some(LogEnd::Done),
            2 => Some(LogEnd::Failed),
            other => return Err(LogError::End(other)),
        };
        let [from, until, count] = [8, 12, 16].map(|at| u32::from_le_bytes([0, 1, 2, 3].map(|byte| head[at + byte])));
        let expected = (count as usize).saturating_mul(CHANGE);
        if rest.len() != expected {
            return Err(LogError::Length { found: bytes.len(), expected: expected.saturating_add(HEAD) });
        }
        let changes: Vec<_> =
            rest.as_chunks::<CHANGE>().0.iter().map(|&bytes| CommandChange::from_bytes(bytes)).collect();
        let mut next = from;
        for (index, change) in changes.iter().enumerate() {
            if change.step < next || change.step >= until {
                return Err(LogError::Order(index));
            }
            next = change.step + 1;
        }
        if until < from {
            return Err(LogError::Order(0));
        }
        Ok(Self { from, log: CommandLog { changes, until, end } })
    }

    /// The step from which on it holds.
    pub fn from(&self) -> u32 {
        self.from
    }
}

impl CommandChange {
    fn from_bytes([a, b, c, d, left @ .., right_low, right_high]: [u8; CHANGE]) -> Self {
        let wheels_mm_s = [i16::from_le_bytes(left), i16::from_le_bytes([right_low, right_high])];
        Self { step: u32::from_le_bytes([a, b, c, d]), wheels_mm_s }
    }

    /// The drive command.
    pub fn drive(self) -> Drive {
        let [left, right] = self.wheels_mm_s.map(|speed| f64::from(speed) / 1000.0);
        Drive::wheels(left, right)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A log of that many steps; speeds change every third.
    fn log(steps: u32) -> CommandLog {
        let mut log = CommandLog::default();
        for step in 0..steps {
            log.push([(step / 3) as i16, -300]);
        }
        log
    }

    #[test]
    fn bytes_bring_back_a_log_and_its_parts() {
        for steps in [0, 1, 2, 100] {
            let mut log = log(steps);
            assert_eq!(CommandLog::from_bytes(&log.to_bytes()), Ok(log.clone()));
            log.finish(LogEnd::Failed);
            for from in [0, 1, 50, 99, 100, 101] {
                let mut other = CommandLog::from_bytes(&log.to_bytes()).unwrap();
                other.truncate(from);
                assert!(other.until() <= from && (from > steps || other.end().is_none()), "{steps} {from}");
                other.extend(LogPart::from_bytes(&log.to_bytes_from(from)).unwrap()).unwrap();
                assert_eq!(other, log, "{steps} {from}");
            }
        }
    }

    #[test]
    fn only_changes_are_stored() {
        let log = log(30);
        assert_eq!((log.changes().len(), log.until()), (10, 30));
        let mut still = CommandLog::default();
        still.push([0, 0]);
        assert_eq!((still.changes().len(), still.until()), (0, 1), "a robot stands still at first");
    }

    #[test]
    fn what_was_shown_is_not_changed() {
        let long = log(40);
        let mut other = log(10);
        other.push([7, 7]);
        let part = |log: &CommandLog, from| LogPart::from_bytes(&log.to_bytes_from(from)).unwrap();
        for from in [0, 5, 20] {
            let mut grows = log(20);
            assert_eq!(grows.extend_beyond(20, part(&long, from)), Ok(()));
            assert_eq!(grows, long, "{from}");
            let mut stays = log(20);
            assert_eq!(stays.extend_beyond(20, part(&log(10), from.min(10))), Ok(()));
            assert_eq!(stays, log(20), "{from}");
        }
        let mut stays = log(20);
        assert_eq!(stays.extend_beyond(20, part(&other, 5)), Err(LogError::Past { from: 5, shown: 20 }));
        let mut ended = log(10);
        ended.finish(LogEnd::Done);
        assert!(stays.extend_beyond(20, part(&ended, 5)).is_err());
        assert_eq!(stays, log(20));
    }

    #[test]
    fn a_gap_is_refused() {
        let part = LogPart::from_bytes(&log(10).to_bytes_from(5)).unwrap();
        assert_eq!(CommandLog::default().extend(part), Err(LogError::Gap { from: 5, until: 0 }));
    }

    /// No bytes panic, whatever is cut off or changed, and what is accepted is in order.
    #[test]
    fn hostile_bytes_are_refused() {
        let good = log(20).to_bytes();
        for end in 0..good.len() {
            assert!(CommandLog::from_bytes(&good[..end]).is_err(), "{end}");
        }
        for at in 0..good.len() {
            for value in 0..=255 {
                let mut bytes = good.clone();
                bytes[at] = value;
                if let Ok(log) = CommandLog::from_bytes(&bytes) {
                    assert!(log.changes().is_sorted_by(|a, b| a.step < b.step));
                    assert!(log.changes().iter().all(|change| change.step < log.until()));
                }
            }
        }
        let mut huge = good.clone();
        huge[16..20].fill(255);
        assert!(matches!(CommandLog::from_bytes(&huge), Err(LogError::Length { .. })));
        assert_eq!(CommandLog::from_bytes(b"GIF89a").unwrap_err(), LogError::NotALog);
    }
}
