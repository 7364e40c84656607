//! Output to the terminal.

use super::failure::Failure;
use coverage_planners::metrics::METRICS;
use robovac_app::compare::ComparisonTable;
use serde::Serialize;
use std::io::{ErrorKind, Write};

/// Writes to standard output. A reader that has seen enough, such as `head`, is no failure.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Failure::io("standard output", &error)),
        _ => Ok(()),
    }
}

/// Writes a line at once. If this fails, the reader has gone away.
pub fn say(line: &str) {
    let mut out = std::io::stdout().lock();
    let _ = writeln!(out, "{line}").and_then(|()| out.flush());
}

/// One line of JSON.
pub fn json(value: &impl Serialize) -> String {
    // Numbers, strings and lists can always be serialised.
    serde_json::to_string(value).unwrap_or_default() + "\n"
}

/// A human-readable duration.
pub fn minutes(seconds: f64) -> String {
    let seconds = seconds.round() as u64;
    format!("{} min {} s", seconds / 60, seconds % 60)
}

/// A Markdown table with those columns of [`METRICS`]; the best of a column is bold, ranges are over seeds.
pub fn markdown(title: &str, columns: &[usize], table: &ComparisonTable) -> String {
    let heads = columns.iter().map(|&column| {
        let metric = &METRICS[column];
        if metric.unit.is_empty() { metric.label.to_owned() } else { format!("{}, {}", metric.label, metric.unit) }
    });
    let heads: Vec<String> = std::iter::once("Planner".to_owned()).chain(heads).collect();
    let mut text = format!("### {title}\n\n| {} |\n|---{}|\n", heads.join(" | "), "|--:".repeat(columns.len()));
    for row in &table.rows {
        let cells = columns.iter().map(|&column| {
            let metric = &METRICS[column];
            let shown = |value| format!("{:.*}", usize::from(metric.decimals), metric.rounded(value));
            let Some(spread) = row.values[column] else { return "–".to_owned() };
            let value = shown(spread.median);
            let value = if table.is_best(row, column) { format!("**{value}**") } else { value };
            if spread.max > spread.min {
                format!("{value} ({} to {})", shown(spread.min), shown(spread.max))
            } else {
                value
            }
        });
        let name =
            row.failure.as_ref().map_or_else(|| row.entrant.to_string(), |why| format!("{} ({why})", row.entrant));
        let cells: Vec<String> = std::iter::once(name).chain(cells).collect();
        text.extend(["| ", &cells.join(" | "), " |\n"]);
    }
    text + "\n"
}
