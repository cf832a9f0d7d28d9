//! The tree of a part of a file as one list, in the order of its text.
//!
//! The grammar fills it directly: no tree is built for a text that is only formatted. Every line is walked twice
//! (measured, then written), and a list is walked faster than a tree whose nodes are spread over memory. It also
//! knows each node's place in the file.

use ladder_syntax::{Builder, LineKind, LineReader, Lines, Network, SyntaxKind};
use std::ops::Range;

/// A node or token. A node's entries follow it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Entry {
    /// Where it begins in the text. It ends where the entry after it and its own begins.
    pub(crate) start: u32,
    /// How many entries it has, itself among them.
    pub(crate) size: u32,
    pub(crate) kind: SyntaxKind,
    /// The kind of the node that it is in; `EOF` directly on a line.
    pub(crate) inside: SyntaxKind,
}

impl Entry {
    /// Whether it is a node, not a token.
    pub(crate) fn is_node(&self) -> bool {
        (self.kind as u16) >= (SyntaxKind::SOURCE_FILE as u16)
    }
}

/// The tree of a part of a file as a list.
#[derive(Default)]
pub(crate) struct Flat {
    builder: FlatBuilder,
    lines: Lines<FlatLine>,
}

impl Flat {
    /// Reads the next part of a text, of at least this many bytes. The list takes the place of the one before, and its
    /// memory.
    pub(crate) fn read(&mut self, reader: &mut LineReader<'_>, least: usize) {
        self.builder.begin(reader.at());
        reader.read(least, &mut self.builder, &mut self.lines);
    }
}

/// What the list knows of a line.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FlatLine {
    /// Its entry.
    entry: u32,
    /// Whether a comment is on it outside blocks.
    has_comment: bool,
}

/// Lays nodes and tokens after each other as the grammar meets them.
struct FlatBuilder {
    /// The last one is that of the line that is being read; at the end it marks where the text ends.
    entries: Vec<Entry>,
    /// The entries of the open nodes, and the kinds of what they are in.
    open: Vec<(u32, SyntaxKind)>,
    /// The kind of the node that was opened last.
    inside: SyntaxKind,
    /// The entry of the line that is being read.
    line: u32,
    /// Where the next token begins.
    at: u32,
    has_comment: bool,
}

impl Default for FlatBuilder {
    fn default() -> Self {
        FlatBuilder {
            entries: Vec::new(),
            open: Vec::with_capacity(16),
            inside: SyntaxKind::EOF,
            line: 0,
            at: 0,
            has_comment: false,
        }
    }
}

impl FlatBuilder {
    /// Begins a new list for what is in a text from a place on.
    fn begin(&mut self, at: usize) {
        self.entries.clear();
        self.line = 0;
        self.at = at as u32;
        self.push(SyntaxKind::EOF);
    }

    fn push(&mut self, kind: SyntaxKind) {
        self.entries.push(Entry {
            start: self.at,
            size: 1,
            kind,
            inside: self.inside,
        });
    }

    /// Opens the node of an entry.
    fn open(&mut self, entry: u32, kind: SyntaxKind) {
        self.open.push((entry, self.inside));
        self.inside = kind;
    }
}

impl Builder for FlatBuilder {
    type Line = FlatLine;
    type Checkpoint = u32;

    const TAKES_PLAIN_BLOCKS: bool = true;

    fn token(&mut self, kind: SyntaxKind, _: &str, place: Range<usize>) {
        self.has_comment |= kind == SyntaxKind::COMMENT && self.open.is_empty();
        self.push(kind);
        self.at = place.end as u32;
    }

    fn plain_block(&mut self, kind: SyntaxKind, place: Range<usize>) {
        self.push(kind);
        self.at = place.end as u32;
    }

    fn start_node(&mut self, kind: SyntaxKind) {
        let entry = self.entries.len() as u32;
        self.push(kind);
        self.open(entry, kind);
    }

    fn checkpoint(&self) -> u32 {
        self.entries.len() as u32
    }

    fn start_node_at(&mut self, checkpoint: u32, kind: SyntaxKind) {
        let mut child = checkpoint as usize;
        let start = self.entries.get(child).map_or(self.at, |first| first.start);
        while let Some(entry) = self.entries.get_mut(child) {
            entry.inside = kind;
            child += entry.size as usize;
        }
        // An operand has few parts, so what moves is little.
        self.entries.insert(
            checkpoint as usize,
            Entry {
                start,
                size: 1,
                kind,
                inside: self.inside,
            },
        );
        self.open(checkpoint, kind);
    }

    fn finish_node(&mut self) {
        if let Some((first, inside)) = self.open.pop() {
            self.entries[first as usize].size = self.entries.len() as u32 - first;
            self.inside = inside;
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
            entries: &flat.builder.entries,
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

    /// Whether a comment is on a line, outside its blocks.
    pub(crate) fn has_comment(&self, line: usize) -> bool {
        self.lines.lines()[line].node().has_comment
    }

    pub(crate) fn kind(&self, line: usize) -> LineKind {
        self.lines.lines()[line].kind
    }

    /// Whether the parser found an error on a line.
    pub(crate) fn has_error(&self, line: usize) -> bool {
        !self.lines.lines()[line].errors.is_empty()
    }

    /// The lines of a network's rungs.
    pub(crate) fn rungs(&self, network: &Network) -> impl Iterator<Item = usize> + use<'s> {
        network.rungs(self.lines)
    }

    /// A line in the text, its line end included.
    pub(crate) fn range(&self, line: usize) -> Range<usize> {
        self.lines.line_range(line).into()
    }

    /// Where the line end begins that a line has after it, if it has one.
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

    /// Whether it is a block without entries for what it holds (see [`Builder::plain_block`]).
    pub(crate) fn is_plain_block(self) -> bool {
        self.entry().size == 1 && self.kind().is_block()
    }

    /// Whether it is a node, not a token.
    pub(crate) fn is_node(self) -> bool {
        self.entry().is_node()
    }

    /// Its own entry and those of all that it holds, in the order of the text, and after them the one that says where
    /// it ends.
    pub(crate) fn entries(self) -> &'f [Entry] {
        let first = self.index as usize;
        &self.entries[first..=first + self.entry().size as usize]
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
