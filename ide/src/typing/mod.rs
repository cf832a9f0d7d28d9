//! Where a person types: what the block, operand or declaration around the cursor is.
//!
//! Read off the tokens in front of the cursor, so that it holds for half-written text: a first part without its
//! bracket, an operand list without its parenthesis. What is at an offset of finished text is for `locate`.

mod declaration;
mod operand;

pub(crate) use declaration::Declaration;
pub(crate) use operand::{Open, Operand};

use crate::path;
use declaration::declaration;
use ladder_analysis::context::{Body, Context};
use ladder_analysis::values::types::Type;
use ladder_instructions::Shape;
use ladder_syntax::rowan::GreenNodeData;
use ladder_syntax::{LineKind, Mode, Name, NodeOrToken, SyntaxKind, TextRange, TextSize, line_around};
use operand::{operand, parenthesis_closes};
use std::ops::Range;

/// A place in a text, with the word that is being written there.
pub(crate) struct Typing<'c> {
    pub(crate) context: &'c Context,
    /// The text of the logical line.
    pub(crate) text: String,
    /// Where it starts.
    base: TextSize,
    /// The cursor in it.
    pub(crate) cursor: usize,
    /// The word around the cursor, a `$` or `%` in front of it included.
    pub(crate) word: Range<usize>,
    /// The scope of the tags that are known here.
    pub(crate) scope: usize,
    /// The body that the network belongs to, if it is one.
    pub(crate) body: Option<Body>,
    /// Whether the cursor is in a string or a number: there is nothing to complete.
    pub(crate) literal: bool,
    pub(crate) place: CursorContext,
}

impl Typing<'_> {
    /// The section that is open where a person types.
    pub(crate) fn section(&self) -> Mode {
        let parse = &self.context.parse;
        let line = parse.line_at(self.base).unwrap_or_default();
        let before = line.checked_sub(1).map(|before| parse.lines()[before].mode_after);
        before.unwrap_or_default()
    }
}

/// What is being written.
#[derive(Debug)]
pub(crate) enum CursorContext {
    /// An empty line outside of sections, or the first word on one.
    LineStart,
    /// A rung, outside of blocks.
    Wire,
    /// The first part of a block.
    Head(Head),
    /// An operand.
    Operand(Operand),
    /// A line of declarations, or of a block definition's frame.
    Declaration(Declaration),
}

/// The first part of a block that is being written.
#[derive(Debug)]
pub(crate) struct Head {
    pub(crate) shape: Shape,
    /// Where its opening bracket is.
    pub(crate) open: usize,
    /// After its closing bracket, if that is there.
    pub(crate) closed: Option<usize>,
    /// Whether an operand list follows.
    pub(crate) has_list: bool,
}

#[derive(Debug, Clone, Copy)]
struct Token {
    kind: SyntaxKind,
    start: usize,
    end: usize,
}

/// What is being written at an offset. None in comments, and where that cannot be known.
pub(crate) fn typing(context: &Context, offset: TextSize) -> Option<Typing<'_>> {
    let parse = &context.parse;
    let after_last = parse
        .lines()
        .last()
        .is_none_or(|line| offset == parse.text_len() && line.text().ends_with(['\n', '\r']));
    let line = if after_last {
        parse.lines().len()
    } else {
        parse.line_at(offset)?
    };
    let in_section = line
        .checked_sub(1)
        .is_some_and(|before| parse.lines()[before].mode_after.is_in_section());
    let (text, base, kind) = match parse.lines().get(line) {
        Some(found) => (found.text().to_owned(), parse.line_start(line), found.kind),
        None => (String::new(), parse.text_len(), LineKind::Blank),
    };
    let cursor = usize::from(offset - base);
    if !text.is_char_boundary(cursor) {
        return None;
    }
    let mut typing = Typing {
        context,
        word: word(&text, cursor),
        text,
        base,
        cursor,
        scope: scope_of(context, line),
        body: None,
        literal: false,
        place: CursorContext::LineStart,
    };
    let Some(found) = parse.lines().get(line) else {
        if in_section {
            typing.place = CursorContext::Declaration(Declaration::Names(true));
        }
        return Some(typing);
    };
    let mut tokens = Vec::new();
    flatten(found.green(), &mut 0, &mut tokens);
    if is_inside(SyntaxKind::COMMENT, '#', &tokens, &typing.text, cursor) {
        return None;
    }
    typing.literal = is_inside(SyntaxKind::STRING, '\'', &tokens, &typing.text, cursor);
    match kind {
        LineKind::Rung => {
            let network = context
                .networks
                .partition_point(|network| network.range.end() <= base);
            if let Some(network) = context.networks.get(network) {
                typing.scope = network.scope;
            }
            typing.body = context.bodies.get(network).copied();
            typing.place = on_rung(found.green(), &mut typing)?;
        }
        LineKind::Rail | LineKind::Conflict => return None,
        LineKind::Stray | LineKind::Comment | LineKind::Blank if !in_section => {
            let before = typing.physical_line().start;
            if !typing.text[before..typing.word.start].trim().is_empty() {
                return None;
            }
        }
        LineKind::SectionEnd | LineKind::BlockEnd | LineKind::BlockHeader => {
            // The keyword itself may still be in the making.
            if !typing.text[..typing.word.start].trim().is_empty() {
                return None;
            }
            if in_section {
                typing.place = CursorContext::Declaration(Declaration::Names(true));
            }
        }
        LineKind::SectionHeader => {
            if !typing.text[..typing.word.start].trim().is_empty() {
                typing.place = CursorContext::Declaration(Declaration::Header);
            }
        }
        _ => typing.place = CursorContext::Declaration(declaration(&tokens, &typing)?),
    }
    Some(typing)
}

impl Typing<'_> {
    /// The word in front of the cursor.
    pub(crate) fn prefix(&self) -> &str {
        &self.text[self.word.start..self.cursor]
    }

    /// Whether a path is a tag of a user-defined block's own type.
    pub(crate) fn keeps_state(&self, path: &str, block: &str) -> bool {
        let ty = block
            .starts_with('$')
            .then(|| path::type_of(self.context, self.scope, path));
        let of = ty.flatten().and_then(|ty| match ty {
            Type::Compound(id) => id.block(),
            _ => None,
        });
        of.is_some_and(|of| Name::new(&of) == Name::new(block))
    }

    /// A stretch of the line, counted from the start of the file.
    pub(crate) fn absolute(&self, range: Range<usize>) -> TextRange {
        TextRange::new(
            self.base + TextSize::new(range.start as u32),
            self.base + TextSize::new(range.end as u32),
        )
    }

    /// The physical line of the cursor, without its line end.
    pub(crate) fn physical_line(&self) -> Range<usize> {
        line_around(&self.text, TextSize::new(self.cursor as u32)).into()
    }

    /// What is after a place on its physical line.
    pub(crate) fn rest(&self, from: usize) -> &str {
        &self.text[from..self.physical_line().end.max(from)]
    }
}

/// The scope of the tags on a line outside of networks.
fn scope_of(context: &Context, line: usize) -> usize {
    let blocks = &context.parse.frame().blocks;
    blocks
        .iter()
        .position(|block| block.lines.contains(&line) || (!block.closed && line >= block.lines.start))
        .map_or(0, |block| block + 1)
}

fn flatten(node: &GreenNodeData, at: &mut usize, out: &mut Vec<Token>) {
    for child in node.children() {
        match child {
            NodeOrToken::Node(node) => flatten(node, at, out),
            NodeOrToken::Token(token) => {
                let start = *at;
                *at += token.text().len();
                out.push(Token {
                    kind: SyntaxKind::from_raw(token.kind()),
                    start,
                    end: *at,
                });
            }
        }
    }
}

fn is_word(c: char) -> bool {
    c == '_' || c.is_alphanumeric()
}

/// The word around a place, with the `$` or `%` in front of it.
fn word(text: &str, cursor: usize) -> Range<usize> {
    let before = text[..cursor].trim_end_matches(is_word);
    let after = text[cursor..].trim_start_matches(is_word);
    let mut start = before.len();
    if before.ends_with(['$', '%']) {
        start -= 1;
    } else if let Some(address) = before.rfind('%') {
        // `%IX0.3`
        let rest = &before[address + 1..];
        if rest.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'.') && !rest.is_empty() {
            start = address;
        }
    }
    start..text.len() - after.len()
}

/// Whether a place is inside of a comment or a string, which ends with `quote`.
fn is_inside(kind: SyntaxKind, quote: char, tokens: &[Token], text: &str, at: usize) -> bool {
    let open = |token: &Token| {
        let written = &text[token.start..token.end];
        written.len() < 2 || !written.ends_with(quote)
    };
    let mut these = tokens
        .iter()
        .filter(|token| token.kind == kind && token.start < at);
    these.any(|token| at < token.end || at == token.end && open(token))
}

fn on_rung(line: &GreenNodeData, typing: &mut Typing<'_>) -> Option<CursorContext> {
    let cursor = typing.cursor;
    let mut at = 0;
    let mut block = None;
    for child in line.children() {
        let (kind, len) = match child {
            NodeOrToken::Node(node) => (SyntaxKind::from_raw(node.kind()), usize::from(node.text_len())),
            NodeOrToken::Token(token) => (SyntaxKind::from_raw(token.kind()), usize::from(token.text_len())),
        };
        if at >= cursor {
            break;
        }
        if let (true, NodeOrToken::Node(node)) = (kind.is_block(), child) {
            block = Some((kind, node, at, at + len));
        }
        at += len;
    }
    let on_wire = |typing: &Typing<'_>| {
        // A word that touches a digit or dot means nothing on a wire.
        typing.text[typing.word.clone()]
            .chars()
            .all(|c| c.is_alphabetic() || c == '_')
            .then_some(CursorContext::Wire)
    };
    let Some((kind, node, start, end)) = block else {
        return on_wire(typing);
    };
    let shape = match kind {
        SyntaxKind::LOGICAL_BLOCK => Shape::Logical,
        SyntaxKind::COIL_BLOCK => Shape::Coil,
        _ => Shape::Function,
    };
    let mut tokens = Vec::new();
    let (mut head_end, mut list) = (start, None);
    let mut place = start;
    for child in node.children() {
        match child {
            NodeOrToken::Node(node) => {
                let kind = SyntaxKind::from_raw(node.kind());
                let from = place;
                let first = tokens.len();
                flatten(node, &mut place, &mut tokens);
                if kind == SyntaxKind::BLOCK_HEAD {
                    head_end = place;
                } else {
                    list.get_or_insert((from, first));
                }
            }
            NodeOrToken::Token(token) => place += usize::from(token.text_len()),
        }
    }
    let (open, close) = shape.brackets();
    let head_closed = typing.text[start..head_end].ends_with(close) && head_end > start + 1;
    let gap_is_blank = cursor <= end || typing.text[end..cursor].trim_matches([' ', '\t', ',']).is_empty();
    match list {
        Some((from, first)) if cursor > from => {
            let list = &tokens[first..];
            let closed = parenthesis_closes(list);
            // One character after a list that is not closed may be an operator or a rail.
            if !closed && !gap_is_blank && typing.text[end..cursor].trim().len() == 1 {
                return None;
            }
            if !gap_is_blank || closed && cursor >= end {
                return on_wire(typing);
            }
            let mut operand = operand(list, from, closed, typing);
            operand.shape = Some(shape);
            let head = typing.text[start..head_end].trim_matches([open, close, ' ', '\t']);
            operand.head.push_str(head);
            let first = operand.before.first().cloned();
            if let Some(first) = first.filter(|first| typing.keeps_state(&typing.text[first.clone()], head)) {
                operand.state = Some(first);
                operand.before.remove(0);
                operand.count -= 1;
            }
            Some(CursorContext::Operand(operand))
        }
        _ if !head_closed && gap_is_blank || cursor < head_end => {
            // All of the first part is one word, `/` too.
            let inner_end = if head_closed { head_end - 1 } else { head_end };
            let inner = &typing.text[start + 1..inner_end.max(start + 1)];
            if inner.contains('#') {
                return None;
            }
            let first = inner.len() - inner.trim_start().len();
            typing.word = if inner.trim().is_empty() {
                cursor..cursor
            } else {
                let last = start + 1 + inner.trim_end().len();
                (start + 1 + first).min(cursor)..last.max(cursor)
            };
            Some(CursorContext::Head(Head {
                shape,
                open: start,
                closed: head_closed.then_some(head_end),
                has_list: list.is_some(),
            }))
        }
        // Between a first part and its list.
        _ if cursor < end => None,
        _ => on_wire(typing),
    }
}
