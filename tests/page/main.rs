//! Decisions and displays of the page's tabs.

mod compare;
mod counts;
mod docs;
mod drawing;
mod explainers;
mod floor_plan_tab;
mod furnish;
mod leaks;
mod map;
mod map_files;
mod montecarlo;
mod names;
mod opening;
mod own_robot;
mod pictures;
mod scenario;
mod session;
mod sweep_files;
mod types;
