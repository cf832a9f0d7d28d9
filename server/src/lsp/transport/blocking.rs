//! Work that takes longer than a moment, off the thread that reads and writes messages.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

use tower_lsp::jsonrpc::{Error, ErrorCode, Result};

use crate::cancel::Cancel;

/// Runs a job on a blocking thread. When the handler that awaits it is dropped (the client cancelled the
/// request), a job that has not begun never begins, and one that runs is stopped by its [`Cancel`].
pub(crate) async fn blocking<T, F>(job: F) -> Result<T>
where
    T: Send + 'static,
    F: FnOnce(&Cancel) -> T + Send + 'static,
{
    let cancel = Cancel::default();
    let _guard = cancel.on_drop();
    let task = tokio::task::spawn_blocking(move || (!cancel.is_cancelled()).then(|| job(&cancel)));
    match task.await {
        Ok(Some(value)) => Ok(value),
        Ok(None) => Err(Error::request_cancelled()),
        Err(error) => Err(match error.try_into_panic() {
            Ok(panic) => internal_error(panic.as_ref()),
            Err(_) => Error::request_cancelled(),
        }),
    }
}

/// Runs a job on this thread, which goes on if it panics.
pub(crate) fn caught<T>(job: impl FnOnce() -> T) -> Result<T> {
    catch_unwind(AssertUnwindSafe(job)).map_err(|panic| internal_error(panic.as_ref()))
}

/// The answer for a handler or a job that panicked.
pub(crate) fn internal_error(panic: &(dyn Any + Send)) -> Error {
    let what = panic
        .downcast_ref::<&str>()
        .map(ToString::to_string)
        .or_else(|| panic.downcast_ref::<String>().cloned())
        .unwrap_or_else(|| "no message".into());
    let message = format!("an error in the language server itself: {what}");
    Error {
        code: ErrorCode::InternalError,
        message: message.into(),
        data: None,
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use tower_lsp::jsonrpc::ErrorCode;

    use super::*;

    #[tokio::test]
    async fn a_panic_is_an_answer() {
        let error = blocking(|_| -> u32 { panic!("planted") }).await.unwrap_err();
        assert_eq!(error.code, ErrorCode::InternalError);
        assert!(error.message.contains("planted"));
        assert_eq!(blocking(|_| 7).await, Ok(7));
        let error = caught(|| -> u32 { panic!("planted") }).unwrap_err();
        assert_eq!(error.code, ErrorCode::InternalError);
        assert_eq!(caught(|| 7), Ok(7));
    }

    #[tokio::test]
    async fn a_dropped_handler_stops_its_job() {
        let (stopped, seen) = std::sync::mpsc::channel();
        let handler = blocking(move |cancel| {
            for _ in 0..10_000 {
                if cancel.is_cancelled() {
                    let _ = stopped.send(());
                    return;
                }
                std::thread::sleep(Duration::from_millis(1));
            }
        });
        assert!(
            tokio::time::timeout(Duration::from_millis(20), handler)
                .await
                .is_err()
        );
        let seen = tokio::task::spawn_blocking(move || seen.recv());
        assert!(seen.await.unwrap().is_ok());
    }
}
