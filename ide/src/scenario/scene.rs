//! Completion and hover in a scene: a drawing whose attributes hold expressions.
//!
//! The text is looked at as it is typed: what is not XML yet is not read as such.

use super::completion::Proposals;
use super::file::Scenarios;
use super::hover::hover;
use super::property_completion::in_expression;
use crate::completion::{CompletionKind, Completions, Snippet, Topic};
use crate::hover::Hover;
use ladder_syntax::{TextRange, TextSize};
use std::sync::Arc;

/// An attribute that a scene has.
#[derive(Debug, Clone, Copy)]
pub struct SceneAttribute {
    /// Its name.
    pub name: &'static str,
    /// What it does, in Markdown.
    pub about: &'static str,
    /// Whether expressions are written in it.
    pub takes_expression: bool,
}

/// Where a cursor is.
enum At<'t> {
    /// In the name of an attribute, which begins here.
    Name(usize),
    /// In the value of the attribute of this name, which begins here.
    Value(&'t str, usize),
}

/// Where an offset is within an element, if it is in one.
fn at(text: &str, offset: usize) -> Option<At<'_>> {
    let before = text.get(..offset)?;
    // No value of XML has one in it.
    let open = before.rfind('<')? + 1;
    let mut value: Option<(char, usize)> = None;
    for (at, c) in before[open..].char_indices() {
        match (c, value) {
            ('"' | '\'', None) => value = Some((c, open + at + 1)),
            ('>', None) => return None,
            (c, Some((quote, _))) if c == quote => value = None,
            _ => {}
        }
    }
    if let Some((_, start)) = value {
        let name = before[open..start - 1].trim_end().strip_suffix('=')?.trim_end();
        let word = name.rfind(char::is_whitespace).map_or(0, |at| at + 1);
        return Some(At::Value(&name[word..], start));
    }
    let start = before.rfind(char::is_whitespace)? + 1;
    (start > open && !before[start..].contains('=')).then_some(At::Name(start))
}

/// What can be written at an offset. `trigger` is the character that was just typed, if that is why it is asked.
pub fn scene_completions(
    scenarios: &Scenarios<'_>,
    offset: TextSize,
    attributes: &[SceneAttribute],
    (colours, trigger): (&[&'static str], Option<char>),
) -> Completions {
    let text = scenarios.text;
    let word = |from: usize| TextRange::new(TextSize::new(from as u32), offset);
    match at(text, offset.into()) {
        Some(At::Name(start)) => {
            let mut out = Proposals::new(word(start));
            for attribute in attributes {
                let value = Snippet::default()
                    .text(attribute.name)
                    .text("=\"")
                    .stop("")
                    .text("\"")
                    .end();
                out.add(
                    CompletionKind::Keyword,
                    attribute.name,
                    "scene",
                    value,
                    Topic::Words(attribute.about),
                );
            }
            out.finish()
        }
        Some(At::Value(name, start)) => {
            let known = attributes.iter().find(|it| it.name == name);
            if !known.is_some_and(|it| it.takes_expression) {
                return Completions::default();
            }
            let mut before = &text[start..offset.into()];
            if let Some(after) = before.rfind(';') {
                before = &before[after + 1..];
            }
            let is_colour = matches!(name, "l:fill" | "l:stroke") && before.contains(':');
            let is_part =
                |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '[' | ']' | '$' | '#' | '%');
            let from = before
                .rfind(|c| !is_part(c))
                .map_or(0, |at| at + before[at..].chars().next().map_or(1, char::len_utf8));
            let written = &before[from..];
            let mut out = Proposals::new(word(usize::from(offset) - written.len()));
            if is_colour {
                for colour in colours {
                    out.value(colour, "a colour of the theme");
                }
            } else {
                in_expression(
                    scenarios,
                    &before[..from],
                    ("", written),
                    trigger.filter(|it| *it != ':'),
                    &mut out,
                );
            }
            out.finish()
        }
        None => Completions::default(),
    }
}

/// What is at an offset, and the file whose lines its links are to.
pub fn scene_hover(
    scenarios: &Scenarios<'_>,
    offset: TextSize,
    attributes: &[SceneAttribute],
) -> Option<(Hover, Option<Arc<str>>)> {
    let text = scenarios.text;
    if let Some(At::Name(start)) = at(text, offset.into()) {
        let end = text[start..]
            .find(['=', ' ', '>', '/', '\n'])
            .map_or(text.len(), |at| start + at);
        let attribute = attributes.iter().find(|it| it.name == &text[start..end])?;
        let range = TextRange::new(TextSize::new(start as u32), TextSize::new(end as u32));
        let markdown = attribute.about.to_owned();
        return Some((Hover { range, markdown }, None));
    }
    hover(scenarios, offset)
}
