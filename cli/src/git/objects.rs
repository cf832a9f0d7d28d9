//! Files as git has them in a revision: `HEAD~2:plant/motor.clad`.

use super::{command, not_started, output, told};
use crate::outcome::Failure;
use ladder_workspace::MAX_FILE_BYTES;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Stdio};

/// At most this many files of a folder are read.
const MOST_FILES: usize = 100_000;

/// Reads objects of the repository around the current folder, as many as are asked for.
pub(crate) struct Objects {
    git: Child,
    asked: ChildStdin,
    answers: BufReader<ChildStdout>,
}

/// What a name stands for.
pub(crate) enum Object {
    /// The content of a file.
    File(Vec<u8>),
    /// A folder, by its name in git.
    Folder(String),
}

/// A file in a folder.
pub(crate) struct Listed {
    /// Its path in the folder.
    pub(crate) path: String,
    /// The name of its content in git.
    pub(crate) id: String,
}

/// Whether an argument means something in a revision, and not a file: `REV:path`, `:path` for what is staged.
pub(crate) fn is_meant(argument: &str) -> bool {
    match argument.split_once(':') {
        // A drive.
        Some((drive, _)) => drive.len() != 1 || !cfg!(windows),
        None => false,
    }
}

impl Objects {
    /// Starts git.
    ///
    /// # Errors
    /// There is none.
    pub(crate) fn open() -> Result<Objects, Failure> {
        let mut git = command(Path::new("."))
            .args(["cat-file", "--batch"])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .map_err(|error| not_started(&error))?;
        match (git.stdin.take(), git.stdout.take()) {
            (Some(asked), Some(answers)) => Ok(Objects {
                git,
                asked,
                answers: BufReader::new(answers),
            }),
            _ => Err(Failure::new("git cannot be asked")),
        }
    }

    /// Reads what `REV:path` stands for.
    ///
    /// # Errors
    /// There is no such revision, or no such file in it; or it is too large.
    pub(crate) fn read(&mut self, name: &str) -> Result<Object, Failure> {
        if name.starts_with('-') || name.contains(['\n', '\r', '\0']) {
            return Err(Failure::new(format!("`{name}` is not the name of a revision")));
        }
        let broken = |_| {
            Failure::new(format!(
                "{name}: git does not answer; is this folder in a repository?"
            ))
        };
        writeln!(self.asked, "{name}").map_err(broken)?;
        self.asked.flush().map_err(broken)?;
        let mut header = String::new();
        // A header is short but for a name in it that is missing.
        let mut line = self.answers.by_ref().take(name.len() as u64 + 200);
        line.read_line(&mut header).map_err(broken)?;
        let mut words = header.trim_end().rsplit(' ');
        let size = words.next().and_then(|size| size.parse::<usize>().ok());
        let (Some(size), Some(kind), Some(id)) = (size, words.next(), words.next()) else {
            return Err(Failure::new(if header.is_empty() {
                format!("{name}: git does not answer; is this folder in a repository?")
            } else {
                format!("{name}: git knows no such revision, or no such file in it")
            }));
        };
        let (kind, id) = (kind.to_owned(), id.to_owned());
        if size > MAX_FILE_BYTES {
            return Err(Failure::new(format!("{name}: this is larger than 64 MiB")));
        }
        let mut bytes = vec![0; size + 1];
        self.answers.read_exact(&mut bytes).map_err(broken)?;
        bytes.pop();
        match kind.as_str() {
            "blob" => Ok(Object::File(bytes)),
            "tree" => Ok(Object::Folder(id)),
            _ => Err(Failure::new(format!(
                "{name}: this is no file or folder; write `REV:path`, or `REV:` for all files"
            ))),
        }
    }
}

impl Drop for Objects {
    fn drop(&mut self) {
        let _ = self.git.kill();
        let _ = self.git.wait();
    }
}

/// The files in a folder of a revision and in its sub-folders; `folder` is its name in git.
///
/// # Errors
/// git does not know it, or it holds too many.
pub(crate) fn list(folder: &str) -> Result<Vec<Listed>, Failure> {
    listed(&["ls-tree", "-r", "-z", "--full-tree", "--", folder], 2)
}

/// The files that are staged, by their paths in the repository.
///
/// # Errors
/// There is no repository, or it holds too many.
pub(crate) fn staged() -> Result<Vec<Listed>, Failure> {
    listed(&["ls-files", "--stage", "-z", "--full-name", ":/"], 1)
}

/// What git lists: a mode, words, and after the tab a path. The word `id` is the name of the content.
fn listed(arguments: &[&str], id: usize) -> Result<Vec<Listed>, Failure> {
    let output = output(command(Path::new(".")).args(arguments))?;
    if !output.status.success() {
        return Err(Failure::new(told(&output)));
    }
    let text = String::from_utf8_lossy(&output.stdout);
    let files = text.split('\0').filter_map(|line| {
        let (about, path) = line.split_once('\t')?;
        let mut about = about.split(' ');
        // Links and repositories in the repository are no files.
        let is_file = about.next()?.starts_with("100");
        let id = about.nth(id - 1)?.to_owned();
        is_file.then(|| Listed {
            path: path.to_owned(),
            id,
        })
    });
    let files: Vec<Listed> = files.take(MOST_FILES + 1).collect();
    if files.len() > MOST_FILES {
        return Err(Failure::new(format!(
            "there are more than {MOST_FILES} files in it"
        )));
    }
    Ok(files)
}
