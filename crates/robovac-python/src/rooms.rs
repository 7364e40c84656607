//! The rooms of a training, laid out when they are needed.

use crate::{failure::Failure, room::Room};
use pyo3::prelude::*;
use rand::RngExt;
use robovac_core::{
    floor_plan::{
        FloorPlan,
        generate::{FlatSpec, generate_flat},
    },
    rng::Rng,
    robot::RobotModel,
};
use robovac_sim::learning::EpisodeRoom;
use std::sync::{Arc, Mutex, PoisonError, Weak};

/// Rooms that stay laid out although no robot is in them: a large one takes megabytes.
const KEPT: usize = 64;

/// Where rooms come from.
pub enum Source {
    /// These.
    Given(Vec<Arc<FloorPlan>>),
    /// Generated flats of a kind, from this seed on.
    Flats(u64, FlatSpec),
}

/// Rooms, and those of them that are laid out.
pub struct Rooms {
    source: Source,
    laid: Vec<Mutex<Weak<EpisodeRoom>>>,
    kept: Mutex<Vec<Arc<EpisodeRoom>>>,
}

impl Rooms {
    /// Given rooms; the first that the robot doesn't fit into is an error.
    pub fn given(rooms: &[Py<Room>], robot: &RobotModel) -> Result<Self, Failure> {
        let plans: Vec<Arc<FloorPlan>> = rooms.iter().map(|room| Arc::clone(&room.get().plan)).collect();
        if plans.is_empty() {
            return Err(Failure::usage("rooms: give at least one room".to_owned()));
        }
        let rooms = Self::new(plans.len(), Source::Given(plans));
        // Now, as an error in the middle of a training comes too late.
        for index in 0..rooms.laid.len() {
            rooms.lay_out(index, robot)?;
        }
        Ok(rooms)
    }

    /// So many generated flats, from the seed `first` on.
    pub fn flats(count: usize, first: u64, spec: FlatSpec) -> Result<Self, Failure> {
        if count == 0 {
            return Err(Failure::usage("flats can't be 0; use at least 1".to_owned()));
        }
        spec.check().map_err(|error| Failure::usage(error.to_string()))?;
        Ok(Self::new(count, Source::Flats(first, spec)))
    }

    fn new(count: usize, source: Source) -> Self {
        Self { source, laid: (0..count).map(|_| Mutex::new(Weak::new())).collect(), kept: Mutex::new(Vec::new()) }
    }

    /// One of them by chance, and its number.
    pub fn choose(&self, robot: &RobotModel, rng: &mut Rng) -> Result<(usize, Arc<EpisodeRoom>), Failure> {
        let index = rng.random_range(0..self.laid.len());
        Ok((index, self.lay_out(index, robot)?))
    }

    /// What users know a room by: its name, or the seed of a generated flat.
    pub fn name(&self, index: usize) -> (Option<String>, Option<u64>) {
        match &self.source {
            Source::Given(plans) => (plans.get(index).map(|plan| plan.name.clone()), None),
            Source::Flats(first, _) => (None, Some(first.wrapping_add(index as u64))),
        }
    }

    fn lay_out(&self, index: usize, robot: &RobotModel) -> Result<Arc<EpisodeRoom>, Failure> {
        let mut laid = self.laid[index].lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(room) = laid.upgrade() {
            return Ok(room);
        }
        let room = Arc::new(self.make(index, robot)?);
        *laid = Arc::downgrade(&room);
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        if kept.len() == KEPT {
            kept.remove(0);
        }
        kept.push(Arc::clone(&room));
        Ok(room)
    }

    fn make(&self, index: usize, robot: &RobotModel) -> Result<EpisodeRoom, Failure> {
        let lay_out = |plan: &FloorPlan| {
            let laid = EpisodeRoom::new(plan, robot);
            laid.map_err(|error| Failure::misfit(format!("room \"{}\": {error}", plan.name)))
        };
        match &self.source {
            Source::Given(plans) => lay_out(&plans[index]),
            Source::Flats(first, spec) => lay_out(&generate_flat(first.wrapping_add(index as u64), spec)),
        }
    }
}
