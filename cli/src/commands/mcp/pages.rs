//! Answers in pages: small ones, since what is read costs an assistant; with the place where the next begins.

use rmcp::model::{CallToolResult, ContentBlock};
use serde_json::{Map, Value, json};

/// So many characters of a text are in one answer.
const MOST_CHARACTERS: usize = 12_000;
/// So many items of a list are in one answer.
const MOST_ITEMS: usize = 50;

/// What a tool answers.
#[derive(Debug)]
pub(super) struct Answer {
    structured: Map<String, Value>,
    picture: Option<String>,
}

impl Answer {
    /// A part of a text, from a character on. `is_ok`: the command has nothing to complain about.
    pub(super) fn text(is_ok: bool, text: &str, from: usize) -> Answer {
        let all = text.chars().count();
        let page: String = text.chars().skip(from).take(MOST_CHARACTERS).collect();
        let next = (from + MOST_CHARACTERS < all).then_some(from + MOST_CHARACTERS);
        Answer::new(is_ok, "text", json!(page), (all, next))
    }

    /// A part of a list, from an item on.
    pub(super) fn list(is_ok: bool, key: &str, items: Vec<Value>, from: usize) -> Answer {
        let all = items.len();
        let next = (from + MOST_ITEMS < all).then_some(from + MOST_ITEMS);
        let page: Vec<Value> = items.into_iter().skip(from).take(MOST_ITEMS).collect();
        Answer::new(is_ok, key, Value::Array(page), (all, next))
    }

    fn new(is_ok: bool, key: &str, page: Value, (all, next): (usize, Option<usize>)) -> Answer {
        let mut structured = Map::new();
        structured.insert("ok".to_owned(), json!(is_ok));
        structured.insert(key.to_owned(), page);
        structured.insert("total".to_owned(), json!(all));
        if let Some(next) = next {
            structured.insert("next".to_owned(), json!(next));
        }
        Answer {
            structured,
            picture: None,
        }
    }

    /// With one more member.
    pub(super) fn with(mut self, key: &str, value: Value) -> Answer {
        self.structured.insert(key.to_owned(), value);
        self
    }

    /// With a PNG picture, in base64.
    pub(super) fn with_picture(mut self, picture: String) -> Answer {
        self.picture = Some(picture);
        self
    }

    /// As the protocol has it: with its words for clients that do not read what is typed.
    pub(super) fn result(self) -> CallToolResult {
        let Answer { structured, picture } = self;
        let words = match structured.get("text").and_then(Value::as_str) {
            Some(text) => match structured.get("next") {
                Some(next) => format!("{text}\n... goes on: ask again with \"from\": {next}"),
                None => text.to_owned(),
            },
            None => Value::Object(structured.clone()).to_string(),
        };
        let mut content = vec![ContentBlock::text(words)];
        content.extend(picture.map(|picture| ContentBlock::image(picture, "image/png")));
        let mut result = CallToolResult::success(content);
        result.structured_content = Some(Value::Object(structured));
        result
    }
}
