//! A changed network as the formatter draws it, and where its things are then.

use super::piece::Piece;
use crate::drawing::item::{Item, ItemKind};
use crate::drawing::rows::Drawing;
use ladder_format::{Edit, Options, apply, display_width, format_text};
use ladder_syntax::{SyntaxErrorKind, TextRange, TextSize, parse};

/// The new text of networks in the place of one, or of neighbours. What is new in the drawings is new in the piece; where
/// nothing is, a person goes on behind `last`, the thing of the old text that is before what is gone.
///
/// # Errors
/// Why it cannot be drawn.
pub(super) fn piece(
    scope: usize,
    drawings: &[Drawing],
    last: Option<TextRange>,
    options: &Options,
) -> Result<Piece, String> {
    let (text, places) = laid_out(drawings, scope > 0, options)?;
    let things: Vec<&Item> = drawings.iter().flat_map(things).collect();
    let with_places = || things.iter().zip(&places);
    let new = with_places().filter(|(item, _)| item.is_new());
    let new: Vec<TextRange> = new.map(|(_, place)| *place).collect();
    let behind = || {
        let found = with_places().find(|(item, _)| !item.is_new() && Some(item.at) == last)?;
        Some(found.1.end())
    };
    // Behind the left rail.
    let begin = || text.find('+').map(|at| TextSize::new(at as u32 + 1));
    let focus = new.first().map(|new| new.start()).or_else(behind).or_else(begin);
    let ranges = drawings.iter().map(Drawing::range);
    Ok(Piece {
        range: ranges.reduce(TextRange::cover).unwrap_or_default(),
        text,
        new,
        focus,
    })
}

/// The blocks of a drawing and the comments in its wires, row by row.
pub(super) fn things(drawing: &Drawing) -> impl Iterator<Item = &Item> {
    drawing.rows.iter().flat_map(|row| {
        let items = row.items.iter().enumerate();
        items.filter_map(|(index, item)| {
            let is_comment = item.kind == ItemKind::Comment && !item.is_loose(row.items.get(index + 1));
            (item.is_block() || is_comment).then_some(item)
        })
    })
}

/// The text of drawings, and where their things are in it.
fn laid_out(
    drawings: &[Drawing],
    in_body: bool,
    options: &Options,
) -> Result<(String, Vec<TextRange>), String> {
    const UNDRAWN: &str = "the network would not read as it is drawn";
    let mut shown: Vec<String> = drawings.iter().map(Drawing::text).collect();
    let mut stand_ins = Vec::new();
    if shown.iter().any(|text| is_frozen(text)) {
        let mut first = 0;
        for (text, drawing) in shown.iter_mut().zip(drawings) {
            *text = with_stand_ins(drawing, first, &mut stand_ins)?;
            first += things(drawing).count();
        }
    }
    let line_end = drawings.first().map_or("\n", Drawing::line_end);
    let text = formatted(&shown.join(&line_end.repeat(2)), in_body, options);
    let parsed = parse(&text);
    let networks = &parsed.structure().networks;
    if networks.len() != drawings.len() {
        return Err(UNDRAWN.to_owned());
    }
    let mut places: Vec<TextRange> = Vec::new();
    for network in networks {
        let read = Drawing::of_text(&parsed, network).map_err(|_| UNDRAWN.to_owned())?;
        places.extend(things(&read).map(|item| item.at));
    }
    if places.len() != drawings.iter().flat_map(things).count() {
        return Err(UNDRAWN.to_owned());
    }
    if stand_ins.is_empty() {
        return Ok((text, places));
    }
    // They are as wide as what they stand in for, but need not be as long.
    let originals = stand_ins.iter().map(|(thing, original)| Edit {
        range: places[*thing],
        text: original.clone(),
    });
    let originals: Vec<Edit> = originals.collect();
    let moved = |place: TextRange| {
        let before = originals
            .iter()
            .take_while(|edit| edit.range.end() <= place.start());
        let grown = |edit: &Edit| edit.text.len() as i64 - i64::from(u32::from(edit.range.len()));
        let shift: i64 = before.map(grown).sum();
        let own = originals.iter().find(|edit| edit.range == place);
        let start = TextSize::new((i64::from(u32::from(place.start())) + shift) as u32);
        TextRange::at(
            start,
            own.map_or(place.len(), |edit| TextSize::of(edit.text.as_str())),
        )
    };
    let places = places.iter().map(|place| moved(*place)).collect();
    Ok((apply(&text, &originals), places))
}

/// What is around networks in a body.
const HEADER: &str = "FUNCTION_BLOCK [$B]\n";
const END: &str = "\nEND_FUNCTION_BLOCK\n";

/// The canonical layout of networks of the file or of a body.
pub(super) fn formatted(text: &str, in_body: bool, options: &Options) -> String {
    if !in_body {
        return format_text(text, options);
    }
    let whole = format_text(&format!("{HEADER}{text}{END}"), options);
    let own = whole.strip_prefix(HEADER).and_then(|own| own.strip_suffix(END));
    own.unwrap_or(text).to_owned()
}

/// Whether the formatter leaves a network as it is, because a block of it cannot be read.
fn is_frozen(text: &str) -> bool {
    parse(text).errors().iter().any(|error| {
        matches!(
            error.kind,
            SyntaxErrorKind::UnexpectedCharacter { .. } | SyntaxErrorKind::UnclosedString
        )
    })
}

/// The text of a drawing with blocks of the same width in the place of those that cannot be read, and what these are.
fn with_stand_ins(
    drawing: &Drawing,
    first: usize,
    originals: &mut Vec<(usize, String)>,
) -> Result<String, String> {
    let mut shown = drawing.clone();
    let mut number = first;
    for row in &mut shown.rows {
        for index in 0..row.items.len() {
            let is_comment = row.items[index].kind == ItemKind::Comment
                && !row.items[index].is_loose(row.items.get(index + 1));
            let item = &mut row.items[index];
            if item.is_block() && is_frozen(&format!("+--{}--+", item.text)) {
                let original = std::mem::take(&mut item.text);
                item.text = stand_in(&original)
                    .ok_or_else(|| format!("`{original}` cannot be read: put that right first"))?;
                originals.push((number, original));
            }
            number += usize::from(item.is_block() || is_comment);
        }
    }
    Ok(shown.text())
}

/// A block with the same first part and the same width.
fn stand_in(block: &str) -> Option<String> {
    let closing = match block.as_bytes().first()? {
        b'[' => ']',
        b'(' => ')',
        _ => '>',
    };
    let (head, list) = block.split_at(block.find(closing)? + 1);
    let room = (display_width(list) as usize).checked_sub("(  )".len())?;
    (room > 0).then(|| format!("{head}( {} )", "x".repeat(room)))
}
