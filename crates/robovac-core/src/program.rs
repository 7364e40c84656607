//! A user's program: its text, and what it is.

use serde::{Deserialize, Serialize};

/// Longest text of a program, bytes.
pub const MOST_PROGRAM: usize = 200_000;
/// Longest name of a program, letters.
pub const MOST_PROGRAM_NAME: usize = 80;

/// A program that a user wrote.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub struct Program {
    /// Name in lists and of its file, without an ending.
    pub name: String,
    /// Its language.
    pub language: ProgramLanguage,
    /// What it does.
    pub kind: ProgramKind,
    /// Its text.
    pub source: String,
}

/// Languages of programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum ProgramLanguage {
    /// Python.
    Python,
    /// JavaScript.
    JavaScript,
}

/// Kinds of programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum ProgramKind {
    /// Drives the robot from its sensor readings.
    Behaviour,
    /// Plans a walk over the cells of a grid.
    Planner,
}

/// Reasons why a program isn't accepted.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ProgramFault {
    /// The text is too long.
    #[error("the program has {found} bytes, more than the {MOST_PROGRAM} that are kept; make it shorter")]
    TooLong {
        /// Its length, bytes.
        found: usize,
    },
    /// The name is empty or too long.
    #[error("the program's name has {found} letters; give it 1 to {MOST_PROGRAM_NAME}")]
    Name {
        /// Its length, letters.
        found: usize,
    },
}

impl Program {
    /// Checks the sizes.
    pub fn check(&self) -> Result<(), ProgramFault> {
        let letters = self.name.chars().count();
        if letters == 0 || letters > MOST_PROGRAM_NAME {
            return Err(ProgramFault::Name { found: letters });
        }
        if self.source.len() > MOST_PROGRAM {
            return Err(ProgramFault::TooLong { found: self.source.len() });
        }
        Ok(())
    }
}

impl Program {
    /// A number that differs for other programs, whatever their names (FNV-1a).
    pub fn fingerprint(&self) -> u64 {
        let bytes = self.source.bytes().chain([self.language as u8, self.kind as u8]);
        bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
    }
}

impl ProgramLanguage {
    /// Both, with their names in files.
    pub const ALL: [(Self, &'static str); 2] = [(Self::Python, "python"), (Self::JavaScript, "javascript")];

    /// Its name in files.
    pub fn id(self) -> &'static str {
        Self::ALL[self as usize].1
    }

    /// The language with that name.
    pub fn parse(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(_, name)| *name == id).map(|(language, _)| language)
    }
}

impl ProgramKind {
    /// Both, with their names in files.
    pub const ALL: [(Self, &'static str); 2] = [(Self::Behaviour, "behaviour"), (Self::Planner, "planner")];

    /// Its name in files.
    pub fn id(self) -> &'static str {
        Self::ALL[self as usize].1
    }

    /// The kind with that name.
    pub fn parse(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(_, name)| *name == id).map(|(kind, _)| kind)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_come_back_and_sizes_are_limited() {
        for (language, id) in ProgramLanguage::ALL {
            assert_eq!((language.id(), ProgramLanguage::parse(id)), (id, Some(language)));
        }
        for (kind, id) in ProgramKind::ALL {
            assert_eq!((kind.id(), ProgramKind::parse(id)), (id, Some(kind)));
        }
        let program = Program {
            name: "Wall".into(),
            language: ProgramLanguage::Python,
            kind: ProgramKind::Behaviour,
            source: "x".repeat(MOST_PROGRAM),
        };
        assert_eq!(program.check(), Ok(()));
        let longer = Program { source: "x".repeat(MOST_PROGRAM + 1), ..program.clone() };
        assert_eq!(longer.check(), Err(ProgramFault::TooLong { found: MOST_PROGRAM + 1 }));
        assert_eq!(Program { name: String::new(), ..program }.check(), Err(ProgramFault::Name { found: 0 }));
    }
}
