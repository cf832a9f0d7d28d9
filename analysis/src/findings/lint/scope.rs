//! Where the comments are that switch rules off, and what each of them covers.

use super::directive::{self, Directive, Word};
use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::rule::Rule;
use ladder_syntax::wiring::PartKind;
use ladder_syntax::{Item, LineKind, NodeOrToken, TextRange, TextSize};

/// A comment that switches rules off.
#[derive(Debug)]
pub(super) struct Allow {
    /// The comment.
    pub(super) comment: TextRange,
    pub(super) rules: Vec<Switched>,
    /// Findings that begin here are not shown.
    pub(super) covers: TextRange,
    /// That is the whole file.
    pub(super) whole_file: bool,
    /// What to take out to be rid of the comment: its line, if nothing else is there.
    pub(super) removal: Option<TextRange>,
}

/// A rule that a comment switches off.
#[derive(Debug)]
pub(super) struct Switched {
    pub(super) rule: Rule,
    /// Whether it would have found something.
    pub(super) used: bool,
}

/// All such comments of a file. What is wrong with comments to the tools goes to `out`.
pub(super) fn allows(context: &Context, out: &mut Vec<Diagnostic>) -> Vec<Allow> {
    let parse = &context.parse;
    let mut allows = Vec::new();
    let mut said = Said::default();
    // Comments between the things of a file: they apply to what is next.
    let structure = parse.structure_once();
    let items = &structure.items;
    // The next such thing, and which item it is.
    let mut known: Option<(usize, TextRange)> = None;
    for (index, item) in items.iter().enumerate() {
        let Item::Decoration(line) = *item else { continue };
        if holds_comments(parse.lines()[line].kind) {
            let next = || match known {
                Some((at, range)) if at > index => range,
                _ => {
                    let mut behind = items.iter().enumerate().skip(index + 1);
                    let found =
                        behind.find_map(|(at, item)| covered(context, *item).map(|range| (at, range)));
                    // Nothing is behind: that stays so.
                    let (at, range) = found.unwrap_or((items.len(), TextRange::default()));
                    known = Some((at, range));
                    range
                }
            };
            read_line(context, line, next, (&mut allows, &mut said), out);
        }
    }
    // Comments within a network, on lines of their own or behind its rungs, apply to it.
    for facts in context.networks.iter().filter(|network| network.commented) {
        for line in facts.first_line..facts.first_line + facts.line_count() {
            if holds_comments(parse.lines()[line].kind) {
                read_line(context, line, || facts.range, (&mut allows, &mut said), out);
            }
        }
        for (number, rung) in facts.wiring.rungs.iter().enumerate() {
            let line = facts.line(number);
            let aside = |part: &ladder_syntax::wiring::RungPart| {
                part.kind == PartKind::Comment && part.segment.is_none()
            };
            if rung.parts.iter().any(aside) {
                read_line(context, line, || facts.range, (&mut allows, &mut said), out);
            }
        }
    }
    allows
}

const fn holds_comments(kind: LineKind) -> bool {
    matches!(kind, LineKind::Comment | LineKind::Rail)
}

/// What a comment before this item covers; none if it applies to a later one.
fn covered(context: &Context, item: Item) -> Option<TextRange> {
    let parse = &context.parse;
    let lines = |lines: std::ops::Range<usize>| {
        TextRange::new(
            parse.line_start(lines.start),
            parse.line_range(lines.end - 1).end(),
        )
    };
    match item {
        Item::Network(network) => Some(context.networks.at(network).range),
        Item::Section(section) => Some(lines(parse.frame().sections[section].lines.clone())),
        Item::BlockHeader(block) => {
            let first = parse.frame().blocks[block].lines.start;
            Some(lines(first..first + 1))
        }
        Item::Stray(line) => Some(parse.line_range(line)),
        Item::Decoration(_) | Item::BlockEnd(_) => None,
    }
}

/// The comments so far that say something of the file.
#[derive(Default)]
struct Said(Vec<(Word, TextRange)>);

impl Said {
    /// Enters a comment on a line. Says so if it changes nothing.
    fn enter(
        &mut self,
        context: &Context,
        (word, comment): (Word, TextRange),
        line: usize,
        out: &mut Vec<Diagnostic>,
    ) {
        let first_network = context.parse.lines().first_network();
        if first_network.is_some_and(|first| line >= first) {
            out.push(directive::too_late(word, comment));
            return;
        }
        match self.0.iter().find(|(other, _)| *other == word) {
            Some((_, first)) => {
                let line = context.line_number(first.start());
                out.push(directive::said_before(word, comment, *first, line));
            }
            None => self.0.push((word, comment)),
        }
    }
}

/// Reads the comments of a line.
fn read_line(
    context: &Context,
    line: usize,
    mut covers: impl FnMut() -> TextRange,
    (allows, said): (&mut Vec<Allow>, &mut Said),
    out: &mut Vec<Diagnostic>,
) {
    let parse = &context.parse;
    let mut at = parse.line_start(line);
    let kind = parse.lines()[line].kind;
    let mut comments = 0;
    let before = allows.len();
    if !parse.lines()[line].text().contains('#') {
        return;
    }
    for child in parse.lines()[line].tree().children() {
        let NodeOrToken::Token(token) = child else {
            at += match child {
                NodeOrToken::Node(node) => node.text_len(),
                NodeOrToken::Token(token) => token.text_len(),
            };
            continue;
        };
        let (text, start) = (token.text(), at);
        at += TextSize::of(text);
        if !text.starts_with('#') {
            continue;
        }
        comments += 1;
        let comment = TextRange::at(start, TextSize::of(text));
        let asked = directive::read(text, start, out);
        if let Some(Directive::Says(word)) = asked {
            said.enter(context, (word, comment), line, out);
        }
        if let Some(Directive::Allow { rules, file }) = asked {
            allows.push(Allow {
                comment,
                rules: rules
                    .into_iter()
                    .map(|rule| Switched { rule, used: false })
                    .collect(),
                covers: if file {
                    TextRange::up_to(parse.text_len())
                } else {
                    covers()
                },
                whole_file: file,
                removal: None,
            });
        }
    }
    if comments == 1 && kind == LineKind::Comment {
        for allow in &mut allows[before..] {
            allow.removal = Some(parse.line_range(line));
        }
    }
}
