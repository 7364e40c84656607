//! Who drives, and the dead man's switch.

use super::{
    motion::{HALT, Motion, STOP},
    words::{FromBridge, Halted, ToBridge},
};
use roomba_oi::{CommandDecoder, MAX_RECEIVED};

/// Clients at once, at most.
pub const MAX_CLIENTS: usize = 8;

/// Names a client while it is connected; chosen by the program.
pub type ClientId = u32;

/// The serial port, and the clients' connections.
pub trait Ends {
    /// Sends bytes to the robot: one or several whole commands.
    fn robot(&mut self, bytes: &[u8]);
    /// Sets the serial port's rate, after all bytes so far have left.
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
    /// Silence of the driver after which the wheels are stopped, while anything of the robot is on.
    pub halt_ms: u64,
    /// Silence after which everything is stopped and the driver is disconnected, while anything is on.
    pub lost_ms: u64,
    /// Silence after which the driver is disconnected while nothing is on, so that others can drive.
    pub idle_ms: u64,
}

impl Default for Limits {
    /// 0.2 s, 1 s, 10 s.
    fn default() -> Self {
        Self { halt_ms: 200, lost_ms: 1000, idle_ms: 10_000 }
    }
}

/// All places are taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Full;

/// The rules of the bridge. Times are ms of any clock that never runs backwards.
#[derive(Debug, Clone)]
pub struct Bridge {
    limits: Limits,
    /// In order of arrival; the first one drives.
    clients: [Option<ClientId>; MAX_CLIENTS],
    decoder: CommandDecoder,
    motion: Motion,
    heard_ms: u64,
    is_halted: bool,
}

impl Bridge {
    /// A bridge without a serial port and without clients.
    pub fn new(limits: Limits) -> Self {
        Self {
            limits,
            clients: [None; MAX_CLIENTS],
            decoder: CommandDecoder::default(),
            motion: Motion::UNKNOWN,
            heard_ms: 0,
            is_halted: false,
        }
    }

    /// The client that drives.
    pub fn driver(&self) -> Option<ClientId> {
        self.clients[0]
    }

    /// All clients in order of arrival, the driver first.
    pub fn clients(&self) -> impl Iterator<Item = ClientId> {
        self.clients.iter().flatten().copied()
    }

    /// Whether wheels, brushes or vacuum are on, as far as the bridge knows.
    pub fn is_on(&self) -> bool {
        self.motion.is_on()
    }

    /// The serial port is open: the first that the robot gets is a stop.
    pub fn opened(&mut self, ends: &mut impl Ends) {
        self.motion = Motion::UNKNOWN;
        // What was interrupted in the middle of a command would take the stop for its data. Zeros do nothing by themselves.
        ends.robot(&[0; MAX_RECEIVED]);
        self.stop(ends);
    }

    /// The serial port is gone: nobody can drive. All clients are disconnected for the reason `why`.
    pub fn closed(&mut self, why: &str, ends: &mut impl Ends) {
        self.decoder.clear();
        for client in core::mem::take(&mut self.clients).into_iter().flatten() {
            ends.close(client, why);
        }
    }

    /// A client has connected.
    ///
    /// # Errors
    /// [`Full`] if there are [`MAX_CLIENTS`]; the program should disconnect it with a reason.
    pub fn joined(&mut self, client: ClientId, now_ms: u64, ends: &mut impl Ends) -> Result<(), Full> {
        let place = self.clients.iter().position(Option::is_none).ok_or(Full)?;
        self.clients[place] = Some(client);
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
            // Bytes that are no command stay here, since nobody knows what they would do.
            if let Some(received) = self.decoder.push(byte)
                && let Ok(command) = received.command
            {
                self.motion.sent(&command);
                ends.robot(received.bytes);
            }
        }
    }

    /// A text message.
    pub fn text(&mut self, client: ClientId, text: &str, now_ms: u64, ends: &mut impl Ends) {
        if !self.heard(client, now_ms) {
            return;
        }
        match text.parse() {
            Ok(ToBridge::Alive) => {}
            Ok(ToBridge::Baud(baud)) => {
                // At another rate, no stop would be understood.
                if self.motion.is_on() || self.motion.is_host_driven {
                    self.stop(ends);
                }
                ends.baud(baud);
            }
            Ok(ToBridge::Brc { is_low }) => ends.brc(is_low),
            Err(_) => ends.tell(client, FromBridge::Unknown),
        }
    }

    /// Lets time pass. To be called every 10 ms or so.
    pub fn tick(&mut self, now_ms: u64, ends: &mut impl Ends) {
        let Some(driver) = self.driver() else { return };
        let silence_ms = now_ms.saturating_sub(self.heard_ms);
        if !self.is_on() {
            if silence_ms >= self.limits.idle_ms {
                self.remove(driver, Halted::Lost, now_ms, ends);
                ends.close(driver, "nothing was heard of this client");
            }
        } else if silence_ms >= self.limits.lost_ms {
            self.remove(driver, Halted::Lost, now_ms, ends);
            ends.close(driver, "the robot was stopped: nothing was heard of this client while it drove");
        } else if silence_ms >= self.limits.halt_ms && !self.is_halted {
            self.is_halted = true;
            ends.robot(&HALT);
            self.tell_all(FromBridge::Halted(Halted::Silent), ends);
        }
    }

    /// The bridge ends: stops the robot and disconnects all clients.
    pub fn ended(&mut self, ends: &mut impl Ends) {
        if self.driver().is_some() {
            self.stop(ends);
            self.tell_all(FromBridge::Halted(Halted::Ended), ends);
        }
        self.closed("the bridge was ended", ends);
    }

    /// Whether it is the driver; takes note of its sign of life.
    fn heard(&mut self, client: ClientId, now_ms: u64) -> bool {
        let drives = self.driver() == Some(client);
        if drives {
            self.heard_ms = self.heard_ms.max(now_ms);
            self.is_halted = false;
        }
        drives
    }

    fn remove(&mut self, client: ClientId, why: Halted, now_ms: u64, ends: &mut impl Ends) {
        let Some(place) = self.clients.iter().position(|&known| known == Some(client)) else { return };
        self.clients[place..].rotate_left(1);
        self.clients[MAX_CLIENTS - 1] = None;
        if place == 0 {
            if self.motion.is_host_driven || self.motion.is_on() {
                self.stop(ends);
                self.tell_all(FromBridge::Halted(why), ends);
            }
            self.hand_over(now_ms, ends);
        }
    }

    /// The first in order drives.
    fn hand_over(&mut self, now_ms: u64, ends: &mut impl Ends) {
        self.decoder.clear();
        self.heard_ms = self.heard_ms.max(now_ms);
        self.is_halted = false;
        if let Some(driver) = self.driver() {
            ends.tell(driver, FromBridge::Drive);
        }
    }

    fn stop(&mut self, ends: &mut impl Ends) {
        self.decoder.clear();
        self.motion = Motion::OWN;
        ends.robot(&STOP);
    }

    fn tell_all(&self, word: FromBridge, ends: &mut impl Ends) {
        for client in self.clients() {
            ends.tell(client, word);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use roomba_oi::Command;

    /// Keeps what was sent.
    #[derive(Default)]
    struct Wires {
        robot: Vec<u8>,
        told: Vec<(ClientId, String)>,
        closed: Vec<ClientId>,
        line: Vec<String>,
    }

    impl Ends for Wires {
        fn robot(&mut self, bytes: &[u8]) {
            self.robot.extend(bytes);
        }
        fn baud(&mut self, baud: u32) {
            self.line.push(format!("baud {baud}"));
        }
        fn brc(&mut self, is_low: bool) {
            self.line.push(format!("brc {is_low}"));
        }
        fn tell(&mut self, client: ClientId, word: FromBridge) {
            self.told.push((client, word.to_string()));
        }
        fn close(&mut self, client: ClientId, _why: &str) {
            self.closed.push(client);
        }
    }

    impl Wires {
        /// What was sent to the robot since the last call.
        fn sent(&mut self) -> Vec<u8> {
            core::mem::take(&mut self.robot)
        }

        fn told(&mut self, client: ClientId) -> Vec<String> {
            let mine = self.told.iter().filter(|(to, _)| *to == client).map(|(_, word)| word.clone()).collect();
            self.told.retain(|(to, _)| *to != client);
            mine
        }
    }

    const DRIVE: [u8; 6] = [131, 145, 0, 100, 0, 100];

    /// A bridge with its port open and clients 1 and 2, at 0 ms.
    fn bridge() -> (Bridge, Wires) {
        let (mut bridge, mut wires) = (Bridge::new(Limits::default()), Wires::default());
        bridge.opened(&mut wires);
        let sent = wires.sent();
        assert!(
            sent.ends_with(&STOP) && sent[..sent.len() - STOP.len()] == [0; MAX_RECEIVED],
            "the first bytes are a stop"
        );
        for client in [1, 2] {
            bridge.joined(client, 0, &mut wires).unwrap();
        }
        assert_eq!(wires.told(1), ["hello roomba-bridge 1", "drive"]);
        assert_eq!(wires.told(2), ["hello roomba-bridge 1", "watch"]);
        (bridge, wires)
    }

    #[test]
    fn stops_are_what_they_are_called() {
        let commands = |bytes: &[u8]| {
            let mut decoder = CommandDecoder::default();
            bytes.iter().filter_map(|&b| Some(format!("{:?}", decoder.push(b)?.command.unwrap()))).collect::<Vec<_>>()
        };
        let still = format!("{:?}", Command::DriveDirect { right: 0, left: 0 });
        assert_eq!(commands(&HALT), [still.clone(), still.clone()]);
        let off = format!("{:?}", Command::Motors(roomba_oi::Motors::default()));
        assert_eq!(commands(&STOP), [still.clone(), still, off, "Start".to_owned()]);
    }

    #[test]
    fn watchers_never_reach_the_robot() {
        let (mut bridge, mut wires) = bridge();
        bridge.bytes(2, &DRIVE, 5, &mut wires);
        bridge.text(2, "baud 19200", 5, &mut wires);
        bridge.text(2, "brc low", 5, &mut wires);
        assert!(wires.sent().is_empty() && wires.line.is_empty());
        bridge.text(1, "baud 19200", 5, &mut wires);
        assert_eq!(wires.line, ["baud 19200"]);
    }

    #[test]
    fn half_a_command_waits_for_its_rest_and_never_swallows_a_stop() {
        let (mut bridge, mut wires) = bridge();
        bridge.bytes(1, &DRIVE, 0, &mut wires);
        wires.sent();
        bridge.bytes(1, &[145, 1], 10, &mut wires);
        assert!(wires.sent().is_empty());
        bridge.tick(210, &mut wires);
        assert_eq!(wires.sent(), HALT);
        bridge.bytes(1, &[244, 1, 244], 250, &mut wires);
        assert_eq!(wires.sent(), [145, 1, 244, 1, 244], "it goes on when its driver is back");
    }

    #[test]
    fn half_a_command_of_another_driver_is_forgotten() {
        let (mut bridge, mut wires) = bridge();
        bridge.bytes(1, &[145, 1], 10, &mut wires);
        bridge.left(1, 10, &mut wires);
        wires.sent();
        bridge.bytes(2, &[128], 20, &mut wires);
        assert_eq!(wires.sent(), [128]);
    }

    #[test]
    fn a_driver_that_is_late_is_halted_and_may_go_on() {
        let (mut bridge, mut wires) = bridge();
        bridge.bytes(1, &DRIVE, 0, &mut wires);
        wires.sent();
        bridge.tick(199, &mut wires);
        assert!(wires.sent().is_empty());
        for now_ms in [200, 300, 999] {
            bridge.tick(now_ms, &mut wires);
        }
        assert_eq!(wires.sent(), HALT, "once");
        assert_eq!(wires.told(2), ["halted silent"]);
        bridge.text(1, "alive", 999, &mut wires);
        bridge.bytes(1, &DRIVE, 999, &mut wires);
        assert_eq!(wires.sent(), DRIVE);
        bridge.tick(1199, &mut wires);
        assert_eq!(wires.sent(), HALT);
    }

    #[test]
    fn a_driver_that_is_lost_is_stopped_and_the_next_one_drives() {
        let (mut bridge, mut wires) = bridge();
        bridge.bytes(1, &DRIVE, 0, &mut wires);
        bridge.tick(1000, &mut wires);
        assert!(wires.sent().ends_with(&STOP));
        assert_eq!((wires.closed.as_slice(), bridge.driver()), (&[1][..], Some(2)));
        assert_eq!(wires.told(2), ["halted lost", "drive"]);
        // What it had still on its way is dropped.
        bridge.bytes(1, &DRIVE, 1001, &mut wires);
        assert!(wires.sent().is_empty());
        bridge.bytes(2, &DRIVE, 1002, &mut wires);
        assert_eq!(wires.sent(), DRIVE);
    }

    #[test]
    fn whatever_is_on_needs_the_driver_alive() {
        for command in
            [&[131, 137, 0, 100, 128, 0][..], &[131, 146, 0, 60, 0, 0], &[131, 138, 4], &[131, 144, 0, 0, 90]]
        {
            let (mut bridge, mut wires) = bridge();
            bridge.bytes(1, command, 0, &mut wires);
            assert!(bridge.is_on(), "{command:?}");
            bridge.tick(200, &mut wires);
            assert!(wires.sent().ends_with(&HALT), "{command:?}");
            bridge.tick(1000, &mut wires);
            assert!(wires.sent().ends_with(&STOP), "{command:?}");
        }
    }

    #[test]
    fn who_leaves_a_robot_in_its_hands_stops_it_but_not_its_own_cleaning() {
        for (commands, stops) in [(&[131][..], true), (&DRIVE, true), (&[128], false), (&[131, 135], false)] {
            let (mut bridge, mut wires) = bridge();
            bridge.bytes(1, commands, 0, &mut wires);
            wires.sent();
            bridge.left(1, 5, &mut wires);
            assert_eq!(wires.sent() == STOP, stops, "{commands:?}");
            assert_eq!(bridge.driver(), Some(2));
        }
    }

    #[test]
    fn an_idle_driver_makes_room_after_a_while() {
        let (mut bridge, mut wires) = bridge();
        bridge.tick(9_999, &mut wires);
        assert_eq!(bridge.driver(), Some(1));
        bridge.tick(10_000, &mut wires);
        assert_eq!((bridge.driver(), wires.closed), (Some(2), vec![1]));
    }

    #[test]
    fn end_and_loss_of_the_port_leave_nobody_connected() {
        let (mut bridge, mut wires) = bridge();
        bridge.bytes(1, &DRIVE, 0, &mut wires);
        wires.sent();
        bridge.ended(&mut wires);
        assert_eq!((wires.sent(), wires.closed.as_slice()), (STOP.to_vec(), &[1, 2][..]));
        let (mut bridge, mut wires) = self::bridge();
        bridge.closed("the cable was pulled", &mut wires);
        assert_eq!((wires.sent(), bridge.clients().count()), (vec![], 0));
        bridge.opened(&mut wires);
        assert!(wires.sent().ends_with(&STOP));
    }

    #[test]
    fn what_is_no_command_stays_here() {
        let (mut bridge, mut wires) = bridge();
        bridge.bytes(1, &[0, 255, 153, 7, 142, 35], 0, &mut wires);
        assert_eq!(wires.sent(), [7, 142, 35]);
    }

    #[test]
    fn the_robot_is_stopped_before_its_line_changes_its_rate() {
        let (mut bridge, mut wires) = bridge();
        bridge.bytes(1, &DRIVE, 0, &mut wires);
        bridge.text(1, "baud 19200", 10, &mut wires);
        assert!(wires.sent().ends_with(&STOP));
        assert_eq!(wires.line, ["baud 19200"]);
    }

    #[test]
    fn the_ninth_client_is_refused() {
        let (mut bridge, mut wires) = bridge();
        for client in 3..=8 {
            assert_eq!(bridge.joined(client, 0, &mut wires), Ok(()));
        }
        assert_eq!(bridge.joined(9, 0, &mut wires), Err(Full));
        bridge.left(5, 0, &mut wires);
        assert_eq!(bridge.joined(9, 0, &mut wires), Ok(()));
        assert_eq!(bridge.clients().collect::<Vec<_>>(), [1, 2, 3, 4, 6, 7, 8, 9]);
    }
}
