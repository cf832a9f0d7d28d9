//! From the textbook grammar to a sketch, with the checks of the paper.

use super::word::{Element, Name, Word, WordKind, words};
use ladder_analysis::Severity;
use ladder_format::Circuit;
use ladder_format::program::{
    Block, Declaration, Drawing, Element as Drawn, Item, Network, Path, Section, SectionKind,
};
use ladder_notation::{Finding, LineColumn, ReadError, Reading};
use std::collections::BTreeMap;

/// Parentheses nest no deeper.
const DEEPEST: usize = 100;

/// A program has no more elements: each branch is a line of its drawing, and moves the next one right.
const MOST_ELEMENTS: usize = 256;

/// Reads the programs of a text.
pub(super) fn read(text: &str) -> Result<Reading, ReadError> {
    let words = words(text)?;
    let mut reader = Reader {
        words: &words,
        at: 0,
        depth: 0,
        elements: 0,
        reading: Reading::default(),
        tags: BTreeMap::new(),
    };
    let mut networks = Vec::new();
    while reader.at < words.len() {
        let line = reader.place().line;
        networks.push((line, reader.program()?));
    }
    if networks.is_empty() {
        return Err(ReadError::whole(
            "there is no program in the file; it begins with `start`",
        ));
    }
    reader.names();
    let Reader {
        mut reading, tags, ..
    } = reader;
    declare(&mut reading, &tags);
    let mut comments = comments(text).peekable();
    let items = &mut reading.program.items;
    for (line, circuit) in networks {
        let mut above = Vec::new();
        while let Some((_, comment)) = comments.next_if(|(at, _)| *at < line) {
            above.push(comment.to_owned());
        }
        items.push(Item::Blank);
        items.push(Item::Network(Network {
            comments: above,
            drawing: Drawing::Circuit(circuit),
        }));
    }
    let mut after = comments
        .map(|(_, comment)| Item::Comment(comment.to_owned()))
        .peekable();
    items.extend(after.peek().is_some().then_some(Item::Blank));
    items.extend(after);
    Ok(reading)
}

/// The comments of a text, with their lines.
fn comments(text: &str) -> impl Iterator<Item = (u32, &str)> {
    let lines = (1..).zip(text.lines());
    lines.filter_map(|(number, line)| Some((number, line.trim_start().strip_prefix('#')?.trim())))
}

/// What is known of a variable.
struct Tag {
    /// Where it is first named.
    place: LineColumn,
    value: Option<bool>,
    written: bool,
    /// The first contact that is called like a coil, or the other way round.
    misplaced: Option<(LineColumn, Element)>,
}

/// What is read of an expression without its parentheses.
#[derive(Default)]
struct Level {
    branches: Vec<Vec<Circuit<Drawn>>>,
    /// A branch has several parts next to another branch, and no parentheses say so.
    is_mixed: bool,
}

impl Level {
    fn branch(&mut self, first: Circuit<Drawn>) {
        self.is_mixed |= self.branches.last().is_some_and(|branch| branch.len() > 1);
        self.branches.push(vec![first]);
    }

    fn in_series(&mut self, part: Circuit<Drawn>) {
        self.is_mixed |= self.branches.len() > 1;
        if let Some(branch) = self.branches.last_mut() {
            branch.push(part);
        }
    }

    /// A coil takes all that is before it.
    fn close(&mut self) {
        if self.branches.len() > 1 {
            let whole = std::mem::take(&mut self.branches);
            let whole = whole.into_iter().map(in_series).collect();
            self.branches = vec![vec![Circuit::Parallel(whole)]];
        }
    }

    fn circuit(mut self) -> Circuit<Drawn> {
        self.close();
        in_series(self.branches.pop().unwrap_or_default())
    }
}

fn in_series(mut parts: Vec<Circuit<Drawn>>) -> Circuit<Drawn> {
    match parts.pop() {
        Some(part) if parts.is_empty() => part,
        last => {
            parts.extend(last);
            Circuit::Series(parts)
        }
    }
}

struct Reader<'w> {
    words: &'w [Word],
    at: usize,
    depth: usize,
    /// The elements of the program that is being read.
    elements: usize,
    reading: Reading,
    tags: BTreeMap<(char, u32), Tag>,
}

impl Reader<'_> {
    /// `start` any `end`
    fn program(&mut self) -> Result<Circuit<Drawn>, ReadError> {
        self.expect(WordKind::Start, "a program begins with `start`")?;
        self.elements = 0;
        let first = self.at;
        let circuit = self.any()?;
        let after = self.at;
        self.expect(
            WordKind::End,
            "a program ends with `end`, and `&` or `V` is between two elements",
        )?;
        self.check(first, after)?;
        Ok(circuit)
    }

    fn any(&mut self) -> Result<Circuit<Drawn>, ReadError> {
        let start = self.place();
        let mut whole = Level::default();
        loop {
            whole.branch(self.one()?);
            while self.take(WordKind::And) {
                if self.is_at_coil() {
                    whole.close();
                }
                whole.in_series(self.one()?);
            }
            if !self.take(WordKind::Or) {
                break;
            }
        }
        if whole.is_mixed {
            self.remark(
                start,
                "textbook-precedence",
                "the paper does not say what belongs together here: before a coil `&` takes all that is before it, between \
                 contacts it binds more tightly than `V`; put parentheses round what belongs together"
                    .to_owned(),
            );
        }
        Ok(whole.circuit())
    }

    /// Whether a coil is next, or what is in parentheses and begins with one.
    fn is_at_coil(&self) -> bool {
        let mut words = self.words[self.at..].iter().map(|word| word.kind);
        let first = words.find(|kind| *kind != WordKind::Open);
        matches!(first, Some(WordKind::Element(element)) if element.is_coil())
    }

    fn one(&mut self) -> Result<Circuit<Drawn>, ReadError> {
        let place = self.place();
        match self.next() {
            Some(WordKind::Open) if self.depth == DEEPEST => Err(ReadError::at(
                place,
                format!("parentheses are nested more than {DEEPEST} deep"),
            )),
            Some(WordKind::Open) => {
                self.depth += 1;
                let inside = self.any()?;
                self.depth -= 1;
                self.expect(WordKind::Close, "this parenthesis is not closed")?;
                Ok(inside)
            }
            Some(WordKind::Element(element)) => {
                let Some(WordKind::Name(name)) = self.next() else {
                    return Err(ReadError::at(
                        place,
                        "a name such as `I0.1`, `M2` or `Q3` is missing here",
                    ));
                };
                self.element(place, element, name)
            }
            _ => Err(ReadError::at(place, "a contact, a coil or `(` is missing here")),
        }
    }

    fn element(
        &mut self,
        place: LineColumn,
        element: Element,
        name: Name,
    ) -> Result<Circuit<Drawn>, ReadError> {
        self.elements += 1;
        if self.elements > MOST_ELEMENTS {
            let message = format!(
                "a program has at most {MOST_ELEMENTS} contacts and coils: make several of it, with a memory such as `M0` between them"
            );
            return Err(ReadError::at(place, message));
        }
        let Name {
            letter,
            number,
            value,
        } = name;
        let called = format!("{letter}{number}");
        match (element.is_coil() || letter == 'M', value) {
            (true, Some(_)) => {
                let what = if element.is_coil() { "a coil" } else { "a memory" };
                return Err(ReadError::at(
                    place,
                    format!("{what} has no value: write `{called}`"),
                ));
            }
            (false, None) if letter == 'I' => {
                return Err(ReadError::at(
                    place,
                    format!("an input has a value: write `{called}.0` or `{called}.1`"),
                ));
            }
            _ => {}
        }
        let tag = self.tags.entry((letter, number)).or_insert(Tag {
            place,
            value,
            written: false,
            misplaced: None,
        });
        tag.written |= element.is_coil();
        let better = if element.is_coil() { ['Q', 'M'] } else { ['I', 'M'] };
        if !better.contains(&letter) {
            tag.misplaced.get_or_insert((place, element));
        }
        if value.is_some() && tag.value.is_some() && tag.value != value {
            return Err(ReadError::at(
                place,
                format!("`{called}` has another value at {}: an input has one", tag.place),
            ));
        }
        tag.value = tag.value.or(value);
        let (one, two) = element.words();
        let shown = match value {
            Some(value) => format!("{one} {two} {called}.{}", u8::from(value)),
            None => format!("{one} {two} {called}"),
        };
        self.reading.report.translated(place, shown);
        let origin = self.reading.origin(place);
        let block = Block::of(element.op(), [Path::tag(called)]);
        let block = block.map_err(|why| ReadError::at(place, why))?;
        Ok(Circuit::Element(Drawn::of(block, Some(origin))))
    }

    /// The paper's checks of a whole program, which is between two words.
    fn check(&mut self, first: usize, after: usize) -> Result<(), ReadError> {
        let inside = &self.words[first..after];
        let mut elements = inside.iter().filter_map(|word| match word.kind {
            WordKind::Element(element) => Some((element, word.place)),
            _ => None,
        });
        if let Some((element, place)) = elements.next()
            && element.is_coil()
        {
            return Err(ReadError::at(
                place,
                "a program begins with a contact, not with a coil",
            ));
        }
        match elements.next_back() {
            Some((element, place)) if !element.is_coil() => Err(ReadError::at(
                place,
                "a program ends with a coil, not with a contact",
            )),
            Some(_) => Ok(()),
            None => Err(ReadError::at(
                self.words[first].place,
                "a program has a contact, a coil and an operation between them",
            )),
        }
    }

    /// Remarks on names that suit the other kind of element. An output that is also read, as in a seal-in, suits.
    fn names(&mut self) {
        let mut remarks = Vec::new();
        for ((letter, number), tag) in &self.tags {
            let Some((place, element)) = tag.misplaced.filter(|_| !(*letter == 'Q' && tag.written)) else {
                continue;
            };
            let (what, one, other) = if element.is_coil() {
                ("a coil", 'Q', 'M')
            } else {
                ("a contact", 'I', 'M')
            };
            let message = format!(
                "{what} is better called `{one}{number}` or `{other}{number}` than `{letter}{number}`"
            );
            remarks.push((place, message));
        }
        for (place, message) in remarks {
            self.remark(place, "textbook-name", message);
        }
        self.reading.findings.sort_by_key(|found| found.place);
    }

    fn remark(&mut self, place: LineColumn, check: &'static str, message: String) {
        self.reading.findings.push(Finding {
            place,
            severity: Severity::Warning,
            check,
            message,
        });
    }

    fn next(&mut self) -> Option<WordKind> {
        let word = self.words.get(self.at)?;
        self.at += 1;
        Some(word.kind)
    }

    fn take(&mut self, kind: WordKind) -> bool {
        let found = self.words.get(self.at).is_some_and(|word| word.kind == kind);
        self.at += usize::from(found);
        found
    }

    fn expect(&mut self, kind: WordKind, message: &str) -> Result<(), ReadError> {
        let place = self.place();
        if self.take(kind) {
            return Ok(());
        }
        Err(ReadError::at(place, message))
    }

    /// Where the next word is; at the end, where the last one does.
    fn place(&self) -> LineColumn {
        let word = self.words.get(self.at).or(self.words.last());
        word.map_or(LineColumn::START, |word| word.place)
    }
}

/// The sections: inputs with their values, outputs, memories.
fn declare(reading: &mut Reading, tags: &BTreeMap<(char, u32), Tag>) {
    for (letter, kind) in [
        ('I', SectionKind::VarInput),
        ('Q', SectionKind::VarOutput),
        ('M', SectionKind::Var),
    ] {
        // An input that is written, an output that is read: they keep their names, and are plain tags.
        let own = tags.iter().filter(|((first, _), _)| *first == letter);
        let (plain, special): (Vec<_>, Vec<_>) = own.partition(|(_, tag)| tag.written && letter == 'I');
        for (kind, tags) in [(kind, special), (SectionKind::Var, plain)] {
            let mut section = Section::new(kind);
            for ((letter, number), tag) in tags {
                section.declarations.push(Declaration {
                    initial: tag.value.filter(|on| *on).map(|_| "TRUE".to_owned()),
                    origin: Some(reading.origin(tag.place)),
                    ..Declaration::new(format!("{letter}{number}"), "BOOL")
                });
            }
            reading.program.items.push(Item::Section(section));
        }
    }
}
