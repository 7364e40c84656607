//! The planner's search, on demand.

use super::Session;
use crate::{
    app::{MOST_SEARCH_CELLS, Search, State},
    planner::TraceStep,
};

impl Session {
    /// Shows the planner's decisions from now on, or no longer.
    pub fn show_search(&mut self, on: bool) {
        self.shows_search = on;
    }

    /// Whether the planner can say what it decides.
    pub fn offers_search(&self) -> bool {
        self.settings.algorithm.planner().is_some_and(|planner| planner.claims.traces)
    }

    /// The decisions behind the plan, if the planner tells them.
    pub fn search(&self) -> Option<&Search> {
        self.search.as_ref()
    }

    /// The decision that the robot is carrying out, if it is to be shown.
    pub fn decision(&self) -> Option<&TraceStep> {
        self.search().filter(|_| self.shows_search)?.decision(self.recording.as_ref()?.run())
    }

    /// The decision in words, or why there is none.
    pub(super) fn search_text(&self) -> String {
        let is_shown = self.shows_search && self.planned.is_some() && self.offers_search();
        match (self.decision(), &self.prepared) {
            _ if !is_shown => String::new(),
            (Some(step), _) => format!("{}.", step.note),
            (None, _) if self.is_cut_short => {
                "The search was stopped before its end, so there is no record of it. Plan again to see it.".to_owned()
            }
            (None, Some(prepared)) if self.search.is_none() => {
                let cells = prepared.job.cells();
                format!("The search is shown in rooms of up to {MOST_SEARCH_CELLS} cells; this one has {cells}.")
            }
            (None, _) if self.state() == State::Finished => "All cells are clean: the search is over.".to_owned(),
            (None, _) => String::new(),
        }
    }
}
