//! Declared types, their members and values: where they are declared and named.

use super::find::tag_of_node;
use super::occurrences::{block_file, each_node};
use super::{Symbol, Usage};
use ladder_analysis::context::Context;
use ladder_analysis::networks::{BlockAt, NetworkAt};
use ladder_analysis::values::compound::Compound;
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::written::facts::{Node, NodeKind};
use ladder_analysis::written::type_spec::{Declared, Initial, SpecKind, TypeSpec};
use ladder_syntax::{Name, TextRange};
use std::sync::Arc;

/// A place of a type or a part of one.
pub(crate) type Place = (TextRange, Symbol, Usage);

/// The symbol of a type by its name.
pub(crate) fn type_named(file: &Context, name: &str) -> Option<Symbol> {
    let found = file.types.find(name)?;
    Some(Symbol::Type {
        file: found.file.clone().unwrap_or_else(|| Arc::clone(&file.name)),
        name: found.declaration.key.clone(),
    })
}

/// The symbol of a member of a structure, or of a value of an enumeration.
fn part_of(file: &Context, ty: &str, name: &str) -> Option<Symbol> {
    match type_named(file, ty)? {
        Symbol::Type { file, name: ty } => Some(Symbol::Part {
            file,
            ty,
            name: Name::new(name),
        }),
        _ => None,
    }
}

/// What a point and a word name after a path of a type: a member of a structure, or a tag of a block by that of its state.
pub(crate) fn member_of(file: &Context, ty: Type, word: &str) -> Option<Symbol> {
    let Type::Compound(id) = ty else { return None };
    match id.block() {
        Some(block) => tag_of_block(file, &block, word),
        None => {
            let (name, word) = (declared_name(ty)?, Name::new(word));
            let is_member = id.with(|ty| match ty {
                Compound::Structure(structure) => structure.member(word.as_str()).is_some(),
                _ => false,
            });
            is_member.then(|| part_of(file, &name, word.as_str()))?
        }
    }
}

/// A tag of the body of a block that a file knows.
fn tag_of_block(file: &Context, block: &str, tag: &str) -> Option<Symbol> {
    let (block, name) = (Name::new(block), Name::new(tag));
    let own = file.user_blocks[..file.own_blocks].iter();
    let (of, item) = match own.zip(0..).find(|(facts, _)| facts.key == block) {
        Some((_, item)) => {
            file.scopes.get(item + 1)?.find(&name)?;
            (Arc::clone(&file.name), item)
        }
        None => {
            let (exports, block) = file.others.blocks(&block).next()?;
            let mut parameters = block.facts.parameters.iter();
            parameters.find(|parameter| parameter.key == name)?;
            (Arc::clone(&exports.file), block.item)
        }
    };
    Some(Symbol::Tag {
        file: of,
        scope: item + 1,
        name,
    })
}

/// The declared type, or block, that a type is; of an array, that of its elements.
pub(crate) fn symbol_of(file: &Context, mut ty: Type) -> Option<Symbol> {
    while let Some((_, element)) = ty.array() {
        ty = element;
    }
    match ty {
        Type::Compound(id) if id.block().is_some() => {
            let name = Name::new(&id.block()?);
            Some(Symbol::Block {
                file: block_file(file, &name)?,
                name,
            })
        }
        _ => type_named(file, &declared_name(ty)?),
    }
}

/// The type of a part of a type: of a member its own, of a value its enumeration.
pub(crate) fn type_of_part(file: &Context, ty: &Name, part: &Name) -> Option<Type> {
    let ty = file.types.find(ty.as_str())?.ty?;
    match ty {
        Type::Scalar(_) => Some(ty),
        _ => member_type(ty, part.as_str()),
    }
}

/// The name of a type that is declared: of a structure or an enumeration.
pub(crate) fn declared_name(ty: Type) -> Option<String> {
    match ty {
        Type::Scalar(Scalar::Enum(id)) => Some(id.get().name.to_string()),
        Type::Compound(id) => id.with(|ty| match ty {
            Compound::Structure(structure) => Some(structure.name.to_string()),
            _ => None,
        }),
        _ => None,
    }
}

/// All places in the declarations of a file.
pub(crate) fn in_declarations(file: &Context) -> Vec<Place> {
    let mut out = Vec::new();
    for ty in file.types.own() {
        let declaration = &ty.declaration;
        let name = declaration.name.as_str();
        let symbol = Symbol::Type {
            file: Arc::clone(&file.name),
            name: declaration.key.clone(),
        };
        out.push((declaration.at, symbol, Usage::Definition));
        let part = |part: &str| Symbol::Part {
            file: Arc::clone(&file.name),
            ty: declaration.key.clone(),
            name: Name::new(part),
        };
        match &declaration.declared.spec.kind {
            SpecKind::Enumeration(values) => {
                for (value, at, _) in values {
                    out.push((*at, part(value), Usage::Definition));
                }
            }
            SpecKind::Structure(members) => {
                for member in members {
                    out.push((member.at, part(&member.name), Usage::Definition));
                    let ty = file.types.find(name).and_then(|found| found.ty);
                    let ty = ty.and_then(|ty| member_type(ty, &member.name));
                    in_declared(file, &member.declared, ty, &mut out);
                }
            }
            _ => {}
        }
        let own = &declaration.declared;
        if !matches!(own.spec.kind, SpecKind::Structure(_)) {
            mentions(file, &own.spec, &mut out);
        }
        in_initial(file, own.initial.as_ref(), ty.ty, &mut out);
    }
    for tag in file.scopes.iter().flat_map(|scope| &scope.tags) {
        if let Some(declared) = &tag.cold.declared
            && tag.cold.foreign.is_none()
            && tag.is_declared()
        {
            in_declared(file, declared, tag.ty, &mut out);
        }
    }
    out
}

fn member_type(ty: Type, member: &str) -> Option<Type> {
    match ty {
        Type::Compound(id) => id.with(|ty| match ty {
            Compound::Structure(structure) => structure.member(member).map(|(_, member)| member.ty),
            _ => None,
        }),
        _ => None,
    }
}

fn in_declared(file: &Context, declared: &Declared, ty: Option<Type>, out: &mut Vec<Place>) {
    mentions(file, &declared.spec, out);
    in_initial(file, declared.initial.as_ref(), ty, out);
}

fn mentions(file: &Context, spec: &TypeSpec, out: &mut Vec<Place>) {
    match &spec.kind {
        SpecKind::Array(_, element) => mentions(file, element, out),
        SpecKind::Named(name) => {
            out.extend(type_named(file, name).map(|symbol| (spec.range, symbol, Usage::Mention)));
        }
        SpecKind::Block(block) => {
            let name = Name::new(block);
            out.extend(block_file(file, &name).map(|file| {
                let symbol = Symbol::Block { file, name };
                (spec.range, symbol, Usage::Mention)
            }));
        }
        _ => {}
    }
}

/// The members and values that an initial value names.
fn in_initial(file: &Context, initial: Option<&Initial>, ty: Option<Type>, out: &mut Vec<Place>) {
    if let (Some(initial), Some(ty)) = (initial, ty) {
        let mut found = Vec::new();
        in_value(file, &initial.node, ty, &mut found);
        out.extend(
            found
                .into_iter()
                .map(|(at, symbol, usage)| (at + initial.start, symbol, usage)),
        );
    }
}

fn in_value(file: &Context, node: &Node, ty: Type, out: &mut Vec<Place>) {
    match &node.kind {
        NodeKind::Array(values) | NodeKind::Repeat(_, values) => {
            let element = match &node.kind {
                NodeKind::Array(_) => ty.array().map(|(_, element)| element),
                _ => Some(ty),
            };
            if let Some(element) = element {
                values
                    .iter()
                    .for_each(|value| in_value(file, value, element, out));
            }
        }
        NodeKind::Members(values) => {
            let Some(name) = declared_name(ty) else { return };
            for (word, value) in values {
                let part = part_of(file, &name, &word.text);
                out.extend(part.map(|symbol| (word.range, symbol, Usage::Mention)));
                if let Some(ty) = member_type(ty, &word.text) {
                    in_value(file, value, ty, out);
                }
            }
        }
        NodeKind::Name(name) => {
            if let (Type::Scalar(Scalar::Enum(_)), Some(of)) = (ty, declared_name(ty)) {
                let part = part_of(file, &of, name);
                out.extend(part.map(|symbol| (node.range, symbol, Usage::Mention)));
            }
        }
        NodeKind::Member(..) => with_type(file, node, out),
        _ => {}
    }
}

/// `Phase.IDLE`
fn with_type(file: &Context, node: &Node, out: &mut Vec<Place>) {
    let NodeKind::Member(base, word) = &node.kind else {
        return;
    };
    if let NodeKind::Name(name) = &base.kind
        && file.types.enumeration(name).is_some()
    {
        let ty = type_named(file, name).map(|symbol| (base.range, symbol, Usage::Mention));
        let part = part_of(file, name, &word.text).map(|symbol| (word.range, symbol, Usage::Mention));
        out.extend(ty.into_iter().chain(part));
    }
}

/// All places in the operands of a block.
pub(crate) fn in_block(file: &Context, network: NetworkAt<'_>, block: BlockAt<'_>) -> Vec<Place> {
    let scope = network.scope;
    let mut out = Vec::new();
    // A member does what the path does that it is in.
    let usage = |base: &Node| {
        let root = tag_of_node(base).and_then(|(name, at)| {
            let tag = &file.scopes[scope].tags[file.scopes[scope].find(&Name::new(name))?];
            let at = block.absolute(at);
            let mut uses = file.uses(file.shared(tag));
            uses.find(|place| place.range == at)
        });
        root.map_or(Usage::Read, |place| place.access.into())
    };
    for operand in &block.facts.operands {
        each_node(&operand.value, &mut |node| match &node.kind {
            NodeKind::Member(base, word) => {
                let is_type = matches!(&base.kind, NodeKind::Name(name)
                    if file.scopes[scope].find(&Name::new(name)).is_none());
                if is_type {
                    with_type(file, node, &mut out);
                    return;
                }
                if let Some(ty @ Type::Compound(_)) = file.path_type(scope, base) {
                    let member = member_of(file, ty, &word.text);
                    out.extend(member.map(|symbol| (word.range, symbol, usage(base))));
                }
            }
            NodeKind::Name(name) => {
                if let Some(id) = file.value_in(scope, block, name) {
                    let part = part_of(file, &id.get().name, name);
                    out.extend(part.map(|symbol| (node.range, symbol, Usage::Mention)));
                }
            }
            _ => {}
        });
    }
    for (range, ..) in &mut out {
        *range = block.absolute(*range);
    }
    out
}
