//! L5K: the text that Logix Designer exports, with the same content as L5X.
//!
//! ```text
//! CONTROLLER Cell (ProcessorType := "1756-L63")
//!     DATATYPE Motor (FamilyType := NoFamily)  SINT ZZ0 (Hidden := 1);  BIT Run ZZ0 : 0;  END_DATATYPE
//!     TAG  t : TIMER := [0,1000,0];  go OF Local:1:I.Data.3;  END_TAG
//!     PROGRAM Main (MAIN := "Begin")  ROUTINE Begin  RC: "said";  N: XIC(go)OTE(run);  END_ROUTINE  END_PROGRAM
//! END_CONTROLLER
//! ```

mod statement;
mod value;

pub(crate) use value::value;

use crate::model::{
    Aoi, DataType, Foreign, Language, Member, Program, Project, Protected, Routine, Rung, Tag, Task, TaskKind,
};
use ladder_notation::{Lines, ReadError};
use statement::{Attributes, sizes, tag, unquoted, with_attributes};

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
            self.at = match inside.find("*)") {
                Some(end) => self.at + end + 4,
                None => self.text.len(),
            };
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

    /// Leaves a block out. What was in it.
    fn skip(&mut self, end: &str) -> Result<&'t str> {
        let rest = self.rest();
        match rest.find(end) {
            Some(found) => {
                self.at += found + end.len();
                Ok(&rest[..found])
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
                    let name = attributes.text("Name");
                    let text = reader.skip("END_ENCODED_DATA")?.to_owned();
                    if attributes.text("EncodedType").eq_ignore_ascii_case("PROGRAM") {
                        let why = "its source is protected, and only Logix Designer can read it";
                        reader
                            .project
                            .refused
                            .push((at, format!("ENCODED_DATA {name}"), why.to_owned()));
                    } else {
                        reader.project.protected.push(Protected { at, name, text });
                    }
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
        let (_, name, attributes) = self.head()?;
        let kind = TaskKind::named(&attributes.text("Type"));
        if kind == TaskKind::Periodic && self.project.rate.is_none() {
            self.project.rate = Some(attributes.text("Rate"));
        }
        let mut task = Task {
            name,
            kind,
            inhibited: attributes.text("InhibitTask").eq_ignore_ascii_case("Yes"),
            rate: Some(attributes.text("Rate")),
            priority: attributes.text("Priority").parse().ok(),
            programs: Vec::new(),
        };
        self.block("END_TASK", |reader, _| {
            let (_, program) = reader.statement()?;
            task.programs.push(program.to_owned());
            Ok(true)
        })?;
        self.project.tasks.push(task);
        Ok(())
    }

    fn data_type(&mut self) -> Result<DataType> {
        let (at, name, attributes) = self.head()?;
        let mut ty = DataType {
            at,
            name,
            is_string: attributes.text("FamilyType") == "StringFamily",
            comment: attributes.told(),
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
                comment: attributes.told(),
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
            comment: attributes.told(),
            ..Aoi::default()
        };
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
                _ => return reader.routine(word, &mut aoi.routines),
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
            inhibited: attributes.text("DISABLED").eq_ignore_ascii_case("Yes"),
            main: (!main.is_empty()).then_some(main),
            comment: attributes.told(),
            ..Program::default()
        };
        self.block("END_PROGRAM", |reader, word| {
            match word {
                "TAG" => {
                    reader.word();
                    program.tags.extend(reader.tags("END_TAG")?);
                }
                _ => return reader.routine(word, &mut program.routines),
            }
            Ok(true)
        })?;
        Ok(program)
    }

    /// A routine, if one begins with a word.
    fn routine(&mut self, word: &str, routines: &mut Vec<Routine>) -> Result<bool> {
        let language = match word {
            "ROUTINE" => {
                self.word();
                routines.push(self.rungs()?);
                return Ok(true);
            }
            "FBD_ROUTINE" => Language::FunctionBlocks,
            "SFC_ROUTINE" => Language::Chart,
            "ST_ROUTINE" => Language::StructuredText,
            _ => return Ok(false),
        };
        self.word();
        let (at, name, attributes) = self.head()?;
        let text = self.skip(&format!("END_{word}"))?;
        let text = match language {
            // Each of its lines begins with a quote.
            Language::StructuredText => {
                let lines = text
                    .lines()
                    .filter_map(|line| line.trim_start().strip_prefix('\''));
                lines.collect::<Vec<_>>().join("\n")
            }
            _ => text.trim().to_owned(),
        };
        routines.push(Routine {
            at,
            name,
            foreign: Some(Foreign { language, text }),
            comment: attributes.told(),
            ..Routine::default()
        });
        Ok(true)
    }

    fn rungs(&mut self) -> Result<Routine> {
        let (at, name, attributes) = self.head()?;
        let mut routine = Routine {
            at,
            name,
            comment: attributes.told(),
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
                ..Rung::default()
            });
            Ok(true)
        })?;
        Ok(routine)
    }
}
