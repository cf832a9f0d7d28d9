//! One session over bytes: they are split into messages, and what the server says gets its headers.

use std::pin::pin;

use futures::StreamExt;
use futures::channel::mpsc;
use futures::future::{Either, select};
use tokio::io::{AsyncRead, AsyncWrite, AsyncWriteExt};

use crate::native::Native;
use crate::received::receive;
use ladder_host::Busy;
use ladder_service::Ending;

/// Serves one client until it says `exit`, its input ends, or its process dies. The input need not end for the
/// session to: some editors keep it open and wait for the server to go.
pub async fn serve<I, O>(input: I, output: O) -> Ending
where
    I: AsyncRead + Send + Unpin + 'static,
    O: AsyncWrite,
{
    serve_counting(input, output, Busy::default()).await
}

/// As [`serve`], and shows whether work is under way.
pub(crate) async fn serve_counting<I, O>(input: I, output: O, busy: Busy) -> Ending
where
    I: AsyncRead + Send + Unpin + 'static,
    O: AsyncWrite,
{
    let (messages, received) = mpsc::channel(0);
    let reader = tokio::spawn(receive(input, messages));
    let (out, written) = mpsc::channel(0);
    let talk = pin!(ladder_service::serve(Native::here(), received, out, busy));
    let write = pin!(write(output, written));
    let ended = match select(talk, write).await {
        Either::Left((ended, write)) => {
            if ended.all_is_said {
                write.await;
            }
            ended
        }
        Either::Right(((), talk)) => talk.await,
    };
    reader.abort();
    ended.ending
}

/// Writes one message after the other, until there are no more or the client takes no more.
async fn write(output: impl AsyncWrite, mut messages: mpsc::Receiver<String>) {
    let mut output = pin!(output);
    while let Some(message) = messages.next().await {
        let frame = format!("Content-Length: {}\r\n\r\n{message}", message.len());
        if output.write_all(frame.as_bytes()).await.is_err() || output.flush().await.is_err() {
            return;
        }
    }
}
