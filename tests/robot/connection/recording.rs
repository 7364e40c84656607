//! A session, recorded and played again.

use super::wire::Wire;
use robovac_core::robot::OdometryModel;
use robovac_link::connection::{LineRecording, Replay, Request};
use robovac_sim::Input;

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
