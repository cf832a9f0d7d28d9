//! What requests about a scenario file, or a scene, have in common: its text, and the program that it is about with the files next to
//! that, open or not.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use ladder_analysis::Cancel;
use ladder_documents::membership::Membership;
use ladder_documents::other_files::OtherFiles;
use ladder_documents::{Kind, Revision, address};
use ladder_ide::{Alone, Scenarios, SceneAttribute};
use ladder_notations::of_workspaces;
use ladder_picture::scene;
use ladder_simulator::Simulation;
use ladder_simulator::scenario::{self, PlantLine, Suite};
use ladder_syntax::{TextRange, TextSize};
use ladder_workspace::shown::path as shown_path;
use tower_lsp::jsonrpc;
use tower_lsp::ls_types::{Position, Uri};

use super::asked::Asked;
use crate::lsp::documents::companions::{compiled_from, scene_of};
use crate::lsp::transport::blocking::blocking;
use crate::lsp::{convert, session::shared::Shared};

/// A scenario file that is asked about.
pub(crate) struct AskedScenarios {
    /// The scenario file.
    pub(crate) revision: Arc<Revision>,
    text: String,
    suite: Suite,
    /// The program, if it was found.
    pub(crate) program: Option<Asked>,
}

impl AskedScenarios {
    /// The offset of a position in the scenario file.
    pub(crate) fn offset(&self, position: Position) -> TextSize {
        self.revision.offset(convert::our_position(position))
    }

    /// The file as features read it.
    pub(crate) fn read(&self) -> Scenarios<'_> {
        Scenarios {
            text: &self.text,
            suite: &self.suite,
            program: self.program.as_ref().map(|program| &*program.context),
            workspace: match &self.program {
                Some(program) => &program.elsewhere,
                None => &Alone,
            },
        }
    }
}

/// The open scenario file of this address, if it is one.
pub(crate) fn scenarios_at(shared: &Shared, uri: &Uri) -> Option<Arc<Revision>> {
    let revision = shared.companions.get(uri.as_str())?;
    (revision.kind() == Kind::Scenarios).then_some(revision)
}

/// The open file of this address that names the tags of a program, if it is one: of scenarios, or a scene.
pub(crate) fn naming_at(shared: &Shared, uri: &Uri) -> Option<Arc<Revision>> {
    let revision = shared.companions.get(uri.as_str())?;
    matches!(revision.kind(), Kind::Scenarios | Kind::Scene).then_some(revision)
}

/// What the text of such a file says.
pub(crate) fn read(revision: &Revision, text: &str) -> Suite {
    if revision.kind() == Kind::Scene {
        scene_of(revision, text).suite()
    } else {
        scenario::parse(text)
    }
}

/// The attributes of scenes, as features read them.
pub(crate) fn scene_attributes() -> Vec<SceneAttribute> {
    let attributes = scene::ATTRIBUTES.iter().map(|attribute| SceneAttribute {
        name: attribute.name,
        about: attribute.about,
        takes_expression: attribute.takes_expression,
    });
    attributes.collect()
}

/// Does a job about such a file; nothing for one that is too large.
pub(crate) async fn about_scenarios<T: Send + 'static>(
    shared: &Arc<Shared>,
    revision: Arc<Revision>,
    job: impl FnOnce(&AskedScenarios) -> Option<T> + Send + 'static,
) -> jsonrpc::Result<Option<T>> {
    let next_to = shared.clone();
    blocking(&*shared.host, move |cancel| {
        let shared = next_to;
        if !revision.fits() {
            return None;
        }
        let text = revision.text();
        let mut suite = read(&revision, &text);
        let program = program(&shared, &revision, &suite, cancel);
        if revision.kind() == Kind::Scene
            && suite.plants.is_empty()
            && let Some(place) = program.as_ref().and_then(|program| program.revision.place())
        {
            suite.plants = plants_of_settings(&shared, &place.path);
        }
        job(&AskedScenarios {
            revision,
            text,
            suite,
            program,
        })
    })
    .await
}

/// The plants that the settings have for a program, as lines of nowhere: a scene shows what is simulated, which runs with these.
fn plants_of_settings(shared: &Shared, program: &Path) -> Vec<PlantLine> {
    let settings = shared.neighbours.simulate(program);
    let plants = settings.plants_of(program).iter();
    let line = plants.map(|plant| PlantLine {
        file: plant.file.path().to_string_lossy().into_owned(),
        range: TextRange::default(),
        name: plant.name.clone(),
    });
    line.collect()
}

/// The program that a scenario file names.
pub(super) struct NamedProgram {
    pub(super) revision: Arc<Revision>,
    path: PathBuf,
    /// The file of the scenarios.
    scenarios: PathBuf,
    /// The editor shows it; else it is as it is on disk.
    pub(super) is_open: bool,
}

impl NamedProgram {
    /// Finds it.
    ///
    /// # Errors
    ///
    /// A sentence for the person.
    pub(super) fn of(shared: &Shared, scenarios: &Revision, suite: &Suite) -> Result<NamedProgram, String> {
        let Some((name, _)) = &suite.program else {
            return Err("the file names no program: it begins with `program NAME.clad`".to_owned());
        };
        let disk = &shared.world().disk;
        let file = address::path_of(&scenarios.uri).ok_or("the file of the scenarios lies in no folder")?;
        let path = disk
            .locate(&disk.named_in(&file, name))
            .map_err(|error| error.to_string())?;
        let open = shown(shared, &path);
        let is_open = open.is_some();
        let revision = open.or_else(|| on_disk(shared, &path));
        Ok(NamedProgram {
            revision: revision.ok_or_else(|| format!("{name} cannot be read any more"))?,
            path,
            scenarios: file,
            is_open,
        })
    }

    /// This very text, ready to run: its neighbours know it a moment later.
    ///
    /// # Errors
    ///
    /// A sentence for the person.
    pub(super) fn compiled(&self, shared: &Shared, suite: &Suite) -> Result<Simulation, String> {
        let analysis = self.revision.analysis();
        let analysis = analysis.ok_or_else(|| format!("{} is too large", shown_path(&self.path)))?;
        let scenarios = (&*self.scenarios, suite);
        Ok(compiled_from(shared, &self.path, analysis.whole(), scenarios)?)
    }
}

fn program(shared: &Shared, revision: &Revision, suite: &Suite, cancel: &Cancel) -> Option<Asked> {
    let program = NamedProgram::of(shared, revision, suite).ok()?.revision;
    let context = Arc::clone(program.context()?);
    let elsewhere = OtherFiles::of(&program, &shared.documents, &shared.companions, cancel);
    Some(Asked {
        revision: program,
        context,
        elsewhere,
        knows_others: true,
        opens_library: shared.agreed().library_blocks,
    })
}

pub(super) fn shown(shared: &Shared, path: &Path) -> Option<Arc<Revision>> {
    let is_it = |revision: &Arc<Revision>| revision.place().is_some_and(|place| place.path == path);
    let is_program = |revision: &Arc<Revision>| is_it(revision) && of_workspaces(path).is_some();
    let open = shared.documents.all().into_iter().find(is_it);
    open.or_else(|| shared.companions.all().into_iter().find(is_program))
}

pub(super) fn on_disk(shared: &Shared, path: &Path) -> Option<Arc<Revision>> {
    let text = match of_workspaces(path) {
        Some(_) => shared.world().disk.read_own(path).ok()?,
        None => shared.neighbours.text_on_disk(path).ok()?,
    };
    let place = Membership::new(path.to_owned(), &shared.neighbours);
    let uri = address::uri_of(path);
    Some(Arc::new(Revision::on_disk(
        &uri,
        shared.agreed().encoding,
        &text,
        place,
    )))
}
