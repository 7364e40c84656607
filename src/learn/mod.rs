//! The module `learn`: lessons, their goals and quizzes. It plans and simulates nothing: runs are made by the workshop's
//! workers.

use robovac_lessons::{Goal, KnownNames, Lesson, LessonBlock, LessonFault, Measure, QuizKind};
use robovac_playground::wire::{message, to_js};
use robovac_sim::montecarlo::RunOutcome;
use wasm_bindgen::prelude::*;

/// A lesson that was read.
#[wasm_bindgen(js_name = LessonText)]
pub struct LessonText {
    lesson: Lesson,
}

#[wasm_bindgen(js_class = LessonText)]
impl LessonText {
    /// Reads a lesson; throws a message that names line, cause and mend.
    #[wasm_bindgen(constructor)]
    pub fn new(text: &str) -> Result<Self, JsValue> {
        Ok(Self { lesson: Lesson::parse(text).map_err(message)? })
    }

    /// All of it, to be shown.
    #[wasm_bindgen(unchecked_return_type = "rust.Lesson")]
    pub fn view(&self) -> Result<JsValue, JsValue> {
        to_js(&self.lesson)
    }

    /// What its author may want otherwise, and names in its links that aren't among these (joined by ", "), each with its line.
    pub fn notes(&self, rooms: String, robots: String, planners: String, behaviours: String) -> Vec<String> {
        let unknown = self.lesson.unknown(&KnownNames { rooms, robots, planners, behaviours });
        unknown.iter().chain(&self.lesson.notes).map(LessonFault::to_string).collect()
    }

    /// The runs that check the answer `link` to a goal, for part `index` of `parts` of the lesson's seeds; pass them to
    /// `Runner.run` in a worker.
    #[wasm_bindgen(unchecked_return_type = "{ id: number }")]
    pub fn request(&self, goal: &str, link: &str, index: usize, parts: usize) -> Result<JsValue, JsValue> {
        let goal = self.goal(goal)?;
        let seeds = goal.seeds();
        let begins = |part: usize| seeds.len() * part / parts.max(1);
        let seeds = seeds.get(begins(index)..begins(index + 1)).unwrap_or_default().to_vec();
        to_js(&goal.request(link, self.lesson.scenario_of(goal), seeds))
    }

    /// Where a program drives that answers a goal: the settings without the algorithm.
    pub fn place(&self, goal: &str, link: &str) -> Result<String, JsValue> {
        let settings = self.goal(goal)?.settings(link).0;
        Ok(settings.keeping(|key| !matches!(key, "planner" | "behaviour") && !key.starts_with("p.")).to_string())
    }

    /// What of the answer `link` doesn't count, as it may not be changed.
    pub fn ignored(&self, goal: &str, link: &str) -> Result<Vec<String>, JsValue> {
        Ok(self.goal(goal)?.settings(link).1)
    }

    /// Whether runs, the results of `Runner.run` in the order of seeds, reach a goal.
    #[wasm_bindgen(unchecked_return_type = "rust.Verdict")]
    pub fn judge(&self, goal: &str, outcomes: &[f64]) -> Result<JsValue, JsValue> {
        to_js(&self.goal(goal)?.judge(&RunOutcome::from_numbers(outcomes)))
    }

    /// The runs of a row of the measurement that is the block with this index.
    #[wasm_bindgen(unchecked_return_type = "{ id: number } | undefined")]
    pub fn measure(&self, block: usize, row: usize) -> Result<JsValue, JsValue> {
        let request = self.table(block).and_then(|table| table.request(row));
        request.map_or(Ok(JsValue::UNDEFINED), |request| to_js(&request))
    }

    /// The cells of that row.
    #[wasm_bindgen(unchecked_return_type = "(number | null)[]")]
    pub fn cells(&self, block: usize, outcomes: &[f64]) -> Result<JsValue, JsValue> {
        let runs = RunOutcome::from_numbers(outcomes);
        to_js(&self.table(block).map(|table| table.cells(&runs)).unwrap_or_default())
    }

    fn goal(&self, id: &str) -> Result<&Goal, JsValue> {
        self.lesson.goals().find(|goal| goal.id == id).ok_or_else(|| message("the lesson has no such goal"))
    }

    fn table(&self, block: usize) -> Option<&Measure> {
        self.lesson
            .blocks
            .get(block)
            .and_then(|block| if let LessonBlock::Measure(table) = block { Some(table) } else { None })
    }
}

/// The question of a kind and a seed; throws for unknown kinds.
#[wasm_bindgen(unchecked_return_type = "rust.Question")]
pub fn question(kind: &str, seed: u32) -> Result<JsValue, JsValue> {
    to_js(&quiz(kind)?.question(seed))
}

/// Marks an answer: `[right, reason]`; `[null, what to give instead]` if it can't be read.
#[wasm_bindgen(unchecked_return_type = "[boolean | null, string]")]
pub fn mark(kind: &str, seed: u32, answer: &str) -> Result<JsValue, JsValue> {
    let question = quiz(kind)?.question(seed);
    match question.wants(answer) {
        Some(wanted) => to_js(&(None::<bool>, wanted)),
        None => to_js(&(Some(question.is_right(answer)), question.because())),
    }
}

fn quiz(kind: &str) -> Result<QuizKind, JsValue> {
    QuizKind::parse(kind).ok_or_else(|| message("there is no such quiz"))
}
