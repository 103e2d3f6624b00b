//! What is read of a page: where its links lead, and its headings.

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};
use std::ops::Range;

/// A link: where it leads, and where in the page it, and the words between its brackets, stand.
pub struct Link {
    pub to: String,
    pub whole: Range<usize>,
    pub words: Range<usize>,
}

/// The links to other files, or places in them: none to the network.
pub fn links(text: &str) -> Vec<Link> {
    let mut links: Vec<Link> = Vec::new();
    let mut open: Option<Link> = None;
    for (event, range) in Parser::new_ext(text, Options::ENABLE_TABLES).into_offset_iter() {
        match event {
            Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                let begin = range.start + if text[range.start..].starts_with('!') { 2 } else { 1 };
                open = Some(Link { to: dest_url.into_string(), whole: range, words: begin..begin });
            }
            Event::End(TagEnd::Link | TagEnd::Image) => links.extend(open.take()),
            _ => {
                if let Some(link) = &mut open {
                    link.words.end = range.end;
                }
            }
        }
    }
    links.retain(|link| !link.to.contains("://") && !link.to.starts_with("mailto:"));
    links
}

/// What `#...` may name: a heading in small letters, a dash for each space, without punctuation.
pub fn anchors(text: &str) -> Vec<String> {
    let mut anchors = Vec::new();
    let mut open: Option<String> = None;
    for event in Parser::new_ext(text, Options::ENABLE_TABLES) {
        match event {
            Event::Start(Tag::Heading { .. }) => open = Some(String::new()),
            Event::End(TagEnd::Heading(_)) => anchors.extend(open.take().map(|heading| anchor(&heading))),
            Event::Text(words) | Event::Code(words) => {
                if let Some(heading) = &mut open {
                    heading.push_str(&words);
                }
            }
            _ => {}
        }
    }
    anchors
}

fn anchor(heading: &str) -> String {
    let kept = heading.trim().chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.map(|c| if c == ' ' { '-' } else { c.to_ascii_lowercase() }).collect()
}

#[cfg(test)]
mod tests {
    use super::{anchors, links};

    #[test]
    fn links_and_anchors() {
        let text =
            "# What `x` costs, mostly\n\n[a *b*](c.md#d) and ![e](f.png), not <https://g.org>.\n\n| [h](i) |\n|---|\n";
        let found = links(text);
        let told: Vec<_> = found.iter().map(|link| (link.to.as_str(), &text[link.words.clone()])).collect();
        assert_eq!(told, [("c.md#d", "a *b*"), ("f.png", "e"), ("i", "h")]);
        assert_eq!(&text[found[0].whole.clone()], "[a *b*](c.md#d)");
        assert_eq!(anchors(text), ["what-x-costs-mostly"]);
    }
}
