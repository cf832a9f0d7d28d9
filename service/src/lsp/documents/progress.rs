//! Progress of long work, for clients that show it.
//!
//! Work never waits for it: steps are put into a channel, and a task sends them when the client has agreed to see
//! them. What is done within a moment is not shown at all.

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::Duration;

use ladder_host::newest::{Receiver, Sender, newest};
use ladder_host::{Host, within};
use tower_lsp::Client;
use tower_lsp::ls_types::notification;
use tower_lsp::ls_types::{
    NumberOrString, ProgressParams, ProgressParamsValue, ProgressToken, WorkDoneProgress,
    WorkDoneProgressBegin, WorkDoneProgressEnd, WorkDoneProgressReport,
};

use crate::lsp::session::shared::Shared;

/// Work that takes no longer than this is not worth a line on the screen.
const MOMENT: Duration = Duration::from_millis(200);

/// Steps are reported no more often.
const PACE: Duration = Duration::from_millis(100);

/// A client that has not agreed by then sees nothing.
const PATIENCE: Duration = Duration::from_secs(30);

/// Work that is under way. When it is dropped the work is done.
#[derive(Debug)]
pub(crate) struct Progress {
    steps: Option<Sender<Advance>>,
}

/// How far the work is.
#[derive(Debug, Clone, Default)]
struct Advance {
    percentage: u32,
    message: String,
}

impl Progress {
    /// Of work that the server began by itself.
    pub(crate) fn begin(shared: &Arc<Shared>, title: &'static str) -> Progress {
        static SERIAL: AtomicU32 = AtomicU32::new(0);
        if !shared.agreed().progress {
            return Progress { steps: None };
        }
        let serial = SERIAL.fetch_add(1, Ordering::Relaxed);
        let token = NumberOrString::String(format!("ladder-{serial}"));
        let (sender, steps) = newest(Advance::default());
        let (client, host) = (shared.client.clone(), shared.host.clone());
        shared.spawn(async move {
            let mut steps = steps;
            if ends_within(&*host, &mut steps, MOMENT).await {
                return;
            }
            let asked = client.create_work_done_progress(token.clone());
            if let Some(Ok(())) = within(&*host, PATIENCE, asked).await {
                show(client, host, token, title, steps).await;
            }
        });
        Progress { steps: Some(sender) }
    }

    /// Of a request: shown if the client gave it a token.
    pub(crate) fn of_request(shared: &Shared, token: Option<ProgressToken>, title: &'static str) -> Progress {
        let Some(token) = token else {
            return Progress { steps: None };
        };
        let (sender, steps) = newest(Advance::default());
        shared.spawn(show(
            shared.client.clone(),
            shared.host.clone(),
            token,
            title,
            steps,
        ));
        Progress { steps: Some(sender) }
    }

    /// Tells how far the work is: how much of how much, and what is checked now.
    pub(crate) fn report(&self, done: usize, all: usize, at: &Path) {
        if let Some(steps) = &self.steps {
            let name = at.file_name().unwrap_or_default().to_string_lossy();
            let step = Advance {
                percentage: (done * 100 / all.max(1)) as u32,
                message: format!("{done}/{all} {name}"),
            };
            steps.send(step);
        }
    }
}

/// Whether the work ends within this time.
async fn ends_within(host: &dyn Host, steps: &mut Receiver<Advance>, time: Duration) -> bool {
    let end = async { while steps.next().await.is_some() {} };
    within(host, time, end).await.is_some()
}

async fn show(
    client: Client,
    host: Arc<dyn Host>,
    token: ProgressToken,
    title: &'static str,
    mut steps: Receiver<Advance>,
) {
    let tell = async |value| {
        let params = ProgressParams {
            token: token.clone(),
            value: ProgressParamsValue::WorkDone(value),
        };
        client.send_notification::<notification::Progress>(params).await;
    };
    tell(WorkDoneProgress::Begin(WorkDoneProgressBegin {
        title: title.to_owned(),
        cancellable: Some(false),
        message: None,
        percentage: Some(0),
    }))
    .await;
    while let Some(step) = steps.next().await {
        tell(WorkDoneProgress::Report(WorkDoneProgressReport {
            cancellable: Some(false),
            message: Some(step.message),
            percentage: Some(step.percentage),
        }))
        .await;
        host.sleep(PACE).await;
    }
    tell(WorkDoneProgress::End(WorkDoneProgressEnd { message: None })).await;
}
