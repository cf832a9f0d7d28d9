//! `ladder.proveProperties`: properties are decided, and what violates one is shown as a finding until a text changes.

use std::sync::Arc;

use ladder_analysis::Cancel;
use ladder_documents::{Kind, address};
use ladder_live::{Failure, argument_of};
use ladder_simulator::scenario;
use tower_lsp::jsonrpc::{Error, Result};
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use super::of_scenarios::{NamedProgram, on_disk};
use crate::lsp::answers::{error, json};
use crate::lsp::documents::companions::refresh_proofs;
use crate::lsp::session::proofs::ProgramText;
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;
use crate::proof::{self, PropertiesProved, ProveProperties};
use crate::scenario_run::Files;

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
    let program = NamedProgram::of(shared, &scenarios, &suite)?;
    let mut simulation = program.compiled(shared, &suite)?;
    let text = ProgramText::of(&simulation);
    let NamedProgram {
        revision: program,
        is_open: is_program_open,
        ..
    } = program;
    let cancel = {
        let (shared, cancel) = (shared.clone(), cancel.clone());
        let (file, program) = (scenarios.clone(), program.clone());
        Cancel::when(move || {
            cancel.is_cancelled()
                || (is_open && !shared.companions.shows(&file))
                || (is_program_open && !shared.documents.shows(&program))
        })
    };
    let files = Files {
        scenarios: &scenarios,
        program: &program,
    };
    let clock = shared.world().clock.clone();
    let found = proof::run(
        &files,
        &suite,
        &mut simulation,
        asked.name.as_deref(),
        clock,
        cancel.clone(),
    )?;
    if cancel.is_cancelled() {
        return Err(Given::Overtaken);
    }
    if is_open {
        shared.proofs.found(&scenarios, text, found.properties.clone());
    }
    Ok(PropertiesProved {
        uri: scenarios.uri.to_string(),
        version: is_open.then_some(scenarios.version),
        program: program.uri.to_string(),
        plants: found.plants,
        unchanging: found.unchanging,
        properties: found.properties,
    })
}
