//! A table that fills itself from runs.

use crate::{
    LessonFault, Link, Number,
    fields::BlockLines,
    goal::{needs_robot, needs_room},
};
use robovac_sim::montecarlo::{RunOutcome, RunsRequest, quantile};
use serde::Serialize;

/// A table: one row for each setting, one column for each number, medians over the runs.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Measure {
    /// What it shows; can be empty.
    pub title: String,
    /// The rows.
    pub rows: Vec<MeasureRow>,
    /// The columns: name with unit.
    pub columns: Vec<String>,
    /// The columns' numbers.
    pub numbers: Vec<Number>,
    /// Number of runs of each row; seeds from 1.
    pub runs: u64,
    /// Simulated time of each run, min.
    pub minutes: f64,
}

/// A row.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct MeasureRow {
    /// Its name.
    pub title: String,
    /// Its settings, as in links.
    pub link: String,
}

impl Measure {
    pub(crate) fn parse(fields: &mut BlockLines) -> Result<Self, LessonFault> {
        let base = fields.need("in", "room=living&robot=roomba600")?;
        needs_robot(&base)?;
        needs_room(&base, "")?;
        let base = Link::parse(&base.value);
        let rows: Vec<MeasureRow> = fields
            .take_all("row")
            .iter()
            .map(|field| {
                let (title, link) = field.value.split_once('|').ok_or_else(|| {
                    let what = format!("the row \"{}\" has no name", field.value);
                    LessonFault::new(field.line, what, "write e.g. \"row: Bounce | behaviour=bounce\"")
                })?;
                Ok(MeasureRow { title: title.trim().to_owned(), link: base.with(&Link::parse(link)).to_string() })
            })
            .collect::<Result<_, LessonFault>>()?;
        if rows.is_empty() {
            return Err(fields.lack("row", "Bounce | behaviour=bounce"));
        }
        let show = fields.need("show", "coverage, distance")?;
        let parse = |name: &str| {
            let unknown = || {
                LessonFault::new(
                    show.line,
                    format!("there is no number \"{name}\""),
                    format!("use some of: {}", Number::names()),
                )
            };
            Number::parse(name).ok_or_else(unknown)
        };
        let numbers: Vec<Number> = show.value.split(',').map(|name| parse(name.trim())).collect::<Result<_, _>>()?;
        let column = |number: &Number| match number.unit() {
            "" => number.id().to_owned(),
            unit => format!("{}, {unit}", number.id()),
        };
        Ok(Self {
            title: fields.text("title"),
            rows,
            columns: numbers.iter().map(column).collect(),
            numbers,
            runs: fields.number("runs", 5.0, 1.0..=1000.0)? as u64,
            minutes: fields.number("minutes", 20.0, 0.1..=600.0)?,
        })
    }

    /// The runs of a row.
    pub fn request(&self, row: usize) -> Option<RunsRequest> {
        let link = Link::parse(&self.rows.get(row)?.link);
        Some(link.request(None, 60.0 * self.minutes, (1..=self.runs).collect()))
    }

    /// The cells of a row: the medians, and `None` where too few runs have a value.
    pub fn cells(&self, runs: &[RunOutcome]) -> Vec<Option<f64>> {
        let median = |number: &Number| {
            let mut values: Vec<f64> = runs.iter().map(|run| number.of(run).unwrap_or(f64::INFINITY)).collect();
            values.sort_unstable_by(f64::total_cmp);
            quantile(&values, 0.5).filter(|value| value.is_finite())
        };
        self.numbers.iter().map(median).collect()
    }
}
