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

use crate::error::{FileError, Problem};
use crate::lock::Lock;
use crate::named::Named;
use crate::write::write;
use crate::{regular, shown};
use ladder_simulator::Kept;
use ladder_syntax::MAX_FILE_BYTES;
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// The format that is written, and the only one that is read.
const FORMAT: u32 = 1;
/// What every file of retentive values begins with.
const HEAD: &str = "ladder-retain ";
/// At most one save in this time.
const PAUSE: Duration = Duration::from_secs(1);

/// A retentive file that is in use.
#[derive(Debug)]
pub struct RetentiveFile {
    path: PathBuf,
    program: String,
    /// What is in it.
    written: Option<String>,
    /// When that was last done; a short run saves at its end only.
    saved: Instant,
    /// No other run writes it meanwhile.
    _lock: Option<Lock>,
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
    /// Opens the file that a workspace names: see [`RetentiveFile::open`].
    ///
    /// # Errors
    /// As there, or it lies outside of the workspace.
    pub fn open_named(file: &Named, program: &str) -> Result<(RetentiveFile, Found), FileError> {
        RetentiveFile::open(&file.locate()?, program)
    }

    /// Opens the file for a program and reads what it kept. A file that is not there yet is not an error. A damaged one
    /// is put aside next to it, as `NAME.damaged`, and the program starts cold. Until the value is dropped no other run
    /// can open it.
    ///
    /// # Errors
    /// It is not a file of retentive values, another run uses it, or the operating system refuses to read it or to put it
    /// aside.
    pub fn open(path: &Path, program: &str) -> Result<(RetentiveFile, Found), FileError> {
        // Checked before a lock is made for it: what is not ours is not touched.
        if read(path)?.is_some_and(|bytes| !has_head(&bytes)) {
            return Err(FileError::new(path, Problem::NotOurs));
        }
        let mut file = RetentiveFile {
            path: path.to_owned(),
            program: program.to_owned(),
            written: None,
            saved: Instant::now(),
            _lock: Lock::of(path)?,
        };
        let Some(bytes) = read(path)? else {
            return Ok((file, Found::default()));
        };
        if !has_head(&bytes) {
            return Err(FileError::new(path, Problem::NotOurs));
        }
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
                let aside = put_aside(path)?;
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
        &self.path
    }

    /// Whether a second has passed since it was opened or last saved: before that a save is not due.
    pub fn is_due(&self, now: Instant) -> bool {
        now.saturating_duration_since(self.saved) >= PAUSE
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
            write(&self.path, text.as_bytes()).map(|()| self.written = Some(text))
        };
        // Only now: a disk that takes a second must not be written to in every scan.
        self.saved = Instant::now();
        done
    }
}

/// The file's content; none if it is not there.
fn read(path: &Path) -> Result<Option<Vec<u8>>, FileError> {
    let file = match regular::open_plain(path, File::options().read(true)) {
        Ok((file, _)) => file,
        Err(FileError {
            problem: Problem::Missing,
            ..
        }) => return Ok(None),
        Err(error) => return Err(error),
    };
    let mut bytes = Vec::new();
    file.take(MAX_FILE_BYTES as u64)
        .read_to_end(&mut bytes)
        .map_err(|error| FileError::reading(path, error))?;
    Ok(Some(bytes))
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

/// Renames a file to `NAME.damaged`, or with a number after it where that is taken.
fn put_aside(path: &Path) -> Result<PathBuf, FileError> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    for number in 1.. {
        let aside = path.with_file_name(match number {
            1 => format!("{name}.damaged"),
            _ => format!("{name}.damaged.{number}"),
        });
        if fs::symlink_metadata(&aside).is_ok() {
            continue;
        }
        // A second name first: unlike a renaming it takes the place of nothing that came there meanwhile.
        let moved = match fs::hard_link(path, &aside) {
            Ok(()) => fs::remove_file(path),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => continue,
            Err(_) => fs::rename(path, &aside),
        };
        return match moved {
            Ok(()) => Ok(aside),
            Err(error) => Err(FileError::writing(&aside, error)),
        };
    }
    Err(FileError::new(path, Problem::ReadOnly))
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
