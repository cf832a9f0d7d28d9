//! What the commands write can be distinguished from what others wrote.

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::path::Path;

/// So much of a file is checked, at its beginning and at its end.
const ENDS: u64 = 4096;

/// The last line of a diagram in a file begins so.
pub(crate) const DRAWN_BY: &str = "# drawn by ladder";

/// What is in a PNG after its header: a piece of text that names the program.
pub(crate) const SOFTWARE: &[u8] = b"tEXtSoftware\0ladder";

/// Whether a file is a trace, a picture, a diagram or a report that a command wrote. One that cannot be read is not.
pub(super) fn by_a_command(file: &Path) -> bool {
    ends(file).is_ok_and(|(head, tail)| is_ours(&head, &tail))
}

fn is_ours(head: &[u8], tail: &[u8]) -> bool {
    let has = |part: &str| contains(head, part.as_bytes());
    match head {
        // A table of scans.
        [b's', ..] => head.starts_with(b"scan,time_ms,") || head.starts_with(b"scan,time_ms\n"),
        [b'{', ..] => head.starts_with(b"{\n  \"program\": \"") && has("\n  \"interval_ms\": "),
        [b'$', ..] => has("$version ladder "),
        // A scene.
        [b'<', b'?', ..] => has("<!-- drawn by ladder -->"),
        [b'<', b'!', ..] => has("<meta name=\"generator\" content=\"ladder\">"),
        // A timing diagram, or a program: both are drawn on paper of their own.
        [b'<', ..] => {
            head.starts_with(b"<svg ")
                && has("role=\"img\">")
                && (has(".paper") || has("<title>Timing diagram of "))
        }
        [0x89, b'P', b'N', b'G', ..] => contains(head, SOFTWARE),
        [b'%', b'P', b'D', b'F', ..] => [head, tail].iter().any(|end| contains(end, b"(ladder")),
        [b'T', b'N', ..] => head.starts_with(b"TN:\nSF:"),
        // A manual page.
        [b'.', ..] => has("\n.TH LADDER") || has("\n.TH LDFMT"),
        _ => tail
            .trim_ascii_end()
            .rsplit(|byte| *byte == b'\n')
            .next()
            .is_some_and(|line| line.starts_with(DRAWN_BY.as_bytes())),
    }
}

fn contains(text: &[u8], part: &[u8]) -> bool {
    text.windows(part.len()).any(|window| window == part)
}

fn ends(file: &Path) -> io::Result<(Vec<u8>, Vec<u8>)> {
    let mut file = File::open(file)?;
    let length = file.metadata()?.len();
    let (mut head, mut tail) = (Vec::new(), Vec::new());
    file.by_ref().take(ENDS).read_to_end(&mut head)?;
    file.seek(SeekFrom::Start(length.saturating_sub(ENDS)))?;
    file.take(ENDS).read_to_end(&mut tail)?;
    Ok((head, tail))
}
