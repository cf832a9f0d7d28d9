//! `ladder.runScenarios`: an open file of scenarios is run, for a client that can start no program.

use std::sync::Arc;

use ladder_analysis::Cancel;
use ladder_documents::{Kind, Revision};
use ladder_live::{Failure, argument_of};
use ladder_simulator::scenario;
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use super::of_scenarios::NamedProgram;
use crate::lsp::answers::{error, json};
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;
use crate::scenario_run::{Files, RunScenarios, ScenariosRun, run};

/// The command.
pub(crate) const RUN_SCENARIOS: &str = "ladder.runScenarios";

pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let asked: RunScenarios = argument_of(RUN_SCENARIOS, params.arguments).map_err(error)?;
    let failed = |message: String| error(Failure::Failed(message));
    let revision = shared.companions.get(&asked.uri);
    let revision = revision
        .filter(|revision| revision.kind() == Kind::Scenarios && revision.fits())
        .ok_or_else(|| {
            failed(format!(
                "{} is no file of scenarios that is open in the editor",
                asked.uri
            ))
        })?;
    let next_to = shared.clone();
    let answer = blocking(&*shared.host, move |cancel| {
        play(&next_to, &revision, &asked, cancel)
    })
    .await?;
    json(&answer.map_err(failed)?)
}

fn play(
    shared: &Shared,
    scenarios: &Revision,
    asked: &RunScenarios,
    cancel: &Cancel,
) -> std::result::Result<ScenariosRun, String> {
    let suite = scenario::parse(&scenarios.text());
    let program = NamedProgram::of(shared, scenarios, &suite)?;
    let simulation = program.compiled(shared, &suite)?;
    let files = Files {
        scenarios,
        program: &program.revision,
    };
    run(
        &files,
        &suite,
        simulation,
        asked.coverage,
        &shared.world().clock,
        cancel,
    )
}
