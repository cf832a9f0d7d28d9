//! What a client sent, with its times: written while a session runs, and read to play it again.
//!
//! The file begins with [`HEADER`]. Then comes, for each piece that was read, a line with its time in microseconds since
//! the beginning and its length in bytes, the bytes as they came, and a line end. So it reads well, and nothing of what
//! came is lost, messages that are none included.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::path::Path;
use std::pin::Pin;
use std::task::{Context, Poll, ready};
use std::time::{Duration, Instant};

use ladder_workspace::shown;
use tokio::io::{AsyncRead, ReadBuf};

/// The first line.
const HEADER: &str = "ladder lsp recording 1";

/// Input that is recorded as it is read.
#[derive(Debug)]
pub(crate) struct Mirror<R> {
    input: R,
    /// None once it could not be written.
    file: Option<File>,
    begun: Instant,
}

impl<R> Mirror<R> {
    /// Records into a file, which is made again. One that holds something else than a recording stays, and so does what a link
    /// leads to.
    pub(crate) fn new(input: R, file: &Path) -> io::Result<Mirror<R>> {
        Ok(Mirror {
            input,
            file: Some(begun(file)?),
            begun: Instant::now(),
        })
    }

    fn record(&mut self, bytes: &[u8]) {
        let Some(file) = &mut self.file else { return };
        let mut piece = format!("{} {}\n", self.begun.elapsed().as_micros(), bytes.len()).into_bytes();
        piece.extend_from_slice(bytes);
        piece.push(b'\n');
        // In one piece and unbuffered: what came before a crash is what is wanted most.
        if let Err(error) = file.write_all(&piece) {
            eprintln!("ladder: the recording ends here, it cannot be written: {error}");
            self.file = None;
        }
    }
}

impl<R: AsyncRead + Unpin> AsyncRead for Mirror<R> {
    fn poll_read(
        mut self: Pin<&mut Self>,
        cx: &mut Context<'_>,
        buffer: &mut ReadBuf<'_>,
    ) -> Poll<io::Result<()>> {
        let before = buffer.filled().len();
        ready!(Pin::new(&mut self.input).poll_read(cx, buffer))?;
        if buffer.filled().len() > before {
            self.record(&buffer.filled()[before..]);
        }
        Poll::Ready(Ok(()))
    }
}

/// A file with the first line of a recording.
fn begun(file: &Path) -> io::Result<File> {
    let header = format!("{HEADER}\n");
    // A device, a pipe or a terminal is written to as it is.
    if file.metadata().is_ok_and(|there| !there.is_file()) {
        let mut file = File::options().write(true).open(file)?;
        file.write_all(header.as_bytes())?;
        return Ok(file);
    }
    if file.is_symlink() {
        return Err(io::Error::other(
            "it is a link, and nothing is written through it; name another file",
        ));
    }
    if holds_something_else(file)? {
        return Err(io::Error::other(
            "it holds something else, and stays as it is; name another file",
        ));
    }
    ladder_workspace::write_made(file, header.as_bytes())
        .map_err(|error| io::Error::other(error.problem.to_string()))?;
    File::options().append(true).open(file)
}

/// Whether a file is there that is neither empty nor a recording.
fn holds_something_else(file: &Path) -> io::Result<bool> {
    let metadata = match file.metadata() {
        Ok(metadata) => metadata,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(false),
        Err(error) => return Err(error),
    };
    if metadata.len() == 0 {
        return Ok(false);
    }
    let mut head = Vec::new();
    File::open(file)?
        .take(HEADER.len() as u64)
        .read_to_end(&mut head)?;
    Ok(head != HEADER.as_bytes())
}

/// A piece of what was read, and when.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Piece {
    pub(crate) at: Duration,
    pub(crate) bytes: Vec<u8>,
}

/// Reads a recording. A last piece that is cut off counts as far as it goes.
pub(crate) fn read(file: &Path) -> Result<Vec<Piece>, String> {
    let named = |what: String| format!("{}: {what}", shown::path(file));
    let opened = File::open(file).map_err(|error| named(error.to_string()))?;
    pieces(&mut BufReader::new(opened)).map_err(|error| named(error.to_string()))
}

fn pieces(input: &mut impl BufRead) -> io::Result<Vec<Piece>> {
    let mut line = String::new();
    input.read_line(&mut line)?;
    if line.trim_end() != HEADER {
        return Err(io::Error::other(
            "this is not a recording; make one with ladder lsp --mirror FILE",
        ));
    }
    let mut pieces = Vec::new();
    loop {
        line.clear();
        if input.read_line(&mut line)? == 0 {
            return Ok(pieces);
        }
        let numbers = line.trim_end().split_once(' ');
        let numbers = numbers.and_then(|(at, length)| Some((at.parse().ok()?, length.parse().ok()?)));
        let Some((at, length)) = numbers else {
            return Err(io::Error::other(format!(
                "a time and a length are expected where {:?} is, after {} pieces",
                line.trim_end(),
                pieces.len()
            )));
        };
        let mut bytes = Vec::new();
        input.take(length).read_to_end(&mut bytes)?;
        pieces.push(Piece {
            at: Duration::from_micros(at),
            bytes,
        });
        line.clear();
        input.read_line(&mut line)?;
    }
}

#[cfg(test)]
mod tests {
    use tokio::io::AsyncReadExt;

    use super::*;

    #[tokio::test]
    async fn what_is_read_is_recorded_to_the_byte() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("session");
        let sent = b"Content-Length: 2\r\n\r\n\xff\n5 5\n".as_slice();
        let mut got = Vec::new();
        let mut mirror = Mirror::new(sent, &file).unwrap();
        mirror.read_to_end(&mut got).await.unwrap();
        assert_eq!(got, sent);
        let pieces = read(&file).unwrap();
        assert_eq!(
            pieces.iter().map(|it| &*it.bytes).collect::<Vec<_>>().concat(),
            sent
        );
    }

    #[test]
    fn what_is_no_recording() {
        let told = |text: &str| pieces(&mut text.as_bytes()).map_err(|error| error.to_string());
        assert!(told("hello\n").unwrap_err().contains("--mirror"));
        assert_eq!(
            told("ladder lsp recording 1\n7 1\na\nnow\n").unwrap_err(),
            "a time and a length are expected where \"now\" is, after 1 pieces"
        );
        let cut = told("ladder lsp recording 1\n7 1\na\n9000 5\nbc").unwrap();
        assert_eq!(
            cut,
            [(7, "a"), (9000, "bc")].map(|(at, bytes)| Piece {
                at: Duration::from_micros(at),
                bytes: bytes.into()
            })
        );
    }
}
