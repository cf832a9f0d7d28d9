//! The paths in a Rust source: those of its `use` declarations, and those in its code.

/// The paths of a source, segment by segment. Comments, texts and what is built for tests only have none.
pub(super) fn of(text: &str) -> Vec<Vec<String>> {
    let tokens = without_tests(&tokens(text));
    let mut paths = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        if tokens[at] == "use" {
            at = tree(&tokens, at + 1, &[], &mut paths);
            continue;
        }
        let begin = at;
        let mut path = Vec::new();
        while tokens.get(at).is_some_and(|token| is_word(token)) {
            path.push(tokens[at].to_owned());
            if tokens.get(at + 1) != Some(&"::") {
                break;
            }
            at += 2;
        }
        at = at.max(begin) + 1;
        // `pub(in crate::room)` imports nothing.
        let is_visibility = begin > 1 && tokens[begin - 1] == "in" && tokens[begin - 2] == "(";
        let goes_on = begin > 0 && tokens[begin - 1] == "::";
        if path.len() > 1 && !is_visibility && !goes_on {
            paths.push(path);
        }
    }
    paths
}

/// Reads a tree of a `use` declaration, whose paths begin with `before`. Returns where it ends.
fn tree(tokens: &[&str], mut at: usize, before: &[String], paths: &mut Vec<Vec<String>>) -> usize {
    let mut path = before.to_vec();
    while let Some(&token) = tokens.get(at) {
        match token {
            "{" => {
                at += 1;
                while tokens.get(at).is_some_and(|token| *token != "}") {
                    at = tree(tokens, at, &path, paths);
                    at += usize::from(tokens.get(at) == Some(&","));
                }
                return at + 1;
            }
            "as" => at += 2,
            "::" => at += 1,
            // What a tree of paths imports from its beginning.
            "self" if !path.is_empty() => at += 1,
            "*" => {
                path.push(token.to_owned());
                at += 1;
            }
            word if is_word(word) => {
                path.push(word.to_owned());
                at += 1;
            }
            _ => break,
        }
    }
    paths.push(path);
    at
}

fn is_word(token: &str) -> bool {
    token.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

/// The tokens without items, fields and statements that are marked `#[cfg(test)]`.
fn without_tests<'t>(tokens: &[&'t str]) -> Vec<&'t str> {
    const MARK: [&str; 7] = ["#", "[", "cfg", "(", "test", ")", "]"];
    let mut kept = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        if tokens[at..].starts_with(&MARK) {
            at = end_of_item(tokens, at + MARK.len());
        } else {
            kept.push(tokens[at]);
            at += 1;
        }
    }
    kept
}

/// Where an item ends: after its `;`, its `,` or its braces, or where what it is in ends.
fn end_of_item(tokens: &[&str], begin: usize) -> usize {
    let is_use = tokens.get(begin) == Some(&"use");
    let mut depth = 0;
    for (at, token) in tokens.iter().enumerate().skip(begin) {
        match *token {
            "{" | "(" | "[" => depth += 1,
            "}" | ")" | "]" if depth == 0 => return at,
            "}" if depth == 1 && !is_use => return at + 1,
            "}" | ")" | "]" => depth -= 1,
            ";" | "," if depth == 0 => return at + 1,
            _ => {}
        }
    }
    tokens.len()
}

/// Words, `::` and single characters. Comments, texts, characters and lifetimes are left out.
fn tokens(text: &str) -> Vec<&str> {
    let mut tokens = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let word = rest
            .find(|c: char| !c.is_alphanumeric() && c != '_')
            .unwrap_or(rest.len());
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            block_comment(rest)
        } else if let Some(length) = raw_text(rest) {
            length
        } else if first == '"' {
            quoted(rest, '"')
        } else if first == '\'' {
            character_or_lifetime(rest)
        } else {
            let length = if rest.starts_with("::") {
                2
            } else {
                word.max(first.len_utf8())
            };
            if !first.is_whitespace() {
                tokens.push(&rest[..length]);
            }
            length
        };
        rest = &rest[length..];
    }
    tokens
}

/// The length of a comment that may have others in it.
fn block_comment(text: &str) -> usize {
    let mut depth = 0;
    let mut at = 0;
    while at < text.len() {
        let rest = &text[at..];
        if rest.starts_with("/*") {
            depth += 1;
            at += 2;
        } else if rest.starts_with("*/") {
            depth -= 1;
            at += 2;
            if depth == 0 {
                break;
            }
        } else {
            at += rest.chars().next().map_or(1, char::len_utf8);
        }
    }
    at
}

/// The length of a raw text such as `br#".."#`, if one begins here.
fn raw_text(text: &str) -> Option<usize> {
    let after_letters = ["r", "br", "cr"].iter().find_map(|letters| {
        text.strip_prefix(letters)
            .filter(|rest| rest.starts_with(['"', '#']))
    })?;
    let content = after_letters.trim_start_matches('#');
    let hashes = &after_letters[..after_letters.len() - content.len()];
    let content = content.strip_prefix('"')?;
    let end = format!("\"{hashes}");
    let length = content.find(&end)? + end.len();
    Some(text.len() - content.len() + length)
}

/// The length of a text in quotes.
fn quoted(text: &str, quote: char) -> usize {
    let mut escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        if c == quote && !escaped {
            return at + 1;
        }
        escaped = c == '\\' && !escaped;
    }
    text.len()
}

fn character_or_lifetime(text: &str) -> usize {
    let mut chars = text.chars().skip(1);
    let is_character = match chars.next() {
        Some('\\') => true,
        _ => chars.next() == Some('\''),
    };
    if is_character { quoted(text, '\'') } else { 1 }
}
