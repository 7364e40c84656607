//! From the text of a lesson to its blocks.

use crate::{
    Choice, Goal, Lesson, LessonBlock, LessonFault, LessonScene, Measure, Quiz, digest,
    fields::{BlockLine, BlockLines},
    prose::{Prose, options, safe_html},
};
use pulldown_cmark::{CodeBlockKind, Event, HeadingLevel, Parser, Tag, TagEnd};
use robovac_core::registry::nearest;

/// Fenced blocks that are more than text.
const KINDS: [&str; 9] = ["lesson", "scene", "predict", "do", "goal", "hint", "code", "measure", "quiz"];
/// Largest lesson, bytes.
const MOST_BYTES: usize = 300_000;

impl Lesson {
    /// Reads a lesson.
    pub fn parse(text: &str) -> Result<Self, LessonFault> {
        if text.len() > MOST_BYTES {
            let what = format!("the lesson has {} kB", text.len() / 1000);
            return Err(LessonFault::new(1, what, format!("keep it below {} kB", MOST_BYTES / 1000)));
        }
        let mut builder = LessonBuilder::default();
        let mut events = Parser::new_ext(text, options()).into_offset_iter();
        while let Some((event, place)) = events.next() {
            let line = || 1 + text[..place.start].matches('\n').count();
            match event {
                Event::Start(Tag::Heading { level: HeadingLevel::H1, .. }) if builder.lesson.title.is_empty() => {
                    for (event, _) in events.by_ref() {
                        match event {
                            Event::Text(part) | Event::Code(part) => builder.lesson.title.push_str(&part),
                            Event::End(TagEnd::Heading(_)) => break,
                            _ => {}
                        }
                    }
                }
                Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(ref info))) if kind_of(info).is_some() => {
                    let (kind, rest) = kind_of(info).unwrap_or_default();
                    let rest = rest.to_owned();
                    if builder.depth > 0 {
                        let what = format!("the block \"{kind}\" is inside a list or a quotation");
                        return Err(LessonFault::new(line(), what, "put its fence at the left margin"));
                    }
                    let mut content = String::new();
                    for (event, _) in events.by_ref() {
                        match event {
                            Event::Text(part) => content.push_str(&part),
                            Event::End(TagEnd::CodeBlock) => break,
                            _ => {}
                        }
                    }
                    builder.flush();
                    builder.block(kind, &rest, line(), &content)?;
                }
                other => {
                    if let Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(ref info))) = other {
                        is_meant_as_code(info, line())?;
                    }
                    match other {
                        Event::Start(_) => builder.depth += 1,
                        Event::End(_) => builder.depth -= 1,
                        _ => {}
                    }
                    builder.prose.push(other);
                }
            }
        }
        builder.flush();
        let mut lesson = builder.lesson;
        if lesson.title.is_empty() {
            return Err(LessonFault::new(1, "the lesson has no title", "begin with a line such as \"# Corners\""));
        }
        if lesson.id.is_empty() {
            lesson.id = plain(&lesson.title);
            let what = format!("the lesson has no id, so answers are for \"{}\", named after its title", lesson.id);
            let mend = format!("put \"id: {}\" into a block \"lesson\", and the title can change later", lesson.id);
            lesson.notes.push(LessonFault::new(1, what, mend));
        }
        lesson.digest = digest(text);
        unique(&lesson)?;
        Ok(lesson)
    }
}

/// Kind and rest of a fence's info string, if the block is more than text.
fn kind_of(info: &str) -> Option<(&'static str, &str)> {
    let (first, rest) = info.trim().split_once(char::is_whitespace).unwrap_or((info.trim(), ""));
    KINDS.into_iter().find(|kind| *kind == first).map(|kind| (kind, rest.trim()))
}

/// Fails if the word behind a fence is one of ours with a slip of the pen: the block would be shown as a program.
fn is_meant_as_code(info: &str, line: usize) -> Result<(), LessonFault> {
    /// A language whose name is like one of ours.
    const SCHEME: &str = "scheme";
    let word = info.split_whitespace().next().unwrap_or_default().to_ascii_lowercase();
    match nearest(&word, &KINDS.join(", ")).filter(|_| word != SCHEME) {
        None => Ok(()),
        Some(kind) => {
            let what = format!("there is no block \"{}\"", info.trim());
            Err(LessonFault::new(line, what, format!("did you mean \"{kind}\"?")))
        }
    }
}

/// A title as a name in links.
fn plain(title: &str) -> String {
    let kept: String =
        title.to_ascii_lowercase().chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
    let parts: Vec<&str> = kept.split('-').filter(|part| !part.is_empty()).collect();
    if parts.is_empty() { "lesson".to_owned() } else { parts.join("-") }
}

/// Fails if two goals, quizzes or predictions share an id, or if a goal's scene isn't there.
fn unique(lesson: &Lesson) -> Result<(), LessonFault> {
    let mut seen = std::collections::BTreeSet::new();
    for block in &lesson.blocks {
        let id = match block {
            LessonBlock::Goal(goal) => &goal.id,
            LessonBlock::Quiz(quiz) => &quiz.id,
            LessonBlock::Predict(choice) => &choice.id,
            _ => continue,
        };
        if !seen.insert(id) {
            return Err(LessonFault::new(1, format!("two blocks have the id \"{id}\""), "give each its own id"));
        }
    }
    let lost = lesson.goals().find(|goal| goal.scene.is_some() && lesson.scenario_of(goal).is_none());
    lost.map_or(Ok(()), |goal| {
        let what = format!(
            "the goal \"{}\" names a scene \"{}\" that has no scenario",
            goal.id,
            goal.scene.as_deref().unwrap_or_default()
        );
        Err(LessonFault::new(1, what, "give a scene that id, with a scenario file in it"))
    })
}

#[derive(Default)]
struct LessonBuilder<'a> {
    lesson: Lesson,
    prose: Prose<'a>,
    depth: usize,
    counts: [usize; 3],
}

impl LessonBuilder<'_> {
    fn flush(&mut self) {
        if !self.prose.is_empty() {
            let html = self.prose.take();
            self.lesson.blocks.push(LessonBlock::Prose { html });
        }
    }

    /// The next automatic id.
    fn next(&mut self, kind: &str, which: usize) -> String {
        self.counts[which] += 1;
        format!("{kind}-{}", self.counts[which])
    }

    fn block(&mut self, kind: &'static str, rest: &str, line: usize, content: &str) -> Result<(), LessonFault> {
        let block = match kind {
            "hint" => LessonBlock::Hint { html: safe_html(content) },
            "code" => {
                let language = if rest.is_empty() { "python" } else { rest };
                if !["python", "javascript"].contains(&language) {
                    let what = format!("there are no programs in \"{language}\"");
                    return Err(LessonFault::new(line, what, "write \"code python\" or \"code javascript\""));
                }
                LessonBlock::Code { language: language.to_owned(), text: content.to_owned() }
            }
            "scene" if content.contains("\n{") || content.starts_with('{') => {
                let at = content.find('{').unwrap_or_default();
                let mut fields = BlockLines::parse(kind, line, &content[..at])?;
                let scene = LessonScene {
                    id: fields.text("id"),
                    title: fields.take("title").map_or_else(|| "Open the room".to_owned(), |field| field.value),
                    link: String::new(),
                    scenario: content[at..].to_owned(),
                };
                fields.finish()?;
                LessonBlock::Scene(scene)
            }
            _ => {
                let mut fields = BlockLines::parse(kind, line, content)?;
                self.lesson.links.extend(fields.links().into_iter().filter(|(_, link)| !link.is_empty()));
                let block = self.of_fields(kind, &mut fields, rest)?;
                fields.finish()?;
                let Some(block) = block else { return Ok(()) };
                block
            }
        };
        self.lesson.blocks.push(block);
        Ok(())
    }

    fn of_fields(
        &mut self,
        kind: &str,
        fields: &mut BlockLines,
        rest: &str,
    ) -> Result<Option<LessonBlock>, LessonFault> {
        Ok(Some(match kind {
            "lesson" => {
                self.lesson.id = fields.take("id").map(|field| id(&field)).transpose()?.unwrap_or_default();
                self.lesson.minutes = fields.number("minutes", 0.0, 1.0..=600.0)?;
                self.lesson.audience = fields.text("for");
                self.lesson.outcomes = fields.take_all("outcome").into_iter().map(|field| field.value).collect();
                let names = fields.text("explains");
                let names = names.split(',').map(str::trim).filter(|name| !name.is_empty());
                self.lesson.explains = names.map(str::to_owned).collect();
                self.lesson.sources = fields.take_all("source").iter().map(|field| safe_html(&field.value)).collect();
                return Ok(None);
            }
            "scene" => LessonBlock::Scene(LessonScene {
                id: fields.text("id"),
                link: fields.need("link", "room=living&behaviour=bounce")?.value,
                title: fields.take("title").map_or_else(|| "Set the scene".to_owned(), |field| field.value),
                scenario: String::new(),
            }),
            "predict" => LessonBlock::Predict(self.choice(fields)?),
            "do" => LessonBlock::Do { label: fields.need("label", "Run it")?.value, link: fields.text("link") },
            "goal" => {
                let id = self.next("goal", 0);
                let goal = Goal::parse(fields, id)?;
                if !fields.has_had("change") {
                    let what = "the goal doesn't say what may be changed, so algorithm and cell may be";
                    let mend = "write e.g. \"change: algorithm, cell\", or \"change: program\"";
                    self.lesson.notes.push(LessonFault::new(fields.line(), what, mend));
                }
                LessonBlock::Goal(goal)
            }
            "measure" => LessonBlock::Measure(Measure::parse(fields)?),
            _ => {
                let id = self.next("quiz", 1);
                LessonBlock::Quiz(Quiz::parse(fields, rest, id)?)
            }
        }))
    }

    fn choice(&mut self, fields: &mut BlockLines) -> Result<Choice, LessonFault> {
        let question = fields.need("question", "Which robot sweeps more?")?;
        let options: Vec<String> = fields.take_all("option").into_iter().map(|field| field.value).collect();
        if options.len() < 2 {
            return Err(fields.lack("option", "The one that bounces"));
        }
        let right = fields.need("answer", "1")?;
        let index = right.value.parse::<usize>().ok().filter(|number| (1..=options.len()).contains(number));
        let Some(index) = index else {
            let what = format!("the answer \"{}\" isn't the number of an option", right.value);
            return Err(LessonFault::new(right.line, what, format!("use a number from 1 to {}", options.len())));
        };
        let id = self.next("predict", 2);
        Ok(Choice {
            id: fields.take("id").map_or(id, |field| field.value),
            question: question.value,
            options,
            right: index - 1,
            because: safe_html(&fields.text("because")),
        })
    }
}

fn id(field: &BlockLine) -> Result<String, LessonFault> {
    if plain(&field.value) == field.value {
        Ok(field.value.clone())
    } else {
        let what = format!("\"{}\" can't be an id", field.value);
        Err(LessonFault::new(
            field.line,
            what,
            format!("use small letters, digits and dashes, e.g. \"{}\"", plain(&field.value)),
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fault(text: &str) -> String {
        Lesson::parse(text).unwrap_err().to_string()
    }

    #[test]
    fn faults_name_line_cause_and_mend() {
        assert_eq!(fault("text"), "line 1: the lesson has no title; begin with a line such as \"# Corners\"");
        let goal = "# T\n\n```goal\nin: room=flat&robot=roomba600&behaviour=bounce\nminutes: 5\n```\n";
        assert_eq!(
            fault(goal),
            "line 3: the block \"goal\" has no line \"need\"; add e.g. \"need: median coverage >= 95 %\""
        );
        for (needed, told) in [
            ("median coverage > 5 %", "line 5: a condition needs one >= or <="),
            ("mean coverage >= 5 %", "line 5: a condition begins with median, every or best, not \"mean\""),
            ("median speed >= 5", "line 5: there is no number \"speed\""),
            ("median coverage >= 5 m", "line 5: \"5 m\" isn't a number in the unit \"%\""),
            (
                "median coverage >= 120 %",
                "line 5: \"median coverage >= 120 %\" decides nothing; a share is from 0 to 100 %",
            ),
            (
                "median time to 90 % <= 21 min",
                "line 5: \"median time to 90 % <= 21 min\" decides nothing; the runs end after 20 min",
            ),
            ("every bumps <= -1", "line 5: \"every bumps <= -1\" decides nothing; it is never below 0"),
        ] {
            let text = format!("# T\n\n```goal\nin: room=flat&robot=roomba600&behaviour=bounce\nneed: {needed}\n```\n");
            assert!(fault(&text).starts_with(told), "{}", fault(&text));
        }
        assert!(
            fault("# T\n```do\nlabel: a\nlable: b\n```")
                .starts_with("line 4: the block \"do\" has no key \"lable\"; it takes: label, link")
        );
        assert!(
            fault("# T\n```predict\nquestion: a\noption: b\noption: c\nanswer: 3\n```")
                .starts_with("line 6: the answer \"3\"")
        );
        assert!(
            fault("# T\n```goal\nin: robot=roomba600&planner=snake\nneed: median coverage >= 5\n```")
                .starts_with("line 3: the link of \"in\" names no")
        );
        assert!(
            fault("# T\n```measure\nin: room=own&map=x&robot=roomba600\nrow: A | planner=snake\nshow: coverage\n```")
                .starts_with("line 3: the link of \"in\" has a room of your own")
        );
        assert_eq!(
            fault("# T\n\n```predic\nquestion: a\n```"),
            "line 3: there is no block \"predic\"; did you mean \"predict\"?"
        );
        assert!(fault("# T\n```Goal\n```").ends_with("did you mean \"goal\"?"));
        assert!(
            fault("# T\n\n- a\n\n  ```goal\n  x: y\n  ```\n")
                .starts_with("line 5: the block \"goal\" is inside a list")
        );
        assert!(fault("# T\n```quiz riddle\n```").starts_with("line 2: there is no quiz \"riddle\""));
        assert!(fault("# T\n```code c\n```").starts_with("line 2: there are no programs in \"c\""));
    }

    #[test]
    fn what_is_in_order_but_may_be_meant_otherwise_is_noted() {
        let text = "# My corners\n\n```goal\nin: room=flat&robot=roomba600&behaviour=bounce\nneed: median coverage >= 5 %\n```\n\
            ```scheme\n(define a 1)\n```\n";
        let notes: Vec<String> = Lesson::parse(text).unwrap().notes.iter().map(ToString::to_string).collect();
        assert!(notes[0].starts_with("line 3: the goal doesn't say what may be changed"), "{notes:?}");
        assert!(notes[1].contains("answers are for \"my-corners\"") && notes.len() == 2, "{notes:?}");
        let text = "# T\n```lesson\nid: t\n```\n```goal\nin: room=flat&robot=roomba600&behaviour=bounce\nchange: cell\nneed: median coverage >= 5 %\n```\n";
        assert_eq!(Lesson::parse(text).unwrap().notes, []);
    }

    #[test]
    fn all_blocks_are_read() {
        let text = "# All `of` it\n\n```lesson\nid: all\nminutes: 20\noutcome: One\noutcome: Two\nsource: [a](https://b.c)\n```\n\
            ```scene\nlink: room=flat\n```\n```predict\nquestion: Q?\noption: a\noption: b\nanswer: 2\nbecause: *so*\n  and so\n```\n\
            ```do\nlabel: Go\n```\n```hint\nLook **there**.\n```\n```code python\ndef step(robot):\n    robot.go(0.2, 0)\n```\n\
            ```measure\nin: room=flat&robot=roomba600\nrow: A | behaviour=bounce\nshow: coverage, bumps\n```\n```quiz reachable\n```\n```python\nplain\n```\n";
        let lesson = Lesson::parse(text).unwrap();
        assert_eq!((lesson.id.as_str(), lesson.title.as_str(), lesson.outcomes.len()), ("all", "All of it", 2));
        let kinds: Vec<String> = lesson
            .blocks
            .iter()
            .map(|block| serde_json::to_value(block).unwrap()["kind"].as_str().unwrap().to_owned())
            .collect();
        assert_eq!(kinds, ["scene", "predict", "do", "hint", "code", "measure", "quiz", "prose"]);
        assert!(
            matches!(&lesson.blocks[1], LessonBlock::Predict(choice) if choice.right == 1 && choice.because.contains("<em>so</em> and so"))
        );
        assert!(
            matches!(&lesson.blocks[5], LessonBlock::Measure(measure) if measure.columns == ["coverage, %", "bumps"] && measure.rows[0].link == "room=flat&robot=roomba600&behaviour=bounce")
        );
    }
}
