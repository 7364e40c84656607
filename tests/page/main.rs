//! What the tabs of the page decide and show.

mod compare;
mod docs;
mod drawing;
mod floor_plan_tab;
mod furnish;
mod map;
mod map_files;
mod montecarlo;
mod opening;
mod scenario;
mod session;
mod types;
