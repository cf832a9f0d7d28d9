//! `undeclared-tag`: a tag is used that no declaration names.
//!
//! How much that matters depends on the file (LANGUAGE §4): an array needs its bounds and a block's body needs
//! every declaration; a file that declares tags has probably forgotten one; and in a file that declares none, a
//! name that is used once and looks like another is probably a slip.

use super::near_names::NearNames;
use crate::context::Context;
use crate::declaration_fix::{Places, Undeclared};
use crate::diagnostic::{Applicability, Diagnostic, Fix};
use crate::did_you_mean;
use crate::facts::NodeKind;
use crate::network::Formal;
use crate::program::Role;
use crate::rule::{Rule, Severity};
use crate::scope::{Origin, SectionKind, TagFacts, Use};
use crate::tags::Tags;
use crate::types::{Scalar, Type};
use ladder_instructions::Accepts;
use ladder_syntax::{Name, TextRange};

/// For how many tags of a file a near name is looked for among all declared ones.
const MOST_SUGGESTIONS: usize = 20;

pub(crate) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    for (scope, facts) in context.scopes.iter().enumerate() {
        let declares = facts.declares();
        let mut suggestions = MOST_SUGGESTIONS;
        let mut places = None;
        let found = || facts.tags.from(facts.declared);
        let undeclared = || found().filter(|tag| is_undeclared(tag, scope));
        for tag in undeclared() {
            let mut uses = context.uses(tag).filter(|place| is_clear(context, tag, place));
            let Some(first) = uses.clone().next() else {
                continue;
            };
            let places = &*places.get_or_insert_with(|| Places::new(context, scope));
            if let Some(index) = uses.find(|place| place.indexed) {
                out.push(array(context, places, tag, index.range));
            } else if scope > 0 {
                out.push(in_body(context, scope, places, tag, first.range));
            } else if declares {
                let look = suggestions > 0;
                suggestions = suggestions.saturating_sub(1);
                out.push(forgotten(context, places, tag, first.range, look));
            }
        }
        if scope == 0 && !declares {
            slips(context, &facts.tags, out);
        }
    }
}

/// Whether the place says that a tag is meant: the block is known and could be read, and no other rule speaks of
/// the operand.
fn is_clear(context: &Context, tag: &TagFacts, place: &Use) -> bool {
    let bound = context.networks.at(place.network).block(place.block);
    let value = &bound.facts.operands[place.operand].value;
    let known = match bound.formals[place.operand] {
        Formal::Operand(operand) => {
            // An expression where none may be is a mistake of its own.
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
        Origin::Form => scope > 0 && tag.address.is_none(),
        _ => false,
    }
}

fn found(severity: Severity, range: TextRange, message: String) -> Diagnostic {
    let mut found = Diagnostic::new(Rule::UndeclaredTag, range, message);
    found.severity = severity;
    found
}

/// An array must be declared: its bounds are nowhere else.
fn array(context: &Context, places: &Places, tag: &TagFacts, range: TextRange) -> Diagnostic {
    let name = &tag.name;
    let (last, element) = extent(context, tag);
    let ty = format!("ARRAY[1..{last}] OF {element}");
    found(
        Severity::Error,
        range,
        format!("the array `{name}` is not declared"),
    )
    .help(format!("declare it with its bounds: {name} : {ty};"))
    .with(places.declare(SectionKind::Var, name, &ty))
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
fn in_body(context: &Context, scope: usize, places: &Places, tag: &TagFacts, range: TextRange) -> Diagnostic {
    let (name, block) = (&tag.name, &context.user_blocks[scope - 1]);
    let mut found = found(
        Severity::Error,
        range,
        format!("`{name}` is not declared in the block `{}`", block.name),
    )
    .help("a block sees its own tags and VAR_GLOBAL tags only: declare it in the block");
    if let Some(outside) = context.scopes[0].find(&Name::new(name)) {
        let outside = &context.scopes[0].tags[outside];
        if outside.shared.is_none() {
            found = found.related(
                context.place_of(outside),
                "a tag of this name is in the program: the block does not see it",
            );
        }
    }
    found.with(declare(places, Role::Internal, tag))
}

/// In a file that declares tags.
fn forgotten(context: &Context, places: &Places, tag: &TagFacts, range: TextRange, look: bool) -> Diagnostic {
    let name = &tag.name;
    let found = found(Severity::Warning, range, format!("`{name}` is not declared"));
    let declared = context.scopes[0].tags.iter().filter(|tag| tag.is_declared());
    let names = declared.map(|tag| tag.name.as_str());
    let near = look.then(|| did_you_mean::closest(name, names)).flatten();
    let found = match near {
        Some(near) if tag.uses.len() == 1 => found.help(format!("did you mean `{near}`?")).fix(
            Applicability::Unsafe,
            format!("Replace with `{near}`"),
            range,
            near,
        ),
        _ => found.help("declare it, so that a typing mistake cannot make a new tag"),
    };
    found.with(declare(places, tag.role, tag))
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

fn declare(places: &Places, role: Role, tag: &TagFacts) -> Option<Fix> {
    let section = section_of(role);
    let ty = tag.ty.unwrap_or(Type::Scalar(Scalar::Dint)).to_string();
    places.declare(section, &tag.name, &ty)
}

/// In a file without declarations: used once, and one letter away from a tag that is used more often.
fn slips(context: &Context, tags: &Tags, out: &mut Vec<Diagnostic>) {
    let undeclared = || tags.iter().filter(|tag| tag.origin == Origin::Undeclared);
    if undeclared().all(|tag| tag.uses.len() != 1) {
        return;
    }
    let often = undeclared()
        .filter(|tag| tag.uses.len() > 1)
        .map(|tag| tag.name.as_str());
    let near = NearNames::new(often);
    for tag in undeclared()
        .filter(|tag| tag.uses.len() == 1 && context.uses(tag).all(|place| is_clear(context, tag, &place)))
    {
        let Some(other) = near.one_letter_from(&tag.name) else {
            continue;
        };
        out.push(
            found(
                Severity::Info,
                context.place_of(tag),
                format!("`{}` is here only, and looks like `{other}`", tag.name),
            )
            .help("a typing mistake makes a new tag: correct it, or declare the tags of the file")
            .fix(
                Applicability::Unsafe,
                format!("Replace with `{other}`"),
                context.place_of(tag),
                other,
            ),
        );
    }
}
