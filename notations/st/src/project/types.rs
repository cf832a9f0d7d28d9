//! The types of a program, and their names.

use super::{Declared, Project};
use crate::names::{self, Names};
use crate::states::piece_of;
use ladder_analysis::program::{Argument, Expr, ExprKind};
use ladder_analysis::values::compound::{Compound, EnumId};
use ladder_analysis::values::types::{Scalar, Type};

impl Project<'_> {
    pub(super) fn add_type(&mut self, ty: Type, names: &mut Names) {
        if is_of_blocks(ty) {
            return;
        }
        match ty {
            Type::Scalar(Scalar::Enum(id))
            | Type::Array {
                element: Scalar::Enum(id),
                ..
            } => {
                self.add_enumeration(id, names);
            }
            Type::Compound(id) => match id.get() {
                Compound::Structure(structure) => {
                    if self.given.types.contains_key(&ty) {
                        return;
                    }
                    self.given.types.insert(ty, names.name(&structure.name, "type"));
                    for member in &structure.members {
                        self.add_type(member.ty, names);
                    }
                    self.type_order.push(Declared::Structure(id));
                }
                Compound::Array(array) => {
                    self.add_type(array.element, names);
                    self.add_inner_array(array.element, "Row", names);
                }
                Compound::Block(_) => {}
            },
            _ => {}
        }
    }

    /// Arrays that are passed to functions and blocks have a name, and those that are copied whole.
    pub(super) fn name_passed_arrays(&mut self, names: &mut Names) {
        let mut types: Vec<Type> = Vec::new();
        for (block, user) in self.source.program.blocks.iter().enumerate() {
            let tags = user.parameters.iter().map(|(tag, _)| *tag);
            types.extend(tags.filter_map(|tag| self.declared_type(Some(block), self.root(tag))));
        }
        for (&(block, tag), &ty) in &self.tags.declared {
            if block.is_none() && self.is_passed(tag) {
                types.push(ty);
            }
        }
        let blocks = self
            .source
            .program
            .networks
            .iter()
            .flat_map(|network| &network.blocks);
        for bound in blocks.flat_map(|block| &block.arguments) {
            if let Argument::Parts(parts) = &bound.argument
                && let Some(tag) = parts.first().and_then(Argument::root)
            {
                let block = self.source.program.tags[tag.0 as usize].block;
                types.extend(self.declared_type(block, self.root(tag)));
            }
        }
        types.sort_by_key(|ty| self.spelled(*ty));
        for ty in types {
            let Some((dimensions, element)) = ty.array() else {
                continue;
            };
            let (first, last) = dimensions.first().copied().unwrap_or_default();
            let spelled = format!("{}_{first}_TO_{last}", self.type_name(element)).replace('-', "m");
            self.add_inner_array(ty, &spelled, names);
        }
    }

    /// The standard takes no `ARRAY .. OF ARRAY ..`: the inner array has a name.
    fn add_inner_array(&mut self, ty: Type, or: &str, names: &mut Names) {
        if ty.array().is_none() || self.given.types.contains_key(&ty) {
            return;
        }
        let name = self.tags.named_arrays.get(&ty).copied().unwrap_or(or);
        self.given.types.insert(ty, names.name(name, "type"));
        self.type_order.push(Declared::Array(ty));
    }

    pub(super) fn add_types_of(&mut self, expr: &Expr, names: &mut Names) {
        if let Scalar::Enum(id) = expr.ty {
            self.add_enumeration(id, names);
        }
        match &expr.kind {
            ExprKind::Pass(a) | ExprKind::Unary(_, a) => self.add_types_of(a, names),
            ExprKind::Binary(_, a, b) | ExprKind::Compare(_, a, b) => {
                self.add_types_of(a, names);
                self.add_types_of(b, names);
            }
            ExprKind::Call(_, all) => all.iter().for_each(|one| self.add_types_of(one, names)),
            _ => {}
        }
    }

    fn add_enumeration(&mut self, id: EnumId, names: &mut Names) {
        if self.given.enumerations.contains_key(&id) {
            return;
        }
        let enumeration = id.get();
        self.given
            .enumerations
            .insert(id, names.name(&enumeration.name, "type"));
        for (name, number) in &enumeration.values {
            self.given
                .values
                .insert((id, i64::from(*number)), names.name(name, "value"));
        }
        self.type_order.push(Declared::Enumeration(id));
    }

    /// The name of a tag's or member's type. Timers that the standard's blocks do not do have a block of their own.
    pub(crate) fn type_name(&self, ty: Type) -> String {
        let named = self.given.types.get(&ty).cloned();
        named.unwrap_or_else(|| self.spelled(ty))
    }

    /// The same, of an array with a name what that stands for.
    pub(crate) fn spelled(&self, ty: Type) -> String {
        match ty {
            Type::Scalar(scalar) => self.scalar_name(scalar),
            Type::State(state) => piece_of(state).into(),
            Type::Array { first, last, element } => {
                format!("ARRAY[{first}..{last}] OF {}", self.scalar_name(element))
            }
            Type::Compound(id) => match id.get() {
                Compound::Structure(structure) => names::identifier(&structure.name),
                Compound::Array(array) => {
                    let bounds: Vec<String> = array
                        .dimensions
                        .iter()
                        .map(|(first, last)| format!("{first}..{last}"))
                        .collect();
                    format!(
                        "ARRAY[{}] OF {}",
                        bounds.join(", "),
                        self.type_name(array.element)
                    )
                }
                Compound::Block(name) => self.block_name(&name),
            },
        }
    }

    fn block_name(&self, name: &str) -> String {
        self.block_of(name).map_or_else(
            || names::identifier(name),
            |block| self.given.blocks[block].clone(),
        )
    }

    fn block_of(&self, name: &str) -> Option<usize> {
        let key = name.to_lowercase();
        let mut blocks = self.source.program.blocks.iter();
        blocks.position(|block| block.name.to_lowercase() == key)
    }

    pub(crate) fn scalar_name(&self, scalar: Scalar) -> String {
        match scalar {
            Scalar::Enum(id) => self.given.enumerations.get(&id).cloned().unwrap_or_default(),
            // Its length is kept where it is written: matiec knows no other than its own.
            Scalar::String(_) => "STRING".into(),
            other => other.name().into(),
        }
    }

    /// The type of a tag as it is declared in the program or in the body of a block.
    pub(crate) fn declared_type(&self, block: Option<usize>, root: &str) -> Option<Type> {
        self.tags.declared.get(&(block, root)).copied()
    }

    /// The type of a member of a structure, or of a variable of a block.
    pub(crate) fn member_type(&self, ty: Type, member: &str) -> Option<Type> {
        let Type::Compound(id) = ty else { return None };
        match id.get() {
            Compound::Structure(structure) => structure.member(member).map(|(_, member)| member.ty),
            Compound::Block(name) => {
                let block = self.block_of(&name)?;
                self.declared_type(Some(block), member)
            }
            Compound::Array(_) => None,
        }
    }
}

/// Whether a type is a timer, counter, bistable or user-defined block.
pub(crate) fn is_block(ty: Type) -> bool {
    match ty {
        Type::State(_) => true,
        Type::Compound(id) => matches!(id.get(), Compound::Block(_)),
        _ => false,
    }
}

/// Whether a type has timers, counters or blocks in it.
pub(crate) fn has_blocks(ty: Type) -> bool {
    let Type::Compound(id) = ty else {
        return is_block(ty);
    };
    match id.get() {
        Compound::Structure(structure) => structure.members.iter().any(|member| has_blocks(member.ty)),
        Compound::Array(array) => has_blocks(array.element),
        Compound::Block(_) => true,
    }
}

/// Whether a type has nothing but timers, counters and blocks in it: each of these is a variable of its own, and nothing is left.
pub(super) fn is_of_blocks(ty: Type) -> bool {
    let Type::Compound(id) = ty else {
        return is_block(ty);
    };
    match id.get() {
        Compound::Structure(structure) => structure.members.iter().all(|member| is_of_blocks(member.ty)),
        Compound::Array(array) => is_of_blocks(array.element),
        Compound::Block(_) => true,
    }
}
