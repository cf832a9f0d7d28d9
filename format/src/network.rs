//! Writing a network over its old text: rungs, the lines between them, comments next to them (LANGUAGE §8
//! rules 2, 5 and 7).

use crate::block::Block;
use crate::columns::Spacing;
use crate::draw::{self, Cover, Rails, Surface};
use crate::edit::Sink;
use crate::flat::{Node, Source};
use crate::pen::Pen;
use crate::read::Reader;
use crate::section::{comments_after, write_piece};
use crate::width::display_width;
use ladder_syntax::SyntaxKind::COMMENT;
use ladder_syntax::{LineKind, Network};

/// A network with all that is needed to write it.
pub(crate) struct Drawing<'f> {
    pub(crate) source: Source<'f>,
    pub(crate) network: &'f Network,
    pub(crate) reader: &'f Reader,
    pub(crate) columns: &'f [u32],
    /// The first rung of the network in the sketch.
    pub(crate) first_rung: usize,
    pub(crate) rails: Rails,
    pub(crate) spacing: Spacing,
}

impl Drawing<'_> {
    pub(crate) fn write<S: Sink>(&self, pen: &mut Pen<'_, S>) {
        let mut rung = self.first_rung;
        // The first of the blank and rail lines in a row that wait to be drawn as one.
        let mut empty = None;
        for line in self.network.lines.clone() {
            if self.source.kind(line) == LineKind::Rung {
                self.rail_line(empty.take(), rung, pen);
                self.rung_line(line, rung, pen);
                rung += 1;
            } else if self.source.has_comment(line) {
                self.rail_line(empty.take(), rung, pen);
                let comments = self
                    .source
                    .line(line)
                    .children()
                    .filter(|child| child.kind() == COMMENT);
                self.comment_line(comments, rung, pen);
                self.keep_line_end(line, pen);
            } else if empty.is_none() {
                empty = Some(line);
            }
        }
    }

    fn keep_line_end<S: Sink>(&self, line: usize, pen: &mut Pen<'_, S>) {
        if let Some(line_end) = self.source.line_end(line) {
            pen.keep(line_end, self.source.range(line).end);
        }
    }

    /// Draws the rails and verticals above a rung on the line `line`, if there is one.
    fn rail_line<S: Sink>(&self, line: Option<usize>, rung: usize, pen: &mut Pen<'_, S>) {
        let Some(line) = line else { return };
        let verticals = draw::verticals(&self.reader.sketch, rung - 1, self.columns);
        let mut surface = OldText { drawing: self, pen };
        draw::between(self.rails, verticals, None, &mut surface, |_| {});
        self.keep_line_end(line, pen);
    }

    /// Draws comments between two rungs, above `rung`.
    fn comment_line<'c, S: Sink>(
        &self,
        comments: impl Iterator<Item = Node<'c>> + Clone,
        rung: usize,
        pen: &mut Pen<'_, S>,
    ) {
        let start = 1 + self.spacing;
        let mut cover = Cover::Until(start);
        for (n, comment) in comments.clone().enumerate() {
            let comment = &self.source.text[comment.range()];
            cover = match cover {
                Cover::Until(end) if !comment.contains(['\n', '\r']) => {
                    Cover::Until(end + if n > 0 { 2 } else { 0 } + display_width(comment))
                }
                _ => Cover::Everything,
            };
        }
        let verticals = draw::verticals(&self.reader.sketch, rung - 1, self.columns);
        let mut surface = OldText { drawing: self, pen };
        draw::between(
            self.rails,
            verticals,
            Some((start, cover)),
            &mut surface,
            |surface| {
                for (n, comment) in comments.enumerate() {
                    surface.pen.blanks(if n > 0 { 2 } else { 0 });
                    surface.pen.keep(comment.start(), comment.end());
                }
            },
        );
    }

    fn rung_line<S: Sink>(&self, line: usize, rung: usize, pen: &mut Pen<'_, S>) {
        let elements = self.reader.sketch.rungs[rung].clone();
        let atoms = &self.reader.atoms[elements.start as usize..elements.end as usize];
        let (Some(first), Some(last)) = (atoms.first(), atoms.last()) else {
            return;
        };
        if self.source.has_comment(line) {
            self.leading_comments(line, rung, self.source.node(first.node).start(), pen);
        }
        let mut surface = OldText { drawing: self, pen };
        draw::rung(&self.reader.sketch, rung, self.columns, self.rails, &mut surface);
        comments_after(self.source, line, self.source.node(last.node).end(), pen);
        self.keep_line_end(line, pen);
    }

    /// The comments before a rung's first element, each on a line of its own.
    fn leading_comments<S: Sink>(
        &self,
        line: usize,
        rung: usize,
        first_element: usize,
        pen: &mut Pen<'_, S>,
    ) {
        let is_leading = |child: &Node<'_>| child.kind() == COMMENT && child.start() < first_element;
        for comment in self.source.line(line).children().filter(is_leading) {
            if rung == self.first_rung {
                pen.keep(comment.start(), comment.end());
            } else {
                self.comment_line(std::iter::once(comment), rung, pen);
            }
            pen.split_line(comment.end());
        }
    }
}

/// The old text as a surface: what is an element there is kept.
struct OldText<'p, 'f, 't, S> {
    drawing: &'p Drawing<'f>,
    pen: &'p mut Pen<'t, S>,
}

impl<S: Sink> Surface for OldText<'_, '_, '_, S> {
    fn blanks(&mut self, count: u32) {
        self.pen.blanks(count);
    }

    fn dashes(&mut self, count: u32) {
        self.pen.dashes(count);
    }

    fn bar(&mut self) {
        self.pen.bar();
    }

    fn element(&mut self, index: usize) {
        let atom = &self.drawing.reader.atoms[index];
        let node = self.drawing.source.node(atom.node);
        if atom.is_kept() {
            self.pen.keep(node.start(), node.end());
            return;
        }
        if !S::SMALL {
            let form = self.drawing.reader.form(atom);
            self.pen.replace(node.start(), node.end(), form);
            return;
        }
        let in_body = self.drawing.network.block.is_some();
        Block::new(self.drawing.source.text, node).pieces(in_body, |piece| write_piece(self.pen, piece));
    }
}
