//! Runs and paths as MCAP bags with ROS 2 messages.

use super::SavedPath;
use crate::{explore::Session, map::MapSession};
use robovac_core::{floor_plan::FloorPlan, geometry::Pose, robot::RobotModel};
use robovac_ros::{Bag, BagError, Pace, RunTopics, SourceMap, file_of, path_topics};
use robovac_sim::{Input, RunRecording, STEP_S, controller::Joystick, experiment::planning::PathToDrive};
use std::io::Cursor;

/// Media type of bags.
pub const BAG_TYPE: &str = "application/x-mcap";
/// Numbers of an input in [`RunBag::inputs_to_numbers`].
const INPUT_NUMBERS: usize = 5;

/// A run that is simulated again, as runs are not stored, and written as a bag meanwhile.
pub struct RunBag {
    recording: RunRecording,
    end: u64,
    topics: RunTopics,
    bag: Bag<Cursor<Vec<u8>>>,
}

impl RunBag {
    /// The run of a session that has the room and settings of the original one: along `driven` for a planner,
    /// with a person's inputs, up to `end_s`. `None` if the robot doesn't fit.
    pub fn of_session(
        session: &Session,
        driven: &PathToDrive,
        inputs: Vec<(u64, Input)>,
        end_s: f64,
    ) -> Result<Option<Self>, BagError> {
        let (Some(prepared), Some(run)) = (session.prepared(), session.new_run(driven)) else { return Ok(None) };
        let recording = RunRecording::within(run, 0).with_inputs(inputs);
        let source = SourceMap {
            plan: session.plan(),
            robot: &prepared.robot,
            path: &driven.line,
            smooth: driven.smooth.as_deref(),
        };
        Self::new(&source, recording, end_s).map(Some)
    }

    /// The run of a session of the Map tab, as far as it was simulated; `None` without one.
    pub fn of_mapping(session: &MapSession) -> Result<Option<Self>, BagError> {
        let (Some(plan), Some(prepared)) = (session.plan(), session.prepared()) else { return Ok(None) };
        let Some((recording, end_s)) = session.again() else { return Ok(None) };
        let source = SourceMap { plan, robot: &prepared.robot, path: &[], smooth: None };
        Self::new(&source, recording, end_s).map(Some)
    }

    fn new(source: &SourceMap<'_>, recording: RunRecording, end_s: f64) -> Result<Self, BagError> {
        let topics = RunTopics::new(source, recording.run(), Pace::FILE);
        let bag = Bag::new(Cursor::new(Vec::new()), "")?;
        Ok(Self { recording, end: (end_s / STEP_S).round() as u64, topics, bag })
    }

    /// Simulates to the end; the bytes of the bag, and the digest of the run's last state.
    pub fn finish(mut self) -> Result<(Vec<u8>, u64), BagError> {
        self.bag.put_all(self.topics.take())?;
        while self.recording.run().steps() < self.end && !self.recording.is_over() && !self.recording.run().waits() {
            self.recording.step();
            self.topics.step(self.recording.run());
            self.bag.put_all(self.topics.take())?;
        }
        self.topics.finish(self.recording.run());
        self.bag.put_all(self.topics.take())?;
        Ok((self.bag.finish()?.into_inner(), self.recording.run().digest()))
    }

    /// Inputs of a run as numbers, to be passed between modules; without cleaning by a map, which has a name in it.
    pub fn inputs_to_numbers(inputs: &[(u64, Input)]) -> Vec<f64> {
        let numbers = |&(step, input): &(u64, Input)| {
            let [kind, a, b, c] = match input {
                Input::Command(Joystick { forward, left }) => [0.0, forward, left, 0.0],
                Input::Lift => [1.0, 0.0, 0.0, 0.0],
                Input::PutDown(Pose { x, y, heading }) => [2.0, x, y, heading],
                Input::Clean(_) => return None,
            };
            Some([step as f64, kind, a, b, c])
        };
        inputs.iter().filter_map(numbers).flatten().collect()
    }

    /// The inverse of [`RunBag::inputs_to_numbers`].
    pub fn inputs_from_numbers(numbers: &[f64]) -> Vec<(u64, Input)> {
        let input = |numbers: &[f64]| match *numbers {
            [step, 0.0, forward, left, _] => Some((step as u64, Input::Command(Joystick { forward, left }))),
            [step, 1.0, ..] => Some((step as u64, Input::Lift)),
            // As it was, to the last bit.
            [step, 2.0, x, y, heading] => Some((step as u64, Input::PutDown(Pose { x, y, heading }))),
            _ => None,
        };
        numbers.chunks_exact(INPUT_NUMBERS).filter_map(input).collect()
    }
}

/// A planned path with its room as a bag.
pub fn path_bag(plan: &FloorPlan, robot: &RobotModel, path: SavedPath<'_>) -> Result<Vec<u8>, BagError> {
    let SavedPath { corners, heading, smooth } = path;
    file_of(path_topics(&SourceMap { plan, robot, path: corners, smooth }, heading))
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::geometry::Pose;
    use robovac_sim::experiment::planning::Planned;

    /// A session that was driven for a while, lifted, put down and driven on; and the digest of its state.
    fn driven(link: &str) -> (Session, f64, u64) {
        let mut session = Session::new();
        session.restore(link).unwrap();
        session.plan_now(|| 0.0);
        session.run_ahead(5.0);
        session.lift();
        session.run_ahead(0.6);
        session.put_down(Pose::new(1.1, 1.2, 0.3));
        session.run_ahead(5.0);
        let run = session.recording().unwrap().run();
        let (end_s, digest) = (run.time_s(), run.digest());
        (session, end_s, digest)
    }

    #[test]
    fn the_bag_of_a_run_is_of_that_very_run() {
        let planned = "room=bedroom&planner=boustrophedon&slip=typical";
        let links = ["room=bedroom&behaviour=bounce&slip=typical", planned, &format!("{planned}&smooth=true")];
        for link in links {
            let (session, end_s, digest) = driven(link);
            let path = session.planned().map_or(PathToDrive::default(), Planned::driven);
            assert_eq!(path.smooth.is_some(), link.contains("smooth"), "{link}");
            let numbers = RunBag::inputs_to_numbers(session.recording().unwrap().inputs());
            let inputs = RunBag::inputs_from_numbers(&numbers);
            assert_eq!(inputs, session.recording().unwrap().inputs());
            // Another session, as in a worker: it has no plan.
            let mut other = Session::new();
            other.follow(&session.snapshot()).unwrap();
            let (bytes, found) = RunBag::of_session(&other, &path, inputs, end_s).unwrap().unwrap().finish().unwrap();
            assert_eq!(found, digest, "{link}");
            assert!(bytes.starts_with(b"\x89MCAP0") && bytes.len() > 50_000, "{link}: {} bytes", bytes.len());
        }
    }

    #[test]
    fn the_bag_of_a_mapping_run_is_of_that_very_run() {
        let mut session = Session::new();
        session.restore("room=bedroom").unwrap();
        let mut mapping = MapSession::new();
        mapping.take(&session);
        mapping.set("explorer", "wall_follow").unwrap();
        mapping.run_ahead(8.0);
        let mut other = MapSession::new();
        other.take(&session);
        other.restore(&mapping.setup().to_link()).unwrap();
        other.resume(&mapping.store().unwrap()).unwrap();
        let (_, digest) = RunBag::of_mapping(&other).unwrap().unwrap().finish().unwrap();
        assert_eq!(digest, mapping.run().unwrap().digest());
    }
}
