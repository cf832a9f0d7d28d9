//! `ladder check -`: one text from stdin, as an editor or another program gives it.

use super::report::{Report, Target};
use super::{Arguments, check, exit_of, may_be_fixed};
use crate::findings::Source;
use crate::form::Form;
use crate::outcome::{Failure, Outcome};
use crate::stdin;
use crate::terminal::Stdout;
use ladder_workspace::{Workspace, is_scenario, is_scene};
use std::io::Write;
use std::path::Path;
use std::sync::Arc;

/// Checks the text. With `--fix` stdout has the fixed text, whether anything was fixed or not, and the findings that
/// are left go to stderr; with `--diff` it has what would change.
pub(super) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let given = arguments.stdin_filename.as_deref();
    let name = stdin::name_or_default(given);
    let bytes = stdin::read_bytes(name)?;
    let gives_text = arguments.fix && !arguments.diff;
    let target = if gives_text {
        Target::Stderr
    } else {
        Target::Stdout
    };
    let mut report = Report::new(arguments.format, arguments.statistics, target);
    if arguments.force_exclude && given.is_some_and(ladder_workspace::is_excluded) {
        if gives_text {
            print(&bytes)?;
        }
        report.finish()?;
        return Ok(Outcome::Fine);
    }
    let source = source(given, bytes, arguments)?;
    may_be_fixed(&source, arguments)?;
    let checked = check(source, arguments.task(), report.renderer());
    if gives_text {
        print(checked.source.text.as_bytes())?;
    }
    report.add(&checked)?;
    let (tally, _) = report.finish()?;
    Ok(checked.outcome().max(exit_of(&tally, arguments)))
}

/// A text with a name is a file of its workspace, as if it had been saved there. One without a name is alone, for
/// it may be one of the files around, and would then be there twice; only the settings of the current folder hold.
fn source(given: Option<&Path>, bytes: Vec<u8>, arguments: &Arguments) -> Result<Source, Failure> {
    let name = stdin::name_or_default(given);
    let workspace = match given {
        Some(name) if is_scenario(name) || is_scene(name) => {
            return Ok(Source::of_bytes(name, bytes, Some(Form::Ladder))?);
        }
        Some(name) => Workspace::of(name)?,
        None => Workspace::without_programs(name)?,
    };
    Ok(Source::of_bytes(name, bytes, arguments.form())?.within(Arc::new(workspace)))
}

fn print(text: &[u8]) -> Result<(), Failure> {
    let mut out = Stdout::new();
    out.write_all(text)?;
    out.flush()?;
    Ok(())
}
