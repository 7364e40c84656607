//! Every lesson of the page: it is in order, its scenes are ones that the page takes, and every goal is reached by its
//! answer and missed by its start.

use coverage_planners::metrics::METRICS;
use robovac_lessons::{Answer, GradedAnswer, Lesson, Quiz, QuizAnswer, check};
use robovac_sim::experiment::Algorithm;
use std::{fs, path::PathBuf};

/// Runs of a goal in the short test; all of them in the long one.
const FEW: usize = 2;

fn root() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// The lessons by the index of the page: entry, file, lesson.
fn lessons() -> Vec<(serde_json::Value, String, Lesson)> {
    let folder = root().join("lessons");
    let index: Vec<serde_json::Value> =
        serde_json::from_str(&fs::read_to_string(folder.join("index.json")).unwrap()).unwrap();
    let read = |entry: serde_json::Value| {
        let file = entry["file"].as_str().unwrap().to_owned();
        let text = fs::read_to_string(folder.join(&file)).unwrap();
        let lesson = Lesson::parse(&text).unwrap_or_else(|fault| panic!("lessons/{file}, {fault}"));
        (entry, file, lesson)
    };
    index.into_iter().map(read).collect()
}

#[test]
fn every_lesson_is_in_order_and_in_the_index() {
    let lessons = lessons();
    for (entry, file, lesson) in &lessons {
        check(lesson).unwrap_or_else(|fault| panic!("lessons/{file}: {fault}"));
        let listed = (entry["id"].as_str(), entry["title"].as_str(), entry["minutes"].as_f64());
        assert_eq!(listed, (Some(lesson.id.as_str()), Some(lesson.title.as_str()), Some(lesson.minutes)), "{file}");
        assert!((20.0..=45.0).contains(&lesson.minutes), "{file}");
        let explained: Vec<&str> =
            entry["explains"].as_array().unwrap().iter().map(|name| name.as_str().unwrap()).collect();
        assert_eq!(explained, lesson.explains, "{file}");
        assert!(!lesson.outcomes.is_empty() && !lesson.sources.is_empty(), "{file}");
        assert!(lesson.goals().count() + lesson.quizzes().count() > 0, "{file}");
    }
    let files = fs::read_dir(root().join("lessons")).unwrap().map(|entry| entry.unwrap().path());
    let texts = files.filter(|path| path.extension().is_some_and(|ending| ending == "md")).count();
    assert_eq!(texts, lessons.len(), "a lesson isn't in lessons/index.json");
}

#[test]
fn what_lessons_explain_is_a_label_of_the_page() {
    let mut labels: Vec<String> = METRICS.iter().map(|metric| metric.label.to_owned()).collect();
    for algorithm in Algorithm::all() {
        labels.extend(algorithm.params().iter().map(|param| param.label.to_owned()));
    }
    let read = |file: &str| fs::read_to_string(root().join(file)).unwrap();
    // What stands between these.
    for (file, before, after) in [
        ("www/explore/numbers.js", "label: \"", "\""),
        ("www/map/numbers.js", "label: \"", "\""),
        ("www/compare/runs-table.js", "  [\"", "\""),
        ("index.html", "class=\"label\">", "<"),
        ("index.html", "class=\"label\" for=\"seed\">", "<"),
        ("index.html", "<label class=\"speed\"", "</span>"),
    ] {
        let text = read(file);
        let found: Vec<&str> = text.split(before).skip(1).filter_map(|rest| rest.split(after).next()).collect();
        assert!(!found.is_empty(), "{file} has no {before}");
        // Behind a comma is the unit.
        let name = |label: &&str| {
            label.rsplit('>').next().unwrap_or_default().split(',').next().unwrap_or_default().to_owned()
        };
        labels.extend(found.iter().map(name));
    }
    let mut seen = Vec::new();
    for (_, file, lesson) in lessons() {
        for name in lesson.explains {
            assert!(labels.contains(&name), "{file} explains \"{name}\", and nothing on the page is called that");
            assert!(!seen.contains(&name), "two lessons explain \"{name}\"");
            seen.push(name);
        }
    }
    assert!(seen.len() > 30);
}

/// The answer file of a lesson. With `UPDATE=1` its answers to quizzes are written again.
fn answer_of(file: &str, lesson: &Lesson) -> Answer {
    let path = root().join("lessons/answers").join(file.replace(".md", ".json"));
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut answer = Answer::parse(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    if std::env::var_os("UPDATE").is_some() {
        let right = |quiz: &Quiz| QuizAnswer {
            answers: (1..=quiz.rounds).map(|seed| (seed, quiz.about.question(seed).right())).collect(),
        };
        answer.quizzes = lesson.quizzes().map(|quiz| (quiz.id.clone(), right(quiz))).collect();
        fs::write(&path, serde_json::to_string_pretty(&answer).unwrap() + "\n").unwrap();
    }
    answer
}

/// The answer passes and the start misses, with the first `runs` seeds of each goal.
fn answers_pass_and_starts_miss(runs: usize) {
    for (_, file, lesson) in lessons() {
        let answer = answer_of(&file, &lesson);
        let mut idle = answer.clone();
        for goal in lesson.goals() {
            let given = idle.goals.get_mut(&goal.id);
            given.unwrap_or_else(|| panic!("{file}: no answer to {}", goal.id)).link.clone_from(&goal.start);
        }
        let mark = |answer: &Answer| {
            let results = GradedAnswer::jobs(&lesson, answer, None).into_iter().map(|mut job| {
                job.request.seeds.truncate(runs);
                let made = job.request.lab().and_then(|lab| job.request.run(&lab, None));
                (job.goal, made)
            });
            GradedAnswer::new(&lesson, answer, "", results.collect())
        };
        let (good, start) = (mark(&answer), mark(&idle));
        // Answers with programs are run by tests of the command line.
        if answer.goals.values().all(|given| given.program.is_none()) {
            assert!(good.passed && good.remarks.is_empty(), "{file}: {good:#?}");
        }
        for goal in start.goals {
            let missed = goal.verdict.is_some_and(|verdict| !verdict.passed);
            assert!(missed, "{file}: the start reaches the goal {}", goal.id);
        }
    }
}

// slow: two runs of each goal of the lessons, twice
#[test]
fn every_goal_is_reached_by_its_answer_and_missed_by_its_start() {
    answers_pass_and_starts_miss(FEW);
}

#[test]
#[ignore = "soak: all runs of every goal"]
fn every_goal_is_reached_and_missed_with_all_its_seeds() {
    answers_pass_and_starts_miss(usize::MAX);
}

#[test]
fn the_template_is_a_lesson_and_the_one_of_the_docs() {
    let script = fs::read_to_string(root().join("www/learn/template.js")).unwrap();
    let text = script.split("TEMPLATE = `").nth(1).and_then(|rest| rest.split("`;").next()).unwrap();
    let text = text.replace("${FENCE}", "```");
    check(&Lesson::parse(&text).unwrap()).unwrap();
    let docs = fs::read_to_string(root().join("docs/teaching.md")).unwrap();
    assert!(docs.contains(&text), "docs/teaching.md has another template than www/learn/template.js");
}
