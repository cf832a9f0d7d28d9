//! What takes the place of a stretch of the text, and what an editor is told of it.

use super::declaring::Declared;
use ladder_format::{Edit, difference};
use ladder_syntax::{Parse, TextRange, TextSize};

/// A stretch of the text, and what takes its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Piece {
    pub(super) range: TextRange,
    pub(super) text: String,
    /// What of it is new or moved, counted from its start.
    pub(super) new: Vec<TextRange>,
    /// Where a person goes on, likewise.
    pub(super) focus: Option<TextSize>,
}

impl Piece {
    /// One in which nothing is to be selected.
    pub(super) fn plain(range: TextRange, text: impl Into<String>) -> Piece {
        Piece {
            range,
            text: text.into(),
            new: Vec::new(),
            focus: None,
        }
    }

    /// A stretch that goes; a person goes on where it was.
    pub(super) fn gone(range: TextRange) -> Piece {
        Piece {
            focus: Some(TextSize::new(0)),
            ..Piece::plain(range, "")
        }
    }
}

/// What comes of a change.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Redrawn {
    /// The edits, sorted, none touching another.
    pub edits: Vec<Edit>,
    /// What is new or moved, in the new text.
    pub select: Vec<TextRange>,
    /// Where a person goes on, in the new text.
    pub focus: Option<TextSize>,
    /// What was done, in a sentence.
    pub said: String,
    /// What was declared.
    pub declared: Vec<Declared>,
}

impl Redrawn {
    /// Pieces that do not overlap, as edits.
    pub(super) fn of(
        parse: &Parse,
        mut pieces: Vec<Piece>,
        said: String,
        declared: Vec<Declared>,
    ) -> Redrawn {
        // What is put in at a place comes before what replaces the text behind it.
        pieces.sort_by_key(|piece| (piece.range.start(), piece.range.end()));
        let mut edits: Vec<Edit> = Vec::new();
        let mut select = Vec::new();
        let (mut on_new, mut on_old) = (None, None);
        let mut shift = 0i64;
        for piece in pieces {
            let old = parse.text_in(piece.range);
            let start = piece.range.start();
            for edit in difference(&old, &piece.text) {
                let range = edit.range + start;
                match edits.last_mut().filter(|last| last.range.end() == range.start()) {
                    Some(last) => {
                        last.range = last.range.cover(range);
                        last.text.push_str(&edit.text);
                    }
                    None => edits.push(Edit {
                        range,
                        text: edit.text,
                    }),
                }
            }
            let new_start = TextSize::new((i64::from(u32::from(start)) + shift) as u32);
            select.extend(piece.new.iter().map(|range| *range + new_start));
            let focus = piece.focus.map(|focus| focus + new_start);
            // Where something is new a person goes on, rather than where something was.
            if piece.new.is_empty() {
                on_old = on_old.or(focus);
            } else {
                on_new = on_new.or(focus);
            }
            shift += piece.text.len() as i64 - i64::from(u32::from(piece.range.len()));
        }
        Redrawn {
            edits,
            select,
            focus: on_new.or(on_old),
            said,
            declared,
        }
    }
}
