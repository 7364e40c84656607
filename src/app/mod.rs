//! Sessions and what to draw of them.

mod outline;
mod palette;
mod scene;
mod viewport;

pub use outline::outlines;
pub use palette::Palette;
pub use scene::{RobotView, Scene};
pub use viewport::Viewport;
