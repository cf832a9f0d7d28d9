//! A folder with files, and programs run in it.

use std::fmt;
use std::fs;
use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use tempfile::TempDir;

/// A small program without errors, in canonical layout.
pub(crate) const MOTOR: &str = "\
+--\\--[ ]( start )--\\--[/]( stop )---------------------------------( )( run )--+
|  /--[ ]( run )----/                                                          |
";

/// The same program, not in canonical layout.
pub(crate) const CROOKED: &str = "\
+-\\-[ ]( start )-\\-[/]( stop )-( )( run )-+
| /-[ ]( run )-/
";

/// A folder of its own, gone with the value.
pub(crate) struct Folder(TempDir);

impl Folder {
    /// Folders in the names are made too.
    pub(crate) fn with(files: &[(&str, &str)]) -> Folder {
        let folder = Folder(tempfile::tempdir().unwrap());
        for (name, text) in files {
            folder.write(name, text.as_bytes());
        }
        folder
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub(crate) fn write(&self, name: &str, bytes: &[u8]) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, bytes).unwrap();
    }

    pub(crate) fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    /// The names of all files directly in it, sorted.
    pub(crate) fn names(&self) -> Vec<String> {
        self.names_in("")
    }

    /// The names of all files directly in a folder of it, sorted.
    pub(crate) fn names_in(&self, inner: &str) -> Vec<String> {
        let mut names: Vec<String> = fs::read_dir(self.path(inner))
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    /// Runs `ladder` in the folder.
    pub(crate) fn ladder(&self, arguments: &[&str]) -> Run {
        self.run(env!("CARGO_BIN_EXE_ladder"), arguments, b"", &[])
    }

    /// Runs `ldfmt` in the folder.
    pub(crate) fn ldfmt(&self, arguments: &[&str]) -> Run {
        self.run(env!("CARGO_BIN_EXE_ldfmt"), arguments, b"", &[])
    }

    /// Runs `ldfmt` in the folder with a text on stdin.
    pub(crate) fn ldfmt_stdin(&self, arguments: &[&str], stdin: &[u8]) -> Run {
        self.run(env!("CARGO_BIN_EXE_ldfmt"), arguments, stdin, &[])
    }

    /// Runs a program in the folder, with variables next to those of any test.
    pub(crate) fn run(
        &self,
        program: &str,
        arguments: &[&str],
        stdin: &[u8],
        variables: &[(&str, &str)],
    ) -> Run {
        let mut child = self
            .command(program, arguments)
            .envs(variables.iter().copied())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        // A program that ends without reading all of it closes the pipe.
        let _ = child.stdin.take().unwrap().write_all(stdin);
        let output = child.wait_with_output().unwrap();
        Run {
            status: output.status.code(),
            stdout: String::from_utf8(output.stdout).unwrap(),
            stderr: String::from_utf8(output.stderr).unwrap(),
        }
    }

    /// The program with the folder as its current one, and an environment that is the same everywhere.
    pub(crate) fn command(&self, program: &str, arguments: &[&str]) -> Command {
        let mut command = Command::new(program);
        command
            .current_dir(self.0.path())
            .args(arguments)
            .env("COLUMNS", "100")
            // The day in the title block of printed pages.
            .env("SOURCE_DATE_EPOCH", "1795651200");
        for variable in ["NO_COLOR", "CLICOLOR_FORCE", "CLICOLOR", "TERM"] {
            command.env_remove(variable);
        }
        command
    }
}

/// How a program ended, and what it said.
pub(crate) struct Run {
    pub(crate) status: Option<i32>,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Run {
    /// The command could not do its work: one message, nothing on stdout, exit status 2.
    pub(crate) fn refused_with(&self, message: &str) {
        assert_eq!(
            self.to_string(),
            format!("exit status 2\n-- stderr\nerror: {message}\n")
        );
    }
}

impl fmt::Display for Run {
    /// The exit status, then what is on stdout and stderr, for snapshots.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.status {
            Some(code) => writeln!(f, "exit status {code}")?,
            None => writeln!(f, "killed")?,
        }
        for (name, text) in [("stdout", &self.stdout), ("stderr", &self.stderr)] {
            if !text.is_empty() {
                write!(f, "-- {name}\n{text}")?;
            }
        }
        Ok(())
    }
}
