//! Notifications whose parameters make no sense: nobody answers a notification, so the client's log gets a line.

use serde::Deserialize;
use tower_lsp::jsonrpc::Request;
use tower_lsp::ls_types::{
    CancelParams, CreateFilesParams, DeleteFilesParams, DidChangeConfigurationParams,
    DidChangeTextDocumentParams, DidChangeWatchedFilesParams, DidChangeWorkspaceFoldersParams,
    DidCloseTextDocumentParams, DidOpenTextDocumentParams, DidSaveTextDocumentParams, RenameFilesParams,
    WillSaveTextDocumentParams,
};

/// What is wrong with the parameters of a notification, if anything. The framework drops such a notification
/// without a word, and an editor would never learn why its changes have no effect.
pub(crate) fn misread(notification: &Request) -> Option<String> {
    let params = notification.params()?;
    let error = match notification.method() {
        "textDocument/didOpen" => DidOpenTextDocumentParams::deserialize(params).err(),
        "textDocument/didChange" => DidChangeTextDocumentParams::deserialize(params).err(),
        "workspace/didChangeConfiguration" => DidChangeConfigurationParams::deserialize(params).err(),
        "workspace/didCreateFiles" => CreateFilesParams::deserialize(params).err(),
        "workspace/didRenameFiles" => RenameFilesParams::deserialize(params).err(),
        "workspace/didDeleteFiles" => DeleteFilesParams::deserialize(params).err(),
        "workspace/didChangeWatchedFiles" => DidChangeWatchedFilesParams::deserialize(params).err(),
        "textDocument/willSave" => WillSaveTextDocumentParams::deserialize(params).err(),
        "textDocument/didSave" => DidSaveTextDocumentParams::deserialize(params).err(),
        "workspace/didChangeWorkspaceFolders" => DidChangeWorkspaceFoldersParams::deserialize(params).err(),
        "textDocument/didClose" => DidCloseTextDocumentParams::deserialize(params).err(),
        "$/cancelRequest" => CancelParams::deserialize(params).err(),
        _ => None,
    }?;
    Some(format!(
        "{} was ignored, its parameters make no sense: {error}",
        notification.method()
    ))
}
