//! A command of this program in a process of its own: what a program of a person does there ends with it.

use std::path::Path;
use std::process::Stdio;
use std::time::Duration;
use tokio::io::{AsyncRead, AsyncReadExt};
use tokio::process::Command;

/// So long a command may run.
const LONGEST: Duration = Duration::from_secs(120);
/// More than this is not read of what a command writes, in bytes.
const MOST: u64 = 16 << 20;

/// What a command has done.
pub(super) struct Done {
    /// 0, 1 or 2 as the command line has them.
    pub(super) status: i32,
    pub(super) stdout: Vec<u8>,
    pub(super) stderr: String,
}

/// Runs a command of this program in a folder.
///
/// # Errors
/// It cannot be started, or takes too long.
pub(super) async fn run(folder: &Path, arguments: &[String]) -> Result<Done, String> {
    let program = std::env::current_exe().map_err(|error| format!("ladder cannot be started: {error}"))?;
    let mut child = Command::new(program)
        .args(arguments)
        .current_dir(folder)
        .env("NO_COLOR", "1")
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .kill_on_drop(true)
        .spawn()
        .map_err(|error| format!("ladder cannot be started: {error}"))?;
    let (stdout, stderr) = (child.stdout.take(), child.stderr.take());
    let all = async { tokio::join!(read(stdout), read(stderr), child.wait()) };
    let (stdout, stderr, status) = tokio::time::timeout(LONGEST, all).await.map_err(|_| {
        format!(
            "this took longer than {} seconds and was ended: ask for less",
            LONGEST.as_secs()
        )
    })?;
    Ok(Done {
        status: status.ok().and_then(|status| status.code()).unwrap_or(2),
        stdout,
        stderr: String::from_utf8_lossy(&stderr).into_owned(),
    })
}

/// Reads all, and keeps as much as there may be.
async fn read(pipe: Option<impl AsyncRead + Unpin>) -> Vec<u8> {
    let mut kept = Vec::new();
    let Some(mut pipe) = pipe else { return kept };
    let _ = (&mut pipe).take(MOST).read_to_end(&mut kept).await;
    // The rest goes, so that the command comes to its end.
    let _ = tokio::io::copy(&mut pipe, &mut tokio::io::sink()).await;
    kept
}
