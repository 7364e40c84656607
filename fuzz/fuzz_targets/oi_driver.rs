//! Whatever arrives on the line, in whatever pieces: no panic, and nothing is sent that moves a robot that nobody has
//! taken control of, nor after the stop.
#![no_main]

use libfuzzer_sys::fuzz_target;
use robovac_link::connection::{Connection, Request};
use roomba_oi::{Command, CommandDecoder};

fn moves(bytes: &[u8]) -> bool {
    let mut decoder = CommandDecoder::default();
    bytes.iter().any(|&byte| match decoder.push(byte).map(|received| received.command) {
        Some(Ok(Command::DriveDirect { right, left } | Command::DrivePwm { right, left })) => (right, left) != (0, 0),
        Some(Ok(Command::Drive { velocity, .. })) => velocity != 0,
        Some(Ok(Command::Clean | Command::Spot | Command::Max | Command::SeekDock)) => true,
        _ => false,
    })
}

fuzz_target!(|input: (bool, u8, &[u8])| {
    let (takes_control, cut, bytes) = input;
    let (mut link, mut now) = (Connection::new(), 1.0);
    link.opened(now);
    for (index, piece) in bytes.chunks(usize::from(cut) + 1).enumerate() {
        now += 0.01;
        link.feed(now, piece);
        link.beat(now);
        link.tick(now);
        if takes_control {
            let _ = link.request(now, Request::Arm { full: index % 2 == 0 });
            let _ = link.request(now, Request::Drive { forward: 1.0, left: 0.3 });
        }
        let _ = (link.take_line(), link.view(now), link.take_traffic(), link.take_trace());
        let sent = link.take_tx();
        assert!(takes_control || !moves(&sent), "{sent:?}");
    }
    let _ = link.request(now, Request::Stop);
    for _ in 0..100 {
        now += 0.01;
        link.beat(now);
        link.tick(now);
        let sent = link.take_tx();
        assert!(!moves(&sent), "{sent:?}");
    }
    assert!(link.recording().starts_with("robovac-oi-recording 1\n"));
});
