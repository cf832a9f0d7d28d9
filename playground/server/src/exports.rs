//! What JavaScript calls. Texts and bytes cross in two buffers: what comes in is written to where [`room`] says, and what goes out
//! lies at [`spoken`], as long as [`length`] says.
#![allow(
    unsafe_code,
    reason = "to give a function its name outside is all that is unsafe here"
)]

use std::cell::RefCell;
use std::time::Duration;

use ladder_host::{Clock, Wait};

use crate::Page;

/// The longest time that the server works before the worker reads messages again.
const TURN: Duration = Duration::from_millis(10);

#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// The time in milliseconds, on a clock that goes on.
    safe fn now() -> f64;
}

thread_local! {
    static PAGE: Page = Page::new(Clock::new(|| Duration::from_secs_f64(now() / 1000.0)));
    static COMES_IN: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static GOES_OUT: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Where as many bytes can be written.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn room(length: usize) -> *mut u8 {
    COMES_IN.with_borrow_mut(|bytes| {
        bytes.clear();
        bytes.resize(length, 0);
        bytes.as_mut_ptr()
    })
}

/// Begins.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn begin() {
    PAGE.with(|_| {});
}

/// The bytes that came in are a name of this length and a file.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn write(name: usize) {
    let bytes = COMES_IN.take();
    if let Some((name, content)) = bytes.split_at_checked(name) {
        PAGE.with(|page| page.write(&String::from_utf8_lossy(name), content));
    }
}

/// The bytes that came in are the name of a file that goes.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn remove() {
    let name = COMES_IN.take();
    PAGE.with(|page| page.remove(&String::from_utf8_lossy(&name)));
}

/// The bytes that came in are a message.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn receive() {
    let message = COMES_IN.take();
    PAGE.with(|page| page.receive(message));
}

/// Works for a moment. So many milliseconds later it has to be called again; never, if that is less than nothing and no message
/// comes.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn turn() -> f64 {
    PAGE.with(|page| match page.turn(TURN) {
        Wait::No => 0.0,
        Wait::Until(moment) => page.time_until(moment).as_secs_f64() * 1000.0,
        Wait::Arrival | Wait::Over => -1.0,
    })
}

/// Takes the next thing that the server has said: whether there is one.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn next() -> bool {
    let said = PAGE.with(Page::said);
    let is_there = said.is_some();
    GOES_OUT.set(said.unwrap_or_default());
    is_there
}

/// Where lies what was taken.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn spoken() -> *const u8 {
    GOES_OUT.with_borrow(|text| text.as_ptr())
}

/// How long that is, in bytes.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn length() -> usize {
    GOES_OUT.with_borrow(String::len)
}
