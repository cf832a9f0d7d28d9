//! What is wrong with a settings file lies in the file, and the rest of it holds.
//!
//! The input is the text of a `ladder.toml`.

use crate::input;
use ladder_workspace::Settings;
use std::ops::Range;
use std::path::Path;

pub(crate) fn check(data: &[u8]) {
    let text = input::text(data);
    let (settings, errors) = Settings::examine(Path::new("plant/ladder.toml"), &text);
    for error in &errors {
        let lies = text.get(Range::<usize>::from(error.range)).is_some();
        assert!(lies, "{error:?} in:\n{text}");
        assert!(!error.message.is_empty(), "{error:?} in:\n{text}");
        assert!(
            error.place.line >= 1 && error.place.column >= 1,
            "{error:?} in:\n{text}"
        );
    }
    let parsed = Settings::parse(Path::new("plant/ladder.toml"), &text);
    assert_eq!(parsed.is_ok(), errors.is_empty(), "{text}");
    if let Err(error) = parsed {
        assert!(
            error.to_string().lines().count() >= errors.len(),
            "{error} in:\n{text}"
        );
    }
    for program in ["plant/motor.clad", "plant/lines/a b.clad", "elsewhere.clad"] {
        let program = Path::new(program);
        let interval = settings.rules_for(program).scan_interval;
        assert!(interval.is_none_or(|interval| interval > 0), "{text}");
        settings.files.contain(program);
    }
}
