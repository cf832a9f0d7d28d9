//! Opening a file that is one: no pipe that never ends, no device that does something when it is opened.

use crate::error::{FileError, Problem, Special};
use ladder_syntax::MAX_FILE_BYTES;
use std::fs::{self, File, FileType, Metadata, OpenOptions};
use std::path::Path;

/// Opens a file that a person named, to read it. What the process was handed by its caller (`/dev/stdin`, the pipe of
/// `<(...)`) is read whatever it is; anything else must be a regular file.
pub(crate) fn open(path: &Path) -> Result<(File, Metadata), FileError> {
    if is_handed_over(path) {
        let file = File::open(path).map_err(|error| FileError::reading(path, error))?;
        let metadata = file.metadata().map_err(|error| FileError::reading(path, error))?;
        return Ok((file, metadata));
    }
    open_regular(path, File::options().read(true))
}

/// Opens a regular file of bounded size, without waiting for what is none.
pub(crate) fn open_regular(path: &Path, options: &mut OpenOptions) -> Result<(File, Metadata), FileError> {
    // Asked first, since to open a device may already do something.
    let before = fs::metadata(path).map_err(|error| FileError::reading(path, error))?;
    check(path, &before)?;
    without_waiting(options);
    let file = options
        .open(path)
        .map_err(|error| FileError::reading(path, error))?;
    let metadata = file.metadata().map_err(|error| FileError::reading(path, error))?;
    check(path, &metadata)?;
    Ok((file, metadata))
}

/// As [`open_regular`], for what another user named: the system's own files, which only look like files, are none
/// either.
pub(crate) fn open_plain(path: &Path, options: &mut OpenOptions) -> Result<(File, Metadata), FileError> {
    let opened = open_regular(path, options)?;
    if is_of_the_system(&opened.0) {
        return Err(FileError::new(path, Problem::Special(Special::System)));
    }
    Ok(opened)
}

fn check(path: &Path, metadata: &Metadata) -> Result<(), FileError> {
    let problem = match special(metadata.file_type()) {
        Some(special) => Problem::Special(special),
        None if metadata.is_dir() => Problem::Directory,
        // Refused before its bytes are fetched.
        None if metadata.len() > MAX_FILE_BYTES as u64 => Problem::TooLarge,
        None => return Ok(()),
    };
    Err(FileError::new(path, problem))
}

/// What a file is, if it is neither a regular one nor a folder.
pub(crate) fn special(kind: FileType) -> Option<Special> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        if kind.is_fifo() {
            return Some(Special::Pipe);
        }
        if kind.is_socket() {
            return Some(Special::Socket);
        }
    }
    let plain = kind.is_file() || kind.is_dir();
    (!plain).then_some(Special::Device)
}

fn is_handed_over(path: &Path) -> bool {
    cfg!(unix)
        && (path == Path::new("/dev/stdin")
            || path.starts_with("/dev/fd")
            || path.starts_with("/proc/self/fd"))
}

/// A pipe that nothing writes to, put in the file's place at the last moment, must not stop us.
fn without_waiting(options: &mut OpenOptions) {
    #[cfg(unix)]
    {
        use rustix::fs::OFlags;
        use std::os::unix::fs::OpenOptionsExt;
        let flags = OFlags::NONBLOCK | OFlags::NOCTTY;
        options.custom_flags(flags.bits() as i32);
    }
    #[cfg(not(unix))]
    let _ = options;
}

/// Whether it lies in `/proc` or `/sys`, wherever those are mounted.
fn is_of_the_system(file: &File) -> bool {
    #[cfg(target_os = "linux")]
    {
        const SYSFS: u64 = 0x6265_6572;
        const CGROUP: [u64; 2] = [0x0027_e0eb, 0x6367_7270];
        let kind = rustix::fs::fstatfs(file).map(|it| it.f_type as u64);
        kind.is_ok_and(|it| it == rustix::fs::PROC_SUPER_MAGIC as u64 || it == SYSFS || CGROUP.contains(&it))
    }
    #[cfg(not(target_os = "linux"))]
    {
        let _ = file;
        false
    }
}
