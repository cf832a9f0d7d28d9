//! What is above the rungs of a file: which version it is, settings, lists.

use super::model::{File, Version, number};
use super::parse::Lines;
use ladder_notation::{LineColumn, ReadError};

/// No more lines than these are checked for a header.
const MOST_CHECKED: usize = 200;

/// The version that a line of the head gives: of anything but `LDmicro0.1` the fork makes its own version, `LDmicro` alone
/// included. The last such line holds.
fn version(line: &str) -> Option<Version> {
    let rest = line.strip_prefix("LDmicro")?;
    Some(match rest.split_whitespace().next() {
        Some("0.1") => Version::V01,
        _ => Version::V02,
    })
}

/// Whether a file is an LDmicro program: it has a header of one word, first or with a line that only LDmicro has next to it.
pub(super) fn recognises(bytes: &[u8]) -> bool {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let lines = bytes.split(|byte| matches!(byte, b'\r' | b'\n'));
    let mut lines = lines.map(<[u8]>::trim_ascii).filter(|line| !line.is_empty());
    let is_header = |line: &[u8]| line.starts_with(b"LDmicro") && !line.contains(&b' ');
    let is_own = |line: &[u8]| {
        matches!(line, b"IO LIST" | b"VAR LIST" | b"PROGRAM")
            || line.starts_with(b"CYCLE=")
            || line.starts_with(b"MICRO=")
    };
    let mut checked = lines.by_ref().take(MOST_CHECKED);
    let Some(first) = checked.next() else {
        return false;
    };
    if matches!(first, b"LDmicro0.1" | b"LDmicro0.2") {
        return true;
    }
    let (mut header, mut own) = (is_header(first), is_own(first));
    for line in checked {
        if header && own {
            break;
        }
        header |= is_header(line);
        own |= is_own(line);
    }
    header && own
}

fn no_header() -> ReadError {
    let message = "the first line of an LDmicro program is `LDmicro0.1` or `LDmicro0.2`";
    ReadError::at(LineColumn::START, message)
}

/// Everything up to `PROGRAM`.
pub(super) fn read(file: &mut File, lines: &mut Lines<'_>) -> Result<(), ReadError> {
    let mut settings: Vec<String> = Vec::new();
    let mut given: Option<Version> = None;
    let mut io: Vec<(u32, Vec<&str>)> = Vec::new();
    loop {
        let Some(line) = lines.next()? else {
            given.ok_or_else(no_header)?;
            return Err(lines.error("the file ends before `PROGRAM`"));
        };
        match line.trim_start_matches('\u{feff}') {
            "PROGRAM" => break,
            "" => {}
            "IO LIST" => {
                for (number, entry) in lines.list(line)? {
                    let words: Vec<&str> = entry.split_whitespace().collect();
                    if words.len() < 3 || words[1] != "at" {
                        let message = "an entry of the IO LIST is `Xname at 12`: a name, `at`, a pin";
                        return Err(ReadError::at(LineColumn::line(number), message));
                    }
                    io.push((number, words));
                }
            }
            line if line.ends_with(" LIST") => {
                let entries = lines.list(line)?.into_iter().map(|(_, entry)| entry.to_owned());
                file.lists.push((line.to_owned(), entries.collect()));
            }
            line if SETTINGS.iter().any(|name| value(line, name).is_some()) => settings.push(line.to_owned()),
            line => match version(line) {
                Some(version) => given = Some(version),
                // LDmicro passes over any other line here.
                None => file.passed.push(line.to_owned()),
            },
        }
    }
    file.version = given.ok_or_else(no_header)?;
    let fields = match file.version {
        Version::V01 => 3,
        Version::V02 => usize::MAX,
    };
    file.io = io
        .into_iter()
        .map(|(number, words)| (number, words[..words.len().min(fields)].join(" ")))
        .collect();
    file.header = header(file.version, &settings);
    Ok(())
}

/// What a header can set, in canonical order.
const SETTINGS: [&str; 6] = ["MICRO", "CYCLE", "CRYSTAL", "BAUD", "COMPILED", "COMPILER"];

fn value<'l>(line: &'l str, name: &str) -> Option<&'l str> {
    line.strip_prefix(name)?.strip_prefix('=')
}

/// The lines of a header as LDmicro saves them. Where a setting is given twice, the last one holds.
pub(super) fn header(version: Version, lines: &[String]) -> Vec<String> {
    let setting = |name: &str| lines.iter().rev().find_map(|line| value(line, name));
    SETTINGS
        .iter()
        .filter_map(|name| {
            let given = setting(name);
            let default = match *name {
                "CYCLE" => Some(10_000),
                "CRYSTAL" => Some(4_000_000),
                "BAUD" => Some(2_400),
                _ => None,
            };
            match (version, given, default) {
                (Version::V01, Some(given), Some(default)) => {
                    Some(format!("{name}={}", number(given).unwrap_or(default)))
                }
                (Version::V01, _, None) if *name == "COMPILER" => None,
                (_, Some(given), _) => Some(format!("{name}={given}")),
                (_, None, default) => default.map(|default| format!("{name}={default}")),
            }
        })
        .collect()
}
