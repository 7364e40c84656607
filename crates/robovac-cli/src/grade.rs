//! `grade`: runs the answers to a lesson again and marks them.

mod programs;
mod report;

use super::{
    failure::Failure,
    output,
    parallel::{self, in_parallel},
    signals::end_requested,
};
use programs::{Programs, Pupil};
use report::{csv, html, table};
use robovac_lessons::{Answer, GradedAnswer, Job, Lesson, check};
use robovac_sim::montecarlo::{Lab, RunOutcome, RunsRequest};
use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
};

/// Largest answer file, bytes.
const MOST_BYTES: u64 = 20_000_000;

/// Run the answers to a lesson again, and mark them
#[derive(clap::Args)]
pub struct Arguments {
    /// The lesson
    #[arg(value_name = "LESSON.md")]
    lesson: PathBuf,
    /// Answers: files that "Hand in" on the page has saved. Without any, only the lesson is checked
    #[arg(value_name = "ANSWER.json")]
    answers: Vec<PathBuf>,
    /// Seeds to use in place of the lesson's: whole numbers, one a line; "#" begins a comment
    #[arg(long, value_name = "FILE")]
    seeds_file: Option<PathBuf>,
    /// Runs in parallel [default: one per core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    jobs: Option<u16>,
    /// Run learners' programs even where they can't be kept from your files and the network
    #[arg(long)]
    unconfined: bool,
    #[command(flatten)]
    form: FormArguments,
}

/// What the table is written as, instead of text.
#[derive(clap::Args)]
struct FormArguments {
    /// Write one JSON object with all numbers
    #[arg(long, conflicts_with_all = ["csv", "html"])]
    json: bool,
    /// Write one line of CSV for each condition
    #[arg(long, conflicts_with = "html")]
    csv: bool,
    /// Write a page with the table
    #[arg(long)]
    html: bool,
}

/// One answer's runs for one goal, with one seed or with some.
struct GradingTask<'a> {
    /// Index of the answer and of the job.
    at: (usize, usize),
    job: &'a Job,
    seeds: &'a [u64],
}

/// Runs of a program that are made together. Always the same ones, however many threads and answers there are: what a
/// program's runs could know of each other must not depend on the computer that marks them.
const TOGETHER: usize = 20;

/// Marks the answers and returns the report.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    let text = read(&arguments.lesson)?;
    let named = |error: &dyn std::fmt::Display| Failure::usage(format!("{}: {error}", arguments.lesson.display()));
    let lesson = Lesson::parse(&text).map_err(|fault| named(&fault))?;
    check(&lesson).map_err(|error| named(&error.replace('\n', &format!("\n{}: ", arguments.lesson.display()))))?;
    for note in &lesson.notes {
        eprintln!("{}: note: {note}", arguments.lesson.display());
    }
    if arguments.answers.is_empty() {
        let (goals, quizzes) = (lesson.goals().count(), lesson.quizzes().count());
        return Ok(format!(
            "{}: \"{}\" is in order; goals: {goals}, quizzes: {quizzes}\n",
            arguments.lesson.display(),
            lesson.title
        ));
    }
    let seeds = arguments.seeds_file.as_deref().map(read_seeds).transpose()?;
    // A broken file is a mark, not the end: the others were handed in, too.
    let answers: Vec<(String, Result<Answer, String>)> = arguments
        .answers
        .iter()
        .map(|path| (name_of(path), read(path).map_err(|e| e.to_string()).and_then(|text| Answer::parse(&text))))
        .collect();
    let jobs: Vec<Vec<Job>> = answers
        .iter()
        .map(|(_, answer)| {
            answer.as_ref().map_or_else(|_| Vec::new(), |answer| GradedAnswer::jobs(&lesson, answer, seeds.as_deref()))
        })
        .collect();
    let threads = parallel::jobs(arguments.jobs);
    let has_programs = jobs.iter().flatten().any(Job::by_program);
    let programs = has_programs.then(|| Programs::new(arguments.unconfined, end_requested()?)).transpose()?;
    if let Some(programs) = &programs {
        eprintln!("{}", programs.words());
    }
    let mut results = make(&jobs, programs.as_ref(), threads);
    let graded: Vec<GradedAnswer> = answers
        .into_iter()
        .zip(&mut results)
        .map(|((file, answer), results)| match answer {
            Ok(answer) => GradedAnswer::new(&lesson, &answer, &file, std::mem::take(results)),
            Err(fault) => GradedAnswer {
                name: file.clone(),
                file,
                passed: false,
                remarks: vec![fault],
                goals: Vec::new(),
                quizzes: Vec::new(),
            },
        })
        .collect();
    Ok(match (arguments.form.json, arguments.form.csv, arguments.form.html) {
        (true, ..) => output::json(&graded),
        (_, true, _) => csv(&graded),
        (.., true) => html(&lesson, &graded),
        _ => table(&lesson, &graded),
    })
}

/// A room, and the program that drives in it, if one does.
type PreparedRun = (Lab, Option<Pupil>);
type Results = Vec<(usize, Result<Vec<RunOutcome>, String>)>;

/// Makes all runs, `threads` at a time: plans first, as the runs of an answer share its plan.
fn make(jobs: &[Vec<Job>], programs: Option<&Programs>, threads: usize) -> Vec<Results> {
    let all: Vec<((usize, usize), &Job)> = jobs
        .iter()
        .enumerate()
        .flat_map(|(who, jobs)| jobs.iter().enumerate().map(move |(which, job)| ((who, which), job)))
        .collect();
    let labs = in_parallel(&all, threads, |(_, job)| {
        let lab = job.request.lab()?;
        if job.by_program() {
            return Ok((lab, Some(Programs::pupil(job)?)));
        }
        let plan_only = RunsRequest { seeds: Vec::new(), ..job.request.clone() };
        plan_only.run(&lab, None)?;
        Ok::<PreparedRun, String>((lab, None))
    });
    let labs: BTreeMap<(usize, usize), Result<PreparedRun, String>> = all.iter().map(|(at, _)| *at).zip(labs).collect();
    let able: Vec<_> = all.iter().filter(|(at, _)| labs.get(at).is_some_and(Result::is_ok)).collect();
    let pieces: Vec<GradingTask<'_>> = able
        .iter()
        .flat_map(|(at, job)| {
            let size = if job.by_program() { TOGETHER } else { 1 };
            job.request.seeds.chunks(size).map(|seeds| GradingTask { at: *at, job, seeds })
        })
        .collect();
    let outcomes = in_parallel(&pieces, threads, |GradingTask { at, job, seeds }| {
        let alone = |make: &dyn Fn(u64) -> Result<RunOutcome, String>| seeds.iter().map(|&seed| make(seed)).collect();
        match (labs.get(at), programs) {
            (Some(Ok((lab, None))), _) => alone(&|seed| job.request.run_one(lab, seed)),
            (Some(Ok((lab, Some(pupil)))), Some(programs)) => programs.run(job, pupil, lab, seeds),
            (Some(Ok((_, Some(_)))), None) => alone(&|_| Err("programs can't be run".to_owned())),
            _ => alone(&|_| Err("it has no room".to_owned())),
        }
    });
    let mut results: Vec<Results> =
        jobs.iter().map(|jobs| jobs.iter().map(|job| (job.goal, Ok(Vec::new()))).collect()).collect();
    for (at, lab) in &labs {
        if let Err(fault) = lab {
            results[at.0][at.1].1 = Err(fault.clone());
        }
    }
    let of_pieces = pieces
        .iter()
        .zip(outcomes)
        .flat_map(|(piece, runs): (_, Vec<_>)| runs.into_iter().map(move |run| (piece, run)));
    for (piece, outcome) in of_pieces {
        let result = &mut results[piece.at.0][piece.at.1].1;
        match (&mut *result, outcome) {
            (Ok(runs), Ok(outcome)) => runs.push(outcome),
            // The first that has failed says why.
            (Ok(_), Err(fault)) if !fault.is_empty() => *result = Err(fault),
            _ => {}
        }
    }
    results
}

fn read(path: &Path) -> Result<String, Failure> {
    let size = fs::metadata(path).map_err(|error| Failure::io(path.display(), &error))?.len();
    if size > MOST_BYTES {
        return Err(Failure::usage(format!(
            "{}: it is too large for a lesson or an answer; check the path",
            path.display()
        )));
    }
    fs::read_to_string(path).map_err(|error| Failure::io(path.display(), &error))
}

fn name_of(path: &Path) -> String {
    path.file_stem().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}

fn read_seeds(path: &Path) -> Result<Vec<u64>, Failure> {
    let text = read(path)?;
    let lines = text.lines().map(|line| line.split('#').next().unwrap_or_default().trim()).enumerate();
    let seeds: Vec<u64> = lines
        .filter(|(_, line)| !line.is_empty())
        .map(|(index, line)| {
            let seed = line.parse::<u32>().map(u64::from);
            seed.map_err(|_| {
                Failure::usage(format!(
                    "{}, line {}: \"{line}\" isn't a seed; use whole numbers from 0 to 4294967295",
                    path.display(),
                    index + 1
                ))
            })
        })
        .collect::<Result<_, _>>()?;
    if seeds.is_empty() {
        return Err(Failure::usage(format!("{}: there is no seed in it; write one a line", path.display())));
    }
    Ok(seeds)
}
