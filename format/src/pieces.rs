//! The words of blocks and declarations: how far apart they stand and which are in capitals (LANGUAGE §8
//! rule 6). One walk over the nodes serves measuring and writing.

use crate::flat::Node;
use ladder_instructions::{Shape, lookup};
use ladder_syntax::SyntaxKind::{self, *};

/// A token of the old text, with the blanks that belong before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Piece {
    pub(crate) kind: SyntaxKind,
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
    /// A walk whose first piece has no blanks before it.
    pub(crate) fn new(text: &'t str, in_body: bool, give: F) -> Self {
        Pieces {
            text,
            give,
            behind: Space::Tight,
            last: EOF,
            end: 0,
            in_body,
            in_calc: false,
            in_user_block: false,
            point_behind_number: false,
        }
    }

    /// Walks a block on a rung whose first part holds the word `head`.
    pub(crate) fn block(&mut self, block: Node<'_>, head: Option<(SyntaxKind, &str)>) {
        self.in_calc = head.is_some_and(|(_, word)| word.eq_ignore_ascii_case("CALC"));
        self.in_user_block = head.is_some_and(|(kind, _)| kind == BLOCK_NAME);
        let search = head.is_some_and(|(_, word)| word.eq_ignore_ascii_case("SEARCH"));
        for child in block.children() {
            match child.kind() {
                OPERAND_LIST => self.operand_list(child, search),
                _ => self.node(child, block.kind()),
            }
        }
    }

    fn operand_list(&mut self, list: Node<'_>, search: bool) {
        let mut operands = 0;
        for child in list.children() {
            operands += u32::from(child.is_node());
            if search && operands == 2 && child.kind() == NAME_EXPR {
                self.name(child, NameRole::Keyword);
            } else {
                self.node(child, OPERAND_LIST);
            }
        }
    }

    /// Walks a node or token that stands in a node of kind `inside`.
    pub(crate) fn node(&mut self, node: Node<'_>, inside: SyntaxKind) {
        let kind = node.kind();
        match kind {
            NAME_EXPR => self.name(node, NameRole::Tag),
            // What could not be read stays as it is written.
            ERROR_NODE => self.piece(node, Space::Free, Space::Free, false),
            BLOCK_HEAD => {
                let has_word = node
                    .children()
                    .any(|token| matches!(token.kind(), MNEMONIC | BLOCK_NAME));
                let space = if has_word {
                    Space::Tight
                } else {
                    // `[ ]` and `( )` keep their blank.
                    Space::Blank
                };
                for child in node.children() {
                    self.in_head(child, space);
                }
            }
            UNARY_EXPR => {
                // `-(a)(b)`: without the blank the text would read as a wire before a coil.
                let call_of_parenthesis = node
                    .child(CALL_EXPR)
                    .and_then(|call| call.children().next())
                    .is_some_and(|callee| callee.kind() == PAREN_EXPR);
                for child in node.children() {
                    if child.kind() == MINUS && call_of_parenthesis {
                        self.piece(child, Space::Free, Space::Blank, false);
                    } else {
                        self.node(child, kind);
                    }
                }
            }
            NAMED_OPERAND | CALL_EXPR => {
                let keyword = if kind == CALL_EXPR {
                    self.in_calc
                } else {
                    !self.in_user_block
                };
                for (index, child) in node.children().enumerate() {
                    if index == 0 && keyword && child.kind() == NAME_EXPR {
                        self.name(child, NameRole::Keyword);
                    } else {
                        self.node(child, kind);
                    }
                }
            }
            _ if node.is_node() => {
                for child in node.children() {
                    self.node(child, kind);
                }
            }
            _ => self.token(node, inside),
        }
    }

    /// The node of a single name.
    fn name(&mut self, node: Node<'_>, role: NameRole) {
        let capitals = role == NameRole::Keyword || {
            let word = &self.text[node.range()];
            is_one_of(word, &["SYS", "PI"]) || (self.in_body && is_one_of(word, &["EN", "ENO"]))
        };
        self.piece(node, Space::Free, Space::Free, capitals);
    }

    /// A token of a block's first part.
    fn in_head(&mut self, token: Node<'_>, space: Space) {
        match token.kind() {
            L_BRACKET | L_PAREN | L_ANGLE => self.piece(token, Space::Free, space, false),
            R_BRACKET | R_PAREN | R_ANGLE => self.piece(token, space, Space::Free, false),
            _ => self.token(token, BLOCK_HEAD),
        }
    }

    /// A token in a node of kind `inside`.
    fn token(&mut self, token: Node<'_>, inside: SyntaxKind) {
        let kind = token.kind();
        let (before, behind) = match kind {
            WHITESPACE | NEWLINE | BOM => return,
            COMMA | SEMICOLON => (Space::Tight, Space::Blank),
            ASSIGN | ARROW | COLON => (Space::Blank, Space::Blank),
            // A `#` directly behind a letter or digit would belong to a literal.
            COMMENT => (Space::Blank, Space::Blank),
            DOT => return self.point(token),
            DOT_DOT => (Space::Tight, Space::Tight),
            L_PAREN if inside == OPERAND_LIST => (Space::Tight, Space::Blank),
            R_PAREN if inside == OPERAND_LIST => (Space::Blank, Space::Free),
            L_BRACKET if inside == ARRAY_EXPR => (Space::Free, Space::Tight),
            L_PAREN if inside == PAREN_EXPR => (Space::Free, Space::Tight),
            L_BRACKET | L_PAREN => (Space::Tight, Space::Tight),
            R_BRACKET | R_PAREN => (Space::Tight, Space::Free),
            MINUS if inside != BINARY_EXPR => (Space::Free, Space::Tight),
            WORD_OPERATOR if inside == UNARY_EXPR => (Space::Free, Space::Blank),
            _ if inside == BINARY_EXPR => (Space::Blank, Space::Blank),
            _ => (Space::Free, Space::Free),
        };
        let capitals = match kind {
            KEYWORD | WORD_OPERATOR => true,
            // An unknown word may be a tag in the wrong place: `[OSR]( )( y )` ends in a coil called `y`.
            MNEMONIC => is_mnemonic(&self.text[token.range()]),
            LITERAL => is_one_of(&self.text[token.range()], &["TRUE", "FALSE"]),
            _ => false,
        };
        self.piece(token, before, behind, capitals);
    }

    /// The point of a member. No blanks around it, unless two tokens would become one: `word.3 . 5`, `a. .b`.
    fn point(&mut self, token: Node<'_>) {
        let behind_number = matches!(self.last, LITERAL | ADDRESS);
        let before = if behind_number || self.last == DOT {
            Space::Free
        } else {
            Space::Tight
        };
        self.piece(token, before, Space::Tight, false);
        self.point_behind_number = behind_number;
    }

    fn piece(&mut self, node: Node<'_>, before: Space, behind: Space, capitals: bool) {
        let (kind, start, end) = (node.kind(), node.start(), node.end());
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
            kind,
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
pub(crate) fn head_word<'t>(text: &'t str, block: Node<'_>) -> Option<(SyntaxKind, &'t str)> {
    block
        .child(BLOCK_HEAD)?
        .children()
        .find(|token| matches!(token.kind(), MNEMONIC | BLOCK_NAME))
        .map(|token| (token.kind(), &text[token.range()]))
}

/// Whether a word is the mnemonic of an instruction, in whatever brackets. Only asked where it matters: of words
/// with small letters.
fn is_mnemonic(word: &str) -> bool {
    word.bytes().any(|b| b.is_ascii_lowercase())
        && Shape::ALL.into_iter().any(|shape| lookup(shape, word).len() > 0)
}

fn is_one_of(word: &str, words: &[&str]) -> bool {
    words.iter().any(|w| w.eq_ignore_ascii_case(word))
}
