//! The planner's search, on demand.

use super::Session;
use crate::{
    app::{MOST_FILMED_CELLS, MOST_SEARCH_CELLS, Search, State},
    planner::TraceStep,
};

impl Session {
    /// Shows the planner's decisions from now on, or no longer.
    pub fn show_search(&mut self, on: bool) {
        self.shows_search = on;
        if let Some(film) = &mut self.film {
            film.rewind();
            self.previews += 1;
        }
    }

    /// Whether the planner can say what it decides.
    pub fn offers_search(&self) -> bool {
        self.settings.algorithm.planner().is_some_and(|planner| planner.claims.traces || planner.claims.anytime)
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
        if is_shown && let Some(film) = &self.film {
            return film.text(self.planned.as_ref().and_then(|planned| planned.proof));
        }
        match (self.decision(), &self.prepared) {
            _ if !is_shown => String::new(),
            (Some(step), _) => format!("{}.", step.note),
            (None, _) if self.planned.as_ref().is_some_and(|planned| planned.is_cut_short) => {
                "The search was stopped before its end, so there is no record of it. Plan again to see it.".to_owned()
            }
            (None, Some(prepared)) if self.search.is_none() => {
                let (cells, planner) = (prepared.job.cells(), self.settings.algorithm.planner());
                let is_filmed = planner.is_some_and(|planner| planner.claims.anytime);
                let most = if is_filmed { MOST_FILMED_CELLS } else { MOST_SEARCH_CELLS };
                format!("The search is shown in rooms of up to {most} cells; this one has {cells}.")
            }
            (None, _) if self.state() == State::Finished => "All cells are clean: the search is over.".to_owned(),
            (None, _) => String::new(),
        }
    }
}
