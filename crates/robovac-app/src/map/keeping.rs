//! Storing and restoring of the Map tab.

use super::{Known, MapSession, StoreError, Stored, stage::Return};
use robovac_sim::{RunRecording, STEP_S};

impl MapSession {
    /// The session as text for [`MapSession::resume`]; `None` if there is nothing worth storing.
    pub fn store(&self) -> Option<String> {
        let stage = self.stage.as_ref().filter(|stage| stage.returning.is_none())?;
        let run = stage.run();
        let end = (stage.recording.end_s() / STEP_S).round() as u64;
        let estimate = self.estimate().filter(|_| end > 0)?;
        let stored = Stored {
            recipe: self.recipe(),
            title: self.base.as_ref().map_or(String::new(), |base| base.title.clone()),
            end,
            shown: run.steps(),
            digest: run.digest(),
            inputs: stage.recording.inputs().to_vec(),
            pose: estimate.pose().or_else(|| run.estimate())?,
            map: estimate.map.clone(),
            marks: estimate.marks.clone(),
            known: stage.known.as_ref().map(|known| (known.name().to_owned(), known.map().clone())),
            program: self.driver_name(),
            docks: stage.known.as_ref().map_or(Vec::new(), |known| known.docks().to_vec()),
        };
        Some(stored.to_text())
    }

    /// Restores a session stored by [`MapSession::store`]. Its map is there at once; the following frames simulate the
    /// run again. Changes nothing on an error.
    pub fn resume(&mut self, text: &str) -> Result<(), StoreError> {
        let stored = Stored::from_text(text)?;
        let robot = self.prepared().map(|prepared| &prepared.robot);
        let known = match (&stored.known, robot) {
            (Some((name, map)), Some(robot)) => {
                let of_no_use = |_| StoreError::Damaged { what: "the robot can't localise on the given map" };
                Some(Known::of(map.clone(), stored.docks.clone(), name.clone(), robot).map_err(of_no_use)?)
            }
            _ => None,
        };
        if stored.recipe != self.recipe_on(known.as_ref()) {
            // All but the program can be the same.
            let others = |recipe: &str| {
                recipe.split(' ').filter(|part| !part.starts_with("program=")).map(str::to_owned).collect::<Vec<_>>()
            };
            let is_same = others(&stored.recipe) == others(&self.recipe_on(known.as_ref()));
            return Err(match stored.program.filter(|_| is_same) {
                Some(name) => StoreError::Program { name },
                None => StoreError::Another { title: stored.title },
            });
        }
        self.program.restart();
        self.landing = None;
        let Some(mut stage) = self.new_stage(known.clone()) else { return Ok(()) };
        self.known = known;
        stage.recording = stage.recording.with_inputs(stored.inputs.clone());
        stage.returning = Some(Return::to(stored));
        self.stage = Some(stage);
        self.playing = false;
        self.version += 1;
        Ok(())
    }

    /// Whether the last restored run ended in another state, reported once: another version of the program simulates
    /// differently. The stored map remains valid.
    pub fn take_strayed(&mut self) -> bool {
        std::mem::take(&mut self.has_strayed)
    }

    /// The run from its start again, and the time up to which it was simulated, s; `None` if the robot doesn't fit.
    pub fn again(&self) -> Option<(RunRecording, f64)> {
        let stage = self.stage.as_ref()?;
        let end_s = stage.returning.as_ref().map_or(stage.recording.end_s(), |way| way.end as f64 * STEP_S);
        Some((stage.recording.again(), end_s))
    }

    /// Progress of restoring a run, 0 to 1; `None` if none is being restored.
    pub fn returned(&self) -> Option<f64> {
        let stage = self.stage.as_ref()?;
        Some(stage.run().steps() as f64 / stage.returning.as_ref()?.end.max(1) as f64)
    }
}
