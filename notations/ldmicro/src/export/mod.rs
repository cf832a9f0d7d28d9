//! From an analysed program to the model of an LDmicro file.

mod fork;
mod rungs;

use crate::element::{self, Form, ROWS};
use crate::field::Coil;
use crate::fork::jumps;
use crate::fork::made::Made;
use crate::kept::{Head, after, comment, kept};
use crate::model::{Dialect, File, Leaf, Node, Rung, Version};
use crate::{head, text};
use ladder_analysis::Analysis;
use ladder_analysis::program::{
    Argument, Block, BlockKind, Expr, ExprKind, Location, Member, Network, Place as Operand, Program,
    RangeRef, Role, SystemTag, TagId,
};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_format::Circuit;
use ladder_instructions::{Op, Profile};
use ladder_notation::circuit::series_parallel;
use ladder_notation::stand_in;
use ladder_notation::{LineColumn, Lines, Report, WriteError};
use std::collections::{HashMap, HashSet};

/// Writes all networks that LDmicro can say; the others become comments.
pub(super) fn file(analysis: &Analysis) -> Result<(File, Report), WriteError> {
    let text = analysis.context.parse.to_string();
    let whole = stand_in::analysis(analysis, &text, |comment| kept(comment).is_some())?;
    let Some(program) = whole.program() else {
        return Err(WriteError::new("the program has errors"));
    };
    let head = Head::of(&text);
    let mut file = head.file;
    if let Some(cycle) = program.cycle {
        let microseconds = u64::try_from(cycle / 1_000).unwrap_or(0).max(1);
        file.set_cycle(microseconds);
    }
    let mut exporter = Exporter {
        input: Input {
            program,
            text: &text,
            lines: Lines::of(&text),
            dialect: file.dialect(),
            is_import: head.is_import,
            in_profile: analysis.context.profile == Profile::Ldmicro,
        },
        names: head.names,
        pulses: head.pulses,
        fork: Fork::default(),
        report: Report::default(),
    };
    exporter.fork();
    if !head.is_import {
        exporter.letters();
    }
    file.header = head::header(file.version, &file.header);
    if file.io.is_empty() {
        file.io = exporter.io(&head.pins);
    }
    file.rungs = exporter.rungs();
    Ok((file, exporter.report))
}

/// What is written.
struct Input<'p> {
    program: &'p Program,
    text: &'p str,
    lines: Lines,
    dialect: Dialect,
    /// It was made from an LDmicro file.
    is_import: bool,
    /// The program has LDmicro's own arithmetic and timing.
    in_profile: bool,
}

/// What only the fork has.
#[derive(Default)]
struct Fork {
    /// For each user-defined block the element of the fork that it is.
    made: Vec<Result<Made, String>>,
    /// What RES gives the counters of the fork.
    resets: HashMap<String, String>,
    /// The labels of rungs that numbers lead to.
    numbered: HashSet<String>,
}

struct Exporter<'p> {
    input: Input<'p>,
    names: HashMap<String, String>,
    /// LDmicro's names for outputs of pulses, by their numbers.
    pulses: HashMap<String, String>,
    fork: Fork,
    report: Report,
}

impl Exporter<'_> {
    /// Names bits by the letters by which LDmicro knows inputs, outputs and relays.
    fn letters(&mut self) {
        let program = self.input.program;
        let mut taken: HashSet<String> = program.tags.iter().map(|tag| tag.name.clone()).collect();
        for tag in program
            .tags
            .iter()
            .filter(|tag| tag.ty == Type::Scalar(Scalar::Bool))
        {
            let letter = match tag.role {
                Role::Input => 'X',
                Role::Output => 'Y',
                Role::Internal => 'R',
            };
            if tag.name.starts_with(['X', 'Y', 'R']) {
                continue;
            }
            let mut name = format!("{letter}{}", tag.name);
            while !taken.insert(name.clone()) {
                name.push('_');
            }
            let why = format!("LDmicro knows it by its first letter: it is `{name}` there");
            let place = self.place(tag.location);
            self.report.approximated(place, tag.name.clone(), why);
            self.names.insert(tag.name.clone(), name);
        }
    }

    fn io(&self, pins: &[(String, String)]) -> Vec<(u32, String)> {
        let entry = |(tag, pin): &(String, String)| (0, format!("{} at {pin}", self.ldmicro_name(tag)));
        pins.iter().map(entry).collect()
    }

    fn network(&mut self, network: &Network) -> Rung {
        let place = self.place(network.location);
        let circuit = series_parallel(network).ok_or("it is not made of series and branches alone");
        let parts = circuit
            .map_err(str::to_owned)
            .and_then(|circuit| self.parts(network, circuit));
        let parts = match parts {
            Ok(parts) => parts,
            Err(why) => {
                self.report.refused(place, "network", why);
                let text = self.input.text[network.location.range].replace('\\', "\\\\");
                let text = text.lines().collect::<Vec<_>>().join("\\r\\n");
                vec![comment(&text)]
            }
        };
        Rung {
            line: place.line,
            parts,
        }
    }

    fn place(&self, location: Location) -> LineColumn {
        self.input
            .lines
            .place(self.input.text, location.range.start().into())
    }

    /// What is in series.
    fn parts(&mut self, network: &Network, circuit: Circuit<usize>) -> Result<Vec<Node>, String> {
        Ok(match circuit {
            Circuit::Element(block) => vec![self.leaf(&network.blocks[block])?],
            Circuit::Series(parts) => {
                let mut out = Vec::with_capacity(parts.len());
                for part in parts {
                    out.extend(self.parts(network, part)?);
                }
                out
            }
            Circuit::Parallel(branches) => {
                let mut out = Vec::with_capacity(branches.len());
                for branch in branches {
                    let mut parts = self.parts(network, branch)?;
                    out.push(match (parts.pop(), parts.is_empty()) {
                        (Some(leaf @ Node::Leaf(_)), true) => leaf,
                        (last, _) => {
                            parts.extend(last);
                            Node::Series(parts)
                        }
                    });
                }
                vec![Node::Parallel(out)]
            }
        })
    }

    fn leaf(&mut self, block: &Block) -> Result<Node, String> {
        let place = self.place(block.location);
        let range = block.location.range;
        let written = &self.input.text[range];
        let text = match kept(written) {
            Some(line) => {
                element::check(&line).map_err(|why| format!("{place}: {why}"))?;
                line
            }
            None => {
                let plain = self
                    .block(block)
                    .map_err(|why| format!("{place}: `{written}`: {why}"))?;
                self.before(usize::from(range.end()), &plain).unwrap_or(plain)
            }
        };
        match block.kind {
            BlockKind::Instruction(row)
                if self.input.dialect.version == Version::V02
                    && matches!(row.op, Op::Ctu | Op::Ctd | Op::Ctc) =>
            {
                let why =
                    "LDmicro's fork counts no further than the limit, and its CTC gives power for one scan";
                self.report.approximated(place, text.clone(), why);
            }
            _ => self.report.translated(place, text.clone()),
        }
        Ok(Node::Leaf(Leaf {
            line: place.line,
            text,
        }))
    }

    /// The line that the comment after a block says it was, if it still means the same.
    fn before(&self, end: usize, plain: &str) -> Option<String> {
        let rest = self.input.text[end..].trim_start_matches(['-', ' ']);
        let length = rest.strip_prefix('#')?.find('#')? + 2;
        let line = after(&rest[..length], "was:")?;
        element::check(&line).ok()?;
        if jumps::same(&line, plain) {
            return Some(line);
        }
        let was = element::plain(&line, self.input.dialect)?;
        let is_reset = || {
            let (name, value) = plain.strip_prefix("MOVE ")?.split_once(' ')?;
            let reset = self.fork.resets.get(name).map_or("0", String::as_str);
            (value == reset).then(|| format!("RES {name}"))
        };
        (was == plain || is_reset() == Some(was)).then_some(line)
    }

    /// The line of a block.
    fn block(&self, block: &Block) -> Result<String, String> {
        let instruction = match block.kind {
            BlockKind::Instruction(instruction) => instruction,
            BlockKind::User(index) => return self.made(block, index),
        };
        let arguments: Vec<&Argument> = block.arguments.iter().map(|bound| &bound.argument).collect();
        if let Some(line) = self.forks(block, instruction.op)? {
            return Ok(line);
        }
        let unknown = || format!("LDmicro has no {} like this", instruction.block());
        let fork = |line: String, more: &str| match self.input.dialect.version {
            Version::V01 => line,
            Version::V02 => line + more,
        };
        let line = match (instruction.op, &arguments[..]) {
            (Op::Contact | Op::NegatedContact, [tag]) => {
                let negated = instruction.op == Op::NegatedContact;
                if let Argument::Value(Expr {
                    kind: ExprKind::Read(Operand::System(tag)),
                    ..
                }) = tag
                {
                    return match (tag, negated) {
                        (SystemTag::On, false) | (SystemTag::Off, true) => Ok("SHORT".to_owned()),
                        (SystemTag::Off, false) | (SystemTag::On, true) => Ok("OPEN".to_owned()),
                        _ => Err(unknown()),
                    };
                }
                let name = self.argument(tag)?;
                fork(format!("CONTACTS {name} {}", u8::from(negated)), " 0")
            }
            (op @ (Op::Coil | Op::NegatedCoil | Op::SetCoil | Op::ResetCoil), [tag]) => {
                if let Argument::State(_) = tag {
                    return Ok(format!("RES {}", self.argument(tag)?));
                }
                let coil = match op {
                    Op::NegatedCoil => Coil::Negated,
                    Op::SetCoil => Coil::Set,
                    Op::ResetCoil => Coil::Reset,
                    _ => Coil::Plain,
                };
                fork(element::coil(&self.argument(tag)?, coil), " 0")
            }
            (Op::Res, [tag]) => format!("RES {}", self.argument(tag)?),
            (Op::Adc, [to, _]) => fork(format!("READ_ADC {}", self.argument(to)?), " 0"),
            (Op::Shift, [Argument::Range(range), Argument::Value(first)]) => self.shift(range, first)?,
            (Op::Lut, [to, index, values @ ..]) => {
                element::table(&self.argument(to)?, &self.argument(index)?, &constants(values)?)
            }
            (Op::Pwl, [to, input, points @ ..]) => {
                element::curve(&self.argument(to)?, &self.argument(input)?, &constants(points)?)
            }
            (Op::Fmt, [Argument::Value(value), values @ ..]) => self.text(value, values)?,
            (op, arguments) => self.regular(op, arguments).ok_or_else(unknown)??,
        };
        Ok(line)
    }

    /// A timer, a counter, or an instruction whose operands are the fields.
    fn regular(&self, op: Op, arguments: &[&Argument]) -> Option<Result<String, String>> {
        let row = ROWS.iter().find(|row| match row.form {
            Form::Values(own, slots) => own == op && slots.len() == arguments.len(),
            Form::Timer(own) | Form::Counter(own) => own == op && arguments.len() == 2,
            _ => false,
        })?;
        let fields: Result<Vec<String>, String> = arguments.iter().map(|a| self.argument(a)).collect();
        let fields = match fields {
            Ok(fields) => fields,
            Err(why) => return Some(Err(why)),
        };
        let word = row.word;
        if let Form::Timer(_) = row.form {
            let preset = fields[1]
                .parse()
                .map_err(|_| "LDmicro's delays are fixed".to_owned());
            return Some(preset.map(|preset| element::timer(word, &fields[0], preset, self.input.dialect)));
        }
        let mut line = [&[word.to_owned()][..], &fields].concat().join(" ");
        if self.input.dialect.version == Version::V02 {
            line.push_str(match row.form {
                Form::Values(Op::Usnd | Op::Urcv, _) => " 1 0",
                Form::Counter(_) => " 0 /",
                _ => "",
            });
        }
        Some(Ok(line))
    }

    fn shift(&self, range: &RangeRef, first: &Expr) -> Result<String, String> {
        let bound = |expr: &Expr| match expr.kind {
            ExprKind::Constant(Value::Int(number)) => Some(number),
            _ => None,
        };
        let enters = Operand::Element(range.tag, range.first.clone());
        let is_own = matches!(&first.kind, ExprKind::Read(place) if self.place_name(place) == self.place_name(&enters));
        match (bound(&range.first), range.last.as_deref().and_then(bound)) {
            (Some(0), Some(last)) if is_own => {
                Ok(format!("SHIFT_REGISTER {} {}", self.name(range.tag), last + 1))
            }
            _ => Err("LDmicro shifts all of an array from 0, and keeps what is at 0".to_owned()),
        }
    }

    fn text(&self, value: &Expr, values: &[&Argument]) -> Result<String, String> {
        let ExprKind::Constant(Value::Text(bytes)) = &value.kind else {
            return Err("LDmicro sends fixed texts".to_owned());
        };
        let latin1: String = bytes.iter().copied().map(char::from).collect();
        let text =
            text::from_value(&latin1, self.input.in_profile).ok_or("LDmicro cannot send such characters")?;
        let mut names = values.iter().map(|value| self.argument(value));
        let variable = names.next().unwrap_or_else(|| Ok("(none)".to_owned()))?;
        for other in names {
            if other? != variable {
                return Err("LDmicro sends one variable in a text".to_owned());
            }
        }
        Ok(text::line(&variable, &text))
    }

    fn argument(&self, argument: &Argument) -> Result<String, String> {
        match argument {
            Argument::Value(value) => self.value(value),
            Argument::Place(place, _) => self.place_name(place),
            Argument::State(tag) => Ok(self.name(*tag)),
            _ => Err("LDmicro has single variables and numbers as operands".to_owned()),
        }
    }

    fn value(&self, value: &Expr) -> Result<String, String> {
        match &value.kind {
            ExprKind::Read(place) => self.place_name(place),
            ExprKind::Pass(inside) => self.value(inside),
            ExprKind::Constant(Value::Int(nanoseconds)) if value.ty == Scalar::Time => {
                match nanoseconds % 1_000 {
                    0 => Ok((nanoseconds / 1_000).to_string()),
                    _ => Err("LDmicro counts whole microseconds".to_owned()),
                }
            }
            ExprKind::Constant(Value::Int(number)) => Ok(number.to_string()),
            _ => Err("LDmicro has single variables and whole numbers as operands".to_owned()),
        }
    }

    fn place_name(&self, place: &Operand) -> Result<String, String> {
        match place {
            Operand::Tag(tag) | Operand::Member(tag, Member::Cv) => Ok(self.name(*tag)),
            // Elsewhere it is a time, and here a number of scans.
            Operand::Member(tag, Member::Et) if self.input.in_profile => Ok(self.name(*tag)),
            Operand::Element(tag, index) => match index.kind {
                ExprKind::Constant(Value::Int(index)) => Ok(format!("{}{index}", self.name(*tag))),
                _ => Err("LDmicro has no computed index".to_owned()),
            },
            _ => Err("LDmicro has single variables and numbers as operands".to_owned()),
        }
    }

    fn name(&self, tag: TagId) -> String {
        self.ldmicro_name(&self.input.program.tags[tag.0 as usize].name)
    }

    fn ldmicro_name(&self, tag: &str) -> String {
        self.names.get(tag).cloned().unwrap_or_else(|| tag.to_owned())
    }
}

fn constants(values: &[&Argument]) -> Result<Vec<i64>, String> {
    let constant = |value: &&Argument| match value {
        Argument::Value(value) => constant_of(value),
        _ => None,
    };
    let all: Option<Vec<i64>> = values.iter().map(constant).collect();
    all.ok_or_else(|| "LDmicro's tables hold numbers".to_owned())
}

fn constant_of(value: &Expr) -> Option<i64> {
    match &value.kind {
        ExprKind::Constant(Value::Int(number)) => Some(*number),
        ExprKind::Pass(inside) => constant_of(inside),
        _ => None,
    }
}
