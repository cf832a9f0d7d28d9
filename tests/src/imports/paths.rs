//! The paths in a Rust source: those of its `use` declarations, and those in its code.

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};

/// The paths of a source, segment by segment. Comments, texts and what is built for tests only have none.
pub(super) fn of(text: &str) -> Vec<Vec<String>> {
    let tokens = tokens(text);
    let tokens: Vec<&str> = tokens.iter().map(String::as_str).collect();
    let tokens = without_tests(&tokens);
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

/// The names of modules in other files that are marked `#[cfg(test)]`.
pub(super) fn test_modules(text: &str) -> Vec<String> {
    let tokens = tokens(text);
    let tokens: Vec<&str> = tokens.iter().map(String::as_str).collect();
    let marked = tokens.windows(MARK.len() + 3).filter_map(|window| match window {
        [mark @ .., "mod", name, ";"] if *mark == MARK => Some((*name).to_owned()),
        _ => None,
    });
    marked.collect()
}

const MARK: [&str; 7] = ["#", "[", "cfg", "(", "test", ")", "]"];

/// The tokens without items, fields and statements that are marked `#[cfg(test)]`.
fn without_tests<'t>(tokens: &[&'t str]) -> Vec<&'t str> {
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

/// Words, `::`, brackets and single characters. Texts, numbers and characters are left out.
fn tokens(text: &str) -> Vec<String> {
    let stream: TokenStream = text.parse().expect("a source can be split into tokens");
    let mut all = Vec::new();
    flatten(stream, &mut all);
    all
}

fn flatten(stream: TokenStream, all: &mut Vec<String>) {
    let mut is_half = false;
    for tree in stream {
        let was_half = std::mem::take(&mut is_half);
        match tree {
            TokenTree::Group(group) => {
                let (opening, closing) = match group.delimiter() {
                    Delimiter::Parenthesis => ("(", ")"),
                    Delimiter::Brace => ("{", "}"),
                    Delimiter::Bracket => ("[", "]"),
                    Delimiter::None => ("", ""),
                };
                all.push(opening.to_owned());
                flatten(group.stream(), all);
                all.push(closing.to_owned());
            }
            TokenTree::Ident(word) => all.push(word.to_string()),
            TokenTree::Punct(sign) if sign.as_char() == ':' && was_half => {
                all.pop();
                all.push("::".to_owned());
            }
            TokenTree::Punct(sign) => {
                is_half = sign.as_char() == ':' && sign.spacing() == Spacing::Joint;
                all.push(sign.to_string());
            }
            TokenTree::Literal(_) => {}
        }
    }
}
