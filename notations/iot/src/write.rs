//! From a program to the notation: a line for each network of what iot-ladder-editor has.

use super::names::{Names, names};
use super::parse::{DEEPEST, MOST_IN_RUNG, MOST_PARTS, element};
use super::word::{Form, ROWS};
use ladder_analysis::Analysis;
use ladder_analysis::program::{
    Argument, Block, BlockKind, Expr, ExprKind, Member, Network, Place as Operand, Program, SystemTag, TagId,
};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::{Value, real_text};
use ladder_format::Circuit;
use ladder_instructions::{Op, Profile};
use ladder_notation::circuit::series_parallel;
use ladder_notation::{LineColumn, Lines, Report, WriteError, Writing, comments, stand_in};
use ladder_syntax::Item;

/// Writes all networks that the notation can say; the others stay as comments.
pub(super) fn write(analysis: &Analysis) -> Result<Writing, WriteError> {
    let text = analysis.context.parse.to_string();
    let whole = stand_in::analysis(analysis, &text, |comment| kept(comment).is_some())?;
    let Some(program) = whole.program() else {
        return Err(WriteError::new("the program has errors"));
    };
    let lines = Lines::of(&text);
    let mut report = Report::default();
    let is_own = analysis.context.profile == Profile::Iot;
    if !is_own {
        let why = "arithmetic, timers and counters are those of iot-ladder-editor there, not of the profile of this file";
        report.approximated(LineColumn::START, "program", why);
    }
    let names = names(program, &mut report, |location| {
        lines.place(&text, location.range.start().into())
    });
    let writer = Writer {
        program,
        names: &names,
        text: &text,
        is_own,
    };
    let mut networks = program
        .networks
        .iter()
        .filter(|network| network.location.file == 0);
    let mut out = String::new();
    let parse = &analysis.context.parse;
    let comments = |line: usize, out: &mut String| {
        let all = comments::on_line(parse, line);
        all.iter()
            .filter(|text| kept(text).is_none())
            .for_each(|text| comment(text, out));
    };
    for item in &parse.structure().items {
        match *item {
            Item::Decoration(line) => comments(line, &mut out),
            Item::Network(number) => {
                let drawn = &parse.structure().networks[number];
                drawn.lines.clone().for_each(|line| comments(line, &mut out));
                let Some(network) = networks.next() else { continue };
                let place = lines.place(&text, network.location.range.start().into());
                match writer.network(network) {
                    Ok(line) => {
                        report.translated(place, "network");
                        out.push_str(&line);
                        out.push('\n');
                    }
                    Err(why) => {
                        report.refused(place, "network", why);
                        for row in text[network.location.range].lines() {
                            out.push_str(&format!("# {row}\n"));
                        }
                    }
                }
            }
            Item::BlockHeader(number) => {
                let header = parse.structure().blocks[number].lines.start;
                let place = lines.place(&text, parse.line_start(header).into());
                report.refused(
                    place,
                    "FUNCTION_BLOCK",
                    "the IoT ladder language has no blocks of one's own",
                );
            }
            _ => {}
        }
    }
    Ok(Writing {
        bytes: out.into_bytes(),
        report,
        ..Writing::default()
    })
}

/// The element in `# iot: OUT T1:DN #`, as it was before it became a comment.
fn kept(comment: &str) -> Option<String> {
    let told = comments::inside(comment)
        .trim()
        .strip_prefix("iot:")?
        .trim()
        .to_owned();
    element(&told).is_some().then_some(told)
}

/// A comment, on lines of its own.
fn comment(text: &str, out: &mut String) {
    for line in comments::told(text) {
        match line.strip_prefix("iot:").map(str::trim) {
            Some(own) if own.starts_with(['=', '>']) => out.push_str(&format!("{own}\n")),
            Some(own) if own.starts_with(';') => out.push_str(&format!("#{}\n", &own[1..])),
            _ => out.push_str(&format!("# {line}\n")),
        }
    }
}

struct Writer<'p> {
    program: &'p Program,
    names: &'p Names,
    text: &'p str,
    /// The program has the arithmetic and timing of the other system.
    is_own: bool,
}

impl Writer<'_> {
    fn network(&self, network: &Network) -> Result<String, String> {
        if network.blocks.len() > MOST_IN_RUNG {
            return Err(format!("a rung has at most {MOST_IN_RUNG} elements there"));
        }
        let circuit = series_parallel(network).ok_or("it is not made of series and branches alone")?;
        self.series(network, &circuit, 0)
    }

    /// A part as what is between `;`.
    fn series(&self, network: &Network, circuit: &Circuit<usize>, depth: usize) -> Result<String, String> {
        match circuit {
            Circuit::Series(parts) if !parts.is_empty() => self.parts(network, parts, " ; ", depth),
            other => self.one(network, other, depth),
        }
    }

    fn parts(
        &self,
        network: &Network,
        parts: &[Circuit<usize>],
        between: &str,
        depth: usize,
    ) -> Result<String, String> {
        if parts.len() > MOST_PARTS {
            return Err(format!("at most {MOST_PARTS} parts are next to each other there"));
        }
        let texts: Result<Vec<String>, String> =
            parts.iter().map(|part| self.one(network, part, depth)).collect();
        Ok(texts?.join(between))
    }

    /// A part as what is between `;` or between `|`.
    fn one(&self, network: &Network, circuit: &Circuit<usize>, depth: usize) -> Result<String, String> {
        if depth == DEEPEST {
            return Err("its branches are nested too deep".to_owned());
        }
        match circuit {
            Circuit::Element(block) => self.element(&network.blocks[*block]),
            Circuit::Series(parts) if parts.is_empty() => Ok("()".to_owned()),
            Circuit::Series(_) => Ok(format!("( {} )", self.series(network, circuit, depth + 1)?)),
            Circuit::Parallel(branches) => {
                let is_nested = |branch: &Circuit<usize>| matches!(branch, Circuit::Parallel(_));
                let texts: Result<Vec<String>, String> = branches
                    .iter()
                    .map(|branch| {
                        let text = self.one(network, branch, depth + 1)?;
                        Ok(if is_nested(branch) {
                            format!("( {text} )")
                        } else {
                            text
                        })
                    })
                    .collect();
                let texts = texts?;
                if texts.len() > MOST_PARTS {
                    return Err(format!("at most {MOST_PARTS} parts are next to each other there"));
                }
                Ok(texts.join(" | "))
            }
        }
    }

    fn element(&self, block: &Block) -> Result<String, String> {
        let written = &self.text[block.location.range];
        if let Some(element) = kept(written) {
            return Ok(element);
        }
        self.block(block).map_err(|why| format!("`{written}`: {why}"))
    }

    /// The element of a block.
    fn block(&self, block: &Block) -> Result<String, String> {
        let BlockKind::Instruction(row) = block.kind else {
            return Err("the IoT ladder language has no blocks of one's own".to_owned());
        };
        let unknown = || format!("the IoT ladder language has no {} like this", row.block());
        let arguments: Vec<&Argument> = block.arguments.iter().map(|bound| &bound.argument).collect();
        if let (Op::Contact, [Argument::Value(value)]) = (row.op, &arguments[..])
            && matches!(value.kind, ExprKind::Read(Operand::System(SystemTag::On)))
        {
            return Ok("()".to_owned());
        }
        if matches!(row.op, Op::Ton | Op::Tof | Op::Ctu | Op::Ctd) {
            return self.state(row.op, block);
        }
        if let (Op::Res | Op::ResetCoil, [Argument::State(tag)]) = (row.op, &arguments[..]) {
            return Ok(format!("RESET {}", self.names.of(*tag)?));
        }
        let resets = match (row.op, &arguments[..]) {
            (Op::ResetCoil, [Argument::Place(_, ty)]) => ty.is_number(),
            (Op::Mov, [Argument::Place(_, ty), Argument::Value(value)]) => {
                ty.is_number() && constant(value) == Some(0)
            }
            _ => false,
        };
        if resets {
            return Ok(format!("RESET {}", self.argument(arguments[0])?));
        }
        let found = ROWS.iter().find(|word| match word.form {
            Form::Contact(op) | Form::Coil(op) | Form::Compare(op) | Form::Calculate(op) => op == row.op,
            Form::Not => row.op == Op::Not,
            Form::Assign => row.op == Op::Mov,
            Form::ScanTime => row.op == Op::Scantime,
            Form::Reset | Form::Timer(_) | Form::Counter(_) => false,
        });
        let word = found.ok_or_else(unknown)?;
        let (least, most) = word.operands();
        if !(least..=most).contains(&arguments.len()) {
            return Err(unknown());
        }
        let mut line = word.word.to_owned();
        for argument in arguments {
            line.push(' ');
            line.push_str(&self.argument(argument)?);
        }
        Ok(line)
    }

    /// A timer or counter.
    fn state(&self, op: Op, block: &Block) -> Result<String, String> {
        if !self.is_own && matches!(op, Op::Tof | Op::Ctd) {
            return Err(
                "there it does something else: it counts while power reaches it, from the first rise on"
                    .to_owned(),
            );
        }
        let (mut state, mut preset, mut base, mut start) = (None, None, 100_000_000, None);
        for bound in &block.arguments {
            let name = bound.operand.map_or("", |operand| operand.name);
            match (&bound.argument, name) {
                (Argument::State(tag), _) => state = Some(*tag),
                (Argument::Value(value), "PT" | "PV") => preset = Some(value),
                (Argument::Value(value), "B") => {
                    base = constant(value).ok_or("the time base is not a number")?;
                }
                (Argument::Value(value), "AC") => {
                    start = Some(constant(value).ok_or("what it counts from is not a number")?);
                }
                (_, name) => {
                    return Err(format!(
                        "there it has no `{name}`; a reset is a rung of its own: (RES)"
                    ));
                }
            }
        }
        let (Some(state), Some(preset)) = (state, preset) else {
            return Err("it is not whole".to_owned());
        };
        let word = if op == Op::Tof { "TOF" } else { by_word(op) };
        let mut line = format!("{word} {}", self.names.of(state)?);
        let is_timer = matches!(op, Op::Ton | Op::Tof);
        let number = match (constant(preset), self.names.preset(state)) {
            // In the profile a plain integer counts the base; elsewhere it is milliseconds.
            (Some(number), _) if is_timer && (preset.ty == Scalar::Time || !self.is_own) => {
                let nanoseconds = if preset.ty == Scalar::Time {
                    number
                } else {
                    number * 1_000_000
                };
                if base <= 0 || nanoseconds % base != 0 {
                    return Err(format!(
                        "its time is not a multiple of the time base of {} ms",
                        base / 1_000_000
                    ));
                }
                nanoseconds / base
            }
            (Some(number), _) => number,
            (None, Some(first)) => first,
            (None, None) => return Err("its preset is a number, or a tag of its own".to_owned()),
        };
        line.push_str(&format!(" {number}"));
        if is_timer {
            if base % 1_000_000 != 0 {
                return Err("the time base is whole milliseconds".to_owned());
            }
            line.push_str(&format!(" {}", base / 1_000_000));
        }
        if let Some(start) = start.filter(|start| *start != 0) {
            line.push_str(&format!(" {start}"));
        }
        Ok(line)
    }

    fn argument(&self, argument: &Argument) -> Result<String, String> {
        match argument {
            Argument::Value(value) => self.value(value),
            Argument::Place(place, _) => self.place(place),
            _ => Err("there operands are single variables and numbers".to_owned()),
        }
    }

    fn value(&self, value: &Expr) -> Result<String, String> {
        match &value.kind {
            ExprKind::Read(Operand::Tag(tag)) if self.program.tags[tag.0 as usize].constant => {
                let initial = self.program.tags[tag.0 as usize].initial.first();
                literal(initial.unwrap_or(&Value::Int(0)), value.ty)
            }
            ExprKind::Read(place) => self.place(place),
            // A number that is checked as a bit.
            ExprKind::Pass(inside) | ExprKind::Compare(Op::Ne, inside, _) => self.value(inside),
            ExprKind::Constant(constant) => literal(constant, value.ty),
            _ => Err("there operands are single variables and numbers".to_owned()),
        }
    }

    fn place(&self, place: &Operand) -> Result<String, String> {
        match place {
            Operand::Tag(tag) => self.names.of(*tag),
            Operand::Member(tag, member) => {
                let name = self.names.of(*tag)?;
                Ok(format!("{name}:{}", self.member(*tag, *member)?))
            }
            _ => Err("there operands are single variables and numbers".to_owned()),
        }
    }

    fn member(&self, tag: TagId, member: Member) -> Result<&'static str, String> {
        let is_timer = self.names.is_timer(tag);
        Ok(match member {
            Member::Et | Member::Cv => "AC",
            Member::Pt | Member::Pv => "PRE",
            Member::Q | Member::Qu => "DN",
            Member::In if is_timer => "EN",
            Member::Timing if is_timer => "TT",
            Member::Changed if !is_timer => "CC",
            _ => return Err("there timers and counters have no such member".to_owned()),
        })
    }
}

fn by_word(op: Op) -> &'static str {
    let is = |form: Form| matches!(form, Form::Timer(own) | Form::Counter(own) if own == op);
    ROWS.iter().find(|row| is(row.form)).map_or("", |row| row.word)
}

fn constant(value: &Expr) -> Option<i64> {
    match &value.kind {
        ExprKind::Constant(Value::Int(number)) => Some(*number),
        ExprKind::Pass(inside) => constant(inside),
        _ => None,
    }
}

/// A literal of the notation.
fn literal(value: &Value, ty: Scalar) -> Result<String, String> {
    match value {
        Value::Bool(on) => Ok(u8::from(*on).to_string()),
        Value::Int(_) if ty == Scalar::Time => Err("there a time is a plain count".to_owned()),
        Value::Int(number) if i32::try_from(*number).is_ok() => Ok(number.to_string()),
        Value::Real(number) => Ok(real_text(*number, ty)),
        _ => Err("there are only numbers of 32 bits there".to_owned()),
    }
}
