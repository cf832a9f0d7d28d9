//! From a program to the draft.

use super::blocks::row_of;
use ladder_analysis::Analysis;
use ladder_analysis::networks::NetworkAt;
use ladder_analysis::program::{
    Argument, Block, BlockKind, Expr, ExprKind, Member, Place as Operand, Program, Role, Tag, TagId,
};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::{Value, real_text};
use ladder_format::{ElementKind, Options, Sketch, display_width};
use ladder_instructions::Op;
use ladder_notation::{LineColumn, Lines, Report, WriteError, Writing, comments, no_program};
use ladder_syntax::Item;
use ladder_syntax::wiring::PartKind;
use std::collections::{HashMap, HashSet};

/// Writes all networks that the draft can say; the others stay as comments.
pub(super) fn write(analysis: &Analysis) -> Result<Writing, WriteError> {
    let Some(program) = analysis.program() else {
        return Err(no_program(analysis, &analysis.context.parse.to_string()));
    };
    let text = analysis.context.parse.to_string();
    let lines = Lines::of(&text);
    let mut writer = Writer {
        program,
        report: Report::default(),
        taken: program
            .tags
            .iter()
            .map(|tag| tag.name.to_ascii_lowercase())
            .collect(),
    };
    let mut parts = Vec::new();
    let mut networks = program
        .networks
        .iter()
        .filter(|network| network.location.file == 0)
        .zip(&analysis.context.networks);
    let parse = &analysis.context.parse;
    let mut above = Vec::new();
    for item in &parse.structure().items {
        let lines_of = match *item {
            Item::Decoration(line) => line..line + 1,
            Item::Network(number) => parse.structure().networks[number].lines.clone(),
            _ => continue,
        };
        for comment in lines_of.flat_map(|line| comments::on_line(parse, line)) {
            above.extend(comments::told(&comment).map(str::to_owned));
        }
        let Item::Network(_) = item else { continue };
        let Some((network, facts)) = networks.next() else {
            break;
        };
        let range = network.location.range;
        let place = lines.place(&text, range.start().into());
        let blocks: Result<HashMap<u32, String>, String> = network
            .blocks
            .iter()
            .map(|block| {
                let start = u32::from(block.location.range.start());
                writer.block(block).map(|text| (start, text))
            })
            .collect();
        let drawn = match blocks {
            Ok(blocks) => {
                writer.report.translated(place, "network");
                Ok(drawing(facts, &blocks))
            }
            Err(why) => {
                writer.report.refused(place, "network", why);
                Err(&text[range])
            }
        };
        parts.push((std::mem::take(&mut above), drawn));
    }
    let mut out = writer.headers();
    for (comments, drawn) in parts {
        out.push('\n');
        for line in comments {
            out.push_str(&format!("// {line}\n"));
        }
        match drawn {
            Ok((sketch, texts)) => {
                let layout = sketch.lay_out(&Options::default());
                layout.draw(|n| &texts[n], "\n", &mut out);
            }
            Err(refused) => {
                for line in refused.lines() {
                    out.push_str(&format!("// {line}\n"));
                }
            }
        }
    }
    if !above.is_empty() {
        out.push('\n');
        for line in above {
            out.push_str(&format!("// {line}\n"));
        }
    }
    Ok(Writing {
        bytes: out.into_bytes(),
        report: writer.report,
        companions: Vec::new(),
    })
}

/// A network with other blocks, given by where the old ones begin, and the texts of its elements.
fn drawing(facts: NetworkAt<'_>, blocks: &HashMap<u32, String>) -> (Sketch, Vec<String>) {
    let mut sketch = Sketch::new();
    let mut texts = Vec::new();
    let mut block = facts.blocks();
    for rung in &facts.wiring.rungs {
        sketch.begin_rung();
        let mut segment = None;
        for part in &rung.parts {
            let kind = match part.kind {
                PartKind::LeftRail => ElementKind::LeftRail,
                PartKind::RightRail => ElementKind::RightRail,
                PartKind::Down => ElementKind::Down,
                PartKind::Up => ElementKind::Up,
                PartKind::Block => ElementKind::Condition,
                _ => continue,
            };
            let text = match part.kind {
                PartKind::Block => block
                    .next()
                    .and_then(|block| blocks.get(&u32::from(block.range().start())))
                    .cloned()
                    .unwrap_or_default(),
                _ => String::new(),
            };
            let joined = segment.is_some() && segment == part.segment;
            segment = part.segment;
            sketch.push(kind, joined, display_width(&text).max(1));
            texts.push(text);
        }
    }
    (sketch, texts)
}

struct Writer<'p> {
    program: &'p Program,
    report: Report,
    /// The names of tags, and those made up for blocks that want one.
    taken: HashSet<String>,
}

impl Writer<'_> {
    /// A block in the draft's spelling.
    fn block(&mut self, block: &Block) -> Result<String, String> {
        let BlockKind::Instruction(row) = block.kind else {
            return Err("the draft has no blocks of one's own".to_owned());
        };
        if matches!(row.op, Op::Ton | Op::Tof | Op::Rto | Op::Ctu | Op::Ctd) {
            return self.state(row.mnemonic, block);
        }
        let own = row_of(row.op).filter(|own| own.3 == block.arguments.len());
        let unknown = || format!("the draft has no {} as it is here", row.block());
        let (_, head, like, count) = own.ok_or_else(unknown)?;
        let values = block.arguments.iter().map(|bound| self.argument(&bound.argument));
        let mut operands = values.collect::<Result<Vec<_>, _>>()?;
        // The result comes last in the draft.
        if count == 3 {
            operands.rotate_left(1);
        }
        if let Some(name) = like {
            operands.insert(0, self.fresh(name));
        }
        Ok(format!("{head}<{}>", operands.join("><")))
    }

    fn state(&mut self, mnemonic: &str, block: &Block) -> Result<String, String> {
        let (mut tag, mut preset, mut reset) = (None, None, None);
        for bound in &block.arguments {
            let name = bound.operand.map_or("", |operand| operand.name);
            match (&bound.argument, name) {
                (Argument::State(id), _) => tag = Some(*id),
                (value, "PT" | "PV") => preset = Some(self.argument(value)?),
                (value, "R") => reset = Some(self.argument(value)?),
                _ => return Err(format!("the draft's {mnemonic} has no `{name}`")),
            }
        }
        let (Some(tag), Some(preset)) = (tag, preset) else {
            return Err(format!("the {mnemonic} is not whole"));
        };
        let name = self.tag(tag).name.clone();
        let is_timer = mnemonic.starts_with('T') || mnemonic == "RTO";
        let reached = format!("{name}_{}", if is_timer { "time" } else { "count" });
        let reset = reset.unwrap_or_else(|| "0".to_owned());
        Ok(format!("[{mnemonic}]<{name}><{reset}><{reached}><{preset}>"))
    }

    fn argument(&mut self, argument: &Argument) -> Result<String, String> {
        match argument {
            Argument::Value(value) => self.value(value),
            Argument::Place(place, _) => self.place(place),
            _ => Err("the draft has single tags and numbers as operands".to_owned()),
        }
    }

    fn value(&mut self, value: &Expr) -> Result<String, String> {
        match &value.kind {
            ExprKind::Read(place) => self.place(place),
            ExprKind::Pass(inside) => self.value(inside),
            ExprKind::Constant(Value::Bool(on)) => Ok(u8::from(*on).to_string()),
            ExprKind::Constant(Value::Int(nanoseconds)) if value.ty == Scalar::Time => {
                match nanoseconds % 1_000_000 {
                    0 => Ok((nanoseconds / 1_000_000).to_string()),
                    _ => Err("the draft counts whole milliseconds".to_owned()),
                }
            }
            ExprKind::Constant(Value::Int(number)) => Ok(number.to_string()),
            ExprKind::Constant(Value::Real(number)) => Ok(real_text(*number, value.ty)),
            _ => Err("the draft has single tags and numbers as operands".to_owned()),
        }
    }

    fn place(&mut self, place: &Operand) -> Result<String, String> {
        match place {
            Operand::Tag(id) => Ok(self.tag(*id).name.clone()),
            Operand::Element(id, index) => {
                let index = self.value(index)?;
                Ok(format!("{}[{index}]", self.tag(*id).name))
            }
            Operand::Member(id, member) => {
                let name = &self.tag(*id).name;
                match member {
                    Member::Q => Ok(name.clone()),
                    Member::Et => Ok(format!("{name}_time")),
                    Member::Cv => Ok(format!("{name}_count")),
                    _ => Err(format!("the draft cannot read that of `{name}`")),
                }
            }
            _ => Err("the draft has single tags and numbers as operands".to_owned()),
        }
    }

    fn tag(&self, id: TagId) -> &Tag {
        &self.program.tags[id.0 as usize]
    }

    /// A new name like this one.
    fn fresh(&mut self, like: &str) -> String {
        let mut number = 1;
        loop {
            let name = format!("{like}{number}");
            if self.taken.insert(name.clone()) {
                return name;
            }
            number += 1;
        }
    }

    /// `IN = { .. }` and the others.
    fn headers(&mut self) -> String {
        let mut sections: [(&str, Vec<String>); 3] =
            [("IN", Vec::new()), ("OUT", Vec::new()), ("VAR", Vec::new())];
        for tag in &self.program.tags {
            // Timers and counters need no header: their blocks name them.
            if matches!(tag.ty, Type::State(_)) {
                continue;
            }
            let (section, letter) = match tag.role {
                Role::Input => (0, Some('I')),
                Role::Output => (1, Some('O')),
                Role::Internal => (2, None),
            };
            match ty(&tag.ty, letter) {
                Ok(ty) => sections[section].1.push(format!("{ty} {}", tag.name)),
                Err(why) => self
                    .report
                    .approximated(LineColumn::START, format!("tag `{}`", tag.name), why),
            }
            if !tag.initial.is_empty() {
                let why = "the draft has no initial values";
                self.report
                    .approximated(LineColumn::START, format!("tag `{}`", tag.name), why);
            }
        }
        let mut out = String::new();
        for (name, entries) in sections {
            if !entries.is_empty() {
                out.push_str(&format!("{name} = {{{}}}\n", entries.join(", ")));
            }
        }
        out
    }
}

/// A type in the draft's words. Inputs and outputs have types of their own.
fn ty(ty: &Type, letter: Option<char>) -> Result<String, String> {
    let (scalar, length) = match ty {
        Type::Scalar(scalar) => (*scalar, None),
        Type::Array { element, first, last } if *first == 0 => (*element, Some(last - first + 1)),
        Type::Array { .. } => return Err("an array of the draft begins at 0".to_owned()),
        Type::State(_) | Type::Compound(_) => return Err("the draft has no such type".to_owned()),
    };
    let word = match (scalar, letter) {
        (Scalar::Bool, Some(letter)) => format!("D{letter}"),
        (Scalar::Real | Scalar::Lreal, Some(letter)) => format!("A{letter}"),
        (Scalar::String(_), Some(letter)) => format!("S{letter}"),
        (Scalar::Bool, None) => "BOOL".to_owned(),
        (Scalar::Real | Scalar::Lreal, None) => "FLOAT".to_owned(),
        (Scalar::String(_), None) => "STRING".to_owned(),
        (Scalar::Sint | Scalar::Int | Scalar::Dint | Scalar::Usint | Scalar::Uint, _) => "INT".to_owned(),
        _ => return Err("the draft has no such type".to_owned()),
    };
    Ok(match length {
        None => word,
        Some(length) => format!("{word}[{length}]"),
    })
}
