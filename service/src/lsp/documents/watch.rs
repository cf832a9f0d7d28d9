//! The files next to the open documents: a client that can is asked to report changes; for any other the server looks
//! for itself, now and then.

use std::sync::{Arc, PoisonError};
use std::time::Duration;

use serde_json::json;
use tower_lsp::ls_types::Registration;

use super::diagnostics;
use crate::lsp::session::shared::Shared;

/// A client that does not answer by then never will; nothing depends on it.
const PATIENCE: Duration = Duration::from_secs(30);

/// The server looks for itself no more often.
const PACE: Duration = Duration::from_secs(2);

/// Registers for programs and settings files, if the client watches files. To be spawned: no handler waits for a client's answer.
pub(crate) async fn register(shared: &Arc<Shared>) {
    if !shared.agreed().watches_files {
        return;
    }
    let registration = Registration {
        id: "ladder-files".into(),
        method: "workspace/didChangeWatchedFiles".into(),
        register_options: Some(json!({
            "watchers": [{ "globPattern": "**/*.clad" }, { "globPattern": "**/ladder.toml" }, { "globPattern": "**/*nicknames.csv" }, { "globPattern": "**/*.{s7dcl,s7res,scl,TcPOU,TcDUT,TcGVL}" }]
        })),
    };
    let asked = shared.client.register_capability(vec![registration]);
    // Without it the server goes on with what it read at first.
    let _ = shared.within(PATIENCE, asked).await;
}

/// Looks whether files are other ones than those that were read, if the client does not report that. The one who
/// calls does not wait for it.
pub(crate) fn look_around(shared: &Arc<Shared>) {
    if shared.agreed().watches_files {
        return;
    }
    let mut last = shared
        .looked_around
        .lock()
        .unwrap_or_else(PoisonError::into_inner);
    let now = shared.world().clock.now();
    if last.is_some_and(|last| now.saturating_sub(last) < PACE) {
        return;
    }
    *last = Some(now);
    drop(last);
    shared.in_background(|shared| {
        let changed = shared.neighbours.changed_on_disk();
        if !changed.is_empty() {
            diagnostics::files_changed(shared, &changed);
        }
    });
}
