//! An LDmicro program as its file has it.

/// The version of the file format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Version {
    /// `LDmicro0.1`: LDmicro up to 2.2.
    #[default]
    V01,
    /// `LDmicro0.2`: the fork from 5.0 on.
    V02,
}

impl Version {
    /// The first line of a file.
    pub(super) const fn line(self) -> &'static str {
        match self {
            Version::V01 => "LDmicro0.1",
            Version::V02 => "LDmicro0.2",
        }
    }

    /// By how many blanks LDmicro indents each level.
    pub(super) const fn indent(self) -> usize {
        match self {
            Version::V01 => 4,
            Version::V02 => 2,
        }
    }
}

/// How the bytes of a file are to be taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Encoding {
    /// Lines end in CR LF.
    pub(super) crlf: bool,
    /// It is not UTF-8, so each byte is the character with its number.
    pub(super) latin1: bool,
}

/// A whole file.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct File {
    pub(super) version: Version,
    pub(super) encoding: Encoding,
    /// `CYCLE=10000` and so on, in canonical order.
    pub(super) header: Vec<String>,
    /// Lines of the head that LDmicro passes over.
    pub(super) passed: Vec<String>,
    /// `PULL-UP LIST` and `VAR LIST` of the fork: each with its entries.
    pub(super) lists: Vec<(String, Vec<String>)>,
    /// `Xin at 21`
    pub(super) io: Vec<(u32, String)>,
    pub(super) rungs: Vec<Rung>,
}

/// What the lines of a file depend on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Dialect {
    pub(super) version: Version,
    /// The length of a cycle in microseconds.
    pub(super) cycle: u64,
}

impl File {
    /// What its lines depend on.
    pub(super) fn dialect(&self) -> Dialect {
        Dialect {
            version: self.version,
            cycle: self.cycle(),
        }
    }

    /// The length of a cycle in microseconds.
    pub(super) fn cycle(&self) -> u64 {
        let line = self.header.iter().find_map(|line| line.strip_prefix("CYCLE="));
        let cycle = line
            .and_then(number)
            .filter(|cycle| (1..=LONGEST_CYCLE).contains(cycle));
        cycle.unwrap_or(DEFAULT_CYCLE)
    }

    /// Sets another length for a cycle; what else its line says stays.
    pub(super) fn set_cycle(&mut self, microseconds: u64) {
        if self.cycle() == microseconds {
            return;
        }
        let line = self.header.iter_mut().find(|line| line.starts_with("CYCLE="));
        match line {
            Some(line) => {
                let after = line["CYCLE=".len()..].trim_start_matches(|c: char| c.is_ascii_digit());
                *line = format!("CYCLE={microseconds}{after}");
            }
            None => self.header.push(format!("CYCLE={microseconds}")),
        }
    }
}

/// The length of a cycle where a file gives none, in microseconds; scans take as long here.
pub(super) const DEFAULT_CYCLE: u64 = 10_000;

/// A day.
const LONGEST_CYCLE: u64 = 86_400_000_000;

/// The number that a text begins with.
pub(super) fn number(text: &str) -> Option<u64> {
    let end = text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
    text[..end].parse().ok()
}

/// A rung: its parts in series.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Rung {
    pub(super) line: u32,
    pub(super) parts: Vec<Node>,
}

/// A part of a rung.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Node {
    Leaf(Leaf),
    Series(Vec<Node>),
    Parallel(Vec<Node>),
}

/// An element: its line, with one blank between its fields.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Leaf {
    pub(super) line: u32,
    pub(super) text: String,
}

impl Leaf {
    /// The text of a comment, if it is one.
    pub(super) fn comment(&self) -> Option<&str> {
        let text = self.text.strip_prefix("COMMENT")?;
        Some(text.strip_prefix(' ').unwrap_or(text))
    }
}

/// The elements of parts, from left to right and top to bottom.
pub(super) fn leaves(parts: &[Node]) -> Vec<&Leaf> {
    fn collect<'n>(parts: &'n [Node], out: &mut Vec<&'n Leaf>) {
        for part in parts {
            match part {
                Node::Leaf(leaf) => out.push(leaf),
                Node::Series(parts) | Node::Parallel(parts) => collect(parts, out),
            }
        }
    }
    let mut out = Vec::new();
    collect(parts, &mut out);
    out
}
