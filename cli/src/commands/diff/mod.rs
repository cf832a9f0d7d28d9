//! `ladder diff`: what changed between two programs, network by network.

mod around;
mod json;
mod pairs;
mod read;
mod same;
mod settings;
mod side;

use crate::git::Git;
use crate::outcome::{Failure, Outcome};
use crate::output::{Existing, Output, may_write};
use crate::terminal::stdout_has_colours;
use anstyle::{AnsiColor, Style};
use clap::{Args, ValueEnum};
use ladder_analysis::Cancel;
use ladder_review::report::text::{Line, LineKind};
use ladder_review::report::{Compared, html, markdown, text};
use ladder_review::whole::Whole;
use ladder_review::{Limits, Outline, compare_renamed};
use ladder_workspace::{is_program, shown};
use pairs::pairs;
use read::{Program, Read};
use settings::SettingsDiff;
use side::Side;
use std::io::Write;
use std::path::{Path, PathBuf};
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
/// programs (.clad) and ladder.toml are compared; one with another name on each side is known by what it holds. A program that uses
/// others is compared with these as they are on each side. Files of other systems are read as ladder text.
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
    /// or does not matter. A tag that has another name is the same tag; inputs and outputs that have other names are said, and
    /// count as a difference. Otherwise they do if no run from a cold start on shows a difference; one that does is shown. What
    /// cannot be decided is said, and counts as a difference.
    #[arg(long, conflicts_with_all = ["format", "output"])]
    same: bool,

    /// Write the run that shows a difference to this file, as a scenario
    ///
    /// It says what the old program does. The file is in the folder of the new program, or of the old one, whose name it holds.
    #[arg(long, value_name = "FILE", requires = "same")]
    write: Option<PathBuf>,

    /// Compare both files as if each were at this path, among the files that are there
    ///
    /// For copies that stand elsewhere, as those of `git difftool`.
    #[arg(long, value_name = "PATH", conflicts_with = "write")]
    among: Option<PathBuf>,

    /// Show the values that tags of a controller held, too
    ///
    /// A program that was saved by a controller's system (L5X) has the value of each tag at that moment. Of tags that the program
    /// writes these are counted and not shown, and the programs are compared from the same values on.
    #[arg(long)]
    values: bool,

    /// How to show what changed
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,

    /// Write to this file instead of stdout
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Replace the output file even if no command of ladder made it
    #[arg(long)]
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

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    if let Some(file) = &arguments.write {
        if file == Path::new("-") {
            return Err(Failure::new("--write needs a file: stdout has the answer"));
        }
        may_write(file, Existing::by(arguments.force))?;
    }
    let git = Git::default();
    let side = |argument| Ok::<_, Failure>(Side::of(argument)?.named(arguments.among.as_deref()));
    let pairs = pairs(side(&arguments.old)?, side(&arguments.new)?, &git)?;
    let mut read = Read::new(arguments, &git);
    for pair in &pairs {
        read.add(pair)?;
    }
    let Read {
        programs, settings, ..
    } = read;
    let nothing = Outline::of_text("", "");
    let outline = |program| Option::map_or(program, &nothing, |program: &Program| &program.outline);
    let compared = programs.iter().map(|both| Compared {
        old: both.old.as_ref().map(|program| program.name.as_str()),
        new: both.new.as_ref().map(|program| program.name.as_str()),
        renamed: both.renamed,
        comparison: compare_renamed(
            outline(both.old.as_ref()),
            outline(both.new.as_ref()),
            both.renames.clone(),
        ),
    });
    let mut compared: Vec<Compared<'_>> = compared.filter(Compared::is_different).collect();
    // In a file of another system a value is what the tag held when the file was saved.
    let is_saved = |name: Option<&str>| name.is_some_and(|name| !is_program(Path::new(name)));
    for compared in compared.iter_mut().filter(|_| !arguments.values) {
        if is_saved(compared.old) && is_saved(compared.new) {
            compared.comparison.fold_values();
        }
    }
    let end = Instant::now() + TIME;
    for compared in &mut compared {
        let left = || end.saturating_duration_since(Instant::now());
        compared.comparison.decide(left(), &Cancel::default());
        if compared.old.is_some() && compared.new.is_some() {
            let (mut limits, networks) = arguments.limits();
            if !arguments.same {
                limits.time = limits.time.min(left());
            }
            compared.comparison.decide_whole(limits, networks);
        }
    }
    let refuted = |compared: &Compared<'_>| compared.comparison.whole == Some(Whole::Refuted);
    let outcome = match &compared[..] {
        all if all.iter().any(refuted) => Outcome::Failed,
        [] if settings.is_empty() => Outcome::Fine,
        _ => Outcome::Findings,
    };
    if arguments.same {
        let told = same::print(&compared, &settings)?;
        if let Some(file) = &arguments.write {
            same::write(file, &compared)?;
        }
        return Ok(if outcome == Outcome::Failed { outcome } else { told });
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
    Ok(outcome)
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
