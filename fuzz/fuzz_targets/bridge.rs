//! The rules of the bridge, by any clients at any times: what they let through is decoded here once more, by a robot that knows
//! nothing of the bridge, and who may move it is kept account of by what the clients were told.
#![no_main]

use libfuzzer_sys::fuzz_target;
use roomba_bridge::{Bridge, ClientId, Ends, FromBridge, Limits};

/// A robot, as far as a bridge can make it move. Written from the Open Interface's specification, without `roomba-oi`.
#[derive(Default)]
struct Robot {
    /// A command that isn't whole yet.
    half: Vec<u8>,
    is_obeying: bool,
    wheels: bool,
    brushes: bool,
    own_program: bool,
}

impl Robot {
    fn hear(&mut self, byte: u8) {
        self.half.push(byte);
        let length = match self.half[0] {
            7 | 128 | 130..=136 | 143 | 173 => 1,
            129 | 138 | 141 | 142 | 150 | 165 => 2,
            162 => 3,
            139 | 144 | 168 => 4,
            137 | 145 | 146 | 163 | 164 => 5,
            167 => 16,
            148 | 149 => self.half.get(1).map_or(usize::MAX, |&count| 2 + usize::from(count)),
            140 => self.half.get(2).map_or(usize::MAX, |&count| 3 + 2 * usize::from(count)),
            // No command.
            _ => return self.half.clear(),
        };
        if self.half.len() == length {
            let command = std::mem::take(&mut self.half);
            self.obey(&command);
        }
    }

    fn obey(&mut self, command: &[u8]) {
        let [opcode, data @ ..] = command else { return };
        match opcode {
            130..=132 => (self.is_obeying, self.own_program) = (true, false),
            7 | 128 | 133 | 173 => *self = Self::default(),
            134..=136 | 143 => *self = Self { own_program: true, ..Self::default() },
            165 => self.own_program |= data[0] != 0,
            137 if self.is_obeying => self.wheels = data[..2] != [0, 0],
            145 | 146 if self.is_obeying => self.wheels = *data != [0; 4],
            // Its bits 5 to 7 are reserved.
            138 if self.is_obeying => self.brushes = data[0] & 31 != 0,
            144 if self.is_obeying => self.brushes = *data != [0; 3],
            _ => {}
        }
    }

    /// Whether the command would move anything in a robot that obeys.
    fn is_moved_by(command: &[u8]) -> bool {
        let mut robot = Self { is_obeying: true, ..Self::default() };
        command.iter().for_each(|&byte| robot.hear(byte));
        robot.wheels || robot.brushes || robot.own_program
    }
}

#[derive(Default)]
struct Wires {
    robot: Robot,
    now_ms: u64,
    /// Who was told last to drive, when, by which number, and whether it has answered.
    turn: Option<(ClientId, u32)>,
    turn_ms: u64,
    is_taken: bool,
    /// When the newest message was sent that the driver has answered.
    alive_ms: u64,
    beats: Vec<u64>,
    /// Whether the queue for the robot is full.
    is_full: bool,
    /// Whether anything was sent since this was cleared.
    has_sent: bool,
}

impl Wires {
    fn is_fresh(&self, most_ms: u64) -> bool {
        self.is_taken && self.now_ms - self.alive_ms < most_ms
    }

    fn send(&mut self, bytes: &[u8]) {
        assert!(self.robot.half.is_empty(), "a command begins within another");
        bytes.iter().for_each(|&byte| self.robot.hear(byte));
        assert!(self.robot.half.is_empty(), "half a command was sent");
        self.has_sent = true;
    }
}

impl Ends for Wires {
    fn robot(&mut self, command: &[u8]) -> bool {
        if self.is_full {
            return false;
        }
        assert!(self.is_taken, "bytes of a client that hasn't taken its turn");
        assert!(!Robot::is_moved_by(command) || self.is_fresh(200), "a late command moves the robot");
        self.send(command);
        true
    }
    fn stop(&mut self, bytes: &[u8]) {
        assert!(!Robot::is_moved_by(bytes));
        self.send(bytes);
    }
    fn baud(&mut self, baud: u32) {
        assert!([300, 600, 1200, 2400, 4800, 9600, 14_400, 19_200, 28_800, 38_400, 57_600, 115_200].contains(&baud));
        assert!(!self.robot.wheels && !self.robot.brushes, "it is out of reach at another rate");
    }
    fn brc(&mut self, _is_low: bool) {}
    fn tell(&mut self, client: ClientId, word: FromBridge) {
        assert!(word.to_string().is_ascii());
        match word {
            FromBridge::Drive(number) => (self.turn, self.turn_ms, self.is_taken) = (Some((client, number)), self.now_ms, false),
            FromBridge::Beat(number) => self.beats.push(number),
            _ => {}
        }
    }
    fn close(&mut self, client: ClientId, why: &str) {
        assert!(!why.is_empty());
        if self.turn.is_some_and(|(driver, _)| driver == client) {
            (self.turn, self.is_taken) = (None, false);
        }
    }
}

/// A text message, of which account is kept first.
fn say(text: &str, client: ClientId, bridge: &mut Bridge, wires: &mut Wires) {
    if let Some((driver, turn)) = wires.turn
        && driver == client
    {
        let number = |word: &str| text.strip_prefix(word).and_then(|number| number.parse::<u64>().ok());
        if wires.is_taken {
            let sent_ms = number("alive ").filter(|number| wires.beats.last().is_some_and(|last| number <= last));
            wires.alive_ms = wires.alive_ms.max(sent_ms.unwrap_or(0));
        } else if number("take ") == Some(u64::from(turn)) {
            (wires.is_taken, wires.alive_ms) = (true, wires.turn_ms);
        }
    }
    bridge.text(client, text, wires.now_ms, wires);
}

fuzz_target!(|data: &[u8]| {
    let (mut bridge, mut wires) = (Bridge::new(Limits::default(), 115_200), Wires::default());
    bridge.opened(0, &mut wires);
    let mut rest = data;
    while let [what, client, after, length, more @ ..] = rest {
        wires.now_ms += u64::from(*after);
        let now_ms = wires.now_ms;
        let (message, left) = more.split_at(usize::from(*length).min(more.len()));
        rest = left;
        let client = ClientId::from(client % 12);
        let drives = wires.is_taken && wires.turn.is_some_and(|(driver, _)| driver == client);
        let is_known = bridge.clients().any(|known| known == client);
        wires.has_sent = false;
        match what % 12 {
            0 if !is_known => drop(bridge.joined(client, now_ms, &mut wires)),
            1 => {
                let is_driver = bridge.driver() == Some(client);
                bridge.left(client, now_ms, &mut wires);
                assert!(!is_driver || !wires.robot.wheels && !wires.robot.brushes, "its driver has left");
            }
            2..=4 => {
                bridge.bytes(client, message, now_ms, &mut wires);
                assert!(drives || !wires.has_sent, "a client that doesn't drive reached the robot");
            }
            5 => {
                // A beat, the newest or an older one; or one that was never sent.
                let age = usize::from(*length % 8);
                let number = wires.beats.iter().rev().nth(age).copied().unwrap_or(u64::from(*after) << 20);
                say(&format!("alive {number}"), client, &mut bridge, &mut wires);
            }
            6 => {
                // Its turn, or an older one.
                let Some((_, number)) = wires.turn else { continue };
                let number = number.wrapping_sub(u32::from(*length % 2));
                say(&format!("take {number}"), client, &mut bridge, &mut wires);
                assert!(!wires.has_sent);
            }
            7 => {
                say("stop", client, &mut bridge, &mut wires);
                let robot = &wires.robot;
                assert!(!is_known || !robot.wheels && !robot.brushes && !robot.own_program, "told to stop");
                assert!(!is_known || !wires.is_taken, "who drove hasn't heard of the stop");
            }
            8 => say(if *length % 2 == 0 { "baud 19200" } else { "brc low" }, client, &mut bridge, &mut wires),
            9 => say(&String::from_utf8_lossy(message), client, &mut bridge, &mut wires),
            10 => wires.is_full = !wires.is_full,
            _ => {
                bridge.tick(now_ms, &mut wires);
                // A driver that was halted may be back before it counts as lost.
                assert!(!wires.robot.wheels || wires.is_fresh(200), "the wheels go on without a driver");
                let is_lost = now_ms - wires.alive_ms >= 1000;
                assert!(!wires.robot.brushes || !is_lost, "the brushes go on without a driver");
            }
        }
    }
    // Whoever drives falls silent now.
    wires.now_ms += 1000;
    bridge.tick(wires.now_ms, &mut wires);
    assert!(!wires.robot.wheels && !wires.robot.brushes && !bridge.is_on());
});
