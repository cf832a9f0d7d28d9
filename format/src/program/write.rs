//! From the sketch of a program to its text, in canonical layout.
//!
//! The parts are first written one after the other without columns, and the places of what has an origin are noted.
//! Then the whole is laid out like any other text; the notes move with the edits.

use super::{
    Declaration, Drawing, Element, Item, Network, Origin, ProgramSketch, RungPiece, Section, comment_text,
};
use crate::edit::Edit;
use crate::{Options, PieceKind, apply, format};
use ladder_syntax::{TextRange, TextSize, line_around, parse};

/// The text of a program, and where in it things are.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct WrittenProgram {
    /// In canonical layout.
    pub text: String,
    /// Where in the text each element and declaration with an origin is, from the top to the bottom.
    pub places: Vec<(TextRange, Origin)>,
}

impl WrittenProgram {
    /// What the text at an offset (in bytes) was made from: the place around it, else the nearest before it on the same
    /// line, else the next one.
    pub fn origin_at(&self, offset: TextSize) -> Option<Origin> {
        let before = || {
            let line = line_around(&self.text, offset).start();
            self.nearest(offset).filter(|(range, _)| range.start() >= line)
        };
        let after = || self.places.get(self.begun(offset));
        let place = before().or_else(after).or(self.places.last());
        self.origin_around(offset)
            .or_else(|| place.map(|(_, origin)| *origin))
    }

    /// What the text at an offset was made from, if it was made from anything.
    pub fn origin_around(&self, offset: TextSize) -> Option<Origin> {
        self.place_around(offset).map(|(_, origin)| origin)
    }

    /// The place that an offset is in.
    pub fn place_around(&self, offset: TextSize) -> Option<(TextRange, Origin)> {
        let place = self.nearest(offset).copied();
        place.filter(|(range, _)| range.contains(offset))
    }

    /// What the first place that is in a range was made from.
    pub fn first_in(&self, range: TextRange) -> Option<Origin> {
        let at = self
            .places
            .partition_point(|(place, _)| place.start() < range.start());
        let (place, origin) = self.places.get(at)?;
        range.contains_range(*place).then_some(*origin)
    }

    /// The last place that begins at an offset or before it.
    fn nearest(&self, offset: TextSize) -> Option<&(TextRange, Origin)> {
        self.places.get(self.begun(offset).checked_sub(1)?)
    }

    /// How many places begin at an offset or before it. Places lie one after the other.
    fn begun(&self, offset: TextSize) -> usize {
        self.places.partition_point(|(range, _)| range.start() <= offset)
    }
}

impl ProgramSketch {
    /// The text of the program.
    pub fn write(&self, options: &Options) -> WrittenProgram {
        let mut writer = Writer::default();
        writer.items(&self.items);
        let edits = format(&parse(&writer.out), options);
        WrittenProgram {
            text: apply(&writer.out, &edits),
            places: moved(writer.places, &edits),
        }
    }
}

/// The places after the edits. Both are sorted, and no edit lies across the border of a place: what is noted begins
/// and ends with something that layout keeps.
fn moved(places: Vec<(TextRange, Origin)>, edits: &[Edit]) -> Vec<(TextRange, Origin)> {
    let mut shift = 0i64;
    let mut next = 0;
    let mut after = |at: TextSize| {
        while let Some(edit) = edits.get(next).filter(|edit| edit.range.end() <= at) {
            shift += edit.text.len() as i64 - i64::from(u32::from(edit.range.len()));
            next += 1;
        }
        TextSize::new((i64::from(u32::from(at)) + shift) as u32)
    };
    places
        .into_iter()
        .map(|(range, origin)| {
            let start = after(range.start());
            // Not `after(range.end())`: what is inserted right after a place does not belong to it.
            let end = after(range.end() - TextSize::new(1)) + TextSize::new(1);
            (TextRange::new(start, end), origin)
        })
        .collect()
}

#[derive(Default)]
struct Writer {
    out: String,
    places: Vec<(TextRange, Origin)>,
}

impl Writer {
    fn items(&mut self, items: &[Item]) {
        for item in items {
            match item {
                Item::Comment(text) => self.comment(text),
                Item::Directive(text) => self.line(&format!("# ladder: {} #", text.replace('#', ""))),
                Item::Blank => self.line(""),
                Item::Text(text) => self.line(text.trim_end()),
                Item::Kept(text, origin) => {
                    self.noted(Some(*origin), |out| out.push_str(text));
                    self.line("");
                }
                Item::Section(section) => self.section(section),
                Item::Network(network) => self.network(network),
                Item::Block {
                    header,
                    origin,
                    items,
                } => {
                    self.out.push_str("FUNCTION_BLOCK ");
                    self.noted(*origin, |out| out.push_str(header));
                    self.line("");
                    self.items(items);
                    self.line("END_FUNCTION_BLOCK");
                }
            }
        }
    }

    fn line(&mut self, text: &str) {
        self.out.push_str(text);
        self.out.push('\n');
    }

    fn comment(&mut self, text: &str) {
        for line in comment_text(text).lines() {
            match line.trim() {
                "" => self.line(""),
                line => self.line(&format!("# {line} #")),
            }
        }
    }

    /// Writes what comes from an origin.
    fn noted(&mut self, origin: Option<Origin>, write: impl FnOnce(&mut String)) {
        let start = TextSize::of(self.out.as_str());
        write(&mut self.out);
        if let Some(origin) = origin {
            let range = TextRange::new(start, TextSize::of(self.out.as_str()));
            self.places.push((range, origin));
        }
    }

    fn section(&mut self, section: &Section) {
        if section.declarations.is_empty() {
            return;
        }
        let keyword = section.kind.keyword();
        match section.qualifier {
            None => self.line(keyword),
            Some(qualifier) => self.line(&format!("{keyword} {}", qualifier.keyword())),
        }
        for declaration in &section.declarations {
            self.declaration(declaration);
        }
        self.line(section.kind.end());
    }

    fn declaration(&mut self, declaration: &Declaration) {
        self.out.push_str("    ");
        self.noted(declaration.origin, |out| {
            out.push_str(&declaration.names.join(", "));
            if let Some(address) = &declaration.address {
                out.push_str(" AT ");
                out.push_str(address);
            }
            out.push_str(" : ");
            out.push_str(&declaration.ty);
            if let Some(initial) = &declaration.initial {
                out.push_str(" := ");
                out.push_str(initial);
            }
            out.push(';');
        });
        if let Some(comment) = &declaration.comment {
            let comment = comment_text(comment).replace('\n', " ");
            self.out.push_str(&format!("  # {} #", comment.trim()));
        }
        self.out.push('\n');
    }

    fn network(&mut self, network: &Network) {
        for comment in &network.comments {
            self.comment(comment);
        }
        match &network.drawing {
            Drawing::Circuit(circuit) => {
                for (number, rung) in circuit.rungs().into_iter().enumerate() {
                    if number == 0 {
                        self.out.push('+');
                    }
                    for piece in rung {
                        self.out.push_str(if piece.joined { "--" } else { "  " });
                        match piece.kind {
                            PieceKind::Down => self.out.push('\\'),
                            PieceKind::Up => self.out.push('/'),
                            PieceKind::Element(element) => self.element(element),
                        }
                    }
                    self.line(if number == 0 { "--+" } else { "" });
                }
            }
            Drawing::Rungs(rungs) => {
                for rung in rungs {
                    self.rung(rung);
                }
            }
        }
    }

    fn rung(&mut self, rung: &[RungPiece]) {
        let mut joined = false;
        for piece in rung {
            if joined && *piece != RungPiece::Gap {
                self.out.push_str("--");
            }
            joined = true;
            match piece {
                RungPiece::Rail => self.out.push('+'),
                RungPiece::Down => self.out.push('\\'),
                RungPiece::Up => self.out.push('/'),
                RungPiece::Element(element) => self.element(element),
                RungPiece::Gap => {
                    self.out.push_str("  ");
                    joined = false;
                }
            }
        }
        self.line("");
    }

    fn element(&mut self, element: &Element) {
        self.noted(element.origin, |out| out.push_str(&element.to_string()));
    }
}
