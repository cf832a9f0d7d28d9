//! What the editor's own settings say.
//!
//! They come with `initialize`, and again whenever a person changes them: a client that can be asked is asked for the
//! section `ladder`, any other sends them along with `workspace/didChangeConfiguration`. What is in a
//! `ladder.toml` wins over them (see [`ladder_workspace::EditorSettings`]).

use std::sync::Arc;
use std::time::Duration;

use ladder_workspace::{EditorSettings, Tree};
use serde_json::Value;
use tower_lsp::ls_types::{ConfigurationItem, DidChangeConfigurationParams, Registration};

use super::diagnostics;
use crate::lsp::session::shared::Shared;

/// The section that is the server's.
const SECTION: &str = "ladder";

/// A client that does not answer by then never will; the settings stay as they are.
const PATIENCE: Duration = Duration::from_secs(30);

/// Takes the settings that come with `initialize`: the section itself, or an object that holds it.
pub(crate) fn begin(shared: &Shared, options: Option<&Value>) {
    if let Some(options) = options.filter(|options| !options.is_null()) {
        take(shared, options.get(SECTION).unwrap_or(options));
    }
}

/// Asks to be notified of changes, and for what is set now. To be spawned: no handler waits for a client's answer.
pub(crate) async fn register(shared: &Arc<Shared>) {
    if shared.agreed().registers_configuration {
        let registration = Registration {
            id: "ladder-settings".into(),
            method: "workspace/didChangeConfiguration".into(),
            register_options: Some(serde_json::json!({ "section": SECTION })),
        };
        let asked = shared.client.register_capability(vec![registration]);
        // Without it the settings stay as they are at first.
        let _ = shared.within(PATIENCE, asked).await;
    }
    if shared.agreed().configuration {
        pull(shared.clone()).await;
    }
}

/// The settings were changed.
pub(crate) fn changed(shared: &Arc<Shared>, params: &DidChangeConfigurationParams) {
    if shared.agreed().configuration {
        shared.spawn(pull(shared.clone()));
        return;
    }
    // The other sections, if there are any, are those of other servers.
    if let Some(settings) = params.settings.get(SECTION).cloned() {
        let reported_as = shared.editor_settings_asked();
        shared.in_background(move |shared| {
            if shared.editor_settings_asked_last(reported_as) {
                follow(shared, &settings);
            }
        });
    }
}

async fn pull(shared: Arc<Shared>) {
    let asked_as = shared.editor_settings_asked();
    let item = ConfigurationItem {
        scope_uri: None,
        section: Some(SECTION.to_owned()),
    };
    let asked = shared.client.configuration(vec![item]);
    let Some(Ok(answer)) = shared.within(PATIENCE, asked).await else {
        return;
    };
    // A client that has nothing set answers null; what came with `initialize` holds on.
    let Some(settings) = answer.first().filter(|settings| !settings.is_null()) else {
        return;
    };
    let settings = settings.clone();
    shared.in_background(move |shared| {
        // Answers may overtake each other; the one to the newest question counts.
        if shared.editor_settings_asked_last(asked_as) {
            follow(shared, &settings);
        }
    });
}

/// Takes new settings. Where there are open files, their workspaces are read again: for a blocking thread.
fn take(shared: &Shared, settings: &Value) {
    let (settings, errors) = EditorSettings::read(&tree(settings));
    shared.set_editor(settings);
    shared.report_settings_once(errors.join("\n"));
}

/// Takes new settings, and does what follows from them: findings and hints may be other ones.
fn follow(shared: &Arc<Shared>, settings: &Value) {
    let before = shared.editor();
    take(shared, settings);
    let now = shared.editor();
    diagnostics::look_at_everything_again(shared);
    let (next_to, agreed) = (shared.clone(), shared.agreed());
    shared.spawn(async move {
        let shared = next_to;
        // Whether the client answers is nobody's concern.
        if agreed.refreshes_inlay_hints && now.inlay_hints != before.inlay_hints {
            let _ = shared.within(PATIENCE, shared.client.inlay_hint_refresh()).await;
        }
        if agreed.refreshes_code_lenses && now.code_lens != before.code_lens {
            let _ = shared.within(PATIENCE, shared.client.code_lens_refresh()).await;
        }
    });
}

fn tree(value: &Value) -> Tree {
    match value {
        Value::Null => Tree::Nothing,
        Value::Bool(switch) => Tree::Switch(*switch),
        Value::Number(number) => whole(number).map_or(Tree::Other, Tree::Whole),
        Value::String(text) => Tree::Text(text.clone()),
        Value::Array(items) => Tree::List(items.iter().map(tree).collect()),
        Value::Object(table) => {
            let entries = table.iter();
            Tree::Table(entries.map(|(key, value)| (key.clone(), tree(value))).collect())
        }
    }
}

/// Some clients have no whole numbers, and write 120.0.
fn whole(number: &serde_json::Number) -> Option<i64> {
    const EXACT: f64 = (1_u64 << 53) as f64;
    let as_float = || {
        number
            .as_f64()
            .filter(|it| it.fract() == 0.0 && it.abs() <= EXACT)
    };
    number.as_i64().or_else(|| as_float().map(|it| it as i64))
}
