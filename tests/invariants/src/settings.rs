//! What is wrong with a settings file lies in the file, and the rest of it holds.
//!
//! The input is the text of a `ladder.toml`.

use crate::input;
use ladder_workspace::Settings;
use std::ops::Range;
use std::path::Path;

pub(crate) fn check(data: &[u8]) {
    let text = input::text(data);
    let (settings, mistakes) = Settings::examine(Path::new("plant/ladder.toml"), &text);
    for mistake in &mistakes {
        let lies = text.get(Range::<usize>::from(mistake.range)).is_some();
        assert!(lies, "{mistake:?} in:\n{text}");
        assert!(!mistake.message.is_empty(), "{mistake:?} in:\n{text}");
        assert!(
            mistake.place.line >= 1 && mistake.place.column >= 1,
            "{mistake:?} in:\n{text}"
        );
    }
    let parsed = Settings::parse(Path::new("plant/ladder.toml"), &text);
    assert_eq!(parsed.is_ok(), mistakes.is_empty(), "{text}");
    if let Err(error) = parsed {
        assert!(
            error.to_string().lines().count() >= mistakes.len(),
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
