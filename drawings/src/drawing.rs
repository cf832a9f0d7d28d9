//! A text with drawings in it, part by part, as a program.

use crate::network::Piece;
use crate::operand::Operands;
use crate::part::{self, Drawn, Form, Part};
use crate::sheet::{Sheet, arms};
use crate::text::{COMMENTS, Phrase};
use ladder_format::program::{self, Item, ProgramSketch, RungPiece};
use ladder_syntax::{LineColumn, NodeOrToken, SyntaxKind, SyntaxNode};
use std::collections::BTreeMap;

/// What was read.
#[derive(Debug, Default)]
pub struct Read {
    /// The networks, with what is written next to them.
    pub program: ProgramSketch,
    /// The origins in the program are indices into this.
    pub places: Vec<LineColumn>,
    /// What was read as it is meant, from top to bottom.
    pub shown: Vec<Shown>,
    /// What could not be read, from top to bottom: it stays as comments.
    pub problems: Vec<Problem>,
    /// The names that ladder text cannot hold, each with its spelling there.
    pub renamed: Vec<(String, String)>,
    /// The names of timers and counters that have none in the drawing.
    pub made: Vec<String>,
}

/// An element of a drawing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Shown {
    /// Where it is.
    pub place: LineColumn,
    /// As it is drawn, with its name.
    pub text: String,
}

/// Something in a drawing that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// Where it is.
    pub place: LineColumn,
    /// As it is drawn.
    pub text: String,
    /// Why not, and what to do.
    pub why: String,
}

impl Read {
    /// Whether everything was read.
    pub fn is_complete(&self) -> bool {
        self.problems.is_empty()
    }
}

/// A drawing is no higher: what takes time grows with the lines of one part.
const HIGHEST: usize = 2_000;

/// Reads a text. What is not a drawing becomes comments.
pub fn read(text: &str) -> Read {
    let mut reader = Reader::default();
    let lines: Vec<&str> = text.trim_start_matches('\u{feff}').lines().collect();
    let mut first = 0;
    for lines in lines.chunk_by(|one, next| is_blank(one) == is_blank(next)) {
        for part in lines.chunks(HIGHEST) {
            if !is_blank(part[0]) {
                reader.part(first, part);
            }
            first += part.len();
        }
    }
    reader.read.renamed = reader.operands.changed();
    reader.read.made = reader.operands.made();
    reader.read.problems.sort_by_key(|problem| problem.place);
    reader.read
}

/// What lines look like.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Look {
    /// Nothing is on a wire.
    Text,
    /// Ladder text, perhaps with an error.
    Ladder,
    /// A ladder diagram as other programs and people draw it.
    Drawn,
}

/// What lines look like, of which none is blank.
pub fn look(lines: &[&str]) -> Look {
    let text = without_comments(lines);
    let lines: Vec<&str> = text.lines().collect();
    let sheet = Sheet::of(lines.iter().copied());
    let part = part::read(&sheet, &mut Operands::default());
    let count = |form: Form| part.symbols.iter().filter(|symbol| symbol.form == form).count();
    let (own, bare) = (count(Form::Own), count(Form::Bare));
    let (inside, drawn) = (count(Form::Inside), count(Form::Drawn));
    let is_box = |c: char| !c.is_ascii() && arms(c).is_some();
    let has_boxes = lines.iter().any(|line| line.contains(is_box));
    // No other drawing has connectors of this kind in its wires.
    let has_connectors = lines
        .iter()
        .any(|line| line.contains("-\\") || line.contains("\\-"));
    // Ladder text begins a rung with `+`.
    let begins_otherwise = || {
        lines
            .iter()
            .all(|line| !line.trim_start_matches([' ', '\t', '|']).starts_with('+'))
    };
    let is_drawn = (has_boxes && !part.symbols.is_empty())
        || (drawn > 0 && drawn + inside + bare > own && !has_connectors)
        || (inside.max(bare) > 1 && own == 0 && begins_otherwise());
    match is_drawn {
        true => Look::Drawn,
        false if part.networks.is_empty() => Look::Text,
        false => Look::Ladder,
    }
}

/// Lines without what is a comment if they are ladder text: that is neither drawn nor a name.
fn without_comments(lines: &[&str]) -> String {
    let tree = SyntaxNode::new_root(ladder_syntax::tree(&lines.join("\n")));
    let tokens = tree.descendants_with_tokens().filter_map(NodeOrToken::into_token);
    let shown = tokens.map(|token| match token.kind() {
        SyntaxKind::COMMENT => {
            let blank = |c| if c == '\n' { c } else { ' ' };
            token.text().chars().map(blank).collect()
        }
        _ => token.text().to_owned(),
    });
    shown.collect()
}

/// The fences of code in a forum or a mail are no part of what is between them.
fn is_blank(line: &str) -> bool {
    line.trim().is_empty() || line.trim_start().starts_with("```")
}

#[derive(Default)]
struct Reader {
    read: Read,
    operands: Operands,
}

impl Reader {
    fn part(&mut self, first: usize, lines: &[&str]) {
        let sheet = Sheet::of(lines.iter().copied());
        let part = part::read(&sheet, &mut self.operands);
        let place = |line: usize, column: usize| LineColumn {
            line: (first + line) as u32 + 1,
            column: sheet.character(line, column),
        };
        if !self.read.program.items.is_empty() {
            self.read.program.items.push(Item::Blank);
        }
        for text in told(&part.texts) {
            self.read.program.items.push(Item::Comment(text));
        }
        let mut top = 0;
        for (number, drawn) in part.networks.iter().enumerate() {
            if number > 0 {
                self.read.program.items.push(Item::Blank);
            }
            if drawn.problems.is_empty() {
                self.network(&part, drawn, &place);
            } else {
                self.stays(&part, drawn, lines, &place);
                let stays = lines[top..=drawn.end].iter();
                let stays = stays.map(|line| Item::Comment(without_hashes(line).to_owned()));
                self.read.program.items.extend(stays);
            }
            top = drawn.end + 1;
        }
    }

    /// Notes why a network stays as it is.
    fn stays(
        &mut self,
        part: &Part,
        drawn: &Drawn,
        lines: &[&str],
        place: &dyn Fn(usize, usize) -> LineColumn,
    ) {
        for ((line, column), why) in &drawn.problems {
            self.read.problems.push(Problem {
                place: place(*line, *column),
                text: lines[*line].trim().to_owned(),
                why: why.clone(),
            });
        }
        for symbol in drawn.network.symbols().map(|symbol| &part.symbols[symbol]) {
            if let Err(why) = &symbol.written {
                self.read.problems.push(Problem {
                    place: place(symbol.line, symbol.column),
                    text: symbol.shown.clone(),
                    why: why.clone(),
                });
            }
        }
    }

    fn network(&mut self, part: &Part, drawn: &Drawn, place: &dyn Fn(usize, usize) -> LineColumn) {
        let mut rungs = Vec::new();
        for rung in &drawn.network.rungs {
            let pieces = rung.iter().map(|piece| match *piece {
                Piece::Rail => RungPiece::Rail,
                Piece::Down => RungPiece::Down,
                Piece::Up => RungPiece::Up,
                Piece::Gap => RungPiece::Gap,
                Piece::Symbol(symbol) => {
                    let symbol = &part.symbols[symbol];
                    let place = place(symbol.line, symbol.column);
                    self.read.places.push(place);
                    let origin = Some(self.read.places.len() as u32 - 1);
                    let text = symbol.shown.clone();
                    RungPiece::Element(match &symbol.written {
                        Ok(part) => {
                            self.read.shown.push(Shown { place, text });
                            program::Element {
                                part: part.clone(),
                                origin,
                            }
                        }
                        Err(why) => {
                            let why = why.clone();
                            self.read.problems.push(Problem { place, text, why });
                            program::Element::comment(&symbol.shown, origin)
                        }
                    })
                }
            });
            rungs.push(pieces.collect());
        }
        self.read.program.items.push(Item::Network(program::Network {
            comments: told(&drawn.texts),
            drawing: program::Drawing::Rungs(rungs),
        }));
    }
}

/// A comment of ladder text without its signs; any other line as it is.
fn without_hashes(line: &str) -> &str {
    let inside = line
        .trim()
        .strip_prefix('#')
        .and_then(|line| line.strip_suffix('#'));
    inside.unwrap_or(line)
}

/// What is written, line by line, without the signs of comments in other languages.
fn told(texts: &[Phrase]) -> Vec<String> {
    let without_signs = |text: &str| {
        let text = text.trim();
        let text = COMMENTS
            .iter()
            .fold(text, |text, sign| text.strip_prefix(sign).unwrap_or(text));
        let text = ["*)", "!!", "*/", "#"]
            .iter()
            .fold(text, |text, sign| text.strip_suffix(sign).unwrap_or(text));
        text.trim().to_owned()
    };
    let mut lines: BTreeMap<usize, Vec<String>> = BTreeMap::new();
    for phrase in texts {
        let text = without_signs(&phrase.text);
        lines
            .entry(phrase.line)
            .or_default()
            .extend((!text.is_empty()).then_some(text));
    }
    let lines = lines.into_values().map(|phrases| phrases.join("  "));
    lines.filter(|text| !text.is_empty()).collect()
}
