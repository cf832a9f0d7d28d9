//! Renaming, with `$0` at what gets another name.

mod drawing;
mod files;
mod kept;
mod scenarios;
mod taken;
mod types;

use super::rename;
use crate::fixture::Fixture;
use expect_test::Expect;
use ladder_format::{Options, apply};

fn renamed(text: &str, new: &str) -> String {
    let fixture = Fixture::new(text);
    let (context, offset, others) = fixture.ask();
    match rename(context, offset, new, &others, &Options::default()) {
        Err(refused) => format!("refused: {refused}\n"),
        Ok(files) => {
            let several = fixture.files.len() + fixture.scenarios.len() > 1;
            let show = files.iter().map(|file| {
                let head = if several {
                    format!("%% {}\n", file.file)
                } else {
                    String::new()
                };
                head + &apply(fixture.text(&file.file), &file.edits)
            });
            show.collect::<Vec<_>>().concat()
        }
    }
}

fn check(text: &str, new: &str, expected: Expect) {
    expected.assert_eq(&renamed(text, new));
}
