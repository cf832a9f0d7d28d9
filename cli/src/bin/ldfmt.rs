//! The program `ldfmt`: `ladder fmt` under a name of its own, for editors and hooks. It is small and starts the `ladder` next to it, so
//! that a release holds the code once.

use std::env;
use std::io;
use std::path::PathBuf;
use std::process::{Command, ExitCode};

fn main() -> ExitCode {
    let started = program().and_then(|ladder| {
        let mut command = Command::new(&ladder);
        command.arg("ldfmt").args(env::args_os().skip(1));
        run(&mut command)
            .map_err(|error| io::Error::new(error.kind(), format!("{}: {error}", ladder.display())))
    });
    started.unwrap_or_else(|error| {
        eprintln!("error: ldfmt needs the program ladder in its own folder, and cannot start it: {error}");
        ExitCode::from(2)
    })
}

/// The `ladder` in the folder of this program, and no other one.
fn program() -> io::Result<PathBuf> {
    let own = env::current_exe()?.canonicalize()?;
    Ok(own.with_file_name(format!("ladder{}", env::consts::EXE_SUFFIX)))
}

/// Becomes the program.
#[cfg(unix)]
fn run(command: &mut Command) -> io::Result<ExitCode> {
    use std::os::unix::process::CommandExt;
    Err(command.exec())
}

/// Starts the program and ends as it does.
#[cfg(not(unix))]
fn run(command: &mut Command) -> io::Result<ExitCode> {
    let status = command.status()?;
    Ok(ExitCode::from(
        status
            .code()
            .and_then(|code| u8::try_from(code).ok())
            .unwrap_or(2),
    ))
}
