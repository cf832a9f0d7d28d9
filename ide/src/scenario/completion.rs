//! Completion in a scenario file: headings, tags, values by their types, and properties.

use super::connection_completion::in_connection;
use super::file::Scenarios;
use super::forms::is_of_property;
use super::hover::keyword;
use super::members::after_point;
use super::named_by_rows::{Owner, Proposed, tags_of};
use super::place::line;
use super::property_completion as property;
use super::row::{Files, stem_of, value_type};
use super::used::used_files;
use crate::completion::{Completion, CompletionKind, Completions, Snippet, Topic};
use ladder_analysis::program::SystemTag;
use ladder_analysis::values::types::Scalar;
use ladder_simulator::scenario::{Direction, HEADINGS, Scenario, TIME, TextLine, TimeRow, Word};
use ladder_syntax::{Name, TextRange, TextSize};

/// This many are proposed at once.
const MOST: usize = 128;

/// Tags of other files come after those of the program.
const AFTER_ALL_OWN: u8 = 8;

/// What can be written at an offset. `programs` are those next to the file, as it would name them; `trigger` is the character
/// that was just typed, if that is why it is asked.
pub fn completions(
    scenarios: &Scenarios<'_>,
    offset: TextSize,
    programs: &[String],
    trigger: Option<char>,
) -> Completions {
    let (start, text) = line(scenarios.text, offset);
    let within = usize::from(offset - start);
    let before = TextLine::read(&text[..within], "", start.into());
    if before.comment.is_some() {
        return Completions::default();
    }
    // The word that is being written is the one that touches the cursor.
    let mut words = before.words.as_slice();
    let mut from = offset;
    if let [rest @ .., last] = words
        && last.range().end() == offset
        && last.text != "=>"
    {
        words = rest;
        from = last.range().start();
    }
    let mut out = Proposals::new(TextRange::new(from, offset));
    out.ends_line = text[within..].trim().is_empty() || text[within..].trim_start().starts_with('#');
    let scenario = scenarios
        .suite
        .scenarios
        .iter()
        .rev()
        .find(|it| it.range.start() <= start);
    if !words.is_empty() && is_of_property(scenarios, start, &text[..within]) {
        property::in_line(scenarios, (start, &text[..within]), trigger, &mut out);
    } else if words.is_empty() && trigger.is_none() && property::is_named_above(scenarios.text, start) {
        property::forms(&mut out);
    } else {
        in_scenario(
            scenarios,
            (offset, start),
            words,
            scenario,
            programs,
            trigger,
            &mut out,
        );
    }
    out.finish()
}

/// Everything but properties.
fn in_scenario(
    scenarios: &Scenarios<'_>,
    (offset, start): (TextSize, TextSize),
    words: &[Word<'_>],
    scenario: Option<&Scenario>,
    programs: &[String],
    trigger: Option<char>,
    out: &mut Proposals,
) {
    match words {
        // A dot among values is one: as before.
        [] if trigger.is_none_or(|trigger| matches!(trigger, '.' | '[')) => {
            at_line_start(scenarios, scenario, offset, trigger, out);
        }
        _ if trigger.is_some() => {}
        [first, rest @ ..] if scenario.is_none() && first.text == "connect" => {
            in_connection(scenarios, rest, out);
        }
        [first, rest @ ..] if scenario.is_none() => heading(first.text, rest.is_empty(), programs, out),
        [first, rest @ ..] => {
            if let Some(scenario) = scenario.filter(|_| first.text != "scenario") {
                in_row(
                    scenarios,
                    scenario,
                    first.text,
                    rest.first().map(|word| word.text),
                    start,
                    out,
                );
            }
        }
        [] => {}
    }
}

pub(super) struct Proposals {
    /// What is replaced.
    pub(super) word: TextRange,
    /// Nothing is after the cursor on its line.
    ends_line: bool,
    items: Vec<Completion>,
}

impl Proposals {
    /// None yet, for what is in the place of this word.
    pub(super) fn new(word: TextRange) -> Proposals {
        Proposals {
            word,
            ends_line: false,
            items: Vec::new(),
        }
    }

    /// As many of them as are proposed at once.
    pub(super) fn finish(mut self) -> Completions {
        let cut = self.items.len() > MOST;
        self.items.truncate(MOST);
        Completions {
            items: self.items,
            cut,
        }
    }

    pub(super) fn add(
        &mut self,
        kind: CompletionKind,
        label: &str,
        detail: &str,
        text: Snippet,
        topic: Topic,
    ) {
        self.items.push(Completion {
            label: label.to_owned(),
            detail: detail.to_owned(),
            kind,
            range: self.word,
            filter: label.to_owned(),
            text,
            topic,
        });
    }

    pub(super) fn value(&mut self, label: &str, words: &'static str) {
        self.add(
            CompletionKind::Value,
            label,
            words,
            Snippet::plain_text(label),
            Topic::Nothing,
        );
    }
}

fn at_line_start(
    scenarios: &Scenarios<'_>,
    scenario: Option<&Scenario>,
    offset: TextSize,
    trigger: Option<char>,
    out: &mut Proposals,
) {
    let written = &scenarios.text[out.word];
    if let Some(scenario) = scenario {
        tags(scenarios, scenario, offset, written, out);
        if trigger.is_none() {
            word(TIME, Snippet::plain_text(format!("{TIME} ")), out);
        }
    } else {
        let suite = &scenarios.suite;
        let given = |heading: &str| match heading {
            "program" => suite.program.is_some(),
            "step" => suite.step.is_some(),
            "interval" => suite.interval.is_some(),
            "tolerance" => suite.tolerance.is_some(),
            // There can be several.
            _ => false,
        };
        for heading in HEADINGS.into_iter().filter(|heading| !given(heading)) {
            word(heading, Snippet::plain_text(format!("{heading} ")), out);
        }
    }
    if trigger.is_none() {
        let text = Snippet::default()
            .text("scenario \"")
            .stop("what is shown")
            .text("\"\n")
            .end();
        word("scenario", text, out);
        property::begun(out);
    }
}

pub(super) fn word(label: &'static str, text: Snippet, out: &mut Proposals) {
    let topic = keyword(label).map_or(Topic::Nothing, Topic::Words);
    out.add(CompletionKind::Keyword, label, "", text, topic);
}

/// The tags that have no row yet: inputs to be given, then what is expected.
fn tags(
    scenarios: &Scenarios<'_>,
    scenario: &Scenario,
    offset: TextSize,
    written: &str,
    out: &mut Proposals,
) {
    let first = time_above(scenario, offset).map_or(0, |time| time.first);
    let has_row = |name: &str, direction: Option<Direction>| {
        let mut rows = scenario.rows.iter();
        rows.any(|row| {
            Some(row.direction) == direction
                && row.first == first
                && Name::new(&row.name) == Name::new(name)
                && !row.range.contains_inclusive(offset)
        })
    };
    if let Some(members) = Files::of(scenarios).and_then(|files| after_point(files, written)) {
        for it in members {
            let text = row_text(&it.name, it.direction, out);
            out.add(it.kind, &it.name, &it.detail, text, it.topic);
        }
        return;
    }
    let mut found = nameable(scenarios);
    found.retain(|it| !has_row(&it.name, it.direction));
    if Name::new(written).as_str().starts_with("sys") {
        for tag in SystemTag::ALL {
            let name = format!("SYS.{}", tag.name());
            let text = row_text(&name, Some(Direction::Expected), out);
            out.add(
                CompletionKind::Constant,
                &name,
                tag.ty().name(),
                text,
                Topic::Words(tag.about()),
            );
        }
    }
    best_first(&mut found, written);
    for it in found {
        let text = row_text(&it.name, it.direction, out);
        out.add(it.kind, &it.name, &it.detail, text, it.topic);
    }
}

/// What the program has, the files that it uses, and the plants beside it.
pub(super) fn nameable(scenarios: &Scenarios<'_>) -> Vec<Proposed> {
    let Some(files) = Files::of(scenarios) else {
        return Vec::new();
    };
    let program = files.program();
    let mut found = tags_of(program, Owner::Program);
    let plants = files
        .plants()
        .map(|(plant, file)| tags_of(&file, Owner::Plant(&plant.name)));
    let others = used_files(program, scenarios.workspace).into_iter();
    let others = others.map(|file| tags_of(&file, Owner::Used(stem_of(&file.name))));
    found.extend(plants.chain(others).flatten().map(|other| Proposed {
        order: other.order + AFTER_ALL_OWN,
        ..other
    }));
    found
}

/// What begins like the word that is written comes first.
pub(super) fn best_first(found: &mut [Proposed], written: &str) {
    let begins = |name: &str| Name::new(name).as_str().starts_with(Name::new(written).as_str());
    found.sort_by_key(|it| (!begins(&it.name), it.order));
}

/// A tag and what is between it and its values, where nothing follows yet.
fn row_text(name: &str, direction: Option<Direction>, out: &Proposals) -> Snippet {
    let after = match direction {
        Some(Direction::Given) if out.ends_line => " ",
        Some(Direction::Expected) if out.ends_line => " => ",
        _ => "",
    };
    Snippet::plain_text(format!("{name}{after}"))
}

fn heading(word: &str, first: bool, programs: &[String], out: &mut Proposals) {
    if !first {
        if word == "plant" {
            out.value("as", "another name before its tags");
        }
        return;
    }
    match word {
        "program" | "plant" => {
            for program in programs {
                out.add(
                    CompletionKind::Value,
                    program,
                    if word == "plant" {
                        "a model of the machine"
                    } else {
                        "program"
                    },
                    Snippet::plain_text(program),
                    Topic::Nothing,
                );
            }
        }
        "step" => ["10ms", "100ms", "1s"]
            .iter()
            .for_each(|it| out.value(it, "a whole number of scans")),
        "interval" => ["1ms", "10ms", "100ms"]
            .iter()
            .for_each(|it| out.value(it, "from one scan to the next")),
        "tolerance" => {
            out.value("0.001", "so much");
            out.value("1%", "such a part of what is expected");
        }
        _ => {}
    }
}

/// The values of a row, or its arrow.
fn in_row(
    scenarios: &Scenarios<'_>,
    scenario: &Scenario,
    tag: &str,
    after: Option<&str>,
    start: TextSize,
    out: &mut Proposals,
) {
    if tag == TIME && after != Some("=>") {
        out.value(".", "as long as `step` says");
        for duration in ["100ms", "1s", "3s", "1m"] {
            out.value(duration, "so long is the step");
        }
        return;
    }
    if after.is_none() {
        let words = "What follows is expected of the program after each step.";
        out.add(
            CompletionKind::Operator,
            "=>",
            "expected",
            Snippet::plain_text("=> "),
            Topic::Words(words),
        );
    }
    let Some(ty) = value_type(scenarios, tag) else {
        return;
    };
    let is_of_plant = !scenarios.suite.plants.is_empty() && after != Some("=>");
    if ty == Scalar::Bool {
        return levels(scenario, start, is_of_plant, out);
    }
    out.value(".", "as before; not checked");
    if is_of_plant {
        out.value("~", "as the plant has it");
    }
    if let Scalar::Enum(id) = ty {
        for (name, _) in &id.get().values {
            out.value(name, "a value");
        }
    }
    let values: &[(&str, &'static str)] = match ty {
        Scalar::Time => &[
            ("0ms", "a duration"),
            ("100ms", "a duration"),
            ("1s", "a duration"),
        ],
        Scalar::String(_) => &[("''", "a text")],
        ty if ty.is_real() => &[("0.0", "a number"), ("1.0", "a number")],
        ty if ty.is_number() => &[("0", "a number"), ("1", "a number")],
        _ => &[],
    };
    for (value, words) in values {
        out.value(value, words);
    }
}

/// The row `time` that an offset is below.
fn time_above(scenario: &Scenario, offset: TextSize) -> Option<&TimeRow> {
    scenario
        .times
        .iter()
        .rev()
        .find(|time| time.range.start() < offset)
}

/// Levels: one, or as many as the other rows have steps.
fn levels(scenario: &Scenario, start: TextSize, is_of_plant: bool, out: &mut Proposals) {
    let own = scenario.rows.iter().find(|row| row.range.start() >= start);
    let own = own.filter(|row| row.range.start() < out.word.end());
    let time = time_above(scenario, start);
    let first = time.map_or(0, |time| time.first);
    let others = scenario.rows.iter().filter(|row| {
        row.first == first && (row.range.start() < start || row.range.start() > out.word.end())
    });
    let longest = others.map(|row| row.cells.len()).max().unwrap_or(0);
    let steps = time.map_or(longest, |time| time.cells.len());
    let there = own.map_or(0, |row| {
        row.cells
            .iter()
            .filter(|(_, place)| place.start() < out.word.end())
            .count()
    });
    // Levels touch: what is accepted is after those that are written.
    out.word = TextRange::empty(out.word.end());
    let missing = steps.saturating_sub(there);
    for (letter, one, all) in [
        ('_', "low", "low to the end"),
        ('-', "high", "high to the end"),
        ('.', "as before; not checked", "as before to the end"),
        ('~', "as the plant has it", "as the plant has it to the end"),
    ] {
        if letter == '~' && !is_of_plant {
            continue;
        }
        if missing > 1 {
            out.value(&letter.to_string().repeat(missing), all);
        }
        out.value(&letter.to_string(), one);
    }
}
