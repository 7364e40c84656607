//! A recording of a robot's line as an MCAP bag with ROS 2 messages.

use robovac_core::{geometry::Pose, robot::Drive};
use robovac_link::{
    connection::LineRecording,
    driver::Happening,
    recording::{LineEvent, RecordedReading, Timeline, Watch},
};
use robovac_ros::{
    BASE, Bag, BagError, Cdr, ODOM, Stamped, Topic,
    message::{self, BatteryActivity, BatteryState, BumperState, velocity, velocity_of},
    topic,
};
use roomba_oi::{
    ChargingState, Command, CommandDecoder, Mode, Packet,
    motion::{WHEEL_BASE_MM, WheelSpeeds},
};
use std::{
    io::{Seek, Write},
    sync::Arc,
};

/// Least time between two messages of odometry, and of the battery, s: with their covariances, all of the 67 a second would
/// be 50 kB a second.
const ODOMETRY_S: f64 = 0.05;
const BATTERY_S: f64 = 1.0;

/// Writes the messages of a recording with its examined `timeline`, in the order of their times.
pub fn recording_bag<W: Write + Seek>(
    recording: &Arc<LineRecording>,
    timeline: &Timeline,
    file: W,
) -> Result<W, BagError> {
    let (mut topics, mut bag) = (LineTopics::new(0.0), Bag::new(file, "")?);
    let mut entries = timeline.entries.iter().peekable();
    let mut watch = Watch::new(Arc::clone(recording));
    let mut has_more = true;
    while has_more {
        let mut events = Vec::new();
        has_more = watch.go_on(1.0, |at, event| events.push((at, event)));
        for (at, event) in events {
            while let Some(entry) = entries.next_if(|entry| entry.time_s <= at) {
                topics.log(entry.time_s, &entry.text, entry.is_fault);
            }
            topics.event(at, &event);
        }
        bag.put_all(topics.take())?;
    }
    for entry in entries {
        topics.log(entry.time_s, &entry.text, entry.is_fault);
    }
    bag.put_all(topics.take())?;
    bag.finish()
}

/// Turns what happens on the line of a real robot into messages.
pub struct LineTopics {
    /// Added to all times, s.
    epoch_s: f64,
    out: Vec<Stamped>,
    pose: Option<Pose>,
    odometry_at: f64,
    battery_at: f64,
    has_dropped: Option<bool>,
    mode: Option<Mode>,
}

impl LineTopics {
    /// Nothing has happened yet; time 0 is `epoch_s` seconds in the stamps.
    pub fn new(epoch_s: f64) -> Self {
        Self {
            epoch_s,
            out: Vec::new(),
            pose: None,
            odometry_at: f64::NEG_INFINITY,
            battery_at: f64::NEG_INFINITY,
            has_dropped: None,
            mode: None,
        }
    }

    /// The messages since the last call, in the order of their times.
    pub fn take(&mut self) -> std::vec::Drain<'_, Stamped> {
        self.out.drain(..)
    }

    /// Takes an event at a time, s.
    pub fn event(&mut self, at: f64, event: &LineEvent) {
        match event {
            LineEvent::Reading(reading) => self.reading(at + self.epoch_s, reading),
            LineEvent::Happening(Happening::Sent(bytes)) => self.sent(at + self.epoch_s, bytes),
            _ => {}
        }
    }

    /// Takes an event in words.
    pub fn log(&mut self, at: f64, text: &str, is_fault: bool) {
        let at = at + self.epoch_s;
        self.put(&topic::LOG, at, message::log(at, "recording", text, is_fault));
    }

    fn put(&mut self, topic: &'static Topic, at: f64, message: Cdr) {
        self.out.push(topic.stamped(at, message));
    }

    fn reading(&mut self, at: f64, reading: &RecordedReading) {
        let has = |packet| reading.contained.contains(packet);
        let pose = reading.pose;
        let before = self.pose.replace(pose);
        if at - self.odometry_at >= ODOMETRY_S {
            self.odometry_at = at;
            let now = before.map_or([0.0; 3], |before| velocity(before, pose, reading.dt_s));
            self.put(&topic::ODOM, at, message::odometry(at, ODOM, pose, now));
            self.put(&topic::TF, at, message::transforms(at, &[(ODOM, BASE, pose)]));
        }
        if has(Packet::BatteryCharge) && at - self.battery_at >= BATTERY_S {
            self.battery_at = at;
            self.put(&topic::BATTERY, at, message::battery(at, &battery(reading)));
        }
        let readings = &reading.readings;
        if has(Packet::BumpsAndDrops) {
            let (bumps, light) = (readings.bumps, readings.light_bumper);
            let state = BumperState {
                pressed: [bumps.bump_left, bumps.bump_right],
                light: [
                    light.left,
                    light.front_left,
                    light.centre_left,
                    light.centre_right,
                    light.front_right,
                    light.right,
                ],
                signal: readings.light_signal,
            };
            self.put(&topic::BUMPER, at, message::bumper(at, &state));
            let dropped = bumps.drop_left || bumps.drop_right;
            if self.has_dropped.replace(dropped) != Some(dropped) {
                self.put(&topic::WHEEL_DROP, at, message::flag(dropped));
            }
        }
        if has(Packet::CliffLeft) {
            self.put(&topic::CLIFF, at, message::cliff(at, readings.cliff));
        }
        if let Some(mode) = reading.mode
            && self.mode.replace(mode) != Some(mode)
        {
            self.put(&topic::MODE, at, message::mode(at, mode as u8));
        }
    }

    /// Commanded wheel speeds. Duty cycles (Drive PWM) aren't speeds.
    fn sent(&mut self, at: f64, bytes: &[u8]) {
        let mut decoder = CommandDecoder::default();
        for &byte in bytes {
            let wheels = match decoder.push(byte).map(|received| received.command) {
                Some(Ok(Command::DriveDirect { right, left })) => {
                    WheelSpeeds { right: right.into(), left: left.into() }
                }
                Some(Ok(Command::Drive { velocity, radius })) => WheelSpeeds::of_drive(velocity, radius).limited(),
                _ => continue,
            };
            let drive = Drive::wheels(1e-3 * wheels.left, 1e-3 * wheels.right);
            let command = velocity_of(drive, 1e-3 * WHEEL_BASE_MM);
            self.put(&topic::CMD_VEL, at, message::twist(command));
        }
    }
}

fn battery(reading: &RecordedReading) -> BatteryState {
    let readings = &reading.readings;
    let thousandth = |value: f32| value / 1000.0;
    BatteryState {
        voltage_v: thousandth(readings.voltage_mv.into()),
        current_a: thousandth(readings.current_ma.into()),
        temperature_c: readings.temperature_c.into(),
        charge_ah: thousandth(readings.charge_left_mah().into()),
        capacity_ah: thousandth(readings.capacity_mah.into()),
        supply: match readings.charging {
            ChargingState::Reconditioning | ChargingState::Full | ChargingState::Trickle => BatteryActivity::Charging,
            ChargingState::None => BatteryActivity::Discharging,
            ChargingState::Waiting | ChargingState::Fault => BatteryActivity::NotCharging,
            ChargingState::Other(_) => BatteryActivity::Unknown,
        },
    }
}
