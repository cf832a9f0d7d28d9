//! Markdown as a client can take it.

use tower_lsp::ls_types::{Documentation, MarkupContent, MarkupKind};

/// Markdown, or the words of it.
pub(crate) fn content(markdown: bool, text: String) -> MarkupContent {
    if markdown {
        MarkupContent {
            kind: MarkupKind::Markdown,
            value: text,
        }
    } else {
        MarkupContent {
            kind: MarkupKind::PlainText,
            value: plain(&text),
        }
    }
}

/// The same, where the protocol wants documentation. A client that lists no formats takes nothing but a text.
pub(crate) fn documentation(markdown: bool, text: String) -> Documentation {
    if markdown {
        Documentation::MarkupContent(content(markdown, text))
    } else {
        Documentation::String(plain(&text))
    }
}

/// The links to lines of a document lead there.
pub(crate) fn linked(text: String, uri: &str) -> String {
    if text.contains("](#L") {
        text.replace("](#L", &format!("]({uri}#L"))
    } else {
        text
    }
}

/// The text without its Markdown: fences, backquotes, the stars of bold text and the targets of links go.
fn plain(markdown: &str) -> String {
    let lines = markdown.lines().filter(|line| !line.starts_with("```"));
    let lines = lines.map(|line| unlinked(&line.replace("**", "").replace('`', "")));
    lines.collect::<Vec<_>>().join("\n")
}

/// `[2](file:///a.clad#L2)` is `2`.
fn unlinked(line: &str) -> String {
    let mut out = String::new();
    let mut rest = line;
    while let Some(middle) = rest.find("](") {
        let Some(open) = rest[..middle].rfind('[') else {
            break;
        };
        let target = &rest[middle + 2..];
        let Some(end) = target.find(')').filter(|&end| target[..end].contains("#L")) else {
            break;
        };
        out.push_str(&rest[..open]);
        out.push_str(&rest[open + 1..middle]);
        rest = &target[end + 1..];
    }
    out + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_text_keeps_the_words() {
        assert_eq!(
            plain("**on-delay** timer\n```clad\n[TON]( t, PT )\n```\nsee `ET`"),
            "on-delay timer\n[TON]( t, PT )\nsee ET"
        );
        let linked = linked("Read: lines [2](#L2), [31](#L31)".to_owned(), "file:///a.clad");
        assert_eq!(
            linked,
            "Read: lines [2](file:///a.clad#L2), [31](file:///a.clad#L31)"
        );
        assert_eq!(plain(&linked), "Read: lines 2, 31");
        assert_eq!(
            plain("+--[ ]( a )--[TON](t, 5s)--+"),
            "+--[ ]( a )--[TON](t, 5s)--+"
        );
    }
}
