//! A lesson and its blocks.

use crate::{Goal, LessonFault, Measure, Quiz};
use serde::Serialize;

/// A lesson.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Lesson {
    /// Its name in links and answers: small letters, digits, dashes.
    pub id: String,
    /// Its heading.
    pub title: String,
    /// How long it takes, min; 0 if unknown.
    pub minutes: f64,
    /// For whom it is; can be empty.
    pub audience: String,
    /// What one can do afterwards.
    pub outcomes: Vec<String>,
    /// Labels of the page's numbers and controls that it explains; the definitions there lead to it.
    pub explains: Vec<String>,
    /// Sources, as safe HTML.
    pub sources: Vec<String>,
    /// Digest of the text.
    pub digest: String,
    /// Its content, in order.
    pub blocks: Vec<LessonBlock>,
    /// All settings links that it opens or runs, each with its line.
    #[serde(skip)]
    pub links: Vec<(usize, String)>,
    /// What its author may want otherwise, although it works.
    #[serde(skip)]
    pub notes: Vec<LessonFault>,
}

/// A part of a lesson.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum LessonBlock {
    /// Text.
    Prose {
        /// Safe HTML.
        html: String,
    },
    /// Settings or a scenario to be opened.
    Scene(LessonScene),
    /// A question whose answer is committed before the run.
    Predict(Choice),
    /// A button that sets something and plays.
    Do {
        /// What is on it.
        label: String,
        /// Settings, as in links; can be empty.
        link: String,
    },
    /// A task.
    Goal(Goal),
    /// Help that is opened by the learner.
    Hint {
        /// Safe HTML.
        html: String,
    },
    /// A program.
    Code {
        /// `python` or `javascript`.
        language: String,
        /// Its text.
        text: String,
    },
    /// A table that fills itself.
    Measure(Measure),
    /// Questions made by the page.
    Quiz(Quiz),
}

/// A scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct LessonScene {
    /// Its name for goals; can be empty.
    pub id: String,
    /// What is on its button.
    pub title: String,
    /// Settings, as in links; empty for a scenario.
    pub link: String,
    /// The text of a scenario file; empty for a link.
    pub scenario: String,
}

/// A question with options.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Choice {
    /// Its name in answers.
    pub id: String,
    /// The question.
    pub question: String,
    /// The options.
    pub options: Vec<String>,
    /// Index of the right one.
    pub right: usize,
    /// Why, as safe HTML.
    pub because: String,
}

impl Lesson {
    /// The goals, in order.
    pub fn goals(&self) -> impl Iterator<Item = &Goal> {
        self.blocks.iter().filter_map(|block| if let LessonBlock::Goal(goal) = block { Some(goal) } else { None })
    }

    /// The quizzes, in order.
    pub fn quizzes(&self) -> impl Iterator<Item = &Quiz> {
        self.blocks.iter().filter_map(|block| if let LessonBlock::Quiz(quiz) = block { Some(quiz) } else { None })
    }

    /// The scenario of a goal's scene, if it has one.
    pub fn scenario_of(&self, goal: &Goal) -> Option<&str> {
        let id = goal.scene.as_deref()?;
        self.blocks.iter().find_map(|block| match block {
            LessonBlock::Scene(scene) if scene.id == id && !scene.scenario.is_empty() => Some(scene.scenario.as_str()),
            _ => None,
        })
    }
}
