//! What watches controllers has no way to them but the guards, and no word for writing.

use std::fs::{read_dir, read_to_string};
use std::path::{Path, PathBuf};

/// Names through which a connection could be had.
const WAYS: [&str; 10] = [
    "TcpStream",
    "TcpListener",
    "TcpSocket",
    "UdpSocket",
    "UnixStream",
    "ToSocketAddrs",
    "tcp_connector",
    "TcpTransport",
    "LogixDriver::new",
    "CipDriver",
];

/// Parts of the driver for Logix that write, or that make objects in a controller.
const WRITERS: [&str; 9] = [
    "ciplink::slc",
    "ciplink::adapter",
    "ciplink::packets",
    "ciplink::browse",
    "trend",
    "generic_message",
    "_raw(",
    "set_plc_time",
    "tag_cache",
];

/// Everything that the driver is asked for.
const ASKED: [&str; 6] = [
    "open",
    "close",
    "connected",
    "definitions",
    "definitions_version",
    "read",
];

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in read_dir(folder).expect("a folder that can be read") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files(&path, found);
        } else {
            found.push(path);
        }
    }
}

#[test]
fn only_guards_have_sockets_and_nothing_writes() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/online");
    let mut found = Vec::new();
    files(&folder, &mut found);
    assert!(
        found.iter().any(|path| path.ends_with("logix/guard.rs")),
        "{found:?}"
    );
    for path in found {
        let name = path
            .strip_prefix(&folder)
            .expect("a file within")
            .display()
            .to_string();
        let text: String = read_to_string(&path)
            .expect("a file")
            .split_whitespace()
            .collect();
        if name.ends_with("tests.rs") {
            continue;
        }
        if !name.contains("guard") {
            for way in WAYS {
                assert!(
                    !text.contains(way),
                    "{name} has {way}: only a guard may open a connection"
                );
            }
        }
        for writer in WRITERS {
            assert!(!text.contains(writer), "{name} has {writer}");
        }
        for (at, _) in text.match_indices("driver.") {
            let rest = &text[at + "driver.".len()..];
            let asked: String = rest
                .chars()
                .take_while(|letter| letter.is_alphanumeric() || *letter == '_')
                .collect();
            assert!(
                ASKED.contains(&asked.as_str()),
                "{name} asks the driver for {asked}"
            );
        }
    }
}
