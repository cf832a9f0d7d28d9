//! `ladder convert`: programs from and to the notations of other systems.

mod one_file;
mod report;
mod target;

use crate::findings::{FOREIGN, Source};
use crate::form::{self, Form};
use crate::outcome::{Failure, Outcome};
use crate::output::{Existing, Output};
use crate::terminal;
use clap::Args;
use ladder_analysis::Analysis;
use ladder_notations::{Companion, Foreign, Notation, write_checked};
use ladder_workspace::shown;
use one_file::Target;
use report::{Account, Side};
use std::io::Write;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;
use target::{Job, jobs};

const EXAMPLES: &str = "\
Examples:
  ladder convert rung.txt                     show a program as ladder text
  ladder convert old.cplc -o motor.clad       write it to a file
  ladder convert motor.clad --to textbook     the other way round
  ladder convert plant/ -o converted/         all programs of a folder
  ladder convert project.xml -o plant/        a project as the files of a workspace
  ladder convert plant/ -o project.xml        the other way round: one file
  ladder convert old.cplc --report json -o motor.clad
                                              what became of each element

The notation of a file is found by its content; --from names it where that is
not enough. Nothing is dropped silently: what has no counterpart stays as a
comment at its place, and stderr says so.

Exit status: 0 fine, 1 something has no counterpart or the program has errors,
2 a file cannot be read or written.";

/// Translate programs from and to other notations
///
/// Programs of other systems become ladder text with their names, comments and arithmetic kept, and the other way
/// round.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Programs, or folders to search for them
    #[arg(value_name = "IN", required = true)]
    inputs: Vec<PathBuf>,

    /// Write to this file, or into this folder if there are several programs; without it to stdout
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,

    /// The notation of the programs; without it their content decides
    #[arg(long, value_name = "NOTATION", value_parser = form::names())]
    from: Option<String>,

    /// The notation to write; without it the name of the output decides, else ladder text is written
    #[arg(long, value_name = "NOTATION", value_parser = form::targets())]
    to: Option<String>,

    /// The file that the programs of a folder come from: what is not changed stays as it is there, to the letter. Without it
    /// the one in the folder
    #[arg(long, value_name = "ORIGINAL")]
    keep: Option<PathBuf>,

    /// Say what became of each element: `json` on stderr, or in this file, as JSON or Markdown if it is called .json or .md
    #[arg(long, value_name = "FORM|FILE")]
    report: Option<PathBuf>,

    /// Replace files that no command of ladder made
    #[arg(long)]
    force: bool,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let from = arguments.from.as_deref().map(form::named);
    let to = arguments.to.as_deref().map(form::named);
    let existing = Existing::by(arguments.force);
    let output = arguments.output.as_deref();
    let (accounts, outcome) =
        match Target::of(&arguments.inputs, output, from, to, arguments.keep.as_deref())? {
            Some(target) => target.convert(existing)?,
            None => one_by_one(&arguments.inputs, output, from, to, existing)?,
        };
    match arguments.report.as_deref() {
        None => report::people(&accounts),
        Some(form) if form == Path::new("json") => report::json(&accounts)?,
        Some(file) => {
            report::people(&accounts);
            if !accounts.is_empty() {
                report::file(&accounts, file, Existing::by(arguments.force))?;
            }
        }
    }
    Ok(outcome)
}

/// Translates each program, and writes it.
fn one_by_one(
    inputs: &[PathBuf],
    output: Option<&Path>,
    from: Option<Form>,
    to: Option<Form>,
    existing: Existing,
) -> Result<(Vec<Account>, Outcome), Failure> {
    let (jobs, mut outcome) = jobs(inputs, output, from, to)?;
    let mut accounts = Vec::new();
    for job in &jobs {
        match convert(job, existing) {
            Ok((account, found)) => {
                outcome = outcome.max(found);
                accounts.push(account);
            }
            Err(failure) => {
                failure.show();
                outcome = outcome.max(Outcome::Failed);
            }
        }
    }
    Ok((accounts, outcome))
}

/// Translates one program, and writes it.
fn convert(job: &Job, existing: Existing) -> Result<(Account, Outcome), Failure> {
    let name = shown::path(&job.input);
    let mut account = Account::new(name.clone());
    let mut files = Vec::new();
    let ladder = match job.from {
        Form::Ladder => {
            let text = ladder_workspace::decode(&job.input, job.bytes.clone())?;
            Source::new(job.input.display().to_string(), text).in_workspace()?
        }
        Form::Foreign(notation) => {
            let foreign = read(notation, job)?;
            let ladder = Source::new(job.input.display().to_string(), foreign.ladder().to_owned());
            let ladder = ladder.in_workspace()?;
            if job.to.is_ladder() && job.folder.is_some() {
                files.clone_from(&foreign.converted().files);
            }
            let analysis = ladder.analyze();
            let report = if files.is_empty() {
                foreign.report(analysis.errors())
            } else {
                foreign.report_of_files(analysis.errors())
            };
            account.add(Side::Source, &report, &foreign.converted().findings);
            ladder
        }
    };
    if let (Some(folder), false) = (&job.folder, files.is_empty()) {
        make_folder(folder, &job.root)?;
        files.extend(job.original());
        write_project(folder, &files, existing)?;
        let outcome = account.outcome();
        return Ok((account, outcome));
    }
    let (bytes, next_to) = match job.to {
        Form::Ladder => (ladder.text.into_bytes(), Vec::from_iter(job.original())),
        Form::Foreign(notation) => {
            let file = job.output.as_deref().unwrap_or(&job.input);
            let stem = file.file_stem().unwrap_or_default().to_string_lossy();
            let writing =
                write_checked(notation, &written_of(&ladder, notation), &stem).map_err(|error| {
                    Failure::new(format!(
                        "{name}: this cannot be written as {}: {error}",
                        notation.title()
                    ))
                })?;
            let side = match job.from {
                Form::Ladder => Side::Source,
                Form::Foreign(_) => Side::Between,
            };
            account.add(side, &writing.report, &[]);
            (writing.bytes, writing.companions)
        }
    };
    if let (Some(folder), Some(_)) = (job.output.as_deref().and_then(Path::parent), &job.folder) {
        make_folder(folder, &job.root)?;
    }
    write(job.output.as_deref(), &bytes, &next_to, existing)?;
    let outcome = account.outcome();
    Ok((account, outcome))
}

/// What a notation writes of a program: with what it uses of other files, if the notation can say that.
fn written_of(ladder: &Source, notation: &dyn Notation) -> Arc<Analysis> {
    let analysis = ladder.analyze();
    match ladder.linked() {
        Ok(linked) if notation.writes_other_files() => Arc::new(analysis.with_others(linked)),
        _ => analysis,
    }
}

/// Writes a program and what belongs next to it. Nothing is written if one of them may not be.
fn write(
    output: Option<&Path>,
    bytes: &[u8],
    next_to: &[Companion],
    existing: Existing,
) -> Result<(), Failure> {
    let mut files = Vec::from_iter(open(output, bytes, existing)?);
    for companion in next_to {
        let Some(output) = output else {
            let name = shown::line(&companion.name);
            terminal::note(&format!(
                "{name} belongs next to this program; with -o it is written there"
            ));
            continue;
        };
        let path = output.with_file_name(&companion.name);
        if path == output {
            return Err(Failure::new(format!(
                "{}: what belongs next to this program is called so; name the program otherwise",
                shown::path(&path)
            )));
        }
        if let (Some(folder), Some(root)) = (path.parent(), output.parent()) {
            make_folder(folder, root)?;
        }
        files.extend(open(Some(&path), &companion.bytes, existing)?);
    }
    finish(files)
}

/// Writes the files of a project into a folder. Nothing is written if one of them may not be.
fn write_project(folder: &Path, files: &[Companion], existing: Existing) -> Result<(), Failure> {
    let mut opened = Vec::new();
    for file in files {
        let mut parts = Path::new(&file.name).components();
        if !parts.all(|part| matches!(part, Component::Normal(_))) {
            let name = shown::line(&file.name);
            return Err(Failure::new(format!(
                "{name}: a file of this name would not be in {}",
                shown::path(folder)
            )));
        }
        let path = folder.join(&file.name);
        make_folder(path.parent().unwrap_or(folder), folder)?;
        opened.extend(open(Some(&path), &file.bytes, existing)?);
    }
    finish(opened)
}

/// A file that is to have these bytes. None: it has them, so that two programs may bring the same block, and a second run is no
/// error.
fn open<'b>(
    output: Option<&Path>,
    bytes: &'b [u8],
    existing: Existing,
) -> Result<Option<(Output, &'b [u8])>, Failure> {
    let has_as_many = |file: &Path| {
        let there = file.symlink_metadata();
        there.is_ok_and(|there| there.is_file() && there.len() == bytes.len() as u64)
    };
    let has_them = |file: &Path| has_as_many(file) && std::fs::read(file).is_ok_and(|there| there == bytes);
    if output.is_some_and(has_them) {
        return Ok(None);
    }
    Ok(Some((Output::open(output, existing)?, bytes)))
}

/// Makes a folder, and those that it is in. Of those inside of `root` none is a link: nothing is made elsewhere.
fn make_folder(folder: &Path, root: &Path) -> Result<(), Failure> {
    let mut inner = folder.ancestors().take_while(|inner| *inner != root);
    let is_link = |inner: &&Path| inner.symlink_metadata().is_ok_and(|found| found.is_symlink());
    if let Some(link) = inner.find(is_link) {
        return Err(Failure::new(format!(
            "{}: this is a link, and nothing is written through it; remove it, or name another folder with -o",
            shown::path(link)
        )));
    }
    if folder == Path::new("") {
        return Ok(());
    }
    std::fs::create_dir_all(folder).map_err(|error| {
        let why = match error.kind() {
            std::io::ErrorKind::AlreadyExists | std::io::ErrorKind::NotADirectory => {
                "a file is there; name another folder".to_owned()
            }
            _ => error.to_string(),
        };
        let folder = shown::path(folder);
        Failure::new(format!("{folder}: the folder cannot be made: {why}"))
    })
}

fn finish(mut files: Vec<(Output, &[u8])>) -> Result<(), Failure> {
    for (file, bytes) in &mut files {
        match std::str::from_utf8(bytes) {
            Ok(text) if file.is_on_screen() => file.write_text(text)?,
            // `> y.clad` gets what `-o y.clad` does.
            _ => file.write_all(bytes)?,
        }
    }
    for (file, _) in files {
        file.finish()?;
    }
    Ok(())
}

fn read(notation: &'static dyn Notation, job: &Job) -> Result<Foreign, Failure> {
    let source = FOREIGN.source(notation, &job.input, &job.bytes)?;
    Foreign::read(notation, &source).map_err(|error| Failure::broken(&job.input, &error))
}
