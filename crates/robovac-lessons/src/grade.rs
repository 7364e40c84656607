//! Marking an answer: its runs are made again.

use crate::{Answer, Goal, Lesson, LessonBlock, LessonScene, Verdict, answer::RunRecord};
use robovac_core::program::Program;
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
    /// Seeds whose digest in the answer differs from that of the run made here.
    pub misfits: Vec<u64>,
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

/// Checks what a lesson opens and runs with the types of the simulator: every link, robot, algorithm and parameter. For
/// tests, `robovac grade` and authors; the page says the same when a scene is opened. Errors name the link.
pub fn check(lesson: &Lesson) -> Result<(), String> {
    for text in lesson.links() {
        let fail = |error: &dyn std::fmt::Display| format!("the link \"{text}\": {error}");
        let link = crate::Link::parse(text);
        let mut settings = Settings::new();
        for (key, value) in link.pairs() {
            settings.take_link(key, value).map_err(|error| fail(&error))?;
        }
        let room = link.get("room").filter(|room| *room != "own");
        if room.is_some_and(|room| robovac_core::floor_plan::room(room).is_none()) {
            return Err(fail(&format!(
                "there is no room \"{}\"; \"robovac rooms\" lists them",
                room.unwrap_or_default()
            )));
        }
    }
    for block in &lesson.blocks {
        let LessonBlock::Scene(LessonScene { title, scenario, .. }) = block else { continue };
        if !scenario.is_empty() {
            plan_of(None, Some(scenario)).map_err(|error| {
                format!("the scene \"{title}\": {error}; paste a file that \"Save as…\" has written")
            })?;
        }
    }
    Ok(())
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
        Self { name, passed, remarks, goals, quizzes }
    }
}

/// Seeds of which the answer claims another digest than the run has.
fn misfits(claimed: &[RunRecord], runs: &[RunOutcome]) -> Vec<u64> {
    let of = |seed: u64| runs.iter().find(|run| run.seed == seed).map(|run| RunRecord::of(run).digest);
    claimed
        .iter()
        .filter(|claim| of(claim.seed).is_some_and(|digest| digest != claim.digest))
        .map(|claim| claim.seed)
        .collect()
}
