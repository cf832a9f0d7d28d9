//! `ladder diff`: what changed between two programs, network by network.

mod json;
mod same;
mod settings;
mod side;

use crate::git::objects::Objects;
use crate::outcome::{Failure, Outcome};
use crate::output::{Existing, Output};
use crate::terminal::stdout_has_colours;
use anstyle::{AnsiColor, Style};
use clap::{Args, ValueEnum};
use ladder_analysis::Others;
use ladder_analysis::names::join::context;
use ladder_review::report::text::{Line, LineKind};
use ladder_review::report::{Compared, html, markdown, text};
use ladder_review::{Limits, Outline, compare};
use ladder_workspace::shown;
use settings::SettingsDiff;
use side::{File, Side};
use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

const EXAMPLES: &str = "\
Examples:
  ladder diff old.clad motor.clad            two files
  ladder diff HEAD:motor.clad motor.clad     what is not committed yet
  ladder diff main: .                        all programs of a repository
  ladder diff v1:plant/ v2:plant/            two revisions of a folder
  ladder diff --same old.clad new.clad       whether both do the same
  ladder diff motor.L5X motor.clad           other systems' files, as they are
  ladder diff HEAD: . --format markdown      for a pull request
  ladder diff HEAD: . --format html -o changes.html
                                             pictures next to each other

Exit status: 0 the same, 1 something is different, 2 a file cannot be read.";

/// Show what changed between two programs, network by network
///
/// Programs are compared by what they say, not by their lines: a network that is drawn in another way is the same,
/// and one that is elsewhere has moved. What was edited is drawn in both forms, with marks at what is different; what is
/// the same is left out. Of an edited network it is said whether it does the same, or with which values it does not.
/// OLD and NEW are files, folders, or `REV:path` as `git show` takes it. Of folders the
/// programs (.clad) and ladder.toml are compared. Files of other systems are read as ladder text.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The old file or folder, or `REV:path`
    old: PathBuf,

    /// The new file or folder, or `REV:path`
    new: PathBuf,

    /// Say whether the programs do the same, and nothing else
    ///
    /// They do if each network of the old program is in the new one and does the same there, in an order that is the same
    /// or does not matter. Otherwise they do if no run from a cold start on shows a difference; one that does is shown. What
    /// cannot be decided is said, and counts as a difference.
    #[arg(long, conflicts_with_all = ["format", "output"])]
    same: bool,

    /// How to show what changed
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,

    /// Write to this file instead of stdout
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Replace the output file even if no command of ladder made it
    #[arg(long, requires = "output")]
    force: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For a terminal
    Text,
    /// A page for a browser, with pictures next to each other
    Html,
    /// For a pull request
    Markdown,
    /// One array of objects
    Json,
}

/// How long may be asked what edited networks do.
const TIME: Duration = Duration::from_secs(20);

/// The same of whole programs, where it is not all that is asked.
const TIME_OF_WHOLE: Duration = Duration::from_secs(2);
/// Programs of more networks are not compared then: what changed in them is to be seen at once.
const MOST_NETWORKS: usize = 2_000;

impl Arguments {
    /// How much may be done to compare whole programs, and of how many networks.
    fn limits(&self) -> (Limits, usize) {
        let (time, networks) = if self.same {
            (TIME, usize::MAX)
        } else {
            (TIME_OF_WHOLE, MOST_NETWORKS)
        };
        let limits = Limits {
            time,
            ..Limits::default()
        };
        (limits, networks)
    }
}

/// Two files that are compared. None: there is no such file on that side.
struct Pair {
    old: Option<File>,
    new: Option<File>,
}

/// The same as texts.
struct Texts {
    old: Option<Named>,
    new: Option<Named>,
}

/// A text, and what its file is called.
struct Named {
    name: String,
    text: String,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let pairs = pairs(Side::of(&arguments.old)?, Side::of(&arguments.new)?)?;
    let mut objects = None;
    let mut programs = Vec::new();
    let mut settings = Vec::new();
    for Pair { old, new } in &pairs {
        let is_settings = [old, new].iter().any(|file| {
            file.as_ref()
                .is_some_and(|file| side::is_settings(Path::new(&file.name)))
        });
        let Some(texts) = read(old.as_ref(), new.as_ref(), &mut objects)? else {
            continue;
        };
        if is_settings {
            settings.extend(SettingsDiff::new(
                texts.old.as_ref().map(Named::borrowed),
                texts.new.as_ref().map(Named::borrowed),
            ));
        } else {
            programs.push((outline(texts.old.as_ref()), outline(texts.new.as_ref()), texts));
        }
    }
    let compared = programs.iter().map(|(old, new, texts)| Compared {
        old: texts.old.as_ref().map(|named| named.name.as_str()),
        new: texts.new.as_ref().map(|named| named.name.as_str()),
        comparison: compare(old, new),
    });
    let mut compared: Vec<Compared<'_>> = compared.filter(is_different).collect();
    let end = Instant::now() + TIME;
    for compared in &mut compared {
        let left = end.saturating_duration_since(Instant::now());
        compared.comparison.decide(left);
        if compared.old.is_some() && compared.new.is_some() {
            let (limits, networks) = arguments.limits();
            compared.comparison.decide_whole(limits, networks);
        }
    }
    if arguments.same {
        return Ok(same::print(&compared, &settings)?);
    }
    let mut out = Output::open(arguments.output.as_deref(), Existing::by(arguments.force))?;
    match arguments.format {
        Format::Text => write_text(&compared, &settings, &mut out)?,
        Format::Html => {
            let settings: Vec<(&str, &[String])> = settings
                .iter()
                .map(|diff| (diff.name(), &diff.lines[..]))
                .collect();
            write_escaped(&html::report(&compared, &settings), &mut out)?;
        }
        Format::Markdown => write_escaped(&markdown_of(&compared, &settings), &mut out)?,
        Format::Json => {
            let files = compared.iter().map(json::File::program);
            let files: Vec<_> = files.chain(settings.iter().map(json::File::settings)).collect();
            crate::json::to_writer_pretty(&mut out, &files)?;
            writeln!(out)?;
        }
    }
    out.finish()?;
    Ok(if compared.is_empty() && settings.is_empty() {
        Outcome::Fine
    } else {
        Outcome::Findings
    })
}

/// A file that is new or gone is a difference, whatever is in it.
fn is_different(compared: &Compared<'_>) -> bool {
    compared.comparison.differs() || compared.old.is_some() != compared.new.is_some()
}

/// Which files are compared with which.
fn pairs(old: Side, new: Side) -> Result<Vec<Pair>, Failure> {
    let pair = |old, new| Pair { old, new };
    match (old, new) {
        (Side::File(old), Side::File(new)) => Ok(vec![pair(Some(old), Some(new))]),
        (Side::Nothing, Side::File(new)) => Ok(vec![pair(None, Some(new))]),
        (Side::File(old), Side::Nothing) => Ok(vec![pair(Some(old), None)]),
        (Side::Nothing, Side::Nothing) => Ok(Vec::new()),
        (Side::Folder(mut old), Side::Folder(mut new)) => {
            let names: BTreeSet<String> = old.keys().chain(new.keys()).cloned().collect();
            Ok(names
                .iter()
                .map(|name| pair(old.remove(name), new.remove(name)))
                .collect())
        }
        _ => Err(Failure::new(
            "a file and a folder cannot be compared; name two files or two folders",
        )),
    }
}

/// The texts of two files. None: they hold the same bytes.
fn read(
    old: Option<&File>,
    new: Option<&File>,
    objects: &mut Option<Objects>,
) -> Result<Option<Texts>, Failure> {
    let mut bytes = |file: Option<&File>| file.map(|file| file.bytes(objects)).transpose();
    let (old_bytes, new_bytes) = (bytes(old)?, bytes(new)?);
    if old_bytes == new_bytes {
        return Ok(None);
    }
    let mut text = |file: Option<&File>, bytes: Option<Vec<u8>>| -> Result<_, Failure> {
        let Some((file, bytes)) = file.zip(bytes) else {
            return Ok(None);
        };
        Ok(Some(Named {
            name: file.name.clone(),
            text: file.text(bytes, objects)?,
        }))
    };
    Ok(Some(Texts {
        old: text(old, old_bytes)?,
        new: text(new, new_bytes)?,
    }))
}

fn outline(side: Option<&Named>) -> Outline {
    let (name, text) = side.map(Named::borrowed).unwrap_or_default();
    let parse = Arc::new(ladder_syntax::parse(text));
    Outline::new(Arc::new(context(&parse, name, &Others::alone())))
}

impl Named {
    fn borrowed(&self) -> (&str, &str) {
        (&self.name, &self.text)
    }
}

/// Writes a report. What turns the order of letters is written out in a file as well: a reader is to see what changed.
fn write_escaped(report: &str, out: &mut Output) -> std::io::Result<()> {
    out.write_all(shown::text(report).as_bytes())
}

fn markdown_of(compared: &[Compared<'_>], settings: &[SettingsDiff]) -> String {
    let mut out = if compared.is_empty() && !settings.is_empty() {
        String::new()
    } else {
        markdown::report(compared)
    };
    for diff in settings {
        out.push_str(&markdown::lines(diff.name(), &diff.lines));
    }
    out
}

const OLD: Style = AnsiColor::Red.on_default();
const NEW: Style = AnsiColor::Green.on_default();
const MOVED: Style = AnsiColor::Cyan.on_default();
const HEADING: Style = Style::new().bold();

fn write_text(compared: &[Compared<'_>], settings: &[SettingsDiff], out: &mut Output) -> Result<(), Failure> {
    let has_colours = !out.is_file() && stdout_has_colours();
    for (number, compared) in compared.iter().enumerate() {
        if number > 0 {
            writeln!(out)?;
        }
        for line in text::report(compared) {
            write_line(&line, has_colours, out)?;
        }
    }
    for (number, diff) in settings.iter().enumerate() {
        if number > 0 || !compared.is_empty() {
            writeln!(out)?;
        }
        for line in text::settings(diff.old.as_deref(), diff.new.as_deref(), &diff.lines) {
            write_line(&line, has_colours, out)?;
        }
    }
    Ok(())
}

/// Writes a line, with what a terminal would interpret escaped.
fn write_line(line: &Line, has_colours: bool, out: &mut Output) -> std::io::Result<()> {
    let style = match line.kind {
        LineKind::Old => OLD,
        LineKind::New => NEW,
        LineKind::Moved => MOVED,
        LineKind::File | LineKind::Heading => HEADING,
        LineKind::Marks | LineKind::Plain => Style::new(),
    };
    if !has_colours {
        return writeln!(out, "{}", shown::line(&line.text));
    }
    let mut at = 0;
    let mark = style.invert();
    for range in &line.marks {
        let (before, marked) = (&line.text[at..range.start], &line.text[range.clone()]);
        write!(out, "{style}{}{style:#}", shown::line(before))?;
        write!(out, "{mark}{}{mark:#}", shown::line(marked))?;
        at = range.end;
    }
    writeln!(out, "{style}{}{style:#}", shown::line(&line.text[at..]))
}
