//! The client's bytes as messages: they are split into [`frames`](crate::frames).

use futures::SinkExt;
use futures::channel::mpsc::Sender;
use tokio::io::AsyncRead;

use crate::frames::{Frame, Frames, LONGEST_MESSAGE};
use ladder_service::Received;

/// Passes the client's messages on until either side ends.
pub(crate) async fn receive(input: impl AsyncRead + Unpin, mut messages: Sender<Received>) {
    let mut frames = Frames::of(input);
    while let Ok(Some(frame)) = frames.next().await {
        let message = match frame {
            Frame::Body(body) => message(body, &mut frames),
            Frame::TooLong(length) => Received::too_long(length, LONGEST_MESSAGE),
            Frame::Stray => Received::stray(),
        };
        if messages.send(message).await.is_err() {
            return;
        }
    }
}

/// The message in a body, which may have the next header at its end.
fn message<R: AsyncRead + Unpin>(mut body: Vec<u8>, frames: &mut Frames<R>) -> Received {
    let read = Received::read(&mut body);
    if !read.is_broken() {
        return read;
    }
    if frames.end_at_header(&mut body) {
        let shorter = Received::read(&mut body);
        if !shorter.is_broken() {
            return shorter;
        }
    }
    frames.skip_quietly();
    read
}

#[cfg(test)]
mod tests {
    use futures::StreamExt;

    use super::*;

    /// What is read in these bytes, a message a line.
    fn received(input: &[u8]) -> String {
        let (sender, messages) = futures::channel::mpsc::channel(100);
        let runtime = tokio::runtime::Builder::new_current_thread().build().unwrap();
        runtime.block_on(receive(input, sender));
        let all: Vec<String> = runtime.block_on(messages.map(|message| message.to_string() + "\n").collect());
        all.concat()
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
