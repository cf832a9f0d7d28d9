//! Semantic tokens: what each word of a text is, for the colours of an editor.
//!
//! Only standard kinds, so that every theme has a colour for them; next to the standard modifiers four say which tags are
//! inputs and outputs, and which blocks contacts and coils. The drawing itself (wires, rails,
//! connectors, brackets) has none: it keeps the colour of text, and that of power while a simulation runs.
//!
//! The green nodes of the lines are walked as they are, without a cursor: an editor asks at every change.

mod legend;

pub use legend::{Modifiers, TokenKind};

use ladder_analysis::context::Context;
use ladder_analysis::names::scope::{Origin, SectionKind};
use ladder_analysis::networks::network::{Formal, Meaning};
use ladder_analysis::networks::{BlockAt, NetworkAt};
use ladder_analysis::program::{ParameterKind, Role};
use ladder_analysis::written::type_spec::SpecKind;
use ladder_instructions::{Accepts, Direction, Op};
use ladder_syntax::rowan::GreenNodeData;
use ladder_syntax::{LineKind, Name, NodeOrToken, SyntaxKind, TextRange, TextSize, Trees};
use std::ops::Range;

/// A word and what it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Token {
    /// Where it is. A comment may span lines.
    pub range: TextRange,
    /// What it is.
    pub kind: TokenKind,
    /// What else is known of it.
    pub modifiers: Modifiers,
}

/// The tokens of a text in their order: of all of it, or of the lines that touch a range.
pub fn semantic_tokens(context: &Context, within: Option<TextRange>) -> Vec<Token> {
    let parse = &context.parse;
    let lines = match within {
        Some(within) => {
            let last = parse.line_at(within.end());
            parse.line_at(within.start()).unwrap_or(0)..last.map_or(0, |line| line + 1)
        }
        None => 0..parse.lines().len(),
    };
    semantic_tokens_of(context, lines)
}

/// The tokens of some logical lines, in their order.
pub fn semantic_tokens_of(context: &Context, lines: Range<usize>) -> Vec<Token> {
    let parse = &context.parse;
    let Range {
        start: first,
        end: last,
    } = lines;
    let mut walk = Walk {
        context,
        at: TextSize::new(0),
        scope: 0,
        out: Vec::with_capacity((last - first.min(last)) * 8),
    };
    let mut network = context.networks.partition_point(|network| {
        parse.text_len() > TextSize::new(0)
            && network.range.end() <= parse.line_start(first.min(last.saturating_sub(1)))
    });
    let mut trees = Trees::default();
    // The blocks of a network, and the next one of them.
    let mut bound = Vec::new();
    let mut bound_of = None;
    let mut block = 0;
    let blocks = &parse.frame().blocks;
    let mut definition = blocks.partition_point(|definition| definition.lines.end <= first);
    for line in first..last {
        let start = parse.line_start(line);
        walk.at = start;
        while blocks
            .get(definition)
            .is_some_and(|definition| definition.lines.end <= line)
        {
            definition += 1;
        }
        let inside = blocks
            .get(definition)
            .is_some_and(|definition| definition.lines.contains(&line));
        walk.scope = if inside { definition + 1 } else { 0 };
        let found = &parse.lines()[line];
        if found.kind != LineKind::Rung {
            let inside = Inside {
                declares: true,
                ..Inside::default()
            };
            walk.node(&trees.of(found), inside);
            continue;
        }
        while context
            .networks
            .get(network)
            .is_some_and(|network| network.range.end() <= start)
        {
            network += 1;
            block = 0;
        }
        let here = context.networks.get(network);
        if bound_of != Some(network) {
            bound_of = Some(network);
            bound.clear();
            bound.extend(here.into_iter().flat_map(NetworkAt::blocks));
        }
        if let Some(here) = here {
            walk.scope = here.scope;
        }
        while bound.get(block).is_some_and(|block| block.base < start) {
            block += 1;
        }
        walk.rung(&trees.of(found), &bound, &mut block);
    }
    walk.out
}

/// What surrounds a node.
#[derive(Clone, Copy, Default)]
struct Inside {
    /// The kind of the node around.
    parent: Option<SyntaxKind>,
    /// What names mean.
    names: Names,
    /// Whether a tag that is here is written.
    written: bool,
    /// Whether it is not a rung.
    declares: bool,
    /// Whether it is a block of program flow.
    flow: bool,
    /// Whether it is a contact or a coil.
    shape: Modifiers,
}

#[derive(Clone, Copy, Default, PartialEq)]
enum Names {
    #[default]
    Tags,
    Labels,
    Functions,
    Operators,
    /// Functions that are called in an expression.
    Callee,
    /// Operands that are given by name.
    Operands,
    /// Names that are introduced.
    Declared,
}

struct Walk<'c> {
    context: &'c Context,
    /// Where the next token starts.
    at: TextSize,
    scope: usize,
    out: Vec<Token>,
}

impl Walk<'_> {
    fn rung(&mut self, line: &GreenNodeData, bound: &[BlockAt<'_>], next: &mut usize) {
        for child in line.children() {
            match child {
                NodeOrToken::Node(node) => {
                    while bound
                        .get(*next)
                        .is_some_and(|block| block.range().start() < self.at)
                    {
                        *next += 1;
                    }
                    let block = bound.get(*next).filter(|block| block.range().start() == self.at);
                    self.block(node, block.copied());
                }
                NodeOrToken::Token(token) => {
                    let len = token.text_len();
                    if SyntaxKind::from_raw(token.kind()) == SyntaxKind::COMMENT {
                        self.push(len, TokenKind::Comment, Modifiers::default());
                    }
                    self.at += len;
                }
            }
        }
    }

    fn block(&mut self, node: &GreenNodeData, bound: Option<BlockAt<'_>>) {
        let kind = SyntaxKind::from_raw(node.kind());
        let shape = match bound.and_then(|bound| bound.instruction()) {
            _ if kind == SyntaxKind::COIL_BLOCK => Modifiers::COIL,
            Some(row) if row.power.is_contact() => Modifiers::CONTACT,
            _ => Modifiers::default(),
        };
        for child in node.children() {
            match child {
                NodeOrToken::Node(child)
                    if SyntaxKind::from_raw(child.kind()) == SyntaxKind::OPERAND_LIST =>
                {
                    self.list(child, bound);
                }
                NodeOrToken::Node(child) => self.node(
                    child,
                    Inside {
                        flow: kind == SyntaxKind::FUNCTION_BLOCK,
                        shape,
                        ..Inside::default()
                    },
                ),
                NodeOrToken::Token(token) => self.at += token.text_len(),
            }
        }
    }

    fn list(&mut self, list: &GreenNodeData, bound: Option<BlockAt<'_>>) {
        let mut operand = 0;
        for child in list.children() {
            match child {
                NodeOrToken::Node(node) => {
                    // The facts of a block have an operand for each of these nodes.
                    let formal = bound.and_then(|bound| bound.formals.get(operand).copied());
                    operand += 1;
                    let inside = self.operand(bound, formal);
                    self.node(node, inside);
                }
                NodeOrToken::Token(token) => {
                    self.token(
                        SyntaxKind::from_raw(token.kind()),
                        token.text(),
                        Inside::default(),
                    );
                }
            }
        }
    }

    /// What names in an operand mean, and whether it is written.
    fn operand(&self, bound: Option<BlockAt<'_>>, formal: Option<Formal>) -> Inside {
        let mut inside = Inside::default();
        match (bound, formal) {
            (_, Some(Formal::Operand(operand))) => {
                inside.names = match operand.accepts {
                    Accepts::Label => Names::Labels,
                    Accepts::Function => Names::Functions,
                    Accepts::SearchOperator => Names::Operators,
                    _ => Names::Tags,
                };
                inside.written = operand.direction != Direction::In;
                let op = bound.and_then(|bound| bound.op());
                // What `<LBL>` and `<FUN>` name is introduced there; no other name is written.
                if inside.names != Names::Tags {
                    inside.written = matches!(op, Some(Op::Lbl | Op::Fun));
                }
            }
            (Some(bound), Some(Formal::Parameter(parameter))) => {
                if let Meaning::User(block) = bound.meaning {
                    let parameter = &self.context.user_blocks[block].parameters[parameter];
                    inside.written = parameter.kind != ParameterKind::Input;
                }
            }
            _ => {}
        }
        inside
    }

    fn node(&mut self, node: &GreenNodeData, mut inside: Inside) {
        let kind = SyntaxKind::from_raw(node.kind());
        inside.parent = Some(kind);
        let mut first = true;
        // What is before the arrow is a name of the block's own.
        let mut named = kind == SyntaxKind::NAMED_OPERAND;
        for child in node.children() {
            match child {
                NodeOrToken::Node(child) => {
                    let mut inner = inside;
                    if named {
                        inner.names = Names::Operands;
                    }
                    match kind {
                        SyntaxKind::CALL_EXPR if first => inner.names = Names::Callee,
                        SyntaxKind::NAME_LIST => inner.names = Names::Declared,
                        // What is in an index is read; so are the arguments of a function.
                        SyntaxKind::INDEX_EXPR | SyntaxKind::CALL_EXPR if !first => {
                            inner.written = false;
                            inner.names = Names::Tags;
                        }
                        SyntaxKind::BINARY_EXPR | SyntaxKind::UNARY_EXPR => inner.written = false,
                        _ => {}
                    }
                    self.node(child, inner);
                    first = false;
                }
                NodeOrToken::Token(token) => {
                    let kind = SyntaxKind::from_raw(token.kind());
                    named &= !matches!(kind, SyntaxKind::ASSIGN | SyntaxKind::ARROW);
                    self.token(kind, token.text(), inside);
                }
            }
        }
    }

    fn push(&mut self, len: TextSize, kind: TokenKind, modifiers: Modifiers) {
        self.out.push(Token {
            range: TextRange::at(self.at, len),
            kind,
            modifiers,
        });
    }

    fn token(&mut self, kind: SyntaxKind, text: &str, inside: Inside) {
        use SyntaxKind as S;
        let none = Modifiers::default();
        let of_language = Modifiers::DEFAULT_LIBRARY;
        let parent = inside.parent;
        let found = match kind {
            S::COMMENT => Some((TokenKind::Comment, none)),
            S::MNEMONIC if inside.flow => Some((TokenKind::Keyword, none)),
            S::MNEMONIC => Some((TokenKind::Function, of_language.and(inside.shape))),
            S::BLOCK_NAME => {
                let header = self.context.parse.frame().blocks.get(self.scope.wrapping_sub(1));
                let here = |line| self.context.parse.line_range(line).contains(self.at);
                let declared = header.is_some_and(|header| here(header.lines.start));
                Some((
                    TokenKind::Class,
                    if declared { Modifiers::DECLARATION } else { none },
                ))
            }
            S::KEYWORD if parent == Some(S::TYPE_REF) => {
                let of = text.eq_ignore_ascii_case("OF") || text.eq_ignore_ascii_case("ARRAY");
                Some(if of {
                    (TokenKind::Keyword, none)
                } else {
                    (TokenKind::Type, of_language)
                })
            }
            S::KEYWORD => Some((TokenKind::Keyword, none)),
            S::STRING => Some((TokenKind::String, none)),
            S::ADDRESS => {
                let written = if inside.written {
                    Modifiers::MODIFICATION
                } else {
                    none
                };
                let role = match text.as_bytes().get(1).map(u8::to_ascii_uppercase) {
                    Some(b'I') => Modifiers::INPUT,
                    Some(b'Q') => Modifiers::OUTPUT,
                    _ => none,
                };
                Some((TokenKind::Variable, Modifiers::STATIC.and(written).and(role)))
            }
            S::IDENT | S::LITERAL if parent == Some(S::MEMBER_EXPR) => Some((TokenKind::Property, none)),
            S::LITERAL if text.starts_with(|c: char| c.is_ascii_alphabetic()) && !text.contains('#') => {
                Some((TokenKind::EnumMember, of_language.and(Modifiers::READONLY)))
            }
            S::LITERAL => Some((TokenKind::Number, none)),
            S::IDENT => self.name(text, inside),
            S::WORD_OPERATOR
            | S::ASSIGN
            | S::ARROW
            | S::PLUS
            | S::MINUS
            | S::STAR
            | S::SLASH
            | S::CARET
            | S::EQUAL
            | S::NOT_EQUAL
            | S::LESS
            | S::LESS_EQUAL
            | S::GREATER
            | S::GREATER_EQUAL => Some((TokenKind::Operator, none)),
            _ => None,
        };
        let len = TextSize::of(text);
        if let Some((kind, modifiers)) = found {
            self.push(len, kind, modifiers);
        }
        self.at += len;
    }

    /// What a name is that a section of types declares here: a type or a member.
    fn declared_in_a_type(&self) -> Option<TokenKind> {
        let own = self.context.types.own();
        let after = own.partition_point(|ty| ty.declaration.at.start() <= self.at);
        let ty = &own[after.checked_sub(1)?].declaration;
        if ty.at.start() == self.at {
            return Some(TokenKind::Type);
        }
        let SpecKind::Structure(members) = &ty.declared.spec.kind else {
            return None;
        };
        let member = members.binary_search_by_key(&self.at, |member| member.at.start());
        member.is_ok().then_some(TokenKind::Property)
    }

    fn name(&self, text: &str, inside: Inside) -> Option<(TokenKind, Modifiers)> {
        let none = Modifiers::default();
        match (inside.parent, inside.names) {
            (_, Names::Operands) if inside.declares => return Some((TokenKind::Property, none)),
            (_, Names::Operands) => return Some((TokenKind::Parameter, none)),
            (Some(SyntaxKind::TYPE_REF), _) => return Some((TokenKind::Type, none)),
            (Some(SyntaxKind::ENUM_VALUE), _) => {
                return Some((
                    TokenKind::EnumMember,
                    Modifiers::DECLARATION.and(Modifiers::READONLY),
                ));
            }
            (_, Names::Callee) => return Some((TokenKind::Function, Modifiers::DEFAULT_LIBRARY)),
            (_, Names::Operators) => return Some((TokenKind::EnumMember, Modifiers::DEFAULT_LIBRARY)),
            (_, names @ (Names::Labels | Names::Functions)) => {
                let kind = if names == Names::Labels {
                    TokenKind::Label
                } else {
                    TokenKind::Function
                };
                let declared = if inside.written {
                    Modifiers::DECLARATION
                } else {
                    none
                };
                return Some((kind, declared));
            }
            _ => {}
        }
        if text.eq_ignore_ascii_case("SYS") || text.eq_ignore_ascii_case("PI") {
            return Some((
                TokenKind::Variable,
                Modifiers::DEFAULT_LIBRARY.and(Modifiers::READONLY),
            ));
        }
        let mut modifiers = none;
        if inside.declares
            && let Some(kind) = self.declared_in_a_type()
        {
            return Some((kind, Modifiers::DECLARATION));
        }
        if inside.parent == Some(SyntaxKind::NAME_LIST) || inside.names == Names::Declared {
            modifiers = modifiers.and(Modifiers::DECLARATION);
        } else if inside.written {
            modifiers = modifiers.and(Modifiers::MODIFICATION);
        }
        let scope = self.context.scopes.get(self.scope)?;
        let Some(index) = scope.find(&Name::new(text)) else {
            if self.context.types.enumeration(text).is_some() {
                return Some((TokenKind::Type, none));
            }
            if self.context.types.has_value(&Name::new(text)) {
                return Some((TokenKind::EnumMember, Modifiers::READONLY));
            }
            return Some((TokenKind::Variable, modifiers));
        };
        let own = &scope.tags[index];
        let mut kind = TokenKind::Variable;
        if let Origin::Declared(section) = own.origin {
            match section {
                SectionKind::Global | SectionKind::External => modifiers = modifiers.and(Modifiers::STATIC),
                SectionKind::Input | SectionKind::Output | SectionKind::InOut if self.scope > 0 => {
                    kind = TokenKind::Parameter;
                }
                _ => {}
            }
        }
        if own.origin == Origin::Shared {
            modifiers = modifiers.and(Modifiers::STATIC);
        }
        let tag = self.context.shared(own);
        match tag.role {
            Role::Input => modifiers = modifiers.and(Modifiers::INPUT),
            Role::Output => modifiers = modifiers.and(Modifiers::OUTPUT),
            Role::Internal => {}
        }
        if tag.constant {
            modifiers = modifiers.and(Modifiers::READONLY);
        }
        Some((kind, modifiers))
    }
}

#[cfg(test)]
mod tests;
