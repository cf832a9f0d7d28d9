//! Asks the client to tell of changes to the files beside the open documents.

use std::time::Duration;

use serde_json::json;
use tower_lsp::Client;
use tower_lsp::ls_types::Registration;

/// A client that does not answer by then never will; nothing depends on it.
const PATIENCE: Duration = Duration::from_secs(30);

/// Registers for programs and settings files. To be spawned: no handler waits for a client's answer.
pub(super) async fn register(client: Client) {
    let registration = Registration {
        id: "ladder-files".into(),
        method: "workspace/didChangeWatchedFiles".into(),
        register_options: Some(json!({
            "watchers": [{ "globPattern": "**/*.clad" }, { "globPattern": "**/ladder.toml" }]
        })),
    };
    let asked = client.register_capability(vec![registration]);
    // Without it the server goes on with what it read at first.
    let _ = tokio::time::timeout(PATIENCE, asked).await;
}
