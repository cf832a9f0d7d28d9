//! From a file's context to its program: names become tags, operands become typed arguments.
//!
//! What does not fit is reported through the rules' own constructors; a program is made only of a file without
//! errors.

mod argument;
mod expression;
mod place;

pub(crate) use expression::is_function;

use crate::context::{Body, Context};
use crate::diagnostic::Diagnostic;
use crate::network::{BoundBlock, Meaning, NetworkFacts};
use crate::program::{
    Block, BlockKind, Element, Function, Location, Network, Program, Tag, TagId, UserBlock,
};
use crate::scope::Scope;
use crate::types::{Scalar, Type};
use ladder_instructions::Op;
use ladder_syntax::{Name, TextRange, TextSize};
use std::collections::HashMap;
use std::ops::Range;

/// What is known while the operands of one block are resolved.
pub(crate) struct Resolver<'c, 'o> {
    context: &'c Context,
    scope: &'c Scope,
    /// The ids of the scope's tags.
    ids: &'c [TagId],
    /// The program's tags.
    tags: &'c [Tag],
    /// Where the block's line starts.
    base: TextSize,
    network: usize,
    /// Structure's networks to the program's.
    network_numbers: &'c [usize],
    out: &'o mut Vec<Diagnostic>,
}

/// Resolves all networks. The program is whole only if `out` has no errors afterwards.
/// Gives the first block beside it that could not be resolved whole: such a program must not run.
pub(crate) fn program(
    context: &Context,
    file: &str,
    out: &mut Vec<Diagnostic>,
) -> (Program, Option<TextRange>) {
    let numbers = network_numbers(context);
    let mut program = Program {
        files: vec![file.to_owned()],
        ..Program::default()
    };
    let ids = tag_ids(context);
    for (index, scope) in context.scopes.iter().enumerate() {
        let own = scope.tags.iter().filter(|tag| tag.shared.is_none());
        program.tags.extend(own.map(|tag| Tag {
            name: tag.name.clone(),
            ty: tag.ty.unwrap_or(Type::Scalar(Scalar::Dint)),
            role: tag.role,
            retain: tag.retain,
            constant: tag.constant,
            initial: tag.initial.clone(),
            block: index.checked_sub(1),
            location: Location {
                file: 0,
                range: tag.at,
            },
        }));
    }
    let mut unresolved = None;
    let mut networks: Vec<Option<Network>> = vec![None; context.networks.len()];
    for (index, facts) in context.networks.iter().enumerate() {
        let mut blocks = Vec::with_capacity(facts.blocks.len());
        for bound in &facts.blocks {
            let mut resolver = Resolver {
                context,
                scope: &context.scopes[facts.scope],
                ids: &ids[facts.scope],
                tags: &program.tags,
                base: bound.base,
                network: index,
                network_numbers: &numbers,
                out: &mut *out,
            };
            let block = resolver.block(bound);
            let whole = block
                .as_ref()
                .is_some_and(|block| block.arguments.len() == bound.formals.len());
            if !whole {
                unresolved.get_or_insert(bound.range());
            }
            blocks.extend(block);
        }
        retain(&mut program, &blocks);
        networks[numbers[index]] = Some(lowered(context, facts, blocks));
    }
    program.networks = networks.into_iter().flatten().collect();
    let bodies = body_ranges(context, &numbers);
    functions(context, &bodies, &mut program);
    user_blocks(context, &bodies, &ids, &mut program);
    let labels = context.labels.iter();
    program.labels = labels
        .map(|label| (label.key.clone(), numbers[label.network]))
        .collect();
    program.labels.sort_by_key(|(_, network)| *network);
    (program, unresolved)
}

/// The id of each tag of each scope. What is shared has the id of the tag that it leads to.
fn tag_ids(context: &Context) -> Vec<Vec<TagId>> {
    let mut next = 0;
    let mut ids: Vec<Vec<TagId>> = Vec::with_capacity(context.scopes.len());
    for scope in &context.scopes {
        let own = scope.tags.iter().map(|tag| {
            let id = TagId(next);
            next += u32::from(tag.shared.is_none());
            id
        });
        ids.push(own.collect());
    }
    for (scope, facts) in context.scopes.iter().enumerate() {
        for (tag, facts) in facts.tags.iter().enumerate() {
            if let Some((shared_scope, shared_tag)) = facts.shared {
                ids[scope][tag] = ids[shared_scope][shared_tag];
            }
        }
    }
    ids
}

/// The file's own networks come first, then those of each block's body, so that every body is one range.
fn network_numbers(context: &Context) -> Vec<usize> {
    let mut order: Vec<usize> = (0..context.networks.len()).collect();
    order.sort_by_key(|&index| (context.networks[index].scope, index));
    let mut numbers = vec![0; order.len()];
    for (number, index) in order.into_iter().enumerate() {
        numbers[index] = number;
    }
    numbers
}

fn lowered(context: &Context, facts: &NetworkFacts, blocks: Vec<Block>) -> Network {
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
            file: 0,
            range: facts.range,
        },
        steps: facts.order.steps.clone(),
        blocks,
        elements,
    }
}

/// `(M)`, `(SM)`, `(RM)` and `[PERSIST]` make their tag retentive.
fn retain(program: &mut Program, blocks: &[Block]) {
    use crate::program::{Argument, Place};
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
                Argument::Place(Place::Tag(tag) | Place::Element(tag, _) | Place::Member(tag, _), _)
                | Argument::State(tag) => *tag,
                Argument::Place(Place::Bit(base, ..), _) => match base.as_ref() {
                    Place::Tag(tag) | Place::Element(tag, _) => *tag,
                    _ => continue,
                },
                Argument::Range(range) => range.tag,
                _ => continue,
            };
            program.tags[tag.0 as usize].retain = true;
        }
    }
}

/// The networks of each body, as the program numbers them.
fn body_ranges(context: &Context, numbers: &[usize]) -> HashMap<Body, Range<usize>> {
    let mut ranges: HashMap<Body, Range<usize>> = HashMap::new();
    for (&body, &number) in context.bodies.iter().zip(numbers) {
        let range = ranges.entry(body).or_insert(number..number + 1);
        *range = range.start.min(number)..range.end.max(number + 1);
    }
    ranges
}

fn functions(context: &Context, bodies: &HashMap<Body, Range<usize>>, program: &mut Program) {
    program.main = bodies.get(&Body::Main).cloned().unwrap_or_default();
    program.functions = context
        .functions
        .iter()
        .enumerate()
        .map(|(index, function)| Function {
            name: function.name.clone(),
            networks: bodies.get(&Body::Function(index)).cloned().unwrap_or_default(),
        })
        .collect();
}

fn user_blocks(
    context: &Context,
    bodies: &HashMap<Body, Range<usize>>,
    ids: &[Vec<TagId>],
    program: &mut Program,
) {
    program.blocks = context
        .user_blocks
        .iter()
        .enumerate()
        .map(|(index, block)| {
            let scope = &context.scopes[index + 1];
            let id = |tag: usize| ids[index + 1][tag];
            let own = |name: &str| id(scope.find(&Name::new(name)).unwrap_or(0));
            UserBlock {
                name: block.name.clone(),
                shape: block.shape,
                parameters: block.parameters.iter().map(|p| (id(p.tag), p.kind)).collect(),
                en: own("EN"),
                eno: own("ENO"),
                networks: bodies.get(&Body::Block(index)).cloned().unwrap_or_default(),
            }
        })
        .collect();
}

impl Resolver<'_, '_> {
    fn report(&mut self, diagnostic: Diagnostic) {
        self.out.push(diagnostic);
    }

    /// A range of the block's line, counted from the start of the file.
    fn at(&self, range: TextRange) -> TextRange {
        range + self.base
    }

    fn tag_id(&self, index: usize) -> TagId {
        self.ids[index]
    }

    /// A block with its arguments. None if it is no known block, or cannot be read; the rules say so.
    fn block(&mut self, bound: &BoundBlock) -> Option<Block> {
        if bound.faulty {
            return None;
        }
        let location = Location {
            file: 0,
            range: bound.range(),
        };
        match bound.meaning {
            // bad-arity says so; what the operands are is then anybody's guess.
            Meaning::Instruction(row) if !row.takes(bound.positional_count()) => None,
            Meaning::Instruction(row) => {
                let (arguments, works_in) = self.arguments(row, bound);
                Some(Block {
                    kind: BlockKind::Instruction(row),
                    location,
                    arguments,
                    works_in,
                })
            }
            Meaning::User(index) if self.context.user_blocks[index].doubtful => None,
            Meaning::User(index) => {
                let arguments = self.user_arguments(index, bound);
                Some(Block {
                    kind: BlockKind::User(index),
                    location,
                    arguments,
                    works_in: None,
                })
            }
            // The operands' own mistakes are shown all the same.
            Meaning::Unknown | Meaning::UnknownUser => None,
        }
    }
}
