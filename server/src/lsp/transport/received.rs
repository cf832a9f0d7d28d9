//! The client's bytes as messages; what is not one is answered.
//!
//! Broken JSON, bytes that are not UTF-8, numbers or nesting that the reader of JSON refuses, a header in small letters or
//! with the wrong length: none of them ends the session. The bytes are split into [`frames`](crate::frames), and what cannot
//! be understood becomes the error that it is answered with.

use serde::Deserialize;
use serde::de::IgnoredAny;
use serde_json::Value;
use tokio::io::AsyncRead;
use tokio::sync::mpsc::Sender;
use tower_lsp::jsonrpc::{Error, ErrorCode, Id, Request, Response};

use super::surrogates::replace_lone_surrogates;
use crate::frames::{Frame, Frames, LONGEST_MESSAGE};

/// What the client has sent.
#[derive(Debug)]
pub(crate) enum Received {
    /// A request, or a notification.
    Request(Request),
    /// The answer to a request of the server.
    Answer(Response),
    /// Something that cannot be understood, with the answer to it.
    Broken(Response),
}

/// Passes the client's messages on until either side ends.
pub(crate) async fn receive(input: impl AsyncRead + Unpin, messages: Sender<Received>) {
    let mut frames = Frames::of(input);
    while let Ok(Some(frame)) = frames.next().await {
        let message = match frame {
            Frame::Body(body) => message(body, &mut frames),
            Frame::TooLong(length) => broken(
                ErrorCode::InvalidRequest,
                format!(
                    "a message of {length} bytes is longer than the server accepts ({LONGEST_MESSAGE}); it was skipped"
                ),
                Id::Null,
            ),
            Frame::Stray => broken(
                ErrorCode::ParseError,
                "a message header has no Content-Length that is a number, or there is none; what followed was skipped up to the next one",
                Id::Null,
            ),
        };
        if messages.send(message).await.is_err() {
            return;
        }
    }
}

fn broken(code: ErrorCode, message: impl Into<String>, id: Id) -> Received {
    let error = Error {
        code,
        message: message.into().into(),
        data: None,
    };
    Received::Broken(Response::from_error(id, error))
}

/// The message in a body, which may have the next header at its end.
fn message<R: AsyncRead + Unpin>(mut body: Vec<u8>, frames: &mut Frames<R>) -> Received {
    replace_lone_surrogates(&mut body);
    let read = read(&body);
    if !matches!(read, Received::Broken(_)) {
        return read;
    }
    if frames.end_at_header(&mut body) {
        let shorter = self::read(&body);
        if !matches!(shorter, Received::Broken(_)) {
            return shorter;
        }
    }
    frames.skip_quietly();
    read
}

/// As much of a message that is not read as says whom to answer.
#[derive(Deserialize, Default)]
struct Addressed {
    #[serde(default)]
    id: Option<Value>,
}

fn read(body: &[u8]) -> Received {
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
    let (said, is_request) = (fields.get("id").cloned(), fields.contains_key("method"));
    let wrong = if fields.get("jsonrpc").and_then(Value::as_str) != Some("2.0") {
        "the message does not say \"jsonrpc\": \"2.0\""
    } else if is_request {
        match serde_json::from_value(value) {
            Ok(request) => return Received::Request(request),
            Err(_) => "the method is not text, or the id is neither a whole number nor text",
        }
    } else {
        match serde_json::from_value(value) {
            Ok(answer) => return Received::Answer(answer),
            Err(_) => "the message is neither a request nor an answer",
        }
    };
    invalid(wrong.into(), id(said))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is read in these bytes, a message a line.
    fn received(input: &[u8]) -> String {
        let (sender, mut messages) = tokio::sync::mpsc::channel(100);
        tokio::runtime::Builder::new_current_thread()
            .build()
            .unwrap()
            .block_on(receive(input, sender));
        let mut all = String::new();
        while let Ok(message) = messages.try_recv() {
            all += &match message {
                Received::Request(request) => serde_json::to_string(&request),
                Received::Answer(answer) => serde_json::to_string(&answer),
                Received::Broken(answer) => serde_json::to_string(&answer),
            }
            .unwrap();
            all.push('\n');
        }
        all
    }

    fn frame(body: &str) -> String {
        format!("Content-Length: {}\r\n\r\n{body}", body.len())
    }

    const EXIT: &str = r#"{"jsonrpc":"2.0","method":"exit"}"#;

    #[test]
    fn messages_and_answers() {
        let answer = r#"{"jsonrpc":"2.0","result":null,"id":3}"#;
        assert_eq!(
            received((frame(EXIT) + &frame(answer)).as_bytes()),
            format!("{EXIT}\n{answer}\n")
        );
    }

    #[test]
    fn headers_are_read_generously() {
        let length = EXIT.len();
        let odd = format!(
            "\r\ncontent-length:{length}\r\nContent-Type: application/vscode-jsonrpc\r\n\r\n{EXIT}\
             Content-Length: {length}\n\n{EXIT}"
        );
        assert_eq!(received(odd.as_bytes()), format!("{EXIT}\n{EXIT}\n"));
    }

    #[test]
    fn the_next_message_is_found_after_a_bad_one() {
        let bad = frame(r#"{"jsonrpc":"2.0","method":"#) + &frame(EXIT);
        let received = received(bad.as_bytes());
        assert!(
            received.contains("-32700") && received.contains("\"id\":null"),
            "{received}"
        );
        assert!(received.ends_with(&format!("{EXIT}\n")), "{received}");
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
            let received = received(frame(body).as_bytes());
            assert!(
                received.contains(&format!("\"id\":{id}}}")) && received.contains(&code.to_string()),
                "{body}: {received}"
            );
        }
    }

    #[test]
    fn a_header_without_a_length_and_bytes_that_are_no_text_are_answered() {
        assert!(received(b"X-Other: 1\r\n\r\n").contains("no Content-Length"));
        assert!(received(b"Content-Length: 2\r\n\r\n\xff\xfe").contains("not UTF-8"));
    }

    #[test]
    fn an_unfinished_message_is_dropped() {
        assert_eq!(received(b"Content-Length: 100\r\n\r\n{"), "");
        assert_eq!(received(b"Content-Le"), "");
    }
}
