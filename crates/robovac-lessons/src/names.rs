//! Names in the links of a lesson that nothing has.

use crate::{Lesson, LessonFault, Link};
use robovac_core::registry::nearest;
use robovac_sim::experiment::Algorithm;

/// What links can name, each a list with ", " between. The page has them in its menus; registries are too large for the
/// module that reads lessons.
#[derive(Debug, Clone, Default)]
pub struct KnownNames {
    /// Rooms.
    pub rooms: String,
    /// Robots.
    pub robots: String,
    /// Planners.
    pub planners: String,
    /// Behaviours.
    pub behaviours: String,
}

impl Lesson {
    /// Names in its links that aren't among the known ones.
    pub fn unknown(&self, known: &KnownNames) -> Vec<LessonFault> {
        let mut faults = Vec::new();
        for (line, text) in &self.links {
            for (key, value) in Link::parse(text).pairs() {
                let names = match key {
                    "room" if value != "own" => &known.rooms,
                    "robot" => &known.robots,
                    "planner" if !Algorithm::is_program_id(value) => &known.planners,
                    "behaviour" if !Algorithm::is_program_id(value) => &known.behaviours,
                    _ => continue,
                };
                if names.split(", ").any(|name| name == value) {
                    continue;
                }
                let mend = nearest(value, names);
                let mend =
                    mend.map_or_else(|| format!("there are: {names}"), |name| format!("did you mean \"{name}\"?"));
                let fault = LessonFault::new(*line, format!("there is no {key} \"{value}\""), mend);
                // Rows of a table repeat the link of "in".
                if !faults.iter().any(|other: &LessonFault| other.what == fault.what) {
                    faults.push(fault);
                }
            }
        }
        faults
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_no_room_robot_or_algorithm_are_told_with_their_lines() {
        let known = KnownNames {
            rooms: "living, flat".to_owned(),
            robots: "roomba600".to_owned(),
            planners: "snake, boustrophedon".to_owned(),
            behaviours: "bounce".to_owned(),
        };
        let text = "# T\n```measure\nin: room=livng&robot=roomba600\nrow: A | planner=snak\nrow: B | behaviour=bounce\nshow: coverage\n```\n\
            ```do\nlabel: x\nlink: room=own&flat=7&behaviour=program&robot=hal9000\n```\n";
        let told: Vec<String> = Lesson::parse(text).unwrap().unknown(&known).iter().map(ToString::to_string).collect();
        assert_eq!(
            told,
            [
                "line 3: there is no room \"livng\"; did you mean \"living\"?",
                "line 4: there is no planner \"snak\"; did you mean \"snake\"?",
                "line 10: there is no robot \"hal9000\"; there are: roomba600",
            ]
        );
    }
}
