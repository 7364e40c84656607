//! Lessons: one Markdown file each, with fenced blocks that the page and the command line understand.
//!
//! [`Lesson::parse`] turns the text into [`LessonBlock`]s: safe HTML, scenes, questions, goals, measurements. A [`Goal`] is a
//! condition on the numbers of many runs; since runs are repeatable to the bit, anybody can check an [`Answer`] again:
//! the page in its workers, `robovac grade` natively. Docs: docs/teaching.md.
//!
//! ```
//! use robovac_lessons::{Lesson, LessonBlock};
//!
//! let text = "# Corners\n\nWatch **one** run.\n\n```goal\nin: room=empty&robot=roomba600&behaviour=bounce\nneed: median coverage >= 60 %\nminutes: 5\n```\n";
//! let lesson = Lesson::parse(text).unwrap();
//! assert_eq!(lesson.title, "Corners");
//! assert!(matches!(&lesson.blocks[..], [LessonBlock::Prose { html }, LessonBlock::Goal(goal)]
//!     if html.contains("<strong>one</strong>") && goal.minutes == 5.0));
//! ```

mod answer;
mod fault;
mod fields;
mod fixed;
mod goal;
mod grade;
mod lesson;
mod link;
mod measure;
mod names;
mod number;
mod parse;
mod prose;
mod quiz;

pub use answer::{Answer, GoalAnswer, QuizAnswer, RunRecord, digest};
pub use fault::LessonFault;
pub use goal::{Goal, Judged, Need, Statistic, Verdict};
pub use grade::{GoalGrade, GradedAnswer, Job, Misfit, QuizGrade, check};
pub use lesson::{Choice, Lesson, LessonBlock, LessonScene};
pub use link::Link;
pub use measure::{Measure, MeasureRow};
pub use names::KnownNames;
pub use number::Number;
pub use prose::safe_html;
pub use quiz::{Question, Quiz, QuizKind};
