//! Messages on their way in and out.

use std::io::Write;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::Sender;

use ladder_debugger::{Output, Request};
use tokio::io::AsyncRead;

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

/// Messages with the length of each in front of it.
pub(super) fn framed(mut output: impl Write + Send + 'static) -> Output {
    Box::new(move |message| {
        let body = message.to_string();
        write!(output, "Content-Length: {}\r\n\r\n{body}", body.len())?;
        output.flush()
    })
}
