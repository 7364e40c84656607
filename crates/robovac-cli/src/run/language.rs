//! How a program's file is run: by which interpreter, with which package.

use super::runtimes::{JAVASCRIPT, PYTHON};
use crate::failure::Failure;
use robovac_core::program::ProgramLanguage;
use std::{
    fs, io,
    path::{Path, PathBuf},
    process::Command,
};

/// What runs a program.
pub struct Language {
    words: Vec<String>,
    variables: Vec<(&'static str, PathBuf)>,
    /// Where the runtime is, until the end.
    folder: Option<Folder>,
}

/// A folder of its own that goes with the program.
struct Folder(PathBuf);

impl Language {
    /// For the file `program`: by its ending, or by the user's own `command`, which gets the file as its last argument.
    pub fn of(program: &Path, command: Option<&str>) -> Result<Self, Failure> {
        let file = program.to_string_lossy().into_owned();
        if let Some(command) = command {
            let mut words: Vec<String> = command.split_whitespace().map(str::to_owned).collect();
            if words.is_empty() {
                return Err(Failure::usage("--command is empty; name a program, e.g. --command ./client".to_owned()));
            }
            words.push(file);
            return Ok(Self { words, variables: Vec::new(), folder: None });
        }
        let ending = program.extension().map(|ending| ending.to_string_lossy().to_lowercase()).unwrap_or_default();
        match &*ending {
            "py" => {
                let folder = Folder::with(PYTHON)?;
                let python = if cfg!(windows) { "python" } else { "python3" };
                Ok(Self {
                    words: [python, "-u", "-B", "-m", "robovac_program", &file].map(str::to_owned).to_vec(),
                    variables: vec![("PYTHONPATH", folder.0.join("python"))],
                    folder: Some(folder),
                })
            }
            "js" | "mjs" => {
                let folder = Folder::with(JAVASCRIPT)?;
                let runner = folder.0.join("javascript").join("node.js").to_string_lossy().into_owned();
                Ok(Self { words: vec!["node".to_owned(), runner, file], variables: Vec::new(), folder: Some(folder) })
            }
            _ => Err(Failure::usage(format!(
                "{file} ends neither in .py nor in .js; say with --command what runs it, e.g. --command ./client"
            ))),
        }
    }

    /// For the text of a program, which is kept in a file for as long as this.
    pub fn of_text(language: ProgramLanguage, source: &str) -> Result<Self, Failure> {
        let name = match language {
            ProgramLanguage::Python => "program.py",
            ProgramLanguage::JavaScript => "program.js",
        };
        let mut found = Self::of(Path::new(name), None)?;
        if let (Some(folder), Some(file)) = (&found.folder, found.words.last_mut()) {
            let path = folder.0.join(name);
            fs::write(&path, source).map_err(|error| Failure::io(path.display(), &error))?;
            *file = path.to_string_lossy().into_owned();
        }
        Ok(found)
    }

    /// The interpreter and its arguments.
    pub fn words(&self) -> &[String] {
        &self.words
    }

    /// Variables of its environment.
    pub fn variables(&self) -> impl Iterator<Item = (&str, &Path)> {
        self.variables.iter().map(|(key, value)| (*key, value.as_path()))
    }

    /// The folder with all that the program needs; none for a command of the user's own.
    pub fn folder(&self) -> Option<&Path> {
        self.folder.as_ref().map(|folder| folder.0.as_path())
    }

    /// The command, to be started.
    pub fn command(&self) -> Command {
        let mut words = self.words.iter();
        let mut command = Command::new(words.next().map_or("", String::as_str));
        command.args(words).envs(self.variables());
        command
    }
}

impl Folder {
    /// These files in a new folder that only this user can change.
    fn with(files: &[(&str, &str)]) -> Result<Self, Failure> {
        let failed = |path: &Path, error: &io::Error| Failure::io(path.display(), error);
        let mut name = [0; 8];
        getrandom::fill(&mut name).map_err(|error| Failure::system(format!("no random numbers: {error}")))?;
        let path = std::env::temp_dir().join(format!("robovac-run-{:016x}", u64::from_le_bytes(name)));
        let mut builder = fs::DirBuilder::new();
        #[cfg(unix)]
        std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
        builder.create(&path).map_err(|e| failed(&path, &e))?;
        let folder = Self(path);
        for (name, text) in files {
            let file = folder.0.join(name);
            if let Some(parent) = file.parent() {
                fs::create_dir_all(parent).map_err(|e| failed(parent, &e))?;
            }
            fs::write(&file, text).map_err(|e| failed(&file, &e))?;
        }
        Ok(folder)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}
