//! Which tags the operands of all blocks name, and how they use them. Tags that are nowhere declared come into
//! their scope here.

use crate::context::Context;
use crate::facts::{Node, NodeKind};
use crate::joined::Joined;
use crate::network::{BoundBlock, Formal, NetworkFacts};
use crate::networks::NetworkAt;
use crate::program::{ParameterKind, Role};
use crate::rare::{Rare, RareFacts};
use crate::reading::TOGETHER;
use crate::scope::{Access, Origin, Scope, TagFacts, Use, UseRef, Uses, type_by_form};
use crate::still_wanted::StillWanted;
use crate::types::{Scalar, Type};
use crate::use_kind::{Deed, Extent, UseKind};
use crate::user_block::UserBlockFacts;
use ladder_instructions::{Accepts, Direction, Law};
use ladder_syntax::{Name, TextRange, TextSize};

/// Enters every use of every tag into its scope. None if that is not wanted any longer.
pub(crate) fn collect(context: &mut Context, wanted: &StillWanted<'_>) -> Option<()> {
    let law = context.profile.law();
    let mut joined = Joined::with_networks(context.networks.len());
    let mut known = Vec::new();
    for first in (0..context.networks.len()).step_by(TOGETHER) {
        let together = first..(first + TOGETHER).min(context.networks.len());
        // Each name leads to another place in memory. The processor goes to several at once if nothing is done between.
        for network in context.networks.range(together.clone()) {
            let scope = &context.scopes[network.scope];
            known.extend(network.facts().named.iter().map(|named| scope.find(&named.key)));
        }
        let mut known = known.drain(..);
        for network in context.networks.range(together) {
            wanted.one_more()?;
            let known = known.by_ref().take(network.named.len());
            enter(
                network,
                known,
                law,
                &mut context.scopes[network.scope],
                &mut joined,
            );
        }
    }
    context.joined = joined;
    roles(&mut context.scopes[0]);
    Some(())
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

/// A tag's name in an operand.
#[derive(Debug, Clone)]
pub(crate) struct Named {
    pub(crate) key: Name,
    /// Where it is, from the start of the block's line.
    range: TextRange,
    pub(crate) block: u32,
    /// A block has far fewer than 2^16 of them.
    pub(crate) operand: u16,
    pub(crate) kind: UseKind,
}

impl Named {
    /// Whether it is at this place of its block's line.
    pub(crate) fn is_at(&self, range: TextRange) -> bool {
        self.range == range
    }

    /// The use that it is, in this network, on a line that starts here.
    pub(crate) fn at(&self, network: usize, line: TextSize) -> Use {
        Use {
            network,
            block: self.block as usize,
            operand: self.operand as usize,
            range: self.range + line,
            access: self.kind.access(),
            whole: self.kind.extent() == Extent::Whole,
            indexed: self.kind.extent() == Extent::Elements,
        }
    }
}

/// The tags that blocks name, in the order in which they are. `room` is to gather them in.
pub(crate) fn named(
    blocks: &[BoundBlock],
    user_blocks: &[UserBlockFacts],
    room: &mut Vec<Named>,
) -> Box<[Named]> {
    let mut names = Names {
        block: 0,
        operand: 0,
        deed: Deed::Other,
        found: room,
    };
    for (block, bound) in blocks.iter().enumerate() {
        names.block = block as u32;
        for (operand, (written, formal)) in bound.facts.operands.iter().zip(bound.formals.iter()).enumerate()
        {
            if let Some(access) = access(bound, *formal, user_blocks) {
                names.operand = operand as u16;
                names.deed = Deed::of(bound, *formal);
                names.walk(&written.value, access, true);
            }
        }
    }
    room.drain(..).collect()
}

/// Names that are being gathered, and where.
struct Names<'r> {
    block: u32,
    operand: u16,
    /// What the block does with the operand.
    deed: Deed,
    found: &'r mut Vec<Named>,
}

impl Names<'_> {
    fn walk(&mut self, node: &Node, access: Access, whole: bool) {
        match &node.kind {
            NodeKind::Name(name) | NodeKind::Address(name) => {
                let extent = if whole { Extent::Whole } else { Extent::Member };
                self.add(name, node.range, access, extent);
            }
            NodeKind::Member(base, _) => {
                let system = matches!(&base.kind, NodeKind::Name(name) if name.eq_ignore_ascii_case("SYS"));
                if !system {
                    self.walk(base, access, false);
                }
            }
            NodeKind::Index(base, index) => {
                self.walk_indexed(base, access);
                self.walk(index, Access::Read, true);
            }
            NodeKind::Range(base, first, last) => {
                self.walk_indexed(base, access);
                self.walk(first, Access::Read, true);
                self.walk(last, Access::Read, true);
            }
            NodeKind::Unary(_, inner) | NodeKind::Paren(inner) => self.walk(inner, Access::Read, whole),
            NodeKind::Binary(_, left, right) => {
                self.walk(left, Access::Read, true);
                self.walk(right, Access::Read, true);
            }
            NodeKind::Call(_, arguments) | NodeKind::Array(arguments) | NodeKind::Repeat(_, arguments) => {
                for argument in arguments {
                    self.walk(argument, Access::Read, true);
                }
            }
            NodeKind::Literal(_) | NodeKind::NoFunction | NodeKind::Missing => {}
        }
    }

    /// The base of an index.
    fn walk_indexed(&mut self, base: &Node, access: Access) {
        match &base.kind {
            NodeKind::Name(name) => self.add(name, base.range, access, Extent::Elements),
            _ => self.walk(base, access, false),
        }
    }

    fn add(&mut self, name: &str, range: TextRange, access: Access, extent: Extent) {
        if name.eq_ignore_ascii_case("SYS") || name.eq_ignore_ascii_case("PI") {
            return;
        }
        self.found.push(Named {
            key: Name::new(name),
            range,
            block: self.block,
            operand: self.operand,
            kind: UseKind::new(access, extent, self.deed),
        });
    }
}

/// Enters the uses of a network's tags. `known`: those that were known before the networks around it were entered.
fn enter(
    network: NetworkAt<'_>,
    known: impl Iterator<Item = Option<usize>>,
    law: &Law,
    scope: &mut Scope,
    joined: &mut Joined,
) {
    for ((number, named), known) in (0..).zip(network.named.iter()).zip(known) {
        let index = known
            .or_else(|| scope.find(&named.key))
            .unwrap_or_else(|| scope.add(undeclared(spelling(network.facts(), named), law)));
        scope.tags[index]
            .uses
            .0
            .push(UseRef::new(network.index as u32, number, named.kind));
        joined.push(index);
    }
    joined.end_network();
}

/// A tag that is first met in an operand.
pub(crate) fn undeclared(name: &str, law: &Law) -> TagFacts {
    let form = type_by_form(name).map(|(scalar, role)| match scalar {
        Scalar::Lreal => (Scalar::real_of(law), role),
        other => (other, role),
    });
    let is_address = name.starts_with('%');
    TagFacts {
        name: name.into(),
        ty: form.map(|(scalar, _)| Type::Scalar(scalar)),
        role: form.map_or(Role::Internal, |(_, role)| role),
        // One that is no address is reported where it is, and for nothing else.
        origin: if form.is_some() || is_address {
            Origin::Form
        } else {
            Origin::Undeclared
        },
        retain: false,
        constant: false,
        rare: Rare::from(RareFacts {
            address: is_address.then(|| name.into()),
            ..RareFacts::NONE
        }),
        declared_at: TextRange::default(),
        uses: Uses::default(),
        mistyped: false,
    }
}

/// A name of a network's operands, as it is written.
pub(crate) fn spelling<'n>(network: &'n NetworkFacts, named: &Named) -> &'n str {
    let block = &network.blocks[named.block as usize];
    spelled(&block.facts.operands[named.operand as usize].value, named.range).unwrap_or_default()
}

/// The name that is at a place of an operand, as it is written.
fn spelled(node: &Node, at: TextRange) -> Option<&str> {
    match &node.kind {
        NodeKind::Name(name) | NodeKind::Address(name) => (node.range == at).then_some(name),
        NodeKind::Member(inner, _) | NodeKind::Unary(_, inner) | NodeKind::Paren(inner) => spelled(inner, at),
        NodeKind::Index(base, index) => spelled(base, at).or_else(|| spelled(index, at)),
        NodeKind::Range(base, first, last) => spelled(base, at)
            .or_else(|| spelled(first, at))
            .or_else(|| spelled(last, at)),
        NodeKind::Binary(_, left, right) => spelled(left, at).or_else(|| spelled(right, at)),
        NodeKind::Call(_, nodes) | NodeKind::Array(nodes) | NodeKind::Repeat(_, nodes) => {
            nodes.iter().find_map(|node| spelled(node, at))
        }
        NodeKind::Literal(_) | NodeKind::NoFunction | NodeKind::Missing => None,
    }
}

/// An undeclared BOOL that is read and never written is an input; one that coils write and nothing reads is an
/// output (LANGUAGE §4). Types are not known yet: only BOOL places make a tag either, and infer checks.
fn roles(scope: &mut Scope) {
    for tag in scope.declared..scope.tags.len() {
        if scope.tags[tag].origin == Origin::Undeclared {
            scope.tags[tag].role = role(&scope.tags[tag].uses);
        }
    }
}

fn role(uses: &Uses) -> Role {
    let read = uses.accesses().any(Access::reads);
    let written = uses.accesses().any(Access::writes);
    let by_coils = || uses.writers().all(|place| place.deed().is_coil());
    match (read, written) {
        (true, false) => Role::Input,
        (false, true) if by_coils() => Role::Output,
        _ => Role::Internal,
    }
}
