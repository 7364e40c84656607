//! Stages that planners are composed of: they take what they need as arguments and keep nothing.

mod seek;

pub use seek::Seeker;
