//! Messages on their way in and out.

use std::io::{self, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::Sender;

use serde_json::{Value as Json, json};
use tokio::io::AsyncRead;

use super::messages::Request;
use crate::frames::{Frame, Frames};

/// What comes in.
#[derive(Debug)]
pub(super) enum Incoming {
    Request(Request),
    /// Something that is not a request: what is wrong with it, and its number if it has one.
    Broken {
        seq: i64,
        problem: String,
    },
}

/// Reads messages until the input ends. `urgent` counts those that a long scan is given up for.
pub(super) async fn read(input: impl AsyncRead + Unpin, to: Sender<Incoming>, urgent: Arc<AtomicUsize>) {
    let mut frames = Frames::of(input);
    while let Ok(Some(frame)) = frames.next().await {
        let incoming = match frame {
            Frame::Body(mut body) => match Request::read(&body) {
                Err(problem) => {
                    let is_cut = frames.end_at_header(&mut body);
                    match Request::read(&body) {
                        Ok(request) if is_cut => Incoming::Request(request),
                        _ => Incoming::Broken {
                            seq: problem.seq,
                            problem: problem.message,
                        },
                    }
                }
                Ok(request) => Incoming::Request(request),
            },
            Frame::TooLong(length) => Incoming::Broken {
                seq: 0,
                problem: format!("a message of {length} bytes is too long"),
            },
            Frame::Stray => Incoming::Broken {
                seq: 0,
                problem: "a message begins with `Content-Length: `, its length in bytes and an empty line"
                    .into(),
            },
        };
        if let Incoming::Request(request) = &incoming
            && request.is_urgent()
        {
            urgent.fetch_add(1, Ordering::SeqCst);
        }
        if to.send(incoming).is_err() {
            return;
        }
    }
}

/// Takes a message to the client; an error if that is gone.
pub(crate) type Output = Box<dyn FnMut(&Json) -> io::Result<()> + Send>;

/// Messages with the length of each in front of it.
pub(super) fn framed(mut output: impl Write + Send + 'static) -> Output {
    Box::new(move |message| {
        let body = message.to_string();
        write!(output, "Content-Length: {}\r\n\r\n{body}", body.len())?;
        output.flush()
    })
}

/// Where messages go out.
pub(super) struct Outlet {
    output: Output,
    seq: i64,
    /// The client does not take anything any more.
    is_broken: bool,
}

impl Outlet {
    pub(super) fn new(output: Output) -> Outlet {
        Outlet {
            output,
            seq: 0,
            is_broken: false,
        }
    }

    /// Whether the client still takes messages.
    pub(super) fn is_broken(&self) -> bool {
        self.is_broken
    }

    pub(super) fn answer(&mut self, request: i64, command: &str, outcome: Result<Json, String>) {
        let mut message = json!({
            "type": "response",
            "request_seq": request,
            "command": command,
            "success": outcome.is_ok(),
        });
        match outcome {
            Ok(Json::Null) => {}
            Ok(body) => message["body"] = body,
            Err(problem) => {
                // A client would take braces in the format for the names of variables.
                message["body"] = json!({"error": {
                    "id": 1, "format": "{problem}", "variables": {"problem": problem}, "showUser": true,
                }});
                message["message"] = problem.into();
            }
        }
        self.send(message);
    }

    pub(super) fn event(&mut self, event: &str, body: Json) {
        let mut message = json!({"type": "event", "event": event});
        if !body.is_null() {
            message["body"] = body;
        }
        self.send(message);
    }

    fn send(&mut self, mut message: Json) {
        self.seq += 1;
        message["seq"] = self.seq.into();
        self.is_broken |= (self.output)(&message).is_err();
    }
}
