//! A network of a text as rows of things.

use super::item::{Item, ItemKind};
use super::rows::{Drawing, Row, line_text};
use ladder_analysis::context::Context;
use ladder_analysis::names::declaring::line_end;
use ladder_syntax::wiring::{PartKind, Rung, RungPart, Wiring, wiring};
use ladder_syntax::{Network, Parse, TextRange, TextSize};
use std::ops::Range;

impl Drawing {
    /// The drawing of a network. None where it holds an error, or cannot be laid out again.
    pub(crate) fn read(context: &Context, network: usize) -> Option<Drawing> {
        let facts = context.networks.at(network);
        (!facts.broken).then(|| Drawing::of_network(context, network).ok())?
    }

    /// The drawing of a network of which each connector has its partner.
    ///
    /// # Errors
    /// Why it has none.
    pub(crate) fn of_network(context: &Context, network: usize) -> Result<Drawing, Undrawn> {
        let facts = context.networks.at(network);
        Drawing::of(&context.parse, facts.first_line, &facts.wiring)
    }

    /// The drawing of a network of a text.
    pub(crate) fn of_text(parse: &Parse, network: &Network) -> Result<Drawing, Undrawn> {
        Drawing::of(parse, network.lines.start, &wiring(parse, network))
    }

    fn of(parse: &Parse, first_line: usize, wiring: &Wiring) -> Result<Drawing, Undrawn> {
        let mut rows = Vec::with_capacity(wiring.rungs.len());
        let mut block = 0;
        let mut range: Option<TextRange> = None;
        let lines = wiring.line_offsets.iter().map(|offset| first_line + offset);
        let lines: Vec<usize> = lines.collect();
        for (drawn, (rung, &line)) in wiring.rungs.iter().zip(lines.iter().enumerate()) {
            let text = line_text(parse, line);
            let start = parse.line_start(line);
            let items = items(drawn, &text, start, &mut block)?;
            let shown = text.trim_end_matches(['\r', '\n']);
            let place = TextRange::at(start, TextSize::of(shown));
            range = Some(range.map_or(place, |range| range.cover(place)));
            let next = lines.get(rung + 1).copied();
            let below = (line + 1..next.unwrap_or(line + 1)).map(|line| line_text(parse, line));
            rows.push(Row {
                items,
                at: place,
                below: below.collect(),
            });
        }
        let mut range = range.ok_or(Undrawn::Nothing)?;
        if range.start() == TextSize::new(0) && line_text(parse, 0).starts_with('\u{feff}') {
            range = TextRange::new(TextSize::of('\u{feff}'), range.end());
        }
        Ok(Drawing {
            rows,
            head: String::new(),
            line_end: line_end(parse),
            range,
        })
    }
}

/// Why a network has no drawing that can be changed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Undrawn {
    /// A `+` is in the middle of a wire.
    StrayRail,
    /// A `|` is in the middle of a wire.
    StrayBar,
    /// A character means nothing.
    Junk,
    /// A comment between two things of a rung goes on on the next line.
    CommentOfLines,
    /// There is no rung.
    Nothing,
}

impl Undrawn {
    /// The sentence for a person.
    pub(crate) fn message(self) -> &'static str {
        match self {
            Undrawn::StrayRail => "a `+` is in the middle of a wire here: put that right in the text first",
            Undrawn::StrayBar => "a `|` is in the middle of a wire here: put that right in the text first",
            Undrawn::Junk => "a character here means nothing: put that right in the text first",
            Undrawn::CommentOfLines => {
                "a comment in a wire here has several lines: write it on one line in the text first"
            }
            Undrawn::Nothing => "there is no rung here",
        }
    }
}

fn items(drawn: &Rung, text: &str, start: TextSize, block: &mut usize) -> Result<Vec<Item>, Undrawn> {
    let parts = &drawn.parts;
    let mut items: Vec<Item> = Vec::new();
    let mut last_segment = None;
    let mut at_bar = false;
    for (index, part) in parts.iter().enumerate() {
        let after_bar = std::mem::take(&mut at_bar);
        let kind = match part.kind {
            PartKind::StrayRail => return Err(Undrawn::StrayRail),
            PartKind::StrayBar => return Err(Undrawn::StrayBar),
            PartKind::Junk => return Err(Undrawn::Junk),
            PartKind::Bar => match touched(parts, index) {
                Touched::Nothing => continue,
                Touched::Right if index == 0 => {
                    at_bar = true;
                    ItemKind::Bar
                }
                Touched::Left if is_last(parts, index) => ItemKind::Bar,
                _ => return Err(Undrawn::StrayBar),
            },
            PartKind::Wire => {
                let segment = part
                    .segment
                    .and_then(|number| drawn.segments.get(number as usize));
                let is_between = |ends: &Range<usize>| {
                    let left = ends.start < index || after_bar;
                    let right = index + 1 < ends.end
                        || (is_last(parts, index + 1)
                            && parts
                                .get(index + 1)
                                .is_some_and(|next| next.kind == PartKind::Bar && next.touches));
                    left && right
                };
                if segment.is_some_and(|segment| is_between(&segment.parts)) {
                    at_bar = after_bar;
                    last_segment = part.segment;
                    continue;
                }
                ItemKind::Stub
            }
            PartKind::LeftRail => ItemKind::LeftRail,
            PartKind::RightRail => ItemKind::RightRail,
            PartKind::Down => ItemKind::Down,
            PartKind::Up => ItemKind::Up,
            PartKind::Comment => ItemKind::Comment,
            PartKind::Block => {
                *block += 1;
                ItemKind::Block(Some(*block - 1))
            }
        };
        let mut shown = &text[part.range];
        // Between two things on its rung a comment with a line end keeps the formatter off the network.
        if kind == ItemKind::Comment && shown.contains(['\n', '\r']) {
            return Err(Undrawn::CommentOfLines);
        }
        if kind == ItemKind::Stub {
            shown = "--";
        }
        let joined = match kind {
            ItemKind::Bar => !at_bar,
            _ => after_bar || (part.segment.is_some() && part.segment == last_segment),
        };
        last_segment = part.segment;
        items.push(Item {
            kind,
            text: shown.to_owned(),
            joined,
            at: part.range + start,
        });
    }
    Ok(items)
}

/// On which side wire reaches to a `|`.
enum Touched {
    Nothing,
    Left,
    Right,
    Both,
}

fn touched(parts: &[RungPart], index: usize) -> Touched {
    let wire = |part: &RungPart| part.segment.is_some();
    let before = parts[index].touches && index > 0 && wire(&parts[index - 1]);
    let after = parts
        .get(index + 1)
        .is_some_and(|part| part.touches && wire(part));
    match (before, after) {
        (false, false) => Touched::Nothing,
        (true, false) => Touched::Left,
        (false, true) => Touched::Right,
        (true, true) => Touched::Both,
    }
}

/// Whether nothing but comments is behind a part.
fn is_last(parts: &[RungPart], index: usize) -> bool {
    let behind = parts.get(index + 1..).unwrap_or_default();
    behind
        .iter()
        .all(|part| part.kind == PartKind::Comment && part.segment.is_none())
}
