//! What a client sends as messages; what is not one is answered.
//!
//! Broken JSON, bytes that are not UTF-8, numbers or nesting that the reader of JSON refuses, a header in small letters or
//! with the wrong length: none of them ends the session. What cannot be understood becomes the error that it is answered
//! with. How the bytes are split into messages is for the program around the server to know.

use std::fmt;

use serde::Deserialize;
use serde::de::IgnoredAny;
use serde_json::Value;
use tower_lsp::jsonrpc::{Error, ErrorCode, Id, Request, Response};

use super::surrogates::replace_lone_surrogates;

/// What the client has sent.
#[derive(Debug)]
pub struct Received(pub(in crate::lsp) Kind);

#[derive(Debug)]
pub(in crate::lsp) enum Kind {
    /// A request, or a notification.
    Request(Request),
    /// The answer to a request of the server.
    Answer(Response),
    /// Something that cannot be understood, with the answer to it.
    Broken(Response),
}

impl Received {
    /// The message in a body.
    pub fn read(body: &mut [u8]) -> Received {
        replace_lone_surrogates(body);
        Received(read(body))
    }

    /// A message of so many bytes, which is longer than the `longest` that the server accepts.
    pub fn too_long(length: u64, longest: u64) -> Received {
        Received(broken(
            ErrorCode::InvalidRequest,
            format!(
                "a message of {length} bytes is longer than the server accepts ({longest}); it was skipped"
            ),
            Id::Null,
        ))
    }

    /// Bytes between messages.
    pub fn stray() -> Received {
        Received(broken(
            ErrorCode::ParseError,
            "a message header has no Content-Length that is a number, or there is none; what followed was skipped up to the next one",
            Id::Null,
        ))
    }

    /// Whether it cannot be understood.
    pub fn is_broken(&self) -> bool {
        matches!(self.0, Kind::Broken(_))
    }
}

fn broken(code: ErrorCode, message: impl Into<String>, id: Id) -> Kind {
    let error = Error {
        code,
        message: message.into().into(),
        data: None,
    };
    Kind::Broken(Response::from_error(id, error))
}

/// As JSON; of what cannot be understood the answer to it.
impl fmt::Display for Received {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let json = match &self.0 {
            Kind::Request(request) => serde_json::to_string(request),
            Kind::Answer(answer) | Kind::Broken(answer) => serde_json::to_string(answer),
        };
        f.write_str(&json.map_err(|_| fmt::Error)?)
    }
}

/// As much of a message that is not read as says whom to answer.
#[derive(Deserialize, Default)]
struct Addressed {
    #[serde(default)]
    id: Option<Value>,
}

fn read(body: &[u8]) -> Kind {
    let Ok(text) = std::str::from_utf8(body) else {
        return broken(ErrorCode::ParseError, "the message is not UTF-8", Id::Null);
    };
    let id = |id: Option<Value>| {
        let id = id.and_then(|id| serde_json::from_value(id).ok());
        id.unwrap_or(Id::Null)
    };
    let invalid = |message: String, id| broken(ErrorCode::InvalidRequest, message, id);
    let value = match serde_json::from_str::<Value>(text) {
        Ok(value) => value,
        Err(refused) => {
            if let Err(error) = serde_json::from_str::<IgnoredAny>(text) {
                return broken(
                    ErrorCode::ParseError,
                    format!("the message is not JSON: {error}"),
                    Id::Null,
                );
            }
            let addressed = serde_json::from_str::<Addressed>(text).unwrap_or_default();
            let message = format!("the message holds what the server does not read: {refused}");
            return invalid(message, id(addressed.id));
        }
    };
    let Value::Object(fields) = &value else {
        let message = "a message is an object; several at once are not read, send one after the other";
        return invalid(message.into(), Id::Null);
    };
    let (told, is_request) = (fields.get("id").cloned(), fields.contains_key("method"));
    let wrong = if fields.get("jsonrpc").and_then(Value::as_str) != Some("2.0") {
        "the message does not say \"jsonrpc\": \"2.0\""
    } else if is_request {
        match serde_json::from_value(value) {
            Ok(request) => return Kind::Request(request),
            Err(_) => "the method is not text, or the id is neither a whole number nor text",
        }
    } else {
        match serde_json::from_value(value) {
            Ok(answer) => return Kind::Answer(answer),
            Err(_) => "the message is neither a request nor an answer",
        }
    };
    invalid(wrong.into(), id(told))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is read in a body, as JSON.
    fn received(body: &str) -> String {
        Received::read(&mut body.to_owned().into_bytes()).to_string()
    }

    #[test]
    fn the_answer_goes_to_whom_it_belongs() {
        let deep = format!(
            r#"{{"jsonrpc":"2.0","id":6,"method":"x","params":{}}}"#,
            "[".repeat(500) + &"]".repeat(500)
        );
        for (body, id, code) in [
            (r#"{"jsonrpc":"1.0","id":4,"method":"x"}"#, "4", -32600),
            (r#"{"jsonrpc":"2.0","id":"a","method":7}"#, "\"a\"", -32600),
            (r#"{"jsonrpc":"2.0","id":5}"#, "5", -32600),
            (r#"{"jsonrpc":"2.0","id":1.5,"method":"x"}"#, "null", -32600),
            (
                r#"{"jsonrpc":"2.0","id":7,"method":"x","params":[1e400]}"#,
                "7",
                -32600,
            ),
            (&deep, "6", -32600),
            ("[]", "null", -32600),
            (r#"["2.0","x",1]"#, "null", -32600),
            ("not json", "null", -32700),
        ] {
            let received = received(body);
            assert!(
                received.contains(&format!("\"id\":{id}}}")) && received.contains(&code.to_string()),
                "{body}: {received}"
            );
        }
    }
}
