//! Who drives, and the dead man's switch.

use super::{
    motion::{ActiveOutputs, HALT, STOP, STOP_ALL, starts},
    repeat::Repeat,
    words::{FromBridge, Halted, ToBridge},
};
use roomba_oi::{Command, CommandDecoder, MAX_RECEIVED};

/// Clients at once, at most.
pub const MAX_CLIENTS: usize = 8;

/// Longest command that is passed on: a stream of all packets has 61 bytes. Longer ones would make a stop wait behind them.
const LONGEST: usize = 64;

/// The rate of robots that lost their settings, baud.
const SLOW_BAUD: u32 = 19_200;

/// Names a client while it is connected; chosen by the program.
pub type ClientId = u32;

/// The serial port, and the clients' connections.
pub trait Ends {
    /// Queues a whole command for the robot. Returns whether there was room; if not, nothing of it may be sent.
    ///
    /// A queue should hold no more than the line carries in 0.1 s, so that commands don't get old in it.
    fn robot(&mut self, command: &[u8]) -> bool;
    /// Sends a stop at once, instead of all commands in the queue.
    fn stop(&mut self, bytes: &[u8]);
    /// Sets the serial port's rate, after all stops so far have left.
    fn baud(&mut self, baud: u32);
    /// Pulls the robot's wake-up pin low, or releases it.
    fn brc(&mut self, is_low: bool);
    /// Sends a text message.
    fn tell(&mut self, client: ClientId, word: FromBridge);
    /// Disconnects a client, which has been removed.
    fn close(&mut self, client: ClientId, why: &str);
}

/// Time limits, ms.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// Age of the newest [`FromBridge::Beat`] that the driver has answered, at which the wheels are stopped, while anything of
    /// the robot is on, and at which commands that set something in motion are too late.
    pub halt_ms: u64,
    /// The same age at which everything is stopped and the driver is disconnected, while anything is on.
    pub lost_ms: u64,
    /// Silence after which a client is disconnected, so that others have its place.
    pub idle_ms: u64,
    /// Time between two [`FromBridge::Beat`].
    pub beat_ms: u64,
}

impl Default for Limits {
    /// 0.2 s, 1 s, 5 s, 0.04 s.
    fn default() -> Self {
        Self { halt_ms: 200, lost_ms: 1000, idle_ms: 5000, beat_ms: 40 }
    }
}

/// All places are taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Full;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Client {
    id: ClientId,
    heard_ms: u64,
}

/// The rules of the bridge. Times are ms of any clock that never runs backwards.
#[derive(Debug, Clone)]
pub struct Bridge {
    limits: Limits,
    /// The rate at which every driver finds the line, baud.
    home_baud: u32,
    baud: u32,
    is_brc_low: bool,
    /// In order of arrival; the first one drives.
    clients: [Option<Client>; MAX_CLIENTS],
    /// Number of the latest [`FromBridge::Drive`], when it was sent, and whether it was answered.
    turn: u32,
    turn_ms: u64,
    is_taken: bool,
    /// When the newest message was sent that the driver has answered.
    alive_ms: u64,
    /// When the last [`FromBridge::Beat`] was sent, which is its number.
    beat_ms: Option<u64>,
    decoder: CommandDecoder,
    motion: ActiveOutputs,
    repeat: Repeat,
}

impl Bridge {
    /// A bridge without a serial port and without clients; the port will be open at `baud`.
    pub fn new(limits: Limits, baud: u32) -> Self {
        Self {
            limits,
            home_baud: baud,
            baud,
            is_brc_low: false,
            clients: [None; MAX_CLIENTS],
            turn: 0,
            turn_ms: 0,
            is_taken: false,
            alive_ms: 0,
            beat_ms: None,
            decoder: CommandDecoder::default(),
            motion: ActiveOutputs::UNKNOWN,
            repeat: Repeat::default(),
        }
    }

    /// The client that drives, or may.
    pub fn driver(&self) -> Option<ClientId> {
        self.clients[0].map(|client| client.id)
    }

    /// All clients in order of arrival, the driver first.
    pub fn clients(&self) -> impl Iterator<Item = ClientId> {
        self.clients.iter().flatten().map(|client| client.id)
    }

    /// Whether wheels, brushes or vacuum are on, as far as the bridge knows.
    pub fn is_on(&self) -> bool {
        self.motion.is_on()
    }

    /// Whether a stop is still being repeated.
    pub fn is_stopping(&self) -> bool {
        !self.repeat.is_over()
    }

    /// The serial port is open: the first that the robot gets is a stop, at both rates that robots have by themselves.
    pub fn opened(&mut self, now_ms: u64, ends: &mut impl Ends) {
        self.motion = ActiveOutputs::UNKNOWN;
        self.baud = self.home_baud;
        if self.home_baud != SLOW_BAUD {
            ends.baud(SLOW_BAUD);
            ends.stop(&[0; LONGEST]);
            ends.stop(&STOP);
            ends.baud(self.home_baud);
        }
        // What was interrupted in the middle of a command would take the stop for its data. Zeros do nothing by themselves.
        ends.stop(&[0; MAX_RECEIVED]);
        self.stop(&STOP, now_ms, ends);
    }

    /// The serial port is gone: nobody can drive. All clients are disconnected for the reason `why`.
    pub fn closed(&mut self, why: &str, ends: &mut impl Ends) {
        self.decoder.clear();
        self.repeat = Repeat::default();
        self.is_taken = false;
        for client in core::mem::take(&mut self.clients).into_iter().flatten() {
            ends.close(client.id, why);
        }
    }

    /// A client has connected.
    ///
    /// # Errors
    /// [`Full`] if there are [`MAX_CLIENTS`]; the program should disconnect it with a reason.
    pub fn joined(&mut self, client: ClientId, now_ms: u64, ends: &mut impl Ends) -> Result<(), Full> {
        let place = self.clients.iter().position(Option::is_none).ok_or(Full)?;
        self.clients[place] = Some(Client { id: client, heard_ms: now_ms });
        ends.tell(client, FromBridge::Hello);
        if place == 0 {
            self.hand_over(now_ms, ends);
        } else {
            ends.tell(client, FromBridge::Watch);
        }
        Ok(())
    }

    /// A client's connection has ended.
    pub fn left(&mut self, client: ClientId, now_ms: u64, ends: &mut impl Ends) {
        self.remove(client, Halted::Left, now_ms, ends);
    }

    /// A binary message: bytes for the robot. Only the driver's are passed on, command by command.
    pub fn bytes(&mut self, client: ClientId, bytes: &[u8], now_ms: u64, ends: &mut impl Ends) {
        if !self.heard(client, now_ms) {
            return;
        }
        for &byte in bytes {
            let Some(received) = self.decoder.push(byte) else { continue };
            // Bytes that are no command stay here, since nobody knows what they would do.
            let Ok(command) = received.command else { continue };
            if received.bytes.len() > LONGEST {
                continue;
            }
            let starts = starts(&command);
            if starts && now_ms.saturating_sub(self.alive_ms) >= self.limits.halt_ms {
                return if self.is_on() { self.halt(now_ms, ends) } else { self.next_turn(Halted::Late, now_ms, ends) };
            }
            if !ends.robot(received.bytes) {
                self.stop(&STOP, now_ms, ends);
                return self.next_turn(Halted::Flooded, now_ms, ends);
            }
            self.motion.sent(&command);
            if starts || matches!(command, Command::Control | Command::Safe | Command::Full) {
                // It is in the driver's hands again.
                self.repeat = Repeat::default();
            }
        }
    }

    /// A text message.
    pub fn text(&mut self, client: ClientId, text: &str, now_ms: u64, ends: &mut impl Ends) {
        let drives = self.heard(client, now_ms);
        match text.parse() {
            Ok(ToBridge::Alive(sent_ms)) if drives && self.beat_ms.is_some_and(|last| sent_ms <= last) => {
                self.alive_ms = self.alive_ms.max(sent_ms);
            }
            Ok(ToBridge::Take(turn)) if !drives && self.driver() == Some(client) && turn == self.turn => {
                self.is_taken = true;
                self.alive_ms = self.turn_ms;
            }
            Ok(ToBridge::Stop) if self.clients().any(|known| known == client) => {
                self.stop(&STOP_ALL, now_ms, ends);
                self.next_turn(Halted::Stopped, now_ms, ends);
            }
            Ok(ToBridge::Baud(baud)) if drives && baud != self.baud => {
                // At another rate, no stop would be understood.
                if self.motion.is_on() || self.motion.is_host_driven {
                    self.stop(&STOP, now_ms, ends);
                }
                self.baud = baud;
                ends.baud(baud);
            }
            Ok(ToBridge::Brc { is_low }) if drives => {
                self.is_brc_low = is_low;
                ends.brc(is_low);
            }
            Ok(_) => {}
            Err(_) => ends.tell(client, FromBridge::Unknown),
        }
    }

    /// Lets time pass. To be called every 10 ms or so.
    pub fn tick(&mut self, now_ms: u64, ends: &mut impl Ends) {
        if let Some(bytes) = self.repeat.due(now_ms) {
            ends.stop(bytes);
        }
        self.beat(now_ms, ends);
        self.watch_driver(now_ms, ends);
        for client in self.clients.into_iter().flatten() {
            if now_ms.saturating_sub(client.heard_ms) >= self.limits.idle_ms {
                self.remove(client.id, Halted::Lost, now_ms, ends);
                ends.close(client.id, "this client was silent: it should answer each beat");
            }
        }
    }

    /// The bridge ends: stops the robot and disconnects all clients. Call [`Self::tick`] while it [is
    /// stopping](Self::is_stopping).
    pub fn ended(&mut self, now_ms: u64, ends: &mut impl Ends) {
        if self.driver().is_some() {
            self.stop(&STOP, now_ms, ends);
            self.tell_all(FromBridge::Halted(Halted::Ended), ends);
        }
        let repeat = self.repeat;
        self.closed("the bridge was ended", ends);
        self.repeat = repeat;
    }

    fn beat(&mut self, now_ms: u64, ends: &mut impl Ends) {
        if self.beat_ms.is_none_or(|last| now_ms.saturating_sub(last) >= self.limits.beat_ms) {
            self.beat_ms = Some(now_ms);
            self.tell_all(FromBridge::Beat(now_ms), ends);
        }
    }

    fn watch_driver(&mut self, now_ms: u64, ends: &mut impl Ends) {
        let Some(driver) = self.driver() else { return };
        let age_ms = now_ms.saturating_sub(self.alive_ms);
        if !self.is_on() {
            return;
        }
        if age_ms >= self.limits.lost_ms {
            self.remove(driver, Halted::Lost, now_ms, ends);
            ends.close(driver, "the robot was stopped: this client was silent while it drove");
        } else if age_ms >= self.limits.halt_ms && self.is_taken {
            self.halt(now_ms, ends);
        }
    }

    /// Takes note of a message; whether it is of the driver, who has taken its turn.
    fn heard(&mut self, client: ClientId, now_ms: u64) -> bool {
        if let Some(known) = self.clients.iter_mut().flatten().find(|known| known.id == client) {
            known.heard_ms = known.heard_ms.max(now_ms);
        }
        self.is_taken && self.driver() == Some(client)
    }

    fn remove(&mut self, client: ClientId, why: Halted, now_ms: u64, ends: &mut impl Ends) {
        let Some(place) = self.clients().position(|known| known == client) else { return };
        self.clients[place..].rotate_left(1);
        self.clients[MAX_CLIENTS - 1] = None;
        if place == 0 {
            if self.motion.is_host_driven || self.motion.is_on() {
                self.stop(&STOP, now_ms, ends);
                self.tell_all(FromBridge::Halted(why), ends);
            }
            self.hand_over(now_ms, ends);
        }
    }

    /// The first in order may drive, on a line as it was at the beginning.
    fn hand_over(&mut self, now_ms: u64, ends: &mut impl Ends) {
        if core::mem::take(&mut self.is_brc_low) {
            ends.brc(false);
        }
        if self.baud != self.home_baud {
            self.baud = self.home_baud;
            if self.is_stopping() {
                // It is repeated at the other rate only.
                ends.stop(&STOP);
                ends.baud(self.home_baud);
                self.stop(&STOP, now_ms, ends);
            } else {
                ends.baud(self.home_baud);
            }
        }
        self.begin_turn(now_ms, ends);
    }

    /// Stops the wheels alone; the driver may be back at once.
    fn halt(&mut self, now_ms: u64, ends: &mut impl Ends) {
        ends.stop(&HALT);
        self.repeat = Repeat::of(&HALT, now_ms);
        self.next_turn(Halted::Silent, now_ms, ends);
    }

    /// The robot was stopped, or held back. What its driver sends is dropped until it has heard of that.
    fn next_turn(&mut self, why: Halted, now_ms: u64, ends: &mut impl Ends) {
        self.begin_turn(now_ms, ends);
        self.tell_all(FromBridge::Halted(why), ends);
    }

    fn begin_turn(&mut self, now_ms: u64, ends: &mut impl Ends) {
        self.decoder.clear();
        (self.turn, self.turn_ms, self.is_taken) = (self.turn.wrapping_add(1), now_ms, false);
        if let Some(driver) = self.driver() {
            ends.tell(driver, FromBridge::Drive(self.turn));
        }
    }

    fn stop(&mut self, bytes: &'static [u8], now_ms: u64, ends: &mut impl Ends) {
        self.decoder.clear();
        self.motion = ActiveOutputs::OWN;
        self.repeat = Repeat::of(bytes, now_ms);
        ends.stop(bytes);
    }

    fn tell_all(&self, word: FromBridge, ends: &mut impl Ends) {
        for client in self.clients() {
            ends.tell(client, word);
        }
    }
}

#[cfg(test)]
mod tests;
