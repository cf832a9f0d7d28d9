//! `ladder.simulate.debug` and the messages of debuggers: a simulation that the editor shows is what a debugger works on.

use std::io;
use std::sync::Arc;

use futures::StreamExt;
use futures::channel::mpsc::{UnboundedReceiver, unbounded};
use ladder_analysis::Cancel;
use ladder_debugger::{Launch, Output, answer_of_none, is_urgent};
use ladder_documents::Revision;
use ladder_live::messages::{Debug, Debugged, DebuggerMessage};
use ladder_live::{Action, Failure, Pace};
use serde_json::Value;
use tower_lsp::Client;
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::LSPAny;
use tower_lsp::ls_types::notification::Notification;

use super::of_scenarios::{on_disk, shown};
use super::simulate::{Debugging, act, answer, begin};
use crate::lsp::answers::{error, json};
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;

/// What a debugger says.
#[derive(Debug)]
enum FromDebugger {}

impl Notification for FromDebugger {
    type Params = DebuggerMessage;
    const METHOD: &'static str = "ladder/fromDebugger";
}

/// Starts what a configuration names with a debugger, or lets one join the simulation of that program which is there.
pub(super) async fn debug(shared: &Arc<Shared>, Debug { launch, mut options }: Debug) -> Result<LSPAny> {
    let world = shared.world().clone();
    let launch = blocking(&*shared.host, move |_| Launch::read(&launch, world)).await?;
    let launch = launch.map_err(failed)?;
    let revision = program(shared, &launch).await?;
    let there = shared.sessions.of(&revision.uri).pop();
    let (sent, messages) = unbounded();
    let output: Output = Box::new(move |message| {
        sent.unbounded_send(message.clone())
            .map_err(|_| io::ErrorKind::BrokenPipe.into())
    });
    if let Some(session) = there.filter(|_| !launch.is_scenario()) {
        answer(&session, Action::Debug(launch.begin(output, true))).await?;
        shared.spawn(pass_on(shared.client.clone(), session.id.clone(), messages));
        let state = act(shared, &session.id, Action::State).await?;
        return json(&Debugged {
            session: session.id.clone(),
            joined: true,
            state,
            first: None,
            notes: Vec::new(),
        });
    }
    let interval = launch.interval().map_err(failed)?;
    options.interval_ms = interval
        .map(|interval| interval as f64 / 1e6)
        .or(options.interval_ms);
    options.history = launch.history().or(options.history);
    let debugging = Debugging {
        keeping: launch.keeping().map_err(failed)?,
        pace: launch.speed().map_err(failed)?.map_or(Pace::Full, Pace::Times),
        beginning: launch.begin(output, false),
    };
    let started = begin(shared, revision, options, Some(debugging)).await?;
    shared.spawn(pass_on(shared.client.clone(), started.session.clone(), messages));
    json(&Debugged {
        session: started.session,
        joined: false,
        state: json(&started.state)?,
        first: started.first,
        notes: started.notes,
    })
}

/// The text to run: as the editor shows it, else as it is on disk.
async fn program(shared: &Arc<Shared>, launch: &Launch) -> Result<Arc<Revision>> {
    let path = launch.program().to_owned();
    if let Some(revision) = shown(shared, &path) {
        return Ok(revision);
    }
    let name = ladder_workspace::shown::path(&path);
    let next_to = shared.clone();
    let found = blocking(&*shared.host, move |_| {
        let shared = next_to;
        let path = shared.world().disk.canonicalize(&path).ok()?;
        shown(&shared, &path).or_else(|| on_disk(&shared, &path))
    });
    found
        .await?
        .ok_or_else(|| failed(format!("{name} cannot be read")))
}

/// A message of a client for its debugger.
pub(crate) fn receive(shared: &Arc<Shared>, DebuggerMessage { session, message }: DebuggerMessage) {
    let is_urgent = is_urgent(&message);
    match shared.sessions.get(&session) {
        Ok(session) => drop(session.ask(Action::Message(message, is_urgent), Cancel::default())),
        // A client may say good-bye to a simulation that is over already.
        Err(_) => {
            let Some(message) = answer_of_none(&message) else {
                return;
            };
            let (client, params) = (shared.client.clone(), DebuggerMessage { session, message });
            shared.spawn(async move { client.send_notification::<FromDebugger>(params).await });
        }
    }
}

/// Sends the client what its debugger says, in that order.
async fn pass_on(client: Client, session: String, mut messages: UnboundedReceiver<Value>) {
    while let Some(message) = messages.next().await {
        let session = session.clone();
        client
            .send_notification::<FromDebugger>(DebuggerMessage { session, message })
            .await;
    }
}

fn failed(problem: String) -> tower_lsp::jsonrpc::Error {
    error(Failure::Failed(problem))
}
