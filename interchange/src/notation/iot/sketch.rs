//! From the model to the sketch of a ladder program.

use super::super::{Finding, Names, Place, Reading};
use super::calculate::{DEFAULT_BASE, Preset, Values, default_preset};
use super::kinds::{Kinds, result};
use super::model::{Element, Family, File, Member, Operand, Part, Variable};
use super::word::Form;
use ladder_analysis::Severity;
use ladder_format::Circuit;
use ladder_format::program::{Declaration, Drawing, Element as Block, Item, Network, Section, SectionKind};
use ladder_instructions::{Op, by_op};
use std::collections::{BTreeMap, HashMap, HashSet};

/// The whole program.
pub(super) fn sketch(file: &File) -> Reading {
    let elements = file.elements();
    let mut tags: BTreeMap<&Variable, Place> = BTreeMap::new();
    let mut blocks: HashMap<&Variable, &Element> = HashMap::new();
    for element in &elements {
        for operand in &element.operands {
            if let Operand::Variable(variable) | Operand::Member(variable, _) = operand {
                tags.entry(variable).or_insert(element.place);
            }
        }
        if let (Form::Timer(_) | Form::Counter(_), Some(Operand::Variable(variable))) =
            (element.row.form, element.operands.first())
        {
            blocks.entry(variable).or_insert(element);
        }
    }
    let mut names = Names::default();
    for variable in tags.keys() {
        names.spell(&variable.to_string());
    }
    let mut values = Values {
        kinds: Kinds::of(file),
        names,
        presets: HashMap::new(),
        helpers: BTreeMap::new(),
    };
    presets(&elements, &tags, &blocks, &mut values);
    let mut importer = Importer {
        blocks: &blocks,
        values,
        reading: Reading::default(),
    };
    let parts = importer.parts(file);
    importer.declare(&tags);
    let mut reading = importer.reading;
    reading.program.items.extend(parts);
    reading
}

/// Notes the presets of all timers and counters; one that the program writes is a tag.
fn presets(
    elements: &[&Element],
    tags: &BTreeMap<&Variable, Place>,
    blocks: &HashMap<&Variable, &Element>,
    values: &mut Values,
) {
    let written: HashSet<&Variable> = elements
        .iter()
        .filter_map(|element| match element.row.form {
            Form::Coil(_) | Form::Reset => element.operands.first(),
            _ => result(element),
        })
        .filter_map(|operand| match operand {
            Operand::Member(variable, Member::Pre) => Some(variable),
            _ => None,
        })
        .collect();
    for variable in tags.keys().filter(|variable| variable.family.is_state()) {
        let number = |index: usize, default: i32| match blocks
            .get(variable)
            .and_then(|block| block.operands.get(index))
        {
            Some(Operand::Number(number)) => number.whole().unwrap_or(default),
            _ => default,
        };
        let preset = Preset {
            value: number(1, default_preset(variable)),
            base: match variable.family {
                Family::Timer => number(2, DEFAULT_BASE),
                _ => DEFAULT_BASE,
            },
            tag: written
                .contains(variable)
                .then(|| values.names.fresh(&format!("{variable}_PRE"))),
        };
        values.presets.insert((*variable).clone(), preset);
    }
}

struct Importer<'f> {
    /// The first block of each timer and counter: a tag belongs to one.
    blocks: &'f HashMap<&'f Variable, &'f Element>,
    values: Values,
    reading: Reading,
}

impl<'f> Importer<'f> {
    fn parts(&mut self, file: &'f File) -> Vec<Item> {
        let mut items = Vec::new();
        let mut above: Vec<String> = Vec::new();
        let mut parts = file.parts.iter().peekable();
        let head = &mut self.reading.program.items;
        while let Some(Part::Beside(line)) = parts.next_if(|part| matches!(part, Part::Beside(_))) {
            head.push(Item::Comment(format!("iot: {line}")));
        }
        for part in parts {
            match part {
                Part::Comment(text) if text.starts_with("iot:") => above.push(format!("iot: # {text}")),
                Part::Comment(text) => above.push(text.clone()),
                Part::Beside(line) => above.push(format!("iot: {line}")),
                Part::Rung(circuit) => {
                    let drawing = Drawing::Circuit(self.circuit(circuit));
                    let comments = std::mem::take(&mut above);
                    items.extend([Item::Blank, Item::Network(Network { comments, drawing })]);
                }
            }
        }
        if !above.is_empty() {
            items.push(Item::Blank);
            items.extend(above.into_iter().map(Item::Comment));
        }
        items
    }

    fn circuit(&mut self, circuit: &'f Circuit<Element>) -> Circuit<Block> {
        match circuit {
            Circuit::Element(element) => Circuit::Series(self.element(element)),
            Circuit::Series(parts) => Circuit::Series(parts.iter().map(|part| self.circuit(part)).collect()),
            Circuit::Parallel(parts) => {
                Circuit::Parallel(parts.iter().map(|part| self.circuit(part)).collect())
            }
        }
    }

    fn element(&mut self, element: &'f Element) -> Vec<Circuit<Block>> {
        let place = element.place;
        let origin = Some(self.reading.origin(place));
        let texts = match self.blocks_of(element) {
            Ok(texts) => texts,
            Err(why) => {
                self.reading.report.refused(place, element.to_string(), &why);
                self.reading.findings.push(Finding {
                    place,
                    severity: Severity::Error,
                    check: "iot-element",
                    message: format!("`{element}` stays as a comment: {why}"),
                });
                let comment = Block::comment(&format!("iot: {element}"), origin);
                return vec![Circuit::Element(comment)];
            }
        };
        let is_stamp = |operand: &Operand| matches!(operand, Operand::Member(_, Member::Tt));
        if element.operands.iter().any(is_stamp) {
            let why =
                "TT says here whether the timer is timing; in the original it is the time of the last count";
            self.reading.report.approximated(place, element.to_string(), why);
        } else {
            self.reading.report.translated(place, element.to_string());
        }
        let block = |text| Circuit::Element(Block::block(text, origin));
        texts.into_iter().map(block).collect()
    }

    fn blocks_of(&mut self, element: &'f Element) -> Result<Vec<String>, String> {
        let operands = &element.operands;
        match element.row.form {
            Form::Contact(op) => self.values.contact(op, &operands[0]),
            Form::Coil(op) => self.values.coil(op, &operands[0]),
            Form::Reset => match &operands[0] {
                Operand::Variable(variable) if variable.family.is_state() => {
                    Ok(vec![format!("(RES)( {variable} )")])
                }
                other => self.values.coil(Op::ResetCoil, other),
            },
            Form::Timer(op) | Form::Counter(op) => self.state(op, element).map(|text| vec![text]),
            Form::Compare(op) => self.values.compare(op, &operands[0], &operands[1]),
            Form::Calculate(op) => self.values.calculate(op, &operands[0], &operands[1..]),
            Form::Not => self.values.calculate(Op::Not, &operands[0], &operands[1..]),
            Form::Assign => self.values.assign(&operands[0], &operands[1]),
            Form::ScanTime => Ok(vec![by_op(Op::Scantime).block()]),
        }
    }

    fn state(&self, op: Op, element: &'f Element) -> Result<String, String> {
        let Some(Operand::Variable(variable)) = element.operands.first() else {
            return Err("it has no timer and no counter".to_owned());
        };
        match self.blocks.get(variable) {
            Some(first) if !std::ptr::eq(*first, element) => {
                return Err(format!(
                    "a timer or counter belongs to one block here, and `{variable}` has one at {}",
                    first.place
                ));
            }
            _ => {}
        }
        let preset = self.values.text(&Operand::Member(variable.clone(), Member::Pre));
        let mut text = format!("{}( {variable}, {preset}", by_op(op).block());
        match (variable.family, element.operands.get(2)) {
            (Family::Timer, _) => {
                let base = self.values.presets.get(variable).map_or(DEFAULT_BASE, |p| p.base);
                text.push_str(&format!(", B := {}", duration(base)));
            }
            (_, Some(Operand::Number(number))) if number.value != 0.0 => {
                text.push_str(&format!(", AC := {}", number.value));
            }
            _ => {}
        }
        Ok(text + " )")
    }

    fn declare(&mut self, tags: &BTreeMap<&'f Variable, Place>) {
        let mut sections = [
            (SectionKind::VarInput, vec![Family::Input]),
            (SectionKind::VarOutput, vec![Family::Output]),
            (
                SectionKind::Var,
                vec![Family::Integer, Family::Float, Family::Timer, Family::Counter],
            ),
        ]
        .map(|(kind, families)| {
            let mut section = Section::new(kind);
            for (variable, place) in tags.iter().filter(|(v, _)| families.contains(&v.family)) {
                let mut declaration = Declaration::new(variable.to_string(), self.ty(variable));
                declaration.origin = Some(self.reading.origin(*place));
                section.declarations.push(declaration);
            }
            section
        });
        let own = &mut sections[2].declarations;
        let presets: BTreeMap<&Variable, &Preset> = self.values.presets.iter().collect();
        for preset in presets.into_values() {
            own.extend(preset.tag.as_ref().map(|tag| Declaration {
                initial: Some(preset.value.to_string()),
                ..Declaration::new(tag, "DINT")
            }));
        }
        for (name, kind) in self.values.helpers.values() {
            own.push(Declaration::new(name, kind.ty()));
        }
        let items = &mut self.reading.program.items;
        items.extend([Item::Directive("profile iot".to_owned()), Item::Blank]);
        items.extend(sections.map(Item::Section));
    }

    fn ty(&self, variable: &Variable) -> String {
        let op = |default: Op| match self.blocks.get(variable).map(|block| block.row.form) {
            Some(Form::Timer(op) | Form::Counter(op)) => by_op(op).mnemonic.to_owned(),
            _ => by_op(default).mnemonic.to_owned(),
        };
        match variable.family {
            Family::Timer => op(Op::Ton),
            Family::Counter => op(Op::Ctu),
            _ => self.values.kinds.variable(variable).ty().to_owned(),
        }
    }
}

/// A time base in milliseconds.
fn duration(milliseconds: i32) -> String {
    match milliseconds {
        0 => "T#0ms".to_owned(),
        ms if ms % 1_000 == 0 => format!("T#{}s", ms / 1_000),
        ms => format!("T#{ms}ms"),
    }
}
