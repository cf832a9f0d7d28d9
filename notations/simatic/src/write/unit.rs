//! The program, or a block of one's own, as one document.

use super::Writer;
use super::declare::{self, Declarations, Declared};
use super::operand::Tags;
use super::power::{POWER_IN, POWER_OUT, Power};
use crate::read::resource::{ID, written};
use ladder_analysis::program::Role;
use ladder_notation::{LineColumn, comments};
use ladder_syntax::{Item, LineKind, Parse};
use std::collections::HashMap;

/// What is written into one document.
#[derive(Debug, Default)]
pub(super) struct Unit {
    /// Empty for the program itself.
    pub(super) name: String,
    /// Whether it is a block, and not the program.
    pub(super) is_block: bool,
    /// Whether its jumps go out of it.
    pub(super) leads_out: bool,
    pub(super) said: Vec<String>,
    pub(super) sections: Vec<Declarations>,
    /// Networks by their number in the structure, each with what is said above it.
    pub(super) networks: Vec<(usize, Vec<String>)>,
    /// Of an unread part: its text in SCL, or why it is not written.
    pub(super) unread: Option<Result<String, String>>,
}

/// The program, and then its blocks.
pub(super) fn units(parse: &Parse) -> Vec<Unit> {
    let structure = parse.structure();
    let mut units = vec![Unit::default()];
    let mut at = 0;
    // Lines of comments, in groups that blank lines part.
    let mut groups: Vec<Vec<String>> = vec![Vec::new()];
    for item in &structure.items {
        match *item {
            Item::Decoration(line) => {
                let said: Vec<String> = comments::on_line(parse, line)
                    .iter()
                    .flat_map(|comment| comments::said(comment).map(str::to_owned).collect::<Vec<_>>())
                    .collect();
                if parse.lines()[line].kind == LineKind::Blank {
                    groups.push(Vec::new());
                } else if let Some(group) = groups.last_mut() {
                    group.extend(said);
                }
            }
            Item::Network(number) => {
                let own = groups.pop().unwrap_or_default();
                let before: Vec<String> = std::mem::take(&mut groups).into_iter().flatten().collect();
                groups.push(Vec::new());
                let unit = &mut units[at];
                let mut said = own;
                let is_first =
                    unit.networks.is_empty() && unit.sections.iter().all(|section| section.keyword == "TYPE");
                if is_first {
                    unit.said.extend(before);
                } else {
                    said = before.into_iter().chain(said).collect();
                }
                let lines = structure.networks[number].lines.clone();
                for comment in lines.flat_map(|line| comments::on_line(parse, line)) {
                    said.extend(comments::said(&comment).map(str::to_owned));
                }
                unit.networks.push((number, said));
            }
            Item::Section(number) => {
                let unit = &mut units[at];
                unit.said
                    .extend(std::mem::take(&mut groups).into_iter().flatten());
                groups.push(Vec::new());
                unit.sections
                    .push(declare::section(parse, &structure.sections[number]));
            }
            Item::BlockHeader(number) => {
                let lines = structure.blocks[number].lines.clone();
                let text = parse.lines()[lines.start].text();
                let name: String = text
                    .split_once('$')
                    .map(|(_, rest)| rest.chars().take_while(|c| c.is_alphanumeric()).collect())
                    .unwrap_or_default();
                let said: Vec<String> = std::mem::take(&mut groups).into_iter().flatten().collect();
                units.push(Unit {
                    name,
                    is_block: true,
                    leads_out: text.contains('<'),
                    unread: super::unread::text_of(parse, lines, &said),
                    said,
                    ..Unit::default()
                });
                groups.push(Vec::new());
                at = units.len() - 1;
            }
            Item::BlockEnd(_) => {
                groups = vec![Vec::new()];
                at = 0;
            }
            Item::Stray(_) => {}
        }
    }
    units
}

/// The names of the parameters of each block.
pub(super) fn parameters(units: &[Unit]) -> HashMap<String, Vec<String>> {
    let of = |unit: &Unit| {
        let sections = unit.sections.iter();
        let own = sections.filter(|section| {
            matches!(
                section.keyword.as_str(),
                "VAR_INPUT" | "VAR_OUTPUT" | "VAR_IN_OUT"
            )
        });
        let names = own
            .flat_map(|section| &section.declared)
            .flat_map(|declared| declared.names.clone());
        (unit.name.to_lowercase(), names.collect())
    };
    units.iter().map(of).collect()
}

impl Writer<'_> {
    /// A document, and the texts that belong to it. `power`: of a block.
    pub(super) fn unit(
        &mut self,
        name: &str,
        unit: &Unit,
        power: Option<Power>,
    ) -> (Vec<u8>, Option<Vec<u8>>) {
        self.statics.clear();
        self.texts.clear();
        self.taken.clear();
        if unit.leads_out {
            let why = "a block of this shape leaves the program that it stands in, and no block does there";
            self.report
                .refused(LineColumn::START, format!("block ${name}"), why);
        }
        let mut tags = Tags::new();
        let mut out: Vec<(String, Vec<String>)> = Vec::new();
        for section in unit.sections.iter().filter(|section| section.keyword != "TYPE") {
            for declared in &section.declared {
                self.declared(section, declared, &mut tags, &mut out);
            }
        }
        self.undeclared(unit, &mut tags, &mut out);
        let mut networks = powered(power, &mut tags, &mut out);
        self.taken.extend(tags.keys().cloned());
        let guard = usize::from(power == Some(Power::Guarded));
        for (number, said) in unit.networks.iter().skip(guard) {
            let Some(network) = self.network_at(*number) else {
                let place = self.place(self.start(*number).into());
                self.report.refused(
                    place,
                    "network",
                    "it is part of a function that the program does not call",
                );
                continue;
            };
            let title = self.titled(said);
            let place = self.place(network.location.range.start().into());
            let parts = match self.in_scl(network, &tags) {
                Some(Ok(text)) => {
                    self.report.translated(place, "network");
                    networks.push_str(&drawn("SCL", &title, "", &text));
                    continue;
                }
                Some(Err(why)) => Err(why),
                None => self.network(network, &tags),
            };
            let parts = match parts {
                Ok(parts) => {
                    self.report.translated(place, "network");
                    parts
                }
                Err(why) => {
                    self.report.refused(place, "network", why);
                    let text = self.text[network.location.range].to_owned();
                    let lines = text.lines().map(|line| format!("        // {line}\r\n"));
                    vec![lines.collect()]
                }
            };
            // Others may jump to it, also if it is refused.
            let label = self.label(network);
            let label = label
                .map(|label| format!("        Label( \"{label}\" )\r\n"))
                .unwrap_or_default();
            for (number, rungs) in parts.iter().enumerate() {
                match number {
                    0 => networks.push_str(&drawn("LAD", &title, &label, rungs)),
                    _ => networks.push_str(&drawn("LAD", "", "", rungs)),
                }
            }
        }
        let statics = self
            .statics
            .iter()
            .map(|(name, ty)| format!("\"{name}\" : {ty};"));
        let statics: Vec<String> = statics.collect();
        if !statics.is_empty() {
            push(&mut out, "VAR", statics);
        }
        let said = self.block_texts(&unit.said);
        let mut document = format!(
            "\u{feff}{{\r\n{said}    S7_Optimized := \"TRUE\";\r\n    S7_PreferredLanguage := \"LAD\";\r\n    S7_Version := \"0.1\"\r\n}}\r\nFUNCTION_BLOCK \"{name}\"\r\n"
        );
        out.sort_by_key(|(header, _)| SECTIONS.iter().position(|own| own == header));
        for (header, lines) in &out {
            document.push_str(&format!("    {header}\r\n"));
            for line in lines {
                document.push_str(&format!("        {line}\r\n"));
            }
            document.push_str("    END_VAR\r\n");
        }
        document.push_str("\r\n");
        document.push_str(&networks);
        document.push_str("END_FUNCTION_BLOCK\r\n");
        (document.into_bytes(), self.resource())
    }

    /// What the texts of a document are, for the file next to it.
    pub(super) fn resource(&self) -> Option<Vec<u8>> {
        (!self.texts.is_empty()).then(|| written(&self.texts).into_bytes())
    }

    /// What stands in front of a declaration.
    pub(super) fn pragma(&mut self, declared: &Declared) -> String {
        let said = declared.comment.as_ref();
        let pragma = said.map(|said| format!("{{ S7_MLC := \"{}\" }} ", self.text_id(said.clone())));
        pragma.unwrap_or_default()
    }

    fn declared(
        &mut self,
        section: &Declarations,
        declared: &Declared,
        tags: &mut Tags,
        out: &mut Vec<(String, Vec<String>)>,
    ) {
        let place = self.place(declared.at);
        let header = match (section.keyword.as_str(), section.qualifier.as_deref()) {
            (_, Some("CONSTANT")) => "VAR CONSTANT".to_owned(),
            ("VAR_INPUT" | "VAR_OUTPUT" | "VAR_IN_OUT", _) => section.keyword.clone(),
            ("VAR", Some(_)) => "VAR RETAIN".to_owned(),
            _ => "VAR".to_owned(),
        };
        for name in &declared.names {
            let shown = format!("tag `{name}`");
            let line = declare::declaration(name, &declared.ty, declared.initial.as_deref(), &self.types);
            let line = match line {
                Ok(line) => line,
                Err(why) => {
                    let why = format!("`{name}` cannot be declared: {why}");
                    self.report.refused(place, shown, why.clone());
                    tags.insert(name.to_lowercase(), Err(why));
                    continue;
                }
            };
            tags.insert(name.to_lowercase(), Ok(declared.ty.to_ascii_uppercase()));
            push(out, &header, vec![format!("{}{line}", self.pragma(declared))]);
            if declare::enumeration(&declared.ty, &self.types).is_some() {
                let why = "an enumeration is a DInt there, and its values are numbers";
                self.report.approximated(place, shown, why);
            } else if matches!(section.keyword.as_str(), "VAR_GLOBAL" | "VAR_EXTERNAL") {
                let why = "other blocks do not see it: it is a variable of the block";
                self.report.approximated(place, shown, why);
            } else if let Some(address) = &declared.address {
                let why = format!(
                    "a variable of a block has no address: connect it to {address} where the block is called"
                );
                self.report.approximated(place, shown, why);
            } else if header == section.keyword && section.qualifier.is_some() {
                let why = "it is not retentive there: only variables of the block itself are";
                self.report.approximated(place, shown, why);
            } else {
                self.report.translated(place, shown);
            }
        }
    }

    /// The tags that the program uses without declaring them. A block's body has none.
    fn undeclared(&mut self, unit: &Unit, tags: &mut Tags, out: &mut Vec<(String, Vec<String>)>) {
        if unit.is_block {
            return;
        }
        let program = self.program;
        for tag in &program.tags {
            let is_own =
                tag.block.is_none() && tag.location.file == 0 && !tag.name.contains(['.', '%', '[', '$']);
            if !is_own || tags.contains_key(&tag.name.to_lowercase()) {
                continue;
            }
            let header = match tag.role {
                Role::Input => "VAR_INPUT",
                Role::Output => "VAR_OUTPUT",
                Role::Internal if tag.retain => "VAR RETAIN",
                Role::Internal => "VAR",
            };
            let ty = tag.ty.to_string();
            let place = self.place(tag.location.range.start().into());
            match declare::declaration(&tag.name, &ty, None, &self.types) {
                Ok(line) => {
                    tags.insert(tag.name.to_lowercase(), Ok(ty.to_ascii_uppercase()));
                    push(out, header, vec![line]);
                }
                Err(why) => {
                    let why = format!("`{}` cannot be declared: {why}", tag.name);
                    self.report
                        .refused(place, format!("tag `{}`", tag.name), why.clone());
                    tags.insert(tag.name.to_lowercase(), Err(why));
                }
            }
        }
    }

    /// The id of a text.
    fn text_id(&mut self, text: String) -> String {
        let id = format!("{ID}{}", self.texts.len() + 1);
        self.texts.push((id.clone(), text));
        id
    }

    /// Title and comment in the pragma of a network.
    fn titled(&mut self, said: &[String]) -> String {
        let (title, comment) = title_and_comment(said);
        let mut out = String::new();
        for (name, text) in [("S7_NetworkComment", comment), ("S7_NetworkTitle", title)] {
            if let Some(text) = text {
                out.push_str(&format!(";\r\n        {name} := \"{}\"", self.text_id(text)));
            }
        }
        out
    }

    fn block_texts(&mut self, said: &[String]) -> String {
        let (title, comment) = title_and_comment(said);
        let mut out = String::new();
        for (name, text) in [("S7_BlockComment", comment), ("S7_BlockTitle", title)] {
            if let Some(text) = text {
                out.push_str(&format!("    {name} := \"{}\";\r\n", self.text_id(text)));
            }
        }
        out
    }
}

/// Declares what stands for the power of a block. Returns the network with which its body begins.
fn powered(power: Option<Power>, tags: &mut Tags, out: &mut Vec<(String, Vec<String>)>) -> String {
    let Some(Power::Given { reads, writes }) = power else {
        return String::new();
    };
    let asked = [
        (reads, "en", POWER_IN, "VAR_INPUT"),
        (writes, "eno", POWER_OUT, "VAR_OUTPUT"),
    ];
    for (_, key, name, header) in asked.into_iter().filter(|(is_asked, ..)| *is_asked) {
        let own = match tags.insert(name.to_owned(), Ok("BOOL".to_owned())) {
            Some(_) => Err(format!(
                "there `{}` is `{name}`, and a tag has that name",
                key.to_uppercase()
            )),
            None => Ok("BOOL".to_owned()),
        };
        if own.is_ok() {
            push(out, header, vec![format!("\"{name}\" : Bool;")]);
        }
        tags.insert(key.to_owned(), own);
    }
    if !writes {
        return String::new();
    }
    let rung = format!(
        "        RUNG wire#powerrail\r\n            Contact( #\"{POWER_IN}\" )\r\n            Coil( #\"{POWER_OUT}\" )\r\n        END_RUNG\r\n"
    );
    drawn("LAD", "", "", &rung)
}

/// A network.
fn drawn(language: &str, title: &str, label: &str, rungs: &str) -> String {
    format!(
        "    {{\r\n        S7_Language := \"{language}\"{title}\r\n    }}\r\n    NETWORK\r\n{label}{rungs}    END_NETWORK\r\n"
    )
}

/// The sections in the order in which documents have them.
const SECTIONS: [&str; 6] = [
    "VAR_INPUT",
    "VAR_OUTPUT",
    "VAR_IN_OUT",
    "VAR",
    "VAR RETAIN",
    "VAR CONSTANT",
];

fn push(out: &mut Vec<(String, Vec<String>)>, header: &str, lines: Vec<String>) {
    match out.iter_mut().find(|(own, _)| own == header) {
        Some((_, own)) => own.extend(lines),
        None => out.push((header.to_owned(), lines)),
    }
}

/// The first line is the title.
fn title_and_comment(said: &[String]) -> (Option<String>, Option<String>) {
    match said {
        [] => (None, None),
        [title] => (Some(title.clone()), None),
        // Equal texts would be taken for one.
        [title, comment] if title == comment => (None, Some(said.join("\n"))),
        [title, rest @ ..] => (Some(title.clone()), Some(rest.join("\n"))),
    }
}
