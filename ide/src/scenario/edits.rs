//! The layout of a scenario file as small edits: cursors and marks stay where they are.

use super::place::line;
use ladder_format::Edit;
use ladder_simulator::scenario;
use ladder_syntax::{TextRange, TextSize};

/// The characters after which columns are aligned.
const TRIGGERS: [char; 1] = ['\n'];

/// The edits that align a text. Sorted, none touching another.
pub fn layout(text: &str) -> Vec<Edit> {
    differences(text, &scenario::layout(text))
}

/// The edits after a character was typed; `offset` is right after it. Enter after a row aligns the rows of its scenario.
/// What is about to be written stays as it is.
pub fn on_type(text: &str, offset: TextSize, typed: char) -> Vec<Edit> {
    if !TRIGGERS.contains(&typed) {
        return Vec::new();
    }
    let (here, _) = line(text, offset);
    let above = text[..usize::from(here)].trim_end();
    let suite = scenario::parse(text);
    let begun = suite.scenarios.iter().rev().find(|it| it.range.start() < here);
    let Some(begun) = begun.filter(|it| it.range.end() < TextSize::of(above)) else {
        return Vec::new();
    };
    let first = begun.range.end();
    let mut edits = layout(text);
    edits.retain(|edit| edit.range.start() >= first && edit.range.end() <= TextSize::of(above));
    edits
}

/// What differs between two texts that differ only in their white space.
fn differences(old: &str, new: &str) -> Vec<Edit> {
    let mut edits = Vec::new();
    let (mut at, mut rest) = (0, new);
    loop {
        let blanks = |text: &str| text.len() - text.trim_start().len();
        let (there, wanted) = (blanks(&old[at..]), blanks(rest));
        if old[at..at + there] != rest[..wanted] {
            edits.push(Edit {
                range: TextRange::at(TextSize::new(at as u32), TextSize::new(there as u32)),
                text: rest[..wanted].to_owned(),
            });
        }
        at += there;
        rest = &rest[wanted..];
        let words = |text: &str| text.find(char::is_whitespace).unwrap_or(text.len());
        // A blank between two levels may come or go.
        let both = words(&old[at..]).min(words(rest));
        if both == 0 {
            return edits;
        }
        at += both;
        rest = &rest[both..];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ladder_format::apply;

    #[test]
    fn edits_are_small_and_complete() {
        let text = "program a.clad\nscenario \"n\"\nstart _ -_\nlong_name => _--\nlast 1 22\n";
        let edits = layout(text);
        assert_eq!(apply(text, &edits), scenario::layout(text));
        assert!(edits.iter().all(|edit| edit.text.trim().is_empty()), "{edits:?}");
        let levels = "program a.clad\n\nscenario \"n\"\na => _ - _\nb    _-_\nc    _-_\n";
        assert_eq!(apply(levels, &layout(levels)), scenario::layout(levels));
    }

    #[test]
    fn enter_aligns_the_scenario_above() {
        let before = "program a.clad\nscenario \"m\"\na =>   _\nscenario \"n\"\nstart _-\nlong_name => _-\n";
        let text = format!("{before}\nb  =>   _\n");
        let edits = on_type(&text, TextSize::of(before), '\n');
        assert_eq!(
            apply(&text, &edits),
            "program a.clad\nscenario \"m\"\na =>   _\nscenario \"n\"\nstart        _-\nlong_name => _-\n\nb  =>   _\n"
        );
        assert_eq!(on_type(&text, TextSize::of(before), 'x'), []);
        assert_eq!(on_type(&text, TextSize::new(15), '\n'), []);
    }
}
