//! Display of the planner's search, on demand.

use super::Session;
use crate::{
    amount::grouped,
    explore::{
        FilmPicture, PlanSearch, SessionState, Showing,
        view::{FilmView, SearchView},
    },
};
use coverage_planners::{PlannerInfo, Proof, ShownSearch, TraceStep};
use robovac_sim::experiment::planning::MOST_SEARCH_CELLS;

impl Session {
    /// Shows or hides the planner's search. Time pauses when a film begins.
    pub fn show_search(&mut self, on: bool) {
        self.shows_search = on;
        // Nobody reads decisions in haste.
        if on && self.searcher().map(PlannerInfo::shown_search) == Some(ShownSearch::Decisions) {
            self.settings.speed = 1.0;
        }
        if let Some(film) = &mut self.film {
            film.rewind();
            film.hold(self.holds_films);
        }
        self.begin_film();
    }

    /// Nothing moves by itself, for users who prefer reduced motion: the run is paused, and films wait for
    /// [`Session::turn_film`].
    pub fn hold_motion(&mut self) {
        (self.holds_films, self.playing) = (true, false);
    }

    /// Pauses if there is a film to show.
    pub(super) fn begin_film(&mut self) {
        if self.shows_search && self.film.is_some() {
            self.pause();
        }
    }

    /// Shows the next picture of the film, or the previous one, and holds it.
    pub fn turn_film(&mut self, forward: bool) {
        self.pause();
        if let Some(film) = &mut self.film {
            film.turn(forward);
        }
    }

    /// Holds the film, or continues it; from the beginning if it was over.
    pub fn hold_film(&mut self, is_held: bool) {
        self.pause();
        if let Some(film) = &mut self.film {
            film.hold(is_held);
        }
    }

    pub(super) fn film_goes_on(&mut self, elapsed_s: f64) {
        if self.picture().is_some()
            && let Some(film) = &mut self.film
        {
            film.go_on(elapsed_s);
        }
        let at = self.picture().and(self.film.as_ref()).map(|film| film.place()[0]);
        if at != self.film_at {
            self.film_at = at;
            self.previews += 1;
        }
    }

    /// The current picture of the film; `None` while the robot drives.
    pub fn picture(&self) -> Option<&FilmPicture> {
        self.shown_film().filter(|_| !self.is_driving())?.picture()
    }

    /// The search as the page shows it.
    pub(super) fn search_view(&self) -> SearchView {
        let (refusal, fits_small) = self.search_refusal();
        SearchView {
            offered: self.offers_search(),
            on: self.shows_search && refusal.is_empty(),
            text: self.search_text(),
            refusal,
            fits_small,
            film: self.film_view(),
        }
    }

    /// Progress of the film.
    fn film_view(&self) -> Option<FilmView> {
        let film = self.shown_film()?;
        let [at, pictures] = film.place();
        let runs = !film.is_held() && !film.is_over() && !self.is_driving();
        Some(FilmView { at, pictures, runs })
    }

    fn shown_film(&self) -> Option<&Showing> {
        self.film.as_ref().filter(|_| self.shows_search)
    }

    fn is_driving(&self) -> bool {
        matches!(self.state(), SessionState::Playing | SessionState::Seeking)
    }

    /// The planner that plans, if it is one of ours.
    fn searcher(&self) -> Option<&'static PlannerInfo> {
        let algorithm = self.settings.algorithm;
        algorithm.planner().filter(|_| self.settings.path.is_none() && !algorithm.is_program())
    }

    /// Whether there is a search to show.
    pub fn offers_search(&self) -> bool {
        self.searcher().is_some()
    }

    /// Why the search can't be shown, and whether it could in a smaller room; empty if it can.
    fn search_refusal(&self) -> (String, bool) {
        let Some(planner) = self.searcher() else { return (String::new(), false) };
        let (most, shown) = match planner.shown_search() {
            ShownSearch::Film => (planner.most_filmed_cells(), "filmed"),
            ShownSearch::Decisions => (MOST_SEARCH_CELLS, "shown"),
        };
        let cells = self.prepared.as_ref().map_or(0, |prepared| prepared.job.cells());
        if cells <= most {
            return (String::new(), false);
        }
        let [most, cells] = [most, cells].map(grouped);
        (format!("The search is {shown} only in rooms of up to {most} planning cells; this one has {cells}."), true)
    }

    /// The decisions of the plan, if the planner traces them.
    pub fn search(&self) -> Option<&PlanSearch> {
        self.search.as_ref()
    }

    /// The decision that the robot is carrying out, if it is shown.
    pub fn decision(&self) -> Option<&TraceStep> {
        self.search().filter(|_| self.shows_search)?.decision(self.recording.as_ref()?.run())
    }

    /// The shown part of the search, in words.
    fn search_text(&self) -> String {
        let Some(planned) = self.planned.as_ref().filter(|_| self.shows_search && self.offers_search()) else {
            return String::new();
        };
        match (self.shown_film(), self.decision()) {
            (Some(film), _) if self.is_driving() && !film.is_over() => {
                "The film of the search is hidden while the robot drives. Pause to watch it.".to_owned()
            }
            (Some(_), _) if self.is_driving() => String::new(),
            (Some(film), _) => {
                let is_other = |own: Proof| planned.compared.is_some_and(|other| other.gap() > own.gap());
                let end = planned.proof.or(planned.compared);
                film.text(end.map(|proof| (proof, is_other(proof))))
            }
            // The numbers stand on the floor, and change before they are read.
            (None, Some(step)) if self.is_driving() => format!("{}.", without_numbers(&step.note)),
            (None, Some(step)) => format!("{}.", step.note),
            (None, None) if self.state() == SessionState::Finished => match &self.search {
                Some(search) => search.ending().map_or_else(
                    || "All cells are clean: the search is finished.".to_owned(),
                    |ending| format!("{}.", ending.note),
                ),
                None => String::new(),
            },
            (None, None) => String::new(),
        }
    }
}

/// A decision's words without what was counted and measured for it.
fn without_numbers(note: &str) -> String {
    let has_number = |part: &str| part.contains(|c: char| c.is_ascii_digit());
    let mut parts = note.split("; ");
    let first = parts.next().unwrap_or_default();
    let (head, between) = match first.split_once(": ").filter(|_| has_number(first)) {
        Some((head, _)) => (head, ": "),
        None => (first, "; "),
    };
    let rest: Vec<&str> = parts.filter(|part| !has_number(part)).collect();
    if rest.is_empty() { head.to_owned() } else { format!("{head}{between}{}", rest.join("; ")) }
}

#[cfg(test)]
mod tests {
    use super::without_numbers;

    #[test]
    fn what_is_said_while_the_robot_drives_is_short() {
        for (note, short) in [
            ("Farthest from the goal: 71 on the right, 61 below; straight on", "Farthest from the goal: straight on"),
            (
                "Left and right equal; cells to clean: 5 above, 7 below; smaller block: up",
                "Left and right equal; smaller block: up",
            ),
            (
                "To point 5, the wall on its left: 7 steps around it; collision 3, 2 resolved",
                "To point 5, the wall on its left",
            ),
            ("To point 5, the wall on its left", "To point 5, the wall on its left"),
            ("The only way: straight on", "The only way: straight on"),
        ] {
            assert_eq!(without_numbers(note), short);
        }
    }
}
