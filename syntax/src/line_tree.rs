//! The tree of one line: made when it is asked for, from the text that the line was read from.
//!
//! A tree takes some fifteen times the memory of its text, and most of what is asked about a program follows from what
//! was read off it once. So a line holds the text, and its tree only while a feature near the cursor reads it. Code that
//! goes over all lines makes trees with [`Trees`], one after the other, and keeps none.

use crate::ast::NodeView;
use crate::grammar::Entry;
use crate::kind::SyntaxNode;
use crate::line::ReadLine;
use crate::lines::line_at;
use crate::tree_builder::{Names, TreeBuilder};
use rowan::GreenNode;
use std::ops::Range;
use std::sync::{Arc, OnceLock};

/// What a line of a [`Parse`](crate::Parse) holds of its tree.
#[derive(Debug, Clone)]
pub struct LineTree {
    /// Some text with the line in it: lines that were read together share it.
    source: Arc<str>,
    /// Where the line begins in it.
    at: u32,
    entry: Entry,
    made: OnceLock<GreenNode>,
}

/// A line of a [`Parse`](crate::Parse).
pub type Line = ReadLine<LineTree>;

impl Line {
    /// Its text, line end included.
    pub fn text(&self) -> &str {
        self.node.text(self.len)
    }

    /// Whether it is a line of another text that an edit has left as it was: it has the same text and means the same by
    /// itself.
    pub fn is(&self, other: &Line) -> bool {
        self.node.is(&other.node)
    }

    /// The line's node as the root of a tree of its own: offsets count from the start of the line.
    pub fn syntax(&self) -> SyntaxNode {
        SyntaxNode::new_root(self.tree())
    }

    /// The line's node for reading downwards: offsets count from the start of the line. The line keeps it, as with
    /// [`Line::green`].
    pub fn view(&self) -> NodeView<'_> {
        NodeView::root(self.green())
    }

    /// The line's green node, which the line does not keep.
    pub fn tree(&self) -> GreenNode {
        self.node.tree()
    }

    /// The line's green node, which the line keeps from now on: for places near the cursor. For many lines there is
    /// [`Trees`].
    pub fn green(&self) -> &GreenNode {
        self.node.kept()
    }
}

/// About the longest text that lines share. A text lives as long as one of its lines, and takes less than 10 KiB as the lines
/// of a part do.
const SHARED: usize = 8 << 10;

/// Stands before a text that is not the beginning of a file, where alone a byte order mark may be.
pub(crate) const BEFORE: &str = "\n";

/// Assigns to lines the text that they were read from. The first one begins at `at`, in the state `entry`.
pub(crate) fn with_text(
    text: &str,
    at: usize,
    entry: Entry,
    lines: impl Iterator<Item = ReadLine<()>>,
) -> impl Iterator<Item = Line> {
    let mut lines = lines.fuse();
    let (mut at, mut entry) = (at, entry);
    let runs = std::iter::from_fn(move || {
        let (start, begin) = (at, entry);
        let mut together = Vec::new();
        while at - start < SHARED
            && let Some(line) = lines.next()
        {
            at += line.len as usize;
            entry = crate::lines::entry_after(&line);
            together.push(line);
        }
        (!together.is_empty()).then(|| sharing(text, start..at, begin, together))
    });
    runs.flatten()
}

/// Lines that share a stretch of a text.
fn sharing(
    text: &str,
    stretch: Range<usize>,
    begin: Entry,
    lines: Vec<ReadLine<()>>,
) -> impl Iterator<Item = Line> + use<'_> {
    let before = if stretch.start == 0 { "" } else { BEFORE };
    let source: Arc<str> = [before, &text[stretch.clone()]].concat().into();
    let (mut within, mut from, mut entry) = (before.len() as u32, stretch.start, begin);
    lines.into_iter().map(move |line| {
        let tree = LineTree {
            source: Arc::clone(&source),
            at: within,
            entry,
            made: OnceLock::new(),
        };
        // A line with an error may be read so because of what is after it.
        if !line.errors.is_empty() {
            let _ = tree.made.set(read(text, from, entry, &mut small_builder()));
        }
        within += line.len;
        from += line.len as usize;
        entry = crate::lines::entry_after(&line);
        line.with_node(tree)
    })
}

fn read(text: &str, at: usize, entry: Entry, builder: &mut TreeBuilder) -> GreenNode {
    line_at(text, at, entry, builder).node
}

/// For a line or two.
fn small_builder() -> TreeBuilder {
    TreeBuilder::new(128, Names::Apart)
}

impl LineTree {
    /// Whether two lines are one that an edit has left as it was.
    pub(crate) fn is(&self, other: &LineTree) -> bool {
        self.at == other.at && Arc::ptr_eq(&self.source, &other.source)
    }

    pub(crate) fn text(&self, len: u32) -> &str {
        &self.source[self.at as usize..(self.at + len) as usize]
    }

    /// The tree, kept from now on.
    pub(crate) fn kept(&self) -> &GreenNode {
        self.made.get_or_init(|| self.make(&mut small_builder()))
    }

    /// The tree, which is not kept.
    pub(crate) fn tree(&self) -> GreenNode {
        match self.made.get() {
            Some(made) => made.clone(),
            None => self.make(&mut small_builder()),
        }
    }

    fn make(&self, builder: &mut TreeBuilder) -> GreenNode {
        read(&self.source, self.at as usize, self.entry, builder)
    }
}

/// Makes the trees of many lines.
pub struct Trees(TreeBuilder);

impl std::fmt::Debug for Trees {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Trees")
    }
}

impl Default for Trees {
    fn default() -> Trees {
        Trees(TreeBuilder::new(1024, Names::Apart))
    }
}

impl Trees {
    /// The tree of a line. The line does not keep it.
    pub fn of(&mut self, line: &Line) -> GreenNode {
        match line.node.made.get() {
            Some(made) => made.clone(),
            None => line.node.make(&mut self.0),
        }
    }
}
