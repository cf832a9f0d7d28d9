//! Declared types, their members and values: where they are declared and named.

use super::occurrences::each_node;
use super::{Symbol, Usage};
use ladder_analysis::context::Context;
use ladder_analysis::names::type_spec::{Declared, Initial, SpecKind, TypeSpec};
use ladder_analysis::networks::facts::{Node, NodeKind};
use ladder_analysis::networks::{BlockAt, NetworkAt};
use ladder_analysis::values::compound::Compound;
use ladder_analysis::values::types::{Scalar, Type};
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
    spec.each_name(&mut |name, at| {
        out.extend(type_named(file, name).map(|symbol| (at, symbol, Usage::Mention)));
    });
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
    for operand in &block.facts.operands {
        each_node(&operand.value, &mut |node| match &node.kind {
            NodeKind::Member(base, word) => {
                let is_type = matches!(&base.kind, NodeKind::Name(name)
                    if file.scopes[scope].find(&Name::new(name)).is_none());
                if is_type {
                    with_type(file, node, &mut out);
                    return;
                }
                if let Some(ty @ Type::Compound(_)) = file.path_type(scope, base)
                    && let Some(name) = declared_name(ty)
                {
                    let part = part_of(file, &name, &word.text);
                    out.extend(part.map(|symbol| (word.range, symbol, Usage::Mention)));
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
