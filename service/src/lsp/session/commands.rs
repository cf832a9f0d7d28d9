//! The commands of a client that the server may name.

use tower_lsp::ls_types::{ClientCapabilities, CodeLensOptions};

/// Starts a simulation of the program with this address.
pub(crate) const START: &str = "ladder.simulation.start";
/// Runs the scenarios in the file with this address.
pub(crate) const TEST: &str = "ladder.test";
/// Proves the properties in the file with this address, or the one of this name.
pub(crate) const PROVE: &str = "ladder.prove";
/// Shows places: an address, a position, and the places.
pub(crate) const SHOW: &str = "ladder.showReferences";

/// Which commands of lenses the client can run.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Commands {
    pub(crate) start: bool,
    pub(crate) test: bool,
    pub(crate) prove: bool,
    pub(crate) show: bool,
}

/// Whether the client names a command in `experimental.commands`.
fn names_command(client: &ClientCapabilities, name: &str) -> bool {
    let named = client
        .experimental
        .as_ref()
        .and_then(|it| it["commands"].as_array());
    named.is_some_and(|named| named.iter().any(|it| it == name))
}

impl Commands {
    /// What the client names in `experimental.commands`.
    pub(crate) fn of(client: &ClientCapabilities) -> Commands {
        Commands {
            start: names_command(client, START),
            test: names_command(client, TEST),
            prove: names_command(client, PROVE),
            show: names_command(client, SHOW),
        }
    }

    pub(crate) fn any(self) -> bool {
        self.start || self.test || self.prove || self.show
    }

    /// What the server offers to such a client.
    pub(crate) fn options(self) -> Option<CodeLensOptions> {
        self.any().then_some(CodeLensOptions {
            resolve_provider: Some(true),
        })
    }
}

/// Asks for another name: an address, and the name in that document.
pub(crate) const RENAME: &str = "ladder.rename";

/// Whether the client names the command that asks for another name.
pub(crate) fn renames(client: &ClientCapabilities) -> bool {
    names_command(client, RENAME)
}

/// Cuts what was after the cursor and belongs to what was accepted: the text, and what is after it on its line.
pub(crate) const CUT: &str = "ladder.completion.cut";

/// Whether the client names the command that cuts, because it replaces nothing after the cursor by itself.
pub(crate) fn cuts_after(client: &ClientCapabilities) -> bool {
    names_command(client, CUT)
}
