//! The WebSocket connections.

use super::gate::Gate;
use crate::failure::Failure;
use roomba_bridge::ClientId;
use std::{
    collections::VecDeque,
    io::{self, ErrorKind, Read, Write},
    net::{Shutdown, SocketAddr, TcpListener, TcpStream},
};
use tungstenite::{
    Bytes, Error, HandshakeError, Message, WebSocket, accept_hdr_with_config,
    handshake::{MidHandshake, server::ServerHandshake},
    protocol::{CloseFrame, WebSocketConfig, frame::coding::CloseCode},
};

/// Connections at once, refused ones and such that haven't asked for anything yet included.
const MOST: usize = 16;
/// Time limit for the request of a connection, and for the end of one that is closed, ms.
const PATIENCE_MS: u64 = 1000;
/// Connections that are accepted in one round.
const MOST_NEW: usize = 4;
/// Messages of a connection that are read before the others have their turn. More than a page sends in a round, so that a stop
/// doesn't wait for the next one.
const MOST_AT_ONCE: usize = 64;
/// Bytes of a connection that are read in one round.
const MOST_A_ROUND: usize = 4096;
/// Longest message. The longest command has 513 bytes.
const MOST_BYTES: usize = 1024;
/// Bytes that wait for a client that doesn't read; then it is dropped.
const MOST_WAITING: usize = 1 << 16;
/// Codes of closures by the bridge, of those for private use: for a reason that may pass, and for good.
const CLOSED: u16 = 4000;
const REFUSED: u16 = 4001;

type Handshake = ServerHandshake<Metered, Gate>;

/// A connection that gives a few bytes a round, whatever arrives: the library reads on as long as there is something, and
/// empty parts of a message are something for ever.
struct Metered {
    stream: TcpStream,
    left: usize,
}

impl Read for Metered {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.left == 0 {
            return Err(ErrorKind::WouldBlock.into());
        }
        let most = buffer.len().min(self.left);
        let count = self.stream.read(buffer.get_mut(..most).unwrap_or_default())?;
        self.left -= count;
        Ok(count)
    }
}

impl Write for Metered {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.stream.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.stream.flush()
    }
}

/// What the clients did.
pub enum Heard {
    Joined(ClientId, SocketAddr),
    Bytes(ClientId, Bytes),
    Text(ClientId, String),
    Left(ClientId),
    Refused(SocketAddr, &'static str),
}

pub struct Clients {
    listener: TcpListener,
    gate: Gate,
    connections: Vec<ClientConnection>,
    last_id: ClientId,
    /// Time of the last round.
    now_ms: u64,
}

struct ClientConnection {
    id: ClientId,
    from: SocketAddr,
    /// When it connected, or was closed.
    since_ms: u64,
    gate: Gate,
    stage: Stage,
    /// Whether its arrival was reported.
    is_known: bool,
}

enum Stage {
    /// Its request is still on its way.
    Asking(Option<Box<MidHandshake<Handshake>>>),
    Open(Box<WebSocket<Metered>>),
    /// The last message waits to be sent or answered.
    Closing(Box<WebSocket<Metered>>),
    Gone,
}

fn config() -> WebSocketConfig {
    WebSocketConfig::default()
        .read_buffer_size(MOST_BYTES)
        .write_buffer_size(0)
        .max_write_buffer_size(MOST_WAITING)
        .max_message_size(Some(MOST_BYTES))
        .max_frame_size(Some(MOST_BYTES))
}

fn is_busy(error: &Error) -> bool {
    matches!(error, Error::Io(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted))
}

impl Clients {
    pub fn new(listener: TcpListener, gate: Gate) -> Result<Self, Failure> {
        listener.set_nonblocking(true).map_err(|e| Failure::io("the listening socket", &e))?;
        Ok(Self { listener, gate, connections: Vec::new(), last_id: 0, now_ms: 0 })
    }

    /// What has arrived by now. Never waits.
    pub fn listen(&mut self, now_ms: u64) -> Vec<Heard> {
        self.now_ms = now_ms;
        self.accept();
        let mut heard = Vec::new();
        for connection in &mut self.connections {
            connection.go_on(now_ms, &mut heard);
        }
        self.connections.retain(|connection| !matches!(connection.stage, Stage::Gone));
        heard
    }

    /// Sends a text message.
    pub fn tell(&mut self, client: ClientId, text: &str) {
        self.connections.iter_mut().filter(|one| one.id == client).for_each(|one| one.send(Message::text(text)));
    }

    /// Sends bytes to all.
    pub fn send_all(&mut self, bytes: &[u8]) {
        if bytes.is_empty() {
            return;
        }
        let bytes = Bytes::copy_from_slice(bytes);
        self.connections.iter_mut().for_each(|one| one.send(Message::Binary(bytes.clone())));
    }

    /// Disconnects a client; the reason reaches it.
    pub fn close(&mut self, client: ClientId, why: &str) {
        let now_ms = self.now_ms;
        self.connections.iter_mut().filter(|one| one.id == client).for_each(|one| one.close(now_ms, CLOSED, why));
    }

    /// Whether a last message still has to be sent or answered.
    pub fn is_closing(&self) -> bool {
        self.connections.iter().any(|one| matches!(one.stage, Stage::Closing(_)))
    }

    fn accept(&mut self) {
        for _ in 0..MOST_NEW {
            let Ok((stream, from)) = self.listener.accept() else { return };
            if self.connections.len() >= MOST {
                // Whoever connects and asks for nothing must not keep out whoever does: the first of them makes room.
                let Some(silent) = self.connections.iter().position(|one| matches!(one.stage, Stage::Asking(_))) else {
                    continue;
                };
                self.connections.remove(silent);
            }
            if stream.set_nonblocking(true).is_err() {
                continue;
            }
            // Every few bytes count; if it can't be set, they come a little later.
            let _ = stream.set_nodelay(true);
            self.last_id = self.last_id.wrapping_add(1);
            let gate = self.gate.for_next();
            let stream = Metered { stream, left: MOST_A_ROUND };
            let stage = Stage::after(accept_hdr_with_config(stream, gate.clone(), Some(config())));
            let (id, since_ms) = (self.last_id, self.now_ms);
            self.connections.push(ClientConnection { id, from, since_ms, gate, stage, is_known: false });
        }
    }
}

impl Stage {
    fn after(shaken: Result<WebSocket<Metered>, HandshakeError<Handshake>>) -> Self {
        match shaken {
            Ok(socket) => Self::Open(Box::new(socket)),
            Err(HandshakeError::Interrupted(rest)) => Self::Asking(Some(Box::new(rest))),
            Err(HandshakeError::Failure(_)) => Self::Gone,
        }
    }
}

impl ClientConnection {
    fn go_on(&mut self, now_ms: u64, heard: &mut Vec<Heard>) {
        let is_late = now_ms.saturating_sub(self.since_ms) >= PATIENCE_MS;
        match &mut self.stage {
            Stage::Asking(rest) => {
                if let Some(rest) = rest.take() {
                    self.stage = Stage::after(rest.handshake());
                }
                if matches!(self.stage, Stage::Asking(_)) && is_late {
                    self.stage = Stage::Gone;
                }
            }
            Stage::Open(_) if !self.is_known => {
                self.is_known = true;
                match self.gate.refused() {
                    None => heard.push(Heard::Joined(self.id, self.from)),
                    Some(why) => {
                        heard.push(Heard::Refused(self.from, why));
                        self.close(now_ms, REFUSED, why);
                    }
                }
            }
            Stage::Open(socket) => {
                if !read(self.id, socket, heard) {
                    heard.push(Heard::Left(self.id));
                    self.stage = Stage::Gone;
                }
            }
            Stage::Closing(socket) => {
                let is_over = socket.flush().is_err_and(|e| !is_busy(&e)) || !drain(socket, &mut VecDeque::new());
                if is_over || is_late {
                    self.stage = Stage::Gone;
                }
            }
            Stage::Gone => {}
        }
    }

    fn send(&mut self, message: Message) {
        let Stage::Open(socket) = &mut self.stage else { return };
        if !self.is_known {
            return;
        }
        match socket.send(message) {
            Err(error) if is_busy(&error) => {}
            // It doesn't read: closed here, so that the next read reports that it has left.
            Err(_) => drop(socket.get_ref().stream.shutdown(Shutdown::Both)),
            Ok(()) => {}
        }
    }

    fn close(&mut self, now_ms: u64, code: u16, why: &str) {
        let Stage::Open(mut socket) = std::mem::replace(&mut self.stage, Stage::Gone) else { return };
        let frame = CloseFrame { code: CloseCode::from(code), reason: why.into() };
        if socket.close(Some(frame)).map_or_else(|error| is_busy(&error), |()| true) {
            self.since_ms = now_ms;
            self.stage = Stage::Closing(socket);
        }
    }
}

/// Reads messages; false at the end of the connection.
fn read(id: ClientId, socket: &mut WebSocket<Metered>, heard: &mut Vec<Heard>) -> bool {
    let mut messages = VecDeque::new();
    let is_there = drain(socket, &mut messages);
    heard.extend(messages.into_iter().filter_map(|message| match message {
        Message::Binary(bytes) => Some(Heard::Bytes(id, bytes)),
        Message::Text(text) => Some(Heard::Text(id, text.to_string())),
        // Answered by the library.
        Message::Ping(_) | Message::Pong(_) | Message::Close(_) | Message::Frame(_) => None,
    }));
    is_there
}

fn drain(socket: &mut WebSocket<Metered>, messages: &mut VecDeque<Message>) -> bool {
    socket.get_mut().left = MOST_A_ROUND;
    for _ in 0..MOST_AT_ONCE {
        match socket.read() {
            Ok(message) => messages.push_back(message),
            Err(error) => return is_busy(&error),
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::thread;

    /// Accepts clients until there is one event, at one time.
    fn first_heard(clients: &mut Clients, now_ms: u64) -> Heard {
        loop {
            if let Some(heard) = clients.listen(now_ms).into_iter().next() {
                return heard;
            }
        }
    }

    fn listening() -> (Clients, SocketAddr) {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = listener.local_addr().unwrap();
        (Clients::new(listener, Gate::new(None, Vec::new())).unwrap(), address)
    }

    fn fill(clients: &mut Clients, address: SocketAddr, now_ms: u64) -> Vec<TcpStream> {
        let silent: Vec<_> = (0..MOST).map(|_| TcpStream::connect(address).unwrap()).collect();
        while clients.connections.len() < MOST {
            clients.listen(now_ms);
        }
        silent
    }

    #[test]
    fn connections_that_ask_for_nothing_lose_their_places_after_a_second() {
        let (mut clients, address) = listening();
        let silent = fill(&mut clients, address, 0);
        clients.listen(PATIENCE_MS - 1);
        assert_eq!(clients.connections.len(), MOST);
        clients.listen(PATIENCE_MS);
        assert_eq!(clients.connections.len(), 0);
        assert!(silent.iter().all(|mut one| matches!(one.read(&mut [0]), Ok(0))), "they were closed");
    }

    #[test]
    fn connections_that_ask_for_nothing_keep_nobody_out() {
        let (mut clients, address) = listening();
        let _silent = fill(&mut clients, address, 0);
        let client = thread::spawn(move || {
            let stream = TcpStream::connect(address).unwrap();
            tungstenite::client("ws://bridge/", stream).is_ok()
        });
        assert!(matches!(first_heard(&mut clients, 0), Heard::Joined(..)));
        assert!(client.join().unwrap());
    }
}
