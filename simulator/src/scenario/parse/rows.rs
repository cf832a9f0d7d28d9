//! The rows of a scenario: how long its steps are, and what tags hold in them.

use super::{Reader, TIME};
use crate::scenario::suite::{Cell, Direction, Row, TimeRow};
use crate::scenario::words::{Word, range};
use crate::value_text;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_syntax::TextRange;
use ladder_syntax::numeral::counted;

impl Reader {
    /// How long the steps are whose rows follow. After other rows the steps go on.
    pub(super) fn time(&mut self, first: Word, rest: &[Word]) {
        const EXAMPLE: &str =
            "write a duration for each step, and a dot for one as long as `step` says, as in: time . 3s .";
        self.check_last_time();
        let mut cells: Vec<(Option<i64>, TextRange)> = Vec::new();
        for word in rest {
            if word.text.bytes().all(|letter| letter == b'.') {
                let dots = word.start..word.end();
                cells.extend(dots.map(|at| (None, range(at, at + 1))));
                continue;
            }
            match value_text::parse(word.text, Scalar::Time) {
                Ok(Value::Int(nanoseconds)) if nanoseconds > 0 => {
                    cells.push((Some(nanoseconds), word.range()));
                }
                _ => {
                    let problem = format!("`{}` is not a duration longer than 0", word.text);
                    self.error(word.range(), problem, EXAMPLE);
                    cells.push((Some(0), word.range()));
                }
            }
        }
        if cells.is_empty() {
            return self.error(first.range(), "`time` has no durations", EXAMPLE);
        }
        if let Some(scenario) = self.suite.scenarios.last_mut() {
            self.first = scenario.steps;
            scenario.steps += cells.len();
            scenario.times.push(TimeRow {
                range: first.range(),
                first: self.first,
                cells,
            });
        }
    }

    /// A row of durations is above the rows that it is about.
    pub(super) fn check_last_time(&mut self) {
        let Some(scenario) = self.suite.scenarios.last() else {
            return;
        };
        let Some(time) = scenario.times.last() else { return };
        // An error below it, and errors come in the order of the text, may be of a row that is missing for that.
        let last_error = self.suite.errors.last().map(|error| error.range.start());
        if scenario.rows.last().is_none_or(|row| row.first < time.first)
            && last_error.is_none_or(|at| at <= time.range.start())
        {
            self.error(
                time.range,
                "no row is below `time`",
                "the rows that have these steps are below it; a second `time` goes on with more steps",
            );
        }
    }

    pub(super) fn row(&mut self, first: Word, rest: &[Word]) {
        if first.text == "=>" || first.text.starts_with(['\'', '"']) || is_levels(first.text) {
            return self.error(
                first.range(),
                "the row begins with no tag",
                "a row is a tag and a value for each step, as in: start _-__",
            );
        }
        let (direction, cells) = match rest {
            [arrow, cells @ ..] if arrow.text == "=>" => (Direction::Expected, cells),
            cells => (Direction::Given, cells),
        };
        let (cells, tolerance) = self.split_tolerance(cells);
        let mut row = Row {
            name: first.text.to_owned(),
            range: first.range(),
            direction,
            first: self.first,
            cells: Vec::new(),
            tolerance,
        };
        for word in cells {
            if word.text == "=>" {
                return self.error(
                    word.range(),
                    "the arrow is directly after the tag",
                    "write it as in: run => _--_",
                );
            }
            if word.unclosed {
                return self.error(
                    word.range(),
                    "the quote after the text is missing",
                    "a text is written as in: 'it works'; a quote in it as $'",
                );
            }
            push_cells(&mut row.cells, *word);
        }
        if row.cells.is_empty() {
            return self.error(
                first.range(),
                format!("`{}` has no values", first.text),
                "give it one for each step: _ low, - high, . as before, or numbers between blanks",
            );
        }
        self.check_length(&row);
        if let Some(scenario) = self.suite.scenarios.last_mut() {
            scenario.steps = scenario.steps.max(row.first + row.cells.len());
            scenario.rows.push(row);
        }
    }

    /// What is before `±` or `+-`, and after it.
    fn split_tolerance<'w, 't>(
        &mut self,
        words: &'w [Word<'t>],
    ) -> (&'w [Word<'t>], Option<(String, TextRange)>) {
        let sign = |word: &Word<'t>| {
            word.text
                .strip_prefix('±')
                .or_else(|| word.text.strip_prefix("+-"))
        };
        let Some(at) = words.iter().position(|word| sign(word).is_some()) else {
            return (words, None);
        };
        let after = &words[at + 1..];
        let touching = sign(&words[at]).unwrap_or_default();
        let place = range(words[at].start, words.last().map_or(0, Word::end));
        let text = match (touching, after) {
            (text, []) if !text.is_empty() => text,
            ("", [one]) => one.text,
            _ => {
                self.error(
                    place,
                    "one number after ± says how far the values may be away",
                    "write it last in the row, as in: level => 1.0 2.0 ± 0.01",
                );
                return (&words[..at], None);
            }
        };
        (&words[..at], Some((text.to_owned(), place)))
    }

    /// Rows below each other have one length: that of the row `time` above them, or of the first.
    fn check_length(&mut self, row: &Row) {
        let Some(scenario) = self.suite.scenarios.last() else {
            return;
        };
        let time = scenario.times.last().map(|time| (TIME, time.cells.len()));
        let first = || {
            let first = scenario.rows.first()?;
            Some((first.name.as_str(), first.cells.len()))
        };
        let Some((above, wanted)) = time.or_else(first) else {
            return;
        };
        let there = row.cells.len();
        if there == wanted {
            return;
        }
        let end = row.cells[there - 1].1.end();
        let place = match row.cells.get(wanted) {
            Some((_, surplus)) => TextRange::new(surplus.start(), end),
            None => TextRange::new(row.cells[0].1.start(), end),
        };
        let message = format!(
            "`{}` has {}, but `{above}` has {wanted}",
            row.name,
            counted(there, "step"),
        );
        let help = if scenario.times.is_empty() {
            "all rows of a scenario have one length: a value for each step"
        } else {
            "all rows below a row `time` have its length: a value for each step"
        };
        self.error(place, message, help);
    }
}

pub(in crate::scenario) fn is_levels(text: &str) -> bool {
    text.chars().all(|c| matches!(c, '_' | '-' | '.' | '~'))
}

/// A word of levels is a step a letter, any other word is one value.
fn push_cells(cells: &mut Vec<(Cell, TextRange)>, word: Word) {
    if !is_levels(word.text) {
        cells.push((Cell::Value(word.text.to_owned()), word.range()));
        return;
    }
    for (at, letter) in word.text.char_indices() {
        let cell = match letter {
            '_' => Cell::Low,
            '-' => Cell::High,
            '~' => Cell::Plant,
            _ => Cell::Same,
        };
        cells.push((cell, range(word.start + at, word.start + at + 1)));
    }
}
