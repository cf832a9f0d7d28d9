//! `textDocument/codeLens` and `codeLens/resolve`: only what the client says that it can do.

use std::sync::Arc;

use ladder_documents::{Revision, address};
use ladder_ide::LensKind;
use ladder_simulator::scenario;
use ladder_syntax::{TextRange, TextSize};
use serde_json::{Value, json};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{
    CodeLens, CodeLensParams, Command, Location, TextDocumentIdentifier, TextDocumentPositionParams,
};

use super::asked::{Places, about_place};
use super::of_scenarios::scenarios_at;
use crate::lsp::session::commands::{PROVE, SHOW, START, TEST};
use crate::lsp::transport::blocking::blocking;
use crate::lsp::{convert, session::shared::Shared};

pub(crate) async fn code_lens(shared: &Arc<Shared>, params: CodeLensParams) -> Result<Option<Vec<CodeLens>>> {
    let commands = shared.agreed().lens_commands;
    if !commands.any() || !shared.editor().code_lens {
        return Ok(None);
    }
    if let Some(revision) = scenarios_at(shared, &params.text_document.uri) {
        let revision = revision.fits().then_some(revision).filter(|_| commands.prove);
        return Ok(revision.map(|revision| of_properties(&revision)));
    }
    let Some(revision) = shared.documents.get(params.text_document.uri.as_str()) else {
        return Ok(None);
    };
    blocking(&*shared.host, move |_| {
        let found = ladder_ide::lenses(revision.context()?);
        let mut lenses = Vec::new();
        for lens in found {
            let range = convert::range_in(&revision, lens.at);
            let mut add = |command, data| {
                lenses.push(CodeLens { range, command, data });
            };
            match lens.kind {
                LensKind::Program => {
                    if commands.start {
                        add(
                            Some(command("Start simulation", START, vec![json!(&*revision.uri)])),
                            None,
                        );
                    }
                    if let Some(scenarios) = scenarios(&revision).filter(|_| commands.test) {
                        add(Some(command("Run scenarios", TEST, vec![json!(scenarios)])), None);
                    }
                }
                // Who jumps and calls is counted when the lens comes into sight.
                LensKind::Jumps(name) if commands.show => add(None, Some(data(&revision, "jump", name))),
                LensKind::Calls(name) if commands.show => add(None, Some(data(&revision, "call", name))),
                LensKind::Jumps(_) | LensKind::Calls(_) => {}
            }
        }
        Some(lenses)
    })
    .await
}

/// Above each property that it is proved, and at the beginning of the file that all are.
fn of_properties(revision: &Revision) -> Vec<CodeLens> {
    let suite = scenario::parse(&revision.text());
    let lens = |at: TextSize, title: &str, arguments| CodeLens {
        range: convert::range_in(revision, TextRange::empty(at)),
        command: Some(command(title, PROVE, arguments)),
        data: None,
    };
    let all = suite.program.as_ref().filter(|_| suite.properties.len() > 1);
    let all = all.map(|(_, program)| lens(program.start(), "Prove all", vec![json!(&*revision.uri)]));
    let each = suite.properties.iter().map(|property| {
        let arguments = vec![json!(&*revision.uri), json!(property.name)];
        lens(property.range.start(), "Prove", arguments)
    });
    all.into_iter().chain(each).collect()
}

fn command(title: &str, command: &str, arguments: Vec<Value>) -> Command {
    Command {
        title: title.to_owned(),
        command: command.to_owned(),
        arguments: Some(arguments),
    }
}

fn data(revision: &Revision, kind: &str, name: TextSize) -> Value {
    let at = convert::range_in(revision, TextRange::empty(name)).start;
    json!({ "uri": &*revision.uri, "at": at, "kind": kind })
}

/// The address of the scenarios next to a program, if there are any.
fn scenarios(revision: &Revision) -> Option<String> {
    let place = revision.place()?;
    let path = place.path.with_extension("ladder-test");
    let is_there = place.neighbours.disk().is_file(&path);
    is_there.then(|| address::uri_of(&path))
}

pub(crate) async fn resolve(shared: &Arc<Shared>, mut lens: CodeLens) -> Result<CodeLens> {
    let Some(data) = lens.data.take() else {
        return Ok(lens);
    };
    let (Some(uri), Ok(position)) = (
        data["uri"].as_str().and_then(convert::uri),
        serde_json::from_value(data["at"].clone()),
    ) else {
        return Ok(lens);
    };
    let place = TextDocumentPositionParams {
        text_document: TextDocumentIdentifier { uri },
        position,
    };
    let places = about_place(shared, place, |asked, offset| {
        let found = ladder_ide::references(&asked.context, offset, &asked.elsewhere);
        let mut places = Places::of(asked);
        let uses = found.iter().filter(|it| !it.usage.declares());
        Some(
            uses.filter_map(|it| places.location(&it.file, it.range))
                .collect::<Vec<Location>>(),
        )
    })
    .await?
    .unwrap_or_default();
    let kind = data["kind"].as_str().unwrap_or("use");
    let title = match places.len() {
        0 => format!("no {kind}s"),
        1 => format!("1 {kind}"),
        count => format!("{count} {kind}s"),
    };
    let arguments = vec![data["uri"].clone(), data["at"].clone(), json!(places)];
    lens.command = Some(command(&title, SHOW, arguments));
    Ok(lens)
}
