//! What the snippets of the extension for Visual Studio Code put in, as it comes, is a program without findings in the canonical layout.

use ladder_analysis::{Severity, analyze};
use ladder_format::{Options, format_text};
use ladder_syntax::parse;
use ladder_tests::project::{read, root};
use serde_json::Value;
use std::sync::Arc;

/// The text that comes if nothing is typed into a snippet: `${1:start}` is `start`, `$0` nothing, `\\` a backslash.
fn plain(body: &str) -> String {
    let mut out = String::new();
    let mut rest = body.chars().peekable();
    let mut inside = false;
    while let Some(letter) = rest.next() {
        match letter {
            '\\' => out.extend(rest.next()),
            '$' if rest.next_if_eq(&'{').is_some() => {
                inside = true;
                // The number and its colon.
                rest.by_ref().find(|letter| *letter == ':');
            }
            '$' => while rest.next_if(char::is_ascii_digit).is_some() {},
            '}' if inside => inside = false,
            _ => out.push(letter),
        }
    }
    out
}

#[test]
fn what_a_snippet_puts_in_is_a_program() {
    let text = read(&root().join("editors/vscode/snippets/clad.json"));
    let snippets: Value = serde_json::from_str(&text).unwrap();
    let snippets = snippets.as_object().unwrap();
    assert!(snippets.len() >= 8);
    for (name, snippet) in snippets {
        let lines = snippet["body"].as_array().unwrap();
        let lines: Vec<&str> = lines.iter().map(|line| line.as_str().unwrap()).collect();
        let program = plain(&(lines.join("\n") + "\n"));
        assert_eq!(format_text(&program, &Options::default()), program, "{name}");
        let parse = Arc::new(parse(&program));
        for finding in analyze(&parse, "program").diagnostics() {
            assert!(finding.severity == Severity::Info, "{name}: {}", finding.message);
        }
    }
}
