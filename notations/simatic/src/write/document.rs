//! Units as source documents: `.s7dcl`, with their texts in `.s7res`.

use super::Made;
use crate::model::{Body, Kind, Net, Network, Part, RAIL, Role, Unit, Value, Variable};
use crate::read::resource::{ID, written};
use crate::sketch::rungs::{Piece, ways};
use crate::sketch::wiring::Strand;
use crate::standard::{Form, of_document};
use ladder_notation::{Companion, Writing};
use std::collections::HashMap;

/// A program as documents.
pub(crate) fn writing(made: Made) -> Writing {
    let files = |unit: &Unit| {
        let (document, texts) = document(unit);
        let texts = texts.map(|bytes| Companion {
            name: format!("{}.s7res", unit.name),
            bytes: bytes.into(),
        });
        (document, texts)
    };
    let mut companions = Vec::new();
    for unit in made.others.iter().chain(&made.callers) {
        let (bytes, texts) = files(unit);
        let name = format!("{}.s7dcl", unit.name);
        companions.push(Companion {
            name,
            bytes: bytes.into(),
        });
        companions.extend(texts);
    }
    let (bytes, texts) = files(&made.program);
    companions.extend(texts);
    Writing {
        bytes,
        companions,
        report: made.report,
    }
}

/// Texts in languages, each with its id.
#[derive(Default)]
struct Texts(Vec<(String, String)>);

impl Texts {
    /// The id of a text.
    fn id(&mut self, text: String) -> String {
        let id = format!("{ID}{}", self.0.len() + 1);
        self.0.push((id.clone(), text));
        id
    }

    /// Title and comment as the values of a pragma, with these names.
    fn titled(&mut self, told: &[String], [comment, title]: [&str; 2]) -> Vec<String> {
        let [first, rest] = title_and_comment(told);
        let values = [(comment, rest), (title, first)].into_iter();
        values
            .filter_map(|(name, text)| Some(format!("{name} := \"{}\"", self.id(text?))))
            .collect()
    }
}

/// The first line is the title.
pub(super) fn title_and_comment(told: &[String]) -> [Option<String>; 2] {
    match told {
        [] => [None, None],
        [title] => [Some(title.clone()), None],
        // Equal texts would be taken for one.
        [title, comment] if title == comment => [None, Some(told.join("\n"))],
        [title, rest @ ..] => [Some(title.clone()), Some(rest.join("\n"))],
    }
}

/// The sections in the order in which documents have them.
const SECTIONS: [(&str, Role, bool); 6] = [
    ("VAR_INPUT", Role::Input, false),
    ("VAR_OUTPUT", Role::Output, false),
    ("VAR_IN_OUT", Role::InOut, false),
    ("VAR", Role::Static, false),
    ("VAR RETAIN", Role::Static, true),
    ("VAR CONSTANT", Role::Constant, false),
];

/// A unit, and the texts that belong to it.
fn document(unit: &Unit) -> (Vec<u8>, Option<Vec<u8>>) {
    let mut texts = Texts::default();
    let lines = unit.variables.iter().map(|own| declaration(own, &mut texts));
    let lines: Vec<String> = lines.collect();
    let mut body = Vec::new();
    if unit.kind == Kind::Type {
        body.push("    STRUCT".to_owned());
        body.extend(lines.into_iter().map(|line| format!("        {line}")));
        body.push("    END_STRUCT;".to_owned());
    } else {
        for (header, role, retain) in SECTIONS {
            let own = unit.variables.iter().zip(&lines);
            let mut own = own
                .filter(|(own, _)| (own.role, own.retain) == (role, retain))
                .peekable();
            if own.peek().is_none() {
                continue;
            }
            body.push(format!("    {header}"));
            body.extend(own.map(|(_, line)| format!("        {line}")));
            body.push("    END_VAR".to_owned());
        }
        body.push(String::new());
        for own in &unit.networks {
            network(own, &mut texts, &mut body);
        }
    }
    // A data block has the members of the block that it belongs to.
    let of = unit
        .returns
        .as_ref()
        .map_or_else(String::new, |ty| format!(" : {ty}"));
    let mut pragma = texts.titled(&unit.told, ["S7_BlockComment", "S7_BlockTitle"]);
    if unit.kind != Kind::Type {
        pragma.push("S7_Optimized := \"TRUE\"".to_owned());
    }
    if unit.kind.is_code() {
        pragma.push("S7_PreferredLanguage := \"LAD\"".to_owned());
    }
    pragma.push("S7_Version := \"0.1\"".to_owned());
    let keyword = unit.kind.keyword();
    let document = format!(
        "\u{feff}{{\r\n    {}\r\n}}\r\n{keyword} \"{}\"{of}\r\n{}\r\nEND_{keyword}\r\n",
        pragma.join(";\r\n    "),
        unit.name,
        body.join("\r\n"),
    );
    let texts = (!texts.0.is_empty()).then(|| written(&texts.0).into_bytes());
    (document.into_bytes(), texts)
}

/// A declaration with its comment.
fn declaration(variable: &Variable, texts: &mut Texts) -> String {
    let pragma = variable.comment.as_ref();
    let pragma = pragma.map(|told| format!("{{ S7_MLC := \"{}\" }} ", texts.id(told.clone())));
    let initial = variable.initial.as_ref().map(|value| format!(" := {value}"));
    format!(
        "{}\"{}\" : {}{};",
        pragma.unwrap_or_default(),
        variable.name,
        variable.ty,
        initial.unwrap_or_default()
    )
}

/// A network, by lines.
fn network(network: &Network, texts: &mut Texts, out: &mut Vec<String>) {
    let (language, lines): (&str, Vec<String>) = match &network.body {
        Body::Ladder(net) => ("LAD", rungs(net)),
        Body::Text(language, _) => {
            // What is not written is a comment.
            let sign = if language == "SCL" { "" } else { "// " };
            let lines = network.text.lines().map(|line| format!("{sign}{line}"));
            (language, lines.collect())
        }
    };
    let mut pragma = vec![format!("S7_Language := \"{language}\"")];
    pragma.extend(texts.titled(&network.told, ["S7_NetworkComment", "S7_NetworkTitle"]));
    out.push("    {".to_owned());
    out.push(format!("        {}", pragma.join(";\r\n        ")));
    out.extend(["    }".to_owned(), "    NETWORK".to_owned()]);
    let label = network.label.as_ref();
    out.extend(label.map(|(_, label)| format!("        Label( \"{label}\" )")));
    out.extend(lines.into_iter().map(|line| format!("        {line}")));
    out.push("    END_NETWORK".to_owned());
}

/// Wires as rungs, by lines.
fn rungs(net: &Net) -> Vec<String> {
    let strands: Vec<Strand<&Part>> = net
        .wires
        .iter()
        .map(|wire| Strand {
            elements: wire.parts.iter().collect(),
            ..Strand::new(wire.from, wire.to)
        })
        .collect();
    let mut names: HashMap<usize, String> = HashMap::new();
    let mut name = |point: usize| match point {
        RAIL => "wire#powerrail".to_owned(),
        point => {
            let next = names.len() + 1;
            let name = names.entry(point).or_insert_with(|| format!("wire#w{next}"));
            name.clone()
        }
    };
    let mut out = Vec::new();
    for way in ways(&strands) {
        out.push(format!("RUNG {}", name(way.from)));
        let (last, pieces) = match way.pieces.split_last() {
            Some((Piece::Point(point), pieces)) => (Some(*point), pieces),
            _ => (None, &way.pieces[..]),
        };
        for piece in pieces {
            match piece {
                Piece::Point(point) => out.push(format!("    {}", name(*point))),
                Piece::Element(part) => out.extend(part_lines(part)),
            }
        }
        out.push(match last {
            Some(point) => format!("END_RUNG {}", name(point)),
            None => "END_RUNG".to_owned(),
        });
    }
    out
}

/// A part, after a line with its pragma.
fn part_lines(part: &Part) -> impl Iterator<Item = String> {
    let templates = part.templates.iter().map(|(name, ty)| format!("{name} := {ty}"));
    let templates: Vec<String> = templates.collect();
    let templates = match &templates[..] {
        [] => None,
        [one] => Some(one.clone()),
        more => Some(format!("[{}]", more.join(", "))),
    };
    let formula = part.formula.as_ref();
    let formula = formula.map(|formula| format!("; S7_Expression := \"{formula}\""));
    let pragma = templates.map(|templates| {
        let formula = formula.unwrap_or_default();
        format!("    {{ S7_Templates := \"{templates}\"{formula} }}")
    });
    pragma.into_iter().chain([format!("    {}", part_text(part))])
}

fn part_text(part: &Part) -> String {
    let form = of_document(&part.name).map(|row| row.form);
    let only = form.and_then(Form::only_pin);
    let arguments = part.arguments.iter().map(|argument| {
        let value = match &argument.value {
            Value::Operand(text) => format!(" {text}"),
            Value::Helper(tag) => format!(" #\"{tag}\""),
            Value::Power(_) | Value::Open => String::new(),
        };
        let sign = if argument.is_output { "=>" } else { ":=" };
        match argument.pin.as_deref() {
            None => value.trim_start().to_owned(),
            pin if pin == only => value.trim_start().to_owned(),
            // The pins of instructions are words of the system, those of blocks are names.
            Some(pin) if form.is_some() => format!("{pin} {sign}{value}"),
            Some(pin) => format!("\"{pin}\" {sign}{value}"),
        }
    });
    let arguments: Vec<String> = arguments.collect();
    let instance = part.instance.as_ref();
    let instance = instance.map(|name| format!("{name}.")).unwrap_or_default();
    if arguments.is_empty() {
        return format!("{instance}{}( )", part.name);
    }
    format!("{instance}{}( {} )", part.name, arguments.join(", "))
}
