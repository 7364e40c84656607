//! Every rule of the bridge, one test each.

use super::*;

/// Keeps what was sent.
#[derive(Default)]
struct Wires {
    robot: Vec<u8>,
    told: Vec<(ClientId, String)>,
    closed: Vec<ClientId>,
    line: Vec<String>,
    is_full: bool,
}

impl Ends for Wires {
    fn robot(&mut self, command: &[u8]) -> bool {
        if !self.is_full {
            self.robot.extend(command);
        }
        !self.is_full
    }
    fn stop(&mut self, bytes: &[u8]) {
        self.robot.extend(bytes);
    }
    fn baud(&mut self, baud: u32) {
        let before = self.sent().len();
        self.line.push(format!("{before} bytes, baud {baud}"));
    }
    fn brc(&mut self, is_low: bool) {
        self.line.push(format!("brc {is_low}"));
    }
    fn tell(&mut self, client: ClientId, word: FromBridge) {
        if !matches!(word, FromBridge::Beat(_)) {
            self.told.push((client, word.to_string()));
        }
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

/// A bridge with its port open, at 0 ms: client 1 drives, client 2 watches.
fn bridge() -> (Bridge, Wires) {
    let (mut bridge, mut wires) = (Bridge::new(Limits::default(), 115_200), Wires::default());
    bridge.opened(0, &mut wires);
    bridge.repeat = Repeat::default();
    wires.sent();
    wires.line.clear();
    for client in [1, 2] {
        bridge.joined(client, 0, &mut wires).unwrap();
    }
    bridge.text(1, "take 1", 0, &mut wires);
    assert_eq!(wires.told(1), ["hello roomba-bridge 2", "drive 1"]);
    assert_eq!(wires.told(2), ["hello roomba-bridge 2", "watch"]);
    (bridge, wires)
}

/// Lets time pass; the clients `alive` answer each beat after `delay_ms`.
fn pass(bridge: &mut Bridge, wires: &mut Wires, times_ms: core::ops::Range<u64>, alive: &[ClientId], delay_ms: u64) {
    for now_ms in times_ms.step_by(10) {
        let answered = now_ms.saturating_sub(delay_ms) / 40 * 40;
        for &client in alive {
            bridge.text(client, &format!("alive {answered}"), now_ms, wires);
        }
        bridge.tick(now_ms, wires);
    }
}

#[test]
fn the_first_bytes_are_a_stop_at_both_rates_of_robots() {
    let (mut bridge, mut wires) = (Bridge::new(Limits::default(), 115_200), Wires::default());
    bridge.opened(0, &mut wires);
    let slow = LONGEST + STOP.len();
    assert_eq!(wires.line, ["0 bytes, baud 19200".to_owned(), format!("{slow} bytes, baud 115200")]);
    let sent = wires.sent();
    assert!(sent.ends_with(&STOP) && sent[..sent.len() - STOP.len()] == [0; MAX_RECEIVED]);
    let mut wires = Wires::default();
    Bridge::new(Limits::default(), SLOW_BAUD).opened(0, &mut wires);
    assert_eq!((wires.line.len(), wires.robot.len()), (0, MAX_RECEIVED + STOP.len()));
}

#[test]
fn stops_are_what_they_are_called() {
    let commands = |bytes: &[u8]| {
        let mut decoder = CommandDecoder::default();
        bytes.iter().filter_map(|&b| Some(format!("{:?}", decoder.push(b)?.command.unwrap()))).collect::<Vec<_>>()
    };
    let still = &*format!("{:?}", Command::DriveDirect { right: 0, left: 0 });
    let off = &*format!("{:?}", Command::Motors(roomba_oi::Motors::default()));
    assert_eq!(commands(&HALT), [still, still]);
    assert_eq!(commands(&STOP), [still, still, off, "Start"]);
    assert_eq!(commands(&STOP_ALL), [still, still, off, "Start", "Safe", still, off, "Start"]);
}

#[test]
fn watchers_never_reach_the_robot() {
    let (mut bridge, mut wires) = bridge();
    for word in ["take 1", "take 2", "baud 19200", "brc low"] {
        bridge.text(2, word, 5, &mut wires);
        bridge.bytes(2, &DRIVE, 5, &mut wires);
    }
    assert!(wires.sent().is_empty() && wires.line.is_empty());
    bridge.text(1, "baud 19200", 5, &mut wires);
    assert_eq!(wires.line, ["0 bytes, baud 19200"]);
}

#[test]
fn whoever_watches_can_stop_the_robot_and_its_driver_must_take_it_again() {
    let (mut bridge, mut wires) = bridge();
    bridge.bytes(1, &DRIVE, 0, &mut wires);
    wires.sent();
    bridge.text(2, "stop", 10, &mut wires);
    assert_eq!(wires.sent(), STOP_ALL);
    assert_eq!(wires.told(1), ["drive 2", "halted stopped"]);
    assert_eq!(wires.told(2), ["halted stopped"]);
    // Still on its way.
    bridge.bytes(1, &DRIVE, 11, &mut wires);
    bridge.text(1, "take 1", 11, &mut wires);
    bridge.bytes(1, &DRIVE, 11, &mut wires);
    assert_eq!(wires.sent(), []);
    bridge.text(1, "take 2", 12, &mut wires);
    bridge.bytes(1, &DRIVE, 12, &mut wires);
    assert_eq!(wires.sent(), DRIVE);
    // A client that was never admitted has no say.
    bridge.text(9, "stop", 13, &mut wires);
    assert_eq!(wires.sent(), []);
}

#[test]
fn what_a_watcher_sent_before_it_knew_that_it_drives_is_dropped() {
    let (mut bridge, mut wires) = bridge();
    bridge.left(1, 10, &mut wires);
    assert_eq!(wires.told(2), ["drive 2"]);
    bridge.bytes(2, &DRIVE, 11, &mut wires);
    bridge.text(2, "baud 19200", 11, &mut wires);
    assert!(wires.sent().is_empty() && wires.line.is_empty());
    bridge.text(2, "take 2", 12, &mut wires);
    bridge.bytes(2, &DRIVE, 12, &mut wires);
    assert_eq!(wires.sent(), DRIVE);
}

#[test]
fn half_a_command_waits_for_its_rest_and_never_swallows_a_stop() {
    let (mut bridge, mut wires) = bridge();
    bridge.bytes(1, &DRIVE, 0, &mut wires);
    wires.sent();
    bridge.bytes(1, &[145, 1], 10, &mut wires);
    assert!(wires.sent().is_empty());
    bridge.tick(200, &mut wires);
    assert_eq!(wires.sent(), HALT);
    bridge.text(1, "take 2", 250, &mut wires);
    bridge.bytes(1, &[145, 1], 250, &mut wires);
    bridge.bytes(1, &[244, 1, 244], 251, &mut wires);
    assert_eq!(wires.sent(), [145, 1, 244, 1, 244], "the half before was forgotten");
}

#[test]
fn half_a_command_of_another_driver_is_forgotten() {
    let (mut bridge, mut wires) = bridge();
    bridge.bytes(1, &[145, 1], 10, &mut wires);
    bridge.left(1, 10, &mut wires);
    wires.sent();
    bridge.text(2, "take 2", 20, &mut wires);
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
    bridge.tick(200, &mut wires);
    assert_eq!(wires.sent(), HALT);
    assert_eq!(wires.told(1), ["drive 2", "halted silent"]);
    pass(&mut bridge, &mut wires, 210..1000, &[], 0);
    assert_eq!(wires.sent(), HALT.repeat(3));
    bridge.bytes(1, &DRIVE, 998, &mut wires);
    assert!(wires.sent().is_empty(), "what was held up on its way is dropped");
    bridge.text(1, "take 2", 999, &mut wires);
    bridge.text(1, "alive 960", 999, &mut wires);
    bridge.bytes(1, &DRIVE, 999, &mut wires);
    assert_eq!(wires.sent(), DRIVE);
    bridge.tick(1159, &mut wires);
    assert_eq!(wires.sent(), []);
    bridge.tick(1160, &mut wires);
    assert_eq!(wires.sent(), HALT, "the age of the beat counts, not when its answer came");
}

#[test]
fn a_steady_delay_of_the_network_is_no_sign_of_life() {
    for (delay_ms, drives) in [(0, true), (60, true), (140, true), (200, false), (300, false), (5000, false)] {
        let (mut bridge, mut wires) = bridge();
        // It took control long ago.
        pass(&mut bridge, &mut wires, 0..6000, &[1, 2], delay_ms);
        bridge.bytes(1, &[131], 6000, &mut wires);
        wires.sent();
        bridge.bytes(1, &DRIVE[1..], 6000, &mut wires);
        assert_eq!(wires.sent() == DRIVE[1..], drives, "{delay_ms} ms");
        assert_eq!(wires.told(1) == ["drive 2", "halted late"], !drives, "{delay_ms} ms");
        bridge.text(1, "take 2", 6000, &mut wires);
        pass(&mut bridge, &mut wires, 6010..8000, &[1, 2], delay_ms);
        assert_eq!(wires.sent(), [], "{delay_ms} ms");
        assert_eq!(bridge.driver(), Some(1), "who can't drive may see its sensors");
    }
    // The delay begins while it drives.
    let (mut bridge, mut wires) = bridge();
    bridge.bytes(1, &DRIVE, 0, &mut wires);
    pass(&mut bridge, &mut wires, 0..1000, &[1, 2], 20);
    assert_eq!(wires.sent(), DRIVE);
    pass(&mut bridge, &mut wires, 1000..1500, &[1, 2], 300);
    assert_eq!(wires.sent(), HALT.repeat(4));
}

#[test]
fn numbers_of_beats_that_were_never_sent_are_no_sign_of_life() {
    let (mut bridge, mut wires) = bridge();
    bridge.text(1, "alive 100000", 0, &mut wires);
    bridge.tick(0, &mut wires);
    bridge.bytes(1, &DRIVE, 0, &mut wires);
    bridge.text(1, "alive 100000", 100, &mut wires);
    wires.sent();
    bridge.tick(200, &mut wires);
    assert_eq!(wires.sent(), HALT);
}

#[test]
fn a_late_command_of_a_robot_that_drives_stops_it() {
    let (mut bridge, mut wires) = bridge();
    bridge.bytes(1, &DRIVE, 0, &mut wires);
    wires.sent();
    // The bridge itself was held up: no time has passed for it.
    bridge.bytes(1, &DRIVE, 300, &mut wires);
    assert_eq!(wires.sent(), [&[131][..], &HALT].concat());
    assert_eq!(wires.told(1), ["drive 2", "halted silent"]);
}

#[test]
fn nothing_starts_late_but_everything_may_stop_late() {
    for (command, starts) in [
        (&[131][..], false),
        (&[145, 0, 0, 0, 0], false),
        (&[138, 0], false),
        (&[148, 1, 7], false),
        (&[145, 0, 1, 0, 0], true),
        (&[137, 255, 0, 0, 0], true),
        (&[146, 0, 0, 0, 1], true),
        (&[138, 1], true),
        (&[144, 0, 0, 1], true),
        (&[135], true),
        (&[136], true),
        (&[134], true),
        (&[143], true),
        (&[165, 1], true),
    ] {
        let (mut bridge, mut wires) = bridge();
        bridge.bytes(1, command, 200, &mut wires);
        assert_eq!(wires.sent() == command, !starts, "{command:?}");
    }
}

#[test]
fn a_driver_that_is_lost_is_stopped_and_the_next_one_drives() {
    let (mut bridge, mut wires) = bridge();
    bridge.bytes(1, &DRIVE, 0, &mut wires);
    bridge.tick(1000, &mut wires);
    assert!(wires.sent().ends_with(&STOP));
    assert_eq!((wires.closed.as_slice(), bridge.driver()), (&[1][..], Some(2)));
    assert_eq!(wires.told(2), ["halted lost", "drive 2"]);
    // What it had still on its way is dropped.
    bridge.text(1, "take 2", 1001, &mut wires);
    bridge.bytes(1, &DRIVE, 1001, &mut wires);
    assert!(wires.sent().is_empty());
    bridge.text(2, "take 2", 1002, &mut wires);
    bridge.bytes(2, &DRIVE, 1002, &mut wires);
    assert_eq!(wires.sent(), DRIVE);
}

#[test]
fn whatever_is_on_needs_the_driver_alive() {
    for command in [&[131, 137, 0, 100, 128, 0][..], &[131, 146, 0, 60, 0, 0], &[131, 138, 4], &[131, 144, 0, 0, 90]] {
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
fn a_stop_is_repeated_until_somebody_drives_again() {
    let (mut bridge, mut wires) = bridge();
    bridge.bytes(1, &DRIVE, 0, &mut wires);
    wires.sent();
    bridge.left(1, 0, &mut wires);
    pass(&mut bridge, &mut wires, 0..3000, &[2], 0);
    assert_eq!(wires.sent(), STOP.repeat(4));
    assert!(!bridge.is_stopping());
    // Questions don't end it, driving does.
    let (mut bridge, mut wires) = self::bridge();
    bridge.bytes(1, &DRIVE, 0, &mut wires);
    bridge.left(1, 0, &mut wires);
    bridge.text(2, "take 2", 0, &mut wires);
    bridge.bytes(2, &[128, 142, 35], 0, &mut wires);
    wires.sent();
    pass(&mut bridge, &mut wires, 0..110, &[2], 0);
    assert_eq!(wires.sent(), STOP);
    bridge.bytes(2, &[131], 110, &mut wires);
    pass(&mut bridge, &mut wires, 110..3000, &[2], 0);
    assert_eq!(wires.sent(), [131]);
}

#[test]
fn a_driver_that_sends_more_than_the_line_carries_is_stopped() {
    let (mut bridge, mut wires) = bridge();
    bridge.bytes(1, &DRIVE, 0, &mut wires);
    wires.sent();
    wires.is_full = true;
    bridge.bytes(1, &DRIVE, 1, &mut wires);
    assert_eq!((wires.sent(), wires.told(1)), (STOP.to_vec(), vec!["drive 2".to_owned(), "halted flooded".to_owned()]));
    wires.is_full = false;
    bridge.bytes(1, &DRIVE, 2, &mut wires);
    assert_eq!(wires.sent(), []);
}

#[test]
fn silent_clients_make_room_after_a_while() {
    let (mut bridge, mut wires) = bridge();
    pass(&mut bridge, &mut wires, 0..5000, &[2], 0);
    assert_eq!(bridge.driver(), Some(1));
    bridge.tick(5000, &mut wires);
    assert_eq!((bridge.driver(), wires.closed.as_slice()), (Some(2), &[1][..]));
    // Also those that watch, and those that never say a word.
    for client in 3..=9 {
        bridge.joined(client, 5000, &mut wires).unwrap();
    }
    assert_eq!(bridge.joined(10, 5000, &mut wires), Err(Full));
    pass(&mut bridge, &mut wires, 5000..10_010, &[2, 4], 0);
    assert_eq!(bridge.clients().collect::<Vec<_>>(), [2, 4]);
    assert_eq!(bridge.joined(10, 10_010, &mut wires), Ok(()));
}

#[test]
fn end_and_loss_of_the_port_leave_nobody_connected() {
    let (mut bridge, mut wires) = bridge();
    bridge.bytes(1, &DRIVE, 0, &mut wires);
    wires.sent();
    bridge.ended(0, &mut wires);
    assert_eq!((wires.sent(), wires.closed.as_slice()), (STOP.to_vec(), &[1, 2][..]));
    pass(&mut bridge, &mut wires, 0..500, &[], 0);
    assert_eq!((wires.sent(), bridge.is_stopping()), (STOP.repeat(3), false));
    let (mut bridge, mut wires) = self::bridge();
    bridge.closed("the cable was pulled", &mut wires);
    assert_eq!((wires.sent(), bridge.clients().count()), (vec![], 0));
    bridge.opened(0, &mut wires);
    assert!(wires.sent().ends_with(&STOP));
}

#[test]
fn what_is_no_command_or_too_long_for_one_stays_here() {
    let (mut bridge, mut wires) = bridge();
    bridge.bytes(1, &[0, 255, 153, 7, 142, 35], 0, &mut wires);
    assert_eq!(wires.sent(), [7, 142, 35]);
    let all: Vec<u8> = [148, 59].into_iter().chain(0..59).collect();
    bridge.bytes(1, &all, 0, &mut wires);
    assert_eq!(wires.sent(), all);
    bridge.bytes(1, &[148, 255].into_iter().chain([7; 255]).chain([142, 35]).collect::<Vec<_>>(), 0, &mut wires);
    assert_eq!(wires.sent(), [142, 35]);
}

#[test]
fn the_robot_is_stopped_before_its_line_changes_its_rate() {
    let (mut bridge, mut wires) = bridge();
    bridge.bytes(1, &DRIVE, 0, &mut wires);
    bridge.text(1, "baud 115200", 10, &mut wires);
    assert_eq!((wires.sent(), wires.line.len()), (DRIVE.to_vec(), 0), "it has this rate");
    bridge.text(1, "baud 19200", 10, &mut wires);
    assert_eq!(wires.line, [format!("{} bytes, baud 19200", STOP.len())]);
}

#[test]
fn a_driver_that_dies_at_another_rate_is_stopped_there_and_the_next_one_finds_the_line_as_at_first() {
    let (mut bridge, mut wires) = bridge();
    bridge.text(1, "baud 19200", 0, &mut wires);
    bridge.text(1, "brc low", 0, &mut wires);
    bridge.bytes(1, &DRIVE, 0, &mut wires);
    wires.sent();
    wires.line.clear();
    bridge.left(1, 10, &mut wires);
    let stops = 2 * STOP.len();
    assert_eq!(wires.line, ["brc false".to_owned(), format!("{stops} bytes, baud 115200")]);
    assert_eq!(wires.sent(), STOP);
    // Nothing was on: then nothing has to be stopped.
    bridge.text(2, "take 2", 10, &mut wires);
    bridge.text(2, "baud 57600", 10, &mut wires);
    bridge.repeat = Repeat::default();
    wires.line.clear();
    bridge.left(2, 20, &mut wires);
    assert_eq!((wires.line, wires.robot), (vec!["0 bytes, baud 115200".to_owned()], vec![]));
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
