//! Writing a network over its old text: rungs, the lines between them, comments beside them (LANGUAGE §8
//! rules 2, 5 and 7).

use crate::columns::Spacing;
use crate::draw::{self, Cover, Rails, Surface};
use crate::edit::Sink;
use crate::pen::Pen;
use crate::pieces::Pieces;
use crate::read::{each_child, is_kept_as_written};
use crate::section::{line_end_near, line_end_of};
use crate::sketch::Sketch;
use crate::width::display_width;
use ladder_syntax::SyntaxKind::COMMENT;
use ladder_syntax::rowan::{Children, NodeOrToken, TextSize};
use ladder_syntax::{Line, LineKind, Network, Parse, TextRange};

/// A network with all that is needed to write it.
pub(crate) struct Drawing<'f> {
    pub(crate) text: &'f str,
    pub(crate) parse: &'f Parse,
    pub(crate) network: &'f Network,
    pub(crate) sketch: &'f Sketch,
    /// For each element where its text begins, from the start of its line.
    pub(crate) places: &'f [u32],
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
        for index in self.network.lines.clone() {
            let line = &self.parse.lines()[index];
            if line.kind == LineKind::Rung {
                self.rail_line(empty.take(), rung, pen);
                self.rung_line(index, rung, pen);
                rung += 1;
            } else if has_comment(line) {
                self.rail_line(empty.take(), rung, pen);
                let comments = comments_between(self, index, 0, u32::MAX);
                self.comment_line(&comments, rung, pen);
                self.keep_line_end(index, pen);
            } else if empty.is_none() {
                empty = Some(index);
            }
        }
    }

    fn start(&self, line: usize) -> usize {
        self.parse.line_start(line).into()
    }

    fn keep_line_end<S: Sink>(&self, line: usize, pen: &mut Pen<'_, S>) {
        let end = self.start(line) + self.parse.lines()[line].len as usize;
        if let Some(line_end) = line_end_of(self.text, self.start(line), end) {
            pen.keep(line_end, end);
        }
    }

    /// Draws the rails and verticals above a rung on the line `line`, if there is one.
    fn rail_line<S: Sink>(&self, line: Option<usize>, rung: usize, pen: &mut Pen<'_, S>) {
        let Some(line) = line else { return };
        let verticals = draw::verticals(self.sketch, rung - 1, self.columns);
        let mut surface = Lines { pen };
        draw::between(self.rails, verticals, None, &mut surface, |_| {});
        self.keep_line_end(line, pen);
    }

    /// Draws comments between two rungs, above `rung`.
    fn comment_line<S: Sink>(&self, comments: &[(usize, usize)], rung: usize, pen: &mut Pen<'_, S>) {
        let start = 1 + self.spacing;
        let mut cover = Cover::Until(start);
        for (n, &(from, to)) in comments.iter().enumerate() {
            let comment = &self.text[from..to];
            cover = match cover {
                Cover::Until(end) if !comment.contains(['\n', '\r']) => {
                    Cover::Until(end + if n > 0 { 2 } else { 0 } + display_width(comment))
                }
                _ => Cover::Everything,
            };
        }
        let verticals = draw::verticals(self.sketch, rung - 1, self.columns);
        let mut surface = Lines { pen };
        draw::between(
            self.rails,
            verticals,
            Some((start, cover)),
            &mut surface,
            |surface| {
                for (n, &(from, to)) in comments.iter().enumerate() {
                    surface.pen.blanks(if n > 0 { 2 } else { 0 });
                    surface.pen.keep(from, to);
                }
            },
        );
    }

    fn rung_line<S: Sink>(&self, index: usize, rung: usize, pen: &mut Pen<'_, S>) {
        let line = &self.parse.lines()[index];
        let elements = self.sketch.rungs[rung].clone();
        let places = &self.places[elements.start as usize..elements.end as usize];
        let (Some(&first), Some(&last)) = (places.first(), places.last()) else {
            return;
        };
        if has_comment(line) {
            for comment in comments_between(self, index, 0, first) {
                if rung == self.first_rung {
                    pen.keep(comment.0, comment.1);
                } else {
                    self.comment_line(&[comment], rung, pen);
                }
                pen.line_end(line_end_near(self.text, comment.1));
            }
        }
        let mut surface = RungSurface {
            children: line.green().children(),
            at: TextSize::new(0),
            line,
            start: self.start(index),
            drawing: self,
            pen,
        };
        draw::rung(self.sketch, rung, self.columns, self.rails, &mut surface);
        if has_comment(line) {
            for (from, to) in comments_between(self, index, last + 1, u32::MAX) {
                pen.blanks(2);
                pen.keep(from, to);
            }
        }
        self.keep_line_end(index, pen);
    }
}

/// The comments of a line that begin in a range of places.
fn comments_between(drawing: &Drawing<'_>, line: usize, from: u32, to: u32) -> Vec<(usize, usize)> {
    let start = drawing.start(line);
    let mut comments = Vec::new();
    each_child(&drawing.parse.lines()[line], start, |kind, _, at, end| {
        if kind == COMMENT && (from..to).contains(&((at - start) as u32)) {
            comments.push((at, end));
        }
    });
    comments
}

/// Whether a comment stands on a line, outside its blocks.
pub(crate) fn has_comment(line: &Line) -> bool {
    line.kind == LineKind::Comment
        || line
            .green()
            .children()
            .filter_map(NodeOrToken::into_token)
            .any(|token| token.kind() == COMMENT.into())
}

/// A line between rungs; it has no elements.
struct Lines<'p, 't, S> {
    pen: &'p mut Pen<'t, S>,
}

impl<S: Sink> Surface for Lines<'_, '_, S> {
    fn blanks(&mut self, count: u32) {
        self.pen.blanks(count);
    }
    fn dashes(&mut self, count: u32) {
        self.pen.dashes(count);
    }
    fn bar(&mut self) {
        self.pen.bar();
    }
    fn element(&mut self, _: usize) {}
}

/// A rung of the old text. Its elements come in order, so one walk over its children finds them all.
struct RungSurface<'s, 'f, 't, S> {
    children: Children<'s>,
    at: TextSize,
    line: &'s Line,
    start: usize,
    drawing: &'s Drawing<'f>,
    pen: &'s mut Pen<'t, S>,
}

impl<S: Sink> Surface for RungSurface<'_, '_, '_, S> {
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
        let place = TextSize::new(self.drawing.places[index]);
        for child in self.children.by_ref() {
            let at = self.at;
            let length = match child {
                NodeOrToken::Node(node) => node.text_len(),
                NodeOrToken::Token(token) => token.text_len(),
            };
            self.at += length;
            if at < place {
                continue;
            }
            let start = self.start + usize::from(at);
            let end = start + usize::from(length);
            match child {
                NodeOrToken::Node(node) if !is_kept_as_written(self.line, TextRange::at(at, length)) => {
                    let in_body = self.drawing.network.block.is_some();
                    let pen = &mut *self.pen;
                    Pieces::new(self.drawing.text, start, in_body, |piece| {
                        pen.blanks(piece.blanks);
                        if piece.capitals {
                            pen.keep_in_capitals(piece.start, piece.end);
                        } else {
                            pen.keep(piece.start, piece.end);
                        }
                    })
                    .block(node, start);
                }
                _ => self.pen.keep(start, end),
            }
            return;
        }
    }
}
