//! Messages out of a stream of bytes, also where a header gives the wrong length.
//!
//! A header counts wherever it is, because no message can hold one: inside a JSON text a line end is written `\n`, and
//! outside of one there are no such words. So a body ends where the next header begins, if that is before the end
//! that its own header announces; and after a body that was too short everything up to the next header is skipped.

use std::io;

use memchr::{memchr, memchr_iter};
use tokio::io::{AsyncRead, AsyncReadExt};

/// No message is longer than this, in bytes: a text of 64 MiB with every character escaped in JSON.
pub(crate) const LONGEST_MESSAGE: u64 = 400 << 20;

/// Of a header line that is longer than this only the end is kept.
const LONGEST_HEADER: usize = 4096;

/// No `Content-Length: 123` is longer than this.
const LONGEST_FIELD: usize = 128;

/// This many bytes are read at once.
const CHUNK: usize = 64 << 10;

const FIELD: &[u8] = b"content-length";

/// What is between two headers.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Frame {
    /// A message, as far as the header is right.
    Body(Vec<u8>),
    /// A message of this length, of which nothing was kept.
    TooLong(u64),
    /// Bytes that belong to no message.
    Stray,
}

/// The frames of a stream.
pub(crate) struct Frames<R> {
    input: R,
    /// What was read and not checked yet, from `at` on.
    buffer: Vec<u8>,
    at: usize,
    /// That bytes are being skipped was reported already.
    lost: bool,
    /// The length of a body that begins here: it was reported first that bytes before its header were skipped.
    announced: Option<u64>,
}

impl<R: AsyncRead + Unpin> Frames<R> {
    pub(crate) fn of(input: R) -> Self {
        Frames {
            input,
            buffer: Vec::new(),
            at: 0,
            lost: false,
            announced: None,
        }
    }

    /// The next frame, or none at the end of the input.
    pub(crate) async fn next(&mut self) -> io::Result<Option<Frame>> {
        if let Some(length) = self.announced.take() {
            return self.body(length).await.map(Some);
        }
        let mut length = None;
        let mut lines = 0;
        let mut stray = false;
        loop {
            let Some(line) = self.line().await? else {
                return Ok(None);
            };
            let line = line.trim_ascii();
            if !line.is_empty() {
                lines += 1;
                match field_at_end(line) {
                    Some((start, value)) => {
                        stray |= start > 0;
                        length = Some(value);
                    }
                    None => stray |= !is_header(line),
                }
                continue;
            }
            match length {
                Some(length) => {
                    let reported = std::mem::replace(&mut self.lost, false);
                    if stray && !reported {
                        self.announced = Some(length);
                        return Ok(Some(Frame::Stray));
                    }
                    return self.body(length).await.map(Some);
                }
                None if lines == 0 => {}
                // The rest of what was reported already.
                None if self.lost && stray => (lines, stray) = (0, false),
                None => {
                    self.lost = true;
                    return Ok(Some(Frame::Stray));
                }
            }
        }
    }

    /// A body was no message. Where the beginning of a header is at its end, the body is cut off there and the
    /// header is read again; whether that is so.
    pub(crate) fn end_at_header(&mut self, body: &mut Vec<u8>) -> bool {
        let earliest = body.len().saturating_sub(LONGEST_FIELD);
        let Some(at) = (earliest..body.len()).find(|&at| may_begin_field(&body[at..])) else {
            return false;
        };
        self.give_back(&body.split_off(at));
        true
    }

    /// That a body was no message was reported. What follows may be the rest of it, and is skipped without a further word.
    pub(crate) fn skip_quietly(&mut self) {
        self.lost = true;
    }

    /// A line with its end; of a very long one only the end.
    async fn line(&mut self) -> io::Result<Option<Vec<u8>>> {
        let mut line = Vec::new();
        loop {
            if !self.fill().await? {
                return Ok((!line.is_empty()).then_some(line));
            }
            let new = &self.buffer[self.at..];
            let end = memchr(b'\n', new);
            let taken = end.map_or(new.len(), |end| end + 1);
            line.extend_from_slice(&new[..taken]);
            self.at += taken;
            if end.is_some() {
                return Ok(Some(line));
            }
            if line.len() > LONGEST_HEADER {
                line.drain(..line.len() - LONGEST_FIELD);
            }
        }
    }

    /// A body of this length, or up to the next header. It is read as it comes: a length is only a promise, and nothing
    /// is allocated for a promise.
    async fn body(&mut self, length: u64) -> io::Result<Frame> {
        let mut body = Vec::new();
        let mut dropped = 0;
        loop {
            let missing = length - dropped - body.len() as u64;
            if missing == 0 {
                break;
            }
            if !self.fill().await? {
                return Err(io::ErrorKind::UnexpectedEof.into());
            }
            let new = &self.buffer[self.at..];
            let taken = usize::try_from(missing).map_or(new.len(), |missing| missing.min(new.len()));
            let looked = body.len();
            body.extend_from_slice(&new[..taken]);
            self.at += taken;
            if let Some(at) = header_in(&body, looked) {
                self.give_back(&body.split_off(at));
                break;
            }
            if body.len() as u64 > LONGEST_MESSAGE {
                let cut = body.len() - LONGEST_FIELD;
                body.drain(..cut);
                dropped += cut as u64;
            }
        }
        Ok(if dropped > 0 {
            Frame::TooLong(length)
        } else {
            Frame::Body(body)
        })
    }

    /// Reads on if nothing is left; false at the end of the input.
    async fn fill(&mut self) -> io::Result<bool> {
        if self.at == self.buffer.len() {
            self.buffer.clear();
            self.at = 0;
            self.buffer.reserve(CHUNK);
            self.input.read_buf(&mut self.buffer).await?;
        }
        Ok(self.at < self.buffer.len())
    }

    fn give_back(&mut self, bytes: &[u8]) {
        self.buffer.splice(..self.at, bytes.iter().copied());
        self.at = 0;
    }
}

/// The header field at the end of some bytes: where it begins, and the length. After stray bytes without a line end
/// it is at the end of their line.
fn field_at_end(bytes: &[u8]) -> Option<(usize, u64)> {
    let bytes = bytes.trim_ascii_end();
    let digits = bytes
        .iter()
        .rev()
        .take_while(|byte| byte.is_ascii_digit())
        .count();
    let (rest, digits) = bytes.split_at(bytes.len() - digits);
    let length = std::str::from_utf8(digits).ok()?.parse().ok()?;
    let name = rest.trim_ascii_end().strip_suffix(b":")?.trim_ascii_end();
    let start = name.len().checked_sub(FIELD.len())?;
    name[start..]
        .eq_ignore_ascii_case(FIELD)
        .then_some((start, length))
}

/// Where a header begins whose line ends after `looked`.
fn header_in(body: &[u8], looked: usize) -> Option<usize> {
    memchr_iter(b'\n', &body[looked..]).find_map(|end| {
        let end = looked + end;
        let earliest = end.saturating_sub(LONGEST_FIELD);
        field_at_end(&body[earliest..end]).map(|(start, _)| earliest + start)
    })
}

/// Whether bytes are the beginning of the field, with nothing after it.
fn may_begin_field(bytes: &[u8]) -> bool {
    let name = bytes.len().min(FIELD.len());
    if !bytes[..name].eq_ignore_ascii_case(&FIELD[..name]) {
        return false;
    }
    let rest = bytes[name..].trim_ascii_start();
    match rest.split_first() {
        None => true,
        Some((b':', rest)) => rest.trim_ascii().iter().all(u8::is_ascii_digit),
        Some(_) => false,
    }
}

/// Whether a line looks like a header of any kind.
fn is_header(line: &[u8]) -> bool {
    let name = line.split(|&byte| byte == b':').next().unwrap_or_default();
    name.len() < line.len()
        && !name.is_empty()
        && name
            .iter()
            .all(|byte| byte.is_ascii_alphanumeric() || *byte == b'-')
}
