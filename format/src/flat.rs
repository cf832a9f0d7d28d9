//! A file's tree as one list, in the order of its text.
//!
//! Every line is walked twice (measured, then written), and a list is walked faster than a tree whose nodes are
//! spread over memory. It also knows each node's place in the file, which green nodes do not.

use ladder_syntax::rowan::{GreenNodeData, NodeOrToken};
use ladder_syntax::{LineKind, Network, Parse, SyntaxKind};
use std::ops::Range;

/// A node or token. A node's entries follow it.
#[derive(Debug, Clone, Copy)]
struct Entry {
    /// Where it begins in the text. It ends where the entry behind it and its own begins.
    start: u32,
    /// How many entries it has, itself among them.
    size: u32,
    kind: SyntaxKind,
}

/// The tree of a file as a list.
pub(crate) struct Flat {
    entries: Vec<Entry>,
    /// For each line its entry, and whether a comment stands on it outside blocks.
    lines: Vec<(u32, bool)>,
}

impl Flat {
    /// Lays out the tree of a parse.
    pub(crate) fn new(parse: &Parse) -> Flat {
        Flat::lay_out(parse, |_| {})
    }

    /// Lays out the tree of a parse, and puts its text together on the way.
    pub(crate) fn with_text(parse: &Parse) -> (Flat, String) {
        let mut text = String::with_capacity(parse.text_len().into());
        let flat = Flat::lay_out(parse, |token| text.push_str(token));
        (flat, text)
    }

    fn lay_out(parse: &Parse, mut token: impl FnMut(&str)) -> Flat {
        let mut flat = Flat {
            entries: Vec::with_capacity(usize::from(parse.text_len()) / 3 + 1),
            lines: Vec::with_capacity(parse.lines().len()),
        };
        let mut at = 0;
        for line in parse.lines() {
            let first = flat.entries.len() as u32;
            let comment = push(line.green(), &mut at, &mut flat.entries, &mut token);
            flat.lines.push((first, comment));
        }
        // The end of the last entry.
        flat.entries.push(Entry {
            start: at,
            size: 1,
            kind: SyntaxKind::EOF,
        });
        flat
    }
}

/// Lays out a node. Returns whether a comment is among its children.
fn push(node: &GreenNodeData, at: &mut u32, entries: &mut Vec<Entry>, text: &mut impl FnMut(&str)) -> bool {
    let first = entries.len();
    let mut comment = false;
    entries.push(Entry {
        start: *at,
        size: 1,
        kind: SyntaxKind::from_raw(node.kind()),
    });
    for child in node.children() {
        match child {
            NodeOrToken::Node(node) => {
                push(node, at, entries, text);
            }
            NodeOrToken::Token(token) => {
                let kind = SyntaxKind::from_raw(token.kind());
                comment |= kind == SyntaxKind::COMMENT;
                entries.push(Entry {
                    start: *at,
                    size: 1,
                    kind,
                });
                text(token.text());
                *at += u32::from(token.text_len());
            }
        }
    }
    entries[first].size = (entries.len() - first) as u32;
    comment
}

/// A text, its parse, and its tree as a list.
#[derive(Clone, Copy)]
pub(crate) struct Source<'s> {
    pub(crate) text: &'s str,
    pub(crate) parse: &'s Parse,
    pub(crate) flat: &'s Flat,
}

impl<'s> Source<'s> {
    /// A line's node.
    pub(crate) fn line(&self, line: usize) -> Node<'s> {
        self.node(self.flat.lines[line].0)
    }

    /// The node or token with a number that [`Node::index`] gave.
    pub(crate) fn node(&self, index: u32) -> Node<'s> {
        Node {
            entries: &self.flat.entries,
            index,
        }
    }

    /// Whether a comment stands on a line, outside its blocks.
    pub(crate) fn has_comment(&self, line: usize) -> bool {
        self.flat.lines[line].1
    }

    pub(crate) fn kind(&self, line: usize) -> LineKind {
        self.parse.lines()[line].kind
    }

    /// The lines of a network's rungs.
    pub(crate) fn rungs(&self, network: &Network) -> impl Iterator<Item = usize> + use<'_, 's> {
        network
            .lines
            .clone()
            .filter(|&line| self.kind(line) == LineKind::Rung)
    }

    /// A line in the text, its line end included.
    pub(crate) fn range(&self, line: usize) -> Range<usize> {
        self.parse.line_range(line).into()
    }

    /// Where the line end begins that a line has behind it, if it has one.
    pub(crate) fn line_end(&self, line: usize) -> Option<usize> {
        let range = self.range(line);
        let line = &self.text.as_bytes()[range.clone()];
        let length = match line {
            [.., b'\r', b'\n'] => 2,
            [.., b'\r' | b'\n'] => 1,
            _ => return None,
        };
        Some(range.end - length)
    }
}

/// A node or token of a [`Source`].
#[derive(Clone, Copy)]
pub(crate) struct Node<'f> {
    entries: &'f [Entry],
    index: u32,
}

impl<'f> Node<'f> {
    fn entry(self) -> &'f Entry {
        &self.entries[self.index as usize]
    }

    pub(crate) fn kind(self) -> SyntaxKind {
        self.entry().kind
    }

    /// Its number, for [`Source::node`].
    pub(crate) fn index(self) -> u32 {
        self.index
    }

    /// Where it begins in the text.
    pub(crate) fn start(self) -> usize {
        self.entry().start as usize
    }

    /// Where it ends in the text.
    pub(crate) fn end(self) -> usize {
        let entry = self.entry();
        self.entries[(self.index + entry.size) as usize].start as usize
    }

    /// Its place in the text.
    pub(crate) fn range(self) -> Range<usize> {
        self.start()..self.end()
    }

    /// Whether it is a node, not a token.
    pub(crate) fn is_node(self) -> bool {
        (self.kind() as u16) >= (SyntaxKind::SOURCE_FILE as u16)
    }

    /// Its children, from left to right.
    pub(crate) fn children(self) -> Children<'f> {
        Children {
            entries: self.entries,
            next: self.index + 1,
            end: self.index + self.entry().size,
        }
    }

    /// Its first child of a kind.
    pub(crate) fn child(self, kind: SyntaxKind) -> Option<Node<'f>> {
        self.children().find(|child| child.kind() == kind)
    }
}

/// The children of a node.
#[derive(Clone)]
pub(crate) struct Children<'f> {
    entries: &'f [Entry],
    next: u32,
    end: u32,
}

impl<'f> Iterator for Children<'f> {
    type Item = Node<'f>;

    fn next(&mut self) -> Option<Node<'f>> {
        if self.next >= self.end {
            return None;
        }
        let node = Node {
            entries: self.entries,
            index: self.next,
        };
        self.next += node.entry().size;
        Some(node)
    }
}
