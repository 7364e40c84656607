//! The drafting room: a file is looked at, scaled, traced and swept before it becomes the room.
