//! A survey in words: for those who don't see the picture, and for the log.

use super::{Phase, Survey};

impl Survey {
    /// One or two sentences that stand for the picture.
    pub fn description(&self) -> String {
        let title = self.base.as_ref().map_or("no room", |base| &base.title);
        let Some(run) = self.run() else { return format!("Map of {title}: the robot can't be put into this room.") };
        if let Some(done) = self.returned() {
            return format!(
                "Map of {title}, as it was left. The robot is driven again up to there: {:.0} % done.",
                (100.0 * done).floor()
            );
        }
        let Some([here, odometry]) = self.figures() else { return format!("Map of {title}.") };
        if run.steps() == 0 {
            return format!("Map of {title}: empty. The robot stands at its start and knows nothing of the room.");
        }
        let held = if self.phase() == Phase::Held { " Somebody holds it." } else { "" };
        if let Some(is_sure) = self.belief().and_then(|belief| belief.is_sure()) {
            let place = match (here.position_m, is_sure) {
                (None, _) => "has no idea where it is".to_owned(),
                (Some(off), false) => format!("guesses where it is, {} off", length(off)),
                (Some(off), true) => format!("is sure where it is, {} off", length(off)),
            };
            let looks = self.intent().is_some_and(|intent| intent.locator.is_some());
            let who = match (&self.known, looks) {
                (Some(_), _) => "knows a map of the room",
                (None, true) => "was carried off and looks for itself on its map",
                (None, false) => "was carried off",
            };
            return format!("{}: the robot {who}, and {place}.{held}", minutes(run.time_s()));
        }
        let goals = self.intent().map_or(String::new(), |intent| match (intent.frontiers.len(), intent.route.last()) {
            (0, None) => String::new(),
            (0, Some(_)) => " It is driving along a line to its goal.".to_owned(),
            (1, None) => " What it knows ends in one place where it could go on.".to_owned(),
            (count, None) => format!(" What it knows ends in {count} places where it could go on."),
            (1, Some(_)) => " It is driving along a line to its goal; what it knows ends in one place.".to_owned(),
            (count, Some(_)) => {
                format!(" It is driving along a line to its goal; what it knows ends in {count} places.")
            }
        });
        format!(
            "{}: {:.0} % of the boundary mapped, {:.0} % of the floor known. The robot believes to be {} from where it is; by \
             odometry alone it would be {}.{goals}{held}",
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
