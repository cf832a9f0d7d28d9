//! What the operating system is asked and told.

use std::ffi::OsStr;
use std::io;

/// Asks the system to wake this thread up within a microsecond of its time instead of 50. Nothing happens where that cannot be asked.
pub fn wake_in_time() {
    // `/proc/thread-self` is a link to `PID/task/TID`; the slack is in the folder that is named for the thread alone.
    let own = std::fs::read_link("/proc/thread-self").ok();
    if let Some(thread) = own.as_deref().and_then(|link| link.file_name()) {
        let file = std::path::Path::new("/proc").join(thread).join("timerslack_ns");
        // Where it cannot be written scans are some microseconds later, which the report shows.
        let _ = std::fs::write(file, "1000");
    }
}

/// Tells the service manager how the program is, where one asked to be told (`NOTIFY_SOCKET`): `READY=1`, `WATCHDOG=1`,
/// `STOPPING=1`.
///
/// # Errors
/// The manager cannot be reached.
pub fn notify(state: &str) -> io::Result<()> {
    match std::env::var_os("NOTIFY_SOCKET") {
        Some(socket) => send(&socket, state),
        None => Ok(()),
    }
}

#[cfg(target_os = "linux")]
fn send(socket: &OsStr, state: &str) -> io::Result<()> {
    use std::os::linux::net::SocketAddrExt;
    use std::os::unix::ffi::OsStrExt;
    use std::os::unix::net::{SocketAddr, UnixDatagram};
    let address = match socket.as_bytes() {
        [b'@', name @ ..] => SocketAddr::from_abstract_name(name)?,
        _ => SocketAddr::from_pathname(socket)?,
    };
    let sender = UnixDatagram::unbound()?;
    sender.send_to_addr(state.as_bytes(), &address).map(|_| ())
}

/// There is no such manager.
#[cfg(not(target_os = "linux"))]
fn send(_: &OsStr, _: &str) -> io::Result<()> {
    Ok(())
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;
    use std::os::linux::net::SocketAddrExt;
    use std::os::unix::net::{SocketAddr, UnixDatagram};

    #[test]
    fn the_manager_is_told_under_a_name_without_a_file() {
        let name = format!("ladder-{}", std::process::id());
        let address = SocketAddr::from_abstract_name(name.as_bytes()).unwrap();
        let manager = UnixDatagram::bind_addr(&address).unwrap();
        send(OsStr::new(&format!("@{name}")), "READY=1").unwrap();
        let mut got = [0; 16];
        let length = manager.recv(&mut got).unwrap();
        assert_eq!(&got[..length], b"READY=1");
        assert!(send(OsStr::new("@nobody-listens-here"), "READY=1").is_err());
    }
}
