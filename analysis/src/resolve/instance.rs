//! The state of a user-defined block as a tag: `[$Motor]( m1, start )`, and its inputs and outputs, `m1.running`.

use super::Resolver;
use super::numbers::{Numbers, Unit};
use super::path::{Part, linear, no_array};
use crate::names::context::Context;
use crate::program::{
    Argument, Chosen, ColumnOf, Disagreement, Expr, Instance, ParameterKind, Place, Program, Tag, TagId,
};
use crate::rules::{constant_write, type_mismatch, unknown_member};
use crate::values::types::{Scalar, Type};
use crate::written::facts::{Node, NodeKind, Word};
use ladder_syntax::Name;
use rustc_hash::FxHashMap;

/// A program with more tags than this is refused: a few lines can declare millions of them.
const MOST_TAGS: usize = 1_000_000;

/// The tags of the program that instances have, by that of the instance and the name in the body.
pub(super) type Insides = FxHashMap<(TagId, Name), TagId>;

impl Resolver<'_, '_> {
    /// The innermost tag of a block's state that a path goes into, with the block and the word after it.
    pub(super) fn instance_of<'n>(&self, node: &'n Node) -> Option<(&'n Node, String, &'n Word)> {
        let ty = |base: &Node| {
            let found = self.part_type(base).filter(|(_, given)| *given == 0);
            found.map(|(ty, _)| ty)
        };
        Context::into_instance(node, ty)
    }

    /// An input or output of a block by the tag of its state, or a part of one: `m1.running`, `m1.drive.speeds[2]`.
    pub(super) fn instance_part(
        &mut self,
        (instance, block, word): &(&Node, String, &Word),
        whole: &Node,
    ) -> Option<(Place, Scalar)> {
        let mut indices = Vec::new();
        let mut name = self.inside_name(instance, whole, &mut indices)?;
        if matches!(whole.kind, NodeKind::Index(..)) && name.contains('.') {
            name.push_str("[]");
        }
        let Some((ty, _)) = self.part_type(whole) else {
            let found = match &whole.kind {
                NodeKind::Member(base, last) if self.context.block_parameter(block, &word.text).is_some() => {
                    let (ty, _) = self.part_type(base)?;
                    unknown_member::of_part(&ty, last, self.at(last.range))
                }
                _ => unknown_member::of_instance(block, word, self.at(word.range)),
            };
            self.report(found);
            return None;
        };
        let Some(scalar) = ty.scalar() else {
            let message = format!("`{name}` is {ty}: as a whole it is not read from outside yet");
            self.report(type_mismatch::wrong(self.at(word.range), message));
            return None;
        };
        let range = self.at(whole.range);
        let insides = self.lowering.map(|lowering| lowering.insides);
        let key = Name::new(&name);
        let inside = |tag: TagId| insides.and_then(|insides| insides.get(&(tag, key.clone())).copied());
        let place = match self.state(instance)? {
            Argument::ChosenState(_) if !indices.is_empty() => {
                let message =
                    format!("an element of `{name}` of one of several blocks is not read from outside yet");
                self.report(type_mismatch::wrong(range, message));
                return None;
            }
            Argument::ChosenState(chosen) => {
                let first = inside(chosen.first).unwrap_or(chosen.first);
                let second = inside(TagId(chosen.first.0.wrapping_add(1))).filter(|_| chosen.count > 1);
                Place::Chosen(Box::new(Chosen {
                    first,
                    step: second.map_or(0, |second| second.0 - first.0),
                    ..*chosen
                }))
            }
            state => {
                let tag = state.root()?;
                let tag = inside(tag).unwrap_or(tag);
                if indices.is_empty() {
                    Place::Tag(tag)
                } else {
                    let part = Part {
                        tag: 0,
                        ty,
                        given: 0,
                        column: 0,
                        indices,
                    };
                    Place::Element(tag, Box::new(linear(&part, &[], range)))
                }
            }
        };
        Some((place, scalar))
    }

    /// What the body calls a part of its parameter, as tags are named that hold the members of a structure (`drive.running`,
    /// `cells[].on`). The indices on the way are added.
    fn inside_name(
        &mut self,
        instance: &Node,
        node: &Node,
        indices: &mut Vec<(Expr, (i64, i64))>,
    ) -> Option<String> {
        if std::ptr::eq(instance, node) {
            return Some(String::new());
        }
        match &node.kind {
            NodeKind::Paren(inner) => self.inside_name(instance, inner, indices),
            NodeKind::Member(base, word) => {
                let mut name = self.inside_name(instance, base, indices)?;
                if !name.is_empty() {
                    let is_element = matches!(base.kind, NodeKind::Index(..));
                    name.push_str(if is_element { "[]." } else { "." });
                }
                Some(name + &word.text)
            }
            NodeKind::Index(base, index) => {
                let name = self.inside_name(instance, base, indices)?;
                let (ty, given) = self.part_type(base)?;
                let Some((dimensions, _)) = ty.array() else {
                    self.report(no_array(ty, self.text_of(base), self.at(base.range)));
                    return None;
                };
                let bounds = dimensions[given];
                indices.push((self.subscript(base, index, bounds)?, bounds));
                Some(name)
            }
            _ => None,
        }
    }

    /// Reports a place in the state of a block that the block alone writes: anything but an input.
    pub(super) fn is_written_by_block(&mut self, node: &Node) -> bool {
        let Some((_, block, word)) = self.instance_of(node) else {
            return false;
        };
        let parameter = self.context.block_parameter(&block, &word.text);
        if parameter.is_some_and(|parameter| parameter.kind == ParameterKind::Input) {
            return false;
        }
        let found = constant_write::of_instance(&self.text_of(node), self.at(node.range));
        self.report(found);
        true
    }
}

/// Enters, for each tag that is the state of a block, the tags of its body.
pub(super) fn add_insides(units: &[Unit<'_>], numbers: &Numbers, program: &mut Program) -> Insides {
    let mut adding = Adding {
        blocks: FxHashMap::default(),
        tags: FxHashMap::default(),
        in_outs: Vec::new(),
        open: Vec::new(),
        done: Vec::new(),
        insides: Insides::default(),
    };
    for (index, unit) in units.iter().enumerate() {
        let context = unit.context;
        for (item, facts) in context.user_blocks.iter().enumerate() {
            // All of the file itself is reached: what is not there is lacking.
            let number = match &facts.import {
                Some(_) if index == 0 => Some(numbers.block(index, context, item)),
                _ => numbers.block_if_reached(index, context, item).copied(),
            };
            let key = (index as u32, facts.key.clone());
            if let Some(number) = number {
                adding.blocks.entry(key).or_insert(number);
            }
        }
    }
    for (index, tag) in program.tags.iter().enumerate() {
        if let Some(block) = tag.block {
            adding.tags.entry(block).or_default().push(TagId(index as u32));
        }
    }
    for (index, unit) in units.iter().enumerate() {
        for (item, block) in unit.context.user_blocks[..unit.context.own_blocks]
            .iter()
            .enumerate()
        {
            if !numbers.has_block(index, item) {
                continue;
            }
            let number = numbers.block(index, unit.context, item);
            for parameter in block
                .parameters
                .iter()
                .filter(|it| it.kind == ParameterKind::InOut)
            {
                adding.in_outs.push((number, parameter.key.clone()));
            }
        }
    }
    let own = program.tags.len();
    for index in 0..own {
        adding.add(program, TagId(index as u32));
    }
    adding.insides
}

struct Adding {
    /// The number of a block by the unit that names it.
    blocks: FxHashMap<(u32, Name), usize>,
    /// The tags of each block's body.
    tags: FxHashMap<usize, Vec<TagId>>,
    /// The in-outs of blocks, which are no tags of an instance.
    in_outs: Vec<(usize, Name)>,
    /// The blocks whose own instances are being given their tags.
    open: Vec<usize>,
    done: Vec<usize>,
    insides: Insides,
}

impl Adding {
    fn add(&mut self, program: &mut Program, id: TagId) {
        let tag = &program.tags[id.0 as usize];
        let Type::Compound(ty) = tag.ty else { return };
        let Some(name) = ty.block() else { return };
        let (location, outer) = (tag.location, tag.block);
        let key = Name::new(&name);
        let at = self.blocks.get(&(location.file, key.clone())).copied();
        let any = || {
            let mut all = self.blocks.iter().filter(|((_, other), _)| *other == key);
            all.next().map(|(_, number)| *number)
        };
        // Nothing uses a block that is not there.
        let Some(block) = at.or_else(any) else { return };
        if program.instances.iter().any(|instance| instance.tag == id) {
            return;
        }
        if self.open.contains(&block) || self.open.len() > 50 || program.tags.len() > MOST_TAGS {
            program.disagreement.get_or_insert(Disagreement {
                message: format!(
                    "the state of {name} contains itself, or has too many parts: make it smaller"
                ),
                location,
            });
            return;
        }
        if !self.done.contains(&block) {
            self.open.push(block);
            for inner in self.tags.get(&block).cloned().unwrap_or_default() {
                self.add(program, inner);
            }
            self.open.pop();
            self.done.push(block);
        }
        let mut tags = Vec::new();
        for body in self.tags.get(&block).cloned().unwrap_or_default() {
            let own = &program.tags[body.0 as usize];
            let root = own.name.split(['.', '[']).next().unwrap_or_default();
            if self.in_outs.contains(&(block, Name::new(root))) {
                continue;
            }
            let mut tag = own.clone();
            let instance = &program.tags[id.0 as usize];
            let key = Name::new(&own.name);
            tag.name = format!("{}.{}", instance.name, own.name);
            tag.retain |= instance.retain;
            (tag.role, tag.is_input) = (crate::program::Role::Internal, false);
            tag.block = outer;
            tag.column = Some(std::sync::Arc::new(column_inside(instance, own)));
            if matches!(own.ty, Type::Array { .. }) && !own.name.contains("[]") {
                tag.name.push_str("[]");
            }
            let new = TagId(program.tags.len() as u32);
            program.tags.push(tag);
            if let Some(outer) = outer {
                self.tags.entry(outer).or_default().push(new);
            }
            self.insides.insert((id, key), new);
            tags.push((body, new));
        }
        program.instances.push(Instance { tag: id, block, tags });
    }
}

/// How a tag of a block's body is a part of an instance.
fn column_inside(instance: &Tag, own: &Tag) -> ColumnOf {
    // The name of the instance and a dot are before that of the tag.
    let before = instance.name.len() + 1;
    let root = instance
        .column
        .as_ref()
        .map_or(instance.name.len(), |column| column.root);
    match &own.column {
        Some(column) => ColumnOf {
            dimensions: column.dimensions.clone(),
            longest_array: column.longest_array,
            declared: (before + column.declared.0, column.declared.1),
            root,
        },
        None => ColumnOf {
            dimensions: match own.ty {
                Type::Array { first, last, .. } => Box::new([(first, last)]),
                _ => Box::default(),
            },
            longest_array: match own.ty {
                Type::Array { first, last, .. } => last.abs_diff(first) + 1,
                _ => 0,
            },
            declared: (before + own.name.len(), own.ty),
            root,
        },
    }
}
