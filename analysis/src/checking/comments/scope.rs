//! Where the comments are that switch rules off, and what each of them covers.

use super::directive::{self, Directive, Word};
use super::unread_names::unknown_names;
use crate::asked::may_ask;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::Rule;
use crate::names::context::Context;
use crate::networks::NetworkAt;
use ladder_syntax::wiring::{PartKind, RungPart};
use ladder_syntax::{LineKind, NodeOrToken, Part, TextRange, TextSize};
use std::ops::Range;

/// A comment that switches rules off.
#[derive(Debug)]
pub(super) struct Allow {
    /// The comment.
    pub(super) comment: TextRange,
    pub(super) rules: Vec<Rule>,
    pub(super) covers: Covers,
    /// What to take out to be rid of the comment: its line, if nothing else is there.
    pub(super) removal: Option<TextRange>,
}

/// Where what rules find is not shown.
#[derive(Debug)]
pub(super) enum Covers {
    File,
    /// On the lines of a network, by its index.
    Network(usize),
    /// On lines of something else; on none if nothing is below the comment.
    Lines(Range<usize>),
}

impl Covers {
    /// The lines; none for the whole file.
    pub(super) fn lines(&self, context: &Context) -> Option<Range<usize>> {
        match self {
            Covers::File => None,
            Covers::Network(index) => Some(context.networks.at(*index).lines()),
            Covers::Lines(lines) => Some(lines.clone()),
        }
    }
}

/// What comments to the tools say.
#[derive(Debug, Default)]
pub(super) struct Directives {
    pub(super) allows: Vec<Allow>,
    pub(super) says: Vec<Says>,
    /// What is wrong with them, each by itself.
    pub(super) wrong: Vec<Diagnostic>,
    /// The definition that a comment made an unread part last.
    unread: Option<usize>,
}

impl Directives {
    /// Whether a line is the first in the definition of a block with a comment that makes it an unread part.
    fn is_first_unread(&mut self, context: &Context, line: usize) -> bool {
        let blocks = &context.parse.frame().blocks;
        let after = blocks.partition_point(|block| block.lines.start <= line);
        let block = after
            .checked_sub(1)
            .filter(|block| blocks[*block].lines.contains(&line));
        let is_own_line = context.parse.lines()[line].kind.is_decoration();
        block.is_some() && is_own_line && block != std::mem::replace(&mut self.unread, block)
    }
}

/// A comment that says something of the file.
#[derive(Debug, Clone, Copy)]
pub(super) struct Says {
    word: Word,
    comment: TextRange,
}

/// What the comments of a file say.
pub(super) fn directives(context: &Context) -> Directives {
    let parse = &context.parse;
    let mut directives = Directives::default();
    let commented = parse.lines().of_parts_that(Part::is_commented);
    for (line, _) in commented.filter(|(_, line)| line.is_commented() && may_ask(line.text())) {
        let kind = parse.lines()[line].kind;
        let network = context.networks.on_line(line);
        let covers = || match network {
            // On a line of its own within a network, or after one of its rungs, it applies to that.
            Some(network) => Covers::Network(network.index),
            // Between the things of a file it applies to what is next.
            None => next_thing(context, line),
        };
        let is_read = match network {
            Some(network) if kind == LineKind::Rung => has_comment_aside(network, line),
            _ => holds_comments(kind) && !is_in_section(context, line),
        };
        if is_read {
            read_line(context, line, covers, &mut directives);
        }
    }
    directives
}

/// Whether a comment that is not a piece of a wire is on a rung.
fn has_comment_aside(network: NetworkAt<'_>, line: usize) -> bool {
    let wiring = &network.wiring;
    let rung = wiring.line_offsets.binary_search(&(line - network.first_line));
    let aside = |part: &RungPart| part.kind == PartKind::Comment && part.segment.is_none();
    rung.is_ok_and(|rung| wiring.rungs[rung].parts.iter().any(aside))
}

fn is_in_section(context: &Context, line: usize) -> bool {
    let sections = &context.parse.frame().sections;
    let after = sections.partition_point(|section| section.lines.start <= line);
    let above = after.checked_sub(1).map(|above| &sections[above]);
    above.is_some_and(|section| section.lines.contains(&line))
}

const fn holds_comments(kind: LineKind) -> bool {
    matches!(kind, LineKind::Comment | LineKind::Rail)
}

/// The network, section, first line of a block definition, or line that means nothing, that is next below a line; no lines if
/// none is.
fn next_thing(context: &Context, line: usize) -> Covers {
    let parse = &context.parse;
    let below = line + 1;
    let index = context
        .networks
        .partition_point(|network| network.first_line < below);
    let network = context.networks.get(index).map(NetworkAt::lines);
    let frame = parse.frame();
    let sections = frame
        .sections
        .partition_point(|section| section.lines.start < below);
    let section = frame.sections.get(sections).map(|section| section.lines.clone());
    let blocks = frame.blocks.partition_point(|block| block.lines.start < below);
    let header = frame
        .blocks
        .get(blocks)
        .map(|block| block.lines.start..block.lines.start + 1);
    let next = [network.clone(), section, header]
        .into_iter()
        .flatten()
        .min_by_key(|lines| lines.start);
    let end = next.as_ref().map_or(parse.lines().len(), |lines| lines.start);
    let stray = (below..end).find(|&line| parse.lines()[line].kind == LineKind::Stray);
    match stray {
        Some(line) => Covers::Lines(line..line + 1),
        None if network.is_some() && next == network => Covers::Network(index),
        None => Covers::Lines(next.unwrap_or_default()),
    }
}

/// What is wrong with comments that say something of the file, all of which these are, from top to bottom: with those that
/// change nothing.
pub(super) fn idle_words(context: &Context, says: impl Iterator<Item = Says>) -> Vec<Diagnostic> {
    let first_network = context.parse.lines().first_network();
    let first_network = first_network.map(|line| context.parse.line_start(line));
    let mut told: Vec<Says> = Vec::new();
    let mut idle = Vec::new();
    for Says { word, comment } in says {
        if first_network.is_some_and(|first| comment.start() >= first) {
            idle.push(directive::too_late(word, comment));
            continue;
        }
        match told.iter().find(|other| other.word == word) {
            Some(first) => {
                let line = context.line_number(first.comment.start());
                idle.push(directive::said_before(word, comment, first.comment, line));
            }
            None => told.push(Says { word, comment }),
        }
    }
    idle
}

/// Says which names in the list of an unread part mean no tag.
fn unknown_tags(context: &Context, line: usize, comment: TextRange, wrong: &mut Vec<Diagnostic>) {
    let blocks = &context.parse.frame().blocks;
    let Some(item) = blocks.iter().position(|block| block.lines.contains(&line)) else {
        return;
    };
    let unread = context
        .user_blocks
        .get(item)
        .and_then(|block| block.unread.as_deref());
    let names = unread.map(|unread| unknown_names(context, item, unread));
    let names = names.unwrap_or_default();
    wrong.extend((!names.is_empty()).then(|| directive::no_tags(&names, comment)));
}

/// Reads the comments of a line.
fn read_line(context: &Context, line: usize, covers: impl Fn() -> Covers, directives: &mut Directives) {
    let parse = &context.parse;
    let mut at = parse.line_start(line);
    let kind = parse.lines()[line].kind;
    let mut comments = 0;
    let before = directives.allows.len();
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
        match directive::read(text, start, &mut directives.wrong) {
            Some(Directive::Says(word)) => directives.says.push(Says { word, comment }),
            Some(Directive::Allow { rules, file }) => directives.allows.push(Allow {
                comment,
                rules,
                covers: if file { Covers::File } else { covers() },
                removal: None,
            }),
            Some(Directive::Unread) if directives.is_first_unread(context, line) => {
                unknown_tags(context, line, comment, &mut directives.wrong);
            }
            Some(Directive::Unread) => directives.wrong.push(directive::no_unread_block(comment)),
            Some(Directive::Known) | None => {}
        }
    }
    if comments == 1 && kind == LineKind::Comment {
        for allow in &mut directives.allows[before..] {
            allow.removal = Some(parse.line_range(line));
        }
    }
}
