//! Comments come, change and go.

use super::change::{Done, Work};
use super::lines::{line_at, network_at, range_of};
use super::piece::Piece;
use crate::drawing::item::{Item, ItemKind};
use ladder_analysis::names::declaring::line_end;
use ladder_syntax::{LineKind, TextRange, TextSize};

impl Work<'_> {
    pub(super) fn comment(&self, place: TextSize, text: &str) -> Done {
        let network = network_at(self.context, place)?;
        let lines = comment_lines(text)?;
        if lines.is_empty() {
            return Err("write what the comment says".to_owned());
        }
        let line_end = line_end(&self.context.parse);
        let text = lines.join(line_end);
        let piece = Piece {
            range: TextRange::empty(range_of(self.context, network.lines()).start()),
            new: vec![TextRange::up_to(TextSize::of(text.as_str()))],
            focus: Some(TextSize::new(0)),
            text: text + line_end,
        };
        Ok((vec![piece], "Comment added".to_owned(), None))
    }

    pub(super) fn edit_comment(&self, what: TextRange, text: &str) -> Done {
        let mut lines = comment_lines(text)?;
        let said = if lines.is_empty() {
            "Comment deleted"
        } else {
            "Comment changed"
        };
        let line = line_at(self.context, what.start()).ok_or("there is no comment there")?;
        let parse = &self.context.parse;
        if parse.lines()[line].kind == LineKind::Comment {
            // Several that follow one another are one for who edits them.
            let last = line_at(self.context, what.end()).map_or(line, |last| last.max(line));
            let is_between =
                |line: &usize| matches!(parse.lines()[*line].kind, LineKind::Comment | LineKind::Blank);
            if !(line..=last).all(|line| is_between(&line)) {
                return Err("there is something between these comments".to_owned());
            }
            let range = range_of(self.context, line..last + 1);
            let old = parse.text_in(range);
            let ending = &old[old.trim_end_matches(['\r', '\n']).len()..];
            let text = lines.join(line_end(parse));
            let piece = if text.is_empty() {
                Piece::gone(range)
            } else {
                Piece {
                    range,
                    new: vec![TextRange::up_to(TextSize::of(text.as_str()))],
                    focus: Some(TextSize::new(0)),
                    text: format!("{text}{ending}"),
                }
            };
            return Ok((vec![piece], said.to_owned(), None));
        }
        let (network, mut drawing) = self.drawn(what.start())?;
        if lines.len() > 1 {
            return Err("a comment in a network is on one line".to_owned());
        }
        for row in 0..drawing.rows.len() {
            let items = &mut drawing.rows[row].items;
            let is_it = |item: &Item| item.kind == ItemKind::Comment && item.at.contains_range(what);
            let Some(index) = items.iter().position(is_it) else {
                continue;
            };
            match lines.pop() {
                Some(text) => {
                    items[index].text = text;
                    items[index].at = TextRange::default();
                }
                None => {
                    drawing.take(row, index);
                }
            }
            return Ok((vec![self.piece(network, drawing)?], said.to_owned(), None));
        }
        Err("there is no comment there".to_owned())
    }
}

/// Lines of a text as comments, each one of its own.
fn comment_lines(text: &str) -> Result<Vec<String>, String> {
    if text.contains('#') {
        return Err("a comment cannot hold a `#`: write it without".to_owned());
    }
    let lines = text.lines().map(str::trim).filter(|line| !line.is_empty());
    Ok(lines.map(|line| format!("# {line} #")).collect())
}
