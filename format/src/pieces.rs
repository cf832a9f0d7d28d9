//! The words of blocks and declarations: how far apart they are and which are in capitals (LANGUAGE §8
//! rule 6). One walk over the nodes serves measuring and writing.

use crate::flat::{Entry, Node};
use ladder_instructions::{Shape, lookup};
use ladder_syntax::SyntaxKind::{self, *};

/// A token of the old text, with the blanks that belong before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Piece {
    pub(crate) kind: SyntaxKind,
    /// Where it is in the text.
    pub(crate) start: usize,
    pub(crate) end: usize,
    /// Blanks before it.
    pub(crate) blanks: u32,
    /// It is written in capitals.
    pub(crate) capitals: bool,
}

/// What a token asks of the space next to it. `Tight` and `Blank` are rules; `Free` takes what the neighbour says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Space {
    Tight,
    Blank,
    Free,
}

/// Walks nodes and hands out their pieces.
pub(crate) struct Pieces<'t, F> {
    text: &'t str,
    give: F,
    after: Space,
    /// The kind of the last piece.
    last: SyntaxKind,
    /// Where the last piece ends.
    end: usize,
    /// The walk is in a block's body, where EN and ENO are words of the language.
    in_body: bool,
    in_calc: bool,
    in_user_block: bool,
    in_search: bool,
    /// The point of a member that is after a number: without blanks the two would read as one number.
    point_after_number: bool,
}

impl<'t, F: FnMut(Piece)> Pieces<'t, F> {
    /// A walk whose first piece has no blanks before it.
    pub(crate) fn new(text: &'t str, in_body: bool, give: F) -> Self {
        Pieces {
            text,
            give,
            after: Space::Tight,
            last: EOF,
            end: 0,
            in_body,
            in_calc: false,
            in_user_block: false,
            in_search: false,
            point_after_number: false,
        }
    }

    /// Walks a block on a rung whose first part holds the word `head`.
    pub(crate) fn block(&mut self, block: Node<'_>, head: Option<(SyntaxKind, &str)>) {
        if let Some((kind, word)) = head {
            self.in_calc = word.eq_ignore_ascii_case("CALC");
            self.in_search = word.eq_ignore_ascii_case("SEARCH");
            self.in_user_block = kind == BLOCK_NAME;
        }
        self.node(block);
    }

    /// Walks a node or token. What a token asks for depends on what it is in and on little else, so the list is
    /// walked from its first entry to its last, whatever nests in it.
    pub(crate) fn node(&mut self, node: Node<'_>) {
        let entries = node.entries();
        // Blanks inside a block's first part: `[ ]` and `( )` keep theirs.
        let mut in_head = Space::Tight;
        let mut operands = 0;
        let mut n = 0;
        while n + 1 < entries.len() {
            let entry = &entries[n];
            if entry.inside == OPERAND_LIST && entry.is_node() {
                operands += 1;
            }
            let next = match entry.kind {
                WHITESPACE | NEWLINE | BOM => n + 1,
                NAME_EXPR => {
                    let next = n + entry.size as usize;
                    let role_of_its_own = self.is_keyword(entries, n, operands);
                    self.name(entry, entries[next].start, role_of_its_own);
                    next
                }
                // What could not be read stays as it is written.
                ERROR_NODE => {
                    let next = n + entry.size as usize;
                    self.piece(entry, entries[next].start, Space::Free, Space::Free, false);
                    next
                }
                BLOCK_HEAD => {
                    let mut tokens = entries[n..n + entry.size as usize].iter();
                    in_head = if tokens.any(|token| matches!(token.kind, MNEMONIC | BLOCK_NAME)) {
                        Space::Tight
                    } else {
                        Space::Blank
                    };
                    n + 1
                }
                _ if entry.is_node() => n + 1,
                _ => {
                    self.token(entries, n, in_head);
                    n + 1
                }
            };
            n = next;
        }
    }

    /// Whether a name is a word of the language by its place: a named operand, a function, the operator of a search.
    fn is_keyword(&self, entries: &[Entry], name: usize, operands: u32) -> bool {
        let inside = entries[name].inside;
        // Its first child follows a node directly.
        let is_first = name > 0 && entries[name - 1].kind == inside;
        match inside {
            CALL_EXPR => is_first && self.in_calc,
            NAMED_OPERAND => is_first && !self.in_user_block && entries[name - 1].inside != STRUCT_EXPR,
            OPERAND_LIST => self.in_search && operands == 2,
            _ => false,
        }
    }

    /// The node of a single name.
    fn name(&mut self, node: &Entry, end: u32, is_keyword: bool) {
        let capitals = is_keyword || {
            let word = &self.text[node.start as usize..end as usize];
            word.len() <= 3
                && (is_one_of(word, &["SYS", "PI"]) || (self.in_body && is_one_of(word, &["EN", "ENO"])))
        };
        self.piece(node, end, Space::Free, Space::Free, capitals);
    }

    fn token(&mut self, entries: &[Entry], n: usize, in_head: Space) {
        let token = &entries[n];
        let end = entries[n + 1].start;
        let (kind, inside) = (token.kind, token.inside);
        let (before, after) = match kind {
            L_BRACKET | L_PAREN | L_ANGLE if inside == BLOCK_HEAD => (Space::Free, in_head),
            R_BRACKET | R_PAREN | R_ANGLE if inside == BLOCK_HEAD => (in_head, Space::Free),
            COMMA | SEMICOLON => (Space::Tight, Space::Blank),
            ASSIGN | ARROW | COLON => (Space::Blank, Space::Blank),
            // A `#` directly after a letter or digit would belong to a literal.
            COMMENT => (Space::Blank, Space::Blank),
            DOT => return self.point(token, end),
            DOT_DOT => (Space::Tight, Space::Tight),
            L_PAREN if inside == OPERAND_LIST => (Space::Tight, Space::Blank),
            R_PAREN if inside == OPERAND_LIST => (Space::Blank, Space::Free),
            L_BRACKET if inside == ARRAY_EXPR => (Space::Free, Space::Tight),
            L_PAREN if matches!(inside, PAREN_EXPR | STRUCT_EXPR) => (Space::Free, Space::Tight),
            L_BRACKET | L_PAREN => (Space::Tight, Space::Tight),
            R_BRACKET | R_PAREN => (Space::Tight, Space::Free),
            // `-(a)(b)`: without the blank the text would read as a wire before a coil.
            MINUS if inside == UNARY_EXPR && negates_call_of_parenthesis(entries, n) => {
                (Space::Free, Space::Blank)
            }
            MINUS if inside != BINARY_EXPR => (Space::Free, Space::Tight),
            WORD_OPERATOR if inside == UNARY_EXPR => (Space::Free, Space::Blank),
            _ if inside == BINARY_EXPR => (Space::Blank, Space::Blank),
            _ => (Space::Free, Space::Free),
        };
        let word = || &self.text[token.start as usize..end as usize];
        let capitals = match kind {
            KEYWORD | WORD_OPERATOR => true,
            // An unknown word may be a tag in the wrong place: `[OSR]( )( y )` ends in a coil called `y`.
            MNEMONIC => is_mnemonic(word()),
            LITERAL => is_one_of(word(), &["TRUE", "FALSE"]),
            _ => false,
        };
        self.piece(token, end, before, after, capitals);
    }

    /// The point of a member. No blanks around it, unless two tokens would become one: `word.3 . 5`, `a. .b`.
    fn point(&mut self, token: &Entry, end: u32) {
        let after_number = matches!(self.last, LITERAL | ADDRESS);
        let before = if after_number || self.last == DOT {
            Space::Free
        } else {
            Space::Tight
        };
        self.piece(token, end, before, Space::Tight, false);
        self.point_after_number = after_number;
    }

    #[inline]
    fn piece(&mut self, entry: &Entry, end: u32, before: Space, after: Space, capitals: bool) {
        let (kind, start, end) = (entry.kind, entry.start as usize, end as usize);
        let blanks = if kind == DOT && before == Space::Free || self.point_after_number {
            u32::from(start > self.end)
        } else if kind == COMMENT && self.last == MINUS {
            // `--# c #` would be a wire.
            1
        } else {
            match (self.after, before) {
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
        self.point_after_number = false;
        self.after = after;
        self.last = kind;
        self.end = end;
    }
}

/// Whether the minus is the sign of what looks like a call of a parenthesis.
fn negates_call_of_parenthesis(entries: &[Entry], minus: usize) -> bool {
    // The minus is the first child of its node.
    let Some(node) = minus.checked_sub(1) else {
        return false;
    };
    let end = node + entries[node].size as usize;
    let mut child = minus + 1;
    while child < end {
        if entries[child].kind == CALL_EXPR {
            return entries[child + 1].kind == PAREN_EXPR;
        }
        child += entries[child].size as usize;
    }
    false
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
