//! The pairs of drawings in the book that show what a code action does: the second is what the action makes of the first.
//!
//! Above the first is `<!-- refactoring: TITLE | TEXT -->`: how the action's title begins, and where it is asked for:
//! at a text that is in the first drawing (`( stop`: in the middle of it), or with that text selected, if it holds a
//! whole block. `UPDATE_EXPECT=1 cargo test -p ladder-tests` writes the second drawings into the page.

use ladder_analysis::analyze;
use ladder_format::{Options, apply};
use ladder_ide::refactorings;
use ladder_syntax::{TextRange, TextSize, parse};
use ladder_tests::book::source;
use ladder_tests::{markdown, project};
use std::sync::Arc;

/// What the action makes of a text; or what is offered instead.
fn done(text: &str, title: &str, place: &str) -> String {
    let at = text
        .find(place)
        .unwrap_or_else(|| panic!("`{place}` is not in\n{text}"));
    let (start, end) = (TextSize::new(at as u32), TextSize::new((at + place.len()) as u32));
    let range = if place.contains(")--") || place.ends_with(" )") {
        TextRange::new(start, end)
    } else {
        TextRange::empty(start + TextSize::new(2))
    };
    let analysis = analyze(&Arc::new(parse(text)), "program");
    let actions = refactorings(&analysis, range);
    let found = actions
        .iter()
        .find(|action| action.title.starts_with(title) && action.disabled.is_none());
    match found {
        Some(action) => apply(text, &action.aligned(&analysis, text, &Options::default())),
        None => format!("`{title}` is not offered at `{place}`, but {actions:#?}"),
    }
}

#[test]
fn drawings_show_what_actions_do() {
    let file = source().join("guide/refactoring.md");
    let text = project::read(&file);
    let fences = markdown::read(&text).fences;
    let update = std::env::var_os("UPDATE_EXPECT").is_some();
    let mut new_text = text.clone();
    let mut problems = Vec::new();
    let mut pairs: Vec<(usize, &str)> = text.match_indices("<!-- refactoring: ").collect();
    assert!(pairs.len() > 10, "only {} pairs of drawings", pairs.len());
    pairs.reverse();
    for (at, mark) in pairs {
        let rest = &text[at + mark.len()..];
        let (title, place) = rest
            .split_once(" -->")
            .and_then(|(rest, _)| rest.split_once(" | "))
            .unwrap_or_else(|| panic!("a title and a place are in the comment: {rest:.40}"));
        let mut after = fences
            .iter()
            .filter(|fence| fence.line > text[..at].lines().count());
        let (Some(before), Some(after)) = (after.next(), after.next()) else {
            panic!("two drawings are below {title}");
        };
        let made = done(&before.text, title, place);
        if made != after.text {
            problems.push(format!(
                "{}:{}: {title} gives\n{made}",
                file.display(),
                after.line
            ));
            assert!(!made.contains("is not offered"), "{made}");
            new_text.replace_range(after.range.clone(), &made);
        }
    }
    if update && new_text != text {
        std::fs::write(&file, new_text).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    }
    assert!(update || problems.is_empty(), "{}", problems.join("\n"));
}
