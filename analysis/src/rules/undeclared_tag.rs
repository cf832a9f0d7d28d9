//! `undeclared-tag`: a tag is used that no declaration names.
//!
//! How much that matters depends on the file (LANGUAGE §4): an array needs its bounds and a block's body needs
//! every declaration; a file that declares tags has probably forgotten one; and in a file that declares none, a
//! name that is used once and looks like another is probably a slip.

use super::declaration_fix::Undeclared;
use super::near_names::{self, Meant, NearNames};
use super::tag_view::TagView;
use crate::findings::diagnostic::{Applicability, Diagnostic, Fix};
use crate::findings::did_you_mean;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::Context;
use crate::names::declaring::Places;
use crate::names::scope::{Origin, SectionKind, TagFacts};
use crate::networks::network::Formal;
use crate::networks::use_place::Use;
use crate::program::Access;
use crate::program::Role;
use crate::values::types::{Scalar, Type};
use crate::written::facts::NodeKind;
use ladder_instructions::Accepts;
use ladder_syntax::{Name, TextRange};
use smol_str::SmolStr;
use std::cell::{Cell, OnceCell};

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Names, "undeclared-tag", Severity::Warning).fixed(Applicability::Unsafe));

/// For how many tags of a file a near name is looked for among all declared ones.
const MOST_SUGGESTIONS: usize = 20;

/// What the rest of the file adds to what is reported about an undeclared tag.
pub(super) struct Undeclaring<'c> {
    context: &'c Context,
    /// Of a file that declares no tags all names.
    usual: Option<NearNames>,
    /// For so many tags a near name is still looked for.
    suggestions: Cell<usize>,
    /// The declared names, sorted: which of several is nearest does not depend on where they are declared.
    declared: OnceCell<Vec<SmolStr>>,
    /// For each scope where its declarations go.
    places: Vec<OnceCell<Places>>,
}

impl<'c> Undeclaring<'c> {
    pub(super) fn of(context: &'c Context) -> Undeclaring<'c> {
        let tags = &context.scopes[0].tags;
        let usual = || {
            let usual = tags.iter().filter(|tag| tag.origin == Origin::Undeclared);
            NearNames::new(usual.map(|tag| Name::new(&tag.name)))
        };
        Undeclaring {
            context,
            usual: (!context.scopes[0].declares()).then(usual),
            suggestions: Cell::new(MOST_SUGGESTIONS),
            declared: OnceCell::new(),
            places: vec![OnceCell::new(); context.scopes.len()],
        }
    }

    /// The declared name that is nearest to another one.
    fn nearest(&self, name: &str) -> Option<&str> {
        let declared = self.declared.get_or_init(|| {
            let tags = self.context.scopes[0].tags.iter().filter(|tag| tag.is_declared());
            let mut names: Vec<SmolStr> = tags
                .map(|tag| tag.name.clone())
                .take(did_you_mean::MOST)
                .collect();
            names.sort_unstable();
            names
        });
        did_you_mean::closest(name, declared.iter().map(SmolStr::as_str))
    }

    /// Has a fix add the declaration of a tag. A typing error must not make a tag: it is not made unasked.
    fn with_declaration(
        &self,
        found: Diagnostic,
        scope: usize,
        section: SectionKind,
        name: &str,
        ty: &str,
    ) -> Diagnostic {
        let places = self.places[scope].get_or_init(|| Places::new(self.context, scope));
        match places.declare(section, name, ty) {
            Some(edits) => {
                let title = format!("Declare `{name} : {ty}` in {}", section.keyword());
                found.with(Fix::new(Applicability::Unsafe, title, edits))
            }
            None => found,
        }
    }
}

/// Looks at one tag.
pub(super) fn check(view: &TagView<'_>, out: &mut Vec<Diagnostic>) {
    let (context, scope, tag, around) = (view.context, view.scope, view.tag, &view.around.undeclaring);
    if !is_undeclared(tag, scope) {
        return;
    }
    let mut uses = context.uses(tag).filter(|place| is_clear(context, tag, place));
    let Some(first) = uses.clone().next() else {
        return;
    };
    if let Some(index) = uses.find(|place| place.indexed) {
        out.push(array(around, scope, tag, index.range));
    } else if scope > 0 {
        out.push(in_body(around, scope, tag, first.range));
    } else if let Some(value) = value_meant(tag) {
        out.push(not_a_tag(tag, &value, first.range));
    } else {
        match &around.usual {
            Some(near) => out.extend(slip(context, tag, near)),
            None => out.push(forgotten(around, tag, first.range)),
        }
    }
}

/// Whether the place says that a tag is meant: the block is known and could be read, and no other rule reports
/// the operand.
fn is_clear(context: &Context, tag: &TagFacts, place: &Use) -> bool {
    let bound = context.networks.at(place.network).block(place.block);
    let value = &bound.facts.operands[place.operand].value;
    let known = match bound.formals[place.operand] {
        Formal::Operand(operand) => {
            // An expression where none may be is an error of its own.
            operand.accepts == Accepts::Expression
                || !matches!(
                    value.kind,
                    NodeKind::Unary(..) | NodeKind::Binary(..) | NodeKind::Call(..)
                )
        }
        Formal::Parameter(_) => true,
        _ => false,
    };
    // `t.Q` where nothing makes a timer of `t`: unknown-member says so.
    let no_member = !matches!(tag.ty, Some(Type::State(_)))
        && matches!(&value.kind, NodeKind::Member(_, word) if word.text.parse::<u32>().is_err());
    known && !bound.faulty && !no_member
}

/// In a body names do not say a type; only direct addresses need no declaration there.
fn is_undeclared(tag: &TagFacts, scope: usize) -> bool {
    match tag.origin {
        Origin::Undeclared => true,
        Origin::Form => scope > 0 && tag.cold.address.is_none(),
        _ => false,
    }
}

fn found(severity: Severity, range: TextRange, message: String) -> Diagnostic {
    let mut found = Diagnostic::new(RULE, range, message);
    found.severity = severity;
    found
}

/// An array must be declared: its bounds are nowhere else.
fn array(around: &Undeclaring<'_>, scope: usize, tag: &TagFacts, range: TextRange) -> Diagnostic {
    let name = &tag.name;
    let (last, element) = extent(around.context, tag);
    let ty = format!("ARRAY[1..{last}] OF {element}");
    let found = found(
        Severity::Error,
        range,
        format!("the array `{name}` is not declared"),
    )
    .help(format!("declare it with its bounds: {name} : {ty};"));
    around.with_declaration(found, scope, SectionKind::Var, name, &ty)
}

/// The highest index that is written out, and the type of the elements, as far as the places say.
fn extent(context: &Context, tag: &TagFacts) -> (i64, Scalar) {
    let mut last = 1;
    let mut element = Scalar::Dint;
    let mut written_out = false;
    for place in context.uses(tag) {
        let bound = context.networks.at(place.network).block(place.block);
        bound.facts.operands[place.operand]
            .value
            .each_index(&mut |index| {
                written_out = true;
                last = last.max(index);
            });
        if let Formal::Operand(operand) = bound.formals[place.operand]
            && matches!(
                operand.accepts,
                Accepts::Bool | Accepts::BoolOrRange | Accepts::BoolRangeOrState
            )
        {
            element = Scalar::Bool;
        }
    }
    (if written_out { last.min(100_000) } else { 10 }, element)
}

/// In a block's body.
fn in_body(around: &Undeclaring<'_>, scope: usize, tag: &TagFacts, range: TextRange) -> Diagnostic {
    let context = around.context;
    let (name, block) = (&tag.name, &context.user_blocks[scope - 1]);
    let mut found = found(
        Severity::Error,
        range,
        format!("`{name}` is not declared in the block `{}`", block.name),
    )
    .help("a block sees its own tags and VAR_GLOBAL tags only: declare it in the block");
    if let Some(outside) = context.scopes[0].find(&Name::new(name)) {
        let outside = &context.scopes[0].tags[outside];
        if !outside.is_alias() {
            found = found.related(
                context.place_of(outside),
                "a tag of this name is in the program: the block does not see it",
            );
        }
    }
    declaring(around, found, (scope, tag), Role::Internal)
}

/// The value, with its type, that a name means which is only ever read where another undeclared tag has the type: which type
/// a place asks for is known of declared tags alone, and a new tag would have the first value.
fn value_meant(tag: &TagFacts) -> Option<String> {
    let Some(Type::Scalar(Scalar::Enum(id))) = tag.ty else {
        return None;
    };
    id.get().number(&tag.name)?;
    let is_written = tag.uses.accesses().any(Access::writes);
    (!is_written).then(|| format!("{}.{}", id.get().name, tag.name))
}

fn not_a_tag(tag: &TagFacts, value: &str, range: TextRange) -> Diagnostic {
    let message = format!("`{}` is a tag of its own here, not the value {value}", tag.name);
    found(Severity::Error, range, message)
        .help("nothing declared says which type is asked for here: write the value with its type")
        .fix(Applicability::Unsafe, format!("Write {value}"), range, value)
}

/// In a file that declares tags.
fn forgotten(around: &Undeclaring<'_>, tag: &TagFacts, range: TextRange) -> Diagnostic {
    let name = &tag.name;
    let found = found(Severity::Warning, range, format!("`{name}` is not declared"));
    let left = around.suggestions.get();
    around.suggestions.set(left.saturating_sub(1));
    let may_be_slip = left > 0 && tag.uses.len() == 1;
    let near = may_be_slip.then(|| around.nearest(name));
    let scope = &around.context.scopes[0];
    let is_of_type = |near: &&str| {
        let near = scope.find(&Name::new(near));
        near.is_some_and(|near| scope.tags[near].ty == tag.ty)
    };
    let found = match near.flatten().filter(is_of_type) {
        Some(near) => near_names::ask(found, name, near, Meant::name(near, "Replace with", range)),
        None => found.help("declare it, so that a typing error cannot make a new tag"),
    };
    declaring(around, found, (0, tag), tag.role)
}

/// Whether a tag needs a declaration, and its places say enough to make one.
pub(crate) fn can_be_declared(context: &Context, scope: usize, tag: &TagFacts) -> bool {
    is_undeclared(tag, scope)
        && !tag.uses.is_empty()
        && context.uses(tag).all(|place| is_clear(context, tag, &place))
}

/// The tags of a scope that need a declaration and whose places say enough to make one.
pub(crate) fn undeclared(context: &Context, scope: usize) -> Vec<Undeclared> {
    let tags = context.scopes[scope].tags.iter();
    let tags = tags.filter(|tag| can_be_declared(context, scope, tag));
    tags.map(|tag| {
        let role = if scope > 0 { Role::Internal } else { tag.role };
        let (section, ty) = if context.uses(tag).any(|place| place.indexed) {
            let (last, element) = extent(context, tag);
            (SectionKind::Var, format!("ARRAY[1..{last}] OF {element}"))
        } else {
            let ty = tag.ty.unwrap_or(Type::Scalar(Scalar::Dint));
            (section_of(role), ty.to_string())
        };
        Undeclared {
            section,
            name: tag.name.to_string(),
            ty,
        }
    })
    .collect()
}

const fn section_of(role: Role) -> SectionKind {
    match role {
        Role::Input => SectionKind::Input,
        Role::Output => SectionKind::Output,
        Role::Internal => SectionKind::Var,
    }
}

/// Has a fix declare the tag in the section that its uses ask for.
fn declaring(
    around: &Undeclaring<'_>,
    found: Diagnostic,
    (scope, tag): (usize, &TagFacts),
    role: Role,
) -> Diagnostic {
    let ty = tag.ty.unwrap_or(Type::Scalar(Scalar::Dint)).to_string();
    around.with_declaration(found, scope, section_of(role), &tag.name, &ty)
}

/// In a file without declarations: used once, and one letter away from a tag that is used more often.
fn slip(context: &Context, tag: &TagFacts, near: &NearNames) -> Option<Diagnostic> {
    if tag.uses.len() != 1 {
        return None;
    }
    let scope = &context.scopes[0];
    let near = near.one_letter_from(&Name::new(&tag.name)).into_iter();
    let near = near.filter_map(|name| scope.find(name));
    let often = near.filter(|&other| scope.tags[other].uses.len() > 1 && scope.tags[other].ty == tag.ty);
    // The first of the file.
    let other = &scope.tags[often.min()?].name;
    let place = context.place_of(tag);
    let found = found(
        Severity::Info,
        place,
        format!("`{}` is here only, and looks like `{other}`", tag.name),
    )
    .help("a typing error makes a new tag: correct it, or declare the tags of the file");
    let title = format!("Replace with `{other}`");
    Some(found.fix(Applicability::Unsafe, title, place, other.as_str()))
}
