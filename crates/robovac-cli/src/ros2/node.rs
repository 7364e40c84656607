//! A node of ROS 2: publishers of our topics, and a subscription to commands.

use crate::failure::Failure;
use robovac_ros::{Stamped, Topic, message::Velocity, topic};
use ros2_client::{
    Context, ContextOptions, MessageTypeName, Name, Node, NodeName, NodeOptions, Publisher, Subscription,
    rustdds::{
        Duration, QosPolicies, QosPolicyBuilder,
        policy::{Durability, History, Reliability},
    },
};
use serde::{Deserialize, Serialize, Serializer, ser::SerializeTuple};
use std::{collections::BTreeMap, fmt::Display};

/// The name of all nodes, in their namespaces.
const NAME: &str = "robovac";
/// Bytes of a message before its content.
const ENCAPSULATION: usize = 4;
/// Messages that a slow reliable subscriber can be behind.
const DEPTH: i32 = 10;
/// Longest time that a message waits for a slow subscriber.
const BLOCKING: std::time::Duration = std::time::Duration::from_millis(20);

/// Arguments of a node.
#[derive(clap::Args)]
pub struct NodeArguments {
    /// DDS domain; nodes see each other only in the same domain
    #[arg(long, value_name = "N", default_value_t = 0, env = "ROS_DOMAIN_ID", value_parser = clap::value_parser!(u16).range(0..=232))]
    domain: u16,
    /// Another name for a topic, as in scan:=laser/scan; can be repeated
    #[arg(long, value_name = "FROM:=TO", value_parser = parse_remap)]
    remap: Vec<(String, String)>,
}

/// The participant that all nodes of a program share.
pub struct Participant<'a> {
    context: Context,
    arguments: &'a NodeArguments,
}

/// A node in one namespace.
pub struct RosNode {
    node: Node,
    namespace: String,
    remaps: BTreeMap<String, String>,
    publishers: BTreeMap<&'static str, Publisher<Encoded>>,
    commands: Option<Subscription<TwistMessage>>,
}

/// A message that is encoded already.
struct Encoded(Vec<u8>);

/// `geometry_msgs/Twist`
#[derive(Deserialize)]
struct TwistMessage {
    linear: [f64; 3],
    angular: [f64; 3],
}

/// As a tuple of bytes: it has no length before it, and bytes are never aligned, so what comes out are these bytes.
impl Serialize for Encoded {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut tuple = serializer.serialize_tuple(self.0.len())?;
        self.0.iter().try_for_each(|byte| tuple.serialize_element(byte))?;
        tuple.end()
    }
}

impl<'a> Participant<'a> {
    pub fn new(arguments: &'a NodeArguments) -> Result<Self, Failure> {
        let context = Context::with_options(ContextOptions::new().domain_id(arguments.domain));
        Ok(Self { context: context.map_err(|e| fault("can't take part in the network", &e))?, arguments })
    }

    /// The domain.
    pub fn domain(&self) -> u16 {
        self.arguments.domain
    }

    /// A node in `namespace`; "" for none.
    pub fn node(&self, namespace: &str) -> Result<RosNode, Failure> {
        let namespace = namespace.trim_matches('/').to_owned();
        let bad = |e: &dyn Display| Failure::usage(format!("--namespace {namespace}: {e}"));
        let name = NodeName::new(&format!("/{namespace}"), NAME).map_err(|e| bad(&format!("{e:?}")))?;
        let options = NodeOptions::new().enable_rosout(false);
        let node = self.context.new_node(name, options).map_err(|e| fault("can't start a node", &format!("{e:?}")))?;
        let remaps = self.arguments.remap.iter().cloned().collect();
        Ok(RosNode { node, namespace, remaps, publishers: BTreeMap::new(), commands: None })
    }
}

impl RosNode {
    /// Full name of the node.
    pub fn name(&self) -> String {
        self.node.fully_qualified_name()
    }

    /// Publishes messages, in turn.
    pub fn publish(&mut self, messages: impl IntoIterator<Item = Stamped>) -> Result<(), Failure> {
        for Stamped { topic, mut bytes, .. } in messages {
            if !self.publishers.contains_key(topic.name) {
                let publisher = self.publisher(topic)?;
                self.publishers.insert(topic.name, publisher);
            }
            bytes.drain(..ENCAPSULATION);
            if let Some(publisher) = self.publishers.get(topic.name) {
                // One that no subscriber takes in time is lost, as everywhere in ROS 2.
                let _ = publisher.publish(Encoded(bytes));
            }
        }
        Ok(())
    }

    fn publisher(&mut self, topic: &'static Topic) -> Result<Publisher<Encoded>, Failure> {
        let (name, kind, quality) = self.endpoint(topic)?;
        let found = self.node.create_topic(&name, kind, &quality);
        let found = found.map_err(|e| fault(topic.name, &format!("{e:?}")))?;
        self.node.create_publisher(&found, None).map_err(|e| fault(topic.name, &format!("{e:?}")))
    }

    /// Listens to commands.
    pub fn subscribe(&mut self) -> Result<(), Failure> {
        let (name, kind, quality) = self.endpoint(&topic::CMD_VEL)?;
        let found = self.node.create_topic(&name, kind, &quality);
        let found = found.map_err(|e| fault("cmd_vel", &format!("{e:?}")))?;
        let commands = self.node.create_subscription(&found, None);
        self.commands = Some(commands.map_err(|e| fault("cmd_vel", &format!("{e:?}")))?);
        Ok(())
    }

    /// The latest command since the last call. One that isn't a number is none.
    pub fn command(&self) -> Option<Velocity> {
        let mut latest = None;
        // A message that can't be read doesn't end those after it.
        for _ in 0..DEPTH {
            match self.commands.as_ref()?.take() {
                Ok(Some((TwistMessage { linear: [ahead, left, _], angular: [_, _, turn] }, _))) => {
                    latest = Some([ahead, left, turn]);
                }
                Ok(None) => break,
                Err(_) => {}
            }
        }
        latest.filter(|command| command.iter().all(|value| value.is_finite()))
    }

    fn endpoint(&self, topic: &Topic) -> Result<(Name, MessageTypeName, QosPolicies), Failure> {
        let name = match self.remaps.get(topic.name) {
            Some(other) if other.starts_with('/') || self.namespace.is_empty() => {
                format!("/{}", other.trim_start_matches('/'))
            }
            Some(other) => format!("/{}/{other}", self.namespace),
            None => topic.in_namespace(&self.namespace),
        };
        let (package, kind) = topic.kind.name();
        let parsed = Name::parse(&name).map_err(|e| Failure::usage(format!("the topic {name}: {e:?}")))?;
        Ok((parsed, MessageTypeName::new(package, kind), quality(topic)))
    }
}

/// Reliable; latched topics keep the last message for late subscribers.
fn quality(topic: &Topic) -> QosPolicies {
    let (durability, depth) =
        if topic.is_latched { (Durability::TransientLocal, 1) } else { (Durability::Volatile, DEPTH) };
    QosPolicyBuilder::new()
        .reliability(Reliability::Reliable { max_blocking_time: Duration::from(BLOCKING) })
        .durability(durability)
        .history(History::KeepLast { depth })
        .build()
}

fn fault(what: &str, error: &impl Display) -> Failure {
    Failure::system(format!("ROS 2: {what}: {error}; check the network interfaces and --domain"))
}

fn parse_remap(text: &str) -> Result<(String, String), String> {
    let pair = text.split_once(":=").filter(|(from, to)| !from.is_empty() && !to.is_empty());
    let pair = pair.map(|(from, to)| (from.trim_start_matches('/').to_owned(), to.to_owned()));
    pair.ok_or_else(|| "give it as from:=to, e.g. scan:=laser/scan".to_owned())
}
