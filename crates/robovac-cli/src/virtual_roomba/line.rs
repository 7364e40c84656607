//! The virtual Roomba's serial line.

use crate::failure::Failure;
use std::{
    collections::VecDeque,
    io::{Read, Write},
    sync::{
        Arc, Condvar, Mutex, PoisonError,
        mpsc::{Receiver, TryRecvError, sync_channel},
    },
    thread,
};

/// Bytes that wait for a reader at most; the oldest go first.
const MOST_WAITING: usize = 1 << 16;
/// Portions of standard input that are read ahead at most; whoever writes more has to wait.
const MOST_LUMPS: usize = 4;
/// Bytes of such a portion at most.
const LUMP: usize = 4096;

/// The host's end of a line. Nothing here ever waits for the host.
pub trait HostLine {
    /// The text after `ready`.
    fn name(&self) -> String;

    /// The host's baud rate.
    fn baud(&self) -> u32;

    /// Whether a program has it open.
    fn has_host(&self) -> bool {
        true
    }

    /// Appends received bytes, at most `most`; false if the host has said all that it will.
    fn read(&mut self, most: usize, bytes: &mut Vec<u8>) -> Result<bool, Failure>;

    /// Sends bytes; unread ones are dropped, the oldest first.
    fn write(&mut self, bytes: &[u8]) -> Result<(), Failure>;

    /// Lets a host go that has said all; whether another one can come.
    fn next_host(&mut self) -> bool {
        false
    }

    /// Pulls the cable out, or plugs it in again; whether that can be done.
    fn plug(&mut self, _is_plugged: bool) -> Result<bool, Failure> {
        Ok(false)
    }
}

/// Appends bytes, and forgets the oldest of those that are too many.
pub fn keep_latest(queue: &mut VecDeque<u8>, bytes: &[u8]) {
    queue.extend(bytes);
    queue.drain(..queue.len().saturating_sub(MOST_WAITING));
}

/// Standard input and output, each with a thread that can block.
pub struct StandardStreams {
    baud: u32,
    incoming: Receiver<Vec<u8>>,
    /// What is read and not passed on yet.
    rest: VecDeque<u8>,
    outgoing: Arc<(Mutex<VecDeque<u8>>, Condvar)>,
}

impl StandardStreams {
    pub fn new(baud: u32) -> Self {
        Self::over(baud, std::io::stdin(), std::io::stdout())
    }

    fn over(baud: u32, mut input: impl Read + Send + 'static, mut output: impl Write + Send + 'static) -> Self {
        let (sender, incoming) = sync_channel(MOST_LUMPS);
        thread::spawn(move || {
            let mut buffer = [0; LUMP];
            while let Ok(count @ 1..) = input.read(&mut buffer) {
                if sender.send(buffer.get(..count).unwrap_or_default().to_vec()).is_err() {
                    return;
                }
            }
        });
        let outgoing = Arc::new((Mutex::new(VecDeque::new()), Condvar::new()));
        let queue = Arc::clone(&outgoing);
        thread::spawn(move || {
            loop {
                let mut waiting = queue.0.lock().unwrap_or_else(PoisonError::into_inner);
                while waiting.is_empty() {
                    waiting = queue.1.wait(waiting).unwrap_or_else(PoisonError::into_inner);
                }
                let bytes: Vec<u8> = waiting.drain(..).collect();
                drop(waiting);
                if output.write_all(&bytes).and_then(|()| output.flush()).is_err() {
                    return;
                }
            }
        });
        Self { baud, incoming, rest: VecDeque::new(), outgoing }
    }
}

impl HostLine for StandardStreams {
    fn name(&self) -> String {
        "stdio".to_owned()
    }

    fn baud(&self) -> u32 {
        self.baud
    }

    fn read(&mut self, most: usize, bytes: &mut Vec<u8>) -> Result<bool, Failure> {
        if self.rest.is_empty() {
            match self.incoming.try_recv() {
                Ok(more) => self.rest.extend(more),
                Err(TryRecvError::Empty) => {}
                Err(TryRecvError::Disconnected) => return Ok(false),
            }
        }
        bytes.extend(self.rest.drain(..most.min(self.rest.len())));
        Ok(true)
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        if !bytes.is_empty() {
            keep_latest(&mut self.outgoing.0.lock().unwrap_or_else(PoisonError::into_inner), bytes);
            self.outgoing.1.notify_one();
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};

    /// Never ends, and counts what was taken of it.
    struct Endless(Arc<AtomicUsize>);

    impl Read for Endless {
        fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
            buffer.fill(128);
            self.0.fetch_add(buffer.len(), Ordering::SeqCst);
            Ok(buffer.len())
        }
    }

    #[test]
    fn standard_input_was_kept_without_limit() {
        let taken = Arc::new(AtomicUsize::new(0));
        let mut line = StandardStreams::over(115_200, Endless(Arc::clone(&taken)), std::io::sink());
        let mut bytes = Vec::new();
        while bytes.len() < 100 * LUMP {
            assert!(line.read(512, &mut bytes).is_ok());
            // What waits, what waits for a place there, and the rest that isn't passed on yet.
            assert!(taken.load(Ordering::SeqCst) <= bytes.len() + (MOST_LUMPS + 2) * LUMP);
            thread::yield_now();
        }
    }
}
