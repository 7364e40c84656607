//! Results as Parquet: a row for each run, in the order of the runs.

use super::{Failure, Opened, Shards, shards::flush_names};
use parquet::{
    basic::Compression,
    column::writer::ColumnWriter,
    data_type::ByteArray,
    errors::ParquetError,
    file::{
        metadata::KeyValue,
        properties::WriterProperties,
        writer::{SerializedFileWriter, SerializedRowGroupWriter},
    },
    schema::parser::parse_message_type,
};
use robovac_sim::{
    Conditions,
    study::{StudyOutcome, StudyRoom, StudyRow, StudyRun},
};
use std::{
    fs::{self, File},
    path::Path,
    sync::Arc,
};

/// Runs in a row group, the unit in which readers take a file.
const GROUP: usize = 10_000;

/// What a column takes from a row.
type TableRow<'a> = (&'a Opened, &'a StudyRow, StudyRun<'a>);

/// How a column's value is found.
enum Value {
    Int(fn(&TableRow<'_>) -> Option<i64>),
    Float(fn(&TableRow<'_>) -> Option<f64>),
    Flag(fn(&TableRow<'_>) -> bool),
    Text(fn(&TableRow<'_>) -> Option<String>),
    /// A list of numbers; empty if there is none.
    Floats(fn(&TableRow<'_>) -> Vec<f32>),
}

use Value::{Flag, Float, Floats, Int, Text};

/// The columns; docs/studies.md describes them.
const COLUMNS: &[(&str, Value)] = &[
    ("run", Int(|(_, row, _)| Some(row.run as i64))),
    ("room", Text(|(_, _, run)| Some(run.room.to_string()))),
    (
        "flat_seed",
        Int(|(_, _, run)| match run.room {
            StudyRoom::Flat(flat) => Some(flat.seed as i64),
            _ => None,
        }),
    ),
    ("robot", Text(|(_, _, run)| Some(run.robot.robot.clone()))),
    ("kind", Text(|(_, _, run)| Some(run.entrant.algorithm.kind().to_owned()))),
    ("algorithm", Text(|(_, _, run)| Some(run.entrant.id().to_owned()))),
    (
        "params",
        Text(|(_, _, run)| Some(run.entrant.to_string().split_once('~').map_or("", |(_, rest)| rest).to_owned())),
    ),
    ("conditions", Text(|(_, _, run)| Some(run.conditions.name.clone()))),
    ("slip", Text(|(_, _, run)| Some(run.conditions.conditions.slip.id().to_owned()))),
    ("noise", Text(|(_, _, run)| Some(run.conditions.conditions.noise.to_string()))),
    ("quantised", Flag(|(_, _, run)| run.conditions.conditions.quantised)),
    (
        "start_charge_percent",
        Int(|(_, _, run)| {
            let Conditions { start_charge_percent, .. } = run.conditions.conditions;
            Some(i64::from(start_charge_percent))
        }),
    ),
    ("odometry", Text(|(_, _, run)| Some(run.conditions.odometry.id().to_owned()))),
    ("seed", Int(|(_, _, run)| Some(run.seed as i64))),
    ("plan_seed", Int(|(opened, _, _)| Some(opened.study.spec.plan_seed as i64))),
    ("minutes", Float(|(opened, _, _)| Some(opened.study.spec.minutes))),
    ("error", Text(|(_, row, _)| row.error.clone())),
    ("measure", Text(|(_, _, run)| Some(if run.entrant.explores() { "boundary" } else { "floor" }.to_owned()))),
    ("floor_m2", Float(|(_, row, _)| outcome(row).map(|o| o.floor_m2))),
    ("cell_size_m", Float(|(_, row, _)| outcome(row).map(|o| o.cell_size_m))),
    ("coverage", Float(|(_, row, _)| outcome(row).map(|o| o.coverage))),
    ("time_to_90_s", Float(|(_, row, _)| outcome(row)?.reached_s[0])),
    ("time_to_99_s", Float(|(_, row, _)| outcome(row)?.reached_s[1])),
    ("time_s", Float(|(_, row, _)| outcome(row).map(|o| o.time_s))),
    ("distance_m", Float(|(_, row, _)| outcome(row).map(|o| o.distance_m))),
    ("bumps", Int(|(_, row, _)| outcome(row).map(|o| i64::from(o.bumps)))),
    ("falls", Int(|(_, row, _)| outcome(row).map(|o| i64::from(o.falls)))),
    ("dirt_left", Float(|(_, row, _)| outcome(row)?.dirt_left)),
    ("excess_distance", Float(|(_, row, _)| outcome(row)?.excess.map(|e| e[0]))),
    ("excess_time", Float(|(_, row, _)| outcome(row)?.excess.map(|e| e[1]))),
    ("curve", Floats(|(_, row, _)| outcome(row).map_or_else(Vec::new, |o| o.curve.clone()))),
    ("digest", Text(|(_, row, _)| outcome(row).map(|o| o.digest.clone()))),
    ("version", Text(|_| Some(env!("CARGO_PKG_VERSION").to_owned()))),
    ("command", Text(|(opened, _, run)| Some(opened.study.command(run)))),
];

fn outcome(row: &StudyRow) -> Option<&StudyOutcome> {
    row.outcome.as_ref()
}

/// Writes the results of all shards. The file appears when it is complete; the same study gives the same bytes.
pub fn write(opened: &Opened, shards: &Shards, out: &Path) -> Result<(), Failure> {
    let part = out.with_extension("parquet.part");
    let io = |error: &_| Failure::io(out.display(), error);
    let bad = |error: ParquetError| Failure::system(format!("{}: {error}", out.display()));
    let file = File::create(&part).map_err(|error| io(&error))?;
    let kept = file.try_clone().map_err(|error| io(&error))?;
    let study = serde_json::to_string(&opened.study.spec).unwrap_or_default();
    let told = [("robovac.study", study), ("robovac.identity", opened.identity.clone())];
    let told = told.map(|(key, value)| KeyValue { key: key.to_owned(), value: Some(value) }).to_vec();
    let properties = WriterProperties::builder()
        .set_compression(Compression::SNAPPY)
        .set_created_by(concat!("robovac ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_key_value_metadata(Some(told));
    let schema = Arc::new(parse_message_type(&schema()).map_err(bad)?);
    let mut writer = SerializedFileWriter::new(file, schema, Arc::new(properties.build())).map_err(bad)?;
    let mut rows = Vec::new();
    for shard in 0..shards.count() {
        rows.extend(shards.load(shard)?);
        if rows.len() >= GROUP || shard + 1 == shards.count() {
            let group: Vec<TableRow<'_>> =
                rows.iter().filter_map(|row| Some((opened, row, opened.study.run(row.run)?))).collect();
            let mut into = writer.next_row_group().map_err(bad)?;
            put(&group, &mut into).map_err(bad)?;
            into.close().map_err(bad)?;
            rows.clear();
        }
    }
    writer.close().map_err(bad)?;
    let stored = kept.sync_all().and_then(|()| fs::rename(&part, out));
    // Before the shards are removed.
    let stored = stored.and_then(|()| flush_names(out.parent().unwrap_or(Path::new(""))));
    stored.map_err(|error| io(&error))
}

fn schema() -> String {
    let columns: Vec<String> = COLUMNS
        .iter()
        .map(|(name, value)| match value {
            Int(_) => format!("optional int64 {name};"),
            Float(_) => format!("optional double {name};"),
            Flag(_) => format!("required boolean {name};"),
            Text(_) => format!("optional binary {name} (UTF8);"),
            Floats(_) => {
                format!("required group {name} (LIST) {{ repeated group list {{ required float element; }} }}")
            }
        })
        .collect();
    format!("message run {{ {} }}", columns.concat())
}

fn put(rows: &[TableRow<'_>], group: &mut SerializedRowGroupWriter<'_, File>) -> Result<(), ParquetError> {
    for (_, value) in COLUMNS {
        let Some(mut column) = group.next_column()? else { break };
        match (value, column.untyped()) {
            (Int(of), ColumnWriter::Int64ColumnWriter(to)) => {
                let (values, levels) = optional(rows.iter().map(of));
                to.write_batch(&values, Some(&levels), None)?;
            }
            (Float(of), ColumnWriter::DoubleColumnWriter(to)) => {
                let (values, levels) = optional(rows.iter().map(of));
                to.write_batch(&values, Some(&levels), None)?;
            }
            (Flag(of), ColumnWriter::BoolColumnWriter(to)) => {
                let values: Vec<bool> = rows.iter().map(of).collect();
                to.write_batch(&values, None, None)?;
            }
            (Text(of), ColumnWriter::ByteArrayColumnWriter(to)) => {
                let texts = rows.iter().map(|row| of(row).map(|text| ByteArray::from(text.into_bytes())));
                let (values, levels) = optional(texts);
                to.write_batch(&values, Some(&levels), None)?;
            }
            (Floats(of), ColumnWriter::FloatColumnWriter(to)) => {
                let (mut values, mut levels, mut repeats) = (Vec::new(), Vec::new(), Vec::new());
                for list in rows.iter().map(of) {
                    levels.extend(list.iter().map(|_| 1).chain(list.is_empty().then_some(0)));
                    repeats.extend((0..list.len().max(1)).map(|place| i16::from(place > 0)));
                    values.extend(list);
                }
                to.write_batch(&values, Some(&levels), Some(&repeats))?;
            }
            _ => return Err(ParquetError::General("the schema doesn't fit its columns".to_owned())),
        }
        column.close()?;
    }
    Ok(())
}

/// The values that are there, and for each row whether there is one.
fn optional<T>(values: impl Iterator<Item = Option<T>>) -> (Vec<T>, Vec<i16>) {
    let mut levels = Vec::new();
    let there = values.inspect(|value| levels.push(i16::from(value.is_some()))).flatten().collect();
    (there, levels)
}
