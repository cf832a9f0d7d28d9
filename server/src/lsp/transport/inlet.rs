//! What comes in: the client's bytes, made safe for the framework.
//!
//! The framework stops reading for good at the first message that it cannot decode: broken JSON, a header in
//! small letters, a `Content-Type` without a charset, bytes that are not UTF-8, a number or a nesting that its reader
//! of JSON refuses. One bad message would end the session. So the client's bytes are split into messages
//! ([`frames`](crate::lsp::transport::frames)), each is checked here, and one that cannot be
//! understood is replaced by a request for the method [`MALFORMED`], which the [`Guard`](crate::lsp::transport::guard) answers
//! with the error that belongs to it. What the framework reads is always well formed.

use std::sync::Arc;

use serde::Deserialize;
use serde::de::IgnoredAny;
use serde_json::json;
use tokio::io::{AsyncRead, AsyncWrite, AsyncWriteExt};
use tower_lsp::jsonrpc::{ErrorCode, Id, Response};

use super::{
    decodable::{Decodable, replace_lone_surrogates},
    frames::{Frame, Frames, LONGEST_MESSAGE},
    long_texts::LongTexts,
};

/// The method that stands for a message that could not be understood. Its parameters are the `code` and
/// `message` of the answer.
pub(crate) const MALFORMED: &str = "$malformed";

/// Copies messages from the client to the framework until either side ends.
pub(crate) async fn feed(
    input: impl AsyncRead + Unpin,
    mut framework: impl AsyncWrite + Unpin,
    long_texts: Arc<LongTexts>,
) {
    let mut frames = Frames::of(input);
    while let Ok(Some(frame)) = frames.next().await {
        let body = match frame {
            Frame::Body(body) => long_texts.take_out(message(body, &mut frames)),
            Frame::TooLong(length) => stand_in(Mistake {
                code: ErrorCode::InvalidRequest,
                message: format!(
                    "a message of {length} bytes is longer than the server accepts ({LONGEST_MESSAGE}); it was skipped"
                ),
                id: Id::Null,
            }),
            Frame::Stray => stand_in(Mistake {
                code: ErrorCode::ParseError,
                message: "a message header has no Content-Length that is a number, or there is none; what followed was skipped up to the next one".into(),
                id: Id::Null,
            }),
        };
        let header = format!("Content-Length: {}\r\n\r\n", body.len());
        let sent = async {
            framework.write_all(header.as_bytes()).await?;
            framework.write_all(&body).await?;
            framework.flush().await
        };
        if sent.await.is_err() {
            return;
        }
    }
}

/// The message itself, or the request that stands for one that cannot be understood.
fn message<R: AsyncRead + Unpin>(mut body: Vec<u8>, frames: &mut Frames<R>) -> Vec<u8> {
    replace_lone_surrogates(&mut body);
    match check(&body) {
        Ok(()) => body,
        Err(_) if frames.end_at_header(&mut body) && check(&body).is_ok() => body,
        Err(mistake) => {
            frames.skip_quietly();
            stand_in(mistake)
        }
    }
}

/// The request that stands for a message that cannot be understood.
fn stand_in(mistake: Mistake) -> Vec<u8> {
    let params = json!({ "code": mistake.code.code(), "message": mistake.message });
    json!({ "jsonrpc": "2.0", "id": mistake.id, "method": MALFORMED, "params": params })
        .to_string()
        .into_bytes()
}

/// What is wrong with a message.
struct Mistake {
    code: ErrorCode,
    message: String,
    id: Id,
}

/// What the framework needs of a request. Parameters are only skipped here.
#[derive(Deserialize)]
#[expect(dead_code, reason = "the fields are there for their types")]
struct Envelope {
    jsonrpc: String,
    method: String,
    #[serde(default)]
    id: Option<Id>,
    #[serde(default)]
    params: Option<IgnoredAny>,
}

/// As much of a broken message as says whom to answer.
#[derive(Deserialize, Default)]
struct Loose {
    #[serde(default)]
    id: Option<serde_json::Value>,
    #[serde(default)]
    method: Option<serde_json::Value>,
    #[serde(default)]
    jsonrpc: Option<serde_json::Value>,
}

fn check(body: &[u8]) -> Result<(), Mistake> {
    let not_json = |message: String| Mistake {
        code: ErrorCode::ParseError,
        message,
        id: Id::Null,
    };
    let text = std::str::from_utf8(body).map_err(|_| not_json("the message is not UTF-8".into()))?;
    let decodable = serde_json::from_str::<Decodable>(text);
    // A list would be read as the fields in their order.
    let is_object = text.trim_ascii_start().starts_with('{');
    if is_object
        && decodable.is_ok()
        && serde_json::from_str::<Envelope>(text).is_ok_and(|envelope| envelope.jsonrpc == "2.0")
    {
        return Ok(());
    }
    if let Err(error) = serde_json::from_str::<IgnoredAny>(text) {
        return Err(not_json(format!("the message is not JSON: {error}")));
    }
    if !is_object {
        return Err(Mistake {
            code: ErrorCode::InvalidRequest,
            message: "a message is an object; several at once are not read, send one after the other".into(),
            id: Id::Null,
        });
    }
    let loose = serde_json::from_str::<Loose>(text).unwrap_or_default();
    let id = || {
        let id = loose.id.clone();
        id.and_then(|id| serde_json::from_value(id).ok())
            .unwrap_or(Id::Null)
    };
    if let Err(error) = decodable {
        return Err(Mistake {
            code: ErrorCode::InvalidRequest,
            message: format!("the message holds what the server does not read: {error}"),
            id: id(),
        });
    }
    if loose.method.is_none() && serde_json::from_str::<Response>(text).is_ok() {
        return Ok(());
    }
    let message = if loose.jsonrpc != Some("2.0".into()) {
        "the message does not say \"jsonrpc\": \"2.0\""
    } else if loose.method.is_none() {
        "the message is neither a request nor an answer"
    } else {
        "the method is not text, or the id is neither a whole number nor text"
    };
    Err(Mistake {
        code: ErrorCode::InvalidRequest,
        message: message.into(),
        id: id(),
    })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use tower_lsp::jsonrpc::Request;

    use super::*;

    /// What the framework would read for these bytes, one body a line.
    fn fed(input: &[u8]) -> String {
        let mut out = Vec::new();
        tokio::runtime::Builder::new_current_thread()
            .build()
            .unwrap()
            .block_on(feed(input, &mut out, Arc::default()));
        let text = String::from_utf8(out).unwrap();
        let bodies: Vec<_> = text.split("Content-Length: ").skip(1).collect();
        bodies
            .iter()
            .map(|frame| frame.split_once("\r\n\r\n").unwrap().1.to_owned() + "\n")
            .collect()
    }

    fn frame(body: &str) -> String {
        format!("Content-Length: {}\r\n\r\n{body}", body.len())
    }

    const EXIT: &str = r#"{"jsonrpc":"2.0","method":"exit"}"#;

    #[test]
    fn a_good_message_passes_untouched() {
        let answer = r#"{"jsonrpc":"2.0","id":3,"result":null}"#;
        assert_eq!(
            fed((frame(EXIT) + &frame(answer)).as_bytes()),
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
        assert_eq!(fed(odd.as_bytes()), format!("{EXIT}\n{EXIT}\n"));
    }

    #[test]
    fn the_next_message_is_found_behind_a_bad_one() {
        let bad = frame(r#"{"jsonrpc":"2.0","method":"#) + &frame(EXIT);
        let fed = fed(bad.as_bytes());
        assert!(
            fed.starts_with(r#"{"id":null,"jsonrpc":"2.0","method":"$malformed","params":{"code":-32700"#),
            "{fed}"
        );
        assert!(fed.ends_with(&format!("{EXIT}\n")), "{fed}");
    }

    #[test]
    fn the_answer_goes_to_whom_it_belongs() {
        for (body, id, code) in [
            (r#"{"jsonrpc":"1.0","id":4,"method":"x"}"#, "4", -32600),
            (r#"{"jsonrpc":"2.0","id":"a","method":7}"#, "\"a\"", -32600),
            (r#"{"jsonrpc":"2.0","id":5}"#, "5", -32600),
            (r#"{"jsonrpc":"2.0","id":1.5,"method":"x"}"#, "null", -32600),
            ("[]", "null", -32600),
            (r#"["2.0","x",1]"#, "null", -32600),
            (r#"[4,"x","2.0"]"#, "null", -32600),
            ("not json", "null", -32700),
        ] {
            let fed = fed(frame(body).as_bytes());
            assert!(
                fed.contains(&format!("\"id\":{id},")) && fed.contains(&code.to_string()),
                "{body}: {fed}"
            );
        }
    }

    #[test]
    fn a_header_without_a_length_and_bytes_that_are_no_text_are_answered() {
        assert!(fed(b"X-Other: 1\r\n\r\n").contains("no Content-Length"));
        assert!(fed(b"Content-Length: 2\r\n\r\n\xff\xfe").contains("not UTF-8"));
    }

    #[test]
    fn an_unfinished_message_is_dropped() {
        assert_eq!(fed(b"Content-Length: 100\r\n\r\n{"), "");
        assert_eq!(fed(b"Content-Le"), "");
    }

    /// Pieces of messages, whole and broken.
    fn any_input() -> impl Strategy<Value = Vec<u8>> {
        let body = prop_oneof![
            Just(EXIT.to_owned()),
            Just(r#"{"jsonrpc":"2.0","id":1,"method":"a","params":[1,{}]}"#.to_owned()),
            Just(r#"{"jsonrpc":"2.0","id":null,"method":"a","params":null}"#.to_owned()),
            Just(r#"{"jsonrpc":"2.0","id":"x","result":{}}"#.to_owned()),
            Just(r#"{"jsonrpc":"2.0","id":1,"error":{"code":1,"message":"m","data":[]}}"#.to_owned()),
            Just(r#"{"jsonrpc":"2.0","id":1,"error":{"code":1}}"#.to_owned()),
            Just(r#"{"jsonrpc":"2.0","id":99999999999999999999,"method":"a"}"#.to_owned()),
            Just(r#"{"jsonrpc":"2.0","id":1,"id":2,"method":"a"}"#.to_owned()),
            Just(r#"{"jsonrpc":"2.0","method":"a","method":"b"}"#.to_owned()),
            Just(r#"{"jsonrpc":"1.0","method":"a"}"#.to_owned()),
            Just(r#"{"jsonrpc":2.0,"method":"a"}"#.to_owned()),
            Just(r#"[{"jsonrpc":"2.0","method":"a"}]"#.to_owned()),
            Just("[".repeat(500)),
            Just(r#"{"jsonrpc":"2.0","method":"a","params":["\ud800\"\\\udfff"]}"#.to_owned()),
            Just(r#"{"jsonrpc":"2.0","id":1,"result":"\udc00\ud83d\ude00"}"#.to_owned()),
            Just(r#"{"jsonrpc":"2.0","id":1,"method":"a","other":1e400}"#.to_owned()),
            Just(r#"{"jsonrpc":"2.0","id":1,"result":-1e400}"#.to_owned()),
            (120usize..132).prop_map(|depth| {
                let (open, close) = ("[".repeat(depth), "]".repeat(depth));
                format!(r#"{{"jsonrpc":"2.0","id":1,"method":"a","params":{open}{close}}}"#)
            }),
            (120usize..132).prop_map(|depth| {
                let (open, close) = ("{\"a\":".repeat(depth), "}".repeat(depth));
                format!(r#"{{"jsonrpc":"2.0","id":1,"result":{open}1{close}}}"#)
            }),
            "[{}:,\"0-9a-z]{0,30}",
        ];
        let wrong_length = (body.clone(), 0usize..200);
        let wrong_length =
            wrong_length.prop_map(|(body, length)| format!("Content-Length: {length}\r\n\r\n{body}"));
        let piece = prop_oneof![
            2 => wrong_length.prop_map(String::into_bytes),
            6 => body.prop_map(|body| frame(&body).into_bytes()),
            1 => prop::collection::vec(any::<u8>(), 0..40),
            1 => "(Content-Length|X): ?[0-9]{0,3}\r?\n{0,2}".prop_map(String::into_bytes),
        ];
        prop::collection::vec(piece, 0..12).prop_map(|pieces| pieces.concat())
    }

    proptest! {
        #[test]
        fn the_framework_can_decode_whatever_comes(input in any_input()) {
            for body in fed(&input).lines() {
                let request = serde_json::from_str::<Request>(body);
                prop_assert!(request.is_ok() || serde_json::from_str::<Response>(body).is_ok(), "{}", body);
            }
        }
    }
}
