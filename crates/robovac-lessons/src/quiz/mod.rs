//! Questions that are made from a seed, and marked.

mod figures;
mod room;

use crate::{
    LessonFault,
    fields::{BlockLines, decimal},
    fixed::short,
};
use robovac_core::rng::seeded;
use serde::Serialize;

/// Stream of the random numbers of questions.
const STREAM: u64 = 23;

/// A quiz of a lesson: questions of one kind.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Quiz {
    /// Its name in answers.
    pub id: String,
    /// The kind of its questions.
    pub about: QuizKind,
    /// How many must be answered well.
    pub rounds: u32,
}

/// A kind of question.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum QuizKind {
    /// How many cells of a room a robot reaches.
    Reachable,
    /// Whether lanes along the rows or along the columns are fewer.
    Lanes,
    /// Whether a closed walk visits every cell once.
    Parity,
    /// The median of some values.
    Median,
    /// The turn that encoder counts stand for.
    Odometry,
    /// The probability after some hits and misses.
    Logodds,
    /// The bytes of a drive command.
    Bytes,
}

/// A question.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Question {
    /// The question.
    pub text: String,
    /// A room: `#` wall, `.` floor, `S` start; rows from top to bottom. Empty if there is none.
    pub room: Vec<String>,
    /// The options to choose from; empty for a number or bytes.
    pub options: Vec<String>,
    /// What a written answer looks like.
    pub example: String,
    #[serde(skip)]
    right: Right,
    #[serde(skip)]
    because: String,
}

/// The right answer.
#[derive(Debug, Clone, PartialEq)]
enum Right {
    /// One of the options.
    Option(usize),
    /// A number, and how far off an answer may be.
    Number(f64, f64),
    /// Bytes.
    Bytes(Vec<u8>),
}

impl QuizKind {
    /// All kinds with their names in lessons.
    pub const ALL: [(Self, &str); 7] = [
        (Self::Reachable, "reachable"),
        (Self::Lanes, "lanes"),
        (Self::Parity, "parity"),
        (Self::Median, "median"),
        (Self::Odometry, "odometry"),
        (Self::Logodds, "logodds"),
        (Self::Bytes, "bytes"),
    ];

    /// The kind with that name.
    pub fn parse(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(_, known)| *known == name).map(|(kind, _)| kind)
    }

    /// The question of a seed.
    pub fn question(self, seed: u32) -> Question {
        let mut rng = seeded(u64::from(seed), STREAM);
        match self {
            Self::Reachable => room::reachable(&mut rng),
            Self::Lanes => room::lanes(&mut rng),
            Self::Parity => room::parity(&mut rng),
            Self::Median => figures::median(&mut rng),
            Self::Odometry => figures::odometry(&mut rng),
            Self::Logodds => figures::log_odds(&mut rng),
            Self::Bytes => figures::bytes(&mut rng),
        }
    }
}

impl Quiz {
    pub(crate) fn parse(fields: &mut BlockLines, rest: &str, id: String) -> Result<Self, LessonFault> {
        let about = QuizKind::parse(rest).ok_or_else(|| {
            let known = QuizKind::ALL.map(|(_, name)| name).join(", ");
            LessonFault::new(
                fields.line(),
                format!("there is no quiz \"{rest}\""),
                format!("write \"quiz\" and one of: {known}"),
            )
        })?;
        let id = fields.take("id").map_or(id, |field| field.value);
        Ok(Self { id, about, rounds: fields.number("rounds", 3.0, 1.0..=20.0)? as u32 })
    }
}

impl Question {
    /// What to give instead of an answer that can't be read; `None` if it can.
    pub fn wants(&self, answer: &str) -> Option<String> {
        let (is_read, what) = match self.right {
            Right::Option(_) => (true, ""),
            Right::Number(..) => (number(answer).is_some(), "a number"),
            Right::Bytes(_) => (bytes(answer).is_some_and(|bytes| !bytes.is_empty()), "bytes from 0 to 255"),
        };
        (!is_read).then(|| format!("Give {what}, {}.", self.example))
    }

    /// Whether an answer is right: the number of an option from 0, a number, or bytes in decimal.
    pub fn is_right(&self, answer: &str) -> bool {
        let answer = answer.trim();
        match &self.right {
            Right::Option(index) => answer.parse() == Ok(*index),
            Right::Number(value, tolerance) => {
                number(answer).is_some_and(|number| (number - value).abs() <= *tolerance)
            }
            Right::Bytes(right) => bytes(answer).is_some_and(|given| given == *right),
        }
    }

    /// The right answer as it could be written.
    pub fn right(&self) -> String {
        match &self.right {
            Right::Option(index) => index.to_string(),
            Right::Number(value, _) => short(*value),
            Right::Bytes(bytes) => bytes.iter().map(u8::to_string).collect::<Vec<_>>().join(" "),
        }
    }

    /// The right answer with its reason.
    pub fn because(&self) -> &str {
        &self.because
    }
}

/// A number with or without its unit.
fn number(answer: &str) -> Option<f64> {
    let bare = answer.trim().trim_end_matches(|c: char| !c.is_ascii_digit());
    decimal(&bare.replace(',', ".").replace('−', "-"))
}

/// Bytes in decimal, with anything between them.
fn bytes(answer: &str) -> Option<Vec<u8>> {
    let parts = answer.split(|c: char| !c.is_ascii_digit()).filter(|part| !part.is_empty());
    parts.map(str::parse).collect::<Result<Vec<u8>, _>>().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn right_answers_are_marked_right_and_others_wrong() {
        for (kind, name) in QuizKind::ALL {
            for seed in 0..40 {
                let question = kind.question(seed);
                assert!(question.is_right(&question.right()), "{name} {seed}: {question:?}");
                assert!(
                    !question.is_right("") && !question.is_right("-4711") && !question.because().is_empty(),
                    "{name} {seed}"
                );
                assert_eq!(question, kind.question(seed));
            }
            let some: Vec<Question> = (0..9).map(|seed| kind.question(seed)).collect();
            assert!(some.iter().any(|question| *question != some[0]), "{name} is always the same");
        }
    }

    #[test]
    fn both_options_occur() {
        for kind in [QuizKind::Lanes, QuizKind::Parity] {
            let rights: Vec<String> = (0..40).map(|seed| kind.question(seed).right()).collect();
            assert!(rights.contains(&"0".to_owned()) && rights.contains(&"1".to_owned()), "{kind:?}: {rights:?}");
        }
    }

    #[test]
    fn what_is_no_number_is_asked_for_again_and_is_not_wrong() {
        let question = QuizKind::Odometry.question(3);
        assert_eq!(question.wants("abc").unwrap(), "Give a number, e.g. −42.5.");
        assert_eq!((question.wants("−4.5 °"), question.wants("17,5")), (None, None));
        assert!(
            QuizKind::Bytes.question(3).wants("wheels").is_some()
                && QuizKind::Bytes.question(3).wants("145 0 300").is_some()
        );
        assert_eq!(QuizKind::Bytes.question(3).wants("145, 1, 2, 3, 4"), None);
    }

    #[test]
    fn numbers_may_be_written_with_unit_and_comma() {
        let question = QuizKind::Odometry.question(3);
        let right = question.right();
        assert!(question.is_right(&format!("{right} °")) && question.is_right(&right.replace('.', ",")), "{right}");
    }

    #[test]
    fn a_number_with_all_the_digits_of_a_calculator_was_marked_wrong() {
        let question = QuizKind::Odometry.question(3);
        let right = question.right();
        assert!(right.contains('.') && question.is_right(&format!("{right}48775592131674")), "{right}");
        assert!(!question.is_right("1234567890123456") && !question.is_right(".") && !question.is_right("1.2.3"));
    }
}
