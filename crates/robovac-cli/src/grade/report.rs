//! Marks as Markdown, CSV and HTML.

use robovac_lessons::{GoalGrade, GradedAnswer, Judged, Lesson};
use std::fmt::Write;

/// What a cell of a goal says: numbers and what doesn't fit.
fn cell(goal: &GoalGrade) -> String {
    let Some(verdict) = &goal.verdict else { return goal.fault.clone() };
    let needs: Vec<String> = verdict.needs.iter().map(|need| format!("{} ({})", value(need), need.text)).collect();
    let mark = if verdict.passed { "passed" } else { "missed" };
    format!("{mark}: {}", needs.join(", "))
}

/// Whether it is passed, and what of it is not as the answer claims.
fn passed(answer: &GradedAnswer) -> String {
    let mut counts = std::collections::BTreeMap::new();
    for part in answer.goals.iter().flat_map(|goal| &goal.misfits).flat_map(|misfit| &misfit.parts) {
        *counts.entry(*part).or_insert(0) += 1;
    }
    let misfits: Vec<String> = counts
        .iter()
        .map(|(part, count)| format!("{part} of {count} run{}", if *count == 1 { "" } else { "s" }))
        .collect();
    if misfits.is_empty() {
        return yes(answer.passed).to_owned();
    }
    format!("{}, but not as claimed: {}", yes(answer.passed), misfits.join(", "))
}

/// Who, and in which file.
fn who(answer: &GradedAnswer) -> String {
    if answer.name == answer.file { answer.name.clone() } else { format!("{} ({})", answer.name, answer.file) }
}

fn value(need: &Judged) -> String {
    need.value.map_or_else(|| "not reached".to_owned(), |value| format!("{value:.1} {}", need.unit).trim().to_owned())
}

fn columns(lesson: &Lesson) -> Vec<String> {
    let goals = lesson.goals().map(|goal| goal.id.clone());
    goals.chain(lesson.quizzes().map(|quiz| quiz.id.clone())).collect()
}

fn cells(lesson: &Lesson, answer: &GradedAnswer) -> Vec<String> {
    if answer.goals.is_empty() && answer.quizzes.is_empty() {
        return vec!["–".to_owned(); columns(lesson).len()];
    }
    let quizzes = answer.quizzes.iter().map(|quiz| format!("{} of {}", quiz.right, quiz.rounds));
    answer.goals.iter().map(cell).chain(quizzes).collect()
}

/// A Markdown table.
pub fn table(lesson: &Lesson, answers: &[GradedAnswer]) -> String {
    let columns = columns(lesson);
    let mut text = format!(
        "### {}\n\n| Answer | Passed | {} | Remarks |\n|---|---|{}---|\n",
        lesson.title,
        columns.join(" | "),
        "---|".repeat(columns.len())
    );
    for answer in answers {
        // Writing to a string doesn't fail.
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} |",
            plain(&who(answer)),
            passed(answer),
            cells(lesson, answer).join(" | "),
            plain(&answer.remarks.join("; "))
        );
    }
    let passed = answers.iter().filter(|answer| answer.passed).count();
    let _ = writeln!(text, "\n{passed} of {} passed.", answers.len());
    text
}

/// One line for each condition and quiz of each answer.
pub fn csv(answers: &[GradedAnswer]) -> String {
    let mut text = "answer,part,condition,value,unit,passed,misfits,remark,file\n".to_owned();
    let mut line = |cells: [&str; 9]| {
        let _ = writeln!(text, "{}", cells.map(quoted).join(","));
    };
    for answer in answers {
        for goal in &answer.goals {
            let misfits = goal.misfits.len().to_string();
            for need in goal.verdict.iter().flat_map(|verdict| &verdict.needs) {
                let value = need.value.map(|value| value.to_string()).unwrap_or_default();
                line([
                    &answer.name,
                    &goal.id,
                    &need.text,
                    &value,
                    need.unit,
                    yes(need.passed),
                    &misfits,
                    "",
                    &answer.file,
                ]);
            }
            if goal.verdict.is_none() {
                line([&answer.name, &goal.id, "", "", "", "no", &misfits, &goal.fault, &answer.file]);
            }
        }
        for quiz in &answer.quizzes {
            let (right, needed) = (quiz.right.to_string(), format!("at least {}", quiz.rounds));
            line([
                &answer.name,
                &quiz.id,
                &needed,
                &right,
                "",
                yes(quiz.right >= quiz.rounds as usize),
                "0",
                "",
                &answer.file,
            ]);
        }
        line([&answer.name, "all", "", "", "", yes(answer.passed), "", &answer.remarks.join("; "), &answer.file]);
    }
    text
}

/// A page that needs nothing else.
pub fn html(lesson: &Lesson, answers: &[GradedAnswer]) -> String {
    let title = escaped(&lesson.title);
    let heads = columns(lesson).iter().fold(String::new(), |text, name| text + "<th>" + &escaped(name) + "</th>");
    let mut rows = String::new();
    for answer in answers {
        let cells =
            cells(lesson, answer).iter().fold(String::new(), |text, cell| text + "<td>" + &escaped(cell) + "</td>");
        let _ = writeln!(
            rows,
            "<tr class=\"{}\"><th>{}</th><td>{}</td>{cells}<td>{}</td></tr>",
            yes(answer.passed),
            escaped(&who(answer)),
            escaped(&passed(answer)),
            escaped(&answer.remarks.join("; "))
        );
    }
    format!(
        "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\">\n\
         <title>{title}</title>\n<style>body{{font:1rem/1.5 system-ui,sans-serif;margin:2rem}}table{{border-collapse:collapse}}\
         th,td{{border:1px solid #999;padding:.3rem .6rem;text-align:left;vertical-align:top}}tr.yes td:nth-child(2){{color:#086a2f;font-weight:600}}</style>\n\
         <h1>{title}</h1>\n<table><thead><tr><th>Answer</th><th>Passed</th>{heads}<th>Remarks</th></tr></thead>\n<tbody>\n{rows}</tbody></table>\n</html>\n"
    )
}

fn yes(is: bool) -> &'static str {
    if is { "yes" } else { "no" }
}

/// Text of a stranger in a Markdown table.
fn plain(text: &str) -> String {
    text.replace(['|', '\n', '\r'], " ").replace('<', "&lt;")
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A CSV cell. A spreadsheet takes text that begins with = + - @ for a formula: it gets an apostrophe, numbers don't.
fn quoted(text: &str) -> String {
    let is_formula = text.starts_with(['=', '+', '-', '@']) && text.parse::<f64>().is_err();
    let text = if is_formula { format!("'{text}") } else { text.to_owned() };
    if text.contains([',', '"', '\n', '\r']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}

#[cfg(test)]
mod tests {
    use super::quoted;

    #[test]
    fn names_cannot_be_formulas() {
        assert_eq!(quoted("=HYPERLINK(\"x\")"), "\"'=HYPERLINK(\"\"x\"\")\"");
        assert_eq!(quoted("-3.5"), "-3.5");
    }
}
