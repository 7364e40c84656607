//! A recording as an MCAP file with ROS 2 messages.

use super::{
    cdr::{Cdr, nanos},
    ros::{self, Message, TOPICS},
};
use crate::failure::Failure;
use ::mcap::{McapError, McapResult, WriteOptions, Writer, records::MessageHeader};
use robovac_core::geometry::Pose;
use robovac_link::{
    connection::LineRecording,
    driver::Happening,
    recording::{LineEvent, RecordedReading, Timeline, Watch},
};
use roomba_oi::{Command, CommandDecoder, Mode, Packet, motion::WheelSpeeds};
use std::{
    collections::BTreeMap,
    io::{self, Seek, Write},
    path::Path,
    sync::Arc,
};

/// Least time between two messages of odometry, and of the battery, s: with their covariances, all of the 67 a second would
/// be 50 kB a second.
const ODOMETRY_S: f64 = 0.05;
const BATTERY_S: f64 = 1.0;

/// Writes the messages of a recording, in the order of their times.
pub fn write(recording: &Arc<LineRecording>, timeline: &Timeline, file: impl Write + Seek) -> McapResult<()> {
    let mut out = Messages::new(file)?;
    let mut entries = timeline.entries.iter().peekable();
    let mut watch = Watch::new(Arc::clone(recording));
    let mut has_more = true;
    while has_more {
        let mut events = Vec::new();
        has_more = watch.go_on(1.0, |at, event| events.push((at, event)));
        for (at, event) in events {
            while let Some(entry) = entries.next_if(|entry| entry.time_s <= at) {
                out.put(entry.time_s, Message::Log, ros::log(entry))?;
            }
            match event {
                LineEvent::Reading(reading) => out.reading(at, &reading)?,
                LineEvent::Happening(Happening::Sent(bytes)) => out.sent(at, &bytes)?,
                _ => {}
            }
        }
    }
    for entry in entries {
        out.put(entry.time_s, Message::Log, ros::log(entry))?;
    }
    out.finish()
}

/// The cause of a failed write.
pub fn failure(path: &Path, error: &McapError) -> Failure {
    match error {
        McapError::Io(error) => Failure::io(path.display(), error),
        other => Failure::io(path.display(), &io::Error::other(other.to_string())),
    }
}

struct Messages<W: Write + Seek> {
    writer: Writer<W>,
    channels: [u16; TOPICS.len()],
    sequence: u32,
    pose: Option<Pose>,
    odometry_at: f64,
    battery_at: f64,
    has_dropped: Option<bool>,
    mode: Option<Mode>,
}

impl<W: Write + Seek> Messages<W> {
    fn new(file: W) -> McapResult<Self> {
        let options = WriteOptions::new().compression(None).profile("ros2").library("robovac");
        let mut writer = options.create(file)?;
        let mut channels = [0; TOPICS.len()];
        for (channel, topic) in channels.iter_mut().zip(&TOPICS) {
            let schema = writer.add_schema(topic.schema, "ros2msg", topic.definition.as_bytes())?;
            *channel = writer.add_channel(schema, topic.name, "cdr", &BTreeMap::new())?;
        }
        Ok(Self {
            writer,
            channels,
            sequence: 0,
            pose: None,
            odometry_at: f64::NEG_INFINITY,
            battery_at: f64::NEG_INFINITY,
            has_dropped: None,
            mode: None,
        })
    }

    fn put(&mut self, time_s: f64, what: Message, cdr: Cdr) -> McapResult<()> {
        let time = nanos(time_s);
        let header = MessageHeader {
            channel_id: self.channels[what as usize],
            sequence: self.sequence,
            log_time: time,
            publish_time: time,
        };
        self.sequence = self.sequence.wrapping_add(1);
        self.writer.write_to_known_channel(&header, &cdr.bytes())
    }

    fn reading(&mut self, at: f64, reading: &RecordedReading) -> McapResult<()> {
        let has = |packet| reading.contained.contains(packet);
        let before = self.pose.replace(reading.pose);
        if at - self.odometry_at >= ODOMETRY_S {
            self.odometry_at = at;
            self.put(at, Message::Odometry, ros::odometry(at, before, reading))?;
        }
        if has(Packet::BatteryCharge) && at - self.battery_at >= BATTERY_S {
            self.battery_at = at;
            self.put(at, Message::Battery, ros::battery(at, reading))?;
        }
        if has(Packet::BumpsAndDrops) {
            self.put(at, Message::Bumper, ros::bumper(at, reading))?;
            let dropped = reading.readings.bumps.drop_left || reading.readings.bumps.drop_right;
            if self.has_dropped.replace(dropped) != Some(dropped) {
                self.put(at, Message::WheelDrop, ros::wheel_drop(dropped))?;
            }
        }
        if has(Packet::CliffLeft) {
            self.put(at, Message::Cliff, ros::cliff(at, reading))?;
        }
        if let Some(mode) = reading.mode
            && self.mode.replace(mode) != Some(mode)
        {
            self.put(at, Message::Mode, ros::mode(at, mode))?;
        }
        Ok(())
    }

    /// Commanded wheel speeds. Duty cycles (Drive PWM) aren't speeds.
    fn sent(&mut self, at: f64, bytes: &[u8]) -> McapResult<()> {
        let mut decoder = CommandDecoder::default();
        for &byte in bytes {
            let wheels = match decoder.push(byte).map(|received| received.command) {
                Some(Ok(Command::DriveDirect { right, left })) => {
                    WheelSpeeds { right: right.into(), left: left.into() }
                }
                Some(Ok(Command::Drive { velocity, radius })) => WheelSpeeds::of_drive(velocity, radius).limited(),
                _ => continue,
            };
            self.put(at, Message::Command, ros::command(wheels))?;
        }
        Ok(())
    }

    fn finish(mut self) -> McapResult<()> {
        self.writer.finish()?;
        self.writer.into_inner().flush()?;
        Ok(())
    }
}
