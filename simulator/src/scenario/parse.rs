//! What the lines of a scenario file say, before anything is known of the program.

use super::error::ScenarioError;
use super::property::{self, FORMS, PROPERTY, Property, Written, is_of_property};
use super::tolerance::Tolerance;
use super::words::{Word, lines, range};
use crate::value_text;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_syntax::numeral::counted;
use ladder_syntax::{TextRange, TextSize};
use std::collections::HashMap;

/// A scenario file.
#[derive(Debug, Clone, PartialEq)]
pub struct Suite {
    /// The program, as it is named, seen from the file's own folder.
    pub program: Option<(String, TextRange)>,
    /// How long a step is, in nanoseconds. Without it a step is one scan.
    pub step: Option<(i64, TextRange)>,
    /// The time from one scan to the next, in nanoseconds.
    pub interval: Option<(i64, TextRange)>,
    /// For all reals that are expected, where a row does not have its own.
    pub tolerance: Option<Tolerance>,
    /// In the order of the file.
    pub scenarios: Vec<Scenario>,
    /// What is assumed of everything that goes into the program.
    pub assumptions: Vec<Written>,
    /// What must hold in every run, in the order of the file.
    pub properties: Vec<Property>,
    /// What could not be read.
    pub errors: Vec<ScenarioError>,
}

/// One scenario.
#[derive(Debug, Clone, PartialEq)]
pub struct Scenario {
    /// What it is called.
    pub name: String,
    /// Its name, with the quotes.
    pub range: TextRange,
    /// How many steps it has.
    pub steps: usize,
    /// Its rows, in the order of the file.
    pub rows: Vec<Row>,
    /// Its rows `time`, in the order of the file. With the second the steps go on below those of the rows above.
    pub times: Vec<TimeRow>,
}

impl Scenario {
    /// How long a step is, in nanoseconds, where a row `time` says it.
    pub fn time_of(&self, step: usize) -> Option<i64> {
        let row = self.times.iter().rev().find(|row| row.first <= step)?;
        row.cells.get(step - row.first)?.0
    }
}

/// A row `time`: how long each of the steps below it is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TimeRow {
    /// The word `time`.
    pub range: TextRange,
    /// The step of its first cell.
    pub first: usize,
    /// In nanoseconds, with its place; none for a dot, which is a step as the file has them. 0 where no duration is written.
    pub cells: Vec<(Option<i64>, TextRange)>,
}

/// A row: a tag, and a cell for each step.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The tag as it is written.
    pub name: String,
    /// Where that is.
    pub range: TextRange,
    /// Whether it goes in or is expected to come out.
    pub direction: Direction,
    /// The step of its first cell.
    pub first: usize,
    /// One for each step, with its place.
    pub cells: Vec<(Cell, TextRange)>,
    /// What is after `±`.
    pub tolerance: Option<(String, TextRange)>,
}

/// Which way a row goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Direction {
    /// Into the program.
    Given,
    /// `=>`: out of it.
    Expected,
}

/// What a row has for a step.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Cell {
    /// `_`
    Low,
    /// `-`
    High,
    /// `.`: as before; not checked.
    Same,
    /// Anything else: a value as it is written.
    Value(String),
}

/// Reads a scenario file.
pub fn parse(text: &str) -> Suite {
    let mut reader = Reader {
        suite: Suite {
            program: None,
            step: None,
            interval: None,
            tolerance: None,
            scenarios: Vec::new(),
            assumptions: Vec::new(),
            properties: Vec::new(),
            errors: Vec::new(),
        },
        named: None,
        has_properties: false,
        names: HashMap::new(),
        tolerance_given: false,
        first: 0,
    };
    for line in lines(text) {
        if let [first, rest @ ..] = line.words.as_slice() {
            let has_rows = !reader.suite.scenarios.is_empty();
            if reader.named.is_some() || is_of_property(*first, rest, has_rows) {
                reader.property(*first, rest, line.before_comment());
            } else {
                reader.line(*first, rest);
            }
        }
    }
    reader.finish(text)
}

/// The words that begin a line before the first scenario.
pub const HEADINGS: [&str; 4] = ["program", "step", "interval", "tolerance"];

/// The word that begins a row of how long steps are.
pub const TIME: &str = "time";

struct Reader {
    suite: Suite,
    /// The scenarios' names, to find the second of a kind.
    names: HashMap<String, TextRange>,
    tolerance_given: bool,
    /// The name of the property whose form is next.
    named: Option<(String, TextRange)>,
    /// There are properties, with errors or without.
    has_properties: bool,
    /// The step of the cells that are first in their rows.
    first: usize,
}

impl Reader {
    fn error(&mut self, range: TextRange, message: impl Into<String>, help: impl Into<String>) {
        self.suite.errors.push(ScenarioError::new(range, message, help));
    }

    fn line(&mut self, first: Word, rest: &[Word]) {
        if first.text == "scenario" {
            return self.scenario(first, rest);
        }
        if !self.suite.scenarios.is_empty() {
            // What is expected of a tag of that name has an arrow.
            if first.text == TIME && rest.first().is_none_or(|word| word.text != "=>") {
                return self.time(first, rest);
            }
            return self.row(first, rest);
        }
        match first.text {
            "program" => self.program(first, rest),
            "step" | "interval" => self.duration(first, rest),
            "tolerance" => self.tolerance(first, rest),
            other => {
                let mut words = HEADINGS.iter().chain(&FORMS).chain([&PROPERTY]);
                let help = match words.find(|word| word.eq_ignore_ascii_case(other)) {
                    Some(word) if *word != other => format!("write it in small letters: {word}"),
                    Some(&"no") => "write it as: no faults".to_owned(),
                    Some(&PROPERTY) => "its name is in quotes, as in: property \"never both\"".to_owned(),
                    Some(word) => format!("say what is so, as in: {word} up and down"),
                    None if rest.is_empty() => "a comment begins with #".to_owned(),
                    None => "a property begins with always, never, when, after, within, possible or no faults; rows \
                             are after a line as in: scenario \"what is shown\""
                        .to_owned(),
                };
                self.error(
                    first.range(),
                    format!(
                        "`{other}` is before the first scenario, where only program, step, interval, \
                         tolerance and properties are"
                    ),
                    help,
                );
            }
        }
    }

    /// A line of a property or an assumption: its text is that of the line before the comment.
    fn property(&mut self, first: Word, rest: &[Word], (text, start): (&str, usize)) {
        self.has_properties = true;
        if first.text == PROPERTY && rest.first().is_some_and(|name| name.text.starts_with('"')) {
            self.check_named();
            let name = rest[0];
            if name.unclosed {
                let example = "write it as in: property \"the contactors exclude each other\"";
                return self.error(name.range(), "the quote after the name is missing", example);
            }
            self.named = Some((name.text.trim_matches('"').trim().to_owned(), name.range()));
            if let Some(form) = rest.get(1) {
                self.form(property::Reader::new(&text[form.start - start..], form.start));
            }
            return;
        }
        let form = property::Reader::new(&text[first.start - start..], first.start);
        if first.text == "assume" && self.named.is_none() {
            let after = first.end() - start;
            let mut rest = property::Reader::new(&text[after..], first.end());
            match rest.expression().and_then(|written| rest.end().map(|()| written)) {
                Ok(written) => self.suite.assumptions.push(written),
                Err(error) => self.suite.errors.push(error),
            }
            return;
        }
        self.form(form);
    }

    fn form(&mut self, reader: property::Reader<'_>) {
        let place = reader.whole();
        let named = self.named.take();
        match reader.form() {
            Ok(form) => {
                let (name, range) = named.unwrap_or_else(|| (reader.text().to_owned(), place));
                if self.suite.properties.iter().any(|other| other.name == name) {
                    let twice = format!("another property is called \"{name}\" too");
                    self.error(
                        range,
                        twice,
                        "give each its own name: reports tell them apart by it",
                    );
                }
                self.suite.properties.push(Property {
                    name,
                    range,
                    place,
                    form,
                });
            }
            Err(error) => self.suite.errors.push(error),
        }
    }

    /// A name of a property is followed by its form.
    fn check_named(&mut self) {
        if let Some((name, range)) = self.named.take() {
            let message = format!("the property \"{name}\" says nothing");
            self.error(
                range,
                message,
                "say below it what must hold, as in: never up and down",
            );
        }
    }

    fn program(&mut self, first: Word, rest: &[Word]) {
        let Some((from, to)) = rest.first().zip(rest.last()) else {
            return self.error(
                first.range(),
                "the program is missing",
                "name it, as in: program motor.clad",
            );
        };
        if self.suite.program.is_some() {
            return self.error(
                first.range(),
                "a second program: all scenarios of a file are about one",
                "put the scenarios of another program into a file of their own",
            );
        }
        // A name may hold blanks, in quotes or not.
        let mut name = String::new();
        let mut end = from.start;
        for word in rest {
            name.extend(std::iter::repeat_n(' ', word.start - end));
            name.push_str(word.text);
            end = word.end();
        }
        let unquoted = name.trim_matches('"').to_owned();
        self.suite.program = Some((unquoted, range(from.start, to.end())));
    }

    fn duration(&mut self, first: Word, rest: &[Word]) {
        let (what, example) = match first.text {
            "step" => ("how long a step is", "step 100ms"),
            _ => ("the time from one scan to the next", "interval 10ms"),
        };
        let [value] = rest else {
            let place = rest.last().map_or(first.range(), Word::range);
            return self.error(
                place,
                format!("one duration says {what}"),
                format!("write it as in: {example}"),
            );
        };
        match value_text::parse(value.text, Scalar::Time) {
            Ok(Value::Int(nanoseconds)) if nanoseconds > 0 => {
                let slot = match first.text {
                    "step" => &mut self.suite.step,
                    _ => &mut self.suite.interval,
                };
                if slot.is_some() {
                    let twice = format!("`{}` appears here a second time", first.text);
                    return self.error(first.range(), twice, "leave only one of them");
                }
                *slot = Some((nanoseconds, value.range()));
            }
            _ => self.error(
                value.range(),
                format!("`{}` is not a duration longer than 0", value.text),
                format!("write it as in: {example}"),
            ),
        }
    }

    fn tolerance(&mut self, first: Word, rest: &[Word]) {
        let parsed = match rest {
            [value] => Tolerance::parse(value.text, Scalar::Lreal),
            _ => Err("one number says how far reals may be from what is expected".to_owned()),
        };
        match parsed {
            Ok(_) if std::mem::replace(&mut self.tolerance_given, true) => self.error(
                first.range(),
                "`tolerance` appears here a second time",
                "leave only one of them; a row may have its own, as in: level => 1.0 2.0 ± 0.01",
            ),
            Ok(tolerance) => self.suite.tolerance = Some(tolerance),
            Err(problem) => {
                let place = rest.last().map_or(first.range(), Word::range);
                self.error(place, problem, "write it as in: tolerance 0.001");
            }
        }
    }

    fn scenario(&mut self, first: Word, rest: &[Word]) {
        const EXAMPLE: &str = "write it as in: scenario \"the pump starts\"";
        self.check_last_time();
        let whole = rest
            .last()
            .map_or(first.range(), |last| range(first.start, last.end()));
        let (name, place) = match rest {
            [name, ..] if name.text.starts_with('"') => {
                if name.unclosed {
                    self.error(name.range(), "the quote after the name is missing", EXAMPLE);
                } else if let Some(more) = rest.get(1) {
                    self.error(more.range(), "nothing is after the name of a scenario", EXAMPLE);
                }
                (name.text.trim_matches('"').trim(), name.range())
            }
            _ => {
                self.error(whole, "a scenario's name is in quotes", EXAMPLE);
                ("", whole)
            }
        };
        if name.is_empty() && rest.first().is_some_and(|word| word.text.starts_with('"')) {
            self.error(place, "the scenario has no name", EXAMPLE);
        }
        if let Some(other) = self
            .names
            .insert(name.to_owned(), place)
            .filter(|_| !name.is_empty())
        {
            self.names.insert(name.to_owned(), other);
            self.error(
                place,
                format!("another scenario is called \"{name}\" too"),
                "give each its own name: reports tell them apart by it",
            );
        }
        self.suite.scenarios.push(Scenario {
            name: name.to_owned(),
            range: place,
            steps: 0,
            rows: Vec::new(),
            times: Vec::new(),
        });
        self.first = 0;
    }

    /// How long the steps are whose rows follow. After other rows the steps go on.
    fn time(&mut self, first: Word, rest: &[Word]) {
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
    fn check_last_time(&mut self) {
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

    fn row(&mut self, first: Word, rest: &[Word]) {
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

    fn finish(mut self, text: &str) -> Suite {
        self.check_last_time();
        self.check_named();
        let end = TextSize::of(text);
        let start = TextSize::new(if text.starts_with('\u{feff}') { 3 } else { 0 });
        if self.suite.program.is_none() && !self.suite.errors.iter().any(|m| m.message.contains("program")) {
            self.error(
                TextRange::empty(start),
                "the program is missing",
                "name it in the first line, as in: program motor.clad",
            );
        }
        if self.suite.scenarios.is_empty() && !self.has_properties {
            self.error(
                TextRange::empty(end),
                "there is no scenario in this file",
                "begin one, as in: scenario \"the pump starts\"",
            );
        }
        for scenario in &self.suite.scenarios {
            let expects = scenario
                .rows
                .iter()
                .any(|row| row.direction == Direction::Expected);
            let is_in_scenario = |error: &ScenarioError| error.range.start() > scenario.range.start();
            if !expects && !self.suite.errors.iter().any(is_in_scenario) {
                self.suite.errors.push(ScenarioError::new(
                    scenario.range,
                    format!("the scenario \"{}\" expects nothing", scenario.name),
                    "say what must come out, in a row with an arrow, as in: run => _--_",
                ));
            }
        }
        self.suite.errors.sort_by_key(|error| error.range.start());
        self.suite
    }
}

pub(super) fn is_levels(text: &str) -> bool {
    text.chars().all(|c| matches!(c, '_' | '-' | '.'))
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
            _ => Cell::Same,
        };
        cells.push((cell, range(word.start + at, word.start + at + 1)));
    }
}
