//! From an editor's address of a file to its path, and back.

use std::path::{Path, PathBuf};

/// The path of a `file:` address; none for any other (`untitled:`, a file inside an archive).
pub fn path_of(uri: &str) -> Option<PathBuf> {
    let rest = uri.strip_prefix("file://")?;
    // A host may be before the path; only this one's files can be read.
    let rest = rest.strip_prefix("localhost").unwrap_or(rest);
    let path = String::from_utf8(decoded(rest)?).ok()?;
    // Two slashes of either kind name another machine on Windows, and to look there reveals to it who is asking.
    let elsewhere = path
        .as_bytes()
        .get(1)
        .is_some_and(|second| matches!(second, b'/' | b'\\'));
    if !path.starts_with('/') || elsewhere || path.contains('\0') {
        return None;
    }
    let drive = path.as_bytes().get(2) == Some(&b':');
    Some(PathBuf::from(if drive { &path[1..] } else { &path }))
}

/// The address of a file.
pub fn uri_of(path: &Path) -> String {
    let path = path.to_string_lossy().replace('\\', "/");
    let mut uri = String::from("file://");
    if !path.starts_with('/') {
        uri.push('/');
    }
    for byte in path.bytes() {
        match byte {
            b'/' | b'-' | b'.' | b'_' | b'~' | b'0'..=b'9' | b'A'..=b'Z' | b'a'..=b'z' => {
                uri.push(byte as char);
            }
            _ => uri.push_str(&format!("%{byte:02X}")),
        }
    }
    uri
}

fn decoded(text: &str) -> Option<Vec<u8>> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        if byte != b'%' {
            bytes.push(byte);
            continue;
        }
        let digits = [rest.next()?, rest.next()?];
        let digits = std::str::from_utf8(&digits).ok()?;
        bytes.push(u8::from_str_radix(digits, 16).ok()?);
    }
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_and_back() {
        for (uri, path) in [
            ("file:///plant/motor.clad", "/plant/motor.clad"),
            ("file:///plant/main%20line/a%23.clad", "/plant/main line/a#.clad"),
            ("file:///%C3%96l.clad", "/Öl.clad"),
        ] {
            assert_eq!(path_of(uri), Some(PathBuf::from(path)));
            assert_eq!(uri_of(Path::new(path)), uri);
        }
        assert_eq!(
            path_of("file:///c%3A/plant/a.clad"),
            Some(PathBuf::from("c:/plant/a.clad"))
        );
    }

    #[test]
    fn what_is_no_file() {
        for uri in [
            "untitled:Untitled-1",
            "file://host/a.clad",
            "file:////host/share/a.clad",
            "file:///%5C%5Chost/share/a.clad",
            "file:///%5Chost/share/a.clad",
            "file:///a%2",
            "file:///a%ZZ",
            "",
        ] {
            assert_eq!(path_of(uri), None, "{uri}");
        }
    }
}
