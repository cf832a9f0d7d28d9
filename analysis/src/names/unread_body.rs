//! Whether the definition of a block says that it is an unread part (LANGUAGE §5.9).

mod calls;

pub(super) use calls::with_calls;

use crate::asked::{asked, may_ask};
use crate::program::{Unread, UnreadDirective, without_blanks};
use ladder_syntax::{BlockDefinition, Line, NodeOrToken, Parse};
use std::sync::Arc;

/// What the first comment of a definition says that makes it one.
pub(super) fn unread(parse: &Parse, definition: &BlockDefinition) -> Option<Arc<Unread>> {
    let body = definition.lines.start + 1..definition.lines.end - usize::from(definition.closed);
    let sections = &parse.frame().sections;
    let is_in_section = |line: usize| {
        let after = sections.partition_point(|section| section.lines.start <= line);
        after > 0 && sections[after - 1].lines.contains(&line)
    };
    let mut directive = None;
    let mut has_foreign_text = false;
    for number in body.clone() {
        let line = &parse.lines()[number];
        if !line.is_commented() || is_in_section(number) {
            continue;
        }
        if directive.is_some() {
            has_foreign_text = true;
            break;
        }
        if may_ask(line.text()) && line.kind.is_decoration() {
            directive = directive_on(line);
        }
    }
    let text: String = body.map(|line| parse.lines()[line].text()).collect();
    Some(Arc::new(Unread {
        directive: directive?,
        text: without_blanks(&text),
        has_foreign_text,
    }))
}

fn directive_on(line: &Line) -> Option<UnreadDirective> {
    let tree = line.tree();
    let mut comments = tree.children().filter_map(|child| match child {
        NodeOrToken::Token(token) => Some(token.text()),
        NodeOrToken::Node(_) => None,
    });
    comments.find_map(|comment| {
        let told = asked(comment).filter(|told| told.word == "unread")?;
        UnreadDirective::read(told.after)
    })
}
