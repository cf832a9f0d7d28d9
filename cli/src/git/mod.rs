//! git as another program: its objects are read through standard input, so that nothing of a name is an option to it.

pub(crate) mod objects;
pub(crate) mod revision;

use crate::outcome::Failure;
use objects::Objects;
use std::cell::{RefCell, RefMut};
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// The repository around the current folder. Its objects are opened when one is first asked for.
#[derive(Default)]
pub(crate) struct Git(RefCell<Option<Objects>>);

impl Git {
    /// Its objects.
    ///
    /// # Errors
    /// There is no git.
    pub(crate) fn objects(&self) -> Result<RefMut<'_, Objects>, Failure> {
        let mut objects = self.0.borrow_mut();
        let open = match objects.take() {
            Some(open) => open,
            None => Objects::open()?,
        };
        Ok(RefMut::map(objects, |objects| objects.insert(open)))
    }
}

/// A command of git in a folder, which runs no hook and no program of the repository's settings, asks nobody, and fetches nothing.
pub(crate) fn command(folder: &Path) -> Command {
    let mut command = Command::new("git");
    command
        .current_dir(folder)
        .args(["--no-pager", "--no-optional-locks"])
        .args(["-c", "core.fsmonitor=false", "-c", "core.hooksPath=/dev/null"])
        .env("GIT_NO_LAZY_FETCH", "1")
        .env("GIT_TERMINAL_PROMPT", "0")
        .stdin(Stdio::null());
    command
}

/// Runs a command of git to its end.
///
/// # Errors
/// There is no git.
pub(crate) fn output(command: &mut Command) -> Result<Output, Failure> {
    command.output().map_err(|error| not_started(&error))
}

pub(crate) fn not_started(error: &std::io::Error) -> Failure {
    Failure::new(format!("git cannot be started: {error}"))
}

/// What git says of an error, on one line.
pub(crate) fn told(output: &Output) -> String {
    let told = String::from_utf8_lossy(&output.stderr);
    let told = told.trim().trim_start_matches("fatal: ");
    if told.is_empty() {
        "git could not do it".to_owned()
    } else {
        told.to_owned()
    }
}
