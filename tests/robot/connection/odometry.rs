//! Where the robot believes to be over the line, by counts and by the packets of distance and angle, held to the truth.

use super::wire::{Fault, Wire, hall, setup_in};
use robovac_core::{
    geometry::{Point, difference},
    robot::OdometryModel,
};
use robovac_link::connection::Request;
use robovac_sim::{Conditions, Run, controller::FollowPath};
use roomba_oi::{Packet, PacketId, Readings, StreamFrame, write_frame};
use std::{cell::RefCell, rc::Rc, sync::Arc};

/// Corners of a line of 14.5 m.
const EIGHTS: &[(f64, f64)] = &[
    (3.0, 2.5),
    (4.5, 2.5),
    (4.5, 3.5),
    (2.0, 3.5),
    (2.0, 2.5),
    (4.5, 2.5),
    (4.5, 1.5),
    (2.0, 1.5),
    (2.0, 2.5),
    (3.0, 2.5),
];
const AHEAD: &[(f64, f64)] = &[(3.0, 2.5), (5.0, 2.5)];

fn armed(personality: &str, model: OdometryModel) -> Wire {
    let mut wire = Wire::new(&setup_in(&hall(), Conditions::default(), 1), personality);
    wire.ask(Request::Odometry { model });
    wire.connect();
    wire.arm();
    wire
}

/// Lets it drive a line by its counts.
fn ride(wire: &mut Wire, corners: &[(f64, f64)]) {
    let setup = setup_in(&hall(), Conditions::default(), 1);
    let start = setup.floor.start;
    let line: Arc<[Point]> = corners.iter().map(|&(x, y)| Point::new(x, y)).collect();
    let follower = FollowPath::new(&setup.robot, OdometryModel::Arc, start, line);
    wire.link.ride(wire.now, "Line", Box::new(follower), start, false).unwrap();
    wire.pass_until(300.0, |wire| wire.view().ride.unwrap().done);
    wire.pass(1.0);
}

/// How far off the estimate is, m and degrees.
fn off(wire: &mut Wire) -> (f64, f64) {
    let ([x, y, heading], truth) = (wire.view().pose, wire.pose());
    ((Point::new(x, y) - truth.position()).norm(), difference(truth.heading, heading).to_degrees().abs())
}

/// What becomes of every whole frame that the robot sends; other bytes arrive as they are.
fn on_frames(mut change: impl FnMut(&[u8]) -> Vec<u8> + 'static) -> Fault {
    let mut waiting = Vec::new();
    Box::new(move |bytes| {
        waiting.extend(bytes);
        let mut out = Vec::new();
        while let [header, length, ..] = waiting[..] {
            let size = usize::from(length) + 3;
            if header == 19 && waiting.len() < size {
                break;
            }
            let is_frame = StreamFrame::parse(&waiting).is_ok();
            let taken: Vec<u8> = waiting.drain(..if is_frame { size } else { 1 }).collect();
            out.extend(if is_frame { change(&taken) } else { taken });
        }
        out
    })
}

/// The distance in a frame, if any, mm.
fn distance(frame: &[u8]) -> Option<i32> {
    let frame = StreamFrame::parse(frame).unwrap();
    frame.values().find(|&(packet, _)| packet == Packet::Distance).map(|(packet, raw)| packet.value(raw))
}

#[test]
fn a_line_is_driven_by_distance_and_angle_without_turning_to_and_fro() {
    let setup = setup_in(&hall(), Conditions::default(), 1);
    let start = setup.floor.start;
    let line: Arc<[Point]> = [(3.0, 2.5), (4.5, 2.5), (4.5, 3.5), (3.0, 3.5)].map(|(x, y)| Point::new(x, y)).into();
    for model in [OdometryModel::PacketArc, OdometryModel::PacketStraight] {
        let follower = || Box::new(FollowPath::new(&setup.robot, model, start, Arc::clone(&line)));
        let mut run = Run::new(&setup, follower());
        while !run.is_finished() && run.time_s() < 60.0 {
            run.step();
        }
        let mut wire = armed("model", model);
        wire.link.ride(wire.now, "Line", follower(), start, false).unwrap();
        wire.pass_until(60.0, |wire| wire.view().ride.unwrap().done);
        for end in [run.pose(), wire.pose()] {
            // Up to a degree and a millimetre are cut off four times a second.
            assert!((end.position() - Point::new(3.0, 3.5)).norm() < 0.5, "{model:?}: {end}");
        }
    }
}

// slow: drift shows in minutes
#[test]
fn both_odometries_hold_to_the_truth() {
    // Counts wrap in one of them, one talks at 19200 baud; one shows a third of every angle until that has been seen.
    for (personality, most) in [
        ("model", (0.4, 8.0)),
        ("wrap", (0.4, 8.0)),
        ("swapped", (0.4, 8.0)),
        ("slow", (0.4, 8.0)),
        ("angle_bug", (1.2, 15.0)),
    ] {
        for (model, id) in OdometryModel::ALL {
            let mut wire = armed(personality, model);
            if personality == "swapped" {
                wire.ask(Request::UseCalibration { swapped: true, distance_factor: 1.0, base_factor: 1.0 });
            }
            ride(&mut wire, EIGHTS);
            let (metres, degrees) = off(&mut wire);
            // A millimetre and a degree are lost every quarter of a second at most.
            let (least, most) = if model.is_by_packets() { (0.02, most) } else { (0.0, (0.005, 0.2)) };
            let is_sensible = (least..most.0).contains(&metres) && degrees < most.1;
            assert!(is_sensible, "{personality} {id}: {metres} m, {degrees} degrees");
            let has_notice = wire.view().notice.is_some_and(|notice| notice.text.contains("a third of every angle"));
            assert_eq!(has_notice, personality == "angle_bug" && model.is_by_packets());
        }
    }
}

#[test]
fn a_lost_frame_loses_its_distance_and_only_by_packets() {
    for (model, is_lost) in [(OdometryModel::PacketArc, true), (OdometryModel::Arc, false)] {
        let clean = {
            let mut wire = armed("model", model);
            ride(&mut wire, AHEAD);
            wire.view().pose[0] - wire.pose().x
        };
        let mut wire = armed("model", model);
        let lost = Rc::new(RefCell::new(0));
        let shared = Rc::clone(&lost);
        wire.fault = Some(on_frames(move |frame| match distance(frame) {
            // One with a motion at full speed.
            Some(mm) if *shared.borrow() == 0 && (mm > 40 || !is_lost && mm > 2) => {
                *shared.borrow_mut() = mm;
                Vec::new()
            }
            _ => frame.to_vec(),
        }));
        ride(&mut wire, AHEAD);
        let spoilt = wire.view().pose[0] - wire.pose().x;
        let lost = f64::from(*lost.borrow()) / 1000.0;
        assert!(lost > 0.0);
        let expected = if is_lost { lost } else { 0.0 };
        // Frames of another time are cut elsewhere.
        assert!((clean - spoilt - expected).abs() < 0.006, "{clean} {spoilt} {lost}");
    }
}

#[test]
fn no_distance_counts_twice_after_a_false_header_or_a_signal_that_jumps() {
    let ride_with = |fault: Option<Fault>| {
        let mut wire = armed("model", OdometryModel::PacketArc);
        wire.fault = fault;
        ride(&mut wire, AHEAD);
        (wire.view().pose[0] - wire.pose().x, wire.view().statistics)
    };
    let (clean, _) = ride_with(None);
    let (resynced, statistics) = ride_with(Some(on_frames(|frame| match distance(frame) {
        // One in 256 is a frame with a right checksum by chance, which takes the true one's bytes.
        Some(_) => Some([&frame[..3], frame].concat())
            .filter(|bytes| StreamFrame::parse(&bytes[..frame.len()]).is_err())
            .unwrap_or_else(|| frame.to_vec()),
        None => frame.to_vec(),
    })));
    assert!(statistics.bad_checksums > 20 && (resynced - clean).abs() < 0.003, "{resynced} {clean} {statistics:?}");
    // They come a frame later, and are cut elsewhere: by up to a millimetre each, where one alone is 7 cm.
    let (jumped, statistics) = ride_with(Some(on_frames(|frame| {
        if distance(frame).is_none() {
            return frame.to_vec();
        }
        let mut readings = Readings::default();
        StreamFrame::parse(frame).unwrap().apply(&mut readings);
        readings.light_signal[2] = 3000;
        write_frame(&[PacketId::from_byte(100).unwrap()], &readings, &mut [0; 258]).unwrap().to_vec()
    })));
    assert!(statistics.implausible > 20 && (jumped - clean).abs() < 0.03, "{jumped} {clean} {statistics:?}");
}

#[test]
fn odometry_is_chosen_while_nothing_drives_and_survives_a_break() {
    let mut wire = armed("model", OdometryModel::PacketArc);
    wire.hold_ahead(0.2);
    assert!(wire.link.request(wire.now, Request::Odometry { model: OdometryModel::Arc }).is_err());
    wire.ask(Request::Stop);
    wire.pass(0.5);
    wire.is_plugged = false;
    wire.pass(3.0);
    wire.is_plugged = true;
    wire.pass_until(5.0, |wire| wire.view().phase == "connected");
    wire.pass_until(5.0, |wire| wire.view().can.arm || wire.view().can.drive);
    if !wire.view().can.drive {
        wire.arm();
    }
    ride(&mut wire, AHEAD);
    let (metres, _) = off(&mut wire);
    assert!(wire.view().odometry == "packet_arc" && metres < 0.1, "{metres}");
    // Motion between requests isn't taken as a jump.
    wire.ask(Request::Odometry { model: OdometryModel::Straight });
    ride(&mut wire, &[(3.0, 2.5), (3.2, 2.5)]);
    let before = wire.view().pose;
    wire.ask(Request::Odometry { model: OdometryModel::PacketStraight });
    wire.pass(1.0);
    assert_eq!(wire.view().pose, before);
}

/// Its list's length was garbled on the way: the robot takes what follows for packets, the stop, too.
#[test]
fn a_garbled_list_does_not_swallow_the_stop_of_who_leaves() {
    let mut wire = armed("model", OdometryModel::PacketArc);
    wire.hold_ahead(1.0);
    assert!(wire.is_rolling());
    wire.robot.receive(&[148, 255], wire.robot.baud());
    wire.ask(Request::Disconnect);
    wire.flush();
    wire.page_lives = false;
    wire.pass(1.0);
    assert!(!wire.is_rolling(), "{:?}", wire.wheels());
}
