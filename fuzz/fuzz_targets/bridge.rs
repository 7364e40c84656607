//! The rules of the bridge, by any clients at any times: only whole commands of the driver reach the robot, and what is on is
//! off once its driver has been silent.
#![no_main]

use libfuzzer_sys::fuzz_target;
use roomba_bridge::{Bridge, ClientId, Ends, FromBridge, Limits};
use roomba_oi::CommandDecoder;

#[derive(Default)]
struct Wires {
    decoder: CommandDecoder,
    last: Vec<u8>,
}

impl Ends for Wires {
    fn robot(&mut self, bytes: &[u8]) {
        assert_eq!(self.decoder.waiting(), None, "a command begins within another");
        for &byte in bytes {
            self.decoder.push(byte);
        }
        assert_eq!(self.decoder.waiting(), None, "half a command was sent");
        self.last = bytes.to_vec();
    }
    fn baud(&mut self, baud: u32) {
        assert!(roomba_oi::BAUD_RATES.contains(&baud));
    }
    fn brc(&mut self, _is_low: bool) {}
    fn tell(&mut self, _client: ClientId, word: FromBridge) {
        assert!(word.to_string().is_ascii());
    }
    fn close(&mut self, _client: ClientId, why: &str) {
        assert!(!why.is_empty());
    }
}

fuzz_target!(|data: &[u8]| {
    let (mut bridge, mut wires, mut now_ms) = (Bridge::new(Limits::default()), Wires::default(), 0);
    bridge.opened(&mut wires);
    let mut rest = data;
    while let [what, client, after, length, more @ ..] = rest {
        now_ms += u64::from(*after);
        let (message, left) = more.split_at(usize::from(*length).min(more.len()));
        rest = left;
        let client = ClientId::from(client % 12);
        wires.last.clear();
        match what % 8 {
            0 if !bridge.clients().any(|known| known == client) => {
                let _ = bridge.joined(client, now_ms, &mut wires);
            }
            1 => bridge.left(client, now_ms, &mut wires),
            2..=4 => {
                let drives = bridge.driver() == Some(client);
                bridge.bytes(client, message, now_ms, &mut wires);
                assert!(drives || wires.last.is_empty(), "a watcher reached the robot");
            }
            5 => bridge.text(client, &String::from_utf8_lossy(message), now_ms, &mut wires),
            _ => bridge.tick(now_ms, &mut wires),
        }
    }
    // Whoever drives falls silent now.
    bridge.tick(now_ms + 1000, &mut wires);
    assert!(!bridge.is_on());
});
