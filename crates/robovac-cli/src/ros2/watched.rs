//! A real robot as a node of ROS 2, for `robovac monitor --ros2`. It is only listened to.

use super::{NodeArguments, Participant, RosNode, since_1970};
use crate::failure::Failure;
use robovac_app::export::LineTopics;
use robovac_link::connection::Connection;

/// Whether and how a monitored robot is published.
#[derive(clap::Args)]
pub struct WatchedArguments {
    /// Publish the robot's readings as a node of ROS 2
    #[arg(long)]
    ros2: bool,
    /// Namespace of the node
    #[arg(long, value_name = "NAME", default_value = "", requires = "ros2")]
    namespace: String,
    #[command(flatten)]
    node: NodeArguments,
}

/// The node of a robot.
pub struct WatchedNode {
    node: RosNode,
    topics: LineTopics,
}

impl WatchedNode {
    /// The node, if one was asked for; the connection's time 0 is now.
    pub fn new(arguments: &WatchedArguments, link: &mut Connection) -> Result<Option<Self>, Failure> {
        if !arguments.ros2 {
            return Ok(None);
        }
        link.watch();
        let node = Participant::new(&arguments.node)?.node(&arguments.namespace)?;
        Ok(Some(Self { node, topics: LineTopics::new(since_1970()) }))
    }

    /// Publishes what happened since the last call.
    pub fn publish(&mut self, link: &mut Connection) -> Result<(), Failure> {
        for (at, event) in link.take_events() {
            self.topics.event(at, &event);
        }
        self.node.publish(self.topics.take())
    }
}
