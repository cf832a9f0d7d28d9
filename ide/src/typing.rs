//! Where a person types: what the block, operand or declaration around the cursor is.
//!
//! Read off the tokens in front of the cursor, so that it holds for half-written text: a first part without its
//! bracket, an operand list without its parenthesis. What stands at an offset of finished text is for `locate`.

use ladder_analysis::context::{Body, Context};
use ladder_instructions::Shape;
use ladder_syntax::rowan::GreenNodeData;
use ladder_syntax::{LineKind, Mode, NodeOrToken, SyntaxKind, TextRange, TextSize};
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
    /// Whether the cursor is in a string or a number: nobody's to complete.
    pub(crate) literal: bool,
    pub(crate) place: Place,
}

/// What is being written.
#[derive(Debug)]
pub(crate) enum Place {
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
    /// Behind its closing bracket, if that is there.
    pub(crate) closed: Option<usize>,
    /// Whether an operand list follows.
    pub(crate) has_list: bool,
}

/// An operand that is being written.
#[derive(Debug, Default)]
pub(crate) struct Operand {
    pub(crate) shape: Option<Shape>,
    /// What the block's first part says.
    pub(crate) head: String,
    /// The operands by place in front of this one.
    pub(crate) before: Vec<Range<usize>>,
    /// Number of operands by place in the whole list.
    pub(crate) count: usize,
    /// The name in front of `:=` or `=>`.
    pub(crate) name: Option<String>,
    /// The names of the other named operands.
    pub(crate) given: Vec<String>,
    /// What is open inside the operand, outermost first.
    pub(crate) open: Vec<Open>,
    /// Whether a value ends right in front of the word: an operator fits here, no value.
    pub(crate) behind_value: bool,
    /// The place in front of the `.` that stands before the word.
    pub(crate) member_of: Option<Range<usize>>,
    /// Whether the operand begins with this word.
    pub(crate) first_word: bool,
    /// Whether something of the operand stands behind the word.
    pub(crate) goes_on: bool,
    /// Whether that is a value: none fits in front of it.
    pub(crate) before_value: bool,
    /// Whether the list has its closing parenthesis.
    pub(crate) closed: bool,
}

/// A bracket that is open inside of an operand.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Open {
    /// `a[`
    Index,
    /// `(` of an expression.
    Group,
    /// `SQRT(`, with the number of commas behind it.
    Call(String, usize),
}

/// A place in a declaration.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Declaration {
    /// Behind a section's keyword: RETAIN or CONSTANT.
    Header,
    /// Where a name is declared; whether it is the first thing on its line.
    Names(bool),
    /// Behind names: AT.
    BehindNames,
    /// Behind AT.
    Address,
    /// Behind the colon.
    Type,
    /// Behind ARRAY with its bounds.
    Of,
    /// Behind `:=`.
    Initial,
}

#[derive(Debug, Clone, Copy)]
struct Token {
    kind: SyntaxKind,
    start: usize,
    end: usize,
}

/// What is being written at an offset. None in comments, and where nothing can be said.
pub(crate) fn typing(context: &Context, offset: TextSize) -> Option<Typing<'_>> {
    let parse = &context.parse;
    let behind_last = parse
        .lines()
        .last()
        .is_none_or(|line| offset == parse.text_len() && line.node().to_string().ends_with(['\n', '\r']));
    let line = if behind_last {
        parse.lines().len()
    } else {
        parse.line_at(offset)?
    };
    let in_section = line
        .checked_sub(1)
        .is_some_and(|before| parse.lines()[before].mode_after == Mode::Section);
    let (text, base, kind) = match parse.lines().get(line) {
        Some(found) => (found.node().to_string(), parse.line_start(line), found.kind),
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
        place: Place::LineStart,
    };
    let Some(found) = parse.lines().get(line) else {
        if in_section {
            typing.place = Place::Declaration(Declaration::Names(true));
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
        LineKind::Rail => return None,
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
                typing.place = Place::Declaration(Declaration::Names(true));
            }
        }
        LineKind::SectionHeader => {
            if !typing.text[..typing.word.start].trim().is_empty() {
                typing.place = Place::Declaration(Declaration::Header);
            }
        }
        _ => typing.place = Place::Declaration(declaration(&tokens, &typing)?),
    }
    Some(typing)
}

impl Typing<'_> {
    /// The word in front of the cursor.
    pub(crate) fn prefix(&self) -> &str {
        &self.text[self.word.start..self.cursor]
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
        let start = self.text[..self.cursor]
            .rfind(['\n', '\r'])
            .map_or(0, |at| at + 1);
        let end = self.text[self.cursor..]
            .find(['\n', '\r'])
            .map_or(self.text.len(), |at| self.cursor + at);
        start..end
    }

    /// What stands behind a place on its physical line.
    pub(crate) fn rest(&self, from: usize) -> &str {
        &self.text[from..self.physical_line().end.max(from)]
    }
}

/// The scope of the tags on a line outside of networks.
fn scope_of(context: &Context, line: usize) -> usize {
    let blocks = &context.parse.structure().blocks;
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
    let behind = text[cursor..].trim_start_matches(is_word);
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
    start..text.len() - behind.len()
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

fn on_rung(line: &GreenNodeData, typing: &mut Typing<'_>) -> Option<Place> {
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
            .then_some(Place::Wire)
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
            // One character behind a list that is not closed may be an operator or a rail.
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
            Some(Place::Operand(operand))
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
            Some(Place::Head(Head {
                shape,
                closed: head_closed.then_some(head_end),
                has_list: list.is_some(),
            }))
        }
        // Between a first part and its list.
        _ if cursor < end => None,
        _ => on_wire(typing),
    }
}

/// Whether the parenthesis that opens a list is closed.
fn parenthesis_closes(list: &[Token]) -> bool {
    let mut depth = 0;
    for token in list {
        match token.kind {
            SyntaxKind::L_PAREN => depth += 1,
            SyntaxKind::R_PAREN => depth -= 1,
            _ => continue,
        }
        if depth == 0 {
            return true;
        }
    }
    false
}

/// The operand around the cursor. `from`: where the list begins.
fn operand(list: &[Token], from: usize, closed: bool, typing: &mut Typing<'_>) -> Operand {
    let (text, word) = (&typing.text, &typing.word);
    let mut operand = Operand {
        closed,
        first_word: true,
        ..Operand::default()
    };
    let mut start = from + 1;
    // Where the value begins that ends in front of the word.
    let mut value: Option<usize> = None;
    let mut last: Option<Token> = None;
    for token in list.iter().skip(1).take_while(|token| token.end <= word.start) {
        if token.kind.is_trivia() {
            continue;
        }
        operand.first_word = false;
        match token.kind {
            SyntaxKind::L_PAREN => {
                operand.open.push(match (value, last) {
                    (Some(from), Some(last)) if last.kind == SyntaxKind::IDENT => {
                        Open::Call(text[from..last.end].to_owned(), 0)
                    }
                    _ => Open::Group,
                });
                value = None;
            }
            SyntaxKind::L_BRACKET => {
                operand.open.push(Open::Index);
                value = None;
            }
            SyntaxKind::R_PAREN | SyntaxKind::R_BRACKET => {
                operand.open.pop();
                value.get_or_insert(token.start);
            }
            SyntaxKind::COMMA => {
                value = None;
                match operand.open.last_mut() {
                    Some(Open::Call(_, commas)) => *commas += 1,
                    Some(_) => {}
                    None => {
                        match operand.name.take() {
                            Some(name) => operand.given.push(name),
                            None => operand.before.push(start..token.start),
                        }
                        start = token.end;
                        operand.first_word = true;
                    }
                }
            }
            SyntaxKind::ASSIGN | SyntaxKind::ARROW => {
                operand.name = Some(text[start..token.start].trim().to_owned());
                value = None;
            }
            SyntaxKind::IDENT | SyntaxKind::ADDRESS | SyntaxKind::LITERAL | SyntaxKind::STRING => {
                value.get_or_insert(token.start);
            }
            SyntaxKind::DOT => {}
            _ => value = None,
        }
        last = Some(*token);
    }
    if let (Some(last), Some(from)) = (last.filter(|last| last.kind == SyntaxKind::DOT), value) {
        operand.member_of = Some(from..last.start);
    } else if last.is_some_and(|last| last.kind == SyntaxKind::DOT)
        || text[word.clone()].starts_with(|c: char| c.is_ascii_digit())
        || text[word.end..].starts_with('#')
    {
        // A number or a duration.
        typing.literal = true;
    } else {
        operand.behind_value = value.is_some();
    }
    behind(list, typing, &mut operand);
    operand
}

/// What stands behind the word: whether the operand goes on, and which operands follow.
fn behind(list: &[Token], typing: &Typing<'_>, operand: &mut Operand) {
    let mut depth = operand.open.len();
    let mut this = true;
    let mut following = 0;
    let mut name = None;
    let mut written = false;
    for token in list.iter().filter(|token| token.start >= typing.word.end) {
        match token.kind {
            kind if kind.is_trivia() => continue,
            SyntaxKind::L_PAREN | SyntaxKind::L_BRACKET => depth += 1,
            SyntaxKind::R_PAREN if depth == 0 => break,
            SyntaxKind::R_PAREN | SyntaxKind::R_BRACKET => depth = depth.saturating_sub(1),
            SyntaxKind::COMMA if depth == 0 => {
                following += usize::from(!this && name.is_none() && written);
                operand.given.extend(name.take());
                (this, written) = (false, false);
                continue;
            }
            SyntaxKind::IDENT if !this && name.is_none() && !written => {
                name = None;
            }
            SyntaxKind::ASSIGN | SyntaxKind::ARROW if !this && depth == 0 => {
                let before = typing.text[..token.start].trim_end();
                let from = before.trim_end_matches(is_word).len();
                name = Some(before[from..].to_owned());
            }
            _ => {}
        }
        written = true;
        if this && !operand.goes_on {
            operand.goes_on = true;
            operand.before_value = matches!(
                token.kind,
                SyntaxKind::IDENT | SyntaxKind::ADDRESS | SyntaxKind::LITERAL | SyntaxKind::STRING
            );
        }
    }
    following += usize::from(!this && name.is_none() && written);
    operand.given.extend(name);
    operand.count = operand.before.len() + usize::from(operand.name.is_none()) + following;
}

fn declaration(tokens: &[Token], typing: &Typing<'_>) -> Option<Declaration> {
    let line = typing.physical_line();
    let alone = typing.text[line.start..typing.word.start].trim().is_empty();
    let mut place = Declaration::Names(alone);
    for token in tokens.iter().take_while(|token| token.end <= typing.word.start) {
        let word = &typing.text[token.start..token.end];
        place = match token.kind {
            kind if kind.is_trivia() => continue,
            SyntaxKind::KEYWORD if word.eq_ignore_ascii_case("AT") => Declaration::Address,
            SyntaxKind::KEYWORD if word.eq_ignore_ascii_case("OF") => Declaration::Type,
            SyntaxKind::COLON => Declaration::Type,
            SyntaxKind::ASSIGN => Declaration::Initial,
            SyntaxKind::COMMA if matches!(place, Declaration::Names(_) | Declaration::BehindNames) => {
                Declaration::Names(false)
            }
            SyntaxKind::SEMICOLON => Declaration::Names(alone),
            SyntaxKind::R_BRACKET if matches!(place, Declaration::Type) => Declaration::Of,
            _ if matches!(place, Declaration::Names(_)) => Declaration::BehindNames,
            // Behind a type, or inside its bounds, nothing is to be named.
            SyntaxKind::L_BRACKET => place,
            _ => place,
        };
    }
    // A half-written line is read together with the one below it: a new physical line begins a new declaration.
    if alone && !matches!(place, Declaration::Names(_)) {
        place = Declaration::Names(true);
    }
    let number = typing.text[typing.word.clone()].starts_with(|c: char| c.is_ascii_digit());
    (!number).then_some(place)
}
