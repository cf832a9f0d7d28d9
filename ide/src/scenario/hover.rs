//! Hover in a scenario file: the tag of a row or of a property, what a value means, when a step is, what a form demands.

use super::file::Scenarios;
use super::forms::{IN_PROPERTY, form, in_property, is_of_property, of_form};
use super::place::{AtCursor, line, place};
use super::row::{Files, Named, named, value_type};
use crate::comments;
use crate::hover::{Hover, tag_card};
use crate::markdown::{code, escaped};
use ladder_analysis::context::Context;
use ladder_simulator::scenario::{Cell, Direction, Row, Scenario};
use ladder_simulator::value_text;
use ladder_syntax::numeral::counted;
use ladder_syntax::{TextRange, TextSize};
use std::sync::Arc;

/// What a name in a line `connect` is for.
const CONNECTED: &str = "Connected: the input takes the value of the output before each scan.";

/// What is at an offset, and the file whose lines its links are to.
pub fn hover(scenarios: &Scenarios<'_>, offset: TextSize) -> Option<(Hover, Option<Arc<str>>)> {
    let Some(found) = place(scenarios, offset) else {
        return Some((word(scenarios, offset)?, None));
    };
    let name = match found {
        AtCursor::Tag(row) => Some((&*row.name, row.range, does(row))),
        AtCursor::Operand(operand) => Some((operand.text, operand.range, IN_PROPERTY)),
        AtCursor::Side(side) => Some((side.text, side.range, CONNECTED)),
        _ => None,
    };
    if let Some((name, range, does)) = name
        && let Some(files) = Files::of(scenarios)
        && let Some(named) = named(files, name)
    {
        let hover = Hover {
            range,
            markdown: of_tag(scenarios, name, does, &named),
        };
        return Some((hover, Some(Arc::clone(&named.file.name))));
    }
    let (range, markdown) = match found {
        AtCursor::Program(range) => (range, size_of(scenarios.program?)),
        AtCursor::Plant(plant) => {
            let file = Files::of(scenarios)?.plant(plant)?;
            (
                plant.range,
                format!("{}\n\n{}", size_of(&file), keyword("plant")?),
            )
        }
        AtCursor::Side(side) => (side.range, of_value(scenarios, side.text, CONNECTED)?),
        AtCursor::Scenario(scenario) => (scenario.range, length(scenarios, scenario)),
        AtCursor::Tag(row) => (row.range, of_value(scenarios, &row.name, does(row))?),
        AtCursor::Operand(operand) => (operand.range, of_value(scenarios, operand.text, IN_PROPERTY)?),
        AtCursor::Property(property) => (property.range, of_form(&property.form).to_owned()),
        AtCursor::Step(scenario, row, cell) => (row.cells[cell].1, of_step(scenarios, scenario, row, cell)),
        AtCursor::Time(scenario, range, step) => (range, when(scenarios, scenario, step)),
        AtCursor::Tolerance(range) => (
            range,
            "How far a value may be from what is expected: `± 0.01`, or a part of it, `± 1%`.".to_owned(),
        ),
    };
    Some((Hover { range, markdown }, None))
}

/// A word that every file has.
fn word(scenarios: &Scenarios<'_>, offset: TextSize) -> Option<Hover> {
    let (start, text) = line(scenarios.text, offset);
    let within = usize::from(offset - start);
    let is_part = |c: char| c.is_alphanumeric() || matches!(c, '=' | '>');
    let from = text[..within]
        .rfind(|c| !is_part(c))
        .map_or(0, |at| at + text[at..].chars().next().map_or(1, char::len_utf8));
    let to = text[within..]
        .find(|c| !is_part(c))
        .map_or(text.len(), |at| within + at);
    let word = &text[from..to];
    let is_first = text[..from].trim().is_empty();
    let markdown = match word {
        "=>" => "What is after `=>` is expected of the program after each step.",
        word if is_first => keyword(word)?,
        word if is_of_property(scenarios, start, text) => in_property(word)?,
        _ => return None,
    };
    Some(Hover {
        range: TextRange::at(start + TextSize::new(from as u32), TextSize::of(word)),
        markdown: markdown.to_owned(),
    })
}

/// What a word at the beginning of a line is for.
pub(super) fn keyword(word: &str) -> Option<&'static str> {
    Some(match word {
        "program" => "The program that the scenarios are about, as it is seen from the folder of this file.",
        "plant" => {
            "A model of the machine, which runs beside the program: its outputs are inputs of the program and the reverse, where names and \
             types are the same. Its tags are `plant.level` in rows and properties; with `as tank` after the file, `tank.level`."
        }
        "connect" => {
            "Connects a tag of a plant with one of the program though their names differ: `connect plant.sensor_1 = near`."
        }
        "step" => "How long a step is: a whole number of scans. Without it a step is one scan.",
        "interval" => {
            "The time from one scan to the next. Without it what `ladder.toml` or the program says."
        }
        "tolerance" => "How far all reals may be from what is expected, such as `0.001` or `1%`.",
        "time" => {
            "How long each of the steps below it is, such as `3s`; `.` for one as long as `step` says. A second row `time` goes \
             on with more steps."
        }
        "scenario" => {
            "What is shown, in quotes. Its rows follow: a tag and a value for each step. Each scenario starts cold."
        }
        word => return form(word),
    })
}

fn size_of(program: &Context) -> String {
    let tags = program.scopes.first().map_or(0, |scope| scope.tags.len());
    format!(
        "{}: {}, {}",
        program.name,
        counted(program.networks.len(), "network"),
        counted(tags, "tag")
    )
}

fn length(scenarios: &Scenarios<'_>, scenario: &Scenario) -> String {
    let steps = counted(scenario.steps, "step");
    let alike = scenario.times.is_empty();
    match (scenarios.suite.step, begin(scenarios, scenario, scenario.steps)) {
        (Some((step, _)), Some(all)) if alike => {
            format!(
                "{steps} of {}, {} together. It starts cold.",
                value_text::duration(step),
                value_text::duration(all)
            )
        }
        (_, Some(all)) => format!("{steps}, {} together. It starts cold.", value_text::duration(all)),
        (_, None) if alike => format!("{steps} of one scan each. It starts cold."),
        (_, None) => format!("{steps}. It starts cold."),
    }
}

/// When a step begins, where that is known without the time of a scan.
fn begin(scenarios: &Scenarios<'_>, scenario: &Scenario, step: usize) -> Option<i64> {
    let usual = scenarios.suite.step.map(|(step, _)| step);
    let usual = usual.or(scenarios.suite.interval.map(|(interval, _)| interval));
    if scenario.times.is_empty() {
        return Some(scenarios.suite.step?.0.saturating_mul(i64::try_from(step).ok()?));
    }
    (0..step).try_fold(0i64, |sum, step| {
        Some(sum.saturating_add(scenario.time_of(step).or(usual)?))
    })
}

/// Which step it is, and from when to when it lasts.
fn when(scenarios: &Scenarios<'_>, scenario: &Scenario, step: usize) -> String {
    let number = format!("step {} of {}", step + 1, scenario.steps);
    let times = begin(scenarios, scenario, step).zip(begin(scenarios, scenario, step + 1));
    match times {
        Some((from, to)) => format!(
            "{number}: {} to {}",
            value_text::duration(from),
            value_text::duration(to)
        ),
        None if scenario.times.is_empty() => format!("{number}: scan {}", step + 1),
        None => number,
    }
}

/// What a row does with its tag.
const fn does(row: &Row) -> &'static str {
    match row.direction {
        Direction::Given => "Given before the first scan of each step.",
        Direction::Expected => "Expected after the last scan of each step.",
    }
}

/// A name of something that is not a tag.
fn of_value(scenarios: &Scenarios<'_>, name: &str, does: &str) -> Option<String> {
    let ty = value_type(scenarios, name)?;
    Some(format!("`{name}` : {}\n\n{does}", ty.name()))
}

fn of_tag(scenarios: &Scenarios<'_>, name: &str, does: &str, named: &Named<'_>) -> String {
    let mut card = tag_card(&named.file, named.tag(), None);
    if let Some(told) = comments::of_declaration(&named.file, named.file.shared(named.tag())) {
        // A comment is not Markdown.
        card = format!("{}\n\n{card}", escaped(&told));
    }
    if let Some(ty) = value_type(scenarios, name).filter(|_| named.name.len() < name.len()) {
        card = format!("`{name}` : {}, of\n\n{card}", ty.name());
    }
    format!("{card}\n\n---\n\n{does}")
}

fn of_step(scenarios: &Scenarios<'_>, scenario: &Scenario, row: &Row, number: usize) -> String {
    let ty = value_type(scenarios, &row.name);
    let shown = |cell: &Cell| match cell {
        Cell::Low => "low (`FALSE`)".to_owned(),
        Cell::High => "high (`TRUE`)".to_owned(),
        Cell::Same => "as before".to_owned(),
        Cell::Plant => "as the plant has it".to_owned(),
        Cell::Value(text) => {
            let value = ty.and_then(|ty| Some((value_text::parse(text, ty).ok()?, ty)));
            let value = value.map_or_else(|| text.clone(), |(value, ty)| value_text::display(&value, ty));
            code(&value)
        }
    };
    let before = row.cells[..number]
        .iter()
        .rev()
        .find(|(cell, _)| *cell != Cell::Same);
    let name = format!("`{}`", row.name);
    let told = match (&row.cells[number].0, row.direction) {
        (Cell::Same, Direction::Expected) => format!("{name} is not checked"),
        (Cell::Same, Direction::Given) => match before {
            Some((cell, _)) => format!("{name} is not given again; last it was {}", shown(cell)),
            None => format!("{name} is not given yet"),
        },
        (cell, Direction::Given) => format!("{name} is given: {}", shown(cell)),
        (cell, Direction::Expected) => format!("{name} is expected to be {}", shown(cell)),
    };
    format!("{told}  \n{}", when(scenarios, scenario, row.first + number))
}
