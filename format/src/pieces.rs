//! The words of blocks and declarations: how far apart they stand and which are in capitals (LANGUAGE §8
//! rule 6). One walk over the green nodes serves measuring and writing.

use ladder_instructions::{Shape, lookup};
use ladder_syntax::SyntaxKind::{self, *};
use ladder_syntax::rowan::{GreenNodeData, NodeOrToken};

/// A token of the old text, with the blanks that belong before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Piece {
    /// Where it stands in the text.
    pub(crate) start: usize,
    pub(crate) end: usize,
    /// Blanks before it.
    pub(crate) blanks: u32,
    /// It is written in capitals.
    pub(crate) capitals: bool,
}

/// What a token asks of the space beside it. `Tight` and `Blank` are rules; `Free` takes what the neighbour says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Space {
    Tight,
    Blank,
    Free,
}

/// What a name is, where that decides its letters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum NameRole {
    Tag,
    /// A word of the language: a named operand, a function, the operator of a search.
    Keyword,
}

/// Walks nodes and hands out their pieces.
pub(crate) struct Pieces<'t, F> {
    text: &'t str,
    give: F,
    behind: Space,
    /// The kind of the last piece.
    last: SyntaxKind,
    /// Where the last piece ends.
    end: usize,
    /// The walk is in a block's body, where EN and ENO are words of the language.
    in_body: bool,
    in_calc: bool,
    in_user_block: bool,
    /// The point of a member that stands behind a number: without blanks the two would read as one number.
    point_behind_number: bool,
}

impl<'t, F: FnMut(Piece)> Pieces<'t, F> {
    /// A walk whose first piece stands behind `at`, without blanks.
    pub(crate) fn new(text: &'t str, at: usize, in_body: bool, give: F) -> Self {
        Pieces {
            text,
            give,
            behind: Space::Tight,
            last: EOF,
            end: at,
            in_body,
            in_calc: false,
            in_user_block: false,
            point_behind_number: false,
        }
    }

    /// Walks a block on a rung.
    pub(crate) fn block(&mut self, node: &GreenNodeData, start: usize) {
        let head = head_word(node);
        self.in_calc = head.is_some_and(|(_, word)| word.eq_ignore_ascii_case("CALC"));
        self.in_user_block = head.is_some_and(|(kind, _)| kind == BLOCK_NAME);
        let search = head.is_some_and(|(_, word)| word.eq_ignore_ascii_case("SEARCH"));
        let mut at = start;
        for child in node.children() {
            match child {
                NodeOrToken::Node(part) if kind_of(part) == OPERAND_LIST => {
                    self.operand_list(part, at, search);
                }
                NodeOrToken::Node(part) => self.node(part, at),
                NodeOrToken::Token(token) => {
                    self.token(kind_of_raw(token.kind()), at, at + len(token.text_len()), node);
                }
            }
            at += len(match child {
                NodeOrToken::Node(part) => part.text_len(),
                NodeOrToken::Token(token) => token.text_len(),
            });
        }
    }

    fn operand_list(&mut self, node: &GreenNodeData, start: usize, search: bool) {
        let mut at = start;
        let mut operands = 0;
        for child in node.children() {
            match child {
                NodeOrToken::Node(operand) => {
                    operands += 1;
                    if search && operands == 2 && kind_of(operand) == NAME_EXPR {
                        self.name(operand, at, NameRole::Keyword);
                    } else {
                        self.node(operand, at);
                    }
                    at += len(operand.text_len());
                }
                NodeOrToken::Token(token) => {
                    let end = at + len(token.text_len());
                    self.token(kind_of_raw(token.kind()), at, end, node);
                    at = end;
                }
            }
        }
    }

    /// Walks any node of a line.
    pub(crate) fn node(&mut self, node: &GreenNodeData, start: usize) {
        let kind = kind_of(node);
        if kind == NAME_EXPR {
            return self.name(node, start, NameRole::Tag);
        }
        if kind == ERROR_NODE {
            // What could not be read stays as it is written.
            let end = start + len(node.text_len());
            self.piece(ERROR_NODE, start, end, Space::Free, Space::Free, false);
            return;
        }
        let mut at = start;
        for (index, child) in node.children().enumerate() {
            match child {
                NodeOrToken::Node(inner) => {
                    let keyword = index == 0
                        && ((kind == NAMED_OPERAND && !self.in_user_block)
                            || (kind == CALL_EXPR && self.in_calc));
                    if keyword && kind_of(inner) == NAME_EXPR {
                        self.name(inner, at, NameRole::Keyword);
                    } else {
                        self.node(inner, at);
                    }
                    at += len(inner.text_len());
                }
                NodeOrToken::Token(token) => {
                    let end = at + len(token.text_len());
                    self.token(kind_of_raw(token.kind()), at, end, node);
                    at = end;
                }
            }
        }
    }

    /// The node of a single name.
    fn name(&mut self, node: &GreenNodeData, start: usize, role: NameRole) {
        let end = start + len(node.text_len());
        let word = &self.text[start..end];
        let capitals = match role {
            NameRole::Keyword => true,
            NameRole::Tag => {
                is_one_of(word, &["SYS", "PI"]) || (self.in_body && is_one_of(word, &["EN", "ENO"]))
            }
        };
        self.piece(IDENT, start, end, Space::Free, Space::Free, capitals);
    }

    /// One token that is a child of `parent`.
    pub(crate) fn token(&mut self, kind: SyntaxKind, start: usize, end: usize, parent: &GreenNodeData) {
        let inside = kind_of(parent);
        let (before, behind) = match kind {
            WHITESPACE | NEWLINE | BOM => return,
            COMMA | SEMICOLON => (Space::Tight, Space::Blank),
            ASSIGN | ARROW | COLON => (Space::Blank, Space::Blank),
            // A `#` directly behind a letter or digit would belong to a literal.
            COMMENT => (Space::Blank, Space::Blank),
            DOT => return self.point(start, end),
            DOT_DOT => (Space::Tight, Space::Tight),
            L_BRACKET | L_ANGLE if inside == BLOCK_HEAD => (Space::Free, head_space(parent)),
            L_PAREN if inside == BLOCK_HEAD => (Space::Free, head_space(parent)),
            R_BRACKET | R_ANGLE | R_PAREN if inside == BLOCK_HEAD => (head_space(parent), Space::Free),
            L_PAREN if inside == OPERAND_LIST => (Space::Tight, Space::Blank),
            R_PAREN if inside == OPERAND_LIST => (Space::Blank, Space::Free),
            L_BRACKET if inside == ARRAY_EXPR => (Space::Free, Space::Tight),
            L_PAREN if inside == PAREN_EXPR => (Space::Free, Space::Tight),
            L_BRACKET | L_PAREN => (Space::Tight, Space::Tight),
            R_BRACKET | R_PAREN => (Space::Tight, Space::Free),
            MINUS if inside == UNARY_EXPR && is_call_of_parenthesis(parent) => (Space::Free, Space::Blank),
            MINUS if inside != BINARY_EXPR => (Space::Free, Space::Tight),
            WORD_OPERATOR if inside == UNARY_EXPR => (Space::Free, Space::Blank),
            _ if inside == BINARY_EXPR => (Space::Blank, Space::Blank),
            _ => (Space::Free, Space::Free),
        };
        let capitals = match kind {
            KEYWORD | WORD_OPERATOR => true,
            // An unknown word may be a tag in the wrong place: `[OSR]( )( y )` ends in a coil called `y`.
            MNEMONIC => is_mnemonic(&self.text[start..end]),
            LITERAL => is_one_of(&self.text[start..end], &["TRUE", "FALSE"]),
            _ => false,
        };
        self.piece(kind, start, end, before, behind, capitals);
    }

    /// The point of a member. No blanks around it, unless two tokens would become one: `word.3 . 5`, `a. .b`.
    fn point(&mut self, start: usize, end: usize) {
        let behind_number = matches!(self.last, LITERAL | ADDRESS);
        let before = if behind_number || self.last == DOT {
            Space::Free
        } else {
            Space::Tight
        };
        self.piece(DOT, start, end, before, Space::Tight, false);
        self.point_behind_number = behind_number;
    }

    fn piece(
        &mut self,
        kind: SyntaxKind,
        start: usize,
        end: usize,
        before: Space,
        behind: Space,
        capitals: bool,
    ) {
        let blanks = if kind == DOT && before == Space::Free || self.point_behind_number {
            u32::from(start > self.end)
        } else if kind == COMMENT && self.last == MINUS {
            // `--# c #` would be a wire.
            1
        } else {
            match (self.behind, before) {
                (Space::Tight, _) | (_, Space::Tight) => 0,
                _ => 1,
            }
        };
        (self.give)(Piece {
            start,
            end,
            blanks,
            capitals,
        });
        self.point_behind_number = false;
        self.behind = behind;
        self.last = kind;
        self.end = end;
    }
}

/// The word in a block's first part, and whether it is a mnemonic or a user-defined block's name.
pub(crate) fn head_word(block: &GreenNodeData) -> Option<(SyntaxKind, &str)> {
    let head = block
        .children()
        .filter_map(NodeOrToken::into_node)
        .find(|node| kind_of(node) == BLOCK_HEAD)?;
    word_in(head)
}

fn word_in(head: &GreenNodeData) -> Option<(SyntaxKind, &str)> {
    head.children()
        .filter_map(NodeOrToken::into_token)
        .map(|token| (kind_of_raw(token.kind()), token.text()))
        .find(|(kind, _)| matches!(kind, MNEMONIC | BLOCK_NAME))
}

/// Whether a word is the mnemonic of an instruction, in whatever brackets. Only asked where it matters: of words
/// with small letters.
fn is_mnemonic(word: &str) -> bool {
    word.bytes().any(|b| b.is_ascii_lowercase())
        && Shape::ALL.into_iter().any(|shape| lookup(shape, word).len() > 0)
}

/// `[ ]` and `( )` keep their blank; a word fills its brackets.
fn head_space(head: &GreenNodeData) -> Space {
    if word_in(head).is_some() {
        Space::Tight
    } else {
        Space::Blank
    }
}

/// `-(a)(b)`: without the blank the text would read as a wire before a coil.
fn is_call_of_parenthesis(unary: &GreenNodeData) -> bool {
    let call = unary
        .children()
        .filter_map(NodeOrToken::into_node)
        .find(|n| kind_of(n) == CALL_EXPR);
    call.is_some_and(|call| {
        let callee = call.children().next().and_then(NodeOrToken::into_node);
        callee.is_some_and(|callee| kind_of(callee) == PAREN_EXPR)
    })
}

fn is_one_of(word: &str, words: &[&str]) -> bool {
    words.iter().any(|w| w.eq_ignore_ascii_case(word))
}

pub(crate) fn kind_of(node: &GreenNodeData) -> SyntaxKind {
    SyntaxKind::from_raw(node.kind())
}

pub(crate) fn kind_of_raw(raw: ladder_syntax::rowan::SyntaxKind) -> SyntaxKind {
    SyntaxKind::from_raw(raw)
}

pub(crate) fn len(size: ladder_syntax::TextSize) -> usize {
    size.into()
}
