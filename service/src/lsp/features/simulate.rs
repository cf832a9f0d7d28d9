//! `workspace/executeCommand` and `ladder/simulationState`: the simulator.

use std::sync::Arc;

use ladder_analysis::Cancel;
use ladder_documents::Revision;
use ladder_host::Host;
use ladder_host::newest::Receiver;
use ladder_live::messages::{OfSession, Options, Show, Shown, Start, Started, State, Status, Stopped};
use ladder_live::{
    Action, Answer, Beginning, Begun, Failure, Given, Keeping, Pace, REPORT, Request, Session, status_text,
};
use serde_json::Value;
use tower_lsp::Client;
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::notification::Notification;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny, Position};

use super::debug;
use crate::lsp::answers::{error, json};
use crate::lsp::convert;
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::{answered::answered, blocking::blocking};

/// How many times as fast as real time a run may be.
const SPEEDS: std::ops::RangeInclusive<f64> = 0.001..=1000.0;

/// A hover does not wait longer for the values of a simulation, which may be within a long step.
const PATIENCE: std::time::Duration = std::time::Duration::from_millis(200);

/// The values of this many scans are sent unless more are asked for.
const PAST: u64 = 100;

/// The notification that shows how a simulation is.
#[derive(Debug)]
enum SimulationState {}

impl Notification for SimulationState {
    type Params = State;
    const METHOD: &'static str = "ladder/simulationState";
}

pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<Option<LSPAny>> {
    let request = Request::read(&params.command, params.arguments).map_err(error)?;
    let answer = match request {
        Request::Start(it) => return start(shared, it).await,
        Request::Debug(it) => debug::debug(shared, it).await,
        Request::Step(it) => act(shared, &it.session, Action::Step(it.scans.unwrap_or(1))).await,
        Request::StepBlock(it) => act(shared, &it.session, Action::StepBlock).await,
        Request::StepRung(it) => act(shared, &it.session, Action::StepRung).await,
        Request::Back(it) => act(shared, &it.session, Action::Back(it.scans.unwrap_or(1))).await,
        Request::GoTo(it) => act(shared, &it.session, Action::GoTo(it.scan)).await,
        Request::Trace(it) => act(shared, &it.session.clone(), Action::Trace(it)).await,
        Request::Breakpoints(it) => act(shared, &it.session, Action::Breakpoints(it.lines, it.tags)).await,
        Request::Why(it) => act(shared, &it.session, Action::Why(it.tag)).await,
        Request::History(it) => {
            let scans = it.scans.unwrap_or(PAST);
            act(shared, &it.session, Action::History(it.tags, scans)).await
        }
        Request::Record(it) => {
            let name = it.name.unwrap_or_else(|| "recorded".to_owned());
            act(shared, &it.session, Action::Record(name, it.outputs)).await
        }
        Request::Run(it) => {
            let pace = pace(it.real_time, it.speed)?;
            let scans = it.scans;
            act(shared, &it.session, Action::Run { scans, pace }).await
        }
        Request::Speed(it) => {
            let pace = pace(it.real_time, it.speed)?.unwrap_or_default();
            act(shared, &it.session, Action::Pace(pace)).await
        }
        Request::Pause(it) => act(shared, &it.session, Action::Pause).await,
        Request::Set(it) => {
            let given = given(&it.tag, it.value, it.text)?;
            act(shared, &it.session, Action::Set(it.tag, given)).await
        }
        Request::Pulse(it) => act(shared, &it.session, Action::Pulse(it.tag)).await,
        Request::Force(it) => {
            let given = given(&it.tag, it.value, it.text)?;
            act(shared, &it.session, Action::Force(it.tag, given)).await
        }
        Request::Unforce(it) => act(shared, &it.session, Action::Unforce(it.tag)).await,
        Request::Serve(it) => act(shared, &it.session, Action::Serve(it.on)).await,
        Request::State(it) => act(shared, &it.session, Action::State).await,
        Request::Show(Show { session, lines, tags }) => {
            act(shared, &session, Action::Show(Shown { lines, tags })).await
        }
        Request::Tags(it) => act(shared, &it.session.clone(), Action::Tags(it)).await,
        Request::Reset(it) => act(shared, &it.session, Action::Reset).await,
        Request::WarmRestart(it) => act(shared, &it.session, Action::WarmRestart).await,
        Request::Stop(it) => stop(shared, it).await,
    };
    answer.map(Some)
}

/// The value for a tag.
fn given(tag: &str, value: Option<Value>, text: Option<String>) -> Result<Given> {
    match (value, text) {
        (Some(value), None) => Ok(Given::Json(value)),
        (None, Some(text)) => Ok(Given::Typed(text)),
        _ => Err(error(Failure::Invalid(format!(
            "{tag} takes a value or a text: give one of the two"
        )))),
    }
}

/// How fast a run is to go; None if neither is set.
fn pace(real_time: Option<bool>, speed: Option<f64>) -> Result<Option<Pace>> {
    match (real_time, speed) {
        (Some(false), None) => Ok(Some(Pace::Full)),
        (Some(false), Some(_)) => Err(error(Failure::Invalid(
            "a run that is not in real time has no speed: give one of the two".into(),
        ))),
        (_, Some(speed)) if !SPEEDS.contains(&speed) => Err(error(Failure::Invalid(format!(
            "speed is {speed}; it must be from 0.001 to 1000 times real time"
        )))),
        (_, Some(speed)) => Ok(Some(Pace::Times(speed))),
        (Some(true), None) => Ok(Some(Pace::default())),
        (None, None) => Ok(None),
    }
}

/// The client has shown what a session sent it.
pub(crate) fn has_shown(shared: &Arc<Shared>, OfSession { session }: OfSession) {
    // One that has ended meanwhile is not an error.
    if let Ok(session) = shared.sessions.get(&session) {
        drop(session.ask(Action::HasShown, Cancel::default()));
    }
}

/// What the operand at a place holds in the simulations of a document, in words; nothing of one that is busy.
pub(crate) async fn values_at(shared: &Arc<Shared>, uri: &str, position: Position) -> Vec<String> {
    let Some(revision) = shared.simulated(uri) else {
        return Vec::new();
    };
    let mut sent = Vec::new();
    for session in shared.sessions.of(uri) {
        let offset = revision.offset(convert::our_position(position));
        let answer = session.ask(Action::ValuesAt(offset), Cancel::default());
        if let Some(Ok(Ok(Answer::Values(values)))) = shared.within(PATIENCE, answer).await {
            sent.extend(values);
        }
    }
    sent
}

async fn start(shared: &Arc<Shared>, Start { uri, options }: Start) -> Result<Option<LSPAny>> {
    let revision = shared
        .simulated(&uri)
        .ok_or_else(|| error(not_open(shared, &uri)))?;
    json(&begin(shared, revision, options, None).await?).map(Some)
}

/// What a simulation is started with to be debugged.
pub(super) struct Debugging {
    pub(super) keeping: Keeping,
    pub(super) pace: Pace,
    pub(super) beginning: Beginning,
}

/// Starts a simulation of a text.
pub(super) async fn begin(
    shared: &Arc<Shared>,
    revision: Arc<Revision>,
    options: Options,
    debugging: Option<Debugging>,
) -> Result<Started> {
    let (name, job, uri) = (shared.sessions.new_name(), revision.clone(), revision.uri.clone());
    let deltas = options.deltas;
    let running = shared.sessions.running();
    let (keeping, debugging) = match debugging {
        Some(it) => (it.keeping, Some((it.pace, it.beginning))),
        None => (Keeping::default(), None),
    };
    let host = shared.host.clone();
    let started = blocking(&*shared.host, move |_| {
        Session::start(name, job, &options, &keeping, &*host, &running)
    });
    let started = started.await?;
    let (session, begun) = started.map_err(error)?;
    let Begun { states, notes, first } = begun;
    let mut state = states.get();
    if let Some((pace, beginning)) = debugging {
        answer(&session, Action::Debug(beginning)).await?;
        drop(session.ask(Action::Pace(pace), Cancel::default()));
    }
    // No `await` from here on: a request that is cancelled must not leave a session that nobody knows of.
    let session = shared.sessions.add(session).map_err(error)?;
    // All of what is shown.
    state.delta = false;
    let host = shared.host.clone();
    let reports = report(shared.client.clone(), host, state.clone(), states, deltas);
    // A client that does not know the session yet would not take a state, and would wait for the next one for ever.
    let answered = answered();
    shared.spawn(async {
        answered.await;
        reports.await;
    });
    // A change may have come while the program was compiled, when nobody could tell the session.
    if let Some(newest) = shared.simulated(&uri)
        && !newest.is(&revision)
    {
        drop(session.ask(Action::Follow(newest), Cancel::default()));
    }
    Ok(Started {
        session: session.id.clone(),
        state,
        first,
        notes,
    })
}

/// Why there is nothing to simulate.
fn not_open(shared: &Shared, uri: &str) -> Failure {
    let companion = shared.companions.get(uri);
    Failure::Failed(
        match companion.filter(|revision| revision.kind().notation().is_some()) {
            Some(revision) => format!(
                "{} is a program of another system; what runs is the ladder text that ladder.preview gives: open that",
                revision.name()
            ),
            None => format!("{uri} is not open in the editor; open it and start again"),
        },
    )
}

async fn stop(shared: &Arc<Shared>, OfSession { session }: OfSession) -> Result<LSPAny> {
    let removed = shared.sessions.remove(&session).map_err(error)?;
    answer(&removed, Action::Stop).await?;
    json(&Stopped {
        session,
        stopped: true,
    })
}

pub(super) async fn act(shared: &Arc<Shared>, session: &str, action: Action) -> Result<LSPAny> {
    let session = shared.sessions.get(session).map_err(error)?;
    json(&answer(&session, action).await?)
}

/// Waits for the session's answer. When the client cancels the request, the guard is dropped with this future and
/// a long step ends.
pub(super) async fn answer(session: &Session, action: Action) -> Result<Answer> {
    let cancel = Cancel::default();
    let _guard = cancel.on_drop();
    match session.ask(action, cancel).await {
        Ok(outcome) => outcome.map_err(error),
        Err(_) => Err(error(Failure::Failed(format!(
            "the simulation {} has stopped",
            session.id
        )))),
    }
}

/// Sends states to the client: the newest, at most one in each interval, and the last one always. With `deltas` only
/// what has changed since the one before, which at first is `before`; the first after an answer is whole, for it may be
/// older than that.
async fn report(
    client: Client,
    host: Arc<dyn Host>,
    mut before: State,
    mut states: Receiver<State>,
    deltas: bool,
) {
    while let Some(state) = states.next().await {
        if state.commands.is_some() {
            // What has changed already, and sent only to a client that waits for it.
            client.send_notification::<SimulationState>(state).await;
            continue;
        }
        let sent = if deltas && state.answers == before.answers {
            state.since(&before)
        } else {
            state.clone()
        };
        before = state;
        client.send_notification::<SimulationState>(sent).await;
        host.sleep(REPORT).await;
    }
    // A thread that ends without saying so has met an error in the scan engine; the client must not go on
    // showing a program that runs.
    let last = states.get();
    if last.status != Status::Ended {
        let mut ended = State {
            status: Status::Ended,
            ..last
        };
        ended.text = status_text(&ended, Pace::default());
        client.send_notification::<SimulationState>(ended).await;
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use futures::StreamExt;
    use serde_json::json;
    use tower::Service;
    use tower_lsp::LspService;

    use super::*;
    use crate::lsp::backend::Backend;
    use crate::lsp::transport::guard::{Answer, Guard};
    use ladder_host::Busy;
    use ladder_host::newest::newest;
    use ladder_host::testing::TestHost;
    use ladder_host::{EventLoop, within};

    /// A client that is slow to take an answer sees this: the state of a change must not overtake the answer to the
    /// start. Which of the two the framework writes first cannot be told from outside.
    #[test]
    fn no_state_goes_out_before_the_answer_to_the_start() {
        let host = TestHost::default();
        host.run(start_and_change(host.host.clone()));
    }

    async fn start_and_change(host: Arc<EventLoop>) {
        let (service, socket) = LspService::new(|client| Backend::new(client, host.clone(), Busy::default()));
        let outbox = service.inner().shared().outbox.clone();
        let mut guard = Guard::new(service, outbox);
        let mut call = async |message: Value| -> Answer {
            let request = serde_json::from_value(message).unwrap();
            guard.ready().await.unwrap();
            guard.call(request).await
        };
        let uri = "file:///a.clad";
        let text = "+--[ ]( a )--( )( y )--+\n";
        let show = json!({"lines": [{"first": 0, "last": 0}], "tags": []});
        let start = json!({"uri": uri, "options": {"show": show}});
        let mut started = Answer::default();
        for message in [
            json!({"id": 1, "method": "initialize", "params": {"capabilities": {}}}),
            json!({"method": "textDocument/didOpen", "params": {"textDocument":
                {"uri": uri, "languageId": "clad", "version": 1, "text": text}}}),
            json!({"id": 2, "method": "workspace/executeCommand", "params":
                {"command": "ladder.simulate.start", "arguments": [start]}}),
            json!({"method": "textDocument/didChange", "params": {"textDocument": {"uri": uri, "version": 2},
                "contentChanges": [{"text": format!("# more #\n{text}")}]}}),
        ] {
            let mut message = message;
            message["jsonrpc"] = "2.0".into();
            let answer = call(message).await;
            if answer.1.place.is_some() {
                started = answer;
            }
        }

        let (sent, _answers) = socket.split();
        let mut states = sent.filter(|it| std::future::ready(it.method() == SimulationState::METHOD));
        let early = within(&*host, Duration::from_millis(200), states.next()).await;
        assert!(early.is_none(), "{early:?}");

        let (answer, left) = started;
        assert!(
            serde_json::to_string(&answer)
                .unwrap()
                .contains(r#""session":"s1""#)
        );
        drop(left);
        let state = within(&*host, Duration::from_secs(10), states.next()).await;
        assert_eq!(state.unwrap().unwrap().params().unwrap()["version"], 2);
    }

    #[test]
    fn a_session_whose_runner_is_gone_is_shown_as_ended() {
        let host = TestHost::default();
        host.run(end_early(host.host.clone()));
    }

    async fn end_early(host: Arc<EventLoop>) {
        let (mut service, socket) =
            LspService::new(|client| Backend::new(client, host.clone(), Busy::default()));
        let initialize = serde_json::json!({"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {"capabilities": {}}});
        service
            .call(serde_json::from_value(initialize).unwrap())
            .await
            .unwrap();
        let state = State {
            session: "s1".into(),
            uri: "file:///a.clad".into(),
            version: 1,
            stale: false,
            change: None,
            program: 0,
            status: Status::Paused,
            text: String::new(),
            controller: None,
            served: None,
            scan: 0,
            time_ms: 0.0,
            scenes: Vec::new(),
            tags: Vec::new(),
            power: Vec::new(),
            faults: Vec::new(),
            behind: 0,
            ahead: 0,
            next: None,
            hit: None,
            breakpoints: Vec::new(),
            forced: 0,
            delta: false,
            answers: 0,
            commands: None,
            operands: Vec::new(),
            labels: None,
        };
        let (states, seen) = newest(state.clone());
        let client = service.inner().shared().client.clone();
        host.spawn(Box::pin(report(client, host.clone(), state.clone(), seen, false)));
        states.send(State {
            status: Status::Running,
            scan: 7,
            ..state
        });
        drop(states);
        let sent: Vec<_> = socket
            .take(2)
            .map(|request| {
                let params = request.params().unwrap();
                (params["status"].clone(), params["scan"].clone())
            })
            .collect()
            .await;
        assert_eq!(sent, [("running".into(), 7.into()), ("ended".into(), 7.into())]);
    }
}
