//! From the model to the sketch of a ladder program.

use super::super::{Finding, Place, Reading};
use super::element::{self, Coil, Form, Slot};
use super::model::{DEFAULT_CYCLE, Encoding, File, Leaf, Node, Rung, leaves, number};
use super::tags::{MOST_STAGES, Tags};
use super::text;
use ladder_analysis::Severity;
use ladder_format::Circuit;
use ladder_format::program::{
    Declaration, Drawing, Element, Item, Network, Section, SectionKind, comment_text,
};
use ladder_instructions::{Op, by_op};
use std::collections::hash_map::Entry;
use std::collections::{HashMap, HashSet};

/// The whole program.
pub(super) fn sketch(file: &File) -> Reading {
    let tags = Tags::of(file);
    let pins: HashMap<&str, (u32, &str)> = file
        .io
        .iter()
        .filter_map(|(line, entry)| entry.split_once(" at ").map(|(name, pin)| (name, (*line, pin))))
        .collect();
    let mut importer = Importer {
        file,
        tags: &tags,
        channels: channels(file, &pins),
        pins,
        reading: Reading::default(),
    };
    importer.head();
    importer.rungs();
    importer.reading
}

/// How many analog inputs there are here, counted from 0.
const CHANNELS: u64 = 64;

/// The channel of each analog input: its pin, if that is a channel and no other input's, else the first that is free.
fn channels<'f>(file: &'f File, pins: &HashMap<&str, (u32, &str)>) -> HashMap<&'f str, u64> {
    let all = file.rungs.iter().flat_map(|rung| leaves(&rung.parts));
    let inputs: Vec<&str> = all
        .filter_map(|leaf| leaf.text.strip_prefix("READ_ADC "))
        .map(name_of)
        .collect();
    let mut channels: HashMap<&str, u64> = HashMap::new();
    let mut taken = HashSet::new();
    for name in &inputs {
        let pin = pins.get(name).and_then(|(_, pin)| number(pin));
        let pin = pin.filter(|pin| (1..CHANNELS).contains(pin) && !channels.contains_key(name));
        if let Some(pin) = pin.filter(|pin| taken.insert(*pin)) {
            channels.insert(name, pin);
        }
    }
    let mut free = (0..CHANNELS).filter(|channel| !taken.contains(channel));
    for name in inputs {
        if let Entry::Vacant(unknown) = channels.entry(name)
            && let Some(channel) = free.next()
        {
            unknown.insert(channel);
        }
    }
    channels
}

struct Importer<'f> {
    file: &'f File,
    tags: &'f Tags,
    /// The port of each analog input.
    channels: HashMap<&'f str, u64>,
    /// The line and the pin of each name in the I/O list.
    pins: HashMap<&'f str, (u32, &'f str)>,
    reading: Reading,
}

/// A block and what there is to say about it.
struct Translation {
    text: String,
    /// Why it is not quite the same.
    remark: Option<String>,
}

impl From<String> for Translation {
    fn from(text: String) -> Translation {
        Translation { text, remark: None }
    }
}

impl<'f> Importer<'f> {
    fn head(&mut self) {
        let mut lines = vec![self.file.version.line().to_owned()];
        let Encoding { crlf, latin1 } = self.file.encoding;
        lines.extend(crlf.then(|| "lines end in CR LF".to_owned()));
        lines.extend(latin1.then(|| "Latin-1".to_owned()));
        lines.extend(self.file.header.iter().cloned());
        for (title, entries) in &self.file.lists {
            lines.push(title.clone());
            lines.extend(entries.iter().cloned());
            lines.push("END".to_owned());
        }
        let sections = self.sections();
        let listed = sections.iter().flat_map(|section| &section.declarations);
        let listed: Vec<&str> = listed
            .filter(|d| d.comment.is_some())
            .map(|d| d.names[0].as_str())
            .collect();
        let given: Vec<&str> = self.file.io.iter().map(|(_, entry)| name_of(entry)).collect();
        let spelled: Vec<&str> = given.iter().filter_map(|name| self.tags.listed(name)).collect();
        // Where the declarations cannot show the list as it is, it is kept beside them.
        if spelled != listed || spelled.len() != given.len() {
            lines.extend(self.file.io.iter().map(|(_, entry)| format!("IO {entry}")));
        }
        for (tag, name) in self.tags.renamed() {
            lines.push(format!("NAME {tag} = {name}"));
            let why = format!("it is spelled `{tag}` here");
            self.reading.report.approximated(Place::START, name, why);
        }
        let items = &mut self.reading.program.items;
        items.extend(
            lines
                .into_iter()
                .map(|line| Item::Comment(format!("ldmicro: {line}"))),
        );
        items.push(Item::Directive("profile ldmicro".to_owned()));
        if self.file.cycle() != DEFAULT_CYCLE {
            items.push(Item::Directive(format!(
                "cycle {}",
                plain_duration(self.file.cycle())
            )));
        }
        items.push(Item::Blank);
        items.extend(sections.into_iter().map(Item::Section));
    }

    fn sections(&mut self) -> Vec<Section> {
        let mut inputs = Section::new(SectionKind::VarInput);
        let mut outputs = Section::new(SectionKind::VarOutput);
        let mut others = Section::new(SectionKind::Var);
        let tags = self.tags;
        for (name, tag) in &tags.bits {
            let declaration = self.declaration(name, tag, "BOOL".to_owned(), name.starts_with(['X', 'Y']));
            let section = match name.chars().next() {
                Some('X') => &mut inputs,
                Some('Y') => &mut outputs,
                _ => &mut others,
            };
            section.declarations.push(declaration);
        }
        for (name, tag) in &tags.variables {
            let declaration = self.declaration(name, tag, tags.ty(name), name.starts_with('A'));
            others.declarations.push(declaration);
        }
        for (tag, stages) in tags.registers.values().filter(|(_, stages)| *stages > 0) {
            let ty = format!("ARRAY[0..{}] OF INT", stages - 1);
            others.declarations.push(Declaration::new(tag, ty));
        }
        vec![inputs, outputs, others]
    }

    fn declaration(&mut self, name: &str, tag: &str, ty: String, may_have_pin: bool) -> Declaration {
        let mut declaration = Declaration::new(tag, ty);
        if let Some((line, pin)) = self.pins.get(name).copied().filter(|_| may_have_pin) {
            declaration.origin = Some(self.reading.origin(Place::line(line)));
            declaration.comment = Some(match pin {
                "0" => "no pin".to_owned(),
                pin => format!("pin {pin}"),
            });
        }
        declaration
    }

    fn rungs(&mut self) {
        let mut above: Option<String> = None;
        for rung in &self.file.rungs {
            if let Some(comment) = only_comment(rung) {
                if let Some(before) = above.replace(said(comment)) {
                    self.reading
                        .program
                        .items
                        .extend([Item::Blank, Item::Comment(before)]);
                }
                self.reading.report.translated(Place::line(rung.line), "COMMENT");
                continue;
            }
            self.reading.program.items.push(Item::Blank);
            let comments: Vec<String> = above.take().into_iter().collect();
            if leaves(&rung.parts).is_empty() {
                let items = comments.into_iter().map(Item::Comment);
                self.reading
                    .program
                    .items
                    .extend(items.chain([Item::Comment("ldmicro: RUNG".to_owned())]));
                let why = "the rung is empty";
                self.reading
                    .report
                    .approximated(Place::line(rung.line), "RUNG", why);
                continue;
            }
            let circuit = Circuit::Series(self.nodes(&rung.parts));
            self.reading.program.items.push(Item::Network(Network {
                comments,
                drawing: Drawing::Circuit(circuit),
            }));
        }
        if let Some(comment) = above {
            self.reading
                .program
                .items
                .extend([Item::Blank, Item::Comment(comment)]);
        }
    }

    fn nodes(&mut self, parts: &'f [Node]) -> Vec<Circuit<Element>> {
        let mut out = Vec::with_capacity(parts.len());
        for part in parts {
            match part {
                // Several elements stay one branch of a parallel.
                Node::Leaf(leaf) => {
                    let elements = self.leaf(leaf).into_iter().map(Circuit::Element);
                    out.push(Circuit::Series(elements.collect()));
                }
                Node::Series(parts) => out.push(Circuit::Series(self.nodes(parts))),
                Node::Parallel(parts) => out.push(Circuit::Parallel(self.nodes(parts))),
            }
        }
        out
    }

    fn leaf(&mut self, leaf: &'f Leaf) -> Vec<Element> {
        let place = Place::line(leaf.line);
        let origin = Some(self.reading.origin(place));
        match self.translated(leaf) {
            Ok(Translation { text, remark }) => {
                match remark {
                    Some(why) => self.reading.report.approximated(place, &leaf.text, why),
                    None => self.reading.report.translated(place, &leaf.text),
                }
                let mut out = vec![Element::block(text, origin)];
                let plain = element::plain(&leaf.text, self.file.version);
                if plain.as_deref() != Some(leaf.text.as_str()) || self.is_reset_variable(leaf) {
                    out.push(Element::comment(&format!("was: {}", leaf.text), origin));
                }
                out
            }
            Err(why) => {
                self.reading.report.refused(place, &leaf.text, &why);
                let shown: String = leaf.text.chars().take(80).collect();
                self.reading.findings.push(Finding {
                    place,
                    severity: Severity::Error,
                    check: "ldmicro-element",
                    message: format!("`{shown}` stays as a comment: {why}"),
                });
                vec![Element::comment(&format!("ldmicro: {}", leaf.text), origin)]
            }
        }
    }

    /// RES of a variable is a MOV here.
    fn is_reset_variable(&self, leaf: &Leaf) -> bool {
        let name = leaf.text.strip_prefix("RES ");
        name.is_some_and(|name| self.tags.any_state(name).is_none())
    }

    fn translated(&mut self, leaf: &'f Leaf) -> Result<Translation, String> {
        let row = element::row_of(&leaf.text).ok_or("there is no such instruction here")?;
        let fields = element::fields(&leaf.text);
        if element::plain(&leaf.text, self.file.version).is_none() && row.form != Form::Comment {
            return Err("its fields are not numbers, or are those of the fork".to_owned());
        }
        let name = fields.first().copied().unwrap_or_default();
        Ok(match row.form {
            Form::Contact => {
                let head = if fields[1] == "0" { "[ ]" } else { "[/]" };
                format!("{head}( {} )", self.tags.bit(name)).into()
            }
            Form::Constant(on) => format!("[ ]( SYS.{} )", if on { "ON" } else { "OFF" }).into(),
            Form::Coil => {
                let head = match Coil::of(&fields) {
                    Coil::Plain => "( )",
                    Coil::Negated => "(/)",
                    Coil::Set => "(S)",
                    Coil::Reset => "(R)",
                };
                format!("{head}( {} )", self.tags.bit(name)).into()
            }
            Form::Timer(op) => {
                let tag = self.state(op, name)?;
                let delay: u64 = fields[1].parse().map_err(|_| "its delay is no number")?;
                format!("{}( {tag}, {} )", by_op(op).block(), duration(delay)).into()
            }
            Form::Counter(op) => {
                let tag = self.state(op, name)?;
                let most = element::literal(fields[1]).unwrap_or(0);
                format!("{}( {tag}, {most} )", by_op(op).block()).into()
            }
            Form::Reset => match self.tags.any_state(name) {
                Some(tag) => format!("(RES)( {tag} )").into(),
                None => format!("[MOV]( {}, 0 )", self.tags.variable(name)).into(),
            },
            Form::Adc => {
                let channel = self
                    .channels
                    .get(name)
                    .ok_or("there are no more analog inputs here")?;
                format!("[ADC]( {}, {channel} )", self.tags.variable(name)).into()
            }
            Form::Shift => {
                let stages: u32 = fields[1].parse().unwrap_or(0);
                let register = self.tags.registers.get(name);
                match register {
                    Some((tag, _)) if stages > 0 && stages <= MOST_STAGES => {
                        format!("[SHIFT]( {tag}[0..{}], {tag}[0] )", stages - 1).into()
                    }
                    _ => return Err(format!("a shift register has 1 to {MOST_STAGES} stages")),
                }
            }
            Form::Values(op, slots) => self.values(op, &fields, slots)?,
            Form::Table | Form::Curve => self.listed_values(row.form, &fields)?,
            Form::Text => self.text(&fields)?,
            Form::Comment => return Err("a comment is alone in its rung".to_owned()),
            Form::Placeholder => return Err("the rung is empty: delete it, or add instructions".to_owned()),
        })
    }

    /// The tag of a timer or counter.
    fn state(&self, op: Op, name: &str) -> Result<&'f str, String> {
        let other = || format!("`{name}` is a timer and a counter at once");
        self.tags.state(name, op).ok_or_else(other)
    }

    fn operand(&self, text: &str, remark: &mut Option<String>) -> Result<String, String> {
        if !element::is_literal(text) {
            return Ok(self.tags.variable(text));
        }
        let value = element::literal(text).ok_or("its literal is no number")?;
        let wrapped = element::wrapped(value);
        if wrapped != value {
            *remark = Some(format!("{text} is {wrapped} in 16 bits"));
        }
        Ok(wrapped.to_string())
    }

    fn values(&self, op: Op, fields: &[&str], slots: &[Slot]) -> Result<Translation, String> {
        let head = by_op(op).block();
        if slots.is_empty() {
            return Ok(head.into());
        }
        let mut remark = None;
        let mut operands = Vec::new();
        for (field, slot) in fields.iter().zip(slots) {
            operands.push(match slot {
                Slot::Place if element::is_literal(field) => {
                    return Err(format!("{field} is a number and cannot be written"));
                }
                Slot::Place => self.tags.variable(field),
                Slot::Value => self.operand(field, &mut remark)?,
                Slot::Number => element::literal(field).unwrap_or(0).to_string(),
            });
        }
        let text = format!("{head}( {} )", operands.join(", "));
        Ok(Translation { text, remark })
    }

    fn listed_values(&self, form: Form, fields: &[&str]) -> Result<Translation, String> {
        let mut remark = None;
        let to = self.tags.variable(fields[0]);
        let index = self.operand(fields[1], &mut remark)?;
        let (head, first, each) = match form {
            Form::Table => ("[LUT]", 4, 1),
            _ => ("[PWL]", 3, 2),
        };
        let values = element::numbers(&fields[first..]).unwrap_or_default();
        if fields[2].parse() != Ok(values.len() / each) || !values.len().is_multiple_of(each) {
            return Err("the number of its values is not the one that it gives".to_owned());
        }
        if values.is_empty() {
            return Err("it has no entries".to_owned());
        }
        let values: Vec<String> = values
            .iter()
            .map(|value| element::wrapped(*value).to_string())
            .collect();
        let text = format!("{head}( {to}, {index}, {} )", values.join(", "));
        Ok(Translation { text, remark })
    }

    fn text(&self, fields: &[&str]) -> Result<Translation, String> {
        let text = text::read(fields).ok_or("its text is not what LDmicro 2.2 writes")?;
        let mut operands = vec![text::literal(&text)];
        match (fields[0], text::numbers(&text)) {
            ("(none)", 0) => {}
            ("(none)", _) => return Err("its text wants a number, and it has no variable".to_owned()),
            (_, 0) => return Err("it has a variable, and its text has no place for it".to_owned()),
            (name, 1) => operands.push(self.tags.variable(name)),
            (_, _) => return Err("LDmicro sends one number in a text".to_owned()),
        }
        Ok(format!("[FMT]( {} )", operands.join(", ")).into())
    }
}

fn name_of(entry: &str) -> &str {
    entry.split(' ').next().unwrap_or_default()
}

/// The text of a rung that is only a comment.
fn only_comment(rung: &Rung) -> Option<&str> {
    match &rung.parts[..] {
        [Node::Leaf(leaf)] => leaf.comment(),
        _ => None,
    }
}

/// A comment as ladder text has it: its lines, where they say the same, else as LDmicro's file has it.
fn said(comment: &str) -> String {
    let lines: Vec<&str> = comment.split("\\r\\n").collect();
    let is_plain = |line: &&str| {
        !line.is_empty() && line.trim() == *line && !line.contains('\\') && comment_text(line) == *line
    };
    if lines.iter().all(is_plain) && !comment.starts_with("ldmicro:") {
        return lines.join("\n");
    }
    format!("ldmicro: COMMENT {comment}")
}

/// A delay in microseconds.
fn duration(microseconds: u64) -> String {
    format!("T#{}", plain_duration(microseconds))
}

/// The same as comments have it, where a `#` would end them.
fn plain_duration(microseconds: u64) -> String {
    match microseconds {
        us if us % 1_000_000 == 0 => format!("{}s", us / 1_000_000),
        us if us % 1_000 == 0 => format!("{}ms", us / 1_000),
        us => format!("{us}us"),
    }
}
