//! Every packet against the simulated robot, and the stream.

use super::support::{BAUD, Lab};
use robovac_link::sensors::to_readings;
use roomba_oi::{Command, GROUPS, Mode, Packet, PacketId, Readings, StreamFrame, slot_bytes, write_frame};

#[test]
fn all_packets_are_those_of_the_simulated_robot() {
    let mut lab = Lab::in_mode(Mode::Full);
    lab.command(Command::DriveDirect { right: 250, left: 300 });
    lab.wait(4.0);
    let all = lab.readings();
    let sensed = lab.robot.sensors();
    let counts = |a: u16, b: u16| a.wrapping_sub(b).cast_signed().abs() < 30;
    assert!(counts(all.left_counts, sensed.left_counts) && counts(all.right_counts, sensed.right_counts));
    let of_sensors = to_readings(sensed);
    let same = [
        Packet::BumpsAndDrops,
        Packet::CliffLeft,
        Packet::CliffFrontLeft,
        Packet::CliffFrontRight,
        Packet::CliffRight,
        Packet::VirtualWall,
        Packet::Overcurrents,
        Packet::DirtDetect,
        Packet::InfraredOmni,
        Packet::Voltage,
        Packet::Temperature,
        Packet::BatteryCharge,
        Packet::BatteryCapacity,
        Packet::CliffLeftSignal,
        Packet::CliffFrontLeftSignal,
        Packet::CliffFrontRightSignal,
        Packet::CliffRightSignal,
        Packet::ChargingSources,
        Packet::InfraredLeft,
        Packet::InfraredRight,
        Packet::Stasis,
    ];
    for packet in same {
        assert_eq!(all.raw(packet), of_sensors.raw(packet), "{packet}");
    }
    assert_eq!((all.requested_right, all.requested_left, all.mode, all.stasis.toggling), (250, 300, 3, true));
    assert!(Packet::ALL.iter().all(|&packet| packet.is_plausible(all.raw(packet))));
    assert!((2500..=2680).contains(&all.cliff_signal[0]) && (2..=32).contains(&all.light_signal[2]));
    assert!(all.left_motor_ma > 60 && all.voltage_mv > 13_000 && all.capacity_mah == 2696);
}

#[test]
fn every_packet_and_group_has_its_bytes() {
    let mut lab = Lab::in_mode(Mode::Passive);
    lab.wait(1.0);
    let singles: Vec<(u8, Vec<u8>)> = (0..=255).map(|id| (id, lab.ask(id))).collect();
    for (id, bytes) in &singles {
        assert_eq!(bytes.len(), PacketId::size_of(*id).unwrap_or(0), "{id}");
    }
    let of = |id: u8| singles[usize::from(id)].1.clone();
    for (id, first, last) in GROUPS {
        let parts: Vec<u8> = (first as u8..=last as u8).flat_map(of).collect();
        // At rest nothing changes from one to the next but the current.
        assert_eq!(of(id), parts, "group {id}");
    }
    assert_eq!(of(35), [1]);
    let current = i16::from_be_bytes([of(23)[0], of(23)[1]]);
    assert!((-151..=-111).contains(&current), "{current} mA at rest");
}

#[test]
fn distance_and_angle_begin_anew_when_they_are_read_and_lose_the_rest() {
    let mut lab = Lab::in_mode(Mode::Full);
    lab.value(19);
    lab.command(Command::DriveDirect { right: 200, left: 200 });
    lab.wait(5.0);
    lab.command(Command::DriveDirect { right: 0, left: 0 });
    lab.wait(1.0);
    let driven = lab.ahead();
    let (distance, again) = (lab.value(19), lab.value(19));
    assert!((f64::from(distance) - 1000.0 * driven).abs() < 1.5, "{distance} {driven}");
    assert_eq!(again, 0);
    lab.command(Command::DriveDirect { right: 100, left: -100 });
    lab.wait(1.0);
    lab.command(Command::DriveDirect { right: 0, left: 0 });
    lab.wait(1.0);
    // Both are in group 2, and 19 alone leaves 20 alone.
    lab.value(19);
    let (angle, turned) = (lab.ask(2), lab.robot.pose().heading.to_degrees());
    let angle = i16::from_be_bytes([angle[4], angle[5]]);
    assert!((f64::from(angle) - turned).abs() <= 1.0, "{angle} {turned}");
    assert_eq!(lab.value(20), 0);
    // Below 67 degrees a second, a stream of every 15 ms never sees a turn.
    lab.command(Command::DriveDirect { right: 60, left: -60 });
    lab.send(&[148, 1, 20]);
    lab.wait(0.5);
    lab.take();
    lab.wait(2.0);
    let sum: i32 = frames(&lab.take()).iter().flatten().map(|&(packet, raw)| packet.value(raw)).sum();
    assert_eq!(sum, 0);
    lab.command(Command::DriveDirect { right: 150, left: -150 });
    lab.wait(0.5);
    lab.take();
    lab.wait(2.0);
    let sum: i32 = frames(&lab.take()).iter().flatten().map(|&(packet, raw)| packet.value(raw)).sum();
    assert!(sum > 100, "{sum}");
}

#[test]
fn a_packet_that_is_asked_twice_at_once_has_distance_once() {
    let mut lab = Lab::in_mode(Mode::Full);
    lab.value(19);
    lab.command(Command::DriveDirect { right: 300, left: 300 });
    lab.wait(1.0);
    lab.take();
    lab.send(&[149, 2, 19, 19]);
    lab.wait(0.02);
    let answer = lab.take();
    assert!(answer[..2] != [0, 0] && answer[2..] == [0, 0], "{answer:?}");
}

/// The values of all frames in a stream without errors.
fn frames(mut bytes: &[u8]) -> Vec<Vec<(Packet, u16)>> {
    let mut frames = Vec::new();
    while let Ok(frame) = StreamFrame::parse(bytes) {
        frames.push(frame.values().collect());
        bytes = &bytes[frame.size()..];
    }
    assert!(bytes.len() < 258, "{bytes:?}");
    frames
}

#[test]
fn the_stream_comes_every_15_ms_to_the_byte() {
    let mut lab = Lab::in_mode(Mode::Passive);
    lab.send(&[148, 2, 29, 13]);
    // From one refresh to the next, in steps of a tenth of a millisecond.
    let mut arrivals = Vec::new();
    for step in 0..2000 {
        lab.wait(1e-4);
        if lab.heard.len() >= 8 {
            arrivals.push(step);
            let frame = lab.take();
            let signal = lab.robot.sensors().cliff_signal[1];
            let readings = Readings { cliff_signal: [0, signal, 0, 0], ..Readings::default() };
            let ids = [Packet::CliffFrontLeftSignal.into(), Packet::VirtualWall.into()];
            assert_eq!(Ok(&frame[..]), write_frame(&ids, &readings, &mut [0; 8]));
        }
    }
    assert_eq!(arrivals.len(), 13);
    assert!(arrivals.windows(2).all(|pair| (149..=151).contains(&(pair[1] - pair[0]))), "{arrivals:?}");
    assert_eq!(lab.value_in_stream(), 2);
}

impl Lab {
    /// Packet 38, queried during a stream.
    fn value_in_stream(&mut self) -> u8 {
        self.send(&[150, 0]);
        self.wait(0.1);
        self.ask(38)[0]
    }
}

#[test]
fn pause_keeps_the_list_and_an_empty_list_ends_the_stream() {
    let mut lab = Lab::in_mode(Mode::Passive);
    lab.send(&[148, 1, 35]);
    lab.wait(0.1);
    assert_eq!(lab.take()[..5], [19, 2, 35, 1, 199]);
    lab.send(&[150, 0]);
    lab.wait(0.1);
    lab.take();
    lab.wait(1.0);
    assert_eq!(lab.take(), [0_u8; 0]);
    assert_eq!(lab.ask(38), [1]);
    lab.send(&[150, 1]);
    lab.wait(0.1);
    assert_eq!(frames(&lab.take())[0], [(Packet::OiMode, 1)]);
    lab.send(&[148, 0]);
    lab.wait(0.1);
    lab.take();
    lab.wait(1.0);
    assert_eq!((lab.take(), lab.ask(38)), (vec![], vec![0]));
}

#[test]
fn a_stream_that_fills_its_slot_is_whole_and_one_that_overruns_it_is_corrupted_after_a_while() {
    // Group 100 and packets of two bytes: 3 + 81 + 29 * 3 = 171 of 172 bytes.
    let fits: Vec<u8> = std::iter::once(100).chain([22; 29]).collect();
    let mut lab = Lab::in_mode(Mode::Passive);
    lab.send(&[&[148, fits.len() as u8], &fits[..]].concat());
    lab.wait(5.0);
    assert_eq!(frames(&lab.take()).len(), 332);
    let too_long: Vec<u8> = fits.iter().copied().chain([22; 5]).collect();
    lab.send(&[148, 0]);
    lab.wait(0.1);
    lab.take();
    lab.send(&[&[148, too_long.len() as u8], &too_long[..]].concat());
    lab.wait(0.5);
    let early = lab.take();
    assert!(StreamFrame::parse(&early).is_ok_and(|frame| frame.size() > slot_bytes(BAUD)), "the first ones are whole");
    lab.wait(5.0);
    lab.take();
    lab.wait(1.0);
    let late = lab.take();
    let whole = (0..late.len()).filter(|&at| StreamFrame::parse(&late[at..]).is_ok_and(|f| f.size() == 186)).count();
    assert!(whole < 60, "{whole} of 66 frames are whole");
}

#[test]
fn answers_come_within_the_refresh_and_at_the_pace_of_the_line() {
    let mut lab = Lab::in_mode(Mode::Passive);
    for offset in 0..30 {
        lab.wait(0.0007 * f64::from(offset));
        lab.take();
        lab.robot.receive(&[142, 100], BAUD);
        let mut waited = 0.0;
        while lab.heard.is_empty() {
            lab.wait(1e-4);
            waited += 1e-4;
        }
        assert!(waited <= 0.0155, "{waited} s");
        let begin = waited;
        while lab.heard.len() < 80 {
            lab.wait(1e-4);
            waited += 1e-4;
        }
        let pace = (waited - begin) / 79.0;
        assert!((pace * f64::from(BAUD) / 10.0 - 1.0).abs() < 0.03, "{pace} s a byte");
    }
}
