//! What the tests want to know of a Markdown text.

use pulldown_cmark::{CodeBlockKind, CowStr, Event, LinkType, Options, Parser, Tag, TagEnd};
use std::collections::HashSet;
use std::ops::Range;

/// A Markdown text, read.
#[derive(Debug, Default)]
pub struct Markdown {
    /// What a link can point to within the text.
    pub anchors: HashSet<String>,
    /// Where the links and pictures point to, in the order of the text.
    pub links: Vec<String>,
    /// What is between backticks in the text.
    pub codes: Vec<String>,
    /// The fenced blocks.
    pub fences: Vec<Fence>,
}

/// A fenced block.
#[derive(Debug)]
pub struct Fence {
    /// The words after the opening fence, which commas separate: the language, then what is reported about it.
    pub words: Vec<String>,
    /// Its content.
    pub text: String,
    /// Where the content is in the Markdown, in bytes.
    pub range: Range<usize>,
    /// The line of the first line of the content, from 1.
    pub line: usize,
}

impl Fence {
    /// The language, if one is named.
    pub fn language(&self) -> Option<&str> {
        self.words.first().map(String::as_str)
    }

    /// Whether the opening fence has this word after the language.
    pub fn says(&self, word: &str) -> bool {
        self.words.iter().skip(1).any(|there| there == word)
    }
}

/// Reads a text.
pub fn read(text: &str) -> Markdown {
    let mut markdown = Markdown::default();
    let mut heading: Option<String> = None;
    let mut fence: Option<Fence> = None;
    for (event, range) in Parser::new_ext(text, Options::ENABLE_TABLES).into_offset_iter() {
        match event {
            Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
            Event::End(TagEnd::Heading(_)) => {
                let anchor = anchor(&heading.take().unwrap_or_default());
                markdown.add_anchor(&anchor);
            }
            Event::Start(Tag::Link {
                link_type: LinkType::Email,
                dest_url,
                ..
            }) => markdown.links.push(format!("mailto:{dest_url}")),
            Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                markdown.links.push(dest_url.into_string());
            }
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) => fence = Some(new_fence(&info)),
            Event::End(TagEnd::CodeBlock) => markdown.fences.extend(fence.take()),
            Event::Text(part) if fence.is_some() => {
                if let Some(fence) = &mut fence {
                    fence.add(&part, range, text);
                }
            }
            Event::Text(part) => extend(&mut heading, &part),
            Event::Code(part) => {
                extend(&mut heading, &part);
                markdown.codes.push(part.into_string());
            }
            _ => {}
        }
    }
    markdown
}

fn extend(heading: &mut Option<String>, part: &str) {
    if let Some(heading) = heading {
        heading.push_str(part);
    }
}

impl Markdown {
    /// A heading that is there already gets a number.
    fn add_anchor(&mut self, anchor: &str) {
        let mut unique = anchor.to_owned();
        let mut number = 0;
        while !self.anchors.insert(unique.clone()) {
            number += 1;
            unique = format!("{anchor}-{number}");
        }
    }
}

fn new_fence(info: &CowStr<'_>) -> Fence {
    Fence {
        words: info
            .split([',', ' '])
            .filter(|word| !word.is_empty())
            .map(str::to_owned)
            .collect(),
        text: String::new(),
        range: 0..0,
        line: 0,
    }
}

impl Fence {
    /// The content comes in pieces, one for each line.
    fn add(&mut self, part: &str, range: Range<usize>, whole: &str) {
        if self.text.is_empty() {
            self.range.start = range.start;
            self.line = whole[..range.start].lines().count() + 1;
        }
        self.range.end = range.end;
        self.text.push_str(part);
    }
}

/// The anchor that mdBook gives a heading: small letters, blanks as `-`, punctuation left out.
fn anchor(heading: &str) -> String {
    heading
        .trim()
        .chars()
        .filter_map(|letter| match letter {
            '_' | '-' => Some(letter),
            letter if letter.is_whitespace() => Some('-'),
            letter if letter.is_alphanumeric() => Some(letter.to_ascii_lowercase()),
            _ => None,
        })
        .collect()
}
