//! The parts of a scenario file.

use super::file::Scenarios;
use super::place::line;
use ladder_simulator::scenario::{Direction, Property};
use ladder_syntax::TextRange;
use ladder_syntax::numeral::counted;

/// A scenario, a row of one, or a property.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ScenarioPart {
    /// What it is called.
    pub name: String,
    /// How many steps a scenario has; which way a row goes; what a property demands.
    pub detail: String,
    /// All of it.
    pub range: TextRange,
    /// Its name.
    pub focus: TextRange,
    /// Its rows; none for a row.
    pub children: Vec<ScenarioPart>,
    /// Whether it is a property.
    pub is_property: bool,
}

/// The scenarios of a file, with their rows, and its properties.
pub fn outline(scenarios: &Scenarios<'_>) -> Vec<ScenarioPart> {
    let part = |scenario: &ladder_simulator::scenario::Scenario| {
        let children: Vec<ScenarioPart> = scenario.rows.iter().map(of_row).collect();
        let start = scenario.range.start();
        // The word `scenario` and a blank are before the name.
        let (line, _) = line(scenarios.text, start);
        let end = children
            .last()
            .map_or(scenario.range.end(), |row| row.range.end());
        ScenarioPart {
            name: if scenario.name.is_empty() {
                "(no name)".to_owned()
            } else {
                scenario.name.clone()
            },
            detail: counted(scenario.steps, "step"),
            range: TextRange::new(line, end),
            focus: scenario.range,
            children,
            is_property: false,
        }
    };
    let parts = scenarios.suite.scenarios.iter().map(part);
    let properties = scenarios.suite.properties.iter();
    let properties = properties.map(|property| of_property(scenarios, property));
    let mut parts: Vec<ScenarioPart> = parts.chain(properties).collect();
    parts.sort_by_key(|part| part.range.start());
    parts
}

fn of_property(scenarios: &Scenarios<'_>, property: &Property) -> ScenarioPart {
    let form = &scenarios.text[property.place];
    let has_name = property.range != property.place;
    // The word `property` and a blank are before the name.
    let start = if has_name {
        line(scenarios.text, property.range.start()).0
    } else {
        property.place.start()
    };
    ScenarioPart {
        name: if property.name.is_empty() {
            "(no name)".to_owned()
        } else {
            property.name.clone()
        },
        detail: if has_name {
            form.to_owned()
        } else {
            "property".to_owned()
        },
        range: TextRange::new(start, property.place.end()),
        focus: property.range,
        children: Vec::new(),
        is_property: true,
    }
}

fn of_row(row: &ladder_simulator::scenario::Row) -> ScenarioPart {
    let last = row.cells.last().map_or(row.range.end(), |(_, place)| place.end());
    let end = row.tolerance.as_ref().map_or(last, |(_, place)| place.end());
    ScenarioPart {
        name: row.name.clone(),
        detail: match row.direction {
            Direction::Given => "given".to_owned(),
            Direction::Expected => "expected".to_owned(),
        },
        range: TextRange::new(row.range.start(), end),
        focus: row.range,
        children: Vec::new(),
        is_property: false,
    }
}
