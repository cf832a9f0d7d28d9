//! Work that takes longer than a moment, off the thread that reads and writes messages.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

use futures::channel::oneshot;
use tower_lsp::jsonrpc::{Error, ErrorCode, Result};

use ladder_analysis::Cancel;
use ladder_host::Host;

/// Has a job done where it may take its time. When the handler that awaits it is dropped (the client cancelled the
/// request), a job that has not begun never begins, and one that runs is stopped by its [`Cancel`].
pub(crate) async fn blocking<T, F>(host: &dyn Host, job: F) -> Result<T>
where
    T: Send + 'static,
    F: FnOnce(&Cancel) -> T + Send + 'static,
{
    let cancel = Cancel::default();
    let _guard = cancel.on_drop();
    let (done, outcome) = oneshot::channel();
    host.work(Box::new(move || {
        let outcome = (!cancel.is_cancelled()).then(|| caught(|| job(&cancel)));
        let _ = done.send(outcome);
    }));
    match outcome.await {
        Ok(Some(outcome)) => outcome,
        // It was given up before it began.
        Ok(None) | Err(oneshot::Canceled) => Err(Error::request_cancelled()),
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
    use std::sync::atomic::{AtomicBool, Ordering};
    use std::sync::{Arc, Mutex};
    use std::time::Duration;

    use futures::FutureExt;
    use tower_lsp::jsonrpc::ErrorCode;

    use super::*;
    use ladder_host::testing::TestHost;

    #[test]
    fn a_panic_is_an_answer() {
        let host = TestHost::default();
        let blocking = |job: fn() -> u32| host.run(blocking(&*host.host, move |_| job()));
        let error = blocking(|| panic!("planted")).unwrap_err();
        assert_eq!(error.code, ErrorCode::InternalError);
        assert!(error.message.contains("planted"));
        assert_eq!(blocking(|| 7), Ok(7));
        let error = caught(|| -> u32 { panic!("planted") }).unwrap_err();
        assert_eq!(error.code, ErrorCode::InternalError);
        assert_eq!(caught(|| 7), Ok(7));
    }

    #[test]
    fn a_dropped_handler_stops_its_job() {
        let host = TestHost::default();
        let (begun, done) = (
            Arc::<AtomicBool>::default(),
            Arc::<Mutex<Option<Cancel>>>::default(),
        );
        let (seen, kept) = (begun.clone(), done.clone());
        let handler = blocking(&*host.host, move |cancel| {
            seen.store(true, Ordering::Relaxed);
            *kept.lock().unwrap() = Some(cancel.clone());
        });
        let mut handler = Box::pin(handler);
        assert!(handler.as_mut().now_or_never().is_none());
        drop(handler);
        // What has not begun never begins.
        host.host.turn(Duration::MAX);
        assert!(!begun.load(Ordering::Relaxed));

        let kept = done.clone();
        let mut handler = Box::pin(blocking(&*host.host, move |cancel| {
            *kept.lock().unwrap() = Some(cancel.clone());
        }));
        assert!(handler.as_mut().now_or_never().is_none());
        host.host.turn(Duration::MAX);
        let cancel = done.lock().unwrap().take().unwrap();
        assert!(!cancel.is_cancelled());
        drop(handler);
        assert!(cancel.is_cancelled());
    }
}
