//! The parts of a scenario file.

use super::file::Scenarios;
use super::place::line;
use ladder_simulator::scenario::Direction;
use ladder_syntax::TextRange;
use ladder_syntax::numeral::counted;

/// A scenario, or a row of one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ScenarioPart {
    /// What it is called.
    pub name: String,
    /// How many steps a scenario has; which way a row goes.
    pub detail: String,
    /// All of it.
    pub range: TextRange,
    /// Its name.
    pub focus: TextRange,
    /// Its rows; none for a row.
    pub children: Vec<ScenarioPart>,
}

/// The scenarios of a file, with their rows.
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
        }
    };
    scenarios.suite.scenarios.iter().map(part).collect()
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
    }
}
