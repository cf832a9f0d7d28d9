//! The screens that the book shows are those that one sees.
//!
//! A block that is marked `screen` names what is done at the terminal in the words of [`Bench::play`], separated by
//! commas. `UPDATE_EXPECT=1` writes what one sees into the page.

use super::{Bench, characters};
use std::path::Path;

#[test]
fn screens_in_the_book() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let program = std::fs::read_to_string(root.join("examples/motor.clad")).unwrap();
    let page = root.join("docs/src/guide/simulator.md");
    let text = std::fs::read_to_string(&page).unwrap();
    let mut shown = String::new();
    let mut rest = text.as_str();
    let mut count = 0;
    while let Some(at) = rest.find("```screen,") {
        let (before, fence) = rest.split_at(at);
        let (head, body) = fence.split_once('\n').unwrap();
        let end = body.find("```").unwrap();
        let steps = head["```screen,".len()..].replace(',', " ");
        let screen = Bench::new(&program).play(&steps, |_, buffer| characters(buffer));
        shown.push_str(before);
        shown.push_str(head);
        for line in screen.lines() {
            shown.push('\n');
            shown.push_str(&line[1..]);
        }
        shown.push('\n');
        rest = &body[end..];
        count += 1;
    }
    shown.push_str(rest);
    assert!(count > 0, "the book shows no screen");
    if std::env::var_os("UPDATE_EXPECT").is_some() {
        std::fs::write(&page, &shown).unwrap();
    } else {
        assert!(shown == text, "the book shows another screen than this:\n{shown}");
    }
}
