//! What the tabs of the page decide and show.

mod compare;
mod draft;
mod drawing;
mod floor_plan;
mod furnish;
mod montecarlo;
mod opening;
mod scenario;
mod session;
mod survey;
