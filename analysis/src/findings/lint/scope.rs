//! Where the comments are that switch rules off, and what each of them covers.

use super::directive::{self, Directive, Word};
use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::networks::NetworkAt;
use crate::rule::Rule;
use ladder_syntax::wiring::{PartKind, RungPart};
use ladder_syntax::{LineKind, NodeOrToken, TextRange, TextSize};

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

/// All such comments of a file, of which these are the lines with directives, from top to bottom. What is wrong with directives goes
/// to `out`.
pub(super) fn allows(
    context: &Context,
    asking: impl Iterator<Item = usize>,
    out: &mut Vec<Diagnostic>,
) -> Vec<Allow> {
    let parse = &context.parse;
    let mut allows = Vec::new();
    let mut said = Said::default();
    for line in asking {
        let kind = parse.lines()[line].kind;
        let network = context.networks.on_line(line);
        let covers = || match network {
            // On a line of its own within a network, or behind one of its rungs, it applies to that.
            Some(network) => network.range,
            // Between the things of a file it applies to what is next.
            None => next_thing(context, line),
        };
        let is_read = match network {
            Some(network) if kind == LineKind::Rung => has_comment_aside(network, line),
            _ => holds_comments(kind) && !is_in_section(context, line),
        };
        if is_read {
            read_line(context, line, covers, (&mut allows, &mut said), out);
        }
    }
    allows
}

/// Whether a comment that is no piece of a wire is on a rung.
fn has_comment_aside(network: NetworkAt<'_>, line: usize) -> bool {
    let wiring = &network.wiring;
    let rung = wiring.line_offsets.binary_search(&(line - network.first_line));
    let aside = |part: &RungPart| part.kind == PartKind::Comment && part.segment.is_none();
    rung.is_ok_and(|rung| wiring.rungs[rung].parts.iter().any(aside))
}

fn is_in_section(context: &Context, line: usize) -> bool {
    let sections = &context.parse.frame().sections;
    let behind = sections.partition_point(|section| section.lines.start <= line);
    let above = behind.checked_sub(1).map(|above| &sections[above]);
    above.is_some_and(|section| section.lines.contains(&line))
}

const fn holds_comments(kind: LineKind) -> bool {
    matches!(kind, LineKind::Comment | LineKind::Rail)
}

/// The network, section, first line of a block definition, or line that means nothing, that is next below a line; an empty range if
/// none is.
fn next_thing(context: &Context, line: usize) -> TextRange {
    let parse = &context.parse;
    let below = line + 1;
    let networks = context
        .networks
        .partition_point(|network| network.first_line < below);
    let network = context.networks.get(networks).map(NetworkAt::lines);
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
    let next = [network, section, header]
        .into_iter()
        .flatten()
        .min_by_key(|lines| lines.start);
    let end = next.as_ref().map_or(parse.lines().len(), |lines| lines.start);
    let stray = (below..end).find(|&line| parse.lines()[line].kind == LineKind::Stray);
    let next = stray.map(|line| line..line + 1).or(next);
    next.map_or_else(TextRange::default, |lines| {
        TextRange::new(
            parse.line_start(lines.start),
            parse.line_range(lines.end - 1).end(),
        )
    })
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
    covers: impl Fn() -> TextRange,
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
