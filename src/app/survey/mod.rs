//! The place Map: a robot that makes a map of a room that it has never seen, and what it makes of it.
