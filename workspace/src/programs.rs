//! The programs of a workspace, read and analysed together.

use crate::disk::{Disk, SystemDisk};
use crate::foreign::ForeignPrograms;
use crate::member::Member;
use crate::named_by_settings::errors_on_disk;
use crate::plan::Plan;
use crate::settings::Settings;
use crate::settings::SettingsError;
use crate::shown::from_here;
use ladder_analysis::{
    Analysis, AnalyzeOptions, Connect, Exported, Exports, Linked, NotWhole, Others, PlantError, PlantFile,
    analyze, exports, link_files, link_tasks, link_with_plants,
};
use ladder_syntax::Parse;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

/// A workspace: its settings, and its programs as they are on disk.
#[derive(Debug)]
pub struct Workspace {
    disk: Arc<dyn Disk>,
    settings: Settings,
    programs: Vec<Source>,
    exported: OnceLock<Arc<Exported>>,
}

/// A program of a workspace.
#[derive(Debug)]
pub struct Source {
    /// Its name in messages: the path, from the current folder on where it lies below it.
    pub name: Arc<str>,
    /// What is in its file.
    pub member: Member,
    path: PathBuf,
    parse: OnceLock<Arc<Parse>>,
    exports: OnceLock<Arc<Exports>>,
    analysis: OnceLock<Arc<Analysis>>,
}

impl Workspace {
    /// The workspace that a program belongs to. Programs that cannot be read are left out: each must be usable
    /// next to one that is not.
    ///
    /// # Errors
    /// The settings file cannot be read, or something in it is wrong.
    pub fn of(program: &Path) -> Result<Workspace, SettingsError> {
        Workspace::on(&(Arc::new(SystemDisk) as Arc<dyn Disk>), program)
    }

    /// As [`Workspace::of`], on another disk.
    ///
    /// # Errors
    /// As there.
    pub fn on(disk: &Arc<dyn Disk>, program: &Path) -> Result<Workspace, SettingsError> {
        let Ok(root) = disk.root_of(program) else {
            return Ok(Workspace::with(disk, Settings::default(), Vec::new()));
        };
        let settings = match root.settings_file() {
            Some(file) => {
                let text = disk.settings_text(&file).map_err(SettingsError::File)?;
                let settings = Settings::parse(&file, &text)?;
                let errors = errors_on_disk(&settings, &text, &**disk);
                if !errors.is_empty() {
                    return Err(SettingsError::Content { file, errors });
                }
                settings
            }
            None => Settings::default(),
        };
        let programs = disk.programs(&root, &settings.files);
        let foreign = ForeignPrograms::on(Arc::clone(disk));
        let sources = programs.iter().filter_map(|path| {
            Some(Source::new(
                foreign.member(path, Some((root.folder(), &programs))).ok()?,
                path,
            ))
        });
        Ok(Workspace::with(disk, settings, sources.collect()))
    }

    /// The workspace of a text that is alone: only the settings that hold for its place.
    ///
    /// # Errors
    /// As for [`Workspace::of`].
    pub fn without_programs(place: &Path) -> Result<Workspace, SettingsError> {
        let disk: Arc<dyn Disk> = Arc::new(SystemDisk);
        Ok(Workspace::with(&disk, Settings::of(place)?, Vec::new()))
    }

    fn with(disk: &Arc<dyn Disk>, settings: Settings, programs: Vec<Source>) -> Workspace {
        Workspace {
            disk: Arc::clone(disk),
            settings,
            programs,
            exported: OnceLock::new(),
        }
    }

    /// Takes out a program, or all programs in a folder, before anything is asked of the others.
    pub fn leave_out(&mut self, path: &Path) {
        let true_path = |path: &Path| self.disk.canonicalize(path).unwrap_or_else(|_| path.to_owned());
        let out = true_path(path);
        self.programs
            .retain(|source| !true_path(&source.path).starts_with(&out));
    }

    /// What its settings file asks for.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Those that show something to each other: none where one is alone, which need not be read twice then.
    pub fn programs_seen_by_others(&self) -> &[Source] {
        match &*self.programs {
            [_] => &[],
            several => several,
        }
    }

    /// The program of a file, if it belongs to the workspace.
    pub fn program_at(&self, path: &Path) -> Option<&Source> {
        let true_path = |path: &Path| self.disk.canonicalize(path).ok();
        let wanted = true_path(path)?;
        let by_path = |source: &&Source| true_path(&source.path).is_some_and(|path| path == wanted);
        let same_name = self
            .programs
            .iter()
            .filter(|source| source.path.file_name() == wanted.file_name());
        same_name.clone().find(by_path).or_else(|| {
            let others = self.programs.iter();
            others
                .filter(|source| self.disk.is_link(&source.path))
                .find(by_path)
        })
    }

    /// The program of a name, as messages have it.
    pub fn program_named(&self, name: &str) -> Option<&Source> {
        self.programs.iter().find(|source| *source.name == *name)
    }

    /// A program's names, findings and, if it needs no other file, program.
    pub fn analysis(&self, source: &Source) -> Arc<Analysis> {
        let analysis = source.analysis.get_or_init(|| {
            let others = match self.programs_seen_by_others() {
                [] => Others::alone(),
                _ => self.exported().others_of(&source.name),
            };
            let rules = self.settings.rules_for(&source.path);
            Arc::new(analyze(
                source.parse(),
                AnalyzeOptions::new(&source.name)
                    .among(&others)
                    .with_rules(&rules),
            ))
        });
        Arc::clone(analysis)
    }

    /// As [`Workspace::analysis`], for a text that is not a program of the workspace: it sees those, they do not see
    /// it.
    pub fn analyze_guest(&self, text: &str, name: &str) -> Arc<Analysis> {
        let parse = Arc::new(ladder_syntax::parse(text));
        let path = self.program_named(name).map_or(Path::new(name), Source::path);
        let rules = self.settings.rules_for(path);
        Arc::new(analyze(
            &parse,
            AnalyzeOptions::new(name)
                .among(&self.exported().others_of(name))
                .with_rules(&rules),
        ))
    }

    /// What runs: the program with all that it uses of other files, and these.
    ///
    /// # Errors
    /// It, or a file that it uses, has errors.
    pub fn link(&self, analysis: &Arc<Analysis>) -> Result<Linked, NotWhole> {
        let linked = link_files(analysis, &|name| Some(self.analysis(self.program_named(name)?)))?;
        self.checked(linked)
    }

    /// What runs, unless a file that it uses has errors before it is ladder text.
    fn checked(&self, linked: Linked) -> Result<Linked, NotWhole> {
        let names = linked.others.iter().map(|other| &other.context.name);
        let mut broken = names.filter(|name| self.program_named(name).is_some_and(Source::is_broken));
        match broken.next().cloned() {
            Some(file) => Err(NotWhole::Errors(file)),
            None => Ok(linked),
        }
    }

    /// What runs where the tasks of a plan do: `analysis` is that of its text, a guest.
    ///
    /// # Errors
    /// A program of a task, or a file that it uses, has errors or is not there.
    pub fn link_plan(&self, plan: &Plan<'_>, analysis: &Arc<Analysis>) -> Result<Linked, NotWhole> {
        let programs = self.programs_of(plan)?;
        let linked = link_tasks(analysis, &programs, &|name| {
            Some(self.analysis(self.program_named(name)?))
        })?;
        self.checked(linked)
    }

    /// What runs beside models of its machine: a program, or what a plan runs. What is wrong with these comes with it; then it must
    /// not run.
    ///
    /// # Errors
    /// One of the programs, or a file that it uses, has errors or is not there.
    pub fn link_beside(
        &self,
        analysis: &Arc<Analysis>,
        plan: Option<&Plan<'_>>,
        plants: (&[PlantFile], &[Connect]),
    ) -> Result<(Linked, Vec<PlantError>), NotWhole> {
        let programs = plan.map_or_else(|| Ok(Vec::new()), |plan| self.programs_of(plan))?;
        let of_name = |name: &str| Some(self.analysis(self.program_named(name)?));
        let (linked, errors) = link_with_plants(analysis, &programs, plants, &of_name)?;
        Ok((self.checked(linked)?, errors))
    }

    fn programs_of(&self, plan: &Plan<'_>) -> Result<Vec<(Arc<Analysis>, u32)>, NotWhole> {
        let programs = plan.programs().map(|(program, every)| {
            let missing = || NotWhole::Missing(Arc::from(from_here(&program.path()).display().to_string()));
            let source = self.program_at(&program.path()).ok_or_else(missing)?;
            Ok((self.analysis(source), every))
        });
        programs.collect()
    }

    fn exported(&self) -> &Arc<Exported> {
        self.exported.get_or_init(|| {
            let exports = self.programs.iter().map(|source| Arc::clone(source.exports()));
            Arc::new(Exported::new(exports.collect()))
        })
    }
}

impl Source {
    fn new(member: Member, path: &Path) -> Source {
        Source {
            name: Arc::from(from_here(path).display().to_string()),
            member,
            path: path.to_owned(),
            parse: OnceLock::new(),
            exports: OnceLock::new(),
            analysis: OnceLock::new(),
        }
    }

    /// Whether anything keeps it from being run in which its file is of another notation.
    fn is_broken(&self) -> bool {
        self.member.foreign().is_some_and(|foreign| foreign.has_errors())
    }

    /// Its ladder text.
    pub fn text(&self) -> &str {
        self.member.ladder()
    }

    /// Where it lies.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Reads off what it shows to the others, so that it is there when they are analysed.
    pub fn prepare(&self) {
        self.exports();
    }

    fn parse(&self) -> &Arc<Parse> {
        self.parse
            .get_or_init(|| Arc::new(ladder_syntax::parse(self.text())))
    }

    fn exports(&self) -> &Arc<Exports> {
        self.exports
            .get_or_init(|| Arc::new(exports(self.parse(), &self.name)))
    }
}
