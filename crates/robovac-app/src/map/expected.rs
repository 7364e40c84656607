//! What robots with nothing but a bumper can be expected to map.

use super::MapSession;
use robovac_core::robot::RobotModel;

/// Medians of 20 runs (seeds 101 to 120) of 20 minutes along the walls of the furnished flat, with typical slip and noise:
/// `robovac map --room flat --robot ID --minutes 20 --seeds 20 --seed 101 --slip typical --noise typical`.
#[derive(Debug, Clone, Copy)]
pub struct ByBumper {
    /// The robot.
    pub robot: &'static str,
    /// Error of the position at the end, m: corrected, and by odometry alone.
    pub position_m: [f64; 2],
    /// Share of the boundary on the corrected map.
    pub boundary: f64,
}

/// All robots that sense their surroundings by contacts alone. A test measures them again.
pub const BY_BUMPER: [ByBumper; 3] = [
    ByBumper { robot: "dvr1", position_m: [0.08, 0.95], boundary: 0.18 },
    ByBumper { robot: "octagon", position_m: [2.3, 2.5], boundary: 0.01 },
    ByBumper { robot: "cell", position_m: [0.27, 1.8], boundary: 0.16 },
];

impl MapSession {
    /// What to expect of the maps of the chosen robot, if it has nothing but a bumper, or lacks what the method needs.
    pub fn expectation(&self) -> Option<String> {
        let robot = &self.prepared()?.robot;
        if self.setup().behaviour.claims.needs_laser && robot.sensors.laser.is_none() {
            return Some(NO_LASER.to_owned());
        }
        expectation(robot)
    }
}

/// Said of a method that needs a laser scanner, for a robot without one.
const NO_LASER: &str = "This method needs a laser scanner, which this robot lacks: it won't drive. Choose the CBot or the \
                        Roomba 600 with laser.";

fn expectation(robot: &RobotModel) -> Option<String> {
    let ByBumper { position_m: [corrected, odometry], boundary, .. } =
        *BY_BUMPER.iter().find(|measured| measured.robot == robot.id)?;
    let length = |m: f64| if m < 1.0 { format!("{:.0} cm", 100.0 * m) } else { format!("{m:.1} m") };
    let verdict = if corrected > 0.5 * odometry {
        "Drift isn't corrected"
    } else {
        "Drift is corrected only where the robot follows walls"
    };
    Some(format!(
        "This robot has nothing but a bumper. {verdict}: after 20 min along the walls of the furnished flat it was {} off \
         ({} by odometry alone), with {:.0} % of the boundary mapped.",
        length(corrected),
        length(odometry),
        100.0 * boundary
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::{MODELS, model};

    #[test]
    fn every_robot_with_nothing_but_a_bumper_has_its_figures() {
        for robot in MODELS {
            let senses = &robot.sensors;
            let is_alone = senses.bumper.is_some() && senses.light_bumper.is_none() && senses.laser.is_none();
            assert_eq!(expectation(robot).is_some(), is_alone, "{}", robot.id);
        }
        let text = expectation(model("octagon").unwrap()).unwrap();
        assert!(text.contains("Drift isn't corrected") && text.contains("2.3 m off"), "{text}");
        assert!(expectation(model("dvr1").unwrap()).unwrap().contains("8 cm off (95 cm by odometry alone)"));
    }
}
