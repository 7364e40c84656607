//! `planners`, `behaviours`, `rooms`, `robots`: lists, one entry a line.

use coverage_planners::{PLANNERS, metrics::METRICS};
use robovac_core::{floor_plan::ROOMS, robot::MODELS};
use robovac_link::emulator::PERSONALITIES;
use robovac_sim::controller::BEHAVIOURS;

pub fn planners() -> String {
    lines(PLANNERS.iter().map(|planner| (planner.id, planner.title)))
}

pub fn behaviours() -> String {
    lines(BEHAVIOURS.iter().map(|behaviour| (behaviour.id, behaviour.title)))
}

pub fn rooms() -> String {
    lines(ROOMS.iter().map(|room| (room.id, room.title)))
}

pub fn robots() -> String {
    lines(MODELS.iter().map(|robot| (robot.id, robot.title)))
}

pub fn personalities() -> String {
    lines(PERSONALITIES.iter().map(|who| (who.id, who.title)))
}

pub fn metrics() -> String {
    lines(METRICS.iter().map(|metric| (metric.id, metric.definition)))
}

/// Ids, padded so that what follows stands in a column.
fn lines<'a>(entries: impl Iterator<Item = (&'a str, &'a str)> + Clone) -> String {
    let width = entries.clone().map(|(id, _)| id.len()).max().unwrap_or(0);
    entries.fold(String::new(), |text, (id, title)| text + &format!("{id:width$}  {title}\n"))
}
