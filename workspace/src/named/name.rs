//! What a name may say.

use crate::error::Problem;
use std::ffi::OsString;

/// A part of a path.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum PathComponent {
    /// A file or folder.
    Name(OsString),
    /// The folder above.
    Up,
}

/// The parts of a relative path. A path that is relative here but not on another system is refused everywhere: a
/// workspace is the same on each machine.
pub(super) fn parts(name: &str) -> Result<Vec<PathComponent>, Problem> {
    let drive =
        name.as_bytes().first().is_some_and(u8::is_ascii_alphabetic) && name.as_bytes().get(1) == Some(&b':');
    if name.starts_with(['/', '\\']) || drive {
        return Err(Problem::NotRelative);
    }
    let separators: &[char] = if cfg!(windows) { &['/', '\\'] } else { &['/'] };
    let mut parts = Vec::new();
    for part in name.split(separators) {
        match part {
            "" | "." => {}
            ".." => parts.push(PathComponent::Up),
            part if is_device_of_windows(part) && cfg!(windows) => return Err(Problem::NotRelative),
            part if part.contains('\0') => return Err(Problem::Missing),
            // Git's own files are not the workspace's to name.
            part if part.eq_ignore_ascii_case(".git") => return Err(Problem::Outside),
            part => parts.push(PathComponent::Name(part.into())),
        }
    }
    if parts.is_empty() {
        return Err(Problem::Directory);
    }
    Ok(parts)
}

/// Whether the parts lead above the folder that they are seen from.
pub(super) fn climbs_out(parts: &[PathComponent]) -> bool {
    let mut depth = 0_i64;
    parts.iter().any(|part| {
        depth += if *part == PathComponent::Up { -1 } else { 1 };
        depth < 0
    })
}

/// Names that Windows takes for devices in every folder, and streams next to a file's content.
fn is_device_of_windows(part: &str) -> bool {
    let stem = part.split(['.', ':']).next().unwrap_or(part).trim_end();
    let numbered = |kind: &str| {
        stem.get(..3).is_some_and(|it| it.eq_ignore_ascii_case(kind))
            && stem.get(3..).is_some_and(|number| number.chars().count() == 1)
    };
    part.contains(':')
        || ["CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$"]
            .iter()
            .any(|device| stem.eq_ignore_ascii_case(device))
        || numbered("COM")
        || numbered("LPT")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn devices_of_windows() {
        for device in ["nul", "NUL.clad", "con ", "com1", "LPT9.txt", "a.clad:stream"] {
            assert!(is_device_of_windows(device), "{device}");
        }
        for file in ["null.clad", "com.clad", "com10", "console", "motor.clad"] {
            assert!(!is_device_of_windows(file), "{file}");
        }
    }
}
