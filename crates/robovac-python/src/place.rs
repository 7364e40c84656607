//! Room, robot and start.

use crate::{failure::Failure, room::Room};
use pyo3::prelude::*;
use robovac_core::{
    grid::Cell,
    registry::{ParamSpec, Params},
};
use robovac_sim::experiment::planning::{GivenStart, Placement, choose_robot};

/// A robot in a room, as arguments.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct PlaceArguments {
    room: Py<Room>,
    robot: String,
    cell_m: Option<f64>,
    start: Option<(i32, i32)>,
    heading_deg: Option<f64>,
}

impl PlaceArguments {
    /// With every name looked up.
    pub fn placement(&self) -> Result<Placement, Failure> {
        let plan = &self.room.get().plan;
        let chosen = choose_robot(&self.robot, plan, self.cell_m);
        let (robot, cell_size) = chosen.ok_or_else(|| Failure::unknown("robot", &self.robot, "robots"))?;
        let start = self.start.map(|(x, y)| GivenStart::Cell(Cell::new(x, y)));
        Ok(Placement { plan: (**plan).clone(), robot, cells: cell_size.into(), start, heading_deg: self.heading_deg })
    }
}

/// Values for all of `specs`, each parsed by its kind.
pub fn checked(specs: &[ParamSpec], given: &[(String, String)]) -> Result<Params, Failure> {
    let mut params = Params::defaults(specs);
    for (id, text) in given {
        params.set_text(specs, id, text)?;
    }
    Ok(params)
}
