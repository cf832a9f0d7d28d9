//! From a file's context, and those of the files that it uses, to its program: names become tags, operands become
//! typed arguments.
//!
//! What does not fit is reported through the rules' own constructors; a program is made only of a file without
//! errors.

mod argument;
mod callee;
mod compared;
mod enumeration;
mod expression;
mod formula_type;
mod inputs;
mod instance;
pub(crate) mod numbers;
mod parts;
mod passed;
mod path;
mod path_ranges;
mod place;
mod ranges;
mod search;
mod swapped;
mod tags;
pub(crate) mod targets;
mod times;
mod user_argument;
mod whole;

pub use argument::in_class;

use crate::findings::diagnostic::Diagnostic;
use crate::findings::excerpt;
use crate::names::context::{Body, Callee, Context};
use crate::names::joined::NamedTags;
use crate::names::scope::Scope;
use crate::networks::network::Meaning;
use crate::networks::{BlockAt, NetworkAt};
use crate::program::{
    Block, BlockKind, Element, Function, Location, Network, Place, Program, TagId, UserBlock,
};
use crate::values::types::Scalar;
use ladder_instructions::{Op, Semantics};
use ladder_syntax::{Name, TextRange, TextSize};
use numbers::{Numbers, Unit};
use rustc_hash::FxHashMap;
use std::ops::Range;
use tags::Ids;

/// What is known while the operands of one block are resolved.
pub(crate) struct Resolver<'c, 'o> {
    context: &'c Context,
    scope: &'c Scope,
    /// The block's names.
    names: NamedTags<'c>,
    /// None while a file is only checked: then the numbers in what comes out mean nothing.
    lowering: Option<Lowering<'c>>,
    /// Where the block's line starts.
    base: TextSize,
    network: usize,
    /// The operand whose value is being resolved, if messages name it.
    operand: Option<OperandAt<'c>>,
    out: &'o mut Vec<Diagnostic>,
}

/// An operand of a block.
#[derive(Clone, Copy)]
struct OperandAt<'c> {
    /// Where its value is.
    range: TextRange,
    name: &'c str,
    block: BlockAt<'c>,
}

/// The numbers by which a program knows what its files name.
#[derive(Clone, Copy)]
struct Lowering<'c> {
    /// The ids of the scope's tags.
    ids: &'c Ids,
    numbers: &'c Numbers,
    insides: &'c instance::Insides,
    /// Which of the numbers' units this is: also the number of its file.
    unit: usize,
}

/// A program as it was resolved. It is whole only if no errors were found.
pub(crate) struct Resolved {
    pub(crate) program: Program,
    /// The first block next to those with errors that could not be resolved whole: such a program must not run.
    pub(crate) unresolved: Option<TextRange>,
    /// Everything that it uses of other files is in it.
    pub(crate) linked: bool,
    /// The networks of the main programs of the files that are there as wholes.
    pub(crate) mains: Vec<Range<usize>>,
}

/// Resolves a network for the sake of its errors, which go to `out`. Returns the first block that could not be
/// resolved whole.
pub(crate) fn check(context: &Context, network: usize, out: &mut Vec<Diagnostic>) -> Option<TextRange> {
    let facts = context.networks.at(network);
    let mut unresolved = None;
    let mut names = context.names_of(facts);
    for (block, bound) in facts.blocks().enumerate() {
        let mut resolver = Resolver {
            context,
            scope: &context.scopes[facts.scope],
            names: names.next_block(block),
            lowering: None,
            base: bound.base,
            network,
            operand: None,
            out: &mut *out,
        };
        if !is_whole(resolver.block(bound).as_ref(), bound) {
            unresolved.get_or_insert(bound.range());
        }
    }
    unresolved
}

/// Resolves all networks of the units, whose errors are reported already.
pub(crate) fn program(units: &[Unit<'_>]) -> Resolved {
    let numbers = Numbers::of(units);
    let mut program = Program {
        files: units.iter().map(|unit| unit.name.to_owned()).collect(),
        cycle: units.first().and_then(|unit| unit.context.cycle),
        profiles: units.iter().map(|unit| unit.context.profile).collect(),
        ..Program::default()
    };
    let ids = tags::tags(units, &numbers, &mut program);
    let insides = instance::add_insides(units, &numbers, &mut program);
    let mut unresolved = None;
    for (index, unit) in units.iter().enumerate() {
        let found = networks(unit, index, (&numbers, &insides), &ids[index], &mut program);
        unresolved = unresolved.or(found);
    }
    let mains = bodies(units, &numbers, &ids, &mut program);
    inputs::mark(units, &ids, &mut program);
    Resolved {
        program,
        unresolved,
        linked: numbers.are_whole(),
        mains,
    }
}

/// Adds a unit's networks. Returns the first block that is not resolved whole.
fn networks(
    unit: &Unit<'_>,
    index: usize,
    (numbers, insides): (&Numbers, &instance::Insides),
    ids: &[Ids],
    program: &mut Program,
) -> Option<TextRange> {
    let context = unit.context;
    let mut unresolved = None;
    let mut reported = Vec::new();
    let mut lowered: Vec<(usize, Network)> = Vec::with_capacity(context.networks.len());
    for (network, facts) in context.networks.iter().enumerate() {
        let Some(number) = numbers.network(index, network) else {
            continue;
        };
        let mut blocks = Vec::with_capacity(facts.blocks.len());
        let mut names = context.names_of(facts);
        for (block, bound) in facts.blocks().enumerate() {
            let mut resolver = Resolver {
                context,
                scope: &context.scopes[facts.scope],
                names: names.next_block(block),
                lowering: Some(Lowering {
                    ids: &ids[facts.scope],
                    numbers,
                    insides,
                    unit: index,
                }),
                base: bound.base,
                network,
                operand: None,
                out: &mut reported,
            };
            let block = resolver.block(bound);
            if !is_whole(block.as_ref(), bound) {
                unresolved.get_or_insert(bound.range());
            }
            blocks.extend(block);
        }
        retain(program, &blocks);
        lowered.push((number, lower(context, index as u32, facts, blocks)));
    }
    lowered.sort_unstable_by_key(|(number, _)| *number);
    program
        .networks
        .extend(lowered.into_iter().map(|(_, network)| network));
    unresolved
}

/// Whether every operand of a block could be resolved.
fn is_whole(block: Option<&Block>, bound: BlockAt<'_>) -> bool {
    block.is_some_and(|block| block.arguments.len() == bound.formals.len())
}

fn lower(context: &Context, file: u32, facts: NetworkAt<'_>, blocks: Vec<Block>) -> Network {
    let elements = facts
        .order
        .elements
        .iter()
        .map(|&(rung, part, step, kind)| Element {
            kind,
            range: facts.part_range(&context.parse, rung, part),
            step,
        })
        .collect();
    Network {
        location: Location {
            file,
            range: facts.range,
        },
        steps: facts.order.steps.clone(),
        blocks,
        elements,
    }
}

/// `(M)`, `(SM)`, `(RM)` and `[PERSIST]` make their tag retentive.
fn retain(program: &mut Program, blocks: &[Block]) {
    use crate::program::Argument;
    for block in blocks {
        let BlockKind::Instruction(row) = block.kind else {
            continue;
        };
        if !matches!(
            row.op,
            Op::RetentiveCoil | Op::RetentiveSet | Op::RetentiveReset | Op::Persist
        ) {
            continue;
        }
        for bound in &block.arguments {
            let tag = match &bound.argument {
                Argument::Place(place, _) => place.root(),
                Argument::State(tag) => Some(*tag),
                Argument::ChosenState(chosen) => {
                    for n in 0..chosen.count {
                        program.tags[(chosen.first.0 + n * chosen.step) as usize].retain = true;
                    }
                    None
                }
                Argument::Range(range) => Some(range.tag),
                Argument::Parts(parts) => {
                    for tag in parts.iter().filter_map(Argument::root) {
                        program.tags[tag.0 as usize].retain = true;
                    }
                    None
                }
                _ => None,
            };
            let Some(tag) = tag else { continue };
            program.tags[tag.0 as usize].retain = true;
        }
    }
}

/// The main program, the functions and blocks with their networks, and the labels. Returns the main programs of all files that
/// are there as wholes.
fn bodies(
    units: &[Unit<'_>],
    numbers: &Numbers,
    ids: &[Vec<Ids>],
    program: &mut Program,
) -> Vec<Range<usize>> {
    let mut mains = Vec::new();
    for (index, unit) in units.iter().enumerate() {
        let context = unit.context;
        let mut ranges: FxHashMap<Body, Range<usize>> = FxHashMap::default();
        for (network, &body) in context.bodies.iter().enumerate() {
            if let Some(number) = numbers.network(index, network) {
                let range = ranges.entry(body).or_insert(number..number + 1);
                *range = range.start.min(number)..range.end.max(number + 1);
            }
        }
        let of = |body: Body| ranges.get(&body).cloned().unwrap_or_default();
        if unit.bodies.is_none() {
            mains.push(of(Body::Main));
        }
        for (item, function) in context.functions.iter().enumerate() {
            if numbers.has_function(index, item) {
                program.functions.push(Function {
                    name: function.name.to_string(),
                    networks: of(Body::Function(item)),
                    every: None,
                });
            }
        }
        for (item, block) in context.user_blocks[..context.own_blocks].iter().enumerate() {
            if !numbers.has_block(index, item) {
                continue;
            }
            let scope = &context.scopes[item + 1];
            let id = |tag: usize| ids[index][item + 1].of_tags[tag];
            let own = |name: &str| id(scope.find(&Name::new(name)).unwrap_or(0));
            program.blocks.push(UserBlock {
                name: block.name.clone(),
                shape: block.shape,
                parameters: block.parameters.iter().map(|p| (id(p.tag), p.kind)).collect(),
                parts: block
                    .parameters
                    .iter()
                    .map(|p| passed::parts_in_body(p, &ids[index][item + 1]))
                    .collect(),
                en: own("EN"),
                eno: own("ENO"),
                networks: of(Body::Block(item)),
                unread: block.unread.clone(),
            });
        }
        for label in &context.labels {
            if let Some(number) = numbers.network(index, label.network) {
                program.labels.push((label.key.clone(), number));
            }
        }
    }
    program.labels.sort_by_key(|(_, network)| *network);
    program.main = mains.first().cloned().unwrap_or_default();
    mains
}

impl<'c> Resolver<'c, '_> {
    /// What the file's profile does otherwise.
    fn semantics(&self) -> &'static Semantics {
        self.context.profile.semantics()
    }

    fn report(&mut self, diagnostic: Diagnostic) {
        self.out.push(diagnostic);
    }

    /// A range of the block's line, counted from the start of the file.
    fn at(&self, range: TextRange) -> TextRange {
        range + self.base
    }

    fn tag_id(&self, index: usize) -> TagId {
        self.lowering
            .map_or(TagId(index as u32), |lowering| lowering.ids.of_tags[index])
    }

    /// A tag as a whole, which this file knows in this type.
    fn tag_as_place(&self, index: usize, ty: Scalar) -> Place {
        let place = Place::Tag(self.tag_id(index));
        let stored = self.lowering.and_then(|lowering| lowering.ids.stored.get(&index));
        match stored {
            Some(stored) => Place::As(Box::new(place), *stored, ty),
            None => place,
        }
    }

    /// The number of the network that a label of the file marks.
    fn network_number(&self, network: usize) -> Option<usize> {
        let lowering = self.lowering?;
        lowering.numbers.network(lowering.unit, network)
    }

    fn function_number(&self, callee: &Callee) -> usize {
        self.lowering
            .map_or(0, |lowering| lowering.numbers.function(lowering.unit, callee))
    }

    fn block_number(&self, index: usize) -> usize {
        self.lowering.map_or(0, |lowering| {
            lowering.numbers.block(lowering.unit, self.context, index)
        })
    }

    /// Of an unread part its operands as they are written.
    fn unread_operands(&self, index: usize, bound: BlockAt<'c>) -> Option<Box<str>> {
        self.lowering?;
        self.context.user_blocks[index].unread.as_ref()?;
        let whole = excerpt::text(&self.context.parse, bound.range());
        let head = excerpt::text(&self.context.parse, bound.head_range());
        let operands = whole.split_once(&head).map_or("", |(_, operands)| operands);
        Some(operands.trim_start_matches([']', ')', '>']).trim().into())
    }

    /// A block with its arguments. None if it is not a known block, or cannot be read; the rules say so.
    fn block(&mut self, bound: BlockAt<'c>) -> Option<Block> {
        if bound.faulty {
            return None;
        }
        let location = Location {
            file: self.lowering.map_or(0, |lowering| lowering.unit as u32),
            range: bound.range(),
        };
        match bound.meaning {
            // bad-arity says so; what the operands are is then anybody's guess.
            Meaning::Instruction(row) if !row.takes(bound.positional_count()) => None,
            Meaning::Instruction(row) => {
                if let Some(found) = self.swapped_operands(row, bound) {
                    self.report(found);
                    return None;
                }
                let (arguments, works_in) = self.arguments(row, bound);
                Some(Block {
                    kind: BlockKind::Instruction(row),
                    location,
                    arguments,
                    works_in,
                    unread: None,
                })
            }
            Meaning::User(index) if self.context.user_blocks[index].doubtful => None,
            Meaning::User(index) => {
                if let Some(found) = self.swapped_arguments(index, bound) {
                    self.report(found);
                    return None;
                }
                let arguments = self.user_arguments(index, bound);
                Some(Block {
                    kind: BlockKind::User(self.block_number(index)),
                    location,
                    arguments,
                    works_in: None,
                    unread: self.unread_operands(index, bound),
                })
            }
            // The operands' own errors are shown all the same.
            Meaning::Unknown | Meaning::UnknownUser => None,
        }
    }
}
