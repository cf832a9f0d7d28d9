//! The gate for text: UTF-8, and not larger than the offsets of the tree can count.

use crate::error::{FileError, Problem};
use crate::regular;
use ladder_syntax::MAX_FILE_BYTES;
use ladder_syntax::{LineIndex, TextSize};
use std::fs::{File, Metadata};
use std::io::Read;
use std::path::Path;

/// Reads a file.
///
/// # Errors
/// The file is missing, is a folder, a pipe or a device, is larger than [`MAX_FILE_BYTES`], is not UTF-8, or the operating system
/// refuses.
pub fn read(path: &Path) -> Result<String, FileError> {
    read_from(regular::open(path)?, path)
}

/// As [`read`], for a file in another notation, which need not be text.
///
/// # Errors
/// As for [`read`], but for what is not UTF-8.
pub fn read_bytes(path: &Path) -> Result<Vec<u8>, FileError> {
    bytes_from(regular::open(path)?, path)
}

/// Reads what was opened; `path` names it in errors.
pub(crate) fn bytes_from(opened: (File, Metadata), path: &Path) -> Result<Vec<u8>, FileError> {
    let bytes = bytes(opened, path)?;
    if bytes.len() > MAX_FILE_BYTES {
        return Err(FileError::new(path, Problem::TooLarge));
    }
    Ok(bytes)
}

/// As [`bytes_from`], for a text.
pub(crate) fn read_from(opened: (File, Metadata), path: &Path) -> Result<String, FileError> {
    decode(path, bytes(opened, path)?)
}

/// One byte more than a file may have, if there are that many.
fn bytes((file, metadata): (File, Metadata), path: &Path) -> Result<Vec<u8>, FileError> {
    if metadata.is_dir() {
        return Err(FileError::new(path, Problem::Directory));
    }
    // What has no length in advance (a pipe) is cut off below.
    let length = metadata.len().min(MAX_FILE_BYTES as u64);
    let mut bytes = Vec::with_capacity(length as usize + 1);
    file.take(MAX_FILE_BYTES as u64 + 1)
        .read_to_end(&mut bytes)
        .map_err(|error| FileError::reading(path, error))?;
    Ok(bytes)
}

/// Takes bytes for a text; `path` names them in errors.
///
/// # Errors
/// More than [`MAX_FILE_BYTES`], or not UTF-8.
pub fn decode(path: &Path, bytes: Vec<u8>) -> Result<String, FileError> {
    if bytes.len() > MAX_FILE_BYTES {
        return Err(FileError::new(path, Problem::TooLarge));
    }
    String::from_utf8(bytes).map_err(|error| {
        let place = error.utf8_error().valid_up_to();
        let bytes = error.as_bytes();
        // All before that place is UTF-8, so nothing is replaced here.
        let before = String::from_utf8_lossy(&bytes[..place]);
        let problem = Problem::NotUtf8 {
            place: LineIndex::new(&before).line_column(&before, TextSize::new(place as u32)),
            byte: bytes[place],
            utf16: bytes.starts_with(&[0xFF, 0xFE]) || bytes.starts_with(&[0xFE, 0xFF]),
        };
        FileError::new(path, problem)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(bytes: &[u8]) -> String {
        decode(Path::new("a.clad"), bytes.to_vec())
            .unwrap_err()
            .to_string()
    }

    #[test]
    fn says_where_the_text_stops_being_utf_8() {
        assert_eq!(
            refused(b"# Ventil #\r\n# \xC3\x96l #  # \xE9 #\n"),
            "a.clad: the file is not UTF-8: byte 16#E9 at line 2, column 11; save it as UTF-8 in your editor"
        );
    }

    #[test]
    fn knows_utf_16_by_its_mark() {
        assert_eq!(
            refused(&[0xFF, 0xFE, b'+', 0]),
            "a.clad: the file is not UTF-8 but UTF-16; save it as UTF-8 in your editor"
        );
    }

    #[test]
    fn keeps_a_byte_order_mark() {
        assert_eq!(
            decode(Path::new("a"), b"\xEF\xBB\xBF+--+".to_vec()).unwrap(),
            "\u{feff}+--+"
        );
    }
}
