//! What the comments of a ladder text keep of an LDmicro file: header, names, pins, rungs that are comments.

use super::model::{File, Leaf, Node, Rung, Version};
use std::collections::HashMap;

/// How a line begins that is not yet one of LDmicro's: which rung it leads to, or that something leads to its rung, is
/// known once all rungs are there.
pub(super) const UNSETTLED: char = '\0';

/// The line in `# ldmicro: GOSUB init #`, as it was before it became a comment.
pub(super) fn kept(comment: &str) -> Option<String> {
    after(comment, "ldmicro:")
}

/// What is after a word in a comment.
pub(super) fn after(comment: &str, word: &str) -> Option<String> {
    let text = comment
        .strip_prefix('#')?
        .strip_suffix('#')?
        .trim()
        .strip_prefix(word)?;
    Some(unescaped(text.trim()))
}

/// A `#` is `\x23` in a comment. A backslash of LDmicro's is doubled, so its `\\x23` is none.
fn unescaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find('\\') {
        out.push_str(&rest[..at]);
        rest = &rest[at..];
        let length = match rest {
            _ if rest.starts_with("\\x23") => {
                out.push('#');
                rest = &rest[4..];
                continue;
            }
            _ if rest.starts_with("\\\\") => 2,
            _ => 1,
        };
        out.push_str(&rest[..length]);
        rest = &rest[length..];
    }
    out + rest
}

/// A line of the head as a comment keeps it: backslashes are not doubled there, as in the path `D:\x23\a.hex`, so one
/// that would be read as more than itself is `\x5C`.
pub(super) fn head_line(line: &str) -> String {
    line.replace("\\x5C", "\\x5Cx5C").replace("\\x23", "\\x5Cx23")
}

/// What the comments above the networks say.
#[derive(Default)]
pub(super) struct Head {
    pub(super) file: File,
    /// Whether the text was made from an LDmicro file.
    pub(super) is_import: bool,
    /// LDmicro's names for tags that are spelled otherwise.
    pub(super) names: HashMap<String, String>,
    /// LDmicro's names for outputs of pulses, by their numbers.
    pub(super) pulses: HashMap<String, String>,
    /// The pins that declarations name, in their order.
    pub(super) pins: Vec<(String, String)>,
}

impl Head {
    pub(super) fn of(text: &str) -> Head {
        let mut head = Head::default();
        let mut list: Option<(String, Vec<String>)> = None;
        for line in text.lines() {
            let line = line.trim();
            let Some(told) = kept(line).map(|told| told.replace("\\x5C", "\\")) else {
                head.declaration(line);
                continue;
            };
            if let Some((title, mut entries)) = list.take() {
                if told == "END" {
                    head.file.lists.push((title, entries));
                } else {
                    entries.push(told);
                    list = Some((title, entries));
                }
                continue;
            }
            head.is_import |= told.starts_with("LDmicro0.");
            match told.as_str() {
                "LDmicro0.2" => head.file.version = Version::V02,
                "lines end in CR LF" => head.file.encoding.crlf = true,
                "Latin-1" => head.file.encoding.latin1 = true,
                told if told.ends_with(" LIST") && !told.starts_with("SUBPROG ") => {
                    list = Some((told.to_owned(), Vec::new()));
                }
                told => {
                    if let Some(line) = told.strip_prefix("HEADER ") {
                        head.file.passed.push(line.to_owned());
                    } else if let Some(entry) = told.strip_prefix("IO ") {
                        head.file.io.push((0, entry.to_owned()));
                    } else if let Some((tag, name)) =
                        told.strip_prefix("NAME ").and_then(|s| s.split_once(" = "))
                    {
                        head.names.insert(tag.to_owned(), name.to_owned());
                    } else if let Some((number, name)) =
                        told.strip_prefix("PULSES ").and_then(|s| s.split_once(" = "))
                    {
                        head.pulses.insert(number.to_owned(), name.to_owned());
                    } else if !told.starts_with("COMMENT") && told.contains('=') {
                        head.file.header.push(told.to_owned());
                    }
                }
            }
        }
        head
    }

    /// The pin in `Xin : BOOL;  # pin 21 #`.
    fn declaration(&mut self, line: &str) {
        let Some((declared, comment)) = line.split_once(';') else {
            return;
        };
        let (Some((name, _)), comment) = (declared.split_once(':'), comment.trim()) else {
            return;
        };
        let pin = match comment {
            "# no pin #" => Some("0".to_owned()),
            comment => after(comment, "pin "),
        };
        self.pins.extend(pin.map(|pin| (name.trim().to_owned(), pin)));
    }
}

/// A comment as an element.
pub(super) fn comment(text: &str) -> Node {
    let text = format!("COMMENT {text}");
    Node::Leaf(Leaf { line: 0, text })
}

/// The rungs that the comments between two networks are: neighbouring lines are one comment.
pub(super) fn comments(text: &str) -> Vec<Rung> {
    let mut rungs = Vec::new();
    let mut lines: Vec<String> = Vec::new();
    let mut rung = |parts| rungs.push(Rung { line: 0, parts });
    let mut in_definition = false;
    for line in text.lines().map(str::trim).chain([""]) {
        // A comment on a block, in it or right above it, is not a rung.
        if line.starts_with("FUNCTION_BLOCK") {
            in_definition = true;
            lines.clear();
        }
        in_definition &= !line.starts_with("END_FUNCTION_BLOCK");
        if in_definition {
            continue;
        }
        let kept = kept(line);
        let is_said = line.len() > 1
            && line.starts_with('#')
            && line.ends_with('#')
            && after(line, "ladder:").is_none();
        if is_said && kept.is_none() {
            let told = line.trim_matches('#').trim();
            lines.push(told.replace('\\', "\\\\"));
            continue;
        }
        if !lines.is_empty() {
            rung(vec![comment(&lines.join("\\r\\n"))]);
            lines.clear();
        }
        match kept.as_deref() {
            Some("RUNG") => rung(Vec::new()),
            Some(told) if told.starts_with("SUBPROG ") => {
                let text = format!("{UNSETTLED}{told}");
                rung(vec![Node::Leaf(Leaf { line: 0, text })]);
            }
            Some(told) if told.starts_with("COMMENT") => {
                rung(vec![comment(told["COMMENT".len()..].trim_start())]);
            }
            _ => {}
        }
    }
    rungs
}
