//! Contacts, edges, the inverter and comparisons (LANGUAGE §5.1).

use super::arguments::Arguments;
use super::place::{Slot, Spot};
use super::{Compiler, Result};
use crate::code::Instr;
use crate::memory::Bit;
use crate::operation::{Test, Width};
use crate::places::EdgeOf;
use ladder_analysis::program::{Argument, Expr, ExprKind, Place};
use ladder_analysis::values::types::{Scalar, common};
use ladder_instructions::{Edge, Edges, FirstEdges, Instruction, Op, Power};

impl Compiler<'_> {
    /// What lets power through or not, as the table of instructions has it.
    pub(super) fn condition(&mut self, row: &Instruction, arguments: Arguments, en: Bit) -> Result<Bit> {
        match row.power {
            Power::Level { high } => self.contact(arguments, en, high),
            Power::TagEdge(edge) => self.edge_contact(arguments, en, edge == Edge::Rising),
            Power::Compares => self.comparison(row.op, arguments, en),
            Power::Inverts => Ok(self.inverter(en)),
            Power::EnEdge(edge) => Ok(self.edge(Bit::HIGH, en, edge == Edge::Rising)),
            Power::Passes | Power::PassesIfDone | Power::Output | Power::SetTag => Ok(en),
        }
    }

    /// `[ ]` and `[/]`
    fn contact(&mut self, arguments: Arguments, en: Bit, open: bool) -> Result<Bit> {
        let value = match arguments.get(0)? {
            Argument::Range(range) => return self.contact_on_range(range, en, open),
            argument => arguments.as_value(argument)?,
        };
        let contact = |out, en, tag| {
            if open {
                Instr::Contact { out, en, tag }
            } else {
                Instr::NegatedContact { out, en, tag }
            }
        };
        // What must be computed first is computed with EN high only: an index outside its array is then no
        // fault.
        let (out, start) = self.begin_powered(en);
        let tag = self.bit(value)?;
        if self.code.instrs.len() == start + 1 {
            self.code.instrs.truncate(start);
            self.emit(contact(out, en, tag));
        } else {
            self.emit(contact(out, Bit::HIGH, tag));
            self.end_powered(start);
        }
        Ok(out)
    }

    /// `[P]` and `[N]`: the tag is read at every evaluation.
    fn edge_contact(&mut self, arguments: Arguments, en: Bit, rising: bool) -> Result<Bit> {
        let value = arguments.value(0)?;
        let memory = self.edge_memory(read_place(value))?;
        let tag = self.bit(value)?;
        Ok(self.edge_with(memory, en, tag, rising))
    }

    /// EN and an edge of a bit. The memory belongs to this place in the text.
    pub(super) fn edge(&mut self, en: Bit, tag: Bit, rising: bool) -> Bit {
        self.edge_with(None, en, tag, rising)
    }

    /// The same, with a memory that others share.
    pub(super) fn edge_with(&mut self, memory: Option<Bit>, en: Bit, tag: Bit, rising: bool) -> Bit {
        let out = self.layout.bit();
        let spot = match memory {
            Some(memory) => Spot::Bit(memory),
            None => {
                let spot = self.remembered_bit();
                // What was high before does not rise.
                if let Spot::Bit(memory) = spot {
                    let is_primed = rising && self.semantics.first_edges == FirstEdges::None;
                    self.layout.memory.set_bit(memory, is_primed);
                }
                spot
            }
        };
        let Slot::Bit(before) = self.load(spot) else {
            return Bit::LOW;
        };
        self.emit(if rising {
            Instr::Rising { out, en, tag, before }
        } else {
            Instr::Falling { out, en, tag, before }
        });
        if !matches!(spot, Spot::Bit(_)) {
            self.layout.keep(before);
            self.store(spot, Slot::Bit(before));
        }
        out
    }

    /// The memory that all edges of a tag share, where edges belong to tags.
    pub(super) fn edge_memory(&mut self, place: Option<&Place>) -> Result<Option<Bit>> {
        let (Edges::OfTag, Some(place @ (Place::Tag(_) | Place::Member(..)))) = (self.semantics.edges, place)
        else {
            return Ok(None);
        };
        let of = match self.spot(place)? {
            Spot::Bit(slot) => EdgeOf::Bit(slot),
            Spot::Word(slot) => EdgeOf::Word(slot),
            _ => return Ok(None),
        };
        if let Some(&memory) = self.edges.get(&of) {
            return Ok(Some(memory));
        }
        let memory = self.layout.bit();
        self.edges.insert(of, memory);
        Ok(Some(memory))
    }

    fn inverter(&mut self, en: Bit) -> Bit {
        let out = self.layout.bit();
        self.emit(Instr::Invert { out, en });
        out
    }

    /// `[EQ]` to `[LE]`: each neighbouring pair.
    fn comparison(&mut self, op: Op, arguments: Arguments, en: Bit) -> Result<Bit> {
        let values = arguments.values_from(0)?;
        let (out, start) = self.begin_powered(en);
        let slots: Vec<(Slot, Scalar)> = values
            .iter()
            .map(|value| Ok((self.expression(value)?, value.ty)))
            .collect::<Result<_>>()?;
        let direct = self.code.instrs.len() == start + 1;
        if direct {
            self.code.instrs.truncate(start);
        }
        let mut power = if direct { en } else { Bit::HIGH };
        let pairs = slots.len().saturating_sub(1);
        for n in 0..pairs {
            let to = if n + 1 == pairs { out } else { self.layout.bit() };
            self.compare_slots(op, to, power, slots[n], slots[n + 1]);
            power = to;
        }
        if !direct {
            self.end_powered(start);
        }
        Ok(out)
    }

    /// One comparison of an expression; gives EN and whether it holds.
    pub(super) fn compare(&mut self, op: Op, en: Bit, a: &Expr, b: &Expr) -> Result<Bit> {
        let out = self.layout.bit();
        let slots = ((self.expression(a)?, a.ty), (self.expression(b)?, b.ty));
        self.compare_slots(op, out, en, slots.0, slots.1);
        Ok(out)
    }

    pub(super) fn compare_slots(&mut self, op: Op, out: Bit, en: Bit, a: (Slot, Scalar), b: (Slot, Scalar)) {
        let test = test_of(op);
        let instr = match (a.0, b.0) {
            (Slot::Bit(a), Slot::Bit(b)) => Instr::CompareBit { test, out, en, a, b },
            (Slot::Text(a), Slot::Text(b)) => Instr::CompareText { test, out, en, a, b },
            (Slot::Word(mut left), Slot::Word(mut right)) => {
                if a.1.is_real() || b.1.is_real() {
                    // Both sides are brought to one type before; a whole number among them would be read as bits.
                    let meet = common(a.1, b.1).unwrap_or(Scalar::Lreal);
                    if let (Slot::Word(l), Slot::Word(r)) =
                        (self.pass(a.0, a.1, meet), self.pass(b.0, b.1, meet))
                    {
                        (left, right) = (l, r);
                    }
                    Instr::CompareReal {
                        test,
                        out,
                        en,
                        a: left,
                        b: right,
                    }
                } else {
                    let a_unsigned = Width::of(a.1) == Width::U64;
                    let b_unsigned = Width::of(b.1) == Width::U64;
                    if a_unsigned || b_unsigned {
                        Instr::CompareUnsigned {
                            test,
                            a_unsigned,
                            b_unsigned,
                            out,
                            en,
                            a: left,
                            b: right,
                        }
                    } else {
                        Instr::Compare {
                            test,
                            out,
                            en,
                            a: left,
                            b: right,
                        }
                    }
                }
            }
            _ => return,
        };
        self.emit(instr);
    }
}

/// The place whose truth a condition is about: a tag, or a number that is compared with 0.
fn read_place(value: &Expr) -> Option<&Place> {
    match &value.kind {
        ExprKind::Read(place) => Some(place),
        ExprKind::Compare(Op::Ne, number, _) => read_place(number),
        _ => None,
    }
}

pub(super) const fn test_of(op: Op) -> Test {
    match op {
        Op::Ne => Test::NE,
        Op::Gt => Test::GT,
        Op::Ge => Test::GE,
        Op::Lt => Test::LT,
        Op::Le => Test::LE,
        _ => Test::EQ,
    }
}
