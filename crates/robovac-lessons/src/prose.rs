//! Markdown as HTML that is safe to show, whoever wrote it.
//!
//! Raw HTML is shown as text, comments are left out, pictures are shown as their descriptions (fetching them would tell
//! another site who reads the lesson), and links lead to `http`, `https`, `mailto` or a place on the page.

use pulldown_cmark::{CowStr, Event, HeadingLevel, Options, Parser, Tag, TagEnd, html::push_html};

/// What of Markdown is understood beyond its core.
pub fn options() -> Options {
    Options::ENABLE_TABLES
}

/// A Markdown text as safe HTML.
pub fn safe_html(markdown: &str) -> String {
    let mut prose = Prose::default();
    for event in Parser::new_ext(markdown, options()) {
        prose.push(event);
    }
    prose.take()
}

/// Collects events and makes them safe.
#[derive(Default)]
pub struct Prose<'a> {
    events: Vec<Event<'a>>,
    /// For each open link, whether it is kept.
    links: Vec<bool>,
    is_comment: bool,
}

impl<'a> Prose<'a> {
    /// Takes the next event.
    pub fn push(&mut self, event: Event<'a>) {
        match event {
            Event::Html(text) | Event::InlineHtml(text) => self.raw(&text),
            Event::Start(Tag::HtmlBlock) => self.is_comment = false,
            Event::Start(Tag::Image { .. }) | Event::End(TagEnd::Image | TagEnd::HtmlBlock) => {}
            Event::Start(Tag::Link { dest_url, .. }) => {
                let tag = opening(&dest_url);
                self.links.push(tag.is_some());
                self.events.extend(tag.map(|tag| Event::Html(CowStr::from(tag))));
            }
            Event::End(TagEnd::Link) => {
                if self.links.pop() == Some(true) {
                    self.events.push(Event::Html(CowStr::from("</a>")));
                }
            }
            Event::Start(Tag::Heading { level, .. }) => {
                let tag = Tag::Heading { level: below(level), id: None, classes: Vec::new(), attrs: Vec::new() };
                self.events.push(Event::Start(tag));
            }
            Event::End(TagEnd::Heading(level)) => self.events.push(Event::End(TagEnd::Heading(below(level)))),
            other => self.events.push(other),
        }
    }

    /// Whether there is nothing to show.
    pub fn is_empty(&self) -> bool {
        self.events.is_empty()
    }

    /// The HTML of what was taken so far.
    pub fn take(&mut self) -> String {
        let mut html = String::new();
        push_html(&mut html, self.events.drain(..));
        html
    }

    fn raw(&mut self, text: &str) {
        let begins = text.trim_start().starts_with("<!--");
        self.is_comment |= begins;
        if self.is_comment {
            self.is_comment = !text.contains("-->");
        } else {
            self.events.push(Event::Text(CowStr::from(text.to_owned())));
        }
    }
}

/// The page has headings of its own above those of a lesson.
fn below(level: HeadingLevel) -> HeadingLevel {
    match level {
        HeadingLevel::H1 | HeadingLevel::H2 => HeadingLevel::H3,
        HeadingLevel::H3 => HeadingLevel::H4,
        HeadingLevel::H4 => HeadingLevel::H5,
        HeadingLevel::H5 | HeadingLevel::H6 => HeadingLevel::H6,
    }
}

/// The opening tag of a link to `address`; `None` if it may not be followed.
fn opening(address: &str) -> Option<String> {
    let lower = address.to_ascii_lowercase();
    let quoted = address.replace('&', "&amp;").replace('"', "&quot;").replace('<', "&lt;").replace('>', "&gt;");
    if lower.starts_with('#') {
        return Some(format!("<a href=\"{quoted}\">"));
    }
    let is_known = ["https://", "http://", "mailto:"].iter().any(|scheme| lower.starts_with(scheme));
    is_known.then(|| format!("<a href=\"{quoted}\" target=\"_blank\" rel=\"noopener noreferrer\">"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn raw_html_of_strangers_is_shown_as_text() {
        let hostile = [
            "<script>alert(1)</script>",
            "a <img src=x onerror=alert(1)> b",
            "<div onclick=\"x()\">\n\n**bold**\n\n</div>",
            "<!-- a --><script>x</script>",
            "<!-- a\nb --> <svg onload=x>",
            "<iframe src=javascript:x></iframe>",
            "```html\n<script>x</script>\n```",
            "`<script>`",
            "| <script> |\n|---|\n| <b onfocus=x> |\n",
        ];
        for text in hostile {
            let html = safe_html(text);
            for tag in ["<script", "<img", "<svg", "<iframe", "<div onclick", "<b "] {
                assert!(!html.contains(tag), "{text}: {html}");
            }
        }
    }

    #[test]
    fn links_lead_to_the_web_or_the_page() {
        for bad in [
            "javascript:alert(1)",
            "JavaScript:x",
            "data:text/html,x",
            "vbscript:x",
            "file:///etc",
            "//other",
            " javascript:x",
            "&#106;avascript:x",
        ] {
            let html = safe_html(&format!("[x]({bad}) <{bad}> [y][z]\n\n[z]: {bad}"));
            assert!(!html.contains("<a"), "{bad}: {html}");
        }
        let html = safe_html("[x](https://a.b/\"onclick=x) [y](#room=flat&planner=snake)");
        assert!(!html.contains("\"onclick") && html.contains("href=\"#room=flat&amp;planner=snake\""), "{html}");
    }

    #[test]
    fn pictures_are_not_fetched() {
        assert_eq!(safe_html("![a robot](https://a.b/c.png)"), "<p>a robot</p>\n");
    }

    #[test]
    fn comments_are_left_out() {
        assert_eq!(safe_html("a\n\n<!-- robovac plan\n--room flat -->\n\nb"), "<p>a</p>\n<p>b</p>\n");
    }
}
