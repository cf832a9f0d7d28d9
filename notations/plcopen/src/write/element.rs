//! Blocks on a rung as elements of a drawing.

use super::boxes::function_block;
use super::compiler::Compiler;
use super::declare::named;
use super::edge::{fell, fell_power, invert};
use super::faces::Faces;
use super::rung::{Rung, modifier, pin};
use super::text::Words;
use super::touched::Touched;
use super::unit::Unit;
use crate::graph::{Edge, End, Kind, Modifier, Storage};
use crate::own;
use crate::standard::function_of;
use ladder_analysis::networks::BlockAt;
use ladder_analysis::program::{Argument, Block, BlockKind, Bound};
use ladder_analysis::written::facts::{Node, NodeKind};
use ladder_instructions::{Instruction, Op};

/// What is a fault in ladder text.
pub(super) const FAULT: &str = "what is a fault here (a division by zero, a value that does not fit) is there whatever the other system makes of it";

/// What the generators of Beremiz and OpenPLC leave out.
const JUMP: &str = "the generators of Beremiz and OpenPLC Editor up to 3 pass over jumps, labels and returns, and say nothing";

/// A block with what it is written from.
pub(super) struct Writer<'w> {
    pub(super) unit: &'w Unit<'w>,
    pub(super) faces: &'w Faces,
    pub(super) block: &'w Block,
    pub(super) facts: BlockAt<'w>,
}

pub(super) type Power = Result<Vec<End>, String>;

impl Writer<'_> {
    /// Puts the block onto a rung; comes back the power that leaves it.
    ///
    /// # Errors
    ///
    /// Why it has no counterpart.
    pub(super) fn write(&self, rung: &mut Rung<'_>, power: Vec<End>) -> Power {
        match self.block.kind {
            BlockKind::Instruction(row) => self.instruction(rung, row, power),
            BlockKind::User(user) => self.user(rung, user, power),
        }
    }

    pub(super) fn words<'r>(&'r self, rung: &'r Rung<'_>) -> Words<'r> {
        Words {
            text: self.unit.text,
            base: self.facts.base,
            names: &rung.made.names,
            compiler: self.unit.compiler,
        }
    }

    pub(super) fn touched(&self) -> Touched {
        Touched::of(self.block)
    }

    /// An operand as it is written.
    fn node(&self, bound: &Bound) -> Result<&Node, String> {
        let mut operands = self.facts.facts.operands.iter();
        let found = operands.find(|operand| self.facts.absolute(operand.range).contains_range(bound.range));
        found
            .map(|operand| &operand.value)
            .ok_or_else(|| "an operand of it has no counterpart".to_owned())
    }

    pub(super) fn operand(&self, name: &str) -> Option<&Bound> {
        let mut all = self.block.arguments.iter();
        all.find(|bound| bound.operand.is_some_and(|operand| operand.name == name))
    }

    /// An operand in ST.
    pub(super) fn text(&self, rung: &Rung<'_>, bound: &Bound) -> Result<String, String> {
        let node = self.node(bound)?;
        let words = self.words(rung);
        match &bound.argument {
            Argument::Value(value) => words.value(value, node),
            Argument::Place(place, _) => words.place(place, node),
            Argument::State(_) | Argument::ChosenState(_) | Argument::Parts(_) => words.node(node),
            // A whole array that a block is handed.
            Argument::Range(_) if !matches!(node.kind, NodeKind::Range(..)) && bound.parameter.is_some() => {
                words.node(node)
            }
            Argument::Range(_) => Err("ranges of arrays have no counterpart".to_owned()),
            _ => Err("an operand of it has no counterpart".to_owned()),
        }
    }

    pub(super) fn first_text(&self, rung: &Rung<'_>) -> Result<String, String> {
        let bound = self.block.arguments.first();
        self.text(rung, bound.ok_or("it has no operand")?)
    }

    fn shown(&self) -> String {
        self.unit.text[self.facts.range()].to_owned()
    }

    pub(super) fn remark(&self, rung: &mut Rung<'_>, why: &str) {
        rung.made.remarks.push((self.shown(), why.to_owned()));
    }

    /// Says of a jump that generators leave it out.
    fn passed_over(&self, rung: &mut Rung<'_>) {
        if self.unit.compiler == Compiler::Matiec {
            self.remark(rung, JUMP);
        }
    }

    fn instruction(&self, rung: &mut Rung<'_>, row: &Instruction, power: Vec<End>) -> Power {
        let none = Modifier::default();
        let unknown = || Err(format!("the standard has no {}", row.block()));
        let touched = self.touched();
        Ok(match row.op {
            Op::Contact | Op::NegatedContact | Op::RisingContact => {
                let tag = self.first_text(rung)?;
                if tag.contains(' ') {
                    if row.op == Op::RisingContact {
                        return Err("an edge of a bit of a number: write it into a BOOL first".to_owned());
                    }
                    // Generators find no type for what NOT makes of a formula.
                    let value = match (row.op, own::low(&tag)) {
                        (Op::NegatedContact, Some(low)) => rung.value(low),
                        (Op::NegatedContact, None) => {
                            let value = rung.value(tag);
                            vec![invert(rung, value)]
                        }
                        _ => rung.value(tag),
                    };
                    return Ok(with_power(rung, power, value));
                }
                let modifier = match row.op {
                    Op::NegatedContact => modifier(true, Edge::None),
                    Op::RisingContact => modifier(false, Edge::Rising),
                    _ => none,
                };
                vec![rung.contact(&tag, modifier, power, touched)]
            }
            Op::FallingContact => {
                let tag = self.first_text(rung)?;
                let rail = vec![rung.rail()];
                let low = |rung: &mut Rung<'_>, from| {
                    vec![rung.contact(&tag, modifier(true, Edge::None), from, touched.clone())]
                };
                let high =
                    |rung: &mut Rung<'_>| vec![rung.contact(&tag, none, rail.clone(), touched.clone())];
                let fell = fell(rung, low, high);
                vec![rung.contact(&fell, none, power, Touched::default())]
            }
            Op::Inverter => vec![invert(rung, power)],
            Op::OneShotRising => rose(rung, power, touched),
            Op::OneShotFalling => {
                let rail = rung.rail();
                let fell = fell_power(rung, power);
                vec![rung.contact(&fell, none, vec![rail], Touched::default())]
            }
            Op::Eq | Op::Ne | Op::Gt | Op::Ge | Op::Lt | Op::Le => {
                let (name, pins) = function_of(row.op).ok_or("it has no counterpart")?;
                let result = match self.of_names(rung, row.op)? {
                    Some(value) => value,
                    None => {
                        let inputs = self.compared(rung, (name, pins))?;
                        vec![rung.block((name, None), inputs, &["OUT"], touched, false)]
                    }
                };
                with_power(rung, power, result)
            }
            Op::Ton
            | Op::Tof
            | Op::Tp
            | Op::Rto
            | Op::Rtof
            | Op::Ctu
            | Op::Ctd
            | Op::Ctud
            | Op::Ctc
            | Op::Sr
            | Op::Rs => self.state(rung, row, power)?,
            Op::Coil | Op::RetentiveCoil => {
                let tag = self.coil_tag(rung, row)?;
                vec![rung.coil(&tag, none, Storage::None, power, touched)]
            }
            Op::NegatedCoil => {
                let tag = self.coil_tag(rung, row)?;
                vec![rung.coil(&tag, modifier(true, Edge::None), Storage::None, power, touched)]
            }
            Op::RisingCoil if self.unit.compiler == Compiler::TwinCat => {
                let tag = self.coil_tag(rung, row)?;
                let from = rose(rung, power.clone(), Touched::default());
                rung.coil(&tag, none, Storage::None, from, touched);
                power
            }
            Op::RisingCoil => {
                let tag = self.coil_tag(rung, row)?;
                vec![rung.coil(&tag, modifier(false, Edge::Rising), Storage::None, power, touched)]
            }
            Op::FallingCoil => {
                let tag = self.coil_tag(rung, row)?;
                let rail = rung.rail();
                let fell = fell_power(rung, power.clone());
                let from = vec![rung.contact(&fell, none, vec![rail], Touched::default())];
                rung.coil(&tag, none, Storage::None, from, touched);
                power
            }
            Op::SetCoil | Op::RetentiveSet => {
                let tag = self.coil_tag(rung, row)?;
                rung.coil(&tag, none, Storage::Set, power, touched.clone());
                if rung.is_needed() {
                    let rail = vec![rung.rail()];
                    vec![rung.contact(&tag, none, rail, touched)]
                } else {
                    Vec::new()
                }
            }
            Op::ResetCoil | Op::RetentiveReset => {
                let tag = self.coil_tag(rung, row)?;
                vec![rung.coil(&tag, none, Storage::Reset, power, touched)]
            }
            Op::Lbl => {
                let label = self.label()?;
                rung.push(Kind::Label(label), Vec::new(), Touched::default(), false);
                self.passed_over(rung);
                power
            }
            Op::Jmp => {
                let label = self.label()?;
                self.passed_over(rung);
                rung.push(Kind::Jump(label, false), vec![pin("", power)], touched, true);
                Vec::new()
            }
            Op::Ret => {
                self.passed_over(rung);
                rung.push(Kind::Return(false), vec![pin("", power)], touched, true);
                Vec::new()
            }
            _ => match function_of(row.op) {
                Some(function) => self.function(rung, row.op, function, power)?,
                None if matches!(row.op, Op::Calc | Op::Neg | Op::Typ) => {
                    self.formula(rung, row.op, power)?
                }
                None => return unknown(),
            },
        })
    }

    /// A comparison of values of an enumeration, for which compilers have the operator and no function.
    fn of_names(&self, rung: &mut Rung<'_>, op: Op) -> Result<Option<Vec<End>>, String> {
        let is_name =
            |bound: &Bound| matches!(&bound.argument, Argument::Value(value) if value.ty.is_enumeration());
        match &self.block.arguments[..] {
            _ if self.unit.compiler == Compiler::TwinCat => Ok(None),
            [one, other] if is_name(one) && is_name(other) => {
                let sign = if op == Op::Ne { "<>" } else { "=" };
                let text = format!("{} {sign} {}", self.text(rung, one)?, self.text(rung, other)?);
                let touched = self.touched();
                Ok(Some(vec![rung.push(
                    Kind::Value(text, false),
                    Vec::new(),
                    touched,
                    false,
                )]))
            }
            all if all.iter().any(is_name) => {
                Err("more than two names are compared in pairs there".to_owned())
            }
            _ => Ok(None),
        }
    }

    fn label(&self) -> Result<String, String> {
        let operand = self.facts.facts.operands.first().ok_or("it has no label")?;
        let text = &self.unit.text[self.facts.absolute(operand.value.range)];
        Ok(super::names::identifier(text))
    }

    /// The tag of a coil, which some make retentive.
    fn coil_tag(&self, rung: &mut Rung<'_>, row: &Instruction) -> Result<String, String> {
        if let Some(Bound {
            argument: Argument::State(_) | Argument::ChosenState(_),
            ..
        }) = self.block.arguments.first()
        {
            return Err("timers and counters have no reset coil there".to_owned());
        }
        let tag = self.first_text(rung)?;
        if matches!(row.op, Op::RetentiveCoil | Op::RetentiveSet | Op::RetentiveReset) {
            let root = tag.split(['.', '[']).next().unwrap_or_default();
            rung.made.retentive.push(root.to_owned());
        }
        Ok(tag)
    }
}

/// Power in the scan in which it comes.
fn rose(rung: &mut Rung<'_>, power: Vec<End>, touched: Touched) -> Vec<End> {
    let instance = rung.made("trigger", named("R_TRIG"), "finds an edge");
    function_block(
        rung,
        ("R_TRIG", instance),
        vec![pin("CLK", power)],
        &["Q"],
        touched,
    )
}

/// A condition in series with the power that comes to it.
fn with_power(rung: &mut Rung<'_>, power: Vec<End>, condition: Vec<End>) -> Vec<End> {
    if rung.is_rail(&power) {
        return condition;
    }
    let inputs = vec![pin("IN1", power), pin("IN2", condition)];
    vec![rung.block(("AND", None), inputs, &["OUT"], Touched::default(), false)]
}
