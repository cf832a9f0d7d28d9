//! Unread parts: texts in SCL are written as they were, all others are not written.

use super::tags::Tags;
use ladder_analysis::program::{BlockKind, Network};
use ladder_notation::foreign_text_of;
use ladder_syntax::Parse;
use std::ops::Range;

/// The text of an unread part. None: the definition on these lines is none.
pub(super) fn text_of(parse: &Parse, lines: Range<usize>, told: &[String]) -> Option<Result<String, String>> {
    let definition: String = lines.map(|line| parse.lines()[line].text()).collect();
    let is_unread = definition
        .lines()
        .any(|line| line.starts_with("# ladder: unread"));
    let is_in_scl = told.iter().any(|told| told.contains("(SCL)"));
    let text = foreign_text_of(&definition).filter(|_| is_in_scl);
    is_unread.then(|| {
        text.ok_or_else(|| "it is an unread part, and of these only texts in SCL are written".to_owned())
    })
}

/// The text of a network in SCL. None: nothing in it is unread.
pub(super) fn in_scl(network: &Network, tags: &Tags<'_>) -> Option<Result<String, String>> {
    let project = tags.project;
    let unread = network.blocks.iter().find_map(|block| match block.kind {
        BlockKind::User(user) => project.source(user)?.unread.as_ref(),
        BlockKind::Instruction(_) => None,
    })?;
    Some(unread.clone().and_then(|text| {
        if network.blocks.len() > 1 {
            return Err("a text in SCL is a network of its own".to_owned());
        }
        if let Some(name) = names(&text).find(|name| tags.known(name).is_none()) {
            return Err(format!(
                "its text in SCL names `#{name}`, which the block does not declare"
            ));
        }
        // A statement that was read alone comes without its end.
        let end = if text.trim_end().ends_with(';') { "" } else { ";" };
        Ok(text + end)
    }))
}

/// The names of variables of the block in a text: `#speed`, `#"speed 2"`.
fn names(text: &str) -> impl Iterator<Item = &str> {
    text.split('#')
        .skip(1)
        .filter_map(|rest| match rest.strip_prefix('"') {
            Some(quoted) => quoted.split('"').next(),
            None => {
                let name = rest.split(|c: char| !c.is_alphanumeric() && c != '_').next();
                // What begins with a digit is part of a literal: `16#FF`.
                name.filter(|name| name.starts_with(|c: char| c.is_alphabetic() || c == '_'))
            }
        })
}
