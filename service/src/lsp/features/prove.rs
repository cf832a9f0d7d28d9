//! `ladder.proveProperties`: properties are decided, and what violates one is shown as a finding until a text changes.

use std::sync::Arc;

use ladder_simulator::scenario;
use tower_lsp::jsonrpc::{Error, Result};
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use super::of_scenarios::{on_disk, shown};
use super::simulate::{error, json};
use crate::cancel::Cancel;
use crate::document::{Kind, Revision, address};
use crate::lsp::documents::companions::{compiled_from, refresh_proofs};
use crate::lsp::session::proofs::ProgramText;
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;
use crate::proof::{self, PropertiesProved, ProveProperties};
use crate::scenario_run::Files;
use crate::simulation::{Failure, argument_of};

/// The command.
pub(crate) const PROVE_PROPERTIES: &str = "ladder.proveProperties";

/// Why nothing came of it.
enum Given {
    /// What to tell the person.
    Up(String),
    /// A text is another one by now.
    Overtaken,
}

impl From<String> for Given {
    fn from(message: String) -> Given {
        Given::Up(message)
    }
}

pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let asked: ProveProperties = argument_of(PROVE_PROPERTIES, params.arguments).map_err(error)?;
    let failed = |message: String| error(Failure::Failed(message));
    let _turn = shared.proofs.turn().await;
    let next_to = shared.clone();
    let job = move |cancel: &Cancel| decide(&next_to, &asked, cancel);
    let answer = blocking(&*shared.host, job).await?;
    match answer {
        Ok(answer) => {
            if answer.version.is_some() {
                refresh_proofs(shared, &answer.uri);
            }
            json(&answer)
        }
        Err(Given::Up(message)) => Err(failed(message)),
        Err(Given::Overtaken) => Err(Error::content_modified()),
    }
}

fn decide(
    shared: &Arc<Shared>,
    asked: &ProveProperties,
    cancel: &Cancel,
) -> std::result::Result<PropertiesProved, Given> {
    let open = shared.companions.get(&asked.uri);
    let is_open = open.is_some();
    // What is not open counts as it is on disk.
    let closed = || address::path_of(&asked.uri).filter(|path| ladder_workspace::is_scenario(path));
    let scenarios = open.or_else(|| on_disk(shared, &closed()?));
    let scenarios = scenarios.filter(|it| it.fits() && (!is_open || it.kind() == Kind::Scenarios));
    let scenarios = scenarios.ok_or_else(|| format!("{} is no file of scenarios", asked.uri))?;
    let suite = scenario::parse(&scenarios.text());
    let Some((name, _)) = &suite.program else {
        let message = "the properties name no program: their file begins with `program NAME.clad`";
        return Err(Given::Up(message.to_owned()));
    };
    let disk = &shared.world().disk;
    let path =
        address::path_of(&scenarios.uri).ok_or_else(|| "the properties lie in no folder".to_owned())?;
    let path = disk
        .locate(&disk.named_in(&path, name))
        .map_err(|error| error.to_string())?;
    let open_program = shown(shared, &path);
    let program = open_program.clone().or_else(|| on_disk(shared, &path));
    let program = program.ok_or_else(|| format!("{name} cannot be read any more"))?;
    // This very text: its neighbours know it a moment later.
    let analysis = program
        .analysis()
        .ok_or_else(|| format!("{name} is too large"))?
        .whole();
    let interval = suite.interval.map(|(interval, _)| interval);
    let mut simulation = compiled_from(shared, &path, analysis, interval).map_err(String::from)?;
    let text = ProgramText::of(&simulation);
    let is_wanted = {
        let (shared, cancel, file) = (shared.clone(), cancel.clone(), scenarios.clone());
        move || {
            let is_shown = |program: &Arc<Revision>| shared.documents.shows(program);
            !cancel.is_cancelled()
                && (!is_open || shared.companions.shows(&file))
                && open_program.as_ref().is_none_or(is_shown)
        }
    };
    let files = Files {
        scenarios: &scenarios,
        program: &program,
    };
    let still = is_wanted.clone();
    let found = proof::run(&files, &suite, &mut simulation, asked.name.as_deref(), is_wanted)?;
    if !still() {
        return Err(Given::Overtaken);
    }
    if is_open {
        shared.proofs.found(&scenarios, text, found.clone());
    }
    Ok(PropertiesProved {
        uri: scenarios.uri.to_string(),
        version: is_open.then_some(scenarios.version),
        program: program.uri.to_string(),
        properties: found,
    })
}
