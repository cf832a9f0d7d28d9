//! Findings that only follow from another one: an error is reported once.
//!
//! A slip in the text changes what is read after it: a label that cannot be read makes its jumps lead nowhere, a
//! section that is not recognised leaves its tags undeclared. What can be explained so is not shown; it comes back
//! if it is still true when the slip is gone.

use super::frame_keyword;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::excerpt::Excerpts;
use crate::names::context::Context;
use crate::names::scope::TagFacts;
use crate::networks::control_flow::ControlFlow;
use crate::networks::network::{Meaning, breaks_drawing};
use crate::networks::unread_line::{identifiers, looks_like_declaration};
use crate::networks::{BlockAt, NetworkAt};
use crate::written::facts::{Node, NodeKind};
use ladder_instructions::Op;
use ladder_syntax::{LineKind, Name, Parse, SyntaxErrorKind, TextRange};
use rustc_hash::FxHashSet;

/// Says of findings whether they follow from the errors of the text. Those about the errors themselves are not to
/// be asked about.
pub(crate) struct FollowUps<'c> {
    context: &'c Context,
    doubt: Doubt,
    excerpts: Excerpts<'c>,
}

impl<'c> FollowUps<'c> {
    /// None: there is no error that anything could follow from.
    pub(crate) fn new(context: &'c Context) -> Option<Self> {
        let doubt = Doubt::new(context);
        let is_some = doubt != Doubt::default() || !context.foreign_comments().0.is_empty();
        is_some.then(|| FollowUps {
            context,
            doubt,
            excerpts: Excerpts::new(&context.parse),
        })
    }

    /// Whether a finding follows from an error.
    pub(crate) fn explain(&mut self, found: &Diagnostic) -> bool {
        self.doubt.explains(self.context, found, &mut self.excerpts)
    }
}

/// What errors leave in doubt.
#[derive(Default, PartialEq, Eq)]
struct Doubt {
    /// Rungs on which something was misread.
    misread: FxHashSet<usize>,
    /// Words on lines that could not be read, and operands of blocks that are not known.
    words: FxHashSet<Name>,
    /// A line that could not be read may have been meant as declarations.
    declarations: bool,
    /// The first line of a block definition could not be read.
    block_header: bool,
    /// Blocks that name a tag whose type is open, in their order.
    mistyped: Vec<TextRange>,
    /// A label, or a function, has no name that can be read.
    nameless_label: bool,
    nameless_function: bool,
    /// Block definitions that reach to the end of the text because their end was not found.
    open_blocks: Vec<TextRange>,
    /// An END_FUNCTION_BLOCK has no beginning: a body may be in the program.
    lost_header: bool,
}

impl Doubt {
    fn new(context: &Context) -> Doubt {
        let mut doubt = Doubt::default();
        let parse = &*context.parse;
        let foreign = context.foreign_comments();
        let anywhere = !foreign.0.is_empty();
        for (index, line) in parse.lines().of_parts_that(|part| anywhere || part.is_faulty()) {
            if let Some(comment) = foreign.on_line(index) {
                doubt.misread.insert(index);
                doubt.declarations |= comment.ends_section;
                continue;
            }
            if line.errors.is_empty() && line.kind != LineKind::Stray {
                continue;
            }
            if line.kind == LineKind::Rung && line.errors.iter().any(breaks_drawing) {
                doubt.misread.insert(index);
            }
            doubt.lost_header |= line.kind == LineKind::BlockEnd;
            let text = parse.lines()[index].text().to_owned();
            doubt.words.extend(identifiers(&text).map(Name::new));
            doubt.declarations |= match line.kind {
                LineKind::Declaration | LineKind::SectionHeader | LineKind::SectionEnd => true,
                _ => {
                    looks_like_declaration(line)
                        || identifiers(&text).any(|word| frame_keyword::nearest(word).is_some())
                }
            };
            doubt.block_header |= line.kind == LineKind::BlockHeader;
        }
        let networks = context.networks.iter();
        let marked = networks.filter(|network| !network.known || network.control_flow.has(ControlFlow::MARK));
        marked
            .flat_map(NetworkAt::blocks)
            .for_each(|bound| doubt.block(bound));
        let tags = context.scopes.iter().flat_map(|scope| &scope.tags);
        doubt.mistyped = blocks_that_name(context, tags.filter(|tag| tag.mistyped));
        let is_framed = parse.frame().is_whole();
        if !is_framed {
            let definitions = parse.frame().blocks.iter();
            let open = definitions.filter(|block| !block.closed);
            let lines = |block: &ladder_syntax::BlockDefinition| {
                let last = parse.line_range(block.lines.end - 1);
                parse.line_range(block.lines.start).cover(last)
            };
            doubt.open_blocks = open.map(lines).collect();
        }
        doubt.lost_header |= !doubt.open_blocks.is_empty() || (!is_framed && has_lost_header(parse));
        doubt
    }

    fn block(&mut self, bound: BlockAt<'_>) {
        match bound.meaning {
            Meaning::Unknown => {
                let names = bound
                    .facts
                    .operands
                    .iter()
                    .filter_map(|operand| name(&operand.value));
                self.words.extend(names.map(Name::new));
            }
            Meaning::Instruction(row) if matches!(row.op, Op::Lbl | Op::Fun) => {
                let named = bound
                    .facts
                    .operands
                    .first()
                    .is_some_and(|o| name(&o.value).is_some());
                let named = named && !bound.faulty;
                self.nameless_label |= row.op == Op::Lbl && !named;
                self.nameless_function |= row.op == Op::Fun && !named;
            }
            _ => {}
        }
    }

    fn explains(&self, context: &Context, found: &Diagnostic, excerpts: &mut Excerpts<'_>) -> bool {
        let (at, parse) = (found.range, &*context.parse);
        let on_misread_line = || {
            let line = parse.line_at(at.start());
            line.is_some_and(|line| self.misread.contains(&line))
        };
        if !self.misread.is_empty() && on_misread_line() {
            return true;
        }
        // A rung in a comment is none.
        let comments = context.foreign_comments();
        let mut elsewhere = found.related.iter().filter(|related| related.file.is_none());
        if elsewhere.any(|related| comments.explain(parse, related.range.start())) {
            return true;
        }
        if found.rule.is_about_types() && contains(&self.mistyped, at) {
            return true;
        }
        let is_in =
            |words: &FxHashSet<Name>, text: &str| !words.is_empty() && words.contains(&Name::new(text));
        match found.rule {
            super::unknown_label::RULE => self.nameless_label || is_in(&self.words, excerpts.text(at).0),
            super::unknown_function::RULE => {
                self.nameless_function || is_in(&self.words, excerpts.text(at).0)
            }
            super::unknown_block::RULE => {
                let (head, _) = excerpts.text(at);
                let name = head.trim_matches(|c: char| !c.is_alphanumeric() && c != '_');
                self.block_header || is_in(&self.words, name)
            }
            super::undeclared_tag::RULE => self.lost_header || self.declarations || self.in_open_block(at),
            super::unknown_member::RULE => {
                !self.words.is_empty() && is_in(&self.words, word_before(parse, at, excerpts))
            }
            super::recursive_block::RULE | super::wrong_place::RULE => self.in_open_block(at),
            _ => false,
        }
    }

    fn in_open_block(&self, range: TextRange) -> bool {
        contains(&self.open_blocks, range)
    }
}

/// Whether one of some places holds the start of another. They are in the order of the file, none inside another.
fn contains(places: &[TextRange], range: TextRange) -> bool {
    let next = places.partition_point(|place| place.start() <= range.start());
    next.checked_sub(1)
        .is_some_and(|place| places[place].contains_inclusive(range.start()))
}

/// The blocks that name one of some tags.
fn blocks_that_name<'c>(context: &Context, tags: impl Iterator<Item = &'c TagFacts>) -> Vec<TextRange> {
    let uses = tags.flat_map(|tag| context.uses(tag));
    let mut blocks: Vec<TextRange> = uses
        .map(|place| context.networks.at(place.network).block(place.block).range())
        .collect();
    blocks.sort_unstable_by_key(|range| range.start());
    blocks.dedup();
    blocks
}

/// Whether an END_FUNCTION_BLOCK ends no definition.
fn has_lost_header(parse: &Parse) -> bool {
    use ladder_syntax::DeclarationProblem::EndWithoutBlock;
    let ends = parse
        .lines()
        .iter()
        .filter(|line| line.kind == LineKind::BlockEnd)
        .count();
    let closed = parse.frame().blocks.iter().filter(|block| block.closed).count();
    ends > closed
        && parse
            .errors()
            .iter()
            .any(|error| error.kind == SyntaxErrorKind::BadDeclaration(EndWithoutBlock))
}

fn name(node: &Node) -> Option<&str> {
    match &node.kind {
        NodeKind::Name(name) => Some(name),
        _ => None,
    }
}

/// The identifier before the point of a member.
fn word_before<'e>(parse: &Parse, member: TextRange, excerpts: &'e mut Excerpts<'_>) -> &'e str {
    let Some(line) = parse.line_at(member.start()) else {
        return "";
    };
    let (before, _) = excerpts.text(TextRange::new(parse.line_start(line), member.start()));
    let before = before.trim_end_matches(['.', ' ', '\t']);
    before
        .rsplit(|c: char| !c.is_alphanumeric() && c != '_')
        .next()
        .unwrap_or_default()
}
