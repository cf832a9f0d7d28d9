//! The tags that the operands of a network name, and how.

use super::network::{BoundBlock, Formal, Meaning, NetworkFacts};
use super::use_kind::{Effect, Extent, UseKind};
use super::use_place::Use;
use crate::program::Access;
use crate::program::ParameterKind;
use crate::written::facts::{Node, NodeKind};
use crate::written::user_block::UserBlockFacts;
use ladder_instructions::{Accepts, Direction};
use ladder_syntax::{Name, TextRange, TextSize};

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
            let Meaning::User(block) = bound.meaning else {
                return None;
            };
            Some(match user_blocks[block].parameters[index].kind {
                ParameterKind::Input => Access::Read,
                ParameterKind::Output => Access::Write,
                ParameterKind::InOut => Access::ReadWrite,
            })
        }
        // Nothing is known of the operand: count it as both, so that no other rule complains of the tag.
        Formal::Instance | Formal::Excess | Formal::UnknownName | Formal::Unknown => Some(Access::ReadWrite),
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

    /// The whole path that begins with it, in its operand.
    pub(crate) fn path_in<'n>(&self, operand: &'n Node) -> Option<&'n Node> {
        path_at(operand, self.range)
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
        effect: Effect::Other,
        found: room,
    };
    for (block, bound) in blocks.iter().enumerate() {
        names.block = block as u32;
        for (operand, (written, formal)) in bound.facts.operands.iter().zip(bound.formals.iter()).enumerate()
        {
            if let Some(access) = access(bound, *formal, user_blocks) {
                names.operand = operand as u16;
                names.effect = Effect::of(bound, *formal);
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
    effect: Effect,
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
                self.walk_subscript(index);
            }
            NodeKind::Range(base, first, last) => {
                self.walk_indexed(base, access);
                self.walk_subscript(first);
                self.walk_subscript(last);
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
            NodeKind::Members(_) | NodeKind::Literal(_) | NodeKind::NoFunction | NodeKind::Missing => {}
        }
    }

    /// An index, or an end of a range: it is read, whatever the block does with the operand.
    fn walk_subscript(&mut self, index: &Node) {
        let effect = std::mem::replace(&mut self.effect, Effect::Other);
        self.walk(index, Access::Read, true);
        self.effect = effect;
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
            kind: UseKind::new(access, extent, self.effect),
        });
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
        NodeKind::Members(_) | NodeKind::Literal(_) | NodeKind::NoFunction | NodeKind::Missing => None,
    }
}

/// The whole path of which the name at a place of an operand is the beginning.
pub(crate) fn path_at(node: &Node, at: TextRange) -> Option<&Node> {
    let within = |node: &Node| node.range.contains_range(at);
    match &node.kind {
        NodeKind::Name(_) | NodeKind::Address(_) => (node.range == at).then_some(node),
        NodeKind::Member(base, _) => path_at(base, at).map(|found| {
            if std::ptr::eq(found, &raw const **base) {
                node
            } else {
                found
            }
        }),
        NodeKind::Index(base, index) => match path_at(base, at) {
            Some(found) if std::ptr::eq(found, &raw const **base) => Some(node),
            Some(found) => Some(found),
            None => path_at(index, at),
        },
        NodeKind::Range(base, first, last) => match path_at(base, at) {
            Some(found) if std::ptr::eq(found, &raw const **base) => Some(node),
            Some(found) => Some(found),
            None => path_at(first, at).or_else(|| path_at(last, at)),
        },
        NodeKind::Paren(inner) => path_at(inner, at).map(|found| {
            if std::ptr::eq(found, &raw const **inner) {
                node
            } else {
                found
            }
        }),
        NodeKind::Unary(_, inner) => path_at(inner, at),
        NodeKind::Binary(_, left, right) => path_at(if within(left) { left } else { right }, at),
        NodeKind::Call(_, nodes) | NodeKind::Array(nodes) | NodeKind::Repeat(_, nodes) => {
            nodes.iter().find_map(|node| path_at(node, at))
        }
        NodeKind::Members(_) | NodeKind::Literal(_) | NodeKind::NoFunction | NodeKind::Missing => None,
    }
}
