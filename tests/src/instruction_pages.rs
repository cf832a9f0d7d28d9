//! The pages of the language reference that are made from the table of instructions: one for each group.

use crate::instruction_runs;
use ladder_instructions::{
    Accepts, Acts, Direction, Group, Instruction, Operand, Presence, TABLE, TypeClass, origin,
};
use ladder_simulator::Simulation;
use std::fmt::Write;
use std::sync::Arc;

/// A page.
#[derive(Debug)]
pub struct Page {
    /// The group that it shows.
    pub group: Group,
    /// The file, seen from the folder `docs/src/language/instructions/`.
    pub file: &'static str,
    introduction: &'static str,
}

/// All of them.
pub const PAGES: [Page; 6] = [
    Page {
        group: Group::Condition,
        file: "conditions.md",
        introduction: "Contacts, edges and comparisons decide whether power goes on.",
    },
    Page {
        group: Group::Data,
        file: "data.md",
        introduction: "These instructions compute a value and write it to their first operand. Which values go together, \
                       and what happens at a fault, is described in [Values and expressions](../expressions.md).",
    },
    Page {
        group: Group::State,
        file: "state.md",
        introduction: "Each of these keeps its state in a tag of its own type. Rules that all timers or all counters \
                       share are in [Instructions](../instructions.md#timers).",
    },
    Page {
        group: Group::Coil,
        file: "coils.md",
        introduction: "Coils write what the rung has found out. They work at every evaluation, with power or without.",
    },
    Page {
        group: Group::Flow,
        file: "flow.md",
        introduction: "These blocks change which network runs next. The main program and functions are described in \
                       [Instructions](../instructions.md#flow).",
    },
    Page {
        group: Group::Port,
        file: "ports.md",
        introduction: "A port connects the program to the world: analog values, pulses, serial text.",
    },
];

/// The text of a page.
pub fn text(page: &Page) -> String {
    let rows = || TABLE.iter().filter(|row| row.group == page.group);
    let mut out = format!(
        "# {}\n\n{}\n\n| block | name | |\n| --- | --- | --- |\n",
        page.group.title(),
        page.introduction
    );
    for row in rows() {
        let (title, summary) = (row.title, cell(row.summary()));
        line(
            &mut out,
            &format!(
                "| {} | [{title}](#{}) | {summary} |",
                code_cell(&row.block()),
                anchor(title)
            ),
        );
    }
    for row in rows() {
        out.push('\n');
        section(&mut out, row);
    }
    out
}

fn section(out: &mut String, row: &Instruction) {
    line(
        out,
        &format!(
            "## {}\n\n```text\n{}\n```\n\n{}\n",
            row.title,
            row.signature(),
            row.doc.trim()
        ),
    );
    if !row.operands.is_empty() {
        line(out, "| operand | takes | meaning |\n| --- | --- | --- |");
        for operand in row.operands {
            line(
                out,
                &format!(
                    "| {} | {} | {} |",
                    name(operand),
                    takes(operand),
                    cell(operand.doc)
                ),
            );
        }
        out.push('\n');
    }
    let acts = match row.acts {
        Acts::Always => "Works at every evaluation, with power or without.",
        Acts::WhenPowered => "Works only while EN is high.",
    };
    line(out, &format!("**ENO:** {}. {acts}\n", row.eno));
    for (profile, text) in row.in_profiles() {
        line(
            out,
            &format!("**In [profile](../profiles.md) `{profile}`:** {text}\n"),
        );
    }
    if !runs(row.example) {
        line(out, &format!("**{NOT_RUN} it.**\n"));
    }
    names(out, "Synonym", row, row.synonyms);
    names(out, "Also accepted", row, row.aliases);
    line(out, &format!("```clad\n{}\n```\n", row.example.trim_end()));
    if !instruction_runs::has_diagram(row) {
        let table = instruction_runs::table(row);
        line(
            out,
            &format!("Run, a column for each scan:\n\n```text\n{table}```\n"),
        );
    }
    let sources: Vec<String> = origin(row.op).iter().map(ToString::to_string).collect();
    line(out, &format!("**From:** {}", sources.join("; ")));
}

fn names(out: &mut String, what: &str, row: &Instruction, names: &[&str]) {
    if names.is_empty() {
        return;
    }
    let (open, close) = row.shape.brackets();
    let blocks: Vec<String> = names
        .iter()
        .map(|name| format!("`{open}{name}{close}`"))
        .collect();
    line(out, &format!("**{what}:** {}\n", blocks.join(", ")));
}

/// How the book says that something is described and checked, but not run.
pub const NOT_RUN: &str = "This version does not run";

/// Whether the simulator takes a program.
pub fn runs(program: &str) -> bool {
    let parse = Arc::new(ladder_syntax::parse(program));
    let analysis = Arc::new(ladder_analysis::analyze(&parse, "program"));
    let program = ladder_analysis::link(&analysis, &|_| None);
    program.is_ok_and(|program| Simulation::new(program, ladder_simulator::Options::default()).is_ok())
}

/// The operand as it is written in its place.
fn name(operand: &Operand) -> String {
    let written = match (operand.presence, operand.direction) {
        (Presence::Named, Direction::Out) => format!("`{} =>`", operand.name),
        (Presence::Named, _) => format!("`{} :=`", operand.name),
        (Presence::Repeated { .. }, _) => format!("`{}`, ...", operand.name),
        (Presence::Required | Presence::Trailing, _) => format!("`{}`", operand.name),
    };
    match operand.presence {
        Presence::Named | Presence::Trailing => format!("{written} (optional)"),
        Presence::Required | Presence::Repeated { .. } => written,
    }
}

/// Which tags and literals may be there.
fn takes(operand: &Operand) -> String {
    let kind = match operand.accepts {
        Accepts::Bool => "BOOL",
        Accepts::BoolOrRange => "BOOL, or a range of BOOL",
        Accepts::BoolRangeOrState => "BOOL, a range of BOOL, a timer or a counter",
        Accepts::State(state) => state.name(),
        Accepts::TimerOrCounter => "a timer or a counter",
        Accepts::Result(class) => class_name(class),
        Accepts::Value => "what passes to the result's type",
        Accepts::Compared => "values that can be compared",
        Accepts::Convertible => "any elementary type",
        Accepts::Wrapped => "any integer or bit string",
        Accepts::Integer => "any integer",
        Accepts::String => "STRING",
        Accepts::Number => "any integer or real",
        Accepts::Duration => "TIME, or an integer in milliseconds",
        Accepts::Time => "TIME",
        Accepts::Count => "DINT",
        Accepts::Expression => "an [expression](../expressions.md#expressions)",
        Accepts::Range => "a range, or the element from which on",
        Accepts::RangeOrValue => "a range, or a STRING",
        Accepts::Label => "a label",
        Accepts::Function => "a function",
        Accepts::SearchOperator => "`EQ` `NE` `GT` `GE` `LT` `LE`",
        Accepts::Tag => "any tag",
    };
    match operand.direction {
        Direction::In => kind.to_owned(),
        Direction::Out => format!("{kind}; is written"),
        Direction::InOut => format!("{kind}; is read and written"),
    }
}

fn class_name(class: TypeClass) -> &'static str {
    match class {
        TypeClass::Number => "integer or real",
        TypeClass::NumberOrTime => "integer, real or TIME",
        TypeClass::Real => "REAL or LREAL",
        TypeClass::BitsOrInteger => "integer or bit string",
        TypeClass::BoolBitsOrInteger => "BOOL, integer or bit string",
        TypeClass::Integer => "integer",
        TypeClass::String => "STRING",
        TypeClass::Any => "any elementary type",
    }
}

/// A `|` would end the cell of a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ")
}

fn code_cell(code: &str) -> String {
    format!("`{}`", cell(code))
}

fn anchor(title: &str) -> String {
    title.to_lowercase().replace(' ', "-")
}

fn line(out: &mut String, text: &str) {
    // Writing to a String does not fail.
    let _ = writeln!(out, "{text}");
}
