//! From the model to the bytes of a file, as LDmicro itself saves it.

use super::model::{File, Node, Version};

/// The whole file.
pub(super) fn save(file: &File) -> Vec<u8> {
    let indent = " ".repeat(file.version.indent());
    let mut out = vec![file.version.line().to_owned()];
    out.extend(file.header.iter().cloned());
    out.extend(file.passed.iter().cloned());
    out.push(String::new());
    for (title, entries) in &file.lists {
        out.push(title.clone());
        out.extend(entries.iter().map(|entry| format!("{indent}{entry}")));
        out.extend(["END".to_owned(), String::new()]);
    }
    out.push("IO LIST".to_owned());
    out.extend(file.io.iter().map(|(_, entry)| format!("{indent}{entry}")));
    out.extend(["END".to_owned(), String::new(), "PROGRAM".to_owned()]);
    for (number, rung) in file.rungs.iter().enumerate() {
        out.push(match file.version {
            Version::V01 => "RUNG".to_owned(),
            Version::V02 => format!("RUNG {}", number + 1),
        });
        nodes(&rung.parts, &indent, 1, &mut out);
        out.push("END".to_owned());
    }
    let end = if file.encoding.crlf { "\r\n" } else { "\n" };
    let text: String = out.into_iter().flat_map(|line| [line, end.to_owned()]).collect();
    // What a ladder text has that Latin-1 has not, is kept in UTF-8.
    let latin1 = file
        .encoding
        .latin1
        .then(|| text.chars().map(|c| u8::try_from(c).ok()).collect());
    latin1.flatten().unwrap_or_else(|| text.into_bytes())
}

fn nodes(parts: &[Node], indent: &str, depth: usize, out: &mut Vec<String>) {
    let before = indent.repeat(depth);
    for part in parts {
        let (word, inside) = match part {
            Node::Leaf(leaf) => {
                out.push(format!("{before}{}", leaf.text));
                continue;
            }
            Node::Series(inside) => ("SERIES", inside),
            Node::Parallel(inside) => ("PARALLEL", inside),
        };
        out.push(format!("{before}{word}"));
        nodes(inside, indent, depth + 1, out);
        out.push(format!("{before}END"));
    }
}
