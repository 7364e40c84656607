//! A TCP port that carries raw bytes, as serial bridges do. One client at a time; the next one waits.

use super::line::{HostLine, keep_latest};
use crate::failure::Failure;
use std::{
    collections::VecDeque,
    io::{Error, ErrorKind, Read, Write},
    net::{SocketAddr, TcpListener, TcpStream},
};

/// The port, and the connected host.
pub struct TcpLine {
    listener: TcpListener,
    address: SocketAddr,
    baud: u32,
    client: Option<TcpStream>,
    waiting: VecDeque<u8>,
}

impl TcpLine {
    pub fn listen(address: &str, baud: u32) -> Result<Self, Failure> {
        let fail = |e: Error| Failure::io(address, &e);
        let listener = TcpListener::bind(address).map_err(fail)?;
        listener.set_nonblocking(true).map_err(fail)?;
        let address = listener.local_addr().map_err(fail)?;
        Ok(Self { listener, address, baud, client: None, waiting: VecDeque::new() })
    }

    fn greet(&mut self) {
        if self.client.is_some() {
            return;
        }
        if let Ok((client, _)) = self.listener.accept()
            && client.set_nonblocking(true).is_ok()
        {
            // Every few bytes count; if it can't be set, they come a little later.
            let _ = client.set_nodelay(true);
            self.waiting.clear();
            self.client = Some(client);
        }
    }
}

fn is_busy(error: &Error) -> bool {
    matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted)
}

impl HostLine for TcpLine {
    fn name(&self) -> String {
        self.address.to_string()
    }

    fn baud(&self) -> u32 {
        self.baud
    }

    fn has_host(&self) -> bool {
        self.client.is_some()
    }

    fn read(&mut self, most: usize, bytes: &mut Vec<u8>) -> Result<bool, Failure> {
        self.greet();
        let Some(client) = &mut self.client else { return Ok(true) };
        let mut buffer = [0; 512];
        match client.read(buffer.get_mut(..most.min(512)).unwrap_or_default()) {
            Ok(count @ 1..) => bytes.extend(buffer.get(..count).unwrap_or_default()),
            // It can have closed its half only, and still wait for answers.
            Ok(0) => return Ok(false),
            Err(error) if is_busy(&error) => {}
            Err(_) => self.client = None,
        }
        Ok(true)
    }

    fn next_host(&mut self) -> bool {
        self.client = None;
        true
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        let Some(client) = &mut self.client else { return Ok(()) };
        keep_latest(&mut self.waiting, bytes);
        while !self.waiting.is_empty() {
            match client.write(self.waiting.as_slices().0) {
                Ok(count @ 1..) => drop(self.waiting.drain(..count)),
                Err(error) if is_busy(&error) => break,
                Ok(0) | Err(_) => {
                    self.client = None;
                    break;
                }
            }
        }
        Ok(())
    }
}
