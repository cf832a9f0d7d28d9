//! Projects that tests write, and what becomes of them.

use expect_test::Expect;
use ladder_format::Options;
use ladder_notation::{Outcome, Source, convert};
use ladder_notation_plcopen::Plcopen;

/// A project with these types, units and instances.
pub(crate) fn project(types: &str, units: &str, instances: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\" xmlns:xhtml=\"http://www.w3.org/1999/xhtml\">\n\
         <types><dataTypes>{types}</dataTypes><pous>{units}</pous></types>\n<instances><configurations>{instances}</configurations></instances>\n</project>\n"
    )
}

/// A program with variables (`a : BOOL`, one a line) and a body in LD.
pub(crate) fn program(variables: &str, body: &str) -> String {
    unit("program", "Main", variables, &format!("<LD>{}</LD>", short(body)))
}

/// A unit with local variables.
pub(crate) fn unit(kind: &str, name: &str, variables: &str, body: &str) -> String {
    let mut lists = String::new();
    for line in variables.lines().map(str::trim).filter(|line| !line.is_empty()) {
        let (head, ty) = line.split_once(" : ").expect("a variable has a type");
        let (list, name) = head.split_once(' ').unwrap_or(("localVars", head));
        let ty = match ty {
            "BOOL" | "INT" | "DINT" | "REAL" | "TIME" | "WORD" => format!("<{ty}/>"),
            ty if ty.starts_with('<') => ty.to_owned(),
            ty => format!("<derived name=\"{ty}\"/>"),
        };
        lists.push_str(&format!(
            "<{list}><variable name=\"{name}\"><type>{ty}</type></variable></{list}>"
        ));
    }
    format!("<pou name=\"{name}\" pouType=\"{kind}\"><interface>{lists}</interface><body>{body}</body></pou>")
}

/// The elements of a body, one a line: `contact 2 from=1 a`, `coil 3 from=2,4 storage=set q`, `block 4 TON T1 IN=2 PT=5 / Q ET`.
pub(crate) fn short(body: &str) -> String {
    let mut out = String::new();
    for line in body.lines().map(str::trim).filter(|line| !line.is_empty()) {
        let mut words = line.split(' ');
        let kind = words.next().expect("a line has words");
        let id = words.next().expect("an element has a number");
        let rest: Vec<&str> = words.collect();
        let point = |from: &str| {
            let wires = from.split(',').filter(|wire| !wire.is_empty());
            let connections: String = wires.map(connection).collect();
            format!("<connectionPointIn>{connections}</connectionPointIn>")
        };
        if kind == "block" {
            let (before, outputs) = match rest.iter().position(|word| *word == "/") {
                Some(at) => (&rest[..at], &rest[at + 1..]),
                None => (&rest[..], &[][..]),
            };
            let instance = before.get(1).filter(|word| !word.contains('='));
            let instance = instance
                .map(|name| format!(" instanceName=\"{name}\""))
                .unwrap_or_default();
            let mut pins = String::new();
            for word in before.iter().filter(|word| word.contains('=')) {
                let (name, from) = word.split_once('=').expect("a pin has a source");
                let (name, modifier) = match name.split_once('!') {
                    Some((name, modifier)) => (name, modifier_of(modifier)),
                    None => (name, String::new()),
                };
                let point = point(from);
                pins.push_str(&format!(
                    "<variable formalParameter=\"{name}\"{modifier}>{point}</variable>"
                ));
            }
            let outputs: Vec<String> = outputs
                .iter()
                .map(|name| {
                    let (name, modifier) = match name.split_once('!') {
                        Some((name, modifier)) => (name, modifier_of(modifier)),
                        None => (*name, String::new()),
                    };
                    format!("<variable formalParameter=\"{name}\"{modifier}><connectionPointOut/></variable>")
                })
                .collect();
            let outputs = outputs.concat();
            out.push_str(&format!(
                "\n<block localId=\"{id}\" typeName=\"{}\"{instance}><inputVariables>{pins}</inputVariables><inOutVariables/>\
                 <outputVariables>{outputs}</outputVariables></block>",
                before[0]
            ));
            continue;
        }
        let mut attributes = String::new();
        let mut inside = String::new();
        let mut text = Vec::new();
        for word in rest {
            match word.split_once('=').filter(|_| text.is_empty()) {
                Some(("from", from)) => inside.push_str(&point(from)),
                Some((name, value)) => attributes.push_str(&format!(" {name}=\"{value}\"")),
                None => text.push(word),
            }
        }
        let text = text.join(" ");
        match kind {
            "contact" | "coil" => inside.push_str(&format!("<variable>{text}</variable>")),
            "inVariable" | "outVariable" => inside.push_str(&format!("<expression>{text}</expression>")),
            "comment" => inside.push_str(&format!("<content><xhtml:p>{text}</xhtml:p></content>")),
            _ => {}
        }
        out.push_str(&format!(
            "\n<{kind} localId=\"{id}\"{attributes}>{inside}</{kind}>"
        ));
    }
    out
}

fn connection(from: &str) -> String {
    match from.split_once('.') {
        Some((id, output)) => format!("<connection refLocalId=\"{id}\" formalParameter=\"{output}\"/>"),
        None => format!("<connection refLocalId=\"{from}\"/>"),
    }
}

fn modifier_of(word: &str) -> String {
    match word {
        "negated" => " negated=\"true\"".to_owned(),
        edge => format!(" edge=\"{edge}\""),
    }
}

/// The ladder text of a project, what was not translated, and the errors of the text.
pub(crate) fn text(xml: &str) -> String {
    let source = Source::alone("test", xml.as_bytes());
    let converted = match convert(&Plcopen, &source, &Options::default()) {
        Ok(converted) => converted,
        Err(error) => return error.to_string(),
    };
    let mut out = converted.written.text;
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(&out).into(), "test.clad");
    for entry in converted.report.remarks() {
        let (Outcome::Approximated(why) | Outcome::Refused(why)) = &entry.outcome else {
            continue;
        };
        let is_refused = matches!(entry.outcome, Outcome::Refused(_));
        let what = if is_refused { "refused" } else { "approximated" };
        out.push_str(&format!("{what} {}: {why}\n", entry.element));
    }
    out.extend(
        analysis
            .errors()
            .map(|error| format!("error: {}\n", error.message)),
    );
    out
}

#[track_caller]
pub(crate) fn check(xml: &str, expected: Expect) {
    expected.assert_eq(&text(xml));
}
