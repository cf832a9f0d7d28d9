//! A file's tree as one list, in the order of its text.
//!
//! The grammar fills it directly: no tree is built for a text that is only formatted. Every line is walked twice
//! (measured, then written), and a list is walked faster than a tree whose nodes are spread over memory. It also
//! knows each node's place in the file.

use ladder_syntax::{Builder, LineKind, Lines, Network, SyntaxKind, read_lines};
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
    lines: Lines<FlatLine>,
}

/// What the list knows of a line.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FlatLine {
    /// Its entry.
    entry: u32,
    /// Whether a comment stands on it outside blocks.
    has_comment: bool,
}

impl Flat {
    /// Reads a text.
    pub(crate) fn new(text: &str) -> Flat {
        let mut builder = FlatBuilder::new(text.len());
        let lines = read_lines(text, &mut builder);
        Flat {
            entries: builder.entries,
            lines,
        }
    }
}

/// Lays nodes and tokens behind each other as the grammar meets them.
struct FlatBuilder {
    /// The last one is that of the line that is being read; at the end it marks where the text ends.
    entries: Vec<Entry>,
    /// The entries of the open nodes.
    open: Vec<u32>,
    /// The entry of the line that is being read.
    line: u32,
    /// Where the next token begins.
    at: u32,
    has_comment: bool,
}

impl FlatBuilder {
    /// A builder for a text of this many bytes.
    fn new(text_len: usize) -> FlatBuilder {
        let mut builder = FlatBuilder {
            entries: Vec::with_capacity(text_len / 2 + 1),
            open: Vec::with_capacity(16),
            line: 0,
            at: 0,
            has_comment: false,
        };
        builder.push(SyntaxKind::EOF);
        builder
    }

    fn push(&mut self, kind: SyntaxKind) {
        self.entries.push(Entry {
            start: self.at,
            size: 1,
            kind,
        });
    }
}

impl Builder for FlatBuilder {
    type Line = FlatLine;
    type Checkpoint = u32;

    fn token(&mut self, kind: SyntaxKind, text: &str) {
        self.has_comment |= kind == SyntaxKind::COMMENT && self.open.is_empty();
        self.push(kind);
        self.at += text.len() as u32;
    }

    fn start_node(&mut self, kind: SyntaxKind) {
        self.open.push(self.entries.len() as u32);
        self.push(kind);
    }

    fn checkpoint(&self) -> u32 {
        self.entries.len() as u32
    }

    fn start_node_at(&mut self, checkpoint: u32, kind: SyntaxKind) {
        let start = self
            .entries
            .get(checkpoint as usize)
            .map_or(self.at, |first| first.start);
        self.open.push(checkpoint);
        // An operand has few parts, so what moves is little.
        let entry = Entry { start, size: 1, kind };
        self.entries.insert(checkpoint as usize, entry);
    }

    fn finish_node(&mut self) {
        if let Some(first) = self.open.pop() {
            self.entries[first as usize].size = self.entries.len() as u32 - first;
        }
    }

    fn finish_line(&mut self, kind: SyntaxKind) -> FlatLine {
        let entry = self.line;
        let next = self.entries.len() as u32;
        self.entries[entry as usize].kind = kind;
        self.entries[entry as usize].size = next - entry;
        self.line = next;
        self.push(SyntaxKind::EOF);
        FlatLine {
            entry,
            has_comment: std::mem::take(&mut self.has_comment),
        }
    }
}

/// A text, and its tree as a list.
#[derive(Clone, Copy)]
pub(crate) struct Source<'s> {
    pub(crate) text: &'s str,
    pub(crate) lines: &'s Lines<FlatLine>,
    entries: &'s [Entry],
}

impl<'s> Source<'s> {
    pub(crate) fn new(text: &'s str, flat: &'s Flat) -> Source<'s> {
        Source {
            text,
            lines: &flat.lines,
            entries: &flat.entries,
        }
    }

    /// A line's node.
    pub(crate) fn line(&self, line: usize) -> Node<'s> {
        self.node(self.lines.lines()[line].node().entry)
    }

    /// The node or token with a number that [`Node::index`] gave.
    pub(crate) fn node(&self, index: u32) -> Node<'s> {
        Node {
            entries: self.entries,
            index,
        }
    }

    /// Whether a comment stands on a line, outside its blocks.
    pub(crate) fn has_comment(&self, line: usize) -> bool {
        self.lines.lines()[line].node().has_comment
    }

    pub(crate) fn kind(&self, line: usize) -> LineKind {
        self.lines.lines()[line].kind
    }

    /// Whether the parser found a mistake on a line.
    pub(crate) fn has_mistake(&self, line: usize) -> bool {
        !self.lines.lines()[line].errors.is_empty()
    }

    /// The lines of a network's rungs.
    pub(crate) fn rungs(&self, network: &Network) -> impl Iterator<Item = usize> + use<'s> {
        network.rungs(self.lines.lines())
    }

    /// A line in the text, its line end included.
    pub(crate) fn range(&self, line: usize) -> Range<usize> {
        self.lines.line_range(line).into()
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
