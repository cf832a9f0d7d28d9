//! The way to a controller that is watched: a connection through which requests to read go, and nothing else.

use std::io;
use std::pin::Pin;
use std::task::{Context, Poll, ready};
use tokio::io::{AsyncRead, AsyncWrite, ReadBuf};

/// Functions that read: coils, discrete inputs, holding registers, input registers.
const READING: std::ops::RangeInclusive<u8> = 1..=4;

/// So long is a request that reads: transaction, protocol and length of two bytes each, unit, function, first place, count.
const REQUEST: usize = 12;

/// So much waits at most until the system takes it: our own client sends one request and waits for the answer.
const MOST_WAITING: usize = 16 * REQUEST;

/// A connection that only lets requests to read through.
#[derive(Debug)]
pub(super) struct Guard<S> {
    stream: S,
    /// What was checked and has not been sent yet. Nothing but this is ever sent.
    checked: Vec<u8>,
}

impl<S> Guard<S> {
    pub(super) fn new(stream: S) -> Guard<S> {
        Guard {
            stream,
            checked: Vec::new(),
        }
    }
}

/// Whether bytes are whole requests to read.
fn check(bytes: &[u8]) -> io::Result<()> {
    let (requests, rest) = bytes.as_chunks::<REQUEST>();
    let is_request = |request: &[u8; REQUEST]| {
        let [_, _, 0, 0, 0, 6, _, function, ..] = request else {
            return false;
        };
        READING.contains(function)
    };
    if rest.is_empty() && requests.iter().all(is_request) {
        return Ok(());
    }
    let refused = "a request that does not only read was kept from the controller";
    Err(io::Error::new(io::ErrorKind::PermissionDenied, refused))
}

impl<S: AsyncWrite + Unpin> Guard<S> {
    /// Sends what was checked, as far as the system takes it.
    fn send(&mut self, context: &mut Context<'_>) -> Poll<io::Result<()>> {
        while !self.checked.is_empty() {
            let sent = ready!(Pin::new(&mut self.stream).poll_write(context, &self.checked))?;
            if sent == 0 {
                return Poll::Ready(Err(io::ErrorKind::WriteZero.into()));
            }
            self.checked.drain(..sent);
        }
        Poll::Ready(Ok(()))
    }
}

impl<S: AsyncWrite + Unpin> AsyncWrite for Guard<S> {
    fn poll_write(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
        bytes: &[u8],
    ) -> Poll<io::Result<usize>> {
        check(bytes)?;
        if self.checked.len() + bytes.len() > MOST_WAITING {
            ready!(self.send(context))?;
        }
        self.checked.extend_from_slice(bytes);
        Poll::Ready(Ok(bytes.len()))
    }

    fn poll_flush(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<io::Result<()>> {
        ready!(self.send(context))?;
        Pin::new(&mut self.stream).poll_flush(context)
    }

    fn poll_shutdown(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_shutdown(context)
    }
}

impl<S: AsyncRead + Unpin> AsyncRead for Guard<S> {
    fn poll_read(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
        into: &mut ReadBuf<'_>,
    ) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_read(context, into)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use tokio::io::AsyncWriteExt;

    /// What comes out at the other end, and whether all was taken.
    fn sent(writes: &[&[u8]]) -> (Vec<u8>, bool) {
        let mut guard = Guard::new(Vec::new());
        let runtime = tokio::runtime::Builder::new_current_thread().build().unwrap();
        let all = runtime.block_on(async {
            for bytes in writes {
                guard.write_all(bytes).await?;
                guard.flush().await?;
            }
            io::Result::Ok(())
        });
        (guard.stream, all.is_ok())
    }

    fn request(function: u8) -> [u8; REQUEST] {
        [0, 9, 0, 0, 0, 6, 1, function, 0, 5, 0, 10]
    }

    #[test]
    fn four_functions_go_through_and_no_other() {
        for function in 0..=255 {
            let frame = request(function);
            let (sent, all) = sent(&[&frame]);
            let reads = matches!(function, 1..=4);
            assert_eq!(
                (all, sent.len()),
                (reads, if reads { REQUEST } else { 0 }),
                "{function}"
            );
        }
    }

    #[test]
    fn a_request_is_whole_and_as_long_as_it_says() {
        let read = request(3);
        let mut longer = read.to_vec();
        longer[5] = 8;
        longer.extend([0, 0]);
        let mut other_protocol = read;
        other_protocol[3] = 1;
        let two = [read, request(5)].concat();
        let of_many: [u8; 17] = [0, 9, 0, 0, 0, 11, 1, 16, 0, 5, 0, 2, 4, 0, 1, 0, 1];
        for refused in [&read[..7], &read[..11], &longer, &other_protocol, &two, &of_many] {
            assert_eq!(sent(&[refused]), (Vec::new(), false), "{refused:?}");
        }
        // What follows a part of a request is not its rest.
        assert_eq!(
            sent(&[&read, &read[..4], &request(6)[4..]]),
            (read.to_vec(), false)
        );
    }

    proptest! {
        #[test]
        fn whatever_is_sent_reads(bytes in prop::collection::vec(prop_oneof![any::<u8>(), 0u8..8], 0..40), valid in 0usize..3) {
            let all = [request(4).repeat(valid), bytes].concat();
            let (sent, _) = sent(&[&all]);
            prop_assert!(sent.chunks(REQUEST).all(|frame| frame.len() == REQUEST && matches!(frame[7], 1..=4)));
        }
    }
}
