//! Marking an answer: its runs are made again.

use crate::{Answer, Goal, Lesson, LessonBlock, LessonScene, Link, Verdict, answer::RunRecord};
use robovac_core::{
    floor_plan::{self, generate::FlatId},
    program::Program,
    registry::nearest,
};
use robovac_sim::{
    experiment::{Algorithm, Settings, plan_of},
    montecarlo::{RunOutcome, RunsRequest},
};
use serde::Serialize;

/// The runs for one goal of an answer. Made anywhere, in any order.
#[derive(Debug, Clone)]
pub struct Job {
    /// Index of the goal in the lesson.
    pub goal: usize,
    /// The runs.
    pub request: RunsRequest,
    /// The program that makes them; with [`Job::by_program`].
    pub program: Option<Program>,
}

/// The mark of an answer.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GradedAnswer {
    /// Who handed it in, or the name of the file.
    pub name: String,
    /// The name of the file, without its ending.
    pub file: String,
    /// Whether all goals and quizzes are passed.
    pub passed: bool,
    /// What is odd, in words.
    pub remarks: Vec<String>,
    /// Each goal of the lesson.
    pub goals: Vec<GoalGrade>,
    /// Each quiz of the lesson.
    pub quizzes: Vec<QuizGrade>,
}

/// The mark for a goal.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GoalGrade {
    /// Its id.
    pub id: String,
    /// The numbers; `None` if there is no answer, or one that can't be run.
    pub verdict: Option<Verdict>,
    /// Why it can't be run; empty if it can.
    pub fault: String,
    /// Runs of the answer that differ from those made here.
    pub misfits: Vec<Misfit>,
}

/// A run of an answer that can't be had with its settings.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Misfit {
    /// Its seed.
    pub seed: u64,
    /// What differs, by its name in the answer.
    pub parts: Vec<&'static str>,
}

/// The mark for a quiz.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct QuizGrade {
    /// Its id.
    pub id: String,
    /// Questions that were answered well, each counted once.
    pub right: usize,
    /// Questions that must be.
    pub rounds: u32,
}

/// Checks what a lesson opens and runs with the types of the simulator: every link, room, robot, algorithm and parameter. For
/// tests, `robovac grade` and authors. Errors name the lines, one fault a line.
pub fn check(lesson: &Lesson) -> Result<(), String> {
    let mut faults: Vec<String> = Vec::new();
    for (line, text) in &lesson.links {
        let link = Link::parse(text);
        let mut settings = Settings::new();
        let mut fail = |error: &dyn std::fmt::Display| {
            let fault = format!("line {line}: the link \"{text}\": {error}");
            faults.push(fault);
        };
        for (key, value) in link.pairs() {
            if let Err(error) = settings.take_link(key, value) {
                fail(&error);
            }
        }
        if let Some(flat) = link.flat() {
            if let Err(error) = flat.parse::<FlatId>() {
                fail(&error);
            }
        } else if let Some(room) = link.get("room").filter(|room| *room != "own" && floor_plan::room(room).is_none()) {
            let rooms = floor_plan::ROOMS.iter().map(|room| room.id).collect::<Vec<_>>().join(", ");
            let meant = nearest(room, &rooms);
            let mend =
                meant.map_or("\"robovac rooms\" lists them".to_owned(), |name| format!("did you mean \"{name}\"?"));
            fail(&format!("there is no room \"{room}\"; {mend}"));
        }
    }
    for block in &lesson.blocks {
        let LessonBlock::Scene(LessonScene { title, scenario, .. }) = block else { continue };
        if !scenario.is_empty()
            && let Err(error) = plan_of(None, Some(scenario))
        {
            faults.push(format!("the scene \"{title}\": {error}; paste a file that \"Save as…\" has written"));
        }
    }
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n")) }
}

impl Job {
    /// Whether a program makes the runs, not an algorithm of the registries.
    pub fn by_program(&self) -> bool {
        Self::is_by_program(&self.request)
    }

    fn is_by_program(request: &RunsRequest) -> bool {
        Algorithm::is_program_id(&request.entrant)
    }
}

impl GradedAnswer {
    /// The runs that an answer needs, on `seeds` or else on those of the lesson.
    pub fn jobs(lesson: &Lesson, answer: &Answer, seeds: Option<&[u64]>) -> Vec<Job> {
        let job = |(index, goal): (usize, &Goal)| {
            let given = answer.goals.get(&goal.id)?;
            let seeds = seeds.map_or_else(|| goal.seeds(), <[u64]>::to_vec);
            let request = goal.request(&given.link, lesson.scenario_of(goal), seeds);
            let program = given.program.clone().filter(|_| Job::is_by_program(&request));
            Some(Job { goal: index, request, program })
        };
        lesson.goals().enumerate().filter_map(job).collect()
    }

    /// The mark. `results` are those of [`GradedAnswer::jobs`], in order.
    pub fn new(
        lesson: &Lesson,
        answer: &Answer,
        file: &str,
        results: Vec<(usize, Result<Vec<RunOutcome>, String>)>,
    ) -> Self {
        let mut remarks = Vec::new();
        if answer.lesson != lesson.id {
            remarks.push(format!("the answer is for the lesson \"{}\", not \"{}\"", answer.lesson, lesson.id));
        } else if !answer.lesson_digest.is_empty() && answer.lesson_digest != lesson.digest {
            remarks.push("the answer was made with another version of the lesson".to_owned());
        }
        let mut results = results;
        let goals: Vec<GoalGrade> = lesson
            .goals()
            .enumerate()
            .map(|(index, goal)| {
                let at = results.iter().position(|(which, _)| *which == index);
                let result = at.map(|at| results.swap_remove(at).1);
                let given = answer.goals.get(&goal.id);
                if let Some(given) = given {
                    let (_, ignored) = goal.settings(&given.link);
                    remarks.extend(ignored.iter().map(|key| {
                        format!("{}: \"{key}\" may not be changed; the value of the exercise was used", goal.id)
                    }));
                }
                match result {
                    None => GoalGrade {
                        id: goal.id.clone(),
                        verdict: None,
                        fault: "no answer".to_owned(),
                        misfits: Vec::new(),
                    },
                    Some(Err(fault)) => GoalGrade { id: goal.id.clone(), verdict: None, fault, misfits: Vec::new() },
                    Some(Ok(runs)) => {
                        let claimed = given.map(|given| given.runs.as_slice()).unwrap_or_default();
                        GoalGrade {
                            id: goal.id.clone(),
                            misfits: misfits(claimed, &runs),
                            verdict: Some(goal.judge(&runs)),
                            fault: String::new(),
                        }
                    }
                }
            })
            .collect();
        let quizzes: Vec<QuizGrade> = lesson
            .quizzes()
            .map(|quiz| {
                let given = answer.quizzes.get(&quiz.id).map(|given| given.answers.as_slice()).unwrap_or_default();
                let right: std::collections::BTreeSet<u32> = given
                    .iter()
                    .filter(|(seed, text)| quiz.about.question(*seed).is_right(text))
                    .map(|(seed, _)| *seed)
                    .collect();
                QuizGrade { id: quiz.id.clone(), right: right.len(), rounds: quiz.rounds }
            })
            .collect();
        let passed = answer.lesson == lesson.id
            && goals.iter().all(|goal| goal.verdict.as_ref().is_some_and(|verdict| verdict.passed))
            && quizzes.iter().all(|quiz| quiz.right >= quiz.rounds as usize);
        let name = if answer.name.is_empty() { file.to_owned() } else { answer.name.clone() };
        Self { name, file: file.to_owned(), passed, remarks, goals, quizzes }
    }
}

/// What the answer claims and the runs don't have.
fn misfits(claimed: &[RunRecord], runs: &[RunOutcome]) -> Vec<Misfit> {
    let of = |claim: &RunRecord| {
        let made = RunRecord::of(runs.iter().find(|run| run.seed == claim.seed)?);
        // Not to the bit: they were written and read as decimals.
        let is_off = |a: f64, b: f64| (a - b).abs() > 1e-6 * b.abs().max(1.0);
        let parts: Vec<&'static str> = [
            ("digest", claim.digest != made.digest),
            ("coverage_percent", is_off(claim.coverage_percent, made.coverage_percent)),
            ("time_s", is_off(claim.time_s, made.time_s)),
            ("distance_m", is_off(claim.distance_m, made.distance_m)),
        ]
        .into_iter()
        .filter_map(|(name, differs)| differs.then_some(name))
        .collect();
        (!parts.is_empty()).then_some(Misfit { seed: claim.seed, parts })
    };
    claimed.iter().filter_map(of).collect()
}
