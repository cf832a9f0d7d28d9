//! The file that keeps retentive tags over a restart (LANGUAGE §6).
//!
//! A line for each tag, between a head that names the format and an end by which a whole file differs from a damaged one:
//!
//! ```text
//! ladder-retain 1
//! program motor.clad
//! total   DINT            42
//! recipe  ARRAY[1..2] OF INT      7       9
//! end 5e3f90b1
//! ```
//!
//! The parts of a line are separated by tabs. The number after `end` is the CRC-32 of all that is before it.

use crate::disk::{Disk, Keeper, KeptFile};
use crate::error::{FileError, Problem};
use crate::named::Named;
use crate::shown;
use ladder_simulator::Kept;
use std::path::Path;
use std::time::Duration;

/// The format that is written, and the only one that is read.
const FORMAT: u32 = 1;
/// What every file of retentive values begins with.
const HEAD: &str = "ladder-retain ";
/// At most one save in this time.
const PAUSE: Duration = Duration::from_secs(1);

/// A retentive file that is in use.
#[derive(Debug)]
pub struct RetentiveFile {
    /// The file, which no other run has meanwhile.
    keeper: Box<dyn Keeper>,
    program: String,
    /// What is in it.
    written: Option<String>,
    /// Since when the next save is waited for: from the first question whether it is due on.
    waiting: Option<Duration>,
}

/// What was found in a retentive file.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Found {
    /// The values, to start warm with; none where the program must start cold.
    pub kept: Option<Vec<Kept>>,
    /// What a person should know: the file was damaged, or belongs to another program.
    pub notes: Vec<String>,
}

impl RetentiveFile {
    /// Opens the file that a workspace names: see [`RetentiveFile::open`]. Another run that uses it may let go of it in the
    /// time `patience`.
    ///
    /// # Errors
    /// As there, or it lies outside of the workspace.
    pub fn open_named(
        disk: &dyn Disk,
        file: &Named,
        program: &str,
        patience: Duration,
    ) -> Result<(RetentiveFile, Found), FileError> {
        RetentiveFile::open_in(disk.keeper(file)?, program, patience)
    }

    /// Opens the file for a program and reads what it kept. A file that is not there yet is not an error. A damaged one
    /// is put aside next to it, as `NAME.damaged`, and the program starts cold. Until the value is dropped no other run
    /// can open it.
    ///
    /// # Errors
    /// It is not a file of retentive values, another run uses it, or the operating system refuses to read it or to put it
    /// aside.
    pub fn open(path: &Path, program: &str) -> Result<(RetentiveFile, Found), FileError> {
        RetentiveFile::open_in(Box::new(KeptFile::at(path)), program, Duration::ZERO)
    }

    fn open_in(
        mut keeper: Box<dyn Keeper>,
        program: &str,
        patience: Duration,
    ) -> Result<(RetentiveFile, Found), FileError> {
        let read = |keeper: &dyn Keeper| match keeper.read()? {
            Some(bytes) if !has_head(&bytes) => Err(FileError::new(keeper.path(), Problem::NotOurs)),
            read => Ok(read),
        };
        // Checked before a lock is made for it: what is not ours is not touched.
        read(&*keeper)?;
        keeper.lock(patience)?;
        let bytes = read(&*keeper)?;
        let mut file = RetentiveFile {
            keeper,
            program: program.to_owned(),
            written: None,
            waiting: None,
        };
        let Some(bytes) = bytes else {
            return Ok((file, Found::default()));
        };
        let path = file.path().to_owned();
        let path = &*path;
        let found = match understand(&bytes) {
            Ok(content) => {
                let mut notes = Vec::new();
                if content.program != program {
                    notes.push(format!(
                        "{}: the values were kept by {}; {program} takes those that fit",
                        shown::path(path),
                        shown::line(&content.program)
                    ));
                }
                file.written = String::from_utf8(bytes).ok();
                Found {
                    kept: Some(content.kept),
                    notes,
                }
            }
            Err(damage) => {
                let aside = file.keeper.put_aside()?;
                Found {
                    kept: None,
                    notes: vec![format!(
                        "{}: {damage}; the program starts cold, and the file is kept as {}",
                        shown::path(path),
                        shown::path(&aside)
                    )],
                }
            }
        };
        Ok((file, found))
    }

    /// The file.
    pub fn path(&self) -> &Path {
        self.keeper.path()
    }

    /// Whether a second has passed since this was first asked after it was opened or last saved: before that a save is not
    /// due. `now` is the time on any clock that goes on.
    pub fn is_due(&mut self, now: Duration) -> bool {
        let since = *self.waiting.get_or_insert(now);
        now.saturating_sub(since) >= PAUSE
    }

    /// Writes the values, in one step: a reader sees the old file or the new one. Nothing is written if they
    /// are those that are there already.
    ///
    /// # Errors
    /// The operating system refuses; the old file is then untouched.
    pub fn save(&mut self, kept: &[Kept]) -> Result<(), FileError> {
        let text = compose(&self.program, kept);
        let done = if self.written.as_ref() == Some(&text) {
            Ok(())
        } else {
            self.keeper
                .write(text.as_bytes())
                .map(|()| self.written = Some(text))
        };
        // Counted from when it is done: a disk that takes a second must not be written to in every scan.
        self.waiting = None;
        done
    }
}

fn has_head(bytes: &[u8]) -> bool {
    bytes.starts_with(HEAD.as_bytes())
}

fn compose(program: &str, kept: &[Kept]) -> String {
    let mut text = format!("{HEAD}{FORMAT}\nprogram {program}\n");
    for tag in kept {
        text.push_str(&tag.name);
        for part in std::iter::once(&tag.ty).chain(&tag.values) {
            text.push('\t');
            text.push_str(part);
        }
        text.push('\n');
    }
    let sum = crc32fast::hash(text.as_bytes());
    text.push_str(&format!("end {sum:08x}\n"));
    text
}

struct Content {
    program: String,
    kept: Vec<Kept>,
}

/// Reads a file; else what is wrong with it.
fn understand(bytes: &[u8]) -> Result<Content, String> {
    let text = std::str::from_utf8(bytes).unwrap_or("");
    let Some(format) = text.lines().next().and_then(|line| line.strip_prefix(HEAD)) else {
        return Err("the file is damaged".into());
    };
    if format.parse() != Ok(FORMAT) {
        return Err(format!(
            "the file has format {}, but this version of ladder reads format {FORMAT} only",
            shown::line(format)
        ));
    }
    let damaged = || "the file is damaged".to_owned();
    let (body, end) = text
        .strip_suffix('\n')
        .and_then(|text| text.rsplit_once('\n'))
        .ok_or_else(damaged)?;
    // With the line end in front of the last line.
    let body = &text[..=body.len()];
    let sum = end.strip_prefix("end ").ok_or_else(damaged)?;
    if u32::from_str_radix(sum, 16) != Ok(crc32fast::hash(body.as_bytes())) {
        return Err(damaged());
    }
    let mut lines = body.lines().skip(1);
    let program = lines
        .next()
        .and_then(|line| line.strip_prefix("program "))
        .ok_or_else(damaged)?;
    let kept = lines.map(|line| {
        let mut parts = line.split('\t').map(str::to_owned);
        let (name, ty) = (parts.next()?, parts.next()?);
        Some(Kept {
            name,
            ty,
            values: parts.collect(),
        })
    });
    Ok(Content {
        program: program.to_owned(),
        kept: kept.collect::<Option<_>>().ok_or_else(damaged)?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_damage_is_seen() {
        let kept = [Kept {
            name: "total".into(),
            ty: "DINT".into(),
            values: vec!["42".into()],
        }];
        let text = compose("motor.clad", &kept);
        assert_eq!(
            understand(text.as_bytes())
                .unwrap_or_else(|damage| panic!("{damage}"))
                .kept,
            kept
        );
        for at in 0..text.len() {
            assert!(understand(&text.as_bytes()[..at]).is_err(), "cut at {at}");
            for bit in 0..8 {
                let mut bytes = text.clone().into_bytes();
                bytes[at] ^= 1 << bit;
                // The case of the sum's digits says nothing.
                if bytes.eq_ignore_ascii_case(text.as_bytes()) && at + 9 >= text.len() {
                    continue;
                }
                assert!(understand(&bytes).is_err(), "bit {bit} of byte {at}");
            }
        }
    }
}
