//! The view model: decoded readings, captions, allowed actions.

use super::wire::{Wire, flat, roomba, setup_in};
use robovac_app::connection::{LiveMapWords, StartPlace};
use robovac_core::{
    geometry::Pose,
    registry::Params,
    robot::{Infrared, SensorReadings},
};
use robovac_link::{
    connection::{
        Calibration, Connection, PressedButton, Request, SETS_OFF, TransportKind, TransportState, TransportView,
    },
    dashboard::{RoombaView, SensorsView},
};
use robovac_sim::{
    Conditions,
    controller::{self, Setup},
};
use roomba_oi::{Packet, Readings};

fn packets(values: &[(Packet, u16)]) -> RoombaView {
    let mut readings = Readings::default();
    for &(packet, raw) in values {
        readings.set_raw(packet, raw);
    }
    RoombaView::new(&readings)
}

#[test]
fn packets_are_decoded() {
    let view = packets(&[
        (Packet::BumpsAndDrops, 0b1110),
        (Packet::CliffFrontRight, 1),
        (Packet::Overcurrents, 0b1_0101),
        (Packet::LightBumper, 0b10_0001),
        (Packet::LightRight, 4095),
        (Packet::Voltage, 15_800),
        (Packet::Current, 65_316),
        (Packet::Temperature, 254),
        (Packet::BatteryCharge, 65_529),
        (Packet::BatteryCapacity, 2696),
        (Packet::ChargingState, 2),
        (Packet::ChargingSources, 2),
        (Packet::Buttons, 0b101),
        (Packet::LeftMotorCurrent, 65_535),
        (Packet::RequestedRightVelocity, 65_436),
        (Packet::SongNumber, 3),
        (Packet::SongPlaying, 1),
        (Packet::RightEncoder, 65_535),
    ]);
    let sensors = &view.sensors;
    assert_eq!((sensors.bumper, sensors.wheel_drops, sensors.is_lifted), ([true, false], [true, true], true));
    assert_eq!((sensors.cliffs, sensors.counts), ([false, false, true, false], [0, 65_535, 0]));
    assert_eq!(sensors.overloads, ["left wheel", "main brush", "side brush"]);
    assert_eq!((sensors.light, sensors.light_signals[5]), ([true, false, false, false, false, true], 4095));
    let battery = &sensors.battery;
    assert_eq!((battery.share, battery.current_ma, battery.is_low, battery.on_dock), (0.0, -220, true, true));
    assert_eq!((view.voltage_v, view.temperature_c, view.charge_mah), (15.8, -2, 0));
    assert_eq!((view.charging.as_str(), &*view.buttons), ("full charging, home base", &["Clean", "Dock"][..]));
    assert_eq!((view.motors_ma[0], view.requested_mm_s, view.song, view.song_plays), (-1, [0, -100], 4, true));
    assert_eq!(packets(&[(Packet::ChargingState, 6), (Packet::ChargingSources, 3)]).charging, "6, both chargers");
}

#[test]
fn infrared_characters_light_their_beams() {
    let seen = |omni| {
        let infrared = Infrared { omni, ..Infrared::default() };
        let [left, top, _] = SensorsView::new(&SensorReadings { infrared, ..SensorReadings::default() }).infrared;
        assert_eq!(left.text, "–");
        (top.lit.join(" "), top.text)
    };
    let is = |lit: &str, text: &str| (lit.to_owned(), text.to_owned());
    assert_eq!(seen(162), is("wall", "virtual wall"));
    assert_eq!((seen(173), seen(254)), (is("green red field", "green + red + field"), seen(173)));
    assert_eq!((seen(164), seen(242)), (is("green", "green"), is("field", "field")));
    assert_eq!(
        (seen(160), seen(240), seen(163), seen(12)),
        (is("", "160"), is("", "240"), is("", "163"), is("", "12"))
    );
    assert_eq!((seen(129), seen(143), seen(144)), (is("", "remote"), is("", "remote"), is("", "144")));
}

#[test]
fn a_connection_says_what_it_is_doing() {
    let closed = Connection::new().view(0.0);
    assert_eq!((closed.doing.title.as_str(), closed.line.title.as_str()), ("No robot", "Not connected"));
    assert!(!closed.is_open && !closed.diagnosis.is_shown && closed.readings.is_none());
    let mut wire = Wire::connected();
    wire.link.set_transport(TransportView { state: TransportState::Open, name: "Cable".into(), ..Default::default() });
    let recorded = wire.view();
    assert!(recorded.is_recording, "an open line of no kind is that of a recording");
    wire.link.set_transport(TransportView::default());
    let view = wire.view();
    assert_eq!((view.doing.title.as_str(), view.line.title.as_str()), ("Watching", "Connected"));
    assert!(view.is_open && view.readings.is_some() && !view.diagnosis.is_shown);
    assert!(view.clock.is_empty() && !view.can.ride);
    wire.arm();
    let view = wire.view();
    assert_eq!(view.doing.note, "Safe: drive, or start an algorithm");
    assert!(view.clock.starts_with("In control for 0:0") && view.can.ride && view.can.steer);
    wire.hold_ahead(0.5);
    let view = wire.view();
    assert_eq!(view.doing.title, "You drive");
    assert!(view.is_moving && !view.moves_alone && view.can.steer && !view.can.ride);
    wire.link.lost(wire.now, "The cable was pulled.", false);
    let view = wire.view();
    assert_eq!((view.doing.title.as_str(), view.diagnosis.picture), ("Connection lost", "unplugged"));
    assert!(view.readings.is_some() && view.diagnosis.is_shown, "what was heard last");
    wire.ask(Request::Disconnect);
    assert!(wire.view().readings.is_none() && !wire.view().is_open);
    let recording = recorded.of_recording("a.txt");
    assert_eq!((recording.line.title.as_str(), recording.doing.title.as_str()), ("Recording a.txt", "Recording"));
    assert!(recording.can.disconnect && !recording.can.arm);
}

#[test]
fn a_robot_that_cleans_by_itself_moves_alone() {
    let mut wire = Wire::armed();
    wire.hold_ahead(1.0);
    wire.ask(Request::Stop);
    for _ in 0..20 {
        wire.pass(0.1);
        assert!(!wire.view().moves_alone, "it rolls out");
    }
    wire.ask(Request::Press { button: PressedButton::Clean });
    wire.pass_until(10.0, |wire| wire.view().moves_alone);
    assert_eq!(wire.view().doing.title, "Moves by itself");
}

#[test]
fn the_trace_says_where_a_program_sets_off() {
    let setup = setup_in(&flat(), Conditions::default(), 1);
    let mut wire = Wire::new(&setup, "model");
    wire.connect();
    wire.arm();
    let set_off = |trace: Vec<f64>| {
        let points: Vec<[f64; 4]> = trace.as_chunks().0.to_vec();
        let found = points.iter().position(|point| point[3] == f64::from(SETS_OFF));
        found.map(|at| (at, points))
    };
    wire.hold_ahead(0.5);
    wire.pass(2.0);
    assert!(set_off(wire.link.take_trace()).is_none(), "by hand it drives on from where it is");
    let (before, start) = (wire.view().pose, setup.floor.start);
    let info = controller::find("bounce").unwrap();
    let params = Params::defaults(info.params);
    let bounce = info.build(&Setup { robot: &roomba(), params: &params, seed: 1 }).unwrap();
    wire.pass(0.1);
    wire.link.ride(wire.now, "Bounce", bounce, start, false).unwrap();
    wire.pass(0.3);
    let (at, points) = set_off(wire.link.take_trace()).unwrap();
    assert_eq!(points[at][..3], [start.x, start.y, start.heading]);
    let far = |point: &[f64; 4], x: f64, y: f64| (point[0] - x).hypot(point[1] - y);
    assert!(at > 0 && points[..at].iter().all(|point| far(point, before[0], before[1]) < 0.05));
    assert!(points.len() > at + 1 && points[at..].iter().all(|point| far(point, start.x, start.y) < 0.2));
    assert_eq!((wire.view().doing.title.as_str(), wire.view().can.steer), ("Bounce", false));
}

#[test]
fn places_are_seen_from_the_start_the_short_way_round() {
    // As near to half a turn as that the other side is near, too.
    let start = Pose::new(1.0, 2.0, 3.1405);
    let place = |x, y, heading| StartPlace::of(Pose::new(x, y, heading), start).id();
    assert_eq!((place(1.0005, 2.0, 3.1405), place(1.0, 2.0, -3.1405)), ("at", "at"));
    // What can hardly be seen bends a measured square.
    assert_eq!((place(1.002, 2.0, 3.1405), place(1.0, 2.0, 3.136)), ("near", "near"));
    assert_eq!((place(1.0, 2.1, 3.1), place(1.0, 2.0, 2.8)), ("near", "near"));
    assert_eq!((place(1.2, 2.0, 3.1), place(1.0, 2.0, 0.0)), ("elsewhere", "elsewhere"));
}

#[test]
fn the_live_map_is_told_in_words() {
    let map = LiveMapWords {
        room: "Flat",
        mode: "Safe",
        driver: "you",
        estimate: Some(Pose::new(1.0, -0.5, std::f64::consts::PI)),
        coverage: Some(0.25),
        swept_m2: 3.0,
        bumps: 2,
        cliffs: 1,
    };
    assert_eq!(
        map.to_string(),
        "Live map of Flat: estimated position 1.00 m, -0.50 m, heading 180 degrees, mode Safe, driven by you. The robot has \
         swept 25 % of the reachable floor; 2 bumps, 1 cliff."
    );
    let blank = LiveMapWords { driver: "", mode: "", coverage: None, ..map };
    assert!(blank.to_string().contains("mode unknown. The robot has swept 3.0 square metres"), "{blank}");
    assert_eq!(LiveMapWords { estimate: None, ..map }.to_string(), "Live map of Flat: no robot");
}

#[test]
fn who_watches_sends_nothing_but_a_stop_and_says_so() {
    let mut wire = Wire::armed();
    wire.hold_ahead(0.4);
    // Another client's robot from here on: it drives ahead, and its stream goes on.
    let (kind, state) = (TransportKind::Socket, TransportState::Open);
    let transport = TransportView { kind, state, is_watching: true, ..Default::default() };
    wire.link = Connection::new();
    wire.link.set_transport(transport.clone());
    wire.commands.clear();
    wire.connect();
    wire.pass(1.0);
    let view = wire.view();
    assert_eq!((view.mode, view.doing.title.as_str(), view.is_moving), ("Safe", "Another client drives", false));
    assert!(view.moves_alone && view.doing.note.contains("Stop") && view.clock.is_empty(), "{view:?}");
    let can = &view.can;
    assert_eq!([can.arm, can.disarm, can.drive, can.steer, can.ride, can.press], [false; 6]);
    for request in [
        Request::Arm { full: false },
        Request::Disarm,
        Request::Drive { forward: 1.0, left: 0.0 },
        Request::Press { button: PressedButton::Clean },
        Request::Raw { bytes: vec![128] },
        Request::Motors { bits: 1 },
        Request::Song { number: 0, notes: vec![[60, 10]] },
        Request::Calibrate { what: Calibration::Metre },
        Request::Identify,
    ] {
        let refused = wire.link.request(wire.now, request).unwrap_err().to_string();
        assert!(refused.starts_with("Another client of the bridge drives"), "{refused}");
    }
    wire.link.leave(wire.now, "The page was hidden.");
    wire.pass(1.0);
    assert_eq!((wire.commands.len(), wire.stops, wire.is_rolling()), (0, 0, true));
    wire.ask(Request::Stop);
    wire.pass(0.1);
    assert_eq!((wire.commands.len(), wire.stops), (0, 1));
    assert!(wire.view().notice.unwrap().text.contains("A stop was sent to the bridge"));
    // The bridge does.
    wire.robot.receive(&[145, 0, 0, 0, 0], 115_200);
    wire.pass(1.0);
    assert_eq!(wire.view().doing.title, "Another client is in control");
    // Now it is its turn.
    wire.link.set_transport(TransportView { is_watching: false, ..transport });
    wire.connect();
    assert!(wire.view().can.arm);
    wire.arm();
    assert_eq!(wire.stops, 1);
}
