//! Blocks on rungs as instructions.

use super::operand::comparison;
use super::rung::{Piece, Series, branch, it};
use super::{Lowered, Result, Writer};
use ladder_analysis::program::{Argument, Block, BlockKind, Bound, Expr, ExprKind, Network, RangeRef};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_instructions::Op;

/// A whole number that a formula is.
pub(super) fn constant(expr: &Expr) -> Option<i64> {
    match &expr.kind {
        ExprKind::Constant(Value::Int(number)) => Some(*number),
        ExprKind::Pass(inner) => constant(inner),
        _ => None,
    }
}

/// The values among the operands.
pub(super) fn values(block: &Block) -> Vec<&Expr> {
    let value = |bound: &'_ Bound| match &bound.argument {
        Argument::Value(_) => true,
        _ => bound.operand.is_none(),
    };
    let all = block.arguments.iter().filter(|bound| value(bound));
    all.filter_map(|bound| match &bound.argument {
        Argument::Value(value) => Some(value),
        _ => None,
    })
    .collect()
}

impl Writer<'_> {
    /// A block. `used`: power goes on after it.
    pub(super) fn block(&mut self, network: &Network, number: usize, used: bool) -> Result<Lowered> {
        let block = &network.blocks[number];
        if super::is_nothing(self.source(block.location.range)) {
            return Ok(Lowered::passing(vec![it("NOP", &[])]));
        }
        let row = match block.kind {
            BlockKind::Instruction(row) => row,
            BlockKind::User(user) => return self.user(user, block).map(Lowered::passing),
        };
        let series = match row.op {
            Op::Contact => self.contact(block, true)?,
            Op::NegatedContact => self.contact(block, false)?,
            Op::RisingContact => self.edge(network, number, "OSR")?,
            Op::FallingContact => self.edge(network, number, "OSF")?,
            Op::Inverter if !used => Vec::new(),
            Op::Inverter => {
                let power = self.made("power", "BOOL", "power on a rung");
                return Ok(Lowered {
                    pieces: vec![it("OTE", &[&power])],
                    cut: Some(vec![it("XIO", &[&power])]),
                });
            }
            Op::OneShotRising => vec![it("ONS", &[&self.storage("risen", true)])],
            Op::OneShotFalling => {
                let (storage, fell) = (
                    self.storage("was_high", false),
                    self.made("fell", "BOOL", "the rung fell"),
                );
                return Ok(Lowered {
                    pieces: vec![it("OSF", &[&storage, &fell])],
                    cut: used.then(|| vec![it("XIC", &[&fell])]),
                });
            }
            Op::Eq | Op::Ne | Op::Gt | Op::Ge | Op::Lt | Op::Le => self.comparison(row.op, block)?,
            Op::Coil | Op::RetentiveCoil => self.coil("OTE", block)?,
            Op::SetCoil | Op::RetentiveSet => return self.set(block, used),
            Op::ResetCoil | Op::RetentiveReset | Op::Res => self.reset(block)?,
            Op::NegatedCoil => return self.negated(block, used),
            Op::RisingCoil | Op::FallingCoil => {
                let rising = row.op == Op::RisingCoil;
                let storage = self.storage(if rising { "risen" } else { "was_high" }, rising);
                let to = self.target(block)?;
                vec![it(if rising { "OSR" } else { "OSF" }, &[&storage, &to])]
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
            | Op::Rs => {
                return self.state(row.op, block, used);
            }
            Op::Lbl | Op::Jmp => self.label(row.op, block)?,
            Op::Fun => Vec::new(),
            Op::Call => {
                let name = self.source(block.arguments[0].range).trim().to_owned();
                let routine = self.names.spell(super::names::Kind::Routine, &name);
                if self.scope.body.is_some() {
                    return Err("an Add-On Instruction calls no routine".to_owned());
                }
                let home = self.input.layout.routine(&name).map(|(program, _)| *program);
                if home != self.scope.program {
                    return Err(format!(
                        "`{name}` is in another program, whose routines this one cannot call"
                    ));
                }
                vec![it("JSR", &[&routine, "0"])]
            }
            // The main routine and an Add-On Instruction return to nobody.
            Op::Ret if self.scope.in_function => vec![it("RET", &[])],
            Op::Ret => vec![it("TND", &[])],
            Op::Mcr => vec![it("MCR", &[])],
            op => self.data(op, block)?,
        };
        Ok(Lowered::passing(series))
    }

    fn contact(&mut self, block: &Block, high: bool) -> Result<Series> {
        match &block.arguments[0].argument {
            Argument::Value(value) => self.condition(value, high),
            Argument::Range(_) => {
                let name = if high { "XIC" } else { "XIO" };
                let bits = self.elements(&block.arguments[0])?;
                Ok(bits.iter().map(|bit| it(name, &[bit])).collect())
            }
            _ => Err("this operand has no counterpart there".to_owned()),
        }
    }

    /// The elements of a range with constant indices.
    fn elements(&mut self, bound: &Bound) -> Result<Vec<String>> {
        const MOST: i64 = 64;
        let (array, first, last) = self.range(bound)?;
        let last = last.unwrap_or(first);
        if last - first >= MOST {
            return Err(format!("so many bits have no counterpart there: at most {MOST}"));
        }
        Ok((first..=last).map(|index| format!("{array}[{index}]")).collect())
    }

    /// The array of a range, and its first and last index.
    pub(super) fn range(&mut self, bound: &Bound) -> Result<(String, i64, Option<i64>)> {
        let Argument::Range(RangeRef { first, last, .. }) = &bound.argument else {
            return Err("this operand has no counterpart there".to_owned());
        };
        let number =
            |expr: &Expr| constant(expr).ok_or("there the index of a range is a constant".to_owned());
        let first = number(first)?;
        let last = last.as_deref().map(number).transpose()?;
        let written = self.source(bound.range).trim().to_owned();
        let array = written
            .rsplit_once('[')
            .map_or(written.as_str(), |(array, _)| array);
        if array.ends_with(']') || written.contains(',') {
            return Err("a range of an array of several dimensions has no counterpart there".to_owned());
        }
        Ok((self.path(array)?, first, last))
    }

    /// A contact for edges: a rung before this one keeps its memory up to date.
    fn edge(&mut self, network: &Network, number: usize, name: &str) -> Result<Series> {
        let block = &network.blocks[number];
        let Argument::Value(value) = &block.arguments[0].argument else {
            return Err("this operand has no counterpart there".to_owned());
        };
        may_be_before(network, number)?;
        let rising = name == "OSR";
        let storage = self.storage(if rising { "risen" } else { "was_high" }, rising);
        let edge = self.made("edge", "BOOL", "the edge of a contact");
        let mut rung = self.condition(value, true)?;
        rung.push(it(name, &[&storage, &edge]));
        self.sheet.before.push(rung);
        Ok(vec![it("XIC", &[&edge])])
    }

    fn comparison(&mut self, op: Op, block: &Block) -> Result<Series> {
        let values = values(block);
        if let ([low, test, high], Op::Le, true) = (&values[..], op, self.input.is_own)
            && let (Some(least), Some(most)) = (number(low), number(high))
            && least <= most
        {
            let texts = [self.value(low)?, self.value(test)?, self.value(high)?];
            return Ok(vec![it("LIM", &texts.each_ref().map(String::as_str))]);
        }
        let mut out = Vec::new();
        for pair in values.windows(2) {
            if pair[0].ty == Scalar::Bool {
                let whole = Expr {
                    ty: Scalar::Bool,
                    kind: ExprKind::Compare(op, Box::new(pair[0].clone()), Box::new(pair[1].clone())),
                    range: pair[0].range,
                };
                out.extend(self.condition(&whole, true)?);
            } else {
                out.push(self.compared(op, pair[0], pair[1])?);
            }
        }
        Ok(out)
    }

    /// What is written.
    pub(super) fn target(&mut self, block: &Block) -> Result<String> {
        let bound = &block.arguments[0];
        let written = self.source(bound.range).to_owned();
        match &bound.argument {
            Argument::Place(place, _) => self.place(place, &written),
            Argument::State(_) | Argument::ChosenState(_) | Argument::Parts(_) => self.path(&written),
            _ => Err("this operand has no counterpart there".to_owned()),
        }
    }

    fn coil(&mut self, name: &str, block: &Block) -> Result<Series> {
        if matches!(block.arguments[0].argument, Argument::Range(_)) {
            let bits = self.elements(&block.arguments[0])?;
            return Ok(bits.iter().map(|bit| it(name, &[bit])).collect());
        }
        let to = self.target(block)?;
        if let Argument::Place(_, ty) = block.arguments[0].argument
            && ty != Scalar::Bool
        {
            return Err("a coil on a number has no counterpart there".to_owned());
        }
        Ok(vec![it(name, &[&to])])
    }

    fn set(&mut self, block: &Block, used: bool) -> Result<Lowered> {
        let pieces = self.coil("OTL", block)?;
        // Its power is the tag.
        let cut = (used && !self.input.is_own).then(|| {
            let bits = pieces.iter().map(|piece| match piece {
                Piece::It(text) => Piece::It(text.replacen("OTL", "XIC", 1)),
                other @ Piece::Branch(_) => other.clone(),
            });
            bits.collect()
        });
        Ok(Lowered { pieces, cut })
    }

    fn reset(&mut self, block: &Block) -> Result<Series> {
        let state = match &block.arguments[0].argument {
            Argument::State(tag) => Some(*tag),
            Argument::ChosenState(chosen) => Some(chosen.first),
            _ => None,
        };
        let Some(state) = state else {
            return self.coil("OTU", block);
        };
        let own = self.target(block)?;
        match self.input.program.tags[state.0 as usize].ty {
            Type::State(ty) => super::state::reset_state(&own, ty),
            _ => Err("this operand has no counterpart there".to_owned()),
        }
    }

    fn negated(&mut self, block: &Block, used: bool) -> Result<Lowered> {
        let power = self.made("power", "BOOL", "power on a rung");
        let mut writes = vec![it("XIO", &[&power])];
        writes.extend(self.coil("OTE", block)?);
        let cut = if used {
            writes.push(it("AFI", &[]));
            branch(vec![writes, vec![it("XIC", &[&power])]])
        } else {
            writes
        };
        Ok(Lowered {
            pieces: vec![it("OTE", &[&power])],
            cut: Some(cut),
        })
    }

    fn label(&mut self, op: Op, block: &Block) -> Result<Series> {
        let name = self.source(block.arguments[0].range).trim().to_owned();
        if self.ambiguous_label(&name) {
            return Err(format!(
                "there a label is only once in a routine, and `{name}` is not"
            ));
        }
        let label = self.names.spell(super::names::Kind::Label, &name);
        if op == Op::Lbl {
            self.sheet.labels.push(label);
            return Ok(Vec::new());
        }
        Ok(vec![it("JMP", &[&label])])
    }
}

pub(super) fn unpassed(expr: &Expr) -> &Expr {
    match &expr.kind {
        ExprKind::Pass(inner) => unpassed(inner),
        _ => expr,
    }
}

/// A number that an expression is.
pub(super) fn number(expr: &Expr) -> Option<f64> {
    match &unpassed(expr).kind {
        ExprKind::Constant(Value::Int(number)) => Some(*number as f64),
        ExprKind::Constant(Value::Real(number)) => Some(*number),
        _ => None,
    }
}

/// Whether what a block reads is the same before the rung.
fn may_be_before(network: &Network, number: usize) -> Result<()> {
    let read: Vec<_> = network.blocks[number]
        .arguments
        .iter()
        .flat_map(Bound::places)
        .collect();
    for (other, block) in network.blocks.iter().enumerate() {
        let flows = match block.kind {
            BlockKind::User(_) => true,
            BlockKind::Instruction(row) => {
                matches!(row.op, Op::Jmp | Op::Call | Op::Ret | Op::For | Op::Mcr)
            }
        };
        let writes = block.arguments.iter().any(|bound| {
            let is_written = !matches!(bound.argument, Argument::Value(_));
            is_written
                && read
                    .iter()
                    .any(|(place, _)| place.root() == bound.argument.root())
        });
        if other != number && (flows || writes) {
            return Err("an edge of what the same network writes has no counterpart there".to_owned());
        }
    }
    Ok(())
}

/// The values of a comparison, for those that look for its likes.
pub(super) fn compared_values(block: &Block) -> Option<(&'static str, Vec<&Expr>)> {
    match block.kind {
        BlockKind::Instruction(row)
            if matches!(row.op, Op::Eq | Op::Ne | Op::Gt | Op::Ge | Op::Lt | Op::Le) =>
        {
            Some((comparison(row.op), values(block)))
        }
        _ => None,
    }
}
