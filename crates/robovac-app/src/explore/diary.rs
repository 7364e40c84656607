//! The event log of a run, as lines of text.

use robovac_sim::{Event, Run, STEP_S, What};

/// Steps within which the robot's reaction belongs to an event: it reacts in the step after.
const ANSWER: u64 = 4;

/// A line of the event log.
#[derive(Debug, Clone, PartialEq)]
pub struct DiaryEntry {
    /// Seconds since the run began.
    pub time_s: f64,
    /// The event and the robot's reaction: `bump left, backing up`.
    pub text: String,
    /// Whether it was sensed; otherwise the robot continued with something by itself.
    pub is_felt: bool,
}

/// The events of `run`, latest first; a robot that `follows_plan` is reported to follow it wherever it is put.
pub fn diary(run: &Run, follows_plan: bool) -> Vec<DiaryEntry> {
    let mut lines = tell(run.events());
    let put_down = What::PutDown.to_string();
    // One that goes to its dock first says so.
    for line in lines.iter_mut().filter(|line| follows_plan && !line.text.contains("dock")) {
        line.text = line.text.replace(&put_down, &format!("{put_down}, follows its plan as before"));
    }
    lines
}

/// A number that changes whenever the diary does.
pub fn diary_version(run: &Run) -> f64 {
    let events = run.events();
    let ends = [events.front(), events.back()].map(|event| event.map_or(0.0, |event| event.step as f64 + 1.0));
    events.len() as f64 + 128.0 * ends[1] + ends[0] / 1e9
}

fn tell<'a>(events: impl IntoIterator<Item = &'a Event>) -> Vec<DiaryEntry> {
    let mut lines: Vec<DiaryEntry> = Vec::new();
    let mut last = None;
    for &Event { step, what } in events {
        let answers = last.is_some_and(|last| step - last <= ANSWER);
        let is_felt = !matches!(what, What::Began(_));
        match lines.last_mut() {
            // An action given up at once isn't shown.
            Some(line) if answers && !line.is_felt && !is_felt => line.text = what.to_string(),
            Some(line) if answers && line.is_felt => {
                line.text.push_str(", ");
                line.text.push_str(&what.to_string());
            }
            _ => {
                lines.push(DiaryEntry { time_s: step as f64 * STEP_S, text: what.to_string(), is_felt });
                last = Some(step);
            }
        }
    }
    lines.reverse();
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_answer_stands_beside_what_it_answers() {
        let events = [
            Event { step: 100, what: What::Bump { left: true, right: false } },
            Event { step: 101, what: What::Began("backing up") },
            Event { step: 130, what: What::Began("turning away") },
            Event { step: 131, what: What::VirtualWall },
        ];
        let lines = tell(&events);
        let texts: Vec<_> = lines.iter().map(|line| (line.time_s, line.text.as_str())).collect();
        assert_eq!(
            texts,
            [
                (131.0 * STEP_S, "virtual wall"),
                (130.0 * STEP_S, "turning away"),
                (100.0 * STEP_S, "bump left, backing up")
            ]
        );
    }
}
