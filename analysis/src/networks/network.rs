//! A network with its blocks bound to the instruction table: which row each block is, and which operand each value is
//! given for.

use crate::networks::control_flow::ControlFlow;
use crate::networks::known_blocks::KnownBlocks;
use crate::networks::named::{self, Named};
use crate::networks::order::Order;
use crate::networks::reading::Reading;
use crate::written::facts::{self, BlockFacts, Head};
use ladder_instructions::{Accepts, Coil, Instruction, Op, Operand, lookup};
use ladder_syntax::wiring::{PartKind, Wiring, bar_contacts};
use ladder_syntax::{
    LineKind, Name, Network, Parse, Surroundings, SyntaxError, SyntaxErrorKind, TextRange, TextSize,
};
use std::sync::Arc;

/// A network, its wiring, order and blocks: all that follows from its own lines and the blocks that it holds, wherever
/// in a file it is.
#[derive(Debug, Clone)]
pub struct NetworkFacts {
    /// The drawing and its connector pairs.
    pub wiring: Arc<Wiring>,
    /// The order of evaluation.
    pub order: Arc<Order>,
    /// The blocks from left to right, top to bottom.
    pub blocks: Box<[BoundBlock]>,
    /// From the start of the first rung to the end of the last, in bytes, line ends included.
    pub(crate) len: TextSize,
    /// Its own text has an error in the drawing.
    pub(crate) broken_by_itself: bool,
    /// Its operands name tags, and neither labels nor functions, and its blocks are instructions or the file's own: what
    /// is found in it depends on its lines, its tags and the signatures of those blocks.
    pub(crate) names_tags_only: bool,
    /// The tags that it names.
    pub(crate) named: Box<[Named]>,
    /// The user-defined blocks that it holds.
    pub(crate) user_blocks: UserBlocks,
    /// What it has of program flow.
    pub(crate) control_flow: ControlFlow,
    /// Each of its blocks is an instruction or a block that is known.
    pub(crate) known: bool,
    /// A block of it keeps its state in a tag.
    pub(crate) keeps_state: bool,
}

/// Which user-defined blocks a network holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum UserBlocks {
    /// None: what its blocks are follows from its own lines.
    None,
    /// Blocks that the file itself defines.
    Own,
    /// Also one of another file, or one that is not known.
    Others,
}

/// A block and what it means.
#[derive(Debug, Clone)]
pub struct BoundBlock {
    /// As it is written. Ranges count from the start of its line.
    pub facts: BlockFacts,
    /// Where its line starts, from the start of the network.
    pub(crate) base: TextSize,
    /// Which instruction or user-defined block it is.
    pub meaning: Meaning,
    /// For each operand, as they are, what it is given for.
    pub formals: Box<[Formal]>,
    /// The parser found an error in it: rules about its operands would only repeat it.
    pub faulty: bool,
}

/// What a block is.
#[derive(Debug, Clone, Copy)]
pub enum Meaning {
    /// A row of the instruction table.
    Instruction(&'static Instruction),
    /// A user-defined block: index of its definition.
    User(usize),
    /// A user-defined block that is not defined, or not in this shape.
    UnknownUser,
    /// No row has this mnemonic in these brackets.
    Unknown,
}

/// What an operand is given for.
#[derive(Debug, Clone, Copy)]
pub enum Formal {
    /// An operand of the instruction's row.
    Operand(&'static Operand),
    /// A parameter of a user-defined block, by its index.
    Parameter(usize),
    /// The tag that is the state of a user-defined block, before all of its parameters.
    Instance,
    /// There are more operands by place than the block takes.
    Excess,
    /// The block has no operand of this name.
    UnknownName,
    /// The block itself is not known.
    Unknown,
}

impl BoundBlock {
    /// The instruction, if it is one.
    pub fn instruction(&self) -> Option<&'static Instruction> {
        match self.meaning {
            Meaning::Instruction(row) => Some(row),
            _ => None,
        }
    }

    /// Which instruction, if it is one.
    pub fn op(&self) -> Option<Op> {
        self.instruction().map(|row| row.op)
    }

    /// What it writes as a coil, if it is one that writes bits.
    pub fn coil(&self) -> Option<Coil> {
        self.instruction().and_then(|row| row.coil)
    }

    /// Its first part as a person writes it: `[TON]`.
    pub fn head_text(&self) -> String {
        let (open, close) = self.facts.shape.brackets();
        match self.facts.head.text() {
            "" => format!("{open} {close}"),
            text => format!("{open}{text}{close}"),
        }
    }

    /// The name of a user-defined block, known or not.
    pub fn user_name(&self) -> Option<&str> {
        match &self.facts.head {
            Head::User(name) => Some(name),
            Head::Mnemonic(_) => None,
        }
    }

    /// Number of operands given by place.
    pub fn positional_count(&self) -> usize {
        self.facts
            .operands
            .iter()
            .filter(|operand| operand.name().is_none())
            .count()
    }
}

impl NetworkFacts {
    /// How many logical lines it takes, from its first rung to its last.
    pub(crate) fn line_count(&self) -> usize {
        self.wiring.line_offsets.last().map_or(0, |last| last + 1)
    }
}

/// The facts of a network.
pub(crate) fn network(
    parse: &Parse,
    network: &Network,
    known: &mut KnownBlocks<'_>,
    reading: &mut Reading,
) -> NetworkFacts {
    let wiring = reading.wiring(parse, network);
    let order = reading.orders.of(&wiring);
    let rungs = wiring.rungs.iter();
    let mut blocks = Vec::with_capacity(rungs.map(|rung| rung.connectors(PartKind::Block).count()).sum());
    let mut base = TextSize::default();
    let mut trees = reading.rungs().iter().enumerate();
    let mut syntax_error = false;
    for line in parse.lines().range(network.lines.clone()) {
        let errors = line.errors.iter();
        syntax_error |= errors.clone().any(breaks_drawing);
        if line.kind == LineKind::Rung
            && let Some((rung, tree)) = trees.next()
        {
            let parts = wiring.rungs[rung].connectors(PartKind::Block);
            let mut errors: Vec<TextRange> = errors.map(|error| error.range).collect();
            errors.sort_unstable_by_key(|range| range.start());
            for facts in facts::blocks(tree, rung, parts) {
                let faulty = is_error_in(&errors, facts.range);
                blocks.push(bind(facts, base, known, faulty));
            }
        }
        base += TextSize::new(line.len);
    }
    let has_bar_contact = || {
        wiring
            .rungs
            .iter()
            .any(|rung| bar_contacts(&rung.parts).next().is_some())
    };
    let broken = syntax_error || !wiring.unpaired.is_empty() || has_bar_contact();
    let user_blocks = user_blocks(&blocks, known);
    let names_tag = |formal: &Formal| match formal {
        Formal::Operand(row) => !matches!(row.accepts, Accepts::Label | Accepts::Function),
        Formal::Parameter(_) | Formal::Instance => true,
        Formal::Excess | Formal::UnknownName | Formal::Unknown => false,
    };
    let names_tags_only = user_blocks != UserBlocks::Others
        && blocks
            .iter()
            .flat_map(|bound| bound.formals.iter())
            .all(names_tag);
    let named = named::named(&blocks, known.list(), &mut reading.named);
    let mut formals = blocks.iter().flat_map(|bound| bound.formals.iter());
    let keeps_state = formals
        .any(|formal| matches!(formal, Formal::Operand(row) if matches!(row.accepts, Accepts::State(_))));
    let control_flow = blocks
        .iter()
        .map(ControlFlow::of)
        .fold(ControlFlow::default(), ControlFlow::with);
    let is_known = blocks
        .iter()
        .all(|bound| matches!(bound.meaning, Meaning::Instruction(_) | Meaning::User(_)));
    NetworkFacts {
        wiring: Arc::new(wiring),
        order,
        blocks: blocks.into(),
        len: base,
        broken_by_itself: broken,
        names_tags_only,
        named,
        user_blocks,
        control_flow,
        known: is_known,
        keeps_state,
    }
}

fn user_blocks(blocks: &[BoundBlock], known: &KnownBlocks<'_>) -> UserBlocks {
    let mut found = UserBlocks::None;
    for bound in blocks {
        match (&bound.facts.head, bound.meaning) {
            (Head::Mnemonic(_), _) => {}
            (Head::User(_), Meaning::User(index)) if known.get(index).import.is_none() => {
                found = UserBlocks::Own;
            }
            (Head::User(_), _) => return UserBlocks::Others,
        }
    }
    found
}

/// Whether an error may have changed what is drawn after it.
pub(crate) fn breaks_drawing(error: &SyntaxError) -> bool {
    matches!(
        error.kind,
        SyntaxErrorKind::UnclosedBlock { .. }
            | SyntaxErrorKind::UnclosedComment
            | SyntaxErrorKind::UnclosedString
            | SyntaxErrorKind::TooComplex
            | SyntaxErrorKind::TooMany(_)
            | SyntaxErrorKind::BadDeclaration(_)
            | SyntaxErrorKind::UnexpectedCharacter {
                place: Surroundings::Rung,
                ..
            }
    )
}

/// Whether an error begins in a block, or right after it where something is missing.
fn is_error_in(errors: &[TextRange], block: TextRange) -> bool {
    let first = errors.partition_point(|range| range.start() < block.start());
    let rest = errors[first..].iter();
    rest.take_while(|range| range.start() <= block.end())
        .any(|range| range.start() < block.end() || range.is_empty())
}

fn bind(facts: BlockFacts, base: TextSize, known: &mut KnownBlocks<'_>, faulty: bool) -> BoundBlock {
    let positional = facts
        .operands
        .iter()
        .filter(|operand| operand.name().is_none())
        .count();
    let meaning = match &facts.head {
        Head::User(name) => match known.find(name, facts.shape) {
            Some(index) => Meaning::User(index),
            None => Meaning::UnknownUser,
        },
        Head::Mnemonic(text) => {
            let mut rows = lookup(facts.shape, text);
            // NOT has two rows: the inverter without operands, and the bitwise one.
            let row = if rows.len() > 1 {
                let fits = rows.clone().find(|row| row.takes(positional));
                // With a wrong number of operands it is an error of the one that has some.
                fits.or_else(|| if positional > 0 { rows.last() } else { rows.next() })
            } else {
                rows.next()
            };
            match row {
                Some(row) => Meaning::Instruction(row),
                None => Meaning::Unknown,
            }
        }
    };
    let (mut place, mut is_instance) = (0, false);
    let formals = facts
        .operands
        .iter()
        .map(|operand| match (operand.name(), meaning) {
            (Some(name), Meaning::Instruction(row)) => {
                row.named(&name.text).map_or(Formal::UnknownName, Formal::Operand)
            }
            (Some(name), Meaning::User(index)) => {
                let key = Name::new(&name.text);
                let parameters = &known.get(index).parameters;
                parameters
                    .iter()
                    .position(|p| p.key == key)
                    .map_or(Formal::UnknownName, Formal::Parameter)
            }
            (None, Meaning::Instruction(row)) => {
                place += 1;
                row.positional(place - 1).map_or(Formal::Excess, Formal::Operand)
            }
            (None, Meaning::User(index)) => {
                if place == 0 && !is_instance && known.is_instance(&operand.value, index) {
                    is_instance = true;
                    return Formal::Instance;
                }
                place += 1;
                if place <= known.get(index).parameters.len() {
                    Formal::Parameter(place - 1)
                } else {
                    Formal::Excess
                }
            }
            (_, Meaning::UnknownUser | Meaning::Unknown) => Formal::Unknown,
        })
        .collect();
    BoundBlock {
        facts,
        base,
        meaning,
        formals,
        faulty,
    }
}

#[cfg(test)]
mod tests {
    use super::{BoundBlock, Named};

    /// A program of ten thousand rungs has thirty thousand of each: a word more, and the allocator takes the next larger
    /// size for them.
    #[test]
    fn what_there_are_many_of_is_small() {
        assert!(size_of::<BoundBlock>() <= 128, "{}", size_of::<BoundBlock>());
        assert!(size_of::<Named>() <= 40, "{}", size_of::<Named>());
    }
}
