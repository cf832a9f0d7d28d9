//! Blocks of SIMATIC controllers, read and written.

mod back;
mod broken;
mod corpus;
mod project;
mod reading;
mod source;
mod structured;
mod unread;
mod writing;

use ladder_format::Options;
use ladder_notation::{Companion, Converted, Notation, Source, Writing, convert};
use ladder_notation_simatic::{Simatic, SimaticMl};

/// What a document becomes.
fn read(text: &str, companions: Vec<Companion>) -> Converted {
    read_as("block", text, companions)
}

/// The same of a file with this name.
fn read_as(name: &str, text: &str, companions: Vec<Companion>) -> Converted {
    read_with(&Simatic, name, text, companions)
}

/// The same of a file in this notation.
fn read_with(notation: &dyn Notation, name: &str, text: &str, companions: Vec<Companion>) -> Converted {
    let source = Source {
        name: name.into(),
        bytes: text.as_bytes(),
        companions,
    };
    convert(notation, &source, &Options::default()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// What a file of SimaticML becomes.
fn read_xml(text: &str) -> Converted {
    read_with(&SimaticMl, "block", text, Vec::new())
}

/// The report in lines.
fn remarks(converted: &Converted) -> String {
    let remarks = ladder_notation::remarks(&converted.report, &converted.findings);
    let lines = remarks.iter().map(|remark| {
        format!(
            "{}: {}: {}: {}\n",
            remark.place, remark.outcome, remark.element, remark.reason
        )
    });
    lines.collect()
}

/// The errors of a ladder text.
fn errors(text: &str) -> Vec<String> {
    let analysis = analysis(text);
    let errors = analysis.errors().map(|error| error.message.clone());
    errors.collect()
}

fn analysis(text: &str) -> ladder_analysis::Analysis {
    ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "test.clad")
}

/// What a program becomes.
fn write(text: &str) -> Result<Writing, String> {
    Simatic.write(&analysis(text)).map_err(|error| error.to_string())
}

/// The networks of a text, each with its drawing alone.
fn networks(text: &str) -> Vec<String> {
    let parse = ladder_syntax::parse(text);
    let structure = parse.structure();
    let all = structure.networks.iter().map(|network| {
        let rungs = network.rungs(parse.lines());
        let words = rungs.map(|line| {
            let text = parse.text_in(parse.line_range(line));
            let words: Vec<&str> = text.split('-').filter(|word| !word.is_empty()).collect();
            words
                .join("-")
                .trim_end_matches([' ', '|', '+', '\n', '\r', '-'])
                .to_owned()
        });
        words.collect::<Vec<_>>().join("\n")
    });
    all.collect()
}
