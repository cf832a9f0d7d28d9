//! A program as its entries: networks, declarations, types, block definitions, settings and comments. Together they are the
//! whole text, so that what becomes of every line can be expressed of one of them.

use crate::canonical::Canonical;
use crate::reader::entries;
use ladder_analysis::context;
use ladder_analysis::context::Context;
use ladder_analysis::program::{Program, unread_name};
use ladder_analysis::{AnalyzeOptions, Cancel, NotWhole};
use ladder_syntax::{Name, TextRange, TextSize};
use std::cell::OnceCell;
use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

/// The entries of a program.
#[derive(Debug, Clone)]
pub struct Outline {
    /// The program.
    pub context: Arc<Context>,
    /// Its entries from top to bottom.
    pub entries: Vec<Entry>,
    /// The blank lines at its end.
    pub end: TextRange,
    program: OnceCell<Result<Running, String>>,
    /// The other files that it uses, by their names, which are the same before and after a change.
    pub(crate) files: BTreeMap<String, Arc<Context>>,
}

/// A program as it runs.
#[derive(Debug, Clone)]
pub(crate) struct Running {
    pub(crate) program: Arc<Program>,
    /// The networks of its own file, by where they begin. They are in another order than the text's: bodies of blocks come last.
    numbers: HashMap<TextSize, usize>,
}

impl Running {
    fn new(program: Arc<Program>) -> Running {
        let networks = program.networks.iter().enumerate();
        let own = networks.filter(|(_, network)| network.location.file == 0);
        Running {
            numbers: own
                .map(|(number, network)| (network.location.range.start(), number))
                .collect(),
            program,
        }
    }

    /// The number of a network in the program.
    pub(crate) fn number(&self, outline: &Outline, entry: &Entry) -> Option<usize> {
        let network = outline.context.networks.at(entry.network?);
        self.numbers.get(&network.range.start()).copied()
    }
}

/// What an entry is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Kind {
    /// A network, by its index in the program's [`Context::networks`].
    Network,
    /// `VAR` .. `END_VAR`, `TYPE` .. `END_TYPE`, with its declarations.
    Section,
    /// `FUNCTION_BLOCK` .. `END_FUNCTION_BLOCK`, with sections and networks.
    Block,
    /// `Motor : STRUCT` .. `END_STRUCT;`, with its members.
    Structure,
    /// A declaration of tags, a type or a member.
    Declaration,
    /// A comment that says something to the tools: `# ladder: profile iot #`.
    Setting,
    /// The directive that its block is an unread part, with the text of the other system below it.
    Unread,
    /// Any other comment that is not right above something else.
    Comment,
    /// A line that holds nothing but errors.
    Stray,
}

impl Kind {
    /// As it is called in reports.
    pub const fn text(self) -> &'static str {
        match self {
            Kind::Network => "network",
            Kind::Section => "section",
            Kind::Block => "block",
            Kind::Structure => "structure",
            Kind::Declaration => "declaration",
            Kind::Setting => "setting",
            Kind::Unread => "unread part",
            Kind::Comment => "comment",
            Kind::Stray => "line",
        }
    }

    /// Whether it holds other entries.
    pub const fn holds_others(self) -> bool {
        matches!(self, Kind::Section | Kind::Block | Kind::Structure)
    }
}

/// One thing that can be changed by itself.
#[derive(Debug, Clone)]
pub struct Entry {
    /// What it is.
    pub kind: Kind,
    /// The blank lines and comments right above it and itself; of one that holds others up to the end of its first line.
    pub range: TextRange,
    /// The same without the blank lines.
    pub shown: TextRange,
    /// Itself, without what is above it.
    pub own: TextRange,
    /// Which network it is.
    pub network: Option<usize>,
    /// The function or block that it is in, as a heading says it; empty for the main program.
    pub place: Arc<str>,
    /// In a program of another system what that calls the place, empty where it has no name for it. None: its line says it.
    pub part: Option<Arc<str>>,
    /// The tags that it writes, or the names that it declares.
    pub names: Vec<Name>,
    /// The names as they are written, for people.
    pub title: String,
    /// What it holds.
    pub inside: Vec<Entry>,
    /// Of one that holds others its last line, with the blank lines above it.
    pub end: TextRange,
    /// What it says.
    pub(crate) told: Canonical,
    /// The comments in it and right above it.
    pub(crate) comments: String,
}

/// A part of another system's program that no reader understands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct UnreadPart {
    pub(crate) name: String,
    /// The comment on it.
    pub(crate) about: String,
    /// What it may write, and what the other system has there.
    pub(crate) text: String,
}

/// Why a program does not run, of which `own` is the file; other files are named as `shown` has it.
pub fn why_not(not_whole: &NotWhole, own: &str, shown: impl Fn(&str) -> String) -> String {
    match not_whole {
        NotWhole::Errors(file) if **file == *own => "has errors".to_owned(),
        NotWhole::Errors(file) => format!("uses {}, which has errors", shown(file)),
        NotWhole::Missing(file) => format!("uses {}, which cannot be read", shown(file)),
    }
}

fn name_parts(entries: &mut [Entry], name: &dyn Fn(TextRange) -> Option<String>) {
    for entry in entries {
        entry.part = Some(name(entry.own).unwrap_or_default().into());
        name_parts(&mut entry.inside, name);
    }
}

fn take_parts(entries: &mut [Entry], from: &[Entry]) {
    for (entry, from) in entries.iter_mut().zip(from) {
        entry.part.clone_from(&from.part);
        take_parts(&mut entry.inside, &from.inside);
    }
}

impl Outline {
    /// Reads the entries of a program that uses no other file.
    pub fn new(context: Arc<Context>) -> Outline {
        let (entries, end) = entries(&context);
        Outline {
            context,
            entries,
            end,
            program: OnceCell::new(),
            files: BTreeMap::new(),
        }
    }

    /// Reads the entries of a text that uses no other file.
    pub fn of_text(name: &str, text: &str) -> Outline {
        let parse = Arc::new(ladder_syntax::parse(text));
        Outline::new(Arc::new(context(&parse, name)))
    }

    /// Reads the entries of a program among others: `program` is what runs, or why nothing does (`has errors`), and `files` are
    /// those that it uses.
    pub fn among(
        context: Arc<Context>,
        program: Result<Arc<Program>, String>,
        files: BTreeMap<String, Arc<Context>>,
    ) -> Outline {
        let outline = Outline {
            files,
            ..Outline::new(context)
        };
        let _ = outline.program.set(program.map(Running::new));
        outline
    }

    /// Takes the names that another system has for the places of a program that was made from one of its files; `name` asks
    /// for that of a part of the text.
    pub fn name_parts(&mut self, name: impl Fn(TextRange) -> Option<String>) {
        name_parts(&mut self.entries, &name);
    }

    /// Takes those of the same program with other names of tags.
    pub fn take_parts(&mut self, from: &Outline) {
        take_parts(&mut self.entries, &from.entries);
    }

    /// What runs, if it was made already.
    pub(crate) fn known_program(&self) -> Option<&Program> {
        Some(&self.program.get()?.as_ref().ok()?.program)
    }

    /// What runs, or why nothing does.
    pub(crate) fn program(&self) -> &Result<Running, String> {
        self.program.get_or_init(|| {
            let analysis =
                AnalyzeOptions::new("").check_unless(Arc::clone(&self.context), &Cancel::default());
            let program = analysis.and_then(|analysis| analysis.program().cloned().map(Running::new));
            program.ok_or_else(|| "has errors, or uses other files".into())
        })
    }

    /// The unread parts that the program defines.
    pub(crate) fn unread(&self) -> Vec<UnreadPart> {
        let mut found = Vec::new();
        unread(&self.entries, &mut found);
        found
    }

    /// Whether it is a program that runs.
    pub fn runs(&self) -> bool {
        self.program().is_ok()
    }

    /// What is written in a range of the text.
    pub fn text(&self, range: TextRange) -> std::borrow::Cow<'_, str> {
        self.context.parse.text_in(range)
    }

    /// The line of the text at which an entry itself begins, from 1.
    pub fn line(&self, entry: &Entry) -> usize {
        self.context.line_number(entry.own.start())
    }
}

fn unread(entries: &[Entry], found: &mut Vec<UnreadPart>) {
    for entry in entries {
        if entry.kind == Kind::Unread {
            let block = entry.place.split(' ').next_back().unwrap_or_default();
            found.push(UnreadPart {
                name: unread_name(block).to_owned(),
                about: entry.title.clone(),
                text: entry.told.key.clone(),
            });
        }
        unread(&entry.inside, found);
    }
}
