//! Text description of the Map tab, for screen readers and the log.

use super::{MapPhase, MapSession};

impl MapSession {
    /// One or two sentences that describe the picture.
    pub fn description(&self) -> String {
        let title = self.base.as_ref().map_or("no room", |base| &base.title);
        let Some(run) = self.run() else {
            let why = if self.prepared().is_some() {
                "no program drives the robot"
            } else {
                "the robot doesn't fit into this room"
            };
            return format!("Map of {title}: {why}.");
        };
        if let Some(done) = self.returned() {
            return format!(
                "Map of {title}, restored from the last visit. Replaying the run: {:.0} % done.",
                (100.0 * done).floor()
            );
        }
        let Some([here, odometry]) = self.figures() else { return format!("Map of {title}.") };
        if run.steps() == 0 {
            return format!("Map of {title}: empty. The robot is at its start and has not mapped anything yet.");
        }
        let held = if self.phase() == MapPhase::Held { " It is being held." } else { "" };
        if let Some(is_sure) = self.estimate().and_then(|estimate| estimate.is_sure()) {
            let place = match (here.position_m, is_sure) {
                (None, _) => "has no pose estimate".to_owned(),
                (Some(off), false) => format!("has an uncertain pose estimate, {} off", length(off)),
                (Some(off), true) => format!("is localised, {} off", length(off)),
            };
            let looks = self.intent().is_some_and(|intent| intent.locator.is_some());
            let who = match (&self.known, looks) {
                (Some(_), _) => "has a map of the room",
                (None, true) => "was kidnapped and is relocalising on its map",
                (None, false) => "was kidnapped",
            };
            return format!("{}: the robot {who}, and {place}.{held}", minutes(run.time_s()));
        }
        let goals = self.intent().map_or(String::new(), |intent| match (intent.frontiers.len(), intent.route.last()) {
            (0, None) => String::new(),
            (0, Some(_)) => " It is driving to its goal.".to_owned(),
            (1, None) => " One frontier is left to explore.".to_owned(),
            (count, None) => format!(" {count} frontiers are left to explore."),
            (1, Some(_)) => " It is driving to its goal; one frontier is left.".to_owned(),
            (count, Some(_)) => {
                format!(" It is driving to its goal; {count} frontiers are left.")
            }
        });
        let grid = if self.thesis().is_some() { " on the thesis' grid" } else { "" };
        format!(
            "{}: {:.0} % of the boundary mapped{grid}, {:.0} % of the floor known. The pose estimate is {} off; by odometry \
             alone it would be {}.{goals}{held}",
            minutes(run.time_s()),
            (100.0 * here.boundary).floor(),
            (100.0 * here.known).floor(),
            length(here.position_m.unwrap_or(0.0)),
            length(odometry.position_m.unwrap_or(0.0)),
        )
    }
}

fn minutes(seconds: f64) -> String {
    let whole = (seconds / 60.0) as u64;
    if whole == 0 { format!("{:.0} s", seconds.floor()) } else { format!("{whole} min") }
}

/// A length in the unit that suits it.
fn length(metres: f64) -> String {
    if metres < 1.0 { format!("{:.0} cm", 100.0 * metres) } else { format!("{metres:.1} m") }
}
