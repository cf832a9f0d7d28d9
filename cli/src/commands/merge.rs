//! `ladder merge`: what two sides made of a program, as one.

use crate::findings::{Source, concise};
use crate::form::{self, Form};
use crate::outcome::{Failure, Outcome};
use crate::output::{Existing, Output};
use crate::terminal;
use clap::Args;
use ladder_analysis::{Diagnostic, Severity};
use ladder_review::{Outline, Sides, merge};
use ladder_workspace::{Workspace, shown};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

const EXAMPLES: &str = "\
Examples:
  ladder merge base.clad mine.clad yours.clad -o both.clad
  ladder merge base.clad mine.clad yours.clad -o -     show it
  ladder git install                                   let git merge so

Exit status: 0 merged, 1 both sides changed the same, or errors came of it that neither side has,
2 a file cannot be read or merged: nothing is written.";

/// Merge what two sides made of a program
///
/// Networks and declarations are merged, not lines: what one side alone changed is as that side has it, wherever the other
/// side put it. What both changed is drawn in both forms between the comments `# <<<<<<< ours #` and `# >>>>>>> theirs #`.
/// What one side renamed has its new name in what the other side wrote. The result is laid out and checked. Without -o it
/// replaces OURS, as git wants it of `ladder merge %O %A %B`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The program that both sides began with
    base: PathBuf,

    /// One side
    ours: PathBuf,

    /// The other side
    theirs: PathBuf,

    /// Write to this file instead of OURS; `-` is stdout
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Replace the file that -o names even if no command of ladder made it
    #[arg(long, requires = "output")]
    force: bool,

    /// The path that the program has in the repository: its settings hold, and messages name it
    #[arg(long, value_name = "PATH")]
    path: Option<PathBuf>,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let name = arguments.path.as_deref().unwrap_or(&arguments.ours);
    let texts = [&arguments.base, &arguments.ours, &arguments.theirs].map(|file| read(file));
    let [base, ours, theirs] = texts;
    let (base, ours, theirs) = (base?, ours?, theirs?);
    let workspace = Arc::new(Workspace::of(name)?);
    let [base_outline, ours_outline, theirs_outline] =
        [&base, &ours, &theirs].map(|text| Outline::of_text("", text));
    let sides = Sides {
        base: &base_outline,
        ours: &ours_outline,
        theirs: &theirs_outline,
    };
    let merged = merge(sides).map_err(|error| Failure::new(format!("{}: {error}", shown::path(name))))?;
    let text = ladder_format::format_text(&merged.text, &workspace.settings().format);
    match arguments.output.as_deref() {
        Some(file) => {
            let mut out = Output::open(Some(file), Existing::by(arguments.force))?;
            out.write_text(&text)?;
            out.finish()?;
        }
        None => ladder_workspace::write(&arguments.ours, text.as_bytes())?,
    }
    for conflict in &merged.conflicts {
        terminal::warning(&format_args!("{}: {conflict}", shown::path(name)));
    }
    for refused in &merged.refused {
        terminal::warning(&format_args!("{}: {refused}; name it by hand", shown::path(name)));
    }
    if !merged.conflicts.is_empty() {
        return Ok(Outcome::Findings);
    }
    let has_all_names = merged.refused.is_empty();
    let source =
        |text: &str| Source::new(name.display().to_string(), text.to_owned()).within(Arc::clone(&workspace));
    let merged = source(&text);
    let new = new_errors(&merged, &[source(&ours), source(&theirs)]);
    for error in &new {
        terminal::plain(&concise::line(&merged, error));
    }
    Ok(if new.is_empty() && has_all_names {
        Outcome::Fine
    } else {
        Outcome::Findings
    })
}

fn read(file: &Path) -> Result<String, Failure> {
    let bytes = ladder_workspace::read_bytes(file)?;
    if let Ok(Form::Foreign(notation)) = form::of_program(file, &bytes) {
        return Err(Failure::new(format!(
            "{}: this is {}; only ladder text is merged",
            shown::path(file),
            notation.title()
        )));
    }
    Ok(ladder_workspace::decode(file, bytes)?)
}

/// The rule about names without a declaration.
const UNDECLARED_TAG: &str = "undeclared-tag";

/// The errors of a text, and the names of which one side has removed the declaration.
fn broken(source: &Source) -> Vec<Diagnostic> {
    let mut found = source.findings();
    found.retain(|finding| finding.severity == Severity::Error || finding.rule.name() == UNDECLARED_TAG);
    found
}

/// The errors of a text that none of the sides has: as many of each sentence as are more.
fn new_errors(merged: &Source, sides: &[Source]) -> Vec<Diagnostic> {
    let mut known: HashMap<String, usize> = HashMap::new();
    for side in sides {
        let mut own: HashMap<String, usize> = HashMap::new();
        for error in broken(side) {
            *own.entry(error.message.clone()).or_default() += 1;
        }
        for (message, count) in own {
            let most = known.entry(message).or_default();
            *most = count.max(*most);
        }
    }
    let mut errors = broken(merged);
    errors.retain(|error| match known.get_mut(&error.message) {
        Some(count) if *count > 0 => {
            *count -= 1;
            false
        }
        _ => true,
    });
    errors
}
