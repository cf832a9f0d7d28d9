//! L5K: the text that Logix Designer exports, with the same content as L5X.
//!
//! ```text
//! CONTROLLER Cell (ProcessorType := "1756-L63")
//!     DATATYPE Motor (FamilyType := NoFamily)  SINT ZZ0 (Hidden := 1);  BIT Run ZZ0 : 0;  END_DATATYPE
//!     TAG  t : TIMER := [0,1000,0];  go OF Local:1:I.Data.3;  END_TAG
//!     PROGRAM Main (MAIN := "Begin")  ROUTINE Begin  RC: "said";  N: XIC(go)OTE(run);  END_ROUTINE  END_PROGRAM
//! END_CONTROLLER
//! ```

use crate::model::{Aoi, DataType, Member, Program, Project, Raw, Routine, Rung, Tag, Usage};
use ladder_notation::{Lines, ReadError};

/// Whether a text is such an export.
pub(crate) fn recognises(text: &str) -> bool {
    let text = text.trim_start_matches('\u{feff}');
    let mut rest = text
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty())
        .take(40);
    let is_first = |line: &str| line.starts_with("IE_VER") || line.starts_with("CONTROLLER ");
    rest.any(is_first)
}

/// Reads a file.
///
/// # Errors
///
/// If a block or a statement has no end, or there is no controller.
pub(crate) fn read(text: &str) -> Result<Project, ReadError> {
    let mut reader = Reader {
        text,
        at: 0,
        project: Project::default(),
    };
    let found = reader.file();
    match found {
        Ok(true) => Ok(reader.project),
        Ok(false) => Err(ReadError::whole(
            "the file has no CONTROLLER: there is nothing to read",
        )),
        Err((at, message)) => Err(ReadError::at(Lines::of(text).place(text, at), message)),
    }
}

type Result<T, E = (usize, String)> = std::result::Result<T, E>;

/// The words and statements of a file.
struct Reader<'t> {
    text: &'t str,
    at: usize,
    project: Project,
}

impl<'t> Reader<'t> {
    fn rest(&self) -> &'t str {
        &self.text[self.at..]
    }

    /// Past blanks and comments.
    fn blanks(&mut self) {
        loop {
            self.at = self.text.len()
                - self
                    .rest()
                    .trim_start_matches([' ', '\t', '\r', '\n', '\u{feff}'])
                    .len();
            let Some(inside) = self.rest().strip_prefix("(*") else {
                return;
            };
            self.at += 4 + inside.find("*)").unwrap_or(inside.len().saturating_sub(2));
        }
    }

    fn peek(&mut self) -> &'t str {
        self.blanks();
        let rest = self.rest();
        let end = rest.find(|c: char| !(c.is_alphanumeric() || matches!(c, '_' | ':' | '\\')));
        let word = &rest[..end.unwrap_or(rest.len())];
        word.trim_end_matches(':')
    }

    fn word(&mut self) -> &'t str {
        let word = self.peek();
        self.at += word.len();
        word
    }

    /// Up to something at the outermost level, without it; outside of texts and brackets.
    fn up_to(&mut self, ends: &[char]) -> Result<&'t str> {
        let start = self.at;
        let (mut open, mut quote, mut escaped) = (0usize, None, false);
        for (offset, c) in self.rest().char_indices() {
            match (quote, c) {
                (Some(_), _) if escaped => escaped = false,
                (Some(_), '$') => escaped = true,
                (Some(mark), c) if c == mark => quote = None,
                (Some(_), _) => {}
                (None, '"' | '\'') => quote = Some(c),
                (None, c) if open == 0 && ends.contains(&c) => {
                    self.at = start + offset;
                    return Ok(&self.text[start..self.at]);
                }
                (None, '(' | '[') => open += 1,
                (None, ')' | ']') => open = open.saturating_sub(1),
                _ => {}
            }
        }
        Err((start, "what begins here has no end".to_owned()))
    }

    /// A statement without its `;`, and where it begins.
    fn statement(&mut self) -> Result<(usize, &'t str)> {
        self.blanks();
        let at = self.at;
        let text = self.up_to(&[';'])?;
        self.at += 1;
        Ok((at, text.trim()))
    }

    /// The attributes in parentheses that follow, if there are any.
    fn attributes(&mut self) -> Result<Attributes<'t>> {
        self.blanks();
        if !self.rest().starts_with('(') || self.rest().starts_with("(*") {
            return Ok(Attributes(Vec::new()));
        }
        self.at += 1;
        let inside = self.up_to(&[')'])?;
        self.at += 1;
        Ok(Attributes::of(inside))
    }

    /// The name and the attributes with which a block begins.
    fn head(&mut self) -> Result<(usize, String, Attributes<'t>)> {
        self.blanks();
        let at = self.at;
        let name = self.word().to_owned();
        Ok((at, name, self.attributes()?))
    }

    /// What is in a block up to its end; `each` reads what begins with a word. It says whether it read it.
    fn block(&mut self, end: &str, mut each: impl FnMut(&mut Self, &'t str) -> Result<bool>) -> Result<()> {
        let begin = self.at;
        loop {
            let word = self.peek();
            if word.eq_ignore_ascii_case(end) {
                self.at += word.len();
                return Ok(());
            }
            if self.rest().is_empty() {
                return Err((
                    begin.min(self.text.len()),
                    format!("the block that begins here has no {end}"),
                ));
            }
            if !each(self, word)? {
                self.statement()?;
            }
        }
    }

    /// Leaves a block out.
    fn skip(&mut self, end: &str) -> Result<()> {
        match self.rest().find(end) {
            Some(found) => {
                self.at += found + end.len();
                Ok(())
            }
            None => Err((self.at, format!("the block that begins here has no {end}"))),
        }
    }

    fn file(&mut self) -> Result<bool> {
        loop {
            match self.peek() {
                "CONTROLLER" => {
                    self.word();
                    let (_, name, _) = self.head()?;
                    self.project.name = name;
                    self.controller()?;
                    return Ok(true);
                }
                _ if self.rest().is_empty() => return Ok(false),
                _ => {
                    self.statement()?;
                }
            }
        }
    }

    fn controller(&mut self) -> Result<()> {
        self.block("END_CONTROLLER", |reader, word| {
            match word {
                "DATATYPE" => {
                    reader.word();
                    let read = reader.data_type()?;
                    reader.project.types.push(read);
                }
                "ADD_ON_INSTRUCTION_DEFINITION" => {
                    reader.word();
                    let read = reader.aoi()?;
                    reader.project.aois.push(read);
                }
                "ENCODED_DATA" => {
                    reader.word();
                    let (at, _, attributes) = reader.head()?;
                    let what = format!("ENCODED_DATA {}", attributes.text("Name"));
                    let why = "it is encoded: its source is protected, and only Logix Designer can read it";
                    reader.project.refused.push((at, what, why.to_owned()));
                    reader.skip("END_ENCODED_DATA")?;
                }
                "TAG" => {
                    reader.word();
                    let tags = reader.tags("END_TAG")?;
                    reader.project.tags.extend(tags);
                }
                "PROGRAM" => {
                    reader.word();
                    let read = reader.program()?;
                    reader.project.programs.push(read);
                }
                "TASK" => {
                    reader.word();
                    reader.task()?;
                }
                "MODULE" | "CONFIG" | "TREND" | "QUICK_WATCH" | "PARAMETER_CONNECTION" => {
                    let end = format!("END_{word}");
                    reader.skip(&end)?;
                }
                _ => return Ok(false),
            }
            Ok(true)
        })
    }

    fn task(&mut self) -> Result<()> {
        let (_, _, attributes) = self.head()?;
        if attributes.text("Type").eq_ignore_ascii_case("PERIODIC") && self.project.rate.is_none() {
            self.project.rate = Some(attributes.text("Rate"));
        }
        self.block("END_TASK", |reader, _| {
            let (_, program) = reader.statement()?;
            reader.project.scheduled.push(program.to_owned());
            Ok(true)
        })
    }

    fn data_type(&mut self) -> Result<DataType> {
        let (at, name, attributes) = self.head()?;
        let mut ty = DataType {
            at,
            name,
            is_string: attributes.text("FamilyType") == "StringFamily",
            comment: attributes.said(),
            ..DataType::default()
        };
        self.block("END_DATATYPE", |reader, _| {
            let (_, text) = reader.statement()?;
            let (text, attributes) = with_attributes(text);
            let mut words = text.split_whitespace();
            let (kind, name) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
            let (name, dimensions) = sizes(name);
            let mut member = Member {
                name: name.to_owned(),
                ty: kind.to_owned(),
                dimensions,
                hidden: attributes.text("Hidden") == "1",
                comment: attributes.said(),
                bit: None,
            };
            if kind == "BIT" {
                let host = words.next().unwrap_or_default().trim_end_matches(':');
                let number = words
                    .next_back()
                    .and_then(|number| number.trim_start_matches(':').parse().ok());
                member.bit = number.map(|number| (host.to_owned(), number));
            }
            ty.members.push(member);
            Ok(true)
        })?;
        Ok(ty)
    }

    fn tags(&mut self, end: &str) -> Result<Vec<Tag>> {
        let mut tags = Vec::new();
        self.block(end, |reader, _| {
            let (at, text) = reader.statement()?;
            tags.push(tag(at, text));
            Ok(true)
        })?;
        Ok(tags)
    }

    fn aoi(&mut self) -> Result<Aoi> {
        let (at, name, attributes) = self.head()?;
        let mut aoi = Aoi {
            at,
            name,
            comment: attributes.said(),
            ..Aoi::default()
        };
        let owner = format!("Add-On Instruction {}", aoi.name);
        self.block("END_ADD_ON_INSTRUCTION_DEFINITION", |reader, word| {
            match word {
                "PARAMETERS" => {
                    reader.word();
                    aoi.parameters.extend(reader.tags("END_PARAMETERS")?);
                }
                "LOCAL_TAGS" => {
                    reader.word();
                    aoi.locals.extend(reader.tags("END_LOCAL_TAGS")?);
                }
                _ => return reader.routine(word, &owner, &mut aoi.routines),
            }
            Ok(true)
        })?;
        Ok(aoi)
    }

    fn program(&mut self) -> Result<Program> {
        let (at, name, attributes) = self.head()?;
        let main = attributes.text("MAIN");
        let mut program = Program {
            at,
            name,
            main: (!main.is_empty()).then_some(main),
            comment: attributes.said(),
            ..Program::default()
        };
        let owner = format!("program {}", program.name);
        self.block("END_PROGRAM", |reader, word| {
            match word {
                "TAG" => {
                    reader.word();
                    program.tags.extend(reader.tags("END_TAG")?);
                }
                _ => return reader.routine(word, &owner, &mut program.routines),
            }
            Ok(true)
        })?;
        Ok(program)
    }

    /// A routine, if one begins with a word.
    fn routine(&mut self, word: &str, owner: &str, routines: &mut Vec<Routine>) -> Result<bool> {
        let language = match word {
            "ROUTINE" => {
                self.word();
                routines.push(self.rungs()?);
                return Ok(true);
            }
            "FBD_ROUTINE" => "a function block diagram",
            "SFC_ROUTINE" => "a sequential function chart",
            "ST_ROUTINE" => "structured text",
            _ => return Ok(false),
        };
        self.word();
        let (at, name, _) = self.head()?;
        let why = format!("it is {language}; only ladder logic is read");
        self.project
            .refused
            .push((at, format!("routine {name} of {owner}"), why));
        self.skip(&format!("END_{word}"))?;
        Ok(true)
    }

    fn rungs(&mut self) -> Result<Routine> {
        let (at, name, attributes) = self.head()?;
        let mut routine = Routine {
            at,
            name,
            comment: attributes.said(),
            ..Routine::default()
        };
        let mut comment = None;
        self.block("END_ROUTINE", |reader, word| {
            reader.at += word.len();
            reader.blanks();
            if !reader.rest().starts_with(':') {
                let why = format!("`{word}` is not expected in a routine of ladder logic");
                return Err((reader.at - word.len(), why));
            }
            reader.at += 1;
            let (at, text) = reader.statement()?;
            if word.eq_ignore_ascii_case("RC") {
                comment = Some(unquoted(text));
                return Ok(true);
            }
            routine.rungs.push(Rung {
                at,
                text: format!("{text};"),
                comment: comment.take(),
                edit: (!matches!(word, "N" | "IR")).then(|| word.to_owned()),
            });
            Ok(true)
        })?;
        Ok(routine)
    }
}

/// `name := value`, one after the other.
struct Attributes<'t>(Vec<(&'t str, &'t str)>);

impl<'t> Attributes<'t> {
    fn of(text: &'t str) -> Attributes<'t> {
        let parts = parts(text, ',');
        let pairs = parts.into_iter().filter_map(|part| part.split_once(":="));
        Attributes(pairs.map(|(name, value)| (name.trim(), value.trim())).collect())
    }

    fn text(&self, name: &str) -> String {
        let found = self.0.iter().find(|(own, _)| own.eq_ignore_ascii_case(name));
        found.map(|(_, value)| unquoted(value)).unwrap_or_default()
    }

    fn said(&self) -> Option<String> {
        Some(self.text("Description")).filter(|said| !said.is_empty())
    }
}

/// A text without its quotes and their escapes.
fn unquoted(text: &str) -> String {
    let inside = text.trim().trim_matches('"');
    inside
        .replace("$N", "\n")
        .replace("$Q", "\"")
        .replace("$\"", "\"")
        .replace("$'", "'")
}

/// What a character parts at the outermost level.
fn parts(text: &str, at: char) -> Vec<&str> {
    let mut out = Vec::new();
    let (mut start, mut open, mut quote, mut escaped) = (0, 0usize, None, false);
    for (offset, c) in text.char_indices() {
        match (quote, c) {
            (Some(_), _) if escaped => escaped = false,
            (Some(_), '$') => escaped = true,
            (Some(mark), c) if c == mark => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'') => quote = Some(c),
            (None, '(' | '[') => open += 1,
            (None, ')' | ']') => open = open.saturating_sub(1),
            (None, c) if c == at && open == 0 => {
                out.push(&text[start..offset]);
                start = offset + c.len_utf8();
            }
            _ => {}
        }
    }
    out.push(&text[start..]);
    out
}

/// A statement and the attributes in it.
fn with_attributes(text: &str) -> (&str, Attributes<'_>) {
    match text.split_once('(') {
        Some((before, after)) => {
            let inside = parts(after, ')');
            (
                before.trim(),
                Attributes::of(inside.first().copied().unwrap_or_default()),
            )
        }
        None => (text, Attributes(Vec::new())),
    }
}

/// `name[3,5]`
fn sizes(text: &str) -> (&str, Vec<u32>) {
    match text.split_once('[') {
        Some((name, sizes)) => {
            let sizes = sizes.trim_end_matches(']').split(',');
            (
                name.trim(),
                sizes
                    .filter_map(|size| size.trim().parse().ok())
                    .filter(|size| *size > 0)
                    .collect(),
            )
        }
        None => (text.trim(), Vec::new()),
    }
}

/// `t : TIMER (RADIX := Decimal) := [0,1000,0]`, `go OF Local:1:I.Data.3`
fn tag(at: usize, text: &str) -> Tag {
    let (head, attributes) = with_attributes(text);
    let usage = match attributes.text("Usage").as_str() {
        "Input" => Usage::Input,
        "Output" => Usage::Output,
        "InOut" => Usage::InOut,
        _ => Usage::Local,
    };
    let mut tag = Tag {
        at,
        usage,
        required: attributes.text("Required").eq_ignore_ascii_case("Yes"),
        constant: matches!(attributes.text("Constant").as_str(), "1" | "Yes"),
        comment: attributes.said(),
        ..Tag::default()
    };
    let mut words = head.split_whitespace();
    let (name, second) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
    if second == "OF" {
        tag.name = name.to_owned();
        tag.alias = words.next().map(str::to_owned);
        return tag;
    }
    // The value is after the attributes, or right after the type.
    let value = match text.rsplit_once(") :=") {
        Some((_, value)) => Some(value),
        None => parts(head, '=').get(1).copied(),
    };
    let given = attributes.text("DefaultData");
    let value = value
        .map(str::trim)
        .or((!given.is_empty()).then_some(given.as_str()));
    tag.value = value.and_then(self::value);
    let head = head.split(":=").next().unwrap_or_default();
    let (name, ty) = head
        .split_once(" : ")
        .or_else(|| head.rsplit_once(':'))
        .unwrap_or((head, ""));
    let (ty, dimensions) = sizes(ty.trim());
    tag.name = name.trim().to_owned();
    tag.ty = ty.to_owned();
    tag.dimensions = dimensions;
    tag
}

/// A value as L5K writes it: `[0,1000,[1,2],'text']`.
pub(crate) fn value(text: &str) -> Option<Raw> {
    let mut reader = Values {
        rest: text.trim(),
        depth: 0,
    };
    let value = reader.value()?;
    reader.rest.trim().is_empty().then_some(value)
}

struct Values<'t> {
    rest: &'t str,
    depth: usize,
}

/// Values nest no deeper.
const DEEPEST: usize = 40;

impl Values<'_> {
    fn value(&mut self) -> Option<Raw> {
        self.rest = self.rest.trim_start();
        if let Some(rest) = self.rest.strip_prefix('[') {
            self.depth += 1;
            if self.depth > DEEPEST {
                return None;
            }
            self.rest = rest;
            let mut values = Vec::new();
            loop {
                values.push(self.value()?);
                self.rest = self.rest.trim_start();
                if let Some(rest) = self.rest.strip_prefix(',') {
                    self.rest = rest;
                    continue;
                }
                self.rest = self.rest.strip_prefix(']')?;
                self.depth -= 1;
                return Some(Raw::List(values));
            }
        }
        let end = if self.rest.starts_with('\'') {
            let mut escaped = false;
            let inner = self.rest.char_indices().skip(1).find(|(_, c)| {
                let ends = *c == '\'' && !escaped;
                escaped = *c == '$' && !escaped;
                ends
            });
            inner?.0 + 1
        } else {
            self.rest.find([',', ']']).unwrap_or(self.rest.len())
        };
        let (text, rest) = self.rest.split_at(end);
        self.rest = rest;
        Some(Raw::Scalar(String::new(), text.trim().to_owned()))
    }
}
