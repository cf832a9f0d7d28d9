//! Zed starts `ladder lsp` for ladder text and for scenario files. There is nothing else to it: colours come from the server.

use zed_extension_api::{self as zed, Command, Extension, LanguageServerId, Result, Worktree};

struct Ladder;

impl Extension for Ladder {
    fn new() -> Self {
        Ladder
    }

    /// The program on the `PATH` of the user's shell. Zed itself obeys the setting `lsp.ladder.binary.path` before it asks.
    fn language_server_command(&mut self, _: &LanguageServerId, worktree: &Worktree) -> Result<Command> {
        let program = worktree.which("ladder").ok_or(
            "The program \"ladder\" is not on the PATH. Install it with \"cargo install --path cli\" in the \
             project's folder, or name it in the setting lsp.ladder.binary.path.",
        )?;
        Ok(Command {
            command: program,
            args: vec!["lsp".to_owned()],
            env: worktree.shell_env(),
        })
    }
}

zed::register_extension!(Ladder);
