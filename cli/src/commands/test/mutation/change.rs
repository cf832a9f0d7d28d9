//! The changes that are made to a program to see whether its scenarios notice: one at a time, each a slip that a person makes.
//!
//! They are made in the program model, where types are fixed and everything has its place: nothing but the one thing changes.

use crate::findings::Source;
use ladder_analysis::program::{Argument, Block, BlockKind, Expr, ExprKind, Location, Place, Program, Step};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::{Value, wrap};
use ladder_instructions::{Instruction, Op, Power, by_op};
use ladder_simulator::value_text;
use ladder_syntax::TextRange;
use std::sync::Arc;

/// A change of one block.
#[derive(Debug, Clone)]
pub(super) struct Change {
    network: usize,
    step: usize,
    block: usize,
    pub(super) kind: Kind,
    /// Of the block.
    pub(super) location: Location,
    /// What is changed, and how: `contact inverted`.
    pub(super) title: String,
}

/// What is changed.
#[derive(Debug, Clone)]
pub(super) enum Kind {
    /// Power goes past the block.
    Bridged,
    /// Another instruction is in its place.
    Replaced(Op),
    /// An operand is another constant.
    Constant {
        argument: usize,
        value: i64,
        range: TextRange,
        ty: Scalar,
    },
}

/// All changes of a program's own file, in the order of the program.
pub(super) fn changes(program: &Program) -> Vec<Change> {
    let mut changes = Vec::new();
    for (number, network) in program.networks.iter().enumerate() {
        if network.location.file != 0 {
            continue;
        }
        for (step, &what) in network.steps.iter().enumerate() {
            let Step::Block { block: index, .. } = what else {
                continue;
            };
            let block = &network.blocks[index];
            let BlockKind::Instruction(row) = block.kind else {
                continue;
            };
            for (kind, done) in of_block(program, block, row) {
                changes.push(Change {
                    network: number,
                    step,
                    block: index,
                    kind,
                    location: block.location,
                    title: format!("{} {done}", noun(row)),
                });
            }
        }
    }
    changes.sort_by_key(|change| change.location.range.start());
    changes
}

fn of_block(program: &Program, block: &Block, row: &Instruction) -> Vec<(Kind, &'static str)> {
    let others = others(row.op).iter();
    let mut found: Vec<(Kind, &'static str)> = others.map(|&(op, done)| (Kind::Replaced(op), done)).collect();
    match row.power {
        Power::Level { .. } | Power::TagEdge(_) | Power::EnEdge(_) | Power::Compares | Power::Inverts => {
            found.push((Kind::Bridged, "bridged"));
        }
        Power::Output => found.extend(preset(program, block, row)),
        _ => {}
    }
    found
}

/// The instructions that are put in the place of another.
const fn others(op: Op) -> &'static [(Op, &'static str)] {
    match op {
        Op::Contact => &[(Op::NegatedContact, "inverted")],
        Op::NegatedContact => &[(Op::Contact, "inverted")],
        Op::RisingContact => &[(Op::Contact, "without its edge"), (Op::FallingContact, "turned")],
        Op::FallingContact => &[
            (Op::NegatedContact, "without its edge"),
            (Op::RisingContact, "turned"),
        ],
        Op::OneShotRising => &[(Op::OneShotFalling, "turned")],
        Op::OneShotFalling => &[(Op::OneShotRising, "turned")],
        Op::Eq => &[(Op::Ne, "inverted")],
        Op::Ne => &[(Op::Eq, "inverted")],
        Op::Gt => &[(Op::Ge, "shifted"), (Op::Le, "inverted")],
        Op::Ge => &[(Op::Gt, "shifted"), (Op::Lt, "inverted")],
        Op::Lt => &[(Op::Le, "shifted"), (Op::Ge, "inverted")],
        Op::Le => &[(Op::Lt, "shifted"), (Op::Gt, "inverted")],
        Op::Coil => &[(Op::NegatedCoil, "inverted")],
        Op::NegatedCoil => &[(Op::Coil, "inverted")],
        Op::SetCoil => &[(Op::Coil, "that does not hold")],
        Op::ResetCoil => &[(Op::NegatedCoil, "that does not hold")],
        Op::RisingCoil => &[(Op::Coil, "without its edge"), (Op::FallingCoil, "turned")],
        Op::FallingCoil => &[(Op::NegatedCoil, "without its edge"), (Op::RisingCoil, "turned")],
        Op::Ton | Op::Rtof => &[(Op::Tof, "of another kind")],
        Op::Tof | Op::Tp | Op::Rto => &[(Op::Ton, "of another kind")],
        Op::Add => &[(Op::Sub, "turned into a subtraction")],
        Op::Sub => &[(Op::Add, "turned into an addition")],
        _ => &[],
    }
}

/// The preset of a timer, doubled, or that of a counter, one more; if it is a constant.
fn preset(program: &Program, block: &Block, row: &Instruction) -> Option<(Kind, &'static str)> {
    let is_timer = matches!(row.op, Op::Ton | Op::Tof | Op::Tp | Op::Rto | Op::Rtof);
    let is_counter = matches!(row.op, Op::Ctu | Op::Ctd | Op::Ctud | Op::Ctc);
    let argument = block.arguments.get(1)?;
    let Argument::Value(Expr { kind, ty, .. }) = &argument.argument else {
        return None;
    };
    let Value::Int(number) = constant(program, kind)? else {
        return None;
    };
    let (value, done) = match number {
        0 => return None,
        number if is_timer => (number.checked_mul(2)?, "with twice its time"),
        number if is_counter => (number.checked_add(1)?, "that counts one more"),
        _ => return None,
    };
    if ty.is_integer() && wrap(value, *ty) != value {
        return None;
    }
    let kind = Kind::Constant {
        argument: 1,
        value,
        range: argument.range,
        ty: *ty,
    };
    Some((kind, done))
}

/// A number that is the same in every scan.
fn constant(program: &Program, kind: &ExprKind) -> Option<Value> {
    match kind {
        ExprKind::Constant(value) => Some(value.clone()),
        ExprKind::Pass(inner) => constant(program, &inner.kind),
        ExprKind::Read(Place::Tag(tag)) => {
            let tag = &program.tags[tag.0 as usize];
            tag.initial.first().filter(|_| tag.constant).cloned()
        }
        _ => None,
    }
}

fn noun(row: &Instruction) -> &'static str {
    match row.power {
        Power::Level { .. } => "contact",
        Power::TagEdge(_) | Power::EnEdge(_) => "edge",
        Power::Compares => "comparison",
        Power::Inverts => "inverter",
        Power::Output if matches!(row.op, Op::Ctu | Op::Ctd | Op::Ctud | Op::Ctc) => "counter",
        Power::Output => "timer",
        _ => match row.op {
            Op::Add => "addition",
            Op::Sub => "subtraction",
            Op::SetCoil => "set coil",
            Op::ResetCoil => "reset coil",
            _ => "coil",
        },
    }
}

impl Change {
    /// The program with this change.
    pub(super) fn made_in(&self, program: &Program) -> Arc<Program> {
        let mut program = program.clone();
        let network = &mut program.networks[self.network];
        let block = &mut network.blocks[self.block];
        match self.kind {
            Kind::Bridged => {
                let step = &mut network.steps[self.step];
                if let Step::Block { en, .. } = *step {
                    *step = Step::Join { upper: en, lower: en };
                }
            }
            Kind::Replaced(op) => block.kind = BlockKind::Instruction(by_op(op)),
            Kind::Constant { argument, value, .. } => {
                if let Argument::Value(expression) = &mut block.arguments[argument].argument {
                    expression.kind = ExprKind::Constant(Value::Int(value));
                }
            }
        }
        Arc::new(program)
    }

    /// Whether it is of a contact or comparison, and shows whether that one matters.
    pub(super) fn is_of_condition(&self, program: &Program) -> bool {
        match program.networks[self.network].blocks[self.block].kind {
            BlockKind::Instruction(row) => {
                matches!(
                    row.power,
                    Power::Level { .. } | Power::TagEdge(_) | Power::Compares
                )
            }
            BlockKind::User(_) => false,
        }
    }

    /// The block as it is written.
    pub(super) fn before<'s>(&self, source: &'s Source) -> &'s str {
        source
            .text
            .get(std::ops::Range::from(self.location.range))
            .unwrap_or_default()
    }

    /// The block as it would be written.
    pub(super) fn after(&self, source: &Source) -> String {
        let before = self.before(source);
        match &self.kind {
            Kind::Bridged => "-".repeat(before.chars().count().min(8)),
            Kind::Replaced(op) => {
                let row = by_op(*op);
                let (open, close) = row.shape.brackets();
                let rest = before
                    .find(close)
                    .map_or("", |at| &before[at + close.len_utf8()..]);
                format!("{open}{}{close}{rest}", row.mnemonic)
            }
            Kind::Constant { value, range, ty, .. } => {
                let number = value_text::display(&Value::Int(*value), *ty);
                let start = usize::from(range.start() - self.location.range.start());
                let end = usize::from(range.end() - self.location.range.start());
                match (before.get(..start), before.get(end..)) {
                    (Some(first), Some(last)) => format!("{first}{number}{last}"),
                    _ => number,
                }
            }
        }
    }
}
