//! `study`: all runs of a study on all cores, stored so that nothing is lost when it is stopped.

pub mod benchmark;
mod shards;
mod table;
mod work;

use super::{failure::Failure, source::load_with_image};
use robovac_sim::study::{Study, StudyError, StudyRoom, fingerprint};
use shards::Shards;
use std::{
    fs,
    path::{Path, PathBuf},
    thread,
};

/// Make all runs of a study file (see docs/studies.md) and write their results as Parquet. A stopped study continues
/// where it left off
#[derive(clap::Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct Arguments {
    #[command(subcommand)]
    command: Option<StudyCommand>,
    /// Study file: JSON, see docs/study.schema.json
    #[arg(required = true)]
    study: Option<PathBuf>,
    /// Results; until they are complete, the shards are in a folder of the same name with .shards appended
    #[arg(long, value_name = "FILE", required = true)]
    out: Option<PathBuf>,
    /// Make only part I of N, on one of N machines; "robovac study merge" merges them when all are there
    #[arg(long, value_name = "I/N", value_parser = parse_part)]
    shard: Option<(u64, u64)>,
    /// Runs in parallel [default: one per core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    jobs: Option<u16>,
}

#[derive(clap::Subcommand)]
enum StudyCommand {
    /// Write the results of a study when all its shards are there
    Merge(Files),
    /// Check a study file and count its runs, without making any
    Check {
        /// Study file
        study: PathBuf,
    },
}

#[derive(clap::Args)]
struct Files {
    /// Study file
    study: PathBuf,
    /// Results, as given to the command that made the shards
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

/// A study with the folder of its file and what tells it from others.
struct Opened {
    study: Study,
    folder: PathBuf,
    identity: String,
}

/// Makes the runs, or merges.
pub fn run(arguments: &Arguments) -> Result<String, Failure> {
    match &arguments.command {
        Some(StudyCommand::Check { study }) => {
            let study = open(study)?.study;
            let (runs, rooms) = (study.runs(), study.rooms().len());
            Ok(format!("{runs} runs in {rooms} rooms, {} shards\n", shards::count(runs)))
        }
        Some(StudyCommand::Merge(Files { study, out })) => {
            let opened = open(study)?;
            merge(&opened, &Shards::open(out, &opened)?, out)
        }
        None => make(arguments),
    }
}

fn make(arguments: &Arguments) -> Result<String, Failure> {
    let Arguments { study: Some(study), out: Some(out), shard, jobs, .. } = arguments else {
        return Err(Failure::usage("give a study file and --out".to_owned()));
    };
    let opened = open(study)?;
    if out.exists() {
        let out = out.display();
        return Err(Failure::usage(format!("--out {out}: the file exists; choose another name or delete it")));
    }
    let shards = Shards::open(out, &opened)?;
    let jobs = jobs.map_or_else(|| thread::available_parallelism().map_or(1, usize::from), usize::from);
    let (part, parts) = shard.unwrap_or((1, 1));
    work::make_shards(&opened, &shards, (part - 1, parts), jobs)?;
    if parts > 1 {
        return Ok(format!("part {part} of {parts} is done; \"robovac study merge\" writes the results of all\n"));
    }
    merge(&opened, &shards, out)
}

fn merge(opened: &Opened, shards: &Shards, out: &Path) -> Result<String, Failure> {
    let count = shards.count();
    if let Some(missing) = (0..count).find(|&shard| !shards.has(shard)) {
        let left = (missing..count).filter(|&shard| !shards.has(shard)).count();
        return Err(Failure::usage(format!(
            "{left} of {count} shards are missing; run \"robovac study\" without --shard, or run the missing parts"
        )));
    }
    table::write(opened, shards, out)?;
    shards.remove()?;
    Ok(format!("{}: {} runs\n", out.display(), opened.study.runs()))
}

fn open(path: &Path) -> Result<Opened, Failure> {
    let bytes = fs::read(path).map_err(|error| Failure::io(path.display(), &error))?;
    read(path, &bytes)
}

/// A study of those bytes, as if they were in the file `path`.
fn read(path: &Path, bytes: &[u8]) -> Result<Opened, Failure> {
    let study = Study::read(&path.display().to_string(), bytes)?;
    let folder = path.parent().unwrap_or(Path::new("")).to_owned();
    // The same study gives the same results only with the same program and the same maps.
    let mut parts = vec![env!("CARGO_PKG_VERSION").as_bytes().to_vec()];
    parts.push(serde_json::to_vec(&study.spec).unwrap_or_default());
    for room in study.rooms() {
        if let StudyRoom::File(name) = room {
            let map = folder.join(name);
            load_with_image(&map)?;
            parts.push(fs::read(&map).map_err(|error| Failure::io(map.display(), &error))?);
        }
    }
    let identity = format!("{:016x}", fingerprint(parts.iter().map(Vec::as_slice)));
    Ok(Opened { study, folder, identity })
}

fn parse_part(text: &str) -> Result<(u64, u64), String> {
    let part = text.split_once('/').and_then(|(part, parts)| Some((part.parse().ok()?, parts.parse().ok()?)));
    let part = part.filter(|&(part, parts)| (1..=parts).contains(&part));
    part.ok_or_else(|| "give the part and the number of parts, as in 2/8".to_owned())
}

impl From<StudyError> for Failure {
    fn from(error: StudyError) -> Self {
        Self::usage(error.to_string())
    }
}
