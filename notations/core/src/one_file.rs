//! A whole project in one file, out of the files of a folder.

use crate::{
    Companion, Converted, Entry, LineColumn, Lines, Notation, Project, ProjectTask, Report, Source,
    WriteError, convert,
};
use ladder_analysis::{Analysis, Severity};
use ladder_format::program::Item;
use std::collections::{BTreeMap, HashMap};
use std::path::Path;
use std::sync::Arc;

/// The file that the files of a folder come from.
#[derive(Debug)]
pub struct Kept<'k> {
    /// The file.
    pub source: &'k Source<'k>,
    /// What is read of it: the files as they were.
    pub before: &'k Project,
}

/// A project as a notation writes it.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct WrittenProject {
    /// The file.
    pub bytes: Vec<u8>,
    /// What became of the elements, a report for each file of the project.
    pub reports: Vec<Report>,
}

/// A project in one file.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct OneFile {
    /// The file.
    pub bytes: Vec<u8>,
    /// What became of the elements, by the files of the folder, whose places these are.
    pub reports: Vec<(String, Report)>,
}

/// Writes the files of a folder, each with its name and its text, as one file, whose name has this stem. `tasks`: what runs them; none:
/// what runs those of the original, else one task. `original`: the file that they come from. What is written is read again: an error in that is refused in the report.
///
/// # Errors
///
/// As [`Notation::write_project`]; if files have errors or cannot be one program, and if the original cannot be read.
pub fn write_one_file(
    notation: &'static dyn Notation,
    files: &[(String, String)],
    tasks: &[ProjectTask],
    stem: &str,
    original: Option<&Source<'_>>,
) -> Result<OneFile, WriteError> {
    let Some(source) = original else {
        let mut project = project_of(notation, files, tasks)?;
        Arc::make_mut(&mut project.analysis.context).name = stem.into();
        let mut writing = notation.write_project(&project, None)?;
        refuse_errors(notation, &mut writing, stem, None);
        return Ok(by_file(&project, writing));
    };
    let wrong = |why: String| WriteError::new(format!("the file that the programs come from: {why}"));
    let before = convert(notation, source, &ladder_format::Options::default())
        .map_err(|error| wrong(error.to_string()))?;
    let read = files_of(&before, files);
    let mut known = before.tasks.clone();
    known.sort_by_key(|task| task.priority);
    let tasks = if tasks.is_empty() { &known } else { tasks };
    if is_same(&read, files) && known == tasks {
        return Ok(OneFile {
            bytes: source.bytes.to_vec(),
            reports: Vec::new(),
        });
    }
    let was = project_of(notation, &read, &known).map_err(|error| wrong(error.message))?;
    let project = project_of(notation, files, tasks)?;
    let kept = Kept { source, before: &was };
    let mut writing = notation.write_project(&project, Some(&kept))?;
    refuse_errors(notation, &mut writing, stem, Some(&before));
    Ok(by_file(&project, writing))
}

/// The project of the files of a folder, of which some are not ladder text.
fn project_of(
    notation: &dyn Notation,
    files: &[(String, String)],
    tasks: &[ProjectTask],
) -> Result<Project, WriteError> {
    let all = files.iter().map(|(name, text)| Companion {
        name: name.clone(),
        bytes: text.clone().into(),
    });
    let all: Vec<Companion> = all.collect();
    let ladder = files.iter().map(|(name, text)| {
        let ladder = if is_ladder_text(name) {
            text.clone()
        } else {
            in_ladder(notation, name, text, &all)?
        };
        Ok((name.clone(), ladder))
    });
    let ladder = ladder.collect::<Result<Vec<_>, WriteError>>()?;
    let mut project = Project::of(&ladder, tasks)?;
    project.keep_written(files);
    Ok(project)
}

/// What others see of a file that is not ladder text, and what of it runs: blocks without their networks, which are written as the file
/// has them.
fn in_ladder(
    notation: &dyn Notation,
    name: &str,
    text: &str,
    all: &[Companion],
) -> Result<String, WriteError> {
    let source = Source {
        name: name.into(),
        bytes: text.as_bytes(),
        companions: all.iter().filter(|other| other.name != name).cloned().collect(),
    };
    let Some(texts) = notation.texts() else {
        return Err(WriteError::new(format!(
            "{name}: only ladder text is written there"
        )));
    };
    let at = |place: LineColumn, why: &str| WriteError::new(format!("{name}:{place}: {why}"));
    let mut reading = texts
        .read(&source)
        .map_err(|error| at(error.place.unwrap_or(LineColumn::START), &error.message))?;
    let mut found = reading.findings.iter();
    if let Some(error) = found.find(|found| found.severity == Severity::Error) {
        return Err(at(error.place, &error.message));
    }
    for item in &mut reading.program.items {
        if let Item::Block { items, .. } = item {
            items.retain(|item| matches!(item, Item::Section(_)));
        }
    }
    Ok(reading.program.write(&ladder_format::Options::default()).text)
}

fn is_ladder_text(name: &str) -> bool {
    Path::new(name).extension().is_some_and(|end| end == "clad")
}

/// The files of a folder that a conversion writes. One alone is called as the one that is there.
fn files_of(converted: &Converted, now: &[(String, String)]) -> Vec<(String, String)> {
    let is_program = |file: &&Companion| Path::new(&file.name).extension().is_some_and(|end| end != "toml");
    let programs = converted.files.iter().filter(is_program);
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    let files: Vec<(String, String)> = programs
        .map(|file| (file.name.clone(), text(&file.bytes)))
        .collect();
    if !files.is_empty() {
        return files;
    }
    let name = match now {
        [(name, _)] => name.clone(),
        _ => "project.clad".to_owned(),
    };
    vec![(name, converted.written.text.clone())]
}

fn is_same(before: &[(String, String)], now: &[(String, String)]) -> bool {
    let sorted = |files: &[(String, String)]| -> BTreeMap<String, String> { files.iter().cloned().collect() };
    before.len() == now.len() && sorted(before) == sorted(now)
}

fn by_file(project: &Project, writing: WrittenProject) -> OneFile {
    let reports = writing.reports.into_iter().enumerate();
    OneFile {
        bytes: writing.bytes,
        reports: reports
            .map(|(number, report)| (project.file(number).to_owned(), report))
            .collect(),
    }
}

/// Reads what is written, and refuses what has an error there that it did not have before.
fn refuse_errors(
    notation: &'static dyn Notation,
    writing: &mut WrittenProject,
    stem: &str,
    before: Option<&Converted>,
) {
    let Some(report) = writing.reports.first_mut().filter(|_| notation.is_read()) else {
        return;
    };
    let source = Source::alone(stem, &writing.bytes);
    let again = match convert(notation, &source, &ladder_format::Options::default()) {
        Ok(again) => again,
        Err(error) => {
            let why = format!("what is written cannot be read again: {error}");
            report.refused(LineColumn::START, notation.title(), why);
            return;
        }
    };
    let mut known: HashMap<String, usize> = HashMap::new();
    for (_, message) in before.into_iter().flat_map(|before| errors(before, stem)) {
        *known.entry(message).or_default() += 1;
    }
    for (place, message) in errors(&again, stem) {
        match known.get_mut(&message) {
            Some(count) if *count > 0 => *count -= 1,
            _ => {
                let why = format!("at {place} of what is written: {message}");
                report.refused(LineColumn::START, notation.title(), why);
            }
        }
    }
}

/// The errors in the ladder text of a file, with the places in that.
fn errors(converted: &Converted, stem: &str) -> Vec<(LineColumn, String)> {
    let text = &converted.written.text;
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), stem);
    let errors = analysis.errors();
    errors
        .map(|error| (converted.place_of(error.range.start()), error.message.clone()))
        .collect()
}

/// Takes out of a report what was to be said of the program as it was: that is as it was there.
pub fn without_known(report: &mut Report, of: &Analysis, known: &Report, before: &Analysis) {
    let line = |text: &str, lines: &Lines, entry: &Entry| {
        let start = lines.offset(
            text,
            LineColumn {
                line: entry.place.line,
                column: 1,
            },
        );
        text[start..].lines().next().unwrap_or_default().trim().to_owned()
    };
    let key = |text: &str, lines: &Lines, entry: &Entry| {
        (
            entry.element.clone(),
            entry.outcome.clone(),
            line(text, lines, entry),
        )
    };
    let [now, was] = [of, before].map(|analysis| analysis.context.parse.to_string());
    let [lines_now, lines_was] = [&now, &was].map(|text| Lines::of(text));
    let mut all = Vec::new();
    for entry in &known.entries {
        all.push(key(&was, &lines_was, entry));
    }
    report.entries.retain(|entry| {
        let key = key(&now, &lines_now, entry);
        match all.iter().position(|known| *known == key) {
            Some(at) => {
                all.swap_remove(at);
                false
            }
            None => true,
        }
    });
}
