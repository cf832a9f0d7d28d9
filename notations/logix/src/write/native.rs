//! User-defined blocks: those that the reader brings along are instructions there, all others Add-On Instructions.

use super::names::Kind;
use super::rung::{Series, it};
use super::unread::UnreadPart;
use super::{Result, Writer};
use crate::blocks::{Blocks, ONS_BIT, OTE_BIT};
use crate::types::Elem;
use ladder_analysis::context::Context;
use ladder_analysis::program::{Argument, Block, Bound, Expr, ExprKind, ParameterKind};
use ladder_analysis::values::types::Scalar;
use ladder_notation::Unwritable;
use ladder_syntax::{LineKind, Name};
use std::collections::HashSet;

/// What a user-defined block is there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Known {
    /// An instruction that the reader wrote as a block.
    Native(&'static str),
    /// What is not read here.
    Unread(UnreadPart),
    /// An Add-On Instruction; its name there.
    Own(String),
    /// It cannot be one; why.
    Not(String),
}

/// The definition without what layout changes.
fn bare(text: &str) -> String {
    let begin = text.find("FUNCTION_BLOCK").unwrap_or(0);
    let kept = text[begin..].chars().filter(|c| !c.is_whitespace() && *c != '-');
    kept.flat_map(char::to_lowercase).collect()
}

/// The instruction whose block the reader writes in this way.
fn native(name: &str, definition: &str) -> Option<&'static str> {
    let name = name.trim_start_matches('$');
    let (own, suffix) = Blocks::named(name)?;
    // Of structured text: rungs have no such instruction.
    if ["TONR", "RTOR", "SCL"].contains(&own) {
        return None;
    }
    let mut blocks = Blocks::default();
    if [OTE_BIT, ONS_BIT].contains(&own) {
        let ty = if suffix.is_empty() { "DINT" } else { suffix };
        blocks.on_word(own, Elem::named(ty)?);
    } else if suffix.is_empty() {
        blocks.plain(own);
    } else {
        let digits = suffix.find(|c: char| c.is_ascii_digit())?;
        let (ty, size) = suffix.split_at(digits);
        let elem = match ty {
            "" => Elem::Dint,
            "STRING" => return native_of_texts(own, size, definition),
            ty => Elem::named(ty)?,
        };
        blocks.on_array(own, size.parse().ok()?, elem);
    }
    same(&blocks, definition).then_some(own)
}

/// Of `STRING824` it is not known where the length ends.
fn native_of_texts(own: &'static str, digits: &str, definition: &str) -> Option<&'static str> {
    let mut ways = (1..digits.len()).filter_map(|at| digits.split_at_checked(at));
    let is_one = ways.any(|(length, size)| {
        let mut blocks = Blocks::default();
        let (Ok(length), Ok(size)) = (length.parse(), size.parse()) else {
            return false;
        };
        blocks.on_array(own, size, Elem::String(length));
        same(&blocks, definition)
    });
    is_one.then_some(own)
}

fn same(blocks: &Blocks, definition: &str) -> bool {
    let bare_definition = bare(definition);
    blocks.texts().any(|text| bare(text) == bare_definition)
}

/// The text of some lines.
fn lines_text(context: &Context, lines: std::ops::Range<usize>) -> String {
    let all = context.parse.lines();
    lines.map(|line| all[line].text()).collect()
}

/// The definitions of a file that the reader writes in this way, by their numbers.
pub(super) fn natives(context: &Context) -> HashSet<usize> {
    let own = context.user_blocks[..context.own_blocks].iter().enumerate();
    let natives = own.filter(|(number, block)| {
        let lines = context.parse.structure().blocks[*number].lines.clone();
        native(&block.name, &lines_text(context, lines)).is_some()
    });
    natives.map(|(number, _)| number).collect()
}

impl Writer<'_> {
    /// Finds out what each block is.
    pub(super) fn know_blocks(&mut self, unwritable: &Unwritable) {
        let context = &self.input.analysis.context;
        for (number, block) in self.input.program.blocks.iter().enumerate() {
            let of = context
                .user_blocks
                .iter()
                .position(|own| own.name.eq_ignore_ascii_case(&block.name));
            let Some(of) = of.filter(|of| *of < context.own_blocks) else {
                self.facts
                    .known
                    .insert(number, Known::Not("it is defined in another file".to_owned()));
                continue;
            };
            if let Some(why) = unwritable.get(&Name::new(&block.name)) {
                self.facts.known.insert(number, Known::Not(why.clone()));
                continue;
            }
            let lines = context.parse.structure().blocks[of].lines.clone();
            let text = lines_text(context, lines.clone());
            let known = match native(&block.name, &text) {
                Some(own) => Known::Native(own),
                None => match UnreadPart::of(context, lines.start, &text) {
                    Some(part) => Known::Unread(part),
                    None if block.parameters.iter().any(|(tag, kind)| {
                        let ty = self.input.program.tags[tag.0 as usize].ty;
                        *kind != ParameterKind::InOut
                            && !ty.scalar().is_some_and(|ty| !ty.is_string() && !ty.is_date())
                    }) || !block.parts.iter().all(Vec::is_empty)
                        && block
                            .parameters
                            .iter()
                            .zip(&block.parts)
                            .any(|((_, kind), parts)| *kind != ParameterKind::InOut && !parts.is_empty()) =>
                    {
                        Known::Not("there only in-outs are texts, structures or arrays".to_owned())
                    }
                    None => {
                        let original = self.original(lines.start, &block.name);
                        let name = match original {
                            Some(original) => self.names.spell(Kind::Type, &original),
                            None => self.names.spell(Kind::Type, &block.name),
                        };
                        self.names.stands_for(Kind::Type, &block.name, &name);
                        Known::Own(name)
                    }
                },
            };
            self.facts.body_of.insert(number, of);
            self.facts.known.insert(number, known);
        }
    }

    /// The name that an Add-On Instruction had: what the reader says above its definition.
    fn original(&self, header: usize, block: &str) -> Option<String> {
        let lines = self.input.analysis.context.parse.lines();
        let above = (0..header)
            .rev()
            .take_while(|line| matches!(lines[*line].kind, LineKind::Comment));
        let names = above.filter_map(|line| {
            let told = lines[line].text().trim().strip_prefix("# Add-On Instruction ")?;
            Some(told.trim_end_matches('#').trim().to_owned())
        });
        let letters = |name: &str| {
            let kept = name.chars().filter(char::is_ascii_alphanumeric);
            kept.flat_map(char::to_lowercase).collect::<String>()
        };
        let mut names = names.filter(|name| letters(name) == letters(block));
        names.next()
    }

    /// The type of a block's instances.
    ///
    /// # Errors
    ///
    /// It cannot be an Add-On Instruction.
    pub(super) fn block_type(&mut self, name: &str) -> Result<String> {
        let all = &self.input.program.blocks;
        let number = all.iter().position(|block| block.name.eq_ignore_ascii_case(name));
        match number.and_then(|number| self.facts.known.get(&number)) {
            Some(Known::Not(why)) => Err(why.clone()),
            _ => Ok(self.names.spell(Kind::Type, name)),
        }
    }

    /// A user-defined block on a rung.
    pub(super) fn user(&mut self, user: usize, block: &Block) -> Result<Series> {
        match self.facts.known.get(&user).cloned() {
            Some(Known::Native(own)) => self.native(own, block),
            Some(Known::Unread(part)) => self.unread_call(&part, block),
            Some(Known::Own(name)) => self.call(user, &name, block),
            Some(Known::Not(why)) => Err(why),
            None => Err("its definition is not in the file".to_owned()),
        }
    }

    fn native(&mut self, own: &'static str, block: &Block) -> Result<Series> {
        let mut texts = Vec::new();
        for bound in &block.arguments {
            texts.push(match own {
                // How often is none of it.
                "FAL" | "FSC" | "FOR" if matches!(bound.argument, Argument::Place(..)) => String::new(),
                _ => self.argument(bound)?,
            });
        }
        let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
        Ok(vec![match (own, &texts[..]) {
            ("TON" | "TOF" | "RTO" | "CTU" | "CTD", [state]) => it(own, &[state, "?", "?"]),
            ("TON" | "TOF" | "RTO", [..]) => {
                return Err("its time base is not a millisecond, which timers count there".to_owned());
            }
            ("TimerRES" | "CounterRES" | "ControlRES", [state]) => it("RES", &[state]),
            ("ONS" | "OSR" | "OSF", all) => it(own, all),
            (OTE_BIT, [w, bit]) => it("OTE", &[&format!("{w}.[{bit}]")]),
            (ONS_BIT, [w, bit]) => it("ONS", &[&format!("{w}.[{bit}]")]),
            ("BSL" | "BSR", [array, control, bit]) => it(own, &[&begin(array), control, bit, "?"]),
            ("FFL" | "LFL", [value, array, control]) => it(own, &[value, &begin(array), control, "?", "?"]),
            ("FFU" | "LFU", [array, value, control]) => it(own, &[&begin(array), value, control, "?", "?"]),
            ("SQI" | "SQO", [array, mask, value, control]) => {
                it(own, &[&begin(array), mask, value, control, "?", "?"])
            }
            ("SQL", [array, value, control]) => it(own, &[&begin(array), value, control, "?", "?"]),
            ("AVE" | "STD", [array, value, control]) => {
                it(own, &[&begin(array), "0", value, control, "?", "?"])
            }
            ("SRT", [array, control]) => it(own, &[&begin(array), "0", control, "?", "?"]),
            ("FAL" | "FSC" | "FOR", all) => self.looped(own, block, all)?,
            _ => return Err("it has no counterpart there".to_owned()),
        }])
    }

    /// What is given for a parameter.
    fn argument(&mut self, bound: &Bound) -> Result<String> {
        match &bound.argument {
            Argument::Value(value) => self.value(value),
            _ => {
                let written = self.source(bound.range).to_owned();
                let written = written
                    .split_once("=>")
                    .map_or(written.as_str(), |(_, value)| value);
                let written = written.split_once(":=").map_or(written, |(_, value)| value);
                self.path(written.trim())
            }
        }
    }

    /// A call of an Add-On Instruction: the instance, then each parameter.
    fn call(&mut self, user: usize, name: &str, block: &Block) -> Result<Series> {
        let definition = &self.input.program.blocks[user];
        let parameters = definition.parameters.clone();
        let mut operands = Vec::new();
        let instance = block.arguments.iter().find(|bound| bound.parameter.is_none());
        operands.push(match instance {
            Some(bound) => self.argument(bound)?,
            None => self.made(name, name, "the state of a block"),
        });
        let mut before = Series::new();
        for (number, (tag, kind)) in parameters.iter().enumerate() {
            if !self.is_given(user, number) {
                continue;
            }
            let ty = self.input.program.tags[tag.0 as usize].ty;
            let given = block
                .arguments
                .iter()
                .find(|bound| bound.parameter == Some(number));
            operands.push(match (given, kind) {
                (Some(bound), ParameterKind::Input) => match &bound.argument {
                    // A number is brought to the type of the parameter there, too.
                    Argument::Value(Expr {
                        ty,
                        kind: ExprKind::Pass(inner),
                        ..
                    }) if Self::is_simple(inner) && ty.is_number() && inner.ty.is_number() => {
                        self.value(inner)?
                    }
                    Argument::Value(value) if !Self::is_simple(value) => {
                        if ty.scalar() == Some(Scalar::Bool) {
                            return Err("there an input takes a tag or a number".to_owned());
                        }
                        if !self.input.is_own {
                            self.note("there an input is computed only while the block has power");
                        }
                        let text = self.formula(value)?;
                        let like = ty.scalar().and_then(super::data::name_of).unwrap_or("DINT");
                        let helper = self.made("input", like, "the value of an input");
                        before.push(it("CPT", &[&helper, &text]));
                        helper
                    }
                    _ => self.argument(bound)?,
                },
                (Some(bound), _) => self.argument(bound)?,
                // An instance keeps what it is not given: it is given its own.
                (None, ParameterKind::Input) if instance.is_some() => {
                    let own = &self.input.program.tags[tag.0 as usize].name;
                    let own = own.rsplit_once('.').map_or(own.as_str(), |(_, own)| own);
                    format!("{}.{}", operands[0], self.member_name(own))
                }
                (None, ParameterKind::Input) => {
                    let initial = self.input.program.tags[tag.0 as usize].initial.first().cloned();
                    super::data::number_of(initial.as_ref(), ty.scalar())?
                }
                (None, _) => {
                    let like = ty.scalar().and_then(super::data::name_of).unwrap_or("DINT");
                    self.made("unused", like, "an output that nothing uses")
                }
            });
        }
        let operands: Vec<&str> = operands.iter().map(String::as_str).collect();
        before.push(it(name, &operands));
        Ok(before)
    }

    /// Whether a parameter is an operand of calls: one of them has a value for it.
    pub(super) fn is_given(&self, user: usize, parameter: usize) -> bool {
        self.data.given.contains(&(user, parameter))
            || self.input.program.blocks[user].parameters[parameter].1 == ParameterKind::InOut
    }
}

/// Its first element.
fn begin(array: &str) -> String {
    format!("{array}[0]")
}
