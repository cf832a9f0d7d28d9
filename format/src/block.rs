//! A block on a rung: what it says about itself, and its canonical form.

use crate::flat::Node;
use crate::pieces::{Piece, Pieces};
use crate::plain;
use crate::read::Stays;
use crate::sketch::ElementKind;
use crate::width::display_width;
use ladder_instructions::{Role, Shape, lookup};
use ladder_syntax::SyntaxKind::{self, *};

/// A block of a text.
#[derive(Clone, Copy)]
pub(crate) struct Block<'s> {
    text: &'s str,
    node: Node<'s>,
    /// The word in its first part: a mnemonic or the name of a user-defined block.
    head: Option<(SyntaxKind, &'s str)>,
}

/// A stretch of the canonical forms that were put after each other; empty for a block that is in its own.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Form {
    pub(crate) start: u32,
    pub(crate) end: u32,
}

impl<'s> Block<'s> {
    pub(crate) fn new(text: &'s str, node: Node<'s>) -> Block<'s> {
        let head = if node.is_plain_block() {
            plain::head(text, node.range()).map(|word| (MNEMONIC, word))
        } else {
            node.child(BLOCK_HEAD).and_then(|head| {
                head.children()
                    .find(|token| matches!(token.kind(), MNEMONIC | BLOCK_NAME))
                    .map(|token| (token.kind(), &text[token.range()]))
            })
        };
        Block { text, node, head }
    }

    /// Whether it has an operand list, be it empty.
    pub(crate) fn has_list(self) -> bool {
        if self.node.is_plain_block() {
            // A list ends with a parenthesis, and so does a coil's first part.
            let bytes = &self.text.as_bytes()[self.node.range()];
            bytes.ends_with(b")") && (bytes[0] != b'(' || bytes[1..].contains(&b'('))
        } else {
            self.node.child(OPERAND_LIST).is_some()
        }
    }

    /// Condition or acting (LANGUAGE §8 rule 5). What the table does not know acts, as do user-defined blocks.
    pub(crate) fn element_kind(self) -> ElementKind {
        let word = match (self.node.kind(), self.head) {
            (LOGICAL_BLOCK, None) => return ElementKind::Condition,
            (_, None) => return ElementKind::Acting,
            (_, Some((MNEMONIC, word))) => word,
            (_, Some(_)) => return ElementKind::Acting,
        };
        let mut rows = lookup(self.shape(), word);
        let row = if rows.len() > 1 {
            // `[NOT]` is a condition without operands, and acts with them.
            let operands = self.positional_operands();
            rows.find(|row| row.takes(operands))
        } else {
            rows.next()
        };
        match row.map_or(Role::Acting, |row| row.role) {
            Role::Condition => ElementKind::Condition,
            Role::Acting => ElementKind::Acting,
        }
    }

    /// Whether it has taken the first part of the block that touches it for its operands, as in `[OSR]( )( y )`.
    /// The wire that is missing there does not belong between the two, so they stay together for the fix.
    pub(crate) fn takes_head_of(self, next: Block<'_>) -> bool {
        let Some((MNEMONIC, word)) = self.head else {
            return false;
        };
        self.has_list()
            && next.node.kind() == COIL_BLOCK
            && next.head.is_some()
            && lookup(self.shape(), word).any(|row| row.limit() == Some(0))
    }

    /// Hands out its pieces. `in_body`: it is in the body of a user-defined block.
    pub(crate) fn pieces(self, in_body: bool, give: impl FnMut(Piece)) {
        if self.node.is_plain_block() {
            plain::pieces(self.text, self.node.range(), give);
        } else {
            Pieces::new(self.text, in_body, give).block(self.node, self.head);
        }
    }

    /// Its width in its canonical form, and that form, put after `forms`, if it is in another.
    pub(crate) fn measure(self, in_body: bool, forms: &mut String) -> Result<(u32, Form), Stays> {
        let (text, place) = (self.text, self.node.range());
        let bytes = &text.as_bytes()[place.clone()];
        if self.node.is_plain_block() && plain::is_canonical(bytes) {
            return Ok((bytes.len() as u32, Form::default()));
        }
        let ascii = bytes.is_ascii();
        let first = forms.len();
        let mut width = 0;
        let mut canonical = true;
        let mut at = place.start;
        let mut several_lines = false;
        self.pieces(in_body, |piece| {
            let word = &text[piece.start..piece.end];
            width += piece.blanks
                + if ascii {
                    word.len() as u32
                } else {
                    display_width(word)
                };
            several_lines |= piece.kind == COMMENT && word.contains(['\n', '\r']);
            let capitals = piece.capitals && word.bytes().any(|b| b.is_ascii_lowercase());
            if canonical
                && (at + piece.blanks as usize != piece.start
                    || piece.blanks > 0 && text.as_bytes()[at] != b' '
                    || capitals)
            {
                canonical = false;
                forms.push_str(&text[place.start..at]);
            }
            at = piece.end;
            if !canonical {
                if piece.blanks > 0 {
                    forms.push(' ');
                }
                let start = forms.len();
                forms.push_str(word);
                if capitals {
                    forms[start..].make_ascii_uppercase();
                }
            }
        });
        if several_lines {
            return Err(Stays);
        }
        let form = Form {
            start: first as u32,
            end: forms.len() as u32,
        };
        Ok((width, form))
    }

    fn shape(self) -> Shape {
        match self.node.kind() {
            LOGICAL_BLOCK => Shape::Logical,
            COIL_BLOCK => Shape::Coil,
            _ => Shape::Function,
        }
    }

    fn positional_operands(self) -> usize {
        if self.node.is_plain_block() {
            return plain::operands(self.text, self.node.range()).unwrap_or(0);
        }
        self.node.child(OPERAND_LIST).map_or(0, |list| {
            list.children()
                .filter(|child| child.is_node() && child.kind() != NAMED_OPERAND)
                .count()
        })
    }
}
