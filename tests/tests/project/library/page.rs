//! The page of the book about the library, made from the sources of its blocks and their first scenarios.
//!
//! `UPDATE_EXPECT=1 cargo test -p ladder-tests` writes it again, with its pictures.

use crate::tested::Tested;
use expect_test::expect_file;
use ladder_analysis::analyze;
use ladder_analysis::library::{SOURCES, Source, Use};
use ladder_picture::{Options, Theme, picture, svg};
use ladder_simulator::scenario::{self, Scenario};
use ladder_simulator::trace::{Format, Trace};
use ladder_tests::{book, project};
use std::fmt::Write;
use std::path::PathBuf;
use std::sync::Arc;

const INTRODUCTION: &str = "\
These blocks are there in every program. They are written in the language itself, as [blocks of your own](blocks.md) are, and are read
only where they are used: a program without them pays nothing. A block of the same name in your workspace takes precedence. Blocks of your own for many programs are in [a folder that `ladder.toml` names](../guide/settings.md#a-library-of-your-own).

Analog values of the first ones are LREAL: an INT, a DINT or a REAL can be given, and `[TYP]` makes one of a result. Times of theirs are those from one run of the
block to the next, whatever the scan interval is, and in every [profile](profiles.md) of the program a block does the same. No wrong value is a fault: each block says what it does instead. Only a result that is too large for LREAL is one, as in
any instruction. State belongs to each place where the block is.
";

const OF_PLANTS: &str = "\
These are parts of machines, for [plants](../guide/plants.md) of a few lines. They count in whole numbers (millimetres, millilitres, thousandths of a degree), so that they can be
used [in proofs](../guide/proving-with-plants.md), and in whole milliseconds: a scan interval of less does not move them. Time passes for them in each scan, so they belong where every scan comes by.
";

#[test]
fn the_page_is_up_to_date() {
    let language = book::source().join("language");
    expect_file![language.join("library.md")].assert_eq(&text());
    for source in SOURCES {
        let place = |file: &str| {
            language
                .join("library")
                .join(format!("{}{file}.svg", anchor(source)))
        };
        expect_file![place("")].assert_eq(&drawing(source));
        expect_file![place("-timing")].assert_eq(&timing(source));
    }
}

fn text() -> String {
    let mut out = format!("# The library\n\n{INTRODUCTION}\n");
    list(&mut out, Use::Programs);
    let _ = writeln!(out, "\n{OF_PLANTS}");
    list(&mut out, Use::Plants);
    for source in SOURCES {
        out.push('\n');
        section(&mut out, source);
    }
    out
}

/// The blocks for one use as a table.
fn list(out: &mut String, wanted: Use) {
    out.push_str("| block | |\n| --- | --- |\n");
    for source in SOURCES.iter().filter(|source| source.is_for == wanted) {
        let _ = writeln!(
            out,
            "| [`{}`](#{}) | {} |",
            source.name,
            anchor(source),
            source.summary()
        );
    }
}

fn section(out: &mut String, source: &'static Source) {
    let name = source.name;
    let parameters = parameters(source);
    let names: Vec<&str> = parameters.iter().map(|parameter| parameter.name).collect();
    let _ = write!(
        out,
        "## {name}\n\n```text\n[{name}]( {} )\n```\n\n{}\n\n",
        names.join(", "),
        source.description()
    );
    out.push_str("| operand | type | default | meaning |\n| --- | --- | --- | --- |\n");
    for parameter in parameters {
        let default = parameter
            .default
            .map_or(String::new(), |default| format!("`{default}`"));
        let _ = writeln!(
            out,
            "| `{}` | {}{} | {default} | {} |",
            parameter.name, parameter.ty, parameter.way, parameter.meaning
        );
    }
    let id = anchor(source);
    let title = first(source).name;
    let _ = write!(
        out,
        "\n![A rung with {name}](library/{id}.svg)\n\n```clad\n{}\n```\n\n![Timing diagram: {title}](library/{id}-timing.svg)\n\n",
        source.example.trim_end()
    );
    let _ = write!(
        out,
        "<details><summary>The source of {name}</summary>\n\n```clad\n{}\n```\n\n</details>\n",
        source.text.trim_end()
    );
}

/// What a heading with the block's name is found by.
fn anchor(source: &Source) -> String {
    source.name[1..].to_lowercase()
}

/// A parameter, as its declaration says it.
pub(super) struct Parameter<'s> {
    pub(super) name: &'s str,
    ty: &'s str,
    /// Nothing for an input.
    way: &'static str,
    /// None where it must be given, or is an output.
    default: Option<&'s str>,
    pub(super) meaning: &'s str,
}

/// The parameters in the order of their declaration, of which each has a line.
pub(super) fn parameters(source: &'static Source) -> Vec<Parameter<'static>> {
    let mut way = None;
    let mut parameters = Vec::new();
    for line in source.text.lines() {
        match line.trim() {
            "VAR_INPUT" => way = Some(""),
            "VAR_OUTPUT" => way = Some("; is written"),
            "VAR_IN_OUT" => way = Some("; is read and written"),
            "END_VAR" => way = None,
            declaration => {
                let Some(way) = way else { continue };
                let (name, rest) = declaration.split_once(':').expect("a name and a type");
                let (rest, comment) = rest.split_once(';').expect("an end");
                let (ty, default) = match rest.split_once(":=") {
                    Some((ty, default)) => (ty, Some(default.trim())),
                    None => (rest, None),
                };
                parameters.push(Parameter {
                    name: name.trim(),
                    ty: ty.trim(),
                    way,
                    default: default.filter(|_| way.is_empty()),
                    meaning: comment.trim().trim_matches('#').trim(),
                });
            }
        }
    }
    parameters
}

/// The example as a picture.
fn drawing(source: &Source) -> String {
    let parse = Arc::new(ladder_syntax::parse(source.example));
    let analysis = analyze(&parse, source.name);
    svg(&picture(&analysis.context, &Options::default()), Theme::Auto)
}

fn first(source: &Source) -> Scenario {
    scenario::parse(source.scenarios).scenarios.swap_remove(0)
}

/// The first scenario as it runs, with the tags of its rows.
fn timing(source: &Source) -> String {
    let scenarios = project::root().join("library/scenarios");
    let file = scenarios.join(format!("{}.ladder-test", &source.name[1..]));
    let mut tested = Tested::read(file);
    tested.suite.scenarios.truncate(1);
    let rows = &tested.suite.scenarios[0].rows;
    let points: Vec<_> = rows
        .iter()
        .map(|row| {
            let point = tested
                .simulation
                .resolve(&row.name)
                .expect("a tag of the example");
            (row.name.clone(), point)
        })
        .collect();
    let mut out = String::new();
    let mut trace = Trace::begin(Format::Svg, source.name, &tested.simulation, &points, &mut out);
    let mut problems = Vec::new();
    tested.passed_by(&mut problems, |simulation| {
        let ran = simulation.scan();
        trace.row(simulation, &mut out);
        ran
    });
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    trace.end(&mut out);
    out
}

#[test]
fn the_pictures_are_those_of_the_blocks() {
    let folder = book::source().join("language/library");
    let mut wanted: Vec<PathBuf> = SOURCES
        .iter()
        .flat_map(|source| ["", "-timing"].map(|kind| folder.join(format!("{}{kind}.svg", anchor(source)))))
        .collect();
    wanted.sort();
    assert_eq!(project::files(&folder, "svg"), wanted);
}
