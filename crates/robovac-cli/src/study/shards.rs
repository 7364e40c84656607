//! Finished parts of a study, each in a file of its own that appears only when it is complete.

use super::{Failure, Opened};
use robovac_sim::study::StudyRow;
use std::{
    fs::{self, File},
    io::{self, BufRead, BufReader, ErrorKind, Write},
    ops::Range,
    path::{Path, PathBuf},
    process,
};

/// Runs in a shard: a second or two of work, and not too many files for a million runs.
const RUNS: u64 = 50;
/// Tells which study the folder belongs to.
const IDENTITY: &str = "identity";

/// The folder of a study's shards.
pub struct Shards {
    folder: PathBuf,
    runs: u64,
}

impl Shards {
    /// Opens the folder beside `out`, or makes it.
    pub fn open(out: &Path, opened: &Opened) -> Result<Self, Failure> {
        let mut name = out.file_name().unwrap_or_default().to_owned();
        name.push(".shards");
        let shards = Self { folder: out.with_file_name(name), runs: opened.study.runs() };
        fs::create_dir_all(&shards.folder).map_err(|error| Failure::io(shards.folder.display(), &error))?;
        let path = shards.folder.join(IDENTITY);
        match fs::read_to_string(&path) {
            Ok(found) if found == opened.identity => Ok(shards),
            Ok(_) => Err(Failure::usage(format!(
                "{}: these shards are of another study, another map or another version of this program; delete the folder \
                 or choose another --out",
                shards.folder.display()
            ))),
            Err(error) if error.kind() == ErrorKind::NotFound => {
                shards.put(IDENTITY, opened.identity.as_bytes())?;
                Ok(shards)
            }
            Err(error) => Err(Failure::io(path.display(), &error)),
        }
    }

    /// Number of shards of the whole study.
    pub fn count(&self) -> u64 {
        count(self.runs)
    }

    /// The runs of a shard.
    pub fn runs(&self, shard: u64) -> Range<u64> {
        shard * RUNS..((shard + 1) * RUNS).min(self.runs)
    }

    /// Whether a shard is there.
    pub fn has(&self, shard: u64) -> bool {
        self.folder.join(name(shard)).exists()
    }

    /// Stores a shard. When this returns, it survives a crash of the machine; until then, there is none of it.
    pub fn store(&self, shard: u64, rows: &[StudyRow]) -> Result<(), Failure> {
        let mut text = Vec::new();
        for row in rows {
            serde_json::to_writer(&mut text, row).map_err(|error| Failure::system(error.to_string()))?;
            text.push(b'\n');
        }
        self.put(&name(shard), &text)
    }

    /// The rows of a shard.
    pub fn load(&self, shard: u64) -> Result<Vec<StudyRow>, Failure> {
        let path = self.folder.join(name(shard));
        let unread = |error: &_| Failure::io(path.display(), error);
        let damaged = || Failure::system(format!("{}: this shard is damaged; delete it and run again", path.display()));
        let mut rows = Vec::new();
        for line in BufReader::new(File::open(&path).map_err(|error| unread(&error))?).lines() {
            let line = line.map_err(|error| unread(&error))?;
            rows.push(serde_json::from_str::<StudyRow>(&line).map_err(|_| damaged())?);
        }
        if rows.iter().map(|row| row.run).eq(self.runs(shard)) { Ok(rows) } else { Err(damaged()) }
    }

    /// Removes the folder.
    pub fn remove(&self) -> Result<(), Failure> {
        fs::remove_dir_all(&self.folder).map_err(|error| Failure::io(self.folder.display(), &error))
    }

    fn put(&self, name: &str, bytes: &[u8]) -> Result<(), Failure> {
        let path = self.folder.join(name);
        // Another process that makes the same shard writes the same bytes.
        let part = self.folder.join(format!(".{name}.{}", process::id()));
        let write = || {
            let mut file = File::create(&part)?;
            file.write_all(bytes)?;
            file.sync_all()?;
            fs::rename(&part, &path)?;
            flush_names(&self.folder)
        };
        write().map_err(|error| Failure::io(path.display(), &error))
    }
}

/// Puts new names in a folder on the disk, too. Only Unix can open a folder.
pub fn flush_names(folder: &Path) -> io::Result<()> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    if cfg!(unix) { File::open(folder)?.sync_all() } else { Ok(()) }
}

/// Number of shards of so many runs.
pub fn count(runs: u64) -> u64 {
    runs.div_ceil(RUNS)
}

fn name(shard: u64) -> String {
    format!("{shard:08}.jsonl")
}
