//! Whatever a robot is sent: no panic, every byte belongs to a command or is named, and what is taken can be written again.
#![no_main]

use libfuzzer_sys::fuzz_target;
use roomba_oi::{Command, CommandDecoder, MAX_WRITTEN, Opcode};

fuzz_target!(|bytes: &[u8]| {
    let (mut decoder, mut buffer, mut seen) = (CommandDecoder::default(), [0; MAX_WRITTEN], 0);
    for &byte in bytes {
        let Some(received) = decoder.push(byte) else { continue };
        seen += received.bytes.len();
        let Ok(command) = received.command else {
            assert_eq!(Opcode::from_byte(byte), None);
            continue;
        };
        assert_eq!(command.encoded_len(), received.bytes.len());
        assert_eq!(command.clamped().opcode(), command.opcode());
        if let Ok(written) = command.encode(&mut buffer) {
            assert_eq!(Command::parse(written), Ok(command));
        }
    }
    assert_eq!(seen + decoder.waiting().map_or(0, |(_, arrived)| arrived), bytes.len());
});
