//! All vectors in the codec.

use super::stream::hear;
use crate::vectors::{bytes, mode, sheets, vectors};
use roomba_oi::{
    BAUD_RATES, Command, CommandDecoder, GROUPS, Hazard, MAX_WRITTEN, Mode, Opcode, Packet, PacketId, Readings,
    motion::{self, WheelSpeeds},
};
use serde_json::{Value, json};
use std::collections::HashSet;

fn opcode(number: &Value) -> Opcode {
    Opcode::from_byte(number.as_u64().unwrap() as u8).unwrap()
}

/// The fields of a command, in the words of the vectors.
fn arguments(command: Command<'_>) -> Value {
    match command {
        Command::Baud { code } => json!({"code": code, "bps": BAUD_RATES[usize::from(code)]}),
        Command::Drive { velocity, radius } => json!({"velocity": velocity, "radius": radius}),
        Command::DriveDirect { right, left } | Command::DrivePwm { right, left } => {
            json!({"right": right, "left": left})
        }
        Command::Motors(m) => json!({
            "side": m.side_brush, "vacuum": m.vacuum, "main": m.main_brush,
            "side_cw": m.side_brush_clockwise, "main_outward": m.main_brush_outward,
        }),
        Command::PwmMotors { main_brush, side_brush, vacuum } => {
            json!({"main": main_brush, "side": side_brush, "vacuum": vacuum})
        }
        Command::Leds { lamps, colour, intensity } => json!({
            "debris": lamps.debris, "spot": lamps.spot, "dock": lamps.dock, "check": lamps.check_robot,
            "color": colour, "intensity": intensity,
        }),
        Command::SchedulingLeds { weekdays, lamps } => json!({"weekdays": weekdays.byte(), "scheduling": lamps.byte()}),
        Command::DigitsRaw { segments: [d3, d2, d1, d0] } => json!({"d3": d3, "d2": d2, "d1": d1, "d0": d0}),
        Command::DigitsAscii { text } => json!({"text": String::from_utf8_lossy(&text)}),
        Command::Buttons(buttons) => json!({"mask": buttons.byte()}),
        Command::Schedule { days, times } => {
            let names = ["sun", "mon", "tue", "wed", "thu", "fri", "sat"];
            let set = (0..7).filter(|day| days.byte() & (1 << day) != 0);
            set.map(|day| (names[day].to_string(), json!(times[day]))).collect::<serde_json::Map<_, _>>().into()
        }
        Command::DayTime { day, time } => json!({"day": day, "hour": time[0], "minute": time[1]}),
        Command::Song { number, notes } => json!({"number": number, "notes": notes}),
        Command::Play { number } => json!({"number": number}),
        Command::SensorReadings { packet } => json!({"packet": packet}),
        Command::Stream { packets } | Command::QueryList { packets } => json!({"packets": packets}),
        Command::PauseResume { state } => json!({"state": state}),
        _ => json!({}),
    }
}

/// The fields of a packet, in the words of the vectors: named bits, or the value.
fn decoded(packet: Packet, readings: &Readings) -> Value {
    let (b, o, l) = (readings.bumps, readings.overcurrents, readings.light_bumper);
    let (u, c, s) = (readings.buttons, readings.chargers, readings.stasis);
    let bits: &[(&str, bool)] = match packet {
        Packet::BumpsAndDrops => &[
            ("bump_right", b.bump_right),
            ("bump_left", b.bump_left),
            ("drop_right", b.drop_right),
            ("drop_left", b.drop_left),
        ],
        Packet::Overcurrents => &[
            ("side_brush", o.side_brush),
            ("main_brush", o.main_brush),
            ("right_wheel", o.right_wheel),
            ("left_wheel", o.left_wheel),
        ],
        Packet::Buttons => &[
            ("clean", u.clean),
            ("spot", u.spot),
            ("dock", u.dock),
            ("minute", u.minute),
            ("hour", u.hour),
            ("day", u.day),
            ("schedule", u.schedule),
            ("clock", u.clock),
        ],
        Packet::ChargingSources => &[("internal", c.internal_charger), ("home_base", c.home_base)],
        Packet::LightBumper => &[
            ("left", l.left),
            ("front_left", l.front_left),
            ("center_left", l.centre_left),
            ("center_right", l.centre_right),
            ("front_right", l.front_right),
            ("right", l.right),
        ],
        Packet::Stasis => &[("toggling", s.toggling), ("disabled", s.disabled)],
        _ => return json!({"value": packet.value(readings.raw(packet))}),
    };
    bits.iter().map(|&(name, set)| (name.to_string(), json!(u8::from(set)))).collect::<serde_json::Map<_, _>>().into()
}

#[test]
fn commands() {
    let all = vectors("/commands", Opcode::ALL.len());
    let seen: HashSet<u64> = all.iter().filter_map(|vector| vector["opcode"].as_u64()).collect();
    assert!(Opcode::ALL.iter().all(|&opcode| seen.contains(&(opcode as u64))), "{seen:?}");
    for vector in all {
        let (id, bytes) = (&vector["id"], bytes(&vector));
        let mut decoder = CommandDecoder::default();
        let (last, before) = bytes.split_last().unwrap();
        assert!(before.iter().all(|&byte| decoder.push(byte).is_none()), "{id}");
        let command = decoder.push(*last).unwrap().command.unwrap();
        assert_eq!(command.opcode(), opcode(&vector["opcode"]), "{id}");
        assert_eq!(arguments(command), vector["args"], "{id}");
        assert_eq!(command.encode(&mut [0; MAX_WRITTEN]), Ok(&bytes[..]), "{id}");
        let accepted: Vec<Mode> = vector["accepted_in"].as_array().unwrap().iter().map(mode).collect();
        for from in Mode::ALL {
            let after = accepted.contains(&from).then(|| match &vector["mode_after"] {
                same if same == "same" => from,
                other => mode(other),
            });
            assert_eq!(from.after_command(command.opcode()), after, "{id} in {from}");
        }
    }
}

#[test]
fn packets() {
    let all = vectors("/packets", Packet::ALL.len() + GROUPS.len());
    let seen: HashSet<u64> = all.iter().filter_map(|vector| vector["packet"].as_u64()).collect();
    assert!((0..=255).all(|id| PacketId::from_byte(id).is_some() == seen.contains(&id.into())), "{seen:?}");
    for vector in all {
        let (id, bytes, wanted) = (&vector["id"], bytes(&vector), vector["decoded"].as_object().unwrap());
        let mut readings = Readings::default();
        let Some(number) = vector["packet"].as_u64() else {
            let mut asked: Vec<u8> = wanted.keys().map(|key| key.parse().unwrap()).collect();
            asked.sort_unstable();
            let mut answer = roomba_oi::AnswerReader::to(&asked).unwrap();
            assert!(answer.feed(&bytes).is_empty() && answer.missing() == 0, "{id}");
            for (packet, raw) in answer.values() {
                assert_eq!(wanted[&(packet as u8).to_string()], packet.value(raw), "{id}");
            }
            continue;
        };
        let packet_id = PacketId::from_byte(number as u8).unwrap();
        assert_eq!(packet_id.size(), bytes.len(), "{id}");
        readings.read(packet_id, &bytes).unwrap();
        let mut written = [0; 80];
        assert_eq!(readings.write(packet_id, &mut written), Some(bytes.len()), "{id}");
        assert_eq!(written[..bytes.len()], bytes, "{id}");
        let Some(packet) = Packet::from_byte(number as u8) else {
            assert_eq!(wanted.len(), packet_id.packets().count(), "{id}");
            for packet in packet_id.packets() {
                assert_eq!(wanted[&(packet as u8).to_string()], packet.value(readings.raw(packet)), "{id}");
            }
            continue;
        };
        let got = decoded(packet, &readings);
        for (key, value) in wanted {
            match key.as_str() {
                "unsigned" => assert_eq!(value, readings.raw(packet), "{id}"),
                "name" if packet == Packet::OiMode => {
                    assert_eq!(Mode::from_report(readings.mode, 0), Some(mode(value)), "{id}");
                }
                "name" => assert_eq!((value.as_str(), readings.charging.byte()), (Some("full charging"), 2), "{id}"),
                key => assert_eq!(got[key], *value, "{id}: {key}"),
            }
        }
        assert!(packet.is_plausible(readings.raw(packet)), "{id}");
    }
}

/// Sizes and signs as in the specification's table of sensor packets.
#[test]
fn packet_table_and_groups() {
    for packet in Packet::ALL {
        let id = packet as u8;
        let size = if matches!(id, 19 | 20 | 22 | 23 | 25..=31 | 33 | 39..=44 | 46..=51 | 54..=57) { 2 } else { 1 };
        let is_signed = matches!(id, 19 | 20 | 23 | 24 | 39..=44 | 54..=57);
        assert_eq!((packet.format().size(), packet.format().is_signed()), (size, is_signed), "{packet}");
    }
    for sheet in sheets() {
        let groups = sheet["groups"].as_object().unwrap();
        assert_eq!(groups.len(), GROUPS.len());
        for (id, first, last) in GROUPS {
            assert_eq!(groups[&id.to_string()], json!([first as u8, last as u8, PacketId::size_of(id)]));
        }
        let Some(table) = sheet["packet_table"].as_array() else { continue };
        assert_eq!(table.len(), Packet::ALL.len());
        for (row, packet) in table.iter().zip(Packet::ALL) {
            assert_eq!((&row["id"], &row["name"]), (&json!(packet as u8), &json!(packet.name())));
        }
    }
}

#[test]
fn streams() {
    for vector in vectors("/streams", 8) {
        let (id, bytes) = (&vector["id"], bytes(&vector));
        let heard = hear(bytes.chunks(1));
        assert_eq!(!heard.frames.is_empty(), vector["valid"].as_bool().unwrap(), "{id}");
        let values: serde_json::Map<String, Value> = heard
            .frames
            .iter()
            .flatten()
            .map(|&(packet, raw)| ((packet as u8).to_string(), json!(packet.value(raw))))
            .collect();
        assert_eq!(Value::from(values), vector["decoded"], "{id}");
    }
}

#[test]
fn odometry() {
    for vector in vectors("/odometry", 3) {
        let number = |key: &str| vector[key].as_f64().unwrap();
        let got = if vector["id"] == "metre" || vector["id"] == "spin_360_per_wheel" {
            number("mm") / motion::MM_PER_COUNT - number("counts")
        } else {
            number("counts") * motion::MM_PER_COUNT - number("mm")
        };
        assert!(got.abs() <= number("tol"), "{}: off by {got}", vector["id"]);
    }
    for vector in vectors("/encoder_wrap", 7) {
        let counts = |key: &str| vector[key].as_i64().unwrap() as u16;
        assert_eq!(vector["delta"], motion::encoder_delta(counts("prev"), counts("now")), "{vector}");
    }
}

#[test]
fn drive_kinematics() {
    for vector in vectors("/drive_kinematics", 8) {
        let bytes = bytes(&vector);
        let speeds = match Command::parse(&bytes).unwrap() {
            Command::Drive { velocity, radius } => WheelSpeeds::of_drive(velocity, radius),
            Command::DriveDirect { right, left } => WheelSpeeds { right: right.into(), left: left.into() },
            other => panic!("{other:?}"),
        };
        let wanted = WheelSpeeds { right: vector["right"].as_f64().unwrap(), left: vector["left"].as_f64().unwrap() };
        assert!((speeds.right - wanted.right).abs() < 1e-9 && (speeds.left - wanted.left).abs() < 1e-9, "{vector}");
    }
}

#[test]
fn angle_error() {
    assert!(sheets().iter().all(|sheet| sheet["angle_bug"]["factor"] == motion::ANGLE_ERROR));
    for example in vectors("/angle_bug/examples", 2) {
        let (angle, reported) = (example["true_deg"].as_f64().unwrap(), example["reported_approx"].as_f64().unwrap());
        assert!((motion::faulty_angle(angle) - reported).abs() < 0.005);
        assert!((motion::true_angle(reported) - angle).abs() < 0.02);
    }
}

#[test]
fn modes() {
    for vector in vectors("/modes/commands", 44) {
        let (from, opcode) = (mode(&vector["from"]), opcode(&vector["cmd"]));
        assert_eq!(from.after_command(opcode).unwrap_or(from), mode(&vector["to"]), "{vector}");
    }
    for vector in vectors("/modes/safety", 8) {
        let event = vector["event"].as_str().unwrap();
        let hazard = match event {
            "cliff while moving forward" | "cliff" => {
                Hazard::of_cliff(WheelSpeeds { right: 100.0, left: 100.0 }).unwrap()
            }
            "cliff while moving backward with |radius| < robot radius" => {
                Hazard::of_cliff(WheelSpeeds::of_drive(-100, 150)).unwrap()
            }
            "wheel drop" => Hazard::WheelDrop,
            "bumper" => Hazard::Bumper,
            _ => Hazard::Charger,
        };
        let reaction = mode(&vector["mode"]).after_hazard(hazard);
        assert_eq!((reaction.mode, reaction.stops), (mode(&vector["to"]), vector["motors"] == "stop"), "{vector}");
    }
}
