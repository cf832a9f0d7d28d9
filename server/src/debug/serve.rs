//! One session, from the first byte to the end.

use std::io::Write;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, TryRecvError, channel};

use ladder_debugger::Adapter;
use tokio::io::AsyncRead;

use super::wire::{self, Incoming};
use crate::native;

/// Serves one client until it disconnects or its input ends.
///
/// # Errors
/// The operating system has no thread for the input.
pub(crate) fn serve<I, W>(input: impl FnOnce() -> I + Send + 'static, output: W) -> std::io::Result<()>
where
    I: AsyncRead + Unpin,
    W: Write + Send + 'static,
{
    let (sender, inbox) = channel();
    let urgent = Arc::<AtomicUsize>::default();
    let counter = urgent.clone();
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build()?;
    // It reads as long as there is input; waiting for it to end would be waiting for the client.
    std::thread::Builder::new().name("input".into()).spawn(move || {
        runtime.block_on(async { wire::read(input(), sender, counter).await });
        runtime.shutdown_background();
    })?;
    let mut adapter = Adapter::new(native::world(), wire::framed(output), urgent.clone());
    while !adapter.is_over() {
        match next(&inbox, &adapter) {
            Ok(Incoming::Request(request)) => {
                if request.is_urgent() {
                    urgent.fetch_sub(1, Ordering::SeqCst);
                }
                adapter.handle(&request);
            }
            Ok(Incoming::Broken { seq, problem }) => adapter.refuse(seq, problem),
            Err(RecvTimeoutError::Timeout) => adapter.run_on(),
            Err(RecvTimeoutError::Disconnected) => adapter.leave(),
        }
    }
    Ok(())
}

/// What comes next: a message, or the time to go on.
fn next(inbox: &Receiver<Incoming>, adapter: &Adapter) -> Result<Incoming, RecvTimeoutError> {
    if !adapter.is_running() {
        return inbox.recv().map_err(|_| RecvTimeoutError::Disconnected);
    }
    match adapter.due() {
        Some(due) => inbox.recv_timeout(due.saturating_sub(adapter.clock().now())),
        None => inbox.try_recv().map_err(|error| match error {
            TryRecvError::Empty => RecvTimeoutError::Timeout,
            TryRecvError::Disconnected => RecvTimeoutError::Disconnected,
        }),
    }
}
