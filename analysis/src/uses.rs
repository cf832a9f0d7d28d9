//! Which tags the operands of all blocks name, and how they use them. Tags that are nowhere declared come into
//! their scope here.

use crate::context::Context;
use crate::facts::{Node, NodeKind};
use crate::network::{BoundBlock, Formal};
use crate::program::{ParameterKind, Role};
use crate::scope::{Access, Origin, Scope, TagFacts, Use, type_by_form};
use crate::types::Type;
use crate::user_block::UserBlockFacts;
use ladder_instructions::{Accepts, Direction, Op};
use ladder_syntax::{Name, TextRange};

/// Enters every use of every tag into its scope.
pub(crate) fn collect(context: &mut Context) {
    for (network, facts) in context.networks.iter().enumerate() {
        let scope = &mut context.scopes[facts.scope];
        for (block, bound) in facts.blocks.iter().enumerate() {
            for (operand, (written, formal)) in
                bound.facts.operands.iter().zip(bound.formals.iter()).enumerate()
            {
                let Some(access) = access(bound, *formal, &context.user_blocks) else {
                    continue;
                };
                let place = Place {
                    network,
                    block,
                    operand,
                    bound,
                };
                walk(&written.value, access, true, &place, scope);
            }
        }
    }
    roles(&mut context.scopes[0], &context.networks);
}

/// How an operand's tag is used. None: the operand names no tag.
pub(crate) fn access(bound: &BoundBlock, formal: Formal, user_blocks: &[UserBlockFacts]) -> Option<Access> {
    match formal {
        Formal::Operand(operand) => match operand.accepts {
            Accepts::Label | Accepts::Function | Accepts::SearchOperator => None,
            _ => Some(match operand.direction {
                Direction::In => Access::Read,
                Direction::Out => Access::Write,
                Direction::InOut => Access::ReadWrite,
            }),
        },
        Formal::Parameter(index) => {
            let crate::network::Meaning::User(block) = bound.meaning else {
                return None;
            };
            Some(match user_blocks[block].parameters[index].kind {
                ParameterKind::Input => Access::Read,
                ParameterKind::Output => Access::Write,
                ParameterKind::InOut => Access::ReadWrite,
            })
        }
        // Nothing is known of the operand: count it as both, so that no other rule complains of the tag.
        Formal::Excess | Formal::UnknownName | Formal::Unknown => Some(Access::ReadWrite),
    }
}

struct Place<'b> {
    network: usize,
    block: usize,
    operand: usize,
    bound: &'b BoundBlock,
}

fn walk(node: &Node, access: Access, whole: bool, place: &Place<'_>, scope: &mut Scope) {
    match &node.kind {
        NodeKind::Name(name) => tag(name, node.range, access, Part::of(whole), place, scope),
        NodeKind::Address(name) => tag(name, node.range, access, Part::of(whole), place, scope),
        NodeKind::Member(base, _) => {
            let system = matches!(&base.kind, NodeKind::Name(name) if name.eq_ignore_ascii_case("SYS"));
            if !system {
                walk(base, access, false, place, scope);
            }
        }
        NodeKind::Index(base, index) => {
            walk_indexed(base, access, place, scope);
            walk(index, Access::Read, true, place, scope);
        }
        NodeKind::Range(base, first, last) => {
            walk_indexed(base, access, place, scope);
            walk(first, Access::Read, true, place, scope);
            walk(last, Access::Read, true, place, scope);
        }
        NodeKind::Unary(_, inner) | NodeKind::Paren(inner) => walk(inner, Access::Read, whole, place, scope),
        NodeKind::Binary(_, left, right) => {
            walk(left, Access::Read, true, place, scope);
            walk(right, Access::Read, true, place, scope);
        }
        NodeKind::Call(_, arguments) | NodeKind::Array(arguments) | NodeKind::Repeat(_, arguments) => {
            for argument in arguments {
                walk(argument, Access::Read, true, place, scope);
            }
        }
        NodeKind::Literal(_) | NodeKind::NoFunction | NodeKind::Missing => {}
    }
}

/// Which part of a tag is meant.
#[derive(Clone, Copy, PartialEq)]
enum Part {
    Whole,
    Member,
    Elements,
}

impl Part {
    const fn of(whole: bool) -> Part {
        if whole { Part::Whole } else { Part::Member }
    }
}

/// The base of an index.
fn walk_indexed(base: &Node, access: Access, place: &Place<'_>, scope: &mut Scope) {
    match &base.kind {
        NodeKind::Name(name) => tag(name, base.range, access, Part::Elements, place, scope),
        _ => walk(base, access, false, place, scope),
    }
}

fn tag(name: &str, range: TextRange, access: Access, part: Part, place: &Place<'_>, scope: &mut Scope) {
    if name.eq_ignore_ascii_case("SYS") || name.eq_ignore_ascii_case("PI") {
        return;
    }
    let at = place.bound.absolute(range);
    let index = scope.find(&Name::new(name)).unwrap_or_else(|| {
        let form = type_by_form(name);
        scope.add(TagFacts {
            name: name.to_owned(),
            ty: form.map(|(scalar, _)| Type::Scalar(scalar)),
            role: form.map_or(Role::Internal, |(_, role)| role),
            origin: if form.is_some() {
                Origin::Form
            } else {
                Origin::Undeclared
            },
            retain: false,
            constant: false,
            initial: Vec::new(),
            address: name.starts_with('%').then(|| name.to_owned()),
            at,
            uses: Vec::new(),
            shared: None,
            foreign: None,
            mistyped: false,
        })
    });
    let (network, block, operand) = (place.network, place.block, place.operand);
    scope.tags[index].uses.push(Use {
        network,
        block,
        operand,
        range: at,
        access,
        whole: part == Part::Whole,
        indexed: part == Part::Elements,
    });
}

/// An undeclared BOOL that is read and never written is an input; one that coils write and nothing reads is an
/// output (LANGUAGE §4). Types are not known yet: only BOOL places make a tag either, and infer checks.
fn roles(scope: &mut Scope, networks: &[std::sync::Arc<crate::network::NetworkFacts>]) {
    for tag in &mut scope.tags {
        if tag.origin != Origin::Undeclared {
            continue;
        }
        let read = tag.uses.iter().any(|u| u.access.reads());
        let written = tag.uses.iter().any(|u| u.access.writes());
        let by_coils = tag.uses.iter().filter(|u| u.access.writes()).all(|u| {
            let op = networks[u.network].blocks[u.block].op();
            op.is_some_and(|op| (Op::Coil..=Op::RetentiveReset).contains(&op))
        });
        tag.role = match (read, written) {
            (true, false) => Role::Input,
            (false, true) if by_coils => Role::Output,
            _ => Role::Internal,
        };
    }
}
