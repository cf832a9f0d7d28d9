//! The programs of a folder as one file of another system.

use super::report::{Account, Side};
use super::{finish, open};
use crate::findings::FOREIGN;
use crate::form::{self, Form};
use crate::outcome::{Failure, Outcome};
use crate::output::Existing;
use crate::terminal;
use ladder_notations::{
    LineColumn, Notation, ProjectTask, Report, Source, of_workspaces, recognise, write_one_file,
};
use ladder_workspace::{Named, Settings, find_ladder_text, find_programs, read_bytes, shown};
use std::path::{Path, PathBuf};

/// A folder, and the file that its programs go into.
pub(super) struct Target<'a> {
    folder: &'a Path,
    output: &'a Path,
    notation: &'static dyn Notation,
    /// The file that the programs come from, if it is named.
    keep: Option<&'a Path>,
}

impl<'a> Target<'a> {
    /// One folder is to become one file: the output is called as files of a notation whose files hold whole projects.
    ///
    /// # Errors
    ///
    /// A file is named that the programs come from, and they do not become one file.
    pub(super) fn of(
        inputs: &'a [PathBuf],
        output: Option<&'a Path>,
        from: Option<Form>,
        to: Option<Form>,
        keep: Option<&'a Path>,
    ) -> Result<Option<Target<'a>>, Failure> {
        let found = match (inputs, output) {
            ([folder], Some(output)) if folder.is_dir() && from.is_none_or(Form::is_ladder) => {
                notation_of(output, to).map(|notation| Target {
                    folder,
                    output,
                    notation,
                    keep,
                })
            }
            _ => None,
        };
        match (found, keep) {
            (None, Some(keep)) => Err(Failure::new(format!(
                "--keep {}: this is the file that the programs of one folder come from, which become one file again: name the folder, and \
                 with -o a file of a notation that holds whole projects, as `-o project.L5X`",
                shown::path(keep)
            ))),
            (found, _) => Ok(found),
        }
    }

    /// Writes the file.
    pub(super) fn convert(&self, existing: Existing) -> Result<(Vec<Account>, Outcome), Failure> {
        let folder = [self.folder.to_owned()];
        let (paths, errors) = match self.notation.texts() {
            Some(_) => find_programs(&folder),
            None => find_ladder_text(&folder),
        };
        if let Some(error) = errors.into_iter().next() {
            return Err(error.into());
        }
        if paths.is_empty() {
            return Err(Failure::new(format!(
                "{}: there are no programs in this folder",
                shown::path(self.folder)
            )));
        }
        let mut files = Vec::with_capacity(paths.len());
        for path in &paths {
            let text = ladder_workspace::decode(path, read_bytes(path)?)?;
            let below = path.strip_prefix(self.folder).unwrap_or(path);
            files.push((name_in(below), text));
        }
        let tasks = self.tasks(&paths[0], &files)?;
        let kept = self.original()?;
        let source = match &kept {
            Some((path, bytes)) => Some(self.source(path, bytes)?),
            None => None,
        };
        let stem = self.output.file_stem().unwrap_or_default().to_string_lossy();
        let written =
            write_one_file(self.notation, &files, &tasks, &stem, source.as_ref()).map_err(|error| {
                Failure::new(format!(
                    "{}: this cannot be written as one {}: {error}",
                    shown::path(self.folder),
                    self.notation.title()
                ))
            })?;
        finish(Vec::from_iter(open(Some(self.output), &written.bytes, existing)?))?;
        if let (Some((kept, _)), true) = (&kept, written.reports.is_empty()) {
            terminal::note(&format!(
                "{}: nothing was changed since it was read from {}",
                shown::path(self.folder),
                shown::path(kept)
            ));
        }
        let mut outcome = Outcome::Fine;
        let told = written
            .reports
            .into_iter()
            .filter(|(_, report)| !report.entries.is_empty());
        let told = told.map(|(file, report)| (self.folder.join(file), report));
        let accounts = told.chain(self.left_out()).map(|(path, report)| {
            let mut account = Account::new(shown::path(&path));
            account.add(Side::Source, &report, &[]);
            outcome = outcome.max(account.outcome());
            account
        });
        let accounts = accounts.collect();
        Ok((accounts, outcome))
    }

    /// The programs of the folder that are not ladder text: they are not written into the file.
    fn left_out(&self) -> impl Iterator<Item = (PathBuf, Report)> {
        let (paths, _) = find_programs(std::slice::from_ref(&self.folder.to_owned()));
        let is_written = |path: &PathBuf| {
            self.notation
                .texts()
                .is_some_and(|texts| of_workspaces(path) == Some(texts))
        };
        let left_out: Vec<PathBuf> = paths.into_iter().filter(|path| !is_written(path)).collect();
        left_out.into_iter().filter_map(|path| {
            let mut report = Report::default();
            let why = format!(
                "only ladder text is written there ({}): bring this file there by hand",
                self.notation.title()
            );
            report.refused(LineColumn::START, of_workspaces(&path)?.title(), why);
            Some((path, report))
        })
    }

    /// The tasks of the settings that run programs of the folder, which are these files. `program`: one of them.
    fn tasks(&self, program: &Path, files: &[(String, String)]) -> Result<Vec<ProjectTask>, Failure> {
        let folder = self
            .folder
            .canonicalize()
            .unwrap_or_else(|_| self.folder.to_owned());
        let settings = Settings::of(program)?;
        let mut tasks = Vec::new();
        for task in settings.simulate.tasks {
            let (mut programs, mut outside) = (Vec::new(), None);
            for (program, _) in &task.programs {
                let path = program.locate()?;
                match path.strip_prefix(&folder) {
                    Ok(below) if files.iter().any(|(name, _)| *name == name_in(below)) => {
                        programs.push(name_in(below));
                    }
                    Ok(below) => {
                        return Err(Failure::new(format!(
                            "{}: task {} runs {}, which is not among the programs of this folder",
                            shown::path(self.folder),
                            task.name,
                            shown::path(below)
                        )));
                    }
                    Err(_) => outside = Some(program.path()),
                }
            }
            match outside {
                Some(path) if !programs.is_empty() => {
                    return Err(Failure::new(format!(
                        "{}: task {} runs {}, too, which is not in this folder: name the folder that all its programs are in",
                        shown::path(self.folder),
                        task.name,
                        shown::path(&path)
                    )));
                }
                Some(_) => {}
                None => tasks.push(ProjectTask {
                    name: task.name,
                    interval: task.interval,
                    priority: task.priority,
                    programs,
                }),
            }
        }
        Ok(tasks)
    }

    /// The file that the programs come from, and its content: the one that is named, else the one of the notation that is in the folder.
    /// What a link there leads to outside of the folder is not read.
    fn original(&self) -> Result<Option<(PathBuf, Vec<u8>)>, Failure> {
        if let Some(named) = self.keep {
            return Ok(Some((named.to_owned(), read_bytes(named)?)));
        }
        let entries = std::fs::read_dir(self.folder).into_iter().flatten().flatten();
        let read = |path: PathBuf| {
            form::by_extension(&path).filter(|form| !form.is_ladder())?;
            let name = path.file_name()?.to_str()?;
            let bytes = Named::in_settings(self.folder, name).read_bytes().ok()?;
            (recognise(&path, &bytes) == Some(self.notation)).then_some((path, bytes))
        };
        let mut found: Vec<(PathBuf, Vec<u8>)> = entries.filter_map(|entry| read(entry.path())).collect();
        found.sort();
        match &found[..] {
            [] | [_] => Ok(found.pop()),
            [(one, _), (other, _), ..] => Err(Failure::new(format!(
                "{}: its programs may come from {} or from {}: name the one that they come from with --keep",
                shown::path(self.folder),
                shown::path(one),
                shown::path(other)
            ))),
        }
    }

    fn source<'s>(&self, path: &'s Path, bytes: &'s [u8]) -> Result<Source<'s>, Failure> {
        if recognise(path, bytes) != Some(self.notation) {
            return Err(Failure::new(format!(
                "{}: its notation is not \"{}\", so what is written cannot be kept as it is there; name the file that the programs come from",
                shown::path(path),
                self.notation.title()
            )));
        }
        Ok(FOREIGN.source(self.notation, path, bytes)?)
    }
}

/// What a file is called in its folder.
fn name_in(below: &Path) -> String {
    let parts: Vec<_> = below.iter().map(|part| part.to_string_lossy()).collect();
    parts.join("/")
}

/// The notation of a file that is to hold a whole project.
fn notation_of(output: &Path, to: Option<Form>) -> Option<&'static dyn Notation> {
    if output.is_dir() || output.as_os_str().as_encoded_bytes().ends_with(b"/") {
        return None;
    }
    let named = form::by_extension(output)?;
    let Form::Foreign(notation) = to.unwrap_or(named) else {
        return None;
    };
    let extension = output.extension()?.to_str()?;
    (notation.has_projects() && ladder_notations::has_extension(notation, extension)).then_some(notation)
}
