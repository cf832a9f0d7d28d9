//! From the draft to a sketch.

use super::blocks::row_named;
use super::header::{self, Entry};
use super::line::{self, Block, Piece};
use ladder_analysis::Severity;
use ladder_format::program::{
    self, Declaration, Drawing, Element, Expression, Item, Network, Path, RungPiece, Section, SectionKind,
};
use ladder_instructions::{Op, by_op};
use ladder_notation::names::Names;
use ladder_notation::{Finding, LineColumn, ReadError, Reading};
use ladder_syntax::{LineIndex, TextSize};
use std::collections::{BTreeMap, HashMap, HashSet};

/// Reads a program.
pub(super) fn read(text: &str) -> Result<Reading, ReadError> {
    let (clean, comments) = without_comments(text)?;
    let file = File::of(&clean)?;
    let mut reader = Reader {
        reading: Reading::default(),
        names: Names::default(),
        uses: file.uses(),
        states: file.states(),
        types: BTreeMap::new(),
    };
    for entry in &file.entries {
        reader.names.spell(&entry.name);
    }
    let mut networks = Vec::new();
    for lines in file.networks() {
        let rungs = lines.iter().map(|(_, pieces)| reader.rung(pieces)).collect();
        networks.push((lines[0].0, Drawing::Rungs(rungs)));
    }
    reader.declare(&file.entries);
    let items = &mut reader.reading.program.items;
    let mut comments = comments.into_iter().peekable();
    // A comment before the first network is about the program.
    let first = networks.first().map_or(u32::MAX, |(line, _)| *line);
    let mut head: Vec<Item> = Vec::new();
    while let Some((_, comment)) = comments.next_if(|(line, _)| *line < first) {
        head.push(Item::Comment(comment));
    }
    head.push(Item::Blank);
    items.splice(0..0, head);
    for (line, drawing) in networks {
        let mut above = Vec::new();
        while let Some((_, comment)) = comments.next_if(|(at, _)| *at <= line) {
            above.push(comment);
        }
        items.push(Item::Blank);
        items.push(Item::Network(Network {
            comments: above,
            drawing,
        }));
    }
    items.extend(comments.map(|(_, comment)| Item::Comment(comment)));
    reader.renamed();
    Ok(reader.reading)
}

/// The text with blanks in the place of `//` and `/* */` comments, and the comments with their lines.
fn without_comments(text: &str) -> Result<(String, Vec<(u32, String)>), ReadError> {
    let mut clean = String::with_capacity(text.len());
    let mut comments = Vec::new();
    let text = text.trim_start_matches('\u{feff}');
    let lines = LineIndex::of_line_feeds(text);
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let number = || lines.line(TextSize::of(text) - TextSize::of(rest)) as u32 + 1;
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            match rest.find("*/") {
                Some(at) => at + 2,
                None => {
                    return Err(ReadError::at(
                        LineColumn::line(number()),
                        "the comment that begins here has no `*/`",
                    ));
                }
            }
        } else {
            clean.push(c);
            rest = &rest[c.len_utf8()..];
            continue;
        };
        let comment = &rest[..length];
        let inside = comment
            .trim_start_matches('/')
            .trim_matches('*')
            .trim_end_matches("*/")
            .trim();
        if !inside.is_empty() {
            comments.push((number(), inside.to_owned()));
        }
        clean.extend(comment.chars().map(|c| if c == '\n' { '\n' } else { ' ' }));
        rest = &rest[length..];
    }
    Ok((clean, comments))
}

/// What a file has: the entries of its headers, and the lines of its drawing.
struct File {
    entries: Vec<Entry>,
    lines: Vec<(u32, Vec<Piece>)>,
}

impl File {
    fn of(text: &str) -> Result<File, ReadError> {
        let mut file = File {
            entries: Vec::new(),
            lines: Vec::new(),
        };
        let mut lines = text.lines().zip(1..);
        while let Some((text, number)) = lines.next() {
            let Some((section, after)) = header::begins(text) else {
                let pieces = line::pieces(text.trim_end(), number)?;
                if pieces.iter().any(|piece| *piece != Piece::Gap) {
                    file.lines.push((number, pieces));
                }
                continue;
            };
            // A header goes on to its `}`, over as many lines as it likes.
            let mut inside = after.trim_start().strip_prefix('{').ok_or_else(|| {
                ReadError::at(
                    LineColumn::line(number),
                    "the entries of a header are between `{` and `}`",
                )
            })?;
            let mut at = number;
            loop {
                let (entries, after) = match inside.split_once('}') {
                    Some((entries, after)) => (entries, Some(after)),
                    None => (inside, None),
                };
                for entry in entries.split(',') {
                    file.entries
                        .extend(header::entry(section, entry, LineColumn::line(at))?);
                }
                match after.map(str::trim) {
                    Some("") => break,
                    Some(_) => {
                        return Err(ReadError::at(
                            LineColumn::line(at),
                            "nothing may be after the `}` of a header",
                        ));
                    }
                    None => {}
                }
                let unclosed =
                    || ReadError::at(LineColumn::line(number), "the header that begins here has no `}`");
                (inside, at) = lines.next().ok_or_else(unclosed)?;
            }
        }
        if file.lines.is_empty() {
            return Err(ReadError::whole("there is no rung in the file"));
        }
        Ok(file)
    }

    fn blocks(&self) -> impl Iterator<Item = &Block> {
        self.lines
            .iter()
            .flat_map(|(_, pieces)| pieces)
            .filter_map(|piece| match piece {
                Piece::Block(block) => Some(block),
                _ => None,
            })
    }

    /// How often each name is an operand.
    fn uses(&self) -> HashMap<String, usize> {
        let mut uses = HashMap::new();
        for operand in self.blocks().flat_map(|block| &block.operands) {
            *uses.entry(base(operand).to_owned()).or_insert(0) += 1;
        }
        uses
    }

    /// What a timer's or counter's names are read as.
    fn states(&self) -> HashMap<String, Member> {
        let mut states = HashMap::new();
        for block in self.blocks() {
            let Some((_, amount)) = state(&block.head) else {
                continue;
            };
            if let [name, _, current, ..] = &block.operands[..] {
                states.insert(name.clone(), (name.clone(), "Q"));
                states.entry(current.clone()).or_insert((name.clone(), amount));
            }
        }
        states
    }

    /// The lines that connectors join.
    fn networks(&self) -> Vec<&[(u32, Vec<Piece>)]> {
        let mut networks = Vec::new();
        let mut start = 0;
        for line in 0..self.lines.len() {
            let goes_on = self.lines[line].1.contains(&Piece::Down)
                && self
                    .lines
                    .get(line + 1)
                    .is_some_and(|(_, below)| below.contains(&Piece::Up));
            if !goes_on {
                networks.push(&self.lines[start..=line]);
                start = line + 1;
            }
        }
        networks
    }
}

/// A timer or counter, and what of it is meant.
type Member = (String, &'static str);

/// A timer or counter, and the member that its third operand shows.
fn state(head: &str) -> Option<(Op, &'static str)> {
    Some(match head {
        "TON" => (Op::Ton, "ET"),
        "TOF" => (Op::Tof, "ET"),
        "RTO" => (Op::Rto, "ET"),
        "CTU" => (Op::Ctu, "CV"),
        "CTD" => (Op::Ctd, "CV"),
        _ => return None,
    })
}

/// The name in `a[3]`.
fn base(operand: &str) -> &str {
    operand.split('[').next().unwrap_or(operand).trim()
}

fn is_name(operand: &str) -> bool {
    operand.starts_with(|c: char| c.is_alphabetic() || c == '_')
        && !["TRUE", "FALSE"]
            .iter()
            .any(|word| word.eq_ignore_ascii_case(operand))
}

struct Reader {
    reading: Reading,
    names: Names,
    uses: HashMap<String, usize>,
    states: HashMap<String, Member>,
    /// The types of names that no header declares, as their places ask for.
    types: BTreeMap<String, (&'static str, LineColumn)>,
}

impl Reader {
    fn rung(&mut self, pieces: &[Piece]) -> Vec<RungPiece> {
        let mut rung = Vec::new();
        for piece in pieces {
            match piece {
                Piece::Rail => rung.push(RungPiece::Rail),
                Piece::Down => rung.push(RungPiece::Down),
                Piece::Up => rung.push(RungPiece::Up),
                Piece::Gap => rung.push(RungPiece::Gap),
                Piece::Comment(text) => rung.push(RungPiece::Element(Element::comment(text, None))),
                Piece::Block(block) => self.block(block, &mut rung),
            }
        }
        while rung.last() == Some(&RungPiece::Gap) {
            rung.pop();
        }
        rung
    }

    fn block(&mut self, block: &Block, out: &mut Vec<RungPiece>) {
        let origin = Some(self.reading.origin(block.place));
        match self.translated(block) {
            Ok(made) => {
                let elements = made.into_iter().map(|block| Element::of(block, origin));
                out.extend(elements.map(RungPiece::Element));
            }
            Err(why) => {
                self.reading.report.refused(block.place, &block.text, &why);
                self.reading.findings.push(Finding {
                    place: block.place,
                    severity: Severity::Error,
                    check: "cplc-draft-block",
                    message: format!("`{}` stays as a comment: {why}", block.text),
                });
                out.push(RungPiece::Element(Element::comment(&block.text, origin)));
            }
        }
    }

    /// The blocks of ladder text that say what one of the draft says.
    fn translated(&mut self, block: &Block) -> Result<Vec<program::Block>, String> {
        let place = block.place;
        if let Some((op, _)) = state(&block.head).filter(|_| block.bracket == '[') {
            return Ok(vec![self.state(block, op)?]);
        }
        let row = row_named(block.bracket, &block.head);
        let (op, _, like, count) = row.ok_or("the draft has no such block")?;
        let (values, ty) = match (like, &block.operands[..]) {
            (None, [_]) => (&block.operands[..], "BOOL"),
            (Some(_), [_, values @ ..]) if values.len() == count => (values, "DINT"),
            (_, all) => {
                let wanted = match count {
                    0 => "one, its name",
                    1 => "one, the tag",
                    2 => "a name and two operands",
                    _ => "a name, two operands and the result",
                };
                return Err(format!(
                    "it has {} operands; the draft gives it {wanted}",
                    all.len()
                ));
            }
        };
        let values = values.iter().map(|value| self.operand(value, ty, place));
        let mut values = values.collect::<Result<Vec<Expression>, String>>()?;
        if count == 3 {
            values.rotate_right(1);
        }
        let mut made = vec![program::Block::of(op, values)?];
        // Other rungs may read whether it let power through.
        let name = &block.operands[0];
        if like.is_some() && self.uses.get(base(name)).is_some_and(|uses| *uses > 1) {
            made.push(program::Block::coil(self.operand(name, "BOOL", place)?));
        }
        self.reading.report.translated(place, &block.text);
        Ok(made)
    }

    fn state(&mut self, block: &Block, op: Op) -> Result<program::Block, String> {
        let [name, reset, _, preset] = &block.operands[..] else {
            return Err(format!(
                "it has {} operands; the draft gives it a name, a reset, what it has reached, and a preset",
                block.operands.len()
            ));
        };
        if !is_name(name) {
            return Err(format!("`{name}` is not a name"));
        }
        let place = block.place;
        let tag = Path::tag(self.names.spell(base(name)));
        self.types
            .insert(base(name).to_owned(), (by_op(op).mnemonic, place));
        let mut operands = vec![tag.into(), self.operand(preset, "DINT", place)?.into()];
        if is_name(reset) {
            let reset = self.operand(reset, "BOOL", place)?;
            operands.push(program::Operand::Given("R".to_owned(), reset));
        }
        let made = program::Block::of(op, operands)?;
        match op {
            Op::Rto => self.reading.report.approximated(
                place,
                &block.text,
                "in the draft power passes it at all times, here when the time has run",
            ),
            _ => self.reading.report.translated(place, &block.text),
        }
        Ok(made)
    }

    /// An operand as ladder text has it.
    fn operand(&mut self, operand: &str, ty: &'static str, place: LineColumn) -> Result<Expression, String> {
        if !is_name(operand) {
            return Ok(Expression::literal(operand.strip_prefix('+').unwrap_or(operand))?);
        }
        if let Some((name, member)) = self.states.get(operand) {
            return Ok(Path::tag(self.names.spell(name)).member(*member).into());
        }
        let name = base(operand);
        self.types.entry(name.to_owned()).or_insert((ty, place));
        let path = Path::tag(self.names.spell(name));
        let index = operand[name.len()..].trim().strip_prefix('[');
        Ok(match index.and_then(|index| index.strip_suffix(']')) {
            Some(index) => {
                let number = Expression::literal(index);
                path.index([number.unwrap_or_else(|_| Path::tag(index).into())])
            }
            None => path,
        }
        .into())
    }

    /// The sections: what the headers declare, then what only the drawing names.
    fn declare(&mut self, entries: &[Entry]) {
        let mut declared = HashSet::new();
        for kind in [SectionKind::VarInput, SectionKind::VarOutput, SectionKind::Var] {
            let mut section = Section::new(kind);
            for entry in entries.iter().filter(|entry| entry.section == kind) {
                declared.insert(entry.name.clone());
                if let Some((name, member)) = self.states.get(&entry.name) {
                    self.reading.report.approximated(
                        entry.place,
                        &entry.text,
                        format!("it is `{name}.{member}` here"),
                    );
                    continue;
                }
                self.reading.report.translated(entry.place, &entry.text);
                section.declarations.push(Declaration {
                    origin: Some(self.reading.origin(entry.place)),
                    ..Declaration::new(self.names.spell(&entry.name), entry.ty.clone())
                });
            }
            self.reading.program.items.push(Item::Section(section));
        }
        let mut section = Section::new(SectionKind::Var);
        for (name, (ty, place)) in std::mem::take(&mut self.types) {
            let is_state = state(ty).is_some();
            if declared.contains(&name) && !is_state {
                continue;
            }
            if !is_state {
                self.reading.report.approximated(
                    place,
                    &name,
                    format!("no header declares it; it is an internal {ty} here"),
                );
            }
            section.declarations.push(Declaration {
                origin: Some(self.reading.origin(place)),
                ..Declaration::new(self.names.spell(&name), ty)
            });
        }
        self.reading.program.items.push(Item::Section(section));
    }

    fn renamed(&mut self) {
        for (original, spelling) in self.names.changed() {
            self.reading.report.approximated(
                LineColumn::START,
                original,
                format!("this is not a name of its own in ladder text; it is `{spelling}` here"),
            );
        }
    }
}
