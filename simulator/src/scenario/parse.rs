//! Reads scenario files.

mod plants;
mod rows;

use super::error::ScenarioError;
use super::property::{self, FORMS, PROPERTY, Property, is_of_property};
use super::suite::{Direction, Scenario, Suite};
use super::tolerance::Tolerance;
use super::words::{Word, lines, range};
use crate::value_text;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_syntax::{TextRange, TextSize, conflicts};
pub(super) use rows::is_levels;
use std::collections::HashMap;

/// Reads a scenario file.
pub fn parse(text: &str) -> Suite {
    let mut reader = Reader {
        suite: Suite {
            program: None,
            plants: Vec::new(),
            connects: Vec::new(),
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
    let conflicts = conflicts(text);
    for conflict in &conflicts {
        reader.conflict(text, conflict.signs[0].1);
    }
    if !conflicts.is_empty() {
        // What it says is known when it is decided.
        return reader.suite;
    }
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

/// The name of a file, which may hold blanks, in quotes or not.
fn file_of(words: &[Word]) -> Option<(String, TextRange)> {
    let (name, range) = as_written(words)?;
    Some((name.trim_matches('"').to_owned(), range))
}

/// Words with the blanks between them, and where they are.
fn as_written(words: &[Word]) -> Option<(String, TextRange)> {
    let (from, to) = words.first().zip(words.last())?;
    let mut text = String::new();
    let mut end = from.start;
    for word in words {
        text.extend(std::iter::repeat_n(' ', word.start - end));
        text.push_str(word.text);
        end = word.end();
    }
    Some((text, range(from.start, to.end())))
}

/// The words that begin a line before the first scenario.
pub const HEADINGS: [&str; 6] = ["program", "plant", "connect", "step", "interval", "tolerance"];

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

    fn conflict(&mut self, text: &str, line: TextRange) {
        let sign = text[std::ops::Range::<usize>::from(line)].trim_ascii_end();
        self.error(
            TextRange::at(line.start(), TextSize::of(sign)),
            "a merge left a conflict here: it is not decided which scenarios or rows hold",
            "keep one of the two forms, or make one of them, and remove the lines of signs around them",
        );
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
            "plant" => self.plant(first, rest),
            "connect" => self.connect(first, rest),
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
                        "`{other}` is before the first scenario, where only program, plant, connect, step, interval, \
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
        let Some(named) = file_of(rest) else {
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
        self.suite.program = Some(named);
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
