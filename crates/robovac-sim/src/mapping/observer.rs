//! Mapping during a run.

use super::{Mapper, ThesisMap, locate::Locator};
use crate::{
    Run, RunObserver,
    controller::{Controller, Intent, clean_by_map},
};
use robovac_core::{
    geometry::{Pose, difference},
    robot::{Odometry, OdometryModel, RobotModel, SensorReadings},
};

/// Makes maps and estimates poses during a run, independently of its controller, and can clean by its map.
#[derive(Clone, Default)]
pub struct MapObserver {
    mapper: Option<Box<Mapper>>,
    baseline: Option<Box<Mapper>>,
    locator: Option<Box<Locator>>,
    thesis: Option<Box<ThesisMap>>,
    reckoned: Vec<Odometry>,
}

impl MapObserver {
    /// Adds a mapper. A controller with its own mapper uses that.
    pub fn with_mapper(self, mapper: Mapper) -> Self {
        Self { mapper: Some(Box::new(mapper)), ..self }
    }

    /// Adds a second mapper for comparison, which doesn't affect the run.
    pub fn with_baseline(self, mapper: Mapper) -> Self {
        Self { baseline: Some(Box::new(mapper)), ..self }
    }

    /// Adds a locator on a known map.
    pub fn with_locator(self, locator: Locator) -> Self {
        Self { locator: Some(Box::new(locator)), ..self }
    }

    /// Adds the thesis' grid, for comparison.
    pub fn with_thesis(self, thesis: ThesisMap) -> Self {
        Self { thesis: Some(Box::new(thesis)), ..self }
    }

    /// Adds dead reckoning by all models from `start`, for comparison.
    pub fn with_reckoning(self, robot: &RobotModel, start: Pose) -> Self {
        Self { reckoned: OdometryModel::ALL.map(|(model, _)| Odometry::new(robot, model, start)).into(), ..self }
    }
}

impl RunObserver for MapObserver {
    fn observe(&mut self, sensed: &SensorReadings) {
        for mapper in [&mut self.mapper, &mut self.baseline].into_iter().flatten() {
            mapper.update(sensed);
        }
        for odometry in &mut self.reckoned {
            odometry.update(sensed);
        }
        if let Some(locator) = &mut self.locator {
            locator.update(sensed);
        }
        if let Some(thesis) = &mut self.thesis {
            thesis.update(sensed);
        }
    }

    fn estimate(&self, driver: &dyn Controller) -> Option<Pose> {
        driver.mapper().or(self.mapper.as_deref()).map(Mapper::pose)
    }

    fn cleaner(&mut self, planner: &'static str, driver: &dyn Controller) -> Option<Box<dyn Controller>> {
        // A given map takes precedence over the behaviour's own.
        let mut mapper = self.mapper.take().map(|mapper| *mapper).or_else(|| driver.mapper().cloned())?;
        if let Some(locator) = self.locator.take().filter(|locator| locator.is_sure())
            && let Some((pose, spread)) = locator.pose().zip(locator.pose_covariance())
        {
            mapper.relocate(pose, &spread);
        }
        Some(clean_by_map(mapper, planner))
    }

    fn bytes(&self) -> usize {
        let mappers: usize = [&self.mapper, &self.baseline].into_iter().flatten().map(|mapper| mapper.bytes()).sum();
        mappers + self.thesis.as_ref().map_or(0, |thesis| thesis.bytes())
    }

    fn boxed_clone(&self) -> Box<dyn RunObserver> {
        Box::new(self.clone())
    }
}

/// The map and estimates of a run with a [`MapObserver`], or with a controller that has a mapper.
impl Run {
    /// The robot's mapper.
    pub fn mapper(&self) -> Option<&Mapper> {
        self.controller().mapper().or_else(|| self.observer::<MapObserver>()?.mapper.as_deref())
    }

    /// The second mapper's estimates.
    pub fn baseline(&self) -> Option<&Mapper> {
        self.observer::<MapObserver>()?.baseline.as_deref()
    }

    /// The thesis' grid.
    pub fn thesis(&self) -> Option<&ThesisMap> {
        self.observer::<MapObserver>()?.thesis.as_deref()
    }

    /// The locator on a known map.
    pub fn locator(&self) -> Option<&Locator> {
        self.observer::<MapObserver>()?.locator.as_deref()
    }

    /// Errors of dead reckoning, in the order of [`OdometryModel::ALL`]: m and rad; empty if not enabled.
    pub fn drifts(&self) -> Vec<[f64; 2]> {
        let truth = self.pose();
        let off =
            |pose: Pose| [(pose.position() - truth.position()).norm(), difference(truth.heading, pose.heading).abs()];
        let reckoned = self.observer::<MapObserver>().map_or(&[][..], |observer| &observer.reckoned);
        reckoned.iter().map(|odometry| off(odometry.pose())).collect()
    }

    /// Its controller's goal on its map.
    pub fn intent(&self) -> Option<Intent<'_>> {
        self.controller().intent()
    }
}
