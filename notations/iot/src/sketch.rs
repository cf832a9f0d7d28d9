//! From the model to the sketch of a ladder program: one block for each element.

use super::kinds::{is_bit, is_float, numbers, result};
use super::model::{Element, Family, File, IotLine, Member, Number, Operand, Variable};
use super::word::Form;
use ladder_analysis::Severity;
use ladder_format::Circuit;
use ladder_format::program::{
    self, Block, Declaration, Drawing, Expression, Invalid, Item, Network, Operand as Given, Path, Section,
    SectionKind,
};
use ladder_instructions::{Op, by_op};
use ladder_notation::{Finding, LineColumn, Names, Reading};
use std::collections::{BTreeMap, HashMap, HashSet};

/// The whole program.
pub(super) fn sketch(file: &File) -> Reading {
    let elements = file.elements();
    let mut tags: BTreeMap<&Variable, LineColumn> = BTreeMap::new();
    let mut states: HashMap<&Variable, &Element> = HashMap::new();
    for element in &elements {
        for operand in &element.operands {
            if let Operand::Variable(variable) | Operand::Member(variable, _) = operand {
                tags.entry(variable).or_insert(element.place);
            }
        }
        if let (Form::Timer(_) | Form::Counter(_), Some(Operand::Variable(variable))) =
            (element.row.form, element.operands.first())
        {
            states.entry(variable).or_insert(element);
        }
    }
    let mut importer = Importer {
        presets: presets(&elements, &tags, &states),
        states,
        numbers: numbers(file),
        reading: Reading::default(),
    };
    importer.items(file);
    let networks = std::mem::take(&mut importer.reading.program.items);
    importer.declare(&tags);
    let items = &mut importer.reading.program.items;
    // What is next to the program above it comes before its declarations.
    let head = networks
        .iter()
        .take_while(|item| matches!(item, Item::Comment(_)))
        .count();
    items.splice(0..0, networks[..head].iter().cloned());
    items.extend(networks.into_iter().skip(head));
    importer.reading
}

/// Where the preset of a timer or counter comes from.
struct Preset {
    /// What it is at first.
    value: i32,
    /// The time base of a timer, in milliseconds.
    base: i32,
    /// The tag that holds it, if the program writes it.
    tag: Option<String>,
}

/// What the editor sets where no time base is given.
const DEFAULT_BASE: i32 = 100;

/// The presets of all timers and counters.
fn presets<'f>(
    elements: &[&'f Element],
    tags: &BTreeMap<&'f Variable, LineColumn>,
    states: &HashMap<&'f Variable, &'f Element>,
) -> BTreeMap<&'f Variable, Preset> {
    let mut names = Names::default();
    for variable in tags.keys() {
        names.spell(&variable.to_string());
    }
    let written: HashSet<&Variable> = elements
        .iter()
        .filter_map(|element| match element.row.form {
            Form::Reset => element.operands.first(),
            _ => result(element),
        })
        .filter_map(|operand| match operand {
            Operand::Member(variable, Member::Pre) => Some(variable),
            _ => None,
        })
        .collect();
    let mut presets = BTreeMap::new();
    for variable in tags.keys().filter(|variable| variable.family.is_state()) {
        let state = states.get(variable);
        let number = |index: usize| match state.and_then(|state| state.operands.get(index)) {
            Some(Operand::Number(number)) => number.whole(),
            _ => None,
        };
        let preset = Preset {
            value: number(1).unwrap_or(i32::from(variable.family == Family::Timer)),
            base: number(2)
                .filter(|_| variable.family == Family::Timer)
                .unwrap_or(DEFAULT_BASE),
            tag: written
                .contains(variable)
                .then(|| names.fresh(&format!("{variable}_PRE"))),
        };
        presets.insert(*variable, preset);
    }
    presets
}

struct Importer<'f> {
    /// The first block of each timer and counter.
    states: HashMap<&'f Variable, &'f Element>,
    presets: BTreeMap<&'f Variable, Preset>,
    /// The inputs and outputs that are not bits.
    numbers: HashSet<Variable>,
    reading: Reading,
}

impl<'f> Importer<'f> {
    fn items(&mut self, file: &'f File) {
        let mut above: Vec<String> = Vec::new();
        let mut parts = file.parts.iter().peekable();
        while let Some(IotLine::Beside(line)) = parts.next_if(|part| matches!(part, IotLine::Beside(_))) {
            self.push(Item::Comment(format!("iot: {line}")));
        }
        for part in parts {
            match part {
                IotLine::Comment(text) if text.starts_with("iot:") => above.push(format!("iot: ; {text}")),
                IotLine::Comment(text) => above.push(text.clone()),
                IotLine::Beside(line) => above.push(format!("iot: {line}")),
                IotLine::Rung(circuit) => {
                    let drawing = Drawing::Circuit(self.circuit(circuit));
                    let comments = std::mem::take(&mut above);
                    self.push(Item::Blank);
                    self.push(Item::Network(Network { comments, drawing }));
                }
            }
        }
        if !above.is_empty() {
            self.push(Item::Blank);
            for text in above {
                self.push(Item::Comment(text));
            }
        }
    }

    fn push(&mut self, item: Item) {
        self.reading.program.items.push(item);
    }

    fn circuit(&mut self, circuit: &'f Circuit<Element>) -> Circuit<program::Element> {
        match circuit {
            Circuit::Element(element) => Circuit::Element(self.element(element)),
            Circuit::Series(parts) => Circuit::Series(parts.iter().map(|part| self.circuit(part)).collect()),
            Circuit::Parallel(parts) => {
                Circuit::Parallel(parts.iter().map(|part| self.circuit(part)).collect())
            }
        }
    }

    fn element(&mut self, element: &'f Element) -> program::Element {
        let place = element.place;
        let origin = Some(self.reading.origin(place));
        let block = match self.block(element) {
            Ok(block) => block,
            Err(why) => {
                self.reading.report.refused(place, element.to_string(), &why);
                self.reading.findings.push(Finding {
                    place,
                    severity: Severity::Error,
                    check: "iot-element",
                    message: format!("`{element}` stays as a comment: {why}"),
                });
                return program::Element::comment(&format!("iot: {element}"), origin);
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
        program::Element::of(block, origin)
    }

    /// The block of an element, or why there is none.
    fn block(&self, element: &'f Element) -> Result<Block, String> {
        let operands = &element.operands;
        match element.row.form {
            Form::Contact(op) => match &operands[0] {
                Operand::Number(_) => Err("a contact looks at a variable".to_owned()),
                operand => Ok(Block::of(op, [self.value(operand, true)?])?),
            },
            Form::Coil(op) => self.coil(op, &operands[0]),
            Form::Reset => match &operands[0] {
                Operand::Variable(variable) if variable.family.is_state() => {
                    Ok(Block::of(Op::Res, [tag(variable)])?)
                }
                operand @ Operand::Member(..) => self.put(operand, 0),
                operand => self.coil(Op::ResetCoil, operand),
            },
            Form::Timer(op) | Form::Counter(op) => self.state(op, element),
            Form::Compare(op) => self.comparison(op, &operands[0], &operands[1]),
            Form::Calculate(op) => self.calculation(op, operands),
            Form::Not => self.calculation(Op::Not, operands),
            Form::Assign => self.calculation(Op::Mov, operands),
            Form::ScanTime => Ok(Block::of(Op::Scantime, Given::NONE)?),
        }
    }

    fn coil(&self, op: Op, operand: &Operand) -> Result<Block, String> {
        match (op, operand) {
            (Op::SetCoil, Operand::Variable(variable)) if self.is_number(variable) => self.put(operand, 1),
            (Op::ResetCoil, Operand::Variable(variable)) if self.is_number(variable) => self.put(operand, 0),
            (_, Operand::Variable(variable)) => Ok(Block::of(op, [tag(variable)])?),
            _ => Err(format!("a coil writes no {operand} here")),
        }
    }

    /// What sets and resets a number: it is given one.
    fn put(&self, operand: &Operand, number: i64) -> Result<Block, String> {
        Ok(Block::of(Op::Mov, [self.written(operand)?, number.into()])?)
    }

    fn is_number(&self, variable: &Variable) -> bool {
        matches!(variable.family, Family::Integer | Family::Float) || self.numbers.contains(variable)
    }

    fn state(&self, op: Op, element: &'f Element) -> Result<Block, String> {
        let Some(Operand::Variable(variable)) = element.operands.first() else {
            return Err("it has no timer and no counter".to_owned());
        };
        let number = |index: usize| match element.operands.get(index) {
            Some(Operand::Number(number)) => number.whole(),
            _ => None,
        };
        let preset = self.presets.get(variable);
        let is_written = preset.is_some_and(|preset| preset.tag.is_some());
        let preset = match number(1).filter(|_| !is_written) {
            Some(number) => Expression::from(i64::from(number)),
            None => self.member(variable, Member::Pre),
        };
        let mut operands = vec![tag(variable).into(), Given::Value(preset)];
        match (variable.family, number(2)) {
            (Family::Timer, base) => {
                let base = duration(base.unwrap_or(DEFAULT_BASE))?;
                operands.push(Given::Given("B".to_owned(), base));
            }
            (_, Some(start)) if start != 0 => {
                operands.push(Given::Given("AC".to_owned(), i64::from(start).into()));
            }
            _ => {}
        }
        Ok(Block::of(op, operands)?)
    }

    fn comparison(&self, op: Op, left: &Operand, right: &Operand) -> Result<Block, String> {
        let both = [left, right];
        let is_number = |operand: &&Operand| matches!(operand, Operand::Number(_));
        if both.iter().all(is_number) {
            return Err("it compares two numbers, neither of which changes".to_owned());
        }
        let floats = both.iter().any(|operand| is_float_variable(operand));
        let is_broken = |operand: &&Operand| matches!(operand, Operand::Number(n) if n.whole().is_none());
        if !floats && both.iter().any(is_broken) {
            return Err(
                "a whole number is compared with one that is not: assign it to an MF first".to_owned(),
            );
        }
        let is_bit = |operand: &&Operand| !is_number(operand) && is_bit(operand, &self.numbers);
        if floats && both.iter().any(is_bit) {
            return Err("a bit is compared with a float: assign it to an MI first".to_owned());
        }
        Ok(Block::of(
            op,
            [self.value(left, !floats)?, self.value(right, !floats)?],
        )?)
    }

    /// The result first, as in the notation.
    fn calculation(&self, op: Op, operands: &[Operand]) -> Result<Block, String> {
        let is_bitwise = matches!(op, Op::And | Op::Or | Op::Xor | Op::Not);
        let mut values = vec![self.written(&operands[0])?];
        for operand in &operands[1..] {
            if is_bitwise && is_float_variable(operand) {
                return Err(format!("C has no such operation with {operand}"));
            }
            values.push(self.value(operand, is_bitwise)?);
        }
        Ok(Block::of(op, values)?)
    }

    /// An operand that is read.
    fn value(&self, operand: &Operand, whole: bool) -> Result<Expression, String> {
        match operand {
            Operand::Variable(variable) => Ok(tag(variable).into()),
            Operand::Member(variable, member) => Ok(self.member(variable, *member)),
            Operand::Number(number) => match number.whole() {
                Some(value) if whole || !number.is_float() => Ok(i64::from(value).into()),
                None if whole => Err(format!("C has no such operation with {operand}")),
                _ => real(number),
            },
        }
    }

    /// What an element writes.
    fn written(&self, operand: &Operand) -> Result<Expression, String> {
        match operand {
            Operand::Variable(_) | Operand::Member(_, Member::Pre | Member::Ac) => self.value(operand, true),
            _ => Err(format!("only its own block and RESET write {operand} here")),
        }
    }

    /// What a timer or counter remembers. A preset that no element writes is a number.
    fn member(&self, variable: &Variable, member: Member) -> Expression {
        match (member, self.presets.get(variable)) {
            (Member::Pre, Some(Preset { tag: Some(name), .. })) => Path::tag(name).into(),
            (Member::Pre, Some(preset)) => i64::from(preset.value).into(),
            (Member::B, Some(preset)) => i64::from(preset.base).into(),
            (member, _) => tag(variable).member(member.word()).into(),
        }
    }

    fn declare(&mut self, tags: &BTreeMap<&'f Variable, LineColumn>) {
        let others = vec![Family::Integer, Family::Float, Family::Timer, Family::Counter];
        let mut sections = [
            (SectionKind::VarInput, vec![Family::Input]),
            (SectionKind::VarOutput, vec![Family::Output]),
            (SectionKind::Var, others),
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
        let presets = self.presets.values().filter_map(|preset| {
            let tag = preset.tag.as_ref()?;
            Some(Declaration {
                initial: Some(preset.value.to_string()),
                ..Declaration::new(tag, "DINT")
            })
        });
        sections[2].declarations.extend(presets);
        let items = &mut self.reading.program.items;
        items.extend([Item::Directive("profile iot".to_owned()), Item::Blank]);
        items.extend(sections.map(Item::Section));
    }

    fn ty(&self, variable: &Variable) -> &'static str {
        match (
            variable.family,
            self.states.get(variable).map(|state| state.row.form),
        ) {
            (_, Some(Form::Timer(op) | Form::Counter(op))) => by_op(op).mnemonic,
            (Family::Timer, _) => "TON",
            (Family::Counter, _) => "CTU",
            (Family::Float, _) => "REAL",
            (Family::Integer, _) => "DINT",
            _ if self.numbers.contains(variable) => "USINT",
            _ => "BOOL",
        }
    }
}

fn is_float_variable(operand: &Operand) -> bool {
    is_float(operand) && matches!(operand, Operand::Variable(_))
}

/// The tag that a variable is.
fn tag(variable: &Variable) -> Path {
    Path::tag(variable.to_string())
}

/// A time base in milliseconds.
fn duration(milliseconds: i32) -> Result<Expression, Invalid> {
    Expression::literal(match milliseconds {
        0 => "T#0ms".to_owned(),
        ms if ms % 1_000 == 0 => format!("T#{}s", ms / 1_000),
        ms => format!("T#{ms}ms"),
    })
}

/// A real literal of ladder text.
fn real(number: &Number) -> Result<Expression, String> {
    let text = format!("{:?}", number.value);
    Ok(Expression::literal(match text.split_once('e') {
        Some((digits, exponent)) if !digits.contains('.') => format!("{digits}.0e{exponent}"),
        _ => text,
    })?)
}
