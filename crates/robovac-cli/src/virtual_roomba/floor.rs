//! The virtual Roomba's room: the user's, or a bare one with a wall or drop-off ahead.

use crate::{failure::Failure, source::load_with_image};
use robovac_core::{
    floor_plan::{FloorPlan, Object, Sketch, room},
    geometry::Point,
};
use robovac_sim::{
    Conditions, RunSetup,
    experiment::planning::{Placement, choose_robot},
};
use std::path::PathBuf;

/// Width of the bare room, and its length unless something ahead makes it longer, m.
const ROOM: (f64, f64) = (4.0, 6.0);
/// Distance of the start from the wall behind it, m.
const START: f64 = 1.0;
/// Depth of a drop-off or of the furniture that stands for a wall, m.
const DEPTH: f64 = 0.5;
/// The robot's id.
const ROOMBA: &str = "roomba600";

/// The room, and what is ahead.
#[derive(clap::Args)]
pub struct FloorArguments {
    /// Map file: text of # and ., PNG, PGM, ROS map or scenario [default: a bare room with 5 m of floor ahead]
    #[arg(long, value_name = "FILE", conflicts_with = "room")]
    map: Option<PathBuf>,
    /// Built-in room, see "robovac rooms"
    #[arg(long, value_name = "ID")]
    room: Option<String>,
    /// Put a wall across the bare room, this many metres ahead of the robot's centre
    #[arg(long, value_name = "M", value_parser = parse_distance, conflicts_with_all = ["map", "room", "cliff_at"])]
    wall_at: Option<f64>,
    /// End the floor of the bare room this many metres ahead of the robot's centre
    #[arg(long, value_name = "M", value_parser = parse_distance, conflicts_with_all = ["map", "room"])]
    cliff_at: Option<f64>,
}

impl FloorArguments {
    /// The robot at its start.
    pub fn setup(&self, conditions: Conditions, seed: u64) -> Result<RunSetup, Failure> {
        let plan = self.plan()?;
        let (robot, cell_size) =
            choose_robot(ROOMBA, &plan, None).ok_or_else(|| Failure::unknown("robot", ROOMBA, "robots"))?;
        let prepared = Placement { plan, robot, cells: cell_size.into(), start: None, heading_deg: None }.prepare()?;
        Ok(prepared.setup(conditions, seed))
    }

    fn plan(&self) -> Result<FloorPlan, Failure> {
        if let Some(path) = &self.map {
            return load_with_image(path);
        }
        if let Some(id) = &self.room {
            return room(id).map(|info| (info.build)()).ok_or_else(|| Failure::unknown("room", id, "rooms"));
        }
        let ahead = self.wall_at.or(self.cliff_at).unwrap_or(0.0);
        let (width, length) = (ROOM.0, ROOM.1.max(START + ahead + 2.0 * DEPTH));
        let across = |ahead: f64| {
            let x = START + ahead;
            [(x, 0.0), (x + DEPTH, 0.0), (x + DEPTH, width), (x, width)].map(|(x, y)| Point::new(x, y)).to_vec()
        };
        let mut plan = Sketch::open(length, width, 0.05).start(START, 0.5 * width, 0.0).finish("Bare room", "");
        plan.objects.extend(self.wall_at.map(|at| Object::Furniture { outline: across(at) }));
        plan.objects.extend(self.cliff_at.map(|at| Object::DropOff { outline: across(at) }));
        Ok(plan)
    }
}

fn parse_distance(text: &str) -> Result<f64, String> {
    let metres = text.parse().ok().filter(|metres| (0.25..=20.0).contains(metres));
    metres.ok_or_else(|| "use 0.25 to 20 metres: the robot itself extends 0.17 m ahead of its centre".to_owned())
}
