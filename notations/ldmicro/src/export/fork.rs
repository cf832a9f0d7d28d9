//! What only LDmicro's fork has, on its way back.

use super::Exporter;
use crate::field;
use crate::fork::made::{Made, definition_in};
use crate::fork::outside::Outside;
use crate::fork::{RESOLUTION, table};
use crate::kept::{UNSETTLED, after};
use crate::model::Version;
use ladder_analysis::program::{Argument, Block, BlockKind, Expr, ExprKind, Place as Operand};
use ladder_analysis::values::value::Value;
use ladder_instructions::Op;
use ladder_notation::foreign_text_of;

/// In the place of a label: the end of the subprogram that the jump is in. None is the end of the program.
pub(super) const OWN_END: &str = "\0";

const FOREIGN: &str = "LDmicro has no blocks of one's own";

impl Exporter<'_> {
    /// Notes what the blocks of the fork say of the whole program.
    pub(super) fn fork(&mut self) {
        let program = self.input.program;
        self.fork.made = program
            .blocks
            .iter()
            .map(|block| self.definition_of(&block.name))
            .collect();
        let networks = program.networks.iter();
        for block in networks.flat_map(|network| &network.blocks) {
            match block.kind {
                BlockKind::User(index) => {
                    if let Some(Ok(Made::Counter(_))) = self.fork.made.get(index)
                        && let Ok((name, init)) = self.counter(block)
                    {
                        self.fork.resets.entry(name).or_insert(init);
                    }
                }
                BlockKind::Instruction(row)
                    if row.op == Op::Lbl && self.was(block).is_some_and(|was| was.starts_with("RUNG ")) =>
                {
                    let label = self.label(block).to_owned();
                    self.fork.numbered.insert(label);
                }
                BlockKind::Instruction(_) => {}
            }
        }
    }

    /// A counter of the fork and where it begins.
    fn counter(&self, block: &Block) -> Result<(String, String), String> {
        let name = self.given(block, 0)?;
        let init = match block.arguments.len() {
            3.. => self.given(block, 2)?,
            _ => self.initial(block).to_string(),
        };
        Ok((name, init))
    }

    fn given(&self, block: &Block, index: usize) -> Result<String, String> {
        let bound = block.arguments.get(index).ok_or("an operand is missing")?;
        self.argument(&bound.argument)
    }

    /// The value that the tag begins with that a block changes.
    fn initial(&self, block: &Block) -> i64 {
        match block.arguments.first().map(|bound| &bound.argument) {
            Some(Argument::Place(Operand::Tag(tag), _)) => {
                match self.input.program.tags[tag.0 as usize].initial.first() {
                    Some(Value::Int(number)) => *number,
                    _ => 0,
                }
            }
            _ => 0,
        }
    }

    /// The line of a block that the program brought along.
    pub(super) fn made(&self, block: &Block, index: usize) -> Result<String, String> {
        let name = &self.input.program.blocks[index].name;
        if let Some(line) = self.unread(block, name) {
            return line;
        }
        let made = match self.fork.made.get(index) {
            Some(made) => made.clone()?,
            None => return Err(FOREIGN.to_owned()),
        };
        let given: Result<Vec<String>, String> = (0..block.arguments.len())
            .map(|index| self.given(block, index))
            .collect();
        Ok(made.line(&given?, self.initial(block), self.input.dialect))
    }

    /// The line of an element that is not read, if a block of this name is one: the comment above its definition begins
    /// with its word.
    fn unread(&self, block: &Block, name: &str) -> Option<Result<String, String>> {
        let definition = definition_in(self.input.text, &format!("[{name}]"))?;
        if !definition
            .lines()
            .any(|line| line.starts_with("# ladder: unread"))
        {
            return None;
        }
        let before = &self.input.text[..self.input.text.find(definition)?];
        let told = before.trim_end().lines().next_back().unwrap_or_default();
        let word = told
            .trim_start_matches(['#', ' '])
            .split(": ")
            .next()
            .unwrap_or_default();
        let Some(outside) = Outside::of(word) else {
            let why = format!("the comment above `{name}` does not say which element it is");
            return Some(Err(why));
        };
        let fields = match (foreign_text_of(definition), block.arguments.first()) {
            (Some(text), _) => Ok(text),
            (None, Some(bound)) => fields(&bound.argument),
            (None, None) => return Some(Ok(outside.word.to_owned())),
        };
        Some(fields.map(|fields| format!("{} {fields}", outside.word)))
    }

    /// What a block of this name is an element of, if it is defined so.
    fn definition_of(&self, name: &str) -> Result<Made, String> {
        let made = Made::named(name).ok_or(FOREIGN)?;
        let text = definition_in(self.input.text, &made.head()).ok_or(FOREIGN)?;
        if !made.is_defined_by(text) {
            return Err(format!("`{name}` is defined otherwise than LDmicro's own"));
        }
        Ok(made)
    }

    /// The line of an instruction that LDmicro 2.2 does not have.
    pub(super) fn forks(&self, block: &Block, op: Op) -> Result<Option<String>, String> {
        let Some(line) = self.forks_line(block, op)? else {
            return Ok(None);
        };
        if self.input.dialect.version == Version::V01 && !self.input.is_import {
            return Err(
                "LDmicro 2.2 has no such element; to write the files of its fork, begin the program with \
                 `# ldmicro: LDmicro0.2 #`"
                    .to_owned(),
            );
        }
        Ok(Some(line))
    }

    fn forks_line(&self, block: &Block, op: Op) -> Result<Option<String>, String> {
        let count = block.arguments.len();
        let first = block.arguments.first().map(|bound| &bound.argument);
        let label = self.label(block);
        Ok(Some(match op {
            Op::Contact | Op::NegatedContact | Op::SetCoil | Op::ResetCoil => {
                let Some(
                    Argument::Place(place, _)
                    | Argument::Value(Expr {
                        kind: ExprKind::Read(place),
                        ..
                    }),
                ) = first
                else {
                    return Ok(None);
                };
                let Operand::Bit(variable, _, bit) = place else {
                    return Ok(None);
                };
                let word = match op {
                    Op::Contact => "IF_BIT_SET",
                    Op::NegatedContact => "IF_BIT_CLEAR",
                    Op::SetCoil => "SET_BIT",
                    _ => "CLEAR_BIT",
                };
                format!("{word} {} {bit}", self.place_name(variable)?)
            }
            Op::Pwm if count == 3 => {
                let (duty, frequency) = (self.given(block, 0)?, self.given(block, 1)?);
                let number = self.given(block, 2)?;
                if !field::is_literal(&frequency) || !field::is_literal(&number) {
                    return Err("LDmicro's pulse outputs and their frequencies are fixed".to_owned());
                }
                let name = self.pulses.get(&number).cloned();
                let name = name.unwrap_or_else(|| format!("P{number}"));
                format!("SET_PWM {duty} {frequency} {name} {RESOLUTION}")
            }
            Op::Lbl if self.fork.numbered.contains(label) => format!("{UNSETTLED}LABEL {label}"),
            Op::Jmp if self.fork.numbered.contains(label) => {
                let was = self.was(block).unwrap_or_default();
                format!("{UNSETTLED}GOTO {label} {was}")
            }
            Op::Lbl => format!("LABEL {label}"),
            Op::Jmp => format!("GOTO {label}"),
            Op::Call => format!("GOSUB {label}"),
            Op::Ret => match self.was(block) {
                Some(was) if was.starts_with("GOTO ") => {
                    let end = if self.in_function(block) { OWN_END } else { "" };
                    format!("{UNSETTLED}GOTO {end} {was}")
                }
                _ if self.in_function(block) => "RETURN".to_owned(),
                _ => format!("{UNSETTLED}GOTO  "),
            },
            op => {
                let Some(row) = table::ROWS.iter().find(|row| row.is(op, count)) else {
                    return Ok(None);
                };
                let given: Result<Vec<String>, String> =
                    (0..count).map(|index| self.given(block, index)).collect();
                [&[row.word.to_owned()][..], &given?].concat().join(" ")
            }
        }))
    }

    /// The label or function that a block names.
    fn label(&self, block: &Block) -> &str {
        let range = block.arguments.first().map(|bound| bound.range);
        range.map_or("", |range| self.input.text[range].trim())
    }

    /// What the comment right after a block says that it was.
    fn was(&self, block: &Block) -> Option<String> {
        let rest = self.input.text[usize::from(block.location.range.end())..].trim_start_matches(['-', ' ']);
        let length = rest.strip_prefix('#')?.find('#')? + 2;
        after(&rest[..length], "was:")
    }

    fn in_function(&self, block: &Block) -> bool {
        let first = self.input.program.networks.get(self.input.program.main.end);
        let first = first.filter(|network| network.location.file == 0);
        first.is_some_and(|first| block.location.range.start() >= first.location.range.start())
    }
}

/// The text that holds the fields of an element that is not read.
fn fields(argument: &Argument) -> Result<String, String> {
    match argument {
        Argument::Value(Expr {
            kind: ExprKind::Constant(Value::Text(bytes)),
            ..
        }) if !bytes.iter().any(u8::is_ascii_control) => Ok(String::from_utf8_lossy(bytes).into_owned()),
        _ => Err("the fields of such an element are fixed".to_owned()),
    }
}
