//! An MCAP file with messages of ROS 2, as `ros2 bag` and Foxglove read it.

use super::{
    cdr::{Cdr, nanos},
    topic::{Stamped, Topic},
};
use mcap::{McapError, WriteOptions, Writer, records::MessageHeader};
use std::{
    collections::BTreeMap,
    io::{self, Cursor, Seek, Write},
};

/// Quality of service that `ros2 bag play` offers for a latched topic: keep last 1, reliable, transient local. Numbers
/// are those of `rmw`, which all releases read.
const LATCHED: &str = "- history: 1\n  depth: 1\n  reliability: 1\n  durability: 1\n  deadline:\n    sec: 9223372036\n    \
    nsec: 854775807\n  lifespan:\n    sec: 9223372036\n    nsec: 854775807\n  liveliness: 1\n  \
    liveliness_lease_duration:\n    sec: 9223372036\n    nsec: 854775807\n  avoid_ros_namespace_conventions: false\n";

/// An MCAP file being written. Without compression, which would need a C compiler.
pub struct Bag<W: Write + Seek> {
    writer: Writer<W>,
    namespace: String,
    channels: BTreeMap<&'static str, u16>,
    sequence: u32,
}

/// Reasons why a bag can't be written.
#[derive(Debug, thiserror::Error)]
pub enum BagError {
    /// The file.
    #[error(transparent)]
    File(#[from] io::Error),
    /// The format.
    #[error("the bag can't be written: {0}")]
    Format(McapError),
}

impl From<McapError> for BagError {
    fn from(error: McapError) -> Self {
        match error {
            McapError::Io(error) => Self::File(error),
            other => Self::Format(other),
        }
    }
}

impl<W: Write + Seek> Bag<W> {
    /// A bag whose topics are in `namespace`; "" for none.
    pub fn new(file: W, namespace: &str) -> Result<Self, BagError> {
        let options = WriteOptions::new().compression(None).profile("ros2").library("robovac");
        let writer = options.create(file)?;
        Ok(Self { writer, namespace: namespace.to_owned(), channels: BTreeMap::new(), sequence: 0 })
    }

    /// Adds a message.
    pub fn put(&mut self, topic: &'static Topic, time_s: f64, message: Cdr) -> Result<(), BagError> {
        self.put_bytes(topic, time_s, &message.bytes())
    }

    /// Adds messages.
    pub fn put_all(&mut self, messages: impl IntoIterator<Item = Stamped>) -> Result<(), BagError> {
        messages.into_iter().try_for_each(|message| self.put_bytes(message.topic, message.time_s, &message.bytes))
    }

    fn put_bytes(&mut self, topic: &'static Topic, time_s: f64, bytes: &[u8]) -> Result<(), BagError> {
        let time = nanos(time_s);
        let channel_id = self.channel(topic)?;
        let header = MessageHeader { channel_id, sequence: self.sequence, log_time: time, publish_time: time };
        self.sequence = self.sequence.wrapping_add(1);
        Ok(self.writer.write_to_known_channel(&header, bytes)?)
    }

    fn channel(&mut self, topic: &'static Topic) -> Result<u16, BagError> {
        if let Some(&channel) = self.channels.get(topic.name) {
            return Ok(channel);
        }
        let (package, name) = topic.kind.name();
        let definition = topic.kind.definition();
        let schema = self.writer.add_schema(&format!("{package}/msg/{name}"), "ros2msg", definition.as_bytes())?;
        let quality = topic.is_latched.then(|| ("offered_qos_profiles".to_owned(), LATCHED.to_owned()));
        let name = topic.in_namespace(&self.namespace);
        let channel = self.writer.add_channel(schema, &name, "cdr", &quality.into_iter().collect())?;
        self.channels.insert(topic.name, channel);
        Ok(channel)
    }

    /// Writes the rest and the index; returns the file.
    pub fn finish(mut self) -> Result<W, BagError> {
        self.writer.finish()?;
        let mut file = self.writer.into_inner();
        file.flush()?;
        Ok(file)
    }
}

/// A whole bag in memory.
pub fn file_of(messages: impl IntoIterator<Item = Stamped>) -> Result<Vec<u8>, BagError> {
    let mut bag = Bag::new(Cursor::new(Vec::new()), "")?;
    bag.put_all(messages)?;
    Ok(bag.finish()?.into_inner())
}
