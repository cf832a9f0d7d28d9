//! Long texts that come in, kept out of the framework's hands.
//!
//! The framework has a buffer twice as large as the longest message that ever came, for as long as the session lasts, and
//! reads every message again and again while its pieces arrive. So the [`inlet`](super::inlet) takes long texts out of what
//! opens and changes documents, and puts tickets in their places; the [`Guard`](super::guard::Guard), which sees every message
//! that the framework has read, puts them back.

use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};

use serde_json::Value;
use tower_lsp::jsonrpc::Request;

/// In bytes. Shorter messages pass as they are.
const LONG: usize = 64 << 10;

/// Before the number of a ticket.
const TICKET: &str = "ladder-long-text-";

/// The texts whose tickets are on their way.
#[derive(Debug, Default)]
pub(crate) struct LongTexts {
    waiting: Mutex<Waiting>,
}

#[derive(Debug, Default)]
struct Waiting {
    last: u64,
    texts: HashMap<String, String>,
}

impl LongTexts {
    /// A message without its long texts.
    pub(super) fn take_out(&self, body: Vec<u8>) -> Vec<u8> {
        if body.len() <= LONG {
            return body;
        }
        let Ok(mut message) = serde_json::from_slice::<Value>(&body) else {
            return body;
        };
        let Some(method) = message.get("method").and_then(Value::as_str).map(str::to_owned) else {
            return body;
        };
        let mut any = false;
        if let Some(params) = message.get_mut("params") {
            for text in texts_of(&method, params).filter(|text| text.len() > LONG) {
                *text = self.keep(std::mem::take(text));
                any = true;
            }
        }
        if any {
            message.to_string().into_bytes()
        } else {
            body
        }
    }

    /// A message with the texts that were taken out of it.
    pub(super) fn put_back(&self, request: Request) -> Request {
        // Most messages hold none, and none is waited for.
        if self.waiting().texts.is_empty() {
            return request;
        }
        let (method, id, params) = request.into_parts();
        let mut again = Request::build(method.clone());
        if let Some(mut params) = params {
            for text in texts_of(&method, &mut params) {
                if let Some(taken) = self.waiting().texts.remove(text) {
                    *text = taken;
                }
            }
            again = again.params(params);
        }
        match id {
            Some(id) => again.id(id).finish(),
            None => again.finish(),
        }
    }

    fn keep(&self, text: String) -> String {
        let mut waiting = self.waiting();
        waiting.last += 1;
        let ticket = format!("{TICKET}{}", waiting.last);
        waiting.texts.insert(ticket.clone(), text);
        ticket
    }

    fn waiting(&self) -> std::sync::MutexGuard<'_, Waiting> {
        self.waiting.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The texts of documents in a message.
fn texts_of<'p>(method: &str, params: &'p mut Value) -> impl Iterator<Item = &'p mut String> + use<'p> {
    let holders: Vec<&mut Value> = match method {
        "textDocument/didOpen" => params.get_mut("textDocument").into_iter().collect(),
        "textDocument/didChange" => match params.get_mut("contentChanges") {
            Some(Value::Array(changes)) => changes.iter_mut().collect(),
            _ => Vec::new(),
        },
        _ => Vec::new(),
    };
    let text = |holder: &'p mut Value| match holder.get_mut("text") {
        Some(Value::String(text)) => Some(text),
        _ => None,
    };
    holders.into_iter().filter_map(text)
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn there_and_back(texts: &LongTexts, message: &Value) -> (usize, Value) {
        let short = texts.take_out(message.to_string().into_bytes());
        let request: Request = serde_json::from_slice(&short).unwrap();
        (
            short.len(),
            serde_json::to_value(texts.put_back(request)).unwrap(),
        )
    }

    #[test]
    fn long_texts_of_documents_come_back_whole() {
        let texts = LongTexts::default();
        let long = "+--[ ]( ä )--+\n".repeat(10_000);
        let opens = json!({ "jsonrpc": "2.0", "method": "textDocument/didOpen", "params": {
            "textDocument": { "uri": "file:///a", "languageId": "clad", "version": 1, "text": long } } });
        let changes = json!({ "jsonrpc": "2.0", "method": "textDocument/didChange", "params": {
            "textDocument": { "uri": "file:///a", "version": 2 },
            "contentChanges": [{ "text": "short" }, { "text": long }] } });
        for message in [opens, changes] {
            let (length, back) = there_and_back(&texts, &message);
            assert!(length < 400, "{length}");
            assert_eq!(back, message);
        }
        assert!(texts.waiting().texts.is_empty());
    }

    #[test]
    fn what_else_is_long_passes() {
        let texts = LongTexts::default();
        let long = "x".repeat(LONG);
        let asked = json!({ "jsonrpc": "2.0", "id": 4, "method": "ladder/ask", "params": { "text": long } });
        let looks_so = json!({ "jsonrpc": "2.0", "method": "textDocument/didOpen", "params": {
            "textDocument": { "uri": "file:///a", "text": "ladder-long-text-1" } } });
        for message in [asked, looks_so] {
            assert_eq!(there_and_back(&texts, &message).1, message);
        }
    }

    #[test]
    fn what_cannot_be_read_is_left_to_others() {
        let texts = LongTexts::default();
        for body in ["[".repeat(2 * LONG), "1".repeat(2 * LONG)] {
            assert_eq!(texts.take_out(body.clone().into_bytes()), body.into_bytes());
        }
    }
}
