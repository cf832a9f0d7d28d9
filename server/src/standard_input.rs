//! Standard input, read by a thread of its own.
//!
//! The runtime's own reader borrows one of the threads on which work is done, and waits there for what the client says
//! next. That thread would never end, nor give back the pages of memory that it worked with; see
//! [`settling`](crate::settling).

use std::io::{self, ErrorKind, Read};
use std::pin::Pin;
use std::task::{Context, Poll, ready};
use std::thread;

use tokio::io::{AsyncRead, ReadBuf};
use tokio::sync::mpsc;

/// This many bytes are read at once at most.
const PIECE: usize = 64 << 10;

/// What the process is given, piece by piece.
#[derive(Debug)]
pub(crate) struct StandardInput {
    pieces: mpsc::Receiver<io::Result<Vec<u8>>>,
    /// The piece that is being taken, and how much of it is.
    piece: Vec<u8>,
    taken: usize,
}

impl StandardInput {
    /// Begins to read. A read cannot be interrupted, so that the thread may be left waiting at the end.
    ///
    /// # Errors
    /// The system gives no thread.
    pub(crate) fn start() -> io::Result<StandardInput> {
        StandardInput::of(io::stdin())
    }

    fn of(mut input: impl Read + Send + 'static) -> io::Result<StandardInput> {
        // One is read while the one before it is checked.
        let (sender, pieces) = mpsc::channel(1);
        thread::Builder::new()
            .name("standard input".into())
            .spawn(move || {
                let mut buffer = vec![0; PIECE];
                loop {
                    let read = match input.read(&mut buffer) {
                        Ok(0) => return,
                        Ok(length) => Ok(buffer[..length].to_vec()),
                        Err(error) if error.kind() == ErrorKind::Interrupted => continue,
                        Err(error) => Err(error),
                    };
                    let ends = read.is_err();
                    if sender.blocking_send(read).is_err() || ends {
                        return;
                    }
                }
            })?;
        Ok(StandardInput {
            pieces,
            piece: Vec::new(),
            taken: 0,
        })
    }
}

impl AsyncRead for StandardInput {
    fn poll_read(
        mut self: Pin<&mut Self>,
        cx: &mut Context<'_>,
        buffer: &mut ReadBuf<'_>,
    ) -> Poll<io::Result<()>> {
        if self.taken == self.piece.len() {
            // None is the end of the input.
            let Some(piece) = ready!(self.pieces.poll_recv(cx)) else {
                return Poll::Ready(Ok(()));
            };
            (self.piece, self.taken) = (piece?, 0);
        }
        let rest = &self.piece[self.taken..];
        let length = rest.len().min(buffer.remaining());
        buffer.put_slice(&rest[..length]);
        self.taken += length;
        Poll::Ready(Ok(()))
    }
}

#[cfg(test)]
mod tests {
    use tokio::io::AsyncReadExt;

    use super::*;

    /// Yields three bytes at a time, now and then an interruption, and an error at the end.
    struct Slow(Vec<u8>, usize);

    impl Read for Slow {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            self.1 += 1;
            if self.1.is_multiple_of(5) {
                return Err(ErrorKind::Interrupted.into());
            }
            if self.0.is_empty() {
                return Err(ErrorKind::BrokenPipe.into());
            }
            let length = self.0.len().min(3);
            buffer[..length].copy_from_slice(&self.0[..length]);
            self.0.drain(..length);
            Ok(length)
        }
    }

    #[tokio::test]
    async fn every_byte_arrives_whatever_the_pieces_are() {
        let text: Vec<u8> = (0..=255).cycle().take(200_000).collect();
        let mut input = StandardInput::of(io::Cursor::new(text.clone())).unwrap();
        let mut read = vec![0; 5];
        input.read_exact(&mut read).await.unwrap();
        input.read_to_end(&mut read).await.unwrap();
        assert_eq!(read, text);
    }

    #[tokio::test]
    async fn an_interruption_is_no_end_and_an_error_is_one() {
        let mut input = StandardInput::of(Slow(b"a longer text".to_vec(), 0)).unwrap();
        let mut read = Vec::new();
        let ended = input.read_to_end(&mut read).await;
        assert_eq!(read, b"a longer text");
        assert_eq!(ended.unwrap_err().kind(), ErrorKind::BrokenPipe);
    }
}
