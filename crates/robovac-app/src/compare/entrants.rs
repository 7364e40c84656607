//! The entrants of a comparison, and which of them were chosen.

use super::{differing::differing, race::MOST_LANES};
use coverage_planners::PLANNERS;
use robovac_core::{
    program::{Program, ProgramKind},
    registry::Params,
    robot::RobotModel,
};
use robovac_sim::experiment::{Algorithm, BEHAVIOUR, Entrant, PLANNER, SettingsError};
use std::{collections::BTreeSet, sync::Arc};

/// Most copies of entrants.
const MOST_COPIES: usize = 16;
/// Planners that are selected at first.
const FIRST: [&str; 4] = ["boustrophedon", "snake", "spiral_stc", "wavefront_path"];

/// Name of an algorithm for users: the user's program has its own.
pub(super) fn titled(algorithm: Algorithm, program: Option<&Program>) -> String {
    let title = algorithm.title();
    program.map_or_else(|| title.to_owned(), |program| format!("{title}: {}", program.name))
}

/// What a robot lacks for an algorithm to do anything; empty if nothing.
pub(super) fn lacking(algorithm: Algorithm, robot: &RobotModel) -> &'static str {
    let is_blind = algorithm.behaviour().is_some_and(|info| info.claims.needs_laser) && robot.sensors.laser.is_none();
    if is_blind { "needs a laser scanner" } else { "" }
}

/// Every entrant has a number, which stays.
#[derive(Clone)]
pub(super) struct Entrants {
    /// One for each planner of the registry and each behaviour that cleans by itself, in their order; those of the user's
    /// program, as a planner and as a behaviour; then copies with other parameters.
    all: Vec<Entrant>,
    /// Number of those before the copies.
    originals: usize,
    /// Copies that were removed; their numbers are used again.
    removed: BTreeSet<usize>,
    /// In the order in which they were chosen.
    chosen: Vec<usize>,
    /// Those of them that were taken out of the race.
    benched: BTreeSet<usize>,
    /// The user's program.
    program: Option<Arc<Program>>,
    robot: Option<RobotModel>,
}

impl Entrants {
    pub fn new() -> Self {
        let planners = PLANNERS.iter().map(|planner| Algorithm::Planner(planner));
        let cleans =
            |algorithm: &Algorithm| algorithm.behaviour().is_some_and(|info| info.claims.cleans && !info.claims.manual);
        let programs = [ProgramKind::Planner, ProgramKind::Behaviour].map(Algorithm::of_program);
        let all = planners.chain(Algorithm::all().filter(cleans)).chain(programs);
        let all: Vec<Entrant> = all.map(Entrant::new).collect();
        Self {
            originals: all.len(),
            chosen: (0..PLANNERS.len()).filter(|&i| FIRST.contains(&all[i].id())).collect(),
            all,
            removed: BTreeSet::new(),
            benched: BTreeSet::new(),
            program: None,
            robot: None,
        }
    }

    pub fn set_program(&mut self, program: Option<Arc<Program>>) {
        self.program = program;
    }

    pub fn set_robot(&mut self, robot: RobotModel) {
        self.robot = Some(robot);
    }

    pub fn all(&self) -> &[Entrant] {
        &self.all
    }

    pub fn get(&self, entrant: usize) -> &Entrant {
        &self.all[entrant]
    }

    // ---- choices

    pub fn choose(&mut self, entrant: usize, takes_part: bool) {
        self.chosen.retain(|&other| other != entrant);
        self.benched.remove(&entrant);
        if takes_part && entrant < self.all.len() && !self.removed.contains(&entrant) {
            self.chosen.push(entrant);
        }
    }

    pub fn set_param(&mut self, entrant: usize, id: &str, text: &str) -> Result<(), SettingsError> {
        self.all.get_mut(entrant).map_or(Ok(()), |entrant| entrant.set(id, text))
    }

    /// Chooses an entrant once more, to be given other parameters. Does nothing beyond the largest number of copies.
    pub fn copy(&mut self, entrant: usize) {
        let original = self.all.get(entrant).filter(|entrant| !entrant.algorithm.is_program()).cloned();
        let copy = original.and_then(|original| self.add_copy(original));
        self.chosen.extend(copy);
    }

    fn add_copy(&mut self, original: Entrant) -> Option<usize> {
        if let Some(index) = self.removed.pop_first() {
            self.all[index] = original;
            return Some(index);
        }
        (self.all.len() < self.originals + MOST_COPIES).then(|| {
            self.all.push(original);
            self.all.len() - 1
        })
    }

    pub fn remove_copy(&mut self, entrant: usize) {
        if self.copy_number(entrant) > 1 {
            self.removed.insert(entrant);
            self.choose(entrant, false);
        }
    }

    /// Lets a chosen entrant race, or takes it out of the race. With [`MOST_LANES`] in it, the last of them leaves.
    pub fn set_racing(&mut self, entrant: usize, races: bool) {
        if !self.chosen.contains(&entrant) {
            return;
        }
        if races {
            self.benched.remove(&entrant);
            self.chosen.retain(|&other| other != entrant);
            let racing = self.chosen.iter().enumerate().filter(|(_, other)| !self.benched.contains(other));
            let last = racing.map(|(place, _)| place).nth(MOST_LANES - 1).unwrap_or(self.chosen.len());
            self.chosen.insert(last, entrant);
        } else {
            self.benched.insert(entrant);
        }
    }

    // ---- what takes part

    pub fn is_chosen(&self, entrant: usize) -> bool {
        self.chosen.contains(&entrant)
    }

    pub fn is_behaviour(&self, entrant: usize) -> bool {
        self.all[entrant].algorithm.behaviour().is_some()
    }

    /// Whether an entrant can take part: the user's program only if there is one of its kind.
    fn is_there(&self, entrant: usize) -> bool {
        let Some(entrant) = self.all.get(entrant) else { return false };
        !entrant.algorithm.is_program() || self.program_of(entrant).is_some()
    }

    /// What the robot lacks for an entrant to do anything; empty if nothing.
    pub fn lacks(&self, entrant: usize) -> &'static str {
        self.robot.as_ref().map_or("", |robot| lacking(self.all[entrant].algorithm, robot))
    }

    /// The user's program that an entrant stands for.
    pub fn program_of(&self, entrant: &Entrant) -> Option<&Arc<Program>> {
        self.program.as_ref().filter(|program| entrant.algorithm == Algorithm::of_program(program.kind))
    }

    /// Name of an entrant for users, without the number of a copy.
    pub fn title(&self, entrant: &Entrant) -> String {
        titled(entrant.algorithm, self.program_of(entrant).map(Arc::as_ref))
    }

    /// Name of an entrant in keys of results: a program's changes with its text.
    pub fn name(&self, entrant: usize) -> String {
        let entrant = &self.all[entrant];
        let text = self.program_of(entrant).map(|program| format!("#{:x}", program.fingerprint())).unwrap_or_default();
        format!("{entrant}{text}")
    }

    /// 1 for an original, 2 and up for its copies; 0 for one that was removed, and for a program that isn't there.
    pub fn copy_number(&self, entrant: usize) -> usize {
        if self.removed.contains(&entrant) || !self.is_there(entrant) {
            return 0;
        }
        if entrant < self.originals {
            return 1;
        }
        let is_same = |&index: &usize| {
            let (one, other) = (self.all[index].algorithm, self.all[entrant].algorithm);
            (one.kind(), one.id()) == (other.kind(), other.id()) && !self.removed.contains(&index)
        };
        2 + (self.originals..entrant).filter(is_same).count()
    }

    /// What tells an entrant from its copies, or from what it was copied of: the values in which they differ, and a number if
    /// another has the same. Empty if it is the only one of its algorithm.
    pub fn distinction(&self, entrant: usize) -> String {
        let copy = self.copy_number(entrant);
        let Entrant { algorithm, params } = &self.all[entrant];
        let is_other = |&index: &usize| {
            let other = self.all[index].algorithm;
            index != entrant
                && (other.kind(), other.id()) == (algorithm.kind(), algorithm.id())
                && self.copy_number(index) > 0
        };
        let others: Vec<&Params> = (0..self.all.len()).filter(is_other).map(|index| &self.all[index].params).collect();
        let words = differing(algorithm.params(), params, &others);
        match others.contains(&params) && copy > 1 {
            true if words.is_empty() => format!("({copy})"),
            true => format!("{words} ({copy})"),
            false => words,
        }
    }

    /// The chosen entrants that can take part, in the order in which they were chosen.
    pub fn taking_part(&self) -> impl Iterator<Item = usize> {
        self.chosen.iter().copied().filter(|&entrant| self.is_there(entrant) && self.lacks(entrant).is_empty())
    }

    /// Those of them that race.
    pub fn racing(&self) -> impl Iterator<Item = usize> {
        self.taking_part().filter(|entrant| !self.benched.contains(entrant))
    }

    /// The planners among them, in the order of the registry.
    pub fn planners(&self) -> Vec<usize> {
        let mut planners: Vec<usize> = self.taking_part().filter(|&entrant| !self.is_behaviour(entrant)).collect();
        planners.sort_unstable();
        planners
    }

    // ---- links

    /// The chosen planners or behaviours with their parameters, for a link.
    pub fn to_link(&self, behaves: bool) -> String {
        let chosen = self.chosen.iter().filter(|&&entrant| self.is_behaviour(entrant) == behaves);
        chosen.map(|&entrant| self.all[entrant].to_string()).collect::<Vec<_>>().join(",")
    }

    /// The chosen ones as a link lists them: planners, then behaviours.
    fn listed(&self) -> impl Iterator<Item = usize> {
        [false, true].into_iter().flat_map(move |behaves| {
            self.chosen.iter().copied().filter(move |&entrant| self.is_behaviour(entrant) == behaves)
        })
    }

    /// The places in a link of those that don't race: taken out of the race, or `waiting` for a lane.
    pub fn bench_to_link(&self, waiting: &[usize]) -> String {
        let places = self.listed().enumerate().filter(|(_, it)| waiting.contains(it) || self.benched.contains(it));
        places.map(|(place, _)| place.to_string()).collect::<Vec<_>>().join(",")
    }

    /// Takes those at these places of a link out of the race; what isn't a place is left out.
    pub fn bench(&mut self, link: &str) {
        let listed: Vec<usize> = self.listed().collect();
        let places = link.split(',').filter_map(|place| place.parse::<usize>().ok());
        self.benched.extend(places.filter_map(|place| listed.get(place)));
    }

    /// Excludes all, and removes all copies.
    pub fn clear(&mut self) {
        self.chosen.clear();
        self.benched.clear();
        self.removed = (self.originals..self.all.len()).collect();
    }

    pub fn choose_planners(&mut self, link: &str) -> Result<(), SettingsError> {
        self.choose_also(PLANNER, link)
    }

    pub fn choose_behaviours(&mut self, link: &str) -> Result<(), SettingsError> {
        self.choose_also(BEHAVIOUR, link)
    }

    /// Chooses the algorithms of a link; one that is chosen already, as a copy.
    fn choose_also(&mut self, kind: &'static str, link: &str) -> Result<(), SettingsError> {
        for entrant in link.split(',').filter(|name| !name.is_empty()) {
            let entrant = Entrant::parse(kind, entrant)?;
            let is_it = |e: &Entrant| e.algorithm.kind() == kind && e.id() == entrant.id();
            let Some(index) = self.all[..self.originals].iter().position(is_it) else { continue };
            if self.chosen.contains(&index) {
                let copy = self.add_copy(entrant);
                self.chosen.extend(copy);
            } else {
                self.all[index] = entrant;
                self.chosen.push(index);
            }
        }
        Ok(())
    }
}
