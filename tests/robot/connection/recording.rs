//! A session, recorded and played again.

use super::wire::{Wire, hall, setup_in};
use robovac_core::robot::OdometryModel;
use robovac_link::{
    connection::{LineRecording, Replay, Request},
    recording::{EntryKind, Examination, Timeline, TimelineEntry, csv},
};
use robovac_sim::{Conditions, Input};

#[test]
fn a_replay_of_a_line_that_is_never_quiet_connects_as_well() {
    let mut wire = Wire::armed();
    wire.pass(0.5);
    // Something every 5 ms, and answers that come at once.
    let mut lines: Vec<String> = wire.link.recording().lines().skip(1).map(ToOwned::to_owned).collect();
    lines.extend((0..400).map(|i| format!("{:.4} <", 0.005 * f64::from(i))));
    lines.sort_by(|a, b| {
        let time = |line: &str| line.split(' ').next().unwrap().parse::<f64>().unwrap();
        time(a).total_cmp(&time(b))
    });
    let text = format!("robovac-oi-recording 1\n{}", lines.join("\n"));
    let mut replay = Replay::new(LineRecording::parse(&text).unwrap());
    replay.advance(f64::INFINITY);
    assert_eq!((replay.view().phase, replay.view().mode), ("connected", "Safe"));
}

#[test]
fn a_replay_shows_what_the_session_showed() {
    let mut wire = Wire::armed();
    let opened = wire.now;
    wire.ask(Request::Odometry { model: OdometryModel::PacketArc });
    wire.hold_ahead(2.0);
    wire.ask(Request::Digits { text: "HI".into() });
    wire.pass(0.5);
    wire.robot.apply(Input::Lift);
    wire.pass(1.0);
    let (then, drop) = (wire.view(), wire.view().drop.unwrap());
    let text = wire.link.recording();
    assert!(text.starts_with("robovac-oi-recording 1\n0.0000 ! open\n"), "{}", &text[..80]);
    assert!(wire.now > opened);
    let mut replay = Replay::new(LineRecording::parse(&text).unwrap());
    replay.advance(replay.duration_s());
    let now = replay.view();
    assert_eq!((now.phase, now.mode, &now.readings), (then.phase, then.mode, &then.readings));
    assert_eq!(now.drop.as_ref().unwrap().text, drop.text);
    assert_eq!(now.statistics.implausible, then.statistics.implausible);
    let moved = |view: &robovac_link::connection::ConnectionView| view.distance_m;
    assert!((moved(&now) - moved(&then)).abs() < 1e-9, "{} {}", now.distance_m, then.distance_m);
    assert!(moved(&now) > 0.3 && now.odometry == "packet_arc");
    // Back and forth again.
    replay.advance(0.5);
    assert!(replay.view().distance_m < 0.01);
    replay.advance(f64::INFINITY);
    assert_eq!(replay.view().readings, then.readings);
    assert!(!replay.view().can.arm && !replay.view().can.drive);
}

fn examined(text: &str) -> Timeline {
    let mut examination = Examination::new(LineRecording::parse(text).unwrap());
    while examination.go_on(1.0) {}
    examination.timeline()
}

/// The only entry that contains these words.
fn entry<'a>(timeline: &'a Timeline, words: &str) -> &'a TimelineEntry {
    let mut found = timeline.entries.iter().filter(|entry| entry.text.contains(words));
    match (found.next(), found.next()) {
        (Some(entry), None) => entry,
        other => panic!("{words}: {other:?} in {:#?}", timeline.entries),
    }
}

#[test]
fn a_timeline_tells_what_happened_and_what_went_wrong() {
    let mut wire = Wire::connected();
    let began = 100.0;
    wire.pass(1.0);
    let commanded = wire.now;
    wire.arm();
    wire.hold_ahead(1.0);
    wire.pass(3.0);
    let lifted = wire.now;
    wire.robot.apply(Input::Lift);
    wire.pass(2.0);
    let pose = wire.pose();
    wire.robot.apply(Input::PutDown(pose));
    wire.pass(1.0);
    // A flipped bit in each of three frames.
    let garbled = wire.now;
    let mut lumps = 0;
    wire.fault = Some(Box::new(move |mut bytes| {
        if let Some(last) = bytes.last_mut() {
            lumps += 1;
            *last ^= u8::from([1, 11, 21].contains(&lumps));
        }
        bytes
    }));
    wire.pass(1.0);
    wire.fault = None;
    wire.is_plugged = false;
    let silent = wire.now;
    wire.pass(0.6);
    wire.is_plugged = true;
    wire.pass(1.0);
    let timeline = examined(&wire.link.recording());

    let is_at = |entry: &TimelineEntry, time: f64| (entry.time_s + began - time).abs() < 0.1;
    assert_eq!(timeline.entries[0].text, "The line was opened.");
    let safe = entry(&timeline, "The mode changed from Passive to Safe: command Safe.");
    assert!(is_at(safe, commanded) && !safe.is_fault && safe.kind == EntryKind::Mode, "{safe:?}");
    let driven = entry(&timeline, "Driven ");
    assert!((driven.duration_s - 1.2).abs() < 0.3 && !driven.is_fault, "{driven:?}");
    assert!(is_at(driven, commanded + 0.1) || driven.time_s > safe.time_s, "{driven:?}");
    let drop = entry(&timeline, "Both wheels dropped for 2.0 s.");
    assert!(is_at(drop, lifted) && drop.is_fault && (drop.duration_s - 2.0).abs() < 0.1, "{drop:?}");
    let lost = entry(&timeline, "left Safe and stopped: both wheels have dropped");
    assert!(is_at(lost, lifted) && lost.is_fault, "{lost:?}");
    let frames = entry(&timeline, " lost");
    assert!(is_at(frames, garbled) && frames.text.starts_with("3 frames"), "{frames:?}");
    assert_eq!(timeline.lost_frames, 3);
    let gap = entry(&timeline, "No sensor readings for 0.6 s.");
    assert!(is_at(gap, silent) && gap.kind == EntryKind::Frames, "{gap:?}");
    assert!(timeline.entries.is_sorted_by_key(|entry| (1e3 * entry.time_s) as u64));
    assert!((timeline.distance_m - wire.view().distance_m).abs() < 1e-6 && timeline.distance_m > 0.2);
    assert!(timeline.charge_percent.is_some_and(|[first, last]| first >= last && last > 50.0), "{timeline:?}");
    assert!((timeline.duration_s + began - wire.now).abs() < 0.1);
    assert!(timeline.summary().contains(" m driven, 0 bumps, battery "), "{}", timeline.summary());
    entry(&timeline, "No cliff sensor detected floor for 2.0 s.");
}

#[test]
fn a_timeline_of_a_silent_line_says_so() {
    let mut wire = Wire::new(&setup_in(&hall(), Conditions::default(), 1), "asleep");
    wire.is_plugged = false;
    wire.link.opened(wire.now);
    wire.pass(5.0);
    wire.link.lost(wire.now, "The port was unplugged.", true);
    let timeline = examined(&wire.link.recording());
    assert!(entry(&timeline, "The line was lost: The port was unplugged.").is_fault);
    assert!(entry(&timeline, "There are no sensor readings.").is_fault);
    assert_eq!((timeline.readings, timeline.charge_percent), (0, None));
}

#[test]
fn a_table_has_a_row_for_every_reading_and_no_value_twice() {
    let mut wire = Wire::armed();
    // Distance and angle come in a few frames only.
    wire.ask(Request::Odometry { model: OdometryModel::PacketArc });
    wire.hold_ahead(2.0);
    wire.pass(1.0);
    let recording = LineRecording::parse(&wire.link.recording()).unwrap();
    let mut text = String::new();
    csv(recording, |piece| {
        text += piece;
        Ok::<_, ()>(())
    })
    .unwrap();
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let names = lines.next().unwrap();
    let rows: Vec<_> = lines.collect();
    assert!(rows.iter().all(|row| row.len() == names.len()));
    assert_eq!(rows.len() as u64, examined(&wire.link.recording()).readings);
    let column = |name: &str| {
        let at = names.iter().position(|known| *known == name).unwrap_or_else(|| panic!("{name}: {names:?}"));
        rows.iter().map(move |row| row[at])
    };
    let distance: i32 = column("distance (mm)").filter_map(|cell| cell.parse::<i32>().ok()).sum();
    let path: f64 = column("path (m)").next_back().unwrap().parse().unwrap();
    assert!((f64::from(distance) - 1000.0 * path).abs() < 15.0, "{distance} mm, {path} m");
    assert!(column("distance (mm)").any(str::is_empty));
    assert_eq!(column("mode").next_back(), Some("Safe"));
    assert!(column("requested_left_velocity (mm/s)").any(|speed| speed.parse::<i32>().is_ok_and(|speed| speed > 100)));
    assert!(column("wheel_drop_left").all(|cell| cell == "0"));
}
