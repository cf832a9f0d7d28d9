//! Refactorings, with `$0` where the cursor is, or from `$0` to `$1` what is selected.

mod allows;
mod blocks;
mod branches;
mod latches;
mod networks;
mod pasted;
mod structures;
mod suggestions;
mod toggles;

use super::{Action, refactorings};
use expect_test::Expect;
use ladder_analysis::analyze;
use ladder_format::{Options, apply};
use ladder_syntax::{TextRange, TextSize, parse};
use std::fmt::Write;
use std::sync::Arc;

/// The text of a fixture, and what is selected in it.
fn fixture(marked: &str) -> (String, TextRange) {
    let start = marked.find("$0").expect("a fixture has its $0");
    let text = marked.replacen("$0", "", 1);
    let end = text.find("$1").unwrap_or(start);
    let text = text.replacen("$1", "", 1);
    (
        text,
        TextRange::new(TextSize::new(start as u32), TextSize::new(end as u32)),
    )
}

fn offered(text: &str, range: TextRange) -> Vec<Action> {
    let analysis = analyze(&Arc::new(parse(text)), "test.clad");
    refactorings(&analysis, range)
}

/// The text after the action whose title begins so.
#[track_caller]
fn done(begin: &str, text: &str, range: TextRange) -> String {
    let analysis = analyze(&Arc::new(parse(text)), "test.clad");
    let actions = refactorings(&analysis, range);
    let action = actions.iter().find(|action| action.title.starts_with(begin));
    let action = action.unwrap_or_else(|| panic!("{begin} is not offered in\n{text}"));
    apply(text, &action.aligned(&analysis, text, &Options::default()))
}

/// What the action does whose title begins so; or why it cannot.
#[track_caller]
fn check(begin: &str, marked: &str, expected: Expect) {
    let (text, range) = fixture(marked);
    let analysis = analyze(&Arc::new(parse(&text)), "test.clad");
    let actions = refactorings(&analysis, range);
    let action = actions.iter().find(|action| action.title.starts_with(begin));
    let shown = match action {
        None => "not offered\n".to_owned(),
        Some(Action {
            disabled: Some(why), ..
        }) => format!("disabled: {why}\n"),
        Some(action) => {
            let edits = action.aligned(&analysis, &text, &Options::default());
            format!("{}\n\n{}", action.title, apply(&text, &edits))
        }
    };
    expected.assert_eq(&shown);
}

/// The titles of all that is offered.
#[track_caller]
fn titles(marked: &str, expected: Expect) {
    let (text, range) = fixture(marked);
    let mut shown = String::new();
    for action in offered(&text, range) {
        let why = action
            .disabled
            .map_or_else(String::new, |why| format!(" -- {why}"));
        let _ = writeln!(shown, "{}{why}", action.title);
    }
    expected.assert_eq(&shown);
}
