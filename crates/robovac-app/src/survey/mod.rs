//! The Map tab: a robot maps an unknown room.
//!
//! [`Survey`] is what the page has: a room taken over from the session, a robot in it that explores and maps, and time. What it
//! believes is in its run's mapper; [`Truth`] is what quality figures compare that with, and nothing else uses it.
//! [`Stored`] brings all of it over a reload.

mod base;
mod belief;
mod curve;
mod figures;
mod keeping;
mod known;
mod layers;
mod numbers;
mod session;
mod setup;
mod stage;
mod state;
mod store;
mod truth;
mod view;
mod words;

pub use belief::Belief;
pub use curve::Sample;
pub use figures::Figures;
pub use known::{Known, OpenError};
pub use layers::Layers;
pub use session::Survey;
pub use setup::{SurveySetup, cleaners, explorers};
pub use state::{Deed, Phase};
pub use store::{STORE_VERSION, StoreError, Stored};
pub use truth::{Truth, Verdict};
pub use view::SurveyView;
