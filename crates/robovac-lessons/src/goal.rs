//! A goal: a condition on the numbers of many runs.

use crate::{
    LessonFault, Link, Number,
    answer::RunRecord,
    fields::{BlockLine, BlockLines, decimal},
    fixed::short,
};
use robovac_sim::montecarlo::{RunOutcome, RunsRequest, quantile};
use serde::Serialize;

/// Longest run of a lesson, min, and most seeds.
const MOST_MINUTES: f64 = 600.0;
const MOST_RUNS: f64 = 1000.0;

/// What a learner may change: names in lessons, and the keys of links that each stands for.
const CHANGES: [(&str, &[&str]); 9] = [
    ("algorithm", &["p."]),
    ("program", &[]),
    ("params", &["p."]),
    ("cell", &["cell"]),
    ("robot", &["robot", "own", "twin", "cell"]),
    ("start", &["start"]),
    ("odometry", &["odometry"]),
    ("plan seed", &["seed"]),
    ("charge", &["charge"]),
];

/// A task: settings to start from, what may be changed, and the condition.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Goal {
    /// Its name in answers.
    pub id: String,
    /// What to achieve, in a sentence; empty if the condition says it all.
    pub title: String,
    /// The settings to start from, as in links; they miss the goal.
    pub start: String,
    /// The room, if `start` names none: the id of a scene with a scenario.
    pub scene: Option<String>,
    /// Names of what may be changed.
    pub changes: Vec<String>,
    /// The seeds: the first, and how many.
    pub first_seed: u64,
    /// Number of runs.
    pub runs: u64,
    /// Simulated time of each run, min.
    pub minutes: f64,
    /// All must hold.
    pub needs: Vec<Need>,
}

/// One condition.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Need {
    /// As it was written.
    pub text: String,
    /// Over the runs.
    pub statistic: Statistic,
    /// What is measured.
    pub number: Number,
    /// Whether at least `value` is needed; else at most.
    pub at_least: bool,
    /// The limit, in the number's unit.
    pub value: f64,
}

/// How the numbers of several runs become one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "snake_case")]
pub enum Statistic {
    /// The median.
    Median,
    /// The worst run.
    Every,
    /// The best run.
    Best,
}

/// Whether a goal is reached, and by what numbers.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Verdict {
    /// Whether all conditions hold.
    pub passed: bool,
    /// Each condition.
    pub needs: Vec<Judged>,
    /// Each run.
    pub runs: Vec<RunRecord>,
}

/// A condition and what was measured.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Judged {
    /// The condition.
    pub text: String,
    /// The measured value, in the number's unit; `None` if too few runs got there.
    pub value: Option<f64>,
    /// Its unit.
    pub unit: &'static str,
    /// Whether it holds.
    pub passed: bool,
}

impl Goal {
    /// Reads the block; `id` if it has none.
    pub(crate) fn parse(fields: &mut BlockLines, id: String) -> Result<Self, LessonFault> {
        let start = fields.need("in", "room=living&behaviour=bounce")?;
        needs_robot(&start)?;
        let scene = fields.take("scene").map(|field| field.value);
        if scene.is_none() {
            needs_room(&start, ", or \"scene: \" with the id of a scene that is a scenario")?;
        }
        let changes = match fields.take("change") {
            None => vec!["algorithm".to_owned(), "cell".to_owned()],
            Some(field) => changes(&field)?,
        };
        let minutes = fields.number("minutes", 20.0, 0.1..=MOST_MINUTES)?;
        let needs = fields.take_all("need");
        let needs: Vec<Need> = needs.iter().map(|need| Need::parse(need, minutes)).collect::<Result<_, _>>()?;
        if needs.is_empty() {
            return Err(fields.lack("need", "median coverage >= 95 %"));
        }
        Ok(Self {
            id: fields.take("id").map_or(id, |field| field.value),
            title: fields.text("title"),
            start: start.value,
            scene,
            changes,
            first_seed: fields.number("seed", 1.0, 0.0..=f64::from(u32::MAX))? as u64,
            runs: fields.number("runs", 20.0, 1.0..=MOST_RUNS)? as u64,
            minutes,
            needs,
        })
    }

    /// The lesson's seeds.
    pub fn seeds(&self) -> Vec<u64> {
        (self.first_seed..self.first_seed + self.runs).collect()
    }

    /// The settings that count: those of the task, with what the answer `link` may change. Second, what else the answer
    /// has changed: it does not count.
    pub fn settings(&self, link: &str) -> (Link, Vec<String>) {
        let (start, answer) = (Link::parse(&self.start), Link::parse(link));
        let has = |name: &str| self.changes.iter().any(|own| own == name);
        let choice = if answer.is_program() { "program" } else { "algorithm" };
        let keys: Vec<&str> = CHANGES
            .iter()
            .filter(|(name, _)| has(name))
            .flat_map(|(_, keys)| *keys)
            .copied()
            .chain(["planner", "behaviour"].into_iter().filter(|_| has(choice)))
            .collect();
        let may = |key: &str| keys.iter().any(|known| *known == key || *known == "p." && key.starts_with("p."));
        let algorithm = |link: &Link| ["planner", "behaviour"].map(|key| link.get(key).map(str::to_owned));
        let names_one = algorithm(&answer).iter().any(Option::is_some);
        // Parameters belong to the algorithm of the task unless that is the learner's choice.
        let is_same = names_one && (algorithm(&start) == algorithm(&answer) || may("planner"));
        let takes = |key: &str| may(key) && (is_same || !key.starts_with("p."));
        // Links leave defaults out: what the answer may change and doesn't name has its default.
        let stays =
            |key: &str| matches!(key, "planner" | "behaviour" | "robot" | "own" | "twin" | "cell") || !takes(key);
        let over: Vec<String> =
            answer.pairs().filter(|(key, _)| takes(key)).map(|(key, value)| format!("{key}={value}")).collect();
        let fixed = ["room", "robot", "planner", "behaviour", "slip", "charge", "quantised", "odometry"];
        let own = |key: &str| start.get(key).unwrap_or_else(|| if key == "room" { "own" } else { usual(key) });
        let differs = |key: &str| {
            let given = answer.get(key).unwrap_or_else(|| usual(key));
            // The page doesn't name the flat in every link.
            let is_other_flat = key == "room" && answer.flat().is_some() && start.flat() != answer.flat();
            let is_other = own(key) != given || is_other_flat;
            !may(key) && !given.is_empty() && is_other
        };
        let ignored = fixed.into_iter().filter(|key| differs(key)).map(str::to_owned).collect();
        (start.keeping(stays).with(&Link::parse(&over.join("&"))), ignored)
    }

    /// The runs that check an answer. `scenario` is that of the goal's scene.
    pub fn request(&self, link: &str, scenario: Option<&str>, seeds: Vec<u64>) -> RunsRequest {
        self.settings(link).0.request(scenario, 60.0 * self.minutes, seeds)
    }

    /// Whether the runs reach the goal.
    pub fn judge(&self, runs: &[RunOutcome]) -> Verdict {
        let needs: Vec<Judged> = self.needs.iter().map(|need| need.judge(runs)).collect();
        let passed = !runs.is_empty() && needs.iter().all(|need| need.passed);
        Verdict { passed, needs, runs: runs.iter().map(RunRecord::of).collect() }
    }
}

/// Fails unless a link of runs names a robot: without, it would be whichever was chosen before.
pub(crate) fn needs_robot(field: &BlockLine) -> Result<(), LessonFault> {
    if Link::parse(&field.value).get("robot").is_some() {
        return Ok(());
    }
    Err(LessonFault::new(field.line, "the link of \"in\" names no robot", "add e.g. \"&robot=roomba600\""))
}

/// Fails unless a link of runs names a room that is the same for everybody.
pub(crate) fn needs_room(field: &BlockLine, or: &str) -> Result<(), LessonFault> {
    let link = Link::parse(&field.value);
    match link.get("room") {
        Some("own") if link.flat().is_none() => {
            let what = "the link of \"in\" has a room of your own, which others lack";
            let mend = format!("use a room of the menu, or a generated flat by a copied link{or}");
            Err(LessonFault::new(field.line, what, mend))
        }
        Some(_) => Ok(()),
        None => {
            let mend = format!("add e.g. \"room=living&\" in front{or}");
            Err(LessonFault::new(field.line, "the link of \"in\" names no room", mend))
        }
    }
}

/// What a setting is if a link doesn't name it; "" for those that every goal names.
fn usual(key: &str) -> &'static str {
    match key {
        "slip" => "none",
        "charge" => "100",
        "quantised" => "false",
        "odometry" => "arc",
        _ => "",
    }
}

fn changes(field: &BlockLine) -> Result<Vec<String>, LessonFault> {
    let names: Vec<String> = field.value.split(',').map(|name| name.trim().to_owned()).collect();
    match names.iter().find(|name| CHANGES.iter().all(|(known, _)| known != name)) {
        None => Ok(names),
        Some(name) => {
            let mend = format!("use some of: {}", CHANGES.map(|(known, _)| known).join(", "));
            Err(LessonFault::new(field.line, format!("\"change\" can't change \"{name}\""), mend))
        }
    }
}

impl Need {
    fn parse(field: &BlockLine, minutes: f64) -> Result<Self, LessonFault> {
        let wrong = |what: String| {
            let mend = format!("write e.g. \"median coverage >= 95 %\"; numbers are: {}", Number::names());
            LessonFault::new(field.line, what, mend)
        };
        let text = field.value.replace('≥', ">=").replace('≤', "<=");
        let (at_least, parts) = match (text.split_once(">="), text.split_once("<=")) {
            (Some(parts), None) => (true, parts),
            (None, Some(parts)) => (false, parts),
            _ => return Err(wrong("a condition needs one >= or <=".to_owned())),
        };
        let (statistic, name) = parts.0.trim().split_once(' ').unwrap_or((parts.0.trim(), ""));
        let statistic = match statistic {
            "median" => Statistic::Median,
            "every" => Statistic::Every,
            "best" => Statistic::Best,
            other => return Err(wrong(format!("a condition begins with median, every or best, not \"{other}\""))),
        };
        let number =
            Number::parse(name.trim()).ok_or_else(|| wrong(format!("there is no number \"{}\"", name.trim())))?;
        let limit = parts.1.trim();
        let bare = limit.strip_suffix(number.unit()).unwrap_or(limit).trim();
        let value = decimal(bare);
        let value =
            value.ok_or_else(|| wrong(format!("\"{limit}\" isn't a number in the unit \"{}\"", number.unit())))?;
        let can_be = match number {
            Number::Coverage | Number::DirtLeft => Some((100.0, "a share is from 0 to 100 %".to_owned())),
            Number::Time | Number::TimeTo90 | Number::TimeTo99 => {
                Some((minutes, format!("the runs end after {} min; see \"minutes\"", short(minutes))))
            }
            Number::Distance | Number::Bumps | Number::Falls => Some((f64::INFINITY, "it is never below 0".to_owned())),
            Number::ExcessDistance | Number::ExcessTime => None,
        };
        if let Some((_, why)) = can_be.filter(|(most, _)| !(0.0..=*most).contains(&value)) {
            return Err(LessonFault::new(field.line, format!("\"{}\" decides nothing", field.value), why));
        }
        Ok(Self { text: field.value.clone(), statistic, number, at_least, value })
    }

    fn judge(&self, runs: &[RunOutcome]) -> Judged {
        // What a run did not reach counts as worst.
        let worst = if self.at_least { f64::NEG_INFINITY } else { f64::INFINITY };
        let mut values: Vec<f64> = runs.iter().map(|run| self.number.of(run).unwrap_or(worst)).collect();
        values.sort_unstable_by(f64::total_cmp);
        let value = match (self.statistic, self.at_least) {
            (Statistic::Median, _) => quantile(&values, 0.5),
            (Statistic::Every, true) | (Statistic::Best, false) => values.first().copied(),
            (Statistic::Every, false) | (Statistic::Best, true) => values.last().copied(),
        };
        let value = value.filter(|value| value.is_finite());
        let passed = value.is_some_and(|value| if self.at_least { value >= self.value } else { value <= self.value });
        Judged { text: self.text.clone(), value, unit: self.number.unit(), passed }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Lesson;

    fn goal(lines: &str) -> Goal {
        let text = format!("# T\n```goal\n{lines}\nneed: median coverage >= 5\n```\n");
        Lesson::parse(&text).unwrap().goals().next().unwrap().clone()
    }

    #[test]
    fn an_answer_changes_what_it_may_and_nothing_else() {
        let of = |change: &str| {
            goal(&format!("in: room=living&robot=roomba600&behaviour=bounce&p.least=170&slip=harsh\nchange: {change}"))
        };
        let settle = |change: &str, link: &str| {
            let (link, ignored) = of(change).settings(link);
            (link.to_string(), ignored)
        };
        let page = "room=flat&behaviour=bounce&robot=dvr1&cell=0.1";
        let (link, ignored) = settle("params", page);
        assert_eq!(link, "room=living&robot=roomba600&behaviour=bounce&slip=harsh", "defaults aren't in links");
        assert_eq!(ignored, ["room", "robot", "slip"]);
        assert_eq!(
            settle("cell", page).0,
            "room=living&robot=roomba600&behaviour=bounce&slip=harsh&cell=0.1&p.least=170"
        );
        let plan = "room=living&planner=snake&p.patience=3&robot=roomba600&cell=0.12&slip=harsh";
        assert_eq!(
            settle("algorithm", plan),
            ("room=living&robot=roomba600&planner=snake&slip=harsh&p.patience=3".to_owned(), vec![])
        );
        assert_eq!(settle("params", plan).0, "room=living&robot=roomba600&behaviour=bounce&slip=harsh&p.least=170");
        assert_eq!(settle("params", plan).1, ["planner"]);
    }

    #[test]
    fn the_room_of_a_scene_was_held_against_pupils_who_had_set_up_the_task() {
        let scene = "```scene\nid: den\ntitle: Den\n{}\n```\n";
        let lines = "in: robot=roomba600&behaviour=bounce\nscene: den\nneed: median coverage >= 5";
        let lesson = Lesson::parse(&format!("# T\n{scene}```goal\n{lines}\n```\n")).unwrap();
        let goal = lesson.goals().next().unwrap();
        let ignored = |link: &str| goal.settings(link).1;
        assert!(ignored("room=own&robot=roomba600&planner=snake").is_empty());
        assert_eq!(ignored("room=living&robot=roomba600&planner=snake"), ["room"]);
    }

    #[test]
    fn a_generated_flat_is_a_room_like_any_other() {
        let goal = goal("in: room=own&flat=7~area:30..40&robot=roomba600&behaviour=bounce");
        let answer = "room=own&flat=7~area:30..40&robot=roomba600&planner=snake";
        let settled = "room=own&robot=roomba600&planner=snake&flat=7~area:30..40";
        let settle = |link: &str| {
            let (link, ignored) = goal.settings(link);
            (link.to_string(), ignored)
        };
        assert_eq!(settle(answer), (settled.to_owned(), vec![]));
        let other = "room=own&flat=8&robot=roomba600&planner=snake";
        assert_eq!(settle(other), (settled.to_owned(), vec!["room".to_owned()]));
        let request = goal.request(answer, None, vec![1]);
        let name = robovac_sim::experiment::plan_of(request.room.as_deref(), None).unwrap().name;
        assert_eq!((name.as_str(), request.settings.as_str()), ("Flat 7", "robot=roomba600"));
        let measure = "# T\n```measure\nin: room=own&flat=7&robot=roomba600\nrow: A | behaviour=bounce\nrow: B | room=living&behaviour=bounce\nshow: coverage\n```\n";
        let lesson = Lesson::parse(measure).unwrap();
        let crate::LessonBlock::Measure(table) = &lesson.blocks[0] else { panic!("{lesson:?}") };
        let rooms: Vec<_> = (0..2).map(|row| table.request(row).unwrap().room.unwrap()).collect();
        assert_eq!(rooms, ["flat=7", "living"]);
    }
}
