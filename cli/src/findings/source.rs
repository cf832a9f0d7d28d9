//! A program's text, and the places in it as people count them.
//!
//! Every file that a command takes for a program comes in here. One of another system has two texts: that of the file,
//! which is shown and which findings have their places in, and the ladder text that it becomes, which is analysed and
//! run.

use crate::form::{self, Form};
use crate::outcome::Failure;
use ladder_analysis::program::{Location, Program};
use ladder_analysis::{
    Analysis, Connect, Diagnostic, Linked, NotWhole, PlantError, PlantFile, library, link_with_plants,
};
use ladder_notations::{Foreign, Mark, ReadError, conversion_of_cplc_draft};
use ladder_syntax::{LineColumn, LineIndex, TextRange, TextSize};
use ladder_workspace::{ForeignPrograms, Member, Plan, SETTINGS_FILE, Workspace, shown};
use std::borrow::Cow;
use std::path::Path;
use std::sync::{Arc, LazyLock, OnceLock};

/// The programs of other systems that this run of a command reads.
pub(crate) static FOREIGN: LazyLock<ForeignPrograms> = LazyLock::new(ForeignPrograms::default);

/// Whether a file is that of a workspace's settings, whose tasks are a program.
pub(crate) fn is_settings(file: &Path) -> bool {
    file.file_name().is_some_and(|name| name == SETTINGS_FILE)
}

/// A text that was checked.
pub(crate) struct Source {
    /// The file as it was named.
    pub(crate) file: String,
    /// The ladder text: that of the file byte for byte, or what a program of another system becomes.
    pub(crate) text: String,
    /// The file, if it is of another system.
    foreign: Option<Arc<Foreign>>,
    /// The lines of the file.
    index: LineIndex,
    /// The workspace around the file, once it is needed. None: there is none that can be used.
    workspace: OnceLock<Option<Arc<Workspace>>>,
    /// Whether it is a settings file, whose tasks the text runs.
    has_tasks: bool,
    /// The models of its machine that run beside it, each with its name, and what is connected.
    plants: (Vec<(Source, String)>, Vec<Connect>),
    analysis: OnceLock<Arc<Analysis>>,
    linked: OnceLock<Result<(Linked, Vec<PlantError>), NotWhole>>,
}

impl Source {
    pub(crate) fn new(file: String, text: String) -> Source {
        let index = LineIndex::new(&text);
        Source {
            file,
            text,
            foreign: None,
            index,
            workspace: OnceLock::new(),
            has_tasks: false,
            plants: Default::default(),
            analysis: OnceLock::new(),
            linked: OnceLock::new(),
        }
    }

    /// Reads a file that a person named, and the workspace around it. `from` is what it is written in; without that its content decides.
    ///
    /// # Errors
    /// The file cannot be read, or is broken, or the settings of its workspace cannot be used.
    pub(crate) fn read(file: &Path, from: Option<Form>) -> Result<Source, Failure> {
        // A folder is the project in it.
        let settings = file.join(SETTINGS_FILE);
        let file = if settings.is_file() { &*settings } else { file };
        if is_settings(file) {
            return Ok(Source::of_tasks(file)?);
        }
        let bytes = ladder_workspace::read_bytes(file)?;
        Source::of_bytes(file, bytes, from)?.in_workspace()
    }

    /// Reads the text of a file from its content, alone.
    ///
    /// # Errors
    /// The content is not text, or is broken.
    pub(crate) fn of_bytes(file: &Path, bytes: Vec<u8>, from: Option<Form>) -> Result<Source, NotRead> {
        let name = file.display().to_string();
        let form = match from {
            Some(form) => form,
            None => form::of_program(file, &bytes)?,
        };
        let Form::Foreign(notation) = form else {
            let text = ladder_workspace::decode(file, bytes).map_err(Failure::from)?;
            return Ok(Source::new(name, text));
        };
        let source = FOREIGN.source(notation, file, &bytes).map_err(Failure::from)?;
        let foreign = Foreign::read(notation, &source).map_err(|error| NotRead::broken(file, &error))?;
        let source = Source::new(name, foreign.ladder().to_owned());
        Ok(source.of_foreign(Some(Arc::new(foreign))))
    }

    /// The same, where the text is what a file of another system becomes.
    fn of_foreign(mut self, foreign: Option<Arc<Foreign>>) -> Source {
        if let Some(foreign) = &foreign {
            self.index = LineIndex::new(foreign.text());
        }
        self.foreign = foreign;
        self
    }

    /// What the tasks of a settings file run.
    ///
    /// # Errors
    /// There are none, or something in the file is wrong.
    pub(crate) fn of_tasks(file: &Path) -> Result<Source, NotRead> {
        let workspace = Arc::new(Workspace::of(file).map_err(Failure::from)?);
        let settings = workspace.settings();
        let plan = Plan::of(settings, file).map_err(Failure::from)?;
        let text = plan.text(&settings.format);
        let mut source = Source::new(file.display().to_string(), text).within(workspace);
        source.has_tasks = true;
        Ok(source)
    }

    /// In the workspace around its file.
    ///
    /// # Errors
    /// The settings of that cannot be used.
    pub(crate) fn in_workspace(self) -> Result<Source, Failure> {
        let workspace = Arc::new(Workspace::of(Path::new(&self.file))?);
        Ok(self.within(workspace))
    }

    /// In a workspace that is loaded already.
    #[must_use]
    pub(crate) fn within(self, workspace: Arc<Workspace>) -> Source {
        let _ = self.workspace.set(Some(workspace));
        self
    }

    /// Beside models of its machine.
    #[must_use]
    pub(crate) fn beside(mut self, plants: Vec<(Source, String)>, connects: Vec<Connect>) -> Source {
        self.plants = (plants, connects);
        self
    }

    /// The same without them.
    #[must_use]
    pub(crate) fn alone(mut self) -> Source {
        self.plants = Default::default();
        self.linked = OnceLock::new();
        self
    }

    /// What is wrong with them, and with how they are connected.
    pub(crate) fn plant_errors(&self) -> Vec<PlantError> {
        self.link()
            .as_ref()
            .map_or_else(|_| Vec::new(), |(_, errors)| errors.clone())
    }

    /// The same file with another text.
    pub(crate) fn with_text(&self, text: String) -> Source {
        let source = Source::new(self.file.clone(), text);
        if let Some(workspace) = self.workspace.get() {
            let _ = source.workspace.set(workspace.clone());
        }
        source
    }

    /// What the file says among the others of its workspace.
    pub(crate) fn analyze(&self) -> Arc<Analysis> {
        let analysis = self.analysis.get_or_init(|| {
            let Some(workspace) = self.workspace() else {
                let parse = Arc::new(ladder_syntax::parse(&self.text));
                return Arc::new(ladder_analysis::analyze(&parse, &self.file));
            };
            match workspace.program_at(Path::new(&self.file)) {
                Some(program) if program.text() == self.text => workspace.analysis(program),
                // Fixed, or changed since it was read.
                Some(program) => workspace.analyze_guest(&self.text, &program.name),
                None => workspace.analyze_guest(&self.text, &self.file),
            }
        });
        Arc::clone(analysis)
    }

    /// The program of another system that the file is, if it is one.
    pub(crate) fn foreign(&self) -> Option<&Arc<Foreign>> {
        self.foreign.as_ref()
    }

    /// What there is to say about a program of another system before it is ladder text.
    pub(crate) fn remarks(&self) -> Vec<Mark> {
        self.foreign
            .as_ref()
            .map_or_else(Vec::new, |foreign| foreign.remarks())
    }

    /// What is found in the program, with its places in the file. Of a program of another system the fixes are left out:
    /// they would change a text that is nowhere.
    pub(crate) fn findings(&self) -> Vec<Diagnostic> {
        self.in_file(self.analyze().diagnostics().to_vec())
    }

    /// What keeps the program from being run, next to the remarks, with its places in the file.
    pub(crate) fn errors(&self) -> Vec<Diagnostic> {
        self.in_file(self.analyze().errors().cloned().collect())
    }

    /// Whether anything keeps the program from being run.
    pub(crate) fn has_errors(&self) -> bool {
        self.foreign.as_ref().is_some_and(|foreign| foreign.has_errors()) || self.analyze().has_errors()
    }

    fn in_file(&self, mut findings: Vec<Diagnostic>) -> Vec<Diagnostic> {
        for related in findings.iter_mut().flat_map(|finding| &mut finding.related) {
            if let Some(other) = related.file.as_ref().and_then(|name| self.member(name)) {
                related.range = other.member.range(related.range);
            }
        }
        let Some(foreign) = &self.foreign else {
            self.offer_conversion(&mut findings);
            return findings;
        };
        foreign.in_file(findings)
    }

    /// Another program of the workspace, by the name that findings and programs know it by.
    fn member(&self, name: &str) -> Option<&ladder_workspace::Source> {
        self.workspace()?.program_named(name)
    }

    /// Adds the conversion to the finding that a file is in the first draft of the language, which is the only one then.
    fn offer_conversion(&self, findings: &mut [Diagnostic]) {
        let [found] = findings else { return };
        if self.analyze().cplc_draft().is_none() {
            return;
        }
        match conversion_of_cplc_draft(&self.text, &self.format_options()) {
            Some(Ok(fix)) => found.fixes.push(fix),
            Some(Err(reason)) => found.help = Some(reason.into()),
            None => {}
        }
    }

    /// Where a part of the ladder text is in the file.
    pub(crate) fn range_in_file(&self, range: TextRange) -> TextRange {
        self.foreign
            .as_ref()
            .map_or(range, |foreign| foreign.range(range))
    }

    /// What the other system calls the part of the file that a range is in, where it is one of another system.
    pub(crate) fn name_of(&self, range: TextRange) -> Option<&str> {
        self.foreign.as_ref()?.name_at(range.start())
    }

    /// What runs: the program with what it uses of other files.
    pub(crate) fn program(&self) -> Result<Arc<Program>, NotWhole> {
        self.linked().map(|linked| linked.program)
    }

    /// The same with those files.
    pub(crate) fn linked(&self) -> Result<Linked, NotWhole> {
        self.link().clone().map(|(linked, _)| linked)
    }

    fn link(&self) -> &Result<(Linked, Vec<PlantError>), NotWhole> {
        self.linked.get_or_init(|| {
            let analysis = self.analyze();
            let (plants, connects) = &self.plants;
            let mut all = std::iter::once(self).chain(plants.iter().map(|(plant, _)| plant));
            if let Some(broken) = all.find(|source| source.has_errors()) {
                return Err(NotWhole::Errors(Arc::clone(&broken.analyze().context.name)));
            }
            if !plants.is_empty() {
                let plants = plants.iter().map(|(plant, name)| PlantFile {
                    analysis: plant.analyze(),
                    name: name.clone(),
                });
                let plants: Vec<PlantFile> = plants.collect();
                let Some(workspace) = self.workspace() else {
                    return link_with_plants(&analysis, &[], (&plants, connects), &|_| None);
                };
                let plan = Plan::of(workspace.settings(), Path::new(&self.file));
                let plan = plan.ok().filter(|_| self.has_tasks);
                return workspace.link_beside(&analysis, plan.as_ref(), (&plants, connects));
            }
            let linked = match self.workspace() {
                Some(workspace) if self.has_tasks => {
                    let plan = Plan::of(workspace.settings(), Path::new(&self.file));
                    let plan = plan.map_err(|_| NotWhole::Missing(Arc::from(&*self.file)))?;
                    workspace.link_plan(&plan, &analysis)
                }
                Some(workspace) => workspace.link(&analysis),
                None => ladder_analysis::link_files(&analysis, &|_| None),
            };
            linked.map(|linked| (linked, Vec::new()))
        })
    }

    /// The plant of a name, as findings and programs know it.
    fn plant(&self, name: &str) -> Option<&Source> {
        let mut plants = self.plants.0.iter().map(|(plant, _)| plant);
        plants.find(|plant| *plant.analyze().context.name == *name)
    }

    /// The layout that its workspace asks for.
    pub(crate) fn format_options(&self) -> ladder_format::Options {
        let workspace = self.workspace();
        workspace.map_or_else(Default::default, |workspace| workspace.settings().format.clone())
    }

    /// Another file of the workspace, by the name that findings and programs know it by.
    pub(crate) fn other(&self, name: &str) -> Option<Source> {
        if let Some(plant) = self.plant(name) {
            let other = Source::new(plant.file.clone(), plant.text.clone()).of_foreign(plant.foreign.clone());
            return Some(match plant.workspace() {
                Some(workspace) => other.within(Arc::clone(workspace)),
                None => other,
            });
        }
        let program = self.member(name)?;
        let other = Source::new(name.to_owned(), program.text().to_owned())
            .of_foreign(program.member.foreign().cloned());
        Some(other.within(Arc::clone(self.workspace()?)))
    }

    /// A program's files, this one first.
    pub(crate) fn members(&self, files: &[String]) -> Vec<Member> {
        let others = files
            .iter()
            .skip(1)
            .map(|name| match (self.plant(name), self.member(name)) {
                (Some(plant), _) => plant.as_member(),
                (None, Some(other)) => other.member.clone(),
                (None, None) => {
                    Member::Ladder(library::source(name).map_or_else(String::new, |it| it.text.to_owned()))
                }
            });
        std::iter::once(self.as_member()).chain(others).collect()
    }

    fn as_member(&self) -> Member {
        match &self.foreign {
            Some(foreign) => Member::Foreign(Arc::clone(foreign)),
            None => Member::Ladder(self.text.clone()),
        }
    }

    /// The workspace around the file. Settings that cannot be used were reported by the command, which read them first.
    fn workspace(&self) -> Option<&Arc<Workspace>> {
        let load = || Workspace::of(Path::new(&self.file)).ok().map(Arc::new);
        self.workspace.get_or_init(load).as_ref()
    }

    /// The file of a place of the program, if it is another one.
    fn file_of(&self, location: Location) -> Option<Source> {
        match (location.file, self.linked.get()) {
            (1.., Some(Ok((linked, _)))) => self.other(&linked.program.files[location.file as usize]),
            _ => None,
        }
    }

    /// A place of the program, in whichever file it lies: `motor.clad:3:12`.
    pub(crate) fn place_name(&self, location: Location) -> String {
        let elsewhere = self.file_of(location);
        let source = elsewhere.as_ref().unwrap_or(self);
        let place = source.place(source.range_in_file(location.range).start());
        format!("{}:{}:{}", shown::line(&source.file), place.line, place.column)
    }

    /// The text of the file.
    pub(crate) fn file_text(&self) -> &str {
        self.foreign.as_ref().map_or(&self.text, |foreign| foreign.text())
    }

    /// Line and column of an offset in the file.
    pub(crate) fn place(&self, offset: TextSize) -> LineColumn {
        self.index.line_column(self.file_text(), offset)
    }

    /// Every line of the ladder text with its line end, from first to last.
    #[cfg(feature = "screen")]
    pub(crate) fn line_ranges(&self) -> impl Iterator<Item = TextRange> + '_ {
        let index = match &self.foreign {
            None => Cow::Borrowed(&self.index),
            Some(_) => Cow::Owned(LineIndex::new(&self.text)),
        };
        (0..index.line_count()).map(move |line| index.range(line))
    }

    /// The whole lines of the file that a range touches, and the number of the first, from 1. A range that ends with a line
    /// end does not touch the line after it.
    pub(crate) fn lines(&self, range: TextRange) -> Lines {
        let first = self.index.line(range.start());
        let last = self.index.line(range.end()).max(first);
        let after_line_end = last > first && self.index.range(last).start() == range.end();
        Lines {
            first,
            last: if after_line_end { last - 1 } else { last },
        }
    }

    /// The lines as they are shown, and where they begin in the text.
    pub(crate) fn excerpt(&self, lines: Lines) -> (Cow<'_, str>, TextSize) {
        let mut start = self.index.range(lines.first).start();
        let end = self.index.range(lines.last).end();
        // The byte order mark is not a character of the first line.
        let text = self.file_text();
        if start == TextSize::new(0) && text.starts_with('\u{feff}') {
            start = TextSize::of('\u{feff}');
        }
        (
            with_line_feeds(&text[TextRange::new(start, end.max(start))]),
            start,
        )
    }
}

/// Why a file that was there cannot be taken for a program.
pub(crate) struct NotRead {
    /// Where it is broken, if it is at one place.
    pub(crate) place: Option<LineColumn>,
    /// What is wrong, with the name of the file.
    pub(crate) failure: Failure,
}

impl NotRead {
    fn broken(file: &Path, error: &ReadError) -> NotRead {
        NotRead {
            place: error.place,
            failure: Failure::broken(file, error),
        }
    }
}

impl From<Failure> for NotRead {
    fn from(failure: Failure) -> NotRead {
        NotRead { place: None, failure }
    }
}

impl From<NotRead> for Failure {
    fn from(not_read: NotRead) -> Failure {
        not_read.failure
    }
}

/// Some lines of a text, counted from 0, both included.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Lines {
    pub(crate) first: usize,
    pub(crate) last: usize,
}

impl Lines {
    /// The lines of both, and those between.
    pub(crate) fn join(self, other: Lines) -> Lines {
        Lines {
            first: self.first.min(other.first),
            last: self.last.max(other.last),
        }
    }

    /// How many lines are between the two; 0 if they touch or overlap.
    pub(crate) fn distance(self, other: Lines) -> usize {
        let between = |upper: usize, lower: usize| lower.saturating_sub(upper).saturating_sub(1);
        between(self.last, other.first).max(between(other.last, self.first))
    }
}

/// Terminals, and the drawing of excerpts, do not know a lone CR as a line end. One byte stands for one byte, so
/// that ranges stay true.
pub(crate) fn with_line_feeds(text: &str) -> Cow<'_, str> {
    let bytes = text.as_bytes();
    let lone = |at: usize| bytes[at] == b'\r' && bytes.get(at + 1) != Some(&b'\n');
    if !(0..bytes.len()).any(lone) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len());
    for (at, letter) in text.char_indices() {
        shown.push(if lone(at) { '\n' } else { letter });
    }
    Cow::Owned(shown)
}
