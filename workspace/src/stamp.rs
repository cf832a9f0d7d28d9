//! Whether a file is still the one that was read.

use std::path::Path;
use std::time::SystemTime;

/// What tells one state of a file from the next: when it was written, and how long it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Stamp(Option<(Written, u64)>);

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Written {
    At(SystemTime),
    Number(u64),
}

impl Stamp {
    /// The stamp of a file now. All files that are not there have the same.
    pub fn of(file: &Path) -> Stamp {
        let data = std::fs::metadata(file).ok();
        Stamp(data.and_then(|data| Some((Written::At(data.modified().ok()?), data.len()))))
    }

    /// The stamp of a file whose writings are counted: the number of the last one, and its length.
    pub(crate) fn numbered(written: Option<(u64, u64)>) -> Stamp {
        Stamp(written.map(|(number, bytes)| (Written::Number(number), bytes)))
    }

    /// How long the file is, in bytes.
    pub fn bytes(&self) -> u64 {
        self.0.map_or(0, |(_, bytes)| bytes)
    }

    /// Whether there is a file.
    pub fn exists(&self) -> bool {
        self.0.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_is_written_has_another_stamp() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a.clad");
        let before = Stamp::of(&file);
        assert!(!before.exists());
        std::fs::write(&file, "one").unwrap();
        let one = Stamp::of(&file);
        assert_ne!(before, one);
        assert_eq!(one, Stamp::of(&file));
        std::fs::write(&file, "more").unwrap();
        assert_ne!(one, Stamp::of(&file));
    }
}
