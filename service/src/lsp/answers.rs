//! What the requests that the protocol does not have are answered.

use ladder_live::Failure;
use serde::Serialize;
use tower_lsp::jsonrpc::{Error, ErrorCode, Result};
use tower_lsp::ls_types::LSPAny;

/// The protocol's code for a request that makes sense but cannot be done.
pub(crate) const REQUEST_FAILED: i64 = -32803;

/// An answer as the protocol has it.
pub(crate) fn json(answer: &impl Serialize) -> Result<LSPAny> {
    serde_json::to_value(answer).map_err(|_| Error::internal_error())
}

/// Why there is none.
pub(crate) fn error(failure: Failure) -> Error {
    let (code, message) = match failure {
        Failure::Invalid(message) => (ErrorCode::InvalidParams, message),
        Failure::Failed(message) => (ErrorCode::ServerError(REQUEST_FAILED), message),
    };
    Error {
        code,
        message: message.into(),
        data: None,
    }
}
