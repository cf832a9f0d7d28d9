//! `never-read` and `never-written` for the members of the structures that a file declares: a member is one thing in all tags of its
//! type, in whichever file. Found together with `unused-type`.

use super::parts;
use super::survey::Survey;
use super::{never_read, never_written};
use crate::findings::diagnostic::Diagnostic;
use crate::names::context::Context;
use crate::names::named_types::NamedType;
use crate::names::scope::{Origin, SectionKind, TagFacts};
use crate::networks::network::{Formal, Meaning};
use crate::networks::use_place::Use;
use crate::other_files::outward::TagUse;
use crate::program::Access;
use crate::program::{ParameterKind, Role};
use crate::values::compound::{Compound, MemberType, TypeId};
use crate::values::types::Type;
use crate::written::facts::{Node, NodeKind};
use crate::written::type_spec::SpecKind;
use ladder_syntax::Name;
use rustc_hash::FxHashMap;

pub(super) fn check(survey: &Survey<'_>, out: &mut Vec<Diagnostic>) {
    let context = survey.context;
    let structures = || {
        context
            .types
            .own()
            .iter()
            .filter(|ty| matches!(ty.declaration.declared.spec.kind, SpecKind::Structure(_)))
    };
    // A file of declarations only has just been begun, unless others use them.
    let is_seen = context.unread.any() || context.others.all_tags_use().read;
    if structures().next().is_none()
        || is_seen
        || (context.networks.is_empty() && !context.others.have_files())
    {
        return;
    }
    let (used, kept) = (Members::used(context), Members::kept(context));
    let has_outputs = context.networks.is_empty()
        || context
            .scopes
            .iter()
            .flat_map(|scope| &scope.tags)
            .any(|tag| tag.role == Role::Output);
    for ty in structures() {
        let key = &ty.declaration.key;
        let is_used = context.types.mentioned.contains(key) || context.others.mentions_type(key);
        if is_used && !context.others.may_copy(key) {
            in_type(context, ty, (&used, &kept), has_outputs, out);
        }
    }
}

fn in_type(
    context: &Context,
    ty: &NamedType,
    (used, kept): (&Members, &Members),
    has_outputs: bool,
    out: &mut Vec<Diagnostic>,
) {
    let SpecKind::Structure(specs) = &ty.declaration.declared.spec.kind else {
        return;
    };
    let Some(Type::Compound(id)) = ty.ty else { return };
    let structure = &ty.declaration.name;
    for spec in specs {
        let key = Name::new(&spec.name);
        let own = used.0.get(&(id, key.clone())).copied().unwrap_or_default();
        let is_kept = kept.0.contains_key(&(id, key.clone()));
        let used = own.with(context.others.member_use(&key));
        let name = &spec.name;
        // Of a structure in it the members say what is not done.
        let is_structure = id.with(|ty| match ty {
            Compound::Structure(structure) => structure
                .member(&spec.name)
                .is_some_and(|(_, member)| holds_members(member.ty)),
            _ => false,
        });
        let (rule, message, help) = match (used.read, used.written) {
            (false, _) if is_kept => continue,
            (false, false) => (
                never_read::RULE,
                format!("the member `{name}` of {structure} is declared and never used"),
                "use it, or remove its declaration",
            ),
            (false, true) if has_outputs && !is_structure => (
                never_read::RULE,
                format!("the member `{name}` of {structure} is written, and nothing reads it"),
                "read it where it is meant to act, or remove it",
            ),
            (true, false) if spec.declared.initial.is_none() && !is_structure => (
                never_written::RULE,
                format!("the member `{name}` of {structure} is read, and nothing writes it"),
                "write it, or say in the type what it begins with",
            ),
            _ => continue,
        };
        out.push(Diagnostic::new(rule, spec.at, message).help(help));
    }
}

/// How a file uses the members of structures.
#[derive(Default)]
struct Members(FxHashMap<(TypeId, Name), TagUse>);

impl Members {
    fn used(context: &Context) -> Members {
        let mut members = Members::default();
        for tag in context.scopes.iter().flat_map(|scope| &scope.tags) {
            if tag.is_alias() || !matches!(tag.ty, Some(Type::Compound(_))) {
                continue;
            }
            members.whole(tag.ty, from_outside(tag));
            for place in context.uses(tag) {
                members.at(context, &place);
            }
        }
        members
    }

    /// The members of retentive tags. A panel may read them; that is no reason to expect that something writes them.
    fn kept(context: &Context) -> Members {
        let mut members = Members::default();
        let tags = context.scopes.iter().flat_map(|scope| &scope.tags);
        for tag in tags.filter(|tag| tag.retain) {
            let by_a_panel = TagUse {
                read: true,
                written: false,
            };
            members.whole(tag.ty, by_a_panel);
        }
        members
    }

    fn at(&mut self, context: &Context, place: &Use) {
        let Some(path) = parts::path_of(context, place) else {
            return;
        };
        let scope = context.networks.at(place.network).scope;
        let used = TagUse::of(place.access);
        // What a block does with its in-out is seen in its body.
        if !is_in_out(context, place) || place.access == Access::Read {
            self.whole(context.path_type(scope, path), used);
        }
        let mut at = path;
        while let NodeKind::Member(base, _)
        | NodeKind::Index(base, _)
        | NodeKind::Range(base, ..)
        | NodeKind::Paren(base) = &at.kind
        {
            self.member(context, scope, at, base, used);
            at = base;
        }
    }

    fn member(&mut self, context: &Context, scope: usize, node: &Node, base: &Node, used: TagUse) {
        if let NodeKind::Member(_, word) = &node.kind
            && let Some(Type::Compound(id)) = context.path_type(scope, base)
        {
            self.add(id, Name::new(&word.text), used);
        }
    }

    /// Returns whether that is more than was known.
    fn add(&mut self, id: TypeId, member: Name, used: TagUse) -> bool {
        let entry = self.0.entry((id, member)).or_default();
        let before = std::mem::replace(entry, entry.with(used));
        *entry != before
    }

    /// A whole is used so.
    // A type nests no deeper than its declarations were read.
    fn whole(&mut self, ty: Option<Type>, used: TagUse) {
        let Some(Type::Compound(id)) = ty.filter(|_| used != TagUse::default()) else {
            return;
        };
        match id.get() {
            Compound::Array(array) => self.whole(Some(array.element), used),
            Compound::Structure(structure) => {
                for MemberType { key, ty, .. } in &structure.members {
                    if self.add(id, key.clone(), used) {
                        self.whole(Some(*ty), used);
                    }
                }
            }
            Compound::Block(_) => {}
        }
    }
}

/// What is done with a tag elsewhere than in networks.
fn from_outside(tag: &TagFacts) -> TagUse {
    let is_input = tag.constant || tag.origin == Origin::Declared(SectionKind::Input);
    TagUse {
        read: tag.origin == Origin::Declared(SectionKind::Output),
        written: is_input || !tag.cold.initial.is_empty(),
    }
}

fn is_in_out(context: &Context, place: &Use) -> bool {
    let network = context.networks.at(place.network);
    let block = network.block(place.block);
    match (block.meaning, block.formals[place.operand]) {
        (Meaning::User(user), Formal::Parameter(index)) => {
            context.user_blocks[user].parameters[index].kind == ParameterKind::InOut
        }
        _ => false,
    }
}

/// Whether a type is a structure, or an array of them.
fn holds_members(ty: Type) -> bool {
    match ty.array() {
        Some((_, element)) => holds_members(element),
        None => matches!(ty, Type::Compound(_)),
    }
}
