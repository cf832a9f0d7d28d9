//! What typing brings about, with `$0` where the cursor is.

mod completed;
mod enter;
mod typed_over;

use super::on_type;
use crate::fixture::Fixture;
use expect_test::Expect;
use ladder_format::{Options, apply};

/// The character before the cursor is the one that was typed; blanks there are those that an editor puts after a
/// line end.
fn check(text: &str, expected: Expect) {
    let fixture = Fixture::new(text);
    let (_, offset, _) = fixture.ask();
    let before = fixture.text("main.clad");
    let typed = before[..usize::from(offset)]
        .trim_end_matches(' ')
        .chars()
        .next_back();
    check_typed(text, typed.unwrap(), expected);
}

/// The character is asked about once more: others were typed after it since.
fn check_typed(text: &str, typed: char, expected: Expect) {
    let fixture = Fixture::new(text);
    let (context, offset, _) = fixture.ask();
    let before = fixture.text("main.clad");
    let edits = on_type(context, offset, typed, &Options::default());
    let shown = if edits.is_empty() {
        "nothing".to_owned()
    } else {
        let after = apply(before, &edits);
        let solid = |text: &str| text.replace([' ', '-', '|', '+', '/', '\\', '\n', '\r'], "");
        assert_eq!(solid(before), solid(&after), "nothing is lost");
        after.replace('\r', "").replace(" \n", "·\n")
    };
    expected.assert_eq(&(shown + "\n"));
}
